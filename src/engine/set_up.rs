//! How an engine is put together.

use std::sync::{Arc, OnceLock};

use glam::DVec2;

use super::added::Added;
use super::constants::PairConstants;
use super::moment::Moment;
use super::neighbour_list::NeighbourList;
use super::pair_buffer::PairBuffer;
use super::pair_memory::PairMemory;
use super::pairs::Interaction;
use super::runs::Runs;
use super::since::Since;
use super::stepper::Engine;
use super::workers::Workers;
use crate::boundary::Boundary;
use crate::discs::Discs;
use crate::discs::columns::Columns;
use crate::field::Field;
use crate::force::HalfPlane;
use crate::integrator::Motion;
use crate::pair::Contacts;
use crate::particle::{ContactLaw, Particle};
use crate::wall::Wall;

impl<L: ContactLaw + Clone + Sync + 'static> Engine<Contacts<L>> {
    /// Discs under `gravity` (m/s2) that touch each other and the walls `planes` by `law`. They will be
    /// moved on by `dt` (s) a step, by `threads` threads.
    pub fn new(
        particles: Vec<Particle>,
        gravity: DVec2,
        law: L,
        planes: Vec<HalfPlane>,
        dt: f64,
        threads: usize,
    ) -> Self {
        Self::of(particles, gravity, Contacts { law }, planes, dt, threads)
    }
}

impl<I: Interaction> Engine<I> {
    /// Discs under `gravity` (m/s2) that act on each other and on the walls `planes` as `interaction` says. They will be
    /// moved on by `dt` (s) a step, by `threads` threads.
    pub fn of(
        particles: Vec<Particle>,
        gravity: DVec2,
        interaction: I,
        planes: Vec<HalfPlane>,
        dt: f64,
        threads: usize,
    ) -> Self {
        let mut engine = Self {
            interaction,
            planes,
            walls: Vec::new(),
            top_speed: 0.0,
            power: [0.0; 2],
            boundary: Boundary::default(),
            gravity: gravity + DVec2::ZERO, // -0.0 would be told from the 0.0 of no contact
            dt,
            columns: Columns { ids: (0..particles.len() as u32).collect(), ..Columns::default() },
            phases: Vec::new(),
            sizes: Vec::new(),
            forces: Vec::new(),
            equal: None,
            list: NeighbourList::default(),
            constants: PairConstants::default(),
            memory: PairMemory::default(),
            live: OnceLock::new(),
            added: Added::default(),
            forces_are_wanted: false,
            moves: Vec::new(),
            elapsed: 0.0,
            moment: Moment::default(),
            runs: Runs::default(),
            far: PairBuffer::default(),
            books: Vec::new(),
            workers: Workers::of(threads),
            since_forces: Since::Still,
            resized: Vec::new(),
            in_id_order: OnceLock::new(),
            as_stored: OnceLock::new(),
            places: OnceLock::new(),
        };
        engine.take_in(&particles);
        drop(particles); // before the list is made
        engine.list.forget();
        engine.update_forces();
        engine.settle();
        engine
    }

    /// The same in a space that ends as `boundary` says.
    pub fn in_space(mut self, boundary: Boundary) -> Self {
        self.boundary = boundary;
        self.start_anew();
        self
    }

    /// The same with more walls.
    pub fn with_walls(mut self, walls: Vec<Arc<dyn Wall>>) -> Self {
        self.top_speed = walls.iter().map(|wall| wall.top_speed()).fold(0.0, f64::max);
        self.walls = walls;
        self.start_anew();
        self
    }

    /// The same in fields.
    pub fn in_fields(mut self, fields: Vec<Arc<dyn Field>>) -> Self {
        self.added.fields = fields;
        self.start_anew();
        self
    }

    /// The same with discs of these kinds, by id.
    pub fn of_kinds(mut self, kinds: &[u32]) -> Self {
        self.columns.kinds = self.columns.ids.iter().map(|&id| kinds[id as usize]).collect();
        self.start_anew();
        self
    }

    /// Something has changed that lists and forces hang on.
    pub(super) fn start_anew(&mut self) {
        self.forget_list();
        self.update_forces();
        self.settle();
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.workers.threads()
    }
}
