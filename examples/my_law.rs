//! My own contact law: Hertz's, whose spring grows stiffer as bodies sink into each other.
//!
//! A law is three pure functions of the contact: the push, the part of it that a spring would give
//! back, and the energy stored. It serves discs and walls alike; the library is not touched.
//! The test at the end holds it against Hertz's closed forms (Landau and Lifshitz, Theory of
//! Elasticity, sec. 9): the deepest overlap, and how long the contact lasts.
//!
//! Run it: cargo run --example my_law

use glam::DVec2;
use parsim2d::force::HalfPlane;
use parsim2d::integrator::VelocityVerlet;
use parsim2d::particle::{Contact, ContactLaw, Particle};
use parsim2d::simulation::Simulation;

/// f = k delta^(3/2).
#[derive(Clone)]
struct Hertz {
    stiffness: f64, // N/m^(3/2)
}

impl ContactLaw for Hertz {
    fn push(&self, contact: &Contact) -> f64 {
        self.stiffness * contact.overlap.powf(1.5)
    }

    fn spring(&self, contact: &Contact) -> f64 {
        self.push(contact) // nothing is damped
    }

    fn stored_energy(&self, contact: &Contact) -> f64 {
        0.4 * self.stiffness * contact.overlap.powf(2.5)
    }
}

pub fn main() {
    let (mass, radius, speed, dt) = (1e-3, 5e-4, 0.5, 1e-7);
    let law = Hertz { stiffness: 4e6 };
    let mut disc = Particle::at_rest(DVec2::new(0.02, radius + 1e-6), radius, mass);
    disc.velocity.y = -speed;
    let (walls, integrator) = (HalfPlane::square(0.04), Box::new(VelocityVerlet));
    let mut simulation =
        Simulation::new(vec![disc], DVec2::ZERO, law.clone(), &walls, integrator, dt);
    let mut duration = 0.0;
    while simulation.particles()[0].position.y < 2.0 * radius {
        simulation.step();
        duration += if simulation.stored_energy() > 0.0 { dt } else { 0.0 };
    }
    let (depth, back) =
        (simulation.largest_overlap() * radius, simulation.particles()[0].velocity.y);
    let deepest = (1.25 * mass * speed * speed / law.stiffness).powf(0.4);
    let lasts = 2.9432 * deepest / speed;
    println!("deepest overlap {depth:.4e} m, Hertz {deepest:.4e} m");
    println!("contact {duration:.4e} s, Hertz {lasts:.4e} s; back at {back:.5} m/s");
    assert!((depth / deepest - 1.0).abs() < 1e-3 && (back / speed - 1.0).abs() < 1e-3);
    assert!((duration / lasts - 1.0).abs() < 1e-2, "{duration:e} s, not {lasts:e} s");
}
