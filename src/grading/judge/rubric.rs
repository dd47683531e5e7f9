//! The rubric: a course's numbers, tolerances and points, from a TOML file.

pub mod interface;
pub mod program;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

use self::interface::Interface;
use self::program::Program;
use super::check::Check;
use super::mistake::Mistake;
use crate::analysis::collision::{ContactEnd, angular_frequency, damping_ratio, restitution};
use crate::table::table;

/// What a skipped check does to the points.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Skipped {
    /// Nothing, if there were frames: one mistake costs one check. Without frames there is nothing to earn
    /// points by, and they are lost.
    LostWithoutFrames,
    /// Nothing, whatever it hangs on.
    LeftOut,
    /// They are lost with the check they hang on.
    Lost,
}

impl Skipped {
    /// Whether the points of `check`, which hangs on the failed `root`, are lost.
    pub fn is_lost(self, check: Check, root: Check) -> bool {
        match self {
            // No motion hangs on the box but what nobody could see.
            Self::LostWithoutFrames => {
                root <= Check::Frames || root == Check::Box && check.is_of_motion()
            }
            Self::LeftOut => false,
            Self::Lost => true,
        }
    }
}

/// What pushes discs apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Law {
    /// Springs, Eq. (1): a contact takes time and depth.
    Spring,
    /// Impulses: a contact takes neither.
    Hard,
}

/// What a submission loses that took eta_n = 1.5e3 as the guide prints it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum PrintedEta {
    /// Nothing: it did as told. The report explains.
    Forgiven,
    /// The points of what discs that never part get wrong.
    Wrong,
}

/// When a student may see a check: the values of Gradescope.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Visibility {
    /// Never.
    Hidden,
    /// After the due date.
    AfterDueDate,
    /// When grades are published.
    AfterPublished,
    /// At once.
    #[default]
    Visible,
}

table! {
    /// A course's numbers. SI units.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields, default)]
    pub struct Rubric, Default {
        /// Number of discs: any of these; empty for any number.
        n: Vec<usize> = Vec::new();
        /// Side of the box, m.
        side: f64 = 0.04;
        /// Lower left corner of the box, m.
        corner: [f64; 2] = [0.0; 2];
        /// Radius, m: any of these; empty for any.
        radius: Vec<f64> = vec![1e-4, 5e-4];
        /// Mass, kg.
        mass: f64 = 1e-3;
        /// Gravity, m/s2, positive downward.
        gravity: f64 = 9.81;
        /// Stiffness k_n, N/m.
        kn: f64 = 5e4;
        /// Damping eta_n, kg/s; not used if `restitution` is given.
        eta: f64 = 1.5e-3;
        /// What pushes discs apart.
        law: Law = Law::Spring;
        /// Restitution e of walls and pairs.
        restitution: Option<f64> = None;
        /// Restitution of walls, before `restitution`.
        restitution_wall: Option<f64> = None;
        /// Restitution of pairs, before `restitution`.
        restitution_pair: Option<f64> = None;
        /// What a submission loses that took eta_n as the guide prints it.
        printed_eta: PrintedEta = PrintedEta::Forgiven;
        /// How far the median of measured restitutions may be off.
        restitution_tolerance: f64 = 0.035;
        /// By what factor the stiffness over mass and gravity may be off.
        stiffness_factor: f64 = 1.5;
        /// By what part of itself the energy may change.
        energy_tolerance: f64 = 0.08;
        /// What a skipped check does to the points.
        skipped: Skipped = Skipped::LostWithoutFrames;
        /// Points of each check.
        points: BTreeMap<Check, f64> = BTreeMap::new();
        /// What part of a check's points a mistake leaves, 0 to 1; 0 if not named.
        partial: BTreeMap<Mistake, f64> = BTreeMap::new();
        /// When students may see a check; at once if not named.
        visibility: BTreeMap<Check, Visibility> = BTreeMap::new();
        /// Hints in place of the usual ones.
        hints: BTreeMap<Mistake, String> = BTreeMap::new();
        /// How submissions are built and run.
        program: Program = Program::default();
        /// Unit tests of what students declare, if there are any.
        #[serde(skip_serializing_if = "Option::is_none")]
        interface: Option<Interface> = None;
    }
}

/// A commented rubric with the usual numbers.
pub const COMMENTED: &str = include_str!("rubric/usual.toml");

/// Why `text` is no rubric; where one value stands for a list of it, or words for a number, how to write that.
fn not_read(why: &toml::de::Error, text: &str) -> String {
    format!("{why}{}", way_out(why, text).unwrap_or_default())
}

fn way_out(why: &toml::de::Error, text: &str) -> Option<String> {
    let span = why.span()?;
    let (before, value) = (text.get(..span.start)?, text.get(span)?);
    let key = before.lines().last()?.trim_end_matches([' ', '=']).trim_start();
    let words = value.strip_prefix(['"', '\'']).and_then(|text| text.strip_suffix(['"', '\'']));
    if why.message().ends_with("expected a sequence") {
        let list = words.map_or(value.to_owned(), |words| {
            let words = words.split_whitespace().map(|word| format!("{word:?}"));
            words.collect::<Vec<_>>().join(", ")
        });
        return Some(format!("  way out: a list, {key} = [{list}]\n"));
    }
    words.filter(|_| why.message().contains("invalid type: string"))?;
    // The usual rubric has the unit after the value.
    let line = COMMENTED.lines().find(|line| line.split(" = ").next() == Some(key))?;
    let (usual, unit) = line.split_once('#').unwrap_or((line, ""));
    let unit = unit.split([',', ':', ';']).next().unwrap_or_default().trim();
    let unit = if unit.contains(' ') || unit.is_empty() { "" } else { &format!(" in {unit}") };
    let usual = usual.trim();
    Some(format!("  way out: a number{unit}, without quotes: {usual}\n"))
}

