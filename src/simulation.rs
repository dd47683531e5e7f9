//! The simulation: discs, what pushes them, the clock, and one time step.
//!
//! Here are Eq. (2), the time step; the placing of the discs; the sum of all forces on each disc,
//! m a = m g + sum f_c ([`PlainDiscs::update_forces`](Motion::update_forces)); and [`Simulation::step`]. From there it is
//! three calls to Eq. (1): the integrator's `step`, `update_forces`, and the law's `push`.

mod changes;
mod clock;
mod fingerprint;
mod plain;
mod readings;
pub mod restore_point;
pub mod state;

use std::f64::consts::PI;

use glam::DVec2;

use self::clock::Clock;
pub use self::state::State;
use crate::discs::Discs;
use crate::discs::columns::Columns;
use crate::force::{Force, HalfPlane};
use crate::integrator::{Integrator, Motion};
use crate::neighbours::Neighbours;
use crate::particle::{Contact, ContactLaw, Particle};
use crate::placement::{self, PlacementError};

/// Eq. (2): dt = tau / N_t = pi sqrt(m / k_n) / N_t, in s.
///
/// tau is the time a disc of mass `mass` (kg) spends in an undamped contact with a wall of
/// stiffness `stiffness` (N/m), and `steps_per_contact` is N_t; two equal discs part sooner, after tau / sqrt(2).
/// Of another law, take the stiffness that [`ContactLaw::linearised`] has at the overlap to be expected.
///
/// ```
/// let dt = parsim2d::simulation::time_step(1e-3, 5e4, 50.0);
/// assert!((dt - 8.8857658763e-6).abs() < 1e-15); // the guide's numbers
/// ```
pub fn time_step(mass: f64, stiffness: f64, steps_per_contact: f64) -> f64 {
    PI * (mass / stiffness).sqrt() / steps_per_contact
}

/// Places `n` discs of `radius` (m) and `mass` (kg), at rest, at random in the square from the
/// origin to (`side`, `side`) (m): uniform over the allowed region, no overlap, no wall contact.
///
/// The same `seed` gives the same discs. Fails, rather than loop for ever, when the box is too
/// full; `placement::lattice` goes denser.
pub fn place_discs(
    n: usize,
    radius: f64,
    mass: f64,
    side: f64,
    seed: u64,
) -> Result<Vec<Particle>, PlacementError> {
    let mut discs = vec![Particle::at_rest(DVec2::ZERO, radius, mass); n];
    placement::at_random(&mut discs, 0, side, &mut placement::generator(seed))?;
    Ok(discs)
}

/// Discs in id order, one force after the other: the plain way. An [`Engine`](crate::engine::Engine) does the same for many
/// discs, fast, and to the same bits.
pub struct PlainDiscs<L> {
    particles: Vec<Particle>,
    gravity: DVec2, // m/s2
    /// Forces of your own.
    forces: Vec<Box<dyn Force>>,
    /// The contact law, the same at walls and between discs.
    law: L,
    walls: Vec<HalfPlane>,
    /// Which discs may touch.
    neighbours: Neighbours,
    /// What is remembered beside the particles: overlaps, energies, the ledger's books.
    books: Columns,
}

impl<L: ContactLaw> Motion for PlainDiscs<L> {
    /// The right-hand side of m a = m g + sum f_c, on each disc: its weight, forces of your own, walls, and other discs in
    /// ascending id.
    ///
    /// A wall is a body of infinite mass. Pairs come in lexicographic order (i < j), whatever found them, and each push
    /// is given to both: so the sum has the bits of every disc gathering its own. (`books` listen; they push nobody.)
    fn update_forces(&mut self) {
        let Self { particles, gravity, forces, law, walls, neighbours, books } = self;
        books.begin_forces();
        for disc in particles.iter_mut() {
            disc.force = disc.mass * *gravity; // the weight, m g
        }
        for force in forces {
            books.add_force(force.as_mut(), particles);
        }
        // f_c by Eq. (1), at walls: the normal points to the wall, so the push goes the other way.
        for (i, disc) in particles.iter_mut().enumerate() {
            for wall in walls.iter() {
                let distance = wall.distance(disc.position);
                if let Some(contact) = Contact::with_wall(disc, distance, wall.normal) {
                    let push = law.push(&contact);
                    disc.force -= push * contact.normal;
                    books.touch_wall((i, disc), &contact, law, push);
                }
            }
        }
        // f_c by Eq. (1), between discs: on j what is on i, with the other sign.
        neighbours.refresh(particles);
        for (i, j) in neighbours.pairs() {
            if let Some(contact) = Contact::between(&particles[i], &particles[j]) {
                let push = law.push(&contact);
                particles[i].force -= push * contact.normal;
                particles[j].force += push * contact.normal;
                books.touch_pair((i, j, particles), &contact, law, push);
            }
        }
    }

