//! Square cells, each named by a key, and discs sorted by them.
//!
//! What is kept is the sorted keys of the discs, and a table of cells only where these are not many more. A few
//! discs far away cost a few digits of the keys, and no cell becomes larger by them.

use glam::{DVec2, Vec2Swizzles};

use super::phase::Phase;
use super::sizes::Sizes;
use super::workers::Workers;

/// Cells on either side of the middle of the discs, at most; what lies beyond is in the last ones. Numbers
/// of up to 31 bits leave 22 of a position for where in its cell a disc is.
const CELLS_AROUND: f64 = (1_u64 << 30) as f64;

/// Cells are wider than asked for by this much, for the rounding of those 22 bits.
pub(super) const MARGIN: f64 = 1e-5;

/// Cells of which a table is made, for each disc, at most.
const CELLS_PER_DISC: usize = 4;

/// Bits by which discs are sorted at a time: the counts of so many digits stay in the nearest memory.
const DIGIT: u32 = 11;

/// Square cells over all discs. Keys ascend along the shorter side of where most discs are, so that
/// neighbours in the next row lie near in memory.
#[derive(Clone, Copy, PartialEq)]
pub(super) struct Grid {
    corner: DVec2, // m
    per_metre: f64,
    /// If the shorter side is upright, x and y are exchanged here.
    is_upright: bool,
    last_column: u64,
    last_row: u64,
    /// From a key to that of the cell above it. Beyond the last column there is one that is always empty.
    pub row: u64,
}

impl Grid {
    /// Cells of a side of `reach` (m) or a little more.
    pub fn new(sizes: &Sizes, reach: f64) -> Self {
        let side = reach * (1.0 + MARGIN);
        let [low, high] = sizes.middle;
        let around = DVec2::splat(CELLS_AROUND * side);
        let corner = sizes.low.max(low - around);
        let size = (sizes.high.min(high + around) - corner) / side;
        let is_upright = (high - low).y < (high - low).x;
        let last = if is_upright { size.yx() } else { size };
        let (last_column, last_row) = (last.x as u64, last.y as u64);
        Self {
            corner,
            per_metre: 1.0 / side,
            is_upright,
            last_column,
            last_row,
            row: last_column + 2,
        }
    }

    /// The cell at `position`. Discs closer than a side are in one cell or in two that touch.
    pub fn key(&self, position: DVec2) -> u64 {
        let cell = (position - self.corner) * self.per_metre;
        let cell = if self.is_upright { cell.yx() } else { cell };
        // `as` sends negative numbers and NaN to 0 and large ones to the last cell. Column 0 is that beyond
        // the last one, and there is a row before the first.
        let column = u64::from(cell.x as u32).min(self.last_column) + 1;
        (u64::from(cell.y as u32).min(self.last_row) + 1) * self.row + column
    }

    /// The cells of discs.
    pub fn keys(&self, phases: &[Phase], workers: &Workers) -> Vec<u64> {
        let mut keys = vec![0; phases.len()];
        workers.pieces(&mut keys, |first, keys| {
            let discs = keys.iter_mut().zip(&phases[first..]);
            discs.for_each(|(key, p)| *key = self.key(p.position()));
        });
        keys
    }

    /// The order in which discs are to be stored: for each place, where its disc is now; and how they lie in the cells
    /// then. Discs of a cell follow each other by id, so that two at exactly one place are always the same first and second
    /// of their contact.
    pub fn order(&self, phases: &[Phase], ids: &[u32], workers: &Workers) -> (Vec<u32>, InCells) {
        let keys = self.keys(phases, workers);
        let (mut order, starts) = self.sort(&keys);
        let keys: Vec<u64> = order.iter().map(|&now| keys[now as usize]).collect();
        let mut rest = &mut order[..];
        for cell in keys.chunk_by(|a, b| a == b) {
            let here;
            (here, rest) = rest.split_at_mut(cell.len());
            if here.len() > 1 {
                here.sort_unstable_by_key(|&now| ids[now as usize]);
            }
        }
        (order, InCells { grid: *self, keys, starts })
    }

    /// The order of discs in cells of these keys, those of one cell as they come, and where each cell begins in it.
    pub fn sort(&self, keys: &[u64]) -> (Vec<u32>, Starts) {
        let starts = Starts::of(self, keys);
        let mut order: Vec<u32> = (0..keys.len() as u32).collect();
        if keys.is_sorted() {
            // They are in order.
        } else if starts.are_known() {
            let mut next = starts.0.clone();
            for (disc, key) in (0..).zip(keys) {
                let next = &mut next[*key as usize];
                order[*next as usize] = disc;
                *next += 1;
            }
        } else {
            sort_by_key(&mut order, |disc| keys[*disc as usize]);
        }
        (order, starts)
    }
}

/// How discs lie in cells that follow each other.
pub(super) struct InCells {
    pub grid: Grid,
    /// The cells of the discs, ascending.
    pub keys: Vec<u64>,
    pub starts: Starts,
}

/// Where cells begin among discs sorted by them: for each key how many discs have lesser ones. Not known where cells are many
/// more than discs.
pub(super) struct Starts(Vec<u32>);

