//! The ring that keeps the last of the pairs' forces, and what is kept of each.

use glam::DVec2;
use wide::f64x2;

use super::both::Both;
use super::group::Group;
use super::lanes::Lanes;
use super::lookup::Lookup;

/// What is kept of a pair's forces: on its first disc, and on its second.
pub(super) trait Entry<V: Lanes> {
    /// Whether the springs' share is told apart.
    const HAS_SPRING: bool;
    /// One side as it lies in the ring.
    type Stored: Copy + Default + Send + Sync;
    /// Both sides as they lie in the ring, the first disc's first: nothing but the two.
    type Both: Copy + Default + Send + Sync;
    /// As it is added up.
    type Sum: Copy;
    /// Puts both sides of a group of contacts with these forces, x and y, on the second discs (N), there.
    fn put(push: [V::Group; 2], spring: [V::Group; 2], there: &mut [Self::Both]);
    /// Both sides together.
    fn together(sides: [Self::Stored; 2]) -> Self::Both;
    /// Each for itself.
    fn apart(both: Self::Both) -> [Self::Stored; 2];
    /// One side: the whole force and the springs' share, N.
    fn side(force: DVec2, spring: DVec2) -> Self::Stored;
    /// A sum that begins with this.
    fn start(zero: V, first: &Self::Stored) -> Self::Sum;
    /// The sum with one more.
    fn plus(sum: Self::Sum, other: &Self::Stored) -> Self::Sum;
    /// The whole force and the springs' share, N.
    fn of(sum: Self::Sum) -> [DVec2; 2];
    /// The whole forces on two discs, x and y of the one and then of the other, and the springs' shares, N.
    fn of_two(zero: V, sums: [Self::Sum; 2]) -> [V; 2];

    /// The sum of this and of the six entries that `parts` name in the ring, one after the other.
    #[inline(always)]
    fn plus_six(sum: Self::Sum, parts: &[u16; 6], ring: Lookup<Self::Stored>) -> Self::Sum {
        let sum = Self::plus(Self::plus(sum, ring.at(parts[0])), ring.at(parts[1]));
        let sum = Self::plus(Self::plus(sum, ring.at(parts[2])), ring.at(parts[3]));
        Self::plus(Self::plus(sum, ring.at(parts[4])), ring.at(parts[5]))
    }
}

/// The whole force alone.
pub(super) struct Whole;

impl<V: Lanes> Entry<V> for Whole {
    const HAS_SPRING: bool = false;
    type Stored = [f64; 2];
    type Both = Both<[f64; 4]>;
    type Sum = f64x2;
    #[inline(always)]
    fn put(push: [V::Group; 2], _spring: [V::Group; 2], there: &mut [Both<[f64; 4]>]) {
        V::Group::put_sides(push, there);
    }
    #[inline(always)]
    fn together([[a, b], [c, d]]: [[f64; 2]; 2]) -> Both<[f64; 4]> {
        Both([a, b, c, d])
    }
    #[inline(always)]
    fn apart(Both([a, b, c, d]): Both<[f64; 4]>) -> [[f64; 2]; 2] {
        [[a, b], [c, d]]
    }
    #[inline(always)]
    fn side(force: DVec2, _spring: DVec2) -> [f64; 2] {
        force.to_array()
    }
    #[inline(always)]
    fn start(_zero: V, first: &[f64; 2]) -> f64x2 {
        f64x2::new(*first)
    }
    #[inline(always)]
    fn plus(sum: f64x2, other: &[f64; 2]) -> f64x2 {
        sum + f64x2::new(*other)
    }
    #[inline(always)]
    fn of(sum: f64x2) -> [DVec2; 2] {
        [DVec2::from_array(sum.to_array()), DVec2::ZERO]
    }
    #[inline(always)]
    fn of_two(zero: V, [a, b]: [f64x2; 2]) -> [V; 2] {
        let ([ax, ay], [bx, by]) = (a.to_array(), b.to_array());
        [zero.of([ax, ay, bx, by]), zero]
    }
}

/// The whole force and the springs' share, for the ledger.
pub(super) struct Split;

impl<V: Lanes> Entry<V> for Split {
    const HAS_SPRING: bool = true;
    type Stored = [f64; 4];
    type Both = Both<[[f64; 4]; 2]>;
    type Sum = V;
    #[inline(always)]
    fn put(push: [V::Group; 2], spring: [V::Group; 2], there: &mut [Both<[[f64; 4]; 2]>]) {
        V::Group::put_sides_of_two(push, spring, there);
    }
    #[inline(always)]
    fn together(sides: [[f64; 4]; 2]) -> Both<[[f64; 4]; 2]> {
        Both(sides)
    }
    #[inline(always)]
    fn apart(Both(sides): Both<[[f64; 4]; 2]>) -> [[f64; 4]; 2] {
        sides
    }
    #[inline(always)]
    fn side(force: DVec2, spring: DVec2) -> [f64; 4] {
        [force.x, force.y, spring.x, spring.y]
    }
    #[inline(always)]
    fn start(zero: V, first: &[f64; 4]) -> V {
        zero.of(*first)
    }
    #[inline(always)]
    fn plus(sum: V, other: &[f64; 4]) -> V {
        sum + sum.of(*other)
    }
    #[inline(always)]
    fn of(sum: V) -> [DVec2; 2] {
        let [x, y, sx, sy] = sum.to_array();
        [DVec2::new(x, y), DVec2::new(sx, sy)]
    }
    #[inline(always)]
    fn of_two(_zero: V, [a, b]: [V; 2]) -> [V; 2] {
        V::halves_exchanged(a, b)
    }
}

/// The last of the pairs' forces: for each pair that on its first disc, then that on its second; and after them twice no
/// force at all.
#[derive(Default)]
pub(super) struct PairBuffer {
    pub whole: Vec<Both<[f64; 4]>>,      // N
    pub split: Vec<Both<[[f64; 4]; 2]>>, // N, with a ledger
}
