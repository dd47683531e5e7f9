//! Discs sorted by cells that suit their size, and who lies around whom.

use std::ops::Range;

use glam::DVec2;

use super::cells::{Grid, InCells};
use super::phase::Phase;
use super::sizes::{Extents, Sizes};
use super::workers::Workers;

/// Discs of about one size, sorted by cells so wide that two near ones are in cells that touch.
pub(super) struct Level {
    cells: InCells,
    /// Its discs in this order; none if they are all there are, in the order in which they are stored.
    sorted: Option<Sorted>,
}

/// Discs in the order of a level.
struct Sorted {
    /// Where they are stored.
    places: Vec<u32>,
    phases: Vec<Phase>,
    radii: Vec<f64>, // m
}

impl Level {
    /// All `discs`, in cells of `grid`.
    fn of_all(discs: Extents, grid: Grid, workers: &Workers) -> Self {
        let keys = grid.keys(discs.phases, workers);
        Self::sorted(discs, &keys, grid, |k| k)
    }

    /// Those of `discs` that are stored at these places, in cells of `grid`.
    fn of_some(discs: Extents, places: &[u32], grid: Grid) -> Self {
        let key = |&place: &u32| grid.key(discs.phases[place as usize].position());
        let keys: Vec<u64> = places.iter().map(key).collect();
        Self::sorted(discs, &keys, grid, |k| places[k as usize])
    }

    /// Discs that are in cells of these keys and stored where `place` says.
    fn sorted(discs: Extents, keys: &[u64], grid: Grid, place: impl Fn(u32) -> u32) -> Self {
        let (order, starts) = grid.sort(keys);
        let keys = order.iter().map(|&k| keys[k as usize]).collect();
        let places: Vec<u32> = order.into_iter().map(place).collect();
        let phases = places.iter().map(|&place| discs.phases[place as usize]).collect();
        let radii = places.iter().map(|&place| discs.radii[place as usize]).collect();
        Self { cells: InCells { grid, keys, starts }, sorted: Some(Sorted { places, phases, radii }) }
    }

    /// Number of discs.
    pub fn count(&self) -> usize {
        self.cells.keys.len()
    }

    /// Whether they are all there are, in the order in which they are stored.
    pub fn is_as_stored(&self) -> bool {
        self.sorted.is_none()
    }

    /// Where a disc of it is stored.
    #[inline(always)]
    pub fn place(&self, disc: usize) -> usize {
        self.sorted.as_ref().map_or(disc, |sorted| sorted.places[disc] as usize)
    }

    /// Its discs in its order; `stored` are all as they are stored.
    #[inline(always)]
    pub fn discs<'a>(&'a self, stored: Extents<'a>) -> Extents<'a> {
        match &self.sorted {
            None => stored,
            Some(Sorted { phases, radii, .. }) => Extents { phases, radii },
        }
    }

    /// Where the cell of this key begins, or would.
    fn start(&self, key: u64) -> usize {
        match self.cells.starts.are_known() {
            true => self.cells.starts.of_cell(key),
            false => self.cells.keys.partition_point(|other| *other < key),
        }
    }

    /// Tells `of`, for each of `discs`, which follow it in cells that touch its own: two runs.
    #[inline(always)]
    pub fn each_ahead(&self, discs: Range<usize>, mut of: impl FnMut(usize, [Range<usize>; 2])) {
        let Some(&first) = self.cells.keys.get(discs.start) else { return };
        // To the right in its own row, and from the left to the right above.
        let ends = |key: u64| [key + 2, key + self.cells.grid.row - 1, key + self.cells.grid.row + 2];
        let mut at = ends(first).map(|key| self.start(key));
        let go_to = |at: &mut usize, key: u64| match self.cells.starts.are_known() {
            true => *at = self.cells.starts.of_cell(key),
            false => {
                while self.cells.keys.get(*at).is_some_and(|other| *other < key) {
                    *at += 1;
                }
            }
        };
        for (disc, &key) in discs.clone().zip(&self.cells.keys[discs]) {
            at.iter_mut().zip(ends(key)).for_each(|(at, key)| go_to(at, key));
            of(disc, [disc + 1..at[0], at[1]..at[2]]);
        }
    }

    /// Those in the cell of `position` and in cells that touch it: three runs. `around` keeps what was
    /// found last.
    pub fn around(&self, position: DVec2, around: &mut Around) -> [Range<usize>; 3] {
        let key = self.cells.grid.key(position);
        if around.key != key {
            let run = |key: u64| [self.start(key - 1), self.start(key + 2)];
            let row = self.cells.grid.row;
            *around = Around { key, runs: [key - row, key, key + row].map(run) };
        }
        around.runs.map(|[start, end]| start..end)
    }
}

/// A cell, 0 for none, and those around it.
#[derive(Clone, Copy, Default)]
pub(super) struct Around {
    key: u64,
    runs: [[usize; 2]; 3],
}

/// Levels of near pairs within `skin` (m) of touching, finest first: discs of one level have radii within
/// a factor of 2 (Krijgsman, Ogarko and Luding 2014), so that small ones are not looked for in cells for
/// large ones. Discs may be `stored` in cells for the [`usual_radius`].
pub(super) fn levels(
    discs: Extents,
    sizes: &Sizes,
    skin: f64,
    stored: Option<InCells>,
    workers: &Workers,
) -> Vec<Level> {
    if is_one_level(sizes, skin) {
        let grid = Grid::new(sizes, 2.0 * sizes.largest_radius + skin);
        let as_stored = |cells| Level { cells, sorted: None };
        return vec![stored.map_or_else(|| Level::of_all(discs, grid, workers), as_stored)];
    }
    let mut members = vec![Vec::new(); LEVELS];
    for (place, radius) in (0..).zip(discs.radii) {
        members[level_of(*radius, sizes)].push(place);
    }
    let level = |places: Vec<u32>| {
        let radii = places.iter().map(|&place| discs.radii[place as usize]);
        let grid = Grid::new(sizes, 2.0 * radii.fold(0.0, f64::max) + skin);
        Level::of_some(discs, &places, grid)
    };
    members.into_iter().filter(|places| !places.is_empty()).map(level).collect()
}

/// The largest radius, m, of those of the median disc's level: what cells of the order of storage follow.
pub(super) fn usual_radius(radii: &[f64], sizes: &Sizes, skin: f64) -> f64 {
    if is_one_level(sizes, skin) {
        return sizes.largest_radius;
    }
    let mut levels = [(0, 0.0_f64); LEVELS];
    for &radius in radii {
        let (count, largest) = &mut levels[level_of(radius, sizes)];
        (*count, *largest) = (*count + 1, largest.max(radius));
    }
    let mut before = 0;
    let median = levels.iter().find(|(count, _)| {
        before += count;
        2 * before >= radii.len()
    });
    median.map_or(sizes.largest_radius, |(_, largest)| *largest)
}

/// Whether cells for the largest discs are so little wider than for the mean one, so that few more are looked at
/// in one level than in several.
fn is_one_level(sizes: &Sizes, skin: f64) -> bool {
    2.0 * sizes.largest_radius + skin <= 1.5 * (2.0 * sizes.mean_radius + skin)
}

/// Levels there are at most; larger discs than that are in the last.
const LEVELS: usize = 64;

/// How many times a radius, m, can be halved before it is below twice the smallest.
fn level_of(radius: f64, sizes: &Sizes) -> usize {
    let times = radius / sizes.smallest_radius;
    if times < 2.0 || times.is_nan() {
        return 0;
    }
    // The exponent of a number in [1, infinity].
    ((times.to_bits() >> 52) as usize - 1023).min(LEVELS - 1)
}
