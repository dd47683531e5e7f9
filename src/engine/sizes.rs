//! How large, how fast and where discs are.

use glam::DVec2;

use super::block::BLOCK;
use super::phase::Phase;
use super::workers::Workers;

/// Discs looked at to learn where most of them are.
const SAMPLE: usize = 256;

/// Where discs are, as they are stored, and how far each acts on its like.
#[derive(Clone, Copy)]
pub(super) struct Extents<'a> {
    pub phases: &'a [Phase],
    /// Half of the distance of centres up to which it does, m: its radius, or more.
    pub radii: &'a [f64],
}

impl Extents<'_> {
    /// Number of discs.
    pub fn count(&self) -> usize {
        self.phases.len()
    }

    /// Where the disc at this place is (m), and its radius (m).
    #[inline(always)]
    pub fn at(&self, place: usize) -> (DVec2, f64) {
        (self.phases[place].position(), self.radii[place])
    }
}

/// What is to be known of all discs before their near pairs are listed.
///
/// Summed block by block, so that it does not depend on the number of threads.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Sizes {
    pub smallest_radius: f64, // m
    pub largest_radius: f64,  // m
    pub mean_radius: f64,     // m
    /// The areas of all discs together, m2.
    pub areas: f64,
    /// The highest speed, m/s.
    pub fastest: f64,
    /// The corners of where discs are that are somewhere, m.
    pub low: DVec2,
    pub high: DVec2,
    /// The corners of where the middle half of them is, in x and in y, m.
    pub middle: [DVec2; 2],
    /// The fraction of the ground that discs cover there.
    pub density: f64,
}

impl Sizes {
    /// Looks at all discs.
    pub fn of(discs: Extents, ids: &[u32], workers: &Workers) -> Self {
        let mut blocks = vec![Self::of_none(); discs.count().div_ceil(BLOCK)];
        workers.pieces(&mut blocks, |first, blocks| {
            let phases = discs.phases[first * BLOCK..].chunks(BLOCK);
            let radii = discs.radii[first * BLOCK..].chunks(BLOCK);
            for (block, (phases, radii)) in blocks.iter_mut().zip(phases.zip(radii)) {
                *block = Self::sums(Extents { phases, radii });
            }
        });
        let mut all = blocks.iter().fold(Self::of_none(), Self::and);
        all.mean_radius /= discs.count().max(1) as f64;
        all.areas *= std::f64::consts::PI;
        all.fastest = all.fastest.sqrt();
        all.look_at_the_middle(discs.phases, ids);
        all
    }

    fn of_none() -> Self {
        Self {
            smallest_radius: f64::INFINITY,
            largest_radius: 0.0,
            mean_radius: 0.0,
            areas: 0.0,
            fastest: 0.0,
            low: DVec2::INFINITY,
            high: DVec2::NEG_INFINITY,
            middle: [DVec2::ZERO; 2],
            density: 1.0,
        }
    }

    /// Sums in the place of means, areas over pi, and speeds squared.
    fn sums(discs: Extents) -> Self {
        let mut sums = Self::of_none();
        for (p, &radius) in discs.phases.iter().zip(discs.radii) {
            sums.smallest_radius = sums.smallest_radius.min(radius);
            sums.largest_radius = sums.largest_radius.max(radius);
            sums.mean_radius += radius;
            sums.areas += radius * radius;
            sums.fastest = sums.fastest.max(p.velocity().length_squared());
            let position = p.position();
            if position.is_finite() {
                (sums.low, sums.high) = (sums.low.min(position), sums.high.max(position));
            }
        }
        sums
    }

    fn and(self, other: &Self) -> Self {
        Self {
            smallest_radius: self.smallest_radius.min(other.smallest_radius),
            largest_radius: self.largest_radius.max(other.largest_radius),
            mean_radius: self.mean_radius + other.mean_radius,
            areas: self.areas + other.areas,
            fastest: self.fastest.max(other.fastest),
            low: self.low.min(other.low),
            high: self.high.max(other.high),
            ..self
        }
    }

