//! Materials, damping, boundaries and stages in a line each.

use tremolite_results::{Border, EFFECTIVE, LiningExtent, SectionStrength, Summary};

use crate::damage::rates::STATIC;
use crate::drawing::plot::range;
use crate::facts::materials;
use crate::facts::{Fact, card};
use crate::language::{Language, say};
use crate::quantities::scale::{count, figures, quantity, span, trimmed};
use crate::quantities::units::Kind;
use crate::section_forces::stations::{Lining, linings};
use crate::source::Source;
use crate::verdict::short_names::percent;

/// Stages that are named; of more their number is told beside the first and the last.
const NAMED: usize = 4;
/// Materials that have a line: more would take the sheet's room.
const MATERIALS: usize = 5;
/// Parameters of a material that are told.
const TOLD: [&str; 12] = [
    "grade",
    "young",
    "poisson",
    "cohesion",
    "friction_angle",
    "tensile_strength",
    "compressive_strength",
    "fracture_energy",
    "rate",
    "gsi",
    "m_i",
    "disturbance",
];

/// By which code sections are judged, with its factors and the bars.
fn sections(source: &Source, of: &SectionStrength) -> String {
    let language = source.language;
    let factor = |x: f64| trimmed(&figures(x, 3));
    let mut parts = vec![of.code.clone()];
    parts.extend((!of.grade.is_empty()).then(|| of.grade.clone()));
    let each = [
        ("γ_c", of.factors.gamma_c),
        ("γ_s", of.factors.gamma_s),
        ("α_cc", of.factors.alpha_cc),
        ("α_ct", of.factors.alpha_ct),
        ("γ_d", of.factors.gamma_d),
    ];
    parts.extend(each.into_iter().map(|(name, x)| format!("{name} {}", factor(x))));
    if source.shakes() {
        parts.push(say!(
            language,
            "concrete × {dynamic} in the earthquake",
            dynamic = factor(of.factors.dynamic)
        ));
    }
    let area = |x: f64| format!("{:.0}", 1e6 * x);
    let millimetres = |x: f64| if x.is_finite() { format!("{:.0}", 1e3 * x) } else { "–".to_owned() };
    parts.push(match of.borders.iter().find(|b| b.bars != [0.0; 2]) {
        Some(Border { bars: [inner, outer], depths, .. })
            if depths.iter().any(|x| x.is_finite() && *x > 0.0) =>
        {
            say!(
                language,
                "bars {inner} inside, {outer} mm²/m outside, their axes {near} and {far} mm from the faces",
                inner = area(*inner),
                outer = area(*outer),
                near = millimetres(depths[0]),
                far = millimetres(depths[1])
            )
        }
        Some(Border { bars: [inner, outer], .. }) => {
            say!(
                language,
                "bars {inner} inside, {outer} mm²/m outside",
                inner = area(*inner),
                outer = area(*outer)
            )
        }
        None if of.reinforced == 0 => say!(language, "no bars"),
        None => say!(language, "with bars"),
    });
    if of.steel > 0.0 && of.reinforced > 0 {
        parts.push(format!("f_yk {}", trimmed(&quantity("Pa", of.steel))));
    }
    parts.join(&say!(language, ", "))
}

/// The strength that a law of concrete is given or works out.
const STRENGTH: &str = "compressive_strength";
/// The tensile strength of such a law.
const TENSION: &str = "tensile_strength";
/// Mean strength of cylinders over the characteristic one \[Pa\], and the share of a mean tensile strength that is its 5 % fractile
/// (EN 1992-1-1 table 3.1).
const MEAN_ABOVE: f64 = 8e6;
const FRACTILE: f64 = 0.7;
/// By this share a strength may lie outside characteristic and mean of its grade: grades are rounded.
const ROUNDED: f64 = 0.05;

/// A strength of the model's concrete that is not that of the section: its symbol, its value, and the characteristic and mean value of
/// the section's grade \[Pa\].
pub struct Unlike {
    symbol: &'static str,
    value: f64,
    grade: [f64; 2],
}

