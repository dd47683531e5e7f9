//! The ring that keeps the last of the pairs' forces, and what is kept of each.

use glam::DVec2;
use wide::f64x2;

use super::contact_lanes::Forces;
use super::lanes::Lanes;

/// What is kept of a contact: on its first disc, and on its second.
pub(super) trait Kept<V: Lanes> {
    /// Whether the springs' share is told apart.
    const HAS_SPRING: bool;
    /// As it lies in the ring.
    type Stored: Copy + Default;
    /// As it is added up.
    type Sum: Copy;
    /// What is to be stored of four contacts with these forces on the second discs, N.
    fn stored(forces: [Forces<V>; 2]) -> [[Self::Stored; 2]; 4];
    /// A force without springs, to begin a sum with.
    fn start(zero: V, force: DVec2, spring: DVec2) -> Self::Sum;
    /// The sum with one more.
    fn plus(sum: Self::Sum, other: Self::Stored) -> Self::Sum;
    /// The whole force and the springs' share, N.
    fn of(sum: Self::Sum) -> [DVec2; 2];
}

/// The whole force alone.
pub(super) struct Whole;

impl<V: Lanes> Kept<V> for Whole {
    const HAS_SPRING: bool = false;
    type Stored = [f64; 2];
    type Sum = f64x2;
    #[inline(always)]
    fn stored([[x, y], _]: [Forces<V>; 2]) -> [[[f64; 2]; 2]; 4] {
        let [a, b, c, d] = V::transposed([x.negated(), y.negated(), x, y]);
        [halves(a), halves(b), halves(c), halves(d)]
    }
    #[inline(always)]
    fn start(_zero: V, force: DVec2, _spring: DVec2) -> f64x2 {
        f64x2::new(force.to_array())
    }
    #[inline(always)]
    fn plus(sum: f64x2, other: [f64; 2]) -> f64x2 {
        sum + f64x2::new(other)
    }
    #[inline(always)]
    fn of(sum: f64x2) -> [DVec2; 2] {
        [DVec2::from_array(sum.to_array()), DVec2::ZERO]
    }
}

/// The whole force and the springs' share, for the ledger.
pub(super) struct Split;

impl<V: Lanes> Kept<V> for Split {
    const HAS_SPRING: bool = true;
    type Stored = [f64; 4];
    type Sum = V;
    #[inline(always)]
    fn stored([[x, y], [sx, sy]]: [Forces<V>; 2]) -> [[[f64; 4]; 2]; 4] {
        let [a, b, c, d] = V::transposed([x, y, sx, sy]);
        [both_signs(a), both_signs(b), both_signs(c), both_signs(d)]
    }
    #[inline(always)]
    fn start(zero: V, force: DVec2, spring: DVec2) -> V {
        zero.of([force.x, force.y, spring.x, spring.y])
    }
    #[inline(always)]
    fn plus(sum: V, other: [f64; 4]) -> V {
        sum + sum.of(other)
    }
    #[inline(always)]
    fn of(sum: V) -> [DVec2; 2] {
        let [x, y, sx, sy] = sum.to_array();
        [DVec2::new(x, y), DVec2::new(sx, sy)]
    }
}

#[inline(always)]
fn halves<V: Lanes>(row: V) -> [[f64; 2]; 2] {
    let [a, b, c, d] = row.to_array();
    [[a, b], [c, d]]
}

#[inline(always)]
fn both_signs<V: Lanes>(row: V) -> [[f64; 4]; 2] {
    [row.negated().to_array(), row.to_array()]
}

/// The last of the pairs' forces: for each pair that on its first disc, then that on its second.
#[derive(Default)]
pub(super) struct Ring {
    pub whole: Vec<[[f64; 2]; 2]>, // N
    pub split: Vec<[[f64; 4]; 2]>, // N, with a ledger
}
