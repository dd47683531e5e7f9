//! n discs in a square box without overlap: at random or on a lattice.

pub mod thrown;

use glam::DVec2;
use rand::{Rng, SeedableRng};
use rand_pcg::Pcg64;
use thiserror::Error;

use crate::neighbours::largest_radius;
use crate::particle::Particle;

/// Packing fraction that random placement of a thousand equal discs or more reaches, measured: with the tries
/// below it places them at 0.53, and never at 0.54. Of few discs the walls leave less room. This is the number
/// that help, README and errors name.
pub const RANDOM_LIMIT: f64 = 0.53;

/// The same if there were no end to the tries and no walls: no room is left for another disc (Feder 1980;
/// Hinrichsen, Feder and Jossang 1986).
const SATURATION: f64 = 0.547;

/// Tries before random placement gives up: so many a disc, within bounds. Close to the limit
/// the free room shrinks with the square root of the tries (Feder 1980), so more would buy
/// little; 3000 a disc reaches [`RANDOM_LIMIT`] and takes a second per 1000 discs.
const TRIES_PER_DISC: u64 = 3_000;
const TRIES: std::ops::RangeInclusive<u64> = 1_000_000..=400_000_000;

/// How far placement came, in words.
fn progress(placed: usize, tried: u64) -> String {
    match tried {
        0 => "more than it can hold, so none was tried".to_owned(),
        _ => format!("{placed} placed after {tried} tries"),
    }
}

/// Why discs could not be placed.
#[derive(Debug, Error, PartialEq)]
pub enum PlacementError {
    /// Random placement found no more room.
    #[error(
        "the box is too full for random placement: {asked} discs asked, {}, packing fraction \
         {fraction:.3} asked (random placement ends near {RANDOM_LIMIT}, and before that for few discs)",
        progress(*placed, *tried)
    )]
    NoRoomAtRandom {
        /// Discs asked for.
        asked: usize,
        /// Discs placed.
        placed: usize,
        /// Positions tried.
        tried: u64,
        /// Area of all discs asked for over the area of the box.
        fraction: f64,
    },
    /// The lattice has too few sites.
    #[error(
        "the box is too small for {asked} discs: packing fraction {fraction:.3} asked, \
         the densest lattice in this box holds {sites} discs of this (largest) radius"
    )]
    NoRoomOnLattice {
        /// Discs asked for.
        asked: usize,
        /// Sites of the densest lattice that fits.
        sites: usize,
        /// Area of all discs asked for over the area of the box.
        fraction: f64,
    },
}

/// The random numbers of this program: PCG XSL RR 128/64 (O'Neill 2014), whose stream is fixed
/// by its name, on every machine and in every version.
pub fn generator(seed: u64) -> Pcg64 {
    Pcg64::seed_from_u64(seed)
}

/// A random number, uniform in [0, 1), from the generator's top 53 bits.
pub fn uniform(generator: &mut Pcg64) -> f64 {
    (generator.next_u64() >> 11) as f64 / (1u64 << 53) as f64
}

/// A random direction, uniform on the circle. No sine or cosine: those differ between platforms.
pub fn direction(generator: &mut Pcg64) -> DVec2 {
    loop {
        let point = 2.0 * DVec2::new(uniform(generator), uniform(generator)) - DVec2::ONE;
        let length_squared = point.length_squared();
        if length_squared <= 1.0 && length_squared > 1e-6 {
            return point / length_squared.sqrt();
        }
    }
}

/// Area of the discs over the area of the square of `side` (m).
pub fn packing_fraction(particles: &[Particle], side: f64) -> f64 {
    let area: f64 = particles.iter().map(|p| p.radius * p.radius).sum();
    std::f64::consts::PI * area / (side * side)
}

/// Puts all discs but the first `fixed`, which stay where they are, at random positions in the
/// square from the origin to (`side`, `side`) (m): uniform over the allowed region, no overlap
/// and no wall contact. The largest are placed first; ids keep their order.
pub fn at_random(
    particles: &mut [Particle],
    fixed: usize,
    side: f64,
    generator: &mut Pcg64,
) -> Result<(), PlacementError> {
    let asked = particles.len();
    let fraction = packing_fraction(particles, side);
    let to_place = packing_fraction(&particles[fixed..], side);
    let most_tries = most_tries(asked, to_place);
    let mut tried = 0;
    let mut grid = PlacedGrid::new(particles, side);
    (0..fixed).for_each(|id| grid.insert(id, particles[id]));

    let mut order: Vec<usize> = (fixed..asked).collect();
    order.sort_by(|&a, &b| particles[b].radius.total_cmp(&particles[a].radius));
    for (placed, &id) in order.iter().enumerate() {
        let radius = particles[id].radius;
        let room = side - 2.0 * radius;
        loop {
            if tried == most_tries || room <= 0.0 {
                let placed = fixed + placed;
                return Err(PlacementError::NoRoomAtRandom { asked, placed, tried, fraction });
            }
            tried += 1;
            let random = DVec2::new(uniform(generator), uniform(generator));
            let position = DVec2::splat(radius) + room * random;
            if grid.is_free(particles, position, radius) && clears_walls(position, radius, side) {
                particles[id].position = position;
                grid.insert(id, particles[id]);
                break;
            }
        }
    }
    Ok(())
}

