//! Energy supplied from outside: by forces that store nothing, and by hand. It stands in a column of its own and
//! is no integration error.

use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, LedgerRow};
use parsim2d::analysis::guard::{EVERY, Guard, Wrong};
use parsim2d::force::Force;
use parsim2d::output::energy::{EnergyFile, HEADER, OLD_HEADER, read};
use parsim2d::output::growing::Extent;
use parsim2d::particle::{Contact, ContactLaw, Particle};
use parsim2d::scenario::Scenario;
use parsim2d::simulation::{Simulation, State};

use crate::support::{ELASTIC, INTEGRATORS, MASS, RADIUS, disc_at, floor, law};

const GRAVITY: DVec2 = DVec2::new(0.0, -9.81);

/// -c v: takes energy and stores none. With c < 0 it gives.
struct Drag(f64); // kg/s

impl Force for Drag {
    fn apply(&mut self, particles: &mut [Particle]) -> f64 {
        particles.iter_mut().for_each(|disc| disc.force -= self.0 * disc.velocity);
        0.0
    }
}

/// A spring to the origin, of 0.1 N/m.
struct Spring;

impl Force for Spring {
    fn apply(&mut self, particles: &mut [Particle]) -> f64 {
        let mut stored_energy = 0.0;
        for disc in particles {
            disc.force -= 0.1 * disc.position;
            stored_energy += 0.05 * disc.position.length_squared();
        }
        stored_energy
    }
}

/// One disc that flies at 1 m/s, under these forces.
fn flying(gravity: DVec2, forces: Vec<Box<dyn Force>>) -> Simulation {
    let disc = disc_at(DVec2::new(0.01, 0.02), DVec2::new(0.6, 0.8));
    let (law, integrator) = (law(ELASTIC), INTEGRATORS[0].1());
    let mut simulation = Simulation::new(vec![disc], gravity, law, &[], integrator, 1e-4);
    forces.into_iter().for_each(|force| simulation.add_force(force));
    simulation
}

/// The ledger's lines at the start and after so many `steps`.
fn course(simulation: &mut Simulation, steps: u32) -> [LedgerRow; 2] {
    let ledger = EnergyLedger::open(simulation);
    let start = ledger.row(simulation);
    (0..steps).for_each(|_| simulation.step());
    [start, ledger.row(simulation)]
}

/// A sum of a thousand works rounds so much, in parts of the energy.
const ROUND_OFF: f64 = 1e-13;

#[test]
fn what_drag_takes_is_supplied_less_than_nothing() {
    let c = 2e-3; // kg/s
    let [start, end] = course(&mut flying(DVec2::ZERO, vec![Box::new(Drag(c))]), 1000);
    // Eq. (3) multiplies v by 1 - c dt/m in each step.
    let left = (1.0 - c * 1e-4 / MASS).powi(2000);
    let k = 0.5 * MASS;
    assert!((end.supplied_J - k * (left - 1.0)).abs() < ROUND_OFF * k, "{end:?}");
    assert!((end.total_J - start.total_J).abs() < ROUND_OFF * k, "{end:?}");
    assert!(end.work_error_J.abs() < ROUND_OFF * k, "{end:?}");
}

#[test]
fn a_force_that_says_what_it_stores_supplies_nothing_and_shows_its_integration_error() {
    // Period 2 pi sqrt(m/k) = 0.63 s: a quarter of it. Eq. (3) errs by omega dt/2 = 5e-4 on the way.
    let [start, end] = course(&mut flying(DVec2::ZERO, vec![Box::new(Spring)]), 785);
    let size = start.total_J;
    assert!(end.supplied_J.abs() < ROUND_OFF * size, "{end:?}");
    let error = ((end.total_J - start.total_J) / size).abs();
    assert!((1e-5..1e-3).contains(&error), "{error}");
    assert!(end.work_error_J.abs() < ROUND_OFF * size, "{end:?}");
}

#[test]
fn a_spring_and_drag_are_told_apart() {
    let forces: Vec<Box<dyn Force>> = vec![Box::new(Drag(1e-3)), Box::new(Spring)];
    let [start, end] = course(&mut flying(GRAVITY, forces), 1000);
    let [_, free] = course(&mut flying(GRAVITY, vec![Box::new(Spring)]), 1000);
    let size = start.kinetic_J + start.gravitational_J + start.elastic_J;
    // c v^2 t with v of 0.6 m/s on the way; what is left in the total is the error of the spring and of the fall,
    // m g v dt/2 < 5e-7 J and omega dt/2 of the spring's 2e-4 J.
    assert!((-5e-5..-3e-5).contains(&end.supplied_J), "{end:?}");
    for row in [end, free] {
        assert!((row.total_J - start.total_J).abs() < 1e-6, "{row:?}");
        assert!(row.work_error_J.abs() < ROUND_OFF * size, "{row:?}");
    }
    assert!(free.supplied_J.abs() < ROUND_OFF * size, "{free:?}");
}

