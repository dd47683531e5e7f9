//! The seam between the sweep over near pairs and what acts in them.
//!
//! A [`PairLaw`] says how two discs push each other, one pair at a time; whatever it is, it is swept by all threads, each
//! pair once, and adds up in one order. Contacts by a [`ContactLaw`] are one of them, and go through the lean
//! walk of the [engine](crate::engine).

use glam::DVec2;

use crate::boundary::Boundary;
use crate::particle::{Contact, ContactLaw, Particle};

/// A disc as a pair law sees it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    /// Its id.
    pub id: u32,
    /// Which kind of disc it is; 0 where kinds are not told apart.
    pub kind: u32,
    /// Position of the centre, m; of the nearest image where space is periodic.
    pub position: DVec2,
    /// Velocity of the centre, m/s.
    pub velocity: DVec2,
    /// Radius, m.
    pub radius: f64,
    /// Mass, kg.
    pub mass: f64,
}

impl Body {
    /// The same as a particle, with no force on it.
    #[inline(always)]
    pub fn particle(&self) -> Particle {
        let mut particle = Particle::at_rest(self.position, self.radius, self.mass);
        particle.velocity = self.velocity;
        particle
    }
}

impl Boundary {
    /// Puts the nearest image of the second in its place.
    #[inline(always)]
    pub(crate) fn bring_near(&self, [i, j]: &mut [Body; 2]) {
        if !self.is_open() {
            j.position = self.nearest_image(i.position, j.position);
        }
    }
}

/// What two discs do to each other.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct PairForces {
    /// The force on each, N; the second need not be the first's opposite.
    pub on: [DVec2; 2],
    /// The part of it that can be had back as energy, N.
    pub conservative: [DVec2; 2],
    /// Energy stored between them, J.
    pub stored_energy: f64,
    /// How deep they have sunk into each other, m; 0 where that means nothing.
    pub overlap: f64,
}

/// How two discs act on each other: a pure function of both, and of one number that the pair may remember.
///
/// The first of the two is always the one of the lower id, so that a law that tells them apart has the same bits however
/// discs are stored.
pub trait PairLaw: Clone + Send + Sync + 'static {
    /// Whether pairs remember a number from step to step. It is 0 when a pair comes together, and again once it has
    /// parted.
    const HAS_MEMORY: bool = false;

    /// Half of the distance of centres up to which a disc of this size and kind acts on its like, m: two discs whose
    /// centres are farther apart than the sum of theirs do not act on each other.
    fn range(&self, radius: f64, kind: u32) -> f64;

    /// What the two do to each other; nothing where they are out of range.
    fn forces(&self, bodies: &[Body; 2], memory: f64) -> Option<PairForces>;

    /// What the pair remembers once `elapsed` seconds of drift lie between the last forces and these bodies. 0 s must
    /// change nothing: forces may be asked for twice.
    fn advance(&self, _bodies: &[Body; 2], memory: f64, _elapsed: f64) -> f64 {
        memory
    }
}

/// Contacts by `law`: central, with the opposite force on the other.
#[derive(Clone, Debug)]
pub struct Contacts<L> {
    /// The contact law.
    pub law: L,
}

impl<L: ContactLaw + Clone + Sync + 'static> PairLaw for Contacts<L> {
    fn range(&self, radius: f64, _kind: u32) -> f64 {
        radius
    }

    fn forces(&self, [i, j]: &[Body; 2], _memory: f64) -> Option<PairForces> {
        let contact = Contact::between(&i.particle(), &j.particle())?;
        let both = |size: f64| [-(size * contact.normal), size * contact.normal];
        Some(PairForces {
            on: both(self.law.push(&contact)),
            conservative: both(self.law.spring(&contact)),
            stored_energy: self.law.stored_energy(&contact),
            overlap: contact.overlap,
        })
    }
}
