//! What all gnuplot scripts share: names in quotes, where files are, what picture is wanted.
//!
//! A script written beside a picture draws the same picture: `gnuplot energy.gp` writes
//! `energy.png`, `gnuplot -e "out='energy.pdf'" energy.gp` a PDF. Paths in it are relative to its
//! own folder, from wherever gnuplot is started (gnuplot 5.4 names the script in `ARG0`).

use std::fmt::Write;

/// `text` as a string of gnuplot: in single quotes, inside which nothing but the quote itself has a
/// meaning.
///
/// ```
/// // The quote by itself, between double ones: two in a row would begin another string at the start.
/// assert_eq!(parsim2d::figure::gnuplot::quoted("it's"), "'it'.\"'\".'s'");
/// ```
pub fn quoted(text: &str) -> String {
    // Two single quotes are one inside a string, but not right after its beginning.
    let text =
        text.replace('\'', "'.\"'\".'").replace('\n', "'.\"\\n\".'").replace('\r', "'.\"\\r\".'");
    format!("'{text}'")
}

/// A file that a script reads.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct DataFile {
    /// Its path from the script's folder, or an absolute one.
    pub path: String,
    /// Whether the path is relative to the script's folder.
    pub is_relative: bool,
}

impl DataFile {
    /// The expression of gnuplot that names it. Relative names begin with the folder or `./`, so that
    /// a name like `<ls` is no command.
    pub fn expression(&self) -> String {
        if self.is_relative { format!("folder.{}", quoted(&self.path)) } else { quoted(&self.path) }
    }
}

/// The beginning of a script named `stem`.gp that draws pictures of `size` pixels, called `what` in
/// its first line: where it is, what terminal draws the `out` that is wanted.
pub fn head(stem: &str, what: &str, (width, height): (f64, f64), endings: &str) -> String {
    let name = format!("{stem}.gp");
    let usual = endings.split(' ').next().unwrap_or("png");
    // A line break in a comment would end it.
    let shown = name.replace(['\n', '\r'], " ");
    let mut text = format!("# {what}. To draw it: gnuplot {shown}\n");
    if usual == "png" {
        let _ = writeln!(text, "# As a PDF: gnuplot -e \"out='picture.pdf'\" {shown}"); // into memory
    }
    let _ = write!(
        text,
        "slash = 0                          # files are named from this script's folder\n\
         script = exists('ARG0') ? ARG0 : ''\n\
         do for [i=1:strlen(script)] {{ if (strstrt('/\\', script[i:i])) {{ slash = i }} }}\n\
         folder = slash > 0 ? script[1:slash] : './'\n\
         if (!exists('out')) out = folder.{out}\n\
         ending = strlen(out) > 4 ? out[strlen(out)-3:strlen(out)] : ''\n",
        out = quoted(&format!("{stem}.{usual}")),
    );
    for ending in endings.split(' ') {
        let terminal = match ending {
            "png" => format!("pngcairo size {width:.0},{height:.0}"),
            "pdf" => format!("pdfcairo size {:.1}cm,{:.1}cm", width / 45.0, height / 45.0),
            // A GIF's script says itself how fast it goes.
            other => format!("{other} animate delay delay loop 0 size {width:.0},{height:.0}"),
        };
        let _ = writeln!(text, "if (ending eq '.{ending}') {{ set terminal {terminal} }}");
    }
    let known: Vec<_> = endings.split(' ').map(|ending| format!("ending ne '.{ending}'")).collect();
    let _ = write!(
        text,
        "if ({}) {{ print 'out must end in: {endings}' ; exit status 1 }}\n\
         set output out\n\
         set encoding utf8\n",
        known.join(" && "),
    );
    text
}

/// Axes, box and view of a scene: `view` as lower left and upper right corner (m), `side` (m) of the
/// box whose outline is drawn.
pub fn ground(view: super::scene::View, side: Option<f64>) -> String {
    let (low, high) = view.corners();
    let mut text = format!(
        "set size ratio -1                 # discs to scale\n\
         set xrange [{:e}:{:e}] ; set xlabel 'x, m'\n\
         set yrange [{:e}:{:e}] ; set ylabel 'y, m'\n\
         set tics nomirror ; set key off\n",
        low.x, high.x, low.y, high.y
    );
    if let Some(side) = side {
        let _ = writeln!(
            text,
            "set object 1 rectangle from 0,0 to {side:e},{side:e} fillstyle empty border lt -1"
        );
    }
    text
}

/// The scale of colours, from `low` to `high` of what `label` says.
pub fn palette(low: f64, high: f64, label: &str) -> String {
    let stops: Vec<_> = super::colour::SCALE
        .iter()
        .enumerate()
        .map(|(k, colour)| format!("{k} '{}'", super::colour::hex(*colour)))
        .collect();
    let high = if high > low { high } else { low + 1.0 };
    format!(
        "set palette defined ({})\nset cbrange [{low:e}:{high:e}] ; set cblabel {}\n",
        stops.join(", "),
        quoted(label)
    )
}

/// Rows of numbers as a data block `name`, read as if they were a file.
pub fn block(name: &str, rows: impl Iterator<Item = String>) -> String {
    let mut text = format!("${name} << EOD\n");
    for row in rows {
        text.push_str(&row);
        text.push('\n');
    }
    text + "EOD\n"
}
