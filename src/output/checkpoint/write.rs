//! The writing of checkpoints.

use std::path::Path;

use super::container::{self, Content};
use super::{Checkpoint, FILE, PREVIOUS};
use crate::output::OutputError;
use crate::output::replace::replace_durably;

impl Checkpoint {
    /// The checkpoint as sections: texts first, for `head`.
    pub fn sections(&self) -> Vec<(String, Content)> {
        let progress = toml::to_string(&self.progress).unwrap_or_default(); // plain tables: never fails
        let texts = [("scenario", self.scenario.clone()), ("progress", progress)];
        let texts = texts.map(|(name, text)| (name.to_owned(), Content::Text(text)));
        let arrays = self.arrays.iter().cloned();
        texts.into_iter().chain(arrays.map(|(name, array)| (name, Content::Array(array)))).collect()
    }

    /// Writes the checkpoint into `folder`, on the disk when this returns. If it fails, what was there is
    /// still there. `keep_last` says whether the present latest one is to become the previous one: a
    /// damaged one must not take the place of a good one.
    pub fn write(&self, folder: &Path, keep_last: bool) -> Result<(), OutputError> {
        let previous = folder.join(PREVIOUS);
        let previous = keep_last.then_some(previous.as_path());
        replace_durably(&folder.join(FILE), previous, |out| container::write(out, &self.sections()))
    }
}
