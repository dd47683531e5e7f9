//! The largest time step that linear contacts allow.
//!
//! A contact network vibrates at most at omega with omega² = k_n lambda. Eq. (3) and velocity Verlet
//! (its dashpot fed the half-step velocity) are the same recurrence; it is stable up to
//! dt = (2/omega) (sqrt(1 + zeta²) - zeta), zeta = eta_n lambda / (2 omega), as the eigenvalues of
//! its 2x2 step matrix say. lambda is 1/m for one disc at a wall, 1/m_i + 1/m_j for a pair, 2.618/m for
//! two equal discs of which a wall holds one (`at_walls.rs`), and 6.1/m for a packed bed: 6 for the
//! triangular packing, 5.76 to 6.02 measured in settled beds (compare Burns and Hanley 2017, IJNME
//! 110:186).
//!
//! A disc of mass m_b with c small neighbours all around it adds a mode of its own, in which it moves
//! against them: k_n c/2 holds it, so that lambda is about c/(2 m_b) + 3.1/m, which for equal discs
//! (c = 6) is 6.1/m again.
//!
//! The limits are necessary, not sufficient: contacts open and close, and a step just below the
//! limit heats a crowded box. Stay below [`COARSE`] of it.

mod at_walls;

use std::f64::consts::PI;

pub use self::at_walls::TwoAtWalls;
use super::linear::{Linear, linear};
use crate::particle::SpringDashpot;

/// Above this fraction of the limit a time step is coarse: stable, and too inaccurate to trust.
pub const COARSE: f64 = 0.4;

/// The fraction of the limit that `--dt auto` takes: about Eq. (2) with N_t = 50 in an elastic bed.
pub const AUTO: f64 = 0.08;

/// omega_max² m / k_n of a packed bed.
const PACKED_BED: f64 = 6.1;

/// What of [`PACKED_BED`] is left without the half of each disc's own six neighbours.
const AROUND_A_DISC: f64 = PACKED_BED - 3.0;

/// What limits the time step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedBy {
    /// One disc at a wall.
    OneDisc,
    /// Two discs in contact.
    Pair,
    /// Two discs in contact with each other and with walls.
    PairAtWalls,
    /// Many contacts at once.
    PackedBed,
    /// Many small discs around a larger one that is light for its size.
    LargeDisc,
}

impl std::fmt::Display for LimitedBy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::OneDisc => "one disc at a wall",
            Self::Pair => "a pair of discs",
            Self::PairAtWalls => "a pair of discs at a wall",
            Self::PackedBed => "a heap of discs",
            Self::LargeDisc => "a large disc among many small ones",
        })
    }
}

/// A limit on the time step and its cause.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limit {
    /// The largest stable time step, s.
    pub dt: f64,
    /// What sets it.
    pub by: LimitedBy,
    /// Whether its fastest mode is damped so strongly that it does not swing.
    pub is_overdamped: bool,
}

/// The stable limit (s) of one mode: omega² = k_n lambda, damping eta_n lambda. k_n in N/m, eta_n in
/// kg/s, lambda in 1/kg.
///
/// ```
/// use parsim2d::analysis::stability::mode_limit;
/// // In units of 1/omega0, zeta = 0, 0.1, 0.3, 1: eta = 2 zeta for k = lambda = 1.
/// for (zeta, limit) in [(0.0, 2.0), (0.1, 1.810), (0.3, 1.488), (1.0, 0.828)] {
///     assert!((mode_limit(1.0, 2.0 * zeta, 1.0) - limit).abs() < 5e-4);
/// }
/// ```
pub fn mode_limit(stiffness: f64, eta: f64, lambda: f64) -> f64 {
    let (omega, zeta) = frequency_and_damping_ratio(stiffness, eta, lambda);
    // sqrt(1 + zeta²) - zeta, without losing digits at large zeta.
    2.0 / omega / (1.0f64.hypot(zeta) + zeta)
}

fn frequency_and_damping_ratio(stiffness: f64, eta: f64, lambda: f64) -> (f64, f64) {
    let omega = (stiffness * lambda).sqrt();
    (omega, eta * lambda / (2.0 * omega))
}

/// So many equal discs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Species {
    /// How many.
    pub n: usize,
    /// Radius of each.
    pub radius: f64, // m
    /// Mass of each.
    pub mass: f64, // kg
}

/// What the stable limit of a set of discs depends on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembly {
    /// Number of discs.
    pub n: usize,
    /// Mass of the lightest disc.
    pub lightest: f64, // kg
    /// Mass of the heaviest disc.
    pub heaviest: f64, // kg
    /// Radius of the smallest disc.
    pub smallest: f64, // m
    /// omega²/k_n of the fastest mode of one large disc against small neighbours.
    pub large_disc: f64, // 1/kg
    /// Two discs between walls; `None` for other numbers of discs, and on an open plane.
    pub at_walls: Option<TwoAtWalls>,
}

