//! The threads that share a step.
//!
//! A step of a thousand discs takes some microseconds, and one of ten thousand a fraction of a millisecond. Waking a
//! sleeping thread takes a good part of that, so helpers wait for the next piece of work awake, for
//! a while, before they go to sleep. What a helper that comes too late would have done, others have done.
//!
//! One word says all that the threads must agree on: how many works there have been, whether the present one is open, and
//! how many helpers are at it. So a work begins with one store, a helper joins with one exchange, and it ends when the
//! word says that nobody is at it any more.

use std::cell::UnsafeCell;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, AtomicU64, AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, TryLockError};
use std::thread::{self, JoinHandle};

/// Looks for work before a thread lets others run, if there is a core for each, and looks after that
/// before a helper goes to sleep.
const LOOKS_AWAKE: u32 = 2_000;
const LOOKS_YIELDING: u32 = 2_000;

/// In the word: whether helpers may still join, and the number of works. Below them helpers are counted.
const IS_OPEN: u64 = 1 << 31;
const ONE_WORK: u64 = 1 << 32;

type Work<'a> = &'a (dyn Fn() + Sync);

/// Threads kept ready from step to step; of one, nothing is shared out.
pub(super) struct Workers {
    desk: Arc<Desk>,
    helpers: Vec<JoinHandle<()>>,
    /// Held by whoever has work on the desk.
    caller: Mutex<()>,
}

/// Where helpers find their work.
#[derive(Default)]
struct Desk {
    /// The number of works, whether the last is open, and how many helpers are at it.
    word: AtomicU64,
    /// The present work. Written by the holder of `caller` while the word is not open and counts nobody; read by helpers
    /// that are counted.
    work: UnsafeCell<Option<Work<'static>>>,
    has_panicked: AtomicBool,
    is_closed: AtomicBool,
    /// Looks for work before a thread lets others run.
    looks_awake: u32,
}

// SAFETY: `work` is written only while the word lets nobody read it, and handed over by the word: the caller opens it with
// release after writing, a helper joins with acquire before reading and leaves with release after its last use, and the
// caller waits with acquire until all have left before the work ends.
#[allow(unsafe_code)]
unsafe impl Sync for Desk {}

/// Things of which each is handed out once.
struct Shares<'a, T> {
    first: *mut T,
    count: usize,
    next: AtomicUsize,
    of: std::marker::PhantomData<&'a mut [T]>,
}

// SAFETY: each thing goes to one thread (`next` counts up), and may be sent there.
#[allow(unsafe_code)]
unsafe impl<T: Send> Sync for Shares<'_, T> {}

impl<'a, T> Shares<'a, T> {
    fn of(shares: &'a mut [T]) -> Self {
        let (first, count) = (shares.as_mut_ptr(), shares.len());
        Self { first, count, next: AtomicUsize::new(0), of: std::marker::PhantomData }
    }

    /// One that nobody has had yet.
    fn take(&self) -> Option<&'a mut T> {
        let number = self.next.fetch_add(1, Ordering::Relaxed);
        // SAFETY: the slice is borrowed for 'a, `number` is within it, and nobody else gets this number.
        #[allow(unsafe_code)]
        (number < self.count).then(|| unsafe { &mut *self.first.add(number) })
    }
}

impl Workers {
    /// A workers of `threads`, the caller's included; of fewer, if the system gives no more.
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

    /// Does `work` for each of `shares`: the caller and whoever of the workers comes in time take one
    /// after the other, so that nobody waits for a thread that the system does not let run. While the
    /// workers is at another work, the caller does it alone.
    pub fn each<T: Send>(&self, shares: &mut [T], work: impl Fn(&mut T) + Sync) {
        let caller = match self.caller.try_lock() {
            Err(TryLockError::WouldBlock) => None,
            Err(TryLockError::Poisoned(caller)) => Some(caller.into_inner()),
            Ok(caller) => Some(caller),
        };
        let (Some(caller), 2.., 1..) = (&caller, shares.len(), self.helpers.len()) else {
            return shares.iter_mut().for_each(work);
        };
        let shares = Shares::of(shares);
        self.share_out(caller, &|| {
            while let Some(share) = shares.take() {
                work(share);
            }
        });
    }

    /// Does `work` for pieces of `all`, one a thread; it is told which of all is the first of its piece.
    pub fn pieces<T: Send>(&self, all: &mut [T], work: impl Fn(usize, &mut [T]) + Sync) {
        let each = all.len().div_ceil(self.threads()).max(1);
        let mut pieces: Vec<_> = all.chunks_mut(each).enumerate().collect();
        self.each(&mut pieces, |(k, piece)| work(*k * each, piece));
    }

