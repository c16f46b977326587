//! How the wave that comes in was made of a record on or within layered ground, in words.

use tremolite_results::{Deconvolved, SoilLayer};

use crate::free_field::numbers::percent;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, quantity, trimmed};

/// The layer that is left with the least of its modulus, where any softens.
fn softest(site: &Deconvolved) -> Option<(usize, &SoilLayer)> {
    site.soil.iter().enumerate().min_by(|a, b| a.1.modulus.total_cmp(&b.1.modulus))
}

/// Where the record was taken, how much of the wave moves that place, and what became of the record: whole sentences.
pub fn words(language: Language, site: &Deconvolved) -> String {
    let ground = match site.corner.as_str() {
        "" => say!(language, "the layers of motion.site"),
        corner => say!(language, "the model's own ground at its corner {corner}", corner = corner),
    };
    let place = match site.depth > 0.0 {
        true => say!(
            language,
            "{depth}\u{a0}m below the surface of {ground}",
            depth = trimmed(&figures(site.depth, 4)),
            ground = ground
        ),
        false => say!(language, "on the surface of {ground}", ground = ground),
    };
    let mut text = say!(
        language,
        "Recorded {place}; the wave that comes up through the base is deconvolved from it: at each frequency the record over what \
         linear layers make of a vertical wave at that place.",
        place = place
    );
    text.push_str(&say!(
        language,
        " That place moves {at_rest} times the incident wave at low frequency and, of all that is let through, at least {least} \
         times, at {least_at}\u{a0}Hz; the record is wanted up to {band}\u{a0}Hz.",
        at_rest = figures(site.at_rest, 3),
        least = figures(site.least, 3),
        least_at = figures(site.least_at, 3),
        band = trimmed(&figures(site.band, 3))
    ));
    if let Some((softest, layer)) = softest(site) {
        text.push_str(&say!(
            language,
            " Its layers have the moduli and the damping that go with the strain of the record: layer {number} from the surface, the \
             softest, shears by {strain} and is left with {modulus} of its modulus.",
            number = softest + 1,
            strain = percent(layer.strain),
            modulus = percent(layer.modulus)
        ));
    }
    if site.lead > 0.0 {
        text.push_str(&say!(
            language,
            " The record comes {lead} later than in its file: the wave takes time from the base to its place, and what fades out \
             rings before it as well.",
            lead = quantity("s", site.lead)
        ));
    }
    text.push_str(&match site.reach.is_finite() {
        true => say!(
            language,
            " Above {reach}\u{a0}Hz, where too little of the wave moves that place, the record fades out: at most {left_out} of a \
             component's ∫a²\u{a0}dt is left out.",
            reach = figures(site.reach, 3),
            left_out = percent(site.left_out)
        ),
        false => say!(language, " Nothing of the record is left out."),
    });
    text
}
