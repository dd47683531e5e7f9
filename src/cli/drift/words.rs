//! The answer in words. Every number in it was measured by the run that prints it, and every
//! judgement hangs on such a number: with other parameters the sentences change.

use std::io::{self, Write};

use super::super::wrapped::wrapped;
use super::findings::{Contact, Findings, Heating};
use crate::number::{energy, percent};
use crate::scenario::settings::IntegratorName::{ExplicitEuler, SymplecticEuler, VelocityVerlet};
use crate::scenario::study::Case;

/// A relative error below this is small beside what a student's plot shows.
const SMALL: f64 = 0.01;

/// A growth of less than this a second is hardly any, 1/s.
const HARDLY: f64 = 0.005;

/// A work residue below this, relative, is round-off.
const ROUND_OFF: f64 = 1e-9;

/// The answer, a paragraph an entry.
pub(super) fn answer(findings: &Findings) -> Vec<String> {
    vec![
        "Does the total energy stay constant? If not, what is the problem, and can it be solved?"
            .to_owned(),
        explicit_euler(findings),
        eq_3(findings),
        verlet(findings),
        crowd(findings),
        saw_tooth(findings),
        damping(findings),
        cure(findings),
    ]
}

fn explicit_euler(findings: &Findings) -> String {
    let wall = findings.contact(Case::Wall, ExplicitEuler);
    let pair = findings.contact(Case::Pair, ExplicitEuler);
    let mut words = format!(
        "Explicit Euler: {} It gains {} in one bounce off a wall with N_t = {:.1}, and {} when two \
         discs meet.",
        if wall.after > SMALL { "no." } else { "not quite." },
        percent(wall.after),
        wall.nt,
        percent(pair.after)
    );
    if let Some(order) = wall.order_after {
        words += &format!(" The gain goes like dt^{order:.2}.");
    }
    let doubled = |case: Case| {
        findings.doubled.iter().find(|run| {
            (run.case, run.integrator, run.nt) == (case.name(), ExplicitEuler.name(), findings.nt)
                && run.restitution == 1.0
        })
    };
    let (nt, time) = (findings.nt, findings.box_time_s);
    words += &match doubled(Case::Box) {
        Some(run) => {
            format!(" In the guide's box the energy had doubled after {:.2} s.", run.time_s)
        }
        None => format!(" In {time} s of the guide's box the energy did not double at N_t = {nt}."),
    };
    if let Some(run) = doubled(Case::Dense) {
        words += &format!(" In the dense box it took {:.2} s.", run.time_s);
    }
    words
}

fn eq_3(findings: &Findings) -> String {
    let wall = findings.contact(Case::Wall, SymplecticEuler);
    let mut words = format!(
        "Eq. (3), the guide's Euler: {} At a wall it errs by up to {} while the contact lasts{}, and \
         by {} after it{}",
        if wall.after.abs() < SMALL { "nearly." } else { "not at so coarse a step." },
        percent(wall.inside),
        order(wall.order_inside),
        percent(wall.after),
        order(wall.order_after),
    );
    let comes_back = wall.inside > 3.0 * wall.after.abs();
    words += if comes_back { ": what it took it gives back." } else { "." };
    let Findings { box_largest_error, box_final_error, box_time_s, nt, .. } = *findings;
    words += &format!(
        " In {box_time_s} s of the guide's box without damping (N_t = {nt}) the error was never above \
         {} and was {} at the end.",
        percent(box_largest_error),
        percent(box_final_error)
    );
    words
}

fn order(order: Option<f64>) -> String {
    order.map_or(String::new(), |order| format!(" (order {order:.2} in dt)"))
}

fn verlet(findings: &Findings) -> String {
    let Contact { after, inside, order_inside, .. } = findings.contact(Case::Wall, VelocityVerlet);
    let euler = findings.contact(Case::Wall, SymplecticEuler).after;
    // The same path in exact arithmetic; some hundred steps of rounding.
    let same = (after - euler).abs() < 1e-10;
    format!(
        "Velocity Verlet errs by up to {} in the wall's contact{} and by {} after it{}",
        percent(*inside),
        order(*order_inside),
        percent(*after),
        if same {
            ", the same as Eq. (3): it moves the discs along the same path, and only reads the \
             velocity half a kick later."
        } else {
            "."
        }
    )
}

