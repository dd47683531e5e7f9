//! The little HTML that pages are made of.

use std::fmt::Write;

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
    let mut text = "<table>\n".to_owned();
    for (k, row) in rows.iter().enumerate() {
        let tag = if k == 0 { "th" } else { "td" };
        text.push_str("<tr>");
        for cell in row {
            let _ = write!(text, "<{tag}>{}</{tag}>", escaped(cell));
        }
        text.push_str("</tr>\n");
    }
    text.push_str("</table>\n");
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
        .replace("url(#clip", &format!("url(#figure{k}-clip"));
    format!("<figure>\n{svg}<figcaption>{}</figcaption>\n</figure>\n", escaped(caption))
}

/// A whole page of `title` in `language` (a code such as `en`).
pub fn page(language: &str, title: &str, body: &str) -> String {
    let title = escaped(title);
    format!(
        "<!doctype html>\n<html lang=\"{language}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}</title>\n\
         <style>\n{STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{body}</body>\n</html>\n"
    )
}

const STYLE: &str = "\
body { font: 16px/1.45 system-ui, sans-serif; color: #111; background: #fff; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.6rem; } h2 { font-size: 1.2rem; margin-top: 2rem; border-bottom: 1px solid #ccc; }
code, pre { font-family: ui-monospace, monospace; font-size: 0.9em; } pre { white-space: pre-wrap; background: #f4f4f4; padding: 0.6rem; }
table { border-collapse: collapse; margin: 0.8rem 0; } th, td { padding: 0.15rem 0.8rem; text-align: right; border-bottom: 1px solid #e5e5e5; }
th { font-weight: 600; } th:first-child, td:first-child { text-align: left; padding-left: 0; }
dl { display: grid; grid-template-columns: max-content auto; gap: 0.15rem 1.2rem; margin: 0; } dt { color: #555; } dd { margin: 0; overflow-wrap: anywhere; }
figure { margin: 1rem 0; break-inside: avoid; } figure svg { width: 100%; height: auto; } figcaption { color: #444; }
.pair figure { max-width: 40rem; } .own { min-height: 8rem; border: 1px dotted #999; padding: 0.5rem; } .verdict { font-weight: 600; }
.good { color: #006d4e; } .coarse { color: #8a5a00; } .unstable { color: #a3270b; }
@media print { body { margin: 0; max-width: none; font-size: 11pt; } h2 { break-after: avoid; } }
";
