//! Frames as rows of a table: ours, those of the guide and of Poeschel and Schwager, and CSV.

use std::io::BufRead;

use super::column::Column;
use super::comment::{COMMENT, Comment};
use super::frame::{Frame, Row};
use super::guess::{self, BOOK, Guess};
use super::ids::Ids;
use super::layout::Layout;
use super::lines::{Line, Lines};
use super::remarks::{Remarks, no_square};
use super::separator::Separator;

mod heading;
mod order;
mod sample;

use self::heading::{named, words_of};
use self::sample::Block;

/// A table while it is read.
#[derive(Debug, Default)]
pub struct Table {
    /// The columns said by hand.
    by_hand: Option<Layout>,
    /// The radius of all discs, m, where no column says it.
    radius: Option<f64>,
    /// The columns in force, and what parts them.
    layout: Option<Layout>,
    separator: Option<Separator>,
    /// Whether the columns in force are guessed.
    is_guessed: bool,
    /// Names in the heading of the present columns.
    heading: String,
    /// Whether no row has followed the heading, a line of names, which may lack one for a leading index.
    may_have_index: bool,
    /// A remark that may be a heading, until a row shows it.
    names: Option<String>,
    /// Remarks that only Poeschel and Schwager's programs write.
    of_book: usize,
    sides: [Option<f64>; 2], // m
    begun: Frame,
    /// A row of the frame that has just begun.
    first: Option<Row>,
    /// Whether the frame has a head.
    has_head: bool,
    finished: usize,
    /// The ids of the frame that has just begun.
    ids: Ids,
    /// The last row that was taken.
    last: Option<Row>,
    /// Whether rows of an earlier frame come after those of a later one.
    goes_back: bool,
    /// Whether less than two blank lines stand between any frames.
    is_narrow: bool,
}

/// What was done with a line.
enum Step {
    /// It is taken.
    Taken,
    /// Nothing: it belongs to the next frame.
    OfNextFrame,
    /// Nothing: no heading names the columns of the rows that begin with it.
    Unnamed,
}

impl Table {
    /// A table with these columns, if they are said by hand; its discs have this `radius` (m) where no column says it.
    pub fn new(by_hand: Option<Layout>, radius: Option<f64>) -> Self {
        Self { layout: by_hand.clone(), by_hand, radius, ..Self::default() }
    }

    /// Whether the columns are named, by the file or by hand.
    pub fn names_columns(&self) -> bool {
        !self.is_guessed
    }

    /// Whether gnuplot reads it as we do.
    pub fn is_plain(&self) -> bool {
        self.layout.as_ref().is_none_or(Layout::is_plain)
            && self.separator.is_none_or(Separator::is_blank)
            && !self.is_narrow
    }

    /// The next frame, which may be shorter than its head says.
    pub fn next_frame<R: BufRead>(
        &mut self,
        lines: &mut Lines<R>,
        remarks: &mut Remarks,
    ) -> Result<Option<Frame>, String> {
        let mut gap = 0;
        while let Some(line) = lines.next()? {
            if line.text.is_empty() {
                gap += 1;
                continue;
            }
            match self.take(&line, gap, remarks)? {
                Step::Taken => {}
                Step::OfNextFrame => {
                    lines.put_back();
                    return Ok(Some(self.finish(remarks)));
                }
                Step::Unnamed => {
                    let separator = self.separator_of(&line);
                    lines.put_back();
                    self.take_block(Block::read(lines, separator, self.begun.declared)?, remarks)?;
                }
            }
            gap = 0;
        }
        self.last_frame(remarks)
    }

    /// Takes a line after `gap` blank ones.
    fn take(&mut self, line: &Line, gap: usize, remarks: &mut Remarks) -> Result<Step, String> {
        let comment = line.text.strip_prefix(COMMENT).map(Comment::of);
        let has_ended = gap > 0 || comment.as_ref().is_some_and(|comment| comment.is_head);
        if has_ended && !self.begun.rows.is_empty() {
            self.is_narrow |= gap < 2;
            return Ok(Step::OfNextFrame);
        }
        if let Some(comment) = comment {
            return self.take_comment(line, comment).map(|()| Step::Taken);
        }
        if line.is_cut && self.begun.declared.is_some() {
            return Err(line.at("the line is cut off"));
        }
        if self.begun.declared.is_some_and(|n| self.begun.rows.len() >= n) {
            return Ok(Step::Taken); // a border
        }
        self.take_data(line, remarks)
    }

