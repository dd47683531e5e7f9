//! Time integrators, side by side: when a method kicks, drifts and asks for forces is the whole difference.
//!
//! On entry to `step` and on its return every force belongs to the present state (for velocity
//! Verlet: to the half-step velocity), so a method may kick first and no first step is special. The energy each gains or loses is told in
//! `analysis/energy.rs`.

use crate::particle::Particle;

/// What a time integrator may do with the discs. All times in s.
pub trait Motion {
    /// v' = v + (F/m) dt, every disc. The work done by the forces is booked here.
    fn kick(&mut self, dt: f64);
    /// x' = x + v dt, every disc.
    fn drift(&mut self, dt: f64);
    /// F = F(x, v), every disc.
    fn update_forces(&mut self);
    /// Changes every disc, of which the id is told too, for methods that need more than kicks and drifts: in any order, by several threads at once if
    /// there are many discs, so what one becomes may hang on nothing but itself. Velocities changed here and not by `kick`
    /// are missing from the work ledger; radii and masses are not an integrator's to change: a guard that goes back
    /// would not find the old ones. Time within a step goes on with `drift` alone, so whoever moves discs here leaves walls that
    /// move, and what pairs remember, where they were.
    fn each(&mut self, change: &(dyn Fn(u32, &mut Particle) + Sync));
}

/// A way to move the discs on by one time step.
pub trait Integrator: Send {
    /// Moves everything from t to t + `dt` (s), asking for forces when it needs them.
    fn step(&mut self, discs: &mut dyn Motion, dt: f64);
}

/// Eq. (3), the guide's Euler: v' = v + a dt; x' = x + v' dt. The *new* velocity moves the disc.
///
/// Also called semi-implicit Euler or Euler-Cromer (Cromer 1981). First order inside a contact,
/// its energy error is bounded: after an elastic contact only O(dt²) is left; after a damped one O(dt).
pub struct SymplecticEuler;

impl Integrator for SymplecticEuler {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        discs.kick(dt);
        discs.drift(dt);
        discs.update_forces();
    }
}

/// Forward Euler: x' = x + v dt; v' = v + a dt. The *old* velocity moves the disc, and every
/// elastic bounce gains energy: about 22 % at a wall with N_t = 50.
pub struct ExplicitEuler;

impl Integrator for ExplicitEuler {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        discs.drift(dt);
        discs.kick(dt);
        discs.update_forces();
    }
}

/// Velocity Verlet (Swope et al. 1982): two half-kicks around a drift, and of second order where forces hang
/// on positions alone.
///
/// With a dashpot it is of *first* order inside a contact, as Eq. (3): the same restitution to the digit.
/// The dashpot is fed the half-step velocity, F(x', v + a dt/2), and that force serves both this
/// step's second half-kick and the next step's first. Positions are those of Eq. (3) started
/// half a kick earlier, so the stability limit is the same.
pub struct VelocityVerlet;

impl Integrator for VelocityVerlet {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        discs.kick(0.5 * dt);
        discs.drift(dt);
        discs.update_forces();
        discs.kick(0.5 * dt);
    }
}
