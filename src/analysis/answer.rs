//! The analytic answer beside a run of one or two discs: what theory says of the first contact and of
//! the heights after it, what this integrator measures, and the order at which it converges.
//!
//! The run is stepped again at dt, dt/2 and dt/4 up to the end of what is asked. The error of a
//! contact hangs on where in a step it begins, so that each is stepped from several phases and
//! the worst error counts for the order.

use glam::DVec2;
use serde::Serialize;

use super::bounce::{Bounce, Touch};
use super::collision::ContactEnd;
use super::line::Line;
use crate::particle::{Particle, SpringDashpot};
use crate::simulation::Simulation;

/// Phases of the touch inside a step: as many as [`USUAL_STEPS`] allow, within these bounds.
const PHASES: std::ops::RangeInclusive<f64> = 8.0..=64.0;

/// So many steps in all take about a tenth of a second.
const USUAL_STEPS: f64 = 3e6;

/// The step is divided by these.
const FINER: [f64; 3] = [1.0, 2.0, 4.0];

/// More steps than this in all, and no answer is given: some seconds.
const MOST_STEPS: f64 = 3e7;

/// Heights after a bounce, at most.
const HEIGHTS: usize = 3;

/// A relative error below this is rounding, and has no order.
const ROUND_OFF: f64 = 1e-11;

/// A run of one or two discs.
#[derive(Clone, Debug)]
pub struct Question {
    /// The discs at the start.
    pub discs: Vec<Particle>,
    /// The contact law.
    pub law: SpringDashpot,
    /// Gravity, m/s2.
    pub gravity: DVec2,
    /// Side of the box, m, if there are walls.
    pub side: Option<f64>,
    /// Time step, s.
    pub dt: f64,
    /// End of the run, s.
    pub time: f64,
}

/// One line of the answer.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct AnswerRow {
    /// What is compared.
    pub what: String,
    /// Its unit; empty for a plain number, r for radii.
    pub unit: &'static str,
    /// What theory says.
    pub theory: f64,
    /// What the run's integrator and step give.
    pub measured: f64,
    /// measured / theory - 1.
    pub error: f64,
    /// p of an error that goes like dt^p, from dt, dt/2 and dt/4.
    pub order: Option<f64>,
}

/// Theory beside measurement.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Answer {
    rows: Vec<AnswerRow>,
    /// Where theory is not quite that of the run.
    pub remark: Option<String>,
}

impl Answer {
    /// Its lines; none where theory has no answer.
    pub fn rows(&self) -> &[AnswerRow] {
        &self.rows
    }

    /// Whether theory has no answer.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty()
    }
}

/// The first contact of a run, as theory sees it.
struct Expected {
    /// The plane's unit normal, outward; `None` for a pair.
    wall: Option<DVec2>,
    touch: Touch,
    bounce: Bounce,
    /// When it begins and when all that is compared has happened, s.
    begins: f64,
    ends: f64,
    /// Heights of the centre at the apexes after it, m.
    heights: Vec<f64>,
    /// Angle by which the line of centres turns while the contact lasts.
    turn: f64, // rad
}

impl Question {
    /// Theory beside measurement, line by line; nothing where no closed form applies: other than one
    /// or two discs, no contact in time, a contact at the start, or a third body in the way. `build`
    /// makes a simulation of these discs with this time step (s).
    pub fn answer(&self, build: &dyn Fn(Vec<Particle>, f64) -> Option<Simulation>) -> Answer {
        let Some(expected) = self.expected() else { return Answer::default() };
        let Some(rows) = self.compare(&expected, build) else { return Answer::default() };
        let remark = (expected.turn > 1e-3).then(|| {
            format!(
                "the discs turn about each other by {:.1e} rad while they touch; theory takes the \
                 normal as fixed, so that a small error stays at any dt",
                expected.turn
            )
        });
        Answer { rows, remark }
    }

