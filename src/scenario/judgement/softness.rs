//! Soft discs: how deep they sink, and which radius or stiffness would do.

use super::SOFT;
use crate::number::{at_most, rounded_up, shortest};
use crate::scenario::finding::{Finding, Matter, Verdict};
use crate::scenario::{DiscSource, Scenario};

/// Overlap, in radii, that the cure for soft discs aims at.
const FIRM: f64 = 0.26;

impl Scenario {
    pub(super) fn softness(&self) -> Option<Finding> {
        let overlap = self.expected_overlap();
        if overlap <= SOFT || !overlap.is_finite() {
            return None;
        }
        let falls = self.walls && self.fall_speed() >= self.fastest_start();
        let speed = at_most(self.expected_speed(), 3);
        let cause = match (falls, self.walls) {
            (true, _) => "a fall through the box".to_owned(),
            (_, true) => format!("a wall met at {speed} m/s"),
            _ => format!("a meeting at {speed} m/s"),
        };
        let depth = match overlap < 1e3 {
            true => format!("{overlap:.2}"),
            false => at_most(overlap, 3),
        };
        // The guide's own discs are soft: a parameter that makes them twice as soft is at fault too.
        let is_well = |mended: &Self| mended.expected_overlap() <= SOFT.max(0.5 * overlap);
        let suspect = self.at_fault(is_well);
        let (fault, value) = match suspect {
            Some(suspect) => (suspect.name, suspect.value),
            None => ("--kn".to_owned(), shortest(self.stiffness)),
        };
        Some(Finding {
            matter: Matter::Softness,
            verdict: Verdict::Coarse,
            what: format!("soft discs: {cause} sinks them {depth} r deep"),
            fault,
            value,
            ways_out: self.cure_for_softness(overlap),
        })
    }

    /// Flags that bring overlaps of `overlap` radii down: a radius that suits the fall, if that
    /// many discs of it fit, and a stiffness that suits what was measured.
    pub fn cure_for_softness(&self, overlap: f64) -> Vec<String> {
        let kn = self.firm_stiffness(overlap);
        let radius = rounded_up(self.radius * self.expected_overlap() / FIRM, 1);
        let area = std::f64::consts::PI * radius * radius * self.n() as f64;
        let fits = area < 0.5 * self.side * self.side;
        let stays_stable = Self { stiffness: kn, ..self.clone() }.is_stable();
        let is_equal = matches!(self.discs, DiscSource::Equal(_));
        let mut cures = Vec::new();
        if is_equal && fits && radius > self.radius {
            cures.push(format!("--radius {}", shortest(radius)));
        }
        let with_step = if stays_stable { "" } else { " with --dt auto" };
        cures.push(format!("--kn {}{with_step}", shortest(kn)));
        cures
    }

    /// The stiffness that brings overlaps of `overlap` radii down to [`FIRM`], as a number to type. A
    /// stiffer contact is less damped, so that this is found by trying.
    pub(super) fn firm_stiffness(&self, overlap: f64) -> f64 {
        let with = |stiffness| Self { stiffness, ..self.clone() };
        let wanted = FIRM * self.expected_overlap() / overlap;
        let (mut soft, mut firm) = (self.stiffness, 2.0 * self.stiffness);
        while with(firm).expected_overlap() > wanted && firm < f64::MAX / 4.0 {
            (soft, firm) = (firm, 2.0 * firm);
        }
        for _ in 0..30 {
            let middle = (soft * firm).sqrt();
            if with(middle).expected_overlap() > wanted { soft = middle } else { firm = middle }
        }
        rounded_up(firm, 2)
    }
}
