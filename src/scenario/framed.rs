//! The discs of a frame, kept in little memory: a run keeps them to its end, for what it may have to say.

use glam::DVec2;

use crate::particle::Particle;

/// The discs of a frame, in its order. What all have in common is kept once.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FramedDiscs {
    positions: Vec<DVec2>,  // m
    velocities: Numbers<2>, // m/s
    sizes: Numbers<1>,      // radius, m
    masses: Numbers<1>,     // kg
}

impl FramedDiscs {
    /// Number of discs.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// The discs one after the other.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Particle> + Clone {
        self.positions.iter().enumerate().map(|(k, position)| {
            let ([radius], [mass]) = (self.sizes.of(k), self.masses.of(k));
            let mut disc = Particle::at_rest(*position, radius, mass);
            disc.velocity = DVec2::from_array(self.velocities.of(k));
            disc
        })
    }
}

impl FromIterator<Particle> for FramedDiscs {
    fn from_iter<I: IntoIterator<Item = Particle>>(discs: I) -> Self {
        let mut framed = Self::default();
        for disc in discs {
            let before = framed.len();
            framed.positions.push(disc.position);
            framed.velocities.add(disc.velocity.to_array(), before);
            framed.sizes.add([disc.radius], before);
            framed.masses.add([disc.mass], before);
        }
        framed
    }
}

/// Numbers of each disc; of the first only, as long as all are the same to the bit.
#[derive(Clone, Debug, Default, PartialEq)]
struct Numbers<const N: usize>(Vec<[f64; N]>);

impl<const N: usize> Numbers<N> {
    fn of(&self, k: usize) -> [f64; N] {
        if self.0.len() == 1 { self.0[0] } else { self.0[k] }
    }

    /// Adds those of the disc that comes after `before` others.
    fn add(&mut self, numbers: [f64; N], before: usize) {
        match self.0[..] {
            [all] if all.map(f64::to_bits) == numbers.map(f64::to_bits) => return,
            [all] => self.0.resize(before, all),
            _ => {}
        }
        self.0.push(numbers);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn discs_come_back_as_they_were_whatever_they_have_in_common() {
        let disc = |k: usize, same: [bool; 3]| {
            let of = |which: usize| if same[which] { 1.0 } else { 1.0 + k as f64 };
            let mut disc = Particle::at_rest(DVec2::splat(k as f64), of(0), of(1));
            // Two zeros that are equal, and not the same.
            disc.velocity.x = if same[2] || k < 2 { 0.0 } else { -0.0 };
            disc
        };
        for case in 0..8 {
            let same = [0, 1, 2].map(|bit| case >> bit & 1 == 1);
            for n in 0..5 {
                let discs: Vec<Particle> = (0..n).map(|k| disc(k, same)).collect();
                let framed: FramedDiscs = discs.iter().copied().collect();
                let back: Vec<Particle> = framed.iter().collect();
                assert_eq!(format!("{back:?}"), format!("{discs:?}"), "{n} discs, {same:?}");
                assert_eq!((framed.len(), framed.is_empty()), (n, n == 0));
                let sizes = if same[0] { n.min(1) } else { n };
                assert_eq!(framed.sizes.0.len(), sizes);
            }
        }
    }
}
