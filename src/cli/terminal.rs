//! What a terminal shows of a run on its way, and how it is asked to stop.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use super::interrupt::Interrupt;
use super::say::say;
use crate::number::seconds;
use crate::session::{Onlooker, Session};
use crate::simulation::Simulation;

/// A progress bar, and Ctrl-C.
pub(super) struct Terminal<'a> {
    bar: ProgressBar,
    interrupt: &'a Interrupt,
}

impl<'a> Terminal<'a> {
    pub fn of(session: &Session, interrupt: &'a Interrupt) -> Self {
        let bar = progress_bar(session.scenario.steps(), session.scenario.output.quiet);
        let bar = bar.with_position(session.simulation().steps());
        bar.reset_eta();
        Self { bar, interrupt }
    }
}

impl Drop for Terminal<'_> {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

impl Onlooker for Terminal<'_> {
    fn stops(&self) -> bool {
        self.interrupt.is_raised()
    }

    fn see(&mut self, simulation: &Simulation) {
        self.bar.set_position(simulation.steps());
        self.bar.set_message(format!("t = {} s", seconds(simulation.time(), 4)));
    }

    fn hear(&mut self, warning: &str) {
        say("warning", warning);
    }
}

/// A bar on terminals only, drawn ten times a second.
pub(super) fn progress_bar(steps: u64, hidden: bool) -> ProgressBar {
    if hidden {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {msg}  {eta} left")
        .expect("a fixed, tested template");
    ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::stderr_with_hz(10))
        .with_style(style)
}

/// Says, on terminals only, that a large box is being filled.
pub(super) fn placing_spinner(quiet: bool) -> ProgressBar {
    let spinner = if quiet { ProgressBar::hidden() } else { ProgressBar::new_spinner() };
    spinner.set_message("placing the discs");
    spinner.enable_steady_tick(Duration::from_millis(200));
    spinner
}
