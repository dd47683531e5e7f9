//! What a check measures, and why.

use std::io::Write;

use super::error::GradeError;
use crate::cli::Failure;
use crate::grade::check::Check;
use crate::grade::rubric::Rubric;
use crate::grade::words::ENGLISH;

pub(super) fn explain(out: &mut impl Write, id: &str, rubric: &Rubric) -> Result<(), Failure> {
    let check = Check::named(id).ok_or_else(|| GradeError::Check { id: id.to_owned() })?;
    let (said, [points, after]) = ((ENGLISH.check)(check), ENGLISH.worth);
    writeln!(out, "{id}: {} ({} {points})", said.title, rubric.points_of(check))?;
    writeln!(out, "{}", said.explained)?;
    if let Some(needed) = check.needs() {
        writeln!(out, "{after}: {}", needed.id())?;
    }
    Ok(())
}
