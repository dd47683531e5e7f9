//! Gravity in any direction: free fall to the digit, ledgers that close on an incline, and the same bits
//! however downward is said.

use crate::support::runs::{outcome, parsim2d, text};
use glam::DVec2;
use parsim2d::analysis::energy::{EnergyLedger, MechanicalEnergy};
use parsim2d::scenario::Scenario;
use serde_json::Value;

fn scenario(text: &str) -> Scenario {
    Scenario::from_toml(text).unwrap_or_else(|error| panic!("{error}\n{text}"))
}

#[test]
fn a_disc_falls_along_gravity_as_its_integrator_says() {
    // Under a constant force every step adds the same: v = g k dt, and x of Eq. (3) is g dt² k (k + 1)/2,
    // that of velocity Verlet g dt² k²/2.
    let g = DVec2::new(3.0, -9.0);
    for (integrator, late) in [("symplectic-euler", 1.0), ("velocity-verlet", 0.0)] {
        let text = format!(
            "walls = false\ngravity = [3, -9]\nintegrator = '{integrator}'\ndt = 1e-5\n[[disc]]\nposition = [0, 0]"
        );
        let mut run = scenario(&text).build().unwrap();
        let steps = 1000;
        (0..steps).for_each(|_| run.step());
        let (k, disc) = (f64::from(steps), run.particles()[0]);
        let place = 0.5 * k * (k + late) * 1e-10 * g;
        // A thousand roundings.
        assert!((disc.velocity - k * 1e-5 * g).length() < 1e-12, "{integrator}");
        assert!((disc.position - place).length() < 1e-12 * place.length(), "{integrator}");
    }
}

#[test]
fn the_ledger_closes_on_an_incline() {
    for integrator in ["symplectic-euler", "velocity-verlet"] {
        let text = format!(
            "n = 30\nradius = 5e-4\nseed = 3\ngravity = [6, -8]\nrestitution = 0.8\ntime = 0.2\n\
             integrator = '{integrator}'"
        );
        let scenario = scenario(&text);
        let mut run = scenario.build().unwrap();
        let ledger = EnergyLedger::open(&mut run);
        let start = ledger.row(&run);
        // -m g.x: all of it there at the start.
        let by_hand: f64 =
            run.particles().iter().map(|p| -p.mass * p.position.dot(DVec2::new(6.0, -8.0))).sum();
        assert!((start.total_J - by_hand).abs() < 1e-15);
        (0..scenario.steps()).for_each(|_| run.step());
        let end = ledger.row(&run);
        let scale = start.total_J.abs() + 0.01; // J; they fall by about 9 mJ
        assert!((end.total_J - start.total_J).abs() < 2e-3 * scale, "{integrator}: {end:?}");
        assert!(end.work_error_J.abs() < 1e-12 * scale, "{integrator}: {end:?}"); // round-off
        assert!(end.dissipated_J > 1e-3, "{integrator}: they have bounced");
        // They lie in the corner on the right: the centre of mass has gone along gravity.
        let mean: DVec2 = run.particles().iter().map(|p| p.position).sum::<DVec2>() / 30.0;
        assert!(mean.x > 0.03 && mean.y < 0.01, "{integrator}: {mean}");
    }
}

#[test]
fn a_number_and_a_vector_downward_give_the_same_bits() {
    for (number, vector) in [
        ("9.81", "[0, -9.81]"),
        ("'981cm/s2'", "['0 m/s2', '-981cm/s2']"),
        ("0", "[0, 0]"),
        ("-1.5", "[0, 1.5]"),
    ] {
        let hash = |gravity: &str| {
            let text = format!("n = 20\nradius = 5e-4\nseed = 5\nspeed = 0.3\ngravity = {gravity}");
            let scenario = scenario(&text);
            assert!(scenario.to_toml().contains("m/s2, downward"), "{gravity}");
            let mut run = scenario.build().unwrap();
            (0..3000).for_each(|_| run.step());
            run.state_hash()
        };
        assert_eq!(hash(number), hash(vector), "{vector}");
    }
}

#[test]
fn a_crowd_falls_along_gravity_with_the_bits_of_the_plain_way() {
    let scenario = scenario("n = 300\nradius = 5e-4\nseed = 1\ngravity = [-7, 4]");
    let discs = scenario.place().unwrap();
    let mut runs = [false, true].map(|as_crowd| scenario.assemble(discs.clone(), as_crowd));
    for run in &mut runs {
        run.step_until(4000);
    }
    assert!(runs[0].largest_overlap() > 0.0, "no contact, no test");
    assert_eq!(runs[0].state_hash(), runs[1].state_hash());
}

