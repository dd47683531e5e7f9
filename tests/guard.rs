//! The guard of a run: what it notices, and the step it finds.

use crate::support::{ELASTIC, MASS, NewIntegrator, RADIUS, STIFFNESS, disc_at, floor, law};
use glam::DVec2;
use parsim2d::analysis::energy::MechanicalEnergy;
use parsim2d::analysis::guard::{BEYOND, CROSSED, EVERY, GROWTH, Guard, Trouble, Wrong};
use parsim2d::analysis::stability::mode_limit;
use parsim2d::force::HalfPlane;
use parsim2d::integrator::{Integrator, SymplecticEuler, VelocityVerlet};
use parsim2d::particle::Particle;
use parsim2d::simulation::Simulation;
use parsim2d::work::Works;

/// Two discs held together by a squeeze between two walls, stepped above their limit.
fn squeezed_pair(integrator: Box<dyn Integrator>, ledger: bool) -> Simulation {
    let law = law(ELASTIC);
    let discs = vec![
        Particle::at_rest(DVec2::ZERO, RADIUS, MASS),
        Particle::at_rest(DVec2::new(1.9 * RADIUS, 0.0), RADIUS, MASS),
    ];
    let planes = [
        HalfPlane { point: DVec2::new(-0.9 * RADIUS, 0.0), normal: DVec2::NEG_X },
        HalfPlane { point: DVec2::new(2.8 * RADIUS, 0.0), normal: DVec2::X },
    ];
    let dt = 1.3 * mode_limit(STIFFNESS, 0.0, 2.0 / MASS);
    let mut simulation = Simulation::new(discs, DVec2::ZERO, law, &planes, integrator, dt);
    if ledger {
        simulation.keep_work_ledger();
    }
    simulation
}

fn steps_until_trouble(simulation: &mut Simulation, guard: &mut Guard) -> Trouble {
    loop {
        let until = guard.next_look(simulation);
        while simulation.steps() < until {
            simulation.step();
        }
        if let Some(trouble) = guard.look(simulation) {
            return trouble;
        }
        assert!(simulation.steps() < 100_000, "nothing found");
    }
}

#[test]
fn the_first_bad_step_is_found_and_the_state_is_the_one_before() {
    // The oracle looks at every single step, the guard at every 64th.
    let symplectic: NewIntegrator = || Box::new(SymplecticEuler);
    let verlet: NewIntegrator = || Box::new(VelocityVerlet);
    let cases = [(symplectic, false), (symplectic, true), (verlet, true)];
    for (integrator, ledger) in cases {
        let mut simulation = squeezed_pair(integrator(), ledger);
        let mut oracle = squeezed_pair(integrator(), ledger);
        let mut guard = Guard::new(&simulation, None, Wrong::ALL.to_vec());
        let trouble = steps_until_trouble(&mut simulation, &mut guard);
        // All the energy at the start is elastic and can move the discs.
        let most = (1.0 + GROWTH) * trouble.energy_at_start;
        while oracle.steps() + 1 < trouble.step {
            oracle.step();
            let energy = MechanicalEnergy::of(&oracle).total();
            let dissipated = oracle.works().map_or(0.0, Works::dissipated);
            assert!(energy <= most && energy + dissipated <= most, "step {}", oracle.steps());
            assert!(oracle.largest_sinking() < CROSSED);
        }
        assert_eq!(simulation.steps(), trouble.step - 1);
        assert_eq!(simulation.state_hash(), oracle.state_hash(), "the same bits");
        assert!(matches!(trouble.wrong, Wrong::EnergyGrown | Wrong::Crossed), "{trouble:?}");
        assert_ne!(trouble.step % EVERY, 0, "not where it happened to look");
        // From the last good step it goes on as it would have, ledger and all.
        simulation.step();
        oracle.step();
        assert_eq!(simulation.state_hash(), oracle.state_hash());
        assert_eq!(simulation.works(), oracle.works());
        let energy = MechanicalEnergy::of(&oracle).total();
        assert_eq!(energy.to_bits(), trouble.energy_after.to_bits());
    }
}

/// A disc thrown at the floor at `speed` (m/s), with a spring of 1 N/m.
fn thrown(speed: f64) -> Simulation {
    let soft = parsim2d::particle::SpringDashpot { stiffness: 1.0, ..law(ELASTIC) };
    let disc = disc_at(DVec2::new(0.02, 2.0 * RADIUS), DVec2::new(0.0, -speed));
    let dt = 1e-5;
    let integrator = Box::new(SymplecticEuler);
    Simulation::new(vec![disc], DVec2::ZERO, soft, &[floor()], integrator, dt)
}

#[test]
fn a_disc_five_radii_deep_in_a_wall_is_named_with_the_wall() {
    // It sinks v sqrt(m/k) deep: 5 radii at 5 r / sqrt(m/k) = 0.0791 m/s.
    let just = BEYOND * RADIUS / (MASS / 1.0f64).sqrt();
    let mut deep = thrown(1.01 * just);
    let mut guard = Guard::new(&deep, Some(0.04), Wrong::ALL.to_vec());
    let trouble = steps_until_trouble(&mut deep, &mut guard);
    assert_eq!((trouble.wrong, trouble.wall), (Wrong::BeyondWall, Some("lower")));
    assert_eq!(trouble.discs, [0]);
    // The first step beyond; a step moves it at most 1.01 just dt = 1.6e-3 r.
    assert!((BEYOND..BEYOND + 2e-3).contains(&trouble.overlap), "{trouble:?}");
    let mut shallow = thrown(0.99 * just);
    let mut guard = Guard::new(&shallow, Some(0.04), Wrong::ALL.to_vec());
    for _ in 0..40_000 {
        shallow.step();
        assert_eq!(guard.look(&mut shallow), None);
    }
}

#[test]
fn a_number_that_is_none_is_found_with_its_disc() {
    let discs =
        (0..5).map(|k| disc_at(DVec2::new(0.005 * (k + 1) as f64, 0.02), DVec2::X)).collect();
    let (law, integrator) = (law(ELASTIC), Box::new(SymplecticEuler));
    let mut simulation = Simulation::new(discs, DVec2::ZERO, law, &[], integrator, 1e-6);
    let mut guard = Guard::new(&simulation, None, Wrong::ALL.to_vec());
    assert_eq!(guard.look(&mut simulation), None);
    (0..10).for_each(|_| simulation.step());
    simulation.act(|discs| discs[3].velocity.x = f64::NAN);
    // The change came from outside: stepping again from the kept state does not meet it, and what
    // was seen is reported at the step at which it was seen.
    let trouble = guard.look(&mut simulation).expect("seen");
    assert_eq!((trouble.wrong, trouble.step), (Wrong::NotFinite, 10));
    assert_eq!(trouble.discs, [3]);
}
