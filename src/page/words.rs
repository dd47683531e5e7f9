//! What pages say.

use serde::Serialize;

use super::gas::NoGas;
use crate::table::table;

type Text = &'static str;

table! {
    /// The words of a language.
    #[derive(Clone, Copy, Debug)]
    pub struct Words, const ENGLISH {
        /// Its code, for HTML.
        code: Text = "en";
        /// Title of the report.
        report: Text = "Report of a simulation";
        /// Before the place for the author's name.
        name: Text = "Name";
        /// Heading of the player.
        player_heading: Text = "The run";
        /// What a player says.
        player: PlayerWords = ENGLISH_PLAYER;
        /// Heading of the way to repeat the run.
        how_to_repeat: Text = "How to repeat it";
        /// Before the command as it was typed, with its seed.
        typed: Text = "The command: ";
        /// Before the command that repeats the run.
        repeats: Text = "The same run from the record beside this page: ";
        /// Heading of the parameters.
        parameters: Text = "Parameters";
        /// Names of the parameters, by their keys in a scenario file; others are shown under their keys.
        parameter_names: [(Text, Text); 17] = [
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
        ];
        /// Name of the time step.
        time_step: Text = "time step dt";
        /// Said below the first of many listed discs, `{}` for how many are left out.
        more_listed: Text = "and {} more in last-run.toml";
        /// Heading of the results.
        results: Text = "Results";
        /// Names of the results, by their keys in the file of the run; others are shown under their keys.
        result_names: [(Text, Text); 11] = [
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
        ];
        /// Said of a run without results.
        no_results: Text = "The run has not ended; it left no results.";
        /// Heading of the diagnosis.
        diagnosis: Text = "Diagnosis";
        /// Said if the scenario cannot be judged any more.
        no_diagnosis: Text = "The scenario cannot be read any more: ";
        /// Heads of the table of contacts: what, two discs, wall, verdict.
        contact_head: [Text; 4] = ["a contact", "two discs", "wall", ""];
        /// Heads of the table of limits: what, limit, dt over it, verdict.
        limit_head: [Text; 4] = ["largest time step", "limit, s", "dt / limit", ""];
        /// Heading of what went wrong.
        failure: Text = "What went wrong";
        /// Names of what is said of it, by their keys in `failure.json`.
        failure_names: [(Text, Text); 8] = [
            ("what", "what"),
            ("step", "at step"),
            ("time_s", "at time, s"),
            ("discs", "discs"),
            ("fault", "parameter at fault"),
            ("value", "its value"),
            ("diagnosis", "why"),
            ("ways_out", "ways out"),
        ];
        /// Heading of theory beside measurement.
        answer: Text = "Theory and measurement";
        /// Its heads: what, theory, measured, relative error, order in dt.
        answer_head: [Text; 5] = ["first contact", "theory", "measured", "error", "order in dt"];
        /// Heading of the place for the author's own answer.
        own_words: Text = "Does the total energy stay constant? If not, what is the problem, and can it be solved?";
        /// Before the number of the first frame that cannot be drawn.
        cut: Text = "The run cannot be drawn from frame ";
        /// Heading of the energy.
        energy: Text = "Energy";
        /// Below the figure of the energies.
        energy_caption: Text = "Where the energy is. The total counts what damping took.";
        /// Below the figure of the residues.
        residue_caption: Text = "The integration error (change of the total): is the time step right? The work \
            residue: is the bookkeeping right?";
        /// Said of a run without a ledger.
        no_energy: Text = "This run kept no energy ledger.";
        /// Heading of the frames.
        frames: Text = "The discs";
        /// Below the first frame.
        first_frame: Text = "At the start.";
        /// Below the last frame.
        last_frame: Text = "At the end.";
        /// Heading of the velocity field.
        velocity: Text = "Velocity field";
        /// Below the velocity field, `{}` for how long the longest arrow is.
        velocity_caption: Text = "The longest arrow is {} % of the box.";
        /// Said of a field of which every so-manieth arrow is drawn.
        fewer_arrows: Text = "One disc of every {} has its arrow.";
        /// Heading of the histogram.
        speeds: Text = "Speeds";
        /// Below a histogram with Maxwell's curve.
        maxwell: Text = "The curve is Maxwell's distribution in two dimensions of the same mean square: what a gas in \
            equilibrium has.";
        /// Why there is no such curve.
        no_maxwell: fn(NoGas) -> Text = |why| match why {
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
        };
        /// Said of a run of few discs, or whose discs never move.
        no_speeds: Text = "No histogram: too few discs, or none that moves.";
        /// Said below discs that are drawn larger than they are.
        enlarged: Text = "Discs are drawn larger than they are, to be seen.";
        /// Before the links.
        data: Text = "Beside this page: ";
    }
}

table! {
    /// The words of a player; `{}` stands for a number.
    #[derive(Clone, Copy, Debug, Serialize)]
    pub struct PlayerWords, const ENGLISH_PLAYER {
        /// Title of a page of a player alone.
        #[serde(skip)]
        title: Text = "A run to look at";
        /// What is to be seen on the picture.
        #[serde(skip)]
        picture: Text = "The discs at the moment that the slide shows";
        /// What is to be seen on the curves.
        #[serde(skip)]
        curves: Text = "The energies over time, with a line at the moment shown";
        /// Names of the energies, by their columns; others are shown under their columns' names.
        #[serde(skip)]
        energies: [(Text, Text); 6] = [
            ("total", "total"),
            ("gravitational", "gravitational"),
            ("kinetic", "kinetic"),
            ("elastic", "elastic"),
            ("dissipated", "dissipated"),
            ("supplied", "supplied"),
        ];
        /// Before the scale of colours.
        #[serde(skip)]
        speed: Text = "speed";
        /// Lets the film run.
        play: Text = "Play";
        /// Lets it stand.
        pause: Text = "Pause";
        /// What these two do.
        #[serde(skip)]
        play_said: Text = "Play or pause (space)";
        /// One frame back.
        #[serde(skip)]
        back: Text = "One frame back (left arrow)";
        /// One frame on.
        #[serde(skip)]
        forth: Text = "One frame on (right arrow)";
        /// The slide.
        #[serde(skip)]
        moment: Text = "Moment";
        /// Before the choice of paces.
        #[serde(skip)]
        pace: Text = "Pace";
        /// The time of the frame shown, s.
        clock: Text = "t = {} s";
        /// The frame shown, if times are not known.
        frame: Text = "frame {}";
        /// How many seconds of the run a second shows.
        rate: Text = "a second shows {} s of the run";
        /// Said of a film that has fewer frames than its file: how many, of how many.
        #[serde(skip)]
        fewer_frames: Text = "It has {} of the {} frames of the file.";
        /// Said of a film that shows every so-manieth disc.
        #[serde(skip)]
        fewer_discs: Text = "It shows one disc of every {}; the run had them all.";
        /// Said of discs that are drawn larger than they are.
        #[serde(skip)]
        enlarged: Text = "On small screens, discs are drawn larger than they are, to be seen.";
        /// Which keys do what.
        #[serde(skip)]
        keys: Text = "Space plays and pauses, the arrow keys go frame by frame, Home and End to the ends.";
        /// Said where no script runs.
        #[serde(skip)]
        no_script: Text = "The player needs JavaScript, which is switched off here.";
    }
}
