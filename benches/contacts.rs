//! How long the parts of a step take on a dense bed: the pass over the contacts, and making the list
//! of near pairs. `cargo bench`; times are those of a pass, and the counter is per disc.

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use glam::DVec2;
use parsim2d::force::{Contacts, Force, Tally};
use parsim2d::neighbours::Neighbours;
use parsim2d::particle::{Damping, Particle, SpringDashpot};

/// Numbers of discs: in the first cache, in the second, in none.
const SIZES: [usize; 3] = [1_000, 20_000, 100_000];

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
