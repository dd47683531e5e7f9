//! Fields: forces that hang on a disc alone, on where it is and when.

use glam::DVec2;

use crate::particle::Particle;

/// A force on each disc by itself: of place, velocity, size and time.
///
/// A pure function, so that any thread may ask.
pub trait Field: Send + Sync {
    /// The force on `disc`, which has this `id`, at `time` (s), N.
    fn force(&self, disc: &Particle, id: u32, time: f64) -> DVec2;

    /// The energy that the disc has in it, J; nothing for a field that supplies energy, or takes it.
    fn stored_energy(&self, _disc: &Particle, _id: u32, _time: f64) -> Option<f64> {
        None
    }
}
