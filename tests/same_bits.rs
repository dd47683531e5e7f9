//! The same bits whatever does the work: the plain way, the engine, any number of threads, any batches
//! of steps, looks in between.

use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, LedgerRow};
use parsim2d::integrator::{Integrator, Motion};
use parsim2d::particle::Particle;
use parsim2d::scenario::Scenario;
use parsim2d::simulation::Simulation;
use parsim2d::simulation::restore_point::RestorePoint;

/// Scenes that differ in who touches whom, and how often.
const SCENES: [(&str, &str, u64); 10] = [
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
        1200,
    ),
    (
        "explicit",
        "n = 600\nseed = 8\nspeed = 1\nradius = 5e-4\nnt = 400\nintegrator = 'explicit-euler'",
        2500,
    ),
    // Pairs of a block may begin many blocks before it, and those of the next one before these.
    (
        "unequal",
        "seed = 3\nside = 0.2\nspeed = 0.3\nintegrator = 'velocity-verlet'\n[[population]]\nn = 3\n\
         radius = 0.02\nmass = 1\n[[population]]\nn = 3000\nradius = 2e-4\nmass = 1e-3",
        450,
    ),
    (
        "strip",
        "n = 2400\nseed = 1\nside = 3\nplacement = 'lattice'\nwalls = false\ngravity = 0",
        300,
    ),
];

/// The discs of a scene; those of the one without walls and gravity in a strip of a few long rows.
fn discs(start: &Scenario) -> Vec<Particle> {
    let mut discs = start.build().unwrap().particles().to_vec();
    if !start.walls && start.gravity.is_nothing() {
        let n = discs.len();
        for (k, disc) in discs.iter_mut().enumerate() {
            let golden = (0.618_034 * k as f64).fract();
            disc.radius = 5e-4;
            disc.position = DVec2::new(9e-4 * ((k * 7919) % n) as f64, 1.5e-3 * golden);
            disc.velocity = DVec2::from_angle(k as f64);
        }
    }
    discs
}

fn plain(text: &str) -> Simulation {
    let start = Scenario::from_toml(text).unwrap();
    start.assemble(discs(&start), false)
}

