//! Curves and points between two axes, with grid and legend.

use super::axis::{Axis, Placed};
use super::end_label;
pub use super::series::{Mark, Series};
use super::svg::{Anchor, Area, Svg, TEXT, coordinate, text_width};

/// A chart.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// Above it; none if empty.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What it shows, drawn in this order.
    pub series: Vec<Series>,
    /// Lines of the legend without a mark.
    pub remarks: Vec<String>,
    /// Whether curves have their names at their ends, and not in a legend.
    pub is_labelled: bool,
}

/// Room for the labels of the vertical axis, at least; the same in charts below one another.
const LEFT: f64 = 84.0; // px
const RIGHT: f64 = 24.0; // px
const BELOW: f64 = 54.0; // px
const LEGEND_ROW: f64 = 20.0; // px
const SAMPLE: f64 = 24.0; // px, of a line in the legend

impl Chart {
    /// An empty chart.
    pub fn new(title: &str, x: Axis, y: Axis) -> Self {
        let (title, series, remarks) = (title.to_owned(), Vec::new(), Vec::new());
        Self { title, x, y, series, remarks, is_labelled: false }
    }

    /// Draws the chart into `area`.
    pub fn draw(&self, svg: &mut Svg, area: Area) {
        let points = || self.series.iter().flat_map(|series| &series.points);
        let x = self.x.fit(points().map(|point| point.0));
        let y = self.y.fit(points().map(|point| point.1));
        let title = if self.title.is_empty() { 12.0 } else { 34.0 };
        let right = if self.is_labelled { end_label::room(&self.series) } else { RIGHT };
        let legend = self.legend_rows(area.width - LEFT - right);
        let head = title + LEGEND_ROW * legend.len() as f64;
        let height = (area.height - head - BELOW).max(20.0);
        let (y_marks, y_power) = y.marks((height / 45.0) as usize);
        let widest = y_marks.iter().map(|(_, text)| text_width(text)).fold(0.0, f64::max);
        let left = LEFT.max(widest + 40.0);
        let plot = Area {
            left: area.left + left,
            top: area.top + head,
            width: (area.width - left - right).max(20.0),
            height,
        };
        let (x_marks, x_power) = fitting_marks(&x, plot.width);
        if !self.title.is_empty() {
            let middle = plot.left + plot.width / 2.0;
            svg.text((middle, area.top + 24.0), Anchor::Middle, &self.title);
        }
        draw_legend(svg, &legend, (plot.left, area.top + title));
        let frame = Frame { plot, x, y };
        frame.draw_grid(svg, &x_marks, &y_marks);
        for series in &self.series {
            frame.draw_series(svg, series);
        }
        svg.rectangle(plot, "fill=\"none\" stroke=\"black\"");
        if self.is_labelled {
            end_label::draw(svg, plot, &frame.ends(&self.series));
        }
        let below = (plot.left + plot.width / 2.0, plot.bottom() + 42.0);
        svg.text(below, Anchor::Middle, &Placed::titled(&self.x.label, x_power));
        let beside = (plot.left - widest - 22.0, plot.top + plot.height / 2.0);
        svg.text_upward(beside, &Placed::titled(&self.y.label, y_power));
    }

    /// The entries of the legend, as many to a row as fit into `width`.
    fn legend_rows(&self, width: f64) -> Vec<Vec<Entry<'_>>> {
        let named = self.series.iter().filter(|one| !one.name.is_empty() && !self.is_labelled);
        let named = named.map(|series| (Some(series), series.name.as_str()));
        let remarks = self.remarks.iter().map(|text| (None, text.as_str()));
        let mut rows: Vec<Vec<Entry>> = Vec::new();
        let mut used = f64::INFINITY;
        for entry in named.chain(remarks) {
            let wide = entry_width(entry);
            if used + wide > width {
                rows.push(Vec::new());
                used = 0.0;
            }
            used += wide;
            if let Some(row) = rows.last_mut() {
                row.push(entry);
            }
        }
        rows
    }
}

/// A line of the legend: what it stands for, if anything, and its text.
type Entry<'a> = (Option<&'a Series>, &'a str);

fn entry_width((series, text): Entry) -> f64 {
    let sample = if series.is_some() { SAMPLE + 6.0 } else { 0.0 };
    sample + text_width(text) + 18.0
}

fn draw_legend(svg: &mut Svg, rows: &[Vec<Entry>], (left, top): (f64, f64)) {
    for (k, row) in rows.iter().enumerate() {
        let (mut x, y) = (left, top + LEGEND_ROW * (k as f64 + 0.5));
        for &(series, text) in row {
            let mut text_at = x;
            if let Some(series) = series {
                let wide = [(x, y), (x + SAMPLE, y)];
                let middle = [(x + SAMPLE / 2.0, y)];
                match series.mark {
                    Mark::Line(..) => draw_line(svg, series, &wide),
                    Mark::Dots(radius) => draw_dots(svg, series, radius.max(3.0), false, &middle),
                    Mark::LineAndDots { radius, is_hollow } => {
                        draw_line(svg, series, &wide);
                        draw_dots(svg, series, radius, is_hollow, &middle);
                    }
                    Mark::Bars(_) => {
                        let bar = Area { left: x + 6.0, top: y - 5.0, width: 12.0, height: 10.0 };
                        svg.rectangle(bar, &format!("fill=\"{}\"", series.colour));
                    }
                }
                text_at += SAMPLE + 6.0;
            }
            svg.text((text_at, y + 0.35 * TEXT), Anchor::Start, text);
            x += entry_width((series, text));
        }
    }
}

