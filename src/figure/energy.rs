//! The energy ledger: where the energy is, and below it the two residues on a logarithmic axis.

use std::fmt::Write;

use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::colour::OKABE_ITO;
use super::gnuplot::{self, DataFile, quoted};
use super::label;
use super::{Figure, Panel};
use crate::analysis::energy::LedgerRow;

/// An energy of a ledger's line, J.
pub type Column = fn(&LedgerRow) -> f64;

/// Name, column number, colour and width of the curves, and what they show.
const ENERGIES: [(&str, usize, &str, f64, Column); 6] = [
    ("total", 7, "#000000", 2.5, |row| row.total_J),
    ("gravitational", 4, "#0072B2", 2.0, |row| row.gravitational_J),
    ("kinetic", 3, "#D55E00", 2.0, |row| row.kinetic_J),
    ("elastic", 5, "#009E73", 2.0, |row| row.elastic_J),
    ("dissipated", 6, "#CC79A7", 2.0, |row| row.dissipated_J),
    (SUPPLIED, 9, "#E69F00", 2.0, |row| row.supplied_J),
];
/// The curve that is drawn only where something was supplied.
const SUPPLIED: &str = "supplied";
const GAIN: &str = "#E69F00";
const LOSS: &str = "#56B4E9";
const RESIDUE: &str = "#882255";
/// Below this an error is no number worth a place.
const LEAST: f64 = 1e-18;

/// What errors are relative to, J: the energies at the start, without their signs.
fn energy_at_start(rows: &[LedgerRow]) -> f64 {
    let size = rows
        .first()
        .map_or(0.0, |row| row.kinetic_J.abs() + row.gravitational_J.abs() + row.elastic_J.abs());
    if size > 0.0 { size } else { 1.0 }
}

/// First and last time, s.
fn ends(rows: &[LedgerRow]) -> (f64, f64) {
    let times = rows.iter().map(|row| row.time_s);
    (times.clone().fold(f64::INFINITY, f64::min), times.fold(0.0, f64::max))
}

fn largest<'a>(rows: impl Iterator<Item = &'a LedgerRow>) -> f64 {
    let sizes = rows.flat_map(|row| ENERGIES.map(|(.., column)| column(row).abs()));
    sizes.filter(|size| size.is_finite()).fold(0.0, f64::max)
}

/// Whether every number of the line is one: not so at the end of a run that exploded.
pub fn is_finite(row: &LedgerRow) -> bool {
    ENERGIES.iter().all(|(.., column)| column(row).is_finite()) && row.time_s.is_finite()
}

/// Energies that grew more than so many times over the start's stand on a logarithmic axis, by their
/// sizes: a linear one would show the last point only.
pub const EXPLODED: f64 = 1e4;

/// The vertical axis of energies: its label, its kind, and the power of ten of its unit.
struct Energies {
    label: String,
    power: i32,
    is_log: bool,
}

impl Energies {
    /// For the ledgers `runs` of what (`energy`).
    fn of<'a>(what: &str, runs: impl Iterator<Item = &'a [LedgerRow]>) -> Self {
        let (mut top, mut is_log) = (0.0, false);
        for rows in runs {
            let start = rows.first().map_or(0.0, |_| energy_at_start(rows));
            let most = largest(rows.iter());
            is_log |= most > EXPLODED * start;
            top = f64::max(top, most);
        }
        if is_log {
            return Self { label: format!("|{what}|, J"), power: 0, is_log };
        }
        let (prefix, power) = label::prefix(top);
        Self { label: format!("{what}, {prefix}J"), power, is_log }
    }

    fn axis(&self) -> Axis {
        let linear = Axis { margin: 0.04, ..Axis::linear(&self.label) };
        if self.is_log { Axis::log(&self.label) } else { linear }
    }

    /// An energy, J, as it stands on the axis.
    fn shown(&self, energy: f64) -> f64 {
        if self.is_log { energy.abs() } else { energy * 10f64.powi(-self.power) }
    }

    /// Column `k` as it stands on gnuplot's axis.
    fn column(&self, k: usize) -> String {
        if self.is_log { format!("abs(${k})") } else { format!("1e{} * ${k}", -self.power) }
    }
}

/// The curves of a ledger: name, column number, colour, width, and what they show.
pub fn energies(
    rows: &[LedgerRow],
) -> impl Iterator<Item = (&'static str, usize, &'static str, f64, Column)> {
    let is_supplied = rows.iter().any(|row| row.supplied_J != 0.0);
    ENERGIES.into_iter().filter(move |(name, ..)| is_supplied || *name != SUPPLIED)
}

