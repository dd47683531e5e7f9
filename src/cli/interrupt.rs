//! Ctrl-C and its kin: once ends the run with complete files, twice ends it at once.

use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

use super::signals::heed;

/// The exit code of an interrupted program.
const INTERRUPTED: i32 = 130;

/// A second signal counts from then on: some programs send each signal twice, to a process and
/// to its group.
const PATIENCE: Duration = Duration::from_secs(1);

/// Whether the run has been asked to stop.
pub(super) struct Interrupt {
    is_raised: Arc<AtomicBool>,
    has_files: Arc<AtomicBool>,
}

impl Interrupt {
    /// Listens to signals from now on. Until files are at stake one of them ends the program.
    pub fn listen() -> Self {
        let (is_raised, has_files) = (Arc::default(), Arc::<AtomicBool>::default());
        let interrupt = Self { is_raised, has_files };
        let (is_raised, has_files) = (interrupt.is_raised.clone(), interrupt.has_files.clone());
        let first = Mutex::new(None::<Instant>);
        heed(move || {
            is_raised.store(true, Ordering::Relaxed);
            let mut first = first.lock().unwrap_or_else(PoisonError::into_inner);
            let first = *first.get_or_insert_with(Instant::now);
            if !has_files.load(Ordering::Relaxed) || first.elapsed() > PATIENCE {
                std::process::exit(INTERRUPTED);
            }
        });
        interrupt
    }

    /// From now on a signal lets the files be finished.
    pub fn finish_files_first(&self) {
        self.has_files.store(true, Ordering::Relaxed);
    }

    /// Whether a signal has come.
    pub fn is_raised(&self) -> bool {
        self.is_raised.load(Ordering::Relaxed)
    }
}
