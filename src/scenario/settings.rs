//! What the user may say, as flags or as keys of a scenario file: one struct for both, from the table of keys.

use clap::{Args, Command};

pub use super::disc_settings::{DiscSettings, PopulationSettings};
pub use super::dt_setting::DtSetting;
use super::error::ScenarioError;
use super::exclusive;
use super::key::Key;
use super::keys::KEYS;
pub use super::keys::Settings;
pub use super::names::{IntegratorName, PlacementName};

/// Flags, one for each key.
impl Args for Settings {
    fn augment_args(command: Command) -> Command {
        command.args(KEYS.iter().map(Key::arg))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl Settings {
    /// Refuses a value that its key does not allow. Discs are checked where they are taken over.
    pub(super) fn check(&self) -> Result<(), ScenarioError> {
        let mut checked = Ok(());
        self.each(&mut |key, said| {
            if let (Ok(()), Some(said)) = (&checked, said) {
                checked = said.check(key);
            }
        });
        checked
    }

    /// Whether the key of this `name` is said.
    pub(super) fn says(&self, name: &str) -> bool {
        let mut is_said = false;
        self.each(&mut |key, said| is_said |= key.name == name && said.is_some());
        is_said
    }

    /// Refuses two choices of one group.
    pub(super) fn check_exclusive(&self) -> Result<(), ScenarioError> {
        for (group, what) in exclusive::GROUPS {
            let mut said = group.iter().filter(|name| self.says_any(name));
            if let (Some(&one), Some(&other)) = (said.next(), said.next()) {
                let why = format!("both say {what}");
                return Err(ScenarioError::Conflict { one: one.into(), other: other.into(), why });
            }
        }
        Ok(())
    }

    /// Whether what a group calls by this `name` is said.
    fn says_any(&self, name: &str) -> bool {
        match name {
            "only [[disc]]" => !self.discs.is_empty() && self.populations.is_empty(),
            "[[disc]]" => !self.discs.is_empty(),
            "[[population]]" => !self.populations.is_empty(),
            key => self.says(key),
        }
    }

    /// Flags over file. A damping, a time step or a choice of discs said in a flag replaces any said
    /// in the file; `--start` replaces all that the file says of them, their speed too.
    pub fn over(self, mut file: Self) -> Self {
        if self.eta.is_some() || self.gamma.is_some() || self.restitution.is_some() {
            (file.eta, file.gamma, file.restitution) = (None, None, None);
        }
        if self.nt.is_some() || self.dt.is_some() {
            (file.nt, file.dt) = (None, None);
        }
        if self.walls.is_some() || self.no_walls.is_some() {
            (file.walls, file.no_walls) = (None, None);
        }
        if self.start.is_some() || self.n.is_some() {
            (file.start, file.columns, file.n) = (None, None, None);
            (file.discs, file.populations) = (Vec::new(), Vec::new());
        }
        if self.start.is_some() {
            (file.radius, file.placement, file.speed) = (None, None, None);
        }
        self.or(file)
    }
}
