//! Numbers for people: as they read them in messages, tables and pictures, and as they type them. What programs read
//! is written by [`crate::output::number`].
//!
//! One style everywhere: plain from 0.01 to 100,000, except where an exponent is shorter (5e4); with an exponent
//! outside.

/// `value` in as many digits as it takes.
///
/// ```
/// use parsim2d::number::shortest;
/// assert_eq!([0.0015, 50.0, 12345.0, 5e4].map(shortest), ["1.5e-3", "50", "12345", "5e4"]);
/// assert_eq!([5e-4, 1.5e5, -0.0, f64::INFINITY].map(shortest), ["5e-4", "1.5e5", "0", "inf"]);
/// ```
pub fn shortest(value: f64) -> String {
    let (plain, power) = (format!("{}", value + 0.0), format!("{value:e}")); // + 0.0 takes the sign off zero
    match value.abs() {
        1e4..1e5 if power.len() < plain.len() => power,
        size if size == 0.0 || !size.is_finite() || (1e-2..1e5).contains(&size) => plain,
        _ => power,
    }
}

/// `value` in `digits` significant digits, zeros at the end among them, so that columns look alike. Digits before the
/// point are all shown.
///
/// ```
/// use parsim2d::number::significant;
/// assert_eq!([0.5, 12.3456, 12345.6].map(|v| significant(v, 4)), ["0.5000", "12.35", "12346"]);
/// assert_eq!([9.99996, 1.5e-6, 0.0].map(|v| significant(v, 4)), ["10.00", "1.500e-6", "0"]);
/// ```
pub fn significant(value: f64, digits: usize) -> String {
    let text = format!("{value:.*e}", digits.saturating_sub(1));
    let power = text.split_once('e').and_then(|(_, power)| power.parse::<i32>().ok());
    match power {
        Some(power @ -2..5) if value != 0.0 => {
            let decimals = (digits as i32 - 1 - power).max(0) as usize;
            format!("{value:.decimals$}")
        }
        Some(_) if value != 0.0 => text,
        _ => shortest(value),
    }
}

/// `value` in `digits` significant digits or fewer, if zeros are at the end.
///
/// ```
/// use parsim2d::number::at_most;
/// assert_eq!([0.5, 12.3456, 12345.6, 1.5e-6].map(|v| at_most(v, 4)), ["0.5", "12.35", "12346", "1.5e-6"]);
/// ```
pub fn at_most(value: f64, digits: usize) -> String {
    shortest(significant(value, digits).parse().unwrap_or(value))
}

/// [`significant`], a plus before what is above zero.
///
/// ```
/// use parsim2d::number::signed;
/// assert_eq!([0.02476, -9.6e-7, 0.0].map(|v| signed(v, 3)), ["+0.0248", "-9.60e-7", "0"]);
/// ```
pub fn signed(value: f64, digits: usize) -> String {
    format!("{}{}", if value > 0.0 { "+" } else { "" }, significant(value, digits))
}

/// A `share` in per cent, three digits.
///
/// ```
/// use parsim2d::number::percent;
/// assert_eq!([0.0321, -1.5e-4, 0.0].map(percent), ["3.21 %", "-0.0150 %", "0 %"]);
/// ```
pub fn percent(share: f64) -> String {
    format!("{} %", significant(100.0 * share, 3))
}

/// [`at_most`] for print: a power of ten in place of an exponent.
///
/// ```
/// use parsim2d::number::typographic;
/// assert_eq!([0.030_04, 1.5e-7, 1e6].map(|v| typographic(v, 3)), ["0.03", "1.5×10⁻⁷", "10⁶"]);
/// ```
pub fn typographic(value: f64, digits: usize) -> String {
    let text = at_most(value, digits);
    let parts =
        text.split_once('e').and_then(|(mantissa, power)| Some((mantissa, power.parse().ok()?)));
    match parts {
        Some(("1", power)) => power_of_ten(power),
        Some((mantissa, power)) => format!("{mantissa}×{}", power_of_ten(power)),
        None => text,
    }
}

/// `10` with `power` raised, in letters that need no markup.
///
/// ```
/// assert_eq!(parsim2d::number::power_of_ten(-18), "10⁻¹⁸");
/// ```
pub fn power_of_ten(power: i32) -> String {
    let raised = |c| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' | '4'..='9' => char::from_u32('⁰' as u32 + (c as u32 - '0' as u32)).unwrap_or(c),
        other => other,
    };
    format!("10{}", power.to_string().chars().map(raised).collect::<String>())
}

/// `value` with at most so many decimals and no exponent: points, pixels.
///
/// ```
/// use parsim2d::number::decimals;
/// assert_eq!([2.0, 0.125, -1e-17].map(|v| decimals(v, 2)), ["2", "0.13", "0"]);
/// ```
pub fn decimals(value: f64, most: i32) -> String {
    let unit = 10f64.powi(most);
    format!("{}", (unit * value).round() / unit + 0.0)
}

