//! Discs to scale in their box, with arrows, lines and paths over them.

use glam::DVec2;

use super::axis::{Axis, Placed};
use super::colour::{SCALE, hex};
use super::svg::{Anchor, Area, Svg, TEXT, coordinate};
use crate::number::{counted, typographic};
use crate::output::frames::Frame;

/// Room around the box, as a fraction of its side.
pub const MARGIN: f64 = 0.03;
/// A picture that shows discs outside the box is at most so many boxes wide; farther ones are left
/// out and counted.
const WIDEST: f64 = 2.0;
/// Discs of fewer pixels than this have no edge of another colour.
const EDGE_FROM: f64 = 2.5; // px, radius
/// Arrows shorter than this are no arrows.
const SHORTEST_ARROW: f64 = 0.7; // px

/// Edges of discs whose colours say something.
const WHITE: [u8; 3] = [0xff; 3];

/// The square part of the plane that a scene shows.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct View {
    /// Lower left corner.
    pub corner: DVec2, // m
    /// Width and height.
    pub width: f64, // m
}

/// The rectangle that holds all discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extent {
    low: DVec2,  // m
    high: DVec2, // m
}

impl Extent {
    /// Of no disc.
    pub const EMPTY: Self = Self { low: DVec2::INFINITY, high: DVec2::NEG_INFINITY };

    /// Grows to hold the discs of `frame`.
    pub fn add(&mut self, frame: &Frame) {
        for row in &frame.rows {
            self.low = self.low.min(row.position - row.radius.abs());
            self.high = self.high.max(row.position + row.radius.abs());
        }
    }
}

impl View {
    /// What to show of discs in a box of `side` (m), or without a box: the box with a little
    /// room, or all discs if they are not far outside it.
    pub fn of(extent: Extent, side: Option<f64>) -> Self {
        let side = side.filter(|side| *side > 0.0 && *side < 1e100);
        let (mut low, mut high) =
            (extent.low.max(DVec2::splat(-1e100)), extent.high.min(DVec2::splat(1e100)));
        if let Some(side) = side {
            let room = DVec2::splat(MARGIN * side);
            let (box_low, box_high) = (-room, DVec2::splat(side) + room);
            (low, high) = (low.min(box_low), high.max(box_high));
            if (high - low).max_element() > WIDEST * side {
                (low, high) = (box_low, box_high);
            }
        }
        let width = (high - low).max_element();
        if !(width > 0.0 && width.is_finite()) {
            return Self { corner: DVec2::splat(-0.5), width: 1.0 };
        }
        let room = if side.is_some() { 0.0 } else { MARGIN * width };
        let middle = low + 0.5 * (high - low);
        let width = width + 2.0 * room;
        Self { corner: middle - 0.5 * width, width }
    }

    /// Whether the view holds the point (m).
    pub fn holds(&self, point: DVec2) -> bool {
        let inside = (point - self.corner) / self.width;
        inside.min_element() >= 0.0 && inside.max_element() <= 1.0
    }

    /// Lower left and upper right corner, m.
    pub fn corners(&self) -> (DVec2, DVec2) {
        (self.corner, self.corner + self.width)
    }
}

/// How many discs of `frame` the view leaves out, as a remark; empty if none.
pub fn left_out(frame: &Frame, view: View) -> String {
    let out = frame.rows.iter().filter(|row| !view.holds(row.position)).count();
    match out {
        0 => String::new(),
        _ => format!(", {out} of {} outside the picture", counted(frame.rows.len(), "disc")),
    }
}

/// A disc of a scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disc {
    /// Centre, m.
    pub centre: DVec2,
    /// Radius, m.
    pub radius: f64,
    /// Colour as red, green, blue.
    pub fill: [u8; 3],
}

/// An arrow, or a straight line of some width.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Where it begins, m.
    pub from: DVec2,
    /// Where it ends, m.
    pub to: DVec2,
    /// Its colour.
    pub colour: [u8; 3],
}

/// A scale of colours with its numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct ColourBar {
    /// Value of the darkest colour.
    pub low: f64,
    /// Value of the lightest.
    pub high: f64,
    /// What it is, with its unit.
    pub label: String,
}

/// Discs in their box.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// Above the picture.
    pub title: String,
    /// What is shown.
    pub view: View,
    /// Side of the box, m, whose outline is drawn.
    pub side: Option<f64>,
    /// The discs.
    pub discs: Vec<Disc>,
    /// Colour of the discs' edges, if they are large enough to have one; unless white, the colour
    /// of discs that are mere dots.
    pub edge: [u8; 3],
    /// Lines through many points (m), over the discs.
    pub paths: Vec<(Vec<DVec2>, &'static str)>,
    /// Lines with their widths, m.
    pub lines: Vec<(Stroke, f64)>,
    /// Arrows.
    pub arrows: Vec<Stroke>,
    /// The scale of colours beside the picture.
    pub bar: Option<ColourBar>,
    /// Colours and what they stand for, in a line below the title.
    pub legend: Vec<(String, String)>,
    /// Whether there are axes with numbers.
    pub has_axes: bool,
}

