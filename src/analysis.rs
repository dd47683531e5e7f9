//! What can be read off a simulation or told beforehand: energies, their drift, closed forms,
//! limits.

pub mod answer;
pub mod bounce;
pub mod collision;
pub mod drift;
pub mod energy;
pub mod guard;
pub mod line;
pub mod linear;
pub mod stability;
pub mod twin;
