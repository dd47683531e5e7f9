//! The reading of checkpoints.

use std::io::{self, BufReader};
use std::path::Path;

use super::container::{self, Content, Flaw};
use super::{Checkpoint, CheckpointError, Progress};
use crate::output::place::plain_file;
use crate::output::written::Written;

impl Checkpoint {
    /// Reads the checkpoint at `path`.
    pub fn read(path: &Path) -> Result<Self, CheckpointError> {
        let sections = || {
            let file = plain_file(path)?;
            let size = file.metadata()?.len();
            container::read_from(BufReader::new(file), size)
        };
        let sections: io::Result<_> = sections();
        sections
            .map_err(|source| CheckpointError::Unreadable { path: path.to_owned(), source })?
            .and_then(Self::from_sections)
            .map_err(|flaw| CheckpointError::Flawed { path: path.to_owned(), flaw })
    }

    /// A checkpoint from the bytes of its file.
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Flaw> {
        Self::from_sections(container::read(bytes)?)
    }

    fn from_sections(sections: Vec<(String, Content)>) -> Result<Self, Flaw> {
        let (mut scenario, mut progress, mut arrays) = (None, None, Vec::new());
        for (name, content) in sections {
            match (name.as_str(), content) {
                ("scenario", Content::Text(text)) => scenario = Some(text),
                ("progress", Content::Text(text)) => progress = Some(text),
                (_, Content::Array(array)) => arrays.push((name, array)),
                (_, Content::Text(_)) => {
                    return Err(Flaw::Damaged(format!("it has an unknown text, {name}")));
                }
            }
        }
        let missing = |what: &str| Flaw::Damaged(format!("it has no section {what}"));
        let progress = progress.ok_or_else(|| missing("progress"))?;
        let progress: Progress = toml::from_str(&progress)
            .map_err(|why| Flaw::Damaged(format!("section progress: {}", why.message())))?;
        if !progress.is_possible() {
            return Err(Flaw::Damaged(
                "section progress: its steps do not fit together".to_owned(),
            ));
        }
        let scenario = scenario.ok_or_else(|| missing("scenario"))?;
        Ok(Self { scenario, progress, arrays })
    }
}

impl Progress {
    /// Whether the last frame and line are of this step or before, and the next ones after it.
    fn is_possible(&self) -> bool {
        let Written { frame_every, frame_at, energy_every, energy_at, .. } = self.written;
        let fits = |at: u64, every: u64| {
            at <= self.step && at.checked_add(every).is_some_and(|next| next > self.step)
        };
        fits(frame_at, frame_every) && (energy_every == 0 || fits(energy_at, energy_every))
    }
}
