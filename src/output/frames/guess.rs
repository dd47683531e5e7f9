//! What the columns of a file without a heading are.
//!
//! Three are the guide's `x y r`, five or more begin with `x y r vx vy`, as this program wrote them before
//! it named them. Each other reading in use is tried on the rows of the first frame. It is possible if all
//! radii are above zero and no two discs overlap by more than one of them, and:
//! - a column is an id only if it counts 0, 1, 2 ... or 1, 2, 3 ..., and is no coordinate if there are
//!   three of these at least;
//! - nothing else is asked of a column.
//!
//! The usual reading is certain where no other is possible. Otherwise five columns are read as usual, and
//! that is said; of other numbers of columns nothing is taken that is not the only possibility. If none
//! is possible, discs really overlap: the usual reading it is.

use glam::DVec2;

use super::column::Column::{self, Id, Kind, Mass, Other, Radius, Vx, Vy, X, Y, Z};
use super::layout::Layout;

/// What is taken, and what is to be said of it.
#[derive(Debug)]
pub struct Guess {
    /// Which column is what.
    pub layout: Layout,
    /// A sentence, unless it is certain.
    pub remark: Option<String>,
}

/// Columns of Poeschel and Schwager, x y phi vx vy omega r m type, and what may follow.
pub const BOOK: [Column; 9] = [X, Y, Other, Vx, Vy, Other, Radius, Mass, Kind];

/// Readings in use, but for the usual one. Columns after these are passed over.
const READINGS: [&[Column]; 9] = [
    &[X, Y, Z, Radius],
    &[Id, X, Y, Radius],
    &[Id, X, Y, Radius, Vx, Vy],
    &[Id, X, Y, Z, Radius],
    &[X, Y, Vx, Vy, Radius],
    &[X, Y, Z, Vx, Vy, Other, Radius],
    &[X, Y, Z, Vx, Vy, Other, Radius, Mass],
    &[Id, X, Y, Vx, Vy, Radius],
    &[Id, X, Y, Z, Vx, Vy, Other, Radius],
];

/// The rows of the first frame, each of so many numbers.
pub struct Sample<'a> {
    /// The numbers, row by row.
    pub numbers: &'a [f64],
    /// How many a row has.
    pub columns: usize,
}

impl Sample<'_> {
    fn rows(&self) -> impl ExactSizeIterator<Item = &[f64]> {
        self.numbers.chunks_exact(self.columns)
    }

    /// Whether the first column counts.
    fn counts(&self) -> bool {
        let first = self.rows().next().map_or(f64::NAN, |row| row[0]);
        (first == 0.0 || first == 1.0)
            && (0..).zip(self.rows()).all(|(k, row)| row[0] == first + f64::from(k))
    }

    /// Whether discs may be so.
    fn allows(&self, reading: &[Column]) -> bool {
        let at = |wanted| reading.iter().position(|column| *column == wanted);
        let (Some(x), Some(y), Some(r)) = (at(X), at(Y), at(Radius)) else { return false };
        let discs = || self.rows().map(|row| (DVec2::new(row[x], row[y]), row[r]));
        let is_mass = |mass: usize| self.rows().all(|row| row[mass] > 0.0);
        discs().all(|(centre, radius)| centre.is_finite() && radius > 0.0 && radius.is_finite())
            && at(Mass).is_none_or(is_mass)
            && !overlap_too_much(&discs().take(MOST_COMPARED).collect::<Vec<_>>())
    }
}

/// So many discs are compared with each other.
const MOST_COMPARED: usize = 1000;

/// Whether any two overlap by more than the smaller radius, as no start may.
fn overlap_too_much(discs: &[(DVec2, f64)]) -> bool {
    discs.iter().enumerate().any(|(k, (centre, radius))| {
        discs[..k]
            .iter()
            .any(|(other, its)| centre.distance(*other) < radius + its - radius.min(*its))
    })
}

