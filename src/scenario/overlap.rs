//! Overlaps of discs at t = 0: who, how deep, and how fast they will fly apart.

use std::collections::HashMap;

use glam::DVec2;

use super::finding::{Finding, Matter, Verdict};
use super::{DiscSource, Scenario};
use crate::analysis::collision::angular_frequency;
use crate::force::HalfPlane;
use crate::neighbours::Neighbours;
use crate::number::at_most;
use crate::particle::{Contact, ContactLaw, Particle, SpringDashpot};

/// Overlaps below this many radii are rounding, or contacts at rest.
const TOUCHING: f64 = 1e-3;

impl Scenario {
    /// Shows `look` every overlap of `discs` with each other and with the walls. In a bed there are more
    /// overlaps than discs, so they are not kept.
    pub(super) fn each_overlap(&self, discs: &[Particle], mut look: impl FnMut(Overlap)) {
        self.each_wall_overlap(discs, &mut look);
        let mut neighbours = Neighbours::default();
        neighbours.refresh(discs);
        let law = &self.law();
        neighbours.pairs().filter_map(|(i, j)| Self::overlap_of(law, discs, i, j)).for_each(look);
    }

    /// The same of overlaps with walls alone.
    pub(super) fn each_wall_overlap(&self, discs: &[Particle], mut look: impl FnMut(Overlap)) {
        let (law, planes) = (&self.law(), HalfPlane::square(self.side));
        let planes = if self.walls { &planes[..] } else { &[] };
        for (disc, p) in discs.iter().enumerate() {
            for plane in planes {
                let distance = plane.distance(p.position);
                if let Some(contact) = Contact::with_wall(p, distance, plane.normal) {
                    let relative = contact.overlap / p.radius;
                    let parting_speed = Self::parting_speed(law, &contact);
                    let (other, centres_coincide) = (None, false);
                    look(Overlap { disc, other, relative, centres_coincide, parting_speed });
                }
            }
        }
    }

    /// How discs `i` and `j` overlap, if they do.
    fn overlap_of(law: &SpringDashpot, discs: &[Particle], i: usize, j: usize) -> Option<Overlap> {
        let contact = Contact::between(&discs[i], &discs[j])?;
        Some(Overlap {
            disc: i,
            other: Some(j),
            relative: contact.overlap / discs[i].radius.min(discs[j].radius),
            centres_coincide: discs[i].position == discs[j].position,
            parting_speed: Self::parting_speed(law, &contact),
        })
    }

    /// Two discs that overlap by more than a radius, found in a time that grows with the discs and not with their
    /// overlaps, of which crammed discs have as many as there are pairs. No such two are missed that lie in one square of
    /// a diagonal of the smallest radius; where there are none, a disc has few others around it.
    pub(super) fn crammed(&self, discs: &[Particle]) -> Option<Overlap> {
        let smallest = discs.iter().map(|disc| disc.radius).fold(f64::INFINITY, f64::min);
        let side = smallest * std::f64::consts::FRAC_1_SQRT_2;
        let law = &self.law();
        let mut squares = HashMap::with_capacity(discs.len());
        discs.iter().enumerate().find_map(|(j, disc)| {
            // Plus zero: there is a zero below zero as well.
            let square = (disc.position / side).floor() + DVec2::ZERO;
            let square = square.to_array().map(f64::to_bits);
            let i = squares.insert(square, j)?;
            // So far out that numbers have no digits left, a square may be larger than it should be.
            Self::overlap_of(law, discs, i, j).filter(|overlap| overlap.relative > 1.0)
        })
    }

    /// The overlap of `discs` that is largest by `measure`, the last of equal ones, and how many there are.
    pub(super) fn deepest_overlap(
        &self,
        discs: &[Particle],
        measure: fn(&Overlap) -> f64,
    ) -> (Option<Overlap>, usize) {
        let (mut deepest, mut many) = (None, 0);
        self.each_overlap(discs, |overlap| {
            many += 1;
            let is_deeper = |than: &Overlap| measure(&overlap).total_cmp(&measure(than)).is_ge();
            if deepest.as_ref().is_none_or(is_deeper) {
                deepest = Some(overlap);
            }
        });
        (deepest, many)
    }

    /// The speed at which an undamped spring would part the bodies, m/s.
    fn parting_speed(law: &SpringDashpot, contact: &Contact) -> f64 {
        contact.overlap * angular_frequency(law.linearised(contact).stiffness, contact.reduced_mass)
    }

    /// Discs whose places were said and whose overlap will throw them apart faster than anything else
    /// in the run moves.
    pub(super) fn start_finding(&self) -> Option<Finding> {
        let discs = match &self.discs {
            DiscSource::Equal(_) => return None,
            DiscSource::Listed(listed, _) => listed.clone(),
            DiscSource::Frame { discs, .. } => discs.iter().collect(),
        };
        if self.crammed(&discs).is_some() {
            return None; // they are refused when they are placed
        }
        let (deepest, _) = self.deepest_overlap(&discs, |overlap| overlap.parting_speed);
        let deepest = deepest.filter(|deepest| deepest.relative > TOUCHING)?;
        let (disc, relative) = (deepest.disc, at_most(deepest.relative, 3));
        let speed = deepest.parting_speed;
        let (who, whom) = match deepest.other {
            Some(other) => {
                (format!("discs {disc} and {other}"), format!("discs {disc} and {other}"))
            }
            None => (format!("disc {disc}"), format!("disc {disc} and a wall")),
        };
        (speed > self.expected_speed()).then(|| Finding {
            matter: Matter::Start,
            verdict: Verdict::Coarse,
            what: format!(
                "overlap at the start: {whom} overlap by {relative} r, and their spring throws them \
                 apart at {} m/s",
                at_most(speed, 3)
            ),
            fault: format!("{who}: position"),
            value: format!("{relative} r of overlap"),
            ways_out: Vec::new(),
        })
    }
}

/// Two bodies that overlap at the start.
pub(super) struct Overlap {
    pub disc: usize,
    /// The other disc; `None` for a wall.
    pub other: Option<usize>,
    /// Overlap over the (smaller) radius.
    pub relative: f64,
    pub centres_coincide: bool,
    /// Relative speed that the spring gives the two, without damping.
    pub parting_speed: f64, // m/s
}

impl Overlap {
    /// Whether no run may start with it: the contact force would throw the discs apart.
    pub fn is_too_deep(&self) -> bool {
        let is_wall = self.other.is_none();
        self.centres_coincide || self.relative > 1.0 || is_wall && self.relative >= 1.0
    }
}
