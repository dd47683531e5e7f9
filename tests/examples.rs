//! Every example runs and does what its head comment says.

use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, MechanicalEnergy};
use parsim2d::particle::Particle;
use parsim2d::scenario::{Scenario, file};
use parsim2d::simulation::Simulation;

use crate::support::gnuplot_is_missing;

/// The named scenario as the program would run it with seed 1, and `more` keys over it.
fn start(name: &str, more: &str) -> (Simulation, u64) {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
    let path = path.join("examples").join(name).with_extension("toml");
    let more = file::parse(more, &path).unwrap();
    let settings = more.over(file::read(&path).unwrap());
    let scenario = Scenario::resolve(&settings, || 1).unwrap();
    (scenario.build().unwrap(), scenario.steps())
}

fn end(name: &str, more: &str) -> Vec<Particle> {
    let (mut simulation, steps) = start(name, more);
    (0..steps).for_each(|_| simulation.step());
    simulation.particles().to_vec()
}

#[test]
fn bounce_loses_a_fifth_of_its_height_at_each_bounce() {
    let (mut simulation, steps) = start("bounce", "");
    let mut apexes = Vec::new();
    let mut rising = false;
    for _ in 0..steps {
        simulation.step();
        let disc = &simulation.particles()[0];
        if rising && disc.velocity.y <= 0.0 {
            apexes.push(disc.position.y - disc.radius);
        }
        rising = disc.velocity.y > 0.0;
    }
    assert!(apexes.len() >= 3, "{apexes:?}");
    // h_k = e^(2k) h_0; e itself is met to 0.5 % at 50 steps a contact, with gravity acting too.
    let mut height = 0.02;
    for apex in &apexes[..3] {
        height *= 0.81;
        assert!((apex / height - 1.0).abs() < 0.02, "{apexes:?}");
    }
}

#[test]
fn two_discs_exchange_their_velocities() {
    let discs = end("two_discs", "");
    // The energy error after a contact of 35 steps is 1e-3 at most, half that in speed.
    assert!(discs[0].velocity.length() < 2e-4, "{}", discs[0].velocity);
    assert!((discs[1].velocity - DVec2::new(0.2, 0.0)).length() < 2e-4);
    // Its own "Try": with e = 0.5 they move on at v (1 -+ e)/2.
    let discs = end("two_discs", "restitution = 0.5");
    assert!((discs[0].velocity.x - 0.05).abs() < 1e-3, "{}", discs[0].velocity);
    assert!((discs[1].velocity.x - 0.15).abs() < 1e-3, "{}", discs[1].velocity);
}

#[test]
fn oblique_discs_part_at_a_right_angle() {
    let discs = end("oblique", "");
    let angle = discs[0].velocity.angle_to(discs[1].velocity).abs().to_degrees();
    // Energy and momentum of equal masses demand 90 degrees; the energy is met to 1e-3.
    assert!((angle - 90.0).abs() < 0.1, "{angle}");
    let hit = discs[1].velocity.to_angle().to_degrees();
    // sin = 1 mm off over 2 mm; the contact's 3e-4 s turn the line of centres by half a degree.
    assert!((hit - 30.0).abs() < 1.0, "{hit}");
}

#[test]
fn newtons_cradle_needs_its_gaps() {
    let speeds = |name| end(name, "").iter().map(|disc| disc.velocity.x).collect::<Vec<_>>();
    let with_gaps = speeds("newtons_cradle");
    // Each of four exchanges is exact to 1e-3 (35 steps a contact).
    assert!((with_gaps[4] - 0.5).abs() < 2e-3, "{with_gaps:?}");
    assert!(with_gaps[..4].iter().all(|v| v.abs() < 2e-3), "{with_gaps:?}");
    let touching = speeds("newtons_cradle_touching");
    // Measured, in parts of the first speed: -0.13, -0.08, -0.03, 0.30, 0.94.
    assert!(touching[0] < -0.05, "{touching:?}");
    assert!(touching[4] < 0.48 && touching[3] > 0.1, "{touching:?}");
    let momentum: f64 = touching.iter().sum();
    assert!((momentum - 0.5).abs() < 1e-12, "{momentum}"); // round-off
}

#[test]
fn a_box_of_gas_keeps_its_energy_and_becomes_maxwellian() {
    let (mut simulation, steps) = start("box_of_gas", "");
    let energy = MechanicalEnergy::of(&simulation).total();
    (0..steps).for_each(|_| simulation.step());
    let drift = MechanicalEnergy::of(&simulation).total() / energy - 1.0;
    // 1e-3 after a contact, either sign, and what contacts hold at this moment.
    assert!(drift.abs() < 5e-3, "{drift}");
    // In 2D the energies are exponential: the share below the mean is 1 - 1/e = 0.632, with a
    // standard deviation of sqrt(0.632 * 0.368 / 400) = 0.024; all were equal at the start.
    let energies: Vec<f64> = simulation.particles().iter().map(Particle::kinetic_energy).collect();
    let mean = energies.iter().sum::<f64>() / energies.len() as f64;
    let below = energies.iter().filter(|&&e| e < mean).count() as f64 / energies.len() as f64;
    assert!((below - 0.632).abs() < 4.0 * 0.024, "{below}");
}

