//! The report of a run: what a student hands in.

use std::fmt::Write;

use super::film::Film;
use super::gas::NoGas;
use super::html::{escaped, list, page, table};
use super::parameters;
use super::player::{Beginning, player};
use super::small::{self, panels};
use super::words::Words;
use crate::analysis::answer::{Answer, AnswerRow};
use crate::analysis::energy::LedgerRow;
use crate::figure::Figure;
use crate::scenario::diagnosis::{CAVEAT, Diagnosis, cell};
use crate::scenario::finding::Verdict;

/// Everything that a report shows.
pub struct Report {
    /// Who hands it in, if that was said.
    pub name: Option<String>,
    /// The command as it was typed, with its seed, if it is known.
    pub typed: Option<String>,
    /// The command that repeats the run.
    pub repeats: String,
    /// The scenario as a file.
    pub scenario: String,
    /// Names and values of what came out.
    pub results: Vec<(String, String)>,
    /// The diagnosis, or why there is none.
    pub diagnosis: Result<Diagnosis, String>,
    /// What went wrong, by names; nothing for a run that did not.
    pub failure: Vec<(String, String)>,
    /// Theory beside measurement, for one or two discs.
    pub answer: Answer,
    /// From which frame on the run cannot be drawn, and why.
    pub cut: Option<String>,
    /// The energies, if there is a ledger.
    pub energy: Option<Figure>,
    /// The ledger; none of its lines if there is none.
    pub rows: Vec<LedgerRow>,
    /// Why a ledger that is there is not drawn.
    pub no_rows: Option<String>,
    /// All frames, to be played.
    pub film: Film,
    /// The first and the last frame.
    pub frames: [Figure; 2],
    /// The velocity field of the last frame, if any disc moves there.
    pub velocity: Option<Figure>,
    /// The histogram of speeds, if any disc moves.
    pub speeds: Option<Figure>,
    /// Why Maxwell's distribution says nothing of them.
    pub no_gas: Option<NoGas>,
    /// Files beside the page, and their sizes in bytes.
    pub data: Vec<(String, u64)>,
}

impl Report {
    /// The page, in the language of `words`.
    pub fn html(&self, words: &Words) -> String {
        let film = player(&self.film, &self.rows, &words.player, Beginning::WhenAsked);
        let parts = [
            self.head(words),
            self.how_to_repeat(words),
            format!("<div class=\"screen\">\n{}</div>\n", section(words.player_heading, &film)),
            self.failure(words),
            self.numbers(words),
            section(words.own_words, &editable("div", "own", words.own_words, "")),
            self.diagnosis(words),
            self.pictures(words),
        ];
        let class = if self.is_long() { "long" } else { "usual" };
        page(words.code, words.report, class, &parts.concat())
    }

    /// Whether there is so much to say that the first sheet must be printed smaller to hold it.
    fn is_long(&self) -> bool {
        const USUAL_FINDINGS: usize = 2;
        let findings = self.diagnosis.as_ref().map_or(0, |diagnosis| diagnosis.findings.len());
        let lists_discs = self.scenario.contains("\n[[");
        findings > USUAL_FINDINGS || !self.failure.is_empty() || lists_discs
    }

    fn head(&self, words: &Words) -> String {
        let name = editable("span", "name", words.name, self.name.as_deref().unwrap_or_default());
        format!(
            "<header>\n<h1>{}</h1>\n<p class=\"who\"><span class=\"label\">{}</span> {name}</p>\n</header>\n",
            escaped(words.report),
            escaped(words.name)
        )
    }

    /// Parameters beside results.
    fn numbers(&self, words: &Words) -> String {
        let dt = self.diagnosis.as_ref().ok().map(|diagnosis| diagnosis.dt_s);
        let parameters = section(words.parameters, &parameters::list(&self.scenario, dt, words));
        let listed = parameters::listed(&self.scenario, words);
        let results = self.results(words) + &self.theory(words);
        format!("<div class=\"columns\">\n{parameters}<div>\n{results}</div>\n</div>\n{listed}")
    }

