//! The drift study: how the energy error of one contact falls with the time step, and how the
//! errors of many contacts add up over a run.

mod key;
mod runs;

use std::fmt::Write;

use self::key::{Key, Keys};
use self::runs::Runs;
use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::gnuplot::{self, DataFile, quoted};
use super::{Figure, Panel};
use crate::output::drift::{CurveRow, DriftRow};

const GUIDE: &str = "#808080";
const PANEL: (f64, f64) = (600.0, 540.0);
const X_LEFT: &str = "time step, s";
const Y_LEFT: &str = "|energy error| after one contact";

fn is_one_contact(row: &&DriftRow) -> bool {
    row.case == "wall" || row.case == "pair"
}

/// The points of a curve of one contact: time step and size of the error, by time step.
fn one_contact(rows: &[DriftRow], key: &Key) -> Vec<(f64, f64)> {
    let same = rows.iter().filter(is_one_contact).filter(|row| Key::of_drift(row) == *key);
    let mut points: Vec<_> = same.map(|row| (row.dt_s, row.final_error.abs())).collect();
    points.sort_by(|a, b| a.0.total_cmp(&b.0));
    points
}

/// Lines of slope 1 and 2 through the lower right of the data: an error falls with the time step
/// as the method's order says.
fn slopes(rows: &[DriftRow]) -> Vec<(f64, [(f64, f64); 2])> {
    let points = rows.iter().filter(is_one_contact).map(|row| (row.dt_s, row.final_error.abs()));
    let there = |p: &(f64, f64)| p.0 > 0.0 && p.1 > 0.0 && p.0.is_finite() && p.1.is_finite();
    let points: Vec<_> = points.filter(there).collect();
    let [first, last] = [f64::min as fn(f64, f64) -> f64, f64::max]
        .map(|which| points.iter().map(|p| p.0).reduce(which));
    let (Some(first), Some(last)) = (first, last) else { return Vec::new() };
    if last <= first {
        return Vec::new();
    }
    // Slope 1 just above all points, slope 2 just below: clear of the curves.
    let above = points.iter().map(|p| p.1 / p.0).fold(0.0, f64::max) * 1.4;
    let below = points.iter().map(|p| p.1 / (p.0 * p.0)).fold(f64::INFINITY, f64::min) / 1.6;
    let line =
        |slope: f64, factor: f64| (slope, [first, last].map(|dt| (dt, factor * dt.powf(slope))));
    vec![line(1.0, above), line(2.0, below)]
}

fn contacts_chart(rows: &[DriftRow]) -> Chart {
    let mut chart = Chart::new("One contact", Axis::log(X_LEFT), Axis::log(Y_LEFT));
    let keys = Keys::of(rows.iter().filter(is_one_contact).map(Key::of_drift));
    for (slope, points) in slopes(rows) {
        let dash = if slope < 1.5 { "6 4" } else { "2 4" };
        let name = format!("slope {slope}");
        chart.series.push(Series::new(&name, GUIDE, Mark::Line(1.2, dash), points.to_vec()));
    }
    for key in &keys.keys {
        let mark =
            Mark::LineAndDots { radius: keys.radius(key), is_hollow: !keys.is_first_case(key) };
        let points = one_contact(rows, key);
        chart.series.push(Series::new(&keys.name(key), keys.colour(key), mark, points));
    }
    chart
}

/// The picture of a study: left the error after one contact against the time step, beside it the
/// errors of the runs over time, a panel a case. All are sizes, on logarithmic axes.
pub fn figure(rows: &[DriftRow], curves: &[CurveRow]) -> Figure {
    let mut panels = vec![Panel::Chart(contacts_chart(rows))];
    panels.extend(Runs::of_cases(curves).iter().map(|runs| Panel::Chart(runs.chart())));
    Figure { columns: panels.len(), panels, panel: PANEL, strip: None }
}

/// The script that draws [`figure`]: the left panel from `drift.csv`, the others from what was made of
/// `drift_energy.csv`.
pub fn script(stem: &str, data: &DataFile, (rows, curves): (&[DriftRow], &[CurveRow])) -> String {
    let runs = Runs::of_cases(curves);
    let columns = 1 + runs.len();
    let size = (PANEL.0 * columns as f64, PANEL.1);
    let mut text = gnuplot::head(stem, "Drift of the energy", size, "png pdf");
    for (k, runs) in runs.iter().enumerate() {
        text += &runs.blocks(k);
    }
    let _ = write!(
        text,
        "if (!exists('file')) file = {}\n\
         set datafile missing NaN           # rows of other curves interrupt none\n\
         set key outside top center horizontal samplen 2 font ',9' noenhanced\n\
         set grid linecolor rgb 'gray85' ; set autoscale xfix\n\
         set logscale y ; set format y '10^{{%T}}'\n\
         set multiplot layout 1,{columns}\n\
         set datafile separator comma columnheaders\n\
         set logscale x ; set xtics ({})\n\
         set title 'One contact'\nset xlabel '{X_LEFT}' ; set ylabel '{Y_LEFT}'\n",
        data.expression(),
        time_step_marks(rows).join(", "),
    );
    let _ = writeln!(text, "plot {}", contact_curves(rows).join(", \\\n    "));
    text += "unset logscale x ; set xtics autofreq\n\
             set datafile separator whitespace ; unset datafile columnheaders\n\
             set key off ; set rmargin 24\n";
    for (k, runs) in runs.iter().enumerate() {
        text += &runs.script(k);
    }
    text + "unset multiplot\n"
}

/// The marks of the left panel's time axis, each with its text: a decade has but one power of ten.
fn time_step_marks(rows: &[DriftRow]) -> Vec<String> {
    let steps = rows.iter().filter(is_one_contact).map(|row| row.dt_s);
    let (marks, _) = Axis::log(X_LEFT).fit(steps).marks(6);
    marks.into_iter().map(|(mark, text)| format!("{} {mark:e}", quoted(&text))).collect()
}

/// A panel without curves still needs one for gnuplot.
const NOTHING: &str = "1/0 notitle";

fn contact_curves(rows: &[DriftRow]) -> Vec<String> {
    let keys = Keys::of(rows.iter().filter(is_one_contact).map(Key::of_drift));
    let guides = slopes(rows).into_iter().map(|(slope, [_, (x, y)])| {
        let dash = if slope < 1.5 { "'-'" } else { "'.'" };
        format!("{y:e} * (x / {x:e})**{slope} with lines lw 1.2 dt {dash} lc rgb '{GUIDE}' title 'slope {slope}'")
    });
    let curves = keys.keys.iter().map(|key| {
        let Key { case, integrator, restitution, .. } = key;
        let mark = if keys.is_first_case(key) { 7 } else { 6 };
        format!(
            "file using (strcol(1) eq {} && strcol(2) eq {} && $3 == {restitution:e} ? $5 : NaN):(abs($7)) \
             with linespoints lw 1.5 pt {mark} ps {:.2} lc rgb '{}' title {}",
            quoted(case),
            quoted(integrator),
            keys.radius(key) / 3.5,
            keys.colour(key),
            quoted(&keys.name(key))
        )
    });
    let all: Vec<_> = guides.chain(curves).collect();
    if all.is_empty() { vec![NOTHING.to_owned()] } else { all }
}