fn most_tries(asked: usize, fraction: f64) -> u64 {
    if fraction >= 1.0 {
        return 0;
    }
    // Thousands of discs above the limit have no hope: a short search shows it.
    if asked >= 1000 && fraction > SATURATION + 0.02 {
        return TRIES.start().max(&(10 * asked as u64)).min(&20_000_000).to_owned();
    }
    (TRIES_PER_DISC * asked as u64).clamp(*TRIES.start(), *TRIES.end())
}

/// Rounding may put a centre a hair too close to a wall.
fn clears_walls(position: DVec2, radius: f64, side: f64) -> bool {
    position.min_element() >= radius && side - position.max_element() >= radius
}

/// Cells at least as wide as the smallest disc, each with a chain of those placed so far: of the discs whose centres lie in
/// it, and of wider ones that reach into it.
struct PlacedGrid {
    cell: f64, // m
    columns: usize,
    newest: Vec<u32>,       // link of each cell's chain
    links: Vec<(u32, u32)>, // a disc, and the link before it
}

const NOBODY: u32 = u32::MAX;

impl PlacedGrid {
    fn new(particles: &[Particle], side: f64) -> Self {
        let most_columns = 2.0 * (particles.len() as f64).sqrt() + 1.0;
        let smallest = particles.iter().map(|p| p.radius).fold(f64::INFINITY, f64::min);
        let cell = (2.0 * smallest).max(side / most_columns);
        let columns = ((side / cell) as usize).max(1);
        let links = Vec::with_capacity(particles.len());
        Self { cell, columns, newest: vec![NOBODY; columns * columns], links }
    }

    /// The cells less than `reach` (m) from `position`, along each axis.
    fn cells(&self, position: DVec2, reach: f64) -> impl Iterator<Item = usize> + use<> {
        let (columns, last) = (self.columns, self.columns as f64 - 1.0);
        let at = |place: DVec2| (place / self.cell).clamp(DVec2::ZERO, DVec2::splat(last));
        let [low, high] = [at(position - reach), at(position + reach)];
        let along = low.x as usize..=high.x as usize;
        let rows = low.y as usize..=high.y as usize;
        rows.flat_map(move |row| along.clone().map(move |column| row * columns + column))
    }

    fn insert(&mut self, id: usize, Particle { position, radius, .. }: Particle) {
        let is_wide = 2.0 * radius > self.cell;
        for cell in self.cells(position, if is_wide { radius } else { 0.0 }) {
            let link = self.links.len() as u32;
            let before = std::mem::replace(&mut self.newest[cell], link);
            self.links.push((id as u32, before));
        }
    }

    fn is_free(&self, particles: &[Particle], position: DVec2, radius: f64) -> bool {
        self.cells(position, radius + 0.5 * self.cell).all(|cell| {
            let mut link = self.newest[cell];
            while link != NOBODY {
                let (id, before) = self.links[link as usize];
                let other = &particles[id as usize];
                let reach = radius + other.radius;
                if position.distance_squared(other.position) <= reach * reach {
                    return false;
                }
                link = before;
            }
            true
        })
    }
}

/// Puts all discs on a lattice in the square from the origin to (`side`, `side`) (m): triangular
/// or square, whichever leaves more room, as wide as the box allows, each disc moved a little at
/// random within its free room. Surplus sites stay empty at random.
pub fn lattice(
    particles: &mut [Particle],
    side: f64,
    generator: &mut Pcg64,
) -> Result<(), PlacementError> {
    let radius = largest_radius(particles);
    let room = side - 2.0 * radius;
    let asked = particles.len();
    let kinds = [Lattice::Triangular, Lattice::Square];
    let spacings = kinds.map(|kind| kind.widest_spacing(asked, room));
    let (kind, spacing) =
        if spacings[0] >= spacings[1] { (kinds[0], spacings[0]) } else { (kinds[1], spacings[1]) };
    let gap = spacing - 2.0 * radius;
    if room < 0.0 || gap < 1e-6 * radius {
        let (sites, fraction) = (lattice_capacity(radius, side), packing_fraction(particles, side));
        return Err(PlacementError::NoRoomOnLattice { asked, sites, fraction });
    }
    // Less than half the gap each way: two neighbours moved towards each other do not touch.
    let jitter = 0.4 * gap.min(radius);
    let (mut to_place, mut sites_left) = (asked, kind.count(spacing, room));
    // The lattice rarely fills the box to the last hair: centre it.
    let extent = kind.sites(spacing, room).fold(DVec2::ZERO, DVec2::max);
    let corner = DVec2::splat(radius) + 0.5 * (DVec2::splat(room) - extent);
    let order = lattice_order(particles, generator);
    let mut next = order.into_iter();
    for site in kind.sites(spacing, room) {
        // Each site is taken with the chance that makes all choices equally likely (Knuth's S).
        let taken = uniform(generator) * (sites_left as f64) < to_place as f64;
        sites_left -= 1;
        if let Some(id) = taken.then(|| next.next()).flatten() {
            let particle = &mut particles[id];
            to_place -= 1;
            let moved = site + jitter * uniform(generator) * direction(generator);
            let edge = particle.radius * (1.0 + 1e-9); // a hair off the wall, for rounding
            let (low, high) = (DVec2::splat(edge), DVec2::splat(side - edge));
            particle.position = (corner + moved).clamp(low, high);
        }
    }
    Ok(())
}

