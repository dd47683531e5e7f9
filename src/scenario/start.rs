//! Where discs come from: `--start`, a frame of a file.

use std::fs::File;
use std::io::BufReader;
use std::path::Path;
use std::sync::Arc;

use super::error::ScenarioError;
use super::quantity::{Length, Quantity};
use super::range::ABOVE_0;
use super::settings::Settings;
use super::{DiscSource, Scenario};
use crate::number::shortest;
use crate::output::frames::layout::Layout;
use crate::output::frames::{Frame, FrameRow, Reading, Told, read_frame_as};
use crate::particle::Particle;

/// The file and the frame of `FILE[:K]`.
///
/// ```
/// use parsim2d::scenario::start::file_and_frame;
/// assert_eq!(file_and_frame("run/trajectory.txt:3"), ("run/trajectory.txt", Some(3)));
/// assert_eq!(file_and_frame("out.txt"), ("out.txt", None));
/// ```
pub fn file_and_frame(said: &str) -> (&str, Option<usize>) {
    match said.rsplit_once(':') {
        Some((path, k)) if k.parse::<usize>().is_ok() => (path, k.parse().ok()),
        _ => (said, None),
    }
}

/// Reads the discs of `--start FILE[:K]`. Radii come from the file, or are all that of
/// `--radius`; velocities and masses too where there
/// are columns for them, else masses from the scenario. Also the side (m) of the file's box, if it says
/// one.
pub(super) fn read(
    said: &str,
    scenario: &Scenario,
    settings: &Settings,
) -> Result<(DiscSource, Option<f64>), ScenarioError> {
    let (path, frame) = file_and_frame(said);
    let bad_start = |why: String| ScenarioError::BadStart { path: path.into(), why };
    let file = File::open(path).map_err(|why| {
        let hint = if path.contains(':') { "; in FILE:K, K is a whole number from 0" } else { "" };
        bad_start(format!("{why}{hint}"))
    })?;
    let above_0 = |said: Quantity<Length>| ABOVE_0.check("radius", said.si, "--radius 1mm");
    let radius = settings.radius.map(above_0).transpose()?;
    let reading = Reading { columns: settings.columns.clone(), format: None, radius };
    let (frame, Told { remarks, names_columns }) =
        read_frame_as(BufReader::new(file), &reading, frame).map_err(bad_start)?;
    let (has_velocities, has_masses) = (frame.has_velocities(), frame.has_masses());
    let frame_has_radii = frame.has_radii();
    check_conflicts(&frame, settings)?;
    check(&frame).map_err(bad_start)?;
    let notes = remarks.into_iter().map(|remark| format!("{path}: {remark}"));
    let notes = notes
        .chain(missing(path, &frame, scenario))
        .chain(without_radii(path, &frame, scenario))
        .chain(unused(path, &frame, settings))
        .collect();
    let side = frame.side;
    let disc = |row: FrameRow| {
        let mass = row.mass.unwrap_or(scenario.mass);
        let mut disc = Particle::at_rest(row.position, row.radius, mass);
        disc.velocity = row.velocity.unwrap_or_default();
        disc
    };
    let source = DiscSource::Frame {
        said: said.to_owned(),
        columns: settings.columns.clone(),
        discs: Arc::new(frame.rows.into_iter().map(disc).collect()),
        has_velocities,
        has_masses,
        has_radii: frame_has_radii,
        side,
        are_named: names_columns,
        notes,
    };
    Ok((source, side))
}

/// The discs of the first frame of `--start FILE[:K]`, if they can be read.
pub(super) fn first_frame(
    said: &str,
    columns: Option<Layout>,
    radius: Option<f64>,
) -> Option<Vec<Particle>> {
    let (path, _) = file_and_frame(said);
    let reading = Reading { columns, radius, format: None };
    let file = BufReader::new(File::open(path).ok()?);
    let (frame, _) = read_frame_as(file, &reading, Some(0)).ok()?;
    check(&frame).ok()?;
    let disc = |row: &FrameRow| Particle::at_rest(row.position, row.radius, 1.0);
    Some(frame.rows.iter().map(disc).collect())
}

/// What the file says is not to be said again.
fn check_conflicts(frame: &Frame, settings: &Settings) -> Result<(), ScenarioError> {
    let conflict = |other: &str, why: &str| {
        Err(ScenarioError::Conflict { one: "start".into(), other: other.into(), why: why.into() })
    };
    if settings.radius.is_some() && frame.has_radii() {
        return conflict("radius", "both say the radii");
    }
    // A record of a run says `speed = 0.0` where nothing was thrown.
    if settings.speed.is_some_and(|speed| speed.si != 0.0) && frame.has_velocities() {
        return conflict("speed", "the file has velocities");
    }
    Ok(())
}

/// Radii and masses must be above zero.
fn check(frame: &Frame) -> Result<(), String> {
    let hint = "\n  way out: if another column is meant, --columns says which is what, in their order, as r,x,y";
    for row in &frame.rows {
        if row.radius <= 0.0 {
            return Err(format!("a disc has radius {}; it must be above 0{hint}", row.radius));
        }
        if let Some(mass) = row.mass.filter(|&mass| mass <= 0.0) {
            return Err(format!("a disc has mass {mass}; it must be above 0{hint}"));
        }
    }
    Ok(())
}

/// What is said of all discs, and the file says of each.
fn unused(path: &str, frame: &Frame, settings: &Settings) -> Option<String> {
    let mass = settings.mass.filter(|_| frame.has_masses())?.si;
    let differs = frame.rows.iter().any(|row| row.mass != Some(mass));
    let mass = shortest(mass);
    differs.then(|| format!("{path} has the mass of each disc: mass = {mass} kg is not used"))
}

/// That all discs have the radius of the scenario.
fn without_radii(path: &str, frame: &Frame, scenario: &Scenario) -> Option<String> {
    let radius = shortest(scenario.radius);
    (!frame.has_radii())
        .then(|| format!("{path} holds no radii: each disc has {radius} m (--radius)"))
}

/// What the file does not hold, and what is taken for it.
fn missing(path: &str, frame: &Frame, scenario: &Scenario) -> Option<String> {
    let (has_velocities, has_masses) = (frame.has_velocities(), frame.has_masses());
    let motion = match scenario.speed > 0.0 {
        true => format!(
            "all discs are thrown with an rms speed of {} m/s (--speed)",
            shortest(scenario.speed)
        ),
        false => "all discs start at rest".to_owned(),
    };
    let mass = shortest(scenario.mass);
    let (what, taken) = match (has_velocities, has_masses) {
        (true, true) => return None,
        (true, false) => ("no masses", format!("each disc has {mass} kg (--mass)")),
        (false, true) => ("no velocities", motion),
        (false, false) => {
            ("no velocities and no masses", format!("{motion}, with {mass} kg (--mass)"))
        }
    };
    let file = Path::new(path);
    let better = file.with_file_name("trajectory.txt");
    let is_live = file.file_name().is_some_and(|name| name == "out.txt") && better.is_file();
    let better = if is_live { "; trajectory.txt of the same run has both" } else { "" };
    Some(format!("{path} holds {what}: {taken}{better}"))
}
