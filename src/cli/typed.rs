//! The command line as it was typed.

/// The command as it was typed, without the folder it wrote to: the same command leaves the same files
/// in any folder.
pub(super) fn typed() -> String {
    let mut words = vec!["parsim2d".to_owned()];
    let mut said = std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned());
    while let Some(word) = said.next() {
        match word.as_str() {
            "--out-dir" => drop(said.next()),
            word if word.starts_with("--out-dir=") => {}
            word => words.push(quoted(word)),
        }
    }
    words.join(" ")
}

/// `word` as a shell takes it for one, on one line.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_alphanumeric() || "-_./:=+,%@".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        return word.to_owned();
    }
    let one_line = word.replace(|c: char| c.is_control(), " ");
    format!("'{}'", one_line.replace('\'', r"'\''"))
}
