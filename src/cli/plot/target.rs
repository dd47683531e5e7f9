//! Where a picture goes, and its gnuplot script beside it.

use std::fs::{self, File};
use std::io::{self, BufWriter, Write};
use std::path::{Component, Path, PathBuf};

use super::error::{bad_out, unreadable};
use crate::cli::failure::Failure;
use crate::cli::refusal::Refusal;
use crate::echo;
use crate::figure::Figure;
use crate::figure::gnuplot::DataFile;
use crate::output::OutputError;
use crate::output::place::{folder_of, place};
use crate::output::replace::replace;

/// The two files that are written.
pub struct Target {
    picture: PathBuf,
    script: PathBuf,
    /// Name of both without their endings.
    pub stem: String,
    /// Whether nothing is to be said of what was written.
    is_silent: bool,
}

impl Target {
    /// The files `out`, or `kind` with the `ending` of the picture in the current folder.
    pub fn new(out: Option<&Path>, kind: &str, ending: &str) -> Result<Self, Refusal> {
        let usual = PathBuf::from(format!("{kind}.{ending}"));
        let picture = out.map_or(usual, Path::to_owned);
        let bad = |why: &str, way_out: String| bad_out(&picture, why, way_out);
        let said = picture.extension().map(|said| said.to_string_lossy().to_lowercase());
        if said.as_deref() != Some(ending) {
            return Err(bad(
                &format!("this picture is a .{ending} file"),
                format!(
                    "--out {}; for PNG and PDF run the script: gnuplot -e \"out='{kind}.pdf'\" {kind}.gp",
                    echo::path(picture.with_extension(ending))
                ),
            ));
        }
        if picture.is_dir() {
            return Err(bad("it is a folder", format!("--out FILE.{ending}")));
        }
        let folder = folder_of(&picture);
        if !folder.is_dir() {
            let folder = echo::path(folder);
            return Err(bad(
                &format!("there is no folder {folder}"),
                format!("make it: mkdir {folder}"),
            ));
        }
        let stem = picture.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        let script = picture.with_extension("gp");
        for file in [&picture, &script] {
            let why =
                |why| bad(&format!("{}: {why}", echo::path(file)), "another --out".to_owned());
            place(file).map_err(why)?;
        }
        Ok(Self { script, picture, stem, is_silent: false })
    }

    /// The same, saying nothing of what was written if `is_silent`.
    pub fn silent(self, is_silent: bool) -> Self {
        Self { is_silent, ..self }
    }

    /// How the script names a data file: from its own folder, so that both may be moved together.
    pub fn data(&self, file: &Path) -> Result<DataFile, Refusal> {
        let unreadable = |source| unreadable(file, &source, "parsim2d");
        let file = fs::canonicalize(file).map_err(unreadable)?;
        for target in [&self.picture, &self.script] {
            if fs::canonicalize(target).is_ok_and(|target| target == file) {
                let why = format!("{} is what is to be drawn", echo::path(target));
                return Err(bad_out(&self.picture, &why, "another --out"));
            }
        }
        let folder = fs::canonicalize(folder_of(&self.script)).map_err(unreadable)?;
        Ok(match relative(&folder, &file) {
            Some(path) => DataFile { path, is_relative: true },
            None => DataFile { path: file.to_string_lossy().into_owned(), is_relative: false },
        })
    }

    /// Writes a figure and its script, and says so.
    pub fn write(&self, figure: &Figure, script: &str) -> Result<(), Failure> {
        self.replace_picture(|out| out.write_all(figure.to_svg().as_bytes()))?;
        self.write_script(script)
    }

    /// Writes the picture by `draw`.
    pub fn replace_picture(
        &self,
        draw: impl FnOnce(&mut BufWriter<File>) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        replace(&self.picture, draw)
    }

    /// Writes a page, which has no script of gnuplot's beside it, and says so.
    pub fn write_page(&self, html: &str) -> Result<(), Failure> {
        self.replace_picture(|out| out.write_all(html.as_bytes()))?;
        Ok(writeln!(io::stdout(), "wrote {}", self.picture.display())?)
    }

    /// The picture could not be written.
    pub fn failed(&self, source: io::Error) -> OutputError {
        OutputError::Write { path: self.picture.clone(), source }
    }

    /// Writes the script, the second of the two, and says what has been written.
    pub fn write_script(&self, script: &str) -> Result<(), Failure> {
        replace(&self.script, |out| out.write_all(script.as_bytes()))?;
        if self.is_silent {
            return Ok(());
        }
        let (picture, script) = (echo::path(&self.picture), echo::path(&self.script));
        Ok(writeln!(io::stdout(), "wrote {picture} and {script}")?)
    }
}

/// The way from `folder` to `file`, both absolute, with `/` between its steps; none from one drive
/// of Windows to another.
fn relative(folder: &Path, file: &Path) -> Option<String> {
    let (from, to): (Vec<_>, Vec<_>) = (folder.components().collect(), file.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    if common == 0 {
        return None;
    }
    let up = from[common..].iter().map(|_| "..".into());
    let down = to[common..].iter().map(|step: &Component| step.as_os_str().to_string_lossy());
    Some(up.chain(down).collect::<Vec<_>>().join("/"))
}