#[test]
fn what_is_given_by_hand_is_supplied_by_few_discs_and_by_a_crowd() {
    for n in [20, 300] {
        let text = format!("n = {n}\nseed = 1\nradius = 5e-4\nrestitution = 0.5\nspeed = 0.2");
        let mut simulation = Scenario::from_toml(&text).unwrap().build().unwrap();
        let ledger = EnergyLedger::open(&mut simulation);
        (0..2000).for_each(|_| simulation.step());
        let before = ledger.row(&simulation);
        assert_eq!(before.supplied_J, 0.0, "{before:?}");
        let kinetic = |simulation: &Simulation| simulation.sum_over(Particle::kinetic_energy);
        // A tap, then all discs lifted by a micrometre: out of the floor a little, and not against each other.
        let was = kinetic(&simulation);
        simulation.act(|discs| discs.iter_mut().for_each(|disc| disc.velocity.y += 0.3));
        let tapped = ledger.row(&simulation);
        let size = before.total_J;
        assert!((tapped.supplied_J - (kinetic(&simulation) - was)).abs() < ROUND_OFF * size);
        simulation.act(|discs| discs.iter_mut().for_each(|disc| disc.position.y += 1e-6));
        let lifted = ledger.row(&simulation);
        let elastic = lifted.elastic_J - tapped.elastic_J;
        let height = n as f64 * MASS * 9.81 * 1e-6;
        let gain = lifted.supplied_J - tapped.supplied_J;
        assert!((gain - height - elastic).abs() < ROUND_OFF * size, "{gain:e} {height:e}");
        for row in [tapped, lifted] {
            assert!((row.total_J - before.total_J).abs() < ROUND_OFF * size, "{row:?}");
            assert!(row.work_error_J.abs() < ROUND_OFF * size, "{row:?}");
        }
    }
}

#[test]
fn a_force_added_on_the_way_brings_its_energy_along() {
    let mut simulation = flying(DVec2::ZERO, Vec::new());
    let ledger = EnergyLedger::open(&mut simulation);
    simulation.add_force(Box::new(Spring));
    let row = ledger.row(&simulation);
    assert_eq!(row.supplied_J, 0.05 * DVec2::new(0.01, 0.02).length_squared());
    assert!((row.total_J - 0.5 * MASS).abs() < ROUND_OFF * MASS, "{row:?}");
}

#[test]
fn the_guard_does_not_sound_for_energy_that_was_supplied() {
    let mut simulation = flying(DVec2::ZERO, vec![Box::new(Drag(-1e-3))]);
    let ledger = EnergyLedger::open(&mut simulation);
    let mut guard = Guard::new(&simulation, None, Wrong::ALL.to_vec());
    for _ in 0..200 {
        (0..EVERY).for_each(|_| simulation.step());
        assert_eq!(guard.look(&mut simulation), None);
    }
    // e-fold twice: v grows by exp(c t/m), t = 200 * 64 * 1e-4 s.
    assert!(ledger.row(&simulation).kinetic_J > 10.0 * 0.5 * MASS);
}

#[test]
fn without_a_ledger_too_the_guard_knows_what_was_supplied() {
    let mut simulation = flying(DVec2::ZERO, vec![Box::new(Drag(-1e-3))]);
    let mut guard = Guard::new(&simulation, None, Wrong::ALL.to_vec());
    for _ in 0..200 {
        (0..EVERY).for_each(|_| simulation.step());
        assert_eq!(guard.look(&mut simulation), None);
    }
    assert!(simulation.supplied() > 9.0 * 0.5 * MASS, "{}", simulation.supplied());
    // A tap that multiplies the energy by nine, of few discs and of the engine.
    for n in [20, 300] {
        let text = format!("n = {n}\nseed = 1\nradius = 5e-4\ngravity = 0\nspeed = 0.2");
        let mut simulation = Scenario::from_toml(&text).unwrap().build().unwrap();
        simulation.act(|discs| discs[0].velocity *= 1.1); // before the guard comes: none of its business
        let mut guard = Guard::new(&simulation, Some(0.04), Wrong::ALL.to_vec());
        simulation.act(|discs| discs.iter_mut().for_each(|disc| disc.velocity *= 3.0));
        for _ in 0..3 {
            simulation.step_until(guard.next_look(&simulation));
            assert_eq!(guard.look(&mut simulation), None, "{n} discs");
        }
        assert!(simulation.works().is_none());
    }
}