    /// From a sample: a few discs far away must not count. It is drawn by a hash of the ids, since every so
    /// many'th disc may be one column of a bed, and is always of the same discs, so that what follows from it
    /// does not change from list to list.
    fn look_at_the_middle(&mut self, phases: &[Phase], ids: &[u32]) {
        let drawn = u64::MAX / phases.len().div_ceil(SAMPLE).max(1) as u64;
        let sample: Vec<DVec2> = ids
            .iter()
            .zip(phases)
            .filter(|(id, p)| hash(u64::from(**id)) <= drawn && p.position().is_finite())
            .map(|(_, p)| p.position())
            .collect();
        let [x, y] = [0, 1].map(|axis| quartiles(sample.iter().map(|position| position[axis])));
        let [low, high] = [DVec2::new(x[0], y[0]), DVec2::new(x[1], y[1])];
        let is_inside = |at: &&DVec2| low.cmple(**at).all() && at.cmple(high).all();
        let inside = sample.iter().filter(is_inside).count() as f64 / sample.len().max(1) as f64;
        let density = self.areas * inside / (high - low).element_product();
        self.middle = [low, high];
        self.density = if density > 1e-3 { density.min(1.0) } else { 1e-3 };
    }
}

/// The quarter that is above a quarter of the values and the one below a quarter of them.
fn quartiles(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let mut values: Vec<f64> = values.collect();
    let Some(last) = values.len().checked_sub(1) else { return [0.0; 2] };
    [last / 4, last - last / 4].map(|k| *values.select_nth_unstable_by(k, f64::total_cmp).1)
}

/// A number that looks drawn at random (the last step of splitmix64, Steele, Lea and Flood 2014).
pub(super) fn hash(number: u64) -> u64 {
    let z = (number + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Discs at these positions, at rest and of these radii.
    fn sizes_of(phases: &[Phase], radii: &[f64], threads: usize) -> Sizes {
        let ids: Vec<u32> = (0..phases.len() as u32).collect();
        Sizes::of(Extents { phases, radii }, &ids, &Workers::of(threads))
    }

    fn at_rest(position: DVec2) -> Phase {
        Phase::new(position, DVec2::ZERO)
    }

    #[test]
    fn sizes_are_those_of_all_discs_on_any_number_of_threads() {
        // More than two blocks, and a part of one.
        let places = (0..2 * BLOCK + 3).map(|k| DVec2::new(-(k as f64), 1.0));
        let mut discs: Vec<_> = places.map(at_rest).collect();
        let radii: Vec<_> = (0..discs.len()).map(|k| 1.0 + (k % 2) as f64).collect();
        discs[200] = Phase::new(discs[200].position(), DVec2::new(3.0, -4.0));
        discs[201] = at_rest(DVec2::NAN);
        let alone = sizes_of(&discs, &radii, 1);
        let n = discs.len() as f64;
        assert_eq!((alone.smallest_radius, alone.largest_radius, alone.fastest), (1.0, 2.0, 5.0));
        assert_eq!((alone.low, alone.high), (DVec2::new(1.0 - n, 1.0), DVec2::new(0.0, 1.0)));
        // 130 discs of radius 1, 129 of radius 2: sums of small whole numbers are exact.
        assert_eq!(alone.mean_radius, (130.0 + 2.0 * 129.0) / n);
        assert_eq!(alone.areas, (130.0 + 4.0 * 129.0) * std::f64::consts::PI);
        for threads in [2, 3, 8] {
            assert_eq!(sizes_of(&discs, &radii, threads), alone, "{threads} threads");
        }
    }

    #[test]
    fn the_middle_of_rows_of_1000_is_half_as_wide_and_half_as_high_as_all() {
        let row = |k: usize| DVec2::new((k % 1000) as f64, (k / 1000) as f64);
        let mut discs: Vec<_> = (0..100_000).map(|k| at_rest(row(k))).collect();
        discs[77] = at_rest(DVec2::splat(1e9));
        let sizes = sizes_of(&discs, &vec![0.25; discs.len()], 1);
        let [width, height] = (sizes.middle[1] - sizes.middle[0]).to_array();
        // A quartile of 256 drawn numbers scatters by 3 %; both ends, and three times that, are 12 %.
        assert!((width / 500.0 - 1.0).abs() < 0.24, "{width}");
        assert!((height / 50.0 - 1.0).abs() < 0.24, "{height}");
        // Five standard deviations of how many of 256 fall into a quarter are 14 % of it; and the box's.
        let covered = std::f64::consts::PI * 0.25 * 0.25;
        assert!((sizes.density / covered - 1.0).abs() < 0.5, "{}", sizes.density);
    }

    #[test]
    fn of_no_discs_there_is_nothing() {
        let sizes = sizes_of(&[], &[], 2);
        assert_eq!((sizes.largest_radius, sizes.mean_radius, sizes.fastest), (0.0, 0.0, 0.0));
    }
}
