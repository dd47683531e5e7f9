//! A small SVG writer: one element a line, numbers with at most two decimals, text escaped.

use crate::number::decimals;
use std::fmt::Write;

/// Text of labels is so high, pixels.
pub const TEXT: f64 = 14.0;

/// A rectangle of the picture, pixels from its upper left corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Left edge.
    pub left: f64, // px
    /// Upper edge.
    pub top: f64, // px
    /// Width.
    pub width: f64, // px
    /// Height.
    pub height: f64, // px
}

impl Area {
    /// Right edge, pixels.
    pub fn right(&self) -> f64 {
        self.left + self.width
    }

    /// Lower edge, pixels.
    pub fn bottom(&self) -> f64 {
        self.top + self.height
    }
}

/// Where a text stands from its point.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Anchor {
    /// The text begins at the point.
    Start,
    /// The point is its middle.
    Middle,
    /// The text ends at the point.
    End,
}

/// A picture being drawn.
pub struct Svg {
    text: String,
    clips: usize,
}

impl Svg {
    /// A white picture of `width` by `height` pixels.
    pub fn new(width: f64, height: f64) -> Self {
        let (w, h) = (coordinate(width), coordinate(height));
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{w}\" height=\"{h}\" \
             viewBox=\"0 0 {w} {h}\" font-family=\"Helvetica, Arial, sans-serif\" \
             font-size=\"{}\">\n<rect width=\"{w}\" height=\"{h}\" fill=\"white\"/>\n",
            coordinate(TEXT)
        );
        Self { text, clips: 0 }
    }

    /// Adds one element as it is: for what has no method of its own.
    pub fn element(&mut self, element: &str) {
        self.text.push_str(element);
        self.text.push('\n');
    }

    /// Begins a group with attributes for all in it.
    pub fn begin_group(&mut self, attributes: &str) {
        self.element(&format!("<g {attributes}>"));
    }

    /// Begins a group of which only what lies in `area` shows.
    pub fn begin_clipped(&mut self, area: Area, attributes: &str) {
        self.clips += 1;
        let id = format!("clip{}", self.clips);
        self.element(&format!("<clipPath id=\"{id}\">"));
        self.rectangle(area, "");
        self.element("</clipPath>");
        self.begin_group(&format!("clip-path=\"url(#{id})\"{}", spaced(attributes)));
    }

    /// Ends the last group begun.
    pub fn end_group(&mut self) {
        self.element("</g>");
    }

    /// A straight line; `style` holds the attributes for stroke and width.
    pub fn line(&mut self, from: (f64, f64), to: (f64, f64), style: &str) {
        let [x1, y1, x2, y2] = [from.0, from.1, to.0, to.1].map(coordinate);
        self.element(&format!(
            "<line x1=\"{x1}\" y1=\"{y1}\" x2=\"{x2}\" y2=\"{y2}\"{}/>",
            spaced(style)
        ));
    }

    /// A line through many points; closed and filled if `style` says so.
    pub fn polyline(&mut self, points: &[(f64, f64)], style: &str) {
        self.shape("polyline", points, style);
    }

    /// A closed shape.
    pub fn polygon(&mut self, points: &[(f64, f64)], style: &str) {
        self.shape("polygon", points, style);
    }

    fn shape(&mut self, name: &str, points: &[(f64, f64)], style: &str) {
        let mut list = String::new();
        for (k, (x, y)) in points.iter().enumerate() {
            let gap = if k > 0 { " " } else { "" };
            let _ = write!(list, "{gap}{},{}", coordinate(*x), coordinate(*y)); // into memory
        }
        self.element(&format!("<{name} points=\"{list}\"{}/>", spaced(style)));
    }

    /// A circle.
    pub fn circle(&mut self, centre: (f64, f64), radius: f64, style: &str) {
        let [x, y, r] = [centre.0, centre.1, radius].map(coordinate);
        self.element(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\"{}/>", spaced(style)));
    }

    /// A rectangle.
    pub fn rectangle(&mut self, area: Area, style: &str) {
        let [x, y, w, h] = [area.left, area.top, area.width, area.height].map(coordinate);
        self.element(&format!(
            "<rect x=\"{x}\" y=\"{y}\" width=\"{w}\" height=\"{h}\"{}/>",
            spaced(style)
        ));
    }

    /// A line of text at `point`, its baseline.
    pub fn text(&mut self, point: (f64, f64), anchor: Anchor, text: &str) {
        let [x, y] = [point.0, point.1].map(coordinate);
        let anchor = match anchor {
            Anchor::Start => "",
            Anchor::Middle => " text-anchor=\"middle\"",
            Anchor::End => " text-anchor=\"end\"",
        };
        self.element(&format!("<text x=\"{x}\" y=\"{y}\"{anchor}>{}</text>", escaped(text)));
    }

    /// A line of text that reads upward, its middle at `point`.
    pub fn text_upward(&mut self, point: (f64, f64), text: &str) {
        let [x, y] = [point.0, point.1].map(coordinate);
        self.element(&format!(
            "<text x=\"{x}\" y=\"{y}\" text-anchor=\"middle\" \
             transform=\"rotate(-90 {x} {y})\">{}</text>",
            escaped(text)
        ));
    }

    /// The whole file.
    pub fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

fn spaced(style: &str) -> String {
    if style.is_empty() { String::new() } else { format!(" {style}") }
}

/// A coordinate with at most two decimals. What is far outside any picture, or
/// no number, is put at its far edge, so that the file stays one that every reader takes.
///
/// ```
/// use parsim2d::figure::svg::coordinate;
/// assert_eq!([coordinate(12.0), coordinate(0.125), coordinate(-0.001)], ["12", "0.13", "0"]);
/// assert_eq!(coordinate(f64::INFINITY), "100000");
/// ```
pub fn coordinate(value: f64) -> String {
    let value = if value.is_nan() { 0.0 } else { value.clamp(-1e5, 1e5) };
    decimals(value, 2)
}

/// `text` with the characters that mean something in XML written as names, and without those that
/// XML does not allow.
///
/// ```
/// assert_eq!(parsim2d::figure::svg::escaped("a<b & \"c\"\u{1}"), "a&lt;b &amp; &quot;c&quot;\u{fffd}");
/// ```
pub fn escaped(text: &str) -> String {
    let mut out = String::new();
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c < ' ' || ['\u{fffe}', '\u{ffff}'].contains(&c) => out.push('\u{fffd}'),
            c => out.push(c),
        }
    }
    out
}

/// About how wide `text` is, pixels; letters of Helvetica are 0.5 to 0.6 of their height on average.
pub fn text_width(text: &str) -> f64 {
    let letter = |c: char| match c {
        'i' | 'l' | 'j' | '.' | ',' | ':' | ' ' | '|' | '\'' => 0.30,
        'm' | 'w' | 'M' | 'W' => 0.85,
        '⁰'..='₉' | '²' | '³' | '¹' => 0.36,
        'A'..='Z' => 0.68,
        _ => 0.56,
    };
    TEXT * text.chars().map(letter).sum::<f64>()
}
