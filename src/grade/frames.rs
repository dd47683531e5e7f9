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
}

/// The film in `bytes`, or why there is none.
pub fn read(bytes: &[u8], rubric: &Rubric) -> Result<Film, Failure> {
    let text = String::from_utf8_lossy(bytes);
    if text.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}').is_empty() {
        return Err(Failure::of(Finding::NothingWritten, Mistake::EmptyFile));
    }
    let (blocks, tally) = blocks(&text);
    let rows: usize = blocks.iter().map(|block| block.rows.len()).sum();
    let bad: usize = blocks.iter().map(|block| block.bad_rows).sum();
    if rows == 0 {
        let cause = if bad > 0 { Mistake::WrongColumns } else { Mistake::NoFrames };
        return Err(Failure::of(Finding::NoRows, cause).with(Quantity::BadLines, bad as f64));
    }
    let blocks = split(blocks, rubric);
    let all = blocks.len();
    let (frames, follows) = whole(blocks);
    let torn = all - frames.len();
    if torn > frames.len() {
        let failure = Failure::of(Finding::MostlyTorn, Mistake::FrameTorn);
        return Err(failure.with(Quantity::TornFrames, torn as f64));
    }
    let digits = tally.digits();
    let mut film = Film { frames, follows, digits, torn, halved: false, side: rubric.side };
    drop_border(&mut film, rubric);
    Ok(film)
}

/// The blocks between blank lines and remarks.
fn blocks(text: &str) -> (Vec<Block>, Tally) {
    let (mut blocks, mut block, mut tally) = (Vec::new(), Block::default(), Tally::default());
    let text = text.trim_start_matches('\u{feff}');
    for line in text.lines().map(str::trim) {
        if line.is_empty() || line.starts_with('#') {
            if !block.rows.is_empty() || block.bad_rows > 0 {
                blocks.push(std::mem::take(&mut block));
            }
            continue;
        }
        let words: Vec<&str> =
            line.split([' ', '\t', ',', ';']).filter(|word| !word.is_empty()).collect();
        match row(&words) {
            Some(spot) => {
                words[..2].iter().for_each(|word| tally.note(word));
                block.rows.push(spot);
            }
            // A line of names at the head of a frame is no row.
            None if block.rows.is_empty() && is_names(&words) => {}
            None => block.bad_rows += 1,
        }
    }
    if !block.rows.is_empty() || block.bad_rows > 0 {
        blocks.push(block);
    }
    (blocks, tally)
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
    let rows = one.rows.len();
    let fits = |n: &&usize| **n > 0 && rows > **n && rows % **n == 0;
    let Some(&n) = rubric.n.iter().find(fits) else { return blocks };
    one.rows.chunks(n).map(|rows| Block { rows: rows.to_vec(), bad_rows: 0 }).collect()
}

/// The whole frames, and for each whether it follows the one before directly. A frame with a bad
/// row, or a shorter one between longer ones or at the very end, was cut while it was written.
fn whole(blocks: Vec<Block>) -> (Vec<Vec<Spot>>, Vec<bool>) {
    let longest_after: Vec<usize> = blocks
        .iter()
        .rev()
        .scan(0, |longest, block| {
            let after = *longest;
            *longest = after.max(block.rows.len());
            Some(after)
        })
        .collect();
    let last = blocks.len() - 1;
    let (mut frames, mut follows) = (Vec::<Vec<Spot>>::new(), Vec::new());
    let mut is_next = true;
    for (k, block) in blocks.into_iter().enumerate() {
        let n = block.rows.len();
        let before = frames.last().map_or(0, Vec::len);
        let is_dip = n < before && (longest_after[last - k] >= before || k == last);
        if block.bad_rows > 0 || is_dip {
            is_next = false;
            continue;
        }
        frames.push(block.rows);
        follows.push(std::mem::replace(&mut is_next, true));
    }
    (frames, follows)
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
