//! A refusal: why, and a way out.

/// Why a command was not begun, and what can be done.
#[derive(Debug, thiserror::Error)]
#[error("{why}\n  way out: {way_out}")]
pub(super) struct Refusal {
    pub why: String,
    pub way_out: String,
}
