//! Classroom 50's `result.json`, schema `classroom50/result/v1`:
//! <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>.

use serde_json::{Value, json};

use super::Graded;
use super::words::Words;
use crate::grade::check::Check;
use crate::grade::verdict::Status;

/// What a whole submission is worth: scores are whole numbers there.
pub const MAX_SCORE: u32 = 100;

/// What the runner says of the submission, from its environment; and the time, UTC, ISO 8601.
#[derive(Clone, Debug, Default)]
pub struct Classroom {
    /// `CLASSROOM`.
    pub classroom: String,
    /// `ASSIGNMENT`.
    pub assignment: String,
    /// `SUBMISSION_TAG`.
    pub submission: String,
    /// `COMMIT_URL`.
    pub commit: String,
    /// `RELEASE_URL`.
    pub release: String,
    /// `REVIEW_URL`.
    pub review: String,
    /// When it was graded.
    pub datetime: String,
}

/// Whole numbers: the hundred points are shared among the checks that were judged, the largest remainders
/// first. What a mistake leaves of a check is rounded down, so 100 means that nothing was lost.
pub fn classroom50(graded: &Graded, classroom: &Classroom, words: &Words) -> Value {
    let report = &graded.report;
    let scores: Vec<(f64, f64)> =
        report.checks.iter().map(|(check, status)| report.score(*check, status)).collect();
    let most = shared(&scores.iter().map(|(earned, lost)| earned + lost).collect::<Vec<_>>());
    let (mut score, mut tests) = (0, Vec::new());
    for (((check, status), (earned, lost)), most) in report.checks.iter().zip(&scores).zip(&most) {
        let own = match status {
            Status::Passed => *most,
            // 1e-9: half of two is one, though sums of tenths may say a little less.
            _ if *earned > 0.0 => (f64::from(*most) * earned / (earned + lost) + 1e-9) as u32,
            _ => 0,
        };
        score += own;
        if graded.shown(true).any(|(shown, _)| shown == check) && earned + lost > 0.0 {
            tests.push(test(*check, status, own, *most, words));
        }
    }
    json!({
        "schema": "classroom50/result/v1",
        "classroom": classroom.classroom,
        "assignment": classroom.assignment,
        "submission": classroom.submission,
        "commit": classroom.commit,
        "release": classroom.release,
        "review": classroom.review,
        "datetime": classroom.datetime,
        "score": score,
        "max-score": MAX_SCORE,
        "tests": tests,
    })
}

fn test(check: Check, status: &Status, score: u32, most: u32, words: &Words) -> Value {
    json!({
        "test-name": format!("{}: {}", check.id(), (words.grade.check)(check).title),
        "passed": *status == Status::Passed,
        "score": score,
        "max-score": most,
    })
}

/// [`MAX_SCORE`] shared in the ratio of `parts`; nothing if all of them are 0.
fn shared(parts: &[f64]) -> Vec<u32> {
    let all: f64 = parts.iter().sum();
    if all <= 0.0 {
        return vec![0; parts.len()];
    }
    let exact: Vec<f64> = parts.iter().map(|part| f64::from(MAX_SCORE) * part / all).collect();
    let mut whole: Vec<u32> = exact.iter().map(|part| (part + 1e-9) as u32).collect();
    let mut order: Vec<usize> = (0..parts.len()).filter(|&k| parts[k] > 0.0).collect();
    order.sort_by(|&a, &b| {
        let rest = |k: usize| exact[k] - f64::from(whole[k]);
        rest(b).total_cmp(&rest(a)).then(a.cmp(&b))
    });
    let given: u32 = whole.iter().sum();
    for &k in order.iter().take(MAX_SCORE.saturating_sub(given) as usize) {
        whole[k] += 1;
    }
    whole
}

/// Seconds since 1970 as UTC, ISO 8601.
///
/// ```
/// use parsim2d::sheet::classroom50::utc;
/// assert_eq!(utc(0), "1970-01-01T00:00:00Z");
/// assert_eq!(utc(1_709_210_096), "2024-02-29T12:34:56Z");
/// ```
pub fn utc(seconds: u64) -> String {
    let (days, time) = (seconds / 86_400, seconds % 86_400);
    // Years from March on, so that the leap day is the last: H. Hinnant, "chrono-compatible
    // low-level date algorithms", civil_from_days.
    let z = days + 719_468;
    let (era, day) = (z / 146_097, z % 146_097);
    let year = (day - day / 1460 + day / 36_524 - day / 146_096) / 365;
    let day = day - (365 * year + year / 4 - year / 100);
    let month = (5 * day + 2) / 153;
    let date = day - (153 * month + 2) / 5 + 1;
    let (year, month) = match month < 10 {
        true => (era * 400 + year, month + 3),
        false => (era * 400 + year + 1, month - 9),
    };
    let (hour, minute, second) = (time / 3600, time / 60 % 60, time % 60);
    format!("{year:04}-{month:02}-{date:02}T{hour:02}:{minute:02}:{second:02}Z")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_are_whole_sum_to_a_hundred_and_nothing_gets_nothing() {
        for parts in [&[1.0, 1.0, 1.0][..], &[3.0, 2.0, 0.0, 2.0], &[0.1; 17], &[7.0]] {
            let shares = shared(parts);
            assert_eq!(shares.iter().sum::<u32>(), MAX_SCORE, "{shares:?}");
            for (part, share) in parts.iter().zip(shares) {
                let exact = 100.0 * part / parts.iter().sum::<f64>();
                assert!((f64::from(share) - exact).abs() < 1.0 && (*part > 0.0 || share == 0));
            }
        }
        assert_eq!(shared(&[0.0, 0.0]), [0, 0]);
        assert!(shared(&[]).is_empty());
    }
}
