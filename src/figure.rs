//! Pictures of what a run wrote: SVG and animated GIF, and gnuplot scripts that draw the same.
//!
//! A [`Figure`] is a grid of panels, each a [`chart::Chart`] (curves between axes) or a
//! [`scene::Scene`] (discs to scale in their box). One file a kind of picture builds them:
//! [`frame`], [`paths`], [`energy`], [`velocity`], [`forces`], [`speeds`], [`history`], [`drift`]; [`animation`]
//! makes the GIF. Numbers come in as values, never as file names, so that any command can draw.
//! The same numbers give the same bytes.

pub mod animation;
pub mod axis;
pub mod chart;
pub mod colour;
pub mod drift;
pub mod end_label;
pub mod energy;
pub mod forces;
pub mod frame;
mod glyphs;
pub mod gnuplot;
pub mod history;
pub mod label;
pub mod paths;
mod raster;
pub mod scene;
pub mod series;
pub mod speeds;
pub mod survey;
pub mod svg;
pub mod ticks;
pub mod velocity;

use self::chart::Chart;
use self::scene::{ColourBar, Scene};
use self::svg::{Area, Svg};

/// One part of a figure.
#[derive(Clone, Debug)]
pub enum Panel {
    /// Curves between axes.
    Chart(Chart),
    /// Discs to scale in their box.
    Scene(Scene),
}

/// A picture of one or more panels in a grid.
#[derive(Clone, Debug)]
pub struct Figure {
    /// Panels of one size, row by row.
    pub panels: Vec<Panel>,
    /// Panels side by side.
    pub columns: usize,
    /// Width and height of a panel, pixels.
    pub panel: (f64, f64),
    /// A scale of colours above all panels.
    pub strip: Option<ColourBar>,
}

impl Figure {
    /// A figure of one chart, 900 by 500 pixels.
    pub fn of_chart(chart: Chart) -> Self {
        Self { panels: vec![Panel::Chart(chart)], columns: 1, panel: (900.0, 500.0), strip: None }
    }

    /// A figure of one scene, 760 pixels wide; its box about 640.
    pub fn of_scene(scene: Scene) -> Self {
        let height = if scene.legend.is_empty() { 730.0 } else { 752.0 };
        Self { panels: vec![Panel::Scene(scene)], columns: 1, panel: (790.0, height), strip: None }
    }

    /// The figure as SVG, one element a line.
    ///
    /// ```
    /// use parsim2d::figure::Figure;
    /// use parsim2d::figure::axis::Axis;
    /// use parsim2d::figure::chart::Chart;
    /// let chart = Chart::new("fall & bounce", Axis::linear("time, s"), Axis::linear("height, m"));
    /// let text = Figure::of_chart(chart).to_svg();
    /// assert!(text.contains("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"900\""));
    /// assert!(text.contains("fall &amp; bounce"));
    /// ```
    pub fn to_svg(&self) -> String {
        let columns = self.columns.max(1);
        let rows = self.panels.len().div_ceil(columns);
        let (width, height) = self.panel;
        let top = if self.strip.is_some() { 40.0 } else { 0.0 };
        let whole = width * columns as f64;
        let mut svg = Svg::new(whole, top + height * rows as f64);
        if let Some(strip) = &self.strip {
            scene::draw_strip(&mut svg, strip, whole);
        }
        for (k, panel) in self.panels.iter().enumerate() {
            let (column, row) = ((k % columns) as f64, (k / columns) as f64);
            let area = Area { left: column * width, top: top + row * height, width, height };
            match panel {
                Panel::Chart(chart) => chart.draw(&mut svg, area),
                Panel::Scene(scene) => scene.draw(&mut svg, area),
            }
        }
        svg.finish()
    }
}
