//! A small picture of a failure: the frame in which it is seen, without words, so that it fits any language.

use glam::DVec2;

use super::film::Film;
use super::verdict::Failure;
use crate::figure::colour::OKABE_ITO;
use crate::figure::svg::{Anchor, Area, Svg};

/// Width and height, px.
const SIZE: f64 = 320.0;
/// What is shown around the box, parts of its side.
const MARGIN: f64 = 0.12;
/// The longest arrow, parts of the side.
const LONGEST: f64 = 0.12;
/// Discs are no smaller than this, px: one of the guide's would be 0.7.
const SMALLEST: f64 = 2.0;

impl Failure {
    /// The discs of its frame in their box as SVG: those it names in another colour and with their
    /// numbers, and for each an arrow along its way from the frame before. None if it has no frame.
    pub fn picture(&self, film: &Film) -> Option<String> {
        let k = self.frame.filter(|&k| k < film.frames.len())?;
        let view = View { corner: film.corner, side: film.side };
        let mut svg = Svg::new(SIZE, SIZE);
        svg.begin_clipped(Area { left: 0.0, top: 0.0, width: SIZE, height: SIZE }, "");
        let (low, high) = (view.place(film.corner), view.length(film.side));
        let wall = Area { left: low.0, top: low.1 - high, width: high, height: high };
        svg.rectangle(wall, "fill=\"none\" stroke=\"black\"");
        let steps = steps(film, k);
        let longest = steps.iter().flatten().map(|step| step.length()).fold(0.0, f64::max);
        let stretch = if longest > 0.0 { LONGEST * film.side / longest } else { 0.0 };
        for is_named in [false, true] {
            let all = film.frames[k].iter().enumerate();
            for (i, spot) in all.filter(|(i, _)| self.discs.contains(i) == is_named) {
                if !spot.position.is_finite() {
                    continue;
                }
                let colour = if is_named { OKABE_ITO[1] } else { OKABE_ITO[4] };
                let centre = view.place(spot.position);
                let radius = view.length(spot.radius).max(SMALLEST);
                svg.circle(centre, radius, &format!("fill=\"{colour}\" fill-opacity=\"0.7\""));
                if let Some(step) = steps[i] {
                    arrow(&mut svg, centre, view.place(spot.position + stretch * step));
                }
                if is_named {
                    let beside = (centre.0 + radius + 2.0, centre.1 - radius - 2.0);
                    svg.text(beside, Anchor::Start, &i.to_string());
                }
            }
        }
        svg.end_group();
        Some(svg.finish())
    }
}

/// Metres to pixels.
struct View {
    corner: DVec2,
    side: f64,
}

impl View {
    fn length(&self, metres: f64) -> f64 {
        metres / self.side * SIZE / (1.0 + 2.0 * MARGIN)
    }

    fn place(&self, position: DVec2) -> (f64, f64) {
        let from = position - self.corner + DVec2::splat(MARGIN * self.side);
        (self.length(from.x), SIZE - self.length(from.y))
    }
}

/// For each disc its way from the frame before, if there is one and it is finite.
fn steps(film: &Film, k: usize) -> Vec<Option<DVec2>> {
    let before = k.checked_sub(1).map(|before| &film.frames[before]);
    let before = before.filter(|before| film.follows[k] && before.len() == film.frames[k].len());
    let step = |i: usize| {
        let step = film.at(k, i) - before?.get(i)?.position;
        // Who crossed the box in one frame did not fly there.
        (step.is_finite() && step.length() < film.side).then_some(step)
    };
    (0..film.frames[k].len()).map(step).collect()
}

/// A line with a head that is a third of it and no more than 5 px.
fn arrow(svg: &mut Svg, from: (f64, f64), to: (f64, f64)) {
    let [from, to] = [from, to].map(|(x, y)| DVec2::new(x, y));
    let way = to - from;
    if way.length() < 1.0 {
        return;
    }
    let head = way.normalize() * (way.length() / 3.0).min(5.0);
    let style = "stroke=\"black\" stroke-width=\"0.8\" fill=\"none\"";
    svg.line((from.x, from.y), (to.x, to.y), style);
    let [left, right] = [0.5, -0.5].map(|side| to - head + side * head.perp());
    svg.polyline(&[(left.x, left.y), (to.x, to.y), (right.x, right.y)], style);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grading::judge::frames::{Footage, read};
    use crate::grading::judge::rubric::Rubric;
    use crate::grading::judge::words::Finding;

    #[test]
    fn a_picture_shows_the_named_discs_the_arrows_and_nothing_that_is_no_number() {
        let text = b"0.01 0.01 5e-4\n0.02 0.02 5e-4\n0.03 0.03 5e-4\n\n\
                     0.011 0.01 5e-4\nnan 0.02 5e-4\n0.03 0.028 5e-4\n\n";
        let film = read(Footage::File(text), &Rubric::default()).unwrap();
        let failure = Failure::of(Finding::PushCrooked, None).at(1, &[2]);
        let picture = failure.picture(&film).unwrap();
        assert_eq!(picture.matches("<circle").count(), 2, "{picture}");
        assert_eq!(picture.matches("<polyline").count(), 2, "{picture}");
        assert_eq!(picture.matches(OKABE_ITO[1]).count(), 1, "{picture}");
        assert!(picture.contains(">2</text>") && !picture.contains("NaN"), "{picture}");
        assert_eq!(failure.at(2, &[]).picture(&film), None, "there is no such frame");
    }
}