impl Scene {
    /// A scene without discs.
    pub fn new(title: String, view: View, side: Option<f64>) -> Self {
        Self { title, view, side, edge: WHITE, has_axes: true, ..Self::default() }
    }

    /// Draws the scene into `area`: as large as fits, both directions to one scale.
    pub fn draw(&self, svg: &mut Svg, area: Area) {
        let legend = if self.legend.is_empty() { 0.0 } else { 22.0 };
        let (left, below) = if self.has_axes { (76.0, 54.0) } else { (10.0, 8.0) };
        let right = if self.bar.is_some() { 92.0 } else { 20.0 };
        let right = if self.has_axes { right } else { 10.0 };
        let head = 36.0 + legend;
        let size = (area.width - left - right).min(area.height - head - below).max(20.0);
        let plot = Area { left: area.left + left, top: area.top + head, width: size, height: size };
        let ground = Ground { plot, view: self.view };
        svg.text((plot.left + size / 2.0, area.top + 24.0), Anchor::Middle, &self.title);
        self.draw_legend(svg, (plot.left, area.top + 45.0));
        svg.begin_clipped(plot, "");
        ground.draw_box(svg, self.side);
        ground.draw_discs(svg, &self.discs, self.edge);
        ground.draw_paths(svg, &self.paths);
        ground.draw_lines(svg, &self.lines);
        ground.draw_arrows(svg, &self.arrows);
        svg.end_group();
        if self.has_axes {
            ground.draw_axes(svg);
        }
        if let Some(bar) = &self.bar {
            draw_bar(svg, bar, plot);
        }
    }

    fn draw_legend(&self, svg: &mut Svg, (left, y): (f64, f64)) {
        let mut x = left;
        for (colour, text) in &self.legend {
            svg.line((x, y), (x + 24.0, y), &format!("stroke=\"{colour}\" stroke-width=\"5\""));
            svg.text((x + 30.0, y + 0.35 * TEXT), Anchor::Start, text);
            x += 30.0 + super::svg::text_width(text) + 18.0;
        }
    }
}

/// The part of the picture that shows the plane.
struct Ground {
    plot: Area,
    view: View,
}

impl Ground {
    /// Pixels of so many metres.
    fn pixels(&self, length: f64) -> f64 {
        length / self.view.width * self.plot.width
    }

    fn point(&self, at: DVec2) -> (f64, f64) {
        let from_corner = at - self.view.corner;
        (
            self.plot.left + self.pixels(from_corner.x),
            self.plot.bottom() - self.pixels(from_corner.y),
        )
    }

    fn draw_box(&self, svg: &mut Svg, side: Option<f64>) {
        if let Some(side) = side {
            let (left, top) = self.point(DVec2::new(0.0, side));
            let size = self.pixels(side);
            let area = Area { left, top, width: size, height: size };
            svg.rectangle(area, "class=\"box\" fill=\"none\" stroke=\"black\"");
        }
    }

    fn draw_discs(&self, svg: &mut Svg, discs: &[Disc], tint: [u8; 3]) {
        let largest = discs.iter().map(|disc| self.pixels(disc.radius)).fold(0.0, f64::max);
        let edge = if largest >= EDGE_FROM {
            format!(" stroke=\"{}\" stroke-width=\"0.5\"", hex(tint))
        } else {
            String::new()
        };
        // A light dot would not be seen.
        let is_dot = edge.is_empty();
        // Discs of one colour in a row share a group.
        for same in discs.chunk_by(|a, b| a.fill == b.fill) {
            let is_light = same[0].fill.iter().all(|channel| *channel > 0x50);
            let fill = if is_dot && is_light && tint != WHITE { tint } else { same[0].fill };
            let fill = hex(fill);
            svg.begin_group(&format!("class=\"discs\" fill=\"{fill}\"{edge}"));
            for disc in same.iter().filter(|disc| disc.radius >= 0.0) {
                svg.circle(self.point(disc.centre), self.pixels(disc.radius), "");
            }
            svg.end_group();
        }
    }

