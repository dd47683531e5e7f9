//! The velocity field: arrows coloured by speed over light discs.

use std::fmt::Write;

use super::Figure;
use super::colour;
use super::frame::{self, ColourBy, LONGEST_ARROW};
use super::gnuplot::{self, DataFile};
use super::scene::{Scene, left_out};
use crate::number::typographic;
use crate::output::frames::Frame;

const FILL: [u8; 3] = [0xe5; 3];
const EDGE: [u8; 3] = [0x99; 3];

fn title(frame: &Frame) -> String {
    let fastest = frame::fastest(frame);
    let speed = if fastest > 0.0 {
        format!("fastest disc {} m/s", typographic(fastest, 3))
    } else {
        "all discs at rest".to_owned()
    };
    format!("{}{speed}{}", frame::time(frame), left_out(frame, frame::view(frame)))
}

/// The velocity field of a frame; the fastest disc's arrow is 5 % of the box.
pub fn figure(frame: &Frame) -> Figure {
    let mut scene = Scene::new(title(frame), frame::view(frame), frame.side);
    scene.discs = frame::plain_discs(frame, FILL);
    scene.edge = EDGE;
    scene.bar = ColourBy::Speed.bar((0.0, frame::fastest(frame)));
    scene.arrows = frame::arrows(frame, frame::box_width(frame), colour::at);
    Figure::of_scene(scene)
}

/// The script that draws [`figure`] from frame `index` of `data`.
pub fn script(stem: &str, data: &DataFile, index: usize, frame: &Frame) -> String {
    let fastest = frame::fastest(frame);
    let scale = if fastest > 0.0 { LONGEST_ARROW * frame::box_width(frame) / fastest } else { 0.0 };
    let size = figure(frame).panel;
    let mut text = gnuplot::head(stem, "Velocity field", size, "png pdf");
    text += &gnuplot::ground(frame::view(frame), frame.side);
    text += &gnuplot::palette(0.0, fastest, "speed, m/s");
    let (selection, file) = (frame::selection(frame, index), data.expression());
    let [fill, edge] = [FILL, EDGE].map(colour::hex);
    // Into memory, which does not fail.
    let _ = writeln!(
        text,
        "set title {} noenhanced\nif (!exists('file')) file = {file}\n\
         plot file {selection} using 1:2:3 with circles fc rgb '{fill}' fs solid border lc rgb '{edge}', \\\n    \
         '' {selection} using 1:2:({scale:e} * $4):({scale:e} * $5):(sqrt($4**2 + $5**2)) \
         with vectors head filled size screen 0.012,18 lw 1.5 lc palette",
        gnuplot::quoted(&title(frame)),
    );
    text
}