/// The strengths of the model's concrete that lie outside characteristic and mean of the section's grade.
pub fn of_another_concrete(summary: &Summary, of: &SectionStrength) -> Vec<Unlike> {
    let laws = || summary.computed.materials.values().filter(|facts| facts.law.starts_with("concrete"));
    let only = |name: &str| {
        let values: Vec<f64> =
            laws().flat_map(|facts| &facts.values).filter(|v| v.name == name).map(|v| v.value).collect();
        // Of several concretes it is not known which is the lining's.
        if let [only] = values[..] { Some(only) } else { None }
    };
    let factors = &of.factors;
    let compression = of.compression * factors.gamma_c / factors.alpha_cc;
    let tension = of.tension * factors.gamma_c / factors.alpha_ct;
    let each = [
        ("f_c", STRENGTH, [compression, compression + MEAN_ABOVE]),
        ("f_t", TENSION, [tension, tension / FRACTILE]),
    ];
    let found = each.into_iter().filter_map(|(symbol, name, grade)| {
        let value = only(name)?;
        let inside = value >= (1.0 - ROUNDED) * grade[0] && value <= (1.0 + ROUNDED) * grade[1];
        (!inside && grade.iter().all(|x| x.is_finite())).then_some(Unlike { symbol, value, grade })
    });
    found.filter(|_| of.yields).collect()
}

/// That sections are judged with another concrete than that of the model, and what the rate does to either; nothing where they are not.
fn concretes(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    let (of, unlike) = summary.parts.sections.values().find_map(|of| {
        let unlike = of_another_concrete(summary, of);
        (!unlike.is_empty()).then_some((of, unlike))
    })?;
    let strength = |x: f64| trimmed(&quantity("Pa", x));
    let told = unlike.iter().map(|one| {
        say!(
            language,
            "{symbol} {value} in the model, {least} (characteristic) to {mean} (mean) by {grade}",
            symbol = one.symbol,
            value = strength(one.value),
            least = strength(one.grade[0]),
            mean = strength(one.grade[1]),
            grade = if of.grade.is_empty() { of.code.clone() } else { of.grade.clone() }
        )
    });
    let text = told.collect::<Vec<String>>().join(&say!(language, "; "));
    let rates = summary.computed.materials.values().flat_map(|facts| &facts.values);
    let rate = rates.filter(|value| value.name == "rate").find(|value| value.word != STATIC);
    let dynamic = trimmed(&figures(of.factors.dynamic, 3));
    let note = match rate {
        Some(rate) => say!(
            language,
            "the model's strength grows with the strain rate ({law}), that of the sections is × {dynamic} in the earthquake",
            law = rate.word,
            dynamic = dynamic
        ),
        None => say!(
            language,
            "static in the model, × {dynamic} in the sections in the earthquake",
            dynamic = dynamic
        ),
    };
    Some(card(say!(language, "Concretes differ"), text, note).warning())
}

/// The clear width, height and length of linings.
fn halls(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    let length = |x: f64| trimmed(&format!("{x:.1}"));
    let told = |(name, of): (&String, &LiningExtent)| {
        let [width, along, height] = of.clear.map(length);
        say!(
            language,
            "{lining} {width} m wide, {height} m high, {along} m long in the model",
            lining = name,
            width = width,
            height = height,
            along = along
        )
    };
    let all: Vec<String> = summary.computed.linings.iter().take(HALLS).map(told).collect();
    let note = say!(language, "clear, inside the lining");
    (!all.is_empty()).then(|| card(say!(language, "Halls"), all.join(&say!(language, "; ")), note))
}

/// Halls whose size is told.
const HALLS: usize = 4;

/// How linings lie on the rock.
fn on_rock(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    if summary.computed.linings.is_empty() {
        return None;
    }
    let label = say!(language, "Lining on rock");
    let interfaces = &summary.parts.interfaces;
    if interfaces.is_empty() {
        let text = say!(language, "tied to the rock: it neither parts from it nor slides on it");
        return Some(card(label, text, ""));
    }
    let all: Vec<String> = interfaces.iter().map(|(name, of)| format!("{name} ({})", of.law)).collect();
    Some(card(say!(language, "Interfaces"), all.join(&say!(language, "; ")), ""))
}

