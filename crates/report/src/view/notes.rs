//! What the view does not show, in sentences for the reader.

use super::fit::LeftOut;
use super::part::Part;
use crate::language::{Language, say};
use crate::quantities::scale::figures;

/// Fields of one value throughout a part.
pub fn uniform(language: Language, part: &str, fields: &[(String, f32)]) -> Option<String> {
    let list: Vec<String> =
        fields.iter().map(|(name, value)| format!("{name} = {}", figures(f64::from(*value), 3))).collect();
    let fields = list.join(", ");
    (!list.is_empty()).then(|| {
        say!(
            language,
            "Not among the fields of {part}, since they have one value throughout: {fields}. A 0 may also mean that its material does not know the quantity.",
            part = part,
            fields = fields,
        )
    })
}

/// What was left out to keep the page small.
pub fn left_out(language: Language, left: &LeftOut, budget: usize) -> Vec<String> {
    let mut notes = Vec::new();
    let megabytes = |bytes: usize| figures(bytes as f64 / 1e6, 3);
    if left.every > 1 {
        notes.push(say!(
            language,
            "To keep the page small the ground is shown at one time in {every} only, the last included; linings and interfaces at all times.",
            every = left.every,
        ));
    }
    if !left.fields.is_empty() {
        let fields = left.fields.join(", ");
        notes.push(say!(
            language,
            "To keep the page small these fields of the ground are left out: {fields}.",
            fields = fields
        ));
    }
    if left.displacement {
        notes.push(say!(language, "To keep the page small the displacement of the ground is left out."));
    }
    if left.size > budget {
        let (size, budget) = (megabytes(left.size), megabytes(budget));
        notes.push(say!(
            language,
            "The view takes {size} MB of the page, more than the {budget} MB meant for it.",
            size = size,
            budget = budget,
        ));
    }
    notes
}

/// Arrays that are no scalars.
pub fn vectors(language: Language, clock: &str, parts: &[Part]) -> Option<String> {
    let mut names: Vec<&str> = Vec::new();
    for name in parts.iter().flat_map(|part| &part.vectors) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    let folder = if clock == "earthquake" { "fields/*.vtu" } else { "stages/*.vtu" };
    let interfaces = parts.iter().any(|part| part.mesh.per == 4);
    let names = (!names.is_empty()).then(|| names.join(", "))?;
    Some(if interfaces {
        say!(
            language,
            "Vectors and tensors other than the displacement are not in the view; {folder} and interfaces/*.vtu hold them: {names}.",
            folder = folder,
            names = names,
        )
    } else {
        say!(
            language,
            "Vectors and tensors other than the displacement are not in the view; {folder} holds them: {names}.",
            folder = folder,
            names = names,
        )
    })
}

/// What the arrows beside the axes are.
pub fn waves(language: Language) -> String {
    say!(
        language,
        "Arrows beside the axes are the waves: each points along the wave's way in the rock of the base, and the thin line across or along it is the direction in which the wave moves the rock."
    )
}

/// What the arrows in the model are.
pub fn flow(language: Language) -> String {
    say!(
        language,
        "Lines with arrows in the model are flow lines of the water below the free surface, those beside a cut plane alone where one is set; the closer they lie, the more water flows. The field seepage of the files holds the discharge."
    )
}
