//! The known word nearest to one that is not known.

/// The guide's symbols, and one-letter ones, for keys with longer names.
const SYMBOLS: [(&str, &str); 11] = [
    ("g", "gravity"),
    ("l", "side"),
    ("r", "radius"),
    ("m", "mass"),
    ("k", "kn"),
    ("k_n", "kn"),
    ("eta_n", "eta"),
    ("N_t", "nt"),
    ("n_t", "nt"),
    ("N", "n"),
    ("e", "restitution"),
];

/// The known word nearest to `word`, if one is near enough to be meant.
pub fn did_you_mean<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    const LONGEST: usize = 60; // bytes; no known word is half as long
    if word.len() > LONGEST {
        return None;
    }
    if let Some((_, key)) = SYMBOLS.iter().find(|(symbol, _)| *symbol == word) {
        return known.iter().copied().find(|near| near == key);
    }
    let word = word.replace('-', "_");
    // One letter off, or two exchanged, is nearer than a long word that begins alike.
    let likeness = |known: &&str| match strsim::osa_distance(&word, known) {
        0 | 1 if known.len() > 2 => 1.0 + strsim::jaro_winkler(&word, known),
        _ => strsim::jaro_winkler(&word, known),
    };
    // A part of one name only, as `verlet`.
    let mut whole = known.iter().copied().filter(|known| word.len() > 3 && known.contains(&word));
    if let (Some(only), None) = (whole.next(), whole.next()) {
        return Some(only);
    }
    known
        .iter()
        .copied()
        .max_by(|a, b| likeness(a).total_cmp(&likeness(b)))
        .filter(|near| likeness(near) > 0.75)
}
