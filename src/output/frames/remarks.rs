//! What is to be said of a file that was read: once each.

/// What is to be told of a file that was read.
#[derive(Clone, Debug, Default)]
pub struct Told {
    /// What was not certain, and what was left out: sentences.
    pub remarks: Vec<String>,
    /// Whether its columns are named, by the file or by hand.
    pub names_columns: bool,
}

/// Sentences, in the order in which they arose.
#[derive(Clone, Debug, Default)]
pub struct Remarks(Vec<String>);

impl Remarks {
    /// Adds one that is not there yet.
    pub fn add(&mut self, remark: impl Into<String>) {
        let remark = remark.into();
        if !self.0.contains(&remark) {
            self.0.push(remark);
        }
    }

    /// All so far.
    pub fn all(&self) -> &[String] {
        &self.0
    }
}

/// What is to be said of a periodic box.
pub(super) const IS_PERIODIC: &str =
    "its box is periodic: a run from it has walls (--no-walls for none)";

/// What is to be said of a box that is not square.
pub(super) fn no_square(width: f64, height: f64) -> String {
    format!(
        "its box is {width} m by {height} m, not a square: its side is not taken, --side says one"
    )
}

/// What is to be said of a box that has its corner elsewhere.
pub(super) fn no_corner(corner: &[f64]) -> String {
    let [x, y] = [0, 1].map(|axis| corner.get(axis).copied().unwrap_or_default());
    format!(
        "its box begins at ({x} m, {y} m), where ours begins at (0, 0): its side is not taken, and its discs stay \
         where they are"
    )
}
