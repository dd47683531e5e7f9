//! A meeting of two discs, computed again with the rubric's spring and dashpot.
//!
//! Lengths in touching distances, times in 1/omega0 of the pair: with r the vector between the
//! centres, r'' = (1 - |r|) n - 2 zeta (r' . n) n while |r| < 1.

use glam::DVec2;

use super::collision::Collision;
use super::flight::Flights;
use super::rubric::{Law, Rubric};
use crate::analysis::collision::{ContactEnd, damping_ratio_for};

/// A step: 300 in half a swing.
const STEP: f64 = 0.01;

/// What is needed to compute meetings again.
#[derive(Clone, Copy, Debug)]
pub struct Replay {
    /// Restitution of a head-on meeting, and its damping ratio.
    head_on: f64,
    zeta: f64,
    /// 1/omega0 of a pair, in frames; none if the time between frames is not known.
    swing: Option<f64>,
}

impl Replay {
    /// With the rubric's numbers and the time between frames that gravity tells.
    pub fn of(flights: &Flights, rubric: &Rubric) -> Self {
        let head_on = rubric.expected_restitution(false).0;
        let is_soft = rubric.law == Law::Spring && head_on > 0.01 && head_on < 0.999;
        let zeta = if is_soft { damping_ratio_for(head_on, ContactEnd::OverlapZero) } else { 0.0 };
        let interval = flights.interval(rubric).filter(|_| is_soft);
        let swing = interval.map(|interval| 1.0 / (rubric.omega0(false) * interval));
        Self { head_on, zeta, swing }
    }

    /// What is to be added to the restitution of a meeting for that of a head-on one.
    pub fn correction(&self, one: &Collision) -> f64 {
        let speed = self.swing.map(|swing| one.speed * swing / one.touch);
        speed.and_then(|speed| self.restitution(one.aim, speed)).map_or(0.0, |e| self.head_on - e)
    }

    /// The restitution at an aim and a speed, as `collision` measures it; none if it does not end.
    fn restitution(&self, aim: f64, speed: f64) -> Option<f64> {
        let mut place = DVec2::new(-(1.0 - aim * aim).sqrt(), aim);
        let mut velocity = DVec2::new(speed, 0.0);
        for _ in 0..2000 {
            let (distance, normal) = (place.length(), place.normalize_or_zero());
            let along = velocity.dot(normal);
            velocity += STEP * (1.0 - distance - 2.0 * self.zeta * along) * normal;
            place += STEP * velocity;
            if place.length() >= 1.0 {
                let across = (aim * speed).powi(2);
                let after = velocity.length_squared() - across;
                return Some((after.max(0.0) / (speed * speed - across)).sqrt());
            }
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn replay(head_on: f64) -> Replay {
        let zeta = damping_ratio_for(head_on, ContactEnd::OverlapZero);
        Replay { head_on, zeta, swing: Some(1.0) }
    }

    #[test]
    fn a_head_on_meeting_gives_back_what_the_formula_says() {
        for e in [0.3, 0.8, 0.95] {
            // The step is a 300th of a swing, and the end is found to one step.
            let measured = replay(e).restitution(0.0, 0.1).unwrap();
            assert!((measured - e).abs() < 3e-3, "{measured} for {e}");
        }
    }

    #[test]
    fn an_oblique_one_gives_back_more_the_softer_it_is() {
        let at = |aim, speed| replay(0.8).restitution(aim, speed).unwrap();
        assert!(at(0.5, 0.3) > at(0.5, 0.1) && at(0.5, 0.1) > at(0.0, 0.1) + 5e-3);
        assert!((at(0.6, 1e-3) - 0.8).abs() < 3e-3, "a stiff one does not turn");
    }
}
