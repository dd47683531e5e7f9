//! What near pairs remember from step to step, and how it goes from one list to the next.

use super::block::BLOCK;
use super::neighbour_list::NeighbourList;

/// One number for each pair of the list, near and far ones; none where pairs remember nothing.
#[derive(Default)]
pub(super) struct PairMemory {
    pub near: Vec<f64>,
    pub far: Vec<f64>,
    /// Between two lists: the ids of those pairs that remember something, the lower first, ascending, and what.
    live: Vec<([u32; 2], f64)>,
}

impl PairMemory {
    /// Those that remember something, by ids: what a checkpoint keeps.
    pub fn live(&self, list: &NeighbourList, ids: &[u32]) -> Vec<([u32; 2], f64)> {
        let mut live = Vec::new();
        let mut keep = |[a, b]: [usize; 2], memory: f64| {
            if memory != 0.0 {
                live.push((by_id([ids[a], ids[b]]), memory));
            }
        };
        let blocks = if self.near.is_empty() { 0 } else { list.first_pair.len().saturating_sub(1) };
        for block in 0..blocks {
            let first = list.pairs_of(block).start;
            for (k, pair) in list.distinct_pairs_of(block).iter().enumerate() {
                let places = pair.map(|at| block * BLOCK + usize::from(at));
                keep(places, self.near[first + k]);
            }
        }
        for (pair, memory) in list.far.iter().zip(&self.far) {
            keep(pair.map(|at| at as usize), *memory);
        }
        live.sort_unstable_by_key(|(ids, _)| *ids);
        live
    }

    /// Takes the memories off the list, which is about to go.
    pub fn put_by(&mut self, list: &NeighbourList, ids: &[u32]) {
        if !self.near.is_empty() || !self.far.is_empty() {
            self.live = self.live(list, ids);
        }
        self.near.clear();
        self.far.clear();
    }

    /// These are remembered, and nothing else.
    pub fn remember(&mut self, live: Vec<([u32; 2], f64)>) {
        self.near.clear();
        self.far.clear();
        self.live = live;
    }

    /// Gives the pairs of a new list what they remember.
    pub fn look_up(&mut self, list: &NeighbourList, ids: &[u32]) {
        let of = |[a, b]: [usize; 2]| {
            let pair = by_id([ids[a], ids[b]]);
            let at = self.live.binary_search_by_key(&pair, |(ids, _)| *ids);
            at.map_or(0.0, |at| self.live[at].1)
        };
        let mut of_near = vec![0.0; list.pairs.len()];
        for block in 0..ids.len().div_ceil(BLOCK) {
            for k in list.pairs_of(block) {
                of_near[k] = of(list.pairs[k].map(|at| block * BLOCK + usize::from(at)));
            }
        }
        self.far = list.far.iter().map(|pair| of(pair.map(|at| at as usize))).collect();
        self.near = of_near;
        self.live.clear();
    }
}

fn by_id([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}
