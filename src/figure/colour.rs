//! Colours: eight that every kind of eye tells apart, and a scale from dark to light.

/// The colours of Okabe and Ito (2008), without yellow, which white paper swallows.
pub const OKABE_ITO: [&str; 7] =
    ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000"];

/// The scale from low to high: each step lighter than the last, none too light for white paper.
/// The first four fifths of "plasma" (van der Walt and Smith 2015).
pub const SCALE: [[u8; 3]; 4] =
    [[0x0d, 0x08, 0x87], [0x7e, 0x03, 0xa8], [0xcc, 0x47, 0x78], [0xf8, 0x95, 0x40]];

/// The colour at `fraction` of the scale, 0 to 1, as red, green, blue. What is no number has the
/// lowest.
///
/// ```
/// use parsim2d::figure::colour::at;
/// assert_eq!(at(0.0), [0x0d, 0x08, 0x87]);
/// assert_eq!(at(7.0), [0xf8, 0x95, 0x40]);
/// ```
pub fn at(fraction: f64) -> [u8; 3] {
    let place = fraction.clamp(0.0, 1.0) * 3.0;
    let k = (place as usize).min(2); // `as` sends what is no number to 0
    let share = if place.is_nan() { 0.0 } else { place - k as f64 };
    std::array::from_fn(|channel| {
        let (from, to) = (f64::from(SCALE[k][channel]), f64::from(SCALE[k + 1][channel]));
        (from + share * (to - from)).round() as u8
    })
}

/// A colour as SVG and gnuplot write it, `#rrggbb`.
pub fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}
