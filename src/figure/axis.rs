//! One axis of a chart: its label, its range, where a value lies on it.

use super::{label, ticks};
use crate::number::{power_of_ten, typographic};

/// How values are spread over an axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// Equal steps, equal lengths.
    Linear,
    /// Equal factors, equal lengths; values at or below zero have no place.
    Log,
}

/// An axis as wished for.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What is along it, with its unit: `time, s`.
    pub label: String,
    /// How values are spread.
    pub spread: Spread,
    /// Where it begins; by the data if not said.
    pub low: Option<f64>,
    /// Where it ends; by the data if not said.
    pub high: Option<f64>,
    /// Room beyond the data at both ends, as a fraction of the axis.
    pub margin: f64,
}

impl Axis {
    /// A linear axis that fits its data tightly.
    pub fn linear(label: &str) -> Self {
        Self { label: label.to_owned(), spread: Spread::Linear, low: None, high: None, margin: 0.0 }
    }

    /// A logarithmic axis with a little room around its data.
    pub fn log(label: &str) -> Self {
        Self { spread: Spread::Log, margin: 0.04, ..Self::linear(label) }
    }

    /// The axis for `values`, which may hold some without a place on it.
    pub fn fit(&self, values: impl Iterator<Item = f64>) -> Placed {
        let is_log = self.spread == Spread::Log;
        // Beyond 1e300 the length of an axis would overflow.
        let on_axis = |v: &f64| v.abs() < 1e300 && (!is_log || *v > 0.0);
        let empty = (f64::INFINITY, f64::NEG_INFINITY);
        let (low, high) =
            values.filter(on_axis).fold(empty, |(low, high), v| (low.min(v), high.max(v)));
        let (low, high) = match (low <= high, is_log) {
            (true, _) => (low, high),
            (false, true) => (0.1, 1.0),
            (false, false) => (0.0, 1.0),
        };
        let (low, high) = (self.low.unwrap_or(low), self.high.unwrap_or(high));
        let (low, high) = widened(low, high.max(low), is_log);
        let (a, b) = if is_log { (low.log10(), high.log10()) } else { (low, high) };
        let room = self.margin * (b - a).min(1e300);
        let below = if self.low.is_none() { room } else { 0.0 };
        let above = if self.high.is_none() { room } else { 0.0 };
        Placed { is_log, low: a - below, high: b + above }
    }
}

/// A range of some width around what may be one value.
fn widened(low: f64, high: f64, is_log: bool) -> (f64, f64) {
    if is_log {
        let is_wide = high / low > 1.0 + 1e-9;
        return if is_wide { (low, high) } else { (low / 2.0, high * 2.0) };
    }
    let size = low.abs().max(high.abs());
    if high - low > 1e-12 * size {
        return (low, high);
    }
    if size == 0.0 { (-1.0, 1.0) } else { (low - 0.5 * size, high + 0.5 * size) }
}

/// An axis with its range.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    is_log: bool,
    low: f64,  // of the value, or of its power of ten
    high: f64, // likewise
}

impl Placed {
    /// Where `value` lies, 0 at the beginning and 1 at the end of the axis; outside these beyond
    /// its ends. Nothing for a value that has no place.
    ///
    /// ```
    /// use parsim2d::figure::axis::Axis;
    /// let axis = Axis { margin: 0.0, ..Axis::log("error") }.fit([1e-4, 1.0].into_iter());
    /// assert_eq!(axis.place(1e-3), Some(0.25));
    /// assert_eq!(axis.place(0.0), None);
    /// ```
    pub fn place(&self, value: f64) -> Option<f64> {
        let along = if self.is_log { value.log10() } else { value };
        let place = (along - self.low) / (self.high - self.low);
        (value.is_finite() && place.is_finite()).then_some(place)
    }

    /// Where the axis begins and ends.
    pub fn range(&self) -> (f64, f64) {
        if self.is_log {
            (10f64.powf(self.low.max(-307.0)), 10f64.powf(self.high.min(307.0)))
        } else {
            (self.low, self.high)
        }
    }

    /// About `wanted` marks with their texts, and the power of ten that the texts leave out.
    pub fn marks(&self, wanted: usize) -> (Vec<(f64, String)>, i32) {
        let (low, high) = self.range();
        if self.is_log {
            let marks = ticks::log(low, high, wanted);
            let text = |mark: f64| {
                let power = mark.log10();
                let is_whole = (power - power.round()).abs() < 1e-9;
                if is_whole { power_of_ten(power.round() as i32) } else { typographic(mark, 3) }
            };
            return (marks.into_iter().map(|mark| (mark, text(mark))).collect(), 0);
        }
        let marks = ticks::linear(low, high, wanted);
        let power = label::shared_power(low.abs().max(high.abs()));
        let texts = label::marks(&marks, power);
        (marks.into_iter().zip(texts).collect(), power)
    }

    /// The label with the power of ten that the marks leave out.
    pub fn titled(label: &str, power: i32) -> String {
        if power == 0 {
            return label.to_owned();
        }
        let factor = power_of_ten(power);
        match label.rsplit_once(", ") {
            Some((what, unit)) => format!("{what}, {factor} {unit}"),
            None => format!("{label}, {factor}"),
        }
    }
}
