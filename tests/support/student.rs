//! The guide's program as a student writes it, right or with one bug.
#![allow(dead_code)] // not every test uses all of it

use std::fmt::Write as _;

use parsim2d::grading::judge::check::Check;
use parsim2d::grading::judge::mistake::Mistake;
use parsim2d::grading::judge::rubric::Rubric;
use parsim2d::grading::judge::verdict::Report;

/// A bug of the little program below.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Bug {
    None,
    ExplicitEuler,
    GravitySign,
    GravityMissing,
    GravitySideways,
    WallMissing,
    InwardWallNormal,
    WallAtCentre,
    OneDiscOnly,
    ContactAtOneRadius,
    NoPairContact,
    PlacedOverlapping,
    PlacedInWall,
    Diameter,
    NotANumber,
    DiscLost,
    OrderChanges,
    Friction,
    UnevenFrames,
    DampingSign,
    TooMuchDamping,
    ForceOverWrongMass,
    NormalNotNormalised,
    ForceAppliedTwice,
    DashpotAtFloorOnly,
    /// The last disc meets nobody.
    LastMeetsNobody,
    /// Discs below the floor are put on it, and keep their speed.
    FloorSticks,
    /// Forces of all steps are added up.
    ForcesNotReset,
    /// A tenth of the stiffness everywhere.
    SoftSprings,
    /// A tenth of the stiffness between discs.
    SoftPairs,
    /// Both of a pair are pushed the same way.
    SameSign,
    /// Who is slower than 0.1 m/s stops.
    Sleeps,
    /// Nobody is faster than 0.4 m/s.
    SpeedLimit,
    /// The right wall stands at 45 mm.
    WallFurther,
    /// eta is 0.
    NoDashpot,
    /// Who leaves at a side comes in at the other.
    Periodic,
    /// Steps move copies.
    MovesCopies,
    /// The first disc that touches the left wall 8 mm and more over the floor stays there.
    StaysAtWall,
    /// Discs that lie on the floor are given a speed along it.
    NeverLiesStill,
    /// Discs stay on the floor for 40 frames before they bounce.
    WaitsOnFloor,
}

/// The guide's program as a student writes it: two loops, Eq. (1) to (3).
pub struct Program {
    pub bug: Bug,
    pub n: usize,
    pub radius: f64,
    pub eta: f64,
    pub every: usize,
    pub frames: usize,
    pub seed: u64,
    /// N_t of Eq. (2).
    pub steps: f64,
    /// A frame whenever the time has passed a multiple of this, s, in place of one every so many steps.
    pub period: Option<f64>,
    /// Whether discs start without speeds, as the guide has it.
    pub at_rest: bool,
}

const STIFFNESS: f64 = 5e4;
const MASS: f64 = 1e-3;
const SIDE: f64 = 0.04;

type Disc = [f64; 4]; // x y vx vy

impl Program {
    pub fn new(bug: Bug, seed: u64) -> Self {
        let (n, radius, eta, every, frames, steps) = (20, 5e-4, 0.0, 60, 400, 30.0);
        Self { bug, n, radius, eta, every, frames, seed, steps, period: None, at_rest: false }
    }

    /// Eq. (2), s.
    fn dt(&self) -> f64 {
        std::f64::consts::PI * (MASS / STIFFNESS).sqrt() / self.steps
    }

