//! The panels of a drift study that show runs of many contacts: whether their errors add up.
//!
//! An energy error swings by its own size whenever a contact is open, so that a curve of it is a band of
//! noise. What answers the question is its level: the median size over a slice of the run's time.

use std::fmt::Write;

use super::key::{Key, Keys, distinct, position};
use crate::figure::axis::Axis;
use crate::figure::chart::{Chart, Mark, Series};
use crate::figure::colour::{self, hex};
use crate::figure::end_label::{is_beside, is_left, spread};
use crate::figure::gnuplot::{self, quoted};
use crate::output::drift::CurveRow;

/// Slices of a run.
const SLICES: usize = 20;
/// Of other integrators than the first only the run of about so many steps in a contact is shown.
const USUAL_NT: f64 = 50.0;
/// Colour of these.
const OTHERS: &str = "#000000";
/// SVG's dashes and gnuplot's patterns of these, side by side.
const DASHES: [(&str, &str); 3] = [("2 3", "'.'"), ("8 3 2 3", "'_.'"), ("12 4", "'_'")];
/// Levels so many times below the lowest last one are not worth a place: the run has hardly begun.
const LEAST: f64 = 0.02;
/// Names at the ends of curves are so far apart in gnuplot's picture, in parts of the axis.
const APART: f64 = 0.045;

/// The level of the error over a run.
struct Level {
    name: String,
    colour: String,
    dash: (&'static str, &'static str),
    points: Vec<(f64, f64)>, // s, and relative to the energy at the start
}

/// The runs of one case.
pub struct Runs {
    title: String,
    until: f64, // s
    levels: Vec<Level>,
}

impl Runs {
    /// The runs of every case, in the order in which they first come.
    pub fn of_cases(curves: &[CurveRow]) -> Vec<Self> {
        let cases = distinct(curves.iter().map(|row| row.case.clone()));
        cases.iter().map(|case| Self::of(curves, case)).collect()
    }

    /// The undamped runs of the first integrator, and one of every other. Damping hides what a step gains.
    fn of(curves: &[CurveRow], case: &str) -> Self {
        let of_case = || curves.iter().filter(|row| row.case == case);
        let restitution = of_case().map(|row| row.restitution).fold(0.0, f64::max);
        let rows: Vec<&CurveRow> = of_case().filter(|row| row.restitution == restitution).collect();
        let keys = Keys::of(rows.iter().map(|row| Key::of_curve(row)));
        let until = rows.iter().map(|row| row.time_s).fold(0.0, f64::max);
        let level = |key: &Key| {
            let same = rows.iter().filter(|row| Key::of_curve(row) == *key);
            Level {
                name: keys.name(key),
                colour: shade(&keys, key),
                dash: match keys.integrator(key) {
                    0 => ("", "1"),
                    other => DASHES[(other - 1) % DASHES.len()],
                },
                points: medians(same.map(|row| (row.time_s, row.error.abs())), until),
            }
        };
        let first = keys.integrators.first().map_or("", String::as_str);
        Self {
            until,
            title: format!("Many contacts: {case}, {first}, e = {restitution}"),
            levels: shown(&keys).into_iter().map(level).collect(),
        }
    }

    fn axes(&self) -> (Axis, Axis) {
        let last = self.levels.iter().filter_map(|level| level.points.last()).map(|point| point.1);
        let lowest = last.filter(|level| *level > 0.0).fold(f64::INFINITY, f64::min);
        let low = lowest.is_finite().then_some(LEAST * lowest);
        let label = format!("|energy error|, median over 1/{SLICES} of the run");
        let x = Axis { low: Some(0.0), high: Some(self.until), ..Axis::linear("time, s") };
        (x, Axis { low, margin: 0.08, ..Axis::log(&label) })
    }

    /// The panel.
    pub fn chart(&self) -> Chart {
        let (x, y) = self.axes();
        let mut chart = Chart::new(&self.title, x, y);
        chart.is_labelled = true;
        for Level { name, colour, dash, points } in &self.levels {
            chart.series.push(Series::new(name, colour, Mark::Line(2.0, dash.0), points.clone()));
        }
        chart
    }

    /// Its curves as data blocks of gnuplot; the panel is number `k`.
    pub fn blocks(&self, k: usize) -> String {
        let block = |(i, level): (usize, &Level)| {
            let rows = level.points.iter().map(|(time, error)| format!("{time:e} {error:e}"));
            gnuplot::block(&format!("level_{k}_{i}"), rows)
        };
        self.levels.iter().enumerate().map(block).collect()
    }

