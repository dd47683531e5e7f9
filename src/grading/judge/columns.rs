//! Which columns are x, y and r, by a heading that names all columns.

/// What x, y and r are called.
const NAMES: [&[&str]; 3] =
    [&["x", "px", "posx", "pos_x"], &["y", "py", "posy", "pos_y"], &["r", "radius", "rad"]];

/// Lines in which a heading is looked for.
const LINES: usize = 60;

/// The columns, from 0, of x, y and r in a text whose first rows of numbers follow a line of as many names; these
/// stand alone, after a `#`, or in it after the word `columns` (or `ATOMS`, of LAMMPS).
///
/// ```
/// use parsim2d::grading::judge::columns::named;
/// assert_eq!(named("# id x y r\n0 0.01 0.02 5e-4\n"), Some([1, 2, 3]));
/// assert_eq!(named("# step 0 time_s 0 n 1 side_m 0.04 columns x y r vx\n0.01 0.02 5e-4 0\n"), Some([0, 1, 2]));
/// assert_eq!(named("# the disc, its x y r\n0.01 0.02 5e-4\n"), None); // no name for every column
/// ```
pub fn named(text: &str) -> Option<[usize; 3]> {
    let mut names: Vec<String> = Vec::new();
    for line in text.split(['\n', '\r']).map(str::trim).take(LINES) {
        let words = words(line.trim_start_matches('#'));
        let has_numbers = words.first().is_some_and(|word| word.parse::<f64>().is_ok());
        if line.starts_with('#') || !has_numbers {
            let is_before = |word: &String| ["columns", "atoms"].contains(&word.as_str());
            let from = words.iter().position(is_before).map_or(0, |before| before + 1);
            let own = words.into_iter().skip(from).collect::<Vec<_>>();
            if places(&own).is_some() {
                names = own;
            }
        } else if words.len() >= 3 {
            return places(&names).filter(|_| names.len() == words.len());
        }
    }
    None
}

/// Words in small letters, without units behind them.
fn words(line: &str) -> Vec<String> {
    let parts = line.split(|c: char| c.is_whitespace() || ",;".contains(c));
    let bare = |word: &str| {
        let word = word.trim_matches(['"', '\'', ':']).to_lowercase();
        let end = word.find(['[', '(', '/']).unwrap_or(word.len());
        word[..end].trim_end_matches("_m").to_owned()
    };
    parts.filter(|word| !word.is_empty()).map(bare).filter(|word| !word.is_empty()).collect()
}

fn places(names: &[String]) -> Option<[usize; 3]> {
    let place = |known: &[&str]| names.iter().position(|name| known.contains(&name.as_str()));
    let [x, y, r] = NAMES.map(place);
    Some([x?, y?, r?])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn headings_name_columns_wherever_they_stand() {
        for (text, expected) in [
            ("x y r\n1 2 3\n", Some([0, 1, 2])),
            ("x,y,r\n1, 2, 3\n", Some([0, 1, 2])),
            ("# x\ty\tphi\tvx\tvy\tomega\tr\tm\n1 2 3 4 5 6 7 8\n", Some([0, 1, 6])),
            (
                "#gravity: 0 -9.81\n# x [m]  y [m]  z [m]  radius [m]\r\n\r\n1 2 3 4\r\n",
                Some([0, 1, 3]),
            ),
            (
                "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n1\nITEM: ATOMS id x y radius\n1 2 3 4\n",
                Some([1, 2, 3]),
            ),
            ("# Frame 1\r# id X Y R\r1 2 3 4\r", Some([1, 2, 3])),
            ("# y x r\n1 2 3\n", Some([1, 0, 2])),
            ("x y r\n1 2 3 4\n", None),
            ("# x y\n1 2 3\n", None),
            ("1 2 3\n# id x y r\n1 2 3 4\n", None),
            ("", None),
        ] {
            assert_eq!(named(text), expected, "{text:?}");
        }
    }
}
