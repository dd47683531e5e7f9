//! Wall time during a run: when to look at the clock, when to refresh `out.txt`, how fast to go.

use std::time::{Duration, Instant};

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
pub struct Pace {
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
}

impl Pace {
    /// The clock of a run that steps on so many `threads` from the present state of `simulation` on. Where the
    /// machine has more cores, writing has one of its own.
    pub fn start(simulation: &Simulation, slowdown: Option<f64>, threads: usize) -> Self {
        let mut steps_per_look =
            (PARTICLE_STEPS_PER_LOOK / simulation.n() as u64).max(FEWEST_STEPS_PER_LOOK);
        if let Some(slowdown) = slowdown {
            // Look twice a refresh, so that a slow run moves smoothly.
            let per_look = 0.5 / (REFRESHES_PER_SECOND * slowdown * simulation.dt());
            steps_per_look = steps_per_look.min((per_look as u64).max(1));
        }
        let now = Instant::now();
        let cores = std::thread::available_parallelism().map_or(1, usize::from);
        Self {
            started: now,
            next_refresh: now,
            last_refresh: 0.0,
            cores_are_shared: cores <= threads,
            stepping: Duration::ZERO,
            from: (simulation.steps(), simulation.time()),
            slowdown,
            steps_per_look,
        }
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

    /// Waits, if the run is to be slow, until wall time has caught up or `interrupted` says stop.
    pub fn keep(&self, simulation: &Simulation, interrupted: impl Fn() -> bool) {
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scenario::Scenario;
    use crate::scenario::settings::Settings;

    const FRAME: Duration = Duration::from_nanos(1_000_000_000 / 60);

    fn pace(threads: usize) -> Pace {
        let scenario = Scenario::resolve(&Settings::default(), || 1).unwrap();
        Pace::start(&scenario.build().unwrap(), None, threads)
    }

    /// How long after the second of two refreshes that took `elsewhere` the next is due.
    fn rest_after(pace: &mut Pace, elsewhere: Duration) -> Duration {
        for _ in 0..2 {
            pace.next_refresh = Instant::now();
            pace.refresh_if_due(|| Ok::<_, ()>(Some(elsewhere))).unwrap();
        }
        pace.next_refresh.saturating_duration_since(Instant::now())
    }

    #[test]
    fn another_thread_takes_a_twentieth_of_the_time_of_a_run_whose_cores_it_shares() {
        let mut pace = pace(1);
        for (are_shared, least, most) in [(true, 19.0, 21.0), (false, 3.0, 5.0)] {
            pace.cores_are_shared = are_shared;
            // Twenty times a second, or a fifth of it; a second more or less, since machines stall.
            let rest = rest_after(&mut pace, Duration::from_secs(1)).as_secs_f64();
            assert!((least..most).contains(&rest), "shared: {are_shared}, {rest} s");
        }
        assert!(self::pace(usize::MAX).cores_are_shared);
        assert!(!self::pace(0).cores_are_shared);
    }

    #[test]
    fn a_refresh_that_was_late_does_not_put_off_the_next() {
        let mut pace = pace(1);
        pace.cores_are_shared = false;
        let due = Instant::now().checked_sub(FRAME / 2).unwrap();
        pace.next_refresh = due;
        pace.refresh_if_due(|| Ok::<_, ()>(Some(Duration::ZERO))).unwrap();
        // To a microsecond: a frame is no whole number of nanoseconds. Where the test itself was held up it
        // is later, never earlier.
        assert!(pace.next_refresh >= due + FRAME - Duration::from_micros(1));
        assert!(pace.next_refresh <= (due + FRAME + Duration::from_micros(1)).max(Instant::now()));
    }

    #[test]
    fn a_refresh_that_found_the_writer_busy_is_due_again_at_once() {
        let mut pace = pace(1);
        let mut calls = 0;
        for answer in [None, None, Some(Duration::ZERO), Some(Duration::ZERO)] {
            let refresh = || {
                calls += 1;
                Ok::<_, ()>(answer)
            };
            pace.refresh_if_due(refresh).unwrap();
            if answer.is_some() {
                pace.next_refresh = Instant::now() + Duration::from_secs(60);
            }
        }
        assert_eq!(calls, 3, "twice busy, once written; then it rests");
    }
}
