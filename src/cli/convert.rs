//! `parsim2d convert`: frames of any format that is read, in any that is written.

use std::fs::File;
use std::io::{self, BufReader, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use clap::Args;

use super::failure::Failure;
use super::file_kind::FileKind;
use super::plot::Progress;
use super::refusal::Refusal;
use super::typed::shown;
use crate::output::frames::format::Format;
use crate::output::frames::layout::Layout;
use crate::output::frames::writer::{Target, Writer};
use crate::output::frames::{Frame, Frames, Reading};
use crate::output::place::is_same;
use crate::output::replace::replace;
use crate::scenario::quantity::{Length, Quantity};

pub(super) const EXAMPLES: &str = "\
Examples:
  parsim2d convert trajectory.txt run.xyz          extended XYZ, for OVITO and ASE
  parsim2d convert trajectory.txt run.csv          one table, for pandas and spreadsheets
  parsim2d convert trajectory.txt run.dump         a LAMMPS dump, for OVITO and VMD
  parsim2d convert dump.lammpstrj frames.txt       frames, for --start, plot and gnuplot
  parsim2d convert old.dat frames.txt --columns x,y,-,r   what the columns are, by hand

What is read: frames of runs, tables with a heading of names (# x y r vx vy m, or a first line), CSV,
XYZ and extended XYZ, LAMMPS dumps and data files (atom_style sphere), and the files of Poeschel and
Schwager's book. What a file does not say is left out and told. Numbers keep nine digits.";

#[derive(Args)]
pub(super) struct ConvertArguments {
    /// The file to read
    #[arg(value_name = "IN")]
    input: PathBuf,
    /// The file to write; its ending says the format: .txt .xyz .extxyz .dump .lammpstrj .csv
    #[arg(value_name = "OUT")]
    output: PathBuf,
    /// Format of IN [default: told by how it begins]
    #[arg(long, value_enum, value_name = "FORMAT")]
    from: Option<Format>,
    /// Format of OUT [default: by its ending]
    #[arg(long, value_enum, value_name = "FORMAT")]
    to: Option<Target>,
    /// Only frame K, from 0 [default: all]
    #[arg(long, value_name = "K", conflicts_with = "until")]
    frame: Option<usize>,
    /// Only frames 0 to K [default: all]
    #[arg(long, value_name = "K")]
    until: Option<usize>,
    /// What the columns of IN are, in their order: x, y, r, d (diameter), vx, vy, m, id, and - for one to
    /// pass over [default: by its heading]
    #[arg(long, value_name = "x,y,-,r", allow_hyphen_values = true)]
    columns: Option<Layout>,
    /// Radius of all discs of a file that says none (m; 1mm, 5e-4)
    #[arg(long, value_name = "M", allow_hyphen_values = true)]
    radius: Option<Quantity<Length>>,
    /// No progress, no remarks
    #[arg(short, long)]
    quiet: bool,
}

impl ConvertArguments {
    fn reading(&self) -> Reading {
        let radius = self.radius.map(|radius| radius.si);
        Reading { columns: self.columns.clone(), format: self.from, radius }
    }

    fn target(&self) -> Result<Target, Refusal> {
        self.to.or_else(|| Target::of(&self.output)).ok_or_else(|| Refusal {
            why: format!("the ending of {} means no format that is written", shown(&self.output)),
            way_out: "one of .txt .xyz .extxyz .dump .lammpstrj .csv; or --to frames, xyz, lammps-dump or csv"
                .to_owned(),
        })
    }

    fn refused(&self, why: &str, whole: usize) -> Refusal {
        // Of others the reader says more.
        let is_ours = |kind: &FileKind| {
            use FileKind::{Checkpoint, DriftCurves, DriftStudy, Ledger, Rubric, Scenario};
            matches!(kind, Checkpoint | DriftCurves | DriftStudy | Ledger | Rubric | Scenario)
        };
        let kind = FileKind::of(&self.input).filter(|kind| whole == 0 && is_ours(kind));
        if let Some(kind) = kind {
            return kind.in_place_of("a file of frames", &self.input);
        }
        let why = format!("cannot convert {}: {why}", shown(&self.input));
        match why.split_once("\n  way out: ") {
            Some((why, way_out)) => Refusal { why: why.to_owned(), way_out: way_out.to_owned() },
            None => Refusal {
                why,
                way_out: match whole {
                    0 => "a file that is read (parsim2d convert --help), --columns or --from"
                        .to_owned(),
                    n => format!("frames 0 to {} are whole: --until {}", n - 1, n - 1),
                },
            },
        }
    }

    /// A radius is above zero.
    fn check_radius(&self) -> Result<(), Refusal> {
        let is_one = |radius: f64| radius > 0.0 && radius.is_finite();
        match self.radius.map(|radius| radius.si) {
            Some(radius) if !is_one(radius) => Err(Refusal {
                why: format!("--radius is {radius} m; it must be above 0"),
                way_out: "--radius 1mm".to_owned(),
            }),
            _ => Ok(()),
        }
    }

    /// What became of `--radius` in `frame`.
    fn of_radius(&self, frame: &Frame) -> Option<String> {
        let radius = self.radius?.si;
        Some(match frame.has_radii() {
            true => "has radii: --radius is not used".to_owned(),
            false => format!("holds no radii: each disc has {radius} m (--radius)"),
        })
    }

    /// Which frames are wanted.
    fn wants(&self, index: usize) -> bool {
        self.frame.is_none_or(|k| k == index) && self.until.is_none_or(|k| index <= k)
    }

    /// The last frame that is wanted.
    fn last(&self) -> usize {
        self.frame.or(self.until).unwrap_or(usize::MAX)
    }
}

/// Converts IN to OUT, which appears whole or not at all.
pub(super) fn convert(arguments: &ConvertArguments) -> Result<ExitCode, Failure> {
    let target = arguments.target()?;
    arguments.check_radius()?;
    let input = open(&arguments.input, &arguments.output)?;
    let mut frames =
        Frames::read_as(BufReader::with_capacity(1 << 16, input), &arguments.reading());
    let mut writer = Writer::new(target);
    let mut told = Vec::new();
    let mut refused = None;
    let written = replace(&arguments.output, |out| {
        match write(arguments, &mut frames, &mut writer, &mut told, out)? {
            Some(why) => {
                refused = Some(why);
                Err(io::ErrorKind::Other.into()) // so that no half file takes its place
            }
            None => Ok(()),
        }
    });
    if let Some(refused) = refused {
        return Err(refused.into());
    }
    written?;
    if !arguments.quiet {
        let name = shown(&arguments.input);
        let remarks = frames.remarks().iter().map(|remark| format!("{name}: {remark}"));
        for note in remarks.chain(told.iter().map(|what| format!("{name} {what}"))) {
            let _ = writeln!(io::stderr(), "note: {note}"); // a closed stderr is no failure
        }
        let many = if writer.frames == 1 {
            "1 frame".to_owned()
        } else {
            format!("{} frames", writer.frames)
        };
        writeln!(io::stdout(), "wrote {}: {many}", shown(&arguments.output))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// The input, which the output must not replace.
fn open(input: &Path, output: &Path) -> Result<File, Refusal> {
    let unreadable = |why: &dyn std::fmt::Display| Refusal {
        why: format!("cannot read {}: {why}", shown(input)),
        way_out: "the name of a file of frames, as trajectory.txt".to_owned(),
    };
    if input.is_dir() {
        return Err(unreadable(&"it is a folder"));
    }
    if is_same(input, output) {
        return Err(Refusal {
            why: format!("{} is to be read and written at once", shown(input)),
            way_out: "another name for what is written".to_owned(),
        });
    }
    File::open(input).map_err(|why| unreadable(&why))
}

/// Writes the frames that are wanted, or says why that cannot be done.
fn write(
    arguments: &ConvertArguments,
    frames: &mut Frames<BufReader<File>>,
    writer: &mut Writer,
    told: &mut Vec<String>,
    out: &mut impl Write,
) -> io::Result<Option<Refusal>> {
    let progress = (!arguments.quiet).then(|| Progress::begin(None));
    let mut read = 0;
    for index in 0.. {
        let Some(frame) = frames.next() else { break };
        let frame: Frame = match frame {
            Ok(frame) => frame,
            Err(why) => return Ok(Some(arguments.refused(&why, index))),
        };
        read = index + 1;
        if let Some(progress) = &progress {
            progress.advance();
        }
        if arguments.wants(index) {
            if let Err(why) = writer.fits(&frame) {
                return Ok(Some(arguments.refused(&why, index)));
            }
            for what in arguments.of_radius(&frame).into_iter().chain(writer.missing(&frame)) {
                if !told.contains(&what) {
                    told.push(what);
                }
            }
            writer.add(out, &frame)?;
        }
        if index >= arguments.last() {
            if let Err(why) = frames.check_order_after(&frame) {
                return Ok(Some(arguments.refused(&why, 0)));
            }
            break;
        }
    }
    Ok(match (read, arguments.frame.or(arguments.until)) {
        (0, _) => Some(arguments.refused("it holds no frame", 0)),
        (_, Some(k)) if read <= k => {
            let why = format!("frame {k} was asked for; it holds frames 0 to {}", read - 1);
            Some(arguments.refused(&why, read))
        }
        _ => None,
    })
}