fn engine(text: &str, threads: usize) -> Simulation {
    let mut start = Scenario::from_toml(text).unwrap();
    start.output.threads = Some(threads as u64);
    start.assemble(discs(&start), true)
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
fn the_engine_has_the_bits_of_the_plain_way_on_any_number_of_threads() {
    for (name, text, steps) in SCENES {
        let mut plain = plain(text);
        let moved_from = plain.state_hash();
        (0..steps).for_each(|_| plain.step());
        assert_ne!(plain.state_hash(), moved_from);
        assert!(plain.largest_overlap() > 0.01, "{name} is no test: nothing touches");
        for threads in [1, 2, 3, 4, 8] {
            let mut engine = engine(text, threads);
            engine.step_until(steps);
            assert_eq!(outcome(&engine), outcome(&plain), "{name} on {threads} threads");
            assert_eq!(engine.particles(), plain.particles(), "{name} on {threads} threads");
            assert!(engine.lists_made() > 2, "{name}: {} lists", engine.lists_made());
        }
    }
}

#[test]
fn a_gas_so_wide_that_a_row_of_cells_is_longer_than_a_block_has_the_same_bits_on_two_threads() {
    let text =
        "n = 100000\nseed = 5\nradius = 3e-6\ngravity = 0\nspeed = 1\nnt = 1300\nrestitution = 1";
    let mut one = engine(text, 1);
    one.step_until(47);
    assert!(one.largest_pair_overlap() > 0.01);
    for threads in [2, 5] {
        let mut many = engine(text, threads);
        many.step_until(47);
        assert_eq!(outcome(&many), outcome(&one), "{threads} threads");
    }
}

#[test]
fn the_engine_s_ledger_is_that_of_the_plain_way_but_for_rounding() {
    for (name, text, steps) in SCENES {
        let row = |mut simulation: Simulation| {
            let ledger = EnergyLedger::open(&mut simulation);
            simulation.step_until(steps / 2);
            ledger.row(&simulation)
        };
        let (plain, engine) = (row(plain(text)), row(engine(text, 2)));
        let columns = |row: &LedgerRow| {
            [row.kinetic_J, row.gravitational_J, row.elastic_J, row.dissipated_J, row.work_error_J]
        };
        let whole = plain.total_J.abs();
        for (plain, engine) in columns(&plain).into_iter().zip(columns(&engine)) {
            // Sums of thousands of terms in another order: 1e-16 each, of the whole at most.
            let bound = 1e-12 * whole;
            assert!((plain - engine).abs() <= bound, "{name}: {plain:e} {engine:e}");
        }
    }
}

#[test]
fn discs_changed_by_hand_far_away_nowhere_or_at_one_place_keep_the_same_bits() {
    type Change = fn(&mut [Particle]);
    let changes: [(&str, Change); 4] = [
        // Pushed apart along x, from the lower id to the higher, wherever each was stored before.
        ("one place", |discs| (0..9).for_each(|k| discs[590 + k].position = discs[k].position)),
        ("faster", |discs| discs.iter_mut().for_each(|disc| disc.velocity *= 1.5)),
        ("far", |discs| discs[7].position = DVec2::new(1e5, 1e5)),
        ("nowhere", |discs| discs[11].position.x = f64::NAN),
    ];
    let (_, text, _) = SCENES[3]; // without walls
    for (name, change) in changes {
        let run = |mut simulation: Simulation| {
            simulation.step_until(200);
            simulation.act(change);
            simulation.step_until(600);
            simulation
        };
        let (plain, engine) = (run(plain(text)), run(engine(text, 2)));
        assert_eq!(outcome(&engine), outcome(&plain), "{name}");
        let (there, here) = (plain.stored_energy(), engine.stored_energy());
        assert!((there - here).abs() <= 1e-12 * there, "{name}: {there:e} {here:e}"); // rounding

        // Come back to, also where every step makes a new list.
        let state = engine.state();
        let mut other = self::engine(text, 1);
        other.set_state(&state);
        assert_eq!(other.stored_energy().to_bits(), engine.stored_energy().to_bits(), "{name}");
        let mut straight = engine;
        straight.step_until(800);
        other.step_until(800);
        assert_eq!(outcome(&other), outcome(&straight), "{name}");
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
        let mut whole = engine(text, 1);
        let ledger = EnergyLedger::open(&mut whole);
        whole.step_until(steps);
        for (threads, batch) in [(1, 1), (2, 7), (3, 64)] {
            let mut parts = engine(text, threads);
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
        let mut without = engine(text, 2);
        without.step_until(steps);
        assert_eq!(outcome(&without), outcome(&whole), "{name} without ledger");
    }
}

#[test]
fn a_state_come_back_to_goes_on_to_the_same_bits() {
    for (name, text, steps) in SCENES {
        let mut straight = engine(text, 1);
        let ledger = EnergyLedger::open(&mut straight);
        straight.step_until(steps / 3);
        let state = straight.state();
        straight.step_until(steps);
        let wanted = (outcome(&straight), ledger.row(&straight));

        straight.set_state(&state);
        straight.step_until(steps);
        assert_eq!((outcome(&straight), ledger.row(&straight)), wanted, "{name}, the same engine");

        let mut other = engine(text, 2);
        other.keep_work_ledger();
        other.set_state(&state);
        other.step_until(steps);
        assert_eq!((outcome(&other), ledger.row(&other)), wanted, "{name}, another engine");
    }
}

#[test]
fn a_kept_state_gone_back_to_goes_on_to_the_same_bits() {
    for (name, text, steps) in SCENES {
        for (has_ledger, threads) in [(true, 2), (false, 1)] {
            let mut straight = engine(text, threads);
            let ledger = has_ledger.then(|| EnergyLedger::open(&mut straight));
            let outcome = |simulation: &Simulation| {
                (outcome(simulation), ledger.as_ref().map(|ledger| ledger.row(simulation)))
            };
            let mut kept = RestorePoint::default();
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

/// Eq. (3) whose drift changes the discs themselves, and slows them down a little.
struct ByHand;

impl Integrator for ByHand {
    fn step(&mut self, discs: &mut dyn Motion, dt: f64) {
        discs.kick(dt);
        discs.each(&|_, disc| {
            disc.velocity *= 1.0 - dt;
            disc.drift(dt);
        });
        discs.update_forces();
    }
}

#[test]
fn an_integrator_that_changes_each_disc_has_the_same_bits_and_makes_no_more_lists() {
    for k in [0, 2, 4] {
        let (name, text, steps) = SCENES[k];
        let (mut plain, mut usual) = (plain(text), engine(text, 1));
        plain.set_integrator(Box::new(ByHand));
        (0..steps).for_each(|_| plain.step());
        usual.step_until(steps);
        for threads in [1, 2, 3] {
            let mut engine = engine(text, threads);
            engine.set_integrator(Box::new(ByHand));
            let mut kept = RestorePoint::default();
            engine.step_until(steps / 2);
            engine.keep(&mut kept);
            engine.step_until(steps / 2 + 50);
            engine.go_back(&kept);
            engine.step_until(steps);
            assert_eq!(outcome(&engine), outcome(&plain), "{name} on {threads} threads");
            // A list follows the discs' way, not who moved them: as many as usual, a few more or less.
            let (lists, usual) = (engine.lists_made(), usual.lists_made());
            assert!(lists <= usual + usual / 4 + 2, "{name}: {lists} lists, {usual} usually");
        }
    }
}

#[test]
fn sizes_changed_by_hand_are_gone_back_on_too() {
    let (_, text, steps) = SCENES[0];
    let mut run = engine(text, 1);
    run.step_until(steps / 3);
    let mut kept = RestorePoint::default();
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