fn crowd(findings: &Findings) -> String {
    let Findings { dense_discs: n, dense_time_s: time, fall_time_s: fall, .. } = *findings;
    if findings.dense.is_empty() || n < 2 {
        return format!(
            "In {time} s the dense box (n = {n}) says nothing of many contacts: it takes discs that \
             meet, and twice the {fall:.2} s in which they fall through the box. Try --time 0.2s."
        );
    }
    let rates: Vec<String> = eq_3_heating(findings).map(rate).collect();
    let heats = eq_3_heating(findings).any(|run| run.is_clear() && run.rate_per_s > HARDLY);
    let all_calm = eq_3_heating(findings).all(is_calm);
    let mut words = format!(
        "{} The energy of the dense box (n = {n}, no damping) grows, with Eq. (3), by {}.",
        match (heats, all_calm) {
            (true, _) => "Many contacts add such errors up.",
            (false, true) => "Many contacts add hardly anything up here.",
            (false, false) => "Whether many contacts add such errors up does not show in this run.",
        },
        rates.join(", ")
    );
    let verlet = findings.dense.iter().find(|run| run.integrator == VelocityVerlet.name());
    if let Some(verlet) = verlet {
        words += &format!(" Velocity Verlet: {}.", rate(verlet));
        let euler = eq_3_heating(findings).find(|run| run.nt == verlet.nt);
        let helps = euler.is_some_and(|euler| verlet.rate_per_s < 0.5 * euler.rate_per_s);
        if heats && verlet.is_clear() && !helps {
            words += " So this is a matter of dt, not of the method: contacts begin and end \
                      between two steps.";
        }
    }
    words
}

fn rate(run: &Heating) -> String {
    match run.is_clear() {
        true => format!("{} a second at N_t = {}", percent(run.rate_per_s), run.nt),
        false => format!(
            "nothing clear at N_t = {} (less than {} a second)",
            run.nt,
            percent(run.rate_per_s.abs() + run.doubt_per_s)
        ),
    }
}

/// Whether the growth is hardly any for certain.
fn is_calm(run: &Heating) -> bool {
    run.rate_per_s.abs() + run.doubt_per_s < HARDLY
}

fn eq_3_heating(findings: &Findings) -> impl Iterator<Item = &Heating> {
    findings.dense.iter().filter(|run| run.integrator == SymplecticEuler.name())
}

fn saw_tooth(findings: &Findings) -> String {
    let fall = &findings.saw_tooth;
    let agrees = (fall.measured_J / fall.formula_J - 1.0).abs() < 1e-3;
    format!(
        "In free fall Eq. (3) shows {} at {:.3} m/s; -m g v dt/2 is {}. {}",
        energy(fall.measured_J),
        fall.speed_m_per_s,
        energy(fall.formula_J),
        if agrees {
            "The new velocity moves the disc, so that K and height belong to times half a step \
             apart. It follows the speed and comes back with it: a saw-tooth, not a loss."
        } else {
            "The two differ: rounding is larger than so small an error."
        }
    )
}

fn damping(findings: &Findings) -> String {
    let damped = &findings.damped;
    let mut words = if damped.taken.abs() > damped.final_error.abs() {
        format!(
            "What damping takes is no error: with e = {} the dashpots took {} of the dense box's \
             energy, and with that counted the sum was off by {} (Eq. (3), N_t = {}).",
            damped.restitution,
            percent(damped.taken),
            percent(damped.final_error),
            findings.nt
        )
    } else {
        "Next to nothing was damped here, so that there is nothing to tell from an error."
            .to_owned()
    };
    words += &format!(
        " The work residue is at most {:.0e} of the energy in all runs: {}",
        findings.work_error,
        if findings.work_error < ROUND_OFF {
            "round-off, the bookkeeping is right. What is left is the time step's doing."
        } else {
            "more than rounding; do not trust these numbers."
        }
    );
    words
}

fn cure(findings: &Findings) -> String {
    // The coarsest step from which on all finer ones are calm, too.
    let runs: Vec<&Heating> = eq_3_heating(findings).collect();
    let coarsest = runs.iter().rev().take_while(|run| is_calm(run)).last();
    let explicit = findings.contact(Case::Wall, ExplicitEuler).after;
    let euler = findings.contact(Case::Wall, SymplecticEuler).after.abs();
    let change = if euler < explicit {
        "move the discs with the new velocity (Eq. (3) or velocity Verlet), which does away with \
         explicit Euler's gain"
    } else {
        "take a finer step: here even Eq. (3) is no better than explicit Euler"
    };
    let tail = match coarsest {
        Some(run) => format!(
            "and take a step fine enough for the crowd: N_t = {} was, of those tried (a growth of \
             less than {} a second). Read the saw-tooth for what it is, and count what damping \
             takes.",
            run.nt,
            percent(HARDLY)
        ),
        None => "and if many discs meet without damping, a step fine enough for them: a longer \
                 --time or a larger --nt would show which; none of those tried did."
            .to_owned(),
    };
    format!("Can it be solved? Yes: {change}; {tail}")
}

/// Writes the paragraphs, broken into lines.
pub(super) fn write(out: &mut impl Write, paragraphs: &[String]) -> io::Result<()> {
    const WIDTH: usize = 92;
    let broken: Vec<String> =
        paragraphs.iter().map(|paragraph| wrapped(paragraph, WIDTH)).collect();
    writeln!(out, "{}", broken.join("\n\n"))
}
