//! Figure of how the stages came to rest.

use tremolite_results::Summary;

use crate::chapter::figure::{Block, Figure};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::scale::{figures, superscript, trimmed};
use crate::script::curves::{Curves, Rule, RuleAnchor};
use crate::script::plot_curves::{self, Plot};
use crate::source::Source;
use crate::stages::names::name;

/// The block; nothing without the file.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let heading = say!(language, "How the model came to rest");
    let left_out = |why: String| {
        let note = say!(language, "Left out. {why}", why = why);
        Some(Block { heading: heading.clone(), notes: vec![note], ..Block::default() })
    };
    let table = match source.relaxation.as_ref()? {
        Ok(table) => table,
        Err(why) => return left_out(why.clone()),
    };
    let columns = (table.column("stage"), table.column("cycle"), table.column("ratio"));
    let (Some(stage), Some(cycle), Some(ratio)) = columns else {
        return left_out(say!(language, "relaxation.csv has no columns stage, cycle and ratio."));
    };
    let spans = spans(stage, cycle, facts);
    let tolerance = tolerance(facts);
    let title = say!(language, "out of balance: Σ|R| / Σ|contributions|");
    let mut panels = vec![(title, vec![curve("", 0, &spans, cycle, ratio)])];
    if let Some(limit) = tolerance {
        let end = spans.last().map_or(1.0, |span| span.to);
        // At every row, so that it too has a value at the script's cursor.
        let rows = spans.iter().flat_map(|span| span.rows.clone().map(|row| span.shift + cycle[row]));
        let line = std::iter::once(0.0).chain(rows).chain([end]).map(|x| (x, limit)).collect();
        let name = say!(language, "tolerance {limit}", limit = trimmed(&figures(limit, 2)));
        panels[0].1.push(PlotCurve::new(name, 1, Pen::Dashed, line));
    }
    let motions = [
        (say!(language, "motion in the stage"), "motion", 3),
        (say!(language, "motion left (estimate)"), "motion_left", 2),
    ];
    let motions: Vec<PlotCurve> = motions
        .into_iter()
        .filter_map(|(name, column, colour)| Some(curve(&name, colour, &spans, cycle, table.column(column)?)))
        .filter(|curve| curve.pieces.iter().flatten().any(|p| p.1.is_finite()))
        .collect();
    if !motions.is_empty() {
        panels.push((say!(language, "motion of the node that moves most (m)"), motions));
    }
    if !panels[0].1[0].pieces.iter().flatten().any(|p| p.1.is_finite()) {
        return left_out(say!(language, "relaxation.csv holds no ratio that is not zero."));
    }
    let mut caption = say!(
        language,
        "Each stage begins out of balance and must end below the tolerance; a curve that levels off above it has not \
         settled. Waves on the way down are usual."
    );
    if tolerance.is_none() {
        caption.push_str(&say!(language, " The summary states no tolerance."));
    }
    if panels.len() > 1 {
        caption.push_str(&say!(language, " The motion left should end far below the stage's own motion."));
    }
    let svg = draw(language, &heading, &panels, &spans, facts);
    let curves = Some(answering(language, &heading, &panels, &spans, facts));
    let figure = Figure {
        heading: heading.clone(),
        file: "relaxation.svg".into(),
        svg,
        caption,
        curves,
        narrow: None,
    };
    Some(Block { heading, figures: vec![figure], ..Block::default() })
}

/// What a run calls at rest: the limit of its own check.
fn tolerance(facts: &Summary) -> Option<f64> {
    facts.computed.stages.iter().map(|stage| stage.tolerance).find(|limit| limit.is_finite())
}

/// The rows of a stage, and from which cycle of the run to which it went.
struct Span {
    stage: usize,
    rows: std::ops::Range<usize>,
    from: f64,
    to: f64,
    /// What to add to the cycles of its rows.
    shift: f64,
}

/// Rows by stage. Cycles may be counted in each stage or through all of them.
fn spans(stage: &[f64], cycle: &[f64], facts: &Summary) -> Vec<Span> {
    let mut spans: Vec<Span> = Vec::new();
    let mut first = 0;
    while first < stage.len() {
        let rows = stage[first..].iter().take_while(|s| **s == stage[first]).count().max(1);
        let from = spans.last().map_or(0.0, |span| span.to);
        let shift = if cycle[first] > from { 0.0 } else { from };
        let last = cycle[first..first + rows].iter().copied().fold(0.0, f64::max);
        let number = stage[first].max(0.0) as usize;
        let whole = facts.computed.stages.get(number).map_or(0.0, |s| s.cycles as f64);
        let to = if shift == 0.0 { last.max(from) } else { from + last.max(whole) };
        let to = if spans.is_empty() { to.max(whole) } else { to };
        spans.push(Span { stage: number, rows: first..first + rows, from, to, shift });
        first += rows;
    }
    spans
}

/// A value over the cycles of the run, a piece a stage; what has no logarithm is left out.
fn curve(name: &str, colour: usize, spans: &[Span], cycle: &[f64], values: &[f64]) -> PlotCurve {
    let positive = |x: f64| if x > 0.0 { x } else { f64::NAN };
    let piece =
        |span: &Span| span.rows.clone().map(|row| (span.shift + cycle[row], positive(values[row]))).collect();
    PlotCurve { name: name.into(), colour, pen: Pen::Curve, pieces: spans.iter().map(piece).collect() }
}

