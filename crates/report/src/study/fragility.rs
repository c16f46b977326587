//! Fragility curves with their bounds and the shares that they are fitted to.

use tremolite_results::study::{Study, StudyFragility};

use super::Figure;
use super::paper::{draw, file_part, from_zero, measured, told};
use crate::drawing::plot::{Pen, PlotCurve};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};

/// One figure a curve that could be fitted, or whose shares are worth a look.
pub fn figures(study: &Study, language: Language) -> Vec<Figure> {
    let shown = study.fragilities.iter().enumerate().filter(|(_, f)| f.fit.is_some() || !f.shares.is_empty());
    shown.map(|(k, f)| figure(study, language, k, f)).collect()
}

fn figure(study: &Study, language: Language, number: usize, f: &StudyFragility) -> Figure {
    let title = limit(study, f, language);
    let shares: Vec<(f64, f64)> = f.shares.iter().map(|s| (s.intensity, s.probability())).collect();
    let mut curves = Vec::new();
    if let Some(fit) = &f.fit {
        let name = say!(
            language,
            "maximum likelihood: median {median}, β {beta}",
            median = measured(fit.theta, &f.unit),
            beta = told(fit.beta)
        );
        curves.push(PlotCurve::new(name, 0, Pen::Curve, f.curve.iter().map(|p| (p[0], p[1])).collect()));
    }
    if let Some(bounds) = &f.bounds {
        let name = say!(language, "bounds of nine tenths of a bootstrap over records");
        for k in [0, 1] {
            let line = f.curve.iter().zip(&bounds.band).map(|(p, band)| (p[0], band[k])).collect();
            curves.push(PlotCurve::new(name.clone(), 0, Pen::Dashed, line));
        }
    }
    let dots = match study.rises {
        true => say!(language, "records beyond the limit, cumulated"),
        false => say!(language, "share of runs at a level"),
    };
    curves.push(PlotCurve::new(dots, 1, Pen::Dots, shares.clone()));
    let highest = f.curve.iter().map(|p| p[0]).chain(shares.iter().map(|p| p.0)).fold(0.0, f64::max);
    let band: Vec<(f64, f64)> = f.bounds.iter().flat_map(|b| band(f, &b.band)).collect();
    let svg = draw(
        &title,
        (&over(&f.by, &f.unit), &say!(language, "probability")),
        (from_zero(highest), Ticks::within(0.0, 1.0, 5)),
        &curves,
        &band,
        &say!(language, "The probability that the limit is exceeded, over intensity."),
    );
    let file = format!("fragility-{}-{}.svg", number + 1, file_part(&f.measure));
    Figure { file, svg, caption: caption(f, language) }
}

/// The limit in words, with the unit of its measure.
pub fn limit(study: &Study, f: &StudyFragility, language: Language) -> String {
    let unit =
        study.measures.iter().find(|m| m.name == f.measure).and_then(|m| m.unit.clone()).unwrap_or_default();
    say!(language, "{measure} above {limit}", measure = f.measure, limit = measured(f.above, &unit))
}

/// A measure of intensity with its unit.
pub fn over(by: &str, unit: &str) -> String {
    if matches!(unit, "" | "1") { by.to_owned() } else { format!("{by} ({unit})") }
}

/// The outline of the bounds: along the lower, back along the upper.
fn band(f: &StudyFragility, band: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let lower = f.curve.iter().zip(band).map(|(p, band)| (p[0], band[0]));
    let upper = f.curve.iter().zip(band).rev().map(|(p, band)| (p[0], band[1]));
    lower.chain(upper).collect()
}

/// What is counted and what is not.
pub fn caption(f: &StudyFragility, language: Language) -> String {
    let mut text = vec![match f.stopped_counted {
        0 => say!(
            language,
            "{all} runs counted, {some} of them beyond the limit.",
            all = f.counted,
            some = f.exceeded
        ),
        stopped => say!(
            language,
            "{all} runs counted, {some} of them beyond the limit ({stopped} stopped by the guard in the earthquake and counted as beyond it).",
            all = f.counted,
            some = f.exceeded,
            stopped = stopped
        ),
    }];
    if !f.left_out.is_empty() {
        let parts: Vec<String> =
            f.left_out.iter().map(|(why, n)| format!("{n} {}", word(why, language))).collect();
        text.push(say!(language, "Left out: {parts}.", parts = parts.join(", ")));
    }
    if !f.no_curve.is_empty() {
        text.push(say!(
            language,
            "No curve: {why}.",
            why = language.tell_or(&f.no_curve_message, &f.no_curve)
        ));
    }
    match &f.bounds {
        Some(b) if b.without > 0 => text.push(say!(
            language,
            "{some} of {all} samples of the bootstrap have no curve and are in no bound.",
            some = b.without,
            all = b.samples + b.without
        )),
        _ if f.fit.is_some() && !f.no_bounds.is_empty() => {
            text.push(say!(language, "No bounds: {why}.", why = word(&f.no_bounds, language)));
        }
        _ => {}
    }
    language.joined(&text)
}

/// A word of study.json in the page's language; itself where this version does not know it.
pub fn word(english: &str, language: Language) -> String {
    match english {
        "binomial" => say!(language, "binomial"),
        "truncated" => say!(language, "truncated"),
        "without an intensity" => say!(language, "without an intensity"),
        "without the measure" => say!(language, "without the measure"),
        "failed" => say!(language, "failed"),
        "not_converged" => say!(language, "not converged"),
        "error" => say!(language, "run error"),
        "pending" => say!(language, "pending"),
        "there is one record alone, and nothing to draw from" => {
            say!(language, "there is one record alone, and nothing to draw from")
        }
        "fewer than half of the samples have a curve: there are too few records" => {
            say!(language, "fewer than half of the samples have a curve: there are too few records")
        }
        other => other.to_owned(),
    }
}
