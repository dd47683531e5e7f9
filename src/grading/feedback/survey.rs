//! A class counted: how many per cent, and which mistakes were made how often.

use std::collections::BTreeMap;

use super::{Entry, Graded};
use crate::grading::judge::check::Check;
use crate::grading::judge::mistake::Mistake;

/// Parts of a hundred in the distribution.
pub const BINS: usize = 10;

/// The submissions that were graded.
pub fn graded(entries: &[Entry]) -> impl Iterator<Item = &Graded> {
    entries.iter().filter_map(|entry| entry.as_ref().ok())
}

/// Every check that some submission came to, in order.
pub fn checks(entries: &[Entry]) -> Vec<Check> {
    let is_asked =
        |check: &Check| graded(entries).any(|graded| graded.report.status(*check).is_some());
    Check::ALL.into_iter().filter(is_asked).collect()
}

/// Submissions by per cent, tens; 100 belongs to the last ten.
pub fn distribution(entries: &[Entry]) -> [usize; BINS] {
    let mut bins = [0; BINS];
    for graded in graded(entries) {
        bins[((graded.report.percent() / 10.0) as usize).min(BINS - 1)] += 1;
    }
    bins
}

/// The median of per cent, if there is a submission.
pub fn median(entries: &[Entry]) -> Option<f64> {
    let mut all: Vec<f64> = graded(entries).map(|graded| graded.report.percent()).collect();
    all.sort_by(f64::total_cmp);
    let (low, high) = (all.get(all.len().checked_sub(1)? / 2)?, all.get(all.len() / 2)?);
    Some((low + high) / 2.0)
}

/// What was done wrong, in which checks, by how many submissions: the most frequent first.
pub fn mistakes(entries: &[Entry]) -> Vec<(Option<Mistake>, Vec<Check>, usize)> {
    type Found = (Vec<Check>, usize);
    let mut counted: BTreeMap<(Option<Mistake>, Option<Check>), Found> = BTreeMap::new();
    for graded in graded(entries) {
        let mut own = BTreeMap::<_, Vec<Check>>::new();
        for (check, failure) in graded.report.failures() {
            // Failures of which no mistake is known have nothing in common but their check.
            let kind = (failure.cause, failure.cause.is_none().then_some(check));
            own.entry(kind).or_default().push(check);
        }
        for (kind, checks) in own {
            let found = counted.entry(kind).or_default();
            found.1 += 1;
            found.0.extend(checks);
        }
    }
    let mut all: Vec<_> = counted
        .into_iter()
        .map(|((mistake, _), (mut checks, count))| {
            checks.sort();
            checks.dedup();
            (mistake, checks, count)
        })
        .collect();
    all.sort_by_key(|(_, _, count)| std::cmp::Reverse(*count));
    all
}
