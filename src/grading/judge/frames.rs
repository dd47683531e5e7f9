//! Reads what a student's program wrote: frames of `x y r` lines, as leniently as can be without
//! guessing. Any bytes give a film or a failure, never a panic.
//!
//! Forgiven: CRLF, headings (a line of names, `t = 0.01`, a count, `---`), remarks (`#`), commas or semicolons after
//! columns, more columns, any number of blank lines, or none if headings part frames or the rubric says how many discs
//! there are, a border of discs that never move, and frames that are cut (left out; they cost nothing).
//! `output::frames` is stricter: it stops at the first line that is not as parsim2d writes it.

use glam::DVec2;

use super::columns::named;
use super::film::Film;
use super::headings::{Block, Headings};
use super::lines::{COLUMNS, Reader, is_ended};
use super::misread::Misread;
use super::mistake::Mistake;
use super::put_right;
use super::rubric::Rubric;
use super::spot::Spot;
use super::verdict::Failure;
use super::words::{ENGLISH, Finding, Quantity};

/// What a program left, as it was caught.
#[derive(Clone, Copy, Debug)]
pub enum Footage<'a> {
    /// One file, frame after frame.
    File(&'a [u8]),
    /// Each whole frame of a program that writes over its file, in order.
    Snapshots(&'a [Vec<u8>]),
    /// There is no file of that name.
    Nothing,
}

impl Footage<'_> {
    /// The beginning of the first file.
    fn first(&self) -> Option<&[u8]> {
        const ENOUGH: usize = 1 << 14;
        let bytes = match self {
            Self::File(bytes) => bytes,
            Self::Snapshots(all) => all.first()?.as_slice(),
            Self::Nothing => return None,
        };
        Some(&bytes[..bytes.len().min(ENOUGH)])
    }

    /// Whether there is nothing in it but blanks.
    fn is_blank(&self) -> bool {
        let is_blank = |bytes: &[u8]| bytes.iter().all(u8::is_ascii_whitespace);
        match self {
            Self::File(bytes) => is_blank(bytes),
            Self::Snapshots(all) => all.iter().all(|bytes| is_blank(bytes)),
            Self::Nothing => true,
        }
    }
}

/// The columns in which x, y and r should stand.
const USUAL: [usize; 3] = [0, 1, 2];

/// The film in what a program left, or why there is none. A heading that names its columns is followed. What another
/// order of columns, another unit or another corner of the box makes right is put right, and [`Film::misread`] says so.
pub fn read(footage: Footage, rubric: &Rubric) -> Result<Film, Failure> {
    let named = footage.first().and_then(|bytes| named(&String::from_utf8_lossy(bytes)));
    let usual = read_columns(footage, rubric, USUAL);
    // A slip in a heading is none in the rows below it.
    let is_right = usual.as_ref().is_ok_and(|(film, _)| put_right::has_radii_asked(film, rubric));
    if let Some(columns) = named.filter(|&columns| columns != USUAL && !is_right) {
        return read_columns(footage, rubric, columns).map(|(film, _)| film);
    }
    let (mut film, sample) = usual?;
    match put_right::columns(&sample, rubric) {
        Some(columns) => {
            let (mut film, _) = read_columns(footage, rubric, columns)?;
            film.misread = Some(Misread::Columns(columns));
            Ok(film)
        }
        None => {
            let is_more = sample.iter().any(|row| !row[3].is_nan());
            film.is_taken = is_more && rubric.radius.is_empty() && named.is_none();
            Ok(film)
        }
    }
}

/// How many frames there are, whole or cut, as [`read`] would part them.
///
/// ```
/// use parsim2d::grading::judge::{frames::{Footage, count}, rubric::Rubric};
/// let (rows, rubric) = ("0.01 0.02 5e-4\n".repeat(6), Rubric { n: vec![2], ..Rubric::default() });
/// assert_eq!(count(Footage::File(rows.as_bytes()), &rubric), 3); // no blank line: n tells
/// assert_eq!(count(Footage::File(b"2\n0 0 1\n0 0 1\n2\n0 0 1\n0 0 1\n"), &Rubric::default()), 2);
/// ```
pub fn count(footage: Footage, rubric: &Rubric) -> usize {
    blocks(footage, rubric, &mut Reader::of(USUAL)).len()
}

/// The blocks of what a program left.
fn blocks(footage: Footage, rubric: &Rubric, reader: &mut Reader) -> Vec<Block> {
    match footage {
        Footage::Nothing => Vec::new(),
        Footage::File(bytes) => split(file(bytes, reader), rubric),
        // A program that writes its whole history each time: the last one has it all.
        Footage::Snapshots([rest @ .., last]) if grows(rest, last) => {
            split(file(last, reader), rubric)
        }
        Footage::Snapshots(all) => snapshots(all, reader),
    }
}