/// What the model is, line by line.
pub fn facts(source: &Source, summary: &Summary) -> Vec<Fact> {
    let language = source.language;
    let mut facts = Vec::new();
    let tables = materials::tables(language, summary);
    // Damping that all share has a line of its own.
    let shared = tables.first().map(|first| first.damping.to_string());
    let shared =
        shared.filter(|damping| tables.len() > 1 && tables.iter().all(|m| m.damping.to_string() == *damping));
    let more = tables.len().saturating_sub(MATERIALS);
    for material in tables.iter().take(MATERIALS) {
        let is_rock = material.given.iter().any(|row| row.name == "gsi");
        let told = material.given.iter().filter(|row| TOLD.contains(&row.name.as_str()));
        let mut parts = vec![material.law.clone()];
        // What is left out and does nothing by itself is not told.
        let told = told.filter(|row| !(row.default && row.name == "disturbance"));
        parts.extend(told.map(|row| match (row.name.as_str(), row.value.as_str()) {
            ("rate", STATIC) => say!(language, "strength the same at any strain rate"),
            ("rate", law) => say!(language, "strength grows with the strain rate ({law})", law = law),
            (name, value) => format!("{} {value}", symbol(name, is_rock)).trim().to_owned(),
        }));
        let works_out = material.derived.iter().filter(|row| row.name == STRENGTH);
        parts.extend(works_out.map(|row| format!("{} {}", symbol(&row.name, is_rock), row.value)));
        parts.push(material.density.clone());
        let label = say!(language, "Material {name}", name = material.name);
        let values = parts.join(&say!(language, ", "));
        facts.push(match shared {
            Some(_) => card(label, values, ""),
            None => {
                card(label, say!(language, "{values}; damping:", values = values), material.damping.clone())
            }
        });
    }
    if more > 0 {
        let text = say!(language, "{number} more, in the appendix under Materials", number = more);
        facts.push(card(say!(language, "Materials"), text, ""));
    }
    if let (Some(_), Some(first)) = (shared, tables.first()) {
        facts.push(card(say!(language, "Damping"), String::new(), first.damping.clone()));
    }
    facts.extend(halls(source, summary));
    facts.extend(thickness(source, summary));
    facts.extend(on_rock(source, summary));
    // A line for each way in which linings are judged.
    let mut judged: Vec<(String, Vec<&str>)> = Vec::new();
    for (lining, of) in &summary.parts.sections {
        let text = sections(source, of);
        match judged.iter_mut().find(|(known, _)| *known == text) {
            Some((_, linings)) => linings.push(lining),
            None => judged.push((text, vec![lining])),
        }
    }
    for (text, linings) in judged {
        facts.push(card(say!(language, "Sections"), text, linings.join(&say!(language, ", "))));
    }
    facts.extend(concretes(source, summary));
    let boundaries = &summary.computed.boundaries;
    if !boundaries.is_empty() {
        let place = |place: &str| match place {
            "base" => say!(language, "base"),
            "x" => say!(language, "sides across x"),
            "y" => say!(language, "sides across y"),
            _ => say!(language, "top"),
        };
        let told = |at: &str, word: &str| {
            say!(language, "{place} {boundary}", place = place(at), boundary = boundary(language, word))
        };
        let all = boundaries.iter().map(|(at, word)| told(at, word));
        let all: Vec<String> = all.collect();
        facts.push(card(say!(language, "Boundaries"), all.join(&say!(language, "; ")), ""));
    }
    if let [Some(pressure), Some(earthquake)] =
        ["pressure", "earthquake"].map(|key| summary.computed.water.get(key))
    {
        let from = match pressure.as_str() {
            "seepage" => say!(language, "steady seepage"),
            _ => say!(language, "still, by a level"),
        };
        let then = match earthquake.as_str() {
            "undrained" => {
                say!(language, "undrained in the earthquake; stresses are total, unless called effective")
            }
            _ => say!(language, "drained in the earthquake; stresses are total, unless called effective"),
        };
        facts.push(card(say!(language, "Water"), from, then));
    }
    facts.extend(initial_stress(source, summary));
    let stages: Vec<&str> = summary.computed.stages.iter().skip(1).map(|s| s.name.as_str()).collect();
    if let [first, .., last] = stages[..]
        && stages.len() > NAMED
    {
        let text = say!(
            language,
            "initial equilibrium, then {number} stages from {first} to {last}",
            number = stages.len(),
            first = first,
            last = last
        );
        facts.push(card(say!(language, "Stages"), text, released(language, summary)));
    } else if !stages.is_empty() {
        let text =
            say!(language, "initial equilibrium, then {stages}", stages = stages.join(&say!(language, ", ")));
        facts.push(card(say!(language, "Stages"), text, released(language, summary)));
    }
    let model = &summary.computed.model;
    if model.elements > 0 {
        let text = match source.shakes() && model.duration > 0.0 {
            true => say!(
                language,
                "{elements} elements, {time} of shaking",
                elements = count(model.elements),
                time = span(model.duration)
            ),
            false => say!(language, "{elements} elements", elements = count(model.elements)),
        };
        facts.push(card(say!(language, "Model"), text, ""));
    }
    facts
}

