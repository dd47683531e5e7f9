//! What closed forms know of a contact law: the spring and the dashpot that it is for small changes of a contact.

use glam::DVec2;

use crate::particle::{Contact, SpringDashpot};

/// The overlap at which laws are linearised, in radii, unless a contact is at hand.
pub const USUAL_OVERLAP: f64 = 0.01;

/// A contact law for small changes about a contact: push = (there) + stiffness d(overlap) + damping d(approach speed).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linear {
    /// How much harder the bodies push for each metre that they are deeper in each other.
    pub stiffness: f64, // N/m
    /// How much harder for each m/s that they approach faster.
    pub damping: f64, // kg/s
}

/// What `law` is about `contact`.
pub fn linear_contact(law: &SpringDashpot, contact: &Contact) -> Linear {
    let damping = law.damping.coefficient(law.stiffness, contact.reduced_mass);
    Linear { stiffness: law.stiffness, damping }
}

/// What `law` is about a contact at rest of bodies of this reduced mass (kg), of which the smaller has this `radius` (m).
pub fn linear(law: &SpringDashpot, radius: f64, reduced_mass: f64) -> Linear {
    let overlap = USUAL_OVERLAP * radius;
    linear_contact(law, &Contact { overlap, normal: DVec2::X, approach_speed: 0.0, reduced_mass })
}
