//! How discs are stored and near pairs listed.

use super::block::BLOCK;
use super::cells::{Grid, put_in_order};
use super::levels::usual_radius;
use super::neighbour_list::{Listed, NeighbourList, widest_skin};
use super::pairs::Interaction;
use super::phase::Size;
use super::sizes::{Extents, Sizes};
use super::stepper::Engine;
use super::workers::Workers;
use crate::pair::PairLaw;

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
        let radii = self.ranges();
        let (discs, ids) = (Extents { phases: &self.phases, radii: &radii }, &self.columns.ids);
        let sizes = Sizes::of(discs, ids, &self.workers);
        let travel = (sizes.fastest * self.dt).min(sizes.largest_radius);
        // The cells of the median disc, however large the largest.
        let skin = widest_skin(&sizes, travel);
        let grid = Grid::new(&sizes, 2.0 * usual_radius(&radii, &sizes, skin) + skin);
        drop(radii);
        let (mut order, stored) = grid.order(&self.phases, ids, &self.workers);
        self.store(&mut order);
        drop(order);
        self.make_list(|list, listed, workers| list.make(listed, &sizes, stored, travel, workers));
    }

    /// Half of the distance of centres up to which each disc acts on its like, m, or its radius if that is more.
    fn ranges(&self) -> Vec<f64> {
        let (law, kinds) = (self.interaction.pairs(), &self.columns.kinds);
        let range = |(place, size): (usize, &Size)| {
            let kind = kinds.get(place).copied().unwrap_or(0);
            law.range(size.radius, kind).max(size.radius)
        };
        self.sizes.iter().enumerate().map(range).collect()
    }

    /// A list of the discs wherever they are stored, good for the energy of the present state.
    pub(super) fn list_anywhere(
        &mut self,
        restore: impl FnOnce(&mut NeighbourList, Listed, &Workers),
    ) {
        self.memory.put_by(&self.list, &self.columns.ids);
        self.make_list(restore);
    }

    fn make_list(&mut self, make: impl FnOnce(&mut NeighbourList, Listed, &Workers)) {
        let radii = &self.ranges()[..];
        let Self { phases, planes, walls, boundary, list, workers, .. } = self;
        let (discs, ids) = (Extents { phases, radii }, &self.columns.ids[..]);
        let (boundary, time) = (*boundary, self.moment.of_forces());
        make(list, Listed { discs, ids, boundary, planes, walls, time }, workers);
        self.after_listing();
    }

    fn after_listing(&mut self) {
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
