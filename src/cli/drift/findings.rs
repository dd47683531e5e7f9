//! The key numbers of the drift study, from which the answer in words is made.

use serde::Serialize;

use crate::analysis::drift::{Course, observed_order};
use crate::scenario::error::ScenarioError;
use crate::scenario::settings::IntegratorName;
use crate::scenario::study::{Case, Study, StudyRun, nearest};

/// A run and what it gave.
pub(super) type Outcome<'a> = (&'a StudyRun, &'a Course);

/// The key numbers. Errors are relative to the energy at the start; N_t counts steps in a wall
/// contact.
#[derive(Debug, Serialize)]
#[allow(non_snake_case)] // a key's name ends with its unit
pub(super) struct Findings {
    /// The N_t nearest to the guide's 50, to which the numbers belong that do not say their own.
    pub nt: f64,
    /// One elastic contact, near that N_t.
    pub contacts: Vec<Contact>,
    /// Eq. (3) in the guide's box, elastic.
    pub box_largest_error: f64,
    pub box_final_error: f64,
    pub box_time_s: f64,
    /// Boxes in which explicit Euler doubled the energy.
    pub doubled: Vec<Doubled>,
    /// The elastic dense box.
    pub dense_discs: usize,
    pub dense_time_s: f64,
    /// Time to fall through the box: before, the discs have hardly met.
    pub fall_time_s: f64,
    /// Empty if the later half of the run begins before that time.
    pub dense: Vec<Heating>,
    pub saw_tooth: Fall,
    pub damped: Damped,
    /// Largest work residue of all runs, over the energy at the start.
    pub work_error: f64,
}

/// One contact, the worst of its phases.
#[derive(Debug, Serialize)]
pub(super) struct Contact {
    pub case: &'static str,
    pub integrator: &'static str,
    pub nt: f64,
    pub after: f64,
    pub inside: f64,
    pub order_after: Option<f64>,
    pub order_inside: Option<f64>,
}

/// When a run had doubled its energy.
#[derive(Debug, Serialize)]
pub(super) struct Doubled {
    pub case: &'static str,
    pub integrator: &'static str,
    pub restitution: f64,
    pub nt: f64,
    pub time_s: f64,
}

/// Growth of the energy in the elastic dense box.
#[derive(Debug, Serialize)]
#[allow(non_snake_case)]
pub(super) struct Heating {
    pub integrator: &'static str,
    pub nt: f64,
    pub rate_per_s: f64,
    /// What the scatter could feign.
    pub doubt_per_s: f64,
}

impl Heating {
    /// Whether the rate stands out of the scatter.
    pub fn is_clear(&self) -> bool {
        self.rate_per_s.abs() > self.doubt_per_s
    }
}

/// The saw-tooth of Eq. (3) in free fall.
#[derive(Debug, Serialize)]
#[allow(non_snake_case)]
pub(super) struct Fall {
    pub speed_m_per_s: f64,
    pub measured_J: f64,
    pub formula_J: f64,
}

/// Eq. (3) in the damped dense box.
#[derive(Debug, Serialize)]
pub(super) struct Damped {
    pub restitution: f64,
    /// What the dashpots took, over the energy at the start.
    pub taken: f64,
    pub final_error: f64,
}

impl Findings {
    pub fn of(study: &Study, outcomes: &[Outcome]) -> Result<Self, ScenarioError> {
        let nt = nearest(&study.nt, 50.0);
        let eq_3 = |case: Case, restitution: f64| {
            let this = |(run, _): &&Outcome| {
                (run.case, run.nt, run.restitution) == (case, nt, restitution)
                    && run.integrator == IntegratorName::SymplecticEuler
            };
            outcomes.iter().find(this).expect("the study has Eq. (3) at every N_t").1
        };
        let (elastic, damped) = (eq_3(Case::Box, 1.0), eq_3(Case::Dense, study.restitution));
        let fall = study.saw_tooth(nt)?;
        let [guide, dense] = &study.boxes;
        let fall_time = (2.0 * dense.side / dense.gravity.size()).sqrt();
        let residue = |(_, course): &Outcome| (course.work_error / course.energy_at_start).abs();
        Ok(Self {
            nt,
            contacts: contacts(outcomes, nt),
            box_largest_error: elastic.largest_error,
            box_final_error: elastic.final_error,
            box_time_s: guide.time,
            doubled: doubled(outcomes),
            dense_discs: dense.n(),
            dense_time_s: dense.time,
            fall_time_s: fall_time,
            dense: if dense.time > 2.0 * fall_time { heating(outcomes) } else { Vec::new() },
            saw_tooth: Fall {
                speed_m_per_s: fall.speed,
                measured_J: fall.measured,
                formula_J: fall.formula,
            },
            damped: Damped {
                restitution: study.restitution,
                taken: damped.dissipated / damped.energy_at_start,
                final_error: damped.final_error,
            },
            work_error: outcomes.iter().map(residue).fold(0.0, f64::max),
        })
    }

    /// The contact of `case` under `integrator`.
    pub fn contact(&self, case: Case, integrator: IntegratorName) -> &Contact {
        let this = |contact: &&Contact| {
            (contact.case, contact.integrator) == (case.name(), integrator.name())
        };
        self.contacts.iter().find(this).expect("the study has every contact")
    }
}

/// Outcomes that differ in N_t alone, together.
pub(super) fn blocks<'a, 'b>(outcomes: &'b [Outcome<'a>]) -> Vec<&'b [Outcome<'a>]> {
    let key = |run: &StudyRun| (run.case, run.integrator.name(), run.restitution.to_bits());
    outcomes.chunk_by(|(a, _), (b, _)| key(a) == key(b)).collect()
}

/// Orders of the errors after and inside a contact.
pub(super) fn orders(block: &[Outcome]) -> [Option<f64>; 2] {
    [|course: &Course| course.final_error, |course: &Course| course.largest_error].map(|error| {
        let errors: Vec<_> = block.iter().map(|(run, course)| (run.nt, error(course))).collect();
        observed_order(&errors)
    })
}

fn contacts(outcomes: &[Outcome], nt: f64) -> Vec<Contact> {
    let contacts = blocks(outcomes).into_iter().filter(|block| block[0].0.case.is_one_contact());
    let contact = |block: &[Outcome]| {
        let all: Vec<f64> = block.iter().map(|(run, _)| run.nt).collect();
        let (run, course) = block.iter().find(|(run, _)| run.nt == nearest(&all, nt))?;
        let [order_after, order_inside] = orders(block);
        Some(Contact {
            case: run.case.name(),
            integrator: run.integrator.name(),
            nt: run.nt,
            after: course.final_error,
            inside: course.largest_error,
            order_after,
            order_inside,
        })
    };
    contacts.filter_map(contact).collect()
}

fn doubled(outcomes: &[Outcome]) -> Vec<Doubled> {
    let doubled = |(run, course): &Outcome| {
        Some(Doubled {
            case: run.case.name(),
            integrator: run.integrator.name(),
            restitution: run.restitution,
            nt: run.nt,
            time_s: course.stopped_at?,
        })
    };
    outcomes.iter().filter_map(doubled).collect()
}

fn heating(outcomes: &[Outcome]) -> Vec<Heating> {
    let elastic =
        outcomes.iter().filter(|(run, _)| run.case == Case::Dense && run.restitution == 1.0);
    let heating = |(run, course): &Outcome| {
        let growth = course.growth()?;
        Some(Heating {
            integrator: run.integrator.name(),
            nt: run.nt,
            rate_per_s: growth.rate,
            doubt_per_s: growth.doubt,
        })
    };
    elastic.filter_map(heating).collect()
}
