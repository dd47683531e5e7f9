//! Overlaps of discs at t = 0: who, how deep, and how fast they will fly apart.

use super::finding::{Finding, Matter, Verdict};
use super::number::Num;
use super::{DiscSource, Scenario};
use crate::analysis::collision::angular_frequency;
use crate::force::HalfPlane;
use crate::neighbours::Neighbours;
use crate::particle::{Contact, Particle};

/// Overlaps below this many radii are rounding, or contacts at rest.
const TOUCHING: f64 = 1e-3;

impl Scenario {
    /// Shows `look` every overlap of `discs` with each other and with the walls. In a bed there are more
    /// overlaps than discs, so they are not kept.
    pub(super) fn each_overlap(&self, discs: &[Particle], mut look: impl FnMut(Overlap)) {
        let planes = HalfPlane::square(self.side);
        let planes = if self.walls { &planes[..] } else { &[] };
        for (disc, p) in discs.iter().enumerate() {
            for plane in planes {
                let distance = plane.distance(p.position);
                if let Some(contact) = Contact::with_wall(p, distance, plane.normal) {
                    let relative = contact.overlap / p.radius;
                    let parting_speed = self.parting_speed(&contact);
                    let (other, centres_coincide) = (None, false);
                    look(Overlap { disc, other, relative, centres_coincide, parting_speed });
                }
            }
        }
        let mut neighbours = Neighbours::default();
        neighbours.refresh(discs);
        for (i, j) in neighbours.pairs() {
            if let Some(contact) = Contact::between(&discs[i], &discs[j]) {
                let relative = contact.overlap / discs[i].radius.min(discs[j].radius);
                let centres_coincide = discs[i].position == discs[j].position;
                let (disc, other) = (i, Some(j));
                let parting_speed = self.parting_speed(&contact);
                look(Overlap { disc, other, relative, centres_coincide, parting_speed });
            }
        }
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
    fn parting_speed(&self, contact: &Contact) -> f64 {
        contact.overlap * angular_frequency(self.stiffness, contact.reduced_mass)
    }

    /// Discs whose places were said and whose overlap will throw them apart faster than anything else
    /// in the run moves.
    pub(super) fn start_finding(&self) -> Option<Finding> {
        let by_speed = |overlap: &Overlap| overlap.parting_speed;
        let (deepest, _) = match &self.discs {
            DiscSource::Equal(_) => return None,
            DiscSource::Listed(listed, _) => self.deepest_overlap(listed, by_speed),
            DiscSource::Frame { discs, .. } => {
                self.deepest_overlap(&discs.iter().collect::<Vec<_>>(), by_speed)
            }
        };
        let deepest = deepest.filter(|deepest| deepest.relative > TOUCHING)?;
        let (disc, relative) = (deepest.disc, Num::rounded(deepest.relative));
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
                Num::rounded(speed)
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
