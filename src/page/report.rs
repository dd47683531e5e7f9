//! The report of a run: what a student hands in.

use maud::{Markup, html};

use super::film::Film;
use super::gas::NoGas;
use super::html::{Page, list, section, table};
use super::parameters;
use super::player::{Beginning, STYLE, player};
use super::small::{self, panels};
use super::words::Words;
use crate::analysis::answer::Answer;
use crate::analysis::energy::LedgerRow;
use crate::figure::Figure;
use crate::number::{bytes, significant};
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
        let class = if self.is_long() { "long" } else { "usual" };
        let (language, title) = (words.code, words.report);
        Page { language, title, class, style: STYLE, has_script: true }.around(&html! {
            header {
                h1 { (words.report) }
                p.who {
                    span.label { (words.name) } " "
                    span.name contenteditable="true" role="textbox" aria-label=(words.name) {
                        (self.name.as_deref().unwrap_or_default())
                    }
                }
            }
            (self.how_to_repeat(words))
            div.screen { (section(words.player_heading, &film)) }
            (self.failure(words))
            (self.numbers(words))
            (section(words.own_words, &html! {
                div.own contenteditable="true" role="textbox" aria-label=(words.own_words) {}
            }))
            (self.diagnosis(words))
            (self.pictures(words))
        })
    }

    /// Whether there is so much to say that the first sheet must be printed smaller to hold it.
    fn is_long(&self) -> bool {
        const USUAL_FINDINGS: usize = 2;
        let findings = self.diagnosis.as_ref().map_or(0, |diagnosis| diagnosis.findings.len());
        let lists_discs = self.scenario.contains("\n[[");
        findings > USUAL_FINDINGS || !self.failure.is_empty() || lists_discs
    }

    /// Parameters beside results.
    fn numbers(&self, words: &Words) -> Markup {
        let dt = self.diagnosis.as_ref().ok().map(|diagnosis| diagnosis.dt_s);
        html! {
            div.columns {
                (section(words.parameters, &parameters::list(&self.scenario, dt, words)))
                div { (self.results(words)) (self.theory(words)) }
            }
            (parameters::listed(&self.scenario, words))
        }
    }

    fn how_to_repeat(&self, words: &Words) -> Markup {
        section(
            words.how_to_repeat,
            &html! {
                @if let Some(typed) = &self.typed { p { (words.typed) code { (typed) } } }
                p { (words.repeats) code { (self.repeats) } }
                @if !self.data.is_empty() {
                    p {
                        (words.data)
                        @for (k, (name, bytes)) in self.data.iter().enumerate() {
                            @if k > 0 { "; " }
                            a href=(name) { (name) } ", " (self::bytes(*bytes))
                        }
                    }
                }
            },
        )
    }

    fn failure(&self, words: &Words) -> Markup {
        const SHORT: usize = 24; // letters
        if self.failure.is_empty() && self.cut.is_none() {
            return html! {};
        }
        let named = self.failure.iter().map(|(key, value)| {
            let name = words.failure_names.iter().find(|(known, _)| known == key);
            (name.map_or(key.as_str(), |(_, name)| name), rounded(value))
        });
        section(
            words.failure,
            &html! {
                dl.said {
                    @for (name, value) in named {
                        @let class = (value.len() > SHORT).then_some("wide-one");
                        dt class=[class] { (name) }
                        dd class=[class] { (value) }
                    }
                }
                @if let Some(cut) = &self.cut { p { (words.cut) (cut) } }
            },
        )
    }

    fn theory(&self, words: &Words) -> Markup {
        if self.answer.is_empty() {
            return html! {};
        }
        let mut rows = vec![words.answer_head.map(str::to_owned).to_vec()];
        rows.extend(self.answer.rows().iter().map(|row| row.cells().to_vec()));
        section(words.answer, &table(&rows))
    }

    fn results(&self, words: &Words) -> Markup {
        let named = |(key, value): &(String, String)| {
            let name = words.result_names.iter().find(|(known, _)| known == key);
            (name.map_or(key.clone(), |(_, name)| (*name).to_owned()), rounded(value))
        };
        section(
            words.results,
            &match self.results.is_empty() {
                true => html! { p { (words.no_results) } },
                false => list(&self.results.iter().map(named).collect::<Vec<_>>()),
            },
        )
    }

    fn diagnosis(&self, words: &Words) -> Markup {
        let diagnosis = match &self.diagnosis {
            Ok(diagnosis) => diagnosis,
            Err(why) => {
                return section(words.diagnosis, &html! { p { (words.no_diagnosis) (why) } });
            }
        };
        let rows = |head: [&str; 4], rows: Vec<[String; 4]>| {
            let head = std::iter::once(head.map(str::to_owned));
            table(&head.chain(rows).map(Vec::from).collect::<Vec<_>>())
        };
        let verdict = |verdict: Option<Verdict>| verdict.map_or(String::new(), |v| v.to_string());
        let figures = diagnosis.figures.iter().map(|figure| {
            let [pair, wall] = [figure.pair, figure.wall].map(cell);
            [figure.name.to_owned(), pair, wall, verdict(figure.verdict)]
        });
        let limits = diagnosis.limits.iter().map(|limit| {
            let [dt, fraction] = [Some(limit.dt_s), Some(limit.fraction)].map(cell);
            [limit.by.clone(), dt, fraction, verdict(Some(limit.verdict))]
        });
        section(
            words.diagnosis,
            &html! {
                (sentence(diagnosis.verdict, &diagnosis.sentence))
                @for finding in diagnosis.findings.iter().skip(1) {
                    (sentence(finding.verdict, &finding.sentence()))
                }
                div.tables {
                    (rows(words.contact_head, figures.collect()))
                    (rows(words.limit_head, limits.collect()))
                }
                p { (CAVEAT) }
            },
        )
    }

    fn pictures(&self, words: &Words) -> Markup {
        let energy = match &self.energy {
            Some(energy) => {
                let captions = [words.energy_caption, words.residue_caption];
                let panels = energy.panels.iter().zip(captions).enumerate();
                pair(panels.map(|(k, (panel, caption))| small::panel(1 + k, panel, caption, words)))
            }
            None => html! { p { (self.no_rows.as_deref().unwrap_or(words.no_energy)) } },
        };
        let [first, last] = &self.frames;
        let frames = [(first, words.first_frame), (last, words.last_frame)].into_iter().enumerate();
        let frames =
            frames.flat_map(|(k, (figure, caption))| panels(3 + k, figure, caption, words));
        html! {
            (section(words.energy, &energy))
            (section(words.frames, &pair(frames)))
            (self.motion(words))
        }
    }

    /// The velocity field beside the histogram of speeds.
    fn motion(&self, words: &Words) -> Markup {
        let velocity = self.velocity.iter().flat_map(|figure| small::field(5, figure, words));
        let velocity = velocity.map(|figure| section(words.velocity, &figure));
        let said = match self.no_gas {
            None => words.maxwell,
            Some(why) => (words.no_maxwell)(why),
        };
        let speeds = match &self.speeds {
            Some(speeds) => html! { @for panel in panels(6, speeds, said, words) { (panel) } },
            None => html! { p { (words.no_speeds) } },
        };
        pair(velocity.chain([section(words.speeds, &speeds)]))
    }
}

/// Parts side by side where there is room for them.
fn pair(parts: impl Iterator<Item = Markup>) -> Markup {
    html! { div.pair { @for part in parts { (part) } } }
}

fn sentence(verdict: Verdict, text: &str) -> Markup {
    html! { p { span class={ "verdict " (verdict) } { (verdict) } ": " (text) } }
}

/// A value with six digits, if it is a number that has more; else as it is.
fn rounded(value: &str) -> String {
    let number = value.parse().ok().filter(|_| value.contains(['.', 'e']));
    number.map_or(value.to_owned(), |value| significant(value, 6))
}