/// The stress before anything was done, and its ratios.
fn initial_stress(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    let found = summary.computed.initial_stress?;
    let [xx, yy, zz, ..] = found.stress;
    let ratio = |along: f64| trimmed(&figures(along / zz, 3));
    let pressure = |stress: f64| source.quantity(Kind::Stress, -stress);
    if zz == 0.0 {
        return None;
    }
    let [x, y, z] = found.at.map(|c| trimmed(&format!("{c:.1}").replace('-', "−")));
    let text = say!(
        language,
        "{vertical} vertical, {x} along x ({kx} of it), {y} along y ({ky})",
        vertical = pressure(zz),
        x = pressure(xx),
        kx = ratio(xx),
        y = pressure(yy),
        ky = ratio(yy)
    );
    let place = say!(language, "at ({x}, {y}, {z}) m", x = x, y = y, z = z);
    Some(card(say!(language, "Initial compression"), text, place))
}

/// Which shares of what is held are let go by excavations that do not let go all; empty where each does.
fn released(language: Language, summary: &Summary) -> String {
    let digs = summary.computed.stages.iter().filter(|stage| !stage.excavated.is_empty());
    let (least, most) = range(digs.map(|stage| stage.release).filter(|share| *share < 1.0));
    match (least <= most, percent(least), percent(most)) {
        (false, _, _) => String::new(),
        (true, least, most) if least == most => {
            say!(language, "an excavation lets go {share} of what is held", share = least)
        }
        (true, least, most) => {
            say!(language, "excavations let go {least} to {most} of what is held", least = least, most = most)
        }
    }
}

/// How thick linings are at their stations.
fn thickness(source: &Source, summary: &Summary) -> Option<Fact> {
    let language = source.language;
    let Some(Ok(rows)) = &source.sections else { return None };
    let told = |lining: &Lining| {
        let (least, most) = range(lining.stations.iter().map(|station| station.thickness));
        let length = |x: f64| trimmed(&figures(x, 3));
        (least <= most).then(|| match length(least) == length(most) {
            true => format!("{} {}\u{a0}m", lining.name, length(least)),
            false => say!(
                language,
                "{lining} {least} to {most}\u{a0}m",
                lining = lining.name,
                least = length(least),
                most = length(most)
            ),
        })
    };
    let all = linings(language, rows, summary);
    // Forces of effective stress are of the same stations.
    let own = all.iter().filter(|lining| !lining.name.ends_with(EFFECTIVE));
    let all: Vec<String> = own.filter_map(told).collect();
    let text = all.join(&say!(language, "; "));
    (!all.is_empty()).then(|| card(say!(language, "Thickness of linings"), text, ""))
}

/// The symbol of a parameter of concrete or of rock. The strength of rock is that of the intact rock.
fn symbol(name: &str, is_rock: bool) -> &str {
    match name {
        STRENGTH if is_rock => "σ_ci",
        "young" => "E",
        "poisson" => "ν",
        "cohesion" => "c",
        "friction_angle" => "φ",
        "tensile_strength" => "f_t",
        "compressive_strength" => "f_c",
        "fracture_energy" => "G_f",
        // C25/30 says what it is.
        "grade" => "",
        "gsi" => "GSI",
        "disturbance" => "D",
        other => other,
    }
}

/// A boundary in words.
fn boundary(language: Language, word: &str) -> String {
    match word {
        "viscous-spring" => say!(language, "viscous with springs"),
        "viscous" => say!(language, "viscous"),
        "free-field" => say!(language, "free field"),
        "periodic" => say!(language, "periodic"),
        "symmetry" => say!(language, "symmetric"),
        "roller" => say!(language, "on rollers"),
        "fixed" => say!(language, "fixed"),
        "free" => say!(language, "free"),
        other => other.to_owned(),
    }
}
