//! Which parameter is at fault: the first that, put back to its usual value, mends the run.

use std::sync::Arc;

use glam::DVec2;

use super::gravity::Gravity;
use super::preset::Preset;
use super::{DampingChoice, DiscSource, Population, Scenario, StepChoice};
use crate::number::shortest;
use crate::particle::Particle;

/// What is said behind `--nt N` where the step was set by `--dt`.
pub(super) const IN_PLACE_OF_DT: &str = " in place of --dt";

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
        let suspect = |name: &str, value: String, usual: String, mended: Self| Suspect {
            name: name.to_owned(),
            value,
            usual,
            mended,
        };
        let number = |name: &str, value: f64, usual: f64, mended: Self| {
            suspect(name, shortest(value), format!("{name} {}", shortest(usual)), mended)
        };
        vec![
            suspect(
                damping_flag,
                shortest(damping),
                format!("{calm_flag} {}", shortest(calm_value)),
                Self { damping: calm, ..self.clone() },
            ),
            number("--kn", self.stiffness, usual.stiffness, {
                Self { stiffness: usual.stiffness, ..self.clone() }
            }),
            number("--mass", self.mass, usual.mass, Self { mass: usual.mass, ..self.clone() }),
            suspect(
                "--gravity",
                self.gravity.said(),
                format!("--gravity {}", shortest(usual.gravity)),
                Self { gravity: Gravity::down(usual.gravity), ..self.clone() },
            ),
            number("--speed", self.speed, 0.0, Self { speed: 0.0, ..self.clone() }),
            number("--radius", self.radius, usual.radius, {
                Self { radius: usual.radius, ..self.clone() }
            }),
            number("--side", self.side, usual.side, Self { side: usual.side, ..self.clone() }),
        ]
    }

    /// What single discs, groups and frames say for themselves, against the common values.
    fn single_discs(&self) -> Vec<Suspect> {
        match &self.discs {
            DiscSource::Equal(_) => Vec::new(),
            DiscSource::Listed(listed, groups) => {
                let mut suspects = self.listed_discs(listed, groups);
                suspects.extend(self.groups(listed, groups));
                suspects
            }
            DiscSource::Frame { said, discs, .. } => {
                let with = |change: fn(&mut Particle, &Self)| {
                    let changed = discs.iter().map(|mut disc| {
                        change(&mut disc, self);
                        disc
                    });
                    let mut source = self.discs.clone();
                    if let DiscSource::Frame { discs, .. } = &mut source {
                        *discs = Arc::new(changed.collect());
                    }
                    self.with_discs(source)
                };
                let suspect = |what: &str, usual: &str, mended| Suspect {
                    name: "--start".to_owned(),
                    value: format!("{said} ({what})"),
                    usual: usual.to_owned(),
                    mended,
                };
                let slower = with(|disc, _| disc.velocity = DVec2::ZERO);
                let larger = with(|disc, this| disc.radius = disc.radius.max(this.radius));
                let heavier = with(|disc, this| disc.mass = disc.mass.max(this.mass));
                vec![
                    suspect("its fastest disc", "a frame with slower discs", slower),
                    suspect("its smallest disc", "a frame with larger discs", larger),
                    suspect("its lightest disc", "a frame with heavier discs", heavier),
                ]
            }
        }
    }

    fn listed_discs(&self, listed: &[Particle], groups: &[Population]) -> Vec<Suspect> {
        let with = |change: &dyn Fn(usize, &mut Particle)| {
            let mut mended = listed.to_vec();
            mended.iter_mut().enumerate().for_each(|(k, disc)| change(k, disc));
            self.with_discs(DiscSource::Listed(mended, groups.to_vec()))
        };
        let extreme = |of: &dyn Fn(&Particle) -> f64| {
            (0..listed.len()).min_by(|&a, &b| of(&listed[a]).total_cmp(&of(&listed[b])))
        };
        let mut suspects = Vec::new();
        for (key, of, common) in [
            ("mass", (|disc| disc.mass) as fn(&Particle) -> f64, self.mass),
            ("radius", |disc| disc.radius, self.radius),
        ] {
            let Some(k) = extreme(&of) else { continue };
            let value = of(&listed[k]);
            // All that are as small: a pair of equal ones is mended together.
            let mended = with(&|_, disc| {
                let slot = if key == "mass" { &mut disc.mass } else { &mut disc.radius };
                *slot = if *slot <= value { common } else { *slot };
            });
            suspects.push(Suspect {
                name: format!("disc {k}: {key}"),
                value: shortest(value),
                usual: format!("{key} = {} for disc {k}", shortest(common)),
                mended,
            });
        }
        if let Some(k) = extreme(&|disc| -disc.velocity.length()) {
            let v = listed[k].velocity;
            suspects.push(Suspect {
                name: format!("disc {k}: velocity"),
                value: format!("[{}, {}]", shortest(v.x), shortest(v.y)),
                usual: format!("a slower disc {k}"),
                mended: with(&|_, disc| {
                    if disc.velocity.length() >= 0.5 * v.length() {
                        disc.velocity = DVec2::ZERO;
                    }
                }),
            });
        }
        suspects
    }

    fn groups(&self, listed: &[Particle], groups: &[Population]) -> Vec<Suspect> {
        let mut suspects = Vec::new();
        for k in suspicious(groups) {
            let group = &groups[k];
            let mut suspect = |key: &str, value: f64, usual: f64, mended: Population| {
                let mut all = groups.to_vec();
                all[k] = mended;
                suspects.push(Suspect {
                    name: format!("population {k}: {key}"),
                    value: shortest(value),
                    usual: format!("{key} = {} for population {k}", shortest(usual)),
                    mended: self.with_discs(DiscSource::Listed(listed.to_vec(), all)),
                });
            };
            suspect("mass", group.mass, self.mass, Population { mass: self.mass, ..*group });
            suspect("radius", group.radius, self.radius, {
                Population { radius: self.radius, ..*group }
            });
            suspect("speed", group.speed, 0.0, Population { speed: 0.0, ..*group });
        }
        suspects
    }

    pub(super) fn with_discs(&self, discs: DiscSource) -> Self {
        Self { discs, ..self.clone() }
    }

    /// The time step, put back to that of the preset.
    pub(super) fn step_suspect(&self) -> Suspect {
        let (name, value) = self.step.flag_and_value();
        let usual = self.preset.values().step;
        let (usual_flag, usual_value) = usual.flag_and_value();
        Suspect {
            name: name.to_owned(),
            value: shortest(value),
            usual: self.in_place_of_dt(format!("{usual_flag} {usual_value}")),
            mended: self.with_step(usual),
        }
    }

    /// The way out `--nt N`, as it is said: the flag stands beside no `--dt`, which a command that set its step by it
    /// has.
    pub(super) fn in_place_of_dt(&self, way_out: String) -> String {
        match self.step {
            StepChoice::Nt(_) => way_out,
            StepChoice::Seconds(_) | StepChoice::Auto => format!("{way_out}{IN_PLACE_OF_DT}"),
        }
    }

    /// This scenario with another time step.
    pub(super) fn with_step(&self, step: StepChoice) -> Self {
        Self { step, ..self.clone() }
    }
}

/// The groups that may be at fault by themselves, in their order: all, and of very many the extreme ones. A suspect is
/// a scenario of its own, so that all of thousands would not fit in memory.
fn suspicious(groups: &[Population]) -> Vec<usize> {
    const MANY: usize = 32;
    if groups.len() <= MANY {
        return (0..groups.len()).collect();
    }
    let most = |of: fn(&Population) -> f64| {
        (0..groups.len()).max_by(|&a, &b| of(&groups[a]).total_cmp(&of(&groups[b])))
    };
    let extremes = [
        most(|g| g.mass),
        most(|g| -g.mass),
        most(|g| g.radius),
        most(|g| -g.radius),
        most(|g| g.speed),
    ];
    let mut suspicious: Vec<usize> = extremes.into_iter().flatten().collect();
    suspicious.sort_unstable();
    suspicious.dedup();
    suspicious
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
