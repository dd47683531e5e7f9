//! `parsim2d presets`: the named sets of parameters, side by side.

use std::io::{self, Write};
use std::process::ExitCode;

use super::failure::Failure;
use crate::number::shortest;
use crate::scenario::preset::Preset;

pub(super) fn print() -> Result<ExitCode, Failure> {
    let mut out = io::stdout().lock();
    writeln!(
        out,
        "{:<18} {:>4} {:>7} {:>7} {:>6} {:>7}  {:<16} N_t",
        "preset", "n", "l m", "r m", "m kg", "k_n N/m", "damping"
    )?;
    for preset in Preset::ALL {
        let values = preset.values();
        let (flag, damping) = values.damping.flag_and_value();
        let (_, nt) = values.step.flag_and_value();
        writeln!(
            out,
            "{:<18} {:>4} {:>7} {:>7} {:>6} {:>7}  {:<16} {nt}",
            preset.name(),
            values.n,
            values.side,
            shortest(values.radius),
            shortest(values.mass),
            shortest(values.stiffness),
            format!("{flag} {}", shortest(damping))
        )?;
    }
    Ok(ExitCode::SUCCESS)
}
