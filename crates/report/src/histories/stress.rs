//! Principal stress at the monitors, beside strengths and as if nothing cracked.

use tremolite_results::MaterialFacts;

use crate::chapter::figure::Section;
use crate::drawing::chart::Mark;
use crate::histories::largest_of_steps::with_steps;
use crate::histories::{Family, Histories, ROUND_OFF, Recorded, largest, largest_of};
use crate::language::say;
use crate::quantities::units::Kind;
use crate::source::Source;

/// s1_elastic this many times the largest s1 is that of an element that has cracked open, and would flatten all others.
const BEYOND_STRESS: f64 = 10.0;

impl Recorded<'_> {
    /// Figure 6 of the paper.
    pub fn stress(&self) -> Section {
        let language = self.source.language;
        let mut caption = say!(language, "Tension is positive.");
        if let Some(strengths) = tensile_strengths(self.source) {
            caption = say!(
                language,
                "{first} Set s1 beside the tensile strength of what a monitor lies in: {strengths}. Fast loading raises it, and \
                 damping adds to s1: where s1 passes it for a moment, the damage at that place says whether a crack opened.",
                first = caption,
                strengths = strengths
            );
        }
        let panels = vec![
            ("s1", say!(language, "s1, the largest principal stress"), Mark::Highest),
            ("s3", say!(language, "s3, the smallest principal stress"), Mark::Lowest),
        ];
        let heading = say!(language, "Principal stress");
        self.family(Family { heading, file: "stress", caption, panels, negligible: ROUND_OFF }, |quantity| {
            self.of_monitors(quantity)
        })
    }

    /// What the strain would ask of concrete that does not crack; nothing in files without it.
    pub fn elastic_stress(&self) -> Option<Section> {
        let language = self.source.language;
        let stress = largest(&self.of_monitors("s1"));
        let (drawn, loose): (Histories<'_>, Histories<'_>) = self
            .of_monitors("s1_elastic")
            .into_iter()
            .partition(|history| largest_of(&history.1) <= BEYOND_STRESS * stress);
        if drawn.is_empty() {
            return None;
        }
        let mut caption = say!(
            language,
            "The largest principal value of σ₀ + C:Δε (s1_elastic in monitors.csv): the stress when the shaking begins, and what the \
             strain since then would add if nothing cracked or yielded. Set it beside s1 above, which also holds what damping over a \
             band adds to a fast change: where it goes on and s1 falls, a crack has taken the stress."
        );
        for history in &loose {
            let most =
                self.source.units.suiting("Pa", largest_of(&history.1)).quantity(largest_of(&history.1));
            caption = say!(
                language,
                "{first} Not drawn: {monitor}, up to {size}: its element has cracked open.",
                first = caption,
                monitor = history.0,
                size = most
            );
        }
        let caption = with_steps(self.source, caption, &["s1_elastic"], Kind::Stress);
        let panels = vec![("s1_elastic", "s1_elastic".to_owned(), Mark::Highest)];
        let heading = say!(language, "Principal stress as if nothing cracked");
        Some(self.family(
            Family { heading, file: "stress-elastic", caption, panels, negligible: ROUND_OFF },
            |_| drawn.clone(),
        ))
    }
}

/// Tensile strength of each material that has one, as one text; nothing where none has.
fn tensile_strengths(source: &Source) -> Option<String> {
    let facts = source.summary.as_ref().ok()?;
    let of = |(name, material): (&String, &MaterialFacts)| {
        let strength = material.values.iter().find(|value| value.name == "tensile_strength")?.value;
        strength.is_finite().then(|| format!("{name} {}", source.quantity(Kind::Stress, strength)))
    };
    let all: Vec<String> = facts.computed.materials.iter().filter_map(of).collect();
    (!all.is_empty()).then(|| all.join(", "))
}
