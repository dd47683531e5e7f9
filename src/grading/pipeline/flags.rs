//! The flags that a submission's own build gives its compiler, so that a build with warnings or a sanitizer is of the
//! same program: `-fopenmp` left out makes a right program's pragmas a warning.

use crate::grading::sandbox::{Limits, SandboxError, Workspace};

/// Flags that say what a program is, with the word that follows some of them; what asks for warnings, another
/// optimisation or a sanitizer is the rubric's.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Flags {
    /// Of the compiler.
    compile: Vec<String>,
    /// Libraries and where they are, which stand after the sources.
    link: Vec<String>,
}

impl Flags {
    /// The flags in what `build` would do in a folder where it was done before: make says so without doing it.
    pub(super) fn of(
        workspace: &Workspace,
        build: &[String],
        limits: &Limits,
    ) -> Result<Self, SandboxError> {
        if build.first().is_none_or(|program| program != "make") {
            let mut flags = Self::default();
            flags.add(build);
            return Ok(flags);
        }
        let shown = ["-n", "-B"].map(str::to_owned);
        let command: Vec<String> = build.iter().cloned().chain(shown).collect();
        let log = workspace.build_by(&command, limits)?.log;
        let mut flags = Self::default();
        log.lines().filter_map(shlex::split).for_each(|line| flags.add(&line));
        Ok(flags)
    }

    /// Adds those of one command, if it is a compiler's.
    fn add(&mut self, command: &[String]) {
        let flags = self;
        let mut words = command.iter().skip_while(|word| !is_compiler(word)).peekable();
        while let Some(word) = words.next() {
            let Some(kind) = kind(word) else { continue };
            let kept = if kind == Kind::Link { &mut flags.link } else { &mut flags.compile };
            // `-I include` and `-Iinclude` are one.
            let takes_next =
                ["-I", "-D", "-L", "-l", "-include", "-isystem"].contains(&word.as_str());
            let next = takes_next.then(|| words.next_if(|next| is_plain(next))).flatten();
            let own: Vec<String> = [Some(word), next].into_iter().flatten().cloned().collect();
            if !kept.windows(own.len()).any(|known| known == own) {
                kept.extend(own);
            }
        }
    }

    /// `command` with these flags: after a compiler's own words, or in the `CXXFLAGS=` given to make.
    pub(super) fn added_to(&self, command: &[String]) -> Vec<String> {
        let mut command = command.to_vec();
        let is_make = command.first().is_some_and(|program| program == "make");
        let given = command.iter_mut().find(|word| word.starts_with("CXXFLAGS="));
        match given {
            Some(word) => self.compile.iter().for_each(|flag| *word += &format!(" {flag}")),
            None if is_make => {}
            None => command.extend(self.compile.iter().chain(&self.link).cloned()),
        }
        command
    }
}

/// Whether a word is the name of a compiler: g++, clang++-18, /usr/bin/cc.
fn is_compiler(word: &str) -> bool {
    let name = word.rsplit('/').next().unwrap_or_default();
    let name = name.trim_end_matches(|c: char| c.is_ascii_digit() || ".-".contains(c));
    ["g++", "c++", "clang++", "gcc", "clang", "cc"].iter().any(|known| name.ends_with(known))
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Compile,
    Link,
}

/// What a flag is for, if it is one that says what the program is.
fn kind(word: &str) -> Option<Kind> {
    if !is_plain(word) || word.starts_with("-fsanitize") || word.starts_with("-fno-sanitize") {
        return None;
    }
    let begins = |all: &[&str]| all.iter().any(|one| word.starts_with(one));
    match () {
        () if begins(&["-l", "-L", "-Wl,"]) => Some(Kind::Link),
        () if begins(&["-std=", "-f", "-pthread", "-I", "-D", "-include", "-isystem", "-m"]) => {
            Some(Kind::Compile)
        }
        () => None,
    }
}

/// Whether make and its shell take a word as it stands.
fn is_plain(word: &str) -> bool {
    word.chars().all(|c| c.is_ascii_alphanumeric() || "-_+=./,:".contains(c))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(line: &str) -> Vec<String> {
        line.split_whitespace().map(str::to_owned).collect()
    }

    fn flags(lines: &[&str]) -> Flags {
        let mut flags = Flags::default();
        lines.iter().for_each(|line| flags.add(&words(line)));
        flags
    }

    #[test]
    fn what_says_what_a_program_is_is_kept_and_the_rest_is_the_rubrics() {
        let flags = flags(&[
            "rm -fr build",
            "cd src && ccache g++-13 -O3 -Wno-unused -std=c++20 -fopenmp -I include -DN=20 -g -c a.cpp -o a.o",
            "/usr/bin/g++ -std=c++20 -fopenmp -fsanitize=address -o parSim2D a.o -lm -L/opt/x -DBAD=`id`",
        ]);
        assert_eq!(flags.compile, words("-std=c++20 -fopenmp -I include -DN=20"));
        assert_eq!(flags.link, words("-lm -L/opt/x"));
    }

    #[test]
    fn make_is_told_in_its_variable_and_a_compiler_after_the_sources() {
        let flags = flags(&["g++ -fopenmp a.cpp -lm"]);
        let make = ["make", "CXXFLAGS=-O2 -Wall"].map(str::to_owned);
        assert_eq!(flags.added_to(&make), ["make", "CXXFLAGS=-O2 -Wall -fopenmp"]);
        let compiler = words("g++ -O2 -c ./a.cpp");
        assert_eq!(flags.added_to(&compiler), words("g++ -O2 -c ./a.cpp -fopenmp -lm"));
        assert_eq!(flags.added_to(&words("make warn")), words("make warn"));
    }
}
