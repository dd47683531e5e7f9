//! What a `submission.toml` says.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use toml::{Table, Value};

use super::{DESCRIPTION, ValidationError};

/// A described submission, with what it has from its base.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Described {
    /// Its folder; not in the file.
    #[serde(skip)]
    pub path: PathBuf,
    /// The submission it is made from, and that one's, the first last; not in the file.
    #[serde(skip)]
    pub bases: Vec<PathBuf>,
    /// The manner of a right one, the mistake of a wrong one.
    pub title: String,
    /// The submission it is made from, relative to the folder above the folder above.
    pub base: Option<String>,
    /// Files that the course asks for.
    pub files: Vec<PathBuf>,
    /// Command that builds; empty: nothing to build.
    pub build: String,
    /// Command that runs.
    pub run: String,
    /// Its arguments: `{n}`, `{seed}` and `{frames}` stand for numbers.
    pub arguments: Vec<String>,
    /// Number of discs.
    pub n: usize,
    /// Number of frames; 0: for ever.
    pub frames: usize,
    /// How frames are written: `overwrite`, `append` or `rename`.
    #[serde(default)]
    pub writes: Option<String>,
    /// Rows after the discs of each frame that are no discs.
    #[serde(default)]
    pub extra_rows: usize,
    /// The name under which it is handed in, if it is not that of its folder.
    pub folder: Option<String>,
    /// Texts exchanged.
    #[serde(default)]
    pub replace: Vec<Replace>,
    /// Files taken away.
    #[serde(default)]
    pub remove: Vec<Remove>,
    /// Symbolic links.
    #[serde(default)]
    pub symlink: Vec<Symlink>,
    /// What the course asks of the discs.
    #[serde(default)]
    pub physics: Physics,
    /// What is expected of the grader.
    pub expected: Expected,
}

/// A text that occurs once in a file, and what comes in its place.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Replace {
    /// The file.
    pub file: PathBuf,
    /// What is there.
    pub from: String,
    /// What comes in its place.
    pub to: String,
}

/// A file that is not handed in.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Remove {
    /// The file.
    pub file: PathBuf,
}

/// A link that is handed in.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Symlink {
    /// Its name.
    pub file: PathBuf,
    /// Where it leads.
    pub target: PathBuf,
}

/// What the course asks of the discs, SI units.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Physics {
    /// Radius, m.
    pub radius: Option<f64>,
    /// `spring` or `hard`.
    pub law: Option<String>,
    /// Damping of the contacts, kg/s.
    pub eta: Option<f64>,
    /// Restitution at a wall.
    pub restitution_wall: Option<f64>,
    /// Restitution of two discs.
    pub restitution_pair: Option<f64>,
    /// Time between frames, s.
    pub frame_s: Option<f64>,
    /// `rest` or `random`.
    pub start: Option<String>,
}

/// What is expected of the grader.
#[derive(Clone, Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expected {
    /// `full`, or nothing.
    pub marks: Option<String>,
    /// The check that must be failed.
    pub check: Option<String>,
    /// The mistake that must be named; none: any.
    pub cause: Option<String>,
    /// Checks that may be failed besides.
    #[serde(default)]
    pub also: Vec<String>,
}

/// What is so where neither a description nor a base of it says another.
const USUAL: &str = r#"
files = ["Makefile", "particle.h", "particle.cpp", "simulation.cpp"]
build = "make"
run = "./parSim2D"
arguments = ["{n}", "{seed}", "{frames}"]
n = 20
frames = 400
"#;

/// Bases upon bases, at most: more are a circle.
const MOST_BASES: usize = 8;

impl Described {
    /// Reads the description in `folder`, and those of what it is made from.
    ///
    /// Fails, naming the file, where one is missing or not as it should be.
    pub fn read(folder: &Path) -> Result<Self, ValidationError> {
        let path = folder.join(DESCRIPTION);
        let mut bases = Vec::new();
        let mut table = table_of(&path)?;
        let mut next = base_of(&table, folder);
        while let Some(base) = next {
            if bases.len() == MOST_BASES {
                return Err(ValidationError::description(&path, "its bases go round in a circle"));
            }
            let below = table_of(&base.join(DESCRIPTION))?;
            next = base_of(&below, &base);
            bases.push(base);
            inherit(&mut table, below);
        }
        let refused = |why: toml::de::Error| ValidationError::description(&path, why.to_string());
        inherit(&mut table, USUAL.parse().map_err(refused)?);
        let described: Self = Value::Table(table).try_into().map_err(refused)?;
        Ok(Self { path: folder.to_owned(), bases, ..described })
    }

    /// The name under which it is handed in.
    pub fn name(&self) -> String {
        let own = self.path.file_name().unwrap_or_default().to_string_lossy();
        self.folder.clone().unwrap_or(own.into_owned())
    }
}

fn table_of(path: &Path) -> Result<Table, ValidationError> {
    let text = fs::read_to_string(path).map_err(ValidationError::file(path))?;
    text.parse().map_err(|why: toml::de::Error| ValidationError::description(path, why.to_string()))
}

fn base_of(table: &Table, folder: &Path) -> Option<PathBuf> {
    let corpus = folder.parent()?.parent()?;
    table.get("base")?.as_str().map(|base| corpus.join(base))
}

/// Settings that are not set are those of what is below; what it was and what was expected of it are not.
fn inherit(table: &mut Table, below: Table) {
    const ITS_OWN: [&str; 6] = ["title", "base", "expected", "replace", "remove", "symlink"];
    for (key, value) in below {
        match (table.get_mut(&key), value) {
            _ if ITS_OWN.contains(&key.as_str()) => {}
            (Some(Value::Table(here)), Value::Table(value)) => {
                value.into_iter().for_each(|(key, value)| {
                    here.entry(key).or_insert(value);
                });
            }
            (Some(_), _) => {}
            (None, value) => {
                table.insert(key, value);
            }
        }
    }
}
