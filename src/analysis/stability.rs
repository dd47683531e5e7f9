//! The largest time step that linear contacts allow.
//!
//! A contact network vibrates at most at omega with omega² = k_n lambda. Eq. (3) and velocity Verlet
//! (its dashpot fed the half-step velocity) are the same recurrence; it is stable up to
//! dt = (2/omega) (sqrt(1 + zeta²) - zeta), zeta = eta_n lambda / (2 omega), as the eigenvalues of
//! its 2x2 step matrix say. lambda is 1/m for one disc at a wall, 1/m_i + 1/m_j for a pair, and
//! 6.1/m for a packed bed: 6 for the triangular packing, 5.76 to 6.02 measured in settled beds
//! (compare Burns and Hanley 2017, IJNME 110:186).
//!
//! The limits are necessary, not sufficient: contacts open and close, and a step just below the
//! limit heats a crowded box. Stay below [`COARSE`] of it.

use std::f64::consts::PI;

use crate::particle::SpringDashpot;

/// Above this fraction of the limit a time step is coarse: stable, and too inaccurate to trust.
pub const COARSE: f64 = 0.4;

/// The fraction of the limit that `--dt auto` takes: about Eq. (2) with N_t = 50 in an elastic bed.
pub const AUTO: f64 = 0.08;

/// omega_max² m / k_n of a packed bed.
const PACKED_BED: f64 = 6.1;

/// What limits the time step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LimitedBy {
    /// One disc at a wall.
    OneDisc,
    /// Two discs in contact.
    Pair,
    /// Many contacts at once.
    PackedBed,
}

impl std::fmt::Display for LimitedBy {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(match self {
            Self::OneDisc => "one disc at a wall",
            Self::Pair => "a pair of discs",
            Self::PackedBed => "a heap of discs",
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

/// The limit for `n` discs whose lightest has mass `lightest` and heaviest `heaviest` (kg):
/// the strictest of one disc at a wall, a pair (n >= 2) and a packed bed (n >= 3).
///
/// ```
/// use parsim2d::analysis::stability::{LimitedBy, limit};
/// use parsim2d::particle::{Damping, SpringDashpot};
/// let as_printed = SpringDashpot {
///     stiffness: 5e4,
///     damping: Damping::Coefficient(1.5e3),
///     tension: true,
/// };
/// let heap = limit(&as_printed, 300, 1e-3, 1e-3);
/// assert_eq!(heap.by, LimitedBy::PackedBed);
/// assert!((heap.dt / 2.1857e-7 - 1.0).abs() < 1e-4); // s; Eq. (2) would need N_t > 2032
/// ```
pub fn limit(law: &SpringDashpot, n: usize, lightest: f64, heaviest: f64) -> Limit {
    let pair_mass = lightest * heaviest / (lightest + heaviest);
    let pair_lambda = if n == 2 { 1.0 / pair_mass } else { 2.0 / lightest };
    let modes = [
        (1, LimitedBy::OneDisc, lightest, 1.0 / lightest),
        (2, LimitedBy::Pair, pair_mass, pair_lambda),
        (3, LimitedBy::PackedBed, pair_mass, PACKED_BED / lightest),
    ];
    modes
        .into_iter()
        .filter(|&(discs, ..)| discs <= n.max(1))
        .map(|(_, by, reduced_mass, lambda)| {
            let eta = law.damping.coefficient(law.stiffness, reduced_mass);
            let (_, zeta) = frequency_and_damping_ratio(law.stiffness, eta, lambda);
            let dt = mode_limit(law.stiffness, eta, lambda);
            Limit { dt, by, is_overdamped: zeta >= 1.0 }
        })
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
