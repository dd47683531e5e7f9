//! Marks of an axis, and prefixes of units.

use crate::number::power_of_ten;
/// The power of ten that the marks of a linear axis share: 0 while they read well without one,
/// else a multiple of three.
pub fn shared_power(largest: f64) -> i32 {
    if largest == 0.0 || !largest.is_finite() || (1e-3..1e5).contains(&largest) {
        return 0;
    }
    3 * (largest.log10() / 3.0).floor() as i32
}

/// `marks` as text, in units of ten to the `power`, with the decimals that tell them apart.
pub fn marks(marks: &[f64], power: i32) -> Vec<String> {
    let scaled = |mark: f64| mark / 10f64.powi(power);
    let step = marks.windows(2).map(|two| scaled(two[1] - two[0])).fold(f64::INFINITY, f64::min);
    let decimals = if step.is_finite() && step > 0.0 {
        (-step.log10() - 1e-9).ceil().clamp(0.0, 12.0) as usize
    } else {
        3
    };
    marks.iter().map(|mark| format!("{:.decimals$}", scaled(*mark) + 0.0)).collect()
}

/// Prefix of the unit in which `largest` reads between 1 and 1000, and its power of ten; a bare
/// power of ten outside the prefixes.
///
/// ```
/// use parsim2d::figure::label::prefix;
/// assert_eq!(prefix(3.8e-3), ("m".to_owned(), -3)); // 3.8 mJ
/// assert_eq!(prefix(2e200), ("10¹⁹⁸ ".to_owned(), 198));
/// ```
pub fn prefix(largest: f64) -> (String, i32) {
    if largest == 0.0 || !largest.is_finite() {
        return (String::new(), 0);
    }
    let power = 3 * (largest.abs().log10() / 3.0 + 1e-12).floor() as i32;
    let name = match power {
        -12 => "p",
        -9 => "n",
        -6 => "µ",
        -3 => "m",
        0 => "",
        3 => "k",
        6 => "M",
        9 => "G",
        12 => "T",
        other => return (format!("{} ", power_of_ten(other)), other),
    };
    (name.to_owned(), power)
}
