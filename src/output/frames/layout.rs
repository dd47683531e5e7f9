//! Which column of a file is what: said by a heading, by hand, or by the format.

use std::fmt;
use std::str::FromStr;

use glam::DVec2;
use serde::{Deserialize, Serialize};

use super::column::Column;
use super::frame::{FrameRow, Row};
use super::separator::{EMPTY, Separator};

/// Which column is what, from the first on.
///
/// ```
/// use parsim2d::output::frames::layout::Layout;
/// let layout: Layout = "x,y,-,r".parse().unwrap(); // as --columns takes it
/// assert_eq!(layout.to_string(), "x,y,-,r");
/// assert!("x,r".parse::<Layout>().is_err()); // where is y?
/// ```
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Layout {
    columns: Vec<Column>,
    /// Whether rows may have further columns.
    is_begin: bool,
    /// The radius of all discs, m, where no column says it.
    radius: Option<f64>,
}

impl Layout {
    /// These columns. Fails if a disc needs one more, or two are the same; a radius may be
    /// said by [`with_radius`](Self::with_radius).
    pub fn of(mut columns: Vec<Column>) -> Result<Self, String> {
        if columns.contains(&Column::Radius) {
            let diameters = columns.iter_mut().filter(|column| **column == Column::Diameter);
            diameters.for_each(|column| *column = Column::Other); // says the same
        }
        let layout = Self { columns, is_begin: false, radius: None };
        let (names, has) = (layout.names(), |column| layout.has(column));
        let twice =
            layout.columns.iter().enumerate().find(|(k, column)| {
                **column != Column::Other && layout.columns[..*k].contains(column)
            });
        if let Some((_, column)) = twice {
            return Err(format!("of its columns `{names}` two are {}", column.name()));
        }
        if !has(Column::X) || !has(Column::Y) {
            return Err(format!("none of its columns `{names}` is x, or none is y"));
        }
        if has(Column::Vx) != has(Column::Vy) {
            return Err(format!("its columns `{names}` have one of vx and vy, not both"));
        }
        Ok(layout)
    }

    /// The columns of these `names`.
    pub fn named<'a>(names: impl Iterator<Item = &'a str>) -> Result<Self, String> {
        Self::of(names.map(Column::named).collect::<Result<_, _>>()?)
    }

    /// The same; all discs have this `radius` (m) if no column says theirs.
    ///
    /// Fails if nothing says it. `heading` is what names the columns, to say so.
    pub fn with_radius(self, radius: Option<f64>, heading: &str) -> Result<Self, String> {
        if self.has_radius() {
            return Ok(self);
        }
        if radius.is_some() {
            return Ok(Self { radius, ..self });
        }
        let free = |column: &Column| matches!(column, Column::Other | Column::Z);
        let last = self.columns.iter().rposition(free);
        let by_hand = last.map(|last| {
            let mut columns = self.clone();
            columns.columns[last] = Column::Radius;
            format!(", or --columns {columns} if it is column {}", last + 1)
        });
        Err(format!(
            "none of its columns `{}` is a radius, r ({heading})\n  way out: --radius 1e-3 is that of all discs, with \
             --start and convert{}",
            self.names(),
            by_hand.unwrap_or_default()
        ))
    }

    /// Whether a column says the radius.
    pub fn has_radius(&self) -> bool {
        self.has(Column::Radius) || self.has(Column::Diameter)
    }

    /// The columns.
    pub fn columns(&self) -> &[Column] {
        &self.columns
    }

    /// Whether there is such a column.
    pub fn has(&self, column: Column) -> bool {
        self.columns.contains(&column)
    }

    /// The same, but that `column` is passed over.
    pub fn without(&self, column: Column) -> Self {
        let kept = |one: &Column| if *one == column { Column::Other } else { *one };
        Self { columns: self.columns.iter().map(kept).collect(), ..self.clone() }
    }

    /// The same columns behind one that is passed over.
    pub fn after_index(&self) -> Self {
        let columns = std::iter::once(Column::Other).chain(self.columns.iter().copied());
        Self { columns: columns.collect(), ..self.clone() }
    }

    /// The names with blanks between them, as in a heading.
    pub fn names(&self) -> String {
        self.columns.iter().map(|column| column.name()).collect::<Vec<_>>().join(" ")
    }

    /// Whether gnuplot, told to take columns 1 to 3 and 4 and 5, takes the right ones.
    pub fn is_plain(&self) -> bool {
        use Column::{Radius, Vx, Vy, X, Y};
        let begin = |wanted: &[Column]| self.columns.starts_with(wanted);
        begin(&[X, Y, Radius, Vx, Vy]) || begin(&[X, Y, Radius]) && !self.has(Vx)
    }

    /// What the words of a row say.
    pub fn row<'a>(
        &self,
        words: impl Iterator<Item = &'a str>,
        separator: Separator,
    ) -> Result<Row, String> {
        self.row_of(words, |word| match separator.number(word)? {
            value if value.is_finite() => Ok(value),
            _ => Err(format!("`{word}` is not finite")),
        })
    }

    /// What a row of numbers says.
    pub fn row_of_numbers(&self, numbers: &[f64]) -> Result<Row, String> {
        self.row_of(numbers.iter(), |number| match number.is_finite() {
            true => Ok(*number),
            false => Err(format!("`{number}` is not finite")),
        })
    }

    fn row_of<T: Copy>(
        &self,
        mut cells: impl Iterator<Item = T>,
        number: impl Fn(T) -> Result<f64, String>,
    ) -> Result<Row, String> {
        let mut row = Row { has_radius: self.radius.is_none(), ..Row::NOTHING };
        row.disc.radius = self.radius.unwrap_or_default();
        let mut read = 0;
        let mut velocity = DVec2::ZERO;
        for (column, cell) in self.columns.iter().zip(cells.by_ref()) {
            read += 1;
            if *column != Column::Other {
                let value = number(cell).map_err(|why| match why == EMPTY {
                    true => format!("column {read}, {}, is empty", column.name()),
                    false => why,
                })?;
                row.take(*column, value, &mut velocity)?;
            }
        }
        let wanted = self.columns.len();
        if read < wanted || !self.is_begin && cells.next().is_some() {
            let than = if read < wanted { "fewer" } else { "more" };
            return Err(format!("{than} columns than the {wanted} of `{}`", self.names()));
        }
        row.disc.velocity = self.has(Column::Vx).then_some(velocity);
        Ok(row)
    }
}