    fn draw_paths(&self, svg: &mut Svg, paths: &[(Vec<DVec2>, &'static str)]) {
        for (path, colour) in paths {
            let points: Vec<_> = path.iter().map(|&point| self.point(point)).collect();
            svg.polyline(&points, &format!("fill=\"none\" stroke=\"{colour}\""));
        }
    }

    fn draw_lines(&self, svg: &mut Svg, lines: &[(Stroke, f64)]) {
        for (line, width) in lines {
            let style = format!(
                "stroke=\"{}\" stroke-width=\"{}\"",
                hex(line.colour),
                coordinate(self.pixels(*width).max(0.3))
            );
            svg.line(self.point(line.from), self.point(line.to), &style);
        }
    }

    fn draw_arrows(&self, svg: &mut Svg, arrows: &[Stroke]) {
        for arrow in arrows {
            let ((x1, y1), (x2, y2)) = (self.point(arrow.from), self.point(arrow.to));
            let (dx, dy) = (x2 - x1, y2 - y1);
            let length = dx.hypot(dy);
            if length < SHORTEST_ARROW {
                continue;
            }
            let (ux, uy) = (dx / length, dy / length);
            let head = (0.45 * length).min(9.0);
            let (bx, by) = (x2 - head * ux, y2 - head * uy);
            let (wx, wy) = (-0.36 * head * uy, 0.36 * head * ux);
            let colour = hex(arrow.colour);
            let style = format!("class=\"arrow\" stroke=\"{colour}\" stroke-width=\"1.5\"");
            svg.line((x1, y1), (bx, by), &style);
            let corners = [(x2, y2), (bx + wx, by + wy), (bx - wx, by - wy)];
            svg.polygon(&corners, &format!("fill=\"{colour}\""));
        }
    }

    /// Marks along the lower and the left edge, the same on both.
    fn draw_axes(&self, svg: &mut Svg) {
        let (plot, (low, high)) = (self.plot, self.view.corners());
        let stroke = "stroke=\"black\"";
        svg.rectangle(plot, "fill=\"none\" stroke=\"#a0a0a0\"");
        let fixed = |low, high| Axis { low: Some(low), high: Some(high), ..Axis::linear("") };
        let most = ((plot.width / 100.0) as usize).clamp(2, 6); // texts do not run into each other
        let (x, y) = (fixed(low.x, high.x), fixed(low.y, high.y));
        let (marks, power) = x.fit(std::iter::empty()).marks(most);
        for (mark, text) in marks {
            let (at, _) = self.point(DVec2::new(mark, 0.0));
            svg.line((at, plot.bottom()), (at, plot.bottom() + 5.0), stroke);
            svg.text((at, plot.bottom() + 20.0), Anchor::Middle, &text);
        }
        let below = (plot.left + plot.width / 2.0, plot.bottom() + 42.0);
        svg.text(below, Anchor::Middle, &Placed::titled("x, m", power));
        let (marks, power) = y.fit(std::iter::empty()).marks(most);
        for (mark, text) in marks {
            let (_, at) = self.point(DVec2::new(0.0, mark));
            svg.line((plot.left, at), (plot.left - 5.0, at), stroke);
            svg.text((plot.left - 8.0, at + 0.35 * TEXT), Anchor::End, &text);
        }
        let beside = (plot.left - 58.0, plot.top + plot.height / 2.0);
        svg.text_upward(beside, &Placed::titled("y, m", power));
    }
}

fn draw_bar(svg: &mut Svg, bar: &ColourBar, plot: Area) {
    let area = Area { left: plot.right() + 14.0, width: 14.0, ..plot };
    define_scale(svg, "x1=\"0\" y1=\"1\" x2=\"0\" y2=\"0\"");
    svg.rectangle(area, "fill=\"url(#scale)\" stroke=\"black\"");
    let axis = Axis { low: Some(bar.low), high: Some(bar.high), ..Axis::linear("") };
    let axis = axis.fit(std::iter::empty());
    let (marks, power) = axis.marks(6);
    for (mark, text) in marks {
        if let Some(place) = axis.place(mark) {
            let y = area.bottom() - place * area.height;
            svg.line((area.right(), y), (area.right() + 4.0, y), "stroke=\"black\"");
            svg.text((area.right() + 7.0, y + 0.35 * TEXT), Anchor::Start, &text);
        }
    }
    let above = (area.right() + 34.0, plot.top - 10.0);
    svg.text(above, Anchor::End, &Placed::titled(&bar.label, power));
}

/// The colours of the scale along a direction, for what is filled with `url(#scale)`.
fn define_scale(svg: &mut Svg, direction: &str) {
    svg.element(&format!("<linearGradient id=\"scale\" {direction}>"));
    for (k, colour) in SCALE.iter().enumerate() {
        let offset = k as f64 / (SCALE.len() - 1) as f64;
        svg.element(&format!("<stop offset=\"{offset:.4}\" stop-color=\"{}\"/>", hex(*colour)));
    }
    svg.element("</linearGradient>");
}

/// A scale of colours from left to right in the middle of a picture of this `width` (px), near its
/// upper edge.
pub(super) fn draw_strip(svg: &mut Svg, bar: &ColourBar, width: f64) {
    define_scale(svg, "x1=\"0\" y1=\"0\" x2=\"1\" y2=\"0\"");
    let area = Area { left: width / 2.0 - 120.0, top: 14.0, width: 240.0, height: 14.0 };
    svg.rectangle(area, "fill=\"url(#scale)\" stroke=\"black\"");
    let y = area.bottom() - 1.5;
    svg.text((area.left - 8.0, y), Anchor::End, &typographic(bar.low, 3));
    let (what, unit) = bar.label.rsplit_once(", ").unwrap_or((&bar.label, ""));
    let text = format!("{} {unit} ({what})", typographic(bar.high, 3));
    svg.text((area.right() + 8.0, y), Anchor::Start, &text);
}