    /// v' = v + a dt, every disc.
    fn kick(&mut self, dt: f64) {
        match self.books.shares.is_empty() {
            true => self.particles.iter_mut().for_each(|disc| disc.kick(dt)),
            false => self.kick_and_book(dt), // the same kicks
        }
    }

    /// x' = x + v dt, every disc.
    fn drift(&mut self, dt: f64) {
        self.particles.iter_mut().for_each(|disc| disc.drift(dt));
    }

    fn each(&mut self, change: &(dyn Fn(u32, &mut Particle) + Sync)) {
        self.particles.iter_mut().zip(0..).for_each(|(disc, id)| change(id, disc));
    }
}

/// Discs, an integrator and a clock.
pub struct Simulation {
    discs: Box<dyn Discs>,
    integrator: Box<dyn Integrator>,
    clock: Clock,
}

impl Simulation {
    /// A simulation at t = 0, the plain way. `gravity` is the acceleration vector g in m/s2; discs touch each other and
    /// the `walls` by `law`; `dt` is the time step in s. Other forces join by [`add_force`](Self::add_force).
    pub fn new(
        particles: Vec<Particle>,
        gravity: DVec2,
        law: impl ContactLaw + 'static,
        walls: &[HalfPlane],
        integrator: Box<dyn Integrator>,
        dt: f64,
    ) -> Self {
        let discs = PlainDiscs::new(particles, gravity, law, walls.to_vec());
        Self::of(Box::new(discs), integrator, dt)
    }

    /// A simulation of these discs at t = 0.
    pub fn of(discs: Box<dyn Discs>, integrator: Box<dyn Integrator>, dt: f64) -> Self {
        Self { discs, integrator, clock: Clock::new(dt) }
    }

    /// One time step: the integrator moves the discs on by dt, asking for forces when it needs them.
    pub fn step(&mut self) {
        let dt = self.begin_step();
        self.integrator.step(self.discs.as_motion(), dt);
        self.discs.end_step(dt);
        self.discs.settle();
    }

    /// Time steps until `end` steps are done: the same as so many times [`step`](Self::step), and
    /// faster for many discs, which are brought up to date at the end only.
    pub fn step_until(&mut self, end: u64) {
        while self.steps() < end {
            let dt = self.begin_step();
            self.integrator.step(self.discs.as_motion(), dt);
            self.discs.end_step(dt);
        }
        self.discs.settle();
    }

    /// Moves the clock on, tells the discs, and says how long the step is, s.
    fn begin_step(&mut self) -> f64 {
        let (from, dt) = (self.time(), self.dt());
        self.clock.tick();
        self.discs.begin_step(from, self.time());
        dt
    }

    /// Steps with another integrator from now on.
    pub fn set_integrator(&mut self, integrator: Box<dyn Integrator>) {
        self.integrator = integrator;
    }

    /// Steps by another `dt` (s) from now on.
    pub fn set_dt(&mut self, dt: f64) {
        self.clock.set_dt(dt);
        self.discs.set_dt(dt);
    }

    /// Adds a force of your own. If it stores energy its work is booked as a spring's is, else as supplied from outside.
    pub fn add_force(&mut self, force: Box<dyn Force>) {
        self.discs.add_force(force);
    }

    /// Puts one more disc in between two steps; it has the highest id. Energies that come with it are booked as inflow.
    pub fn insert(&mut self, disc: Particle) {
        self.discs.insert(disc);
    }

    /// Takes the disc of this id out between two steps, and gives it back. Higher ids move down by one; energies that go
    /// with it are booked as inflow, less than nothing.
    pub fn remove(&mut self, id: usize) -> Particle {
        self.discs.remove(id)
    }

    /// Changes the discs by hand between two steps. Forces follow the change (under velocity Verlet
    /// from the present velocity on), and the energy it gave is booked as given by hand. A change that changes nothing
    /// leaves the run as it was, to the bit.
    pub fn act(&mut self, change: impl FnOnce(&mut [Particle])) {
        let mut change = Some(change);
        self.discs.act(&mut |particles| {
            if let Some(change) = change.take() {
                change(particles);
            }
        });
    }
}
