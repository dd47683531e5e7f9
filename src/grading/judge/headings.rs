//! Headings: lines that stand at the same place of each frame and are no discs, as `t = 0.01`, a count, `---`.
//!
//! A row that was cut is none: it stands where it was cut. So a line is a heading only if lines of its shape come back
//! at the same place; of what holds words, the first thing of a passage is one at once.

use std::collections::BTreeMap;

use super::lines::{Kind, Line, Other, Passage};
use super::spot::Spot;

/// A frame while it is read.
#[derive(Clone, Debug, Default)]
pub struct Block {
    /// Its discs.
    pub rows: Vec<Spot>,
    /// Lines that are neither discs nor headings.
    pub bad_rows: usize,
    /// Headings.
    pub headings: usize,
}

impl Block {
    /// Whether there is no line in it.
    pub fn is_empty(&self) -> bool {
        self.rows.is_empty() && self.bad_rows + self.headings == 0
    }
}

/// Where a line stands in its passage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Place {
    /// Before the first disc.
    Head,
    /// Between discs.
    Middle,
    /// After the last.
    Foot,
    /// There is no disc.
    Alone,
}

/// Lines of one shape that follow each other.
#[derive(Clone, Copy, Debug)]
struct Group {
    passage: usize,
    place: Place,
    /// Discs before it.
    before: usize,
    /// Discs of its passage.
    rows: usize,
    /// Lines.
    times: usize,
    /// The first of them.
    line: Other,
}

/// At which places lines of a shape are headings.
#[derive(Clone, Copy, Debug, Default)]
struct Role {
    head: bool,
    foot: bool,
    alone: bool,
    /// Between discs, without parting frames.
    remark: bool,
    /// Between discs, where a frame ends and the next begins.
    parts: bool,
    /// The count that it is at most feet, if it is a number.
    count: Option<usize>,
    /// How many follow each other.
    times: usize,
}

/// Which lines are headings.
#[derive(Debug, Default)]
pub struct Headings {
    roles: Vec<Role>,
}

impl Headings {
    /// The headings in all passages of a film that has so many shapes.
    pub fn of(passages: &[Passage], shapes: usize) -> Self {
        let mut groups: Vec<Vec<Group>> = vec![Vec::new(); shapes];
        for (k, passage) in passages.iter().enumerate() {
            for group in groups_of(k, passage) {
                groups[group.line.shape].push(group);
            }
        }
        let full = passages.iter().filter(|passage| rows(passage) > 0).count();
        let last = passages.len().saturating_sub(1);
        Self { roles: groups.iter().map(|groups| Role::of(groups, full, last)).collect() }
    }

    /// The frames of a passage: one, or more if headings part them.
    pub fn blocks(&self, passage: &Passage) -> Vec<Block> {
        let (mut blocks, mut block) = (Vec::new(), Block::default());
        let (all, mut before) = (rows(passage), 0);
        for piece in pieces(passage) {
            let place = Place::of(before, all);
            let is_heading = self.headings(piece, place);
            for (line, is_heading) in piece.iter().zip(is_heading) {
                match line {
                    Line::Row(spot) => block.rows.push(*spot),
                    Line::Other(_) if !is_heading => block.bad_rows += 1,
                    Line::Other(other) => {
                        if self.roles[other.shape].parts && block.rows.len() + block.bad_rows > 0 {
                            blocks.push(std::mem::take(&mut block));
                        }
                        block.headings += 1;
                    }
                }
            }
            before += rows(piece);
        }
        blocks.extend((!block.is_empty()).then_some(block));
        blocks
    }

    /// Which of the lines that follow each other are headings. A cut row may look like a count; it comes before it: what
    /// is more of a shape than there should be is a cut row.
    fn headings(&self, piece: &[Line], place: Place) -> Vec<bool> {
        let mut left: BTreeMap<usize, usize> = BTreeMap::new();
        let mut is_heading: Vec<bool> = piece
            .iter()
            .rev()
            .map(|line| {
                let Line::Other(other) = line else { return false };
                let role = self.roles[other.shape];
                let left = left.entry(other.shape).or_insert(role.times);
                let is_more = *left == 0 && other.kind == Kind::Numbers;
                *left = left.saturating_sub(1);
                !is_more && role.holds(other, place)
            })
            .collect();
        is_heading.reverse();
        is_heading
    }
}

impl Place {
    fn of(before: usize, rows: usize) -> Self {
        match before {
            _ if rows == 0 => Self::Alone,
            0 => Self::Head,
            before if before == rows => Self::Foot,
            _ => Self::Middle,
        }
    }
}

