//! Wall time during a run: when to look at the clock, when to refresh `out.txt`, how fast to go.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::simulation::Simulation;

/// At most so many refreshes of `out.txt` a second.
const REFRESHES_PER_SECOND: f64 = 60.0;

/// A refresh waits at least so many times as long as the last one took, so that showing a large
/// run costs it at most a twentieth of its time.
const REST_AFTER_REFRESH: f64 = 20.0;

/// The clock is looked at about every so many particle-steps (a millisecond or less, or one
/// step if that takes longer), so that looking costs nothing.
const PARTICLE_STEPS_PER_LOOK: u64 = 20_000;

/// The wall clock of a run.
pub(super) struct Watch {
    started: Instant,
    next_refresh: Instant,
    /// Wall time that the last refresh took, s.
    last_refresh: f64,
    stepping: Duration,
    /// Step and simulated time (s) at the start of this session.
    from: (u64, f64),
    /// Wall seconds for a simulated second.
    slowdown: Option<f64>,
    steps_per_look: u64,
    bar: ProgressBar,
}

impl Watch {
    pub fn start(simulation: &Simulation, steps: u64, slowdown: Option<f64>, quiet: bool) -> Self {
        let mut steps_per_look = (PARTICLE_STEPS_PER_LOOK / simulation.n() as u64).max(1);
        if let Some(slowdown) = slowdown {
            // Look twice a refresh, so that a slow run moves smoothly.
            let per_look = 0.5 / (REFRESHES_PER_SECOND * slowdown * simulation.dt());
            steps_per_look = steps_per_look.min((per_look as u64).max(1));
        }
        let now = Instant::now();
        let bar = progress_bar(steps, quiet).with_position(simulation.steps());
        bar.reset_eta();
        Self {
            started: now,
            next_refresh: now,
            last_refresh: 0.0,
            stepping: Duration::ZERO,
            from: (simulation.steps(), simulation.time()),
            slowdown,
            steps_per_look,
            bar,
        }
    }

    /// The step at which to look at the clock next.
    pub fn next_look(&self, simulation: &Simulation) -> u64 {
        simulation.steps() + self.steps_per_look
    }

    /// Steps the simulation up to step `until` and books the wall time it took.
    pub fn step_until(&mut self, simulation: &mut Simulation, until: u64) {
        let begun = Instant::now();
        simulation.step_until(until);
        self.stepping += begun.elapsed();
    }

    /// Calls `refresh` if it is due.
    pub fn refresh_if_due<E>(&mut self, refresh: impl FnOnce() -> Result<(), E>) -> Result<(), E> {
        let begun = Instant::now();
        if begun < self.next_refresh {
            return Ok(());
        }
        refresh()?;
        let took = begun.elapsed().as_secs_f64();
        // The shorter of two, so that one slow write does not freeze the view; and a run that
        // waits anyway has time for all.
        let usual = if self.slowdown.is_some() { 0.0 } else { took.min(self.last_refresh) };
        self.last_refresh = took;
        let pause = (REST_AFTER_REFRESH * usual).max(1.0 / REFRESHES_PER_SECOND);
        self.next_refresh = begun + Duration::from_secs_f64(pause);
        Ok(())
    }

    /// Shows how far the run is; waits, if it is to be slow, until wall time has caught up or
    /// `interrupted` says stop.
    pub fn keep_pace(&self, simulation: &Simulation, interrupted: impl Fn() -> bool) {
        self.bar.set_position(simulation.steps());
        self.bar.set_message(format!("t = {:.4} s", simulation.time()));
        let Some(slowdown) = self.slowdown else {
            return;
        };
        let wanted = (simulation.time() - self.from.1) * slowdown;
        loop {
            let ahead = wanted - self.started.elapsed().as_secs_f64();
            if ahead <= 0.0 || interrupted() {
                return;
            }
            std::thread::sleep(Duration::from_secs_f64(ahead.min(0.05)));
        }
    }

    /// Takes the progress bar away.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }

    /// Wall time since the start, s.
    pub fn wall_time(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    /// Steps since the start of this session.
    pub fn steps(&self, simulation: &Simulation) -> u64 {
        simulation.steps() - self.from.0
    }

    /// Wall time spent stepping, s.
    pub fn stepping_time(&self) -> f64 {
        self.stepping.as_secs_f64()
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
