//! Discs sorted by cells that suit their size, and who lies around whom.

use std::ops::Range;

use glam::DVec2;

use super::cells::{Grid, sort_by_key};
use super::sizes::{Extents, Sizes};
use super::workers::Workers;

/// Discs of about one size, sorted by cells so wide that two near ones are in cells that touch.
pub(super) struct Level {
    grid: Grid,
    /// The cells of its discs, ascending.
    keys: Vec<u64>,
    /// Where these discs are stored; none if they are all there are, in the order in which they are stored.
    places: Option<Vec<u32>>,
}

/// Discs of a level that follow each other.
pub(super) enum Run<'a> {
    /// Stored one after the other.
    Stored(Range<usize>),
    /// Stored at these places.
    At(&'a [u32]),
}

impl Run<'_> {
    /// How many there are.
    pub fn count(&self) -> usize {
        match self {
            Self::Stored(places) => places.len(),
            Self::At(places) => places.len(),
        }
    }

    /// Tells `of` where each is stored, where it is and its radius (m).
    #[inline(always)]
    pub fn each(self, discs: Extents, mut of: impl FnMut(usize, DVec2, f64)) {
        match self {
            Self::Stored(places) => {
                let here = discs.phases[places.clone()].iter().zip(&discs.radii[places.clone()]);
                for (place, (p, radius)) in places.zip(here) {
                    of(place, p.position(), *radius);
                }
            }
            Self::At(places) => {
                for &place in places {
                    let (position, radius) = discs.at(place as usize);
                    of(place as usize, position, radius);
                }
            }
        }
    }
}

impl Level {
    /// All discs as one level of near pairs within `skin` (m) of touching.
    pub fn of_all(discs: Extents, sizes: &Sizes, skin: f64, workers: &Workers) -> Self {
        let grid = Grid::new(sizes, 2.0 * sizes.largest_radius + skin);
        let keys = grid.keys(discs.phases, workers);
        Self { grid, keys, places: None }.sorted()
    }

    fn sorted(mut self) -> Self {
        if !self.keys.is_sorted() {
            let keys = &self.keys;
            let mut order: Vec<u32> = (0..keys.len() as u32).collect();
            sort_by_key(&mut order, |k| keys[*k as usize]);
            self.places = Some(match &self.places {
                None => order.clone(),
                Some(places) => order.iter().map(|&k| places[k as usize]).collect(),
            });
            self.keys = order.iter().map(|&k| keys[k as usize]).collect();
        }
        self
    }

    /// Number of discs.
    pub fn count(&self) -> usize {
        self.keys.len()
    }

    /// Whether they are all there are, in the order in which they are stored.
    pub fn is_as_stored(&self) -> bool {
        self.places.is_none()
    }

    /// Where a disc of it is stored.
    pub fn place(&self, disc: usize) -> usize {
        self.places.as_ref().map_or(disc, |places| places[disc] as usize)
    }

    fn run(&self, discs: Range<usize>) -> Run<'_> {
        match &self.places {
            None => Run::Stored(discs),
            Some(places) => Run::At(&places[discs]),
        }
    }

    /// Tells `of`, for each of `discs`, which follow it in cells that touch its own: two runs.
    #[inline(always)]
    pub fn each_ahead(&self, discs: Range<usize>, mut of: impl FnMut(usize, [Run<'_>; 2])) {
        let Some(&first) = self.keys.get(discs.start) else { return };
        let row = self.grid.row;
        let from = |key: u64| self.keys.partition_point(|other| *other < key);
        let [mut right, mut above, mut end] =
            [first + 2, first + row - 1, first + row + 2].map(from);
        let go_to = |at: &mut usize, key: u64| {
            while self.keys.get(*at).is_some_and(|other| *other < key) {
                *at += 1;
            }
        };
        for (disc, &key) in discs.clone().zip(&self.keys[discs]) {
            go_to(&mut right, key + 2);
            go_to(&mut above, key + row - 1);
            go_to(&mut end, key + row + 2);
            of(disc, [self.run(disc + 1..right), self.run(above..end)]);
        }
    }

    /// Those in the cell of `position` and in cells that touch it: three runs. `around` keeps what was
    /// found last.
    pub fn around<'a>(&'a self, position: DVec2, around: &mut Around) -> [Run<'a>; 3] {
        let key = self.grid.key(position);
        if around.key != key {
            let from = |key: u64| self.keys.partition_point(|other| *other < key);
            let run = |key: u64| [from(key - 1), from(key + 2)];
            let row = self.grid.row;
            *around = Around { key, runs: [key - row, key, key + row].map(run) };
        }
        around.runs.map(|[start, end]| self.run(start..end))
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
/// large ones.
pub(super) fn levels(discs: Extents, sizes: &Sizes, skin: f64, workers: &Workers) -> Vec<Level> {
    if is_one_level(sizes, skin) {
        return vec![Level::of_all(discs, sizes, skin, workers)];
    }
    let mut members = vec![Vec::new(); LEVELS];
    for (place, radius) in (0..).zip(discs.radii) {
        members[level_of(*radius, sizes)].push(place);
    }
    let level = |places: Vec<u32>| {
        let discs = || places.iter().map(|&place| discs.at(place as usize));
        let largest_radius = discs().map(|(_, radius)| radius).fold(0.0, f64::max);
        let grid = Grid::new(sizes, 2.0 * largest_radius + skin);
        let keys = discs().map(|(position, _)| grid.key(position)).collect();
        Level { grid, keys, places: Some(places) }.sorted()
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
