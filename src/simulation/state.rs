//! A state as named arrays, to be written down and read back with every bit.

pub mod view;

use glam::DVec2;

use self::view::ArrayView;
use super::{Simulation, State};
use crate::discs::{Remembered, Snapshot};
use crate::force::{Share, Tally};
use crate::particle::Particle;
use crate::work::{Sum, Works};

/// Values of one kind, in order.
#[derive(Clone, Debug, PartialEq)]
pub enum Array {
    /// Numbers with a unit, SI.
    Numbers(Vec<f64>),
    /// Counts: steps, ids.
    Counts(Vec<u64>),
}

/// Numbers of a disc: x y vx vy fx fy r m.
const PER_DISC: usize = 8;
/// Numbers of a disc's share of contact forces: spring x y, dashpot x y.
const PER_SHARE: usize = 4;

impl State {
    /// The discs, in id order.
    pub fn particles(&self) -> Vec<Particle> {
        let Snapshot { particles, ids, .. } = &self.discs;
        let mut ordered = particles.clone();
        ids.iter().zip(particles).for_each(|(&id, disc)| ordered[id as usize] = *disc);
        ordered
    }

    /// Whether it is the state of a crowd, which has an order of its own, and works booked in it.
    pub fn is_of_crowd(&self) -> bool {
        !self.discs.ids.is_empty()
    }

    /// Everything in the state, by name. Whoever stores these need not know what they are.
    pub fn arrays(&self) -> Vec<(&'static str, Array)> {
        let views = views(self.discs.remembered(), self.steps);
        views.into_iter().map(|(name, view)| (name, view.to_array())).collect()
    }

    /// The state that [`arrays`](Self::arrays) came from. Names that belong to no state are left alone.
    ///
    /// Fails, with the array's name, where one is missing or does not fit the others.
    pub fn from_arrays(mut arrays: Vec<(String, Array)>) -> Result<Self, String> {
        let arrays = &mut arrays;
        let steps = match take(arrays, "steps") {
            Some(Array::Counts(steps)) if steps.len() == 1 => steps[0],
            _ => return Err("array steps: one count is wanted".to_owned()),
        };
        let overlaps = numbers(arrays, "overlaps", 3)?;
        let sums: Vec<Sum> = numbers(arrays, "works", 8)?
            .chunks_exact(2)
            .map(|pair| Sum { value: pair[0], carry: pair[1] })
            .collect();
        let stored_energy = numbers(arrays, "stored_energy", 1)?[0];
        let particles = particles(arrays)?;
        let shares = match arrays.iter().any(|(name, _)| name == "shares") {
            false => None,
            true => Some(numbers(arrays, "shares", PER_SHARE * particles.len())?),
        };
        let of_share =
            |s: &[f64]| Share { spring: DVec2::new(s[0], s[1]), dashpot: DVec2::new(s[2], s[3]) };
        let tally = Tally {
            largest_pair_overlap: overlaps[0],
            largest_sinking: overlaps[1],
            largest_wall_overlap: overlaps[2],
            shares: shares.map(|shares| shares.chunks_exact(PER_SHARE).map(of_share).collect()),
        };
        // Only where something was moved by hand; no run of the program does that.
        let by_hand = match arrays.iter().any(|(name, _)| name == "by_hand") {
            false => Sum::default(),
            true => {
                let sum = numbers(arrays, "by_hand", 2)?;
                Sum { value: sum[0], carry: sum[1] }
            }
        };
        let [gravity, spring, dashpot, external] = [sums[0], sums[1], sums[2], sums[3]];
        let works = Works { gravity, spring, dashpot, external, by_hand };
        let plain = Snapshot { particles, tally, works, stored_energy, ..Snapshot::default() };
        Ok(Self { discs: with_crowd(plain, arrays)?, steps })
    }
}

impl Simulation {
    /// The arrays of the present [`state`](Self::state), without a copy of anything.
    pub fn arrays(&self) -> Vec<(&'static str, ArrayView<'_>)> {
        views(self.discs.remembered(), self.steps)
    }
}

