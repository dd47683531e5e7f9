//! Numbers four at a time, with what the processor has for it.
//!
//! Every operation rounds each of the four as IEEE 754 says, so the bits are those of one number at a
//! time, on any processor.

use std::ops::{Add, Div, Mul, Sub};

use wide::{CmpGt, CmpLt, f64x4};

/// Four numbers.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// Four other numbers. They are asked of numbers, since who has some has a processor for them.
    fn of(self, numbers: [f64; 4]) -> Self;

    /// The numbers.
    fn to_array(self) -> [f64; 4];

    /// Square roots.
    fn sqrt(self) -> Self;

    /// The numbers that are above 0, and 0 for the others.
    fn or_zero(self) -> Self;

    /// The lesser of each two; the second if one is no number.
    fn lesser(self, other: Self) -> Self;

    /// The greater of each two; the second if one is no number.
    fn greater(self, other: Self) -> Self;

    /// All with the other sign.
    fn negated(self) -> Self;

    /// (a, b, c, d) as (b, a, d, c).
    fn neighbours_exchanged(self) -> Self;

    /// Where this is less than `other`: all bits, else none.
    fn is_less(self, other: Self) -> Self;

    /// What is left of this where `mask` has all bits; 0 where it has none.
    fn where_all(self, mask: Self) -> Self;

    /// This where `mask` has all bits, `other` where it has none.
    fn or_else(self, mask: Self, other: Self) -> Self;

    /// Whether a mask has a bit.
    fn is_any(self) -> bool;

    /// (a0, a1, a2, a3), (b0, ..), .. as (a0, b0, c0, d0), (a1, ..), ..
    fn transposed(rows: [Self; 4]) -> [Self; 4];

    /// The same number four times.
    #[inline(always)]
    fn all(self, number: f64) -> Self {
        self.of([number; 4])
    }
}

/// On any processor.
impl Lanes for f64x4 {
    #[inline(always)]
    fn of(self, numbers: [f64; 4]) -> Self {
        Self::new(numbers)
    }
    #[inline(always)]
    fn to_array(self) -> [f64; 4] {
        Self::to_array(self)
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Self::sqrt(self)
    }
    #[inline(always)]
    fn or_zero(self) -> Self {
        self.cmp_gt(Self::ZERO) & self
    }
    #[inline(always)]
    fn lesser(self, other: Self) -> Self {
        self.fast_min(other)
    }
    #[inline(always)]
    fn greater(self, other: Self) -> Self {
        self.cmp_gt(other).blend(self, other)
    }
    #[inline(always)]
    fn negated(self) -> Self {
        self ^ Self::splat(-0.0)
    }
    #[inline(always)]
    fn neighbours_exchanged(self) -> Self {
        let [a, b, c, d] = self.to_array();
        Self::new([b, a, d, c])
    }
    #[inline(always)]
    fn is_less(self, other: Self) -> Self {
        self.cmp_lt(other)
    }
    #[inline(always)]
    fn where_all(self, mask: Self) -> Self {
        self & mask
    }
    #[inline(always)]
    fn or_else(self, mask: Self, other: Self) -> Self {
        mask.blend(self, other)
    }
    #[inline(always)]
    fn is_any(self) -> bool {
        self.move_mask() != 0
    }
    #[inline(always)]
    fn transposed(rows: [Self; 4]) -> [Self; 4] {
        let rows = rows.map(Self::to_array);
        std::array::from_fn(|k| Self::new(rows.map(|row| row[k])))
    }
}
