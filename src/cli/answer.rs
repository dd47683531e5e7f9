//! The analytic answer beside a run of one or two discs, after its summary.

use std::io::{self, Write};

use glam::DVec2;

use crate::analysis::answer::{Answer, AnswerRow, Question};
use crate::number::significant;
use crate::scenario::{DiscSource, Scenario, StepChoice};
use crate::simulation::Simulation;

/// Theory beside measurement for this scenario; nothing where theory has none.
pub(super) fn of(scenario: &Scenario) -> Answer {
    let nobody_asks = scenario.output.quiet && !scenario.output.json;
    if scenario.n() > 2 || nobody_asks {
        return Answer::default();
    }
    let build = |discs, dt| -> Option<Simulation> {
        let step = StepChoice::Seconds(dt);
        let discs = DiscSource::Listed(discs, Vec::new());
        Scenario { discs, step, ..scenario.clone() }.build().ok()
    };
    let Ok(start) = scenario.build() else { return Answer::default() };
    let question = Question {
        discs: start.particles().to_vec(),
        law: scenario.law(),
        gravity: scenario.gravity_vector(),
        side: scenario.walls.then_some(scenario.side),
        dt: scenario.dt(),
        time: scenario.time,
    };
    question.answer(&build)
}

/// Writes the table; nothing for no rows.
pub(super) fn write(out: &mut impl Write, answer: &Answer) -> io::Result<()> {
    if answer.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nfirst contact             theory       measured     error     order in dt")?;
    for [what, theory, measured, error, order] in answer.rows().iter().map(AnswerRow::cells) {
        writeln!(out, "{what:<25} {theory:<12} {measured:<12} {error:<9} {order}")?;
    }
    answer.remark.iter().try_for_each(|remark| writeln!(out, "({remark})"))
}

/// Of so few discs, each placed by hand, the velocities are told.
const FEW: std::ops::RangeInclusive<usize> = 2..=8;

/// The velocities of each disc at the start and at the end of a run of few discs, m/s: what a collision does.
pub(super) fn velocities(scenario: &Scenario, end: &Simulation) -> Vec<[DVec2; 2]> {
    let is_placed = matches!(&scenario.discs, DiscSource::Listed(_, groups) if groups.is_empty());
    if !is_placed || !FEW.contains(&end.n()) {
        return Vec::new();
    }
    let Ok(start) = scenario.place() else { return Vec::new() };
    let pairs = start.iter().zip(end.particles());
    pairs.map(|(start, end)| [start.velocity, end.velocity]).collect()
}

/// Writes them as a table; nothing for none.
pub(super) fn write_velocities(out: &mut impl Write, of: &[[DVec2; 2]]) -> io::Result<()> {
    if of.is_empty() {
        return Ok(());
    }
    writeln!(out, "\nvelocity, m/s   vx at start   vy at start     vx at end     vy at end")?;
    for (disc, [start, end]) in of.iter().enumerate() {
        let [a, b, c, d] = [start.x, start.y, end.x, end.y].map(|v| significant(v, 6));
        writeln!(out, "disc {disc:<9} {a:>12} {b:>13} {c:>13} {d:>13}")?;
    }
    Ok(())
}
