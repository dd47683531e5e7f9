//! Classroom 50's `result.json`, schema `classroom50/result/v1`:
//! <https://github.com/foundation50/classroom50/wiki/Advanced-Autograding>.

use serde_json::{Value, json};

use super::Graded;
use super::words::Words;
use crate::grading::judge::verdict::Status;

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
    /// `REVIEW_URL`; the commit's if there is none.
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
    let (mut tests, mut later) = (Vec::new(), (0, 0));
    for (((check, status), (earned, lost)), most) in report.checks.iter().zip(&scores).zip(&most) {
        let own = match status {
            Status::Passed => *most,
            // 1e-9: half of two is one, though sums of tenths may say a little less.
            _ if *earned > 0.0 => (f64::from(*most) * earned / (earned + lost) + 1e-9) as u32,
            _ => 0,
        };
        if graded.shown(true).any(|(shown, _)| shown == check) {
            let title = format!("{}: {}", check.id(), (words.grade.check)(*check).title);
            tests.push((title, *status == Status::Passed, own, *most));
        } else {
            later = (later.0 + own, later.1 + most);
        }
    }
    // Scores must be the sums of the tests': what is not shown goes into one.
    tests.push((words.hidden_test.to_owned(), later.0 == later.1, later.0, later.1));
    tests.retain(|(.., most)| *most > 0);
    let score: u32 = tests.iter().map(|(.., own, _)| own).sum();
    let most: u32 = tests.iter().map(|(.., most)| most).sum();
    let review = [&classroom.review, &classroom.commit];
    json!({
        "schema": "classroom50/result/v1",
        "classroom": classroom.classroom,
        "assignment": classroom.assignment,
        "submission": classroom.submission,
        "commit": classroom.commit,
        "release": classroom.release,
        "review": review.into_iter().find(|url| !url.is_empty()).map_or("", String::as_str),
        "datetime": submitted(&classroom.submission).unwrap_or_else(|| classroom.datetime.clone()),
        "graded_at": classroom.datetime,
        "score": score,
        "max-score": most,
        "tests": tests.into_iter().map(|test| json!({
            "test-name": test.0, "passed": test.1, "score": test.2, "max-score": test.3,
        })).collect::<Vec<_>>(),
    })
}

/// When it was submitted, from a tag such as `submit/2026-06-01T14-32-05Z-a1b2c3d`: the same whenever it is
/// graded again.
fn submitted(tag: &str) -> Option<String> {
    let time = tag.strip_prefix("submit/")?.get(..20)?;
    let is_digit = |k: usize| time.as_bytes()[k].is_ascii_digit();
    let digits = [0, 1, 2, 3, 5, 6, 8, 9, 11, 12, 14, 15, 17, 18];
    let marks = [(4, "-"), (7, "-"), (10, "T"), (13, "-"), (16, "-"), (19, "Z")];
    let is_time = digits.into_iter().all(is_digit)
        && marks.into_iter().all(|(k, mark)| time.get(k..=k) == Some(mark));
    is_time.then(|| format!("{}:{}:{}", &time[..13], &time[14..16], &time[17..]))
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
/// use parsim2d::grading::feedback::classroom50::utc;
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

    #[test]
    fn the_time_of_submission_is_that_of_its_tag() {
        let time = submitted("submit/2026-06-01T14-32-05Z-a1b2c3d");
        assert_eq!(time.as_deref(), Some("2026-06-01T14:32:05Z"));
        for tag in
            ["", "submit/", "v1.0", "submit/2026-06-01T14-32-05", "submit/2026-06-01 14-32-05Z"]
        {
            assert_eq!(submitted(tag), None, "{tag}");
        }
    }
}
