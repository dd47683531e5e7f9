//! Contact laws in four lanes.

use super::lanes::Lanes;
use crate::particle::{ContactLaw, Damping, Particle, SpringDashpot};

/// Four contacts as a contact law sees them, lane by lane; see [`Contact`](crate::particle::Contact).
#[derive(Clone, Copy)]
pub struct ContactLanes<'a, V> {
    /// Overlaps, m.
    pub overlap: V,
    /// Approach speeds, m/s.
    pub approach_speed: V,
    /// The four first and the four second discs.
    pub(super) discs: [[&'a Particle; 4]; 2],
}

impl<V: Lanes> ContactLanes<'_, V> {
    /// Reduced masses, kg.
    #[inline(always)]
    pub fn reduced_mass(&self) -> V {
        let masses =
            |[a, b, c, d]: [&Particle; 4]| self.overlap.of([a.mass, b.mass, c.mass, d.mass]);
        let (a, b) = (masses(self.discs[0]), masses(self.discs[1]));
        a * b / (a + b)
    }
}

/// A contact law that can be asked about four contacts at a time. Each lane must have the bits that
/// [`ContactLaw`] gives for it alone; `tests/same_bits.rs` holds crowds to that.
pub trait LaneLaw: ContactLaw {
    /// [`ContactLaw::push`] of all four, N.
    fn pushes<V: Lanes>(&self, contacts: &ContactLanes<V>) -> V;
    /// [`ContactLaw::spring`] of all four, N.
    fn springs<V: Lanes>(&self, contacts: &ContactLanes<V>) -> V;
}

impl LaneLaw for SpringDashpot {
    #[inline(always)]
    fn pushes<V: Lanes>(&self, contacts: &ContactLanes<V>) -> V {
        let all = |number| contacts.overlap.all(number);
        let stiffness = all(self.stiffness);
        let eta = match self.damping {
            Damping::Coefficient(eta) => all(eta),
            Damping::Rate(gamma) => contacts.reduced_mass() * all(gamma),
            Damping::Ratio(zeta) => all(2.0 * zeta) * (stiffness * contacts.reduced_mass()).sqrt(),
        };
        let push = stiffness * contacts.overlap + eta * contacts.approach_speed;
        if self.tension { push } else { push.or_zero() }
    }

    #[inline(always)]
    fn springs<V: Lanes>(&self, contacts: &ContactLanes<V>) -> V {
        contacts.overlap.all(self.stiffness) * contacts.overlap
    }
}
