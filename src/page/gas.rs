//! Whether the discs of a run are a gas in equilibrium, of whose speeds Maxwell's distribution tells.

use std::f64::consts::PI;

use crate::analysis::energy::LedgerRow;
use crate::scenario::Scenario;

/// Fewer discs than this are no gas: their energy swings by more than 10 % from one to the next.
pub const FEWEST_DISCS: usize = 50;
/// Damping may take so much of the mean kinetic energy. A gas that cools has tails of its own.
const LOST: f64 = 0.1;
/// The mean kinetic energies of the first and the last fifth of the run differ by less than this.
const CHANGED: f64 = 0.15;
/// Each disc must have met so many others: after a few collisions a distribution has relaxed.
const FEWEST_MEETINGS: f64 = 5.0;

/// Why Maxwell's distribution says nothing of the speeds of a run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum NoGas {
    /// There are too few discs.
    Few,
    /// They have different masses, and at one temperature each mass has a distribution of its own.
    Unlike,
    /// No walls hold them together.
    Open,
    /// There is no ledger to tell the rest by.
    Unknown,
    /// Nothing moves.
    Still,
    /// Damping took much of the energy: the discs cool down, or settle.
    Cooling,
    /// Their kinetic energy changed, as it does in a fall.
    Unsteady,
    /// They hardly met.
    Sparse,
}

/// Why the discs of `scenario`, which left the ledger `rows`, are no gas in equilibrium; nothing if they
/// are one.
pub fn no_gas(scenario: &Scenario, rows: &[LedgerRow]) -> Option<NoGas> {
    let (lightest, heaviest) = scenario.mass_range();
    if scenario.n() < FEWEST_DISCS {
        return Some(NoGas::Few);
    }
    if lightest < heaviest {
        return Some(NoGas::Unlike);
    }
    if !scenario.walls {
        return Some(NoGas::Open);
    }
    let [Some(first), Some(last)] = [rows.first(), rows.last()] else {
        return Some(NoGas::Unknown);
    };
    let fifth = rows.len().div_ceil(5);
    let kinetic = kinetic(rows);
    let [begin, end] = [&rows[..fifth], &rows[rows.len() - fifth..]].map(self::kinetic);
    // Also false of what is no number.
    if !(kinetic > 0.0 && kinetic.is_finite()) {
        return Some(NoGas::Still);
    }
    if (last.dissipated_J - first.dissipated_J) > LOST * kinetic {
        return Some(NoGas::Cooling);
    }
    if (begin - end).abs() > CHANGED * kinetic {
        return Some(NoGas::Unsteady);
    }
    let meetings = meetings_per_second(scenario, kinetic) * (last.time_s - first.time_s);
    (meetings < FEWEST_MEETINGS).then_some(NoGas::Sparse)
}

/// Mean kinetic energy of the lines, J.
fn kinetic(rows: &[LedgerRow]) -> f64 {
    rows.iter().map(|row| row.kinetic_J).sum::<f64>() / rows.len() as f64
}

/// How often a disc meets another, 1/s: 2 sqrt(pi) (n/A) d sqrt(kT/m) for discs of diameter d in the
/// area A, with the `kinetic` energy n kT (Chapman and Cowling 1970, in two dimensions).
fn meetings_per_second(scenario: &Scenario, kinetic: f64) -> f64 {
    let n = scenario.n() as f64;
    let diameter = 2.0 * scenario.radius_range().0;
    let thermal_speed = (kinetic / (n * scenario.mass_range().0)).sqrt();
    2.0 * PI.sqrt() * n / scenario.side.powi(2) * diameter * thermal_speed
}
