//! Gravity: a number, downward, or a vector `[gx, gy]` with y up; and what falls along it.

use std::fmt;
use std::str::FromStr;

use glam::DVec2;
use serde::Deserialize;

use super::quantity::{Acceleration, Pair, Quantity};
use crate::number::shortest;

/// The acceleration of gravity, m/s2.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity {
    /// As a vector, y up.
    pub vector: DVec2, // m/s2
}

impl Gravity {
    /// Downward.
    pub fn down(g: f64) -> Self {
        Self { vector: DVec2::new(0.0, -g) }
    }

    /// Of these components; `[0, -g]` has the bits of `down(g)`, zeros included.
    pub fn of([x, y]: [f64; 2]) -> Self {
        Self { vector: DVec2::new(0.0 + x, -(0.0 - y)) }
    }

    /// Its size, m/s2.
    pub fn size(self) -> f64 {
        let DVec2 { x, y } = self.vector;
        if x == 0.0 { y.abs() } else { x.hypot(y) } // a number keeps its bits
    }

    /// Whether there is none.
    pub fn is_nothing(self) -> bool {
        self.vector == DVec2::ZERO
    }

    /// Whether a number says it: it is along y.
    pub fn is_vertical(self) -> bool {
        self.vector.x == 0.0
    }

    /// From the highest corner of a square of `side` (m) to the lowest, along the fall, m.
    pub fn fall_height(self, side: f64) -> f64 {
        if self.is_vertical() {
            return side;
        }
        side * (self.vector.x.abs() + self.vector.y.abs()) / self.size()
    }

    /// How deep, along the fall, a heap of this `area` (m²) lies in a square of `side` (m), m: a layer as
    /// wide as the box, or, where gravity slants, the corner it runs into, with its surface across the fall.
    pub fn heap_depth(self, area: f64, side: f64) -> f64 {
        if self.is_vertical() {
            return area / side;
        }
        let DVec2 { x, y } = self.vector.abs() / self.size();
        let (less, more) = (x.min(y), x.max(y));
        let (corner, whole) = (0.5 * side * side * less / more, side * side);
        let in_corner = |area: f64| (2.0 * less * more * area).sqrt();
        if area <= corner {
            in_corner(area)
        } else if area <= whole - corner {
            area * more / side + 0.5 * side * less
        } else {
            self.fall_height(side) - in_corner((whole - area).max(0.0))
        }
    }
}

/// As it is said in a scenario file: a number if it is along y.
impl fmt::Display for Gravity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let DVec2 { x, y } = self.vector;
        if self.is_vertical() { write!(f, "{:?}", -y) } else { write!(f, "[{x:?}, {y:?}]") }
    }
}

impl Gravity {
    /// As it is said on the command line.
    pub(super) fn said(self) -> String {
        let DVec2 { x, y } = self.vector;
        if self.is_vertical() {
            return shortest(-y);
        }
        format!("[{},{}]", shortest(x), shortest(y))
    }
}

impl FromStr for Gravity {
    type Err = String;

    /// `9.81`, `981cm/s2`, `0,-9.81` or `[0, -9.81]`.
    fn from_str(text: &str) -> Result<Self, String> {
        let bare = text.trim();
        let listed = bare.strip_prefix('[').and_then(|text| text.strip_suffix(']'));
        let Some((x, y)) = listed.unwrap_or(bare).split_once(',') else {
            let number: Quantity<Acceleration> = bare
                .parse()
                .map_err(|why| format!("{why}; nor a vector [gx, gy], as [0, -9.81], y up"))?;
            return Ok(Self::down(number.si));
        };
        let is_digits = |text: &str| text.bytes().all(|byte| byte.is_ascii_digit());
        if listed.is_none() && is_digits(x.trim_start_matches('-')) && is_digits(y) {
            return Err(format!(
                "either a number with a comma in it, and then a dot is meant: {x}.{y}, or a vector, y up, and \
                 then brackets make it one: [{x}, {y}]"
            ));
        }
        let component = |text: &str| text.parse::<Quantity<Acceleration>>().map(|said| said.si);
        match (component(x), component(y)) {
            (Ok(x), Ok(y)) => Ok(Self::of([x, y])),
            (Ok(_), _) if component(&y.replacen(',', ".", 1)).is_ok() => Err(format!(
                "not two numbers: write a dot, not a comma, as [{x}, {}]",
                y.trim().replacen(',', ".", 1)
            )),
            _ => {
                Err("not two numbers (in m/s2): a vector is [gx, gy], as [0, -9.81], y up"
                    .to_owned())
            }
        }
    }
}

