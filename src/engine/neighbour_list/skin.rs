//! How wide a skin is to be, by what is there when the list is made.
//!
//! The wider the skin the more pairs are walked each step, and the rarer lists are made. How many pairs
//! there would be is counted: in a bed there is a gap between first and second neighbours, in which a
//! wider skin costs nothing, and in a gas a wide one has few pairs. Counts are whole numbers, so that they
//! do not depend on the number of threads.

use super::make::Search;
use crate::engine::block::BLOCK;
use crate::engine::levels::Level;
use crate::engine::sizes::{Sizes, hash};
use crate::engine::workers::Workers;

/// Skins to choose from, in mean radii.
pub(super) const SKINS: [f64; 12] = [0.05, 0.1, 0.2, 0.35, 0.5, 0.7, 0.9, 1.15, 1.4, 2.0, 2.8, 4.0];

/// The one up to which near pairs are counted in any case.
const ALWAYS_COUNTED: usize = 8;

/// What walking a near pair costs in a step, and what making the list costs a disc, in ns on a processor of
/// 2023. Measured once; they decide the skin, and no result depends on them.
const COST_OF_PAIR: f64 = 1.35;
const COST_OF_LIST: f64 = 130.0;

/// Discs among which pairs are counted, at least; and of larger engines one in so many.
const DISCS_COUNTED: usize = 256;
const ONE_IN: usize = 16;

/// Which of the [`SKINS`] costs least up to `last`, if the list's discs (of which the fastest goes `travel`
/// mean radii a step) have `pairs` near pairs each with it. Of equal ones the widest.
fn cheapest(last: usize, travel: f64, pairs: impl Fn(usize) -> f64) -> usize {
    let cost = |k: usize| COST_OF_PAIR * pairs(k) + COST_OF_LIST * travel / (0.5 * SKINS[k]);
    (0..=last).rev().min_by(|&a, &b| cost(a).total_cmp(&cost(b))).unwrap_or(0)
}

/// The widest skin to be thought of for discs of which the fastest goes `travel` m a step: in a gas more
/// than where pairs are counted in any case.
fn widest(sizes: &Sizes, travel: f64) -> usize {
    // As many as there would be if discs lay anywhere.
    let pairs = |k: usize| 0.5 * sizes.density * (2.0 + SKINS[k]) * (2.0 + SKINS[k]);
    cheapest(SKINS.len() - 1, travel / sizes.mean_radius, pairs).max(ALWAYS_COUNTED)
}

/// The same in m.
pub(in crate::engine) fn widest_skin(sizes: &Sizes, travel: f64) -> f64 {
    SKINS[widest(sizes, travel)] * sizes.mean_radius
}

/// The skin of least cost, m, for discs of which the fastest goes `travel` m a step. Their `levels` are good for
/// the [`widest_skin`].
pub(super) fn best_skin(
    search: Search,
    levels: &[Level],
    sizes: &Sizes,
    travel: f64,
    workers: &Workers,
) -> f64 {
    let (last, mean) = (widest(sizes, travel), sizes.mean_radius);
    let (discs, counts) =
        count_by_skin(search, levels, SKINS.map(|skin| skin * mean), last, workers);
    let pairs = |k: usize| counts[..=k].iter().sum::<u64>() as f64 / discs as f64;
    SKINS[cheapest(last, travel / mean, pairs)] * mean
}

/// Of a sample of discs: how many, and how many pairs with each of `skins` (m) are not near with the one before.
fn count_by_skin(
    search: Search,
    levels: &[Level],
    skins: [f64; 12],
    last: usize,
    workers: &Workers,
) -> (u64, [u64; 12]) {
    let one_in = (search.discs.count() / DISCS_COUNTED).clamp(1, ONE_IN) as u64;
    let mut pieces = Vec::new();
    for (k, level) in levels.iter().enumerate() {
        let starts = (0..level.count()).step_by(BLOCK);
        let drawn = starts.filter(|&start| start == 0 || hash(start as u64) % one_in == 0);
        let piece = |start: usize| (k, start..(start + BLOCK).min(level.count()), [0; 12]);
        pieces.extend(drawn.map(piece));
    }
    workers.pieces(&mut pieces, |_, pieces| {
        for (k, discs, counts) in pieces {
            search.each_run(
                &levels[*k],
                levels[*k + 1..].iter(),
                discs.clone(),
                |_, (position, radius), (_, discs), run| {
                    for (its_position, its_radius) in run.map(|k| discs.at(k)) {
                        let reach = radius + its_radius;
                        let squared = position.distance_squared(its_position);
                        if squared < (reach + skins[last]) * (reach + skins[last]) {
                            let gap = squared.sqrt() - reach;
                            counts[skins[..last].iter().filter(|skin| gap >= **skin).count()] += 1;
                        }
                    }
                },
            );
        }
    });
    let mut counts = [0; 12];
    for (.., of_piece) in &pieces {
        counts.iter_mut().zip(of_piece).for_each(|(all, some)| *all += some);
    }
    (pieces.iter().map(|(_, discs, _)| discs.len() as u64).sum(), counts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::engine::sizes::Extents;

    #[test]
    fn the_skin_fills_a_gap_between_neighbours_and_stays_narrow_where_there_is_none() {
        // As in a bed: 3 pairs up to 0.9 radii, many more from there.
        let bed = |k: usize| if SKINS[k] <= 0.9 { 3.0 } else { 5.0 };
        assert_eq!(SKINS[cheapest(8, 1e-4, bed)], 0.9);
        assert_eq!(SKINS[cheapest(8, 0.0, bed)], 0.9);
        // Lists each few steps are worth more pairs.
        assert_eq!(SKINS[cheapest(8, 0.1, bed)], 1.4);
        // A pair more for each tenth of a radius.
        assert_eq!(SKINS[cheapest(8, 1e-4, |k| 10.0 * SKINS[k])], 0.05);
    }

    #[test]
    fn wider_skins_are_thought_of_where_discs_are_few_and_fast() {
        let none = Extents { phases: &[], radii: &[] };
        let of_none = Sizes::of(none, &[], &Workers::of(1));
        let sizes = |density| Sizes { mean_radius: 1.0, density, ..of_none };
        assert_eq!(widest_skin(&sizes(0.8), 1e-4), 1.4);
        assert_eq!(widest_skin(&sizes(0.01), 0.1), 4.0);
    }
}
