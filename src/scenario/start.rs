//! Where discs are when the run begins: read from a frame, listed, or placed.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;

use super::error::ScenarioError;
use super::range::radius_in;
use super::settings::{PlacementName, Settings};
use super::{DiscSource, Population, Scenario};
use crate::force::HalfPlane;
use crate::neighbours::Neighbours;
use crate::output::frames::read_frame;
use crate::particle::{Contact, Particle};
use crate::placement::{self, PlacementError};
use glam::DVec2;

/// Reads the discs of `--start FILE[:K]`. Radii and, where there are columns for them,
/// velocities come from the file, masses from the scenario.
pub(super) fn read(
    said: &str,
    scenario: &Scenario,
    settings: &Settings,
) -> Result<Vec<Particle>, ScenarioError> {
    let (path, frame) = match said.rsplit_once(':') {
        Some((path, k)) if k.parse::<usize>().is_ok() => (path, k.parse().ok()),
        _ => (said, None),
    };
    let bad_start = |why: String| ScenarioError::BadStart {
        path: path.into(),
        why,
    };
    let file = File::open(Path::new(path)).map_err(|why| bad_start(why.to_string()))?;
    let rows = read_frame(BufReader::new(file), frame).map_err(bad_start)?;
    if settings.speed.is_some() && rows.iter().any(|row| row.velocity.is_some()) {
        return Err(ScenarioError::Conflict {
            one: "start".into(),
            other: "speed".into(),
            why: "the file has velocities".into(),
        });
    }
    let disc = |(k, row): (usize, &crate::output::frames::FrameRow)| {
        let field = format!("disc {k} of {path}: r");
        let radius = radius_in(scenario.side, &field, row.radius, scenario.walls)?;
        let mut disc = Particle::at_rest(row.position, radius, scenario.mass);
        disc.velocity = row.velocity.unwrap_or_default();
        Ok(disc)
    };
    rows.iter().enumerate().map(disc).collect()
}

impl Scenario {
    /// The discs at t = 0, placed and checked.
    pub(super) fn place(&self) -> Result<Vec<Particle>, ScenarioError> {
        let mut generator = placement::generator(self.seed);
        let equal = |n| Population {
            n,
            radius: self.radius,
            mass: self.mass,
            speed: self.speed,
        };
        let (mut particles, groups) = match &self.discs {
            DiscSource::Equal(n) => (Vec::new(), vec![equal(*n)]),
            DiscSource::Listed(listed, groups) => (listed.clone(), groups.clone()),
            DiscSource::Frame(_, discs) => (discs.clone(), Vec::new()),
        };
        let fixed = particles.len();
        self.check_overlaps(&particles)?;
        for group in &groups {
            let disc = Particle::at_rest(DVec2::ZERO, group.radius, group.mass);
            particles.extend(std::iter::repeat_n(disc, group.n));
        }
        if particles.len() > fixed {
            match self.placement {
                PlacementName::Lattice if fixed == 0 => {
                    placement::lattice(&mut particles, self.side, &mut generator)
                }
                _ => placement::at_random(&mut particles, fixed, self.side, &mut generator),
            }
            .map_err(|why| self.box_too_full(why, &particles))?;
        }
        let speeds = groups
            .iter()
            .flat_map(|group| std::iter::repeat_n(group.speed, group.n));
        for (disc, speed) in particles[fixed..].iter_mut().zip(speeds) {
            if speed > 0.0 {
                disc.velocity = speed * placement::direction(&mut generator);
            }
        }
        self.set_speed_of_frame(&mut particles[..fixed], &mut generator);
        Ok(particles)
    }

    /// `--speed` beside a `--start` file that has no velocities.
    fn set_speed_of_frame(&self, discs: &mut [Particle], generator: &mut rand_pcg::Pcg64) {
        if matches!(self.discs, DiscSource::Frame(..)) && self.speed > 0.0 {
            for disc in discs {
                disc.velocity = self.speed * placement::direction(generator);
            }
        }
    }

    /// Refuses coincident centres and overlaps of more than one radius: the contact force would
    /// throw such discs apart. Smaller overlaps are told in the notes.
    fn check_overlaps(&self, discs: &[Particle]) -> Result<(), ScenarioError> {
        let bad = |what: String| {
            let way_out = "move the discs apart, or use a smaller radius".to_owned();
            Err(ScenarioError::BadOverlap { what, way_out })
        };
        for overlap in self.overlaps(discs) {
            let Overlap {
                disc,
                other,
                relative,
                centres_coincide,
            } = overlap;
            match other {
                Some(other) if centres_coincide => {
                    return bad(format!("discs {disc} and {other} have the same centre"));
                }
                Some(other) if relative > 1.0 => {
                    return bad(format!(
                        "discs {disc} and {other} overlap by {relative:.3} radii"
                    ));
                }
                None if relative >= 1.0 => {
                    let p = discs[disc].position;
                    let which = if relative > 1.0 {
                        "outside the box"
                    } else {
                        "on a wall"
                    };
                    return bad(format!(
                        "disc {disc} has its centre {which} ({} m, {} m; side {} m)",
                        p.x, p.y, self.side
                    ));
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// All overlaps of `discs` with each other and with the walls.
    pub(super) fn overlaps(&self, discs: &[Particle]) -> Vec<Overlap> {
        let mut overlaps = Vec::new();
        let planes = HalfPlane::square(self.side);
        let planes = if self.walls { &planes[..] } else { &[] };
        for (disc, p) in discs.iter().enumerate() {
            for plane in planes {
                let distance = plane.distance(p.position);
                if let Some(contact) = Contact::with_wall(p, distance, plane.normal) {
                    let relative = contact.overlap / p.radius;
                    overlaps.push(Overlap {
                        disc,
                        other: None,
                        relative,
                        centres_coincide: false,
                    });
                }
            }
        }
        let mut neighbours = Neighbours::default();
        neighbours.refresh(discs);
        for (i, j) in neighbours.pairs() {
            if let Some(contact) = Contact::between(&discs[i], &discs[j]) {
                let relative = contact.overlap / discs[i].radius.min(discs[j].radius);
                let centres_coincide = discs[i].position == discs[j].position;
                overlaps.push(Overlap {
                    disc: i,
                    other: Some(j),
                    relative,
                    centres_coincide,
                });
            }
        }
        overlaps
    }

    /// A placement error with ways out that fit.
    fn box_too_full(&self, source: PlacementError, particles: &[Particle]) -> ScenarioError {
        let (n, fraction) = (
            particles.len(),
            placement::packing_fraction(particles, self.side),
        );
        let (_, largest) = self.radius_range();
        let mut ways_out = Vec::new();
        let random = matches!(source, PlacementError::NoRoomAtRandom { .. });
        if random && n <= placement::lattice_capacity(largest, self.side) {
            ways_out.push("--placement lattice".to_owned());
        }
        // Comfortably below the random limit; walls cost some room too.
        let shrink = 0.4 / fraction;
        if matches!(self.discs, DiscSource::Equal(_)) && shrink < 1.0 {
            ways_out.push(format!("-n {}", ((n as f64 * shrink) as usize).max(1)));
            ways_out.push(format!(
                "--radius {:.1e}",
                0.95 * self.radius * shrink.sqrt()
            ));
        }
        let side = self.side
            * (1.0f64 / shrink)
                .max(1.1)
                .sqrt()
                .max(2.5 * largest / self.side);
        ways_out.push(format!("--side {:.1e}", 1.05 * side));
        ScenarioError::BoxTooFull {
            source,
            way_out: ways_out.join(", or "),
        }
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
}
