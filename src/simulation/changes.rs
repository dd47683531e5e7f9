//! What may be changed between two steps.

use glam::DVec2;

use super::Simulation;
use crate::particle::ContactLaw;

impl Simulation {
    /// Discs fall by `gravity` (m/s2) from now on. The energy that gives is booked as given by hand. A checkpoint holds no
    /// gravity: who goes on from it says it again.
    ///
    /// ```
    /// use glam::DVec2;
    /// use parsim2d::scenario::Scenario;
    /// let disc = "gravity = 0\n[[disc]]\nposition = [0.02, 0.02]";
    /// let mut run = Scenario::from_toml(disc).unwrap().build().unwrap();
    /// run.set_gravity(DVec2::new(0.0, -9.81));
    /// run.step();
    /// assert!((run.particles()[0].velocity.y + 9.81 * run.dt()).abs() < 1e-18); // v = g t
    /// ```
    pub fn set_gravity(&mut self, gravity: DVec2) {
        self.discs.set_gravity(gravity);
    }

    /// Discs touch by `law` from now on, at walls too. Forces follow the change, as in [`act`](Self::act), and the energy it
    /// gives is booked as given by hand. A checkpoint holds no law.
    ///
    /// # Errors
    ///
    /// The law itself, if it is not of the type of the present one; nothing is changed then.
    pub fn set_law<L: ContactLaw + 'static>(&mut self, law: L) -> Result<(), L> {
        let mut law = Some(law);
        self.discs.set_law(&mut law);
        law.map_or(Ok(()), Err)
    }
}
