//! Frames: fast writing, and the thread that replaces `out.txt` while a run goes on.

use std::fs;
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::support::{ELASTIC, law};
use glam::DVec2;
use parsim2d::integrator::SymplecticEuler;
use parsim2d::output::frames::{Columns, write_frame};
use parsim2d::output::live::LiveFrame;
use parsim2d::output::live_writer::LiveWriter;
use parsim2d::output::number::push_g9;
use parsim2d::particle::Particle;
use parsim2d::scenario::Scenario;
use parsim2d::simulation::Simulation;

const SIDE: f64 = 0.04; // m

/// Discs of all sorts of numbers: several sizes, signs, zeros, and speeds of discs nearly at rest.
fn discs(n: usize) -> Vec<Particle> {
    let disc = |k: usize| {
        let share = k as f64 / 10_007.0;
        let radius = [1e-4, 1e-4, 1e-4, 2.5e-4][k % 4] * if k % 1000 < 500 { 1.0 } else { share };
        let mut disc = Particle::at_rest(SIDE * DVec2::new(share, 0.5 - share), radius, 1e-3);
        disc.velocity = DVec2::new(share * 10f64.powi(-(k as i32 % 30)), -share);
        disc
    };
    (1..=n).map(disc).collect()
}

fn simulation(n: usize) -> Simulation {
    let (law, integrator) = (law(ELASTIC), Box::new(SymplecticEuler));
    Simulation::new(discs(n), DVec2::ZERO, law, &[], integrator, 1e-3)
}

fn live(folder: &Path) -> LiveFrame {
    LiveFrame { path: folder.join("out.txt"), side: SIDE, border: Some(1e-3) }
}

/// What `out.txt` holds when the run itself writes it.
fn written_here(simulation: &Simulation) -> Vec<u8> {
    let mut text = Vec::new();
    live(Path::new("")).write(&mut text, simulation).unwrap();
    text
}

fn names(folder: &Path) -> Vec<String> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect()
}

#[test]
fn a_frame_of_several_blocks_is_its_rows_one_after_the_other() {
    let simulation = simulation(5000); // 300 kB
    for (columns, names) in [(Columns::Positions, "x y r"), (Columns::Discs, "x y r vx vy m")] {
        let n = simulation.n();
        let mut expected =
            format!("# step 0 time_s 0 n {n} side_m 0.04 columns {names}\n").into_bytes();
        for disc in simulation.particles() {
            let (place, velocity) = (disc.position, disc.velocity);
            let row = [place.x, place.y, disc.radius, velocity.x, velocity.y, disc.mass];
            for &value in &row[..names.split(' ').count()] {
                push_g9(&mut expected, value);
                expected.push(b' ');
            }
            *expected.last_mut().unwrap() = b'\n';
        }
        let mut text = Vec::new();
        write_frame(&mut text, &simulation, SIDE, columns).unwrap();
        assert!(text == expected, "{columns:?}");
    }
}

#[test]
fn the_thread_writes_what_the_run_itself_would() {
    let folder = tempfile::tempdir().unwrap();
    let mut simulation = simulation(3000);
    let mut writer = LiveWriter::new(live(folder.path()));
    for _ in 0..3 {
        simulation.step();
        assert!(writer.offer(&simulation).unwrap().is_some());
        let expected = written_here(&simulation);
        simulation.step(); // the frame is of the moment at which it was handed over
        writer.wait().unwrap();
        assert!(fs::read(folder.path().join("out.txt")).unwrap() == expected);
    }
}

#[test]
fn the_thread_puts_the_discs_of_a_crowd_in_order() {
    let folder = tempfile::tempdir().unwrap();
    for populations in
        ["n = 600\nradius = 2e-4", "n = 600\nradius = 2e-4\n[[population]]\nn = 50\nradius = 4e-4"]
    {
        let text = format!("seed = 3\nspeed = 0.3\n[[population]]\n{populations}\n");
        let scenario = Scenario::from_toml(&text).unwrap();
        let mut crowd = scenario.assemble(scenario.place().unwrap(), true);
        (0..3).for_each(|_| crowd.step());
        let (_, ids) = crowd.as_stored();
        assert!(!ids.is_sorted(), "discs in id order need not be put in order");
        let mut writer = LiveWriter::new(live(folder.path()));
        writer.offer(&crowd).unwrap();
        writer.wait().unwrap();
        assert!(fs::read(folder.path().join("out.txt")).unwrap() == written_here(&crowd), "{text}");
    }
}

