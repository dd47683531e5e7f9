//! Numbers for people.

/// Points, two decimals at most.
///
/// ```
/// use parsim2d::grading::feedback::number::points;
/// assert_eq!([points(2.0), points(0.5), points(-1e-17)], ["2", "0.5", "0"]);
/// ```
pub fn points(value: f64) -> String {
    let rounded = (100.0 * value).round() / 100.0 + 0.0; // + 0.0 takes the sign off zero
    format!("{rounded}")
}

/// Per cent with a decimal, cut: only everything is 100.
///
/// ```
/// use parsim2d::grading::feedback::number::percent;
/// assert_eq!([percent(99.97), percent(100.0), percent(200.0 / 3.0)], ["99.9", "100", "66.6"]);
/// ```
pub fn percent(value: f64) -> String {
    // Sums of thirds and tenths miss by some units of the last place.
    let cut = (10.0 * value + 1e-9).floor() / 10.0;
    format!("{cut}")
}

/// A measured number: four digits are enough to read.
pub fn short(value: f64) -> String {
    match value.abs() {
        size if size == 0.0 || (1e-3..1e5).contains(&size) => {
            format!("{value:.4}").trim_end_matches('0').trim_end_matches('.').to_owned()
        }
        _ => format!("{value:.3e}"),
    }
}