impl<'de> Deserialize<'de> for Gravity {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(
            untagged,
            expecting = "gravity is a number in m/s2 (downward), a string with a unit, or a vector [gx, gy], y up"
        )]
        enum Said {
            Number(f64),
            Text(String),
            Vector(Pair<Acceleration>),
        }
        match Said::deserialize(deserializer)? {
            Said::Number(g) => Ok(Self::down(g)),
            Said::Text(text) => {
                text.parse().map_err(|why| serde::de::Error::custom(format!("`{text}` is {why}")))
            }
            Said::Vector(pair) => Ok(Self::of(pair.si)),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_heap_holds_its_area_whichever_way_it_lies() {
        let side = 0.04;
        for vector in [[0.0, -9.81], [3.0, -9.0], [-5.0, -5.0], [9.0, 0.5], [-9.81, 0.0]] {
            let gravity = Gravity::of(vector);
            let fall = gravity.vector.abs() / gravity.size();
            for part in [0.001, 0.1, 0.5, 0.9, 0.999] {
                let depth = gravity.heap_depth(part * side * side, side);
                // Columns along y, 10,000 of them: each is wet up to the depth. Errors go like 1/columns.
                let columns = 10_000;
                let wet: f64 = (0..columns)
                    .map(|k| side * (f64::from(k) + 0.5) / f64::from(columns))
                    .map(|x| {
                        let left = depth - fall.x * x;
                        let high = if fall.y > 0.0 { left / fall.y } else { left.signum() * side };
                        high.clamp(0.0, side) / side
                    })
                    .sum();
                let found = wet / f64::from(columns);
                assert!((found / part - 1.0).abs() < 2e-3, "{vector:?}, {part}: {found}");
            }
            let full = gravity.heap_depth(side * side, side);
            assert!((full / gravity.fall_height(side) - 1.0).abs() < 1e-12, "{vector:?}");
        }
    }

    #[test]
    fn a_vector_downward_has_the_bits_of_a_number() {
        for g in [9.81, 0.0, -1.5, 1e-300] {
            let (number, vector) = (Gravity::down(g).vector, Gravity::of([0.0, -g]).vector);
            assert_eq!(number.to_array().map(f64::to_bits), vector.to_array().map(f64::to_bits));
        }
        assert_eq!(Gravity::of([-0.0, 0.0]).vector.to_array().map(f64::to_bits), [0, 1 << 63]);
    }

    #[test]
    fn words_are_read_as_they_are_meant_or_refused() {
        for (text, vector) in [
            ("9.81", [0.0, -9.81]),
            ("981cm/s2", [0.0, -9.81]),
            ("-3", [0.0, 3.0]),
            ("0,-9.81", [0.0, -9.81]),
            ("[0, -9.81]", [0.0, -9.81]),
            (" [1,2] ", [1.0, 2.0]),
            ("1.5,2", [1.5, 2.0]),
            ("1m/s2, -981cm/s2", [1.0, -9.81]),
        ] {
            let gravity: Gravity = text.parse().unwrap_or_else(|why| panic!("{text}: {why}"));
            assert_eq!(gravity.vector, DVec2::from_array(vector), "{text}");
            assert_eq!(gravity.to_string().parse(), Ok(gravity), "{text}");
            assert_eq!(gravity.said().parse(), Ok(gravity), "{text}");
        }
        for (text, word) in [
            ("9,81", "a dot is meant: 9.81"),
            ("-9,81", "a dot is meant: -9.81"),
            ("down", "nor a vector"),
            ("[0, -9,81]", "not two numbers: write a dot, not a comma, as [0, -9.81]"),
            ("[1, 2, 3]", "not two numbers"),
            ("[1]", "nor a vector"),
            ("", "nor a vector"),
        ] {
            let why = text.parse::<Gravity>().unwrap_err();
            assert!(why.contains(word), "{text}: {why}");
        }
    }
}
