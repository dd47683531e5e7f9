//! Restitution as the time step gives it, beside that of Eq. (1) in continuous time.
//!
//! With a dashpot every integrator here is of first order inside a contact, and the lower e, the more of
//! itself it is off: one contact is stepped, begun at several phases of a step, and e read off.

use glam::DVec2;

use crate::force::HalfPlane;
use crate::number::{at_most, safely_above, shortest};
use crate::particle::Particle;
use crate::scenario::Scenario;
use crate::scenario::expected::ExpectedContact;
use crate::scenario::finding::{Finding, Matter, Verdict};
use crate::scenario::settings::IntegratorName;
use crate::scenario::{StepChoice, suspects::Suspect};
use crate::simulation::Simulation;

/// Restitution that is off by more than this part of itself is missed.
pub const MISSED: f64 = 0.05;

/// Phases of the touch inside a step.
const PHASES: u32 = 8;

/// Steps in a contact of restitution `e` from which on nothing is missed, so that it need not be stepped: e is
/// off by 0.3 to 0.7 |ln e|³ / steps of itself (measured for 0.01 to 1e-6). At most some tenths of a second.
fn enough_steps(e: f64) -> f64 {
    (1000.0 + e.ln().abs().powi(3) / (0.5 * MISSED)).min(2e5)
}

impl Scenario {
    /// The restitution that this integrator and time step give in the `contact`, without weight: the mean
    /// over the phases at which it may begin; `None` where a contact never ends, where the step is
    /// unstable, or where it is so fine that nothing is missed.
    pub fn stepped_restitution(&self, contact: &ExpectedContact) -> Option<f64> {
        if !self.is_stable() || contact.steps > enough_steps(contact.restitution) {
            return None;
        }
        let phases = (0..PHASES).map(|phase| (f64::from(phase) + 0.5) / f64::from(PHASES));
        let sum: f64 = phases.map(|phase| self.stepped_contact(contact, phase)).sum();
        Some(sum / f64::from(PHASES))
    }

    /// Speed after over speed before of one contact that begins `phase` of a step after a step: of a disc
    /// of the reduced mass with a wall, for the law sees no more of a pair. 0 if it does not end.
    fn stepped_contact(&self, contact: &ExpectedContact, phase: f64) -> f64 {
        let ExpectedContact { reduced_mass, angular_frequency: omega, .. } = *contact;
        let (radius, dt) = (1.0, self.dt()); // m: nothing hangs on it, nor on the speed
        let speed = 0.1 * radius * omega;
        let at = DVec2::new(0.0, radius + phase * speed * dt);
        let mut disc = Particle::at_rest(at, radius, reduced_mass);
        disc.velocity.y = -speed;
        let floor = HalfPlane { point: DVec2::ZERO, normal: DVec2::NEG_Y };
        let (law, integrator) = (self.law(), self.new_integrator());
        let mut run = Simulation::new(vec![disc], DVec2::ZERO, law, &[floor], integrator, dt);
        let is_apart = |run: &Simulation| run.particles()[0].position.y >= radius;
        while is_apart(&run) {
            run.step();
        }
        for _ in 0..(4.0 * contact.steps) as u64 + 100 {
            run.step();
            if is_apart(&run) {
                run.step(); // velocity Verlet kicks once more with the force of the step before
                return run.particles()[0].velocity.y / speed;
            }
        }
        0.0
    }

    /// How far off, as a part of itself, the restitution of the `contact` comes out.
    fn missed_by(&self, contact: &ExpectedContact) -> f64 {
        let stepped = self.stepped_restitution(contact);
        stepped.filter(|_| contact.restitution > 0.0).map_or(0.0, |e| e / contact.restitution - 1.0)
    }

    /// The contact whose restitution is missed most, what it is between, and by how much.
    fn most_missed(&self) -> Option<(&'static str, ExpectedContact, f64)> {
        let pair = (self.n() > 1).then(|| ("of two discs", self.expected_pair()));
        let wall = self.walls.then(|| ("at a wall", self.expected_wall()));
        let all = [pair, wall].into_iter().flatten();
        let missed = all.map(|(whose, contact)| (whose, contact, self.missed_by(&contact)));
        missed.max_by(|a, b| a.2.abs().total_cmp(&b.2.abs()))
    }

    /// Whether the step gives the restitution that is meant; explicit Euler has a finding of its own.
    fn keeps_restitution(&self) -> bool {
        self.integrator == IntegratorName::ExplicitEuler
            || self.most_missed().is_none_or(|(.., missed)| missed.abs() <= MISSED)
    }

    pub(super) fn missed_restitution(&self) -> Option<Finding> {
        if self.keeps_restitution() {
            return None;
        }
        let (whose, contact, missed) = self.most_missed()?;
        let Suspect { name, value, .. } = self.step_suspect();
        let what = format!(
            "restitution is missed: at this step a contact {whose} has e = {}, not {} ({:+.0} %)",
            at_most(contact.restitution * (1.0 + missed), 3),
            at_most(contact.restitution, 3),
            100.0 * missed
        );
        Some(Finding {
            matter: Matter::Restitution,
            verdict: Verdict::Coarse,
            what,
            fault: name,
            value,
            ways_out: self.nt_for_restitution(missed).into_iter().collect(),
        })
    }

    /// The N_t that gives the restitution meant, found by trying.
    fn nt_for_restitution(&self, missed: f64) -> Option<String> {
        let now = self.with_step(StepChoice::Nt(1.0)).dt() / self.dt();
        let mut nt = safely_above(now * missed.abs() / MISSED); // the error goes like dt
        for _ in 0..20 {
            let finer = self.with_step(StepChoice::Nt(nt));
            if finer.keeps_restitution() && finer.is_runnable() {
                return Some(self.in_place_of_dt(format!("--nt {}", shortest(nt))));
            }
            nt = safely_above(1.2 * nt);
        }
        None
    }
}
