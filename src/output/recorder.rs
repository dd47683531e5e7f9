//! All files of a run: created together before the first step, each written when it is due.

pub mod continued;

use std::io;
use std::path::{Path, PathBuf};
use std::time::Duration;

use super::OutputError;
use super::checkpoint::{self, refuse_foreign};
use super::energy::EnergyFile;
use super::failure;
use super::live::LiveFrame;
use super::live_writer::LiveWriter;
use super::place::place;
use super::record;
use super::replace::{NewFile, remove_temporaries};
use super::together::take_places;
use super::trajectory::Trajectory;
use super::written::{ENERGY, TRAJECTORY};
use crate::analysis::energy::EnergyLedger;
use crate::simulation::Simulation;

const LIVE: &str = "out.txt";

/// Every file that a run may be writing when it is killed.
const FILES: [&str; 7] =
    [LIVE, TRAJECTORY, ENERGY, record::FILE, failure::FILE, checkpoint::FILE, checkpoint::PREVIOUS];

/// What is to be written, where and how often.
#[derive(Clone, Debug, PartialEq)]
pub struct OutputPlan {
    /// The folder; made if it is not there.
    pub folder: PathBuf,
    /// Steps between frames of `trajectory.txt`.
    pub frame_every: u64,
    /// Whether `out.txt` follows the same steps rather than wall time.
    pub live_follows_frames: bool,
    /// Steps between lines of `energy.csv`; 0 for no ledger.
    pub energy_every: u64,
    /// Side of the box, m.
    pub side: f64,
    /// Radius of the border discs of `out.txt`, m, if they are wanted.
    pub border: Option<f64>,
    /// The scenario of the run, for `last-run.toml`; none is written if it is empty.
    pub record: String,
}

/// The files of a run.
pub struct Recorder {
    plan: OutputPlan,
    live: LiveWriter,
    trajectory: Trajectory,
    energy: Option<(EnergyLedger, EnergyFile)>,
    /// The last step each file has.
    frame_at: u64,
    energy_at: u64,
}

impl Recorder {
    /// Creates all files and writes the state at the start into each. If one cannot be created,
    /// none is: what was in the folder is still there.
    ///
    /// Opens the work ledger of `simulation` if there is to be an `energy.csv`.
    pub fn create(plan: &OutputPlan, simulation: &mut Simulation) -> Result<Self, OutputError> {
        let folder = &plan.folder;
        make_ready(folder)?;
        remove_temporaries(folder, &FILES); // of a run that was killed at its start
        let new = |name: &str| NewFile::create(&folder.join(name));
        let (live, trajectory) = (new(LIVE)?, new(TRAJECTORY)?);
        let energy = if plan.energy_every > 0 { Some(new(ENERGY)?) } else { None };
        let mut record = if plan.record.is_empty() { None } else { Some(new(record::FILE)?) };
        record.as_mut().map_or(Ok(()), |file| file.write(plan.record.as_bytes()))?;

        let path = |name: &str| folder.join(name);
        let energy_file = match &energy {
            Some(new) => {
                Some((EnergyLedger::open(simulation), EnergyFile::new(new.writer()?, path(ENERGY))))
            }
            None => None,
        };
        let frames = Trajectory::new(trajectory.writer()?, path(TRAJECTORY), plan.side);
        let frame = LiveFrame { path: path(LIVE), side: plan.side, border: plan.border };
        let mut recorder = Self {
            plan: plan.clone(),
            live: LiveWriter::new(frame),
            trajectory: frames,
            energy: energy_file,
            frame_at: simulation.steps(),
            energy_at: simulation.steps(),
        };
        recorder.write_start(&live, simulation)?;
        // All have their first frame; only now does anything old go: what a former run left that this one
        // does not replace, too.
        let stale = Stale { record: record.is_none(), energy: energy.is_none(), checkpoints: true };
        let new = [live, trajectory].into_iter().chain(record).chain(energy).collect();
        take_places(new, &stale.names().map(path).collect::<Vec<_>>())?;
        Ok(recorder)
    }

    /// The next step at which a file is due.
    pub fn next_due(&self) -> u64 {
        let frame = self.frame_at + self.plan.frame_every;
        match self.plan.energy_every {
            0 => frame,
            every => frame.min(self.energy_at + every),
        }
    }

