//! One contact of the linear spring-dashpot under a constant push, such as a bounce on the floor
//! with gravity: x'' + 2 beta x' + omega0² x = a, x the overlap, from x = 0 and x' = v.
//!
//! Without the push, `collision.rs` has the closed forms. With it the end of the contact is the root
//! of a known function, found here by bisection to round-off. Gravity makes restitution hang on
//! the speed: a slow enough disc stays.

use super::collision::{ContactEnd, angular_frequency};

/// A contact before it begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Stiffness k_n, N/m.
    pub stiffness: f64,
    /// Damping coefficient eta_n, kg/s.
    pub eta: f64,
    /// Reduced mass m_eff, kg.
    pub reduced_mass: f64,
    /// Approach speed at the touch, m/s.
    pub speed: f64,
    /// Constant acceleration into the contact, m/s2: g on a floor, 0 for a pair.
    pub push: f64,
    /// When the contact counts as over.
    pub end: ContactEnd,
}

/// What the contact does.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounce {
    /// Largest overlap, m.
    pub depth: f64,
    /// How it ends; `None` if the bodies stay together.
    pub parting: Option<Parting>,
}

/// The end of a contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parting {
    /// Duration of the contact, s.
    pub duration: f64,
    /// When the overlap is back to zero, s after the touch: a while after a contact that ended with
    /// its force.
    pub apart: f64,
    /// Speed at which the surfaces part then, m/s.
    pub speed: f64,
}

impl Touch {
    /// Depth, duration and parting speed.
    ///
    /// ```
    /// use parsim2d::analysis::bounce::Touch;
    /// use parsim2d::analysis::collision::ContactEnd;
    /// // The guide's disc falls through its box: 1.2528 r without the weight, a hair more with it.
    /// let fall = Touch {
    ///     stiffness: 5e4,
    ///     eta: 0.0,
    ///     reduced_mass: 1e-3,
    ///     speed: (2.0f64 * 9.81 * 0.04).sqrt(),
    ///     push: 9.81,
    ///     end: ContactEnd::OverlapZero,
    /// };
    /// let bounce = fall.bounce();
    /// assert!((bounce.depth / 1e-4 - 1.2548).abs() < 5e-5); // (v/w0 and m g / k) / r
    /// let parting = bounce.parting.unwrap();
    /// assert!((parting.speed / fall.speed - 1.0).abs() < 1e-12); // elastic
    /// ```
    pub fn bounce(&self) -> Bounce {
        let omega0 = angular_frequency(self.stiffness, self.reduced_mass);
        // Sixty looks a swing miss no turn of so smooth a function; after a hundred swings a body
        // that is still there stays.
        let look = 0.1 / omega0;
        let (mut deepest, mut t) = (None, 0.0);
        while t < 600.0 / omega0 {
            let next = t + look;
            let (_, speed) = self.motion(next);
            if deepest.is_none() && speed <= 0.0 {
                deepest = Some(root(t, next, |t| self.motion(t).1));
            }
            if deepest.is_some() && self.hold(next) <= 0.0 {
                let begin = if self.hold(t) > 0.0 { t } else { deepest.unwrap_or(t) };
                let duration = root(begin, next, |t| self.hold(t));
                return Bounce { depth: self.depth(deepest), parting: self.parting(duration) };
            }
            t = next;
        }
        Bounce { depth: self.depth(deepest), parting: None }
    }

    /// From the end of the contact to where the surfaces part; `None` for a disc so slow that the push
    /// brings the force back before.
    fn parting(&self, duration: f64) -> Option<Parting> {
        let (overlap, speed) = match self.end {
            ContactEnd::OverlapZero => (0.0, -self.motion(duration).1),
            ContactEnd::ForceZero => (self.motion(duration).0, -self.motion(duration).1),
        };
        // At force zero k x = eta u; the force returns if k u < eta a.
        let square = speed * speed - 2.0 * self.push * overlap;
        if square <= 0.0 || self.stiffness * speed < self.eta * self.push {
            return None;
        }
        let flight = 2.0 * overlap / (speed + square.sqrt());
        Some(Parting { duration, apart: duration + flight, speed: square.sqrt() })
    }

    fn depth(&self, deepest: Option<f64>) -> f64 {
        // An overdamped disc creeps towards its rest from above.
        let rest = self.push * self.reduced_mass / self.stiffness;
        deepest.map_or(rest, |t| self.motion(t).0)
    }

    /// What is above 0 while the contact lasts: the overlap (m), or the force (N).
    fn hold(&self, t: f64) -> f64 {
        let (overlap, speed) = self.motion(t);
        match self.end {
            ContactEnd::OverlapZero => overlap,
            ContactEnd::ForceZero => self.stiffness * overlap + self.eta * speed,
        }
    }

    /// Overlap (m) and approach speed (m/s) at `t` s after the touch.
    fn motion(&self, t: f64) -> (f64, f64) {
        let squared = self.stiffness / self.reduced_mass; // omega0²
        let beta = 0.5 * self.eta / self.reduced_mass;
        // x = rest + a c + b s, with c = e^(-beta t) cos wt, s = e^(-beta t) sin wt / w, w² = omega0² -
        // beta², and cosh, sinh where w² < 0 (as sums, for e^(-beta t) alone may be nothing).
        let w_squared = squared - beta * beta;
        let w = w_squared.abs().sqrt();
        let decay = (-beta * t).exp();
        let (c, s) = if w * t < 1e-6 {
            (decay, decay * t)
        } else if w_squared > 0.0 {
            (decay * (w * t).cos(), decay * (w * t).sin() / w)
        } else {
            let (slow, fast) = (((w - beta) * t).exp(), (-(w + beta) * t).exp());
            (0.5 * (slow + fast), 0.5 * (slow - fast) / w)
        };
        let rest = self.push / squared;
        let (a, b) = (-rest, self.speed - beta * rest);
        let swing = a * c + b * s;
        (rest + swing, b * c - w_squared * a * s - beta * swing)
    }
}

/// The root of `f` between `low`, where it is above 0, and `high`, where it is not: to the last bit.
fn root(mut low: f64, mut high: f64, f: impl Fn(f64) -> f64) -> f64 {
    // Each turn halves the interval: 60 turns leave 1e-18 of it.
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if f(middle) > 0.0 { low = middle } else { high = middle }
    }
    0.5 * (low + high)
}
