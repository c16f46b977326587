//! Ground reaction: motion of walls over the share of the forces that was let go, where that went in steps.

use tremolite_results::{StageSummary, Summary};

use crate::chapter::figure::{Block, Figure};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, LINES, Style, Svg, text_width};
use crate::drawing::ticks::Ticks;
use crate::language::say;
use crate::quantities::scale::{figures, trimmed};
use crate::quantities::units::Kind;
use crate::script::curves::{Rule, RuleAnchor};
use crate::script::plot_curves::{self, Plot};
use crate::source::Source;
use crate::stages::convergence::{WallPoint, caverns};
use crate::stages::names::called;

/// Figures beyond these say nothing new.
const MOST: usize = 6;
/// A share held that is round-off.
const ALL: f64 = 1e-9;

/// Stages in which one excavation was let go step by step.
#[derive(Clone, Debug, PartialEq)]
struct Steps {
    /// The stage of the excavation.
    first: usize,
    /// Share let go by the end of each stage, from the first on.
    shares: Vec<f64>,
}

/// Excavations that were let go in more than one step. λ of a stage is of all that is held, so what is left shrinks by
/// 1 − λ; a further excavation ends the series, since what it holds is mixed with the rest.
fn series(stages: &[StageSummary]) -> Vec<Steps> {
    let mut found = Vec::new();
    let mut k = 1;
    while k < stages.len() {
        let first = k;
        k += 1;
        let release = stages[first].release;
        if stages[first].excavated.is_empty() || !release.is_finite() || release >= 1.0 - ALL {
            continue;
        }
        let mut held = 1.0 - release;
        let mut shares = vec![1.0 - held];
        while k < stages.len() && stages[k].excavated.is_empty() && held > ALL {
            let release = if stages[k].release.is_finite() { stages[k].release } else { 1.0 };
            held *= 1.0 - release;
            shares.push(1.0 - held);
            k += 1;
        }
        if shares.len() > 1 {
            found.push(Steps { first, shares });
        }
    }
    found
}

/// The block; nothing where every excavation was let go at once.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let stages = &facts.computed.stages;
    let series = series(stages);
    let caverns = caverns(stages);
    let figures: Vec<Figure> = series
        .iter()
        .filter_map(|steps| figure(source, stages, steps, &concerned(&caverns, &stages[steps.first])))
        .take(MOST)
        .enumerate()
        .map(|(number, figure)| named(figure, number))
        .collect();
    if figures.is_empty() {
        return None;
    }
    let mut notes = Vec::new();
    if series.len() > figures.len() {
        notes.push(say!(
            language,
            "{drawn} of {all} such excavations are drawn.",
            drawn = figures.len(),
            all = series.len()
        ));
    }
    let text = say!(
        language,
        "Motion towards the opening since the stage before the excavation, over the share of the forces at its surface \
                that has been let go (what is left acts like a support). A straight line is elastic rock; where the curve \
                steepens the rock yields. After a lining is installed the curve should flatten as the lining takes its share."
    );
    Some(Block { heading: say!(language, "Ground reaction"), text, figures, notes, ..Block::default() })
}

/// The points of the caverns that the excavated groups belong to by name; all where none does.
fn concerned(
    caverns: &indexmap::IndexMap<String, Vec<WallPoint>>,
    stage: &StageSummary,
) -> Vec<(String, WallPoint)> {
    let of = |all: bool| -> Vec<(String, WallPoint)> {
        let belongs = |cavern: &str| {
            let within =
                |group: &String| group.strip_prefix(cavern).is_some_and(|rest| rest.starts_with('.'));
            all || stage.excavated.iter().any(within)
        };
        let chosen = caverns.iter().filter(|(cavern, _)| belongs(cavern));
        let points =
            chosen.flat_map(|(cavern, points)| points.iter().map(move |p| (cavern.clone(), p.clone())));
        points.filter(|(_, p)| p.inward.is_some()).collect()
    };
    let own = of(false);
    if own.is_empty() { of(true) } else { own }
}

fn named(figure: Figure, number: usize) -> Figure {
    let suffix = if number == 0 { String::new() } else { format!("-{}", number + 1) };
    Figure { file: format!("reaction{suffix}.svg"), ..figure }
}

