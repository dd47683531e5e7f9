//! What a student's functions give for the numbers of a case, beside what they should give.

use super::mistake::Mistake;
use super::rubric::interface::Case;
use super::verdict::{Failure, Status, Verdict};
use super::words::{ENGLISH, Finding, Quantity};

/// The verdict on one case from what the probe printed.
///
/// Its last numbers count, as many as are expected: what a student's own functions print comes before.
///
/// ```
/// use parsim2d::grading::judge::{interface::verdict, rubric::interface::Case, verdict::Status};
/// let case = Case {
///     name: "two discs".to_owned(),
///     stdin: String::new(),
///     expected: vec![25.0, 0.0],
///     tolerance: 1e-5,
///     hint: None,
/// };
/// assert_eq!(verdict(&case, "here 3\n25.0001 -0.0002\n"), Status::Passed); // to 1e-5 of 25
/// assert!(matches!(verdict(&case, "-25 0\n"), Status::Failed(_)));
/// ```
pub fn verdict(case: &Case, printed: &str) -> Verdict {
    let numbers: Vec<f64> =
        printed.split_whitespace().filter_map(|word| word.parse().ok()).collect();
    let Some(first) = numbers.len().checked_sub(case.expected.len()) else {
        let failure = Failure::of(Finding::TooFewNumbers, Mistake::InterfaceWrong);
        let failure = failure.with(Quantity::Numbers, numbers.len() as f64);
        let failure = failure.with(Quantity::NumbersWanted, case.expected.len() as f64);
        return Status::Failed(failure.in_case(case, printed));
    };
    let came = &numbers[first..];
    let is_right = |(came, expected): (&f64, &f64)| (came - expected).abs() <= case.slack();
    if came.iter().zip(&case.expected).all(is_right) {
        return Status::Passed;
    }
    let mut failure = Failure::of(Finding::OtherNumbers, Mistake::InterfaceWrong);
    for (came, expected) in came.iter().zip(&case.expected).filter(|pair| !is_right(*pair)) {
        failure = failure.with(Quantity::Came, *came).with(Quantity::Expected, *expected);
    }
    Status::Failed(failure.in_case(case, ""))
}

impl Failure {
    /// A probe that cannot be built with what was handed in; `log` is what the build printed.
    pub fn interface_missing(log: &str) -> Self {
        Self::of(Finding::ProbeNotBuilt, Mistake::InterfaceMissing).saying(log)
    }

    /// A probe that did not end well in a case; `log` is what it printed.
    pub fn probe_ends_badly(case: &Case, log: &str) -> Self {
        Self::of(Finding::ProbeEndsBadly, Mistake::InterfaceWrong).in_case(case, log)
    }

    /// With the case, its own hint, and what was printed.
    fn in_case(self, case: &Case, printed: &str) -> Self {
        let [named, given, hint] = ENGLISH.case;
        let mut said = format!("{named}: {}\n{given}: {}", case.name, case.stdin.trim());
        if let Some(own) = &case.hint {
            said += &format!("\n{hint}: {own}");
        }
        self.saying(&format!("{said}\n{printed}"))
    }
}
