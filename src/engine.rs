//! Many discs, fast: the same physics as [`PlainDiscs`](crate::simulation::PlainDiscs), to the
//! same bits, on any number of threads.
//!
//! What it does otherwise:
//! - Discs are stored cell by cell, so that those that touch lie close in memory too. Outside,
//!   everything is in id order.
//! - Each pair is computed once, contacts four at a time; each disc then adds up its own in ascending id of
//!   the partner, whoever computed them.
//! - Forces, kicks and drifts are put off until forces are asked for again, and then done in one pass over the
//!   discs, block by block.
//! - The pass is shared out to threads by blocks of discs.
//!
//! Why the bits are the same is told in `docs/same-bits.md`.

mod add_up;
mod added;
mod as_discs;
#[cfg(target_arch = "x86_64")]
mod avx2;
#[cfg(all(target_arch = "x86_64", has_avx512))]
mod avx512;
mod block;
mod block_pairs;
mod bodies;
mod both;
mod cells;
mod constants;
mod four_pairs;
mod group;
mod halo;
mod lanes;
mod largest;
mod lean_snapshot;
mod levels;
mod listing;
mod lookup;
mod moment;
mod moves;
mod neighbour_list;
mod pair_buffer;
mod pair_memory;
mod pairs;
mod phase;
mod runs;
mod set_up;
mod since;
mod sizes;
mod stepper;
mod sums;
mod sweep;
mod walk;
mod workers;

pub use self::pairs::{Interaction, Pairwise};
pub use self::stepper::Engine;
pub use crate::pair::{Body, Contacts, PairForces, PairLaw};

/// Fewer discs than this are stepped by one thread unless more are asked for: sharing a step out costs
/// some microseconds.
pub const WORTH_SHARING: usize = 4000;
