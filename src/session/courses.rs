//! The runs of a study, side by side.

use std::sync::atomic::{AtomicUsize, Ordering};

use crate::analysis::drift::Course;
use crate::scenario::error::ScenarioError;
use crate::scenario::study::StudyRun;

/// All courses, in the order of `runs`, on as many threads as the machine has. Each run is
/// independent of the others, so that no number depends on the threads.
///
/// # Errors
///
/// That of the first run whose discs cannot be placed.
pub fn courses(
    runs: &[StudyRun],
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Vec<Course>, ScenarioError> {
    // The longest first: a short one fills the gap at the end.
    let mut queue: Vec<usize> = (0..runs.len()).collect();
    queue.sort_by_key(|&k| std::cmp::Reverse(runs[k].particle_steps()));
    let next = AtomicUsize::new(0);
    let work = || {
        let mut done = Vec::new();
        while let Some(&k) = queue.get(next.fetch_add(1, Ordering::Relaxed)) {
            done.push((k, runs[k].course(&progress)));
        }
        done
    };
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    let mut done = std::thread::scope(|scope| {
        let others: Vec<_> = (1..threads).map(|_| scope.spawn(work)).collect();
        let mut done = work();
        for other in others {
            // A panic there is a panic here.
            done.extend(other.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)));
        }
        done
    });
    done.sort_by_key(|&(k, _)| k);
    done.into_iter().map(|(_, course)| course).collect()
}
