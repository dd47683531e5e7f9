//! The rubric: a course's numbers, tolerances and points, from a TOML file.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use super::check::Check;
use crate::analysis::collision::{ContactEnd, angular_frequency, damping_ratio, restitution};

/// What a skipped check does to the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Skipped {
    /// Nothing: one mistake costs one check.
    LeftOut,
    /// They are lost with the check they hang on.
    Lost,
}

/// A course's numbers. SI units.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub struct Rubric {
    /// Number of discs: any of these; empty for any number.
    pub n: Vec<usize>,
    /// Side of the box, m.
    pub side: f64,
    /// Lower left corner of the box, m.
    pub corner: [f64; 2],
    /// Radius, m: any of these; empty for any.
    pub radius: Vec<f64>,
    /// Mass, kg.
    pub mass: f64,
    /// Gravity, m/s2, positive downward.
    pub gravity: f64,
    /// Stiffness k_n, N/m.
    pub kn: f64,
    /// Damping eta_n, kg/s; not used if `restitution` is given.
    pub eta: f64,
    /// Restitution e of walls and pairs.
    pub restitution: Option<f64>,
    /// How far the median of measured restitutions may be off.
    pub restitution_tolerance: f64,
    /// By what part of itself the energy may change.
    pub energy_tolerance: f64,
    /// What a skipped check does to the points.
    pub skipped: Skipped,
    /// Points of each check.
    pub points: BTreeMap<Check, f64>,
}

impl Default for Rubric {
    fn default() -> Self {
        Self {
            n: Vec::new(),
            side: 0.04,
            corner: [0.0; 2],
            radius: vec![1e-4, 5e-4],
            mass: 1e-3,
            gravity: 9.81,
            kn: 5e4,
            eta: 1.5e-3,
            restitution: None,
            restitution_tolerance: 0.05,
            energy_tolerance: 0.08,
            skipped: Skipped::LeftOut,
            points: BTreeMap::new(),
        }
    }
}

/// A commented rubric with the usual numbers.
pub const COMMENTED: &str = "\
# Rubric of parsim2d grade. Every line may be left out; these are the usual numbers, in SI units.
n = []                        # number of discs: any of these; [] for any number
side = 0.04                   # m
corner = [0.0, 0.0]           # lower left corner of the box, m; [-0.02, -0.02] for a centred one
radius = [1e-4, 5e-4]         # m: any of these; [] for any
mass = 1e-3                   # kg
gravity = 9.81                # m/s2, positive downward
kn = 5e4                      # N/m: how deep discs may sink in
eta = 1.5e-3                  # kg/s: the restitution to be expected
# restitution = 1.0           # instead of eta, for walls and pairs
restitution_tolerance = 0.05  # how far the median may be off
energy_tolerance = 0.08       # by what part of itself the energy may change
skipped = \"left_out\"          # checks that hang on a failed one: \"left_out\" of the points, or \"lost\"

[points]
frames = 1.0
discs = 1.0
radii = 1.0
box = 1.0
start = 1.0
free_flight = 3.0
wall_bounce = 2.0
pair_collision = 2.0
restitution_wall = 1.0
restitution_pair = 1.0
energy = 2.0
";

impl Rubric {
    /// Reads a rubric. Errors name the line, key, value and way out.
    pub fn parse(text: &str) -> Result<Self, String> {
        let rubric: Self = toml::from_str(text).map_err(|why| why.to_string())?;
        rubric.refused().map_or(Ok(rubric), Err)
    }

    fn refused(&self) -> Option<String> {
        let positive = [("side", self.side), ("mass", self.mass), ("kn", self.kn)];
        let not_negative = [
            ("gravity", self.gravity),
            ("eta", self.eta),
            ("restitution_tolerance", self.restitution_tolerance),
            ("energy_tolerance", self.energy_tolerance),
        ];
        let bad = |ok: bool, name: &str, value: f64, range: &str| {
            (!ok).then(|| format!("{name} = {value} is out of range; it is {range}"))
        };
        let radii = self.radius.iter().map(|&r| ("radius", r));
        let more = positive.into_iter().chain(radii);
        let more = more.map(|(k, v)| bad(v.is_finite() && v > 0.0, k, v, "above 0"));
        let points = self.points.iter().map(|(check, &points)| (check.id(), points));
        let rest = not_negative.into_iter().chain(points);
        let rest = rest.map(|(k, v)| bad(v.is_finite() && v >= 0.0, k, v, "0 or more"));
        let e = self.restitution.unwrap_or(1.0);
        let corner = self.corner.iter().find(|value| !value.is_finite());
        more.chain(rest)
            .flatten()
            .next()
            .or_else(|| bad(e > 0.0 && e <= 1.0, "restitution", e, "above 0 and at most 1"))
            .or_else(|| bad(corner.is_none(), "corner", *corner?, "two finite numbers"))
    }

    /// Points of a check.
    pub fn points_of(&self, check: Check) -> f64 {
        self.points.get(&check).copied().unwrap_or(check.usual_points())
    }

    /// Reduced masses of a wall contact and of a pair, kg.
    fn reduced_mass(&self, is_wall: bool) -> f64 {
        if is_wall { self.mass } else { 0.5 * self.mass }
    }

    /// omega0 of a contact with a wall, or of a pair, 1/s.
    pub fn omega0(&self, is_wall: bool) -> f64 {
        angular_frequency(self.kn, self.reduced_mass(is_wall))
    }

    /// The smallest and largest restitution that is right: a contact may end at overlap zero or
    /// at force zero.
    pub fn expected_restitution(&self, is_wall: bool) -> (f64, f64) {
        if let Some(e) = self.restitution {
            return (e, e);
        }
        let zeta = damping_ratio(self.eta, self.kn, self.reduced_mass(is_wall));
        let ends = [ContactEnd::OverlapZero, ContactEnd::ForceZero];
        let [a, b] = ends.map(|end| restitution(zeta, end));
        (a.min(b), a.max(b))
    }

    /// Whether nothing takes energy.
    pub fn is_elastic(&self) -> bool {
        self.expected_restitution(true).0 == 1.0
    }
}