/// An axis of powers of ten.
fn decades((low, high): (f64, f64)) -> Ticks {
    if !(low.is_finite() && high.is_finite()) {
        return Ticks { range: (-1.0, 1.0), marks: Vec::new() };
    }
    let (low, high) = (low.floor(), high.ceil().max(low.floor() + 1.0));
    let step = ((high - low) / 8.0).ceil().max(1.0) as usize;
    let marks = (low as i32..=high as i32).step_by(step).map(|power| {
        let label = if power == 0 { "1".into() } else { format!("10{}", superscript(power)) };
        (f64::from(power), label)
    });
    Ticks { range: (low - 0.1, high + 0.1), marks: marks.collect() }
}

fn draw(
    language: Language,
    title: &str,
    panels: &[(String, Vec<PlotCurve>)],
    spans: &[Span],
    facts: &Summary,
) -> String {
    let mut svg = Svg::new(WIDTH);
    let end = spans.last().map_or(1.0, |span| span.to.max(1.0));
    let across = Ticks::within(0.0, end, 10);
    let mut top = 0.0;
    for (k, (heading, curves)) in panels.iter().enumerate() {
        top = plot::title(&mut svg, (LEFT, top), WIDTH - LEFT - RIGHT, heading, curves);
        // Names of the stages stand above the first axes.
        top += if k == 0 { 16.0 } else { 0.0 };
        let height = if k == 0 { 230.0 } else { 160.0 };
        let mut curves = curves.clone();
        curves.iter_mut().flat_map(|curve| curve.pieces.iter_mut().flatten()).for_each(|p| p.1 = p.1.log10());
        let up = decades(plot::ranges(&curves).1);
        let axes =
            Axes { left: LEFT, right: WIDTH - RIGHT, top, bottom: top + height, across: across.clone(), up };
        for span in &spans[1.min(spans.len())..] {
            let (x, _) = axes.point(span.from, 0.0);
            svg.rule((x, top - if k == 0 { 14.0 } else { 0.0 }), (x, top + height), true);
        }
        if k == 0 {
            names(language, &mut svg, &axes, spans, facts);
        }
        plot::draw(&mut svg, &axes, &curves);
        top += height + 26.0;
    }
    let along = say!(language, "cycles of all stages");
    svg.text((WIDTH - RIGHT, top + 8.0), Anchor::End, 12.0, Style::Muted, &along);
    let description = say!(language, "out of balance over the cycles of all stages, with the tolerance");
    svg.finish(top + 16.0, title, &description)
}

/// The same for the page's script.
fn answering(
    language: Language,
    title: &str,
    panels: &[(String, Vec<PlotCurve>)],
    spans: &[Span],
    facts: &Summary,
) -> Curves {
    let plots = panels.iter().map(|(heading, curves)| Plot {
        title: heading.clone(),
        unit: String::new(),
        log: true,
        ends: None,
        curves,
    });
    let plots: Vec<Plot> = plots.collect();
    let mut curves = plot_curves::curves(title, &say!(language, "cycles of all stages"), "", &plots);
    let rule = |span: &Span| Rule {
        across: span.from,
        name: full_name(language, span, facts),
        side: RuleAnchor::Start,
    };
    curves.rules = spans.iter().map(rule).collect();
    curves
}

/// Number and name of a stage.
fn full_name(language: Language, span: &Span, facts: &Summary) -> String {
    let name = facts.computed.stages.get(span.stage).map_or_else(String::new, |s| name(language, &s.name));
    format!("{} {name}", span.stage).trim().to_owned()
}

/// Names of the stages above their parts of the axis; numbers, or nothing, where there is no room.
fn names(language: Language, svg: &mut Svg, axes: &Axes, spans: &[Span], facts: &Summary) {
    for span in spans {
        let (from, to) = (axes.point(span.from, 0.0).0, axes.point(span.to, 0.0).0);
        let number = span.stage.to_string();
        let full = full_name(language, span, facts);
        let fitting =
            [full.as_str(), number.as_str()].into_iter().find(|t| text_width(t, 11.0) + 6.0 <= to - from);
        if let Some(text) = fitting {
            svg.text((from + 4.0, axes.top - 4.0), Anchor::Start, 11.0, Style::Muted, text);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cycles_counted_in_each_stage_or_through_all_give_the_same_spans() {
        let stage = [0.0, 0.0, 1.0, 1.0, 2.0];
        let ends = |cycle: &[f64]| -> Vec<(f64, f64, f64)> {
            spans(&stage, cycle, &Summary::default()).iter().map(|s| (s.from, s.to, s.shift)).collect()
        };
        let own = ends(&[20.0, 40.0, 20.0, 60.0, 20.0]);
        let through = ends(&[20.0, 40.0, 60.0, 100.0, 120.0]);
        assert_eq!(own, [(0.0, 40.0, 0.0), (40.0, 100.0, 40.0), (100.0, 120.0, 100.0)]);
        assert_eq!(
            through.iter().map(|s| (s.0, s.1)).collect::<Vec<_>>(),
            own.iter().map(|s| (s.0, s.1)).collect::<Vec<_>>()
        );
    }

    #[test]
    fn an_axis_of_decades_covers_its_values() {
        let ticks = decades((-5.3, -0.2));
        assert!(ticks.range.0 < -6.0 && ticks.range.1 > 0.0);
        assert_eq!(ticks.marks.first().unwrap().1, "10⁻⁶");
        assert_eq!(ticks.marks.last().unwrap().1, "1");
    }
}
