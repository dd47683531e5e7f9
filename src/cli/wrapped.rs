//! Text in lines.

/// What stands after a number and stays with it.
const UNITS: [&str; 6] = ["%", "s", "m", "J", "r", "m/s"];

/// `text` in lines of at most `width` characters, if no word is longer; a number keeps its unit.
pub(super) fn wrapped(text: &str, width: usize) -> String {
    let mut words: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        let bare = word.trim_end_matches(['.', ',', ';', ':', ')']);
        match words.last_mut() {
            Some(number) if UNITS.contains(&bare) => *number = format!("{number} {word}"),
            _ => words.push(word.to_owned()),
        }
    }
    let mut lines = vec![String::new()];
    for word in words {
        let line = lines.last_mut().expect("never empty");
        if line.is_empty() {
            *line = word;
        } else if line.chars().count() + 1 + word.chars().count() <= width {
            line.push(' ');
            line.push_str(&word);
        } else {
            lines.push(word);
        }
    }
    lines.join("\n")
}

#[cfg(test)]
mod tests {
    use super::wrapped;

    #[test]
    fn lines_keep_to_their_width_and_numbers_keep_their_units() {
        let text = "it gains 21.7 % in a bounce, and 0.097 % (order 2.00 in dt) after 0.35 s.";
        for width in [10, 20, 33, 80] {
            let lines = wrapped(text, width);
            assert!(lines.lines().all(|line| line.chars().count() <= width), "{lines}");
            assert_eq!(lines.replace('\n', " "), text);
            for unit in ["%", "s."] {
                assert!(lines.lines().all(|line| !line.starts_with(unit)), "{lines}");
            }
        }
    }
}
