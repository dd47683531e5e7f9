//! Lists held against what they are to be: every near pair once, every part where its force will lie.

use std::collections::BTreeSet;

use glam::DVec2;

use super::make::{Listed, Search};
use super::{GROUP, LONGEST_RING, NeighbourList, widest_skin};
use crate::boundary::Boundary;
use crate::discs::Discs;
use crate::engine::block::BLOCK;
use crate::engine::levels::levels;
use crate::engine::phase::Phase;
use crate::engine::sizes::{Extents, Sizes};
use crate::engine::workers::Workers;
use crate::engine::{Contacts, Engine};
use crate::integrator::{Integrator, SymplecticEuler};
use crate::neighbours::all_pairs;
use crate::particle::{Contact, ContactLaw, Damping, Particle, SpringDashpot};

const RADIUS: f64 = 5e-4; // m
const DT: f64 = 1e-6; // s

fn golden(k: usize) -> f64 {
    (0.618_033_988_749_895 * k as f64).fract()
}

/// Somewhere in the unit square.
fn somewhere(k: usize) -> DVec2 {
    DVec2::new(golden(k), golden(7919 * k + 3) * 0.5 + 0.5 * golden(104_729 * k))
}

fn disc(position: DVec2, radius: f64) -> Particle {
    Particle::at_rest(position, radius, 1e-3 * (radius / RADIUS) * (radius / RADIUS))
}

/// A square bed of rows of so many discs, that nearly touch.
fn bed(n: usize, columns: usize) -> Vec<Particle> {
    let place = |k: usize| DVec2::new((k % columns) as f64, (k / columns) as f64);
    (0..n).map(|k| disc((place(k) + 0.01 * somewhere(k)) * 2.02 * RADIUS, RADIUS)).collect()
}

/// So many that cover about this fraction of their ground, with radii of the fraction that `of` gives.
fn gas(n: usize, density: f64, of: impl Fn(usize) -> f64) -> Vec<Particle> {
    let side = (n as f64 * std::f64::consts::PI / density).sqrt() * RADIUS;
    let one = |k| {
        let mut disc = disc(side * somewhere(k), RADIUS * of(k));
        disc.velocity = 20.0 * DVec2::from_angle(k as f64);
        disc
    };
    (0..n).map(one).collect()
}

/// Nine in ten in a dense body, the others fast and up to `spread` of its widths away.
fn debris(n: usize, spread: f64) -> Vec<Particle> {
    let columns = (n as f64).sqrt() as usize;
    let mut discs = bed(n, columns);
    let width = columns as f64 * 2.02 * RADIUS;
    for k in (0..n).step_by(10) {
        discs[k].position = width * spread * (somewhere(k) - 0.5 + 0.7 * DVec2::X);
        discs[k].velocity = DVec2::from_angle(k as f64);
    }
    discs
}

/// A large disc in the middle of small ones.
fn giant(n: usize, times: f64) -> Vec<Particle> {
    let large = times * RADIUS;
    let mut discs = vec![disc(DVec2::ZERO, large)];
    let ring = (3.0 * times) as usize;
    let around = |k: usize| DVec2::from_angle(k as f64 / ring as f64 * std::f64::consts::TAU);
    discs.extend((0..ring).map(|k| disc((large + 0.9 * RADIUS) * around(k), RADIUS)));
    let width = (8.0 * large * large + 10.0 * n as f64 * RADIUS * RADIUS).sqrt();
    let places = (0..).map(|k| width * (somewhere(k) - 0.5));
    let outside = places.filter(|at| at.length() > large + 2.0 * RADIUS).map(|at| disc(at, RADIUS));
    discs.extend(outside.take(n - ring - 1));
    discs
}

