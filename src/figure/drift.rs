//! The drift study: how the energy error of one contact falls with the time step, and how the
//! errors of many contacts add up over a run.

use std::fmt::Write;

use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::colour::{self, OKABE_ITO, hex};
use super::gnuplot::{self, DataFile, quoted};
use super::{Figure, Panel};
use crate::output::drift::{CurveRow, DriftRow};

const GUIDE: &str = "#808080";
const PANEL: (f64, f64) = (640.0, 560.0);
const X_LEFT: &str = "time step, s";
const Y_LEFT: &str = "|energy error| after one contact";
const Y_RIGHT: &str = "|energy error| of many discs";

/// What makes one curve: case, integrator and restitution, and N_t where the curve runs over time.
#[derive(Clone, Debug, PartialEq)]
struct Key {
    case: String,
    integrator: String,
    restitution: f64,
    nt: f64,
}

impl Key {
    fn of_drift(row: &DriftRow) -> Self {
        let (case, integrator) = (row.case.clone(), row.integrator.clone());
        Self { case, integrator, restitution: row.restitution, nt: 0.0 }
    }

    fn of_curve(row: &CurveRow) -> Self {
        let (case, integrator) = (row.case.clone(), row.integrator.clone());
        Self { case, integrator, restitution: row.restitution, nt: row.nt }
    }
}

/// The curves of a panel, in the order in which they first come, and what tells them apart.
struct Keys {
    keys: Vec<Key>,
    integrators: Vec<String>,
    cases: Vec<String>,
    restitutions: Vec<f64>,
    nts: Vec<f64>,
}

impl Keys {
    fn of(rows: impl Iterator<Item = Key>) -> Self {
        let mut keys: Vec<Key> = Vec::new();
        for key in rows {
            // Curves have many points in a row: the last key is nearly always the same.
            if keys.last() != Some(&key) && !keys.contains(&key) {
                keys.push(key);
            }
        }
        let mut nts = distinct(keys.iter().map(|key| key.nt));
        nts.sort_by(f64::total_cmp);
        Self {
            integrators: distinct(keys.iter().map(|key| key.integrator.clone())),
            cases: distinct(keys.iter().map(|key| key.case.clone())),
            restitutions: distinct(keys.iter().map(|key| key.restitution)),
            nts,
            keys,
        }
    }

    /// The name of a curve: only what differs from the others.
    fn name(&self, key: &Key) -> String {
        let mut parts = vec![key.case.clone()];
        if self.integrators.len() > 1 {
            parts.push(key.integrator.clone());
        }
        if self.restitutions.len() > 1 {
            parts.push(format!("e = {:.3}", key.restitution));
        }
        if key.nt > 0.0 {
            parts.push(format!("N_t = {}", key.nt));
        }
        parts.join(", ")
    }

    fn is_first_case(&self, key: &Key) -> bool {
        self.cases.first() == Some(&key.case)
    }

    /// A colour for every integrator and restitution.
    fn colour(&self, key: &Key) -> &'static str {
        let integrator = position(&self.integrators, &key.integrator);
        let restitution = position(&self.restitutions, &key.restitution);
        OKABE_ITO[(integrator * self.restitutions.len() + restitution) % OKABE_ITO.len()]
    }

    /// From dark for the smallest N_t to light for the largest.
    fn shade(&self, key: &Key) -> String {
        let last = self.nts.len().max(2) - 1;
        hex(colour::at(position(&self.nts, &key.nt) as f64 / last as f64))
    }

    /// Dashes tell integrators and restitutions apart where colours tell N_t, the first case's from
    /// the others'.
    fn dash(&self, key: &Key) -> usize {
        let integrator = position(&self.integrators, &key.integrator);
        let restitution = position(&self.restitutions, &key.restitution);
        let case = position(&self.cases, &key.case);
        (case + self.cases.len() * (integrator * self.restitutions.len() + restitution))
            % DASHES.len()
    }
}

/// SVG's dashes and gnuplot's patterns, side by side.
const DASHES: [(&str, &str); 6] = [
    ("", "1"),
    ("7 4", "'-'"),
    ("2 3", "'.'"),
    ("8 3 2 3", "'_.'"),
    ("12 4", "'_'"),
    ("2 6", "'. '"),
];

fn distinct<T: PartialEq>(values: impl Iterator<Item = T>) -> Vec<T> {
    let mut seen = Vec::new();
    for value in values {
        if !seen.contains(&value) {
            seen.push(value);
        }
    }
    seen
}