    /// Does `work` here and in every helper that comes before it is done.
    fn share_out(&self, _caller: &MutexGuard<()>, work: Work) {
        let desk = &*self.desk;
        desk.has_panicked.store(false, Ordering::Relaxed);
        // SAFETY: `_caller` keeps a second work from being laid on the desk, and the word has been closed and counting nobody
        // since the last, so nobody reads `work`. A helper uses it only while the word counts it; `Waiting`, which is
        // there before the word is opened, closes it and waits until it counts nobody, before this function returns or
        // unwinds: so nobody uses `work` longer than it lives.
        #[allow(unsafe_code)]
        unsafe {
            *desk.work.get() = Some(std::mem::transmute::<Work<'_>, Work<'static>>(work));
        }
        let waiting = Waiting(desk);
        let word = desk.word.load(Ordering::Relaxed);
        desk.word.store(word.wrapping_add(ONE_WORK) | IS_OPEN, Ordering::SeqCst);
        self.helpers.iter().for_each(|helper| helper.thread().unpark());
        work();
        drop(waiting);
        assert!(!desk.has_panicked.load(Ordering::Relaxed), "a thread of the step has panicked");
    }
}

impl Drop for Workers {
    fn drop(&mut self) {
        self.desk.is_closed.store(true, Ordering::Relaxed);
        self.desk.word.fetch_add(ONE_WORK, Ordering::Release);
        for helper in self.helpers.drain(..) {
            helper.thread().unpark();
            let _ = helper.join(); // its panic was passed on
        }
    }
}

/// When dropped, closes the work and waits until nobody is at it any more.
struct Waiting<'a>(&'a Desk);

impl Drop for Waiting<'_> {
    fn drop(&mut self) {
        self.0.word.fetch_and(!IS_OPEN, Ordering::AcqRel);
        let mut looks = 0_u32;
        while self.0.word.load(Ordering::Acquire) % IS_OPEN > 0 {
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
            if !self.join(done) {
                continue;
            }
            // SAFETY: the word counts this helper, so the work lies there until it leaves.
            #[allow(unsafe_code)]
            let work = unsafe { *self.work.get() };
            if let Err(payload) = catch_unwind(AssertUnwindSafe(|| work.map(|work| work()))) {
                self.has_panicked.store(true, Ordering::Relaxed);
                std::mem::forget(payload); // dropping it might panic once more
            }
            self.word.fetch_sub(1, Ordering::Release);
        }
    }

    /// Joins the work of this number, if it is still open; the word counts this helper from then on.
    fn join(&self, number: u64) -> bool {
        let counted =
            |word: u64| (word / ONE_WORK == number && word & IS_OPEN != 0).then_some(word + 1);
        self.word.fetch_update(Ordering::Acquire, Ordering::Relaxed, counted).is_ok()
    }

    /// Waits until there have been other than `done` works, and says how many.
    fn next_work(&self, done: u64) -> u64 {
        let mut looks = 0_u32;
        loop {
            let works = self.word.load(Ordering::Acquire) / ONE_WORK;
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_share_is_done_once_whoever_does_it() {
        for threads in [1, 2, 5] {
            let workers = Workers::of(threads);
            for shares in 0..=2 * threads {
                for _ in 0..200 {
                    let mut sums: Vec<_> = (0..shares).collect();
                    workers.each(&mut sums, |sum| *sum += 1);
                    assert_eq!(sums, (1..=shares).collect::<Vec<_>>());
                }
            }
        }
    }

    #[test]
    fn pieces_are_all_there_is_and_know_where_they_begin() {
        for (threads, n) in [(1, 0), (1, 5), (3, 2), (3, 3), (3, 10), (8, 9)] {
            let mut all = vec![0; n];
            Workers::of(threads).pieces(&mut all, |first, piece| {
                piece.iter_mut().zip(first..).for_each(|(here, k)| *here += k + 1);
            });
            assert_eq!(all, (1..=n).collect::<Vec<_>>());
        }
    }

    #[test]
    fn who_asks_a_team_at_work_does_it_alone() {
        let workers = Workers::of(3);
        let done = AtomicUsize::new(0);
        workers.each(&mut [(); 6], |()| {
            workers.each(&mut [(); 4], |()| {
                done.fetch_add(1, Ordering::Relaxed);
            });
        });
        assert_eq!(done.into_inner(), 24);
    }

    #[test]
    fn a_panic_reaches_the_caller_once_nobody_is_at_work_and_the_team_goes_on() {
        let workers = Workers::of(3);
        for _ in 0..3 {
            let at_work = AtomicUsize::new(0);
            let outcome = catch_unwind(AssertUnwindSafe(|| {
                workers.each(&mut [0, 1, 2, 3, 4, 5], |k| {
                    at_work.fetch_add(1, Ordering::Relaxed);
                    thread::sleep(std::time::Duration::from_micros(100));
                    at_work.fetch_sub(1, Ordering::Relaxed);
                    assert_ne!(*k, 3, "wanted");
                });
            }));
            assert!(outcome.is_err());
            assert_eq!(at_work.into_inner(), 0);
            let done = AtomicUsize::new(0);
            workers.each(&mut [(); 3], |()| {
                done.fetch_add(1, Ordering::Relaxed);
            });
            assert_eq!(done.into_inner(), 3);
        }
    }
}
