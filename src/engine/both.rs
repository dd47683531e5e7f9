//! Both sides of a pair, next to each other.

/// Both sides of a pair, aligned so that no store of one crosses a line of the cache.
#[derive(Clone, Copy, Default)]
#[repr(C, align(32))]
pub struct Both<T>(pub(super) T);
