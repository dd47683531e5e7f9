//! Who may touch whom: a cell grid that fills a list of near pairs, behind one iterator.
//!
//! The list (Verlet 1967) holds every pair closer than touching plus a *skin*. It stays good
//! until some disc has moved half a skin; then the grid makes a new one. Pairs come in
//! lexicographic order, i < j, so neither grid nor skin changes one bit of the forces.

use glam::DVec2;

use crate::particle::Particle;

/// Lists shorter-lived than this many steps get a wider skin, longer-lived ones than four times
/// this a narrower one. A matter of speed only.
const WANTED_LIFE: u32 = 25;
/// More near pairs than this per disc cost more to walk than a new list costs to make.
const MOST_PAIRS_PER_DISC: usize = 6;
/// Bounds of the skin, in smallest radii.
const SKIN: std::ops::RangeInclusive<f64> = 0.1..=20.0;

/// The near pairs of a set of discs, kept up to date.
#[derive(Default)]
pub struct Neighbours {
    pairs: Vec<[u32; 2]>,
    grid: CellGrid,
    listed_at: Vec<(DVec2, f64)>, // m, where each disc was when the list was made, its radius
    skin: f64,                    // m
    life: u32,                    // steps that the present list has served
}

impl Neighbours {
    /// All pairs (i, j) with i < j that may touch, in lexicographic order.
    pub fn pairs(&self) -> impl Iterator<Item = (usize, usize)> + '_ {
        self.pairs.iter().map(|&[i, j]| (i as usize, j as usize))
    }

    /// Makes a new list if discs have moved too far for the present one.
    pub fn refresh(&mut self, particles: &[Particle]) {
        if self.is_good_for(particles) {
            self.life = self.life.saturating_add(1);
            return;
        }
        self.choose_skin(particles);
        self.grid.fill(particles, self.skin);
        self.pairs.clear();
        self.grid.append_pairs(particles, self.skin, &mut self.pairs);
        self.listed_at.clear();
        self.listed_at.extend(particles.iter().map(|p| (p.position, p.radius)));
        self.life = 0;
    }

    /// Two discs that were a skin apart can only touch once they have moved a skin between them,
    /// or grown. A disc whose position is no number any more touches nobody.
    fn is_good_for(&self, particles: &[Particle]) -> bool {
        let limit = 0.499 * self.skin; // a little less than half, for rounding
        self.listed_at.len() == particles.len()
            && particles.iter().zip(&self.listed_at).all(|(p, &(then, radius))| {
                let moved_squared = p.position.distance_squared(then);
                let is_near = moved_squared <= limit * limit || !p.position.is_finite();
                is_near && p.radius <= radius
            })
    }

    /// The skin follows what the last list taught: how long it served and how many pairs it had.
    fn choose_skin(&mut self, particles: &[Particle]) {
        // Of the smallest: a giant's would hold thousands of small discs near each other.
        let radius = smallest_radius(particles);
        if self.listed_at.len() != particles.len() {
            self.skin = 0.5 * radius;
        } else if self.pairs.len() > MOST_PAIRS_PER_DISC * particles.len() {
            self.skin *= 0.7;
        } else if self.life < WANTED_LIFE {
            self.skin *= 1.5;
        } else if self.life > 4 * WANTED_LIFE {
            self.skin *= 0.8;
        }
        self.skin = self.skin.clamp(SKIN.start() * radius, SKIN.end() * radius);
    }
}

/// Every pair i < j, in lexicographic order: slow and plainly right. Tests hold the grid to it.
pub fn all_pairs(n: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..n).flat_map(move |i| (i + 1..n).map(move |j| (i, j)))
}

/// The largest radius, m; 0 without discs.
pub fn largest_radius(particles: &[Particle]) -> f64 {
    particles.iter().map(|p| p.radius).fold(0.0, f64::max)
}

fn smallest_radius(particles: &[Particle]) -> f64 {
    particles.iter().map(|p| p.radius).fold(f64::INFINITY, f64::min)
}

/// Square cells, each with the ids of the discs whose centres lie in it. Discs outside the grid
/// belong to its nearest cell, so that every disc is somewhere and close ones stay close.
#[derive(Default)]
struct CellGrid {
    corner: DVec2, // m
    cell: f64,     // m
    columns: usize,
    rows: usize,
    starts: Vec<u32>, // where each cell's ids begin in `ids`
    ids: Vec<u32>,
}

