//! A session without files and without a terminal: what a page, or a program of one's own, runs.

use parsim2d::analysis::guard::Wrong;
use parsim2d::scenario::Scenario;
use parsim2d::session::{Onlooker, Session};
use parsim2d::simulation::Simulation;

fn scenario(text: &str) -> Scenario {
    Scenario::from_toml(text).unwrap_or_else(|why| panic!("{why}"))
}

/// Stops the run each time that it has been seen so often.
struct Slice {
    left: u32,
    seen_at: Vec<u64>,
}

impl Onlooker for Slice {
    fn stops(&self) -> bool {
        self.left == 0
    }

    fn see(&mut self, simulation: &Simulation) {
        self.left -= 1;
        self.seen_at.push(simulation.steps());
    }
}

#[test]
fn a_session_in_slices_ends_with_the_bits_of_steps_one_by_one_and_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let mut scenario = scenario("n = 150\nradius = 5e-4\nseed = 1\ntime = 0.01\nspeed = 0.3");
    scenario.output.folder = folder.path().to_owned();
    let mut plain = scenario.build().unwrap();
    (0..scenario.steps()).for_each(|_| plain.step());

    let mut session = Session::without_files(&scenario, scenario.build().unwrap());
    let mut slices = Vec::new();
    while !session.is_done() {
        let mut slice = Slice { left: 1, seen_at: Vec::new() };
        session.run(&mut slice).unwrap();
        assert_eq!(slice.seen_at, [session.simulation().steps()]);
        slices.extend(slice.seen_at);
    }
    assert!(slices.len() > 1 && slices.is_sorted(), "{slices:?}");
    assert_eq!(session.simulation().state_hash(), plain.state_hash());
    assert_eq!(session.simulation().steps(), scenario.steps());
    assert!(session.failure.is_none());
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 0);
}

#[test]
fn a_session_that_goes_wrong_ends_a_step_before_and_says_why() {
    // N_t = 4 heats a bed until a disc is lost.
    let text = "n = 100\nradius = 1e-3\nseed = 1\nnt = 4\neta = 0\nallow_unstable = true\ntime = 1";
    let mut scenario = scenario(text);
    scenario.allow_unstable = false; // asked for when it was read; the run is to stop
    let mut session = Session::without_files(&scenario, scenario.build().unwrap());
    session.run(&mut ()).unwrap();
    let failure = session.failure.as_ref().unwrap();
    assert!(failure.stopped && session.is_stopped() && !session.is_done());
    assert_eq!(session.simulation().steps() + 1, failure.step);
    assert_eq!(failure.fault.as_deref(), Some("--nt"), "{failure}");
}

#[test]
fn a_guard_looks_for_what_its_scenario_may_do_wrong() {
    use Wrong::{BeyondWall, Crossed, EnergyGrown, NotFinite};
    for (text, watched) in [
        ("radius = 1e-3", vec![NotFinite, Crossed, BeyondWall, EnergyGrown]),
        ("radius = 1e-3\nwalls = false", vec![NotFinite, Crossed, EnergyGrown]),
        ("", vec![NotFinite, BeyondWall, EnergyGrown]), // the guide's own discs are soft
        ("walls = false\nspeed = 100\ndt = 1e-8", vec![NotFinite, EnergyGrown]),
    ] {
        assert_eq!(scenario(text).watched(), watched, "{text}");
    }
}
