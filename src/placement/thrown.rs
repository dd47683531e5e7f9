//! Velocities at the start: random directions, a given rms speed, and no momentum of the whole.

use glam::DVec2;
use rand_pcg::Pcg64;

use super::direction;
use crate::particle::Particle;

/// Gives `discs` velocities in random directions of the rms `speed` (m/s), each disc counted once. Of two or
/// more the common motion is taken out, m-weighted, before they are scaled to that speed: their momentum
/// is nothing but rounding. One disc alone keeps its momentum, for it has no other motion.
///
/// ```
/// use glam::DVec2;
/// use parsim2d::particle::Particle;
/// use parsim2d::placement::{generator, thrown::throw};
/// let mut discs = vec![Particle::at_rest(DVec2::ZERO, 1e-4, 1e-3); 20];
/// throw(&mut discs, 0.5, &mut generator(7)); // m/s
/// let mean_square = discs.iter().map(|p| p.velocity.length_squared()).sum::<f64>() / 20.0;
/// let momentum: DVec2 = discs.iter().map(|p| p.mass * p.velocity).sum();
/// assert!((mean_square - 0.25).abs() < 1e-15 && momentum.length() < 1e-17);
/// ```
pub fn throw(discs: &mut [Particle], speed: f64, generator: &mut Pcg64) {
    loop {
        discs.iter_mut().for_each(|disc| disc.velocity = direction(generator));
        if let [one] = discs {
            one.velocity *= speed;
            return;
        }
        let mass: f64 = discs.iter().map(|disc| disc.mass).sum();
        let common = discs.iter().map(|disc| disc.mass * disc.velocity).sum::<DVec2>() / mass;
        discs.iter_mut().for_each(|disc| disc.velocity -= common);
        let square: f64 = discs.iter().map(|disc| disc.velocity.length_squared()).sum();
        let rms = (square / discs.len() as f64).sqrt();
        // Two that were thrown the same way have next to nothing left: they are thrown again.
        if rms > 0.01 || discs.is_empty() {
            let scale = speed / rms;
            discs.iter_mut().for_each(|disc| disc.velocity *= scale);
            return;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::placement::generator;

    #[test]
    fn discs_of_any_masses_have_the_speed_and_no_momentum() {
        for n in [2, 3, 20, 1000] {
            for seed in 0..20 {
                let mass = |k: usize| 1e-3 * (1.0 + (k * k % 7) as f64);
                let mut discs: Vec<Particle> =
                    (0..n).map(|k| Particle::at_rest(DVec2::ZERO, 1e-4, mass(k))).collect();
                throw(&mut discs, 0.3, &mut generator(seed));
                let square: f64 = discs.iter().map(|disc| disc.velocity.length_squared()).sum();
                let momentum: DVec2 = discs.iter().map(|disc| disc.mass * disc.velocity).sum();
                let sizes: f64 = discs.iter().map(|p| p.mass * p.velocity.length()).sum();
                // Rounding of n sums, and of a scale that is at most 100.
                assert!(((square / n as f64).sqrt() / 0.3 - 1.0).abs() < 1e-12, "{n}, seed {seed}");
                assert!(momentum.length() < 1e-13 * sizes, "{n}, seed {seed}: {momentum}");
            }
        }
    }

    #[test]
    fn one_disc_is_thrown_and_keeps_its_momentum() {
        let mut disc = [Particle::at_rest(DVec2::ZERO, 1e-4, 1e-3)];
        throw(&mut disc, 0.3, &mut generator(1));
        assert!((disc[0].velocity.length() / 0.3 - 1.0).abs() < 1e-15);
        throw(&mut [], 0.3, &mut generator(1));
    }
}