    fn how_to_repeat(&self, words: &Words) -> String {
        let line = |said: &str, command: &str| {
            format!("<p>{}<code>{}</code></p>\n", escaped(said), escaped(command))
        };
        let typed = self.typed.as_ref().map(|typed| line(words.typed, typed));
        let again = line(words.repeats, &self.repeats);
        section(words.how_to_repeat, &(typed.unwrap_or_default() + &again + &self.data(words)))
    }

    fn failure(&self, words: &Words) -> String {
        if self.failure.is_empty() && self.cut.is_none() {
            return String::new();
        }
        const SHORT: usize = 24; // letters
        let mut text = "<dl class=\"said\">\n".to_owned();
        for (key, value) in &self.failure {
            let name = words.failure_names.iter().find(|(known, _)| known == key);
            let (name, value) = (name.map_or(key.as_str(), |(_, name)| name), rounded(value));
            let class = if value.len() > SHORT { " class=\"wide-one\"" } else { "" };
            let (name, value) = (escaped(name), escaped(&value));
            let _ = writeln!(text, "<dt{class}>{name}</dt><dd{class}>{value}</dd>");
        }
        text += "</dl>\n";
        if let Some(cut) = &self.cut {
            let _ = writeln!(text, "<p>{}{}</p>", escaped(words.cut), escaped(cut));
        }
        section(words.failure, &text)
    }

    fn theory(&self, words: &Words) -> String {
        if self.answer.is_empty() {
            return String::new();
        }
        let mut rows = vec![words.answer_head.map(str::to_owned).to_vec()];
        for AnswerRow { what, unit, theory, measured, error, order } in self.answer.rows() {
            let what = if unit.is_empty() { what.clone() } else { format!("{what}, {unit}") };
            let order = order.map_or("-".to_owned(), |order| format!("{order:.1}"));
            rows.push(vec![what, short(*theory), short(*measured), format!("{error:+.1e}"), order]);
        }
        section(words.answer, &table(&rows))
    }

    fn results(&self, words: &Words) -> String {
        let named = |(key, value): &(String, String)| {
            let name = words.result_names.iter().find(|(known, _)| known == key);
            (name.map_or(key.clone(), |(_, name)| (*name).to_owned()), rounded(value))
        };
        let text = match self.results.is_empty() {
            true => format!("<p>{}</p>\n", escaped(words.no_results)),
            false => list(&self.results.iter().map(named).collect::<Vec<_>>()),
        };
        section(words.results, &text)
    }

    fn diagnosis(&self, words: &Words) -> String {
        let diagnosis = match &self.diagnosis {
            Ok(diagnosis) => diagnosis,
            Err(why) => {
                let text = format!("<p>{}{}</p>\n", escaped(words.no_diagnosis), escaped(why));
                return section(words.diagnosis, &text);
            }
        };
        let mut text = sentence(diagnosis.verdict, &diagnosis.sentence);
        for finding in diagnosis.findings.iter().skip(1) {
            text += &sentence(finding.verdict, &finding.sentence());
        }
        let rows = |head: [&str; 4], rows: Vec<[String; 4]>| {
            let head = std::iter::once(head.map(str::to_owned));
            table(&head.chain(rows).map(Vec::from).collect::<Vec<_>>())
        };
        let verdict = |verdict: Option<Verdict>| verdict.map_or(String::new(), |v| v.to_string());
        let figures = diagnosis.figures.iter().map(|figure| {
            let [pair, wall] = [figure.pair, figure.wall].map(cell);
            [figure.name.to_owned(), pair, wall, verdict(figure.verdict)]
        });
        text += "<div class=\"tables\">\n";
        text += &rows(words.contact_head, figures.collect());
        let limits = diagnosis.limits.iter().map(|limit| {
            let [dt, fraction] = [Some(limit.dt_s), Some(limit.fraction)].map(cell);
            [limit.by.clone(), dt, fraction, verdict(Some(limit.verdict))]
        });
        text += &rows(words.limit_head, limits.collect());
        let _ = writeln!(text, "</div>\n<p>{}</p>", escaped(CAVEAT));
        section(words.diagnosis, &text)
    }

