//! The largest values of all steps, of which the rows that figures draw are a few.

use crate::language::say;
use crate::quantities::units::Kind;
use crate::source::Source;

/// A caption, and behind it the largest size that a monitor had in any step of some quantities; loose pieces are left out.
pub fn with_steps(source: &Source, caption: String, quantities: &[&str], kind: Kind) -> String {
    let facts = source.facts();
    let held = |name: &&String| !facts.monitors.on_broken_elements.contains(name);
    let sizes = facts.monitors.peaks.keys().filter(held).flat_map(|name| {
        let of = |quantity: &&str| {
            let peaks = facts.monitors.peaks[name].get(*quantity)?;
            let [max, min] = [peaks.step_max?, peaks.step_min?];
            // What a monitor could bear counts in tension.
            let size = if kind == Kind::Stress { max } else { max.abs().max(min.abs()) };
            Some((name.as_str(), (*quantity).to_owned(), size))
        };
        quantities.iter().filter_map(of).collect::<Vec<_>>()
    });
    let Some((monitor, quantity, size)) =
        sizes.filter(|(.., size)| size.is_finite()).max_by(|a, b| a.2.total_cmp(&b.2))
    else {
        return caption;
    };
    let told = say!(
        source.language,
        "Of all steps the largest is {size}, {quantity} of {monitor}.",
        size = source.quantity(kind, size),
        quantity = quantity,
        monitor = monitor
    );
    match caption.is_empty() {
        true => told,
        false => say!(source.language, "{first} {second}", first = caption, second = told),
    }
}
