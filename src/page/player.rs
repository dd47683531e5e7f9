//! A run to look at: its frames and energies within a page, and the script that shows them.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

use super::film::{ABSENT, BYTES, FASTEST, Film, SCALE};
use super::html::{Page, data};
use super::words::{PlayerWords, Words};
use crate::analysis::energy::LedgerRow;
use crate::figure::energy::{self, EXPLODED};
use crate::figure::{colour, label};
use crate::number::{rounded, typographic};

/// Digits of the numbers: a picture needs no more, and the page becomes smaller.
const DIGITS: usize = 6;
const SCRIPT: &str = include_str!("player.js");
/// The style of pages with a player.
pub const STYLE: &str = include_str!("style.css");
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
    let (language, title) = (words.code, words.player.title);
    Page { language, title, class: "alone", style: STYLE, has_script: true }.around(&html! {
        h1 { (title) }
        (player(film, rows, &words.player, Beginning::AtOnce))
    })
}

/// The player of a film, beside the energies of the ledger `rows`, if there are any.
pub fn player(film: &Film, rows: &[LedgerRow], words: &PlayerWords, begins: Beginning) -> Markup {
    // Without times it is not known which energies belong to a frame.
    let energies = film.times().and_then(|_| energies(rows, words));
    html! {
        section.player {
            div.stage {
                div {
                    canvas #discs role="img" aria-label=(words.picture) {}
                    (controls(film, words))
                    @if let Some(fastest) = film.fastest() { (bar(fastest, words)) }
                }
                @if let Some(energies) = &energies { (beside(energies, words)) }
            }
            p.note { (note(film, words)) }
            noscript { p { (words.no_script) } }
        }
        (data("film", &contents(film, energies, words, begins)))
        script { (PreEscaped(SCRIPT)) }
    }
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
        radii: film.radii().iter().map(|radius| rounded(*radius, DIGITS)).collect(),
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
        let values =
            rows.iter().map(|row| rounded(column(row) * 10f64.powi(-power), DIGITS)).collect();
        Curve { name: said.map_or(name, |(_, said)| said), colour, values }
    });
    Some(Energies {
        unit: format!("{prefix}J"),
        is_log,
        times: rows.iter().map(|row| row.time_s).collect(),
        curves: curves.collect(),
    })
}

/// The curves of the energies, and their values at the moment.
fn beside(energies: &Energies, words: &PlayerWords) -> Markup {
    html! {
        div {
            canvas #energies role="img" aria-label=(words.curves) {}
            dl #now {
                @for Curve { name, colour, .. } in &energies.curves {
                    dt style={ "color: " (colour) } { (name) }
                    dd {}
                }
            }
        }
    }
}

/// What the colours say.
fn bar(fastest: f64, words: &PlayerWords) -> Markup {
    let shades: Vec<String> = colour::SCALE.iter().map(|shade| colour::hex(*shade)).collect();
    let scale = format!("background: linear-gradient(to right, {})", shades.join(", "));
    html! {
        p.bar { span { (words.speed) } " 0 " i style=(scale) {} " " (typographic(fastest, 3)) " m/s" }
    }
}

fn controls(film: &Film, words: &PlayerWords) -> Markup {
    let button = |id: &str, text: &str, said: &str| {
        html! { button type="button" id=(id) title=(said) { (text) } " " }
    };
    let last = film.frames().0.saturating_sub(1);
    html! {
        div.controls {
            (button("play", words.play, words.play_said))
            (button("back", "\u{2039}", words.back))
            (button("forth", "\u{203a}", words.forth))
            input #moment type="range" min="0" max=(last) value="0" aria-label=(words.moment);
            output #clock {}
            label {
                (words.pace) " "
                select #pace {
                    @for (value, text) in PACES {
                        option value=(value) selected[value == USUAL_PACE] { (text) }
                    }
                }
            }
            " " span #rate {}
        }
    }
}

/// What the film leaves out, and how it is played by keys.
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
    parts.join(" ")
}
