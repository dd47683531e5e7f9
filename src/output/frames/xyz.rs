//! XYZ and extended XYZ: a count, a line of remarks, and so many rows. Read by OVITO, ASE and VMD.
//!
//! In the extended form the remarks are `key=value`: `Properties` names the columns, `Lattice` is the box,
//! `Time` the time (<https://github.com/libAtoms/extxyz>).

use std::io::{self, BufRead, Write};

use super::column::Column;
use super::frame::{Frame, FrameRow, frame_of_rows};
use super::guess::{self, Guess, Sample};
use super::layout::Layout;
use super::lines::Lines;
use super::remarks::{IS_PERIODIC, Remarks, no_corner, no_square};
use super::rows::push_values;
use super::separator::{Separator, shortened};
use crate::output::number::push_g9;

const BLANK: Separator = Separator::BLANK;

/// A file in this format while it is read.
#[derive(Debug, Default)]
pub struct Xyz {
    /// The columns said by hand.
    by_hand: Option<Layout>,
    /// The radius of all discs, m, where no column says it.
    radius: Option<f64>,
    /// Those of the first frame, where it has no `Properties`.
    first: Option<Layout>,
    is_guessed: bool,
}

impl Xyz {
    /// A file with these columns, if they are said by hand; its discs have this `radius` (m) where no column says it.
    pub fn new(by_hand: Option<Layout>, radius: Option<f64>) -> Self {
        Self { by_hand, radius, ..Self::default() }
    }

    /// Whether the columns are named, by the file or by hand.
    pub fn names_columns(&self) -> bool {
        !self.is_guessed
    }

    /// The next frame.
    pub fn next_frame<R: BufRead>(
        &mut self,
        lines: &mut Lines<R>,
        remarks: &mut Remarks,
    ) -> Result<Option<Frame>, String> {
        let Some(n) = count(lines)? else { return Ok(None) };
        let Some(line) = lines.next()? else { return Err(cut(0, n)) };
        let remark = line.text.into_owned();
        let pairs = pairs(&remark);
        let properties = value(&pairs, "properties");
        let properties = properties.map(|text| columns(text, self.radius)).transpose()?;
        let discs = match self.by_hand.as_ref().or(properties.as_ref()).or(self.first.as_ref()) {
            Some(layout) => each_row(lines, n, |row| layout.row(row.split_whitespace(), BLANK))?,
            None => {
                let rows = each_row(lines, n, |row| Ok(row.to_owned()))?;
                let layout = self.layout(&remark, &rows, remarks)?;
                let discs = rows.iter().map(|row| layout.row(row.split_whitespace(), BLANK));
                let discs = discs.collect::<Result<_, _>>()?;
                self.first = Some(layout);
                discs
            }
        };
        let mut frame = frame_of_rows(&discs, lines.number(), remarks)?;
        frame.time = value(&pairs, "time").and_then(|time| time.parse().ok());
        frame.step =
            ["step", "timestep"].into_iter().find_map(|key| value(&pairs, key)?.parse().ok());
        let pbc = value(&pairs, "pbc").unwrap_or_default();
        if pbc.split_whitespace().take(2).any(|axis| axis.starts_with(['T', 't', '1'])) {
            remarks.add(IS_PERIODIC);
        }
        frame.side = side(&pairs, remarks);
        Ok(Some(frame))
    }

    /// The columns of a file without `Properties`, from its remark or its rows.
    fn layout(
        &mut self,
        remark: &str,
        rows: &[String],
        remarks: &mut Remarks,
    ) -> Result<Layout, String> {
        let first = rows.first().map_or("", String::as_str);
        let n = first.split_whitespace().count();
        let named = Layout::named(remark.trim_start_matches('#').split_whitespace());
        if let Some(named) = named.ok().filter(|named| named.columns().len() == n) {
            return named.with_radius(self.radius, "its second line");
        }
        let is_number = |word: &str| word.parse::<f64>().is_ok();
        if !first.split_whitespace().all(is_number) {
            return self.with_element(n);
        }
        let mut numbers = Vec::with_capacity(n * rows.len());
        for row in rows {
            for word in row.split_whitespace() {
                numbers.push(BLANK.number(word)?);
            }
        }
        if numbers.len() != n * rows.len() {
            return Err("its rows have not all the same number of columns".to_owned());
        }
        let Guess { layout, remark } =
            guess::guess(&Sample { numbers: &numbers, columns: n }, self.radius)?;
        remark.into_iter().for_each(|remark| remarks.add(remark));
        self.is_guessed = true;
        Ok(layout)
    }

