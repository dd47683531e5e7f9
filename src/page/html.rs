//! What pages are made of, beside plain elements: `maud` writes them out, and escapes whatever is put into them.

use maud::{Markup, PreEscaped, html};
use serde::Serialize;

/// A table of cells, the first row its head; the first cell of a row is left, the others are right.
pub fn table(rows: &[Vec<String>]) -> Markup {
    let (head, rows) = rows.split_first().map_or((&[][..], rows), |(head, rows)| (&head[..], rows));
    wide(&html! {
        table {
            tr { @for cell in head { th { (cell) } } }
            @for row in rows {
                tr { @for cell in row { td { (cell) } } }
            }
        }
    })
}

/// What may be wider than the page: it is moved to a side, and no word of it is cut.
pub fn wide(inside: &Markup) -> Markup {
    html! { div.wide { (inside) } }
}

/// A table of names and values.
pub fn list(rows: &[(String, String)]) -> Markup {
    html! {
        dl { @for (name, value) in rows { dt { (name) } dd { (value) } } }
    }
}

/// A heading and what is below it.
pub fn section(heading: &str, inside: &Markup) -> Markup {
    html! { section { h2 { (heading) } (inside) } }
}

/// A picture within the page, number `k` of it, with what is to be seen on it. `svg` is one of ours.
pub fn figure(k: usize, svg: &str, caption: &str) -> Markup {
    // Names within one SVG count for the whole page.
    let svg = ["clip", "scale"].iter().fold(svg.to_owned(), |svg, name| {
        svg.replace(&format!("id=\"{name}"), &format!("id=\"figure{k}-{name}"))
            .replace(&format!("url(#{name}"), &format!("url(#figure{k}-{name}"))
    });
    html! { figure { (PreEscaped(svg)) figcaption { (caption) } } }
}

/// What a script reads, under a name: JSON that no part of can end the element around it.
pub fn data(id: &str, value: &impl Serialize) -> Markup {
    // What is written here has no keys but words and no numbers but finite ones, or none.
    let json = serde_json::to_string(value).unwrap_or_default().replace('<', "\\u003c");
    html! { script type="application/json" id=(id) { (PreEscaped(json)) } }
}

/// What a page is, beside what stands on it.
pub struct Page<'a> {
    /// The code of its language, such as `en`.
    pub language: &'a str,
    /// Its title.
    pub title: &'a str,
    /// The class of its body.
    pub class: &'a str,
    /// Its style sheet, one of ours.
    pub style: &'a str,
    /// Whether scripts within it may run.
    pub has_script: bool,
}

impl Page<'_> {
    /// The whole page. A browser is told to load nothing, and to run nothing but what the page brings if it has a
    /// script, should something slip through.
    pub fn around(&self, body: &Markup) -> String {
        let scripts = if self.has_script { "; script-src 'unsafe-inline'" } else { "" };
        let page = html! {
            html lang=(self.language) {
                head {
                    meta charset="utf-8";
                    meta http-equiv="Content-Security-Policy"
                        content={ "default-src 'none'; style-src 'unsafe-inline'" (scripts) };
                    meta name="viewport" content="width=device-width, initial-scale=1";
                    title { (self.title) }
                    style { (PreEscaped(self.style)) }
                }
                body class=(self.class) { (body) }
            }
        };
        format!("<!doctype html>\n{}\n", page.into_string())
    }
}
