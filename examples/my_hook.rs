//! My own hooks: act on the discs before steps and look at them after, in a loop of my own.
//!
//! `Simulation::step` is one time step and nothing else, so a hook is a line before or after it.
//! Here the box is tapped from below ten times a second, and the heap's height is watched.
//!
//! Run it: cargo run --example my_hook

use glam::DVec2;
use parsim2d::analysis::energy::EnergyLedger;
use parsim2d::scenario::Scenario;
use parsim2d::simulation::Simulation;

const TAP: f64 = 0.3; // m/s

/// Before a step: whatever lies low is knocked upward. `act` books the energy it gives.
fn tap(simulation: &mut Simulation) {
    simulation.act(|discs| {
        for disc in discs.iter_mut().filter(|disc| disc.position.y < 0.01) {
            disc.velocity += DVec2::new(0.0, TAP);
        }
    });
}

/// After a step: the height of the centre of mass, m.
fn height(simulation: &Simulation) -> f64 {
    let discs = simulation.particles();
    discs.iter().map(|disc| disc.position.y).sum::<f64>() / discs.len() as f64
}

pub fn main() {
    let scenario = "n = 100\nseed = 1\nradius = 5e-4\nrestitution = 0.5";
    let mut simulation = Scenario::from_toml(scenario).unwrap().build().unwrap();
    let ledger = EnergyLedger::open(&mut simulation);
    let start = ledger.row(&simulation);
    let tap_every = (0.1 / simulation.dt()) as u64;
    let mut highest = 0.0_f64;

    for step in 1..=5 * tap_every {
        if step % tap_every == 0 {
            tap(&mut simulation);
        }
        simulation.step();
        if step > tap_every {
            highest = highest.max(height(&simulation));
        }
    }

    let end = ledger.row(&simulation);
    println!("after five taps: heap up to {highest:.4} m, now {:.4} m", height(&simulation));
    println!("the taps gave {:.3e} J, damping took {:.3e} J", end.supplied_J, end.dissipated_J);
    assert!(end.work_error_J.abs() < 1e-12, "energy unaccounted for: {end:?}");
    assert!((end.total_J / start.total_J - 1.0).abs() < 0.01, "not the time step's error: {end:?}");
}
