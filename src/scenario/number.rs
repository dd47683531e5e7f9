//! Numbers in messages.

use std::fmt;

/// A number as a person writes it: plain in the middle of the range, with an exponent outside.
pub(super) struct Num(pub f64);

impl Num {
    /// `value` to three digits.
    pub fn rounded(value: f64) -> Self {
        Self(format!("{value:.2e}").parse().unwrap_or(value))
    }
}

impl fmt::Display for Num {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(value) = self;
        if *value == 0.0 || !value.is_finite() || (1e-3..1e4).contains(&value.abs()) {
            write!(f, "{value}")
        } else {
            write!(f, "{value:e}")
        }
    }
}

/// `value` and at least 3 % more, rounded up to two digits: a number to type.
pub(super) fn round_up(value: f64) -> f64 {
    let digit = 10f64.powi((1.03 * value).log10().floor() as i32 - 1);
    // A second rounding: 21 * 100 is exact, 0.21e-3 / 1e-4 is not.
    format!("{:.1e}", (1.03 * value / digit - 1e-9).ceil() * digit).parse().unwrap_or(value)
}
