//! What theory says of a run of one or two discs: who is met first, and what then happens.

use glam::DVec2;

use super::question::Question;
use crate::analysis::bounce::{Bounce, Touch};
use crate::analysis::collision::ContactEnd;
use crate::analysis::linear::{Linear, linear};
use crate::particle::Particle;

/// Heights after a bounce, at most.
const HEIGHTS: usize = 3;

/// The first contact of a run, as theory sees it.
pub(super) struct Expected {
    /// The plane's unit normal, outward; `None` for a pair.
    pub wall: Option<DVec2>,
    pub touch: Touch,
    pub bounce: Bounce,
    /// When it begins and when all that is compared has happened, s.
    pub begins: f64,
    pub ends: f64,
    /// Heights of the centre at the apexes after it, m.
    pub heights: Vec<f64>,
    /// Angle by which the line of centres turns while the contact lasts.
    pub turn: f64, // rad
}

impl Expected {
    /// What to say of a pair that turns.
    pub fn turning(&self) -> Option<String> {
        (self.turn > 1e-3).then(|| {
            format!(
                "the discs turn about each other by {:.1e} rad while they touch; theory takes the \
                 normal as fixed, so that a small error stays at any dt",
                self.turn
            )
        })
    }

    /// What to say where the weight of a disc, which pushes it into the wall while it touches, shows in its
    /// restitution.
    pub fn weighing(&self) -> Option<String> {
        let weightless = Touch { push: 0.0, ..self.touch }.bounce().parting?.speed;
        let with = self.bounce.parting?.speed;
        let shows = (with - weightless).abs() > 1e-4 * weightless;
        shows.then(|| {
            format!(
                "restitution is that of a disc with its weight on it; without, as `check` has it first, e = {:.4}",
                weightless / self.touch.speed
            )
        })
    }
}

impl Question {
    /// The first contact, where theory has it in closed form.
    pub(super) fn expected(&self) -> Option<Expected> {
        match self.discs[..] {
            [disc] => self.bounce_of(&disc),
            [i, j] => self.meeting_of(&i, &j),
            _ => None,
        }
    }

    /// The contact that `speed`, `push` and `reduced_mass` describe.
    fn touch(&self, reduced_mass: f64, speed: f64, push: f64) -> Touch {
        let Linear { stiffness, damping } = linear(&self.law, self.smaller_radius(), reduced_mass);
        Touch {
            stiffness,
            eta: damping,
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
        if wall == DVec2::NEG_Y && self.gravity.y < 0.0 && self.gravity.x == 0.0 {
            self.add_heights(disc, &mut expected);
        }
        Some(expected)
    }

    /// How long to look: to the end of the contact, or to the deepest point if it has none.
    fn length(&self, bounce: &Bounce, touch: &Touch) -> f64 {
        let swing = (touch.reduced_mass / touch.stiffness).sqrt();
        bounce.parting.map_or(10.0 * swing, |parting| parting.apart + swing)
    }

    /// The apexes after the first bounces off the floor, under gravity along y, as long as no other wall and
    /// no end of the run comes between.
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
    /// `None` without walls, or in contact at the start.
    fn walls_ahead(&self, disc: &Particle) -> Option<Vec<(f64, DVec2)>> {
        let side = self.side?;
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
