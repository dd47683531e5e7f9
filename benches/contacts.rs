//! How long the parts of a step take on a dense bed: the pass over the contacts, and making the list
//! of near pairs. `cargo bench`; times are those of a pass, and the counter is per disc.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::DVec2;
use parsim2d::crowd::Crowd;
use parsim2d::discs::Discs;
use parsim2d::force::{Contacts, Force, Tally};
use parsim2d::integrator::{Integrator, Motion, SymplecticEuler};
use parsim2d::neighbours::Neighbours;
use parsim2d::particle::{Damping, Particle, SpringDashpot};

/// Numbers of discs: in the first cache, in the second, in none.
const SIZES: [usize; 3] = [1_000, 20_000, 100_000];

/// The guide's time step, s.
const DT: f64 = 8.885765876316733e-6;

/// The guide's larger discs, m, and their mass, kg.
const RADIUS: f64 = 5e-4;
const MASS: f64 = 1e-3;

fn main() {
    divan::main();
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

fn contacts() -> Contacts<SpringDashpot> {
    let damping = Damping::Coefficient(1.5e-3); // kg/s, the guide's
    let law = SpringDashpot { stiffness: 5e4, damping, tension: true };
    Contacts { law, neighbours: Neighbours::default() }
}

/// Every contact found, computed and given to both discs; the list is there already.
#[divan::bench(args = SIZES)]
fn contact_pass(bencher: Bencher, n: usize) {
    let (mut particles, mut contacts, mut tally) = (bed(n), contacts(), Tally::default());
    contacts.apply(&mut particles, &mut tally);
    bencher
        .counter(ItemsCount::new(n))
        .bench_local(|| contacts.apply(black_box(&mut particles), &mut tally));
}

fn crowd(particles: Vec<Particle>, has_ledger: bool) -> Crowd<SpringDashpot> {
    let law = contacts().law;
    let mut crowd = Crowd::new(particles, DVec2::ZERO, law, Vec::new(), DT, 1);
    if has_ledger {
        crowd.keep_work_ledger();
    }
    crowd
}

/// The same as [`contact_pass`] by a crowd on one thread.
#[divan::bench(args = SIZES)]
fn crowd_contact_pass(bencher: Bencher, n: usize) {
    let mut crowd = crowd(bed(n), false);
    bencher.counter(ItemsCount::new(n)).bench_local(|| crowd.update_forces());
}

/// The same with the springs' share told apart, for the ledger.
#[divan::bench(args = SIZES)]
fn crowd_contact_pass_with_ledger(bencher: Bencher, n: usize) {
    let mut crowd = crowd(bed(n), true);
    bencher.counter(ItemsCount::new(n)).bench_local(|| crowd.update_forces());
}

/// A whole step of a crowd on one thread, with its ledger. The bed hangs in the void and wobbles.
#[divan::bench(args = SIZES)]
fn crowd_step(bencher: Bencher, n: usize) {
    let mut crowd = crowd(bed(n), true);
    bencher.counter(ItemsCount::new(n)).bench_local(|| SymplecticEuler.step(&mut crowd, DT));
}

/// A crowd from nothing: cells, list of near pairs, first forces.
#[divan::bench(args = SIZES)]
fn crowd_from_nothing(bencher: Bencher, n: usize) {
    let particles = bed(n);
    bencher
        .counter(ItemsCount::new(n))
        .with_inputs(|| particles.clone())
        .bench_local_values(|particles| crowd(particles, false));
}

/// A list of near pairs from nothing.
#[divan::bench(args = SIZES)]
fn list_build(bencher: Bencher, n: usize) {
    let particles = bed(n);
    bencher.counter(ItemsCount::new(n)).with_inputs(Neighbours::default).bench_local_refs(
        |neighbours| {
            neighbours.refresh(black_box(&particles));
        },
    );
}