/// The arrays of a state by name.
fn views(discs: Remembered, steps: u64) -> Vec<(&'static str, ArrayView)> {
    let of_disc = |p: &Particle| {
        let (x, v, f) = (p.position, p.velocity, p.force);
        [x.x, x.y, v.x, v.y, f.x, f.y, p.radius, p.mass]
    };
    let Remembered { particles, ids, tally, works, stored_energy, .. } = discs;
    let Remembered { springs, listed_at, skin, limit_squared, .. } = discs;
    let Tally { largest_pair_overlap, largest_sinking, largest_wall_overlap, shares } = tally;
    let Works { gravity, spring, dashpot, external, by_hand } = works;
    let sums = [gravity, spring, dashpot, external].map(|sum| [sum.value, sum.carry]);
    let overlaps = [*largest_pair_overlap, *largest_sinking, *largest_wall_overlap];
    let mut views = vec![
        ("steps", ArrayView::of_counts([steps].into_iter())),
        ("overlaps", ArrayView::of_numbers([overlaps].into_iter())),
        ("works", ArrayView::of_numbers(sums.into_iter())),
        ("stored_energy", ArrayView::of_numbers([[stored_energy]].into_iter())),
        ("particles", ArrayView::of_numbers(particles.iter().map(of_disc))),
    ];
    if by_hand != Sum::default() {
        let by_hand = [by_hand.value, by_hand.carry];
        views.push(("by_hand", ArrayView::of_numbers([by_hand].into_iter())));
    }
    if let Some(shares) = shares {
        let of_share = |s: &Share| [s.spring.x, s.spring.y, s.dashpot.x, s.dashpot.y];
        views.push(("shares", ArrayView::of_numbers(shares.iter().map(of_share))));
    }
    if !ids.is_empty() {
        let listed_at = listed_at.iter().copied();
        views.push(("ids", ArrayView::of_counts(ids.iter().map(|id| u64::from(*id)))));
        views.push(("springs", ArrayView::of_numbers(springs.iter().map(DVec2::to_array))));
        views.push(("listed_at", ArrayView::of_numbers(listed_at)));
        views.push(("list", ArrayView::of_numbers([[skin, limit_squared]].into_iter())));
    }
    views
}

/// `plain` with what a crowd remembers besides, if it is the state of one.
fn with_crowd(plain: Snapshot, arrays: &mut Vec<(String, Array)>) -> Result<Snapshot, String> {
    let n = plain.particles.len();
    let ids: Vec<u32> = match take(arrays, "ids") {
        None => return Ok(plain),
        Some(Array::Counts(ids)) if is_permutation(&ids, n) => {
            ids.iter().map(|id| *id as u32).collect()
        }
        _ => return Err(format!("array ids: the numbers from 0 to {} are wanted", n - 1)),
    };
    let springs = match take(arrays, "springs") {
        Some(Array::Numbers(numbers)) if [0, 2 * n].contains(&numbers.len()) => numbers,
        other => fitting("springs", 2 * n, other)?,
    };
    let springs = springs.chunks_exact(2).map(|s| DVec2::new(s[0], s[1])).collect();
    let listed_at = numbers(arrays, "listed_at", 2 * n)?;
    let list = numbers(arrays, "list", 2)?;
    Ok(Snapshot {
        ids,
        springs,
        listed_at: listed_at.chunks_exact(2).map(|x| [x[0], x[1]]).collect(),
        skin: list[0],
        limit_squared: list[1],
        ..plain
    })
}

/// Whether `ids` has every number below `n` once.
fn is_permutation(ids: &[u64], n: usize) -> bool {
    let mut is_there = vec![false; n];
    let mut mark = |id: &u64| match is_there.get_mut(*id as usize) {
        Some(there) => !std::mem::replace(there, true),
        None => false,
    };
    ids.len() == n && ids.iter().all(&mut mark)
}

fn particles(arrays: &mut Vec<(String, Array)>) -> Result<Vec<Particle>, String> {
    let Some(Array::Numbers(numbers)) = take(arrays, "particles") else {
        return Err("array particles: numbers are wanted".to_owned());
    };
    if numbers.is_empty() || numbers.len() % PER_DISC != 0 {
        let has = numbers.len();
        return Err(format!("array particles: {has} numbers; {PER_DISC} a disc are wanted"));
    }
    let disc = |p: &[f64]| {
        let mut disc = Particle::at_rest(DVec2::new(p[0], p[1]), p[6], p[7]);
        disc.velocity = DVec2::new(p[2], p[3]);
        disc.force = DVec2::new(p[4], p[5]);
        disc
    };
    let particles: Vec<Particle> = numbers.chunks_exact(PER_DISC).map(disc).collect();
    let is_sound = |p: &Particle| [p.radius, p.mass].iter().all(|x| *x > 0.0 && x.is_finite());
    match particles.iter().position(|p| !is_sound(p)) {
        Some(id) => Err(format!("array particles: radius or mass of disc {id} is not above 0")),
        None => Ok(particles),
    }
}

/// Takes the array `name` out: of a million discs none is kept longer than it is needed.
fn take(arrays: &mut Vec<(String, Array)>, name: &str) -> Option<Array> {
    let at = arrays.iter().position(|(of, _)| of == name)?;
    Some(arrays.swap_remove(at).1)
}

/// Takes out the numbers of the array `name`, which must be so `many`.
fn numbers(arrays: &mut Vec<(String, Array)>, name: &str, many: usize) -> Result<Vec<f64>, String> {
    fitting(name, many, take(arrays, name))
}

/// The numbers of `array`, called `name`, which must be so `many`.
fn fitting(name: &str, many: usize, array: Option<Array>) -> Result<Vec<f64>, String> {
    match array {
        Some(Array::Numbers(numbers)) if numbers.len() == many => Ok(numbers),
        Some(Array::Numbers(numbers)) => {
            Err(format!("array {name}: {} numbers where {many} are wanted", numbers.len()))
        }
        _ => Err(format!("array {name}: {many} numbers are wanted, there are none")),
    }
}