    fn compare(
        &self,
        expected: &Expected,
        build: &dyn Fn(Vec<Particle>, f64) -> Option<Simulation>,
    ) -> Option<Vec<AnswerRow>> {
        let quantities = self.quantities(expected);
        let steps = expected.ends / self.dt * FINER.iter().sum::<f64>();
        // A contact within the first step leaves no room for another phase.
        let is_soon = expected.begins < 2.0 * self.dt;
        let phases = (USUAL_STEPS / steps).clamp(*PHASES.start(), *PHASES.end()).floor();
        let phases = if is_soon || steps * phases > MOST_STEPS { 1.0 } else { phases };
        if steps > MOST_STEPS {
            return None;
        }
        let phases = phases as u32;
        let mut first = Vec::new();
        let mut worst = vec![Vec::new(); quantities.len()];
        for finer in FINER {
            let mut errors = vec![0.0_f64; quantities.len()];
            for phase in 0..phases {
                let (dt, ahead) = self.step_and_start(expected, finer, phase, phases);
                let simulation = build(self.discs_after(ahead), dt)?;
                let measured = self.measure(expected, simulation, ahead);
                for (k, value) in measured.iter().enumerate() {
                    errors[k] = errors[k].max((value / quantities[k].2 - 1.0).abs());
                }
                if first.is_empty() {
                    first = measured;
                }
            }
            for (worst, error) in worst.iter_mut().zip(errors) {
                worst.push(((self.dt / finer).ln(), error));
            }
        }
        let row = |(((what, unit, theory), measured), worst): (_, &Vec<(f64, f64)>)| AnswerRow {
            what,
            unit,
            theory,
            measured,
            error: measured / theory - 1.0,
            order: order(worst),
        };
        let rows = quantities.into_iter().zip(first).zip(&worst).map(row);
        Some(rows.filter(|row| row.measured.is_finite()).collect())
    }

    /// Time step, s, and how much later the run starts, s. With the phase the number of steps in the
    /// contact changes by a part of one, too: whole numbers look better than they are.
    fn step_and_start(
        &self,
        expected: &Expected,
        finer: f64,
        phase: u32,
        phases: u32,
    ) -> (f64, f64) {
        let part = f64::from(phase) / f64::from(phases);
        // By the golden section, so that the two parts together fill the square evenly.
        let other_part = (0.618_034 * f64::from(phase)).fract();
        let dt = self.dt / finer;
        let steps = expected.bounce.parting.map_or(f64::INFINITY, |parting| parting.duration / dt);
        let dt = dt / (1.0 + other_part / steps);
        (dt, part * dt)
    }

    /// Name, unit and theory of all that is compared.
    fn quantities(&self, expected: &Expected) -> Vec<(String, &'static str, f64)> {
        let depth = expected.bounce.depth / self.smaller_radius();
        let mut quantities = vec![("largest overlap".to_owned(), "r", depth)];
        if let Some(parting) = expected.bounce.parting {
            let e = parting.speed / expected.touch.speed;
            quantities.push(("contact time".to_owned(), "s", parting.duration));
            quantities.push(("restitution".to_owned(), "", e));
        }
        for (k, &height) in expected.heights.iter().enumerate() {
            quantities.push((format!("height after bounce {}", k + 1), "m", height));
        }
        quantities
    }

    fn smaller_radius(&self) -> f64 {
        self.discs.iter().map(|disc| disc.radius).fold(f64::INFINITY, f64::min)
    }

    /// The discs after a free flight of `time` s.
    fn discs_after(&self, time: f64) -> Vec<Particle> {
        let mut discs = self.discs.clone();
        for disc in &mut discs {
            disc.position += time * (disc.velocity + 0.5 * time * self.gravity);
            disc.velocity += time * self.gravity;
        }
        discs
    }

    fn expected(&self) -> Option<Expected> {
        match self.discs[..] {
            [disc] => self.bounce_of(&disc),
            [i, j] => self.meeting_of(&i, &j),
            _ => None,
        }
    }