#[test]
fn settling_ends_in_a_heap_at_rest_with_all_energy_accounted_for() {
    let (mut simulation, steps) = start("settling", "");
    let ledger = EnergyLedger::open(&mut simulation);
    let start = ledger.row(&simulation);
    (0..steps).for_each(|_| simulation.step());
    let row = ledger.row(&simulation);
    // A fall through half the box would make 0.4 m/s, 8e-2 J in all.
    assert!(row.kinetic_J < 1e-3 * start.gravitational_J, "{row:?}");
    assert!((row.total_J / start.total_J - 1.0).abs() < 0.01, "{row:?}");
    assert!(row.work_error_J.abs() < 1e-12, "{row:?}");
}

/// The extensions are whole programs; each checks itself and panics if it does not work.
#[path = "../examples"]
mod extensions {
    #[path = "my_force.rs"]
    pub mod my_force;
    #[path = "my_hook.rs"]
    pub mod my_hook;
    #[path = "my_integrator.rs"]
    pub mod my_integrator;
    #[path = "my_law.rs"]
    pub mod my_law;
    #[allow(dead_code)] // its `main` writes into the present folder
    #[path = "my_output.rs"]
    pub mod my_output;
}

#[test]
fn my_force_stores_the_energy_it_says() {
    extensions::my_force::main();
}

#[test]
fn my_integrator_is_of_fourth_order() {
    extensions::my_integrator::main();
}

#[test]
fn my_hook_taps_the_box_and_its_work_is_booked() {
    extensions::my_hook::main();
}

#[test]
fn my_law_meets_the_closed_forms_of_hertz() {
    extensions::my_law::main();
}

#[test]
fn my_output_writes_a_file_and_the_script_that_draws_it() {
    let folder = tempfile::tempdir().unwrap();
    let [start, end] = extensions::my_output::write_heap(folder.path()).unwrap();
    assert!(end < 0.5 * start, "{start} {end}");
    let text = std::fs::read_to_string(folder.path().join("heap.dat")).unwrap();
    let rows: Vec<Vec<f64>> = text
        .lines()
        .skip(1)
        .map(|line| line.split(' ').map(|word| word.parse().unwrap()).collect())
        .collect();
    assert!(rows.len() > 300, "{}", rows.len());
    // As long as nothing touches the floor the heap falls as one disc, to Eq. (3)'s g dt t/2 < 3e-6 m.
    for row in rows.iter().take_while(|row| row[0] < 0.01) {
        assert!((row[1] - row[2]).abs() < 5e-6, "{row:?}");
    }
    if !gnuplot_is_missing("the script of my_output") {
        let mut gnuplot = std::process::Command::new("gnuplot");
        let drawn = gnuplot
            .args(["-d", "-e", "set terminal pngcairo; set output 'heap.png'", "heap.gp"])
            .current_dir(&folder)
            .output()
            .unwrap();
        assert!(drawn.status.success() && drawn.stderr.is_empty(), "{drawn:?}");
        assert!(folder.path().join("heap.png").metadata().unwrap().len() > 5000);
    }
}

/// What a run of an example prints.
fn printed(name: &str) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    let output = std::process::Command::new(env!("CARGO_BIN_EXE_parsim2d"))
        .arg(path)
        .current_dir(&folder)
        .output()
        .unwrap();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn the_cradles_show_who_got_the_blow() {
    let velocities = |name: &str| -> Vec<[f64; 4]> {
        let text = printed(name);
        let rows = text.lines().filter(|line| line.starts_with("disc "));
        let numbers = |line: &str| {
            let words: Vec<f64> =
                line.split_whitespace().skip(2).map(|word| word.parse().unwrap()).collect();
            [words[0], words[1], words[2], words[3]]
        };
        rows.map(numbers).collect()
    };
    for (name, last, first) in [
        ("newtons_cradle.toml", 0.5, 0.0),
        // Measured: 0.94 and -0.13 of the first speed.
        ("newtons_cradle_touching.toml", 0.47, -0.065),
    ] {
        let rows = velocities(name);
        assert_eq!(rows.len(), 5, "{name}: {rows:?}");
        assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), [0.5, 0.0, 0.0, 0.0, 0.0]);
        assert!((rows[4][2] - last).abs() < 5e-3 && (rows[0][2] - first).abs() < 5e-3, "{rows:?}");
    }
    // Discs placed at random are no lesson of who met whom.
    assert!(!printed("box_of_gas.toml").contains("velocity, m/s"));
}

#[test]
fn extensions_fit_on_a_page() {
    for name in ["my_force", "my_hook", "my_integrator", "my_law", "my_output"] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR"));
        let path = path.join("examples").join(name).with_extension("rs");
        let lines = std::fs::read_to_string(path).unwrap().lines().count();
        assert!(lines <= 60, "{name}: {lines} lines");
    }
}
