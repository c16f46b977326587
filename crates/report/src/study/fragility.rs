//! Fragility curves with their bounds and the shares that they are fitted to.

use tremolite_results::study::{Study, StudyFragility};

use super::Figure;
use super::paper::{draw, file_part, from_zero, told};
use crate::drawing::plot::{Pen, PlotCurve};
use crate::drawing::ticks::Ticks;

/// One figure a curve that could be fitted, or whose shares are worth a look.
pub fn figures(study: &Study) -> Vec<Figure> {
    let shown = study.fragilities.iter().enumerate().filter(|(_, f)| f.fit.is_some() || !f.shares.is_empty());
    shown.map(|(k, f)| figure(study, k, f)).collect()
}

fn figure(study: &Study, number: usize, f: &StudyFragility) -> Figure {
    let title = limit(study, f);
    let shares: Vec<(f64, f64)> =
        f.shares.iter().map(|s| (s.intensity, s.exceeded as f64 / s.of.max(1) as f64)).collect();
    let mut curves = Vec::new();
    if let Some(fit) = &f.fit {
        let name = format!("maximum likelihood: median {} {}, β {}", told(fit.theta), f.unit, told(fit.beta));
        curves.push(PlotCurve::new(name, 0, Pen::Curve, f.curve.iter().map(|p| (p[0], p[1])).collect()));
    }
    if let Some(bounds) = &f.bounds {
        for (k, name) in [
            (0, "bounds of nine tenths of a bootstrap over records"),
            (1, "bounds of nine tenths of a bootstrap over records"),
        ] {
            let line = f.curve.iter().zip(&bounds.band).map(|(p, band)| (p[0], band[k])).collect();
            curves.push(PlotCurve::new(name, 0, Pen::Dashed, line));
        }
    }
    let dots = if study.rises { "records beyond the limit, cumulated" } else { "share of runs at a level" };
    curves.push(PlotCurve::new(dots, 1, Pen::Dots, shares.clone()));
    let highest = f.curve.iter().map(|p| p[0]).chain(shares.iter().map(|p| p.0)).fold(0.0, f64::max);
    let band: Vec<(f64, f64)> = f.bounds.iter().flat_map(|b| band(f, &b.band)).collect();
    let svg = draw(
        &title,
        (&format!("{} ({})", f.by, f.unit), "probability"),
        (from_zero(highest), Ticks::within(0.0, 1.0, 5)),
        &curves,
        &band,
        "The probability that the limit is exceeded, over intensity.",
    );
    let file = format!("fragility-{}-{}.svg", number + 1, file_part(&f.measure));
    Figure { file, svg, caption: caption(f) }
}

/// The limit in words, with the unit of its measure.
pub fn limit(study: &Study, f: &StudyFragility) -> String {
    let unit =
        study.measures.iter().find(|m| m.name == f.measure).and_then(|m| m.unit.clone()).unwrap_or_default();
    format!("{} above {} {unit}", f.measure, told(f.above)).trim_end().to_owned()
}

/// The outline of the bounds: along the lower, back along the upper.
fn band(f: &StudyFragility, band: &[[f64; 2]]) -> Vec<(f64, f64)> {
    let lower = f.curve.iter().zip(band).map(|(p, band)| (p[0], band[0]));
    let upper = f.curve.iter().zip(band).rev().map(|(p, band)| (p[0], band[1]));
    lower.chain(upper).collect()
}

/// What is counted and what is not.
pub fn caption(f: &StudyFragility) -> String {
    let mut text = format!("{} runs counted, {} of them beyond the limit", f.counted, f.exceeded);
    if f.stopped_counted > 0 {
        text += &format!(
            " ({} stopped by the guard in the earthquake and counted as beyond it)",
            f.stopped_counted
        );
    }
    text += ".";
    if !f.left_out.is_empty() {
        let parts: Vec<String> = f.left_out.iter().map(|(why, n)| format!("{n} {why}")).collect();
        text += &format!(" Left out: {}.", parts.join(", "));
    }
    if !f.no_curve.is_empty() {
        text += &format!(" No curve: {}.", f.no_curve);
    }
    match &f.bounds {
        Some(b) if b.without > 0 => {
            text += &format!(
                " {} of {} samples of the bootstrap have no curve and are in no bound.",
                b.without,
                b.samples + b.without
            );
        }
        _ if f.fit.is_some() && !f.no_bounds.is_empty() => text += &format!(" No bounds: {}.", f.no_bounds),
        _ => {}
    }
    text
}
