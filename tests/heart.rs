//! The heart that students read: four files, short, with the equations and the sum of forces in them, and a law that can
//! be asked what it is for small changes.

use std::fs;
use std::path::Path;

use glam::DVec2;
use parsim2d::particle::{Contact, ContactLaw, Damping, Linear};

use crate::support::{MASS, STIFFNESS, law};

fn text(file: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("src").join(file);
    fs::read_to_string(path).unwrap()
}

#[test]
fn the_four_files_of_the_heart_are_read_in_an_hour() {
    let files = ["particle.rs", "simulation.rs", "force.rs", "integrator.rs"];
    let lines: usize = files.iter().map(|file| text(file).lines().count()).sum();
    assert!(lines < 600, "{lines} lines");
}

#[test]
fn the_simulation_holds_the_step_and_the_sum_and_no_housekeeping() {
    let text = text("simulation.rs").to_lowercase();
    let code = text.lines().filter(|line| !line.contains("mod "));
    for line in code {
        for word in ["snapshot", "hash", "fingerprint", "restore", "checkpoint", "array", "kept"] {
            assert!(!line.contains(word), "{word}: {line}");
        }
    }
    for needed in ["fn time_step", "fn place_discs", "fn step(", "disc.mass * *gravity", "law.push"]
    {
        assert!(text.contains(needed), "{needed} is not there");
    }
}

#[test]
fn three_calls_lead_from_the_step_to_the_law() {
    // Each is in the body of the one before: no helper lies between.
    let body = |file: &str, head: &str| {
        let text = text(file);
        let start = text.find(head).unwrap_or_else(|| panic!("{file} has no {head}"));
        let indent = text[..start].lines().last().unwrap_or_default().len();
        let end = format!("\n{}}}\n", " ".repeat(indent));
        let length = text[start..].find(&end).unwrap();
        text[start..start + length].to_owned()
    };
    assert!(body("simulation.rs", "pub fn step(").contains("self.integrator.step("));
    let euler = text("integrator.rs");
    let euler = &euler[euler.find("for SymplecticEuler").unwrap()..];
    assert!(euler.split("\n}\n").next().unwrap().contains("discs.update_forces()"));
    assert!(body("simulation.rs", "fn update_forces(").contains("law.push(&contact)"));
}

fn contact(overlap: f64) -> Contact {
    Contact { overlap, normal: DVec2::X, approach_speed: 0.3, reduced_mass: MASS / 2.0 }
}

/// push = k delta^(3/2) + c sqrt(delta) v, Hertz's spring with a dashpot (Kuwabara and Kono 1987).
struct Viscoelastic {
    k: f64, // N/m^(3/2)
    c: f64, // kg/s/m^(1/2)
}

impl ContactLaw for Viscoelastic {
    fn push(&self, contact: &Contact) -> f64 {
        self.spring(contact) + self.c * contact.overlap.sqrt() * contact.approach_speed
    }

    fn spring(&self, contact: &Contact) -> f64 {
        self.k * contact.overlap.powf(1.5)
    }

    fn stored_energy(&self, contact: &Contact) -> f64 {
        0.4 * self.k * contact.overlap.powf(2.5)
    }
}

#[test]
fn a_spring_dashpot_is_its_own_linear_law() {
    for (damping, eta) in [
        (Damping::Coefficient(0.7), 0.7),
        (Damping::Rate(1e3), 0.5 * MASS * 1e3),
        (Damping::Ratio(0.5), (STIFFNESS * 0.5 * MASS).sqrt()),
    ] {
        let linear = law(damping).linearised(&contact(1e-5));
        assert_eq!(linear, Linear { stiffness: STIFFNESS, damping: eta });
    }
}

#[test]
fn a_law_of_ones_own_is_linearised_by_differences() {
    let law = Viscoelastic { k: 4e6, c: 20.0 };
    for overlap in [1e-9, 1e-6, 1e-4] {
        let Linear { stiffness, damping } = law.linearised(&contact(overlap));
        let root: f64 = f64::sqrt(overlap);
        let slope = 1.5 * law.k * root + 0.5 * law.c / root * 0.3;
        assert!((stiffness / slope - 1.0).abs() < 1e-6, "{overlap}: {stiffness} {slope}");
        // push has 16 digits, the difference of speeds is as small as 1e-5 of a vibration's: five or more are left.
        assert!((damping / (law.c * root) - 1.0).abs() < 1e-5, "{overlap}: {damping}");
    }
}