fn scenes() -> Vec<(&'static str, Vec<Particle>)> {
    let clustered = |k: usize| if k % 2 == 0 { 1.0 } else { 0.3 };
    let mut clusters = gas(2000, 0.3, clustered);
    clusters.iter_mut().for_each(|p| p.position += 10.0 * (p.position * 40.0).floor());
    let mut far = bed(1500, 30);
    far[7].position = DVec2::new(500.0, -500.0);
    far[8].position = DVec2::new(-1e300, 2.0);
    let mut odd = bed(700, 20);
    (odd[300].position, odd[301].position) = (odd[5].position, odd[5].position);
    odd[600].position.x = f64::NAN;
    odd[601].position.y = f64::INFINITY;
    vec![
        ("none", Vec::new()),
        ("two", bed(2, 2)),
        ("bed", bed(3000, 60)),
        ("rows of 1000", bed(4000, 1000)),
        ("gas", gas(2500, 0.1, |_| 1.0)),
        ("clusters", clusters),
        ("1:100", gas(1500, 0.02, |k| 1.0 / (1.0 - 0.99 * golden(k)))),
        ("giant", giant(2500, 80.0)),
        ("debris", debris(2500, 30.0)),
        ("far", far),
        ("odd", odd),
    ]
}

const LAW: SpringDashpot =
    SpringDashpot { stiffness: 1e3, damping: Damping::Coefficient(0.01), tension: false };

fn engine(discs: Vec<Particle>, threads: usize) -> Engine<Contacts<SpringDashpot>> {
    let mut engine = Engine::new(discs, DVec2::ZERO, LAW, Vec::new(), DT, threads);
    // Ids in another order than that of places.
    let n = engine.columns.ids.len() as u32;
    engine.columns.ids.iter_mut().for_each(|id| *id = n - 1 - *id);
    engine.places.take();
    engine.list();
    engine
}

/// Lists these discs, stored as they come, with twice the skin.
fn list_anywhere(list: &mut NeighbourList, discs: &[Particle], ids: &[u32], workers: &Workers) {
    let phases: Vec<_> = discs.iter().map(Phase::from).collect();
    let radii: Vec<_> = discs.iter().map(|p| p.radius).collect();
    let discs = Extents { phases: &phases, radii: &radii };
    let boundary = Boundary::default();
    let listed = Listed { discs, ids, boundary, planes: &[], walls: &[], time: 0.0 };
    list.list_anywhere(listed, workers);
}

/// All pairs of a list, and that they are stored as they should be.
fn pairs(list: &NeighbourList) -> BTreeSet<[usize; 2]> {
    assert!(list.far.is_sorted());
    let mut pairs: BTreeSet<_> = list.far.iter().map(|pair| pair.map(|at| at as usize)).collect();
    let mut many = pairs.len();
    for block in 0..list.first_pair.len() - 1 {
        let distinct = list.distinct_pairs_of(block);
        assert!(distinct.is_sorted_by(|a, b| a < b));
        let all = &list.pairs[list.pairs_of(block)];
        assert!(all.len() % GROUP == 0 && all.len() < distinct.len() + GROUP);
        assert!(all[distinct.len()..].iter().all(|pair| Some(pair) == distinct.last()));
        for pair in distinct {
            let [a, b] = pair.map(|at| block * BLOCK + usize::from(at));
            assert!(a < b && a / BLOCK == block && b - a <= list.span as usize);
            pairs.insert([a, b]);
        }
        many += distinct.len();
    }
    assert_eq!(many, pairs.len(), "each once");
    pairs
}

fn near_pairs(particles: &[Particle], skin: f64) -> BTreeSet<[usize; 2]> {
    let is_near = |&(a, b): &(usize, usize)| {
        let (p, q) = (&particles[a], &particles[b]);
        let reach = p.radius + skin + q.radius;
        p.position.distance_squared(q.position) < reach * reach
    };
    all_pairs(particles.len()).filter(is_near).map(|(a, b)| [a, b]).collect()
}

