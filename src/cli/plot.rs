//! `parsim2d plot`: pictures of what a run wrote, and the gnuplot scripts that draw the same.

mod arguments;
mod error;
mod input;
mod player;
mod progress;
mod target;

use std::path::{Path, PathBuf};
use std::process::ExitCode;

pub(super) use self::arguments::PlotArguments;
use self::arguments::{
    EnergyArguments, ForcesArguments, FrameArguments, HistoryArguments, Kind, OneFrame,
    ReadingArguments, SpeedsArguments, TrajectoryArguments,
};
pub(super) use self::error::bad_out;
use self::error::{bad_file, no_velocities};
pub(super) use self::input::{FrameFile, ledger};
use self::input::{one_file, read_table};
pub(super) use self::progress::Progress;
pub(super) use self::target::Target;
use super::failure::Failure;
use super::refusal::Refusal;
use super::told::Told;
use crate::figure::animation::{self, Animation};
use crate::figure::forces::{discs, links};
use crate::figure::frame::{Choice, ColourBy, has_velocities};
use crate::figure::history::{History, Quantity};
use crate::figure::paths::{MOST_PATHS, Paths, Travel};
use crate::figure::speeds::{Histogram, Moments};
use crate::figure::survey::Survey;
use crate::figure::{drift, energy, forces, frame, paths, speeds, velocity};
use crate::number::shortest;
use crate::output::frames::Frame;
use crate::output::record;
use crate::scenario::settings::Settings;

/// Draws what was asked for.
pub(super) fn plot(arguments: &PlotArguments) -> Result<ExitCode, Failure> {
    match &arguments.kind {
        Kind::Frame(arguments) => plot_frame(arguments)?,
        Kind::Trajectory(arguments) if arguments.gif => plot_animation(arguments)?,
        Kind::Trajectory(arguments) if arguments.html => player::plot(arguments)?,
        Kind::Trajectory(arguments) => plot_trajectory(arguments)?,
        Kind::Energy(arguments) => plot_energy(arguments)?,
        Kind::Velocity(arguments) => plot_velocity(arguments)?,
        Kind::Forces(arguments) => plot_forces(arguments)?,
        Kind::Speeds(arguments) => plot_speeds(arguments)?,
        Kind::History(arguments) => plot_history(arguments)?,
        Kind::Drift(arguments) => {
            let file = one_file("drift", &arguments.files)?;
            plot_drift(file, &Target::new(arguments.out.as_deref(), "drift", "svg")?)?;
        }
    }
    Ok(ExitCode::SUCCESS)
}

/// The one file of frames of a picture of this `kind`.
fn frame_file(
    kind: &'static str,
    files: &[PathBuf],
    reading: &ReadingArguments,
) -> Result<FrameFile, Failure> {
    Ok(FrameFile::with_columns(one_file(kind, files)?, reading.columns.clone()))
}

/// The file of one frame, where its picture goes, and the frame with its number.
fn one_frame(
    kind: &'static str,
    of: &OneFrame,
) -> Result<(FrameFile, Target, usize, Frame), Failure> {
    let file = frame_file(kind, &of.files, &of.reading)?;
    let target = Target::new(of.out.as_deref(), kind, "svg")?;
    let (index, one) = file.frame(of.frame)?;
    Ok((file, target, index, one))
}

/// Draws `drift.csv` and the `drift_energy.csv` beside it.
pub(super) fn plot_drift(file: &Path, target: &Target) -> Result<(), Failure> {
    let rows = read_table(file, "drift", crate::output::drift::read)?;
    let beside = file.with_file_name("drift_energy.csv");
    let curves = read_table(&beside, "drift", crate::output::drift::read_curves)?;
    let script = drift::script(&target.stem, &target.data(file)?, (&rows, &curves));
    target.write(&drift::figure(&rows, &curves), &script)
}