/// The film whose x, y and r stand in these columns, and all columns of some of its rows.
fn read_columns(
    footage: Footage,
    rubric: &Rubric,
    columns: [usize; 3],
) -> Result<(Film, Vec<[f64; COLUMNS]>), Failure> {
    if matches!(footage, Footage::Nothing) {
        return Err(Failure::of(Finding::NothingWritten, Mistake::NoFrames));
    }
    let mut reader = Reader::of(columns);
    let blocks = blocks(footage, rubric, &mut reader);
    if blocks.is_empty() && footage.is_blank() {
        return Err(Failure::of(Finding::NothingWritten, Mistake::EmptyFile));
    }
    let said = first_bad_line(&reader);
    if blocks.iter().all(|block| block.rows.is_empty()) {
        let cause = if reader.others > 0 { Mistake::WrongColumns } else { Mistake::NoFrames };
        let failure = Failure::of(Finding::NoRows, cause);
        return Err(failure.with(Quantity::BadLines, reader.others as f64).saying(&said));
    }
    let is_bad = blocks.iter().any(|block| block.bad_rows > 0);
    let all = blocks.len();
    let (frames, follows) = whole(blocks);
    let torn = all - frames.len();
    if torn > frames.len() {
        let failure = Failure::of(Finding::MostlyTorn, Mistake::FrameTorn);
        let said = if is_bad { said.as_str() } else { "" };
        return Err(failure.with(Quantity::TornFrames, torn as f64).saying(said));
    }
    let digits = reader.tally.digits();
    let (side, corner) = (rubric.side, DVec2::from(rubric.corner));
    let (halved, misread, is_wild, is_taken) = (false, None, false, false);
    let mut film =
        Film { frames, follows, digits, torn, is_wild, is_taken, halved, misread, side, corner };
    film.put_right(rubric);
    drop_border(&mut film, rubric);
    Ok((film, reader.sample))
}

/// The first line that is no disc, for a student.
fn first_bad_line(reader: &Reader) -> String {
    const LONGEST: usize = 60;
    let Some(line) = reader.first_other() else { return String::new() };
    let shown: String = line.chars().take(LONGEST).flat_map(char::escape_debug).collect();
    let more = if line.chars().nth(LONGEST).is_some() { " ..." } else { "" };
    format!("{}: {shown}{more}", ENGLISH.bad_line)
}

/// Whether each snapshot is the one before it, and more.
fn grows(rest: &[Vec<u8>], last: &[u8]) -> bool {
    let begins = |pair: &[Vec<u8>]| pair[1].len() > pair[0].len() && pair[1].starts_with(&pair[0]);
    rest.windows(2).all(begins)
        && rest.last().is_some_and(|before| last.len() > before.len() && last.starts_with(before))
}

/// The frames of a file. If its last line has no end, it was cut there.
fn file(bytes: &[u8], reader: &mut Reader) -> Vec<Block> {
    let passages = reader.passages(bytes);
    let headings = Headings::of(&passages, reader.shapes());
    let mut blocks: Vec<Block> =
        passages.iter().flat_map(|passage| headings.blocks(passage)).collect();
    if blocks.len() > 2 && !is_ended(bytes) {
        let last = blocks.last_mut().filter(|block| !block.rows.is_empty());
        last.into_iter().for_each(|block| block.bad_rows += 1);
    }
    // Headings alone are no frame.
    blocks.retain(|block| block.rows.len() + block.bad_rows > 0);
    blocks
}

/// Each snapshot is one frame. One without an end where the others have one was caught too early.
fn snapshots(all: &[Vec<u8>], reader: &mut Reader) -> Vec<Block> {
    let all: Vec<&Vec<u8>> = all.iter().filter(|bytes| !bytes.is_empty()).collect();
    let ends = all.iter().filter(|bytes| is_ended(bytes)).count();
    let is_usual = 2 * ends > all.len();
    let (mut passages, mut whose) = (Vec::new(), Vec::new());
    for (k, bytes) in all.iter().enumerate() {
        let own = reader.passages(bytes);
        whose.extend(vec![k; own.len()]);
        passages.extend(own);
    }
    let headings = Headings::of(&passages, reader.shapes());
    let bad_rows = |bytes: &Vec<u8>| usize::from(is_usual && !is_ended(bytes));
    let new = |bytes: &&Vec<u8>| Block { bad_rows: bad_rows(bytes), ..Block::default() };
    let mut blocks: Vec<Block> = all.iter().map(new).collect();
    for (k, passage) in whose.into_iter().zip(&passages) {
        for part in headings.blocks(passage) {
            blocks[k].rows.extend(part.rows);
            blocks[k].bad_rows += part.bad_rows;
            blocks[k].headings += part.headings;
        }
    }
    blocks.retain(|block| !block.is_empty());
    blocks
}

