//! The writing of checkpoints.

use std::path::Path;

use super::container::{self, Section};
use super::{Checkpoint, FILE, PREVIOUS, Progress};
use crate::output::OutputError;
use crate::output::replace::replace_durably;
use crate::simulation::state::ArrayView;

/// The sections of a checkpoint of `scenario`, as a scenario file, `progress` and `arrays`: texts first, for
/// `head`.
pub fn sections<'a>(
    scenario: &'a str,
    progress: &Progress,
    arrays: impl IntoIterator<Item = (&'a str, ArrayView<'a>)>,
) -> Vec<(&'a str, Section<'a>)> {
    let progress = toml::to_string(progress).unwrap_or_default(); // plain tables: never fails
    let texts = [("scenario", scenario.into()), ("progress", progress.into())];
    let texts = texts.map(|(name, text)| (name, Section::Text(text)));
    let arrays = arrays.into_iter().map(|(name, array)| (name, Section::Array(array)));
    texts.into_iter().chain(arrays).collect()
}

/// Writes a checkpoint of these `sections` into `folder`, on the disk when this returns. If it fails, what
/// was there is still there. `keep_last` says whether the present latest one is to become the previous one:
/// a damaged one must not take the place of a good one.
pub fn write(
    folder: &Path,
    sections: &[(&str, Section)],
    keep_last: bool,
) -> Result<(), OutputError> {
    let previous = folder.join(PREVIOUS);
    let previous = keep_last.then_some(previous.as_path());
    replace_durably(&folder.join(FILE), previous, |out| container::write(out, sections))
}

impl Checkpoint {
    /// The sections it was read from.
    pub fn sections(&self) -> Vec<(&str, Section<'_>)> {
        let arrays = self.arrays.iter().map(|(name, array)| (name.as_str(), array.into()));
        sections(&self.scenario, &self.progress, arrays)
    }
}
