//! Small promises to the user: what is not there is said to be not there, times have digits, a full lattice
//! is offered what fits, discs are thrown without a common motion.
#![allow(clippy::too_many_lines)] // tables of cases

use crate::support::runs::{outcome, parsim2d, text};
use glam::DVec2;
use parsim2d::scenario::Scenario;

#[test]
fn what_is_not_there_is_said_to_be_not_there() {
    let folder = tempfile::tempdir().unwrap();
    for (flag, key, lacks, nearest) in [
        ("--friction 0.3", "friction = 0.3", "no friction yet", "--restitution"),
        ("--periodic", "periodic = true", "no periodic box yet", "--no-walls"),
        ("--contact hertz", "contact = 'hertz'", "one contact law", "CONTRIBUTING.md"),
        ("--rotation", "rotation = true", "do not rotate", "position, velocity, radius and mass"),
        ("--spin=3", "spin = 3", "do not rotate", "position, velocity, radius and mass"),
        ("--temperature 300", "temperature = 300", "no thermostat", "--speed"),
        ("--charge 1e-9", "charge = 1e-9", "gravity and contacts only", "examples/my_force.rs"),
        ("--dim 3", "dim = 3", "two dimensions", "three"),
        ("--species 2", "species = 2", "in groups", "[[population]]"),
        ("--density 2500", "density = 2500", "not by its density", "--mass"),
        ("--width 0.1", "width = 0.1", "square", "--side"),
        ("--gx 1", "gx = 1", "one key", "gravity = [1, -9.81]"),
        (
            "--integrator leapfrog",
            "integrator = 'leapfrog'",
            "not there by that name",
            "velocity-verlet",
        ),
        ("--integrator rk4", "integrator = 'rk4'", "not there", "examples/my_integrator.rs"),
    ] {
        std::fs::write(folder.path().join("wish.toml"), key).unwrap();
        let commands = [
            flag.to_owned(),
            format!("check {flag}"),
            "wish.toml".to_owned(),
            "check wish.toml".to_owned(),
        ];
        for command in commands {
            let output = outcome(folder.path(), &command);
            let message = text(&output.stderr);
            assert_eq!(output.status.code(), Some(2), "{command}: {message}");
            let parts = [lacks, nearest, "way out: "];
            assert!(parts.iter().all(|part| message.contains(part)), "{command}: {message}");
            assert!(!message.contains("did you mean") && !message.contains("similar"), "{message}");
        }
    }
    // A slip of the finger is told as before, and so is a flag of another command.
    for (command, part) in
        [("--radios 3", "'--radius'"), ("plot --velocity", "unexpected argument")]
    {
        let message = text(&outcome(folder.path(), command).stderr);
        assert!(message.contains(part), "{message}");
    }
    std::fs::write(folder.path().join("slip.toml"), "radios = 3").unwrap();
    let message = text(&outcome(folder.path(), "slip.toml").stderr);
    assert!(message.contains("did you mean `radius`?"), "{message}");
}

#[test]
fn a_run_of_microseconds_says_how_long_it_was() {
    let folder = tempfile::tempdir().unwrap();
    let output = outcome(folder.path(), "-n 2 --seed 1 --dt 1e-8 --time 1us");
    assert!(text(&output.stdout).contains("100 steps to t = 1.00000e-6 s\n"));
    assert!(outcome(folder.path(), "plot trajectory trajectory.txt").status.success());
    let picture = std::fs::read_to_string(folder.path().join("trajectory.svg")).unwrap();
    assert!(picture.contains("t = 1.000e-6 s"));
}