fn figure(
    source: &Source,
    stages: &[StageSummary],
    steps: &Steps,
    points: &[(String, WallPoint)],
) -> Option<Figure> {
    let language = source.language;
    let before = steps.first - 1;
    let several = points.iter().any(|(cavern, _)| *cavern != points[0].0);
    let curve = |(k, (cavern, point)): (usize, &(String, WallPoint))| {
        let start = point.inwards(stages, before)?;
        let after = steps.shares.iter().enumerate().map(|(i, share)| {
            let moved = point.inwards(stages, steps.first + i).unwrap_or(f64::NAN) - start;
            (100.0 * share, moved)
        });
        let name = point.called(language);
        let name = if several { format!("{cavern} {name}") } else { name };
        let points: Vec<(f64, f64)> = std::iter::once((0.0, 0.0)).chain(after).collect();
        points[1..].iter().any(|p| p.1.is_finite()).then(|| PlotCurve::new(name, k, Pen::Marked, points))
    };
    let mut curves: Vec<PlotCurve> = points.iter().take(LINES.len()).enumerate().filter_map(curve).collect();
    if curves.is_empty() {
        return None;
    }
    let (low, high) = plot::ranges(&curves).1;
    let scale = source.scale(Kind::Displacement);
    for point in curves.iter_mut().flat_map(|curve| curve.pieces.iter_mut().flatten()) {
        point.1 *= scale.factor;
    }
    let stage = called(language, steps.first, &stages[steps.first]);
    let named = say!(language, "{name}: motion towards the opening", name = stage);
    let heading = scale.labelled(&named);
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &heading, &curves) + 16.0;
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + 250.0,
        across: Ticks::within(0.0, 104.0, 10),
        up: Ticks::around((low * scale.factor).min(0.0), (high * scale.factor).max(0.0), 6),
    };
    let mut free_from = f64::NEG_INFINITY;
    for (i, share) in steps.shares.iter().enumerate() {
        let (x, _) = axes.point(100.0 * share, 0.0);
        svg.rule((x, top - 14.0), (x, axes.bottom), true);
        let text = label(stages, steps.first + i);
        let width = text_width(&text, 11.0);
        // From the rule to the left, where the stage went.
        if x - width - 4.0 > free_from {
            svg.text((x - 4.0, top - 4.0), Anchor::End, 11.0, Style::Muted, &text);
            free_from = x;
        }
    }
    plot::draw(&mut svg, &axes, &curves);
    let along = say!(language, "let go so far");
    svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &format!("{along} (%)"));
    let plot = Plot { title: named, unit: scale.unit.clone(), log: false, ends: None, curves: &curves };
    let mut answering = plot_curves::curves(&heading, &along, "%", &[plot]);
    let rule = |(i, share): (usize, &f64)| Rule {
        across: 100.0 * share,
        name: label(stages, steps.first + i),
        side: RuleAnchor::End,
    };
    answering.rules = steps.shares.iter().enumerate().map(rule).collect();
    let installed =
        steps.shares.iter().enumerate().filter(|(i, _)| !stages[steps.first + i].installed.is_empty());
    // What is installed in a stage is there before its forces go.
    let installed = installed.map(|(i, _)| {
        let share = if i == 0 { 0.0 } else { 100.0 * steps.shares[i - 1] };
        let names = stages[steps.first + i].installed.join(", ");
        say!(
            language,
            "{names} installed with {share}\u{a0}% of the forces let go",
            names = names,
            share = trimmed(&figures(share, 3))
        )
    });
    let installed: Vec<String> = installed.collect();
    let caption = if installed.is_empty() {
        String::new()
    } else {
        say!(language, "{list}.", list = installed.join(&say!(language, "; ")))
    };
    let description = say!(language, "motion over the share of forces let go");
    let svg = svg.finish(axes.bottom + 42.0, &heading, &description);
    Some(Figure {
        heading: say!(language, "Ground reaction"),
        file: String::new(),
        svg,
        caption,
        curves: Some(answering),
        narrow: None,
    })
}

/// Number and name of a stage.
fn label(stages: &[StageSummary], k: usize) -> String {
    format!("{k} {}", stages[k].name).trim().to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_of_what_is_held_add_up_and_a_further_excavation_ends_a_series() {
        let stage = |excavated: &str, release| StageSummary {
            excavated: if excavated.is_empty() { Vec::new() } else { vec![excavated.into()] },
            release,
            ..StageSummary::default()
        };
        let stages = [
            stage("", f64::NAN),
            stage("a", 0.5),
            stage("", 0.5),
            stage("", 1.0),
            stage("b", 1.0),
            stage("c", 0.3),
            stage("d", 0.2),
            stage("", 1.0),
        ];
        assert_eq!(
            series(&stages),
            [
                Steps { first: 1, shares: vec![0.5, 0.75, 1.0] },
                Steps { first: 6, shares: vec![1.0 - 0.8, 1.0] }
            ]
        );
    }
}
