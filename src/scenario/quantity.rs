//! Numbers with an optional unit, on the command line and in scenario files: `0.04`, `4cm`.

use std::fmt;
use std::marker::PhantomData;
use std::str::FromStr;

use serde::Deserialize;
use serde::de::{Deserializer, Error, Visitor};

use crate::echo;

/// A kind of quantity: its SI unit and the suffixes it understands, each with its size in SI.
pub trait Dimension {
    /// Suffixes, SI unit first.
    const SUFFIXES: &'static [(&'static str, f64)];
}

/// Declares dimensions in one table.
macro_rules! dimensions {
    ($($(#[$doc:meta])* $name:ident: $($suffix:literal = $size:literal),+;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name;
        impl Dimension for $name {
            const SUFFIXES: &'static [(&'static str, f64)] = &[$(($suffix, $size)),+];
        }
    )+
        /// The suffixes of all dimensions.
        const UNITS: &[&[(&str, f64)]] = &[$($name::SUFFIXES),+];
    };
}

dimensions! {
    /// A length.
    Length: "m" = 1.0, "cm" = 1e-2, "mm" = 1e-3, "um" = 1e-6, "µm" = 1e-6, "nm" = 1e-9;
    /// A mass.
    Mass: "kg" = 1.0, "g" = 1e-3, "mg" = 1e-6;
    /// A time.
    Time: "s" = 1.0, "ms" = 1e-3, "us" = 1e-6, "ns" = 1e-9, "min" = 60.0, "h" = 3600.0;
    /// A speed.
    Speed: "m/s" = 1.0, "cm/s" = 1e-2, "mm/s" = 1e-3;
    /// An acceleration.
    Acceleration: "m/s2" = 1.0, "m/s^2" = 1.0, "cm/s2" = 1e-2;
    /// A stiffness.
    Stiffness: "N/m" = 1.0, "kN/m" = 1e3;
    /// A damping coefficient.
    Coefficient: "kg/s" = 1.0, "g/s" = 1e-3;
    /// A rate.
    Rate: "1/s" = 1.0, "/s" = 1.0, "Hz" = 1.0;
    /// A plain number.
    Number: "" = 1.0;
}

/// Whether `word` is a unit that some quantity takes: `mm`, `kN/m`.
pub fn is_unit(word: &str) -> bool {
    let mut units = UNITS.iter().flat_map(|units| units.iter());
    units.any(|&(unit, _)| unit == word && !word.is_empty())
}

/// Whether `text` is a number and a unit, whatever is measured in it: `0.5mm`, `5 kN/m`.
pub fn is_with_unit(text: &str) -> bool {
    let text = text.trim();
    let mut units =
        UNITS.iter().flat_map(|units| units.iter()).filter(|(unit, _)| !unit.is_empty());
    units.any(|(unit, _)| {
        text.strip_suffix(unit).is_some_and(|number| number.trim_end().parse::<f64>().is_ok())
    })
}

/// A number of threads: whole, and [`MOST_THREADS`] at most, which is checked with the scenario.
pub fn thread_count(text: &str) -> Result<i64, String> {
    whole_number(text).map_err(|_| format!("not a whole number from 1 to {MOST_THREADS}"))
}

/// More threads than any machine of ours has; each takes memory.
pub const MOST_THREADS: i64 = 256;

/// Two quantities: the x and y of a vector.
#[derive(Clone, Debug, Deserialize)]
#[serde(try_from = "Vec<Quantity<D>>", bound = "D: Dimension")]
pub struct Pair<D> {
    /// x and y in SI units.
    pub si: [f64; 2],
    dimension: PhantomData<D>,
}

impl<D> TryFrom<Vec<Quantity<D>>> for Pair<D> {
    type Error = String;

    fn try_from(values: Vec<Quantity<D>>) -> Result<Self, String> {
        match values.as_slice() {
            [x, y] => Ok(Self { si: [x.si, y.si], dimension: PhantomData }),
            [_] => Err("expected [x, y], found one number".to_owned()),
            _ => Err(format!("expected [x, y], found {} numbers", values.len())),
        }
    }
}

