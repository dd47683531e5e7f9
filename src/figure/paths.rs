//! All frames in one picture: the paths of a few discs, or some moments of many side by side.

use std::fmt::Write;

use glam::DVec2;

use super::colour::{OKABE_ITO, hex};
use super::frame::{self, ColourBy};
use super::gnuplot::{self, DataFile, quoted};
use super::scene::{Disc, Scene, left_out};
use super::survey::Survey;
use super::{Figure, Panel};
use crate::number::{counted, seconds, typographic};
use crate::output::frames::Frame;

/// More discs than this have no paths drawn: they would be a tangle.
pub const MOST_PATHS: usize = 50;
/// So many moments are shown of more discs.
const MOMENTS: usize = 6;
/// Points of a path closer than this fraction of the picture to the last one do not show.
const CLOSEST: f64 = 4e-4;
/// A longer path loses every second point.
const MOST_POINTS: usize = 8192;

/// The paths of the discs, gathered frame by frame.
pub struct Paths {
    survey: Survey,
    paths: Vec<Vec<DVec2>>, // m
    last: Frame,
}

impl Paths {
    /// The paths of the discs of frames that `survey` has seen.
    pub fn begin(survey: Survey) -> Self {
        Self { survey, paths: vec![Vec::new(); survey.discs], last: Frame::default() }
    }

    /// Goes on to the next frame.
    pub fn add(&mut self, frame: Frame) {
        let closest = CLOSEST * self.survey.view().width;
        for (path, row) in self.paths.iter_mut().zip(&frame.rows) {
            if path.last().is_none_or(|last| last.distance(row.position) > closest) {
                path.push(row.position);
            }
            if path.len() > MOST_POINTS {
                let mut is_kept = false;
                path.retain(|_| {
                    is_kept = !is_kept;
                    is_kept
                });
            }
        }
        self.last = frame;
    }

    /// The picture: paths, and the discs where they were last.
    pub fn figure(self) -> Figure {
        let (survey, last) = (self.survey, self.last);
        let mut scene = Scene::new(paths_title(&survey, &last), survey.view(), survey.side);
        let disc = |(k, row): (usize, &crate::output::frames::FrameRow)| Disc {
            centre: row.position,
            radius: row.radius,
            fill: rgb(OKABE_ITO[k % OKABE_ITO.len()]),
        };
        scene.discs = last.rows.iter().enumerate().map(disc).collect();
        let mut paths = self.paths;
        for (path, row) in paths.iter_mut().zip(&last.rows) {
            path.push(row.position); // though it is close
        }
        let colour = |k: usize| OKABE_ITO[k % OKABE_ITO.len()];
        scene.paths = paths.into_iter().enumerate().map(|(k, path)| (path, colour(k))).collect();
        Figure::of_scene(scene)
    }
}

fn paths_title(survey: &Survey, last: &Frame) -> String {
    let until =
        last.time.map_or(String::new(), |time| format!(" until t = {} s", seconds(time, 4)));
    let outside = left_out(last, survey.view());
    let paths = if survey.discs == 1 { "Path" } else { "Paths" };
    let (discs, frames) = (counted(survey.discs, "disc"), counted(survey.frames, "frame"));
    format!("{paths} of {discs}{until}, {frames}{outside}")
}

fn rgb(colour: &str) -> [u8; 3] {
    let channel = |k: usize| {
        let digits = colour.get(1 + 2 * k..3 + 2 * k).unwrap_or("00");
        u8::from_str_radix(digits, 16).unwrap_or(0)
    };
    [channel(0), channel(1), channel(2)]
}

/// The script that draws the picture of the paths from `data`.
pub fn script(stem: &str, data: &DataFile, survey: &Survey, last: &Frame) -> String {
    let mut text = gnuplot::head(stem, "Paths of the discs", (790.0, 730.0), "png pdf");
    text += &gnuplot::ground(survey.view(), survey.side);
    let (n, frame) = (survey.discs, survey.frames.saturating_sub(1));
    // Into memory, which does not fail.
    let _ = writeln!(
        text,
        "set title {} noenhanced\nif (!exists('file')) file = {}\n\
         colours = '{}'\ncolour(k) = word(colours, int(k) % {} + 1)\n\
         # Frames are apart in the file: a path is drawn from each place of disc i to its next.\n\
         disc = -1\n\
         step(i, x, y) = (from = i == disc ? x1 : NaN, y0 = y1, disc = i, x1 = x, y1 = y, from)\n\
         x1 = NaN ; y1 = NaN\n\
         plot for [i=0:{last}] file index 0:{frame} every ::i::i using (step(i, $1, $2)):(y0):(x1 - from):(y1 - y0) \
         with vectors nohead lw 1 lc rgb colour(i), \\\n    \
         for [i=0:{last}] file index {frame} every ::i::i using 1:2:3 with circles fs solid noborder fc rgb colour(i)",
        quoted(&paths_title(survey, last)),
        data.expression(),
        OKABE_ITO.join(" "),
        OKABE_ITO.len(),
        last = n.saturating_sub(1),
    );
    text
}