    /// The lines of a gnuplot script that draw it.
    pub fn script(&self, k: usize) -> String {
        let (x, y) = self.axes();
        let points = || self.levels.iter().flat_map(|level| &level.points);
        let (placed_x, placed_y) = (x.fit(points().map(|p| p.0)), y.fit(points().map(|p| p.1)));
        let (low, high) = placed_y.range();
        let mut text = format!(
            "set title {} noenhanced\nset xlabel {} ; set ylabel {}\n\
             set xrange [0:{until:e}] ; set yrange [{low:e}:{high:e}]\nunset label\n",
            quoted(&self.title),
            quoted(&x.label),
            quoted(&y.label),
            until = if self.until > 0.0 { self.until } else { 1.0 },
        );
        let end = |level: &Level| {
            let &(time, error) = level.points.iter().rfind(|point| point.1 > 0.0)?;
            Some((placed_x.place(time)?, placed_y.place(error)?.clamp(0.0, 1.0)))
        };
        let ends: Vec<_> = self.levels.iter().map(end).collect();
        let beside = |end: &Option<(f64, f64)>| end.filter(|end| is_beside(end.0)).map(|end| end.1);
        let wanted: Vec<f64> = ends.iter().filter_map(beside).collect();
        let mut heights = spread(&wanted, APART, (0.0, 1.0)).into_iter();
        for (level, end) in self.levels.iter().zip(ends) {
            let Some((along, height)) = end else { continue };
            let (along, height, offset) = match (is_beside(along), is_left(along)) {
                (true, _) => (1.0, heights.next().unwrap_or(height), "left offset character 1,0"),
                (false, true) => (along, height, "right offset character -0.5,0.8"),
                (false, false) => (along, height, "left offset character 1,0"),
            };
            let (name, colour) = (quoted(&level.name), &level.colour);
            // Into memory, which does not fail.
            let _ = writeln!(
                text,
                "set label {name} at graph {along:.4},{height:.4} {offset} \
                 textcolor rgb '{colour}' font ',10' noenhanced"
            );
        }
        let curve = |(i, level): (usize, &Level)| {
            let Level { colour, dash, .. } = level;
            format!("$level_{k}_{i} using 1:2 with lines lw 2 dt {} lc rgb '{colour}'", dash.1)
        };
        let curves: Vec<_> = self.levels.iter().enumerate().map(curve).collect();
        text + &format!("plot {}\n", curves.join(", \\\n    "))
    }
}

/// All runs of the first integrator, one of each other.
fn shown(keys: &Keys) -> Vec<&Key> {
    let first = keys.keys.iter().filter(|key| keys.integrator(key) == 0);
    let others = keys.integrators.iter().skip(1).filter_map(|integrator| {
        let same = keys.keys.iter().filter(|key| key.integrator == *integrator);
        let far = |key: &&Key| (key.nt.max(1e-9) / USUAL_NT).ln().abs();
        same.min_by(|a, b| far(a).total_cmp(&far(b)))
    });
    first.chain(others).collect()
}

/// From dark for the smallest N_t to light for the largest; black for other integrators.
fn shade(keys: &Keys, key: &Key) -> String {
    if keys.integrator(key) > 0 {
        return OTHERS.to_owned();
    }
    let last = keys.nts.len().max(2) - 1;
    hex(colour::at(position(&keys.nts, &key.nt) as f64 / last as f64))
}

/// The median of the values in each slice of the time `until` (s), in the middle of that slice.
fn medians(points: impl Iterator<Item = (f64, f64)>, until: f64) -> Vec<(f64, f64)> {
    let mut slices = vec![Vec::new(); SLICES];
    for (time, value) in points {
        let slice = (time / until * SLICES as f64) as usize; // 0 where there is no time
        slices[slice.min(SLICES - 1)].push(value);
    }
    let median = |(k, mut values): (usize, Vec<f64>)| {
        values.sort_by(f64::total_cmp);
        let middle = *values.get(values.len() / 2)?;
        Some(((k as f64 + 0.5) / SLICES as f64 * until, middle))
    };
    slices.into_iter().enumerate().filter_map(median).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_level_of_a_swinging_error_is_its_median_and_not_its_zeros() {
        // |sin| swings between 0 and 1 many times in a slice; half of it is above sin 45 degrees.
        let error = |k: u32| (f64::from(k) * 1e-4, (0.37 * f64::from(k)).sin().abs());
        let level = medians((0..=10_000).map(error), 1.0);
        assert_eq!(level.len(), SLICES);
        assert!((level[0].0 - 0.025).abs() < 1e-12);
        // 500 samples a slice, not in step with the swing: to a few per cent.
        assert!(level.iter().all(|point| (point.1 - 0.5f64.sqrt()).abs() < 0.03), "{level:?}");
        assert_eq!(medians([(0.0, 3.0)].into_iter(), 0.0), [(0.0, 3.0)]);
    }
}
