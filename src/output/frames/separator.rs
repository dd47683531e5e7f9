//! What stands between the numbers of a line, and before their decimals.

use std::str::{Split, SplitAsciiWhitespace};

/// What is wrong with a word of no letters.
pub const EMPTY: &str = "a column is empty";

/// How a line of numbers is to be taken apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Separator {
    /// A comma or semicolon between columns; blanks or tabs if none.
    mark: Option<char>,
    /// Whether a comma stands before decimals.
    pub has_decimal_commas: bool,
}

/// The words of a line.
pub enum Words<'a> {
    Blank(SplitAsciiWhitespace<'a>),
    Mark(Split<'a, char>),
}

impl Separator {
    /// Any run of blanks, and decimal points.
    pub const BLANK: Self = Self { mark: None, has_decimal_commas: false };

    /// The one of `line`, the first with numbers or names. A comma inside of every word that is parted from
    /// the others by something else is a decimal one.
    pub fn of(line: &str) -> Self {
        let inside = |word: &str| {
            let (before, after) = word.split_once(',').unwrap_or(("0", "0"));
            before.ends_with(|c: char| c.is_ascii_digit())
                && after.starts_with(|c: char| c.is_ascii_digit())
                && !after.contains([',', '.'])
        };
        let is_decimal = |mut words: Words| {
            line.contains(',') && words.all(|word| !word.is_empty() && inside(word))
        };
        let [semicolon, comma] = [';', ','].map(|mark| Self { mark: Some(mark), ..Self::BLANK });
        if line.contains(';') {
            return Self { has_decimal_commas: !line.contains('.'), ..semicolon };
        }
        if line.contains('\t') || line.split_ascii_whitespace().count() > 1 {
            let blank = Self::BLANK.words(line);
            if is_decimal(blank) {
                return Self { has_decimal_commas: true, ..Self::BLANK };
            }
        }
        if line.contains(',') { comma } else { Self::BLANK }
    }

    /// The words of `line`, as they stand there.
    pub fn words(self, line: &str) -> Words<'_> {
        match self.mark {
            None => Words::Blank(line.split_ascii_whitespace()),
            // Nothing stands behind a mark at the end.
            Some(mark) => Words::Mark(line.strip_suffix(mark).unwrap_or(line).split(mark)),
        }
    }

    /// Whether the commas of `line` may stand before decimals as well as between columns.
    pub fn is_doubtful(self, line: &str) -> bool {
        let is_whole =
            |word: &str| word.trim_start_matches('-').bytes().all(|byte| byte.is_ascii_digit());
        self.mark == Some(',') && self.words(line).count() > 3 && self.words(line).all(is_whole)
    }

    /// Whether columns are parted by blanks, as gnuplot wants it.
    pub fn is_blank(self) -> bool {
        self.mark.is_none() && !self.has_decimal_commas
    }

    /// The number that `word` is. It may be infinite, or none.
    pub fn number(self, word: &str) -> Result<f64, String> {
        if let Ok(number) = word.parse() {
            return Ok(number);
        }
        if word.is_empty() {
            return Err(EMPTY.to_owned());
        }
        let mut usual = word.replace(['d', 'D'], "e"); // Fortran
        if self.has_decimal_commas {
            usual = usual.replace(',', ".");
        }
        usual.parse().map_err(|_| {
            let hint = match word.contains(',') {
                true => " (decimals have a point; commas are read where blanks or semicolons part all columns)",
                false => "",
            };
            format!("`{}` is not a number{hint}", shortened(word))
        })
    }
}

impl<'a> Iterator for Words<'a> {
    type Item = &'a str;

    fn next(&mut self) -> Option<&'a str> {
        match self {
            Self::Blank(words) => words.next(),
            Self::Mark(words) => words.next().map(|word| word.trim().trim_matches('"')),
        }
    }
}

/// A word as it can be said: not a page of it, and nothing that a terminal would obey.
pub fn shortened(word: &str) -> String {
    const MOST: usize = 40;
    let mut short: String =
        word.chars().take(MOST).map(|c| if c.is_control() { ' ' } else { c }).collect();
    if word.chars().nth(MOST).is_some() {
        short.push_str("...");
    }
    short
}
