//! The refusal of an unstable time step: which parameter is at fault, and what would work.

use std::fmt;

use super::number::Num;
use super::preset::Preset;
use super::{DampingChoice, Scenario, StepChoice};
use crate::analysis::stability::{COARSE, LimitedBy};

/// A time step above the stable limit, and why.
#[derive(Clone, Debug, PartialEq)]
pub struct Refusal {
    /// The parameter at fault, as its flag: the one that, put back to the preset's value, would
    /// make the run stable.
    pub fault: &'static str,
    /// Its value.
    pub value: f64,
    /// The time step asked for, s.
    pub dt: f64,
    /// The largest stable time step, s.
    pub limit: f64,
    /// What sets the limit.
    pub by: LimitedBy,
    /// Flags that work, each tried against the limit.
    pub ways_out: Vec<String>,
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { fault, value, dt, limit, by, ways_out } = self;
        writeln!(
            f,
            "unstable: dt = {dt:.3e} s is {} times the largest stable step for {by}, {limit:.3e} s",
            Num::rounded(dt / limit)
        )?;
        writeln!(f, "  the parameter at fault: {fault} = {}", Num(*value))?;
        if !ways_out.is_empty() {
            writeln!(f, "  ways out: {}", ways_out.join(", or "))?;
        }
        write!(f, "  --allow-unstable runs it anyway, for the lesson")
    }
}

impl Scenario {
    /// Why this time step is refused; `None` if it is stable.
    pub fn refusal(&self) -> Option<Refusal> {
        if self.is_stable() {
            return None;
        }
        let (fault, value) = self.fault();
        let limit = self.limit();
        Some(Refusal {
            fault,
            value,
            dt: self.dt(),
            limit: limit.dt,
            by: limit.by,
            ways_out: self.ways_out(fault),
        })
    }

    fn is_stable(&self) -> bool {
        self.dt() <= self.limit().dt
    }

    /// The first parameter that, put back to the preset's value, makes the run stable: what the
    /// discs are before how finely time is cut. Without one, the time step itself.
    fn fault(&self) -> (&'static str, f64) {
        let usual = self.preset.values();
        let (damping_flag, damping) = self.damping.flag_and_value();
        let (step_flag, step) = self.step.flag_and_value();
        let suspects = [
            (damping_flag, damping, Self { damping: usual.damping, ..self.clone() }),
            ("--kn", self.stiffness, Self { stiffness: usual.stiffness, ..self.clone() }),
            ("--mass", self.mass, Self { mass: usual.mass, ..self.clone() }),
        ];
        suspects
            .into_iter()
            .find(|(.., mended)| mended.is_stable())
            .map_or((step_flag, step), |(flag, value, _)| (flag, value))
    }

    /// Up to three changes, each kept only if it makes the run stable.
    fn ways_out(&self, fault: &str) -> Vec<String> {
        let with = |step| Self { step, ..self.clone() };
        let limit = self.limit();
        // Just below the limit an elastic heap heats up; an overdamped one, which never lets go
        // of a contact, does not.
        let fraction = if limit.is_overdamped { 1.0 } else { COARSE };
        let nt = round_up(with(StepChoice::Nt(1.0)).dt() / (fraction * limit.dt));
        let mut tries = vec![
            self.usual_value_of(fault),
            (format!("--nt {}", Num(nt)), with(StepChoice::Nt(nt))),
            ("--dt auto".to_owned(), with(StepChoice::Auto)),
        ];
        tries.dedup_by(|a, b| a.0 == b.0);
        tries.retain(|(_, mended)| mended.is_stable() && mended.check_clock().is_ok());
        tries.into_iter().map(|(way_out, _)| way_out).collect()
    }

    /// The flag that puts the parameter at fault back to its usual value, and what becomes of it.
    fn usual_value_of(&self, fault: &str) -> (String, Self) {
        let usual = self.preset.values();
        match fault {
            "--kn" => {
                let mended = Self { stiffness: usual.stiffness, ..self.clone() };
                (format!("--kn {}", Num(usual.stiffness)), mended)
            }
            "--mass" => {
                let mended = Self { mass: usual.mass, ..self.clone() };
                (format!("--mass {}", Num(usual.mass)), mended)
            }
            "--nt" | "--dt" => {
                let (flag, value) = usual.step.flag_and_value();
                (format!("{flag} {value}"), Self { step: usual.step, ..self.clone() })
            }
            // A damping: the calm one, whatever the preset.
            _ => {
                let damping = Preset::Guide.values().damping;
                let (flag, value) = damping.flag_and_value();
                (format!("{flag} {value:e}"), Self { damping, ..self.clone() })
            }
        }
    }
}

impl DampingChoice {
    /// The flag that says this damping, and its value.
    pub fn flag_and_value(self) -> (&'static str, f64) {
        match self {
            Self::Eta(eta) => ("--eta", eta),
            Self::Gamma(gamma) => ("--gamma", gamma),
            Self::Restitution(e) => ("--restitution", e),
        }
    }
}

impl StepChoice {
    /// The flag that says this step, and its value.
    pub fn flag_and_value(self) -> (&'static str, f64) {
        match self {
            Self::Nt(nt) => ("--nt", nt),
            Self::Seconds(dt) => ("--dt", dt),
            Self::Auto => ("--dt", f64::NAN),
        }
    }
}

/// `value` and at least 3 % more, rounded up to two digits: a number to type.
pub fn round_up(value: f64) -> f64 {
    let digit = 10f64.powi((1.03 * value).log10().floor() as i32 - 1);
    // A second rounding: 21 * 100 is exact, 0.21e-3 / 1e-4 is not.
    format!("{:.1e}", (1.03 * value / digit - 1e-9).ceil() * digit).parse().unwrap_or(value)
}