impl Rubric {
    /// Reads a rubric. Errors name the line, key, value and way out.
    pub fn parse(text: &str) -> Result<Self, String> {
        let rubric: Self = toml::from_str(text).map_err(|why| not_read(&why, text))?;
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
        let factor = self.stiffness_factor;
        let factor = bad(factor > 1.0, "stiffness_factor", factor, "above 1; inf: not asked");
        let corner = self.corner.map(|v| bad(v.is_finite(), "corner", v, "two finite numbers"));
        more.chain(rest)
            .chain(corner)
            .chain([factor])
            .flatten()
            .next()
            .or_else(|| self.part_refused())
            .or_else(|| self.program.refused())
            .or_else(|| self.n_refused())
            .or_else(|| self.points_refused())
            .or_else(|| self.eta_refused())
            .or_else(|| self.interface.as_ref().and_then(Interface::refused))
    }

    /// A number of discs that programs are told, and that would then be called wrong.
    fn n_refused(&self) -> Option<String> {
        let (n, asked) = (self.program.n, &self.n);
        let is_told = self.program.tells_n() && !asked.is_empty();
        (is_told && !asked.contains(&n)).then(|| {
            format!("program.n = {n} is what programs are told, and n = {asked:?} is what is right\n  way out: n = [{n}]")
        })
    }

    /// Points that nobody can earn.
    fn points_refused(&self) -> Option<String> {
        let own = self.points.get(&Check::Interface).copied().unwrap_or(0.0);
        if own > 0.0 && self.interface.is_none() {
            return Some(format!(
                "points.interface = {own}, and there is no [interface]: nothing would be asked\n  way out: an [interface] with \
                 its cases, or no points for it"
            ));
        }
        let all: f64 = Check::ALL.iter().map(|&check| self.points_of(check)).sum();
        (all == 0.0).then(|| {
            "points are 0 for every check: there is nothing to earn\n  way out: above 0 for one check and more, as \
             free_flight = 3.0"
                .to_owned()
        })
    }

    /// A damping of the course's own, and restitutions that would be taken in its place.
    fn eta_refused(&self) -> Option<String> {
        let (eta, usual) = (self.eta, Self::default().eta);
        let name = match (self.restitution, self.restitution_wall, self.restitution_pair) {
            (Some(_), ..) => "restitution",
            (_, Some(_), Some(_)) => "restitution_wall and restitution_pair",
            _ => return None,
        };
        (eta != usual).then(|| {
            format!(
                "eta = {eta} and {name} are given, and one follows from the other\n  way out: leave out eta, or {name}"
            )
        })
    }

    /// What lies between 0 and 1.
    fn part_refused(&self) -> Option<String> {
        let kept = self.partial.iter().map(|(mistake, &part)| (mistake.id(), Some(part)));
        let e = [
            ("restitution", self.restitution),
            ("restitution_wall", self.restitution_wall),
            ("restitution_pair", self.restitution_pair),
        ];
        e.into_iter()
            .chain(kept)
            .filter_map(|(name, part)| Some((name, part?)))
            .find(|(_, part)| !(0.0..=1.0).contains(part))
            .map(|(name, part)| format!("{name} = {part} is out of range; it is 0 to 1"))
    }

    /// Points of a check; none for unit tests that the rubric does not have.
    pub fn points_of(&self, check: Check) -> f64 {
        if check == Check::Interface && self.interface.is_none() {
            return 0.0;
        }
        self.points.get(&check).copied().unwrap_or(check.usual_points())
    }

    /// Reduced masses of a wall contact and of a pair, kg.
    fn reduced_mass(&self, is_wall: bool) -> f64 {
        if is_wall { self.mass } else { 0.5 * self.mass }
    }

    /// omega0 of a contact with a wall, or of a pair, 1/s.
    ///
    /// Infinite for hard discs.
    pub fn omega0(&self, is_wall: bool) -> f64 {
        if self.law == Law::Hard {
            return f64::INFINITY;
        }
        angular_frequency(self.kn, self.reduced_mass(is_wall))
    }

    /// The smallest and largest restitution that is right: a contact may end at overlap zero or
    /// at force zero.
    pub fn expected_restitution(&self, is_wall: bool) -> (f64, f64) {
        let own = if is_wall { self.restitution_wall } else { self.restitution_pair };
        if let Some(e) = own.or(self.restitution) {
            return (e, e);
        }
        let zeta = damping_ratio(self.eta, self.kn, self.reduced_mass(is_wall));
        let ends = [ContactEnd::OverlapZero, ContactEnd::ForceZero];
        let [a, b] = ends.map(|end| restitution(zeta, end));
        (a.min(b), a.max(b))
    }

    /// Whether contacts take next to nothing: less than a thousandth of the speed.
    pub fn is_elastic(&self) -> bool {
        [true, false].iter().all(|&is_wall| self.expected_restitution(is_wall).0 > 0.999)
    }

    /// When students may see a check.
    pub fn visibility_of(&self, check: Check) -> Visibility {
        self.visibility.get(&check).copied().unwrap_or_default()
    }

    /// What part of a check's points a mistake leaves.
    pub fn part_left(&self, mistake: Option<Mistake>) -> f64 {
        mistake.and_then(|mistake| self.partial.get(&mistake).copied()).unwrap_or(0.0)
    }
}
