//! The discs at t = 0: placed, checked for overlaps, and told what would fit if they do not.

use glam::DVec2;
use rand_pcg::Pcg64;

use super::error::ScenarioError;
use super::overlap::Overlap;
use super::settings::PlacementName;
use super::{DiscSource, Population, Scenario};
use crate::number::{at_most, rounded, shortest};
use crate::particle::Particle;
use crate::placement::thrown::throw;
use crate::placement::{self, PlacementError};
use crate::simulation::place_discs;

impl Scenario {
    /// The discs at t = 0, placed and checked.
    pub fn place(&self) -> Result<Vec<Particle>, ScenarioError> {
        self.check_area()?;
        let (fixed, groups) = {
            let (fixed, groups) = self.fixed_and_groups();
            self.check_overlaps(&fixed)?;
            (fixed.len(), groups) // a million discs need not be kept twice
        };
        let mut particles = self.placed(self.seed).map_err(|why| self.box_too_full(why))?;
        // Directions have a stream of random numbers of their own.
        let mut generator = placement::generator(!self.seed);
        let (fixed_discs, mut placed) = particles.split_at_mut(fixed);
        for group in groups {
            let (of_group, others) = placed.split_at_mut(group.n);
            if group.speed > 0.0 {
                throw(of_group, group.speed, &mut generator);
            }
            placed = others;
        }
        self.set_speed_of_frame(fixed_discs, &mut generator);
        Ok(particles)
    }

    /// Discs of more area than the box are refused before any is made: a hundred million of them would
    /// fill a laptop's memory first.
    fn check_area(&self) -> Result<(), ScenarioError> {
        let fraction = self.packing_fraction();
        let DiscSource::Equal(asked) = self.discs else { return Ok(()) };
        if fraction < 1.0 {
            return Ok(());
        }
        let why = match self.placement {
            PlacementName::Random => {
                PlacementError::NoRoomAtRandom { asked, placed: 0, tried: 0, fraction }
            }
            PlacementName::Lattice => {
                let sites = placement::lattice_capacity(self.radius, self.side);
                PlacementError::NoRoomOnLattice { asked, sites, fraction }
            }
        };
        Err(self.box_too_full(why))
    }

    /// Area of all discs over that of the box.
    pub(super) fn packing_fraction(&self) -> f64 {
        let area: f64 = self.species().iter().map(|s| s.n as f64 * s.radius * s.radius).sum();
        std::f64::consts::PI * area / (self.side * self.side)
    }

    /// Discs whose places are said, and groups that the program places.
    fn fixed_and_groups(&self) -> (Vec<Particle>, Vec<Population>) {
        let equal = |n| Population { n, radius: self.radius, mass: self.mass, speed: self.speed };
        match &self.discs {
            DiscSource::Equal(n) => (Vec::new(), vec![equal(*n)]),
            DiscSource::Listed(listed, groups) => (listed.clone(), groups.clone()),
            DiscSource::Frame { discs, .. } => (discs.iter().collect(), Vec::new()),
        }
    }

    /// All discs in their places by the random numbers of `seed`, or why not.
    fn placed(&self, seed: u64) -> Result<Vec<Particle>, PlacementError> {
        let (mut particles, groups) = self.fixed_and_groups();
        let fixed = particles.len();
        for group in &groups {
            let disc = Particle::at_rest(DVec2::ZERO, group.radius, group.mass);
            particles.extend(std::iter::repeat_n(disc, group.n));
        }
        let placed = match self.placement {
            _ if particles.len() == fixed => Ok(()),
            PlacementName::Lattice if fixed == 0 => {
                placement::lattice(&mut particles, self.side, &mut placement::generator(seed))
            }
            PlacementName::Random if matches!(self.discs, DiscSource::Equal(_)) => {
                place_discs(particles.len(), self.radius, self.mass, self.side, seed)
                    .map(|placed| particles = placed)
            }
            _ => {
                let generator = &mut placement::generator(seed);
                placement::at_random(&mut particles, fixed, self.side, generator)
            }
        };
        placed.map(|()| particles)
    }

    /// `--speed` beside a `--start` file that has no velocities.
    fn set_speed_of_frame(&self, discs: &mut [Particle], generator: &mut Pcg64) {
        if matches!(self.discs, DiscSource::Frame { .. }) && self.speed > 0.0 {
            throw(discs, self.speed, generator);
        }
    }

    /// Refuses coincident centres and overlaps of more than one radius: the contact force would
    /// throw such discs apart. Smaller overlaps are told in the notes.
    fn check_overlaps(&self, discs: &[Particle]) -> Result<(), ScenarioError> {
        let mut refused = None;
        let mut look = |overlap: Overlap| {
            if refused.is_none() {
                refused = self.refuse_overlap(discs, &overlap);
            }
        };
        self.each_wall_overlap(discs, &mut look);
        match self.crammed(discs) {
            Some(overlap) => look(overlap),
            None => self.each_overlap(discs, look),
        }
        refused.map_or(Ok(()), Err)
    }

