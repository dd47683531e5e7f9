//! What a stepped run of one or two discs shows: when they touch and part, how deep, how fast, how
//! high.

use glam::DVec2;

use super::expected::Expected;
use super::question::Question;
use crate::analysis::bounce::Touch;
use crate::analysis::collision::ContactEnd;
use crate::simulation::Simulation;

impl Question {
    /// Depth, duration, restitution and heights of a stepped run, as far as theory has them; not a
    /// number where the run does not get so far.
    pub(super) fn measure(&self, expected: &Expected, mut run: Simulation, ahead: f64) -> Vec<f64> {
        let mut seen = Seen::default();
        let mut before = self.state(expected, &run);
        let (end, bounces) = (expected.ends - ahead, expected.heights.len());
        // A method that gains energy flies higher, and longer.
        let is_parting = |seen: &Seen| seen.parted.is_some() && seen.parting_speed.is_none();
        while run.time() < end
            || is_parting(&seen)
            || (seen.heights.len() < bounces && run.time() < 1.5 * end)
        {
            run.step();
            let now = self.state(expected, &run);
            seen.look(before, now, run.time(), run.dt(), expected);
            before = now;
        }
        let or_nothing = |value: Option<f64>| value.unwrap_or(f64::NAN);
        let mut measured = vec![seen.depth / self.smaller_radius()];
        if expected.bounce.parting.is_some() {
            let e = or_nothing(seen.parting_speed) / or_nothing(seen.touch_speed);
            measured.extend([or_nothing(seen.duration), e]);
        }
        measured.extend((0..bounces).map(|k| or_nothing(seen.heights.get(k).copied())));
        measured
    }

    /// Gap, m, approach speed, m/s, and height of disc 0, m.
    fn state(&self, expected: &Expected, run: &Simulation) -> State {
        match (expected.wall, run.particles()) {
            (None, [i, j, ..]) => {
                let apart = j.position - i.position;
                let distance = apart.length();
                State {
                    gap: distance - i.radius - j.radius,
                    speed: (i.velocity - j.velocity).dot(apart / distance),
                    height: 0.0,
                }
            }
            (wall, discs) => {
                let (disc, normal) = (&discs[0], wall.unwrap_or(DVec2::NEG_Y));
                let plane = if normal.min_element() < 0.0 { 0.0 } else { self.side.unwrap_or(0.0) };
                State {
                    gap: plane - disc.position.dot(normal) - disc.radius,
                    speed: disc.velocity.dot(normal),
                    height: disc.position.y,
                }
            }
        }
    }
}

/// The relevant part of a state.
#[derive(Clone, Copy, Debug)]
struct State {
    gap: f64,    // m
    speed: f64,  // m/s, approaching
    height: f64, // m
}

/// What was seen so far.
#[derive(Debug, Default)]
struct Seen {
    depth: f64,                 // m
    touched_at: Option<f64>,    // s
    touch_speed: Option<f64>,   // m/s
    duration: Option<f64>,      // s
    parted: Option<f64>,        // how long ago the surfaces had parted, in steps
    parting_speed: Option<f64>, // m/s
    heights: Vec<f64>,          // m
    highest: Option<f64>,       // m, since the last bounce, while rising
}

impl Seen {
    /// Takes in one step, from `before` to `now` at `time` s.
    fn look(&mut self, before: State, now: State, time: f64, dt: f64, expected: &Expected) {
        let Touch { push, stiffness, eta, end, .. } = expected.touch;
        if self.duration.is_none() {
            self.depth = self.depth.max(-now.gap);
        }
        if before.gap >= 0.0 && now.gap < 0.0 && self.touched_at.is_none() {
            let part = before.gap / (before.gap - now.gap);
            self.touched_at = Some(time - (1.0 - part) * dt);
            // The path of a step is the speed in its middle, whichever velocity the integrator keeps;
            // until the touch there is only the push.
            let middle = (before.gap - now.gap) / dt;
            self.touch_speed = Some(middle + (part - 0.5) * dt * push);
        }
        let hold = |state: State| match end {
            ContactEnd::OverlapZero => -state.gap,
            ContactEnd::ForceZero => eta * state.speed - stiffness * state.gap,
        };
        if let (Some(touched_at), None, true) = (self.touched_at, self.duration, hold(now) <= 0.0) {
            let part = hold(before) / (hold(before) - hold(now));
            self.duration = Some(time - (1.0 - part) * dt - touched_at);
        }
        if let (Some(rest), None) = (self.parted, self.parting_speed) {
            // Back from the middle of this step, the first without the contact.
            let middle = (now.gap - before.gap) / dt;
            self.parting_speed = Some(middle + (rest + 0.5) * dt * push);
        }
        if before.gap < 0.0 && now.gap >= 0.0 && self.parted.is_none() {
            self.parted = Some(now.gap / (now.gap - before.gap));
        }
        if before.gap < 0.0 && now.gap >= 0.0 {
            self.highest = Some(now.height);
        }
        if let Some(highest) = self.highest {
            if now.height >= highest {
                self.highest = Some(now.height);
            } else {
                self.heights.push(highest);
                self.highest = None;
            }
        }
    }
}
