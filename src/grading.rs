//! Grading: from the folder that a student hands in to the sheet handed back.
//!
//! [`judge`] measures the frames that a program wrote, by physics; [`feedback`] says what came out, to students,
//! instructors and platforms; [`sandbox`] builds and runs student code and knows nobody; [`pipeline`] takes a
//! submission through all three; [`validation`] holds the judge against programs of which it is known what is wrong.

pub mod feedback;
pub mod judge;
pub mod pipeline;
pub mod sandbox;
pub mod validation;