#[test]
fn a_frame_that_comes_while_one_is_being_written_is_left_out() {
    let folder = tempfile::tempdir().unwrap();
    let mut simulation = simulation(50_000); // takes the thread milliseconds
    let mut writer = LiveWriter::new(live(folder.path()));
    assert!(writer.offer(&simulation).unwrap().is_some());
    let expected = written_here(&simulation);
    writer.wait().unwrap();
    let mut left_out = 0;
    for _ in 0..100 {
        left_out += usize::from(writer.offer(&simulation).unwrap().is_none());
    }
    // A hundred calls in the time of a few frames, however slow the machine.
    assert!(left_out > 0, "every one of a hundred frames found the thread idle");
    writer.wait().unwrap();
    assert!(fs::read(folder.path().join("out.txt")).unwrap() == expected);
    simulation.step();
    assert!(writer.offer(&simulation).unwrap().is_some(), "idle again");
}

#[test]
fn what_fails_on_the_thread_comes_back_and_names_the_file() {
    let folder = tempfile::tempdir().unwrap();
    let gone = folder.path().join("gone");
    let simulation = simulation(10);
    for waits in [false, true] {
        let mut writer = LiveWriter::new(live(&gone)); // no such folder
        assert!(writer.offer(&simulation).unwrap().is_some());
        let said = match waits {
            true => writer.wait().unwrap_err(),
            false => loop {
                match writer.offer(&simulation) {
                    Ok(None) => std::thread::yield_now(),
                    Ok(Some(_)) => panic!("the frame before has failed"),
                    Err(said) => break said,
                }
            },
        };
        assert!(said.to_string().contains("out.txt failed"), "{said}");
        // It goes on once there is a folder.
        fs::create_dir(&gone).unwrap();
        assert!(writer.offer(&simulation).unwrap().is_some());
        writer.wait().unwrap();
        assert!(fs::read(gone.join("out.txt")).unwrap() == written_here(&simulation));
        fs::remove_dir_all(&gone).unwrap();
    }
}

#[test]
fn a_run_that_ends_early_leaves_a_whole_frame_and_no_temporary_file() {
    let folder = tempfile::tempdir().unwrap();
    let simulation = simulation(50_000);
    let mut writer = LiveWriter::new(live(folder.path()));
    writer.offer(&simulation).unwrap();
    drop(writer);
    assert_eq!(names(folder.path()), ["out.txt"]);
    assert!(fs::read(folder.path().join("out.txt")).unwrap() == written_here(&simulation));
}

#[test]
fn who_reads_along_sees_whole_frames_and_always_one() {
    let folder = tempfile::tempdir().unwrap();
    let (live, simulation) = (live(folder.path()), simulation(300));
    let whole = written_here(&simulation);
    live.refresh(&simulation).unwrap();
    let is_done = AtomicBool::new(false);
    let seen = std::thread::scope(|scope| {
        let reader = scope.spawn(|| {
            let mut seen = 0;
            while !is_done.load(Ordering::Relaxed) {
                let read = fs::read(&live.path).expect("there is always a frame");
                assert!(read == whole, "{} bytes of {}", read.len(), whole.len());
                seen += 1;
            }
            seen
        });
        (0..500).for_each(|_| live.refresh(&simulation).unwrap());
        is_done.store(true, Ordering::Relaxed);
        reader.join().unwrap()
    });
    assert!(seen > 0);
    assert_eq!(names(folder.path()), ["out.txt"]);
    // Where somebody has taken it away it comes again.
    fs::remove_file(&live.path).unwrap();
    live.refresh(&simulation).unwrap();
    assert!(fs::read(&live.path).unwrap() == whole);
}