impl Row {
    const NOTHING: Self = Self {
        disc: FrameRow { position: DVec2::ZERO, radius: 0.0, velocity: None, mass: None, id: None },
        z: None,
        kind: 0.0,
        frame: None,
        step: None,
        time: None,
        has_radius: true,
        side: None,
    };

    fn take(&mut self, column: Column, value: f64, velocity: &mut DVec2) -> Result<(), String> {
        match column {
            Column::X => self.disc.position.x = value,
            Column::Y => self.disc.position.y = value,
            Column::Z => self.z = Some(value),
            Column::Radius => self.disc.radius = value,
            Column::Diameter => self.disc.radius = 0.5 * value,
            Column::Vx => velocity.x = value,
            Column::Vy => velocity.y = value,
            Column::Mass => self.disc.mass = Some(value),
            // Whole numbers up to 2^53 are exact.
            Column::Id if value >= 0.0 && value.fract() == 0.0 && value < 9e15 => {
                self.disc.id = Some(value as u64);
            }
            Column::Id => return Err(format!("an id is a whole number from 0, not {value}")),
            Column::Frame => self.frame = Some(value),
            Column::Step => self.step = Some(value),
            Column::Time => self.time = Some(value),
            Column::Side => self.side = Some(value),
            Column::Kind => self.kind = value,
            Column::Other => {}
        }
        Ok(())
    }
}

impl FromStr for Layout {
    type Err = String;

    fn from_str(said: &str) -> Result<Self, String> {
        let column = |name: &str| match (name.trim(), Column::named(name)?) {
            ("-" | "_" | "", _) => Ok(Column::Other),
            (name, Column::Other) => Err(format!(
                "`{name}` is none of x, y, z, r, d (diameter), vx, vy, m, id, frame, step, time_s, side_m, nor - for a \
                 column to pass over"
            )),
            (_, column) => Ok(column),
        };
        let columns = said.split(',').map(column).collect::<Result<_, _>>()?;
        let layout = Self::of(columns).map_err(|why| format!("{why}; as x,y,-,r"))?;
        Ok(Self { is_begin: true, ..layout })
    }
}

impl fmt::Display for Layout {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (k, column) in self.columns.iter().enumerate() {
            let comma = if k > 0 { "," } else { "" };
            write!(f, "{comma}{}", column.name())?;
        }
        Ok(())
    }
}

impl TryFrom<String> for Layout {
    type Error = String;

    fn try_from(said: String) -> Result<Self, String> {
        said.parse()
    }
}

impl From<Layout> for String {
    fn from(layout: Layout) -> Self {
        layout.to_string()
    }
}
