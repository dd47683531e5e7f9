//! The threads that share a step.
//!
//! A step of ten thousand discs takes a fraction of a millisecond. Waking a
//! sleeping thread takes a good part of that, so helpers wait for the next piece of work awake, for
//! a while, before they go to sleep. What a helper that comes too late would have done, others have done.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, TryLockError};
use std::thread::{self, JoinHandle};

/// Looks for work before a thread lets others run, if there is a core for each, and looks after that
/// before a helper goes to sleep.
const LOOKS_AWAKE: u32 = 2_000;
const LOOKS_YIELDING: u32 = 2_000;

type Work<'a> = &'a (dyn Fn() + Sync);

/// Threads kept ready from step to step; of one, nothing is shared out.
pub(super) struct Team {
    desk: Arc<Desk>,
    helpers: Vec<JoinHandle<()>>,
    /// Held by whoever has work on the desk.
    caller: Mutex<()>,
}

/// Where helpers find their work.
#[derive(Default)]
struct Desk {
    /// The present work, for as long as there is something of it left to do.
    work: Mutex<Option<Work<'static>>>,
    /// How many works there have been; it changes once the next lies there.
    works: AtomicUsize,
    /// Helpers that are at it.
    busy: AtomicUsize,
    has_panicked: AtomicBool,
    is_closed: AtomicBool,
    /// Looks for work before a thread lets others run.
    looks_awake: u32,
}

impl Team {
    /// A team of `threads`, the caller's included; of fewer, if the system gives no more.
    pub fn of(threads: usize) -> Self {
        let cores = thread::available_parallelism().map_or(1, usize::from);
        let looks_awake = if threads > cores { 0 } else { LOOKS_AWAKE };
        let desk = Arc::new(Desk { looks_awake, ..Desk::default() });
        let hire = |k: usize| {
            let desk = desk.clone();
            thread::Builder::new().name(format!("step {k}")).spawn(move || desk.help()).ok()
        };
        let helpers = (1..threads).map_while(hire).collect();
        Self { desk, helpers, caller: Mutex::default() }
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.helpers.len() + 1
    }

    /// Does `work` for each of `shares`: the caller and whoever of the team comes in time take one
    /// after the other, so that nobody waits for a thread that the system does not let run. While the
    /// team is at another work, the caller does it alone.
    pub fn each<T: Send>(&self, shares: Vec<T>, work: impl Fn(T) + Sync) {
        let caller = match self.caller.try_lock() {
            Err(TryLockError::WouldBlock) => None,
            Err(TryLockError::Poisoned(caller)) => Some(caller.into_inner()),
            Ok(caller) => Some(caller),
        };
        let (Some(caller), 2.., 1..) = (&caller, shares.len(), self.helpers.len()) else {
            return shares.into_iter().for_each(work);
        };
        let shares: Vec<_> = shares.into_iter().map(|share| Mutex::new(Some(share))).collect();
        let next = AtomicUsize::new(0);
        self.share_out(caller, &|| {
            while let Some(share) = shares.get(next.fetch_add(1, Ordering::Relaxed)) {
                locked(share).take().into_iter().for_each(&work);
            }
        });
    }

    /// Does `work` for pieces of `all`, one a thread; it is told which of all is the first of its piece.
    pub fn pieces<T: Send>(&self, all: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
        let each = all.len().div_ceil(self.threads()).max(1);
        let pieces = all.chunks_mut(each).enumerate();
        self.each(pieces.collect(), |(k, piece)| work(k * each, piece));
    }

    /// Does `work` here and in every helper that comes before it is done.
    fn share_out(&self, _caller: &MutexGuard<()>, work: Work) {
        // SAFETY: a helper takes `work` from the desk under its lock, counting itself `busy` under the
        // same lock, and uses it until it counts itself out. `Waiting`, which is there before `work` is,
        // takes `work` off the desk and waits until nobody is busy, before this function returns or
        // unwinds. `_caller` keeps a second work from being laid on the desk meanwhile.
        #[allow(unsafe_code)]
        let lasting = unsafe { std::mem::transmute::<Work<'_>, Work<'static>>(work) };
        self.desk.has_panicked.store(false, Ordering::Relaxed);
        let waiting = Waiting(&self.desk);
        *locked(&self.desk.work) = Some(lasting);
        self.desk.works.fetch_add(1, Ordering::Release);
        self.helpers.iter().for_each(|helper| helper.thread().unpark());
        work();
        drop(waiting);
        assert!(
            !self.desk.has_panicked.load(Ordering::Relaxed),
            "a thread of the step has panicked"
        );
    }
}