fn plot_frame(arguments: &FrameArguments) -> Result<(), Failure> {
    let (file, target, index, one) = one_frame("frame", &arguments.of)?;
    let has_velocities = has_velocities(&one);
    let needs_them = arguments.vectors || arguments.colour == Some(ColourBy::Speed);
    if needs_them && !has_velocities {
        return Err(no_velocities(&file.path, "leave out --vectors and --colour speed").into());
    }
    let usual = if has_velocities { ColourBy::Speed } else { ColourBy::Nothing };
    let by = arguments.colour.unwrap_or(usual);
    let choice = Choice { by, vectors: arguments.vectors };
    let data = target.data(&file.path)?;
    let script = frame::script(&target.stem, &data, index, &one, choice);
    target.write(&frame::figure(&one, choice), &file.script(script))
}

/// A look at all frames, and how far the discs come in them.
fn survey(file: &FrameFile, until: Option<usize>) -> Result<(Survey, Travel), Failure> {
    let (mut survey, mut travel) = (Survey::begin(), Travel::default());
    let progress = Progress::begin(None);
    file.each_frame(until, |_, frame| {
        survey.add(&frame);
        travel.add(&frame);
        progress.advance();
        Ok(())
    })?;
    Ok((survey, travel))
}

fn plot_trajectory(arguments: &TrajectoryArguments) -> Result<(), Failure> {
    let file = frame_file("trajectory", &arguments.files, &arguments.reading)?;
    let target = Target::new(arguments.out.as_deref(), "trajectory", "svg")?;
    let (survey, travel) = survey(&file, arguments.until)?;
    let progress = Progress::begin(Some(survey.frames));
    let data = target.data(&file.path)?;
    let every = arguments.every.get();
    if survey.discs > MOST_PATHS {
        let wanted = travel.moments();
        let mut chosen = Vec::new();
        file.each_frame(arguments.until, |index, frame| {
            progress.advance();
            if wanted.contains(&index) {
                chosen.push((index, frame));
            }
            Ok(())
        })?;
        let script = paths::moments_script(&target.stem, &data, &survey, &chosen);
        return target.write(&paths::moments_figure(&survey, &chosen), &file.script(script));
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
    target.write(&drawn.figure(), &file.script(script))
}

fn plot_animation(arguments: &TrajectoryArguments) -> Result<(), Failure> {
    let file = frame_file("trajectory", &arguments.files, &arguments.reading)?;
    let target = Target::new(arguments.out.as_deref(), "trajectory", "gif")?;
    let (survey, _) = survey(&file, arguments.until)?;
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
            target.write_script(&file.script(script))
        }
    }
}

