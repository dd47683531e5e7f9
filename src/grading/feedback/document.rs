//! The page around a sheet: one file, nothing from elsewhere, no script, fit for A4.

use maud::{Markup, html};

use crate::page::html::Page;

/// How a page lies on paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paper {
    /// A student's sheet.
    Upright,
    /// The table of a class.
    Across,
}

/// A whole page in `language` (a code such as `en`).
pub fn document(language: &str, title: &str, paper: Paper, body: &Markup) -> String {
    let (size, width) = match paper {
        Paper::Upright => ("A4", "50rem"),
        Paper::Across => ("A4 landscape", "75rem"),
    };
    let style =
        format!("@page {{ size: {size}; margin: 14mm; }}\nbody {{ max-width: {width}; }}\n{STYLE}");
    Page { language, title, class: "sheet", style: &style, has_script: false }.around(body)
}

/// A paragraph of a class.
pub fn paragraph(class: &str, text: &str) -> Markup {
    html! { p class=(class) { (text) } }
}

const STYLE: &str = "\
body { font: 15px/1.45 system-ui, sans-serif; color: #111; background: #fff; margin: 1.5rem auto; padding: 0 1rem; overflow-wrap: anywhere; }
h1 { font-size: 1.5rem; margin: 0 0 0.4rem; } h2 { font-size: 1.15rem; margin: 1.6rem 0 0.6rem; border-bottom: 1px solid #bbb; break-after: avoid; }
.sum { font-size: 1.15rem; margin: 0.2rem 0; } .bar { height: 0.6rem; background: #e8e8e8; border: 1px solid #999; border-radius: 0.3rem; overflow: hidden; }
.bar span { display: block; height: 100%; background: #006d4e; print-color-adjust: exact; }
.check { border-left: 0.3rem solid #999; padding: 0.15rem 0 0.15rem 0.8rem; margin: 0.5rem 0; break-inside: avoid; }
.check h3 { font-size: 1rem; margin: 0; display: flex; gap: 0.6rem; align-items: baseline; } .check h3 .title { flex: 1; } .check h3 .sign { width: 1.1rem; text-align: center; }
.check h3 .points { font-weight: 400; color: #333; white-space: nowrap; } .check p { margin: 0.2rem 0; } .check .kind { color: #555; }
.check.passed { border-color: #006d4e; } .check.failed { border-color: #a3270b; } .check.partly { border-color: #8a5a00; }
.passed .sign { color: #006d4e; } .failed .sign { color: #a3270b; } .partly .sign { color: #8a5a00; }
.beside { display: grid; grid-template-columns: 1fr 15rem; gap: 1rem; align-items: start; } .hint { background: #f3f6fa; padding: 0.4rem 0.6rem; border-radius: 0.2rem; print-color-adjust: exact; }
dl { display: grid; grid-template-columns: max-content auto; gap: 0.1rem 1rem; margin: 0.3rem 0; } dt { color: #555; } dd { margin: 0; } .check dt { white-space: normal; max-width: 20rem; }
figure { margin: 0; break-inside: avoid; } figure svg { width: 100%; height: auto; border: 1px solid #ddd; } figcaption { color: #555; font-size: 0.8rem; line-height: 1.3; }
pre { font: 0.8rem/1.35 ui-monospace, monospace; white-space: pre-wrap; background: #f4f4f4; padding: 0.5rem; margin: 0.3rem 0; }
.wide { overflow-x: auto; } .wide td, .wide th { overflow-wrap: normal; } .wide .left { min-width: 8rem; }
.wide td.name { position: sticky; left: 0; background: #fff; max-width: min(20rem, 45vw); overflow-wrap: anywhere; }
table { border-collapse: collapse; } th, td { padding: 0.12rem 0.4rem; text-align: center; border-bottom: 1px solid #ddd; } tr { break-inside: avoid; } thead { display: table-header-group; }
th { font-weight: 600; vertical-align: bottom; } th.up span { writing-mode: vertical-rl; transform: rotate(180deg); white-space: nowrap; font-weight: 400; } .left { text-align: left; } td.number { text-align: right; white-space: nowrap; }
td.passed { color: #006d4e; } td.failed { color: #a3270b; font-weight: 600; } td.partly { color: #8a5a00; } .legend { color: #555; font-size: 0.85rem; }
.bins { max-width: 36rem; } .partial { border: 1px solid #8a5a00; padding: 0.4rem 0.6rem; }
@media (max-width: 40rem) { .beside { grid-template-columns: 1fr; } }
@media print { .wide { overflow: visible; } .wide .left { min-width: 0; } body { margin: 0; max-width: none; font-size: 10pt; padding: 0; } a { color: inherit; text-decoration: none; } }
";