/// The picture of one ledger of at least two lines.
pub fn figure(rows: &[LedgerRow]) -> Figure {
    let shown = Energies::of("energy", [rows].into_iter());
    let mut upper = Chart::new("", Axis::linear("time, s"), shown.axis());
    for (name, _, colour, width, column) in energies(rows) {
        let points = rows.iter().map(|row| (row.time_s, shown.shown(column(row)))).collect();
        upper.series.push(Series::new(name, colour, Mark::Line(width, ""), points));
    }
    let panels = vec![Panel::Chart(upper), Panel::Chart(errors(rows))];
    Figure { panels, columns: 1, panel: (900.0, 400.0), strip: None }
}

fn errors(rows: &[LedgerRow]) -> Chart {
    let (size, start) = (energy_at_start(rows), rows.first().map_or(0.0, |row| row.total_J));
    let y = Axis { low: Some(LEAST), ..Axis::log("error / energy at start") };
    let mut chart = Chart::new("", Axis::linear("time, s"), y);
    let curve = |part: &dyn Fn(&LedgerRow) -> f64| {
        rows.iter().map(|row| (row.time_s, part(row) / size)).collect::<Vec<_>>()
    };
    let mut add = |name: &str, colour: &str, mark, points| {
        chart.series.push(Series::new(name, colour, mark, points));
    };
    add("integration error: gain", GAIN, Mark::Dots(1.2), curve(&|row| row.total_J - start));
    add("integration error: loss", LOSS, Mark::Dots(1.2), curve(&|row| start - row.total_J));
    let residue = curve(&|row| row.work_error_J.abs());
    add("work residue (round-off)", RESIDUE, Mark::Line(1.5, ""), residue);
    chart.series.push(precision(rows));
    chart
}

/// A line at the spacing of numbers near 1: errors below it are none.
fn precision(rows: &[LedgerRow]) -> Series {
    let points = <[f64; 2]>::from(ends(rows)).map(|time| (time, f64::EPSILON)).to_vec();
    Series::new("double precision", "#808080", Mark::Line(1.5, "2 4"), points)
}

/// The total energy of several runs over time, and the sizes of their errors below.
pub fn comparison(runs: &[(String, Vec<LedgerRow>)]) -> Figure {
    let shown = Energies::of("total energy", runs.iter().map(|(_, rows)| rows.as_slice()));
    let mut totals = Chart::new("", Axis::linear("time, s"), shown.axis());
    let y = Axis { low: Some(LEAST), ..Axis::log("|integration error| / energy at start") };
    let mut errors = Chart::new("", Axis::linear("time, s"), y);
    for (k, (name, rows)) in runs.iter().enumerate() {
        let colour = OKABE_ITO[k % OKABE_ITO.len()];
        let (size, start) = (energy_at_start(rows), rows.first().map_or(0.0, |row| row.total_J));
        let total = rows.iter().map(|row| (row.time_s, shown.shown(row.total_J))).collect();
        let error = rows.iter().map(|row| (row.time_s, (row.total_J - start).abs() / size));
        totals.series.push(Series::new(name, colour, Mark::Line(2.0, dash(k)), total));
        errors.series.push(Series::new("", colour, Mark::Dots(1.2), error.collect()));
    }
    let all: Vec<_> = runs.iter().flat_map(|(_, rows)| rows.iter().copied()).collect();
    errors.series.push(precision(&all));
    let panels = vec![Panel::Chart(totals), Panel::Chart(errors)];
    Figure { panels, columns: 1, panel: (900.0, 400.0), strip: None }
}

/// From the eighth run on colours come back, as dashes.
fn dash(k: usize) -> &'static str {
    ["", "8 4", "2 3"][k / OKABE_ITO.len() % 3]
}

/// The lines that both scripts begin with.
fn beginning(stem: &str, shown: &Energies, rows: &[LedgerRow]) -> String {
    let mut text = gnuplot::head(stem, "Energy ledger", (900.0, 800.0), "png pdf");
    text += "set datafile separator comma columnheaders\n\
             set key outside top center horizontal samplen 2 Left reverse noenhanced\n\
             set grid linecolor rgb 'gray85'\n\
             set autoscale xfix\n\
             set lmargin 11 ; set rmargin 3     # the two panels in line\n\
             set xlabel 'time, s'\n\
             set multiplot layout 2,1\n";
    let _ = writeln!(text, "set ylabel {}", quoted(&shown.label)); // into memory
    let (first, last) = ends(rows);
    if first < last {
        let _ = writeln!(text, "set xrange [{first:e}:{last:e}]");
    }
    if shown.is_log {
        text += "set logscale y ; set format y '10^{%T}'\n";
    }
    text
}