    /// Why these two may not overlap so, if they may not.
    fn refuse_overlap(&self, discs: &[Particle], overlap: &Overlap) -> Option<ScenarioError> {
        let Overlap { disc, other, relative, centres_coincide, .. } = *overlap;
        let what = match other {
            Some(other) if centres_coincide => {
                format!("discs {disc} and {other} have the same centre")
            }
            Some(other) if relative > 1.0 => {
                let relative = at_most(relative, 3);
                format!("discs {disc} and {other} overlap by {relative} radii (at most 1)")
            }
            None if relative >= 1.0 => {
                let DVec2 { x, y } = discs[disc].position;
                let where_ = if relative > 1.0 { "outside the box" } else { "on a wall" };
                format!("disc {disc} has its centre {where_} ({x} m, {y} m; side {} m)", self.side)
            }
            _ => return None,
        };
        let way_out = match (&self.discs, other) {
            (DiscSource::Frame { .. }, _) => self.offers_for_frame(discs, overlap),
            (_, Some(_)) => "move the discs apart, or give them a smaller radius".to_owned(),
            (_, None) => "put it inside, between 0 and the side, or use a larger --side".to_owned(),
        };
        let who = match other {
            Some(other) => format!("discs {disc} and {other}: position"),
            None => format!("disc {disc}: position"),
        };
        Some(ScenarioError::BadOverlap { who, what, way_out })
    }

    /// A placement error with ways out, each tried before it is offered.
    fn box_too_full(&self, source: PlacementError) -> ScenarioError {
        if let (PlacementName::Lattice, DiscSource::Equal(_)) = (self.placement, &self.discs) {
            let way_out = self.what_fits_a_lattice().join(", or ");
            return ScenarioError::BoxTooFull { source, way_out };
        }
        let fraction = self.packing_fraction();
        // Comfortably below the random limit; walls cost some room too.
        let shrink = (0.4 / fraction).min(0.8);
        let (_, largest) = self.radius_range();
        let radius = rounded(0.95 * self.radius * shrink.sqrt(), 2);
        let side = rounded((1.05 * self.side / shrink.sqrt()).max(2.5 * largest), 2);
        let mut changes = Vec::new();
        if let DiscSource::Equal(n) = self.discs {
            let fewer = (n as f64 * shrink) as usize;
            let lattice = Self { placement: PlacementName::Lattice, ..self.clone() };
            changes.push(("--placement lattice".to_owned(), lattice));
            let discs = DiscSource::Equal(fewer.max(1));
            changes.push((format!("-n {}", fewer.max(1)), Self { discs, ..self.clone() }));
            changes
                .push((format!("--radius {}", shortest(radius)), Self { radius, ..self.clone() }));
        }
        changes.push((format!("--side {}", shortest(side)), Self { side, ..self.clone() }));
        let differs = |changed: &Self| changed != self;
        changes.retain(|(_, changed)| differs(changed) && changed.finds_room());
        let ways_out = those_that_run(changes);
        let way_out = match ways_out.is_empty() {
            true => "fewer or smaller discs, or a larger --side".to_owned(),
            false => ways_out.join(", or "),
        };
        ScenarioError::BoxTooFull { source, way_out }
    }

    /// What a lattice holds: the most discs of this radius, the largest ones of this number, the smallest
    /// box for them, to two digits.
    fn what_fits_a_lattice(&self) -> Vec<String> {
        let n = self.n();
        let holds = |radius: f64, side: f64| placement::lattice_capacity(radius, side) >= n;
        let most = placement::lattice_capacity(self.radius, self.side);
        let mut changes = Vec::new();
        if most > 0 {
            let discs = DiscSource::Equal(most);
            changes.push((format!("-n {most}"), Self { discs, ..self.clone() }));
        }
        let two_digits = |value: f64| rounded(value, 2);
        // By steps of one in the second digit; what a lattice covers lies between 0.5 and 0.9069 of the box.
        let (mut radius, mut side) = (two_digits(self.radius), two_digits(self.side));
        while !holds(radius, self.side) {
            radius = two_digits(radius - 0.1 * 10f64.powf((0.999 * radius).log10().floor()));
        }
        while !holds(self.radius, side) {
            side = two_digits(side + 0.1 * 10f64.powf(side.log10().floor()));
        }
        changes.push((format!("--radius {}", shortest(radius)), Self { radius, ..self.clone() }));
        changes.push((format!("--side {}", shortest(side)), Self { side, ..self.clone() }));
        those_that_run(changes)
    }

    /// Whether the discs can be placed with this seed and the next few. For very many discs the
    /// packing fraction alone must do.
    fn finds_room(&self) -> bool {
        const MOST_DISCS_TO_TRY: usize = 20_000;
        if self.n() > MOST_DISCS_TO_TRY {
            return match self.placement {
                PlacementName::Random => true,
                // Sites cover at most 0.9069 of the box.
                PlacementName::Lattice => self.packing_fraction() < 0.85,
            };
        }
        (0..4).all(|more| self.placed(self.seed + more).is_ok())
    }
}

/// The ways out that nothing else stands against, neither the judgement nor the memory of a laptop; if there is
/// none such, those that are not refused; and if none again, all: room at least they have.
fn those_that_run(changes: Vec<(String, Scenario)>) -> Vec<String> {
    const LAPTOP: u64 = 8_000_000_000; // bytes
    let runs = |changed: &Scenario| changed.is_runnable() && changed.memory() <= LAPTOP;
    let runs_well = |changed: &Scenario| runs(changed) && changed.is_firm_enough();
    let is_any = |of: &dyn Fn(&Scenario) -> bool| changes.iter().any(|(_, changed)| of(changed));
    let (some_run, some_run_well) = (is_any(&runs), is_any(&runs_well));
    let is_kept = |changed: &Scenario| match (some_run_well, some_run) {
        (true, _) => runs_well(changed),
        (_, true) => runs(changed),
        _ => true,
    };
    let kept = changes.into_iter().filter(|(_, changed)| is_kept(changed));
    kept.map(|(way_out, _)| way_out).collect()
}
