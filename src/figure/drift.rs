//! The drift study: how the energy error of one contact falls with the time step, and how the
//! errors of many contacts add up over a run.

use std::fmt::Write;

use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::colour::{self, OKABE_ITO, hex};
use super::gnuplot::{self, DataFile, quoted};
use super::label::short;
use super::{Figure, Panel};
use crate::output::drift::{CurveRow, DriftRow};

const GUIDE: &str = "#808080";
const PANEL: (f64, f64) = (560.0, 560.0);
const X_LEFT: &str = "time step, s";
const Y_LEFT: &str = "|energy error| after one contact";
const Y_RIGHT: &str = "|energy error|";
/// Of other integrators than the first only the run of about so many steps in a contact is shown.
const USUAL_NT: f64 = 50.0;
/// Colour of these.
const OTHERS: &str = "#000000";

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
        let mut parts = Vec::new();
        if self.cases.len() > 1 {
            parts.push(key.case.clone());
        }
        let is_first = self.integrators.first() == Some(&key.integrator);
        if self.integrators.len() > 1 && !(is_first && key.nt > 0.0) {
            parts.push(key.integrator.clone());
        }
        if self.restitutions.len() > 1 {
            parts.push(format!("e = {}", short(key.restitution, 3)));
        }
        if key.nt > 0.0 {
            parts.push(format!("N_t = {}", key.nt));
        }
        parts.join(", ")
    }

    fn is_first_case(&self, key: &Key) -> bool {
        self.cases.first() == Some(&key.case)
    }

    fn integrator(&self, key: &Key) -> usize {
        position(&self.integrators, &key.integrator)
    }

    /// A colour for every integrator and restitution.
    fn colour(&self, key: &Key) -> &'static str {
        let restitution = position(&self.restitutions, &key.restitution);
        let k = self.integrator(key) * self.restitutions.len() + restitution;
        OKABE_ITO[k % OKABE_ITO.len()]
    }

    /// Radius of a curve's dots, px: later ones are smaller, so that none is hidden.
    fn radius(&self, key: &Key) -> f64 {
        3.0 + 1.6 * (self.integrators.len() - 1 - self.integrator(key)) as f64
    }

    /// From dark for the smallest N_t to light for the largest; black for other integrators.
    fn shade(&self, key: &Key) -> String {
        if self.integrator(key) > 0 {
            return OTHERS.to_owned();
        }
        let last = self.nts.len().max(2) - 1;
        hex(colour::at(position(&self.nts, &key.nt) as f64 / last as f64))
    }

    /// Dashes tell restitutions apart, and other integrators.
    fn dash(&self, key: &Key) -> (&'static str, &'static str) {
        let k = match self.integrator(key) {
            0 => position(&self.restitutions, &key.restitution),
            other => self.restitutions.len() + other - 1,
        };
        DASHES[k % DASHES.len()]
    }

    /// The curves that a panel of runs shows: all of the first integrator, one of each other, of
    /// the first restitution.
    fn shown(&self) -> Vec<&Key> {
        let first = self.keys.iter().filter(|key| self.integrator(key) == 0);
        let others = self.integrators.iter().skip(1).filter_map(|integrator| {
            let same = self.keys.iter().filter(|key| key.integrator == *integrator);
            let same = same.filter(|key| Some(&key.restitution) == self.restitutions.first());
            let far = |key: &&Key| (key.nt.max(1e-9) / USUAL_NT).ln().abs();
            same.min_by(|a, b| far(a).total_cmp(&far(b)))
        });
        first.chain(others).collect()
    }
}

/// SVG's dashes and gnuplot's patterns, side by side.
const DASHES: [(&str, &str); 5] =
    [("", "1"), ("7 4", "'-'"), ("2 3", "'.'"), ("8 3 2 3", "'_.'"), ("12 4", "'_'")];

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

/// Cases of many contacts, in the order in which they first come.
fn run_cases(curves: &[CurveRow]) -> Vec<String> {
    distinct(curves.iter().map(|row| row.case.clone()))
}