#[test]
fn the_diagnosis_falls_along_gravity() {
    let close = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-12;
    // From corner to corner: sqrt(2 (|gx| + |gy|) l); downward, sqrt(2 g l).
    for (gravity, sum) in
        [("9.81", 9.81), ("[0, -9.81]", 9.81), ("[6, -8]", 14.0), ("[-9.81, 0]", 9.81)]
    {
        let scenario = scenario(&format!("gravity = {gravity}"));
        assert!(close(scenario.expected_speed(), (2.0f64 * sum * 0.04).sqrt()), "{gravity}");
    }
    let foot = |gravity: &str| {
        scenario(&format!("n = 500\nradius = 5e-4\ngravity = {gravity}"))
            .expected_wall()
            .foot_overlap
    };
    // 500 squares of 1 mm in the corner, at 45 degrees: a depth of sqrt(500) mm in place of 12.5 mm.
    let tilted = foot("[9.81, -9.81]") / 2f64.sqrt();
    assert!(close(tilted / foot("9.81"), 500f64.sqrt() / 12.5));
}

#[test]
fn theory_stands_beside_a_bounce_under_tilted_gravity() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(
        folder.path().join("tilted.toml"),
        "radius = 5e-4\neta = 0.5\ngravity = [2, -9]\ntime = 0.08\nnt = 400\n[[disc]]\nposition = [0.01, 0.02]",
    )
    .unwrap();
    let output = outcome(folder.path(), "tilted.toml --json");
    let summary: Value = serde_json::from_slice(&output.stdout)
        .unwrap_or_else(|_| panic!("{}", text(&output.stderr)));
    let rows = summary["answer"]["rows"].as_array().unwrap();
    for what in ["largest overlap", "contact time", "restitution"] {
        let row = rows.iter().find(|row| row["what"].as_str().unwrap().starts_with(what)).unwrap();
        // First order in the step, by the dashpot: 1/400.
        assert!(row["error"].as_f64().unwrap().abs() < 5e-3, "{row}");
    }
}

#[test]
fn tilted_gravity_is_said_by_flag_and_by_key_and_printed_back() {
    let folder = tempfile::tempdir().unwrap();
    let printed = |flag: &str| {
        let output = parsim2d(folder.path(), "--print-config --seed 1").arg(flag).output().unwrap();
        assert!(output.status.success(), "{flag}: {}", text(&output.stderr));
        text(&output.stdout)
    };
    for flag in ["--gravity=1,-9.81", "--gravity=[1, -9.81]", "--gravity=1m/s2,-981cm/s2"] {
        assert!(printed(flag).contains("gravity = [1.0, -9.81] # m/s2, y up\n"), "{flag}");
    }
    assert!(printed("--gravity=0,-9.81").contains("gravity = 9.81 # m/s2, downward\n"));
    let output = parsim2d(folder.path(), "--gravity 9,81").output().unwrap();
    let message = text(&output.stderr);
    assert!(
        output.status.code() == Some(2) && message.contains("a dot is meant: 9.81"),
        "{message}"
    );
    // The record of a run has it, and the run comes again.
    assert!(outcome(folder.path(), "-n 3 --seed 2 --time 10ms --gravity=1,-9 -q").status.success());
    let record =
        |folder: &std::path::Path| std::fs::read_to_string(folder.join("last-run.toml")).unwrap();
    let hash = |record: &str| record.lines().find(|l| l.contains("state_hash")).unwrap().to_owned();
    let first = record(folder.path());
    assert!(first.contains("gravity = [1.0, -9.0]"), "{first}");
    assert!(outcome(folder.path(), "last-run.toml -q --out-dir again").status.success());
    assert_eq!(hash(&record(&folder.path().join("again"))), hash(&first));
    assert!(outcome(folder.path(), "report").status.success());
}

#[test]
fn energy_in_free_flight_is_kept_along_any_gravity() {
    let text = "walls = false\ngravity = [-4, 2]\nintegrator = 'velocity-verlet'\ndt = 1e-4\n\
                [[disc]]\nposition = [0, 0]\nvelocity = [1, 2]";
    let mut run = scenario(text).build().unwrap();
    let start = MechanicalEnergy::of(&run).total();
    (0..5000).for_each(|_| run.step());
    // Velocity Verlet is exact on a parabola: 5000 roundings of 1e-16 of 2.5 mJ.
    assert!((MechanicalEnergy::of(&run).total() - start).abs() < 1e-14);
}
