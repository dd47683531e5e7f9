//! My own integrator: Forest and Ruth's fourth-order method (Physica D 43, 105, 1990).
//!
//! An integrator says when to kick, when to drift and when to ask for forces; the library is not
//! touched. Three velocity Verlet steps of chosen lengths, one of them backwards, cancel each
//! other's third-order errors.
//!
//! Run it: cargo run --example my_integrator

use parsim2d::analysis::energy::MechanicalEnergy;
use parsim2d::integrator::{Integrator, Motion, VelocityVerlet};
use parsim2d::scenario::Scenario;

struct ForestRuth;

impl Integrator for ForestRuth {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        let outer = 1.0 / (2.0 - 2.0f64.cbrt());
        for part in [outer, 1.0 - 2.0 * outer, outer] {
            discs.kick(0.5 * part * dt);
            // What `drift` does, but for the time of walls that move; `each` reaches the discs themselves, for a method
            // that needs more.
            discs.each(&|_, disc| disc.position += disc.velocity * (part * dt));
            discs.update_forces();
            discs.kick(0.5 * part * dt);
        }
    }
}

/// Relative energy error of a disc that rests on a soft floor and is let swing, after 0.1 s.
fn energy_error(integrator: Box<dyn Integrator>, nt: u32) -> f64 {
    // One contact that never opens: where the force is smooth, a method shows its order.
    let scenario = format!(
        "nt = {nt}\nradius = 5e-3\nkn = 100\neta = 0\n[[disc]]\nposition = [0.02, 0.00486]"
    );
    let mut simulation = Scenario::from_toml(&scenario).unwrap().build().unwrap();
    simulation.set_integrator(integrator);
    let start = MechanicalEnergy::of(&simulation).total();
    let mut worst = 0.0_f64;
    while simulation.time() < 0.1 {
        simulation.step();
        worst = worst.max((MechanicalEnergy::of(&simulation).total() / start - 1.0).abs());
    }
    worst
}

pub fn main() {
    for nt in [20, 40, 80] {
        let verlet = energy_error(Box::new(VelocityVerlet), nt);
        let mine = energy_error(Box::new(ForestRuth), nt);
        println!("N_t = {nt}: velocity Verlet {verlet:.1e}, Forest-Ruth {mine:.1e}");
    }
    let gain = energy_error(Box::new(ForestRuth), 20) / energy_error(Box::new(ForestRuth), 40);
    assert!((gain.log2() - 4.0).abs() < 0.3, "not of fourth order: {:.2}", gain.log2());
}
