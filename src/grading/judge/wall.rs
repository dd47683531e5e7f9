//! The walls of the box.

use glam::DVec2;
use serde::Serialize;

/// Left, right, bottom, top.
pub const WALLS: [(DVec2, u8); 4] =
    [(DVec2::NEG_X, 1), (DVec2::X, 2), (DVec2::NEG_Y, 4), (DVec2::Y, 8)];

/// A wall of the box.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Wall {
    /// Low x.
    Left,
    /// High x.
    Right,
    /// Low y.
    Floor,
    /// High y.
    Ceiling,
}

impl Wall {
    /// The wall with this bit of [`WALLS`].
    pub fn of(bit: u8) -> Self {
        match bit {
            1 => Self::Left,
            2 => Self::Right,
            4 => Self::Floor,
            _ => Self::Ceiling,
        }
    }

    /// The wall with this normal, outward.
    pub fn with_normal(normal: DVec2) -> Self {
        let found = WALLS.iter().find(|(known, _)| *known == normal);
        Self::of(found.map_or(8, |(_, bit)| *bit))
    }
}

/// English.
pub(super) fn english(wall: Wall) -> &'static str {
    match wall {
        Wall::Left => "left wall",
        Wall::Right => "right wall",
        Wall::Floor => "floor",
        Wall::Ceiling => "ceiling",
    }
}