impl Role {
    /// What lines are for that stand in these places. `full`: passages with discs; `last`: the number of the last passage.
    fn of(groups: &[Group], full: usize, last: usize) -> Self {
        let Some(first) = groups.first() else { return Self::default() };
        let (kind, times) = (first.line.kind, usual(groups.iter().map(|group| group.times)).0);
        if kind == Kind::Broken {
            return Self::default();
        }
        let is_words = kind == Kind::Words;
        let at = |place: Place| groups.iter().filter(move |group| group.place == place);
        let is_often = |place: Place| at(place).count() > 0 && 2 * at(place).count() >= full;
        let is_first = |place: Place| first.passage == 0 && first.place == place;
        let (count, times_counted) = usual(at(Place::Foot).filter_map(|group| group.line.count));
        let is_true = at(Place::Foot).any(|group| group.rows == count && count > 0);
        let count = Some(count).filter(|_| is_true && 2 * times_counted >= full);
        let is_last = at(Place::Foot).any(|group| group.passage == last);
        let is_foot = if is_words { is_often(Place::Foot) || is_last } else { count.is_some() };
        let remark = is_words && is_remark(groups, full);
        let parts = !remark && is_often(Place::Middle) && parts(groups, is_words);
        let is_one_of = |place: Place| {
            at(place).count() > 0 && (is_words || is_often(place) || is_first(place))
        };
        let [head, alone] = [Place::Head, Place::Alone].map(is_one_of);
        Self { head, foot: is_foot, alone, remark, parts, count, times }
    }

    /// Whether a line of this shape is a heading at this place of a passage.
    fn holds(self, line: &Other, place: Place) -> bool {
        self.parts
            || match place {
                Place::Head => self.head,
                Place::Middle => self.remark,
                Place::Foot => self.foot && (line.kind == Kind::Words || line.count == self.count),
                Place::Alone => self.alone,
            }
    }
}

/// Whether lines stand once between the same discs of three passages of four, which are frames already.
fn is_remark(groups: &[Group], full: usize) -> bool {
    let middle = groups.iter().filter(|group| group.place == Place::Middle);
    let mut in_passage: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
    for group in middle {
        in_passage.entry(group.passage).or_default().push(group.before);
    }
    let once =
        in_passage.values().filter_map(|all| if let [one] = all[..] { Some(one) } else { None });
    full >= 3 && 4 * usual(once).1 >= 3 * full
}

/// Whether lines part frames: most have as many discs between them as others, or, words that is, a passage begins
/// with one.
fn parts(groups: &[Group], is_words: bool) -> bool {
    let mut gaps = Vec::new();
    let (mut passage, mut from, mut rows) = (usize::MAX, 0, 0);
    for group in groups {
        if group.passage != passage {
            gaps.push(rows - from);
            (passage, from, rows) = (group.passage, 0, group.rows);
        }
        gaps.push(group.before - from);
        from = group.before;
    }
    gaps.push(rows - from);
    gaps.retain(|&gap| gap > 0);
    let (_, alike) = usual(gaps.iter().copied());
    let are_alike = alike >= 2 && 2 * alike >= gaps.len();
    let middle = groups.iter().find(|group| group.place == Place::Middle);
    let is_at_an_end = |group: &Group| {
        let is_end = matches!(group.place, Place::Head | Place::Foot);
        is_end && middle.is_some_and(|middle| middle.passage == group.passage)
    };
    let begins = groups.iter().any(is_at_an_end);
    if is_words { are_alike || begins } else { are_alike && begins }
}

/// The most frequent of `values`, and how often it is there.
fn usual(values: impl Iterator<Item = usize>) -> (usize, usize) {
    let mut often: BTreeMap<usize, usize> = BTreeMap::new();
    for value in values {
        *often.entry(value).or_default() += 1;
    }
    often.into_iter().max_by_key(|(_, count)| *count).unwrap_or_default()
}

fn rows(lines: &[Line]) -> usize {
    lines.iter().filter(|line| matches!(line, Line::Row(_))).count()
}

/// Runs of discs and runs of other lines, by turns.
fn pieces(passage: &Passage) -> impl Iterator<Item = &[Line]> {
    passage.chunk_by(|a, b| matches!(a, Line::Row(_)) == matches!(b, Line::Row(_)))
}

/// The groups in the passage of this number.
fn groups_of(k: usize, passage: &Passage) -> Vec<Group> {
    let (all, mut before) = (rows(passage), 0);
    let mut groups = Vec::new();
    for piece in pieces(passage) {
        let mut own: BTreeMap<usize, Group> = BTreeMap::new();
        for line in piece {
            let Line::Other(line) = *line else { continue };
            let place = Place::of(before, all);
            let new = Group { passage: k, place, before, rows: all, times: 0, line };
            own.entry(line.shape).or_insert(new).times += 1;
        }
        groups.extend(own.into_values());
        before += rows(piece);
    }
    groups
}
