//! Names of curves at their ends, in the curves' colours: nothing to look up in a legend.

use super::series::Series;
use super::svg::{Anchor, Area, Svg, TEXT, text_width};

/// Names are so far apart, baseline to baseline, px.
pub const APART: f64 = TEXT + 3.0;
/// Curves that end in this last part of the plot have their names beside it, others inside.
const NEAR_THE_END: f64 = 0.7;
/// Between a curve and its name, px.
const GAP: f64 = 8.0;

/// Places as near to the `wanted` ones as can be, `gap` apart and in the same order, between `low` and `high`
/// if there is room.
///
/// ```
/// use parsim2d::figure::end_label::spread;
/// assert_eq!(spread(&[5.0, 1.0, 5.2], 1.0, (0.0, 10.0)), [4.6, 1.0, 5.6]);
/// assert_eq!(spread(&[9.9, 10.0], 1.0, (0.0, 10.0)), [9.0, 10.0]);
/// ```
pub fn spread(wanted: &[f64], gap: f64, (low, high): (f64, f64)) -> Vec<f64> {
    let mut order: Vec<usize> = (0..wanted.len()).collect();
    order.sort_by(|&a, &b| wanted[a].total_cmp(&wanted[b]));
    // Names that would overlap make a block, which stands where its members would on average.
    let mut blocks: Vec<Vec<usize>> = Vec::new();
    let first = |block: &[usize]| {
        let middles = block.iter().zip(0..).map(|(&k, at)| wanted[k] - gap * f64::from(at));
        let mean = middles.sum::<f64>() / block.len() as f64;
        let room = (high - gap * (block.len() - 1) as f64).max(low);
        mean.clamp(low, room)
    };
    for k in order {
        let mut block = vec![k];
        while let Some(before) = blocks.pop() {
            let end = first(&before) + gap * before.len() as f64;
            if end <= first(&block) + 1e-9 * gap {
                blocks.push(before);
                break;
            }
            block = [before, block].concat();
        }
        blocks.push(block);
    }
    let mut places = vec![0.0; wanted.len()];
    for block in blocks {
        let start = first(&block);
        for (at, k) in block.into_iter().enumerate() {
            places[k] = start + gap * at as f64;
        }
    }
    places
}

/// Whether there is no room inside the plot right of a curve that ends at `place`: its name then stands left of
/// the end, and above the curve.
pub fn is_left(place: f64) -> bool {
    place > 0.35
}

/// Room for the names beside the plot, px.
pub(super) fn room(series: &[Series]) -> f64 {
    let names = series.iter().map(|series| text_width(&series.name));
    names.fold(0.0, f64::max) + 2.0 * GAP
}

/// Whether a curve that ends at `place`, from 0 to 1 along the axis, has its name beside the plot.
pub fn is_beside(place: f64) -> bool {
    place > NEAR_THE_END
}

/// Draws the names of the `series`, each of which ends at a point (px) of the `plot`.
pub(super) fn draw(svg: &mut Svg, plot: Area, series: &[(&Series, (f64, f64))]) {
    let within = (plot.top + 0.5 * TEXT, plot.bottom() - 0.2 * TEXT);
    let baseline = |y: f64| (y + 0.35 * TEXT).clamp(within.0, within.1);
    let (beside, inside): (Vec<_>, Vec<_>) =
        series.iter().partition(|(_, (x, _))| is_beside((x - plot.left) / plot.width.max(1.0)));
    let wanted: Vec<f64> = beside.iter().map(|(_, (_, y))| baseline(*y)).collect();
    let heights = spread(&wanted, APART, within);
    let beside = beside.into_iter().zip(heights).map(|((one, _), y)| (one, (plot.right(), y)));
    let place = |one, (x, y): (f64, f64)| match is_left((x - plot.left) / plot.width.max(1.0)) {
        true => (one, (x, (y - GAP).max(within.0 + 0.5 * TEXT)), Anchor::End),
        false => (one, (x + GAP, baseline(y)), Anchor::Start),
    };
    let beside = beside.map(|(one, (x, y))| (one, (x + GAP, y), Anchor::Start));
    let inside = inside.into_iter().map(|(one, end)| place(one, end));
    for (one, point, anchor) in beside.chain(inside) {
        svg.begin_group(&format!("fill=\"{}\"", one.colour));
        svg.text(point, anchor, &one.name);
        svg.end_group();
    }
}
