//! What closed forms know of a contact law: the spring and the dashpot that it is for small changes of a contact.

use glam::DVec2;

pub use crate::particle::Linear;
use crate::particle::{Contact, ContactLaw};

/// The overlap at which laws are linearised, in radii, unless a contact is at hand.
pub const USUAL_OVERLAP: f64 = 0.01;

/// What `law` is about a contact at rest of bodies of this reduced mass (kg), of which the smaller has this `radius` (m).
pub fn linear(law: &impl ContactLaw, radius: f64, reduced_mass: f64) -> Linear {
    let overlap = USUAL_OVERLAP * radius;
    law.linearised(&Contact { overlap, normal: DVec2::X, approach_speed: 0.0, reduced_mass })
}
