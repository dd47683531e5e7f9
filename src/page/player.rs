//! A run to look at: its frames and energies within a page, and the script that shows them.

use serde::Serialize;

use super::film::{ABSENT, BYTES, FASTEST, Film, SCALE};
use super::html::{data, escaped, page};
use super::words::{PlayerWords, Words};
use crate::analysis::energy::LedgerRow;
use crate::figure::energy::{self, EXPLODED};
use crate::figure::{colour, label};

const SCRIPT: &str = include_str!("player.js");
/// Moments of the energies, at most; the picture is not so many pixels wide.
const MOST_MOMENTS: usize = 600;
/// Colours of speeds.
const SHADES: usize = 32;
/// Wall time of the whole run at the usual pace, s: a fall through the box is seen to happen.
const LENGTH: f64 = 12.0;
/// Paces, and which of them is the usual one.
const PACES: [(&str, &str); 7] = [
    ("0.03125", "1/32\u{d7}"),
    ("0.125", "1/8\u{d7}"),
    ("0.25", "1/4\u{d7}"),
    ("0.5", "1/2\u{d7}"),
    ("1", "1\u{d7}"),
    ("2", "2\u{d7}"),
    ("4", "4\u{d7}"),
];
const USUAL_PACE: &str = "1";

/// Pixels of a picture on a small screen.
const NARROW: f64 = 330.0;

/// The energies, one curve each, in one unit.
#[derive(Serialize)]
struct Energies {
    unit: String,
    #[serde(rename = "isLog")]
    is_log: bool,
    times: Vec<f64>, // s
    curves: Vec<Curve>,
}

#[derive(Serialize)]
struct Curve {
    name: &'static str,
    colour: &'static str,
    values: Vec<f64>, // of the unit
}

/// What the script reads; it knows no other numbers.
#[derive(Serialize)]
struct Data<'a> {
    corner: [f64; 2], // m
    width: f64,       // m
    side: Option<f64>,
    times: Option<Vec<f64>>, // s
    frames: usize,
    radii: Vec<f64>, // m
    fastest: Option<f64>,
    shades: Vec<String>,
    plain: String,
    least: f64, // px
    bytes: usize,
    scale: u16,
    top: u8,
    absent: u8,
    length: f64,
    begins: bool,
    energies: Option<Energies>,
    words: &'a PlayerWords,
    places: String,
}

/// Whether a player begins by itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beginning {
    /// As soon as the page is open.
    AtOnce,
    /// When somebody asks for it.
    WhenAsked,
}

/// A page of a player alone.
pub fn alone(film: &Film, rows: &[LedgerRow], words: &Words) -> String {
    let heading = format!("<h1>{}</h1>\n", escaped(words.player.title));
    let body = heading + &player(film, rows, &words.player, Beginning::AtOnce);
    page(words.code, words.player.title, "alone", &body)
}

/// The player of a film, beside the energies of the ledger `rows`, if there are any.
pub fn player(film: &Film, rows: &[LedgerRow], words: &PlayerWords, begins: Beginning) -> String {
    // Without times it is not known which energies belong to a frame.
    let energies = film.times().and_then(|_| energies(rows, words));
    let beside = energies.as_ref().map_or(String::new(), |energies| beside(energies, words));
    let bar = film.fastest().map_or(String::new(), |fastest| bar(fastest, words));
    let seen = escaped(words.picture);
    let (controls, note) = (controls(film, words), note(film, words));
    let stage = format!(
        "<div class=\"stage\">\n<div>\n<canvas id=\"discs\" role=\"img\" aria-label=\"{seen}\"></canvas>\n\
         {controls}{bar}</div>\n{beside}</div>\n"
    );
    let script = format!("<script>\n{SCRIPT}</script>\n");
    let film = data("film", &contents(film, energies, words, begins));
    format!("<section class=\"player\">\n{stage}{note}</section>\n{film}{script}")
}

fn contents<'a>(
    film: &Film,
    energies: Option<Energies>,
    words: &'a PlayerWords,
    begins: Beginning,
) -> impl Serialize + 'a {
    let view = film.view();
    let shade = |k: usize| colour::hex(colour::at(k as f64 / (SHADES - 1) as f64));
    Data {
        corner: view.corner.into(),
        width: view.width,
        side: film.side(),
        times: film.times(),
        frames: film.frames().0,
        radii: film.radii().iter().map(|radius| digits(*radius)).collect(),
        fastest: film.fastest(),
        shades: (0..SHADES).map(shade).collect(),
        plain: colour::OKABE_ITO[0].to_owned(),
        least: least_radius(film),
        bytes: BYTES,
        scale: SCALE,
        top: FASTEST,
        absent: ABSENT,
        length: LENGTH,
        begins: begins == Beginning::AtOnce,
        energies,
        words,
        places: film.places(),
    }
}

