//! What can be read off a simulation or told beforehand: energies, closed forms, limits.

pub mod collision;
pub mod energy;
pub mod guard;
pub mod stability;
