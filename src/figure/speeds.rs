//! Histogram of speeds beside Maxwell's distribution in two dimensions; of discs of several masses, beside
//! the sum of theirs at one temperature.

use std::collections::BTreeMap;
use std::fmt::Write;

use super::Figure;
use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::frame::speed;
use super::gnuplot::{self, quoted};
use super::ticks;
use crate::number::{seconds, typographic};
use crate::output::frames::Frame;

const BARS: &str = "#56B4E9";
const CURVE: &str = "#D55E00";
/// Points of the curve.
const POINTS: usize = 200;

/// Maxwell's distribution of the speed in two dimensions, s/m:
/// f(v) = (v/s²) exp(-v²/(2 s²)), with s² = <v²>/2 (kT/m in equilibrium), s in m/s.
///
/// ```
/// let density = parsim2d::figure::speeds::maxwell(0.5, 0.5);
/// assert!((density - 1.2130613194252668).abs() < 1e-12); // exp(-1/2) / 0.5
/// ```
pub fn maxwell(speed: f64, s: f64) -> f64 {
    let ratio = speed / s;
    ratio / s * (-0.5 * ratio * ratio).exp()
}

/// What a first look at the speeds tells.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Moments {
    count: usize,
    sum: f64,         // m/s
    sum_squares: f64, // m2/s2
    largest: f64,     // m/s
    frames: usize,
    /// How many discs have each mass (kg, by its bits), and the sum of their m v2, J.
    masses: BTreeMap<u64, usize>,
    sum_kinetic: f64,
}

impl Moments {
    /// Takes in the speeds of a frame.
    pub fn add(&mut self, frame: &Frame) {
        self.frames += 1;
        for speed in frame.rows.iter().map(speed) {
            self.count += 1;
            self.sum += speed;
            self.sum_squares += speed * speed;
            self.largest = self.largest.max(speed);
        }
        // Discs of which nobody says the mass are all alike.
        for (mass, speed) in frame.rows.iter().map(|row| (row.mass.unwrap_or(1.0), speed(row))) {
            *self.masses.entry(mass.to_bits()).or_default() += 1;
            self.sum_kinetic += mass * speed * speed;
        }
    }

    /// Mean speed, m/s.
    pub fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }

    /// Root mean square speed, m/s.
    pub fn rms(&self) -> f64 {
        (self.sum_squares / self.count.max(1) as f64).sqrt()
    }
}

/// Speeds counted in bins of one width.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    moments: Moments,
    width: f64, // m/s
    counts: Vec<usize>,
    is_bare: bool,
}

impl Histogram {
    /// An empty histogram for speeds of these moments: about 2 n^(1/3) bins (Rice's rule) of a
    /// round width.
    pub fn new(moments: Moments) -> Self {
        let bins = (2.0 * (moments.count as f64).cbrt()).clamp(5.0, 60.0);
        let largest = if moments.largest > 0.0 { moments.largest.min(1e300) } else { 1.0 };
        let (digit, power) = ticks::step(largest / bins);
        let width = digit * 10f64.powi(power);
        let count = (largest / width).floor().clamp(0.0, 1000.0) as usize + 1;
        Self { moments, width, counts: vec![0; count], is_bare: false }
    }

    /// Counts the speeds of a frame.
    pub fn add(&mut self, frame: &Frame) {
        for speed in frame.rows.iter().map(speed) {
            let bin = (speed / self.width) as usize;
            let last = self.counts.len() - 1;
            self.counts[bin.min(last)] += 1;
        }
    }

    /// Right edge (m/s) and density (s/m) of each bin; the densities times the width add up to 1.
    pub fn bars(&self) -> Vec<(f64, f64)> {
        let whole = self.moments.count.max(1) as f64 * self.width;
        let bar =
            |(k, count): (usize, &usize)| ((k + 1) as f64 * self.width, *count as f64 / whole);
        self.counts.iter().enumerate().map(bar).collect()
    }

    /// The same without Maxwell's curve: of discs that are no gas in equilibrium it tells nothing.
    pub fn bare(self) -> Self {
        Self { is_bare: true, ..self }
    }

    /// Width of a bin, m/s.
    pub fn width(&self) -> f64 {
        self.width
    }

    /// Whether no disc moves in any frame.
    pub fn is_at_rest(&self) -> bool {
        self.moments.largest == 0.0
    }

    /// The parameter s of Maxwell's distribution of the same mean square speed, m/s.
    fn s(&self) -> f64 {
        self.moments.rms() / 2f64.sqrt()
    }

    /// Density (s/m) at a `speed` (m/s) of discs in equilibrium that have the masses and the kinetic energy of
    /// these: each mass m has a distribution of its own, s² = kT/m with kT = <m v²>/2.
    pub fn equilibrium(&self, speed: f64) -> f64 {
        let Moments { count, masses, sum_kinetic, .. } = &self.moments;
        let count = *count as f64;
        let of_mass = |(bits, n): (&u64, &usize)| {
            let s = (0.5 * sum_kinetic / count / f64::from_bits(*bits)).sqrt();
            *n as f64 / count * maxwell(speed, s)
        };
        masses.iter().map(of_mass).sum()
    }