    /// `n` columns of which the first is an element: then come x, y and perhaps z.
    fn with_element(&self, n: usize) -> Result<Layout, String> {
        use Column::{Other, X, Y, Z};
        if self.radius.is_some() && (n == 3 || n == 4) {
            let columns = [Other, X, Y, Z].into_iter().take(n).collect();
            return Layout::of(columns)?.with_radius(self.radius, "an element and coordinates");
        }
        let one = "--radius 1e-3, with --start and convert";
        let way_out = match n {
            0..4 => format!("{one}, if they are an element, x and y"),
            4 => format!(
                "{one}, if they are an element, x, y and z; --columns -,x,y,r if the last is the radius"
            ),
            _ => "--columns -,x,y,-,r if the radius comes after an element and x y z".to_owned(),
        };
        Err(format!(
            "nothing says which of its {n} columns is the radius: it has no Properties=...\n  way out: {way_out}"
        ))
    }
}

/// The number of discs with which a frame begins; none at the end of the file.
fn count<R: BufRead>(lines: &mut Lines<R>) -> Result<Option<usize>, String> {
    while let Some(line) = lines.next()? {
        if !line.text.is_empty() {
            let n = line.text.parse();
            let why = || {
                let said = shortened(&line.text);
                line.at(format!("a frame begins with the number of its discs, not `{said}`"))
            };
            return n.map(Some).map_err(|_| why());
        }
    }
    Ok(None)
}

/// The next `n` lines as `read` reads them.
pub(super) fn each_row<R: BufRead, T>(
    lines: &mut Lines<R>,
    n: usize,
    read: impl Fn(&str) -> Result<T, String>,
) -> Result<Vec<T>, String> {
    let mut rows = Vec::new();
    for k in 0..n {
        match lines.next()? {
            Some(line) if !line.is_cut || k + 1 == n => {
                rows.push(read(&line.text).map_err(|why| line.at(why))?);
            }
            _ => return Err(cut(k, n)),
        }
    }
    Ok(rows)
}

fn cut(read: usize, n: usize) -> String {
    format!("the frame is cut off: {read} of {n} discs")
}

/// The columns that `species:S:1:pos:R:3` and the like name.
fn columns(properties: &str, radius: Option<f64>) -> Result<Layout, String> {
    use Column::{Diameter, Id, Mass, Other, Radius, Vx, Vy, X, Y, Z};
    let parts: Vec<&str> = properties.split(':').collect();
    let mut columns = Vec::new();
    for part in parts.chunks(3) {
        let &[name, _, width] = part else {
            return Err(format!("Properties={properties} is not made of name:type:columns"));
        };
        let known: &[Column] = match name.to_lowercase().as_str() {
            "pos" | "position" | "positions" => &[X, Y, Z],
            "radius" | "radii" => &[Radius],
            "diameter" => &[Diameter],
            "velo" | "vel" | "velocity" | "velocities" => &[Vx, Vy],
            "mass" | "masses" => &[Mass],
            "id" | "ids" => &[Id],
            _ => &[],
        };
        let width = width
            .parse::<usize>()
            .map_err(|_| format!("Properties={properties}: `{width}` columns"))?;
        let more = std::iter::repeat(Other);
        columns.extend(known.iter().copied().chain(more).take(width.min(1000)));
    }
    let heading = format!("Properties={properties}");
    let layout = Layout::of(columns).map_err(|why| format!("{why} ({heading})"))?;
    layout.with_radius(radius, &heading)
}

