//! How discs are stored and near pairs listed.

use super::block::BLOCK;
use super::cells::{Grid, put_in_order};
use super::levels::usual_radius;
use super::neighbour_list::{Listed, NeighbourList, widest_skin};
use super::pairs::Interaction;
use super::sizes::Sizes;
use super::stepper::Engine;
use super::workers::Workers;
use crate::discs::columns::Columns;
use crate::pair::PairLaw;
use crate::particle::Particle;

impl<I: Interaction> Engine<I> {
    /// Stores the discs in this order: for each place, where its disc is now. What lies beside the discs
    /// goes with them. `order` is used up.
    pub(super) fn store(&mut self, order: &mut [u32]) {
        let mut is_moved = false;
        put_in_order(order, |a, b| {
            is_moved = true;
            self.phases.swap(a, b);
            self.sizes.swap(a, b);
            self.forces.swap(a, b);
            self.columns.swap(a, b);
        });
        if is_moved {
            self.forget_copies();
            self.places.take();
        }
    }

    /// Stores the discs cell by cell and lists who is near whom, with a skin for the present speeds.
    pub(super) fn list(&mut self) {
        self.memory.put_by(&self.list, &self.columns.ids);
        self.moment.list();
        let listed = self.to_be_listed();
        let sizes = Sizes::of(&listed, &self.columns.ids, &self.workers);
        let travel = (sizes.fastest * self.dt).min(sizes.largest_radius);
        // The cells of the median disc, however large the largest.
        let skin = widest_skin(&sizes, travel);
        let usual = usual_radius(&listed, &sizes, skin);
        let grid = Grid::new(&sizes, 2.0 * usual + skin);
        self.store(&mut grid.order(&listed, &self.columns.ids, &self.workers));
        let particles = &self.to_be_listed()[..];
        self.make_list(particles, |list, listed, workers| {
            list.make(listed, &sizes, travel, workers)
        });
        self.after_listing();
    }

    /// A list of the discs wherever they are stored, good for the energy of the present state.
    pub(super) fn list_anywhere(
        &mut self,
        restore: impl FnOnce(&mut NeighbourList, Listed, &Workers),
    ) {
        self.memory.put_by(&self.list, &self.columns.ids);
        self.make_list(&self.to_be_listed(), restore);
        self.after_listing();
    }

    pub(super) fn make_list(
        &mut self,
        particles: &[Particle],
        make: impl FnOnce(&mut NeighbourList, Listed, &Workers),
    ) {
        let Self { columns: Columns { ids, .. }, planes, walls, boundary, list, workers, .. } =
            self;
        let time = self.moment.of_forces();
        let may_touch = |disc: &Particle, skin: f64| {
            let is_near = |distance: f64| distance < disc.radius + skin;
            planes.iter().any(|plane| is_near(plane.distance(disc.position)))
                || walls.iter().any(|wall| is_near(wall.nearest(disc.position, time).distance))
        };
        let listed = Listed { particles, ids, boundary: *boundary, may_touch: &may_touch };
        make(list, listed, workers);
    }

    pub(super) fn after_listing(&mut self) {
        if self.equal.is_none() {
            self.constants.work_out(&self.list, &self.sizes, &self.workers);
        }
        if <I::Pairs as PairLaw>::HAS_MEMORY {
            self.live.take();
            self.memory.look_up(&self.list, &self.columns.ids);
        }
        self.runs.share_out(&self.list, self.phases.len().div_ceil(BLOCK), self.workers.threads());
    }

    pub(super) fn forget_list(&mut self) {
        self.list.forget();
    }
}
