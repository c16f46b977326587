//! What a given motion is, seen from the model's base.

use std::fmt;
use std::str::FromStr;

use crate::shown::shown;

/// Where the given motion is thought to act. Taking one for another is the most frequent error of users in
/// this field, so it is a type, and the factor is meant to be printed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// At a free surface of the base's rock: twice the incident wave.
    Outcrop,
    /// The up-going incident wave itself.
    Incident,
    /// At a depth within the ground, up-going and down-going waves together. The incident part depends on the layers
    /// and comes by deconvolution.
    Within,
    /// On the surface of layered ground; as for `Within`, at depth 0.
    Surface,
}

impl Kind {
    /// The factor from the given motion to the incident wave, or `None` where no single factor exists.
    ///
    /// Outcrop holds for vertically incident waves in homogeneous rock with a horizontal surface.
    pub fn incident_factor(self) -> Option<f64> {
        match self {
            Kind::Outcrop => Some(0.5),
            Kind::Incident => Some(1.0),
            Kind::Within | Kind::Surface => None,
        }
    }
}

impl fmt::Display for Kind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Kind::Outcrop => "outcrop",
            Kind::Incident => "incident",
            Kind::Within => "within",
            Kind::Surface => "surface",
        })
    }
}

impl FromStr for Kind {
    type Err = String;

    fn from_str(word: &str) -> Result<Kind, String> {
        match word {
            "outcrop" => Ok(Kind::Outcrop),
            "incident" => Ok(Kind::Incident),
            "within" => Ok(Kind::Within),
            "surface" => Ok(Kind::Surface),
            _ => Err(format!(
                "'{}' is not a kind of motion; use outcrop, incident, within or surface",
                shown(word)
            )),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_outcrop_is_halved_and_motion_of_layered_ground_has_no_factor() {
        assert_eq!("outcrop".parse::<Kind>().map(Kind::incident_factor), Ok(Some(0.5)));
        assert_eq!("incident".parse::<Kind>().map(Kind::incident_factor), Ok(Some(1.0)));
        assert_eq!("within".parse::<Kind>().map(Kind::incident_factor), Ok(None));
        assert_eq!("surface".parse::<Kind>().map(Kind::incident_factor), Ok(None));
        assert!("bedrock".parse::<Kind>().is_err());
    }
}