impl CellGrid {
    /// Sorts the discs into cells.
    fn fill(&mut self, particles: &[Particle], skin: f64) {
        self.lay_out(particles, 2.0 * smallest_radius(particles) + skin);
        self.starts.clear();
        self.starts.resize(self.columns * self.rows + 1, 0);
        // A disc whose position is no number touches nobody.
        for p in particles.iter().filter(|p| p.position.is_finite()) {
            let cell = self.cell_of(p.position);
            self.starts[cell] += 1;
        }
        let mut end = 0;
        for start in &mut self.starts {
            end += *start;
            *start = end;
        }
        self.ids.resize(particles.len(), 0);
        let finite = particles.iter().enumerate().filter(|(_, p)| p.position.is_finite());
        for (id, p) in finite.rev() {
            let cell = self.cell_of(p.position);
            self.starts[cell] -= 1;
            self.ids[self.starts[cell] as usize] = id as u32;
        }
    }

    /// Covers where the discs are, with cells no smaller than `least` (m) and at most about one a disc. The outermost
    /// hundredth on each side does not count: one disc far away must not make every cell huge.
    fn lay_out(&mut self, particles: &[Particle], least: f64) {
        let (left, right) = middle_range(particles.iter().map(|p| p.position.x));
        let (low, high) = middle_range(particles.iter().map(|p| p.position.y));
        let (width, height) = (right - left, high - low);
        let area_per_disc = width * height / particles.len().max(1) as f64;
        let longest_row = width.max(height) / particles.len().max(1) as f64;
        self.corner = DVec2::new(left, low);
        self.cell = least.max(area_per_disc.sqrt()).max(longest_row);
        let cells_along = |length: f64| ((length / self.cell).max(0.0) as usize).max(1);
        self.columns = cells_along(width);
        self.rows = cells_along(height);
    }

    fn column_and_row(&self, position: DVec2) -> (usize, usize) {
        let cell = (position - self.corner) / self.cell;
        // `as` sends negative numbers and NaN to 0 and large ones to the last cell.
        let column = (cell.x as usize).min(self.columns - 1);
        let row = (cell.y as usize).min(self.rows - 1);
        (column, row)
    }

    fn cell_of(&self, position: DVec2) -> usize {
        let (column, row) = self.column_and_row(position);
        row * self.columns + column
    }

    /// Adds all pairs closer than touching plus `skin`, in lexicographic order.
    ///
    /// A disc looks for those that are smaller, or as large and of higher id, so no farther than for its like. A giant looks
    /// over many cells, but small discs never over its: discs that do not lie in each other look over each cell a few times.
    fn append_pairs(&self, particles: &[Particle], skin: f64, pairs: &mut Vec<[u32; 2]>) {
        let smallest = smallest_radius(particles);
        for (i, p) in (0..).zip(particles).filter(|(_, p)| p.position.is_finite()) {
            let lowest_id = if p.radius > smallest { 0 } else { i + 1 };
            let reach = DVec2::splat((2.0 * p.radius + skin) * (1.0 + 1e-9)); // a hair more, for rounding
            let (left, low) = self.column_and_row(p.position - reach);
            let (right, high) = self.column_and_row(p.position + reach);
            let first = pairs.len();
            for row in low..=high {
                // The cells of one row lie side by side in `ids`: one run for all of them.
                let (leftmost, rightmost) = (row * self.columns + left, row * self.columns + right);
                let run = self.starts[leftmost] as usize..self.starts[rightmost + 1] as usize;
                for &j in self.ids[run].iter().filter(|id| **id >= lowest_id) {
                    let q = &particles[j as usize];
                    let is_less = q.radius < p.radius || q.radius == p.radius && j > i;
                    if is_less && is_near(p, q, skin) {
                        pairs.push([i.min(j), i.max(j)]);
                    }
                }
            }
            pairs[first..].sort_unstable();
        }
        pairs.sort(); // no work where all are of one size
    }
}

fn is_near(a: &Particle, b: &Particle, skin: f64) -> bool {
    let reach = a.radius + b.radius + skin;
    a.position.distance_squared(b.position) < reach * reach
}

/// The range of the finite values without the lowest and highest hundredth.
fn middle_range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    let mut values: Vec<f64> = values.filter(|value| value.is_finite()).collect();
    let Some(last) = values.len().checked_sub(1) else {
        return (0.0, 0.0);
    };
    let margin = last / 100;
    let (_, &mut low, rest) = values.select_nth_unstable_by(margin, f64::total_cmp);
    if rest.is_empty() {
        return (low, low);
    }
    let (_, &mut high, _) = rest.select_nth_unstable_by(last - 2 * margin - 1, f64::total_cmp);
    (low, high)
}
