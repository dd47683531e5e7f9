//! Contacts of four pairs at a time, in whatever the processor has for four numbers.

use super::both::Both;
use super::group::Group;
use super::lanes::Lanes;
use super::lookup::{Lookup, Offset};
use super::phase::Phase;

impl<V: Lanes> Group for V {
    const PAIRS: usize = 4;
    type Mask = Self;

    #[inline(always)]
    fn load(self, numbers: &[f64]) -> Self {
        self.of([numbers[0], numbers[1], numbers[2], numbers[3]])
    }
    #[inline(always)]
    fn store(self, there: &mut [f64]) {
        self.put(there.first_chunk_mut().expect("room for four"));
    }
    #[inline(always)]
    fn all(self, number: f64) -> Self {
        self.of([number; 4])
    }
    #[inline(always)]
    fn sqrt(self) -> Self {
        Lanes::sqrt(self)
    }
    #[inline(always)]
    fn negated(self) -> Self {
        Lanes::negated(self)
    }
    #[inline(always)]
    fn none(self) -> Self {
        self.of([0.0; 4])
    }
    #[inline(always)]
    fn is_less(self, other: Self) -> Self {
        Lanes::is_less(self, other)
    }
    #[inline(always)]
    fn either(self, one: Self, other: Self) -> Self {
        one.or_where(other)
    }
    #[inline(always)]
    fn is_any(self, mask: Self) -> bool {
        mask.has_any()
    }
    #[inline(always)]
    fn where_all(self, mask: Self) -> Self {
        Lanes::where_all(self, mask)
    }
    #[inline(always)]
    fn store_mask(self, mask: Self, there: &mut [f64]) {
        mask.store(there);
    }
    #[inline(always)]
    fn load_mask(self, from: &[f64]) -> Self {
        self.load(from)
    }
    #[inline(always)]
    fn differences(self, discs: Lookup<Phase>, pairs: &[[Offset; 2]]) -> [Self; 4] {
        let seen = |[i, j]: [Offset; 2]| self.of(discs.after(j).0) - self.of(discs.after(i).0);
        V::transposed([seen(pairs[0]), seen(pairs[1]), seen(pairs[2]), seen(pairs[3])])
    }
    #[inline(always)]
    fn put_sides([x, y]: [Self; 2], there: &mut [Both<[f64; 4]>]) {
        let there = &mut there[..4];
        let [a, b, c, d] = V::both_sides(x, y);
        a.put(&mut there[0].0);
        b.put(&mut there[1].0);
        c.put(&mut there[2].0);
        d.put(&mut there[3].0);
    }
    #[inline(always)]
    fn put_sides_of_two([x, y]: [Self; 2], [sx, sy]: [Self; 2], there: &mut [Both<[[f64; 4]; 2]>]) {
        let there = &mut there[..4];
        let [a, b, c, d] = V::transposed([x, y, sx, sy]);
        put_both(a, &mut there[0].0);
        put_both(b, &mut there[1].0);
        put_both(c, &mut there[2].0);
        put_both(d, &mut there[3].0);
    }
}

#[inline(always)]
fn put_both<V: Lanes>(row: V, there: &mut [[f64; 4]; 2]) {
    Lanes::negated(row).put(&mut there[0]);
    row.put(&mut there[1]);
}