    /// Takes a line of names or numbers.
    fn take_data(&mut self, line: &Line, remarks: &mut Remarks) -> Result<Step, String> {
        let begins_with_number =
            line.text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        if (self.layout.is_none() || !begins_with_number) && self.take_names(line)? {
            if self.begun.rows.is_empty() {
                return Ok(Step::Taken);
            }
            self.is_narrow = true;
            return Ok(Step::OfNextFrame);
        }
        if self.is_guessed && self.begun.rows.is_empty() && !self.has_width_of(line) {
            self.layout = None; // a frame of its own
        }
        if self.layout.is_none() {
            return Ok(Step::Unnamed);
        }
        self.take_index(line, remarks);
        let row = self.row(line)?;
        self.check_order(&row).map_err(|why| line.at(why))?;
        if self.is_of_next(&row) {
            self.is_narrow = true;
            return Ok(Step::OfNextFrame);
        }
        self.check_id(&row).map_err(|why| line.at(why))?;
        self.push(row, remarks);
        Ok(Step::Taken)
    }

    /// Whether rows of an earlier frame have come after those of a later one.
    pub fn goes_back(&self) -> bool {
        self.goes_back
    }

    /// Passes over a whole number that stands before the columns that the heading names: the index that pandas writes.
    fn take_index(&mut self, line: &Line, remarks: &mut Remarks) {
        if !std::mem::take(&mut self.may_have_index) {
            return;
        }
        let words: Vec<&str> = self.separator_of(line).words(&line.text).collect();
        let Some(layout) = &self.layout else { return };
        if words.len() == layout.columns().len() + 1 && words[0].parse::<u64>().is_ok() {
            self.layout = Some(layout.after_index());
            remarks.add("its first column, which its heading does not name, is passed over");
        }
    }

    fn separator_of(&mut self, line: &Line) -> Separator {
        *self.separator.get_or_insert_with(|| Separator::of(&line.text))
    }

    fn take_comment(&mut self, line: &Line, comment: Comment) -> Result<(), String> {
        if line.is_cut && self.finished > 0 {
            return Err(self.cut_off());
        }
        let frame = &mut self.begun;
        self.has_head |= comment.is_head;
        frame.step = comment.step.or(frame.step);
        frame.time = comment.time.or(frame.time);
        frame.side = comment.side.or(frame.side);
        frame.declared = comment.n.or(frame.declared);
        self.of_book += usize::from(comment.is_of_book);
        for (side, said) in self.sides.iter_mut().zip(comment.sides) {
            *side = said.or(*side);
        }
        self.names = comment.names.or(self.names.take());
        match comment.columns {
            Some(columns) if self.by_hand.is_none() && columns != self.heading => {
                self.layout = Some(named(&columns, self.radius).map_err(|why| line.at(why))?);
                self.is_guessed = false;
                self.heading = columns;
                self.separator = None;
            }
            _ => {}
        }
        Ok(())
    }

    /// Takes `line` for a heading, if it is one: the first line, or one like it further down.
    fn take_names(&mut self, line: &Line) -> Result<bool, String> {
        let separator = Separator::of(&line.text);
        let is_number = |word: &str| separator.number(word).is_ok();
        if separator.words(&line.text).any(is_number) {
            self.take_earlier_names(&line.text).map_err(|why| line.at(why))?;
            return Ok(false);
        }
        let is_first =
            self.layout == self.by_hand && self.begun.rows.is_empty() && self.finished == 0;
        if self.by_hand.is_some() && is_first {
            return Ok(true); // the names are not needed
        }
        if *line.text == self.heading {
            return Ok(true);
        }
        if !is_first {
            return Ok(false);
        }
        let is_coordinate =
            |word: &str| matches!(Column::named(word), Ok(Column::X | Column::Y) | Err(_));
        if !separator.words(&line.text).any(is_coordinate) {
            return Ok(false);
        }
        self.layout = Some(named(&line.text, self.radius).map_err(|why| line.at(why))?);
        self.heading = line.text.clone().into_owned();
        self.may_have_index = true;
        Ok(true)
    }