/// Goes through the blocks as a pass does, and looks what every part finds in the ring.
fn hold_parts_against_pairs(list: &NeighbourList, ids: &[u32], wanted: &BTreeSet<[usize; 2]>) {
    assert!(list.ring_length % GROUP == 0 && list.ring_length <= LONGEST_RING);
    let mut parts: Vec<Vec<(u32, [usize; 2], usize)>> = vec![Vec::new(); ids.len()];
    for &pair in wanted {
        parts[pair[0]].push((ids[pair[1]], pair, 0));
        parts[pair[1]].push((ids[pair[0]], pair, 1));
    }
    let mut buffer = vec![None; list.ring_length + 1];
    buffer.extend(list.far.iter().map(|pair| Some(pair.map(|at| at as usize))));
    let mut more = list.more.iter().peekable();
    for block in 0..list.first_pair.len() - 1 {
        for k in list.pairs_of(block) {
            let pair = list.pairs[k].map(|at| block * BLOCK + usize::from(at));
            buffer[k % list.ring_length] = Some(pair);
        }
        let places = block * BLOCK..((block + 1) * BLOCK).min(ids.len());
        for (place, parts) in places.clone().zip(&mut parts[places]) {
            let mut entries: Vec<usize> = list.parts[place].map(usize::from).to_vec();
            if let Some(of) = more.next_if(|of| of.place as usize == place) {
                assert!(entries.iter().all(|entry| *entry == 2 * list.ring_length));
                let [start, end] = of.parts.map(|at| at as usize);
                entries = list.more_parts[start..end].iter().map(|at| *at as usize).collect();
            }
            parts.sort_unstable();
            let found: Vec<_> = entries
                .iter()
                .filter_map(|entry| buffer[entry / 2].map(|pair| (pair, entry % 2)))
                .collect();
            let wanted: Vec<_> = parts.iter().map(|part| (part.1, part.2)).collect();
            assert_eq!(found, wanted, "disc at {place}");
        }
    }
    assert_eq!(more.next(), None);
}

/// Whoever begins at a block finds all it needs in the pairs from `reaches_back_to` on.
fn hold_reaches_against_pairs(list: &NeighbourList) {
    let blocks = list.first_pair.len() - 1;
    let mut lowest = list.first_pair[..blocks].to_vec();
    for block in 0..blocks {
        for (k, pair) in list.pairs_of(block).zip(list.distinct_pairs_of(block)) {
            let reached = &mut lowest[block + usize::from(pair[1]) / BLOCK];
            *reached = (*reached).min((k / GROUP * GROUP) as u32);
        }
    }
    for block in 0..blocks {
        let of_later = lowest[block..].iter().min();
        assert_eq!(Some(&list.reaches_back_to[block]), of_later, "block {block}");
        let (first, places) = list.halo_at(block);
        assert!(list.first_pair[first] <= list.reaches_back_to[block]);
        for before in first..block {
            let ends = list.distinct_pairs_of(before).iter().map(|pair| usize::from(pair[1]));
            assert!(ends.max().is_none_or(|end| before * BLOCK + end < places.end));
        }
    }
}

#[test]
fn a_list_has_every_near_pair_once_and_every_part_where_its_force_will_lie() {
    for (name, discs) in scenes() {
        let mut engine = engine(discs, 1);
        let discs = engine.particles_as_stored().to_vec();
        let wanted = near_pairs(&discs, engine.list.skin);
        println!(
            "{name}: {} pairs, {} far, {} more",
            wanted.len(),
            engine.list.far.len(),
            engine.list.more.len()
        );
        assert_eq!(pairs(&engine.list), wanted, "{name}");
        hold_parts_against_pairs(&engine.list, &engine.columns.ids, &wanted);
        hold_reaches_against_pairs(&engine.list);

        // Stored in any order: the same with twice the skin.
        let discs: Vec<_> = discs.into_iter().rev().collect();
        let ids: Vec<_> = engine.columns.ids.iter().rev().copied().collect();
        let list = &mut engine.list;
        list_anywhere(list, &discs, &ids, &engine.workers);
        let wanted = near_pairs(&discs, 2.0 * list.skin);
        assert_eq!(pairs(list), wanted, "{name}");
        hold_parts_against_pairs(list, &ids, &wanted);
        hold_reaches_against_pairs(list);
    }
}

