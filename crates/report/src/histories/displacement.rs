//! Displacement of the monitors: as it is, less the mean of all, and of pairs.

use crate::chapter::figure::Section;
use crate::drawing::chart::Mark;
use crate::histories::largest_of_steps::with_steps;
use crate::histories::{Family, ROUND_OFF, Recorded, SMALL, components, largest_of};
use crate::language::say;
use crate::quantities::scale::{figures, quantity};
use crate::quantities::units::Kind;
use crate::source::monitor_pairs::{difference, from_mean, held};

/// A monitor on a broken element, or a pair with one, that moves by this many times the others' largest would flatten them.
const BEYOND_OTHERS: f64 = 3.0;

impl Recorded<'_> {
    /// Figure 5 of the paper.
    pub fn displacement(&self) -> Section {
        let language = self.source.language;
        let names = ["ux", "uy", "uz"];
        let mut caption = self.in_step(say!(
            language,
            "Relative to the state before the earthquake. Look whether all monitors move in step, as those of a cavern do that moves with the rock, and whether they return: what is left at the end is permanent."
        ));
        let size = |monitor: &str| {
            let of = |quantity: &&str| self.table.column(&format!("{monitor}.{quantity}"));
            names.iter().filter_map(of).map(largest_of).fold(0.0, f64::max)
        };
        let loose = self.source.facts().monitors.on_broken_elements;
        let hidden = flattening(&self.monitors, |name| loose.iter().any(|other| other == name), size);
        for monitor in &hidden {
            caption = say!(
                language,
                "{first} Not drawn: {monitor}, up to {size}, on a broken element.",
                first = caption,
                monitor = *monitor,
                size = self.source.quantity(Kind::Displacement, size(monitor))
            );
        }
        let caption = with_steps(self.source, caption, &names, Kind::Displacement);
        let heading = say!(language, "Displacement");
        let panels = components(language, &names, Mark::Largest);
        let family = Family { heading, file: "displacement", caption, panels, negligible: SMALL };
        self.family(family, |quantity| {
            let mut histories = self.of_monitors(quantity);
            histories.retain(|(name, _)| !hidden.contains(&name));
            histories
        })
    }

    /// A caption, and behind it how far the monitors move in step, where the summary says so.
    fn in_step(&self, caption: String) -> String {
        let language = self.source.language;
        let facts = self.source.facts();
        facts.monitors.synchrony.iter().fold(caption, |first, (component, of)| {
            say!(
                language,
                "{first} {component}: of any two monitors that are not on broken elements the correlation is at least \
                 {correlation} ({least}), and the shift in time at which they fit best at most {lag} ({latest}).",
                first = first,
                component = component,
                correlation = figures(of.correlation, 4),
                least = of.least_of,
                lag = quantity("s", of.lag.abs()),
                latest = of.latest_of
            )
        })
    }

    /// What of the displacement strains the linings: without the motion that all monitors share.
    pub fn beside_mean(&self) -> Option<Section> {
        let language = self.source.language;
        if self.monitors.len() < 3 {
            return None;
        }
        // One on a broken element would move the mean of all.
        let loose = self.source.facts().monitors.on_broken_elements;
        let held = |name: &str| !loose.iter().any(|other| other == name);
        let all = !self.monitors.iter().any(|name| held(name));
        let mut caption = say!(
            language,
            "Displacement of each monitor less the mean of all in the same row: motion that all share causes no strain. Look for monitors that do not return to the others."
        );
        if !all && !loose.is_empty() {
            caption = say!(
                language,
                "{first} Not in the mean, since they are on broken elements: {monitors}.",
                first = caption,
                monitors = loose.join(", ")
            );
        }
        Some(self.family(
            Family {
                heading: say!(language, "Displacement less the mean of the monitors"),
                file: "displacement-less-mean",
                caption,
                panels: components(language, &["ux", "uy", "uz"], Mark::Nothing),
                // The files do not hold the size that would have to be told.
                negligible: ROUND_OFF,
            },
            |quantity| from_mean(self.of_monitors(quantity), |name| all || held(name)),
        ))
    }

    /// Of pairs that the case names.
    pub fn relative(&self) -> Section {
        let language = self.source.language;
        let heading = say!(language, "Relative displacement");
        if self.pairs.is_empty() {
            let why = say!(language, "The case names no pairs of monitors ([[monitor_pair]]).");
            return Section::left_out(&heading, why);
        }
        let mut caption = say!(
            language,
            "Of each pair, the displacement of the first monitor less that of the second: what the lining between them has to \
             follow."
        );
        let names = ["ux", "uy", "uz"];
        let facts = self.source.facts();
        let of_pair = |name: &str, quantity: &str| difference(self.table, &facts, name, quantity);
        let (_, loose) = held(self.source, &facts);
        let size = |name: &str| {
            let each = names.iter().filter_map(|quantity| of_pair(name, quantity));
            each.map(|values| largest_of(&values)).fold(0.0, f64::max)
        };
        let hidden = flattening(&self.pairs, |name| loose.contains(&name), size);
        for pair in &hidden {
            let size = size(pair);
            caption = say!(
                language,
                "{first} Not drawn: {pair}, up to {size} along an axis, of which one monitor is on a broken element.",
                first = caption,
                pair = *pair,
                size = self.source.quantity(Kind::Displacement, size)
            );
        }
        let panels = components(language, &names, Mark::Largest);
        self.family(Family { heading, file: "relative", caption, panels, negligible: SMALL }, |quantity| {
            let drawn = self.pairs.iter().filter(|name| !hidden.contains(name));
            drawn.filter_map(|name| Some((name.clone(), of_pair(name, quantity)?))).collect()
        })
    }
}

/// Of those that came loose the ones beside which the others, by their sizes, would be flat lines.
fn flattening(names: &[String], is_loose: impl Fn(&str) -> bool, size: impl Fn(&str) -> f64) -> Vec<&String> {
    let (loose, others): (Vec<&String>, Vec<&String>) = names.iter().partition(|name| is_loose(name));
    let most = others.iter().map(|name| size(name)).fold(0.0, f64::max);
    loose.into_iter().filter(|name| most > 0.0 && size(name) > BEYOND_OTHERS * most).collect()
}