#[test]
fn a_full_lattice_is_offered_the_most_that_fits() {
    for (n, radius) in
        [(2000, 5e-4), (419, 1e-3), (5, 0.01), (2, 0.019), (60_000, 1e-4), (3, 0.019)]
    {
        let text = format!("placement = 'lattice'\nn = {n}\nradius = {radius:e}");
        let error = Scenario::from_toml(&text).unwrap().place().unwrap_err().to_string();
        let ways_out = error.split("way out: ").nth(1).expect(&error);
        let offered = |flag: &str| {
            let words = ways_out.split(&format!("{flag} ")).nth(1).expect(&error);
            words.split(',').next().unwrap().trim().parse::<f64>().unwrap()
        };
        let fits = |n: f64, radius: f64, side: f64| {
            let text =
                format!("placement = 'lattice'\nn = {n}\nradius = {radius:e}\nside = {side:e}");
            Scenario::from_toml(&text).unwrap().place().is_ok()
        };
        let (most, largest, smallest) = (offered("-n"), offered("--radius"), offered("--side"));
        let n = f64::from(n);
        assert!(fits(most, radius, 0.04) && !fits(most + 1.0, radius, 0.04), "{error}");
        // To two digits.
        assert!(fits(n, largest, 0.04) && !fits(n, 1.11 * largest, 0.04), "{error}");
        assert!(fits(n, radius, smallest) && !fits(n, radius, 0.9 * smallest), "{error}");
    }
}

#[test]
fn thrown_discs_have_their_speed_and_no_momentum_but_one_alone() {
    let momentum = |text: &str| {
        let discs = Scenario::from_toml(&format!("seed = 4\n{text}")).unwrap().place().unwrap();
        let sum: DVec2 = discs.iter().map(|disc| disc.mass * disc.velocity).sum();
        let sizes: f64 = discs.iter().map(|disc| disc.mass * disc.velocity.length()).sum();
        (sum.length() / sizes, discs)
    };
    for text in [
        "n = 2\nspeed = 0.3",
        "n = 20\nspeed = 0.3",
        "n = 150\nspeed = 0.3\nradius = 5e-4",
        "[[population]]\nn = 5\nspeed = 0.3\nmass = 4e-3\n[[population]]\nn = 9\nspeed = 1.5",
    ] {
        let (share, discs) = momentum(text);
        assert!(share < 1e-14, "{text}: {share}"); // rounding
        // The groups keep their own.
        let rms = |of: &[parsim2d::particle::Particle]| {
            let sum: f64 = of.iter().map(|disc| disc.velocity.length_squared()).sum();
            (sum / of.len() as f64).sqrt()
        };
        assert!(
            (rms(&discs[..discs.len().min(5)]) > 0.0) && discs[0].velocity != discs[1].velocity
        );
        if text.contains("population") {
            assert!((rms(&discs[..5]) / 0.3 - 1.0).abs() < 1e-12);
            assert!((rms(&discs[5..]) / 1.5 - 1.0).abs() < 1e-12);
        } else {
            assert!((rms(&discs) / 0.3 - 1.0).abs() < 1e-12, "{text}");
        }
    }
    // A listed disc keeps the velocity that was said, one alone the one it was thrown with.
    let (_, discs) = momentum(
        "[[disc]]\nposition = [0.02, 0.02]\nvelocity = [1, 2]\n[[population]]\nn = 4\nspeed = 0.3",
    );
    assert_eq!(discs[0].velocity, DVec2::new(1.0, 2.0));
    let sum: DVec2 = discs[1..].iter().map(|disc| disc.velocity).sum();
    assert!(sum.length() < 1e-14);
    let (share, discs) = momentum("n = 1\nspeed = 0.3");
    assert!((share - 1.0).abs() < 1e-12 && (discs[0].velocity.length() / 0.3 - 1.0).abs() < 1e-12);
}

#[test]
fn check_and_run_say_restitution_with_and_without_the_weight_by_name() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = "-n 1 --seed 1 --radius 5e-4 --restitution 0.5 --time 0.2";
    let checked = text(&outcome(folder.path(), &format!("check {arguments}")).stdout);
    let line = |name: &str| checked.lines().find(|line| line.starts_with(name)).unwrap().to_owned();
    assert!(line("restitution e, without a weight").contains("0.5000"), "{checked}");
    // Under its weight a bounce gives less: 0.4990 after a fall through the box.
    assert!(line("e with the weight on it, after a fall").contains("0.4990"), "{checked}");
    let run = text(&outcome(folder.path(), arguments).stdout);
    assert!(
        run.contains("with its weight on it; without, as `check` has it first, e = 0.5000"),
        "{run}"
    );
    // Elastic discs, and a pair, have one restitution.
    let elastic = arguments.replace("0.5 ", "1 ");
    let output = parsim2d(folder.path(), &elastic).output().unwrap();
    assert!(!text(&output.stdout).contains("weight"), "{}", text(&output.stdout));
}