#[test]
fn pairs_far_apart_in_storage_are_told_from_those_that_fit_into_the_ring() {
    // Some eleven near pairs a disc, stored in any order.
    let n = 12_000;
    let mut discs = bed(n, 100);
    (0..n).for_each(|k| discs.swap(k, (7919 * k + 11) % n));
    let mut engine = engine(bed(2, 2), 1);
    let ids: Vec<u32> = (0..n as u32).collect();
    engine.list.skin = 1.5 * RADIUS;
    list_anywhere(&mut engine.list, &discs, &ids, &engine.workers);
    let list = &engine.list;
    assert!(list.span < super::SPAN, "{}", list.span);
    assert!(!list.far.is_empty() && list.pairs.len() > list.ring_length);
    let wanted = near_pairs(&discs, 3.0 * RADIUS);
    assert_eq!(pairs(list), wanted);
    hold_parts_against_pairs(list, &ids, &wanted);
    hold_reaches_against_pairs(list);
}

/// The force on each disc, N, and the energy stored, J: one contact after the other.
fn one_after_the_other(discs: &[Particle], law: &SpringDashpot) -> (Vec<DVec2>, f64) {
    let (mut forces, mut energy) = (vec![DVec2::ZERO; discs.len()], 0.0);
    for (a, b) in all_pairs(discs.len()) {
        if let Some(contact) = Contact::between(&discs[a], &discs[b]) {
            let force = law.push(&contact) * contact.normal;
            forces[a] -= force;
            forces[b] += force;
            energy += law.stored_energy(&contact);
        }
    }
    (forces, energy)
}

#[test]
fn a_giant_s_far_pairs_push_to_the_bits_of_one_contact_after_the_other_on_any_number_of_threads() {
    // All that do not touch it lie above its right half, between its own place and those of its partners there.
    let mut discs = giant(12_000, 400.0);
    for (k, p) in discs.iter_mut().enumerate().filter(|(_, p)| p.position.length() > 402.0 * RADIUS)
    {
        p.position = RADIUS * (DVec2::new(0.0, 402.0) + DVec2::new(400.0, 250.0) * somewhere(k));
    }
    let run = |threads| {
        let mut engine = engine(discs.clone(), threads);
        engine.keep_work_ledger();
        assert!(engine.list.far.len() > 50, "{}", engine.list.far.len());
        let (forces, energy) = one_after_the_other(engine.particles(), &LAW);
        for (id, wanted) in forces.into_iter().enumerate() {
            assert_eq!(engine.particle(id).force, wanted, "disc {id} on {threads} threads");
        }
        // A few thousand terms of one sign in another order.
        assert!((engine.stored_energy() / energy - 1.0).abs() < 1e-12);
        (0..20).for_each(|_| SymplecticEuler.step(engine.as_motion(), DT));
        engine.settle();
        (engine.particles().to_vec(), *engine.works())
    };
    let one = run(1);
    assert_ne!(one.0[0].velocity, DVec2::ZERO);
    for threads in [2, 3] {
        assert!(run(threads) == one, "{threads} threads");
    }
}

#[test]
fn a_list_does_not_depend_on_the_number_of_threads() {
    for (name, discs) in scenes() {
        let one = engine(discs.clone(), 1);
        for threads in [2, 3, 8] {
            let many = engine(discs.clone(), threads);
            assert_eq!(many.columns.ids, one.columns.ids, "{name}");
            let of = |list: &NeighbourList| {
                let NeighbourList { pairs, first_pair, far, parts, more, more_parts, .. } = list;
                let lists = (pairs.clone(), first_pair.clone(), far.clone(), parts.clone());
                let NeighbourList { reaches_back_to, reaches_ahead_to, ring_length, skin, .. } =
                    list;
                let reaches = (reaches_back_to.clone(), reaches_ahead_to.clone());
                (lists, more.clone(), more_parts.clone(), reaches, *ring_length, skin.to_bits())
            };
            assert!(of(&many.list) == of(&one.list), "{name} on {threads} threads");
        }
    }
}