/// `value` with a decimal, cut: of per cent, only everything is 100.
///
/// ```
/// use parsim2d::number::cut;
/// assert_eq!([99.97, 100.0, 200.0 / 3.0].map(cut), ["99.9", "100", "66.6"]);
/// ```
pub fn cut(value: f64) -> String {
    // Sums of thirds and tenths miss by some units of the last place.
    format!("{}", (10.0 * value + 1e-9).floor() / 10.0)
}

/// A time, s: with so many decimals, or, where these would show fewer than three digits of it, with an exponent.
///
/// ```
/// use parsim2d::number::seconds;
/// assert_eq!([1.0000038, 0.009996, 2.5e-7].map(|t| seconds(t, 6)), ["1.000004", "0.009996", "2.50000e-7"]);
/// assert_eq!(seconds(0.0, 4), "0.0000");
/// ```
pub fn seconds(time: f64, decimals: usize) -> String {
    let shows = time == 0.0 || time.abs() >= 10f64.powi(2 - decimals as i32);
    if shows { format!("{time:.decimals$}") } else { format!("{time:.*e}", decimals - 1) }
}

/// A time step, s.
///
/// ```
/// assert_eq!(parsim2d::number::time_step(8.885766e-6), "8.8858e-6 s");
/// ```
pub fn time_step(dt: f64) -> String {
    format!("{} s", at_most(dt, 5))
}

/// An energy, J.
///
/// ```
/// assert_eq!(parsim2d::number::energy(3.873852e-3), "3.87385e-3 J");
/// ```
pub fn energy(joules: f64) -> String {
    format!("{} J", significant(joules, 6))
}

/// So many of what `one` is the name of.
///
/// ```
/// use parsim2d::number::counted;
/// assert_eq!([counted(1, "disc"), counted(20, "disc")], ["1 disc", "20 discs"]);
/// ```
pub fn counted(n: usize, one: &str) -> String {
    format!("{n} {one}{}", if n == 1 { "" } else { "s" })
}

/// So many bytes: 1 MB is a million of them.
///
/// ```
/// use parsim2d::number::bytes;
/// assert_eq!([9999, 272_000_000, 26_012_000_000].map(bytes), ["9999 bytes", "272 MB", "26.0 GB"]);
/// ```
pub fn bytes(bytes: u64) -> String {
    match (bytes, bytes as f64) {
        (0..10_000, _) => format!("{bytes} bytes"),
        (10_000..10_000_000, bytes) => format!("{:.0} kB", bytes / 1e3),
        (10_000_000..1_000_000_000, bytes) => format!("{:.0} MB", bytes / 1e6),
        (_, bytes) => format!("{:.1} GB", bytes / 1e9),
    }
}

/// The number nearest to `value` that has so many significant digits: to type, or to store.
///
/// ```
/// assert_eq!(parsim2d::number::rounded(2.0 / 3.0, 3), 0.667);
/// ```
pub fn rounded(value: f64, digits: usize) -> f64 {
    format!("{value:.*e}", digits.saturating_sub(1)).parse().unwrap_or(value)
}

/// The next number from `value` > 0 upwards that has so many significant digits; what is no such number stays.
///
/// ```
/// use parsim2d::number::rounded_up;
/// assert_eq!([rounded_up(2.01e-3, 1), rounded_up(2.01e-3, 2), rounded_up(2e-3, 2)], [3e-3, 2.1e-3, 2e-3]);
/// assert_eq!([f64::INFINITY, 0.0].map(|v| rounded_up(v, 1)), [f64::INFINITY, 0.0]);
/// ```
pub fn rounded_up(value: f64, digits: usize) -> f64 {
    in_last_places(value, digits, |places| (places - 1e-9).ceil())
}

/// The next number from `value` > 0 downwards that has so many significant digits; what is no such number stays.
///
/// ```
/// assert_eq!(parsim2d::number::rounded_down(3e-3 - 1e-7, 1), 2e-3);
/// ```
pub fn rounded_down(value: f64, digits: usize) -> f64 {
    in_last_places(value, digits, |places| (places + 1e-9).floor())
}

/// `value` with how often it holds the unit of its last digit made whole.
fn in_last_places(value: f64, digits: usize, whole: impl Fn(f64) -> f64) -> f64 {
    let unit = 10f64.powi((value.log10().floor() as i32).saturating_add(1 - digits as i32));
    if !(value > 0.0 && value.is_finite() && unit > 0.0) {
        return value;
    }
    // A second rounding: 21 * 100 is exact, 0.21e-3 / 1e-4 is not.
    rounded(whole(value / unit) * unit, digits)
}

/// At least 3 % more than `value`, in two digits: a limit, and some room.
///
/// ```
/// assert_eq!(parsim2d::number::safely_above(2.0), 2.1);
/// ```
pub fn safely_above(value: f64) -> f64 {
    rounded_up(1.03 * value, 2)
}
