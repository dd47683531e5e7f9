//! What the lines that begin with `#` say: our own heads, those of Poeschel and Schwager, and remarks.

/// What remarks begin with.
pub const COMMENT: [char; 2] = ['#', '%'];

/// What one of them says, as far as it says anything.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Comment {
    /// Steps done.
    pub step: Option<u64>,
    /// Simulated time, s.
    pub time: Option<f64>,
    /// Number of discs.
    pub n: Option<usize>,
    /// Side of the box, m.
    pub side: Option<f64>,
    /// Sides of a box that may not be square, m.
    pub sides: [Option<f64>; 2],
    /// The names of the columns, after `columns`.
    pub columns: Option<String>,
    /// Words that may be names of columns.
    pub names: Option<String>,
    /// Whether a frame begins with it.
    pub is_head: bool,
    /// Whether it is one of those that Poeschel and Schwager's programs write.
    pub is_of_book: bool,
}

impl Comment {
    /// Reads `text`, what stands after the `#`.
    pub fn of(text: &str) -> Self {
        let text = text.trim_start_matches('#').trim();
        let first = text.split_whitespace().next().unwrap_or_default();
        if ["step", "time_s", "n", "side_m", "columns"].contains(&first) {
            let head = Self::of_head(text);
            if head != (Self { is_head: head.is_head, ..Self::default() }) {
                return head;
            }
        }
        if first == "NewFrame" {
            return Self { is_head: true, is_of_book: true, ..Self::default() };
        }
        match text.split_once([':', '=']) {
            Some((key, value)) => Self::of_pair(key.trim(), value.trim()),
            None => Self { names: Some(text.to_owned()), ..Self::default() },
        }
    }

    /// `step 0 time_s 0 n 20 side_m 0.04 columns x y r`
    fn of_head(text: &str) -> Self {
        let (pairs, columns) = match text.split_once("columns ") {
            Some((pairs, columns)) => (pairs, Some(columns.to_owned())),
            None => (text, None),
        };
        let mut head = Self { is_head: true, columns, ..Self::default() };
        let words: Vec<&str> = pairs.split_whitespace().collect();
        for pair in words.windows(2) {
            match pair[0] {
                "step" => head.step = pair[1].parse().ok(),
                "time_s" => head.time = pair[1].parse().ok(),
                "n" => head.n = pair[1].parse().ok(),
                "side_m" => head.side = pair[1].parse().ok(),
                _ => {}
            }
        }
        head
    }

    /// `Time: 0.5`
    fn of_pair(key: &str, value: &str) -> Self {
        let number = || value.split_whitespace().next().and_then(|word| word.parse().ok());
        let is_of_book =
            matches!(key, "gravity" | "timestep" | "nstep" | "nprint" | "nenergy" | "lx" | "type");
        let mut said = Self { is_of_book, ..Self::default() };
        match key.to_lowercase().as_str() {
            "time" | "t" | "time_s" => {
                said.time = number();
                said.is_head = said.time.is_some();
            }
            "lx" => said.sides[0] = number(),
            "ly" => said.sides[1] = number(),
            "no_of_particles" => said.n = value.parse().ok(),
            "columns" => said.columns = Some(value.to_owned()),
            _ => {}
        }
        said
    }
}
