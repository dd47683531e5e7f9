//! The ways in which a run can go wrong, each with the check that finds it and the discs that it names. Which of them a
//! guard looks for is the scenario's choice.

use glam::DVec2;

use super::memory::Memory;
use crate::analysis::energy::MechanicalEnergy;
use crate::named::named;
use crate::neighbours::Neighbours;
use crate::particle::{Contact, Particle};
use crate::simulation::Simulation;
use crate::work::Works;

/// Two discs have crossed once their overlap is this fraction of the sum of their radii: their centres
/// have met, or passed within a twentieth of that.
pub const CROSSED: f64 = 0.95;

/// A disc overlaps a wall by so many radii: its centre is four radii beyond.
pub const BEYOND: f64 = 5.0;

/// The energy, with or without what damping took, has grown by this fraction of what could have moved
/// the discs, and stays so from one look to the next: inside a contact a coarse step may err by as
/// much for a moment.
pub const GROWTH: f64 = 1.0;

/// Sums of energies are trusted to this fraction.
const ROUNDING: f64 = 1e-9;

named! {
    /// In what way a run has gone wrong.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Wrong, name {
        /// A number is infinite or none at all.
        NotFinite = "not-finite",
        /// The centres of two discs have met: [`CROSSED`].
        Crossed = "crossed",
        /// A disc overlaps a wall by more than [`BEYOND`] radii.
        BeyondWall = "beyond-wall",
        /// The energy has grown by more than [`GROWTH`].
        EnergyGrown = "energy-grown",
    }
}

/// Ids of the discs in question, the wall, and the deepest overlap over the (smaller) radius.
type Whom = (Vec<usize>, Option<&'static str>, f64);

impl Wrong {
    /// Whether a run has gone wrong in this way.
    pub(super) fn is_so(self, look: &Look) -> bool {
        match self {
            Self::NotFinite => !look.mechanical.is_finite() || !look.total.is_finite(),
            Self::Crossed => look.simulation.largest_sinking() >= CROSSED,
            Self::BeyondWall => look.simulation.largest_wall_overlap() > BEYOND,
            Self::EnergyGrown => look.mechanical.max(look.total) > look.most(),
        }
    }

    /// Who has gone wrong in this way.
    pub(super) fn whom(self, particles: &[Particle], side: Option<f64>) -> Whom {
        match self {
            Self::Crossed => deepest_pair(particles),
            Self::BeyondWall => deepest_at_wall(particles, side),
            Self::NotFinite | Self::EnergyGrown => {
                let disc = fastest(particles);
                let (at_wall, wall, overlap) = deepest_at_wall(&particles[disc..=disc], side);
                let wall = wall.filter(|_| !at_wall.is_empty() && overlap > 0.0);
                (vec![disc], wall, overlap.max(0.0))
            }
        }
    }
}

/// What a guard sees of the present state.
pub(super) struct Look<'a> {
    simulation: &'a Simulation,
    side: Option<f64>, // m
    memory: &'a Memory,
    now: MechanicalEnergy, // J
    /// Without what was supplied from outside, which is not held against the run.
    mechanical: f64, // J
    /// The same with what the dashpots took.
    total: f64, // J
}

impl<'a> Look<'a> {
    pub fn at(simulation: &'a Simulation, side: Option<f64>, memory: &'a Memory) -> Self {
        let now = MechanicalEnergy::of(simulation);
        let mechanical = now.total() - (simulation.supplied() - memory.supplied);
        let total = mechanical + dissipated(simulation).unwrap_or(0.0);
        Self { simulation, side, memory, now, mechanical, total }
    }

    /// The largest energy that is still right, J. Without walls gravity goes on giving.
    fn most(&self) -> f64 {
        let (start, now) = (&self.memory.start, &self.now);
        let fallen = match self.side {
            Some(_) => 0.0,
            None => (start.gravitational - now.gravitational).max(0.0),
        };
        let sizes = now.kinetic + now.gravitational.abs() + start.gravitational.abs();
        start.total() + GROWTH * (self.memory.movable + fallen) + ROUNDING * sizes
    }
}

/// What the dashpots took, J, where a ledger is kept.
pub(super) fn dissipated(simulation: &Simulation) -> Option<f64> {
    simulation.works().map(Works::dissipated)
}

/// The fastest disc; one whose speed is no number comes first.
fn fastest(particles: &[Particle]) -> usize {
    let speed = |disc: &Particle| disc.velocity.length_squared();
    let sick =
        particles.iter().position(|disc| !disc.position.is_finite() || !speed(disc).is_finite());
    let fastest = || {
        let by_speed = |&a: &usize, &b: &usize| {
            speed(&particles[a]).total_cmp(&speed(&particles[b])).then(b.cmp(&a))
        };
        (0..particles.len()).max_by(by_speed).unwrap_or(0)
    };
    sick.unwrap_or_else(fastest)
}

fn deepest_pair(particles: &[Particle]) -> Whom {
    let mut neighbours = Neighbours::default();
    neighbours.refresh(particles);
    let mut deepest = (Vec::new(), None, 0.0);
    for (i, j) in neighbours.pairs() {
        let (a, b) = (&particles[i], &particles[j]);
        if let Some(contact) = Contact::between(a, b) {
            let overlap = contact.overlap / a.radius.min(b.radius);
            if overlap > deepest.2 {
                deepest = (vec![i, j], None, overlap);
            }
        }
    }
    deepest
}

fn deepest_at_wall(discs: &[Particle], side: Option<f64>) -> Whom {
    let mut deepest = (Vec::new(), None, 0.0);
    let Some(side) = side else { return deepest };
    for (id, disc) in discs.iter().enumerate() {
        let DVec2 { x, y } = disc.position;
        let walls = [("left", x), ("right", side - x), ("lower", y), ("upper", side - y)];
        for (wall, distance) in walls {
            let overlap = 1.0 - distance / disc.radius;
            if overlap > deepest.2 {
                deepest = (vec![id], Some(wall), overlap);
            }
        }
    }
    deepest
}
