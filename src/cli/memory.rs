//! How much memory a run may take, and how much it has used: Linux tells it in files.

mod there;

use self::there::room;
use crate::scenario::Scenario;
use crate::scenario::error::ScenarioError;

/// Refuses a run that takes more memory than there is, as far as the system tells.
pub(super) fn check(scenario: &Scenario) -> Result<(), ScenarioError> {
    room().map_or(Ok(()), |room| scenario.fit_memory(room.bytes, room.whose))
}

/// The most memory that this process has held at once, all included, in MB (1e6 bytes). `None` where
/// the system does not tell it in a file, as outside Linux.
pub(super) fn peak_memory() -> Option<f64> {
    peak_in(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// The peak in MB from the text of a `/proc/PID/status`: the line `VmHWM: 1234 kB`, in units of 1024
/// bytes (proc_pid_status(5)).
fn peak_in(status: &str) -> Option<f64> {
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: f64 = line.trim().strip_suffix("kB")?.trim_end().parse().ok()?;
    Some(1.024e-3 * kilobytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_peak_is_read_in_units_of_1024_bytes() {
        let status = "Name:\tparsim2d\nVmPeak:\t  9999 kB\nVmHWM:\t    2000 kB\nVmRSS:\t 1 kB\n";
        assert_eq!(peak_in(status), Some(2.048));
    }

    #[test]
    fn a_status_that_does_not_tell_it_gives_nothing() {
        for status in ["", "Name:\tparsim2d\n", "VmHWM:\tmany kB\n", "VmHWM:\t2000\n"] {
            assert_eq!(peak_in(status), None, "{status}");
        }
    }
}
