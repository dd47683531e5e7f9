//! Points that belong together, and how they are drawn.

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A line of this width, pixels, with this pattern of dashes (SVG's `stroke-dasharray`; empty
    /// for none).
    Line(f64, &'static str),
    /// Dots of this radius, pixels.
    Dots(f64),
    /// Dots of this radius on a thin line; hollow ones if said.
    LineAndDots {
        /// Radius of a dot, px.
        radius: f64, // px
        /// Whether the dots are rings.
        is_hollow: bool,
    },
    /// Bars from zero; each point is the upper right corner of one, its width in x the number.
    Bars(f64),
}

/// Points that belong together.
#[derive(Clone, Debug, PartialEq)]
pub struct Series {
    /// Its name in the legend; none if empty.
    pub name: String,
    /// Its colour, as SVG writes it.
    pub colour: String,
    /// How it is drawn.
    pub mark: Mark,
    /// Its points, in the units of the axes. Those without a place on them interrupt the line.
    pub points: Vec<(f64, f64)>,
}

impl Series {
    /// A series of these.
    pub fn new(name: &str, colour: &str, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        Self { name: name.to_owned(), colour: colour.to_owned(), mark, points }
    }
}
