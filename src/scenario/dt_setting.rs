//! A time step as it may be said.

use serde::Deserialize;

use super::quantity::{Quantity, Time};
use crate::echo;

/// A time step in seconds, or `auto`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DtSetting {
    /// A fixed fraction of the stable limit.
    Auto,
    /// So many seconds.
    Seconds(f64),
}

impl DtSetting {
    /// The seconds, if they were said.
    pub(super) fn seconds(self) -> Option<f64> {
        if let Self::Seconds(seconds) = self { Some(seconds) } else { None }
    }
}

impl std::str::FromStr for DtSetting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        if text.trim() == "auto" {
            return Ok(Self::Auto);
        }
        let seconds: Quantity<Time> = text.parse().map_err(|why| format!("{why}, nor `auto`"))?;
        Ok(Self::Seconds(seconds.si))
    }
}

impl<'de> Deserialize<'de> for DtSetting {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "a number of seconds, a string with a unit, or \"auto\"")]
        enum Said {
            Number(f64),
            Text(String),
        }
        match Said::deserialize(deserializer)? {
            Said::Number(seconds) => Ok(Self::Seconds(seconds)),
            Said::Text(text) => {
                let refused = |why| format!("`{}` is {why}", echo::value(&text));
                text.parse().map_err(|why: String| serde::de::Error::custom(refused(why)))
            }
        }
    }
}