fn plot_energy(arguments: &EnergyArguments) -> Result<(), Failure> {
    let target = Target::new(arguments.out.as_deref(), "energy", "svg")?;
    let named = |path: &PathBuf| Ok((path.display().to_string(), ledger(path)?));
    let runs = arguments.files.iter().map(named).collect::<Result<Vec<_>, Failure>>()?;
    let data = arguments.files.iter().map(|path| target.data(path));
    let data = data.collect::<Result<Vec<_>, Refusal>>()?;
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

fn plot_velocity(arguments: &OneFrame) -> Result<(), Failure> {
    let (file, target, index, one) = one_frame("velocity", arguments)?;
    if !has_velocities(&one) {
        return Err(no_velocities(&file.path, "parsim2d plot frame, which needs none").into());
    }
    let script = velocity::script(&target.stem, &target.data(&file.path)?, index, &one);
    target.write(&velocity::figure(&one), &file.script(script))
}

fn plot_forces(arguments: &ForcesArguments) -> Result<(), Failure> {
    let (file, target, _, one) = one_frame("forces", &arguments.of)?;
    let scenario = arguments.scenario(law_beside(&file, &one, arguments))?;
    if !has_velocities(&one) {
        input::remark("the frame has no velocities; dashpots are taken to be at rest");
    }
    match (one.has_masses(), arguments.mass) {
        (false, _) => input::remark(&format!(
            "the frame has no masses; each disc is taken to have {} kg (--mass)",
            shortest(scenario.mass)
        )),
        (true, Some(_)) => input::remark("the frame has the mass of each disc; --mass is not used"),
        (true, None) => {}
    }
    let walls = if scenario.walls { forces::walls(&one) } else { Vec::new() };
    let links = links(&discs(&one, scenario.mass), &scenario.law(), &walls);
    let script = forces::script(&target.stem, &one, &links);
    target.write(&forces::figure(&one, &links), &script)
}

/// What the record beside the file says, if it is that of the run whose `frame` is drawn. Without one the
/// flags must say the law; what they leave open is told.
fn law_beside(file: &FrameFile, frame: &Frame, arguments: &ForcesArguments) -> Option<Settings> {
    let record = file.path.with_file_name(record::FILE);
    let told = Told::read(&record).and_then(|told| told.of(frame, arguments.of.frame.is_none()));
    let why = match told {
        Ok(Told { said: Ok((settings, _)), .. }) => return Some(settings),
        Ok(Told { said: Err(why), .. }) => why.to_string(),
        Err(why) => why.to_string(),
    };
    if !arguments.says_all(frame.has_masses()) {
        let preset = arguments.preset.unwrap_or_default();
        let mass = if frame.has_masses() { "" } else { "--mass, " };
        input::remark(&format!(
            "{} does not tell of these frames ({why}): what of {mass}--kn, --eta is not said is taken from the \
             preset {}",
            record.display(),
            preset.name()
        ));
    }
    None
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
        return Err(no_velocities(&file.path, "").into());
    }
    let mut histogram = Histogram::new(moments);
    file.each_frame(until, |_, frame| {
        histogram.add(&frame);
        Ok(())
    })?;
    Ok(histogram)
}

fn plot_speeds(arguments: &SpeedsArguments) -> Result<(), Failure> {
    let file = frame_file("speeds", &arguments.of.files, &arguments.of.reading)?;
    let target = Target::new(arguments.of.out.as_deref(), "speeds", "svg")?;
    let (time, histogram) = if arguments.pool {
        (None, pooled_speeds(&file, arguments.until)?)
    } else {
        let (_, one) = file.frame(arguments.of.frame)?;
        if !has_velocities(&one) {
            return Err(no_velocities(&file.path, "").into());
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

/// Of so few discs the histories of all are drawn, if none is named.
const FEW: usize = 8;

fn plot_history(arguments: &HistoryArguments) -> Result<(), Failure> {
    let file = FrameFile::with_columns(&arguments.file, arguments.reading.columns.clone());
    let target = Target::new(arguments.out.as_deref(), "history", "svg")?;
    let (_, first) = file.frame(Some(0))?;
    let n = first.rows.len();
    let quantities: Vec<Quantity> = match arguments.quantities[..] {
        [] => vec![Quantity::Y],
        ref said => said.to_vec(),
    };
    let discs = match arguments.disc[..] {
        [] => (0..if n <= FEW { n } else { 1 }).collect(),
        ref said => said.to_vec(),
    };
    if let Some(disc) = discs.iter().find(|disc| **disc >= n) {
        let last = n.saturating_sub(1);
        let why = format!("disc {disc} was asked for; its frames hold discs 0 to {last}");
        return Err(bad_file(&file.path, &why, &format!("--disc {last}")).into());
    }
    if quantities.iter().any(|quantity| quantity.is_of_velocity()) && !has_velocities(&first) {
        return Err(no_velocities(&file.path, "x and y only").into());
    }
    let mut history = History::begin(discs, quantities);
    file.each_frame(arguments.until, |_, frame| {
        history.add(&frame);
        Ok(())
    })?;
    target.write(&history.figure(), &history.script(&target.stem))
}
