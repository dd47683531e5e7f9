//! What pages say: one table of words for each language. A new language is a new constant; the
//! compiler asks for every entry.

/// The words of a language.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// Its code, for HTML.
    pub code: &'static str,
    /// Title of the report.
    pub report: &'static str,
    /// Heading of the way to repeat the run.
    pub how_to_repeat: &'static str,
    /// Before the command as it was typed, a drawn seed added.
    pub typed: &'static str,
    /// Before the command that repeats the run.
    pub repeats: &'static str,
    /// Heading of the parameters.
    pub parameters: &'static str,
    /// Heading of the results.
    pub results: &'static str,
    /// Names of the results, by their keys in the file of the run; others are shown under their keys.
    pub result_names: [(&'static str, &'static str); 11],
    /// Said of a run without results.
    pub no_results: &'static str,
    /// Heading of the diagnosis.
    pub diagnosis: &'static str,
    /// Said if the scenario cannot be judged any more.
    pub no_diagnosis: &'static str,
    /// Heads of the table of contacts: what, two discs, wall, verdict.
    pub contact_head: [&'static str; 4],
    /// Heads of the table of limits: what, limit, dt over it, verdict.
    pub limit_head: [&'static str; 4],
    /// Heading of what went wrong.
    pub failure: &'static str,
    /// Names of what is said of it, by their keys in `failure.json`.
    pub failure_names: [(&'static str, &'static str); 8],
    /// Heading of theory beside measurement.
    pub answer: &'static str,
    /// Its heads: what, theory, measured, relative error, order in dt.
    pub answer_head: [&'static str; 5],
    /// Heading of the place for the author's own answer.
    pub own_words: &'static str,
    /// Before the number of the first frame that cannot be drawn.
    pub cut: &'static str,
    /// Heading of the energy.
    pub energy: &'static str,
    /// Below the figure of the energy.
    pub energy_caption: &'static str,
    /// Said of a run without a ledger.
    pub no_energy: &'static str,
    /// Heading of the frames.
    pub frames: &'static str,
    /// Below the first frame.
    pub first_frame: &'static str,
    /// Below the last frame.
    pub last_frame: &'static str,
    /// Heading of the histogram.
    pub speeds: &'static str,
    /// Below the histogram.
    pub speeds_caption: &'static str,
    /// Said of a run of few discs, or whose discs never move.
    pub no_speeds: &'static str,
    /// Heading of the links.
    pub data: &'static str,
}

/// English.
pub const ENGLISH: Words = Words {
    code: "en",
    report: "Report of a simulation",
    how_to_repeat: "How to repeat it",
    typed: "As it was typed, with its seed: ",
    repeats: "The same run again, from the file beside this page: ",
    parameters: "Parameters",
    results: "Results",
    result_names: [
        ("version", "version of parsim2d"),
        ("steps", "time steps"),
        ("time_s", "simulated time, s"),
        ("energy_start_J", "mechanical energy at the start, J"),
        ("energy_end_J", "mechanical energy at the end, J"),
        ("dissipated_J", "taken by damping, J"),
        ("energy_error_J", "change of the sum of all (integration error), J"),
        ("max_overlap_over_r", "largest overlap, radii"),
        ("state_hash", "fingerprint of the final state"),
        ("went_wrong", "went wrong"),
        ("interrupted", "interrupted"),
    ],
    no_results: "The run has not ended; it left no results.",
    diagnosis: "Diagnosis",
    no_diagnosis: "The scenario cannot be read any more: ",
    contact_head: ["a contact", "two discs", "wall", ""],
    limit_head: ["largest time step", "limit, s", "dt / limit", ""],
    failure: "What went wrong",
    failure_names: [
        ("what", "what"),
        ("step", "at step"),
        ("time_s", "at time, s"),
        ("discs", "discs"),
        ("fault", "parameter at fault"),
        ("value", "its value"),
        ("diagnosis", "why"),
        ("ways_out", "ways out"),
    ],
    answer: "Theory and measurement",
    answer_head: ["first contact", "theory", "measured", "error", "order in dt"],
    own_words: "Does the total energy stay constant? If not, what is the problem, and can it be solved?",
    cut: "The run cannot be drawn from frame ",
    energy: "Energy",
    energy_caption: "Above, where the energy is; the total counts what damping took. Below, two \
        residues on a logarithmic scale: the integration error (the change of the total: is the time \
        step right?) and the work residue (is the bookkeeping right?).",
    no_energy: "This run kept no energy ledger.",
    frames: "The discs",
    first_frame: "At the start.",
    last_frame: "At the end.",
    speeds: "Speeds",
    speeds_caption: "All speeds of all frames, beside Maxwell's distribution in two dimensions of the \
        same mean square: what a gas in equilibrium would have.",
    no_speeds: "No histogram: too few discs, or none that moves.",
    data: "Data",
};
