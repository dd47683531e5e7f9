//! The table of the drift study: a line for each case, integrator and restitution, a column for
//! each N_t.

use std::io::{self, Write};

use super::findings::{Outcome, blocks, orders};
use crate::analysis::drift::Course;
use crate::number::{counted, percent, shortest};
use crate::scenario::study::{Case, Study, StudyRun};

pub(super) fn write(out: &mut impl Write, study: &Study, outcomes: &[Outcome]) -> io::Result<()> {
    writeln!(out, "Error of the total energy, of the energy at the start\n")?;
    writeln!(out, "One elastic contact, the worst of 16 phases")?;
    let blocks = blocks(outcomes);
    let boxes = blocks.partition_point(|block| block[0].0.case.is_one_contact());
    let (contacts, boxes) = blocks.split_at(boxes);
    for (k, block) in contacts.iter().enumerate() {
        if k == 0 || contacts[k - 1][0].0.case != block[0].0.case {
            heading(out, block.iter().map(|(run, _)| run.nt), "order")?;
        }
        write_contact(out, block)?;
    }
    for case in [Case::Box, Case::Dense] {
        let scenario = &study.boxes[usize::from(case == Case::Dense)];
        let discs = counted(scenario.n(), "disc");
        let (radius, time) = (shortest(scenario.radius), scenario.time);
        let title = if case == Case::Box { "The guide's box" } else { "A dense box" };
        writeln!(out, "\n{title}: {discs} of {radius} m, {time} s; largest, then at the end")?;
        heading(out, study.nt.iter().copied(), "")?;
        for block in boxes.iter().filter(|block| block[0].0.case == case) {
            write_box(out, &study.nt, block)?;
        }
    }
    writeln!(out)
}

fn write_contact(out: &mut impl Write, block: &[Outcome]) -> io::Result<()> {
    let StudyRun { case, integrator, .. } = block[0].0;
    let errors: [fn(&Course) -> f64; 2] =
        [|course| course.final_error, |course| course.largest_error];
    for ((when, error), order) in ["after", "inside"].into_iter().zip(errors).zip(orders(block)) {
        let name = format!("{}, {} {when}", case.name(), integrator.name());
        let order = order.map_or("-".to_owned(), |order| format!("{order:.2}"));
        line(out, &name, block.iter().map(|(_, course)| percent(error(course))), &order)?;
    }
    Ok(())
}

fn write_box(out: &mut impl Write, nt: &[f64], block: &[Outcome]) -> io::Result<()> {
    let StudyRun { integrator, restitution, .. } = block[0].0;
    let name = format!("e = {restitution}, {}", integrator.name());
    for (name, cell) in [(name, largest as fn(&Course) -> String), (String::new(), at_the_end)] {
        let cells = nt.iter().map(|nt| {
            let here = block.iter().find(|(run, _)| run.nt == *nt);
            here.map_or("-".to_owned(), |(_, course)| cell(course))
        });
        line(out, &name, cells, "")?;
    }
    Ok(())
}

fn largest(course: &Course) -> String {
    match course.stopped_at {
        Some(_) => "doubled".to_owned(),
        None => percent(course.largest_error),
    }
}

fn at_the_end(course: &Course) -> String {
    match course.stopped_at {
        Some(time) => format!("{time:.2} s"),
        None => percent(course.final_error),
    }
}

fn heading(out: &mut impl Write, nt: impl Iterator<Item = f64>, last: &str) -> io::Result<()> {
    line(out, "N_t", nt.map(|nt| ((10.0 * nt).round() / 10.0).to_string()), last)
}

fn line(
    out: &mut impl Write,
    name: &str,
    cells: impl Iterator<Item = String>,
    last: &str,
) -> io::Result<()> {
    let cells: String = cells.map(|cell| format!(" {cell:>10}")).collect();
    writeln!(out, "{}", format!("  {name:<31}{cells} {last:>6}").trim_end())
}
