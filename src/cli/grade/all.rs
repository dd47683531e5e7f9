//! Grades many submissions at once: one bad one never stops the others.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use crate::grading::feedback::{Entry, Graded, Ungraded};

/// Grades all `submissions`, `jobs` at a time. Tells `ended` of each as it ends, under its number; gives
/// all of them in their order. Whoever cannot be graded, or makes `grade_one` panic, is an entry as well.
///
/// A reason given by `grade_one` goes on a sentence that begins with the name.
pub(super) fn grade_all(
    submissions: impl IntoIterator<Item = PathBuf>,
    jobs: usize,
    grade_one: impl Fn(usize, &Path) -> Result<Graded, String> + Sync,
    ended: impl Fn(usize, &Entry) + Sync,
) -> Vec<Entry> {
    let submissions: Vec<PathBuf> = submissions.into_iter().collect();
    let entries: Vec<Mutex<Option<Entry>>> = submissions.iter().map(|_| Mutex::new(None)).collect();
    let next = AtomicUsize::new(0);
    let work = || {
        while let Some((k, path)) = Some(next.fetch_add(1, Ordering::Relaxed))
            .and_then(|k| submissions.get(k).map(|path| (k, path)))
        {
            let entry = grade_safely(k, path, &grade_one);
            ended(k, &entry);
            *entries[k].lock().unwrap_or_else(PoisonError::into_inner) = Some(entry);
        }
    };
    std::thread::scope(|scope| {
        for _ in 1..jobs.clamp(1, submissions.len().max(1)) {
            scope.spawn(work);
        }
        work();
    });
    let entries =
        entries.into_iter().map(|e| e.into_inner().unwrap_or_else(PoisonError::into_inner));
    let missing = |path: &Path| Err(ungraded(path, "was not come to".to_owned()));
    entries.zip(&submissions).map(|(entry, path)| entry.unwrap_or_else(|| missing(path))).collect()
}

fn grade_safely(
    k: usize,
    path: &Path,
    grade_one: &impl Fn(usize, &Path) -> Result<Graded, String>,
) -> Entry {
    match catch_unwind(AssertUnwindSafe(|| grade_one(k, path))) {
        Ok(Ok(graded)) => Ok(graded),
        Ok(Err(why)) => Err(ungraded(path, why)),
        Err(panic) => Err(ungraded(path, format!("made the grader panic: {}", said(&*panic)))),
    }
}

fn ungraded(path: &Path, why: String) -> Ungraded {
    Ungraded { name: path.display().to_string(), why }
}

fn said(panic: &(dyn Any + Send)) -> &str {
    let text = panic.downcast_ref::<String>().map(String::as_str);
    text.or_else(|| panic.downcast_ref::<&str>().copied()).unwrap_or("without a word")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grading::judge::rubric::Rubric;

    #[test]
    fn bad_ones_stop_nobody_and_the_order_is_the_given_one_with_any_number_of_threads() {
        let names = ["a", "unreadable", "b", "panics", "c", "d", "e"];
        for jobs in [0, 1, 3, 50] {
            let told = Mutex::new(Vec::new());
            let grade_one = |_, path: &Path| match path.to_str() {
                Some("unreadable") => Err("cannot be read".to_owned()),
                Some("panics") => panic!("index {} out of bounds", 7),
                name => Ok(Graded::of_frames(name.unwrap_or_default(), b"", &Rubric::default())),
            };
            let ended = |k, entry: &Entry| told.lock().unwrap().push((k, entry.is_ok()));
            let entries = grade_all(names.map(PathBuf::from), jobs, grade_one, ended);
            let order: Vec<&str> = entries.iter().map(crate::grading::feedback::name_of).collect();
            assert_eq!(order, names);
            let why = |k: usize| entries[k].as_ref().unwrap_err().why.as_str();
            assert_eq!(why(1), "cannot be read");
            assert_eq!(why(3), "made the grader panic: index 7 out of bounds");
            let mut told = told.into_inner().unwrap();
            told.sort_unstable();
            let right = [true, false, true, false, true, true, true];
            assert_eq!(told, right.into_iter().enumerate().collect::<Vec<_>>(), "each told once");
        }
        assert!(grade_all(Vec::new(), 4, |_, _| Err(String::new()), |_, _| {}).is_empty());
    }
}
