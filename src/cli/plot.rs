//! `parsim2d plot`: pictures of what a run wrote, and the gnuplot scripts that draw the same.

mod arguments;
mod error;
mod input;
mod progress;
mod target;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub(super) use self::arguments::PlotArguments;
use self::arguments::{
    ColourName, EnergyArguments, ForcesArguments, FrameArguments, Kind, SpeedsArguments,
    TrajectoryArguments, VelocityArguments,
};
pub(super) use self::error::PlotError;
pub(super) use self::input::FrameFile;
use self::input::{one_file, read_table};
use self::progress::Progress;
pub(super) use self::target::Target;
use super::Failure;
use crate::analysis::energy::LedgerRow;
use crate::figure::animation::{self, Animation};
use crate::figure::forces::{discs, links};
use crate::figure::frame::{Choice, ColourBy, has_velocities};
use crate::figure::paths::{MOST_PATHS, Paths, moments};
use crate::figure::speeds::{Histogram, Moments};
use crate::figure::survey::Survey;
use crate::figure::{drift, energy, forces, frame, paths, speeds, velocity};
use crate::output::frames::Frame;
use crate::output::record;
use crate::scenario::file::read as read_scenario;

/// Draws what was asked for.
pub(super) fn plot(arguments: &PlotArguments) -> Result<ExitCode, Failure> {
    match &arguments.kind {
        Kind::Frame(arguments) => plot_frame(arguments)?,
        Kind::Trajectory(arguments) if arguments.gif => plot_animation(arguments)?,
        Kind::Trajectory(arguments) => plot_trajectory(arguments)?,
        Kind::Energy(arguments) => plot_energy(arguments)?,
        Kind::Velocity(arguments) => plot_velocity(arguments)?,
        Kind::Forces(arguments) => plot_forces(arguments)?,
        Kind::Speeds(arguments) => plot_speeds(arguments)?,
        Kind::Drift(arguments) => {
            let file = one_file("drift", &arguments.files)?;
            plot_drift(file, &Target::new(arguments.out.as_deref(), "drift", "svg")?)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// Draws `drift.csv` and the `drift_energy.csv` beside it.
pub(super) fn plot_drift(file: &Path, target: &Target) -> Result<(), Failure> {
    let rows = read_table(file, "drift", crate::output::drift::read)?;
    let beside = file.with_file_name("drift_energy.csv");
    let curves = read_table(&beside, "drift", crate::output::drift::read_curves)?;
    let data = [target.data(file)?, target.data(&beside)?];
    let script = drift::script(&target.stem, &data[0], &data[1], (&rows, &curves));
    target.write(&drift::figure(&rows, &curves), &script)
}

fn plot_frame(arguments: &FrameArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("frame", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "frame", "svg")?;
    let (index, one) = file.frame(arguments.frame)?;
    let has_velocities = has_velocities(&one);
    let needs_them = arguments.vectors || arguments.colour == Some(ColourName::Speed);
    if needs_them && !has_velocities {
        return Err(
            PlotError::no_velocities(&file.path, "leave out --vectors and --colour speed").into()
        );
    }
    let by = match arguments.colour {
        Some(ColourName::Radius) => ColourBy::Radius,
        Some(ColourName::None) => ColourBy::Nothing,
        Some(ColourName::Speed) => ColourBy::Speed,
        None if has_velocities => ColourBy::Speed,
        None => ColourBy::Nothing,
    };
    let choice = Choice { by, vectors: arguments.vectors };
    let data = target.data(&file.path)?;
    let script = frame::script(&target.stem, &data, index, &one, choice);
    target.write(&frame::figure(&one, choice), &script)
}

/// A look at all frames.
fn survey(file: &FrameFile, until: Option<usize>) -> Result<Survey, Failure> {
    let mut survey = Survey::begin();
    let progress = Progress::begin(None);
    file.each_frame(until, |_, frame| {
        survey.add(&frame);
        progress.advance();
        Ok(())
    })?;
    Ok(survey)
}

fn plot_trajectory(arguments: &TrajectoryArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("trajectory", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "trajectory", "svg")?;
    let survey = survey(&file, arguments.until)?;
    let progress = Progress::begin(Some(survey.frames));
    let data = target.data(&file.path)?;
    let every = arguments.every.get();
    if survey.discs > MOST_PATHS {
        let wanted = moments(survey.frames);
        let mut chosen = Vec::new();
        file.each_frame(arguments.until, |index, frame| {
            progress.advance();
            if wanted.contains(&index) {
                chosen.push((index, frame));
            }
            Ok(())
        })?;
        let script = paths::moments_script(&target.stem, &data, &survey, &chosen);
        return target.write(&paths::moments_figure(&survey, &chosen), &script);
    }
    let (mut drawn, mut last) = (Paths::begin(survey), Frame::default());
    file.each_frame(arguments.until, |index, frame| {
        progress.advance();
        if index % every == 0 || index + 1 == survey.frames {
            drawn.add(frame.clone());
        }
        last = frame;
        Ok(())
    })?;
    let script = paths::script(&target.stem, &data, &survey, &last);
    target.write(&drawn.figure(), &script)
}

fn plot_animation(arguments: &TrajectoryArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("trajectory", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "trajectory", "gif")?;
    let survey = survey(&file, arguments.until)?;
    let progress = Progress::begin(Some(survey.frames));
    let data = target.data(&file.path)?;
    let every = arguments.every.get();
    let (size, fps) = (arguments.size, arguments.fps);
    let script = animation::script(&target.stem, &data, &survey, (every, size, fps));
    let mut trouble = None;
    let picture = target.replace_picture(|out| {
        let mut animation = Animation::begin(out, survey, size, fps)?;
        let done = file.each_frame(arguments.until, |index, frame| {
            progress.advance();
            if index % every == 0 {
                animation.add(index, &frame).map_err(|why| target.failed(why))?;
            }
            Ok(())
        });
        match done {
            Ok(()) => animation.finish(),
            Err(failure) => {
                trouble = Some(failure);
                Err(std::io::ErrorKind::Other.into()) // so that no half picture takes its place
            }
        }
    });
    match trouble {
        Some(failure) => Err(failure),
        None => {
            picture?;
            target.write_script(&script)
        }
    }
}

/// The finite rows of an energy ledger, at least two.
pub(super) fn ledger(path: &Path) -> Result<Vec<LedgerRow>, Failure> {
    let mut rows = read_table(path, "energy", crate::output::energy::read)?;
    let read = rows.len();
    rows.retain(energy::is_finite);
    if rows.len() < 2 {
        let why = format!("{} of its {read} rows are finite; two are needed", rows.len());
        return Err(PlotError::bad_file(path, &why, "another run, with a smaller time step").into());
    }
    if rows.len() < read {
        let left_out = read - rows.len();
        input::remark(&format!(
            "{}: {left_out} rows that are not finite are left out",
            path.display()
        ));
    }
    Ok(rows)
}

fn plot_energy(arguments: &EnergyArguments) -> Result<(), Failure> {
    let target = Target::new(arguments.out.as_deref(), "energy", "svg")?;
    let named = |path: &PathBuf| Ok((path.display().to_string(), ledger(path)?));
    let runs = arguments.files.iter().map(named).collect::<Result<Vec<_>, Failure>>()?;
    let data = arguments.files.iter().map(|path| target.data(path));
    let data = data.collect::<Result<Vec<_>, PlotError>>()?;
    match (runs.as_slice(), data.as_slice()) {
        ([(_, rows)], [data]) => {
            target.write(&energy::figure(rows), &energy::script(&target.stem, data, rows))
        }
        _ => {
            let script = energy::comparison_script(&target.stem, &data, &runs);
            target.write(&energy::comparison(&runs), &script)
        }
    }
}

fn plot_velocity(arguments: &VelocityArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("velocity", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "velocity", "svg")?;
    let (index, one) = file.frame(arguments.frame)?;
    if !has_velocities(&one) {
        return Err(
            PlotError::no_velocities(&file.path, "parsim2d plot frame, which needs none").into()
        );
    }
    let script = velocity::script(&target.stem, &target.data(&file.path)?, index, &one);
    target.write(&velocity::figure(&one), &script)
}

fn plot_forces(arguments: &ForcesArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("forces", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "forces", "svg")?;
    let record = file.path.with_file_name(record::FILE);
    let scenario = arguments.scenario(read_scenario(&record).ok())?;
    let (_, one) = file.frame(arguments.frame)?;
    if !has_velocities(&one) {
        input::remark("the frame has no velocities; dashpots are taken to be at rest");
    }
    let walls = if scenario.walls { forces::walls(&one) } else { Vec::new() };
    let links = links(&discs(&one, scenario.mass), &scenario.law(), &walls);
    let script = forces::script(&target.stem, &one, &links);
    target.write(&forces::figure(&one, &links), &script)
}

/// The speeds of all frames, up to number `until`.
pub(super) fn pooled_speeds(file: &FrameFile, until: Option<usize>) -> Result<Histogram, Failure> {
    let mut moments = Moments::default();
    let mut has_them = true;
    file.each_frame(until, |_, frame| {
        moments.add(&frame);
        has_them &= has_velocities(&frame);
        Ok(())
    })?;
    if !has_them {
        return Err(PlotError::no_velocities(&file.path, "").into());
    }
    let mut histogram = Histogram::new(moments);
    file.each_frame(until, |_, frame| {
        histogram.add(&frame);
        Ok(())
    })?;
    Ok(histogram)
}

fn plot_speeds(arguments: &SpeedsArguments) -> Result<(), Failure> {
    let file = FrameFile::named(one_file("speeds", &arguments.files)?);
    let target = Target::new(arguments.out.as_deref(), "speeds", "svg")?;
    let (time, histogram) = if arguments.pool {
        (None, pooled_speeds(&file, arguments.until)?)
    } else {
        let (_, one) = file.frame(arguments.frame)?;
        if !has_velocities(&one) {
            return Err(PlotError::no_velocities(&file.path, "").into());
        }
        let mut moments = Moments::default();
        moments.add(&one);
        let mut histogram = Histogram::new(moments);
        histogram.add(&one);
        (one.time, histogram)
    };
    let title = histogram.title(time);
    let script = speeds::script(&target.stem, &histogram, &title);
    target.write(&speeds::figure(&histogram, &title), &script)
}
