//! One frame: discs to scale in their box.

use clap::ValueEnum;
use std::fmt::Write;

use super::Figure;
use super::colour;
use super::gnuplot::{self, DataFile};
use super::scene::{ColourBar, Disc, Extent, Scene, Stroke, View, left_out};
use crate::number::{counted, seconds};
use crate::output::frames::{Frame, FrameRow};

/// The longest arrow, as a fraction of what is shown.
pub const LONGEST_ARROW: f64 = 0.05;
/// Colour of discs that show nothing by their colour.
pub const PLAIN: [u8; 3] = [0x56, 0xb4, 0xe9];
/// The edge of such discs.
const PLAIN_EDGE: [u8; 3] = [0x00, 0x72, 0xb2];

/// What the colour of a disc says.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum ColourBy {
    /// Speed
    Speed,
    /// Radius
    Radius,
    /// One colour for all
    #[value(name = "none")]
    Nothing,
}

impl ColourBy {
    /// The value that colours a disc.
    pub fn value(self, row: &FrameRow) -> f64 {
        match self {
            Self::Speed => speed(row),
            Self::Radius => row.radius,
            Self::Nothing => 0.0,
        }
    }

    /// The range of values over a frame; from zero for speeds.
    pub fn range(self, frame: &Frame) -> (f64, f64) {
        let values = frame.rows.iter().map(|row| self.value(row));
        let high = values.clone().fold(0.0, f64::max);
        let low = match self {
            Self::Radius => values.fold(high, f64::min),
            _ => 0.0,
        };
        (low, high)
    }

    /// The scale of colours for values in a range, if they differ.
    pub fn bar(self, (low, high): (f64, f64)) -> Option<ColourBar> {
        let label = match self {
            Self::Speed => "speed, m/s",
            Self::Radius => "radius, m",
            Self::Nothing => return None,
        };
        (high > low && high.is_finite()).then(|| ColourBar { low, high, label: label.to_owned() })
    }
}

/// Speed of a disc, m/s; 0 if the file does not say.
pub fn speed(row: &FrameRow) -> f64 {
    // Not `length`, whose squares overflow sooner.
    row.velocity.map_or(0.0, |v| v.x.hypot(v.y)).min(f64::MAX)
}

/// The fastest disc's speed, m/s.
pub fn fastest(frame: &Frame) -> f64 {
    frame.rows.iter().map(speed).fold(0.0, f64::max)
}

/// The discs of `frame`, coloured by what `by` says over a `range`.
pub fn discs(frame: &Frame, by: ColourBy, (low, high): (f64, f64)) -> Vec<Disc> {
    let fill = |row: &FrameRow| match by {
        ColourBy::Nothing => PLAIN,
        _ => colour::at((by.value(row) - low) / (high - low)),
    };
    let disc = |row| (row, fill(row));
    let discs = frame.rows.iter().map(disc);
    discs.map(|(row, fill)| Disc { centre: row.position, radius: row.radius, fill }).collect()
}

/// The discs of `frame` in one colour.
pub fn plain_discs(frame: &Frame, fill: [u8; 3]) -> Vec<Disc> {
    let disc = |row: &FrameRow| Disc { centre: row.position, radius: row.radius, fill };
    frame.rows.iter().map(disc).collect()
}

/// Arrows along the velocities, the fastest of [`LONGEST_ARROW`] of `width` (m).
pub fn arrows(frame: &Frame, width: f64, tint: impl Fn(f64) -> [u8; 3]) -> Vec<Stroke> {
    let fastest = fastest(frame);
    let arrow = |row: &FrameRow| {
        let along = row.velocity? / fastest * LONGEST_ARROW * width;
        let colour = tint(speed(row) / fastest);
        along.is_finite().then(|| Stroke { from: row.position, to: row.position + along, colour })
    };
    frame.rows.iter().filter_map(arrow).collect()
}

/// `t = 0.0100 s, ` if the frame says its time.
pub fn time(frame: &Frame) -> String {
    frame.time.map_or(String::new(), |time| format!("t = {} s, ", seconds(time, 4)))
}

