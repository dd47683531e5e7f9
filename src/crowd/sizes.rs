//! How large, how fast and how far away discs are.

use super::BLOCK;
use super::team::Team;
use crate::particle::Particle;

/// What is to be known of all discs before their near pairs are listed.
///
/// Summed block by block, so that it does not depend on the number of threads.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Sizes {
    pub largest_radius: f64, // m
    pub mean_radius: f64,    // m
    /// The areas of all discs together, m2.
    pub areas: f64,
    /// The highest speed, m/s.
    pub fastest: f64,
    /// The largest coordinate, whatever its sign, m.
    pub farthest: f64,
}

impl Sizes {
    /// Looks at all discs.
    pub fn of(particles: &[Particle], team: &Team) -> Self {
        let mut blocks = vec![Self::default(); particles.len().div_ceil(BLOCK)];
        team.pieces(&mut blocks, |first, blocks| {
            let discs = particles[first * BLOCK..].chunks(BLOCK);
            blocks.iter_mut().zip(discs).for_each(|(block, discs)| *block = Self::sums(discs));
        });
        let mut all = blocks.iter().fold(Self::default(), Self::and);
        all.mean_radius /= particles.len().max(1) as f64;
        all.areas *= std::f64::consts::PI;
        all.fastest = all.fastest.sqrt();
        all
    }

    /// Sums in the place of means, areas over pi, and speeds squared.
    fn sums(discs: &[Particle]) -> Self {
        discs.iter().fold(Self::default(), |sums, p| {
            let one = Self {
                largest_radius: p.radius,
                mean_radius: p.radius,
                areas: p.radius * p.radius,
                fastest: p.velocity.length_squared(),
                farthest: p.position.abs().max_element(),
            };
            sums.and(&one)
        })
    }

    fn and(self, other: &Self) -> Self {
        Self {
            largest_radius: self.largest_radius.max(other.largest_radius),
            mean_radius: self.mean_radius + other.mean_radius,
            areas: self.areas + other.areas,
            fastest: self.fastest.max(other.fastest),
            farthest: self.farthest.max(other.farthest),
        }
    }
}

#[cfg(test)]
mod tests {
    use glam::DVec2;

    use super::*;

    #[test]
    fn sizes_are_those_of_all_discs_on_any_number_of_threads() {
        // More than two blocks, and a part of one.
        let mut discs: Vec<_> = (0..2 * BLOCK + 3)
            .map(|k| Particle::at_rest(DVec2::new(-(k as f64), 1.0), 1.0 + (k % 2) as f64, 1.0))
            .collect();
        discs[200].velocity = DVec2::new(3.0, -4.0);
        let alone = Sizes::of(&discs, &Team::of(1));
        let n = discs.len() as f64;
        assert_eq!((alone.largest_radius, alone.fastest, alone.farthest), (2.0, 5.0, n - 1.0));
        // 130 discs of radius 1, 129 of radius 2: sums of small whole numbers are exact.
        assert_eq!(alone.mean_radius, (130.0 + 2.0 * 129.0) / n);
        assert_eq!(alone.areas, (130.0 + 4.0 * 129.0) * std::f64::consts::PI);
        for threads in [2, 3, 8] {
            assert_eq!(Sizes::of(&discs, &Team::of(threads)), alone, "{threads} threads");
        }
    }

    #[test]
    fn of_no_discs_all_is_zero() {
        assert_eq!(Sizes::of(&[], &Team::of(2)), Sizes::default());
    }
}
