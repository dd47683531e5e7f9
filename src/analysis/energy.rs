//! The energy ledger: where the energy is, and two residues that must not be confused.
//!
//! - `total = kinetic + gravitational + elastic + dissipated - supplied`. The first three are read off the
//!   present state, then comes what the dashpots took, and what was supplied from outside: by added forces
//!   that store nothing (drag takes, so it supplies less than nothing), and by hand. Its change since the start is the
//!   *integration error*: it says whether the time step is right. For Eq. (3) it is O(dt) while
//!   a contact lasts and O(dt²) after it; in free fall it is -m g v dt/2, a saw-tooth in step
//!   with the speed that comes back at the bounce, not a drift. Velocity Verlet has O(dt²) in both.
//!   With a dashpot the O(dt) stays after the contact, whichever of the two steps.
//! - `work_error = (K - K0) - (sum of works)`, each work F . (v + v')/2 dt gathered at its kick.
//!   A kick changes K by exactly that much, so this closes to *round-off* at any time step. It
//!   says whether the bookkeeping is right, and nothing about accuracy: a run that explodes
//!   closes too.
//!
//! Why the two differ: the work a spring does along the discs' discrete path is not exactly the
//! energy k_n delta_n²/2 it had stored; that difference is the first residue.
//!
//! Dissipated energy is minus the dashpots' work, where "dashpot" is all of the contact force but
//! k_n delta_n. With `--no-tension` the contact ends with some overlap left; the clipped force then
//! unloads the spring for nothing, and that too is counted as dissipated.

use serde::{Deserialize, Serialize};

use crate::particle::Particle;
use crate::simulation::Simulation;

/// Mechanical energy of a state, J.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MechanicalEnergy {
    /// Sum of m v²/2.
    pub kinetic: f64,
    /// Sum of -m g . x, zero at the origin: m g y where gravity points down.
    pub gravitational: f64,
    /// Sum of k_n delta_n²/2 over all contacts, and what other forces store.
    pub elastic: f64,
}

impl MechanicalEnergy {
    /// The energy of the present state.
    pub fn of(simulation: &Simulation) -> Self {
        let gravity = simulation.gravity();
        Self {
            kinetic: simulation.sum_over(Particle::kinetic_energy),
            gravitational: simulation.sum_over(|p| -p.mass * gravity.dot(p.position)),
            elastic: simulation.stored_energy(),
        }
    }

    /// The sum of the three, J.
    pub fn total(&self) -> f64 {
        self.kinetic + self.gravitational + self.elastic
    }
}

/// One line of the ledger; the fields are the columns of `energy.csv`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[allow(non_snake_case)] // a column's name ends with its unit
pub struct LedgerRow {
    /// Steps done.
    pub step: u64,
    /// Simulated time, s.
    pub time_s: f64,
    /// Kinetic energy, J.
    pub kinetic_J: f64,
    /// Gravitational energy, J.
    pub gravitational_J: f64,
    /// Elastic energy, J.
    pub elastic_J: f64,
    /// Energy taken by the dashpots since the start, J.
    pub dissipated_J: f64,
    /// Sum of the four less what was supplied, J. Its change is the integration error.
    pub total_J: f64,
    /// Change of kinetic energy minus the sum of all works, J. Round-off, if all is well.
    pub work_error_J: f64,
    /// Energy supplied from outside since the start, J; 0 where only weight and contacts act.
    #[serde(default)] // older ledgers have no such column
    pub supplied_J: f64,
}

/// The ledger of one run.
pub struct EnergyLedger {
    kinetic_at_start: f64, // J
}

impl EnergyLedger {
    /// Opens the ledger: from now on the simulation books its works.
    pub fn open(simulation: &mut Simulation) -> Self {
        simulation.keep_work_ledger();
        Self { kinetic_at_start: simulation.sum_over(Particle::kinetic_energy) }
    }

    /// A ledger of a run that goes on: the simulation has its works, the discs had this kinetic energy
    /// (J) when the ledger was opened.
    pub fn continued(kinetic_at_start: f64) -> Self {
        Self { kinetic_at_start }
    }

    /// Kinetic energy when the ledger was opened, J.
    pub fn kinetic_at_start(&self) -> f64 {
        self.kinetic_at_start
    }

    /// The ledger's line for the present state.
    pub fn row(&self, simulation: &Simulation) -> LedgerRow {
        let energy = MechanicalEnergy::of(simulation);
        let works = simulation.works().copied().unwrap_or_default();
        let (dissipated, supplied) = (works.dissipated(), works.supplied());
        LedgerRow {
            step: simulation.steps(),
            time_s: simulation.time(),
            kinetic_J: energy.kinetic,
            gravitational_J: energy.gravitational,
            elastic_J: energy.elastic,
            dissipated_J: dissipated,
            total_J: energy.total() + dissipated - supplied,
            work_error_J: (energy.kinetic - self.kinetic_at_start) - works.total(),
            supplied_J: supplied,
        }
    }
}
