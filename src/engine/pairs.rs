//! What a sweep does with the near pairs of a block: the lean [walk](super::walk) for contacts, one pair at a time for every
//! other law.

use std::any::Any;

use super::block_pairs::BlockPairs;
use super::lanes::Lanes;
use super::largest::Largest;
use super::pair_buffer::Entry;
use super::walk::{Equal, Scratch, Unequal, Walk};
use crate::pair::{Body, Contacts, PairForces, PairLaw};
use crate::particle::ContactLaw;

/// A pair law as the sweep uses it, with the law of contacts at walls.
pub trait Interaction: Clone + Send + Sync + 'static {
    /// What acts between discs.
    type Pairs: PairLaw;
    /// What acts at walls.
    type AtWalls: ContactLaw;
    /// What acts between discs.
    fn pairs(&self) -> &Self::Pairs;
    /// What acts at walls.
    fn at_walls(&self) -> &Self::AtWalls;
    /// Takes another law of contacts out of `law`, an `Option`, if it is of the type of the present one, and says whether it is.
    fn take_law(&mut self, law: &mut dyn Any) -> bool;
    #[doc(hidden)]
    #[allow(private_interfaces, private_bounds)]
    #[inline(always)]
    fn walk<V: Lanes, E: Entry<V>>(
        &self,
        _zero: V,
        block: &mut BlockPairs,
        ring: &mut [E::Both],
        slot: usize,
        _scratch: &mut Scratch,
        largest: &mut Largest,
    ) {
        one_by_one::<V, E, _>(self.pairs(), block, ring, slot, largest);
    }
}

impl<L: ContactLaw + Clone + Sync + 'static> Interaction for Contacts<L> {
    type Pairs = Self;
    type AtWalls = L;

    fn pairs(&self) -> &Self {
        self
    }

    fn at_walls(&self) -> &L {
        &self.law
    }

    fn take_law(&mut self, law: &mut dyn Any) -> bool {
        take(&mut self.law, law)
    }

    #[allow(private_interfaces, private_bounds)]
    #[inline(always)]
    fn walk<V: Lanes, E: Entry<V>>(
        &self,
        zero: V,
        block: &mut BlockPairs,
        ring: &mut [E::Both],
        slot: usize,
        scratch: &mut Scratch,
        largest: &mut Largest,
    ) {
        let law = &self.law;
        match block.fixed.equal {
            Some(size) => {
                let walk = Walk { law, sizing: Equal::of(size), block };
                walk.go::<V, E>(zero, ring, slot, scratch, largest);
            }
            None => {
                let walk = Walk { law, sizing: Unequal::of(block.constants), block };
                walk.go::<V, E>(zero, ring, slot, scratch, largest);
            }
        }
    }
}

/// Discs that act on each other by one law, and on walls by another.
#[derive(Clone, Debug)]
pub struct Pairwise<P, L> {
    /// What acts between discs.
    pub pairs: P,
    /// What acts at walls.
    pub at_walls: L,
}

impl<P: PairLaw, L: ContactLaw + Clone + Sync + 'static> Interaction for Pairwise<P, L> {
    type Pairs = P;
    type AtWalls = L;

    fn pairs(&self) -> &P {
        &self.pairs
    }

    fn at_walls(&self) -> &L {
        &self.at_walls
    }

    fn take_law(&mut self, law: &mut dyn Any) -> bool {
        take(&mut self.at_walls, law)
    }
}

fn take<L: 'static>(present: &mut L, law: &mut dyn Any) -> bool {
    let law = law.downcast_mut::<Option<L>>().and_then(Option::take);
    law.map(|law| *present = law).is_some()
}

/// The forces of a pair, the one of lower id first, with what it remembers brought up to date.
#[inline(always)]
pub(super) fn forces_of<P: PairLaw>(
    law: &P,
    bodies: &[Body; 2],
    memory: Option<&mut f64>,
    elapsed: f64,
) -> Option<PairForces> {
    let Some(memory) = memory else { return law.forces(bodies, 0.0) };
    let advanced = match elapsed > 0.0 {
        true => law.advance(bodies, *memory, elapsed),
        false => *memory,
    };
    let forces = law.forces(bodies, advanced);
    *memory = if forces.is_some() { advanced } else { 0.0 };
    forces
}

/// The two bodies with the lower id first, and whether that exchanged them.
#[inline(always)]
pub(super) fn by_id([a, b]: [Body; 2]) -> ([Body; 2], bool) {
    if a.id < b.id { ([a, b], false) } else { ([b, a], true) }
}

/// Both sides of a pair as they lie in the ring.
#[inline(always)]
pub(super) fn sides_of<V: Lanes, E: Entry<V>>(forces: &PairForces, is_exchanged: bool) -> E::Both {
    let side = |k: usize| E::side(forces.on[k], forces.conservative[k]);
    E::together(if is_exchanged { [side(1), side(0)] } else { [side(0), side(1)] })
}

fn one_by_one<V: Lanes, E: Entry<V>, P: PairLaw>(
    law: &P,
    block: &mut BlockPairs,
    ring: &mut [E::Both],
    slot: usize,
    largest: &mut Largest,
) {
    let slots = (slot..ring.len()).chain(0..slot);
    let BlockPairs { fixed, discs, place, pairs, memory, elapsed, .. } = block;
    for ((k, pair), slot) in pairs.iter().enumerate().zip(slots) {
        let body = |at: u16| fixed.body(*place + usize::from(at), discs.at(at));
        let (bodies, is_exchanged) = by_id([body(pair[0]), body(pair[1])]);
        ring[slot] = match forces_of(law, &bodies, memory.get_mut(k), *elapsed) {
            None => Default::default(),
            Some(forces) => {
                largest.note(forces.overlap, bodies[0].radius, bodies[1].radius);
                sides_of::<V, E>(&forces, is_exchanged)
            }
        };
    }
}
