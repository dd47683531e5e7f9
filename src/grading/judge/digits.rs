//! How finely numbers were printed: what a difference may be before it means anything.

/// The way in which a file prints its positions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Digits {
    /// So many digits after the dot in every number.
    Fixed(i32),
    /// So many significant digits, zeros at the end left out (what C++ streams do).
    General(i32),
}

/// What is known of the digits while a file is read.
#[derive(Clone, Copy, Debug, Default)]
pub struct Tally {
    significant: i32,
    decimals: Option<i32>,
    varies: bool,
}

impl Tally {
    /// Takes note of one number as printed; not of what is no number, nor of what has left any box: written out, either
    /// has other digits than the rest.
    pub fn note(&mut self, word: &str) {
        const NOWHERE: f64 = 1e6;
        if !word.parse::<f64>().is_ok_and(|value| value.abs() < NOWHERE) {
            return;
        }
        let mantissa = word.split(['e', 'E']).next().unwrap_or_default();
        let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
        let decimals = mantissa.split('.').nth(1).map_or(0, str::len) as i32;
        self.significant = self.significant.max(digits.trim_start_matches('0').len() as i32);
        self.varies |= word.len() != mantissa.len();
        self.varies |= self.decimals.is_some_and(|before| before != decimals);
        self.decimals = Some(decimals);
    }

    /// What they were.
    pub fn digits(&self) -> Digits {
        match self.decimals {
            Some(decimals) if !self.varies => Digits::Fixed(decimals),
            _ => Digits::General(self.significant.max(1)),
        }
    }
}

impl Digits {
    /// Half a unit of the last printed place of `value`.
    ///
    /// ```
    /// use parsim2d::grading::judge::digits::Digits;
    /// assert!((Digits::Fixed(4).half_unit(0.03) - 5e-5).abs() < 1e-12);
    /// assert!((Digits::General(6).half_unit(0.0123) - 5e-8).abs() < 1e-12);
    /// ```
    pub fn half_unit(self, value: f64) -> f64 {
        match self {
            Self::Fixed(decimals) => 0.5 * 10f64.powi(-decimals.min(300)),
            Self::General(_) if value == 0.0 => 0.0,
            Self::General(digits) => {
                0.5 * 10f64.powi(value.abs().log10().floor() as i32 - digits.min(300) + 1)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_exploded_does_not_make_the_rest_look_finer() {
        for (words, expected) in [
            (["0.012345", "nan", "0.020000"], Digits::Fixed(6)),
            (["0.0123456", "123457000000000000000000000", "0.02"], Digits::General(6)),
            (["0.0123456", "-inf", "1.23457e+150"], Digits::Fixed(7)),
        ] {
            let mut tally = Tally::default();
            words.into_iter().for_each(|word| tally.note(word));
            assert_eq!(tally.digits(), expected, "{words:?}");
        }
    }
}
