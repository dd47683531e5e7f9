//! Two discs and the walls of their box: the fastest way in which they vibrate together.
//!
//! A wall holds a disc with the stiffness of a disc, so that a disc between a wall and another one
//! vibrates faster than the pair in the open: for equal masses omega² = (3 + sqrt(5))/2 k_n/m, 2.618
//! in place of 2, and 2 k_n/m for a light disc between a wall and a far heavier one.
//!
//! What counts of a wall contact is how much of the line of centres lies along it: p² = 1 for a disc
//! whose walls hold it along the whole line (a wall across it, or a corner), less for a slanting one.
//! Only what can occur counts: a disc at a wall and the other straight on it; two unequal discs on one
//! floor, one of them in the corner; and, in a box too narrow for two abreast, discs from wall to wall.

use crate::analysis::linear::{Linear, linear};
use crate::particle::SpringDashpot;

/// Two discs in a square box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoAtWalls {
    /// Mass of each.
    pub masses: [f64; 2], // kg
    /// Radius of each.
    pub radii: [f64; 2], // m
    /// Side of the box.
    pub side: f64, // m
}

impl TwoAtWalls {
    /// The largest stable step, s: where the fastest mode of Eq. (3) comes to -1 a step. Each contact
    /// has its own damping, so that no common ratio is needed.
    ///
    /// ```
    /// use parsim2d::analysis::stability::TwoAtWalls;
    /// use parsim2d::particle::{Damping, SpringDashpot};
    /// let elastic =
    ///     SpringDashpot { stiffness: 5e4, damping: Damping::Coefficient(0.0), tension: true };
    /// let stack = TwoAtWalls { masses: [1e-3; 2], radii: [5e-4; 2], side: 0.04 };
    /// let omega = (0.5 * (3.0 + 5.0f64.sqrt()) * 5e4 / 1e-3).sqrt(); // 1/s
    /// assert!((stack.limit(&elastic) * omega / 2.0 - 1.0).abs() < 1e-12);
    /// ```
    pub fn limit(&self, law: &SpringDashpot) -> f64 {
        let ways = self.ways();
        let is_stable = |dt: f64| ways.iter().all(|&held| self.is_stable(law, held, dt));
        // One disc of the lighter mass alone is stable up to here, if it is not damped.
        let [a, b] = self.masses;
        let lighter = a.min(b);
        let (mut low, mut high) =
            (0.0, 2.0 * (lighter / self.linear(law, lighter).stiffness).sqrt());
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if middle == low || middle == high {
                break;
            }
            if is_stable(middle) { low = middle } else { high = middle }
        }
        low
    }

    fn linear(&self, law: &SpringDashpot, reduced_mass: f64) -> Linear {
        let [r, s] = self.radii;
        linear(law, r.min(s), reduced_mass)
    }

    /// p² of both discs, for every way in which walls can hold them.
    fn ways(&self) -> Vec<[f64; 2]> {
        let [r, s] = self.radii;
        let reach = r + s;
        let across = (self.side - reach) / reach; // of the line of centres, from wall to wall
        let mut ways = Vec::new();
        if across >= 1.0 {
            ways.extend([[1.0, 0.0], [0.0, 1.0]]); // one at a wall, the other straight on it
        } else if 2.0 * across * across > 1.0 {
            // From wall to wall; one of them in a corner, if the other, beside it, clears the floor.
            let held = across * across;
            let up = reach * (1.0 - held).sqrt();
            ways.push([held, held]);
            ways.extend((r + up >= s).then_some([1.0, held]));
            ways.extend((s + up >= r).then_some([held, 1.0]));
        } else {
            ways.push([1.0, 1.0]); // pressed into opposite corners
        }
        // Both on one floor: the line of centres rises by s - r. Beside the larger one in its corner
        // there is room; the smaller one in the corner touches the larger only if that can come near.
        let rise = ((s - r) / reach).powi(2);
        let along_floor = 2.0 * (r * s).sqrt();
        if along_floor + reach <= self.side {
            ways.push(if r < s { [rise, 1.0] } else { [1.0, rise] });
            if along_floor + r.min(s) >= r.max(s) {
                ways.push(if r < s { [1.0, rise] } else { [rise, 1.0] });
            }
        }
        ways
    }

    /// Whether no mode of discs so held grows at this step. The forces of the contacts along their
    /// modes, times dt² over the displacements, are a matrix whose largest eigenvalue must stay below
    /// 4: k_n dt² of an elastic contact over a mass, and 2 eta_n dt more of a damped one.
    fn is_stable(&self, law: &SpringDashpot, held: [f64; 2], dt: f64) -> bool {
        let [a, b] = self.masses;
        let weight = |mass: f64| {
            let Linear { stiffness, damping } = self.linear(law, mass);
            stiffness * dt * dt + 2.0 * dt * damping
        };
        let between = weight(a * b / (a + b));
        let mut left = 4.0 - between * (1.0 / a + 1.0 / b);
        for (mass, held) in [(a, held[0]), (b, held[1])] {
            if held == 0.0 {
                continue;
            }
            let wall = weight(mass) / mass;
            if wall >= 4.0 {
                return false;
            }
            left -= held * (between / mass) * wall / (4.0 - wall);
        }
        left > 0.0
    }
}
