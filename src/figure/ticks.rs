//! Where the marks of an axis stand: round numbers, about as many as asked for.

/// The marks of a linear axis from `low` to `high`: multiples of 1, 2 or 5 times a power of ten,
/// all within the range, about `wanted` of them, never more than three times as many.
///
/// A range so narrow that neighbouring numbers run out has its ends for marks; one that is not
/// finite has none.
///
/// ```
/// use parsim2d::figure::ticks::linear;
/// assert_eq!(linear(0.0, 0.04, 5), [0.0, 0.01, 0.02, 0.03, 0.04]);
/// assert_eq!(linear(-1.3, 1.3, 3), [-1.0, 0.0, 1.0]);
/// ```
pub fn linear(low: f64, high: f64, wanted: usize) -> Vec<f64> {
    if !low.is_finite() || !high.is_finite() {
        return Vec::new();
    }
    let (low, high) = (low.min(high), low.max(high));
    let wanted = wanted.max(1) as f64;
    let rough = high / wanted - low / wanted; // not the difference, which may overflow
    let largest = low.abs().max(high.abs());
    // Below 1e-12 of the numbers themselves their last digits show in the marks.
    if rough <= 1e-12 * largest || rough < f64::MIN_POSITIVE * 1e3 {
        return if low < high { vec![low, high] } else { vec![low] };
    }
    let (digit, power) = step(rough);
    let at = |k: f64| times_power_of_ten(k * digit, power);
    // Rounding may put a multiple a hair outside.
    let first = (low / at(1.0)).ceil() - 1.0;
    let count = (wanted * 3.0) as usize + 3;
    let marks = (0..count).map(|k| at(first + k as f64));
    let slack = 1e-9 * rough;
    marks
        .filter(|mark| *mark >= low - slack && *mark <= high + slack)
        .map(|mark| mark.clamp(low, high) + 0.0) // not -0
        .collect()
}

/// The nearest of 1, 2, 5 times a power of ten to `rough` (on a logarithmic scale): digit, power.
pub(super) fn step(rough: f64) -> (f64, i32) {
    let power = rough.log10().floor();
    let leading = rough / 10f64.powf(power);
    let digit = match leading {
        l if l < 1.5 => 1.0,
        l if l < 3.2 => 2.0,
        l if l < 7.1 => 5.0,
        _ => 10.0,
    };
    (digit, power as i32)
}

/// `value` times ten to the `power`; by division where that is exact (3/10, not 3 * 0.1).
fn times_power_of_ten(value: f64, power: i32) -> f64 {
    if (-300..0).contains(&power) {
        value / 10f64.powi(-power)
    } else {
        value * 10f64.powf(f64::from(power))
    }
}

/// The marks of a logarithmic axis from `low` to `high`, both above zero: whole powers of ten, or
/// every second, third, fifth ... of them, at most `wanted`, but two at least. Where fewer than two powers of ten
/// lie in the range, 2 and 5 times them too, or round numbers if even these are too few.
///
/// ```
/// use parsim2d::figure::ticks::log;
/// assert_eq!(log(1e-3, 10.0, 10), [1e-3, 1e-2, 0.1, 1.0, 10.0]);
/// assert_eq!(log(0.15, 6.0, 10), [0.2, 0.5, 1.0, 2.0, 5.0]);
/// assert_eq!(log(1e-17, 1e-3, 2), [1e-15, 1e-10, 1e-5]);
/// ```
pub fn log(low: f64, high: f64, wanted: usize) -> Vec<f64> {
    if !(low > 0.0 && low.is_finite() && high >= low && high.is_finite()) {
        return Vec::new();
    }
    let (first, last) = ((low.log10() - 1e-9).ceil() as i32, (high.log10() + 1e-9).floor() as i32);
    let within = |mark: &f64| *mark >= low * (1.0 - 1e-9) && *mark <= high * (1.0 + 1e-9);
    if last > first {
        let stride = decade_stride((last - first) as usize, wanted);
        let marks = |stride: i32| -> Vec<f64> {
            let powers = (first..=last).filter(|power| power.rem_euclid(stride) == 0);
            powers.map(|power| times_power_of_ten(1.0, power)).collect()
        };
        // One mark alone has no scale.
        let finer = [200, 100, 50, 20, 10, 5, 3, 2, 1].into_iter().filter(|finer| *finer < stride);
        let mut all = std::iter::once(stride).chain(finer).map(marks);
        return all.find(|marks| marks.len() > 1).unwrap_or_default();
    }
    let digits = (first - 1..=last + 1).flat_map(|power| {
        [1.0, 2.0, 5.0].into_iter().map(move |digit| times_power_of_ten(digit, power))
    });
    let marks: Vec<f64> = digits.filter(within).collect();
    if marks.len() >= 2 { marks } else { linear(low, high, wanted.min(5)) }
}

/// Every how many decades a mark stands.
fn decade_stride(decades: usize, wanted: usize) -> i32 {
    let strides = [1, 2, 3, 5, 10, 20, 50, 100, 200, 500];
    let fits = |stride: &usize| decades / stride < wanted.max(2);
    strides.into_iter().find(fits).unwrap_or(500) as i32
}
