//! The flags of `parsim2d grade`.

use std::path::PathBuf;

use clap::Args;

use crate::grading::feedback::folder::Format;

#[derive(Args)]
pub(in crate::cli) struct GradeArguments {
    /// Folders handed in: each is copied, built and run in a sandbox, and graded (Linux)
    #[arg(value_name = "SUBMISSION")]
    #[arg(required_unless_present_any = ["frames", "explain", "init_rubric"])]
    #[arg(conflicts_with_all = ["frames", "explain", "init_rubric"])]
    pub submissions: Vec<PathBuf>,
    /// Files of frames, `x y r` a line, blank lines between frames: nothing is built or run
    #[arg(long, value_name = "FILE", num_args = 1..)]
    #[arg(conflicts_with_all = ["explain", "init_rubric"])]
    pub frames: Vec<PathBuf>,
    /// Build and run with limits alone where no sandbox works: student code can then read your files
    #[arg(long, requires = "submissions")]
    pub allow_unsandboxed: bool,
    /// A folder that submissions may read, for tools outside /usr; programs are looked for in its `bin`
    #[arg(long, value_name = "FOLDER", requires = "submissions", value_parser = folder)]
    pub tools: Vec<PathBuf>,
    /// Folders with a submission.toml that says what is wrong with them: does the grader find it?
    #[arg(long, requires = "submissions", conflicts_with = "rubric")]
    pub proof: bool,
    /// The seed programs are given, in place of the rubric's
    #[arg(long, value_name = "N", requires = "submissions")]
    pub seed: Option<u64>,
    /// The numbers and points of the course
    #[arg(long, value_name = "RUBRIC.toml")]
    pub rubric: Option<PathBuf>,
    #[command(flatten)]
    pub sheets: SheetArguments,
    /// Exit with 1 if a submission has less
    #[arg(long, value_name = "PERCENT", value_parser = percent)]
    pub fail_under: Option<f64>,
    /// Submissions graded at once [default: as many as there are processors]
    #[arg(short, long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    pub jobs: Option<u16>,
    /// Say what a check measures, and why; or what a cause means
    #[arg(long, value_name = "CHECK|CAUSE")]
    pub explain: Option<String>,
    /// Print a commented rubric with the usual numbers
    #[arg(long)]
    pub init_rubric: bool,
}

impl GradeArguments {
    /// The files that are read.
    pub fn inputs(&self) -> Vec<PathBuf> {
        self.frames.iter().chain(&self.rubric).cloned().collect()
    }

    /// Submissions graded at once.
    pub fn jobs(&self) -> usize {
        let processors = || std::thread::available_parallelism().map_or(1, usize::from);
        self.jobs.map_or_else(processors, usize::from)
    }
}

/// In which formats results are written, and where to.
#[derive(Args)]
pub(in crate::cli) struct SheetArguments {
    /// One JSON object for each submission, in a list; the same as --format json
    #[arg(long)]
    pub json: bool,
    /// How results are written; more than one with --out-dir
    #[arg(long, value_name = "FORMAT", conflicts_with = "json")]
    pub format: Vec<Format>,
    /// With a small picture of each failure, as SVG in the JSON
    #[arg(long)]
    pub pictures: bool,
    /// Write a page and a JSON file for each submission, and class.html, class.csv, class.json, as each ends.
    /// The tables hold the submissions graded now: a folder whose tables have others is refused
    #[arg(long, value_name = "FOLDER")]
    pub out_dir: Option<PathBuf>,
    /// Let the tables of the class in --out-dir lose submissions that are not graded now; their pages stay
    #[arg(long, requires = "out_dir")]
    pub replace_class: bool,
    /// Write to a file, which appears whole, in place of standard output
    #[arg(long, value_name = "FILE", conflicts_with = "out_dir")]
    pub out: Option<PathBuf>,
}

impl SheetArguments {
    /// The formats asked for, each once; none if none was named.
    pub fn formats(&self) -> Vec<Format> {
        let mut formats = if self.json { vec![Format::Json] } else { Vec::new() };
        for format in &self.format {
            if !formats.contains(format) {
                formats.push(*format);
            }
        }
        formats
    }
}

fn percent(text: &str) -> Result<f64, String> {
    let value: f64 = text.parse().map_err(|_| "not a number".to_owned())?;
    match (0.0..=100.0).contains(&value) {
        true => Ok(value),
        false => Err("per cent, 0 to 100".to_owned()),
    }
}

/// A folder that is there, by its whole name: inside the sandbox `.` is another one.
fn folder(text: &str) -> Result<PathBuf, String> {
    let whole = std::fs::canonicalize(text).map_err(|why| why.to_string())?;
    if whole.is_dir() { Ok(whole) } else { Err("it is no folder".to_owned()) }
}
