//! All files of a run: created together before the first step, each written when it is due.

use std::path::PathBuf;

use super::OutputError;
use super::checkpoint::refuse_foreign;
use super::energy::EnergyFile;
use super::live::LiveFrame;
use super::replace::NewFile;
use super::trajectory::Trajectory;
use crate::analysis::energy::EnergyLedger;
use crate::simulation::Simulation;

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
}

/// The files of a run.
pub struct Recorder {
    plan: OutputPlan,
    live: LiveFrame,
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
        refuse_foreign(folder)?;
        std::fs::create_dir_all(folder).map_err(|source| OutputError::Create {
            path: folder.clone(),
            source,
        })?;
        let path = |name: &str| folder.join(name);
        let live = NewFile::create(&path("out.txt"))?;
        let trajectory = NewFile::create(&path("trajectory.txt"))?;
        let energy = match plan.energy_every {
            0 => None,
            _ => Some(NewFile::create(&path("energy.csv"))?),
        };
        live.take_place()?;
        let trajectory = trajectory.take_place()?;
        let energy = match energy {
            Some(file) => {
                let file = EnergyFile::new(file.take_place()?, path("energy.csv"));
                Some((EnergyLedger::open(simulation), file))
            }
            None => None,
        };
        let mut recorder = Self {
            plan: plan.clone(),
            live: LiveFrame {
                path: path("out.txt"),
                side: plan.side,
                border: plan.border,
            },
            trajectory: Trajectory::new(trajectory, path("trajectory.txt"), plan.side),
            energy,
            frame_at: simulation.steps(),
            energy_at: simulation.steps(),
        };
        recorder.write_all(simulation)?;
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
            if self.plan.live_follows_frames {
                self.live.refresh(simulation)?;
            }
        }
        if simulation.steps() >= self.energy_at + self.plan.energy_every {
            self.append_energy(simulation)?;
        }
        Ok(())
    }

    /// Writes the present state to `out.txt`.
    pub fn refresh_live(&self, simulation: &Simulation) -> Result<(), OutputError> {
        self.live.refresh(simulation)
    }

    /// Gives every file the last state, if it does not have it yet.
    pub fn finish(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if self.frame_at < simulation.steps() {
            self.append_frame(simulation)?;
        }
        if self.energy_at < simulation.steps() {
            self.append_energy(simulation)?;
        }
        if let Some((_, file)) = &mut self.energy {
            file.flush()?;
        }
        self.live.refresh(simulation)
    }

    fn write_all(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.append_frame(simulation)?;
        self.append_energy(simulation)?;
        self.live.refresh(simulation)
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