/// What a frame's picture shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Choice {
    /// What colours the discs.
    pub by: ColourBy,
    /// Whether there are arrows along the velocities.
    pub vectors: bool,
}

/// The view of one frame.
pub fn view(frame: &Frame) -> View {
    let mut extent = Extent::EMPTY;
    extent.add(frame);
    View::of(extent, frame.side)
}

fn title(frame: &Frame, choice: Choice) -> String {
    let discs = counted(frame.rows.len(), "disc");
    let rest = match choice {
        Choice { by: ColourBy::Nothing, vectors: false } => "",
        _ if frame.rows.iter().all(|row| row.velocity.is_none()) => "",
        _ if fastest(frame) == 0.0 => ", all at rest",
        _ => "",
    };
    format!("{}{discs}{rest}{}", time(frame), left_out(frame, view(frame)))
}

/// The picture of one frame.
pub fn figure(frame: &Frame, choice: Choice) -> Figure {
    let view = view(frame);
    let mut scene = Scene::new(title(frame, choice), view, frame.side);
    let range = choice.by.range(frame);
    scene.discs = discs(frame, choice.by, range);
    scene.bar = choice.by.bar(range);
    if choice.by == ColourBy::Nothing {
        scene.edge = PLAIN_EDGE;
    }
    if choice.vectors {
        scene.arrows = arrows(frame, box_width(frame), |_| [0; 3]);
    }
    Figure::of_scene(scene)
}

/// Side of the box, m, or of what is shown if there is none.
pub fn box_width(frame: &Frame) -> f64 {
    frame.side.unwrap_or(view(frame).width)
}

/// gnuplot's selection of one frame of a file: `index` and, without a border, `every`.
pub fn selection(frame: &Frame, index: usize) -> String {
    format!("index {index} every ::0::{}", frame.rows.len().saturating_sub(1))
}

/// The script that draws [`figure`] from frame `index` of `data`.
pub fn script(stem: &str, data: &DataFile, index: usize, frame: &Frame, choice: Choice) -> String {
    let figure = figure(frame, choice);
    let range = choice.by.range(frame);
    let mut text = gnuplot::head(stem, "Discs to scale", figure.panel, "png pdf");
    text += &gnuplot::ground(view(frame), frame.side);
    let (selection, file) = (selection(frame, index), data.expression());
    let [fill, edge] = [PLAIN, PLAIN_EDGE].map(colour::hex);
    let colour = match choice.by {
        ColourBy::Nothing => {
            format!("1:2:3 with circles fc rgb '{fill}' fs solid border lc rgb '{edge}'")
        }
        ColourBy::Radius => "1:2:3:3 with circles fs solid noborder lc palette".to_owned(),
        ColourBy::Speed => {
            "1:2:3:(sqrt($4**2 + $5**2)) with circles fs solid noborder lc palette".to_owned()
        }
    };
    if choice.by != ColourBy::Nothing {
        let label = choice.by.bar(range).map_or(String::new(), |bar| bar.label);
        text += &gnuplot::palette(range.0, range.1, &label);
    }
    let _ = write!(
        text,
        "set title {} noenhanced\nif (!exists('file')) file = {file}\n\
         plot file {selection} using {colour}",
        gnuplot::quoted(&title(frame, choice)),
    );
    let fastest = fastest(frame);
    if choice.vectors && fastest > 0.0 {
        let scale = LONGEST_ARROW * box_width(frame) / fastest;
        let _ = write!(
            text,
            ", \\\n    '' {selection} using 1:2:({scale:e} * $4):({scale:e} * $5) with vectors head \
             filled size screen 0.012,18 lw 1.5 lc rgb 'black'"
        );
    }
    text + "\n"
}

/// Whether the frame has velocities.
pub fn has_velocities(frame: &Frame) -> bool {
    frame.rows.iter().any(|row| row.velocity.is_some())
}
