//! Keys and words with their names of before: they are refused, and the new name is given.

use toml::Spanned as Located;
use toml::de::{DeTable, DeValue};
use tremolite_laws::parameter::Dimension;

use crate::units;

/// What converts whole files.
const SCRIPT: &str = "`scripts/rename-keys FILE` converts a whole file";

/// Key before, key now. It is renamed where the table has a key of the new name and none of the old one.
const KEYS: [(&str, &str); 12] = [
    ("relative", "monitor_pair"),
    ("near", "size_near"),
    ("far", "size_far"),
    ("along", "size_along"),
    ("dip_direction", "dip_azimuth"),
    ("friction", "friction_coefficient"),
    ("ucs", "compressive_strength"),
    ("lateral_of", "k0_stress"),
    ("process", "processing"),
    ("part", "surface_component"),
    ("dynamic", "dynamic_factor"),
    ("model_x_azimuth", "x_azimuth"),
];

/// Word before, word now, of any key.
const WORDS: [(&str, &str); 2] = [("one-point", "reduced-integration"), ("full", "full-integration")];

/// The new name of a key that a table does not have, if the table has that.
pub(crate) fn key<'a>(name: &str, mut here: impl Iterator<Item = &'a str>) -> Option<&'static str> {
    let (_, new) = KEYS.iter().find(|(old, _)| *old == name)?;
    here.any(|key| key == *new).then_some(*new)
}

/// Whether a key is there under its name of before, which is refused by itself.
pub(crate) fn has_old(new: &str, has: impl Fn(&str) -> bool) -> bool {
    KEYS.iter().any(|(old, now)| *now == new && has(old))
}

/// What to write for a renamed key of the table at `path`. `file` is the whole file.
pub(crate) fn remedy(new: &str, path: &str, value: &Located<DeValue<'_>>, file: Azimuth) -> String {
    match new {
        "dip_azimuth" => {
            let old = value.get_ref().as_str().and_then(|text| units::parse(text, Dimension::ANGLE).ok());
            let azimuth = old.map(|old| match path.ends_with("layer") || path.contains("layer[") {
                true => file.0 - old,
                false => file.0 - std::f64::consts::FRAC_PI_2 + old,
            });
            match azimuth {
                Some(azimuth) => {
                    let degrees = (azimuth.to_degrees() * 1e9).round() / 1e9;
                    format!(
                        "write dip_azimuth = \"{} deg\", which is clockwise from north; {SCRIPT}",
                        degrees.rem_euclid(360.0)
                    )
                }
                None => format!("write the direction clockwise from north as `dip_azimuth`; {SCRIPT}"),
            }
        }
        "x_azimuth" if path == "motion" => format!("write `model_x_azimuth` above all tables; {SCRIPT}"),
        new => format!("write `{new}`; {SCRIPT}"),
    }
}

/// The new name of a word that is not known, if it is one of these.
pub(crate) fn word(text: &str, words: &[&'static str]) -> Option<&'static str> {
    let (_, new) = WORDS.iter().find(|(old, _)| *old == text)?;
    words.iter().copied().find(|word| word == new)
}

/// The azimuth \[rad\] of the model's x axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Azimuth(pub f64);

impl Azimuth {
    /// That of a file, whether it stands above all tables or, as before, in `[motion]`.
    pub fn of(file: &DeTable<'_>) -> Self {
        let name = "model_x_azimuth";
        let motion = file.get("motion").and_then(|motion| motion.get_ref().as_table());
        let value = file.get(name).or_else(|| motion.and_then(|motion| motion.get(name)));
        let text = value.and_then(|value| value.get_ref().as_str());
        let angle = text.and_then(|text| units::parse(text, Dimension::ANGLE).ok());
        Azimuth(angle.unwrap_or(std::f64::consts::FRAC_PI_2))
    }
}
