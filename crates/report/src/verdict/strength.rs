//! Lines on linings whose law can neither crack nor yield: the utilisation of their sections.

use tremolite_results::{SectionStrength, Summary};

use crate::language::say;
use crate::section_forces::used::{clauses, shown, without_shear};
use crate::source::Source;
use crate::verdict::VerdictLine;
use crate::verdict::short_names::{NAME, short};

/// Linings of which each has a line.
const ALONE: usize = 2;

/// Those that are judged by it: what cracks or yields is judged by that.
fn judged(facts: &Summary) -> impl Iterator<Item = (&String, &SectionStrength)> {
    facts.parts.sections.iter().filter(|(_, of)| !of.yields)
}

/// The most that a lining uses; an infinite one is no number in the file.
fn most(of: &SectionStrength) -> Option<f64> {
    let each = [&of.bending, &of.shear].into_iter().flatten();
    let size = each.map(|used| if used.value.is_nan() { f64::INFINITY } else { used.value });
    size.max_by(f64::total_cmp)
}

/// A line a lining, the worst first.
pub fn lines(source: &Source, facts: &Summary) -> Vec<VerdictLine> {
    let language = source.language;
    let mut all: Vec<_> = judged(facts).filter_map(|(name, of)| Some((name, of, most(of)?))).collect();
    all.sort_by(|a, b| b.2.total_cmp(&a.2));
    let told = |used: &Option<tremolite_results::Used>| {
        used.as_ref().map_or_else(|| "–".to_owned(), |used| shown(used.value))
    };
    let shear = |of: &SectionStrength| {
        let (value, [_, clause], why) = (told(&of.shear), clauses(of), without_shear(language, of));
        match (clause.is_empty(), why.is_empty()) {
            (true, _) => value,
            (false, true) => say!(language, "{value} in shear ({clause})", value = value, clause = clause),
            (false, false) => {
                say!(
                    language,
                    "{value} in shear ({clause}: {why})",
                    value = value,
                    clause = clause,
                    why = why
                )
            }
        }
    };
    let line = |(name, of, most): (&String, &SectionStrength, f64)| VerdictLine {
        class: if most <= 1.0 { "good" } else { "bad" },
        text: match clauses(of) {
            [first, ""] => say!(
                language,
                "{lining}, {code}: utilisation {bending} in thrust and moment ({first}), shear has no clause; above 1 at {beyond} of {stations} stations.",
                lining = short(name, NAME),
                bending = told(&of.bending),
                first = first,
                code = of.code,
                beyond = of.beyond,
                stations = of.stations
            ),
            [first, _] => say!(
                language,
                "{lining}, {code}: utilisation {bending} in thrust and moment ({first}), {shear}; above 1 at {beyond} of {stations} stations.",
                lining = short(name, NAME),
                bending = told(&of.bending),
                first = first,
                shear = shear(of),
                code = of.code,
                beyond = of.beyond,
                stations = of.stations
            ),
        },
    };
    all.into_iter().take(ALONE).map(line).collect()
}
