//! What several test files share: small set-ups with one contact, and the guide's numbers.
#![allow(dead_code)] // each test file uses its own part

#[cfg(all(target_os = "linux", any(target_arch = "x86_64", target_arch = "aarch64")))]
pub mod handed_in;
pub mod imports;
pub mod plotting;
pub mod runs;
pub mod scripts;
pub mod student;

use glam::DVec2;
use parsim2d::force::HalfPlane;
use parsim2d::integrator::{ExplicitEuler, Integrator, SymplecticEuler, VelocityVerlet};
use parsim2d::particle::{Damping, Particle, SpringDashpot};
use parsim2d::simulation::Simulation;
use proptest::test_runner::{Config as ProptestConfig, RngSeed};

/// The guide's stiffness, N/m, mass, kg, and radius, m.
pub const STIFFNESS: f64 = 5e4;
pub const MASS: f64 = 1e-3;
pub const RADIUS: f64 = 5e-4;

/// Property tests that try the same cases every time, and leave no files.
pub fn steady() -> ProptestConfig {
    ProptestConfig {
        rng_seed: RngSeed::Fixed(2019),
        failure_persistence: None,
        ..ProptestConfig::default()
    }
}

pub type NewIntegrator = fn() -> Box<dyn Integrator>;

pub const INTEGRATORS: [(&str, NewIntegrator); 3] = [
    ("symplectic-euler", || Box::new(SymplecticEuler)),
    ("explicit-euler", || Box::new(ExplicitEuler)),
    ("velocity-verlet", || Box::new(VelocityVerlet)),
];

pub fn law(damping: Damping) -> SpringDashpot {
    SpringDashpot { stiffness: STIFFNESS, damping, tension: true }
}

pub const ELASTIC: Damping = Damping::Coefficient(0.0);

/// The floor y = 0.
pub fn floor() -> HalfPlane {
    HalfPlane { point: DVec2::ZERO, normal: DVec2::NEG_Y }
}

pub fn disc_at(position: DVec2, velocity: DVec2) -> Particle {
    let mut disc = Particle::at_rest(position, RADIUS, MASS);
    disc.velocity = velocity;
    disc
}

/// One contact, without gravity: who meets whom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Meeting {
    /// A disc and the floor.
    Wall,
    /// Two equal discs.
    Pair,
    /// A disc and one of five times its mass and twice its radius.
    UnequalPair,
}

pub const MEETINGS: [Meeting; 3] = [Meeting::Wall, Meeting::Pair, Meeting::UnequalPair];

impl Meeting {
    pub fn reduced_mass(self) -> f64 {
        match self {
            Self::Wall => MASS,
            Self::Pair => MASS / 2.0,
            Self::UnequalPair => MASS * 5.0 / 6.0,
        }
    }

    /// The bodies `gap` (m) apart, approaching at `speed` (m/s).
    pub fn begin(
        self,
        law: SpringDashpot,
        new_integrator: NewIntegrator,
        gap: f64,
        speed: f64,
        dt: f64,
    ) -> Simulation {
        let (walls, discs) = match self {
            Self::Wall => {
                let disc = disc_at(DVec2::new(0.0, RADIUS + gap), DVec2::new(0.0, -speed));
                (vec![floor()], vec![disc])
            }
            _ => {
                let mut other = disc_at(DVec2::ZERO, DVec2::ZERO);
                if self == Self::UnequalPair {
                    (other.mass, other.radius) = (5.0 * MASS, 2.0 * RADIUS);
                }
                let apart = RADIUS + other.radius + gap;
                other.position.x = apart;
                (Vec::new(), vec![disc_at(DVec2::ZERO, DVec2::new(speed, 0.0)), other])
            }
        };
        Simulation::new(discs, DVec2::ZERO, law, &walls, new_integrator(), dt)
    }

    /// Speed at which the bodies approach, m/s.
    pub fn approach_speed(self, simulation: &Simulation) -> f64 {
        match (self, simulation.particles()) {
            (Self::Wall, discs) => -discs[0].velocity.y,
            (_, discs) => discs[0].velocity.x - discs[1].velocity.x,
        }
    }

    /// Distance between the surfaces, m; negative while they overlap.
    pub fn gap(self, simulation: &Simulation) -> f64 {
        match (self, simulation.particles()) {
            (Self::Wall, discs) => discs[0].position.y - discs[0].radius,
            (_, discs) => {
                discs[0].position.distance(discs[1].position) - discs[0].radius - discs[1].radius
            }
        }
    }
}

/// A command that a signal ends, also where whoever started the tests has had signals ignored, as `nohup` and a
/// shell in the background do: what is ignored stays so for everything that is started from there.
pub fn heeding(program: impl AsRef<std::ffi::OsStr>) -> std::process::Command {
    #[allow(unused_mut)] // elsewhere than on Linux tests have nothing to set signals with
    let mut command = std::process::Command::new(program);
    #[cfg(target_os = "linux")]
    {
        use nix::sys::signal::{SigHandler, Signal, signal};
        use std::os::unix::process::CommandExt;

        let heed = || {
            for one in [Signal::SIGHUP, Signal::SIGINT, Signal::SIGQUIT, Signal::SIGTERM] {
                // SAFETY: no handler of ours is there or set, only the usual action.
                unsafe { signal(one, SigHandler::SigDfl) }?;
            }
            Ok(())
        };
        // SAFETY: between fork and exec it makes system calls that are safe there (signal-safety(7)), no more.
        unsafe { command.pre_exec(heed) };
    }
    command
}

/// True, and says so, if there is no gnuplot to test `what` with.
pub fn gnuplot_is_missing(what: &str) -> bool {
    is_missing("gnuplot", "PARSIM2D_REQUIRE_GNUPLOT", what)
}

/// True, and says so, if there is no Chromium to test `what` with.
pub fn browser_is_missing(what: &str) -> bool {
    is_missing("chromium", "PARSIM2D_REQUIRE_BROWSER", what)
}

/// Whether `program` is not installed; that is a failure if the variable `required` is set.
fn is_missing(program: &str, required: &str, what: &str) -> bool {
    let there = std::process::Command::new(program).arg("--version").output().is_ok();
    if !there {
        let message = format!("SKIPPED: {program} is not installed, so {what} was not tested");
        assert!(std::env::var_os(required).is_none(), "{message}");
        // Not `eprintln!`, which the test runner hides.
        std::io::Write::write_all(&mut std::io::stderr(), format!("{message}\n").as_bytes())
            .unwrap();
    }
    !there
}
