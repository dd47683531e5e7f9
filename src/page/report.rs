//! The report of a run: what a student hands in.

use std::fmt::Write;

use super::html::{escaped, figure, list, page, table};
use super::words::Words;
use crate::analysis::answer::{Answer, AnswerRow};
use crate::figure::Figure;
use crate::scenario::diagnosis::{CAVEAT, Diagnosis, cell};
use crate::scenario::finding::Verdict;

/// Everything that a report shows.
pub struct Report {
    /// The command as it was typed, if it is known.
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
    /// The first and the last frame.
    pub frames: [Figure; 2],
    /// The histogram of speeds, if any disc moves.
    pub speeds: Option<Figure>,
    /// Files beside the page, and their sizes in bytes.
    pub data: Vec<(String, u64)>,
}

impl Report {
    /// The page, in the language of `words`.
    pub fn html(&self, words: &Words) -> String {
        let parts = [
            self.how_to_repeat(words),
            self.failure(words),
            self.results(words),
            self.theory(words),
            section(words.own_words, "<div class=\"own\" contenteditable=\"true\"></div>\n"),
            self.diagnosis(words),
            self.pictures(words),
            section(words.parameters, &format!("<pre>{}</pre>\n", escaped(&self.scenario))),
            self.data(words),
        ];
        page(words.code, words.report, &parts.concat())
    }

    fn how_to_repeat(&self, words: &Words) -> String {
        let line = |said: &str, command: &str| {
            format!("<p>{}<code>{}</code></p>\n", escaped(said), escaped(command))
        };
        let typed = self.typed.as_ref().map(|typed| line(words.typed, typed));
        let again = line(words.repeats, &self.repeats);
        section(words.how_to_repeat, &(typed.unwrap_or_default() + &again))
    }

    fn failure(&self, words: &Words) -> String {
        if self.failure.is_empty() {
            return String::new();
        }
        let named = |(key, value): &(String, String)| {
            let name = words.failure_names.iter().find(|(known, _)| known == key);
            (name.map_or(key.clone(), |(_, name)| (*name).to_owned()), value.clone())
        };
        section(words.failure, &list(&self.failure.iter().map(named).collect::<Vec<_>>()))
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
            let rounded = value.parse().ok().filter(|_| value.contains('.') || value.contains('e'));
            let value = rounded.map_or(value.clone(), short);
            (name.map_or(key.clone(), |(_, name)| (*name).to_owned()), value)
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
        text += &rows(words.contact_head, figures.collect());
        let limits = diagnosis.limits.iter().map(|limit| {
            let [dt, fraction] = [Some(limit.dt_s), Some(limit.fraction)].map(cell);
            [limit.by.clone(), dt, fraction, verdict(Some(limit.verdict))]
        });
        text += &rows(words.limit_head, limits.collect());
        let _ = writeln!(text, "<p>{}</p>", escaped(CAVEAT));
        section(words.diagnosis, &text)
    }

    fn pictures(&self, words: &Words) -> String {
        let energy = match &self.energy {
            Some(energy) => figure(1, energy, words.energy_caption),
            None => format!("<p>{}</p>\n", escaped(words.no_energy)),
        };
        let [first, last] = &self.frames;
        let frames = format!(
            "<div class=\"pair\">\n{}{}</div>\n",
            figure(2, first, words.first_frame),
            figure(3, last, words.last_frame)
        );
        let cut =
            self.cut.as_ref().map(|cut| format!("<p>{}{}</p>\n", escaped(words.cut), escaped(cut)));
        let frames = frames + &cut.unwrap_or_default();
        let speeds = match &self.speeds {
            Some(speeds) => figure(4, speeds, words.speeds_caption),
            None => format!("<p>{}</p>\n", escaped(words.no_speeds)),
        };
        section(words.energy, &energy)
            + &section(words.frames, &frames)
            + &section(words.speeds, &speeds)
    }

    fn data(&self, words: &Words) -> String {
        let mut text = "<ul>\n".to_owned();
        for (name, bytes) in &self.data {
            let name = escaped(name);
            let _ = writeln!(text, "<li><a href=\"{name}\">{name}</a>, {}</li>", size(*bytes));
        }
        text.push_str("</ul>\n");
        section(words.data, &text)
    }
}

fn section(heading: &str, text: &str) -> String {
    format!("<h2>{}</h2>\n{text}", escaped(heading))
}

fn sentence(verdict: Verdict, text: &str) -> String {
    format!("<p><span class=\"verdict {verdict}\">{verdict}</span>: {}</p>\n", escaped(text))
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
