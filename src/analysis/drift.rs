//! How far the total energy strays from its value at the start: one run watched step by step.
//!
//! "Total" counts what the dashpots took (`energy.rs`), so that damping is no error and what is
//! left is the integrator's. Errors are relative to the energy at the start. A box that has
//! doubled its energy is stopped: there is nothing more to learn from it.

use super::energy::EnergyLedger;
use super::line::Line;
use crate::simulation::Simulation;

/// Relative error from which on a run is stopped: the energy has doubled.
pub const DOUBLED: f64 = 1.0;

/// The energy of one run, from its start to its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Time step, s.
    pub dt: f64,
    /// Largest |E/E0 - 1| of all steps.
    pub largest_error: f64,
    /// E/E0 - 1 at the end, with its sign.
    pub final_error: f64,
    /// Energy at the start E0, J.
    pub energy_at_start: f64,
    /// What the dashpots took, J.
    pub dissipated: f64,
    /// Work residue of the ledger, J: round-off, if the bookkeeping is right.
    pub work_error: f64,
    /// Time, s, at which the error had reached the most allowed and the run was stopped.
    pub stopped_at: Option<f64>,
    /// (time in s, E/E0 - 1) at evenly spaced steps, start and end included.
    pub curve: Vec<(f64, f64)>,
}

impl Course {
    /// Steps `simulation` `steps` times and watches its energy at every step, until the relative
    /// error reaches `most`. The curve gets about `points` points; `progress` is told at each how
    /// many steps were done since the last.
    ///
    /// ```
    /// use glam::DVec2;
    /// use parsim2d::analysis::drift::Course;
    /// use parsim2d::particle::{Damping, Particle, SpringDashpot};
    /// use parsim2d::{integrator::SymplecticEuler, simulation::Simulation};
    /// // Free fall from 0.03 m for 0.05 s: Eq. (3) shows -m g v dt/2 of m g h.
    /// let disc = Particle::at_rest(DVec2::new(0.02, 0.03), 5e-4, 1e-3);
    /// let gravity = DVec2::new(0.0, -9.81);
    /// let law = SpringDashpot { stiffness: 5e4, damping: Damping::Ratio(0.1), tension: true };
    /// let euler = Box::new(SymplecticEuler);
    /// let fall = Simulation::new(vec![disc], gravity, law, &[], euler, 1e-5);
    /// let course = Course::watch(fall, 5000, f64::INFINITY, 10, &mut |_| {});
    /// let saw_tooth = -0.5 * 9.81 * 0.05 * 1e-5 / 0.03;
    /// assert!((course.final_error / saw_tooth - 1.0).abs() < 1e-9);
    /// ```
    pub fn watch(
        mut simulation: Simulation,
        steps: u64,
        most: f64,
        points: u64,
        progress: &mut dyn FnMut(u64),
    ) -> Self {
        let ledger = EnergyLedger::open(&mut simulation);
        let energy_at_start = ledger.row(&simulation).total_J;
        let every = steps.div_ceil(points.max(1)).max(1);
        let (mut largest_error, mut stopped_at) = (0.0_f64, None);
        let (mut curve, mut told) = (vec![(0.0, 0.0)], 0);
        while simulation.steps() < steps && stopped_at.is_none() {
            simulation.step();
            let error = ledger.row(&simulation).total_J / energy_at_start - 1.0;
            largest_error = largest_error.max(error.abs());
            // Also true once the numbers have overflowed.
            let is_astray = !error.is_finite() || error >= most;
            stopped_at = is_astray.then(|| simulation.time());
            let done = simulation.steps();
            if done % every == 0 || done == steps || is_astray {
                progress(done - told);
                told = done;
                curve.push((simulation.time(), error));
            }
        }
        progress(steps - told);
        let end = ledger.row(&simulation);
        Self {
            dt: simulation.dt(),
            largest_error,
            final_error: end.total_J / energy_at_start - 1.0,
            energy_at_start,
            dissipated: end.dissipated_J,
            work_error: end.work_error_J,
            stopped_at,
            curve,
        }
    }

    /// The worse of two courses of the same case: each error is the larger one in size.
    #[must_use]
    pub fn worse(self, other: &Self) -> Self {
        let larger = |a: f64, b: f64| if b.abs() > a.abs() { b } else { a };
        Self {
            largest_error: larger(self.largest_error, other.largest_error),
            final_error: larger(self.final_error, other.final_error),
            dissipated: larger(self.dissipated, other.dissipated),
            work_error: larger(self.work_error, other.work_error),
            ..self
        }
    }

    /// How fast the energy grows: over the later half of the run, where the discs have met.
    /// `None` for a run that was stopped, or has too few points for a line.
    pub fn growth(&self) -> Option<Growth> {
        let half = &self.curve[self.curve.len() / 2..];
        let line = Line::through(half).filter(|_| self.stopped_at.is_none() && half.len() > 2)?;
        let time = half[half.len() - 1].0 - half[0].0;
        Some(Growth { rate: line.slope, doubt: 2.0 * line.scatter / time })
    }
}

/// Growth of the energy, relative to the energy at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Growth {
    /// Slope of the error, 1/s.
    pub rate: f64,
    /// What the scatter of the error (contacts under way, the saw-tooth of free fall) could
    /// feign, 1/s: twice its rms size over the time looked at. Swings of a whole bed are slow, so
    /// that many points are no more certain than few.
    pub doubt: f64,
}

/// The order p of an error that goes like `N_t^-p`, from the two finest of `(N_t, error)`.
///
/// ```
/// use parsim2d::analysis::drift::observed_order;
/// let errors = [(10.0, 0.09), (50.0, 4e-3), (100.0, 1e-3)];
/// assert!((observed_order(&errors).unwrap() - 2.0).abs() < 1e-12);
/// assert_eq!(observed_order(&errors[..1]), None);
/// ```
pub fn observed_order(errors: &[(f64, f64)]) -> Option<f64> {
    let mut errors = errors.to_vec();
    errors.sort_by(|a, b| b.0.total_cmp(&a.0));
    let [(fine_nt, fine), (nt, coarse), ..] = errors[..] else { return None };
    let order = (coarse / fine).abs().ln() / (fine_nt / nt).ln();
    order.is_finite().then_some(order)
}