fn keys_of_case(curves: &[CurveRow], case: &str) -> Keys {
    Keys::of(curves.iter().filter(|row| row.case == case).map(Key::of_curve))
}

fn run_title(case: &str, keys: &Keys) -> String {
    match keys.integrators.first() {
        Some(integrator) => format!("Many contacts: {case}, {integrator}"),
        None => format!("Many contacts: {case}"),
    }
}

fn runs_chart(curves: &[CurveRow], case: &str) -> Chart {
    let keys = keys_of_case(curves, case);
    let title = run_title(case, &keys);
    let mut chart = Chart::new(&title, Axis::linear("time, s"), Axis::log(Y_RIGHT));
    for key in keys.shown() {
        let same = curves.iter().filter(|row| Key::of_curve(row) == *key);
        // Zeros, as at the start, have no place on the axis and need no gap.
        let points = same.map(|row| (row.time_s, row.error.abs())).filter(|point| point.1 > 0.0);
        let mark = Mark::Line(1.5, keys.dash(key).0);
        chart.series.push(Series::new(&keys.name(key), &keys.shade(key), mark, points.collect()));
    }
    chart
}

/// The picture of a study: left the error after one contact against the time step, beside it the
/// errors of the runs over time, a panel a case. All are sizes, on logarithmic axes. The runs of the
/// first integrator of a case are shown, and one of every other.
pub fn figure(rows: &[DriftRow], curves: &[CurveRow]) -> Figure {
    let mut panels = vec![Panel::Chart(contacts_chart(rows))];
    for case in run_cases(curves) {
        panels.push(Panel::Chart(runs_chart(curves, &case)));
    }
    Figure { columns: panels.len(), panels, panel: PANEL, strip: None }
}

/// The script that draws [`figure`] from `drift.csv` and `drift_energy.csv`.
pub fn script(
    stem: &str,
    data: &DataFile,
    energy: &DataFile,
    (rows, curves): (&[DriftRow], &[CurveRow]),
) -> String {
    let cases = run_cases(curves);
    let size = (PANEL.0 * (1 + cases.len()) as f64, PANEL.1);
    let mut text = gnuplot::head(stem, "Drift of the energy", size, "png pdf");
    let _ = write!(
        text,
        "if (!exists('file')) file = {}\nif (!exists('energy')) energy = {}\n\
         set datafile separator comma columnheaders\n\
         set datafile missing NaN           # rows of other curves interrupt none\n\
         set key outside top center horizontal samplen 2 font ',9' noenhanced\n\
         set grid linecolor rgb 'gray85' ; set autoscale xfix\n\
         set logscale y ; set format y '10^{{%T}}'\n\
         set multiplot layout 1,{}\n\
         set logscale x ; set format x '10^{{%T}}'\n\
         set title 'One contact'\nset xlabel '{X_LEFT}' ; set ylabel '{Y_LEFT}'\n",
        data.expression(),
        energy.expression(),
        1 + cases.len(),
    );
    let _ = writeln!(text, "plot {}", contact_curves(rows).join(", \\\n    "));
    let _ = writeln!(
        text,
        "unset logscale x ; set format x '%g'\nset xlabel 'time, s' ; set ylabel '{Y_RIGHT}'"
    );
    for case in cases {
        let keys = keys_of_case(curves, &case);
        let (title, curves) = (quoted(&run_title(&case, &keys)), run_curves(&keys));
        let _ = writeln!(text, "set title {title} noenhanced\nplot {}", curves.join(", \\\n    "));
    }
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

fn run_curves(keys: &Keys) -> Vec<String> {
    let curve = |key: &Key| {
        let Key { case, integrator, restitution, nt } = key;
        format!(
            "energy using (strcol(1) eq {} && strcol(2) eq {} && $3 == {restitution:e} && $4 == {nt:e} \
             && $6 != 0 ? $5 : NaN):(abs($6)) with lines lw 1.5 dt {} lc rgb '{}' title {}",
            quoted(case),
            quoted(integrator),
            keys.dash(key).1,
            keys.shade(key),
            quoted(&keys.name(key))
        )
    };
    keys.shown().into_iter().map(curve).collect()
}
