//! Which way a channel looks.

use std::fmt;

/// The positive direction of a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Orientation {
    /// Horizontal; the azimuth (rad) clockwise from north, in [0, 2π).
    Azimuth(f64),
    /// Vertical, upwards positive.
    Up,
}

impl Orientation {
    /// East, azimuth 90°.
    pub const EAST: Orientation = Orientation::Azimuth(std::f64::consts::FRAC_PI_2);
    /// North, azimuth 0.
    pub const NORTH: Orientation = Orientation::Azimuth(0.0);

    /// The direction of a channel by its code, such as `HNE`: `E`, `N` and `Z` at the end of three letters are positive to the
    /// east, north and up (SEED manual, appendix A). `None` for other codes, `HN1` and `HN2` among them, whose direction
    /// only the station's metadata know.
    pub fn of_channel_code(code: &str) -> Option<Orientation> {
        match code.as_bytes() {
            [_, _, b'E'] => Some(Orientation::EAST),
            [_, _, b'N'] => Some(Orientation::NORTH),
            [_, _, b'Z'] => Some(Orientation::Up),
            _ => None,
        }
    }

    /// A horizontal direction from degrees clockwise from north; 360 becomes 0.
    pub fn from_degrees(degrees: f64) -> Orientation {
        Orientation::Azimuth(degrees.rem_euclid(360.0).to_radians())
    }

    /// Reads a component's label as records print it: `Up`, `UD`, `Vert`, `N`, `EW`, `090`, `332 deg`, an accelerometer's channel
    /// such as `HNE`, or a quadrant bearing such as `N28W` (28° from north towards west, azimuth 332°). `ENE` and
    /// `NNE` are points of the compass as well, so they are none.
    ///
    /// `EW` and `NS` mean positive to the east and to the north, as is the custom. `None` for anything else,
    /// `Down` among it: the sign would have to be turned and the caller must decide that.
    pub fn parse(label: &str) -> Option<Orientation> {
        let word = label.trim().trim_end_matches('.').to_ascii_uppercase();
        match word.as_str() {
            "UP" | "UD" | "U-D" | "V" | "Z" | "VERT" | "VERTICAL" => return Some(Orientation::Up),
            "N" | "NS" | "N-S" | "NORTH" => return Some(Orientation::NORTH),
            "E" | "EW" | "E-W" | "EAST" => return Some(Orientation::EAST),
            "S" | "SOUTH" => return Some(Orientation::from_degrees(180.0)),
            "W" | "WEST" => return Some(Orientation::from_degrees(270.0)),
            _ => {}
        }
        if let [b'B' | b'C' | b'E' | b'H' | b'S', b'N', _] = word.as_bytes()
            && word != "ENE"
        {
            return Orientation::of_channel_code(&word);
        }
        if let Some(degrees) = degrees(word.trim_end_matches("DEG").trim(), 360.0) {
            return Some(Orientation::from_degrees(degrees));
        }
        let north = match word.chars().next()? {
            'N' => true,
            'S' => false,
            _ => return None,
        };
        let east = match word.chars().last()? {
            'E' => true,
            'W' => false,
            _ => return None,
        };
        // The first and last characters are single bytes here, and differ, so the range is sound.
        let angle = degrees(&word[1..word.len() - 1], 90.0)?;
        Some(Orientation::from_degrees(match (north, east) {
            (true, true) => angle,
            (false, true) => 180.0 - angle,
            (false, false) => 180.0 + angle,
            (true, false) => 360.0 - angle,
        }))
    }
}

/// A plain number of degrees in [0, `largest`], written with digits and a point alone.
fn degrees(text: &str, largest: f64) -> Option<f64> {
    if !text.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
        return None;
    }
    text.trim().parse().ok().filter(|d| (0.0..=largest).contains(d))
}

impl fmt::Display for Orientation {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Orientation::Azimuth(azimuth) => write!(f, "azimuth {:.1} deg", azimuth.to_degrees()),
            Orientation::Up => f.write_str("up"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quadrant_bearings_become_azimuths_clockwise_from_north() {
        for (label, degrees) in [
            ("N28W", 332.0),
            ("S62W", 242.0),
            ("N60E", 60.0),
            ("S30E", 150.0),
            ("090", 90.0),
            ("360", 0.0),
            ("332 deg", 332.0),
            ("ew", 90.0),
            ("S", 180.0),
        ] {
            match Orientation::parse(label) {
                Some(Orientation::Azimuth(a)) => assert!((a.to_degrees() - degrees).abs() < 1e-9, "{label}"),
                other => panic!("{label}: {other:?}"),
            }
        }
        for label in ["Up", "U-D", "HNZ", "enz"] {
            assert_eq!(Orientation::parse(label), Some(Orientation::Up), "{label}");
        }
        assert_eq!(Orientation::parse("HNE"), Some(Orientation::EAST));
        assert_eq!(Orientation::parse("BNN"), Some(Orientation::NORTH));
    }

    #[test]
    fn labels_without_a_clear_direction_give_none() {
        for label in [
            "", "Down", "DWN", "N100W", "361", "-90", "NaN", "N28", "NW", "inf", "H1", "é", "Né8W", "ENE",
            "NNE", "WNE", "HN1", "HN2", "HHE", "D-U", "WE",
        ] {
            assert_eq!(Orientation::parse(label), None, "{label}");
        }
    }
}
