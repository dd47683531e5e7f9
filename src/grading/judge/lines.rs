//! Lines of a file: discs, blank ones, and everything else by its shape.

use std::collections::BTreeMap;

use glam::DVec2;

use super::digits::Tally;
use super::spot::Spot;

/// Columns that are looked at when their order is in doubt.
pub const COLUMNS: usize = 8;

/// Rows of which all columns are kept.
const SAMPLE: usize = 200;

/// The longest shape that is told from others, bytes.
const LONGEST_SHAPE: usize = 80;

/// What a line that is no disc is made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// It begins with a word, or is a number with a unit: no cut row looks so.
    Words,
    /// One or two numbers alone: a time, a count; or a row that was cut.
    Numbers,
    /// Anything else: a bad row.
    Broken,
}

/// A line that is no disc.
#[derive(Clone, Copy, Debug)]
pub struct Other {
    /// Which lines it is like: those of one shape differ in numbers only.
    pub shape: usize,
    /// What it is made of.
    pub kind: Kind,
    /// The whole number that it is, if it is one alone.
    pub count: Option<usize>,
}

/// A line that is not blank.
#[derive(Clone, Copy, Debug)]
pub enum Line {
    /// A disc.
    Row(Spot),
    /// No disc.
    Other(Other),
}

/// Lines between blank lines and remarks.
pub type Passage = Vec<Line>;

/// Whether the last line of a file has an end.
pub fn is_ended(bytes: &[u8]) -> bool {
    bytes.ends_with(b"\n") || bytes.ends_with(b"\r")
}

/// Reads lines, and keeps what is known of all of them.
#[derive(Debug, Default)]
pub struct Reader {
    /// Which columns are x, y and r.
    columns: [usize; 3],
    /// How finely positions are printed.
    pub tally: Tally,
    /// All columns of the first rows (NaN where there is none), of one passage.
    pub sample: Vec<[f64; COLUMNS]>,
    /// Lines that are no disc.
    pub others: usize,
    first_other: [Option<String>; 2],
    shapes: BTreeMap<String, usize>,
}

impl Reader {
    /// A reader of files whose x, y and r stand in these columns, from 0.
    pub fn of(columns: [usize; 3]) -> Self {
        Self { columns, ..Self::default() }
    }

    /// The first line that is no disc: one with a digit, if there is one.
    pub fn first_other(&self) -> Option<&str> {
        self.first_other.iter().flatten().next().map(String::as_str)
    }

    /// How many shapes there are.
    pub fn shapes(&self) -> usize {
        self.shapes.len()
    }

    /// The passages of a file, none of them empty.
    pub fn passages(&mut self, bytes: &[u8]) -> Vec<Passage> {
        let text = String::from_utf8_lossy(bytes);
        let (mut passages, mut passage) = (Vec::new(), Passage::new());
        let mut has_sample = !self.sample.is_empty();
        // Old Macs end lines with CR alone.
        let end = if text.contains('\n') { '\n' } else { '\r' };
        for line in text.trim_start_matches('\u{feff}').split(end).map(str::trim) {
            if !line.is_empty() && !line.starts_with('#') {
                passage.push(self.line(line, has_sample));
            } else if !passage.is_empty() {
                passages.push(std::mem::take(&mut passage));
                has_sample = !self.sample.is_empty();
            }
        }
        passages.extend((!passage.is_empty()).then_some(passage));
        passages
    }

    fn line(&mut self, line: &str, has_sample: bool) -> Line {
        // As gnuplot reads: blanks part columns; a comma after a number does no harm.
        let words: Vec<&str> =
            line.split_whitespace().map(|word| word.trim_end_matches([',', ';'])).collect();
        let Some(spot) = self.row(&words) else { return Line::Other(self.other(line, &words)) };
        let [x, y, _] = self.columns;
        [x, y].into_iter().for_each(|k| self.tally.note(words[k]));
        if !has_sample && self.sample.len() < SAMPLE {
            let column = |k: usize| words.get(k).and_then(|word| number(word)).unwrap_or(f64::NAN);
            self.sample.push(std::array::from_fn(column));
        }
        Line::Row(spot)
    }

