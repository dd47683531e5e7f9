//! What pages say: one table of words for each language. A new language is a new constant; the
//! compiler asks for every entry.

use serde::Serialize;

use super::gas::NoGas;

/// The words of a language.
#[derive(Clone, Copy, Debug)]
pub struct Words {
    /// Its code, for HTML.
    pub code: &'static str,
    /// Title of the report.
    pub report: &'static str,
    /// Before the place for the author's name.
    pub name: &'static str,
    /// Heading of the player.
    pub player_heading: &'static str,
    /// What a player says.
    pub player: PlayerWords,
    /// Heading of the way to repeat the run.
    pub how_to_repeat: &'static str,
    /// Before the command as it was typed, with its seed.
    pub typed: &'static str,
    /// Before the command that repeats the run.
    pub repeats: &'static str,
    /// Heading of the parameters.
    pub parameters: &'static str,
    /// Names of the parameters, by their keys in a scenario file; others are shown under their keys.
    pub parameter_names: [(&'static str, &'static str); 17],
    /// Name of the time step.
    pub time_step: &'static str,
    /// Said below the first of many listed discs, `{}` for how many are left out.
    pub more_listed: &'static str,
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
    /// Below the figure of the energies.
    pub energy_caption: &'static str,
    /// Below the figure of the residues.
    pub residue_caption: &'static str,
    /// Said of a run without a ledger.
    pub no_energy: &'static str,
    /// Heading of the frames.
    pub frames: &'static str,
    /// Below the first frame.
    pub first_frame: &'static str,
    /// Below the last frame.
    pub last_frame: &'static str,
    /// Heading of the velocity field.
    pub velocity: &'static str,
    /// Below the velocity field, `{}` for how long the longest arrow is.
    pub velocity_caption: &'static str,
    /// Said of a field of which every so-manieth arrow is drawn.
    pub fewer_arrows: &'static str,
    /// Heading of the histogram.
    pub speeds: &'static str,
    /// Below a histogram with Maxwell's curve.
    pub maxwell: &'static str,
    /// Why there is no such curve.
    pub no_maxwell: fn(NoGas) -> &'static str,
    /// Said of a run of few discs, or whose discs never move.
    pub no_speeds: &'static str,
    /// Said below discs that are drawn larger than they are.
    pub enlarged: &'static str,
    /// Before the links.
    pub data: &'static str,
}

/// The words of a player; `{}` stands for a number.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct PlayerWords {
    /// Title of a page of a player alone.
    #[serde(skip)]
    pub title: &'static str,
    /// What is to be seen on the picture.
    #[serde(skip)]
    pub picture: &'static str,
    /// What is to be seen on the curves.
    #[serde(skip)]
    pub curves: &'static str,
    /// Names of the energies, by their columns; others are shown under their columns' names.
    #[serde(skip)]
    pub energies: [(&'static str, &'static str); 6],
    /// Before the scale of colours.
    #[serde(skip)]
    pub speed: &'static str,
    /// Lets the film run.
    pub play: &'static str,
    /// Lets it stand.
    pub pause: &'static str,
    /// What these two do.
    #[serde(skip)]
    pub play_said: &'static str,
    /// One frame back.
    #[serde(skip)]
    pub back: &'static str,
    /// One frame on.
    #[serde(skip)]
    pub forth: &'static str,
    /// The slide.
    #[serde(skip)]
    pub moment: &'static str,
    /// Before the choice of paces.
    #[serde(skip)]
    pub pace: &'static str,
    /// The time of the frame shown, s.
    pub clock: &'static str,
    /// The frame shown, if times are not known.
    pub frame: &'static str,
    /// How many seconds of the run a second shows.
    pub rate: &'static str,
    /// Said of a film that has fewer frames than its file: how many, of how many.
    #[serde(skip)]
    pub fewer_frames: &'static str,
    /// Said of a film that shows every so-manieth disc.
    #[serde(skip)]
    pub fewer_discs: &'static str,
    /// Said of discs that are drawn larger than they are.
    #[serde(skip)]
    pub enlarged: &'static str,
    /// Which keys do what.
    #[serde(skip)]
    pub keys: &'static str,
    /// Said where no script runs.
    #[serde(skip)]
    pub no_script: &'static str,
}

