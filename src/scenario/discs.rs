//! Which discs a run has, as said: so many equal ones, listed ones and groups, or a frame.

use std::sync::Arc;

use glam::DVec2;

use super::error::ScenarioError;
use super::framed::FramedDiscs;
use super::range::{ABOVE_0, ANY, FROM_0, Range, from_to, radius_in};
use super::resolve::si;
use super::settings::{DiscSettings, PopulationSettings, Settings};
use super::start;
use super::{DiscSource, Population, Scenario};
use crate::particle::Particle;

/// More discs than this do not fit the memory of a machine of today (250 bytes each).
const NUMBERS: Range = from_to(1.0, 1e8);

impl Scenario {
    /// Takes over the discs that `settings` say, or `usual` many equal ones. A frame may bring
    /// the side of its box along; one that is already there, `frame`, is not read again.
    pub(super) fn take_discs(
        &mut self,
        settings: &Settings,
        usual: usize,
        frame: Option<FramedDiscs>,
    ) -> Result<(), ScenarioError> {
        if let (Some(columns), None) = (&settings.columns, &settings.start) {
            return Err(ScenarioError::out_of_range(
                "columns",
                columns,
                "it says how the file of --start is read, and there is none",
                "--start FILE, or leave it out",
            ));
        }
        let (discs, groups) = (&settings.discs, &settings.populations);
        self.discs = if let (Some(said), Some(discs)) = (&settings.start, frame) {
            DiscSource::Frame {
                said: said.clone(),
                columns: settings.columns.clone(),
                discs: Arc::new(discs),
                // A scenario says only what its file does not hold.
                has_velocities: settings.speed.is_none(),
                has_masses: settings.mass.is_none(),
                has_radii: settings.radius.is_none(),
                side: None,
                are_named: true,
                notes: Vec::new(),
            }
        } else if let Some(said) = &settings.start {
            let (frame, side) = start::read(said, self, settings)?;
            if let (None, Some(side)) = (settings.side, side) {
                self.side = ABOVE_0.check("side_m of the frame", side, "--side 4cm")?;
            }
            frame
        } else if discs.is_empty() && groups.is_empty() {
            let n = NUMBERS.check_whole("n", settings.n.unwrap_or(usual as i64), "-n 20")?;
            radius_in(self.side, "radius", self.radius, self.walls)?;
            DiscSource::Equal(n as usize)
        } else {
            let listed = discs.iter().enumerate().map(|(k, disc)| self.listed_disc(k, disc));
            let groups = groups.iter().enumerate().map(|(k, group)| self.population(k, group));
            let (listed, groups) =
                (listed.collect::<Result<_, _>>()?, groups.collect::<Result<_, _>>()?);
            DiscSource::Listed(listed, groups)
        };
        NUMBERS.check_whole("the number of discs", self.n() as i64, "fewer discs")?;
        Ok(())
    }

    /// Ids count from 0 in file order.
    fn listed_disc(&self, id: usize, said: &DiscSettings) -> Result<Particle, ScenarioError> {
        let field = |name: &str| format!("disc {id}: {name}");
        let radius = si(said.radius, self.radius);
        let radius = radius_in(self.side, &field("radius"), radius, self.walls)?;
        let mass = ABOVE_0.check(&field("mass"), si(said.mass, self.mass), "mass = 1e-3")?;
        let vector = |name: &str, [x, y]: [f64; 2]| {
            let component =
                |axis, value| ANY.check(&field(&format!("{name} {axis}")), value, "write a number");
            Ok(DVec2::new(component("x", x)?, component("y", y)?))
        };
        let position = vector("position", said.position.si)?;
        let mut disc = Particle::at_rest(position, radius, mass);
        if let Some(velocity) = &said.velocity {
            disc.velocity = vector("velocity", velocity.si)?;
        }
        Ok(disc)
    }

    fn population(&self, k: usize, said: &PopulationSettings) -> Result<Population, ScenarioError> {
        let field = |name: &str| format!("population {k}: {name}");
        let radius = si(said.radius, self.radius);
        let mass = si(said.mass, self.mass);
        let speed = si(said.speed, self.speed);
        Ok(Population {
            n: NUMBERS.check_whole(&field("n"), said.n, "n = 20")? as usize,
            radius: radius_in(self.side, &field("radius"), radius, true)?,
            mass: ABOVE_0.check(&field("mass"), mass, "mass = 1e-3")?,
            speed: FROM_0.check(&field("speed"), speed, "speed = 0.1")?,
        })
    }
}