    fn row(&self, words: &[&str]) -> Option<Spot> {
        let [x, y, radius] = self.columns.map(|k| words.get(k).and_then(|word| number(word)));
        Some(Spot { position: DVec2::new(x?, y?), radius: radius? })
    }

    fn other(&mut self, line: &str, words: &[&str]) -> Other {
        self.others += 1;
        let is_plain = !line.contains(|c: char| c.is_ascii_digit());
        self.first_other[usize::from(is_plain)].get_or_insert_with(|| line.to_owned());
        let mut shape = String::new();
        for word in words {
            shape += &skeleton(word);
            shape.push(' ');
            if shape.len() > LONGEST_SHAPE {
                break;
            }
        }
        let next = self.shapes.len();
        let shape = *self.shapes.entry(shape).or_insert(next);
        let count = if let [one] = words { one.parse().ok() } else { None };
        Other { shape, kind: kind(words), count }
    }
}

/// A word without its numbers, of which only is told that they are there.
fn skeleton(word: &str) -> String {
    if number(word).is_some() {
        return "0".to_owned();
    }
    let mut rest = word.chars().peekable();
    let mut skeleton = String::new();
    while let Some(c) = rest.next() {
        match c {
            '+' | '-' | '.' if rest.peek().is_some_and(char::is_ascii_digit) => {}
            '0'..='9' => {
                let is_of_number = |c: &char| c.is_ascii_digit() || "eE.+-".contains(*c);
                while rest.next_if(is_of_number).is_some() {}
                skeleton.push('0');
            }
            c => skeleton.push(c),
        }
    }
    skeleton
}

fn kind(words: &[&str]) -> Kind {
    let is_letter = |word: &&str| word.starts_with(char::is_alphabetic);
    let is_sign = |c: char| c.is_ascii_digit() || "+-.".contains(c);
    let begins = |word: &&&str| word.contains(char::is_alphabetic) || word.chars().count() > 1;
    let begins = words
        .first()
        .filter(|word| !word.starts_with(is_sign) || word.starts_with("--"))
        .is_some_and(|word| begins(&word));
    let numbers = words.iter().filter(|word| number(word).is_some()).count();
    match () {
        () if numbers == words.len() && numbers < 3 => Kind::Numbers,
        () if begins && number(words[0]).is_none() => Kind::Words,
        () if numbers < 3 && words.iter().all(|w| number(w).is_some() || is_letter(w)) => {
            Kind::Words
        }
        () => Kind::Broken,
    }
}

/// A number as C, C++, Python and Rust print it; `-nan` and `nan(ind)` too.
pub fn number(word: &str) -> Option<f64> {
    let lower = word.trim_start_matches(['-', '+']).to_ascii_lowercase();
    if lower.starts_with("nan") || lower.starts_with("1.#") {
        return Some(f64::NAN);
    }
    word.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_that_differ_in_numbers_only_have_one_shape_and_cut_rows_are_no_words() {
        let mut reader = Reader::of([0, 1, 2]);
        let mut other = |line: &str| {
            let words: Vec<&str> = line.split_whitespace().collect();
            reader.other(line, &words)
        };
        for [a, b] in [["t=0", "t=1e-05"], ["t = 0", "t = -0.5s"], ["3/400", "14/400"]] {
            assert_eq!(other(a).shape == other(b).shape, !a.contains(" = "), "{a}, {b}");
        }
        for words in ["t = 0", "frame 3/400", "---", "20 discs", "ITEM: ATOMS x y r", "==="] {
            assert_eq!(other(words).kind, Kind::Words, "{words}");
        }
        for numbers in ["20", "0.01", "0.0123 0.0", "100 1e-5"] {
            assert_eq!(other(numbers).kind, Kind::Numbers, "{numbers}");
        }
        for broken in
            ["0.01 0.02 5e-", "0.01 -", "-", "0.1 0.2 5e-40.3 0.2 5e-4", "1;2;3", ".", "1,5 2,5"]
        {
            assert_eq!(other(broken).kind, Kind::Broken, "{broken}");
        }
    }
}