    fn pictures(&self, words: &Words) -> String {
        let energy = match &self.energy {
            Some(energy) => {
                let captions = [words.energy_caption, words.residue_caption];
                let panels = energy.panels.iter().zip(captions).enumerate();
                pair(panels.map(|(k, (panel, caption))| small::panel(1 + k, panel, caption, words)))
            }
            None => {
                let why = self.no_rows.as_deref().unwrap_or(words.no_energy);
                format!("<p>{}</p>\n", escaped(why))
            }
        };
        let [first, last] = &self.frames;
        let frames = [(first, words.first_frame), (last, words.last_frame)].into_iter().enumerate();
        let frames =
            frames.flat_map(|(k, (figure, caption))| panels(3 + k, figure, caption, words));
        section(words.energy, &energy) + &section(words.frames, &pair(frames)) + &self.motion(words)
    }

    /// The velocity field beside the histogram of speeds.
    fn motion(&self, words: &Words) -> String {
        let velocity = self.velocity.iter().flat_map(|figure| {
            let text = small::field(5, figure, words);
            text.into_iter().map(|text| section(words.velocity, &text))
        });
        let said = match self.no_gas {
            None => words.maxwell,
            Some(why) => (words.no_maxwell)(why),
        };
        let speeds = match &self.speeds {
            Some(speeds) => panels(6, speeds, said, words).concat(),
            None => format!("<p>{}</p>\n", escaped(words.no_speeds)),
        };
        pair(velocity.chain([section(words.speeds, &speeds)]))
    }

    fn data(&self, words: &Words) -> String {
        if self.data.is_empty() {
            return String::new();
        }
        let link = |(name, bytes): &(String, u64)| {
            let name = escaped(name);
            format!("<a href=\"{name}\">{name}</a>, {}", size(*bytes))
        };
        let links: Vec<String> = self.data.iter().map(link).collect();
        format!("<p>{}{}</p>\n", escaped(words.data), links.join("; "))
    }
}

fn section(heading: &str, text: &str) -> String {
    format!("<section>\n<h2>{}</h2>\n{text}</section>\n", escaped(heading))
}

/// Parts side by side where there is room for them.
fn pair(parts: impl Iterator<Item = String>) -> String {
    format!("<div class=\"pair\">\n{}</div>\n", parts.collect::<String>())
}

/// A place to write into, of a `class`; what it is for is told to those who do not see it.
fn editable(tag: &str, class: &str, purpose: &str, text: &str) -> String {
    let (purpose, text) = (escaped(purpose), escaped(text));
    format!(
        "<{tag} class=\"{class}\" contenteditable=\"true\" role=\"textbox\" aria-label=\"{purpose}\">{text}</{tag}>\n"
    )
}

fn sentence(verdict: Verdict, text: &str) -> String {
    format!("<p><span class=\"verdict {verdict}\">{verdict}</span>: {}</p>\n", escaped(text))
}

/// A value with six digits, if it is a number that has more; else as it is.
fn rounded(value: &str) -> String {
    let number = value.parse().ok().filter(|_| value.contains(['.', 'e']));
    number.map_or(value.to_owned(), short)
}

/// Six digits.
fn short(number: f64) -> String {
    match number.abs() {
        size if (1e-3..1e5).contains(&size) => {
            let digits = (5 - size.log10().floor() as i32).clamp(0, 8) as usize;
            format!("{number:.digits$}")
        }
        _ => format!("{number:.5e}"),
    }
}

/// A size for a person.
fn size(bytes: u64) -> String {
    match bytes {
        0..10_000 => format!("{bytes} bytes"),
        10_000..10_000_000 => format!("{} kB", bytes / 1000),
        _ => format!("{} MB", bytes / 1_000_000),
    }
}
