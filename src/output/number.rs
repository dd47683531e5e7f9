//! Numbers as C's `%.9g` prints them: nine significant digits, always with a dot.

/// Significant digits: a position in the guide's box to 1e-11 m.
const DIGITS: usize = 9;

/// Appends `value` in at most nine significant digits, without trailing zeros; in exponent form
/// below 1e-4 and from 1e9 on.
///
/// ```
/// use parsim2d::output::number::push_g9;
/// let text = |value| {
///     let mut text = Vec::new();
///     push_g9(&mut text, value);
///     String::from_utf8(text).unwrap()
/// };
/// assert_eq!(text(0.0001), "0.0001");
/// assert_eq!(text(0.02 / 3.0), "0.00666666667");
/// assert_eq!(text(-1.5e-5), "-1.5e-05");
/// assert_eq!(text(1234567890.0), "1.23456789e+09");
/// ```
pub fn push_g9(out: &mut Vec<u8>, value: f64) {
    if !value.is_finite() {
        let name = if value.is_nan() { "nan" } else { "inf" };
        if value == f64::NEG_INFINITY {
            out.push(b'-');
        }
        return out.extend(name.as_bytes());
    }
    if value.is_sign_negative() {
        out.push(b'-');
    }
    if value == 0.0 {
        return out.push(b'0');
    }
    let (digits, exponent) = nine_digits(value.abs());
    let significant = digits.iter().rposition(|&digit| digit != b'0').unwrap_or(0) + 1;
    let digits = &digits[..significant];
    match exponent {
        0..9 => {
            let whole = exponent as usize + 1;
            out.extend(&digits[..whole.min(significant)]);
            out.extend((significant..whole).map(|_| b'0'));
            push_decimals(out, digits.get(whole..).unwrap_or_default());
        }
        -4..0 => {
            out.extend(b"0.");
            out.extend((exponent + 1..0).map(|_| b'0'));
            out.extend(digits);
        }
        _ => {
            out.push(digits[0]);
            push_decimals(out, &digits[1..]);
            let sign = if exponent < 0 { '-' } else { '+' };
            out.extend(format!("e{sign}{:02}", exponent.abs()).as_bytes());
        }
    }
}

fn push_decimals(out: &mut Vec<u8>, decimals: &[u8]) {
    if !decimals.is_empty() {
        out.push(b'.');
        out.extend(decimals);
    }
}

/// `value` > 0 as d.dddddddd times a power of ten, rounded to nine digits.
fn nine_digits(value: f64) -> ([u8; DIGITS], i32) {
    quick_digits(value).unwrap_or_else(|| exact_digits(value))
}

/// Scales by a power of ten and rounds to an integer. The scaling is off by less than 1e-6, so
/// where the fraction is that close to one half, or the size is unusual, there is no answer.
fn quick_digits(value: f64) -> Option<([u8; DIGITS], i32)> {
    const POWERS: [f64; 18] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
        1e17,
    ];
    if !(1e-9..1e9).contains(&value) {
        return None;
    }
    // The power that makes 1e8 <= scaled < 1e9: guess from the binary exponent, then correct.
    let binary_exponent = (value.to_bits() >> 52) as i32 - 1023;
    let mut exponent = (binary_exponent * 77 + if binary_exponent < 0 { -255 } else { 0 }) / 256;
    let scaled_by =
        |exponent: i32| Some(value * POWERS.get(8usize.checked_add_signed(-exponent as isize)?)?);
    let mut scaled = scaled_by(exponent)?;
    if scaled >= 999_999_999.5 - 1e-3 {
        exponent += 1;
        scaled = scaled_by(exponent)?;
    }
    let whole = scaled.round();
    if (scaled - scaled.floor() - 0.5).abs() < 1e-5 || !(1e8..999_999_999.5).contains(&whole) {
        return None;
    }
    let mut number = whole as u32;
    let mut digits = [b'0'; DIGITS];
    for digit in digits.iter_mut().rev() {
        *digit += (number % 10) as u8;
        number /= 10;
    }
    Some((digits, exponent))
}

/// The standard library's exact rounding, which is slower.
fn exact_digits(value: f64) -> ([u8; DIGITS], i32) {
    let text = format!("{value:.8e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mut digits = [b'0'; DIGITS];
    for (digit, byte) in digits.iter_mut().zip(mantissa.bytes().filter(|&byte| byte != b'.')) {
        *digit = byte;
    }
    (digits, exponent.parse().unwrap_or(0))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn quick_digits_are_the_exact_ones(mantissa in 1.0..10.0f64, exponent in -10..10i32) {
            let value = mantissa * 10f64.powi(exponent);
            if let Some(quick) = quick_digits(value) {
                prop_assert_eq!(quick, exact_digits(value));
            }
        }
    }

    #[test]
    fn quick_digits_answer_for_nearly_all_numbers_of_a_simulation() {
        let answered =
            (1..10_000).filter(|&k| quick_digits(0.04 * f64::from(k) / 10_007.0).is_some()).count();
        assert!(answered > 9_990, "{answered} of 9999");
    }
}