/// One long block is many frames of n rows, if the rubric knows n.
fn split(blocks: Vec<Block>, rubric: &Rubric) -> Vec<Block> {
    let [one] = blocks.as_slice() else { return blocks };
    let rows = one.rows.len();
    let fits = |n: &&usize| **n > 0 && rows > **n && rows % **n == 0 && one.bad_rows == 0;
    // The last frame, or row, may be cut.
    let nearly = |n: &&usize| **n > 0 && rows > 2 * **n && one.bad_rows <= 1;
    let Some(&n) = rubric.n.iter().find(fits).or_else(|| rubric.n.iter().find(nearly)) else {
        return blocks;
    };
    let whole = one.rows.len() - usize::from(has_cut_end(&one.rows));
    let frames = one.rows[..whole].chunks(n);
    frames.map(|rows| Block { rows: rows.to_vec(), ..Block::default() }).collect()
}

/// The whole frames, and for each whether it follows the one before directly.
///
/// A frame with a bad row, or whose last number is shorter than that of the row above, was cut while it
/// was written; so was a shorter one at the very end. A shorter one between longer ones may have been
/// cut at the end of a line by chance, or be wrong: one in fifty is taken for chance, for there are some
/// fifty places where it could have been cut between two ends of lines.
fn whole(blocks: Vec<Block>) -> (Vec<Vec<Spot>>, Vec<bool>) {
    let dips = dips(&blocks);
    let is_doubtful = |(block, is_dip): &(&Block, &bool)| **is_dip && !has_cut_end(&block.rows);
    let doubtful = blocks.iter().zip(&dips).filter(is_doubtful).count();
    let is_chance = 50 * doubtful <= blocks.len().max(100);
    let (mut frames, mut follows) = (Vec::<Vec<Spot>>::new(), Vec::new());
    let mut is_next = true;
    let last = blocks.len() - 1;
    for (k, block) in blocks.into_iter().enumerate() {
        let is_short = dips[k] && (is_chance || k == last || has_cut_end(&block.rows));
        if block.bad_rows > 0 || block.rows.is_empty() || is_short {
            is_next = false;
            continue;
        }
        frames.push(block.rows);
        follows.push(std::mem::replace(&mut is_next, true));
    }
    (frames, follows)
}

/// The blocks of good rows that are shorter than one before and one after, or than one before at the end.
fn dips(blocks: &[Block]) -> Vec<bool> {
    let length = |block: &Block| if block.bad_rows > 0 { 0 } else { block.rows.len() };
    let longest = |longest: &mut usize, block: &Block| {
        let before = *longest;
        *longest = before.max(length(block));
        Some(before)
    };
    let before: Vec<usize> = blocks.iter().scan(0, longest).collect();
    let mut after: Vec<usize> = blocks.iter().rev().scan(0, longest).collect();
    after.reverse();
    let last = blocks.len() - 1;
    let is_dip = |(k, block): (usize, &Block)| {
        let n = length(block);
        block.bad_rows == 0 && n < before[k] && (n < after[k] || k == last)
    };
    blocks.iter().enumerate().map(is_dip).collect()
}

/// Whether the radius in the last row has lost digits: all discs of the course have one radius.
fn has_cut_end(rows: &[Spot]) -> bool {
    matches!(rows, [.., above, last] if last.radius != above.radius)
}

/// Rows that never move, with centres on the edge of the box or outside, are the guide's border.
fn drop_border(film: &mut Film, rubric: &Rubric) {
    let n = film.n();
    if film.frames.len() < 3 || film.frames.iter().any(|frame| frame.len() != n) {
        return;
    }
    let low = DVec2::from(rubric.corner);
    let high = low + DVec2::splat(rubric.side);
    let hair = 1e-9 * rubric.side;
    let first = film.frames[0].clone();
    let is_border = |i: usize| {
        let p = first[i].position;
        let is_out = (p - low).min_element() <= hair || (high - p).min_element() <= hair;
        is_out && film.frames.iter().all(|frame| frame[i] == first[i])
    };
    let keep: Vec<bool> = (0..n).map(|i| !is_border(i)).collect();
    if !keep.contains(&true) {
        return;
    }
    for frame in &mut film.frames {
        let mut kept = keep.iter();
        frame.retain(|_| *kept.next().unwrap_or(&true));
    }
}
