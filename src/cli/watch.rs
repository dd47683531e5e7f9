//! Wall time during a run: when to look at the clock, when to refresh `out.txt`, how fast to go.

use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::output::number::seconds;
use crate::simulation::Simulation;

/// At most so many refreshes of `out.txt` a second.
const REFRESHES_PER_SECOND: f64 = 60.0;

/// A refresh waits at least so many times as long as the last one kept the run from stepping, so that
/// showing a large run costs it at most a twentieth of its time.
const REST_AFTER_REFRESH: f64 = 20.0;

/// What of a refresh another thread does counts so much less where it has a core of its own: it still takes
/// caches and memory, and that core may turn out to be busy.
const SPARE_CORE: f64 = 0.2;

/// The clock is looked at about every so many particle-steps (some milliseconds), but not after fewer steps
/// than this, so that looking costs nothing: many discs are stepped faster in one go.
const PARTICLE_STEPS_PER_LOOK: u64 = 100_000;
const FEWEST_STEPS_PER_LOOK: u64 = 8;

/// The wall clock of a run.
pub(super) struct Watch {
    started: Instant,
    next_refresh: Instant,
    /// Wall time that the last refresh took from the run, s.
    last_refresh: f64,
    /// Whether what another thread writes takes all its time from the run.
    cores_are_shared: bool,
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
        let mut steps_per_look =
            (PARTICLE_STEPS_PER_LOOK / simulation.n() as u64).max(FEWEST_STEPS_PER_LOOK);
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
            cores_are_shared: true,
            stepping: Duration::ZERO,
            from: (simulation.steps(), simulation.time()),
            slowdown,
            steps_per_look,
            bar,
        }
    }

    /// The run steps on so many `threads`: where the machine has more cores, writing has one of its own.
    pub fn share_cores(&mut self, threads: usize) {
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        self.cores_are_shared = cores <= threads;
    }

    /// The step at which to look at the clock next.
    pub fn next_look(&self, simulation: &Simulation) -> u64 {
        simulation.steps() + self.steps_per_look
    }

    /// Books the wall time since `begun` as spent on stepping and what belongs to it.
    pub fn book_stepping(&mut self, begun: Instant) {
        self.stepping += begun.elapsed();
    }

    /// Calls `refresh` if it is due. It returns how long another thread was busy with the last one, or
    /// `None` if it still is; then it is due again at once.
    pub fn refresh_if_due<E>(
        &mut self,
        refresh: impl FnOnce() -> Result<Option<Duration>, E>,
    ) -> Result<(), E> {
        let begun = Instant::now();
        if begun < self.next_refresh {
            return Ok(());
        }
        let Some(elsewhere) = refresh()? else { return Ok(()) };
        let weight = if self.cores_are_shared { 1.0 } else { SPARE_CORE };
        let took = begun.elapsed().as_secs_f64() + weight * elsewhere.as_secs_f64();
        // The shorter of two, so that one slow write does not freeze the view; and a run that
        // waits anyway has time for all.
        let usual = if self.slowdown.is_some() { 0.0 } else { took.min(self.last_refresh) };
        self.last_refresh = took;
        let rested = begun + Duration::from_secs_f64(REST_AFTER_REFRESH * usual);
        // Counted from when this one was due, since a step may end well after that.
        let regular = self.next_refresh + Duration::from_secs_f64(1.0 / REFRESHES_PER_SECOND);
        self.next_refresh = regular.max(rested).max(begun);
        Ok(())
    }

    /// Shows how far the run is; waits, if it is to be slow, until wall time has caught up or
    /// `interrupted` says stop.
    pub fn keep_pace(&self, simulation: &Simulation, interrupted: impl Fn() -> bool) {
        self.bar.set_position(simulation.steps());
        self.bar.set_message(format!("t = {} s", seconds(simulation.time(), 4)));
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

    /// Wall time spent on steps, on the guard's looks, and on the frames and rows that were due, s.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Scenario;
    use crate::scenario::settings::Settings;

    const FRAME: Duration = Duration::from_nanos(1_000_000_000 / 60);

    fn watch() -> Watch {
        let scenario = Scenario::resolve(&Settings::default(), || 1).unwrap();
        Watch::start(&scenario.build().unwrap(), 1, None, true)
    }

    /// How long after the second of two refreshes that took `elsewhere` the next is due.
    fn rest_after(watch: &mut Watch, elsewhere: Duration) -> Duration {
        for _ in 0..2 {
            watch.next_refresh = Instant::now();
            watch.refresh_if_due(|| Ok::<_, ()>(Some(elsewhere))).unwrap();
        }
        watch.next_refresh.saturating_duration_since(Instant::now())
    }

    #[test]
    fn another_thread_takes_a_twentieth_of_the_time_of_a_run_whose_cores_it_shares() {
        let mut watch = watch();
        for (are_shared, least, most) in [(true, 19.0, 21.0), (false, 3.0, 5.0)] {
            watch.cores_are_shared = are_shared;
            // Twenty times a second, or a fifth of it; a second more or less, since machines stall.
            let rest = rest_after(&mut watch, Duration::from_secs(1)).as_secs_f64();
            assert!((least..most).contains(&rest), "shared: {are_shared}, {rest} s");
        }
        watch.share_cores(usize::MAX);
        assert!(watch.cores_are_shared);
        watch.share_cores(0);
        assert!(!watch.cores_are_shared);
    }

    #[test]
    fn a_refresh_that_was_late_does_not_put_off_the_next() {
        let mut watch = watch();
        watch.cores_are_shared = false;
        let due = Instant::now().checked_sub(FRAME / 2).unwrap();
        watch.next_refresh = due;
        watch.refresh_if_due(|| Ok::<_, ()>(Some(Duration::ZERO))).unwrap();
        // To a microsecond: a frame is no whole number of nanoseconds. Where the test itself was held up it
        // is later, never earlier.
        assert!(watch.next_refresh >= due + FRAME - Duration::from_micros(1));
        assert!(watch.next_refresh <= (due + FRAME + Duration::from_micros(1)).max(Instant::now()));
    }

    #[test]
    fn a_refresh_that_found_the_writer_busy_is_due_again_at_once() {
        let mut watch = watch();
        let mut calls = 0;
        for answer in [None, None, Some(Duration::ZERO), Some(Duration::ZERO)] {
            let refresh = || {
                calls += 1;
                Ok::<_, ()>(answer)
            };
            watch.refresh_if_due(refresh).unwrap();
            if answer.is_some() {
                watch.next_refresh = Instant::now() + Duration::from_secs(60);
            }
        }
        assert_eq!(calls, 3, "twice busy, once written; then it rests");
    }
}
