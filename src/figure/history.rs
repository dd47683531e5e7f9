//! What single discs do over time: position, velocity, speed. A disc that bounces is a vertical line in a picture
//! of its path, and a row of parabolas here.

use clap::ValueEnum;
use std::fmt::Write;

use glam::DVec2;

use super::axis::Axis;
use super::chart::{Chart, Mark, Series};
use super::colour::OKABE_ITO;
use super::gnuplot::{self, quoted};
use super::{Figure, Panel};
use crate::named::named;
use crate::number::counted;
use crate::output::frames::{Frame, FrameRow};

/// A panel, px.
const PANEL: (f64, f64) = (900.0, 280.0);

named! {
    /// Something that a disc has at every moment.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
    pub enum Quantity, name {
        /// From the left wall
        X = "x",
        /// Above the floor
        Y = "y",
        /// Velocity to the right
        Vx = "vx",
        /// Velocity upward
        Vy = "vy",
        /// Size of the velocity
        Speed = "speed",
    }
}

impl Quantity {
    /// Whether it can be had from frames with velocities only.
    pub fn is_of_velocity(self) -> bool {
        !matches!(self, Self::X | Self::Y)
    }

    fn label(self) -> String {
        let unit = if self.is_of_velocity() { "m/s" } else { "m" };
        format!("{}, {unit}", self.name())
    }

    /// Its value for a disc; none where the file has no velocity.
    fn of(self, row: &FrameRow) -> Option<f64> {
        let velocity = || row.velocity.map(|v: DVec2| [v.x, v.y, v.x.hypot(v.y)]);
        match self {
            Self::X => Some(row.position.x),
            Self::Y => Some(row.position.y),
            Self::Vx => velocity().map(|v| v[0]),
            Self::Vy => velocity().map(|v| v[1]),
            Self::Speed => velocity().map(|v| v[2]),
        }
    }
}

/// The history of some discs, gathered frame by frame.
#[derive(Clone, Debug)]
pub struct History {
    discs: Vec<usize>,
    quantities: Vec<Quantity>,
    has_times: bool,
    /// Time, s, or number of a frame; then all quantities of the first disc, of the second ...
    rows: Vec<(f64, Vec<f64>)>,
}

impl History {
    /// Of these discs and quantities, without a frame yet.
    pub fn begin(discs: Vec<usize>, quantities: Vec<Quantity>) -> Self {
        Self { discs, quantities, has_times: true, rows: Vec::new() }
    }

    /// Goes on to the next frame.
    pub fn add(&mut self, frame: &Frame) {
        self.has_times &= frame.time.is_some();
        let time = frame.time.unwrap_or(self.rows.len() as f64);
        let value = |disc: usize, quantity: Quantity| {
            frame.rows.get(disc).and_then(|row| quantity.of(row)).unwrap_or(f64::NAN)
        };
        let of_disc = |&disc: &usize| self.quantities.iter().map(move |&q| value(disc, q));
        let values = self.discs.iter().flat_map(of_disc).collect();
        self.rows.push((time, values));
    }

    fn title(&self) -> String {
        let frames = counted(self.rows.len(), "frame");
        match self.discs[..] {
            [disc] => format!("Disc {disc}, {frames}"),
            _ => format!("{}, {frames}", counted(self.discs.len(), "disc")),
        }
    }

    fn time_label(&self) -> &'static str {
        if self.has_times { "time, s" } else { "frame" }
    }

    /// Where `quantity` of a disc, both by their place in the lists, stands in a row.
    fn column(&self, disc: usize, quantity: usize) -> usize {
        disc * self.quantities.len() + quantity
    }

    /// The picture: a panel a quantity, a curve a disc.
    pub fn figure(&self) -> Figure {
        let panel = |(k, quantity): (usize, &Quantity)| {
            let y = Axis { margin: 0.05, ..Axis::linear(&quantity.label()) };
            let title = if k == 0 { self.title() } else { String::new() };
            let mut chart = Chart::new(&title, Axis::linear(self.time_label()), y);
            chart.is_labelled = true;
            for (i, disc) in self.discs.iter().enumerate() {
                let column = self.column(i, k);
                let points = self.rows.iter().map(|(time, values)| (*time, values[column]));
                let mark = Mark::Line(1.5, dash(i).0);
                chart.series.push(Series::new(&name(*disc), colour(i), mark, points.collect()));
            }
            Panel::Chart(chart)
        };
        let panels: Vec<Panel> = self.quantities.iter().enumerate().map(panel).collect();
        Figure { panels, columns: 1, panel: PANEL, strip: None }
    }

    /// The script that draws it; the numbers are in it, since a frame's time stands in a remark.
    pub fn script(&self, stem: &str) -> String {
        let size = (PANEL.0, PANEL.1 * self.quantities.len() as f64);
        let mut text = gnuplot::head(stem, "Discs over time", size, "png pdf");
        let row = |(time, values): &(f64, Vec<f64>)| {
            let values: String = values.iter().map(|value| format!(" {value:e}")).collect();
            format!("{time:e}{values}")
        };
        text += &gnuplot::block("history", self.rows.iter().map(row));
        // Into memory, which does not fail.
        let _ = write!(
            text,
            "set key {} noenhanced\n\
             set grid linecolor rgb 'gray85' ; set autoscale xfix ; set offsets 0,0,graph 0.05,graph 0.05\n\
             set lmargin 12 ; set xlabel '{}'\nset multiplot layout {},1 title {} noenhanced\n",
            if self.discs.len() > 1 { "outside right center samplen 2" } else { "off" },
            self.time_label(),
            self.quantities.len(),
            quoted(&self.title()),
        );
        for (k, quantity) in self.quantities.iter().enumerate() {
            let curve = |(i, disc): (usize, &usize)| {
                format!(
                    "$history using 1:{} with lines lw 1.5 dt {} lc rgb '{}' title '{}'",
                    self.column(i, k) + 2,
                    dash(i).1,
                    colour(i),
                    name(*disc)
                )
            };
            let curves: Vec<_> = self.discs.iter().enumerate().map(curve).collect();
            let label = quantity.label();
            let _ = writeln!(text, "set ylabel '{label}'\nplot {}", curves.join(", \\\n    "));
        }
        text + "unset multiplot\n"
    }
}

fn name(disc: usize) -> String {
    format!("disc {disc}")
}

fn colour(i: usize) -> &'static str {
    OKABE_ITO[i % OKABE_ITO.len()]
}

/// SVG's dashes and gnuplot's pattern: when the colours come back, as dashes.
fn dash(i: usize) -> (&'static str, &'static str) {
    [("", "1"), ("8 4", "'-'"), ("2 3", "'.'")][i / OKABE_ITO.len() % 3]
}
