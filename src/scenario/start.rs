//! Where discs come from: `--start`, a frame of a file.

use std::fs::File;
use std::io::BufReader;
use std::sync::Arc;

use super::error::ScenarioError;
use super::settings::Settings;
use super::{DiscSource, Scenario};
use crate::output::frames::{Frame, FrameRow, read_frame};
use crate::particle::Particle;

/// Reads the discs of `--start FILE[:K]`. Radii and, where there are columns for them,
/// velocities come from the file, masses from the scenario. Also the side (m) of the file's box, if
/// it says one.
pub(super) fn read(
    said: &str,
    scenario: &Scenario,
    settings: &Settings,
) -> Result<(DiscSource, Option<f64>), ScenarioError> {
    let (path, frame) = match said.rsplit_once(':') {
        Some((path, k)) if k.parse::<usize>().is_ok() => (path, k.parse().ok()),
        _ => (said, None),
    };
    let bad_start = |why: String| ScenarioError::BadStart { path: path.into(), why };
    let file = File::open(path).map_err(|why| {
        let hint = if path.contains(':') { "; in FILE:K, K is a whole number from 0" } else { "" };
        bad_start(format!("{why}{hint}"))
    })?;
    let Frame { rows, side, .. } = read_frame(BufReader::new(file), frame).map_err(bad_start)?;
    let has_velocities = rows.iter().any(|row| row.velocity.is_some());
    if settings.speed.is_some() && has_velocities {
        return Err(ScenarioError::Conflict {
            one: "start".into(),
            other: "speed".into(),
            why: "the file has velocities".into(),
        });
    }
    if let Some(row) = rows.iter().find(|row| row.radius <= 0.0) {
        return Err(bad_start(format!("a disc has radius {}; it must be above 0", row.radius)));
    }
    let disc = |row: FrameRow| {
        let mut disc = Particle::at_rest(row.position, row.radius, scenario.mass);
        disc.velocity = row.velocity.unwrap_or_default();
        disc
    };
    let discs = Arc::new(rows.into_iter().map(disc).collect());
    Ok((DiscSource::Frame { said: said.to_owned(), discs, has_velocities }, side))
}