impl Starts {
    /// Those of discs in cells of these keys.
    pub fn of(grid: &Grid, keys: &[u64]) -> Self {
        let cells = (grid.last_row + 3).saturating_mul(grid.row) + 2; // to two after the last that touches one
        if cells > (CELLS_PER_DISC * keys.len() + 64) as u64 {
            return Self(Vec::new());
        }
        let mut starts = vec![0; cells as usize];
        keys.iter().for_each(|key| starts[*key as usize] += 1);
        let mut start = 0;
        for here in &mut starts {
            (*here, start) = (start, start + *here);
        }
        Self(starts)
    }

    pub fn are_known(&self) -> bool {
        !self.0.is_empty()
    }

    /// Where the cell of this key begins, or would.
    #[inline(always)]
    pub fn of_cell(&self, key: u64) -> usize {
        self.0[key as usize] as usize
    }
}

/// Sorts by `key`, the equal ones in the order in which they come: digit by digit, the lowest first.
pub(super) fn sort_by_key<T: Copy>(items: &mut Vec<T>, key: impl Fn(&T) -> u64) {
    let [lowest, highest] = items.iter().fold([u64::MAX, 0], |[low, high], item| {
        let key = key(item);
        [low.min(key), high.max(key)]
    });
    let lowest = lowest.min(highest); // of nothing
    let bits = u64::BITS - (highest - lowest).leading_zeros();
    let width = bits.div_ceil(bits.div_ceil(DIGIT).max(1));
    let mut sorted = items.clone();
    for shift in (0..bits).step_by(width.max(1) as usize) {
        let digit = |item: &T| ((key(item) - lowest) >> shift) as usize & ((1 << width) - 1);
        let mut ends = vec![0_usize; 1 << width];
        items.iter().for_each(|item| ends[digit(item)] += 1);
        let mut end = 0;
        for start in &mut ends {
            (*start, end) = (end, end + *start);
        }
        for item in &*items {
            let next = &mut ends[digit(item)];
            sorted[*next] = *item;
            *next += 1;
        }
        std::mem::swap(items, &mut sorted);
    }
}

/// Moves the disc at `order[place]` to `place`, for all places, and all that lies beside the discs
/// with them, in place. `order` is used up.
pub(super) fn put_in_order(order: &mut [u32], mut swap: impl FnMut(usize, usize)) {
    for first in 0..order.len() {
        let mut place = first;
        loop {
            let from = std::mem::replace(&mut order[place], place as u32) as usize;
            if from == first || from == place {
                break;
            }
            swap(place, from);
            place = from;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::sizes::Extents;

    #[test]
    fn what_is_put_in_order_lies_where_the_order_says() {
        for order in [vec![], vec![0], vec![1, 0], vec![2, 0, 1, 3], vec![4, 3, 0, 1, 2]] {
            let before: Vec<u32> = (0..order.len() as u32).map(|k| 10 * k).collect();
            let mut after = before.clone();
            put_in_order(&mut order.clone(), |a, b| after.swap(a, b));
            let wanted: Vec<u32> = order.iter().map(|&from| before[from as usize]).collect();
            assert_eq!(after, wanted);
        }
    }

    #[test]
    fn what_is_sorted_by_key_ascends_and_equal_ones_stay_as_they_came() {
        for (n, times) in
            [(0, 1), (1, 1), (5, 0), (1000, 1), (1000, 0x1_0000_0001), (3000, 1 << 52)]
        {
            let key = |k: u32| u64::from(7919 * k % 512) * times;
            let mut sorted: Vec<u32> = (0..n).collect();
            sort_by_key(&mut sorted, |k| key(*k));
            let mut wanted: Vec<u32> = (0..n).collect();
            wanted.sort_by_key(|k| key(*k));
            assert_eq!(sorted, wanted);
        }
    }

    #[test]
    fn discs_closer_than_a_side_are_in_cells_that_touch_wherever_they_are() {
        let golden = |k: usize| (0.618_034 * k as f64).fract();
        let spread = |k: usize| DVec2::new(golden(k), golden(7 * k + 3));
        let kinds: [fn(DVec2) -> DVec2; 5] = [
            |place| place,
            |place| DVec2::new(place.x, 10.0 * place.y),
            |place| DVec2::new(place.x, 0.0),
            |place| DVec2::new(1e4 * place.x, place.y),
            |place| if place.x < 0.01 { 1e12 * place } else { place },
        ];
        for kind in kinds {
            let places: Vec<_> = (0..400).map(|k| kind(spread(k))).collect();
            let phases: Vec<_> = places.iter().map(|p| Phase::new(*p, DVec2::ZERO)).collect();
            let (discs, ids) = (Extents { phases: &phases, radii: &[0.01; 400] }, &[0; 400]);
            let (reach, sizes) = (0.05, Sizes::of(discs, ids, &Workers::of(1)));
            let grid = Grid::new(&sizes, reach);
            for (k, p) in places.iter().enumerate() {
                let key = grid.key(*p);
                let around = [key - grid.row, key, key + grid.row];
                for q in &places[..k] {
                    let other = grid.key(*q);
                    let is_near = p.distance(*q) < reach;
                    let touch = around.iter().any(|key| other.abs_diff(*key) <= 1);
                    assert!(touch || !is_near, "{p:?} {q:?}");
                }
            }
        }
    }
}