/// From here on the vertical axis is logarithmic.
fn errors_below(label: &str) -> String {
    format!(
        "set ylabel {}\nset logscale y ; set format y '10^{{%T}}' ; set yrange [{LEAST:e}:*]\n",
        quoted(label)
    )
}

/// The script that draws [`figure`] from the ledger `data`.
pub fn script(stem: &str, data: &DataFile, rows: &[LedgerRow]) -> String {
    let shown = Energies::of("energy", [rows].into_iter());
    let mut text = beginning(stem, &shown, rows);
    let _ = writeln!(text, "if (!exists('file')) file = {}", data.expression());
    let curves = energies(rows).map(|(name, column, colour, width, _)| {
        format!(
            "file using 2:({}) with lines lw {width} lc rgb '{colour}' title '{name}'",
            shown.column(column)
        )
    });
    let _ = writeln!(text, "plot {}", curves.collect::<Vec<_>>().join(", \\\n    "));
    text += &errors_below("error / energy at start");
    let start = rows.first().map_or(0.0, |row| row.total_J);
    let _ = write!(
        text,
        "part(x) = x > 0 ? x / {:e} : NaN\n\
         plot file using 2:(part($7 - {start:e})) with points pt 7 ps 0.4 lc rgb '{GAIN}' notitle, \\\n    \
         '' using 2:(part({start:e} - $7)) with points pt 7 ps 0.4 lc rgb '{LOSS}' notitle, \\\n    \
         keyentry with points pt 7 lc rgb '{GAIN}' title 'integration error: gain', \\\n    \
         keyentry with points pt 7 lc rgb '{LOSS}' title 'integration error: loss', \\\n    \
         '' using 2:(part(abs($8))) with lines lw 2 lc rgb '{RESIDUE}' title 'work residue (round-off)', \\\n    \
         {:e} with lines lw 2 dt 3 lc rgb 'gray50' title 'double precision'\n\
         unset multiplot\n",
        energy_at_start(rows),
        f64::EPSILON,
    );
    text
}

/// The script that draws [`comparison`] from the ledgers `data`.
pub fn comparison_script(
    stem: &str,
    data: &[DataFile],
    runs: &[(String, Vec<LedgerRow>)],
) -> String {
    let shown = Energies::of("total energy", runs.iter().map(|(_, rows)| rows.as_slice()));
    let all: Vec<_> = runs.iter().flat_map(|(_, rows)| rows.iter().copied()).collect();
    let mut text = beginning(stem, &shown, &all);
    let both = || runs.iter().zip(data).enumerate();
    let curves = both().map(|(k, ((name, _), file))| {
        let (colour, dash) = (OKABE_ITO[k % OKABE_ITO.len()], 1 + k / OKABE_ITO.len() % 3);
        let (file, name) = (file.expression(), quoted(name));
        format!(
            "{file} using 2:({}) with lines lw 2 dt {dash} lc rgb '{colour}' title {name}",
            shown.column(7)
        )
    });
    let _ = writeln!(text, "plot {}", curves.collect::<Vec<_>>().join(", \\\n    "));
    text += &errors_below("|integration error| / energy at start");
    text += "part(x) = x > 0 ? x : NaN\n";
    let errors = both().map(|(k, ((_, rows), file))| {
        let start = rows.first().map_or(0.0, |row| row.total_J);
        format!(
            "{} using 2:(part(abs($7 - {start:e}) / {:e})) with points pt 7 ps 0.4 lc rgb '{}' notitle",
            file.expression(),
            energy_at_start(rows),
            OKABE_ITO[k % OKABE_ITO.len()]
        )
    });
    // Runs without any error, at rest, still leave gnuplot this line to draw.
    let precision =
        format!("{:e} with lines lw 2 dt 3 lc rgb 'gray50' title 'double precision'", f64::EPSILON);
    let errors: Vec<_> = errors.chain([precision]).collect();
    let _ = writeln!(text, "plot {}", errors.join(", \\\n    "));
    text + "unset multiplot\n"
}
