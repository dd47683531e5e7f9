//! One contact of the linear spring-dashpot in closed form: how long it lasts, how much speed
//! it gives back, how deep it goes.
//!
//! Notation: omega0 = sqrt(k_n / m_eff), zeta = eta_n / (2 sqrt(k_n m_eff)). Two ends of a contact
//! are in use and both are here: when the overlap is back to zero (the dashpot then pulls in
//! the last part; what Eq. (1) does), and when the force first crosses zero (what clipping the
//! force does; Schwager and Poeschel 2007, Granular Matter 9:465).

use std::f64::consts::PI;

/// When a contact counts as over.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactEnd {
    /// The overlap is back to zero: Eq. (1) as printed.
    OverlapZero,
    /// The force crosses zero: no tension.
    ForceZero,
}

/// Undamped angular frequency omega0, 1/s, of a contact of stiffness k_n (N/m) and reduced mass
/// m_eff (kg).
pub fn angular_frequency(stiffness: f64, reduced_mass: f64) -> f64 {
    (stiffness / reduced_mass).sqrt()
}

/// Damping ratio zeta of a contact: eta_n (kg/s), k_n (N/m), m_eff (kg).
pub fn damping_ratio(eta: f64, stiffness: f64, reduced_mass: f64) -> f64 {
    eta / (2.0 * (stiffness * reduced_mass).sqrt())
}

/// omega0 times the duration of the contact; infinite if it never ends.
///
/// ```
/// use parsim2d::analysis::collision::{ContactEnd, scaled_duration};
/// assert!((scaled_duration(0.5, ContactEnd::OverlapZero) - 3.6276).abs() < 5e-5);
/// assert!((scaled_duration(0.5, ContactEnd::ForceZero) - 2.4184).abs() < 5e-5);
/// ```
pub fn scaled_duration(zeta: f64, end: ContactEnd) -> f64 {
    let root = (1.0 - zeta * zeta).abs().sqrt();
    match end {
        ContactEnd::OverlapZero if zeta < 1.0 => PI / root,
        ContactEnd::OverlapZero => f64::INFINITY,
        // Near zeta = 1 both closed forms are 0/0; the limit is 2.
        ContactEnd::ForceZero if root < 1e-6 => 2.0,
        ContactEnd::ForceZero if zeta < 1.0 => (PI - 2.0 * zeta.asin()) / root,
        // (zeta + root) / (zeta - root) = (zeta + root)², as their product is 1.
        ContactEnd::ForceZero => 2.0 * (zeta + root).ln() / root,
    }
}

/// Restitution e: speed after over speed before; 0 if the contact never ends.
///
/// ```
/// use parsim2d::analysis::collision::{ContactEnd, restitution};
/// assert!((restitution(0.1, ContactEnd::OverlapZero) - 0.72925).abs() < 5e-6);
/// assert!((restitution(1.0, ContactEnd::ForceZero) - 0.13534).abs() < 5e-6);
/// ```
pub fn restitution(zeta: f64, end: ContactEnd) -> f64 {
    (-zeta * scaled_duration(zeta, end)).exp()
}

/// The damping ratio that gives restitution `e`, 0 < e <= 1.
///
/// ```
/// use parsim2d::analysis::collision::{ContactEnd, damping_ratio_for, restitution};
/// for end in [ContactEnd::OverlapZero, ContactEnd::ForceZero] {
///     let zeta = damping_ratio_for(0.3, end);
///     assert!((restitution(zeta, end) - 0.3).abs() < 1e-12);
/// }
/// ```
pub fn damping_ratio_for(e: f64, end: ContactEnd) -> f64 {
    match end {
        ContactEnd::OverlapZero => -e.ln() / PI.hypot(e.ln()),
        ContactEnd::ForceZero => {
            // e falls steadily with zeta; no closed inverse is known. e < 1e-6 from zeta 1e3 on.
            let (mut low, mut high) = (0.0, 1.0);
            while restitution(high, end) > e {
                high *= 2.0;
            }
            for _ in 0..200 {
                let middle = 0.5 * (low + high);
                if restitution(middle, end) > e { low = middle } else { high = middle }
            }
            0.5 * (low + high)
        }
    }
}

/// Largest overlap, m, of a contact that begins at `speed` (m/s).
///
/// Undamped it is v/omega0; with damping (v/omega0) exp(-(zeta/w) atan(w/zeta)), w = sqrt(1-zeta²),
/// and its continuation with atanh for zeta > 1.
///
/// ```
/// use parsim2d::analysis::collision::largest_overlap;
/// let fall = (2.0f64 * 9.81 * 0.04).sqrt(); // through the guide's box, m/s
/// assert!((largest_overlap(fall, 0.0, 5e4, 1e-3) / 1e-4 - 1.2528).abs() < 5e-5); // in radii
/// ```
pub fn largest_overlap(speed: f64, zeta: f64, stiffness: f64, reduced_mass: f64) -> f64 {
    let w = (1.0 - zeta * zeta).abs().sqrt();
    let decay = if zeta == 0.0 {
        0.0
    } else if w < 1e-6 {
        1.0
    } else if zeta < 1.0 {
        zeta / w * (w / zeta).atan()
    } else {
        zeta / w * (w / zeta).atanh()
    };
    speed / angular_frequency(stiffness, reduced_mass) * (-decay).exp()
}
