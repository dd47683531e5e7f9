//! The same bits whatever does the work: the plain way, a crowd, any number of threads, any batches
//! of steps, looks in between.

use parsim2d::analysis::energy::EnergyLedger;
use parsim2d::scenario::Scenario;
use parsim2d::simulation::{KeptState, Simulation};

/// Scenes that differ in who touches whom, and how often.
const SCENES: [(&str, &str, u64); 7] = [
    ("dense", "n = 900\nseed = 1\nradius = 5e-4\nside = 0.04\nspeed = 0.3", 1500),
    ("gas", "n = 1500\nseed = 2\nradius = 1e-4\ngravity = 0\nrestitution = 1\nspeed = 1.5", 1000),
    ("falling", "n = 700\nseed = 3\nradius = 3e-4\nrestitution = 0.7", 6000),
    (
        "corner",
        "n = 600\nseed = 4\nradius = 4e-4\nspeed = 1\nkn = 2e4\nrestitution = 0.4\nwalls = false\n\
         integrator = 'velocity-verlet'",
        1500,
    ),
    (
        "polydisperse",
        "seed = 5\nspeed = 0.5\nrestitution = 0.8\n[[population]]\nn = 40\nradius = 1.5e-3\n\
         mass = 9e-3\n[[population]]\nn = 600\nradius = 4e-4\nmass = 1e-3",
        1500,
    ),
    ("soft", "n = 500\nseed = 6\nspeed = 2\nradius = 4e-4\nkn = 3e3\neta = 0.01", 1200),
    (
        "clipped",
        "n = 500\nseed = 7\nspeed = 1\nradius = 5e-4\ngamma = 8e2\nno_tension = true",
        2500,
    ),
];

fn plain(text: &str) -> Simulation {
    let mut start = Scenario::from_toml(text).unwrap();
    let discs = start.build().unwrap().particles().to_vec();
    start.output.threads = Some(1);
    start.assemble(discs, false)
}

fn crowd(text: &str, threads: usize) -> Simulation {
    let mut start = Scenario::from_toml(text).unwrap();
    start.output.threads = Some(threads);
    start.build().unwrap()
}

/// What must agree to the bit.
fn outcome(simulation: &Simulation) -> (u64, [u64; 3]) {
    let overlaps = [
        simulation.largest_pair_overlap(),
        simulation.largest_sinking(),
        simulation.largest_wall_overlap(),
    ];
    (simulation.state_hash(), overlaps.map(f64::to_bits))
}

#[test]
fn a_crowd_has_the_bits_of_the_plain_way_on_any_number_of_threads() {
    for (name, text, steps) in SCENES {
        let mut plain = plain(text);
        let moved_from = plain.state_hash();
        (0..steps).for_each(|_| plain.step());
        assert_ne!(plain.state_hash(), moved_from);
        assert!(plain.largest_overlap() > 0.01, "{name} is no test: nothing touches");
        for threads in [1, 2, 3, 4, 8] {
            let mut crowd = crowd(text, threads);
            crowd.step_until(steps);
            assert_eq!(outcome(&crowd), outcome(&plain), "{name} on {threads} threads");
            assert!(crowd.lists_made() > 2, "{name}: {} lists", crowd.lists_made());
        }
    }
}

#[test]
fn ledger_batches_and_looks_change_no_bit() {
    for (name, text, steps) in SCENES {
        let steps = steps / 4;
        let energies = |simulation: &Simulation, ledger: &EnergyLedger| {
            let row = ledger.row(simulation);
            [row.kinetic_J, row.elastic_J, row.dissipated_J, row.work_error_J].map(f64::to_bits)
        };
        let mut whole = crowd(text, 1);
        let ledger = EnergyLedger::open(&mut whole);
        whole.step_until(steps);
        for (threads, batch) in [(1, 1), (2, 7), (3, 64)] {
            let mut parts = crowd(text, threads);
            let ledger_of_parts = EnergyLedger::open(&mut parts);
            while parts.steps() < steps {
                parts.step_until((parts.steps() + batch).min(steps));
                assert_eq!(parts.particles().len(), parts.n());
                ledger_of_parts.row(&parts);
            }
            assert_eq!(outcome(&parts), outcome(&whole), "{name}, {batch} steps at a time");
            let (seen, wanted) = (energies(&parts, &ledger_of_parts), energies(&whole, &ledger));
            assert_eq!(seen, wanted, "{name}, {batch} steps at a time");
        }
        let mut without = crowd(text, 2);
        without.step_until(steps);
        assert_eq!(outcome(&without), outcome(&whole), "{name} without ledger");
    }
}

#[test]
fn a_state_come_back_to_goes_on_to_the_same_bits() {
    for (name, text, steps) in SCENES {
        let mut straight = crowd(text, 1);
        let ledger = EnergyLedger::open(&mut straight);
        straight.step_until(steps / 3);
        let state = straight.state();
        straight.step_until(steps);
        let wanted = (outcome(&straight), ledger.row(&straight));

        straight.set_state(&state);
        straight.step_until(steps);
        assert_eq!((outcome(&straight), ledger.row(&straight)), wanted, "{name}, the same crowd");

        let mut other = crowd(text, 2);
        other.keep_work_ledger();
        other.set_state(&state);
        other.step_until(steps);
        assert_eq!((outcome(&other), ledger.row(&other)), wanted, "{name}, another crowd");
    }
}

#[test]
fn a_kept_state_gone_back_to_goes_on_to_the_same_bits() {
    for (name, text, steps) in SCENES {
        for (has_ledger, threads) in [(true, 2), (false, 1)] {
            let mut straight = crowd(text, threads);
            let ledger = has_ledger.then(|| EnergyLedger::open(&mut straight));
            let outcome = |simulation: &Simulation| {
                (outcome(simulation), ledger.as_ref().map(|ledger| ledger.row(simulation)))
            };
            let mut kept = KeptState::default();
            straight.keep(&mut kept); // what it keeps first does not stay
            straight.step_until(steps / 3);
            straight.keep(&mut kept);
            let there = (outcome(&straight), forces(&straight));
            straight.step_until(steps);
            let wanted = outcome(&straight);
            for _ in 0..2 {
                straight.go_back(&kept);
                assert_eq!(kept.steps(), steps / 3);
                assert_eq!((outcome(&straight), forces(&straight)), there, "{name}, there");
                straight.step_until(steps);
                assert_eq!(outcome(&straight), wanted, "{name}, from there on");
            }
        }
    }
}

#[test]
fn sizes_changed_by_hand_are_gone_back_on_too() {
    let (_, text, steps) = SCENES[0];
    let mut run = crowd(text, 1);
    run.step_until(steps / 3);
    let mut kept = KeptState::default();
    run.keep(&mut kept);
    run.step_until(steps / 2);
    let wanted = outcome(&run);
    for factor in [1.1, 1.2] {
        run.act(|discs| discs[7].radius *= factor);
        run.act(|discs| discs.iter_mut().for_each(|disc| disc.mass *= factor));
        run.step_until(steps / 2 + 10);
    }
    assert_ne!(run.particles()[7].radius, 5e-4);
    run.go_back(&kept);
    run.step_until(steps / 2);
    assert_eq!(outcome(&run), wanted);
}

/// Every force, to the bit, N.
fn forces(simulation: &Simulation) -> Vec<[u64; 2]> {
    simulation.each_particle().map(|disc| disc.force.to_array().map(f64::to_bits)).collect()
}
