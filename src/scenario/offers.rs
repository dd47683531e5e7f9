//! What to do about a frame that cannot be a start: each offer is tried before it is made.

use super::overlap::Overlap;
use super::{DiscSource, Scenario, start};
use crate::number::{rounded_up, shortest};
use crate::particle::Particle;

impl Scenario {
    /// Ways out of `overlap` of the `discs` of a frame.
    pub(super) fn offers_for_frame(&self, discs: &[Particle], overlap: &Overlap) -> String {
        let DiscSource::Frame { are_named, notes, .. } = &self.discs else { return String::new() };
        let mut offers = Vec::new();
        if !are_named {
            let read_as = notes.iter().find(|note| note.contains("columns are read as"));
            offers.push(read_as.cloned().unwrap_or_else(|| {
                "no heading names the columns of the file: if they are not x, y, r in this order, --columns says which \
                 is what, as --columns r,x,y"
                    .to_owned()
            }));
        }
        match overlap.other {
            None => self.offer_boxes(discs, &mut offers),
            Some(_) if overlap.centres_coincide => offers.push(
                "the file may say a disc twice, which is one row too many, or hold several frames that nothing parts: \
                 two blank lines do, or a column frame"
                    .to_owned(),
            ),
            Some(_) => {}
        }
        offers.extend(self.offer_first_frame());
        if offers.is_empty() {
            offers.push(match overlap.other {
                Some(_) => {
                    "move the discs of the file apart, or give them smaller radii".to_owned()
                }
                None => "put the discs of the file inside, between 0 and the side".to_owned(),
            });
        }
        offers.join("; or ")
    }

    /// Boxes that hold the discs.
    fn offer_boxes(&self, discs: &[Particle], offers: &mut Vec<String>) {
        let DiscSource::Frame { side: own, .. } = &self.discs else { return };
        let holds = |side: f64| Self { side, ..self.clone() }.allows(discs);
        if let Some(own) = own.filter(|&own| own != self.side && holds(own)) {
            offers.push(format!("--side {}, as the frame itself says", shortest(own)));
            return;
        }
        let reach = |disc: &Particle| disc.position.max_element() + disc.radius;
        let furthest = discs.iter().map(reach).fold(0.0, f64::max);
        let side = rounded_up(furthest, 2);
        let are_all_outside = discs.iter().all(|disc| disc.position.max_element() > self.side);
        if holds(side) {
            let unit = match are_all_outside {
                true => "no disc is in the box: lengths are read in m, and these may be in mm; ",
                false => "",
            };
            offers.push(format!("{unit}--side {} holds the discs as they are", shortest(side)));
        } else if (Self { walls: false, ..self.clone() }).allows(discs) {
            offers.push(
                "shift the positions of the file to between 0 and the side; or --no-walls, for no box"
                    .to_owned(),
            );
        }
    }

    /// The first frame of the file, if it is another one.
    fn offer_first_frame(&self) -> Option<String> {
        let DiscSource::Frame { said, columns, has_radii, .. } = &self.discs else { return None };
        let radius = (!has_radii).then_some(self.radius);
        let first = start::first_frame(said, columns.clone(), radius)?;
        let (path, _) = start::file_and_frame(said);
        self.allows(&first).then(|| format!("the first frame of the file, --start {path}:0"))
    }

    /// Whether a run may start with these discs.
    fn allows(&self, discs: &[Particle]) -> bool {
        let mut is_allowed = true;
        self.each_wall_overlap(discs, |overlap| is_allowed &= !overlap.is_too_deep());
        if !is_allowed || self.crammed(discs).is_some() {
            return false;
        }
        self.each_overlap(discs, |overlap| is_allowed &= !overlap.is_too_deep());
        is_allowed
    }
}