    fn is_of_one_mass(&self) -> bool {
        self.moments.masses.len() < 2
    }

    fn name_of_curve(&self) -> &'static str {
        if self.is_of_one_mass() { "Maxwell, 2D" } else { "Maxwell, 2D, of these masses" }
    }

    /// Speeds (m/s) and densities (s/m) of the curve.
    fn curve(&self) -> Vec<(f64, f64)> {
        let (end, s) = (self.last_edge(), self.s());
        let density = |speed| match self.is_of_one_mass() {
            true => maxwell(speed, s),
            false => self.equilibrium(speed),
        };
        (0..=POINTS).map(|k| end * k as f64 / POINTS as f64).map(|v| (v, density(v))).collect()
    }

    fn has_curve(&self) -> bool {
        let s = self.s();
        !self.is_bare && s.is_finite() && s > 1e-300
    }

    fn last_edge(&self) -> f64 {
        self.counts.len() as f64 * self.width
    }

    fn remark(&self) -> String {
        let Moments { count, .. } = self.moments;
        let speeds = if count == 1 { "speed" } else { "speeds" };
        if self.is_at_rest() {
            return format!("{count} {speeds}, all zero");
        }
        let [mean, rms] = [self.moments.mean(), self.moments.rms()].map(|v| typographic(v, 3));
        format!("{count} {speeds}, mean {mean} m/s, rms {rms} m/s")
    }

    /// A title for the frames counted: the `time` (s) of one, or that many were pooled.
    pub fn title(&self, time: Option<f64>) -> String {
        match (self.moments.frames, time) {
            (0 | 1, Some(time)) => format!("Speeds at t = {} s", seconds(time, 4)),
            (0 | 1, None) => "Speeds".to_owned(),
            (frames, _) => format!("Speeds of {frames} frames"),
        }
    }
}

/// The picture of a histogram.
pub fn figure(histogram: &Histogram, title: &str) -> Figure {
    let end = histogram.last_edge();
    let x = Axis { low: Some(0.0), high: Some(end), ..Axis::linear("speed, m/s") };
    let y = Axis { low: Some(0.0), margin: 0.05, ..Axis::linear("probability density, s/m") };
    let mut chart = Chart::new(title, x, y);
    let bars = Mark::Bars(histogram.width);
    // Speeds that are all zero have no density; the empty axes say so.
    let points = if histogram.is_at_rest() { Vec::new() } else { histogram.bars() };
    chart.series.push(Series::new("discs", BARS, bars, points));
    if histogram.has_curve() {
        let (name, points) = (histogram.name_of_curve(), histogram.curve());
        chart.series.push(Series::new(name, CURVE, Mark::Line(2.0, ""), points));
    }
    chart.remarks.push(histogram.remark());
    Figure::of_chart(chart)
}

/// The script that draws [`figure`], with the numbers in it.
pub fn script(stem: &str, histogram: &Histogram, title: &str) -> String {
    let size = figure(histogram, title).panel;
    let mut text = gnuplot::head(stem, "Histogram of speeds", size, "png pdf");
    let bar =
        |(right, density): (f64, f64)| format!("{:e} {density:e}", right - 0.5 * histogram.width);
    text += &gnuplot::block("speeds", histogram.bars().into_iter().map(bar));
    let mut curves = vec![format!(
        "$speeds using 1:{} with boxes fs solid border lc rgb 'white' fc rgb '{BARS}' title 'discs'",
        if histogram.is_at_rest() { "(0)" } else { "2" }
    )];
    let curve = format!("with lines lw 2 lc rgb '{CURVE}' title '{}'", histogram.name_of_curve());
    if histogram.has_curve() && !histogram.is_of_one_mass() {
        let point = |(speed, density)| format!("{speed:e} {density:e}");
        text += &gnuplot::block("curve", histogram.curve().into_iter().map(point));
        curves.push(format!("$curve using 1:2 {curve}"));
    } else if histogram.has_curve() {
        let _ = writeln!(text, "s = {:e}                # m/s, s^2 = <v^2>/2", histogram.s());
        curves.push(format!("x/s**2 * exp(-x**2 / (2*s**2)) {curve}"));
    }
    curves.push(format!("keyentry title {}", quoted(&histogram.remark())));
    let _ = write!(
        text,
        "set title {} noenhanced\nset xrange [0:{:e}] ; set xlabel 'speed, m/s'\n\
         set yrange [0:{}] ; set ylabel 'probability density, s/m'\n\
         set boxwidth {:e}\nset grid linecolor rgb 'gray85'\nset samples 400\n\
         set key outside top center horizontal noenhanced\nplot {}\n",
        quoted(title),
        histogram.last_edge(),
        if histogram.is_at_rest() { "1" } else { "*" },
        histogram.width,
        curves.join(", \\\n    "),
    );
    text
}