/// Pairs looked at when a list is made of these discs, for each disc.
fn looked_at(discs: Vec<Particle>) -> f64 {
    let engine = engine(discs, 1);
    let radii: Vec<_> = engine.sizes.iter().map(|size| size.radius).collect();
    let discs = Extents { phases: &engine.phases, radii: &radii };
    let sizes = Sizes::of(discs, &engine.columns.ids, &engine.workers);
    let levels = levels(discs, &sizes, widest_skin(&sizes, 0.0), None);
    let search = Search { discs, skin: 0.0 };
    let mut looked_at = 0;
    for (k, level) in levels.iter().enumerate() {
        let coarser = levels[k + 1..].iter();
        search.each_run(level, coarser, 0..level.count(), |_, _, _, run| looked_at += run.len());
    }
    looked_at as f64 / discs.count() as f64
}

#[test]
fn rows_of_1000_debris_far_discs_and_giants_cost_no_more_looks_than_an_even_bed() {
    let even = looked_at(bed(100_000, 997));
    assert!(even < 16.0, "{even}"); // 4.5 cells of (3.4/2.02)^2 discs, less than 13, and what cells are wider
    let mut far = bed(20_000, 141);
    far[7].position = DVec2::splat(500.0);
    far[8].position = DVec2::splat(-1e300);
    let mut large = bed(100_000, 316);
    large[50_000] = disc(large[50_000].position, 500.0 * RADIUS);
    for (name, discs) in [
        ("rows of 1000", bed(100_000, 1000)),
        ("debris", debris(16_000, 10.0)),
        ("thin debris", debris(16_000, 1e3)),
        ("far", far),
        ("giant inside", large),
        ("giant", giant(100_000, 500.0)),
        // The mean radius, and with it the skin, is that of five of the smallest.
        ("1:100", gas(50_000, 0.002, |k| 1.0 / (1.0 - 0.99 * golden(k)))),
    ] {
        let looked_at = looked_at(discs);
        // As many, and for each coarser level a few.
        assert!(looked_at < even + 8.0, "{name}: {looked_at}, {even} in a bed");
    }
}

#[test]
fn a_disc_far_away_makes_no_list() {
    let lists = |far: Option<DVec2>| {
        let mut discs = bed(1000, 30);
        discs.iter_mut().enumerate().for_each(|(k, p)| p.velocity = DVec2::from_angle(k as f64));
        if let Some(far) = far {
            discs[7].position = far;
        }
        let mut engine = engine(discs, 1);
        (0..1000).for_each(|_| SymplecticEuler.step(engine.as_motion(), DT));
        engine.lists_made()
    };
    let wanted = lists(None);
    assert!((3..100).contains(&wanted), "{wanted}");
    for far in [DVec2::splat(500.0), DVec2::new(-1e9, 0.0), DVec2::splat(1e300)] {
        // A disc fewer is among the others, so that a list more or less may be made.
        assert!(lists(Some(far)).abs_diff(wanted) <= 2, "{far}");
    }
}

#[test]
fn a_bed_has_a_wide_skin_that_costs_no_pair_and_a_thin_gas_a_wider_one() {
    let spaced = engine(bed(4000, 60), 1); // 2.02 radii from one to the next, 2.86 across
    assert!(spaced.list.skin >= 0.69 * RADIUS, "{}", spaced.list.skin);
    let pairs_a_disc = pairs(&spaced.list).len() as f64 / 4000.0;
    assert!(pairs_a_disc < 2.0, "{pairs_a_disc}");
    let skin = engine(gas(4000, 0.01, |_| 1.0), 1).list.skin;
    assert!(skin > 2.0 * RADIUS, "{skin}");
}
