//! What a case says of its page, as the summary carries it.

use tremolite_case::{Limits, Page};
use tremolite_results::PageWish;

/// What is to be handed to the report.
pub fn wish(page: &Page) -> PageWish {
    let signed = ["designed", "checked", "reviewed", "approved"].into_iter().zip(&page.signed);
    PageWish {
        language: page.language.word().into(),
        view: page.view,
        project: page.project.clone().unwrap_or_default(),
        design_level: page.design_level.clone().unwrap_or_default(),
        signed: signed.filter_map(|(role, name)| Some((role.to_owned(), name.clone()?))).collect(),
        limits: limits(&page.limits).into_iter().collect(),
    }
}

/// Limits by the names that a summary has for them.
pub fn limits(limits: &Limits) -> Vec<(String, f64)> {
    let Limits { displacement, relative_displacement, crack_width, damage, crushing, utilisation } = *limits;
    [
        ("displacement", displacement),
        ("relative_displacement", relative_displacement),
        ("crack_width", crack_width),
        ("damage", damage),
        ("crushing", crushing),
        ("utilisation", utilisation),
    ]
    .into_iter()
    .filter_map(|(name, limit)| Some((name.to_owned(), limit?)))
    .collect()
}