/// What the columns of `sample` are. Fails with the possible readings if nothing can be taken.
///
/// Two are x and y if all discs have this `radius`, m.
pub fn guess(sample: &Sample, radius: Option<f64>) -> Result<Guess, String> {
    let n = sample.columns;
    let usual = match n {
        2 => return two(radius),
        0..3 => return Err(format!("{n} columns; a disc is `x y r` or `x y r vx vy`")),
        3 | 4 => vec![X, Y, Radius],
        _ => vec![X, Y, Radius, Vx, Vy],
    };
    let (counts, rows) = (sample.counts(), sample.rows().len());
    let mut possible: Vec<Vec<Column>> = Vec::new();
    let readings =
        READINGS.iter().filter(|reading| reading.len() <= n).map(|reading| reading.to_vec());
    for reading in std::iter::once(usual.clone()).chain(readings) {
        let has_id = reading[0] == Id;
        if (has_id && !counts) || !sample.allows(&reading) {
            continue;
        }
        // A longer one that says the same and more.
        possible.retain(|shorter| !reading.starts_with(shorter));
        possible.push(reading);
    }
    if counts && rows >= 3 && possible.iter().any(|reading| reading[0] == Id) {
        possible.retain(|reading| reading[0] == Id);
    }
    match &possible[..] {
        [] => taken(usual, n, (n > 3).then_some("as no heading names them")),
        [one] if *one == usual => {
            let is_doubtful = n == 4 || n > 5 || n == 3 && counts && rows >= 3;
            taken(usual, n, is_doubtful.then_some("as no heading names them"))
        }
        [one] => taken(one.clone(), n, Some("by their values, as no heading names them")),
        // Written so by every version of this program, and by the guide's users.
        [_, ..] if n == 5 && possible.contains(&usual) => {
            let other =
                whole(&possible.into_iter().find(|one| *one != usual).unwrap_or_default(), n);
            taken(
                usual,
                n,
                Some(&format!("as no heading names them; if they are others, as {}", said(&other))),
            )
        }
        [one, other, ..] => Err(undecided(&whole(one, n), &whole(other, n))),
    }
}

/// Two columns, x and y, of discs that all have this `radius`, m.
fn two(radius: Option<f64>) -> Result<Guess, String> {
    if radius.is_none() {
        return Err(
            "2 columns; a disc is `x y r` or `x y r vx vy`\n  way out: --radius 1e-3 is that of all discs, with \
             --start and convert"
                .to_owned(),
        );
    }
    let layout = Layout::of(vec![X, Y])?.with_radius(radius, "two columns")?;
    Ok(Guess { layout, remark: None })
}

/// All columns of a reading.
fn whole(reading: &[Column], n: usize) -> Vec<Column> {
    let rest = std::iter::repeat(Other);
    reading.iter().copied().chain(rest).take(n).collect()
}

fn taken(reading: Vec<Column>, n: usize, why: Option<&str>) -> Result<Guess, String> {
    let layout = Layout::of(whole(&reading, n))?;
    let remark = why.map(|why| {
        let flag = if why.contains("--columns") {
            String::new()
        } else {
            "; --columns says it otherwise".to_owned()
        };
        let passed_over = match n - reading.len() {
            0 => String::new(),
            1 => format!(" (column {n} is passed over)"),
            _ => format!(" (columns {} to {n} are passed over)", reading.len() + 1),
        };
        format!("its columns are read as `{}`{passed_over}, {why}{flag}", layout.names())
    });
    Ok(Guess { layout, remark })
}

/// As one says it by hand.
fn said(reading: &[Column]) -> String {
    let name = |column: &Column| if *column == Z { "-" } else { column.name() };
    format!("--columns {}", reading.iter().map(name).collect::<Vec<_>>().join(","))
}

fn undecided(one: &[Column], other: &[Column]) -> String {
    let names = |reading: &[Column]| {
        reading.iter().map(|column| column.name()).collect::<Vec<_>>().join(" ")
    };
    format!(
        "no heading names its columns, and they may be `{}` or `{}`\n  way out: {}, or {}",
        names(one),
        names(other),
        said(one),
        said(other)
    )
}