/// The order in which discs take the sites: that of their ids, or a random one (Fisher and Yates)
/// if they differ, so that groups are mixed and do not lie in layers.
fn lattice_order(particles: &[Particle], generator: &mut Pcg64) -> Vec<usize> {
    let mut order: Vec<usize> = (0..particles.len()).collect();
    let like = |a: &Particle, b: &Particle| (a.radius, a.mass) == (b.radius, b.mass);
    if !particles.windows(2).all(|two| like(&two[0], &two[1])) {
        for last in (1..order.len()).rev() {
            order.swap(last, (uniform(generator) * (last + 1) as f64) as usize);
        }
    }
    order
}

/// How many discs of `radius` (m) the denser of the two lattices holds in a square of `side` (m).
///
/// ```
/// // The guide's larger discs, which must not touch: 46 staggered rows of 39.
/// assert_eq!(parsim2d::placement::lattice_capacity(5e-4, 0.04), 46 * 39);
/// assert_eq!(parsim2d::placement::lattice_capacity(1e-300, 1.0), usize::MAX); // more than can be said
/// ```
pub fn lattice_capacity(radius: f64, side: f64) -> usize {
    let (room, tight) = (side - 2.0 * radius, 2.0 * radius * (1.0 + 1e-6));
    if room < 0.0 {
        return 0;
    }
    [Lattice::Triangular, Lattice::Square]
        .map(|kind| kind.count(tight, room))
        .into_iter()
        .max()
        .unwrap_or(0)
}

#[derive(Clone, Copy)]
enum Lattice {
    Triangular,
    Square,
}

/// Sites of a row that begins at `left`.
fn columns(left: f64, spacing: f64, room: f64) -> usize {
    if left > room { 0 } else { (((room - left) / spacing) as usize).saturating_add(1) }
}

impl Lattice {
    /// From row to row, and how far every other row is shifted.
    fn rise_and_shift(self, spacing: f64) -> (f64, f64) {
        match self {
            Self::Triangular => (0.75f64.sqrt() * spacing, 0.5 * spacing),
            Self::Square => (spacing, 0.0),
        }
    }

    /// How many [`sites`](Self::sites) there are.
    fn count(self, spacing: f64, room: f64) -> usize {
        let (rise, shift) = self.rise_and_shift(spacing);
        let rows = ((room / rise) as usize).saturating_add(1);
        let of = |rows: usize, left: f64| rows.saturating_mul(columns(left, spacing, room));
        of(rows.div_ceil(2), 0.0).saturating_add(of(rows / 2, shift))
    }

    /// Sites `spacing` apart in a square of side `room`, row by row from the origin.
    fn sites(self, spacing: f64, room: f64) -> impl Iterator<Item = DVec2> {
        let (rise, shift) = self.rise_and_shift(spacing);
        let rows = (room / rise) as usize + 1;
        let row = move |k: usize| {
            let left = if k % 2 == 1 { shift } else { 0.0 };
            (0..columns(left, spacing, room))
                .map(move |c| DVec2::new(left + c as f64 * spacing, k as f64 * rise))
        };
        (0..rows).flat_map(row)
    }

    /// The widest spacing that still gives `n` sites, by bisection.
    fn widest_spacing(self, n: usize, room: f64) -> f64 {
        let (mut fits, mut too_wide) = (room / (2.0 * (n as f64).sqrt() + 2.0), 2.0 * room);
        if n == 1 {
            return f64::MAX; // the one site has all the room
        }
        for _ in 0..60 {
            let middle = 0.5 * (fits + too_wide);
            if self.count(middle, room) >= n {
                fits = middle;
            } else {
                too_wide = middle;
            }
        }
        fits
    }
}