    /// The contact that `speed`, `push` and `reduced_mass` describe.
    fn touch(&self, reduced_mass: f64, speed: f64, push: f64) -> Touch {
        Touch {
            stiffness: self.law.stiffness,
            eta: self.law.damping.coefficient(self.law.stiffness, reduced_mass),
            reduced_mass,
            speed,
            push,
            end: if self.law.tension { ContactEnd::OverlapZero } else { ContactEnd::ForceZero },
        }
    }

    /// One disc and the wall it comes to first.
    fn bounce_of(&self, disc: &Particle) -> Option<Expected> {
        let [(begins, wall), (next, _), ..] = self.walls_ahead(disc)?[..] else { return None };
        let speed = (disc.velocity + begins * self.gravity).dot(wall);
        let touch = self.touch(disc.mass, speed, self.gravity.dot(wall));
        let bounce = touch.bounce();
        let ends = begins + self.length(&bounce, &touch);
        if begins.is_nan() || speed <= 0.0 || ends >= next.min(self.time) {
            return None;
        }
        let mut expected =
            Expected { wall: Some(wall), touch, bounce, begins, ends, heights: vec![], turn: 0.0 };
        if wall == DVec2::NEG_Y && self.gravity.y < 0.0 {
            self.add_heights(disc, &mut expected);
        }
        Some(expected)
    }

    /// How long to look: to the end of the contact, or to the deepest point if it has none.
    fn length(&self, bounce: &Bounce, touch: &Touch) -> f64 {
        let swing = (touch.reduced_mass / touch.stiffness).sqrt();
        bounce.parting.map_or(10.0 * swing, |parting| parting.apart + swing)
    }

    /// The apexes after the first bounces off the floor, as long as no other wall and no end of the run
    /// comes between.
    fn add_heights(&self, disc: &Particle, expected: &mut Expected) {
        let (g, mut touch, mut begins) = (-self.gravity.y, expected.touch, expected.begins);
        for _ in 0..HEIGHTS {
            let Some(parting) = touch.bounce().parting else { return };
            let height = disc.radius + 0.5 * parting.speed * parting.speed / g;
            let apex = begins + parting.apart + parting.speed / g;
            // A while longer, so that the apex is seen; a disc that moves along meets a side wall.
            let seen = apex + 0.1 * parting.speed / g;
            let x = disc.position.x + seen * disc.velocity.x;
            let free = self.side.is_some_and(|side| {
                (disc.radius..side - disc.radius).contains(&x) && height < side - disc.radius
            });
            // A bounce of some steps' height is no height.
            if !free || seen >= self.time || parting.speed / g < 50.0 * self.dt {
                return;
            }
            expected.heights.push(height);
            expected.ends = seen;
            begins += parting.apart + 2.0 * parting.speed / g;
            touch.speed = parting.speed;
        }
    }

    /// When a disc in free flight would touch each wall, s, earliest first, with the wall's normal.
    /// `None` without walls, in a push that is not along y, or in contact at the start.
    fn walls_ahead(&self, disc: &Particle) -> Option<Vec<(f64, DVec2)>> {
        let side = self.side.filter(|_| self.gravity.x == 0.0)?;
        let room = side - 2.0 * disc.radius;
        let from_low = disc.position - DVec2::splat(disc.radius);
        let mut walls = Vec::new();
        for (gap, normal) in [
            (from_low.x, DVec2::NEG_X),
            (room - from_low.x, DVec2::X),
            (from_low.y, DVec2::NEG_Y),
            (room - from_low.y, DVec2::Y),
        ] {
            if gap < 0.0 {
                return None;
            }
            let (speed, push) = (disc.velocity.dot(normal), self.gravity.dot(normal));
            walls.push((time_to_cover(gap, speed, push), normal));
        }
        walls.sort_by(|a, b| a.0.total_cmp(&b.0));
        Some(walls)
    }

