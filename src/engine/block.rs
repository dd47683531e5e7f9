//! Blocks of discs as they are stored.

/// Discs in a block: what is moved, walked or summed in one go. Sums are kept block by block and then
/// added in order, so that they do not depend on who did which.
pub(super) const BLOCK: usize = 128;