    /// A remark before the first row was a heading if it has a name for each of its columns, x and y among
    /// them.
    fn take_earlier_names(&mut self, row: &str) -> Result<(), String> {
        if self.layout.is_some() {
            return Ok(());
        }
        let separator = *self.separator.get_or_insert_with(|| Separator::of(row));
        let n = separator.words(row).count();
        if self.of_book >= 2 && n >= 8 {
            let mut columns: Vec<Column> = BOOK.into_iter().take(n).collect();
            columns.resize(n, Column::Other);
            self.layout = Some(Layout::of(columns)?);
            return Ok(());
        }
        let Some(names) = self.names.take() else { return Ok(()) };
        let words = words_of(&names);
        // One of ours in other units is one of ours.
        let has =
            |column| words.iter().any(|word| Column::named(word).map_or(true, |one| one == column));
        if words.len() == n && has(Column::X) && has(Column::Y) {
            self.layout = Some(named(&names, self.radius)?);
        }
        Ok(())
    }

    /// Takes the rows of the first frame of a file without heading.
    fn take_block(&mut self, block: Block, remarks: &mut Remarks) -> Result<(), String> {
        let Guess { layout, remark } =
            guess::guess(&block.sample(), self.radius).map_err(|why| block.at(&why))?;
        remark.into_iter().for_each(|remark| remarks.add(remark));
        block.remark.iter().for_each(|remark| remarks.add(remark));
        for numbers in block.rows() {
            let row = layout.row_of_numbers(numbers).map_err(|why| block.at(&why))?;
            self.push(row, remarks);
        }
        (self.layout, self.is_guessed) = (Some(layout), true);
        Ok(())
    }

    fn row(&mut self, line: &Line) -> Result<Row, String> {
        let Self { layout: Some(layout), separator, by_hand, .. } = self else {
            return Err(line.at("no heading names its columns"));
        };
        let separator = *separator.get_or_insert_with(|| Separator::of(&line.text));
        layout.row(separator.words(&line.text), separator).map_err(|why| {
            let way_out = if by_hand.is_some() { "; --columns says so" } else { "" };
            line.at(format!("{why}{way_out}"))
        })
    }

    /// Whether `line` has as many columns as the layout.
    fn has_width_of(&self, line: &Line) -> bool {
        let width = self.separator.unwrap_or(Separator::BLANK).words(&line.text).count();
        self.layout.as_ref().is_some_and(|layout| layout.columns().len() == width)
    }

    /// Whether `row` says that it belongs to another frame than those before it.
    fn is_of_next(&self, row: &Row) -> bool {
        let place = |row: &Row| (row.frame, row.step, row.time);
        self.first.is_some_and(|first| place(&first) != place(row))
    }

    fn push(&mut self, row: Row, remarks: &mut Remarks) {
        if let Some(first) = &self.first {
            if first.z != row.z {
                remarks.add(
                    "its discs have different z, which is left out: there are two dimensions here",
                );
            }
        } else {
            self.first = Some(row);
            let frame = &mut self.begun;
            frame.step = row.step.map(|step| step as u64).or(frame.step);
            frame.time = row.time.or(frame.time);
            frame.side = row.side.or(frame.side);
        }
        if row.kind != 0.0 {
            remarks.add("some of its particles stand or are driven (type not 0): here they move as all others");
        }
        self.last = Some(row);
        self.begun.lacks_radii |= !row.has_radius;
        self.begun.rows.push(row.disc);
    }

    fn finish(&mut self, remarks: &mut Remarks) -> Frame {
        self.finished += 1;
        self.first = None;
        self.ids = Ids::default();
        self.has_head = false;
        let mut frame = std::mem::take(&mut self.begun);
        if let [Some(width), Some(height)] = self.sides {
            match width == height {
                true => frame.side = frame.side.or(Some(width)),
                false => remarks.add(no_square(width, height)),
            }
        }
        self.tell(remarks);
        frame
    }

    /// What is to be said of how the table was read.
    fn tell(&self, remarks: &mut Remarks) {
        if self.of_book >= 2 && self.by_hand.is_none() && self.heading.is_empty() {
            remarks.add("its columns are those of Poeschel and Schwager: x y phi vx vy omega r m");
        }
        if self.separator.is_some_and(|separator| separator.has_decimal_commas) {
            remarks.add("a comma in its numbers is read as a decimal point");
        }
    }

    fn cut_off(&self) -> String {
        format!(
            "its last frame is cut off; frames 0 to {} are whole",
            self.finished.saturating_sub(1)
        )
    }

    /// What stands at the end of the file.
    fn last_frame(&mut self, remarks: &mut Remarks) -> Result<Option<Frame>, String> {
        match (self.begun.rows.is_empty(), self.finished) {
            (false, _) => Ok(Some(self.finish(remarks))),
            // A head without rows is what a full disk leaves.
            (true, 1..) if self.has_head => Err(self.cut_off()),
            _ => Ok(None),
        }
    }
}
