//! The folder of a run before it begins: no other run writes there, and nothing that could go on is lost
//! without a word.

use std::path::{Path, PathBuf};

use super::failure::Failure;
use super::refusal::Refusal;
use super::typed::{quoted, shown};
use crate::output::checkpoint::container::Flaw;
use crate::output::checkpoint::{self, Checkpoint, CheckpointError, refuse_foreign};
use crate::output::failure;
use crate::output::lock::FolderLock;
use crate::output::place::is_same;
use crate::output::recorder::{make_folder, refuse_in_the_way};
use crate::scenario::settings::Settings;
use crate::scenario::start::file_and_frame;
use crate::scenario::{DiscSource, Scenario};

/// A folder to write to.
pub(super) struct Claim {
    folder: PathBuf,
    lock: Option<FolderLock>,
    /// Whether a new run comes, which replaces what is there.
    is_new: bool,
    note: Option<String>,
}

impl Claim {
    /// For a new run in `folder`, which is looked through now, so that a refusal need not wait until discs
    /// are placed, and again when it is locked: a signal may end the program in between, and would leave the
    /// file of the lock.
    pub fn of_new_run(folder: &Path) -> Result<Self, Failure> {
        let mut claim = Self::new(folder, true)?;
        claim.lock = None;
        Ok(claim)
    }

    /// For a run that goes on where it was, and locks the folder before its checkpoint is read.
    pub fn of_same_run(folder: &Path) -> Result<Self, Failure> {
        Self::new(folder, false)
    }

    fn new(folder: &Path, is_new: bool) -> Result<Self, Failure> {
        let mut claim = Self { folder: folder.to_owned(), lock: None, is_new, note: None };
        if folder.is_dir() {
            claim.take()?;
        }
        Ok(claim)
    }

    /// Makes the folder if it is not there, as late as that so that a refused run leaves none, and locks it
    /// if it is not locked yet. Also what is to be said of what it held.
    pub fn complete(&mut self) -> Result<Option<String>, Failure> {
        if self.lock.is_none() {
            make_folder(&self.folder)?;
            self.take()?;
        }
        Ok(self.note.take())
    }

    fn take(&mut self) -> Result<(), Failure> {
        self.lock = Some(FolderLock::take(&self.folder)?);
        if self.is_new {
            refuse_foreign(&self.folder)?;
            refuse_in_the_way(&self.folder)?;
            self.note = replaced(&self.folder)?;
        }
        Ok(())
    }
}

/// What is to be said of the checkpoints in `folder`, which a new run replaces. A run that asked for
/// checkpoints and is not done is not replaced at all.
fn replaced(folder: &Path) -> Result<Option<String>, Failure> {
    let latest = folder.join(checkpoint::FILE);
    let mut damaged = None;
    for path in [latest, folder.join(checkpoint::PREVIOUS)] {
        match Checkpoint::read(&path) {
            Ok(whole) => return of_whole(&path, whole),
            Err(CheckpointError::Flawed { flaw: Flaw::Damaged(why), .. }) if damaged.is_none() => {
                damaged = Some(format!("{} is damaged ({why}) and is replaced", shown(&path)));
            }
            Err(_) => {}
        }
    }
    Ok(damaged)
}

/// The same of the `whole` checkpoint at `path`.
fn of_whole(path: &Path, whole: Checkpoint) -> Result<Option<String>, Failure> {
    let Checkpoint { scenario, progress, mut arrays } = whole;
    let written = &progress.written;
    let Ok((scenario, _)) =
        Scenario::continued(&scenario, &mut arrays, written, Settings::default())
    else {
        return Ok(Some(format!("{} says no possible scenario and is replaced", shown(path))));
    };
    let (step, steps) = (progress.step, scenario.steps());
    let folder = path.parent().unwrap_or(Path::new("."));
    // One that went wrong would go wrong again.
    if step >= steps || failure::is_there(folder) {
        return Ok(None);
    }
    if scenario.output.checkpoint_every.is_none() {
        return Ok(Some(format!("the interrupted run here (step {step} of {steps}) is replaced")));
    }
    let names = [checkpoint::FILE, checkpoint::PREVIOUS].map(|name| folder.join(name));
    let there = names.iter().filter(|path| path.exists()).map(|path| shown(path));
    Err(Failure::Refused(Refusal {
        why: format!(
            "a run that keeps checkpoints is not done here: {} is at step {step} of {steps}, and this run \
             would replace it and its files",
            shown(path)
        ),
        way_out: format!(
            "go on with it: parsim2d resume {}; or another folder: --out-dir; or give it up: remove {}",
            quoted(&shown(path)),
            there.collect::<Vec<_>>().join(" and ")
        ),
    }))
}

/// Refuses a run that starts from a file that it would replace.
pub(super) fn keep_start(scenario: &Scenario) -> Result<(), Failure> {
    let DiscSource::Frame { said, .. } = &scenario.discs else { return Ok(()) };
    let (start, _) = file_and_frame(said);
    let folder = &scenario.output.folder;
    let is_replaced = |name: &str| is_same(Path::new(start), &folder.join(name));
    if !is_replaced("trajectory.txt") && !is_replaced("out.txt") {
        return Ok(());
    }
    Err(Failure::Refused(Refusal {
        why: format!("--start reads {start}, and this run would replace that file"),
        way_out: format!("another folder, as --out-dir next; or give {start} another name"),
    }))
}
