//! The little HTML that pages are made of.

use std::fmt::Write;

use serde::Serialize;

use crate::figure::Figure;

/// `text` with the characters that mean something to HTML written out.
///
/// ```
/// use parsim2d::page::html::escaped;
/// assert_eq!(escaped("a < b & \"c\""), "a &lt; b &amp; &quot;c&quot;");
/// ```
pub fn escaped(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped.push_str("&amp;"),
            '<' => escaped.push_str("&lt;"),
            '>' => escaped.push_str("&gt;"),
            '"' => escaped.push_str("&quot;"),
            '\'' => escaped.push_str("&#39;"),
            c => escaped.push(c),
        }
    }
    escaped
}

/// A table of cells, the first row its head; the first cell of a row is left, the others are right.
pub fn table(rows: &[Vec<String>]) -> String {
    let mut text = "<div class=\"wide\">\n<table>\n".to_owned();
    for (k, row) in rows.iter().enumerate() {
        let tag = if k == 0 { "th" } else { "td" };
        text.push_str("<tr>");
        for cell in row {
            let _ = write!(text, "<{tag}>{}</{tag}>", escaped(cell));
        }
        text.push_str("</tr>\n");
    }
    text.push_str("</table>\n</div>\n");
    text
}

/// A table of names and values.
pub fn list(rows: &[(String, String)]) -> String {
    let mut text = "<dl>\n".to_owned();
    for (name, value) in rows {
        let _ = writeln!(text, "<dt>{}</dt><dd>{}</dd>", escaped(name), escaped(value));
    }
    text.push_str("</dl>\n");
    text
}

/// A figure within the page, number `k` of it, with what is to be seen on it.
pub fn figure(k: usize, figure: &Figure, caption: &str) -> String {
    // Names within one SVG count for the whole page.
    let svg = figure
        .to_svg()
        .replace("id=\"clip", &format!("id=\"figure{k}-clip"))
        .replace("url(#clip", &format!("url(#figure{k}-clip"))
        .replace("id=\"scale", &format!("id=\"figure{k}-scale"))
        .replace("url(#scale", &format!("url(#figure{k}-scale"));
    format!("<figure>\n{svg}<figcaption>{}</figcaption>\n</figure>\n", escaped(caption))
}

/// What a script reads, under a name: JSON that no part of can end the element around it.
pub fn data(id: &str, value: &impl Serialize) -> String {
    // What is written here has no keys but words and no numbers but finite ones, or none.
    let json = serde_json::to_string(value).unwrap_or_default().replace('<', "\\u003c");
    format!("<script type=\"application/json\" id=\"{id}\">{json}</script>\n")
}

/// A whole page of `title` in `language` (a code such as `en`), its body of a `class`. A browser is told to
/// load nothing.
pub fn page(language: &str, title: &str, class: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; \
         style-src 'unsafe-inline'; script-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body class=\"{class}\">\n{body}</body>\n</html>\n"
    )
}

const STYLE: &str = include_str!("style.css");
