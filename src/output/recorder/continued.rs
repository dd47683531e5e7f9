//! The files of a run that goes on from a checkpoint: checked, cut back to its moment, and continued.

use std::fs::{File, OpenOptions};
use std::io::{self, Read};
use std::path::Path;

use super::{FILES, LIVE, OutputPlan, Recorder, Stale, make_ready, refuse_in_the_way};
use crate::analysis::energy::EnergyLedger;
use crate::output::energy::EnergyFile;
use crate::output::growing::Extent;
use crate::output::live::LiveFrame;
use crate::output::live_writer::LiveWriter;
use crate::output::place::{is_same, plain_file};
use crate::output::replace::{NewFile, remove_temporaries};
use crate::output::together::take_places;
use crate::output::trajectory::Trajectory;
use crate::output::written::{ENERGY, TRAJECTORY, Written};
use crate::output::{OutputError, record};
use crate::simulation::Simulation;

impl Recorder {
    /// How far the files have come, once that is on the disk.
    pub fn written(&mut self) -> Result<Written, OutputError> {
        let (ledger_kinetic, energy) = match &mut self.energy {
            Some((ledger, file)) => (ledger.kinetic_at_start(), Some(file.sync()?)),
            None => (0.0, None),
        };
        Ok(Written {
            frame_every: self.plan.frame_every,
            frame_at: self.frame_at,
            energy_every: self.plan.energy_every,
            energy_at: self.energy_at,
            ledger_kinetic_J: ledger_kinetic,
            trajectory: self.trajectory.sync()?,
            energy,
        })
    }

    /// Takes up the files of a run where they were when its checkpoint was `written`. They lie in the folder
    /// `from`; if `plan` names another, they are copied there as far as they are good, and stay as they are.
    ///
    /// Fails, and changes nothing, if one of them is not what that run wrote.
    pub fn resume(
        plan: &OutputPlan,
        simulation: &Simulation,
        from: &Path,
        written: &Written,
    ) -> Result<Self, OutputError> {
        written.check(from)?;
        let folder = &plan.folder;
        let path = |name: &str| folder.join(name);
        let is_here = is_same(from, folder);
        // A checkpoint here may be no good: the run goes on from the other one.
        if is_here { refuse_in_the_way(folder) } else { make_ready(folder) }?;
        // Of a run that was killed; and the only one here is this one.
        remove_temporaries(folder, &FILES);
        let mut new = Vec::new();
        let continued = |name, extent, new: &mut Vec<NewFile>| match is_here {
            true => open(&path(name)),
            false => copy(&from.join(name), extent, &path(name), new),
        };
        // Everything that can fail comes first: where something does, nothing has been touched.
        let trajectory = continued(TRAJECTORY, written.trajectory, &mut new)?;
        let energy =
            written.energy.map(|extent| Ok((continued(ENERGY, extent, &mut new)?, extent)));
        let energy = energy.transpose()?;
        let mut record = NewFile::create(&path(record::FILE))?;
        record.write(plan.record.as_bytes())?;
        let live = LiveFrame { path: path(LIVE), side: plan.side, border: plan.border };
        let first = NewFile::create(&live.path)?;
        live.write_all(first.writer()?, simulation)?;
        new.extend([record, first]);
        let stale = Stale { record: false, energy: energy.is_none(), checkpoints: !is_here };
        take_places(new, &stale.names().map(path).collect::<Vec<_>>())?;

        let (extent, last) = (written.trajectory, written.frame_at);
        let frames = Trajectory::continued(trajectory, path(TRAJECTORY), plan.side, extent, last)?;
        let ledger = EnergyLedger::continued(written.ledger_kinetic_J);
        let energy = energy.map(|(file, extent)| EnergyFile::continued(file, path(ENERGY), extent));
        Ok(Self {
            plan: plan.clone(),
            live: LiveWriter::new(live),
            trajectory: frames,
            energy: energy.transpose()?.map(|file| (ledger, file)),
            frame_at: written.frame_at,
            energy_at: written.energy_at,
        })
    }
}

/// A copy of the file `from`, as far as it is good, to write on; it will take the place of `to` with the other `new`
/// ones.
fn copy(
    from: &Path,
    extent: Extent,
    to: &Path,
    new: &mut Vec<NewFile>,
) -> Result<File, OutputError> {
    let copy = NewFile::create(to)?;
    let mut out = copy.writer()?;
    plain_file(from)
        .and_then(|file| io::copy(&mut file.take(extent.bytes), &mut out))
        .map_err(|source| OutputError::Write { path: to.to_owned(), source })?;
    new.push(copy);
    Ok(out)
}

fn open(path: &Path) -> Result<File, OutputError> {
    OpenOptions::new()
        .read(true)
        .write(true)
        .open(path)
        .map_err(|source| OutputError::Create { path: path.to_owned(), source })
}