/// A whole number, on the command line also in the form 1e3.
pub fn whole_number(text: &str) -> Result<i64, String> {
    let whole =
        |number: f64| (number.fract() == 0.0 && number.abs() < 9e15).then_some(number as i64);
    let number = text.trim().parse().ok();
    number
        .or_else(|| whole(text.trim().parse().ok()?))
        .ok_or_else(|| "not a whole number (or too large)".to_owned())
}

/// A number of dimension `D`, held in SI units.
///
/// ```
/// use parsim2d::scenario::quantity::{Length, Quantity};
/// let side: Quantity<Length> = "4cm".parse().unwrap();
/// assert_eq!(side.si, 0.04); // m
/// let rate: Quantity<parsim2d::scenario::quantity::Rate> = "21/s".parse().unwrap();
/// assert_eq!(rate.si, 21.0); // 1/s
/// assert!("4 parsecs".parse::<Quantity<Length>>().is_err());
/// ```
#[derive(Debug, PartialEq)]
pub struct Quantity<D> {
    /// The value in SI units.
    pub si: f64,
    dimension: PhantomData<D>,
}

impl<D> Clone for Quantity<D> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<D> Copy for Quantity<D> {}

impl<D> From<f64> for Quantity<D> {
    fn from(si: f64) -> Self {
        Self { si, dimension: PhantomData }
    }
}

impl<D: Dimension> FromStr for Quantity<D> {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let text = text.trim();
        // A suffix fits if it leaves a number: "5mm" is not 5m of m, "inf" and "1e3" stay whole.
        let mut readings = D::SUFFIXES.iter().filter_map(|&(suffix, size)| {
            let number = text.strip_suffix(suffix)?;
            // "21/s" is 21 of /s, not 2 of 1/s.
            let runs_on = suffix.starts_with(|c: char| c.is_ascii_digit());
            if runs_on && !number.ends_with(char::is_whitespace) {
                return None;
            }
            let number: f64 = number.trim_end().parse().ok()?;
            // 4cm is 4/100 m, the nearest number to 0.04; 4 * 0.01 may not be.
            Some(if size < 1.0 { number / (1.0 / size).round() } else { number * size })
        });
        if let Some(si) = text.parse().ok().or_else(|| readings.next()) {
            return Ok(Self::from(si));
        }
        if text.contains(',') {
            return Err("not a number: write a dot, not a comma".to_owned());
        }
        let suffixes: Vec<&str> = D::SUFFIXES.iter().map(|&(suffix, _)| suffix).collect();
        Err(match suffixes.as_slice() {
            [""] => "not a number".to_owned(),
            [only] => format!("not a number (in {only})"),
            [si, ..] => format!("not a number (in {si}, or with one of: {})", suffixes.join(", ")),
            [] => unreachable!("every dimension has an SI unit"),
        })
    }
}

impl<'de, D: Dimension> Deserialize<'de> for Quantity<D> {
    fn deserialize<S: Deserializer<'de>>(deserializer: S) -> Result<Self, S::Error> {
        struct Reader<D>(PhantomData<D>);
        impl<D: Dimension> Visitor<'_> for Reader<D> {
            type Value = Quantity<D>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                let (unit, _) = D::SUFFIXES[0];
                match unit {
                    "" => f.write_str("a number"),
                    _ => write!(f, "a number in {unit}, or a string with a unit"),
                }
            }
            fn visit_f64<E: Error>(self, si: f64) -> Result<Self::Value, E> {
                Ok(si.into())
            }
            fn visit_i64<E: Error>(self, si: i64) -> Result<Self::Value, E> {
                Ok((si as f64).into())
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Self::Value, E> {
                text.parse().map_err(|why| E::custom(format!("`{}` is {why}", echo::value(text))))
            }
        }
        deserializer.deserialize_any(Reader(PhantomData))
    }
}