/// The `key=value` pairs of a remark, keys in lower case; a value may stand in quotes.
fn pairs(remark: &str) -> Vec<(String, String)> {
    let mut pairs = Vec::new();
    let mut rest = remark;
    while let Some((before, after)) = rest.split_once('=') {
        let key = before.split_whitespace().next_back().unwrap_or_default();
        let after = after.trim_start();
        let quote = after.chars().next().filter(|c| ['"', '\''].contains(c));
        let (value, further) = match quote {
            Some(quote) => after[1..].split_once(quote).unwrap_or((&after[1..], "")),
            None => after.split_once(char::is_whitespace).unwrap_or((after, "")),
        };
        pairs.push((key.trim_matches('"').to_lowercase(), value.to_owned()));
        rest = further;
    }
    pairs
}

fn value<'a>(pairs: &'a [(String, String)], key: &str) -> Option<&'a str> {
    pairs.iter().find(|(said, _)| said == key).map(|(_, value)| value.as_str())
}

/// The side of the box, m, if there is one, square, with a corner at 0 as ours.
fn side(pairs: &[(String, String)], remarks: &mut Remarks) -> Option<f64> {
    let numbers =
        |text: &str| text.split_whitespace().map(str::parse).collect::<Result<Vec<f64>, _>>();
    let lattice = numbers(value(pairs, "lattice")?).ok()?;
    let &[width, a, _, b, height, ..] = &lattice[..] else { return None };
    let origin = value(pairs, "origin").and_then(|text| numbers(text).ok()).unwrap_or_default();
    if origin.iter().take(2).any(|&corner| corner != 0.0) {
        remarks.add(no_corner(&origin));
        return None;
    }
    if width != height || a != 0.0 || b != 0.0 {
        remarks.add(no_square(width, height));
        return None;
    }
    Some(width)
}

/// Writes a frame as extended XYZ. What the frame does not say is left out; z is 0, and the box twice the
/// largest radius thick.
pub fn write(out: &mut impl Write, frame: &Frame) -> io::Result<()> {
    let (has_velocity, has_mass) = (frame.has_velocities(), frame.has_masses());
    let mut text = format!("{}\n", frame.rows.len()).into_bytes();
    if let Some(side) = frame.side {
        let thick = 2.0 * frame.rows.iter().map(|row| row.radius).fold(0.0, f64::max);
        text.extend(b"Lattice=\"");
        push_values(&mut text, &[side, 0.0, 0.0, 0.0, side, 0.0, 0.0, 0.0, thick]);
        text.extend(b"\" Origin=\"0 0 0\" pbc=\"F F F\" ");
    }
    text.extend(b"Properties=species:S:1:pos:R:3:radius:R:1");
    text.extend(if has_velocity { &b":velo:R:3"[..] } else { b"" });
    text.extend(if has_mass { &b":mass:R:1"[..] } else { b"" });
    text.extend(b":id:I:1");
    if let Some(time) = frame.time {
        text.extend(b" Time=");
        push_g9(&mut text, time);
    }
    if let Some(step) = frame.step {
        text.extend(format!(" Step={step}").bytes());
    }
    text.push(b'\n');
    for (k, row) in frame.rows.iter().enumerate() {
        text.extend(b"X ");
        push_in_space(&mut text, row);
        text.extend(format!(" {}\n", row.id.unwrap_or(k as u64)).bytes());
    }
    out.write_all(&text)
}

/// A disc as three dimensions have it: x y z radius, then vx vy vz and the mass where they are known.
pub(super) fn push_in_space(text: &mut Vec<u8>, row: &FrameRow) {
    push_values(text, &[row.position.x, row.position.y, 0.0, row.radius]);
    if let Some(velocity) = row.velocity {
        text.push(b' ');
        push_values(text, &[velocity.x, velocity.y, 0.0]);
    }
    if let Some(mass) = row.mass {
        text.push(b' ');
        push_g9(text, mass);
    }
}
