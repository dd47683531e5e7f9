//! What the reader of a sheet should know.

use serde::Serialize;

/// The notes, each in English.
macro_rules! notes {
    ($($note:ident: $text:literal;)+) => {
        /// What the reader should know, though it costs nothing.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Note { $(#[doc = $text] $note,)+ }

        /// English.
        pub(super) fn english(note: Note) -> &'static str {
            match note { $(Note::$note => $text,)+ }
        }
    };
}

notes! {
    PrintedEta:
        "discs that touch never part. That is what eta_n = 1.5e3 of the guide does if it is taken in \
         kg/s: 150 times critical damping. You did as told, and no points are lost; we think a minus \
         sign was lost in print. Try 1.5e-3 and see discs bounce.";
    PrintedEtaExplodes:
        "contacts give back 12 times the speed and more, and soon numbers end. That is what eta_n = 1.5e3 of the \
         guide does, if it is taken in kg/s, with the guide's own step: in one step of Eq. (2) the dashpot changes a \
         velocity by eta_n dt/m of itself, which is 13 for N_t = 50 and 67 for N_t = 10, so it turns the velocity \
         round and makes it larger, step after step. You did as told, and no points are lost. What this hides is \
         masked: it is out of the total. We think a minus sign was lost in print. For the instructor: let it run \
         again with eta_n = 1.5e-3, and grade what is seen then.";
    ColumnsTaken:
        "there are more than three columns, no heading says which is which, and the rubric has no radius to know one \
         by: the first three were taken for x, y and r.";
    ProgramNotRebuilt:
        "the program that ran was handed in as it is: the build found it newer than the sources, or makes another, \
         and did not make it anew. Whether the sources do the same was not seen.";
    AsksForInput:
        "the program asks for more on its standard input than the course gives it, and got nothing.";
    LittleJudged:
        "less than half of what is asked of motion could be judged, and the percentage is of that part: more discs, \
         larger ones, speeds at the start or more frames would show more.";
}
