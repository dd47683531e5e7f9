//! What pushes the discs: the seam every force goes through, the contact sweep, and the walls.

use glam::DVec2;

use crate::neighbours::Neighbours;
use crate::particle::{Contact, ContactLaw, Particle};

/// Something that pushes discs.
pub trait Force: Send {
    /// Adds this force (N) to every disc it acts on and returns the energy it stores, J.
    ///
    /// A force that returns 0 stores nothing: what it does is booked as supplied from outside (taken, if it is drag).
    /// One that returns what it stores must do nothing else: of a spring with drag make two, or return 0.
    ///
    /// `tally` is for contact forces; other forces leave it alone.
    fn apply(&mut self, particles: &mut [Particle], tally: &mut Tally) -> f64;

    /// Moves what the force itself remembers past a completed step of `dt` s.
    fn end_step(&mut self, _dt: f64) {}
}

/// What contact forces report beside the pushes they give.
#[derive(Clone, Default)]
pub struct Tally {
    /// The largest overlap of two discs so far, as a fraction of the smaller radius.
    pub largest_pair_overlap: f64,
    /// The same as a fraction of the sum of the radii, where it is more than the smaller radius: 1
    /// once centres meet.
    pub largest_sinking: f64,
    /// The largest overlap with a wall so far, as a fraction of the radius.
    pub largest_wall_overlap: f64,
    /// Spring and dashpot force on each disc, kept only while the work ledger is on.
    pub shares: Option<Vec<Share>>,
}

impl Tally {
    /// Has `force`, which is no contact of the simulation's own, act on `particles`. What it stores it books
    /// as a spring would; what is not booked here is supplied from outside.
    pub(crate) fn book(&mut self, force: &mut dyn Force, particles: &mut [Particle]) -> f64 {
        let unbooked = |disc: &Particle, share: &Share| disc.force - share.spring - share.dashpot;
        let before: Vec<DVec2> = match &self.shares {
            Some(shares) => particles.iter().zip(shares).map(|(p, s)| unbooked(p, s)).collect(),
            None => Vec::new(),
        };
        let stored_energy = force.apply(particles, self);
        if stored_energy != 0.0 {
            let shares = self.shares.iter_mut().flatten();
            for ((disc, share), before) in particles.iter().zip(shares).zip(before) {
                share.spring += unbooked(disc, share) - before;
            }
        }
        stored_energy
    }

    /// Forgets the shares of the previous state; the largest overlaps are of the whole run.
    pub fn begin(&mut self) {
        if let Some(shares) = &mut self.shares {
            shares.fill(Share::default());
        }
    }
}

/// The part of a disc's force that stores energy or damps, split in two for the work ledger.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Share {
    /// From springs, k_n delta_n, and from other forces that store energy.
    pub spring: DVec2, // N
    /// The rest of the contact force: the dashpot, and what clipping took away.
    pub dashpot: DVec2, // N
}

/// Contacts between discs.
///
/// Pairs come in lexicographic order of ids (i < j), so each disc receives its partners'
/// pushes in ascending id, whatever found the pairs: the sum has the same bits for all pairs,
/// for a grid, and for a list of any skin, and the same as if each disc gathered its own.
pub struct Contacts<L> {
    /// The contact law.
    pub law: L,
    /// Who may touch whom.
    pub neighbours: Neighbours,
}

impl<L: ContactLaw> Force for Contacts<L> {
    fn apply(&mut self, particles: &mut [Particle], tally: &mut Tally) -> f64 {
        self.neighbours.refresh(particles);
        let mut stored_energy = 0.0;
        for (i, j) in self.neighbours.pairs() {
            let Some(contact) = Contact::between(&particles[i], &particles[j]) else {
                continue;
            };
            let push = self.law.push(&contact);
            particles[i].force -= push * contact.normal;
            particles[j].force += push * contact.normal;
            stored_energy += self.law.stored_energy(&contact);

            let smaller_radius = particles[i].radius.min(particles[j].radius);
            let relative_overlap = contact.overlap / smaller_radius;
            tally.largest_pair_overlap = tally.largest_pair_overlap.max(relative_overlap);
            if relative_overlap > 1.0 {
                let reach = particles[i].radius + particles[j].radius;
                tally.largest_sinking = tally.largest_sinking.max(contact.overlap / reach);
            }
            if let Some(shares) = &mut tally.shares {
                let spring = self.law.spring(&contact);
                shares[i].spring -= spring * contact.normal;
                shares[j].spring += spring * contact.normal;
                shares[i].dashpot -= (push - spring) * contact.normal;
                shares[j].dashpot += (push - spring) * contact.normal;
            }
        }
        stored_energy
    }
}

/// A wall: everything beyond a straight line. A centre beyond it is still pushed back.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct HalfPlane {
    /// A point on the line.
    pub point: DVec2, // m
    /// Unit vector n_ib from the inside to the wall.
    pub normal: DVec2,
}

impl HalfPlane {
    /// Left, right, lower and upper wall of the square from the origin to (`side`, `side`), m.
    pub fn square(side: f64) -> [Self; 4] {
        let low = DVec2::ZERO;
        let high = DVec2::splat(side);
        [(low, DVec2::NEG_X), (high, DVec2::X), (low, DVec2::NEG_Y), (high, DVec2::Y)]
            .map(|(point, normal)| Self { point, normal })
    }

    /// How far `position` (m) is inside the wall's line, m; negative beyond it.
    #[inline]
    pub fn distance(&self, position: DVec2) -> f64 {
        (self.point - position).dot(self.normal)
    }
}

/// Contacts between discs and walls: a contact with a body of infinite mass.
pub struct Walls<L> {
    /// The contact law, the same as between discs.
    pub law: L,
    /// The walls, in the order in which their pushes are added.
    pub planes: Vec<HalfPlane>,
}

impl<L: ContactLaw> Force for Walls<L> {
    fn apply(&mut self, particles: &mut [Particle], tally: &mut Tally) -> f64 {
        let mut stored_energy = 0.0;
        for (i, particle) in particles.iter_mut().enumerate() {
            for plane in &self.planes {
                let distance = plane.distance(particle.position);
                let Some(contact) = Contact::with_wall(particle, distance, plane.normal) else {
                    continue;
                };
                let push = self.law.push(&contact);
                particle.force -= push * contact.normal;
                stored_energy += self.law.stored_energy(&contact);

                let relative_overlap = contact.overlap / particle.radius;
                tally.largest_wall_overlap = tally.largest_wall_overlap.max(relative_overlap);
                if let Some(shares) = &mut tally.shares {
                    let spring = self.law.spring(&contact);
                    shares[i].spring -= spring * contact.normal;
                    shares[i].dashpot -= (push - spring) * contact.normal;
                }
            }
        }
        stored_energy
    }
}
