//! Discs sorted by cells that suit their size, and who lies around whom.

use std::ops::Range;

use glam::DVec2;

use super::cells::{Grid, InCells, MARGIN};
use super::phase::Phase;
use super::sizes::{Extents, Sizes};

/// Discs of about one size, sorted by cells so wide that two near ones are in cells that touch.
pub(super) struct Level {
    cells: InCells,
    /// The largest radius, m.
    pub largest_radius: f64,
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
    /// Those of `discs` that are stored at these `places`, the largest of this radius (m), in cells for a `skin` (m).
    /// Discs may be `stored` in cells of the same grid.
    fn of_some(
        discs: Extents,
        places: &[u32],
        largest_radius: f64,
        (sizes, skin): (&Sizes, f64),
        stored: Option<&InCells>,
    ) -> Self {
        let grid = Grid::new(sizes, 2.0 * largest_radius + skin);
        let keys: Vec<u64> = match stored {
            Some(cells) if cells.grid == grid => {
                places.iter().map(|&place| cells.keys[place as usize]).collect()
            }
            _ => {
                let position = |&place: &u32| discs.phases[place as usize].position();
                places.iter().map(|place| grid.key(position(place))).collect()
            }
        };
        let (order, starts) = grid.sort(&keys);
        let keys = order.iter().map(|&k| keys[k as usize]).collect();
        let places: Vec<u32> = order.into_iter().map(|k| places[k as usize]).collect();
        let phases = places.iter().map(|&place| discs.phases[place as usize]).collect();
        let radii = places.iter().map(|&place| discs.radii[place as usize]).collect();
        let sorted = Some(Sorted { places, phases, radii });
        Self { cells: InCells { grid, keys, starts }, largest_radius, sorted }
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
        let ends =
            |key: u64| [key + 2, key + self.cells.grid.row - 1, key + self.cells.grid.row + 2];
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

    /// Those less than `reach` (m) from `position`, and others about them: a run for each row of cells.
    pub fn within(&self, reach: f64, position: DVec2) -> impl Iterator<Item = Range<usize>> {
        let around = DVec2::splat(reach * (1.0 + MARGIN));
        let [low, high] = [position - around, position + around].map(|at| self.cells.grid.key(at));
        let row = self.cells.grid.row;
        let columns = high % row - low % row;
        let keys = (0..=high / row - low / row).map(move |above| low + above * row);
        keys.map(move |key| self.start(key)..self.start(key + columns + 1))
    }

    /// Whether near pairs with discs of a `coarser` level are found faster from there, within a `skin` (m): each of those goes
    /// through the rows of cells that it covers here, and finds none within itself; each of these through three rows there.
    pub fn is_found_from(&self, coarser: &Self, skin: f64) -> bool {
        let reach = coarser.largest_radius + skin + self.largest_radius;
        let rows = 2.0 * reach / (2.0 * self.largest_radius + skin) + 2.0;
        rows * (coarser.count() as f64) < 3.0 * self.count() as f64
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
) -> Vec<Level> {
    let of_some = |places: &[u32], largest_radius: f64, stored: Option<&InCells>| {
        Level::of_some(discs, places, largest_radius, (sizes, skin), stored)
    };
    if is_one_level(sizes, skin) {
        let largest_radius = sizes.largest_radius;
        return vec![match stored {
            Some(cells) => Level { cells, largest_radius, sorted: None },
            None => of_some(&Vec::from_iter(0..discs.count() as u32), largest_radius, None),
        }];
    }
    let mut members = vec![(Vec::new(), 0.0_f64); LEVELS];
    for (place, &radius) in (0..).zip(discs.radii) {
        let (places, largest) = &mut members[level_of(radius, sizes)];
        places.push(place);
        *largest = largest.max(radius);
    }
    members.retain(|(places, _)| !places.is_empty());
    members.iter().map(|(places, largest)| of_some(places, *largest, stored.as_ref())).collect()
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
