//! Forces that are no contacts: with them begins the sum of each disc's forces.

use glam::DVec2;

use std::sync::Arc;

use crate::field::Field;
use crate::force::Force;

/// What a disc's sum of forces begins with.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Start {
    /// Weight and added forces, N.
    pub force: DVec2,
    /// The part of the added ones that stores energy, N.
    pub spring: DVec2,
    /// The part of them that does not, N.
    pub field: DVec2,
}

/// Forces that are no contacts, and what they do to each disc as it is stored.
#[derive(Default)]
pub(super) struct Added {
    pub fields: Vec<Arc<dyn Field>>,
    pub forces: Vec<Box<dyn Force>>,
    pub starts: Vec<Start>,
    /// Energy stored in them, J.
    pub stored_energy: f64,
}

impl Added {
    /// What the sums begin with; empty if that is the weight.
    pub fn starts(&self) -> &[Start] {
        &self.starts
    }
}
