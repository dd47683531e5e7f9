//! Contacts of as many pairs at a time as the processor's widest registers have numbers.

use std::ops::{Add, Div, Mul, Sub};

use super::both::Both;
use super::lookup::{Lookup, Offset};
use super::phase::Phase;

/// A number for each pair of a group. Every operation rounds each as IEEE 754 says.
pub trait Group:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Pairs in a group.
    const PAIRS: usize;
    /// Yes or no for each pair.
    type Mask: Copy;

    /// The first numbers of `numbers`.
    fn load(self, numbers: &[f64]) -> Self;
    /// Puts them there, as the first.
    fn store(self, there: &mut [f64]);
    /// The same number for each.
    fn all(self, number: f64) -> Self;
    /// Square roots.
    fn sqrt(self) -> Self;
    /// All with the other sign.
    fn negated(self) -> Self;

    /// No for each.
    fn none(self) -> Self::Mask;
    /// Where this is less than `other`.
    fn is_less(self, other: Self) -> Self::Mask;
    /// Where it is one or the other.
    fn either(self, one: Self::Mask, other: Self::Mask) -> Self::Mask;
    /// Whether there is a yes.
    fn is_any(self, mask: Self::Mask) -> bool;
    /// What is left of this where `mask` says yes; 0 elsewhere.
    fn where_all(self, mask: Self::Mask) -> Self;
    /// Puts a mask there, as the first of numbers that are none.
    fn store_mask(self, mask: Self::Mask, there: &mut [f64]);
    /// The mask that was put there.
    fn load_mask(self, from: &[f64]) -> Self::Mask;

    /// What x, y, vx and vy of the second disc of each pair are more than those of the first.
    fn differences(self, discs: Lookup<Phase>, pairs: &[[Offset; 2]]) -> [Self; 4];
    /// Puts (-x, -y) and (x, y) there, pair by pair.
    fn put_sides(force: [Self; 2], there: &mut [Both<[f64; 4]>]);
    /// The same for two forces: (-x, -y, -sx, -sy) and (x, y, sx, sy).
    fn put_sides_of_two(whole: [Self; 2], spring: [Self; 2], there: &mut [Both<[[f64; 4]; 2]>]);
}