impl Assembly {
    /// The assembly of all `species`, of which there is at least one disc, in a box of `side` (m) if
    /// there are walls.
    ///
    /// ```
    /// use parsim2d::analysis::stability::{Assembly, Species};
    /// // A disc of 3 mm in a ring of 60 of 0.14 mm, all of 1 g: 70 would have room around it.
    /// let large = Species { n: 1, radius: 3e-3, mass: 1e-3 };
    /// let small = Species { n: 60, radius: 1.4e-4, mass: 1e-3 };
    /// let ring = Assembly::of(&[large, small], None);
    /// assert_eq!(ring.n, 61);
    /// assert!((ring.large_disc - (3.1 + 60.0 / 2.0) / 1e-3).abs() < 1e-6); // 1/kg
    /// ```
    pub fn of(species: &[Species], side: Option<f64>) -> Self {
        let n = species.iter().map(|s| s.n).sum::<usize>();
        let least = |of: fn(&Species) -> f64| species.iter().map(of).fold(f64::INFINITY, f64::min);
        let (lightest, smallest) = (least(|s| s.mass), least(|s| s.radius));
        let large_disc = species
            .iter()
            .map(|s| {
                let angle = (smallest / (s.radius + smallest)).asin(); // half of what one takes up
                let around = (PI / angle + 1e-9).floor().min(n.saturating_sub(1) as f64);
                AROUND_A_DISC / lightest + around / (2.0 * s.mass)
            })
            .fold(0.0, f64::max);
        let heaviest = species.iter().map(|s| s.mass).fold(0.0, f64::max);
        let two = || match *species {
            [both] => Some([both, both]),
            [one, other] => Some([one, other]),
            _ => None,
        };
        let at_walls = side.filter(|_| n == 2).zip(two()).map(|(side, two)| TwoAtWalls {
            masses: two.map(|disc| disc.mass),
            radii: two.map(|disc| disc.radius),
            side,
        });
        Self { n, lightest, heaviest, smallest, large_disc, at_walls }
    }
}

/// The limits for an assembly of discs, each with its cause: one disc at a wall, a pair (n >= 2), two
/// discs and a wall (n = 2), a packed bed (n >= 3), and a large disc among small ones where it is
/// stricter than the bed.
///
/// ```
/// use parsim2d::analysis::stability::{Assembly, LimitedBy, Species, limit};
/// use parsim2d::particle::{Damping, SpringDashpot};
/// let as_printed = SpringDashpot {
///     stiffness: 5e4,
///     damping: Damping::Coefficient(1.5e3),
///     tension: true,
/// };
/// let heap = Assembly::of(&[Species { n: 300, radius: 1e-4, mass: 1e-3 }], Some(0.04));
/// let limit = limit(&as_printed, &heap);
/// assert_eq!(limit.by, LimitedBy::PackedBed);
/// assert!((limit.dt / 2.1857e-7 - 1.0).abs() < 1e-4); // s; Eq. (2) would need N_t > 2032
/// ```
pub fn limits(law: &SpringDashpot, assembly: &Assembly) -> Vec<Limit> {
    let &Assembly { n, lightest, heaviest, smallest, large_disc, at_walls } = assembly;
    let pair_mass = lightest * heaviest / (lightest + heaviest);
    let pair_lambda = if n == 2 { 1.0 / pair_mass } else { 2.0 / lightest };
    let bed = PACKED_BED / lightest;
    let modes = [
        (1, LimitedBy::OneDisc, lightest, 1.0 / lightest),
        (2, LimitedBy::Pair, pair_mass, pair_lambda),
        (3, LimitedBy::PackedBed, pair_mass, bed),
        (3, LimitedBy::LargeDisc, pair_mass, large_disc),
    ];
    let mode = |reduced_mass: f64, lambda: f64| {
        let Linear { stiffness, damping } = linear(law, smallest, reduced_mass);
        let (_, zeta) = frequency_and_damping_ratio(stiffness, damping, lambda);
        (mode_limit(stiffness, damping, lambda), zeta >= 1.0)
    };
    let two = at_walls.map(|two| {
        let (_, is_overdamped) = mode(pair_mass, pair_lambda);
        Limit { dt: two.limit(law), by: LimitedBy::PairAtWalls, is_overdamped }
    });
    modes
        .into_iter()
        .filter(|&(discs, ..)| discs <= n.max(1))
        // The margin keeps equal discs, for which both are 6.1/m, out of the rounding.
        .filter(|&(_, by, _, lambda)| by != LimitedBy::LargeDisc || lambda > 1.001 * bed)
        .map(|(_, by, reduced_mass, lambda)| {
            let (dt, is_overdamped) = mode(reduced_mass, lambda);
            Limit { dt, by, is_overdamped }
        })
        .chain(two)
        .collect()
}

/// The strictest of [`limits`].
pub fn limit(law: &SpringDashpot, assembly: &Assembly) -> Limit {
    limits(law, assembly)
        .into_iter()
        .min_by(|a, b| a.dt.total_cmp(&b.dt))
        .expect("one disc at a wall always counts")
}

/// The factor by which explicit Euler multiplies the energy in one elastic contact of angular
/// frequency omega (1/s): each step gains 1 + (omega dt)², over pi / (omega dt) steps.
///
/// ```
/// use parsim2d::analysis::stability::explicit_euler_gain;
/// let dt = std::f64::consts::PI / 50.0; // N_t = 50 at omega = 1: a wall
/// assert!((explicit_euler_gain(1.0, dt) - 1.218).abs() < 2e-3);
/// assert!((explicit_euler_gain(2.0f64.sqrt(), dt) - 1.322).abs() < 4e-3); // a pair
/// ```
pub fn explicit_euler_gain(omega: f64, dt: f64) -> f64 {
    ((omega * dt).powi(2).ln_1p() * PI / (omega * dt)).exp()
}