    /// Writes what is due at the present step.
    pub fn record_due(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if simulation.steps() >= self.frame_at + self.plan.frame_every {
            self.append_frame(simulation)?;
            self.flush_energy()?; // whole rows for who reads along
            if self.plan.live_follows_frames {
                self.live.refresh(simulation)?;
            }
        }
        if simulation.steps() >= self.energy_at + self.plan.energy_every {
            self.append_energy(simulation)?;
        }
        Ok(())
    }

    /// Takes back what was written of steps after `step`.
    pub fn cut_back_to(&mut self, step: u64) -> Result<(), OutputError> {
        self.frame_at = self.trajectory.cut_back_to(step)?;
        if let Some((_, file)) = &mut self.energy {
            self.energy_at = file.cut_back_to(step)?;
        }
        Ok(())
    }

    /// Has the present state written to `out.txt` while the run goes on, and returns how long another thread
    /// was busy with the frame before; `None`, and nothing is done, if it still is. An error may be that
    /// of the frame before.
    pub fn refresh_live(
        &mut self,
        simulation: &Simulation,
    ) -> Result<Option<Duration>, OutputError> {
        self.live.offer(simulation)
    }

    /// Gives every file the last state, if it does not have it yet.
    pub fn finish(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if self.frame_at < simulation.steps() {
            self.append_frame(simulation)?;
        }
        if self.energy_at < simulation.steps() {
            self.append_energy(simulation)?;
        }
        self.flush_energy()?;
        self.live.refresh(simulation)
    }

    /// Adds what came out of the run to `last-run.toml`, as comments.
    pub fn record_results(&self, results: &[String]) -> Result<(), OutputError> {
        if self.plan.record.is_empty() {
            return Ok(());
        }
        record::write(&self.plan.folder, &self.plan.record, results)
    }

    fn write_start(&mut self, live: &NewFile, simulation: &Simulation) -> Result<(), OutputError> {
        self.append_frame(simulation)?;
        self.append_energy(simulation)?;
        self.flush_energy()?;
        self.live.frame().write_all(live.writer()?, simulation)
    }

    fn flush_energy(&mut self) -> Result<(), OutputError> {
        self.energy.as_mut().map_or(Ok(()), |(_, file)| file.flush())
    }

    fn append_frame(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.frame_at = simulation.steps();
        self.trajectory.append(simulation)
    }

    fn append_energy(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.energy_at = simulation.steps();
        match &mut self.energy {
            Some((ledger, file)) => file.append(&ledger.row(simulation)),
            None => Ok(()),
        }
    }
}

/// Which files of a former run a run in its folder does not replace: they go, for their run is gone, and with them
/// what it said of its end.
struct Stale {
    /// `last-run.toml`.
    record: bool,
    /// `energy.csv`.
    energy: bool,
    /// Checkpoints; a run that goes on where it was keeps them.
    checkpoints: bool,
}

impl Stale {
    fn names(&self) -> impl Iterator<Item = &'static str> {
        let all = [
            (true, failure::FILE),
            (self.checkpoints, checkpoint::FILE),
            (self.checkpoints, checkpoint::PREVIOUS),
            (self.record, record::FILE),
            (self.energy, ENERGY),
        ];
        all.into_iter().filter_map(|(is_stale, name)| is_stale.then_some(name))
    }
}

/// Makes `folder` if it is not there; refuses one in which something is nobody's of ours, or in the way.
fn make_ready(folder: &Path) -> Result<(), OutputError> {
    refuse_foreign(folder)?;
    refuse_in_the_way(folder)?;
    make_folder(folder)
}

/// Refuses a `folder` where something that is no file, or somebody's own, has a name that a run gives to a file: now or
/// later, for a run must not find out at its end.
pub fn refuse_in_the_way(folder: &Path) -> Result<(), OutputError> {
    for path in FILES.map(|name| folder.join(name)) {
        place(&path).map_err(|source| OutputError::InTheWay { path, source })?;
    }
    match record::is_foreign(folder) {
        true => Err(OutputError::ForeignRecord { path: folder.join(record::FILE) }),
        false => Ok(()),
    }
}

/// Makes the folder if it is not there.
pub fn make_folder(folder: &Path) -> Result<(), OutputError> {
    let refuse = |source| OutputError::Create { path: folder.to_owned(), source };
    if folder.exists() && !folder.is_dir() {
        return Err(refuse(io::Error::new(io::ErrorKind::NotADirectory, "it is a file")));
    }
    std::fs::create_dir_all(folder).map_err(refuse)
}