impl Drop for Team {
    fn drop(&mut self) {
        self.desk.is_closed.store(true, Ordering::Relaxed);
        self.desk.works.fetch_add(1, Ordering::Release);
        for helper in self.helpers.drain(..) {
            helper.thread().unpark();
            let _ = helper.join(); // its panic was passed on
        }
    }
}

/// When dropped, takes the work off the desk and waits until nobody is at it any more.
struct Waiting<'a>(&'a Desk);

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        *locked(&self.0.work) = None;
        let mut looks = 0_u32;
        while self.0.busy.load(Ordering::Acquire) > 0 {
            looks = looks.saturating_add(1);
            if looks < self.0.looks_awake { std::hint::spin_loop() } else { thread::yield_now() }
        }
    }
}

impl Desk {
    /// What a helper does all its life.
    fn help(&self) {
        let mut done = 0;
        loop {
            done = self.next_work(done);
            if self.is_closed.load(Ordering::Relaxed) {
                return;
            }
            let Some(work) = self.take_part() else { continue };
            if let Err(payload) = catch_unwind(AssertUnwindSafe(work)) {
                self.has_panicked.store(true, Ordering::Relaxed);
                std::mem::forget(payload); // dropping it might panic once more
            }
            self.busy.fetch_sub(1, Ordering::Release);
        }
    }

    /// The present work, if it still lies there; whoever takes it is busy from then on.
    fn take_part(&self) -> Option<Work<'static>> {
        let work = locked(&self.work);
        if work.is_some() {
            self.busy.fetch_add(1, Ordering::Relaxed);
        }
        *work
    }

    /// Waits until there have been other than `done` works, and says how many.
    fn next_work(&self, done: usize) -> usize {
        let mut looks = 0_u32;
        loop {
            let works = self.works.load(Ordering::Acquire);
            if works != done {
                return works;
            }
            looks = looks.saturating_add(1);
            if looks < self.looks_awake {
                std::hint::spin_loop();
            } else if looks < self.looks_awake + LOOKS_YIELDING {
                thread::yield_now();
            } else {
                thread::park(); // woken by the next work, also if that came just now
            }
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_is_done_once_whoever_does_it() {
        for threads in [1, 2, 5] {
            let team = Team::of(threads);
            for shares in 0..=2 * threads {
                for _ in 0..200 {
                    let mut sums = vec![0; shares];
                    team.each(sums.iter_mut().enumerate().collect(), |(k, sum)| *sum += k + 1);
                    assert_eq!(sums, (1..=shares).collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn pieces_are_all_there_is_and_know_where_they_begin() {
        for (threads, n) in [(1, 0), (1, 5), (3, 2), (3, 3), (3, 10), (8, 9)] {
            let mut all = vec![0; n];
            Team::of(threads).pieces(&mut all, |first, piece| {
                piece.iter_mut().zip(first..).for_each(|(here, k)| *here += k + 1);
            });
            assert_eq!(all, (1..=n).collect::<Vec<_>>());
        }
    }

    #[test]
    fn who_asks_a_team_at_work_does_it_alone() {
        let team = Team::of(3);
        let done = AtomicUsize::new(0);
        team.each((0..6).collect(), |_: usize| {
            team.each((0..4).collect(), |_: usize| {
                done.fetch_add(1, Ordering::Relaxed);
            });
        });
        assert_eq!(done.into_inner(), 24);
    }

    #[test]
    fn a_panic_reaches_the_caller_once_nobody_is_at_work_and_the_team_goes_on() {
        let team = Team::of(3);
        for _ in 0..3 {
            let at_work = AtomicUsize::new(0);
            let outcome = catch_unwind(AssertUnwindSafe(|| {
                team.each((0..6).collect(), |k| {
                    at_work.fetch_add(1, Ordering::Relaxed);
                    thread::sleep(std::time::Duration::from_micros(100));
                    at_work.fetch_sub(1, Ordering::Relaxed);
                    assert_ne!(k, 3, "wanted");
                });
            }));
            assert!(outcome.is_err());
            assert_eq!(at_work.into_inner(), 0);
            let done = AtomicUsize::new(0);
            team.each((0..3).collect(), |_: i32| {
                done.fetch_add(1, Ordering::Relaxed);
            });
            assert_eq!(done.into_inner(), 3);
        }
    }
}
