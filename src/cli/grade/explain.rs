//! What a check measures, and why; what a cause means.

use std::io::Write;

use super::error::GradeError;
use crate::cli::failure::Failure;
use crate::grading::feedback::plain::one_line;
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;
use crate::grading::judge::rubric::Rubric;
use crate::grading::judge::words::ENGLISH;
use crate::number::decimals;

pub(super) fn explain(out: &mut impl Write, id: &str, rubric: &Rubric) -> Result<(), Failure> {
    match (Check::named(id), Mistake::named(id)) {
        (Some(check), _) => explain_check(out, check, rubric)?,
        (None, Some(mistake)) => explain_cause(out, mistake, rubric)?,
        (None, None) => return Err(GradeError::Unexplained { id: id.to_owned() }.into()),
    }
    Ok(())
}

fn explain_check(out: &mut impl Write, check: Check, rubric: &Rubric) -> std::io::Result<()> {
    let (said, after) = ((ENGLISH.check)(check), ENGLISH.after);
    let worth = rubric.points_of(check);
    writeln!(
        out,
        "{}: {} ({} {})",
        check.id(),
        said.title,
        decimals(worth, 2),
        ENGLISH.points_of(worth)
    )?;
    writeln!(out, "{}", said.explained)?;
    check.needs().map_or(Ok(()), |needed| writeln!(out, "{after}: {}", needed.id()))
}

fn explain_cause(out: &mut impl Write, cause: Mistake, rubric: &Rubric) -> std::io::Result<()> {
    let said = (ENGLISH.mistake)(cause);
    let hint = rubric.hints.get(&cause).map_or(said.hint, String::as_str);
    writeln!(out, "{}: {} {}", cause.id(), ENGLISH.looks_like, said.looks_like)?;
    writeln!(out, "{}: {}", ENGLISH.hint, one_line(hint))?;
    writeln!(out, "{}: {} %", ENGLISH.part_left, decimals(100.0 * rubric.part_left(Some(cause)), 2))
}
