//! Numbers of data files, as C's `%.9g` prints them: nine significant digits, always with a dot.

/// Significant digits: a position in the guide's box to 1e-11 m.
const DIGITS: usize = 9;

/// More bytes than a number takes: sign, nine digits, a dot, and `e-324` or `0.000` at most.
const LONGEST: usize = 24;

/// The text `00000000` as one word.
const ZEROS: u64 = u64::from_le_bytes([b'0'; 8]);

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
    // Room for the longest, and then less: a fixed length is faster than the one that is needed.
    let begin = out.len();
    out.extend_from_slice(&[b'0'; LONGEST]);
    let length = lay_out(&mut out[begin..], nine_digits(value.abs()));
    out.truncate(begin + length);
}

/// Nine decimal digits, as text, and the power of ten of the first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Decimal {
    first: u8,
    after: [u8; DIGITS - 1],
    exponent: i32,
}

impl Decimal {
    /// How many digits are left without the zeros at the end, one at least.
    fn significant(&self) -> usize {
        // Differences from '0'; the last digit is the highest byte.
        let after = u64::from_le_bytes(self.after) ^ ZEROS;
        DIGITS - after.leading_zeros() as usize / 8
    }
}

/// Writes `number` into `text`, which is all zeros; returns its length.
fn lay_out(text: &mut [u8], number: Decimal) -> usize {
    let Decimal { first, after, exponent } = number;
    let significant = number.significant();
    match exponent {
        -4..0 => {
            let at = (1 - exponent) as usize; // after 0. and zeros
            text[1] = b'.';
            text[at] = first;
            text[at + 1..at + DIGITS].copy_from_slice(&after);
            at + significant
        }
        0..9 => {
            let whole = exponent as usize; // digits before the point, but for the first
            text[0] = first;
            text[1..DIGITS].copy_from_slice(&after);
            if significant <= whole + 1 {
                return whole + 1;
            }
            text[whole + 1] = b'.';
            text[whole + 2..=DIGITS].copy_from_slice(&after[whole..]);
            significant + 1
        }
        _ => {
            text[0] = first;
            text[1] = b'.';
            text[2..=DIGITS].copy_from_slice(&after);
            let at = if significant > 1 { significant + 1 } else { 1 };
            at + put_exponent(&mut text[at..], exponent)
        }
    }
}

/// Writes `e-05` and the like; returns its length.
fn put_exponent(text: &mut [u8], exponent: i32) -> usize {
    let size = exponent.unsigned_abs();
    text[0] = b'e';
    text[1] = if exponent < 0 { b'-' } else { b'+' };
    let digit = |power: u32| b'0' + (size / power % 10) as u8;
    if size < 100 {
        text[2] = digit(10);
        text[3] = digit(1);
        return 4;
    }
    text[2] = digit(100);
    text[3] = digit(10);
    text[4] = digit(1);
    5
}

/// `value` > 0, rounded to nine digits.
fn nine_digits(value: f64) -> Decimal {
    quick_digits(value).unwrap_or_else(|| exact_digits(value))
}

/// Scales by a power of ten and rounds to an integer. The scaling is off by less than 1e-6, so
/// where the fraction is that close to one half, or the size is unusual, there is no answer.
fn quick_digits(value: f64) -> Option<Decimal> {
    // As small as the velocities of discs that have come to rest.
    if !(1e-35..1e9).contains(&value) {
        return None;
    }
    // The power that makes 1e8 <= scaled < 1e9: guess from the binary exponent, then correct.
    let binary_exponent = (value.to_bits() >> 52) as i32 - 1023;
    let guess = (binary_exponent * 1233) >> 12; // times log10(2), rounded down
    let exponent = guess + i32::from(scale(value, 8 - guess) >= 1e9);
    let scaled = scale(value, 8 - exponent);
    // Numbers from 2^52 on are whole: adding it rounds, and leaves the whole number in the low bits.
    const WHOLE: f64 = (1_u64 << 52) as f64;
    let rounded = scaled + WHOLE;
    let number = rounded.to_bits() as u32;
    let rest = scaled - (rounded - WHOLE);
    if rest.abs() > 0.5 - 1e-5 || !(100_000_000..1_000_000_000).contains(&number) {
        return None;
    }
    let first = b'0' + (number / 100_000_000) as u8;
    Some(Decimal { first, after: eight_digits(number % 100_000_000), exponent })
}

/// `value` times ten to the `power` (0 to 44), rounded twice at most: powers up to 1e22 are exact.
fn scale(value: f64, power: i32) -> f64 {
    const POWERS: [f64; 23] = [
        1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
        1e17, 1e18, 1e19, 1e20, 1e21, 1e22,
    ];
    let power = power as usize;
    if power <= 22 { value * POWERS[power] } else { value * 1e22 * POWERS[(power - 22).min(22)] }
}

/// The digits of a `number` below 1e8, as text: halved into two fours, four twos and eight digits, all
/// parts of one word at once. Each division is a multiplication and a shift, exact for so small numbers.
fn eight_digits(number: u32) -> [u8; 8] {
    let number = u64::from(number);
    // The high part goes to the low end: it is what comes first in memory.
    let fours = (number / 10_000) | ((number % 10_000) << 32);
    let hundreds = ((fours * 5243) >> 19) & 0x0000_007f_0000_007f;
    let twos = hundreds | ((fours - hundreds * 100) << 16);
    let tens = ((twos * 103) >> 10) & 0x000f_000f_000f_000f;
    let ones = tens | ((twos - tens * 10) << 8);
    (ones | ZEROS).to_le_bytes()
}

/// The standard library's exact rounding, which is slower.
fn exact_digits(value: f64) -> Decimal {
    let text = format!("{value:.8e}");
    let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
    let mut digits = mantissa.bytes().filter(|&byte| byte != b'.');
    let mut next = || digits.next().unwrap_or(b'0');
    let first = next();
    let after = std::array::from_fn(|_| next());
    Decimal { first, after, exponent: exponent.parse().unwrap_or(0) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

        #[test]
        fn quick_digits_are_the_exact_ones(mantissa in 1.0..10.0f64, exponent in -40..10i32) {
            let value = mantissa * 10f64.powi(exponent);
            if let Some(quick) = quick_digits(value) {
                prop_assert_eq!(quick, exact_digits(value));
            }
        }
    }

    #[test]
    fn numbers_just_below_a_power_of_ten_are_rounded_like_all_others() {
        for exponent in -40..12 {
            let power = 10f64.powi(exponent);
            for below in [0.0, 1e-16, 1e-12, 4.99e-10, 4.999_999e-10, 5.000_001e-10, 5.01e-10, 1e-9]
            {
                let value = power * (1.0 - below);
                assert_eq!(nine_digits(value), exact_digits(value), "{value:e}");
            }
        }
    }

    #[test]
    fn quick_digits_answer_for_nearly_all_numbers_of_a_simulation() {
        // Metres in the guide's box, and the velocities of discs that have nearly come to rest.
        for largest in [0.04, 1e-5, 1e-12, 1e-20] {
            let number = |k: u32| largest * f64::from(k) / 10_007.0;
            let answered = (1..10_000).filter(|&k| quick_digits(number(k)).is_some()).count();
            assert!(answered > 9_990, "{answered} of 9999 up to {largest}");
        }
    }
}