/// Marks whose texts do not run into each other.
fn fitting_marks(axis: &Placed, width: f64) -> (Vec<(f64, String)>, i32) {
    let mut wanted = (width / 80.0).max(2.0) as usize;
    loop {
        let (marks, power) = axis.marks(wanted);
        let widest = marks.iter().map(|(_, text)| text_width(text)).fold(0.0, f64::max);
        if wanted <= 1 || (widest + 12.0) * marks.len() as f64 <= width {
            return (marks, power);
        }
        wanted -= 1;
    }
}

/// Where the curves are drawn, and where values lie there.
struct Frame {
    plot: Area,
    x: Placed,
    y: Placed,
}

impl Frame {
    fn horizontal(&self, value: f64) -> Option<f64> {
        self.x.place(value).map(|place| self.plot.left + place * self.plot.width)
    }

    fn vertical(&self, value: f64) -> Option<f64> {
        self.y.place(value).map(|place| self.plot.bottom() - place * self.plot.height)
    }

    fn draw_grid(&self, svg: &mut Svg, x: &[(f64, String)], y: &[(f64, String)]) {
        let (plot, grid) = (self.plot, "stroke=\"#d9d9d9\"");
        for (mark, text) in x {
            if let Some(at) = self.horizontal(*mark) {
                svg.line((at, plot.top), (at, plot.bottom()), grid);
                svg.text((at, plot.bottom() + 20.0), Anchor::Middle, text);
            }
        }
        for (mark, text) in y {
            if let Some(at) = self.vertical(*mark) {
                svg.line((plot.left, at), (plot.right(), at), grid);
                svg.text((plot.left - 8.0, at + 0.35 * TEXT), Anchor::End, text);
            }
        }
    }

    fn draw_series(&self, svg: &mut Svg, series: &Series) {
        svg.begin_clipped(self.plot, "");
        if let Mark::Bars(width) = series.mark {
            self.draw_bars(svg, series, width);
        }
        for run in self.runs(series) {
            match series.mark {
                Mark::Line(..) => draw_line(svg, series, &run),
                Mark::Dots(radius) => draw_dots(svg, series, radius, false, &run),
                Mark::LineAndDots { radius, is_hollow } => {
                    draw_line(svg, series, &run);
                    draw_dots(svg, series, radius, is_hollow, &run);
                }
                Mark::Bars(_) => {}
            }
        }
        svg.end_group();
    }

    /// The named series with the last point of each that has a place, px.
    fn ends<'a>(&self, series: &'a [Series]) -> Vec<(&'a Series, (f64, f64))> {
        let end = |one: &'a Series| {
            let last = self.runs(one).pop()?.pop()?;
            (!one.name.is_empty()).then_some((one, last))
        };
        series.iter().filter_map(end).collect()
    }

    /// The series in pixels, cut where a point has no place.
    fn runs(&self, series: &Series) -> Vec<Vec<(f64, f64)>> {
        let mut runs = vec![Vec::new()];
        for &(x, y) in &series.points {
            match (self.horizontal(x).zip(self.vertical(y)), runs.last_mut()) {
                (Some(point), Some(run)) => run.push(point),
                (None, Some(run)) if !run.is_empty() => runs.push(Vec::new()),
                _ => {}
            }
        }
        runs.retain(|run| !run.is_empty());
        runs.iter().map(|run| thinned(run)).collect()
    }

    fn draw_bars(&self, svg: &mut Svg, series: &Series, width: f64) {
        let zero = self.vertical(0.0).unwrap_or(self.plot.bottom());
        for &(right, top) in series.points.iter().filter(|point| point.1 > 0.0) {
            let corners = (self.horizontal(right - width), self.horizontal(right));
            if let ((Some(left), Some(right)), Some(top)) = (corners, self.vertical(top)) {
                let bar = Area { left, top, width: right - left, height: zero - top };
                let style = format!("fill=\"{}\" stroke=\"white\"", series.colour);
                svg.rectangle(bar, &style);
            }
        }
    }
}

/// More points than pixels make a large file and no better picture: of those in one half pixel
/// column the first, lowest, highest and last are left.
fn thinned(run: &[(f64, f64)]) -> Vec<(f64, f64)> {
    if run.len() < 4000 {
        return run.to_vec();
    }
    let column = |point: &(f64, f64)| (point.0 * 2.0).floor();
    let mut left = Vec::new();
    for same in run.chunk_by(|a, b| column(a) == column(b)) {
        let last = same.len() - 1;
        let by_height = |a: &usize, b: &usize| same[*a].1.total_cmp(&same[*b].1);
        let low = (0..=last).min_by(by_height).unwrap_or(0);
        let high = (0..=last).max_by(by_height).unwrap_or(0);
        let mut kept = [0, low.min(high), low.max(high), last].to_vec();
        kept.dedup();
        left.extend(kept.into_iter().map(|k| same[k]));
    }
    left
}

fn draw_line(svg: &mut Svg, series: &Series, run: &[(f64, f64)]) {
    let (width, dash) = match series.mark {
        Mark::Line(width, dash) => (width, dash),
        _ => (1.5, ""),
    };
    let dash =
        if dash.is_empty() { String::new() } else { format!(" stroke-dasharray=\"{dash}\"") };
    let style = format!(
        "fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" stroke-linejoin=\"round\"{dash}",
        series.colour,
        coordinate(width)
    );
    svg.polyline(run, &style);
}

fn draw_dots(svg: &mut Svg, series: &Series, radius: f64, is_hollow: bool, run: &[(f64, f64)]) {
    let fill = if is_hollow { "white" } else { &series.colour };
    svg.begin_group(&format!("fill=\"{fill}\" stroke=\"{}\"", series.colour));
    for point in run {
        svg.circle(*point, radius, "");
    }
    svg.end_group();
}
