//! Why a picture was not drawn, said to the person who wanted it. Nothing has been written then.

use std::io;
use std::path::Path;

use crate::cli::refusal::Refusal;
use crate::cli::typed::shown;
use crate::echo;

/// A file that cannot be opened, of a kind that `command` writes.
pub fn unreadable(path: &Path, source: &io::Error, command: &str) -> Refusal {
    Refusal {
        why: format!("cannot read {}: {source}", echo::path(path)),
        way_out: format!("`{command}` writes it; or name another file"),
    }
}

/// A file that cannot be drawn.
pub fn bad_file(path: &Path, why: &str, way_out: &str) -> Refusal {
    let why = format!("cannot draw {}: {why}", echo::path(path));
    Refusal { why, way_out: way_out.to_owned() }
}

/// A file without the velocities that the picture shows; `or` is another way out, where there is one.
pub fn no_velocities(path: &Path, or: &str) -> Refusal {
    let better = path.with_file_name("trajectory.txt");
    let way_out = match better.is_file() && better != path {
        true => format!("{}, which has them", shown(&better)),
        false => "the trajectory.txt of the run, which has them".to_owned(),
    };
    let or = if or.is_empty() { String::new() } else { format!("; or {or}") };
    bad_file(path, "its frame has no velocities (columns `x y r`)", &format!("{way_out}{or}"))
}

/// More files than one, `n`, where one is drawn.
pub fn too_many(kind: &str, n: usize) -> Refusal {
    Refusal {
        why: format!("plot {kind} draws one file, and {n} were named"),
        way_out: "one command a file; only `plot energy` draws several in one picture".to_owned(),
    }
}

/// A name that the picture cannot have.
pub fn bad_out(path: &Path, why: &str, way_out: impl Into<String>) -> Refusal {
    let why = format!("--out {} is not possible: {why}", echo::path(path));
    Refusal { why, way_out: way_out.into() }
}
