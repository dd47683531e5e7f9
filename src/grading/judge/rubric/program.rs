//! How a course's submissions are built and run: the section `[program]` of a rubric.

use serde::{Deserialize, Serialize};

use crate::table::table;

table! {
    /// How submissions become programs, and programs frames. Commands are split into words as a shell does it,
    /// but no shell runs them.
    #[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
    #[serde(deny_unknown_fields, default)]
    pub struct Program, Default {
        /// Files that are to be handed in.
        files: Vec<String> = ["Makefile", "particle.h", "particle.cpp", "simulation.cpp"]
            .map(str::to_owned)
            .into();
        /// Command that builds; empty: nothing to build.
        build: String = "make".to_owned();
        /// Command that runs.
        run: String = "./parSim2D".to_owned();
        /// Its arguments; `{n}`, `{seed}` and `{frames}` stand for numbers.
        arguments: Vec<String> = Vec::new();
        /// What it reads on its standard input; the same stand for numbers.
        stdin: String = String::new();
        /// Number of discs it is asked for, where it can be asked.
        n: usize = 20;
        /// Seed it is asked for, where it can be asked.
        seed: u64 = 1;
        /// Frames that are enough.
        frames: usize = 400;
        /// Fewer whole frames than this, in the time there is, are too few.
        frames_at_least: usize = 20;
        /// Rows after the discs of a frame that are no discs.
        extra_rows: usize = 0;
        /// Discs of the crowded box; 0: it is not asked for.
        many: usize = 1000;
        /// Frames of it.
        many_frames: usize = 12;
        /// Commands that build with warnings (`-Wextra` among their words), of which the first that works counts;
        /// `{sources}` stands for the files in C and C++. None: warnings are looked for in what `build` prints.
        warnings: Vec<String> = vec![
            "make 'CXXFLAGS=-O2 -Wall -Wextra'".to_owned(),
            "g++ -O2 -Wall -Wextra -c {sources}".to_owned(),
        ];
        /// Commands that build with sanitizers, of which the first that works counts. None: they are not asked for.
        sanitizer: Vec<String> = vec![
            "make 'CXXFLAGS=-O1 -g -fsanitize=address,undefined'".to_owned(),
            "g++ -O1 -g -fsanitize=address,undefined -o parSim2D {sources}".to_owned(),
        ];
        /// Wall time of a build, s.
        build_seconds: f64 = 60.0;
        /// Wall time of a run, s.
        run_seconds: f64 = 20.0;
        /// Wall time of the run of many, s.
        many_seconds: f64 = 60.0;
    }
}

impl Program {
    /// Whether a program is told how many discs there are to be.
    pub fn tells_n(&self) -> bool {
        self.arguments.iter().chain([&self.stdin]).any(|text| text.contains("{n}"))
    }

    /// What is wrong with a number, if anything: key, value and range.
    pub(super) fn refused(&self) -> Option<String> {
        let seconds = [
            ("build_seconds", self.build_seconds),
            ("run_seconds", self.run_seconds),
            ("many_seconds", self.many_seconds),
        ];
        let out = |(_, value): &(&str, f64)| !(*value > 0.0 && *value <= 3600.0);
        if let Some((key, value)) = seconds.into_iter().find(out) {
            return Some(format!(
                "program.{key} = {value} is out of range; it is above 0, at most 3600 s"
            ));
        }
        self.text_refused().or_else(|| {
            let least = [
                ("n", self.n, 1),
                ("frames", self.frames, 1),
                ("many_frames", self.many_frames, 2),
            ];
            let (key, value, least) = least.into_iter().find(|(_, value, least)| value < least)?;
            Some(format!("program.{key} = {value} is out of range; it is at least {least}"))
        })
    }

    /// What is wrong with a command, a file or an argument.
    fn text_refused(&self) -> Option<String> {
        if self.run.trim().is_empty() {
            return Some(
                "program.run is empty; it is the command that runs, as ./parSim2D".to_owned(),
            );
        }
        let is_outside =
            |file: &&String| file.starts_with('/') || file.split('/').any(|part| part == "..");
        if let Some(file) = self.files.iter().find(is_outside) {
            return Some(format!("program.files has {file:?}; files lie in the folder handed in"));
        }
        let rest = |text: &&String| {
            let known = ["{n}", "{seed}", "{frames}"];
            known.iter().fold((*text).clone(), |text, name| text.replace(name, "")).contains('{')
        };
        if let Some(text) = self.arguments.iter().chain([&self.stdin]).find(rest) {
            let known = "{n}, {seed} and {frames} stand for numbers, nothing else does";
            return Some(format!("program.arguments or program.stdin has {text:?}; {known}"));
        }
        let wants_shell =
            |command: &&String| ["&&", ";", "|", ">"].iter().any(|sign| command.contains(sign));
        if let Some(command) = [&self.build, &self.run].into_iter().find(wants_shell) {
            let way_out = "no shell runs it; way out: a target of a Makefile";
            return Some(format!("the command {command:?} wants a shell, and {way_out}"));
        }
        (self.frames_at_least > self.frames).then(|| {
            let (least, most) = (self.frames_at_least, self.frames);
            format!("program.frames_at_least = {least} is above program.frames = {most}")
        })
    }
}
