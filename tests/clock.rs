//! The clock: a time step that changes in a run, and comes back with the state.

use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, LedgerRow};
use parsim2d::particle::{Contact, ContactLaw, Damping, SpringDashpot};
use parsim2d::scenario::Scenario;
use parsim2d::simulation::{Simulation, State};

/// A few discs, stepped plainly, and the engine.
fn busy(is_crowd: bool) -> Simulation {
    busy_of(if is_crowd { 400 } else { 20 }, is_crowd)
}

fn busy_of(n: usize, is_crowd: bool) -> Simulation {
    let text = format!("n = {n}\nseed = 3\nradius = 5e-4\nspeed = 0.4\nrestitution = 0.6");
    let scenario = Scenario::from_toml(&text).unwrap();
    scenario.assemble(scenario.place().unwrap(), is_crowd)
}

#[test]
fn time_is_that_of_the_last_change_and_the_steps_since() {
    let mut run = busy(false);
    let dt = run.dt();
    (0..300).for_each(|_| run.step());
    assert_eq!(run.time(), 300.0 * dt);
    run.set_dt(0.5 * dt);
    assert_eq!((run.time(), run.steps(), run.dt()), (300.0 * dt, 300, 0.5 * dt));
    (0..100).for_each(|_| run.step());
    assert_eq!(run.time(), 300.0 * dt + 100.0 * (0.5 * dt));
}

#[test]
fn the_same_time_step_said_again_changes_no_bit() {
    for is_crowd in [false, true] {
        let (mut said, mut silent) = (busy(is_crowd), busy(is_crowd));
        for _ in 0..500 {
            said.set_dt(said.dt());
            said.step();
            silent.step();
        }
        assert_eq!(said.state_hash(), silent.state_hash());
        assert_eq!(said.time().to_bits(), silent.time().to_bits());
    }
}

#[test]
fn a_disc_in_flight_goes_as_far_as_the_new_step_says() {
    let text = "gravity = 0\n[[disc]]\nposition = [0.02, 0.02]\nvelocity = [0.1, 0]";
    let mut run = Scenario::from_toml(text).unwrap().build().unwrap();
    run.set_dt(1e-4);
    (0..10).for_each(|_| run.step());
    run.set_dt(3e-4);
    (0..10).for_each(|_| run.step());
    // v t; twenty sums of 0.02 m round by 1e-18 m each.
    assert!((run.particles()[0].position.x - 0.0204).abs() < 1e-16);
    assert!((run.time() - 4e-3).abs() < 1e-17);
}

#[test]
fn a_changed_time_step_comes_back_with_the_state_and_goes_on_to_the_same_bits() {
    for is_crowd in [false, true] {
        let mut straight = busy(is_crowd);
        let ledger = EnergyLedger::open(&mut straight);
        straight.step_until(400);
        straight.set_dt(0.5 * straight.dt());
        straight.step_until(700);
        let named = straight.state().arrays().into_iter();
        let state =
            State::from_arrays(named.map(|(name, array)| (name.to_owned(), array)).collect());
        let mut other = busy(is_crowd);
        other.keep_work_ledger();
        other.set_state(&state.unwrap());
        assert_eq!(other.dt().to_bits(), straight.dt().to_bits());
        for run in [&mut straight, &mut other] {
            run.step_until(1500);
        }
        assert_eq!(other.state_hash(), straight.state_hash());
        assert_eq!(ledger.row(&other), ledger.row(&straight));
    }
}

#[test]
fn gravity_and_law_change_between_two_steps_and_the_ledger_still_closes() {
    let law = |stiffness: f64| SpringDashpot {
        stiffness,
        damping: Damping::Coefficient(1.5e-3),
        tension: true,
    };
    let mut hashes = Vec::new();
    for is_crowd in [false, true] {
        let mut run = busy_of(400, is_crowd);
        let ledger = EnergyLedger::open(&mut run);
        run.step_until(400);
        let before = ledger.row(&run);
        run.set_gravity(DVec2::new(3.0, -1.6)); // a tilted moon
        let lifted = ledger.row(&run);
        assert!((lifted.gravitational_J - before.gravitational_J).abs() > 0.1 * before.total_J);
        assert_total(&lifted, &before);
        run.step_until(700);
        let before = ledger.row(&run);
        run.set_law(law(2.5e4)).expect("the law of the run is a spring and dashpot");
        let softened = ledger.row(&run);
        assert!(softened.elastic_J < 0.6 * before.elastic_J, "{before:?}"); // half as stiff
        assert_total(&softened, &before);
        run.step_until(1500);
        hashes.push(run.state_hash());
    }
    assert_eq!(hashes[0], hashes[1]);
}

/// The total stays where it was in a change: what it gave is booked.
fn assert_total(after: &LedgerRow, before: &LedgerRow) {
    // Sums of 400 terms in another order: 1e-16 each, of the whole at most.
    let bound = 1e-12 * before.total_J.abs();
    assert!((after.total_J - before.total_J).abs() < bound, "{before:?} {after:?}");
}

#[test]
fn a_law_of_another_type_is_given_back_and_changes_nothing() {
    struct Glue;
    impl ContactLaw for Glue {
        fn push(&self, _contact: &Contact) -> f64 {
            -1.0
        }
        fn spring(&self, _contact: &Contact) -> f64 {
            0.0
        }
        fn stored_energy(&self, _contact: &Contact) -> f64 {
            0.0
        }
    }
    for is_crowd in [false, true] {
        let (mut asked, mut silent) = (busy(is_crowd), busy(is_crowd));
        assert!(asked.set_law(Glue).is_err());
        asked.set_gravity(silent.gravity());
        for run in [&mut asked, &mut silent] {
            run.step_until(500);
        }
        assert_eq!(asked.state_hash(), silent.state_hash());
    }
}
