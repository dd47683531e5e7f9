//! The threads that share a step.
//!
//! A step of ten thousand discs takes a fraction of a millisecond and is shared out twice. Waking a
//! sleeping thread takes a good part of that, so helpers wait for the next piece of work awake, for
//! a while, before they go to sleep.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread::{self, JoinHandle};

/// Looks for work before a thread lets others run, if there is a core for each, and looks after that
/// before a helper goes to sleep.
const LOOKS_AWAKE: u32 = 2_000;
const LOOKS_YIELDING: u32 = 2_000;

type Work<'a> = &'a (dyn Fn(usize) + Sync);

/// Threads kept ready from step to step; of one, nothing is shared out.
pub(super) struct Team {
    desk: Arc<Desk>,
    helpers: Vec<JoinHandle<()>>,
}

/// Where helpers find their work.
#[derive(Default)]
struct Desk {
    work: Mutex<Option<Work<'static>>>,
    /// How many works there have been; it changes once the next lies there.
    works: AtomicUsize,
    /// Helpers that have not done the present one.
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
            thread::Builder::new().name(format!("step {k}")).spawn(move || desk.help(k)).ok()
        };
        let helpers = (1..threads).map_while(hire).collect();
        Self { desk, helpers }
    }

    /// Number of threads.
    pub fn threads(&self) -> usize {
        self.helpers.len() + 1
    }

    /// Does `work` for each of `shares`, at most one a thread, all at once.
    pub fn each<T: Send>(&self, shares: Vec<T>, work: impl Fn(T) + Sync) {
        assert!(shares.len() <= self.threads(), "a share too many");
        if shares.len() < 2 {
            return shares.into_iter().for_each(work);
        }
        let shares: Vec<_> = shares.into_iter().map(|share| Mutex::new(Some(share))).collect();
        self.share_out(&|k| {
            let share = shares.get(k).and_then(|share| locked(share).take());
            if let Some(share) = share {
                work(share);
            }
        });
    }

    /// Does `work(k)` for each thread k, the caller's being 0.
    fn share_out(&self, work: Work) {
        // SAFETY: helpers use `work` only until they have counted themselves out of `busy`, and this
        // function does not return, nor unwind, before all of them have: `Waiting` sees to it.
        #[allow(unsafe_code)]
        let lasting = unsafe { std::mem::transmute::<Work<'_>, Work<'static>>(work) };
        *locked(&self.desk.work) = Some(lasting);
        self.desk.busy.store(self.helpers.len(), Ordering::Relaxed);
        self.desk.works.fetch_add(1, Ordering::Release);
        self.helpers.iter().for_each(|helper| helper.thread().unpark());
        let waiting = Waiting(&self.desk);
        work(0);
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

/// Waits, when dropped, until every helper has done its part.
struct Waiting<'a>(&'a Desk);

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        let mut looks = 0_u32;
        while self.0.busy.load(Ordering::Acquire) > 0 {
            looks += 1;
            if looks < self.0.looks_awake { std::hint::spin_loop() } else { thread::yield_now() }
        }
        *locked(&self.0.work) = None;
    }
}

impl Desk {
    /// What helper `k` does all its life.
    fn help(&self, k: usize) {
        let mut done = 0;
        loop {
            done = self.next_work(done);
            if self.is_closed.load(Ordering::Relaxed) {
                return;
            }
            let work = *locked(&self.work);
            let outcome = work.map(|work| catch_unwind(AssertUnwindSafe(|| work(k))));
            if matches!(outcome, Some(Err(_))) {
                self.has_panicked.store(true, Ordering::Relaxed);
            }
            self.busy.fetch_sub(1, Ordering::Release);
        }
    }

    /// Waits until there have been other than `done` works, and says how many.
    fn next_work(&self, done: usize) -> usize {
        let mut looks = 0_u32;
        loop {
            let works = self.works.load(Ordering::Acquire);
            if works != done {
                return works;
            }
            looks += 1;
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

fn locked<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_is_done_once_whoever_does_it() {
        for threads in [1, 2, 5] {
            let team = Team::of(threads);
            for shares in 0..=threads {
                for _ in 0..200 {
                    let mut sums = vec![0; shares];
                    team.each(sums.iter_mut().enumerate().collect(), |(k, sum)| *sum += k + 1);
                    assert_eq!(sums, (1..=shares).collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn a_panic_of_a_helper_reaches_the_caller_after_all_are_done() {
        let team = Team::of(3);
        let done = AtomicUsize::new(0);
        let outcome = catch_unwind(AssertUnwindSafe(|| {
            team.each(vec![0, 1, 2], |k| {
                assert_ne!(k, 1, "wanted");
                thread::sleep(std::time::Duration::from_millis(20));
                done.fetch_add(1, Ordering::Relaxed);
            });
        }));
        assert!(outcome.is_err());
        assert_eq!(done.into_inner(), 2);
    }
}