/// A force upward, so large (N) that its sum with others rounds: whether it comes first shows in the last digits.
struct Constant;

const UPWARD: DVec2 = DVec2::new(0.0, 1e12);

impl Force for Constant {
    fn apply(&mut self, particles: &mut [Particle]) -> f64 {
        particles.iter_mut().for_each(|disc| disc.force += UPWARD);
        0.0
    }
}

#[test]
fn a_disc_s_forces_are_added_up_weight_first_then_ones_own_then_walls_then_discs() {
    let depth = 3e-6;
    let discs = vec![
        disc_at(DVec2::new(0.02, RADIUS - depth), DVec2::ZERO),
        disc_at(DVec2::new(0.02 + 1.99 * RADIUS, 1.1 * RADIUS), DVec2::ZERO),
    ];
    let law = law(ELASTIC);
    let touch = Contact::between(&discs[0], &discs[1]).unwrap();
    let floor_touch =
        Contact::with_wall(&discs[0], floor().distance(discs[0].position), floor().normal).unwrap();
    let mut simulation = Simulation::new(discs, GRAVITY, law, &[floor()], INTEGRATORS[0].1(), 1e-6);
    simulation.add_force(Box::new(Constant));
    let weight = MASS * GRAVITY;
    let wall = law.push(&floor_touch) * floor_touch.normal;
    let pair = law.push(&touch) * touch.normal;
    let wanted = weight + UPWARD - wall - pair; // rounded in this order: equal to the bit
    assert_eq!(simulation.particles()[0].force, wanted);
    for other in [weight - wall + UPWARD - pair, weight - wall - pair + UPWARD] {
        assert_ne!(other, wanted, "no order is told apart here");
    }
}

#[test]
fn what_was_supplied_survives_a_restart() {
    let begin = || {
        let mut simulation = flying(GRAVITY, vec![Box::new(Drag(1e-3)), Box::new(Spring)]);
        let ledger = EnergyLedger::open(&mut simulation);
        (simulation, ledger)
    };
    let (mut first, ledger) = begin();
    (0..100).for_each(|_| first.step());
    first.act(|discs| discs[0].position.y += 1e-3);
    let named = first.state().arrays().into_iter().map(|(name, array)| (name.to_owned(), array));
    let state = State::from_arrays(named.collect()).unwrap();
    let (mut second, _) = begin();
    second.set_state(&state);
    assert!(ledger.row(&first).supplied_J != 0.0);
    for _ in 0..100 {
        assert_eq!(ledger.row(&first), ledger.row(&second));
        first.step();
        second.step();
    }
}

#[test]
fn a_ledger_of_eight_columns_says_that_nothing_was_supplied() {
    let text = format!("{OLD_HEADER}\n0,0,0.5,1.5,0,0,2,0\n1,0.1,0.6,1.4,0,0,2,0\n");
    let rows = read(text.as_bytes()).unwrap();
    assert_eq!(rows.iter().map(|row| row.supplied_J).collect::<Vec<_>>(), [0.0, 0.0]);
    assert_eq!(rows[1].kinetic_J, 0.6);
}

#[test]
fn a_run_that_goes_on_keeps_the_columns_of_its_old_ledger() {
    for (header, zero) in [(OLD_HEADER, ""), (HEADER, ",0.0")] {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("energy.csv");
        let begun = format!("{header}\n0,0.0,0.5,1.5,0.0,0.0,2.0,0.0{zero}\n");
        std::fs::write(&path, &begun).unwrap();
        let extent = Extent { bytes: begun.len() as u64, crc32: crc32fast::hash(begun.as_bytes()) };
        let file = std::fs::OpenOptions::new().read(true).write(true).open(&path).unwrap();
        let mut file = EnergyFile::continued(file, path.clone(), extent).unwrap();
        let rows = read(begun.as_bytes()).unwrap();
        file.append(&LedgerRow { step: 1, ..rows[0] }).unwrap();
        file.flush().unwrap();
        let expected = format!("{begun}1,0.0,0.5,1.5,0.0,0.0,2.0,0.0{zero}\n");
        assert_eq!(std::fs::read_to_string(&path).unwrap(), expected);
    }
}
