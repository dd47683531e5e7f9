//! Contact laws in two lanes.

use wide::{CmpGt, f64x2};

use crate::particle::{ContactLaw, Damping, Particle, SpringDashpot};

/// Two contacts as a contact law sees them, lane by lane; see [`Contact`](crate::particle::Contact).
#[derive(Clone, Copy)]
pub struct ContactLanes<'a> {
    /// Overlaps, m.
    pub overlap: f64x2,
    /// Approach speeds, m/s.
    pub approach_speed: f64x2,
    /// The two first and the two second discs.
    pub(super) discs: [[&'a Particle; 2]; 2],
}

impl ContactLanes<'_> {
    /// Reduced masses, kg.
    #[inline(always)]
    pub fn reduced_mass(&self) -> f64x2 {
        let [a, b] = self.discs.map(|[one, two]| f64x2::new([one.mass, two.mass]));
        a * b / (a + b)
    }
}

/// A contact law that can be asked about two contacts at a time. Each lane must have the bits that
/// [`ContactLaw`] gives for it alone; `tests/same_bits.rs` holds crowds to that.
pub trait LaneLaw: ContactLaw {
    /// [`ContactLaw::push`] of both, N.
    fn pushes(&self, contacts: &ContactLanes) -> f64x2;
    /// [`ContactLaw::spring`] of both, N.
    fn springs(&self, contacts: &ContactLanes) -> f64x2;
}

impl LaneLaw for SpringDashpot {
    #[inline(always)]
    fn pushes(&self, contacts: &ContactLanes) -> f64x2 {
        let stiffness = f64x2::splat(self.stiffness);
        let eta = match self.damping {
            Damping::Coefficient(eta) => f64x2::splat(eta),
            Damping::Rate(gamma) => contacts.reduced_mass() * f64x2::splat(gamma),
            Damping::Ratio(zeta) => {
                f64x2::splat(2.0 * zeta) * (stiffness * contacts.reduced_mass()).sqrt()
            }
        };
        let push = stiffness * contacts.overlap + eta * contacts.approach_speed;
        if self.tension { push } else { push.cmp_gt(f64x2::ZERO) & push }
    }

    #[inline(always)]
    fn springs(&self, contacts: &ContactLanes) -> f64x2 {
        f64x2::splat(self.stiffness) * contacts.overlap
    }
}
