//! What is to be said of a file that was read: once each.

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
