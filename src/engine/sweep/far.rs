//! Far pairs: computed before any disc is moved, for no thread knows when the other disc is.

use wide::f64x4;

use super::Sweep;
use crate::engine::largest::Largest;
use crate::engine::pair_buffer::{Entry, PairBuffer, Split, Whole};
use crate::engine::pairs::{Interaction, by_id, forces_of, sides_of};
use crate::engine::phase::Phase;
use crate::engine::workers::Workers;

impl<I: Interaction> Sweep<'_, I> {
    /// The forces of far pairs of `discs`, each remembering what it does in `memory`.
    pub fn far(
        &self,
        discs: &[Phase],
        memory: &mut [f64],
        workers: &Workers,
        ring: &mut PairBuffer,
        largest: &mut Largest,
    ) {
        match self.has_ledger {
            _ if self.list.far.is_empty() => {}
            false => self.far_with::<Whole>(discs, memory, workers, &mut ring.whole, largest),
            true => self.far_with::<Split>(discs, memory, workers, &mut ring.split, largest),
        }
    }

    fn far_with<E: Entry<f64x4>>(
        &self,
        discs: &[Phase],
        memory: &mut [f64],
        workers: &Workers,
        ring: &mut Vec<E::Both>,
        all: &mut Largest,
    ) {
        let list = self.list;
        ring.resize(list.far.len(), Default::default());
        let each = list.far.len().div_ceil(workers.threads()).max(1);
        let mut memory = memory.chunks_mut(each);
        let mut shares: Vec<_> = list
            .far
            .chunks(each)
            .zip(ring.chunks_mut(each))
            .map(|(pairs, ring)| {
                (pairs, ring, memory.next().unwrap_or_default(), Largest::default())
            })
            .collect();
        workers.each(&mut shares, |(pairs, ring, memory, largest)| {
            for (k, (pair, out)) in pairs.iter().zip(ring.iter_mut()).enumerate() {
                let body = |at: u32| self.fixed.body(at as usize, &discs[at as usize]);
                let (mut bodies, is_exchanged) = by_id([body(pair[0]), body(pair[1])]);
                self.boundary.bring_near(&mut bodies);
                let law = self.interaction.pairs();
                *out = match forces_of(law, &bodies, memory.get_mut(k), self.elapsed) {
                    None => Default::default(),
                    Some(forces) => {
                        largest.note(forces.overlap, bodies[0].radius, bodies[1].radius);
                        sides_of::<f64x4, E>(&forces, is_exchanged)
                    }
                };
            }
        });
        shares.iter().for_each(|(.., largest)| all.join(largest));
    }
}
