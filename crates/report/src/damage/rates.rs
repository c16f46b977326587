//! How much stronger concrete was for being strained fast, where it failed.

use serde::Serialize;
use tremolite_results::{Damaged, MaterialValue, RateFactor, Summary};

use crate::damage::{heading, place};
use crate::language::{Language, say};
use crate::quantities::scale::figures;

/// The rate factors of one measure of damage in one group.
#[derive(Serialize)]
pub struct RateRow {
    /// Empty where it is that of the row above.
    pub group: String,
    pub measure: String,
    pub largest: String,
    pub place: String,
    pub mean: String,
    /// Where damage began.
    pub first: String,
}

/// The rate law of a strength that is the same at any rate.
pub const STATIC: &str = "none";

/// Whether some material is stronger the faster it is strained.
pub fn goes_by_rate(summary: &Summary) -> bool {
    let grows = |value: &MaterialValue| value.name == "rate" && value.word != STATIC;
    summary.computed.materials.values().any(|facts| facts.values.iter().any(grows))
}

/// Digits of a factor.
const DIGITS: i32 = 3;

/// What is damaged in which law goes by rates.
pub fn rates(language: Language, summary: &Summary) -> Vec<RateRow> {
    if !goes_by_rate(summary) {
        return Vec::new();
    }
    let mut rows = Vec::new();
    for (name, group) in &summary.parts.damage {
        let known = group.measures.iter().filter_map(|(measure, damaged)| Some((measure, damaged.rate?)));
        for (k, (measure, rate)) in known.enumerate() {
            rows.push(RateRow {
                group: if k == 0 { name.clone() } else { String::new() },
                measure: heading(language, measure),
                largest: figures(rate.largest, DIGITS),
                place: place(language, rate.at.element, rate.at.at),
                mean: figures(rate.mean, DIGITS),
                first: figures(rate.first, DIGITS),
            });
        }
    }
    rows
}

/// What the rate made of the strength in tension of each lining that cracked; nothing where none did, or the results do not tell.
pub fn stronger(language: Language, summary: &Summary) -> Option<String> {
    let linings = summary.conclusion.findings.iter().filter(|f| f.id.starts_with("damage_"));
    let rate = |group: &str| -> Option<RateFactor> {
        let cracked: &Damaged = summary.parts.damage.get(group)?.measures.get("d_tension")?;
        cracked.rate
    };
    let told =
        linings.filter_map(|finding| Some((&finding.group, rate(&finding.group)?))).map(|(name, rate)| {
            let largest = figures(rate.largest, DIGITS);
            match rate.first.is_finite() {
                true => say!(
                    language,
                    "{largest} times in {lining}, {first} where cracking began",
                    largest = largest,
                    lining = name,
                    first = figures(rate.first, DIGITS)
                ),
                false => say!(language, "{largest} times in {lining}", largest = largest, lining = name),
            }
        });
    let all = told.collect::<Vec<String>>().join(&say!(language, "; "));
    (!all.is_empty())
        .then(|| say!(language, "Where it cracked its tensile strength was up to {told}.", told = all))
}
