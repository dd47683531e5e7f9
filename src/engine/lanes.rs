//! Numbers four at a time, with what the processor has for it.
//!
//! Every operation rounds each of the four as IEEE 754 says, so the bits are those of one number at a
//! time, on any processor.

use std::ops::{Add, Div, Mul, Sub};

use wide::{CmpGt, CmpLt, f64x4};

use super::group;

/// Four numbers.
pub trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    /// The numbers in which this processor works contacts out.
    type Group: group::Group;

    /// Some of them.
    fn group(self) -> Self::Group;

    /// Does `work` in a function of its own, made for this processor: the compiler looks at a loop alone there, and
    /// takes choices out of it that it leaves in a loop among many.
    fn apart(self, work: impl FnOnce());

    /// Four other numbers. They are asked of numbers, since who has some has a processor for them.
    fn of(self, numbers: [f64; 4]) -> Self;

    /// Puts the numbers there, all at once: what is put down in parts cannot be picked up whole for a while.
    fn put(self, there: &mut [f64; 4]);

    /// The numbers.
    fn to_array(self) -> [f64; 4];

    /// Square roots.
    fn sqrt(self) -> Self;

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

    /// All bits of both masks.
    fn or_where(self, other: Self) -> Self;

    /// Whether a mask has a bit.
    fn has_any(self) -> bool;

    /// (a0, a1, a2, a3), (b0, ..), .. as (a0, b0, c0, d0), (a1, ..), ..
    fn transposed(rows: [Self; 4]) -> [Self; 4];

    /// (a0, a1, b0, b1) and (a2, a3, b2, b3) of the rows a and b; its own inverse.
    fn halves_exchanged(a: Self, b: Self) -> [Self; 2];

    /// (-x0, -y0, x0, y0), (-x1, -y1, x1, y1), ..: both sides of four pushes.
    fn both_sides(x: Self, y: Self) -> [Self; 4];

    /// The same number four times.
    #[inline(always)]
    fn all(self, number: f64) -> Self {
        self.of([number; 4])
    }
}

/// On any processor.
impl Lanes for f64x4 {
    type Group = Self;
    #[inline(always)]
    fn group(self) -> Self {
        self
    }
    #[inline(never)]
    fn apart(self, work: impl FnOnce()) {
        work();
    }
    #[inline(always)]
    fn of(self, numbers: [f64; 4]) -> Self {
        Self::new(numbers)
    }
    #[inline(always)]
    fn put(self, there: &mut [f64; 4]) {
        *there = Self::to_array(self);
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
    fn or_where(self, other: Self) -> Self {
        self | other
    }
    #[inline(always)]
    fn has_any(self) -> bool {
        self.move_mask() != 0
    }
    #[inline(always)]
    fn transposed(rows: [Self; 4]) -> [Self; 4] {
        let rows = rows.map(Self::to_array);
        std::array::from_fn(|k| Self::new(rows.map(|row| row[k])))
    }
    #[inline(always)]
    fn halves_exchanged(a: Self, b: Self) -> [Self; 2] {
        let [a, b] = [a.to_array(), b.to_array()];
        [Self::new([a[0], a[1], b[0], b[1]]), Self::new([a[2], a[3], b[2], b[3]])]
    }
    #[inline(always)]
    fn both_sides(x: Self, y: Self) -> [Self; 4] {
        Self::transposed([x.negated(), y.negated(), x, y])
    }
}
