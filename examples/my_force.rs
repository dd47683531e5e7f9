//! My own force: discs that attract each other's common centre, like a bowl of elastic thread.
//!
//! A force is anything that adds to `particle.force` and says how much energy it stores; the
//! library is not touched. The energy test at the end is the reward for returning the right energy.
//!
//! Run it: cargo run --example my_force

use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, MechanicalEnergy};
use parsim2d::force::Force;
use parsim2d::particle::Particle;
use parsim2d::scenario::Scenario;

/// A spring from every disc to one point.
struct Bowl {
    centre: DVec2,  // m
    stiffness: f64, // N/m
}

impl Force for Bowl {
    fn apply(&mut self, particles: &mut [Particle]) -> f64 {
        let mut stored_energy = 0.0;
        for particle in particles {
            let stretch = particle.position - self.centre;
            particle.force -= self.stiffness * stretch;
            stored_energy += 0.5 * self.stiffness * stretch.length_squared();
        }
        stored_energy
    }
}

pub fn main() {
    let scenario = Scenario::from_toml("n = 50\nseed = 1\ngravity = 0\nrestitution = 1").unwrap();
    let mut simulation = scenario.build().unwrap();
    simulation.add_force(Box::new(Bowl { centre: DVec2::splat(0.02), stiffness: 1.0 }));
    let ledger = EnergyLedger::open(&mut simulation);
    let start = MechanicalEnergy::of(&simulation).total();

    for _ in 0..20_000 {
        simulation.step();
    }

    let end = MechanicalEnergy::of(&simulation).total();
    println!("t = {:.3} s, energy {start:.6e} J at start, {end:.6e} J at end", simulation.time());
    println!("work residue {:.1e} J", ledger.row(&simulation).work_error_J);
    assert!((end / start - 1.0).abs() < 0.02, "the energy does not match the force");
}
