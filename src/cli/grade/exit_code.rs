//! The exit code of a grading.

use std::io::{self, Write};

use crate::grading::feedback::Entry;
use crate::grading::feedback::plain::one_line;

/// 3 if a submission could not be graded, else 1 if one has less than `least` per cent, else 0.
pub(super) fn exit_code(entries: &[Entry], least: Option<f64>) -> u8 {
    let mut code = 0;
    for entry in entries {
        match entry {
            Ok(graded) if least.is_some_and(|least| graded.report.percent() < least) => {
                code = code.max(1);
            }
            Ok(_) => {}
            Err(ungraded) => {
                let line = format!("error: {} {}", ungraded.name, ungraded.why);
                let _ = writeln!(io::stderr(), "{}", one_line(&line));
                code = 3;
            }
        }
    }
    code
}