/// How far the discs have come, gathered frame by frame: what happens, and when nothing does.
#[derive(Clone, Debug, Default)]
pub struct Travel {
    places: Vec<DVec2>, // m, of the last frame
    way: Vec<f64>,      // m, of all discs together until each frame
}

impl Travel {
    /// Goes on to the next frame.
    pub fn add(&mut self, frame: &Frame) {
        let steps = self.places.iter().zip(&frame.rows);
        let step: f64 = steps.map(|(from, row)| from.distance(row.position)).sum();
        let so_far = self.way.last().copied().unwrap_or(0.0);
        self.way.push(if step.is_finite() { so_far + step } else { so_far });
        self.places.clear();
        self.places.extend(frame.rows.iter().map(|row| row.position));
    }

    /// The frames that are shown as moments: the first, the last, and between them equal parts of the way that
    /// the discs went. Discs that have come to rest are shown once.
    pub fn moments(&self) -> Vec<usize> {
        let last = self.way.len().saturating_sub(1);
        let shown = MOMENTS.min(self.way.len().max(1));
        let whole = self.way.last().copied().unwrap_or(0.0);
        let mut chosen = vec![0];
        for k in 1..shown {
            let part = k as f64 / (shown - 1) as f64;
            let wanted = match whole > 0.0 {
                true => self.way.partition_point(|way| *way < part * whole),
                false => (part * last as f64) as usize,
            };
            let room = last - (shown - 1 - k); // for those after it
            let next = chosen[k - 1] + 1;
            chosen.push(if k + 1 == shown { last } else { wanted.clamp(next, room) });
        }
        chosen
    }
}

/// `t = 0.0100 s`, or which frame it is.
fn moment_title(index: usize, frame: &Frame) -> String {
    frame.time.map_or(format!("frame {index}"), |time| format!("t = {} s", seconds(time, 4)))
}

/// The picture of some moments, each with the number of its frame.
pub fn moments_figure(survey: &Survey, chosen: &[(usize, Frame)]) -> Figure {
    let by = if survey.has_velocities { ColourBy::Speed } else { ColourBy::Nothing };
    let range = (0.0, survey.fastest);
    let panel = |(index, frame): &(usize, Frame)| {
        let mut scene = Scene::new(moment_title(*index, frame), survey.view(), survey.side);
        scene.discs = frame::discs(frame, by, range);
        scene.has_axes = false;
        Panel::Scene(scene)
    };
    let panels = chosen.iter().map(panel).collect();
    let strip = by.bar(range);
    Figure { panels, columns: 3.min(chosen.len()), panel: (330.0, 360.0), strip }
}

/// The script that draws [`moments_figure`] from `data`.
pub fn moments_script(
    stem: &str,
    data: &DataFile,
    survey: &Survey,
    chosen: &[(usize, Frame)],
) -> String {
    let rows = chosen.len().div_ceil(3);
    let columns = chosen.len().min(3);
    let size = (330.0 * columns as f64, 360.0 * rows as f64 + 40.0);
    let mut text = gnuplot::head(stem, "Moments of a run", size, "png pdf");
    text += &gnuplot::ground(survey.view(), survey.side);
    text += "unset xlabel ; unset ylabel ; unset tics ; unset border\n";
    let fill = if survey.has_velocities {
        text += &gnuplot::palette(0.0, survey.fastest, "speed, m/s");
        text += "unset colorbox\n";
        "1:2:3:(sqrt($4**2 + $5**2)) with circles fs solid noborder lc palette".to_owned()
    } else {
        format!("1:2:3 with circles fs solid noborder fc rgb '{}'", hex(frame::PLAIN))
    };
    let title = if survey.has_velocities && survey.fastest > 0.0 {
        format!("speed from 0 (dark) to {} m/s (light)", typographic(survey.fastest, 3))
    } else {
        String::new()
    };
    let _ = write!(
        text,
        "if (!exists('file')) file = {}\nset multiplot layout {rows},{columns} title {}\n",
        data.expression(),
        quoted(&title)
    );
    for (index, frame) in chosen {
        let selection = frame::selection(frame, *index);
        let title = quoted(&moment_title(*index, frame));
        let _ = writeln!(text, "set title {title}\nplot file {selection} using {fill}");
    }
    text + "unset multiplot\n"
}
