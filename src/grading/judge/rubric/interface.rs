//! Unit tests of what students declare in their header: the section `[interface]` of a rubric.

use std::fs;
use std::path::{Component, Path};

use serde::{Deserialize, Serialize};

/// A small program of the instructor's (the probe) that includes a header of the student's, reads numbers and prints
/// numbers; and what it should print.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Interface {
    /// File of the probe, beside the rubric or in a folder below.
    pub probe: String,
    /// Command that builds it, word by word, in the folder handed in, where the probe lies under its own name.
    pub build: Vec<String>,
    /// Command that runs it, word by word.
    pub run: Vec<String>,
    /// What it is asked, one after another.
    #[serde(default)]
    pub case: Vec<Case>,
    /// What is in the file of the probe; see [`Interface::read`].
    #[serde(skip)]
    pub source: Vec<u8>,
}

/// One question to the probe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Case {
    /// What is asked, for the student.
    pub name: String,
    /// What the probe reads on its standard input.
    pub stdin: String,
    /// The last numbers that it should print.
    pub expected: Vec<f64>,
    /// How far each may be off: part of the largest of the expected ones, or a number where these are all 0.
    #[serde(default = "usual_tolerance")]
    pub tolerance: f64,
    /// Where to look if it prints others; it should not give the answer away.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub hint: Option<String>,
}

/// A plain C++ stream prints six digits: it is off by up to 5e-6 of the number.
fn usual_tolerance() -> f64 {
    1e-5
}

impl Interface {
    /// Reads the file of the probe, which lies in `folder`, that of the rubric.
    ///
    /// Fails, saying why, if it is not there, or elsewhere in truth (a link).
    pub fn read(&mut self, folder: &Path) -> Result<(), String> {
        let said = |why: std::io::Error| format!("interface.probe = {:?}: {why}", self.probe);
        let whole = |path: &Path| fs::canonicalize(path).map_err(said);
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        let probe = whole(&folder.join(&self.probe))?;
        if !probe.starts_with(whole(folder)?) {
            return Err(self.is_elsewhere());
        }
        self.source = fs::read(&probe).map_err(said)?;
        Ok(())
    }

    /// The name of the probe in the folder handed in.
    pub fn file_name(&self) -> &str {
        self.probe.rsplit('/').next().unwrap_or_default()
    }

    fn is_elsewhere(&self) -> String {
        format!("interface.probe = {:?}: the probe lies in the rubric's folder", self.probe)
    }

    /// What is wrong with a value, if anything: key, value and range.
    pub(super) fn refused(&self) -> Option<String> {
        let is_inside = |part: Component| matches!(part, Component::Normal(_));
        if !Path::new(&self.probe).components().all(is_inside) || self.file_name().is_empty() {
            return Some(self.is_elsewhere());
        }
        if self.build.is_empty() || self.run.is_empty() {
            let example =
                r#"build = ["g++", "-o", "probe", "probe.cpp", "particle.cpp"], run = ["./probe"]"#;
            return Some(format!("interface.build or interface.run is empty; as {example}"));
        }
        if self.case.is_empty() {
            return Some("[interface] has no [[interface.case]]: there is nothing to compare\n  way out: one [[interface.case]] and more, each with name, stdin and expected".to_owned());
        }
        self.case.iter().find_map(Case::refused)
    }
}

impl Case {
    fn refused(&self) -> Option<String> {
        let name = &self.name;
        if self.expected.is_empty() || self.expected.iter().any(|value| !value.is_finite()) {
            let value = &self.expected;
            return Some(format!("expected = {value:?} of the case {name:?}: finite numbers"));
        }
        let value = self.tolerance;
        let is_bad = !(value.is_finite() && value > 0.0);
        is_bad.then(|| {
            format!("tolerance = {value} of the case {name:?} is out of range; it is above 0")
        })
    }

    /// How far each number may be off.
    pub fn slack(&self) -> f64 {
        let largest = self.expected.iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        if largest > 0.0 { self.tolerance * largest } else { self.tolerance }
    }
}
