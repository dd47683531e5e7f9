//! Each law has one text: whoever edits [`SpringDashpot::push`] changes every path.
//!
//! The heart and the engine are copied into a scratch crate, with the text as it is and with another; both step
//! the same discs plainly and by the engine.
//!
//! [`SpringDashpot::push`]: parsim2d::particle::SpringDashpot

use std::fs;
use std::path::Path;
use std::process::Command;

/// What a step needs, and nothing else.
const ROOMS: [&str; 13] = [
    "boundary",
    "discs",
    "engine",
    "field",
    "force",
    "integrator",
    "neighbours",
    "pair",
    "particle",
    "placement",
    "simulation",
    "wall",
    "work",
];
const CRATES: [&str; 5] = ["glam", "rand", "rand_pcg", "thiserror", "wide"];

/// Steps a box of discs plainly, and by the engine with and without threads, and prints the states' hashes.
const MAIN: &str = r#"
use glam::DVec2;
use one_text::engine::Engine;
use one_text::force::HalfPlane;
use one_text::integrator::SymplecticEuler;
use one_text::particle::{Damping, Particle, SpringDashpot};
use one_text::simulation::{PlainDiscs, Simulation};

fn main() {
    let place = |k: usize| DVec2::new(1.0 + 1.9 * (k % 20) as f64, 1.0 + 1.9 * (k / 20) as f64) * 1e-3;
    let discs: Vec<_> = (0..400)
        .map(|k| {
            let mut disc = Particle::at_rest(place(k), 1e-3, 1e-3);
            disc.velocity = DVec2::from_angle(k as f64);
            disc
        })
        .collect();
    let law = SpringDashpot { stiffness: 5e4, damping: Damping::Rate(1e3), tension: true };
    let (gravity, walls, dt) = (DVec2::new(0.0, -9.81), HalfPlane::square(0.04).to_vec(), 8e-6);
    let plain = PlainDiscs::new(discs.clone(), gravity, law, walls.clone());
    let engine = |threads| Engine::new(discs.clone(), gravity, law, walls.clone(), dt, threads);
    let hash = |discs| {
        let mut run = Simulation::of(discs, Box::new(SymplecticEuler), dt);
        run.step_until(200);
        println!("{:016x}", run.state_hash());
    };
    hash(Box::new(plain));
    hash(Box::new(engine(1)));
    hash(Box::new(engine(3)));
}
"#;

/// A scratch crate of the heart and the engine.
struct Scratch(tempfile::TempDir);

impl Scratch {
    fn new() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        let folder = tempfile::tempdir().unwrap();
        let source = folder.path().join("src");
        fs::create_dir(&source).unwrap();
        for room in ROOMS {
            copy(&root.join("src"), &source, room);
        }
        let rooms: String = ROOMS.iter().map(|room| format!("pub mod {room};\n")).collect();
        fs::write(source.join("lib.rs"), rooms).unwrap();
        fs::write(source.join("main.rs"), MAIN).unwrap();
        let whole = fs::read_to_string(root.join("Cargo.toml")).unwrap();
        let of = |name: &str| {
            let is_it = |line: &&str| line.split(' ').next() == Some(name);
            whole.lines().find(is_it).unwrap_or_else(|| panic!("no {name} in Cargo.toml"))
        };
        let manifest = format!(
            "[package]\nname = \"one_text\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\
             [dependencies]\n{}\n[profile.dev]\nopt-level = 1\ndebug = false\n\
             [profile.dev.package.\"*\"]\nopt-level = 0\n[workspace]\n",
            CRATES.map(of).join("\n")
        );
        fs::write(folder.path().join("Cargo.toml"), manifest).unwrap();
        fs::copy(root.join("Cargo.lock"), folder.path().join("Cargo.lock")).unwrap();
        Self(folder)
    }

    /// The three hashes with this text of particle.rs.
    fn hashes(&self, heart: &str) -> Vec<String> {
        let folder = self.0.path();
        fs::write(folder.join("src/particle.rs"), heart).unwrap();
        let run = Command::new(env!("CARGO"))
            .args(["run", "--quiet", "--offline"])
            .env("CARGO_TARGET_DIR", folder.join("target"))
            .current_dir(folder)
            .output()
            .unwrap();
        assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
        String::from_utf8(run.stdout).unwrap().lines().map(str::to_owned).collect()
    }
}

/// Copies the file and the folder of a room.
fn copy(from: &Path, to: &Path, room: &str) {
    fs::copy(from.join(format!("{room}.rs")), to.join(format!("{room}.rs"))).unwrap();
    let mut folders = vec![room.to_owned()];
    while let Some(folder) = folders.pop() {
        let Ok(entries) = fs::read_dir(from.join(&folder)) else { continue };
        fs::create_dir_all(to.join(&folder)).unwrap();
        for entry in entries.map(Result::unwrap) {
            let name = format!("{folder}/{}", entry.file_name().to_str().unwrap());
            match entry.file_type().unwrap().is_dir() {
                true => folders.push(name),
                false => drop(fs::copy(entry.path(), to.join(&name)).unwrap()),
            }
        }
    }
}

#[test]
fn an_edit_of_the_law_changes_the_plain_path_and_the_engine_alike() {
    let text = "let push = self.stiffness * contact.overlap + eta * contact.approach_speed;";
    let other = "let push = self.stiffness * contact.overlap.powi(2) * 1e4
            + if contact.approach_speed > 0.0 { eta * contact.approach_speed } else { 0.0 };";
    let heart = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/particle.rs");
    let heart = fs::read_to_string(heart).unwrap();
    assert_eq!(heart.matches(text).count(), 1, "the law has another text now");
    let scratch = Scratch::new();
    let (as_it_is, edited) = (scratch.hashes(&heart), scratch.hashes(&heart.replace(text, other)));
    for hashes in [&as_it_is, &edited] {
        assert_eq!(hashes.len(), 3);
        assert!(hashes.iter().all(|hash| *hash == hashes[0]), "{hashes:?}");
    }
    assert_ne!(as_it_is[0], edited[0], "the edit changed nothing");
}
