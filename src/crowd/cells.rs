//! Square cells, each named by a key, and discs sorted by them.
//!
//! There is no table of cells: what is kept is the sorted keys of the discs. A few discs far away cost a
//! few digits of the keys, and no cell becomes larger by them.

use std::ops::Range;

use glam::{DVec2, Vec2Swizzles};

use super::sizes::Sizes;
use super::team::Team;
use crate::particle::Particle;

/// Cells on either side of the middle of the discs, at most; what lies beyond is in the last ones. Numbers
/// of up to 31 bits leave 22 of a position for where in its cell a disc is.
const CELLS_AROUND: f64 = (1_u64 << 30) as f64;

/// Cells are wider than asked for by this much, for the rounding of those 22 bits.
const MARGIN: f64 = 1e-5;

/// Bits by which discs are sorted at a time: the counts of so many digits stay in the nearest memory.
const DIGIT: u32 = 11;

/// Square cells over all discs. Keys ascend along the shorter side of where most discs are, so that
/// neighbours in the next row lie near in memory.
#[derive(Clone, Copy)]
pub(super) struct Grid {
    corner: DVec2, // m
    per_metre: f64,
    /// If the shorter side is upright, x and y are exchanged here.
    is_upright: bool,
    last_column: u64,
    last_row: u64,
    /// From a key to that of the cell above it. Beyond the last column there is one that is always empty.
    row: u64,
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
        let column = (cell.x as u64).min(self.last_column) + 1;
        ((cell.y as u64).min(self.last_row) + 1) * self.row + column
    }

    /// The cells of discs.
    fn keys(&self, particles: &[Particle], team: &Team) -> Vec<u64> {
        let mut keys = vec![0; particles.len()];
        team.pieces(&mut keys, |first, keys| {
            keys.iter_mut()
                .zip(&particles[first..])
                .for_each(|(key, p)| *key = self.key(p.position));
        });
        keys
    }

    /// The order in which discs are to be stored: for each place, where its disc is now. Discs of a cell
    /// follow each other by id, so that two at exactly one place are always the same first and second of
    /// their contact.
    pub fn order(&self, particles: &[Particle], ids: &[u32], team: &Team) -> Vec<u32> {
        let keys = self.keys(particles, team);
        let key = |now: u32| keys[now as usize];
        let mut order: Vec<u32> = (0..particles.len() as u32).collect();
        sort_by_key(&mut order, |now| key(*now));
        for cell in order.chunk_by_mut(|a, b| key(*a) == key(*b)).filter(|cell| cell.len() > 1) {
            cell.sort_unstable_by_key(|&now| ids[now as usize]);
        }
        order
    }
}

/// Sorts by `key`, the equal ones in the order in which they come: digit by digit, the lowest first.
pub(super) fn sort_by_key<T: Copy>(items: &mut Vec<T>, key: impl Fn(&T) -> u64) {
    let highest = items.iter().map(&key).max().unwrap_or(0);
    let lowest = items.iter().map(&key).min().unwrap_or(0);
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

    /// Tells `of` where each is stored, and itself.
    #[inline(always)]
    pub fn each(self, particles: &[Particle], mut of: impl FnMut(usize, &Particle)) {
        match self {
            Self::Stored(places) => {
                for (place, p) in places.clone().zip(&particles[places]) {
                    of(place, p);
                }
            }
            Self::At(places) => {
                for &place in places {
                    of(place as usize, &particles[place as usize]);
                }
            }
        }
    }
}

impl Level {
    /// All discs as one level of near pairs within `skin` (m) of touching.
    pub fn of_all(particles: &[Particle], sizes: &Sizes, skin: f64, team: &Team) -> Self {
        let largest_radius = sizes.largest_radius;
        let grid = Grid::new(sizes, 2.0 * largest_radius + skin);
        let keys = grid.keys(particles, team);
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
pub(super) fn levels(particles: &[Particle], sizes: &Sizes, skin: f64, team: &Team) -> Vec<Level> {
    if level_of(sizes.largest_radius, sizes) == 0 {
        return vec![Level::of_all(particles, sizes, skin, team)];
    }
    let mut members = vec![Vec::new(); LEVELS];
    for (place, p) in (0..).zip(particles) {
        members[level_of(p.radius, sizes)].push(place);
    }
    let level = |places: Vec<u32>| {
        let discs = || places.iter().map(|&place| &particles[place as usize]);
        let largest_radius = discs().map(|p| p.radius).fold(0.0, f64::max);
        let grid = Grid::new(sizes, 2.0 * largest_radius + skin);
        let keys = discs().map(|p| grid.key(p.position)).collect();
        Level { grid, keys, places: Some(places) }.sorted()
    };
    members.into_iter().filter(|places| !places.is_empty()).map(level).collect()
}

/// The largest radius, m, of those of the median disc's level: what cells of the order of storage follow.
pub(super) fn usual_radius(particles: &[Particle], sizes: &Sizes) -> f64 {
    if level_of(sizes.largest_radius, sizes) == 0 {
        return sizes.largest_radius;
    }
    let mut levels = [(0, 0.0_f64); LEVELS];
    for p in particles {
        let (count, largest) = &mut levels[level_of(p.radius, sizes)];
        (*count, *largest) = (*count + 1, largest.max(p.radius));
    }
    let mut before = 0;
    let median = levels.iter().find(|(count, _)| {
        before += count;
        2 * before >= particles.len()
    });
    median.map_or(sizes.largest_radius, |(_, largest)| *largest)
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
