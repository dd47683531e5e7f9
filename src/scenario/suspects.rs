//! Which parameter is at fault: the first that, put back to its usual value, mends the run.

use super::number::Num;
use super::preset::Preset;
use super::{DampingChoice, DiscSource, Scenario, StepChoice};

/// A parameter and the scenario with this one put back to its usual value.
pub(super) struct Suspect {
    /// Its flag, or the disc that has it.
    pub name: String,
    pub value: String,
    /// The usual value, as it would be said.
    pub usual: String,
    pub mended: Scenario,
}

impl Scenario {
    /// The first suspect whose usual value makes the scenario well. What the discs are comes before
    /// where they are, and a single disc before all.
    pub(super) fn at_fault(&self, is_well: impl Fn(&Self) -> bool) -> Option<Suspect> {
        let changed = |suspect: &Suspect| suspect.mended != *self;
        let mut suspects = self.single_discs();
        suspects.extend(self.common_values());
        suspects.into_iter().find(|suspect| changed(suspect) && is_well(&suspect.mended))
    }

    /// The values that all discs share, against those of the preset.
    fn common_values(&self) -> Vec<Suspect> {
        let usual = self.preset.values();
        let (damping_flag, damping) = self.damping.flag_and_value();
        // A damping is put back to the calm one, whatever the preset.
        let calm = Preset::Guide.values().damping;
        let (calm_flag, calm_value) = calm.flag_and_value();
        let number = |name: &str, value: f64, usual: f64, mended: Self| Suspect {
            name: name.to_owned(),
            value: Num(value).to_string(),
            usual: format!("{name} {}", Num(usual)),
            mended,
        };
        vec![
            Suspect {
                name: damping_flag.to_owned(),
                value: Num(damping).to_string(),
                usual: format!("{calm_flag} {calm_value:e}"),
                mended: Self { damping: calm, ..self.clone() },
            },
            number("--kn", self.stiffness, usual.stiffness, {
                Self { stiffness: usual.stiffness, ..self.clone() }
            }),
            number("--mass", self.mass, usual.mass, Self { mass: usual.mass, ..self.clone() }),
            number("--gravity", self.gravity, usual.gravity, {
                Self { gravity: usual.gravity, ..self.clone() }
            }),
            number("--speed", self.speed, 0.0, Self { speed: 0.0, ..self.clone() }),
            number("--radius", self.radius, usual.radius, {
                Self { radius: usual.radius, ..self.clone() }
            }),
            number("--side", self.side, usual.side, Self { side: usual.side, ..self.clone() }),
        ]
    }

    /// The lightest and the fastest of listed discs and groups.
    fn single_discs(&self) -> Vec<Suspect> {
        let DiscSource::Listed(listed, groups) = &self.discs else {
            return Vec::new();
        };
        let mut suspects = Vec::new();
        let lightest = (0..listed.len()).min_by(|&a, &b| listed[a].mass.total_cmp(&listed[b].mass));
        if let Some(k) = lightest {
            let mut mended = listed.clone();
            mended[k].mass = self.mass;
            suspects.push(Suspect {
                name: format!("disc {k}: mass"),
                value: Num(listed[k].mass).to_string(),
                usual: format!("mass = {} for disc {k}", Num(self.mass)),
                mended: self.with_discs(DiscSource::Listed(mended, groups.clone())),
            });
        }
        let speed = |k: usize| listed[k].velocity.length();
        if let Some(k) = (0..listed.len()).max_by(|&a, &b| speed(a).total_cmp(&speed(b))) {
            let mut mended = listed.clone();
            mended[k].velocity = glam::DVec2::ZERO;
            let v = listed[k].velocity;
            suspects.push(Suspect {
                name: format!("disc {k}: velocity"),
                value: format!("[{}, {}]", Num(v.x), Num(v.y)),
                usual: format!("a slower disc {k}"),
                mended: self.with_discs(DiscSource::Listed(mended, groups.clone())),
            });
        }
        let lightest = (0..groups.len()).min_by(|&a, &b| groups[a].mass.total_cmp(&groups[b].mass));
        if let Some(k) = lightest {
            let mut mended = groups.clone();
            mended[k].mass = self.mass;
            suspects.push(Suspect {
                name: format!("population {k}: mass"),
                value: Num(groups[k].mass).to_string(),
                usual: format!("mass = {} for population {k}", Num(self.mass)),
                mended: self.with_discs(DiscSource::Listed(listed.clone(), mended)),
            });
        }
        suspects
    }

    pub(super) fn with_discs(&self, discs: DiscSource) -> Self {
        Self { discs, ..self.clone() }
    }

    /// The flag that said the time step, and its value.
    pub(super) fn step_flag(&self) -> (String, String) {
        let (flag, value) = self.step.flag_and_value();
        (flag.to_owned(), Num(value).to_string())
    }

    /// This scenario with another time step.
    pub(super) fn with_step(&self, step: StepChoice) -> Self {
        Self { step, ..self.clone() }
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