/// Discs are drawn with this radius at least, px: as many as there are, they do not fill the picture.
fn least_radius(film: &Film) -> f64 {
    if film.discs() <= 500 { 1.6 } else { 0.7 }
}

/// The energies at no more moments than can be seen, the first and the last among them.
fn energies(all: &[LedgerRow], words: &PlayerWords) -> Option<Energies> {
    if all.len() < 2 {
        return None;
    }
    let kept = all.len().min(MOST_MOMENTS);
    let rows: Vec<&LedgerRow> = (0..kept).map(|k| &all[k * (all.len() - 1) / (kept - 1)]).collect();
    let largest = |column: fn(&LedgerRow) -> f64| {
        rows.iter().map(|row| column(row).abs()).fold(0.0, f64::max)
    };
    let shown: Vec<_> = energy::energies(all).collect();
    let largest = shown.iter().map(|(.., column)| largest(*column)).fold(0.0, f64::max);
    let at_start: f64 = shown.iter().map(|(.., column)| column(rows[0]).abs()).sum();
    let is_log = largest > EXPLODED * at_start && at_start > 0.0;
    let (prefix, power) = if is_log { (String::new(), 0) } else { label::prefix(largest) };
    let curves = shown.into_iter().map(|(name, _, colour, _, column)| {
        let said = words.energies.iter().find(|(known, _)| *known == name);
        let values = rows.iter().map(|row| digits(column(row) * 10f64.powi(-power))).collect();
        Curve { name: said.map_or(name, |(_, said)| said), colour, values }
    });
    Some(Energies {
        unit: format!("{prefix}J"),
        is_log,
        times: rows.iter().map(|row| row.time_s).collect(),
        curves: curves.collect(),
    })
}

/// Six digits: a picture needs no more, and the page becomes smaller.
fn digits(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

/// The curves of the energies, and their values at the moment.
fn beside(energies: &Energies, words: &PlayerWords) -> String {
    let item = |curve: &Curve| {
        let Curve { name, colour, .. } = curve;
        format!("<dt style=\"color: {colour}\">{}</dt><dd></dd>\n", escaped(name))
    };
    let items: String = energies.curves.iter().map(item).collect();
    let seen = escaped(words.curves);
    format!(
        "<div>\n<canvas id=\"energies\" role=\"img\" aria-label=\"{seen}\"></canvas>\n\
         <dl id=\"now\">\n{items}</dl>\n</div>\n"
    )
}

/// What the colours say.
fn bar(fastest: f64, words: &PlayerWords) -> String {
    let shades: Vec<String> = colour::SCALE.iter().map(|shade| colour::hex(*shade)).collect();
    format!(
        "<p class=\"bar\"><span>{}</span> 0 <i style=\"background: linear-gradient(to right, {})\"></i> {} m/s</p>\n",
        escaped(words.speed),
        shades.join(", "),
        label::short(fastest, 3)
    )
}

fn controls(film: &Film, words: &PlayerWords) -> String {
    let button = |id: &str, text: &str, said: &str| {
        let (text, said) = (escaped(text), escaped(said));
        format!("<button type=\"button\" id=\"{id}\" title=\"{said}\">{text}</button>\n")
    };
    let paces = PACES.map(|(value, text)| {
        let chosen = if value == USUAL_PACE { " selected" } else { "" };
        format!("<option value=\"{value}\"{chosen}>{text}</option>")
    });
    let last = film.frames().0.saturating_sub(1);
    [
        "<div class=\"controls\">\n".to_owned(),
        button("play", words.play, words.play_said),
        button("back", "\u{2039}", words.back),
        button("forth", "\u{203a}", words.forth),
        format!(
            "<input type=\"range\" id=\"moment\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"{}\">\n",
            escaped(words.moment)
        ),
        "<output id=\"clock\"></output>\n".to_owned(),
        format!(
            "<label>{} <select id=\"pace\">{}</select></label>\n<span id=\"rate\"></span>\n",
            escaped(words.pace),
            paces.concat()
        ),
        "</div>\n".to_owned(),
    ]
    .concat()
}

/// What the film leaves out, how it is played by keys, and what is to be seen without a script.
fn note(film: &Film, words: &PlayerWords) -> String {
    let (kept, all) = film.frames();
    let mut parts = Vec::new();
    if kept < all {
        let said = words.fewer_frames.replacen("{}", &kept.to_string(), 1);
        parts.push(said.replacen("{}", &all.to_string(), 1));
    }
    if film.disc_step() > 1 {
        parts.push(words.fewer_discs.replacen("{}", &film.disc_step().to_string(), 1));
    }
    if least_radius(film) * film.view().width / NARROW
        > film.radii().iter().copied().fold(0.0, f64::max)
    {
        parts.push(words.enlarged.to_owned());
    }
    parts.push(words.keys.to_owned());
    let without = escaped(words.no_script);
    format!(
        "<p class=\"note\">{}</p>\n<noscript><p>{without}</p></noscript>\n",
        escaped(&parts.join(" "))
    )
}
