//! Reads what a student's program wrote: frames of `x y r` lines, as leniently as can be without
//! guessing. Any bytes give a film or a failure, never a panic.
//!
//! Forgiven: CRLF, a line of names at the head, remarks (`#`), commas or semicolons between columns,
//! more columns, any number of blank lines, or none if the rubric says how many discs there are, a
//! border of discs that never move, and frames that are cut (left out; they cost nothing).
//! `output::frames` is stricter: it stops at the first line that is not as parsim2d writes it.

use glam::DVec2;

use super::digits::Tally;
use super::film::{Film, Spot};
use super::mistake::Mistake;
use super::rubric::Rubric;
use super::verdict::Failure;
use super::words::{Finding, Quantity};

/// A frame while it is read.
#[derive(Clone, Debug, Default)]
struct Block {
    rows: Vec<Spot>,
    bad_rows: usize,
    /// Lines without a number before the first row.
    names: usize,
}

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

/// The film in what a program left, or why there is none.
pub fn read(footage: Footage, rubric: &Rubric) -> Result<Film, Failure> {
    let mut tally = Tally::default();
    let blocks = match footage {
        Footage::Nothing => return Err(Failure::of(Finding::NothingWritten, Mistake::NoFrames)),
        Footage::File(bytes) => split(file(bytes, &mut tally), rubric),
        // A program that writes its whole history each time: the last one has it all.
        Footage::Snapshots([rest @ .., last]) if grows(rest, last) => {
            split(file(last, &mut tally), rubric)
        }
        Footage::Snapshots(all) => snapshots(all, &mut tally),
    };
    if blocks.is_empty() && footage.is_blank() {
        return Err(Failure::of(Finding::NothingWritten, Mistake::EmptyFile));
    }
    if blocks.iter().all(|block| block.rows.is_empty()) {
        let bad: usize = blocks.iter().map(|block| block.bad_rows + block.names).sum();
        let cause = if bad > 0 { Mistake::WrongColumns } else { Mistake::NoFrames };
        return Err(Failure::of(Finding::NoRows, cause).with(Quantity::BadLines, bad as f64));
    }
    let all = blocks.len();
    let (frames, follows) = whole(blocks);
    let torn = all - frames.len();
    if torn > frames.len() {
        let failure = Failure::of(Finding::MostlyTorn, Mistake::FrameTorn);
        return Err(failure.with(Quantity::TornFrames, torn as f64));
    }
    let digits = tally.digits();
    let (side, corner) = (rubric.side, DVec2::from(rubric.corner));
    let mut film =
        Film { frames, follows, digits, torn, is_wild: false, halved: false, side, corner };
    drop_border(&mut film, rubric);
    Ok(film)
}

/// Whether each snapshot is the one before it, and more.
fn grows(rest: &[Vec<u8>], last: &[u8]) -> bool {
    let begins = |pair: &[Vec<u8>]| pair[1].len() > pair[0].len() && pair[1].starts_with(&pair[0]);
    rest.windows(2).all(begins)
        && rest.last().is_some_and(|before| last.len() > before.len() && last.starts_with(before))
}

/// The frames of a file. If its last line has no end, it was cut there.
fn file(bytes: &[u8], tally: &mut Tally) -> Vec<Block> {
    let mut blocks = blocks(bytes, tally);
    if blocks.len() > 2 && !bytes.ends_with(b"\n") {
        blocks.last_mut().into_iter().for_each(|block| block.bad_rows += 1);
    }
    blocks
}

/// Each snapshot is one frame. One without an end where the others have one was caught too early.
fn snapshots(all: &[Vec<u8>], tally: &mut Tally) -> Vec<Block> {
    let all = all.iter().filter(|bytes| !bytes.is_empty());
    let ends = all.clone().filter(|bytes| bytes.ends_with(b"\n")).count();
    let is_usual = 2 * ends > all.clone().count();
    all.filter_map(|bytes| {
        let mut whole = Block {
            bad_rows: usize::from(is_usual && !bytes.ends_with(b"\n")),
            ..Block::default()
        };
        for part in blocks(bytes, tally) {
            whole.rows.extend(part.rows);
            whole.bad_rows += part.bad_rows;
            whole.names += part.names;
        }
        (whole.rows.len() + whole.bad_rows + whole.names > 0).then_some(whole)
    })
    .collect()
}

/// The blocks between blank lines and remarks.
fn blocks(bytes: &[u8], tally: &mut Tally) -> Vec<Block> {
    let text = String::from_utf8_lossy(bytes);
    let (mut blocks, mut block) = (Vec::new(), Block::default());
    let mut finish = |block: &mut Block| {
        if block.rows.len() + block.bad_rows + block.names > 0 {
            blocks.push(std::mem::take(block));
        }
    };
    for line in text.trim_start_matches('\u{feff}').lines().map(str::trim) {
        if line.is_empty() || line.starts_with('#') {
            finish(&mut block);
            continue;
        }
        // As gnuplot reads: blanks part columns; a comma after a number does no harm.
        let words: Vec<&str> =
            line.split_whitespace().map(|word| word.trim_end_matches([',', ';'])).collect();
        match row(&words) {
            Some(spot) => {
                words[..2].iter().for_each(|word| tally.note(word));
                block.rows.push(spot);
            }
            // A line of names at the head of a frame is no row.
            None if block.rows.is_empty() && is_names(&words) => block.names += 1,
            None => block.bad_rows += 1,
        }
    }
    finish(&mut block);
    blocks
}

fn is_names(words: &[&str]) -> bool {
    words.iter().all(|word| number(word).is_none())
}

/// A number as C, C++, Python and Rust print it; `-nan` and `nan(ind)` too.
fn number(word: &str) -> Option<f64> {
    let lower = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
    if lower.starts_with("nan") || lower.starts_with("1.#") {
        return Some(f64::NAN);
    }
    word.parse().ok()
}

fn row(words: &[&str]) -> Option<Spot> {
    let [x, y, r, ..] = words else { return None };
    Some(Spot { position: DVec2::new(number(x)?, number(y)?), radius: number(r)? })
}

/// One long block is many frames of n rows, if the rubric knows n.
fn split(blocks: Vec<Block>, rubric: &Rubric) -> Vec<Block> {
    let [one] = blocks.as_slice() else { return blocks };
    let rows = if one.bad_rows > 0 { 0 } else { one.rows.len() };
    let fits = |n: &&usize| **n > 0 && rows > **n && rows % **n == 0;
    let Some(&n) = rubric.n.iter().find(fits) else { return blocks };
    one.rows.chunks(n).map(|rows| Block { rows: rows.to_vec(), ..Block::default() }).collect()
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
