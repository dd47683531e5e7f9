//! The numbers of the discs of a frame, no two of which may be the same.

use std::collections::HashSet;

/// The ids of a frame so far.
#[derive(Debug, Default)]
pub struct Ids(HashSet<u64>);

impl Ids {
    /// Adds one; says whether it is new.
    pub fn add(&mut self, id: u64) -> bool {
        self.0.insert(id)
    }

    /// The first of `ids` that came before, and its place among them.
    pub fn repeated(ids: impl Iterator<Item = Option<u64>>) -> Option<(usize, u64)> {
        let mut seen = Self::default();
        ids.enumerate().find_map(|(k, id)| id.filter(|id| !seen.add(*id)).map(|id| (k, id)))
    }
}
