//! How long the parts of a step take on a dense bed: the pass over the contacts, and making the list
//! of near pairs. `cargo bench`; each line is the median of some hundred passes, and the time of a disc.

use std::hint::black_box;
use std::time::{Duration, Instant};

use glam::DVec2;
use parsim2d::discs::Discs;
use parsim2d::engine::{Contacts, Engine};
use parsim2d::integrator::{Integrator, Motion, SymplecticEuler};
use parsim2d::neighbours::Neighbours;
use parsim2d::particle::{Damping, Particle, SpringDashpot};
use parsim2d::simulation::PlainDiscs;

/// Numbers of discs: in the first cache, in the second, in none.
const SIZES: [usize; 3] = [1_000, 20_000, 100_000];

/// The guide's time step, s.
const DT: f64 = 8.885765876316733e-6;

/// The guide's larger discs, m, and their mass, kg.
const RADIUS: f64 = 5e-4;
const MASS: f64 = 1e-3;

fn main() {
    println!("{:<32} {:>8} {:>14} {:>10}", "what", "discs", "a pass, us", "a disc, ns");
    for n in SIZES {
        contact_pass(n);
        crowd_contact_pass(n);
        crowd_contact_pass_with_ledger(n);
        crowd_step(n);
        crowd_from_nothing(n);
        list_build(n);
    }
}

/// Does `pass` for a second, at least five times, and prints the median; what `prepare` does is not timed.
fn report<T>(what: &str, n: usize, mut prepare: impl FnMut() -> T, mut pass: impl FnMut(&mut T)) {
    let begun = Instant::now();
    let mut times = Vec::new();
    while times.len() < 5 || begun.elapsed() < Duration::from_secs(1) {
        let mut prepared = prepare();
        let start = Instant::now();
        pass(&mut prepared);
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    let median = times[times.len() / 2];
    println!("{what:<32} {n:>8} {:>14.1} {:>10.2}", 1e6 * median, 1e9 * median / n as f64);
}

/// Staggered rows, as wide as high, all neighbours overlapping by one per cent: six contacts a disc.
fn bed(n: usize) -> Vec<Particle> {
    let spacing = 0.99 * 2.0 * RADIUS;
    let columns = (n as f64).sqrt().ceil() as usize;
    let disc = |id: usize| {
        let (column, row) = (id % columns, id / columns);
        let shift = if row % 2 == 1 { 0.5 } else { 0.0 };
        let place = DVec2::new(column as f64 + shift, row as f64 * 0.75f64.sqrt());
        Particle::at_rest(spacing * place, RADIUS, MASS)
    };
    (0..n).map(disc).collect()
}

fn law() -> SpringDashpot {
    let damping = Damping::Coefficient(1.5e-3); // kg/s, the guide's
    SpringDashpot { stiffness: 5e4, damping, tension: true }
}

/// Every contact found, computed and given to both discs; the list is there already.
fn contact_pass(n: usize) {
    let mut discs = PlainDiscs::new(bed(n), DVec2::ZERO, law(), Vec::new());
    report("contact_pass", n, || (), |()| black_box(&mut discs).update_forces());
}

fn engine(particles: Vec<Particle>, has_ledger: bool) -> Engine<Contacts<SpringDashpot>> {
    let mut engine = Engine::new(particles, DVec2::ZERO, law(), Vec::new(), DT, 1);
    if has_ledger {
        engine.keep_work_ledger();
    }
    engine
}

/// The same as [`contact_pass`] by the engine on one thread.
fn crowd_contact_pass(n: usize) {
    let mut engine = engine(bed(n), false);
    report("crowd_contact_pass", n, || (), |()| engine.update_forces());
}

/// The same with the springs' share told apart, for the ledger.
fn crowd_contact_pass_with_ledger(n: usize) {
    let mut engine = engine(bed(n), true);
    report("crowd_contact_pass_with_ledger", n, || (), |()| engine.update_forces());
}

/// A whole step of the engine on one thread, with its ledger. The bed hangs in the void and wobbles.
fn crowd_step(n: usize) {
    let mut engine = engine(bed(n), true);
    report("crowd_step", n, || (), |()| SymplecticEuler.step(&mut engine, DT));
}

/// The engine from nothing: cells, list of near pairs, first forces.
fn crowd_from_nothing(n: usize) {
    let particles = bed(n);
    let begin = || Some(particles.clone());
    report("crowd_from_nothing", n, begin, |discs| {
        black_box(engine(discs.take().expect("prepared"), false));
    });
}

/// A list of near pairs from nothing.
fn list_build(n: usize) {
    let particles = bed(n);
    report("list_build", n, Neighbours::default, |neighbours| {
        neighbours.refresh(black_box(&particles));
    });
}
