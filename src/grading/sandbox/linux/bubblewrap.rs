//! The command line of bubblewrap.

use std::fs;
use std::path::{Path, PathBuf};

use super::landlock_rules::READABLE;

/// Where a submission finds itself inside.
pub(super) const INSIDE: &str = "/box";

/// The words before the command: what there is inside, and no network.
pub(super) fn arguments(folder: &Path, scratch: &Path, readable: &[PathBuf]) -> Vec<String> {
    let mut words = Words(Vec::new());
    words.add("--unshare-all --die-with-parent --new-session --hostname box");
    for path in READABLE {
        match fs::read_link(path) {
            // As on Debian, where /bin is a link to usr/bin.
            Ok(target) if !path.starts_with("/etc/") => {
                words.with("--symlink", &[&target, Path::new(path)])
            }
            _ => words.with("--ro-bind-try", &[Path::new(path), Path::new(path)]),
        }
    }
    words.add("--proc /proc --dev /dev --remount-ro /dev");
    words.with("--bind", &[scratch, Path::new("/tmp")]);
    // After what would hide them.
    for path in readable {
        words.with("--ro-bind", &[path, path]);
    }
    words.with("--bind", &[folder, Path::new(INSIDE)]);
    words.add("--remount-ro / --chdir /box");
    words.0
}

struct Words(Vec<String>);

impl Words {
    fn add(&mut self, words: &str) {
        self.0.extend(words.split(' ').map(str::to_owned));
    }

    fn with(&mut self, option: &str, paths: &[&Path]) {
        self.0.push(option.to_owned());
        self.0.extend(paths.iter().map(|path| path.to_string_lossy().into_owned()));
    }
}
