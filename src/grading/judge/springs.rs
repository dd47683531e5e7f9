//! Whether contacts are as stiff as asked, and walls where they should be: what the times of contacts and the
//! swings within them say together, and which check says it.

use super::bounce::{self, Bounce};
use super::collision::{self, Collision};
use super::film::Film;
use super::flight::Flights;
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::stiffness::Stiffness;
use super::touching::{self, Shift, Touching};
use super::verdict::Status;
use super::{momentum, passing};

/// What is known of the springs of walls and pairs, and of the places of walls.
pub struct Springs {
    /// Of walls, if it is not as asked.
    pub wall: Option<Stiffness>,
    /// Of pairs, if it is not as asked.
    pub pair: Option<Stiffness>,
    /// A wall that is felt elsewhere.
    pub shift: Option<Shift>,
}

impl Springs {
    /// By the times of contacts, and by swings where frames are dense enough.
    pub fn of(
        film: &Film,
        (flights, bounces, collisions): (&Flights, &[Bounce], &[Collision]),
        rubric: &Rubric,
    ) -> Self {
        let [wall, pair] = Stiffness::of(film, flights, rubric);
        let (timed, shift) = match touching::wall(film, bounces, flights, rubric) {
            Some(Touching::Spring(spring)) => (Some(spring), None),
            Some(Touching::Shifted(shift)) => (None, Some(shift)),
            None => (None, None),
        };
        let timed_pair = touching::pair(collisions, flights, rubric);
        let first = |swings: Option<Stiffness>, timed| swings.filter(Stiffness::is_off).or(timed);
        let wall = first(wall, timed).filter(|wall| shift.is_none() && wall.is_off());
        Self { wall, pair: first(pair, timed_pair).filter(Stiffness::is_off), shift }
    }

    /// The mistake at walls.
    pub fn cause_at_walls(&self, rubric: &Rubric) -> Option<Mistake> {
        self.shift.as_ref().map(Shift::cause).or_else(|| Some(self.wall.as_ref()?.cause(rubric)))
    }

    /// What is amiss at walls, unless the box has told it.
    pub fn of_walls(&self, is_told: bool, bounces: &[Bounce], rubric: &Rubric) -> Status {
        match (&self.shift, &self.wall) {
            (None, None) => bounce::verdict(bounces),
            _ if is_told => Status::NotSeen,
            (Some(shift), _) => Status::Failed(shift.failure()),
            // A spring so soft would have let discs in: something else keeps them there.
            (_, Some(wall)) if wall.ratio < 0.1 => {
                Status::Failed(wall.failure(Mistake::SticksToWall))
            }
            (_, Some(wall)) => Status::Failed(wall.failure(wall.cause(rubric))),
        }
    }

    /// What is amiss with the springs of pairs. If walls are off as well it is one mistake, and told there.
    fn of_pairs(&self, is_timed: bool, rubric: &Rubric) -> Option<Status> {
        let pair = self.pair.as_ref().filter(|pair| pair.is_timed == is_timed)?;
        Some(match self.wall {
            Some(_) => Status::NotSeen,
            None => Status::Failed(pair.failure(pair.cause_of_pair(rubric))),
        })
    }

    /// What is amiss with pairs: where frames lie within contacts, that tells most; then whom a push moves,
    /// how long it lasts, and whether all are pushed.
    pub fn pairs(
        &self,
        film: &Film,
        (flights, collisions): (&Flights, &[Collision]),
        is_apart: bool,
        rubric: &Rubric,
    ) -> Status {
        if let Some(failure) = momentum::run_off(film, flights, rubric) {
            return Status::Failed(failure);
        }
        if let Some(status) = self.of_pairs(false, rubric) {
            return status;
        }
        let status = collision::verdict(collisions);
        if matches!(status, Status::Failed(_)) {
            return status;
        }
        let left_out = || passing::left_out(film, flights, collisions, rubric).map(Status::Failed);
        let more = self.of_pairs(true, rubric);
        more.or_else(|| if is_apart { left_out() } else { None }).unwrap_or(status)
    }
}
