//! Pages for people: one self-contained HTML file, no network, fit for printing.
//!
//! What a page says is in [`words`], one typed table for each language; what it shows comes in as
//! values. [`html`] escapes.

pub mod html;
pub mod report;
pub mod words;