/// English.
pub const ENGLISH: Words = Words {
    code: "en",
    report: "Report of a simulation",
    name: "Name",
    player_heading: "The run",
    player: PlayerWords {
        title: "A run to look at",
        picture: "The discs at the moment that the slide shows",
        curves: "The energies over time, with a line at the moment shown",
        energies: [
            ("total", "total"),
            ("gravitational", "gravitational"),
            ("kinetic", "kinetic"),
            ("elastic", "elastic"),
            ("dissipated", "dissipated"),
            ("supplied", "supplied"),
        ],
        speed: "speed",
        play: "Play",
        pause: "Pause",
        play_said: "Play or pause (space)",
        back: "One frame back (left arrow)",
        forth: "One frame on (right arrow)",
        moment: "Moment",
        pace: "Pace",
        clock: "t = {} s",
        frame: "frame {}",
        rate: "a second shows {} s of the run",
        fewer_frames: "It has {} of the {} frames of the file.",
        fewer_discs: "It shows one disc of every {}; the run had them all.",
        enlarged: "On small screens, discs are drawn larger than they are, to be seen.",
        keys: "Space plays and pauses, the arrow keys go frame by frame, Home and End to the ends.",
        no_script: "The player needs JavaScript, which is switched off here.",
    },
    how_to_repeat: "How to repeat it",
    typed: "The command: ",
    repeats: "The same run from the record beside this page: ",
    parameters: "Parameters",
    parameter_names: [
        ("preset", "set of parameters"),
        ("n", "discs"),
        ("seed", "seed"),
        ("side", "side of the box"),
        ("radius", "radius of a disc"),
        ("mass", "mass of a disc"),
        ("gravity", "gravity, downward"),
        ("kn", "normal stiffness k_n"),
        ("eta", "normal damping eta_n"),
        ("gamma", "damping rate gamma"),
        ("restitution", "restitution e"),
        ("no_tension", "contacts never pull"),
        ("nt", "steps in a contact N_t"),
        ("time", "simulated time"),
        ("allow_unstable", "unstable step allowed"),
        ("speed", "rms speed at the start"),
        ("border", "border discs in out.txt"),
    ],
    time_step: "time step dt",
    more_listed: "and {} more in last-run.toml",
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
    energy_caption: "Where the energy is. The total counts what damping took.",
    residue_caption: "The integration error (change of the total): is the time step right? The work \
        residue: is the bookkeeping right?",
    no_energy: "This run kept no energy ledger.",
    frames: "The discs",
    first_frame: "At the start.",
    last_frame: "At the end.",
    velocity: "Velocity field",
    velocity_caption: "The longest arrow is {} % of the box.",
    fewer_arrows: "One disc of every {} has its arrow.",
    speeds: "Speeds",
    maxwell: "The curve is Maxwell's distribution in two dimensions of the same mean square: what a gas in \
        equilibrium has.",
    no_maxwell: |why| match why {
        NoGas::Few => "No curve of Maxwell's: the discs are too few for it to be told from chance.",
        NoGas::Unlike => {
            "No curve of Maxwell's: the discs have different masses, each with its own."
        }
        NoGas::Open => "No curve of Maxwell's: without walls the discs fly apart.",
        NoGas::Unknown => {
            "No curve of Maxwell's: without a ledger it is not known whether this is a gas."
        }
        NoGas::Still => "No curve of Maxwell's: nothing moves.",
        NoGas::Cooling => {
            "No curve of Maxwell's: damping took much of the energy, so this is no gas in equilibrium."
        }
        NoGas::Unsteady => {
            "No curve of Maxwell's: the kinetic energy changed, so this is no gas in equilibrium."
        }
        NoGas::Sparse => {
            "No curve of Maxwell's: the discs hardly met, so nothing brought them to equilibrium."
        }
    },
    no_speeds: "No histogram: too few discs, or none that moves.",
    enlarged: "Discs are drawn larger than they are, to be seen.",
    data: "Beside this page: ",
};