    /// Two discs, away from the walls. In their fall together gravity does not show.
    fn meeting_of(&self, i: &Particle, j: &Particle) -> Option<Expected> {
        let (apart, velocity) = (j.position - i.position, i.velocity - j.velocity);
        let reach = i.radius + j.radius;
        // |apart - velocity t| = reach, the earlier root.
        let (half_b, c) = (apart.dot(velocity), apart.length_squared() - reach * reach);
        let square = velocity.length_squared();
        let begins = c / (half_b + (half_b * half_b - square * c).sqrt());
        if c < 0.0 || half_b <= 0.0 || begins.is_nan() {
            return None; // in contact, parting, or passing by
        }
        let normal = (apart - begins * velocity) / reach;
        let reduced_mass = i.mass * j.mass / (i.mass + j.mass);
        let touch = self.touch(reduced_mass, velocity.dot(normal), 0.0);
        let bounce = touch.bounce();
        let ends = begins + self.length(&bounce, &touch);
        // Softer discs pass through each other.
        let is_soft = bounce.depth > 0.9 * reach;
        let next = [i, j].map(|disc| match self.side {
            Some(_) => self.walls_ahead(disc).map_or(0.0, |walls| walls[0].0),
            None => f64::INFINITY,
        });
        let is_clear = ends < next[0].min(next[1]).min(self.time);
        let is_glancing = touch.speed < 0.1 * velocity.length();
        (is_clear && !is_soft && !is_glancing).then_some(Expected {
            wall: None,
            touch,
            bounce,
            begins,
            ends,
            heights: Vec::new(),
            turn: velocity.perp_dot(normal).abs() * (ends - begins) / reach,
        })
    }

    /// Depth, duration, restitution and heights of a stepped run, as far as theory has them; not a
    /// number where the run does not get so far.
    fn measure(&self, expected: &Expected, mut run: Simulation, ahead: f64) -> Vec<f64> {
        let mut seen = Seen::default();
        let mut before = self.state(expected, &run);
        let (end, bounces) = (expected.ends - ahead, expected.heights.len());
        // A method that gains energy flies higher, and longer.
        while run.time() < end || (seen.heights.len() < bounces && run.time() < 1.5 * end) {
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
            // Until the touch there is only the push.
            self.touch_speed = Some(before.speed + part * dt * push);
        }
        let hold = |state: State| match end {
            ContactEnd::OverlapZero => -state.gap,
            ContactEnd::ForceZero => eta * state.speed - stiffness * state.gap,
        };
        if let (Some(touched_at), None, true) = (self.touched_at, self.duration, hold(now) <= 0.0) {
            let part = hold(before) / (hold(before) - hold(now));
            self.duration = Some(time - (1.0 - part) * dt - touched_at);
        }
        if before.gap < 0.0 && now.gap >= 0.0 && self.parting_speed.is_none() {
            // Here, too, there is only the push: back to where the surfaces parted.
            let rest = now.gap / (now.gap - before.gap);
            self.parting_speed = Some(rest * dt * push - now.speed);
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

/// Time, s, to cover `gap` (m) from `speed` (m/s) under `push` (m/s2); infinite if it never is.
fn time_to_cover(gap: f64, speed: f64, push: f64) -> f64 {
    let square = speed * speed + 2.0 * push * gap;
    if square < 0.0 {
        return f64::INFINITY; // turns back before
    }
    let time = if push > 0.0 && speed < 0.0 {
        (square.sqrt() - speed) / push // away first
    } else {
        2.0 * gap / (speed + square.sqrt())
    };
    if time >= 0.0 && time.is_finite() { time } else { f64::INFINITY }
}

/// The order of `(ln dt, error)`; none where an error is round-off.
fn order(errors: &[(f64, f64)]) -> Option<f64> {
    let is_clear = errors.iter().all(|&(_, error)| error > ROUND_OFF);
    let logarithms: Vec<_> = errors.iter().map(|&(dt, error)| (dt, error.ln())).collect();
    Line::through(&logarithms).filter(|_| is_clear).map(|line| line.slope)
}