fn position<T: PartialEq>(all: &[T], one: &T) -> usize {
    all.iter().position(|other| other == one).unwrap_or(0)
}

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
    let at_last = points.iter().filter(|p| p.0 == last).map(|p| p.1);
    // Above the largest error for slope 1, below the smallest for slope 2: clear of the curves.
    let high = 1.6 * at_last.clone().fold(0.0, f64::max);
    let low = at_last.fold(f64::INFINITY, f64::min) / 1.6;
    [(1.0, high), (2.0, low)]
        .map(|(slope, end)| (slope, [(first, end * (first / last).powf(slope)), (last, end)]))
        .to_vec()
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
        let mark = Mark::LineAndDots { radius: 3.5, is_hollow: !keys.is_first_case(key) };
        let points = one_contact(rows, key);
        chart.series.push(Series::new(&keys.name(key), keys.colour(key), mark, points));
    }
    chart
}

fn runs_chart(curves: &[CurveRow]) -> Chart {
    let mut chart = Chart::new("Many contacts", Axis::linear("time, s"), Axis::log(Y_RIGHT));
    let keys = Keys::of(curves.iter().map(Key::of_curve));
    for key in &keys.keys {
        let same = curves.iter().filter(|row| Key::of_curve(row) == *key);
        // Zeros, as at the start, have no place on the axis and need no gap.
        let points = same.map(|row| (row.time_s, row.error.abs())).filter(|point| point.1 > 0.0);
        let mark = Mark::Line(1.5, DASHES[keys.dash(key)].0);
        chart.series.push(Series::new(&keys.name(key), &keys.shade(key), mark, points.collect()));
    }
    chart
}

/// The picture of a study: left the error after one contact against the time step, right the errors
/// of the runs over time. Both are sizes, on logarithmic axes.
pub fn figure(rows: &[DriftRow], curves: &[CurveRow]) -> Figure {
    let panels = vec![Panel::Chart(contacts_chart(rows)), Panel::Chart(runs_chart(curves))];
    let legend_lines = [&panels[0], &panels[1]].map(|panel| match panel {
        Panel::Chart(chart) => chart.series.len(),
        Panel::Scene(_) => 0,
    });
    // Long legends take height, not the curves'.
    let most = legend_lines.into_iter().max().unwrap_or(0) as f64;
    Figure {
        panels,
        columns: 2,
        panel: (PANEL.0, PANEL.1 + 11.0 * (most - 6.0).max(0.0)),
        strip: None,
    }
}

/// The script that draws [`figure`] from `drift.csv` and `drift_energy.csv`.
pub fn script(
    stem: &str,
    data: &DataFile,
    energy: &DataFile,
    (rows, curves): (&[DriftRow], &[CurveRow]),
) -> String {
    let (width, height) = figure(rows, curves).panel;
    let mut text = gnuplot::head(stem, "Drift of the energy", (2.0 * width, height), "png pdf");
    let _ = write!(
        text,
        "if (!exists('file')) file = {}\nif (!exists('energy')) energy = {}\n\
         set datafile separator comma columnheaders\n\
         set datafile missing NaN           # rows of other curves interrupt none\n\
         set key outside top center horizontal samplen 3 noenhanced\n\
         set grid linecolor rgb 'gray85'\n\
         set logscale y ; set format y '10^{{%T}}'\n\
         set multiplot layout 1,2\n\
         set logscale x ; set format x '10^{{%T}}'\n\
         set title 'One contact'\nset xlabel '{X_LEFT}' ; set ylabel '{Y_LEFT}'\n",
        data.expression(),
        energy.expression(),
    );
    let _ = writeln!(text, "plot {}", contact_curves(rows).join(", \\\n    "));
    let _ = write!(
        text,
        "unset logscale x ; set format x '%g'\n\
         set title 'Many contacts'\nset xlabel 'time, s' ; set ylabel '{Y_RIGHT}'\n",
    );
    let _ = writeln!(text, "plot {}", run_curves(curves).join(", \\\n    "));
    text + "unset multiplot\n"
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
             with linespoints lw 1.5 pt {mark} lc rgb '{}' title {}",
            quoted(case),
            quoted(integrator),
            keys.colour(key),
            quoted(&keys.name(key))
        )
    });
    let all: Vec<_> = guides.chain(curves).collect();
    if all.is_empty() { vec![NOTHING.to_owned()] } else { all }
}

fn run_curves(curves: &[CurveRow]) -> Vec<String> {
    let keys = Keys::of(curves.iter().map(Key::of_curve));
    let all: Vec<_> = keys
        .keys
        .iter()
        .map(|key| {
            let Key { case, integrator, restitution, nt } = key;
            format!(
                "energy using (strcol(1) eq {} && strcol(2) eq {} && $3 == {restitution:e} && $4 == {nt:e} \
                 && $6 != 0 ? $5 : NaN):(abs($6)) with lines lw 1.5 dt {} lc rgb '{}' title {}",
                quoted(case),
                quoted(integrator),
                DASHES[keys.dash(key)].1,
                keys.shade(key),
                quoted(&keys.name(key))
            )
        })
        .collect();
    if all.is_empty() { vec![NOTHING.to_owned()] } else { all }
}