    fn random(&mut self) -> f64 {
        self.seed = self.seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.seed >> 11) as f64 / (1u64 << 53) as f64
    }

    fn place(&mut self) -> Vec<Disc> {
        let mut discs: Vec<Disc> = Vec::new();
        let r = self.radius;
        let margin = if self.bug == Bug::PlacedInWall { 0.0 } else { 1.01 * r };
        while discs.len() < self.n {
            let x = margin + (SIDE - 2.0 * margin) * self.random();
            let y = margin + (SIDE - 2.0 * margin) * self.random();
            let v = [self.random() - 0.5, self.random() - 0.5];
            let v = if self.at_rest { [0.0; 2] } else { v };
            let is_free = |d: &Disc| (d[0] - x).hypot(d[1] - y) > 2.02 * r;
            if discs.iter().all(is_free) {
                discs.push([x, y, v[0], v[1]]);
            }
        }
        match self.bug {
            Bug::PlacedOverlapping => {
                let beside = [discs[0][0] + r, discs[0][1]];
                discs[1][..2].copy_from_slice(&beside);
            }
            Bug::PlacedInWall => discs[3][0] = 0.3 * r,
            _ => {}
        }
        discs
    }

    /// What becomes of a wall's push along an axis.
    fn at_wall(&self, push: f64, axis: usize) -> f64 {
        match self.bug {
            Bug::WallMissing => 0.0,
            Bug::Periodic if axis == 0 => 0.0,
            Bug::InwardWallNormal => -push,
            Bug::ForceOverWrongMass => MASS * push,
            _ => push,
        }
    }

    fn forces(&self, discs: &[Disc]) -> Vec<[f64; 2]> {
        let g = match self.bug {
            Bug::GravitySign => [0.0, 9.81],
            Bug::GravityMissing => [0.0, 0.0],
            Bug::GravitySideways => [9.81, 0.0],
            _ => [0.0, -9.81],
        };
        let mut forces: Vec<[f64; 2]> = vec![[MASS * g[0], MASS * g[1]]; discs.len()];
        let eta = match self.bug {
            Bug::DampingSign => -self.eta,
            Bug::TooMuchDamping => 2.0,
            Bug::DashpotAtFloorOnly | Bug::NoDashpot => 0.0,
            _ => self.eta,
        };
        let stiffness = if self.bug == Bug::SoftSprings { 0.1 * STIFFNESS } else { STIFFNESS };
        self.pairs(discs, eta, &mut forces);
        let reach = if self.bug == Bug::WallAtCentre { 0.0 } else { self.radius };
        for (disc, force) in discs.iter().zip(&mut forces) {
            for (axis, high) in [(0, false), (0, true), (1, false), (1, true)] {
                let sign = if high { 1.0 } else { -1.0 }; // of the normal, to the wall
                let is_further = self.bug == Bug::WallFurther && axis == 0;
                let side = if is_further { 0.045 } else { SIDE };
                let depth = reach - if high { side - disc[axis] } else { disc[axis] };
                let is_floor = axis == 1 && !high;
                let eta = if self.bug == Bug::DashpotAtFloorOnly && is_floor { 1.0 } else { eta };
                let push = -stiffness * depth * sign - eta * disc[axis + 2];
                if depth > 0.0 {
                    force[axis] += self.at_wall(push, axis);
                }
            }
            if self.bug == Bug::Friction {
                force[0] -= 5e-3 * disc[2];
                force[1] -= 5e-3 * disc[3];
            }
        }
        forces
    }

    fn pairs(&self, discs: &[Disc], eta: f64, forces: &mut [[f64; 2]]) {
        let reach = match self.bug {
            Bug::ContactAtOneRadius => self.radius,
            Bug::NoPairContact => 0.0,
            _ => 2.0 * self.radius,
        };
        let stiffness = match self.bug {
            Bug::SoftSprings | Bug::SoftPairs => 0.1 * STIFFNESS,
            _ => STIFFNESS,
        };
        let met = discs.len() - usize::from(self.bug == Bug::LastMeetsNobody);
        for i in 0..met {
            for j in i + 1..met {
                let way = [discs[j][0] - discs[i][0], discs[j][1] - discs[i][1]];
                let distance = way[0].hypot(way[1]);
                if distance >= reach || distance == 0.0 {
                    continue;
                }
                let length = if self.bug == Bug::NormalNotNormalised { 1.0 } else { distance };
                let n = [way[0] / length, way[1] / length];
                let v = (discs[i][2] - discs[j][2]) * n[0] + (discs[i][3] - discs[j][3]) * n[1];
                let push = stiffness * (reach - distance) + eta * v;
                let push = match self.bug {
                    Bug::ForceOverWrongMass => MASS * push,
                    Bug::ForceAppliedTwice => 2.0 * push,
                    _ => push,
                };
                for axis in 0..2 {
                    forces[i][axis] -= push * n[axis];
                    forces[j][axis] += match self.bug {
                        Bug::OneDiscOnly => 0.0,
                        Bug::SameSign => -push * n[axis],
                        _ => push * n[axis],
                    };
                }
            }
        }
    }

    fn step(&self, discs: &mut [Disc], sums: &mut [[f64; 2]]) {
        let mut forces = self.forces(discs);
        if self.bug == Bug::ForcesNotReset {
            for (force, sum) in forces.iter_mut().zip(sums) {
                *sum = [sum[0] + force[0], sum[1] + force[1]];
                *force = *sum;
            }
        }
        for (disc, force) in discs.iter_mut().zip(forces) {
            for axis in 0..2 {
                let old = disc[axis + 2];
                disc[axis + 2] += force[axis] / MASS * self.dt();
                let mover = if self.bug == Bug::ExplicitEuler { old } else { disc[axis + 2] };
                disc[axis] += mover * self.dt();
            }
        }
    }

    /// Places and speeds that some bugs set after a step.
    fn set(&self, disc: &mut Disc) {
        if self.bug == Bug::FloorSticks && disc[1] < self.radius {
            disc[1] = self.radius;
        }
        if self.bug == Bug::Periodic {
            disc[0] = disc[0].rem_euclid(SIDE);
        }
        let speed = disc[2].hypot(disc[3]);
        let factor = match self.bug {
            Bug::Sleeps if speed < 0.1 => 0.0,
            Bug::SpeedLimit if speed > 0.4 => 0.4 / speed,
            _ => 1.0,
        };
        disc[2..].iter_mut().for_each(|v| *v *= factor);
    }

    /// What some bugs do after a step; `held` are discs that do not move, with their steps left.
    fn meddle(&self, discs: &mut [Disc], before: &[Disc], held: &mut Vec<(usize, usize, Disc)>) {
        held.retain_mut(|(i, left, kept)| {
            *left -= 1;
            discs[*i] = if *left == 0 { *kept } else { [kept[0], kept[1], 0.0, 0.0] };
            *left > 0
        });
        for (i, disc) in discs.iter_mut().enumerate() {
            let depth = self.radius - disc[1];
            self.set(disc);
            let lies = depth > 0.0 && depth < 3.0 * MASS * 9.81 / STIFFNESS && disc[3].abs() < 0.02;
            let is_at_wall = disc[0] < 1.1 * self.radius || disc[0] > SIDE - 1.1 * self.radius;
            let is_touched = |(j, d): (usize, &Disc)| {
                j != i && (d[0] - disc[0]).hypot(d[1] - disc[1]) < 2.1 * self.radius
            };
            if self.bug == Bug::NeverLiesStill
                && lies
                && disc[2].abs() < 0.4
                && !is_at_wall
                && !before.iter().enumerate().any(is_touched)
            {
                disc[2] = 0.4f64.copysign(disc[2]);
            }
            let [x, y, ..] = before[i];
            let is_first = self.bug == Bug::StaysAtWall && held.is_empty() && y > 0.008;
            if is_first && x < self.radius {
                held.push((i, usize::MAX, [self.radius, y, 0.0, 0.0]));
            }
            let touches = depth > 0.0 && before[i][1] >= self.radius && disc[3] < 0.0;
            if self.bug == Bug::WaitsOnFloor && touches {
                let [x, y, vx, vy] = before[i];
                held.push((i, 40 * self.every, [x, y, vx, -vy]));
            }
        }
    }

    /// What it writes: six significant digits, as C++ streams do.
    pub fn output(mut self) -> String {
        let mut discs = self.place();
        let (mut out, mut held) = (String::new(), Vec::new());
        let mut sums = vec![[0.0; 2]; self.n];
        let (mut time, mut next) = (0.0, 0.0);
        let printed = if self.bug == Bug::Diameter { 2.0 * self.radius } else { self.radius };
        for frame in 0..self.frames {
            if self.bug == Bug::OrderChanges && frame % 40 == 20 {
                discs.swap(0, 1);
            }
            if self.bug == Bug::DiscLost && frame == 100 {
                discs.pop();
            }
            for (i, disc) in discs.iter().enumerate() {
                let x = if self.bug == Bug::NotANumber && frame == 50 && i == 7 {
                    f64::NAN
                } else {
                    disc[0]
                };
                writeln!(out, "{} {} {}", general(x), general(disc[1]), general(printed)).unwrap();
            }
            out.push('\n');
            let more = self.bug == Bug::UnevenFrames && self.random() < 0.5;
            next += self.period.unwrap_or_default();
            let mut left = if more { 2 * self.every } else { self.every };
            while if self.period.is_some() { time < next } else { left > 0 } {
                (time, left) = (time + self.dt(), left.saturating_sub(1));
                let before = discs.clone();
                self.step(&mut discs, &mut sums);
                self.meddle(&mut discs, &before, &mut held);
                if self.bug == Bug::MovesCopies {
                    discs = before;
                }
            }
        }
        out
    }
}

/// Six significant digits without trailing zeros.
fn general(value: f64) -> String {
    format!("{value:.5e}").parse::<f64>().unwrap().to_string()
}

pub fn elastic() -> Rubric {
    Rubric { restitution: Some(1.0), ..Rubric::default() }
}

/// eta = 0.7 kg/s: e = 0.855 at a wall, 0.800 for a pair.
pub fn damped() -> Rubric {
    Rubric { eta: 0.7, ..Rubric::default() }
}

pub fn lost(report: &Report) -> Vec<(Check, Option<Mistake>)> {
    report.failures().map(|(check, failure)| (check, failure.cause)).collect()
}
