//! Pages for people: one self-contained HTML file, no network, fit for printing.
//!
//! What a page says is in [`words`], one typed table for each language; what it shows comes in as
//! values. `maud` escapes, and [`html`] has the pieces. [`film`] makes the frames of a run small, [`player`] shows them.

pub mod film;
pub mod gas;
pub mod html;
pub mod parameters;
pub mod player;
pub mod report;
pub mod small;
pub mod words;
