//! How far crown, walls and floor of each cavern moved, by stage.

use indexmap::IndexMap;
use tremolite_results::{StageSummary, Summary};

use crate::chapter::figure::{Block, Figure};
use crate::chapter::text_table::{Cell, Head, TextTable};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};
use crate::quantities::units::Kind;
use crate::source::Source;
use crate::stages::names::{called, name};

/// Points side by side in one table.
const ABREAST: usize = 5;

/// A named point of a cavern.
#[derive(Clone, Debug, PartialEq)]
pub struct WallPoint {
    /// As the summary has it.
    pub key: String,
    /// Without the cavern's name.
    pub label: String,
    /// Component and sign of the motion towards the opening, where the name says it.
    pub inward: Option<(usize, f64)>,
}

/// The points of each cavern, by its name.
pub fn caverns(stages: &[StageSummary]) -> IndexMap<String, Vec<WallPoint>> {
    let mut caverns: IndexMap<String, Vec<WallPoint>> = IndexMap::new();
    for key in stages.iter().flat_map(|stage| stage.walls.keys()) {
        let (cavern, label, inward) = parts(key);
        let points = caverns.entry(cavern).or_default();
        if !points.iter().any(|point| point.key == *key) {
            points.push(WallPoint { key: key.clone(), label, inward });
        }
    }
    caverns
}

/// The cavern, the place in it, and which way is inward: `hall.wall.left` is a wall of smaller x.
fn parts(key: &str) -> (String, String, Option<(usize, f64)>) {
    let words: Vec<&str> = key.split('.').collect();
    let is = |word: &str, names: &[&str]| {
        word.to_lowercase().split(['_', '-', ' ']).any(|part| names.contains(&part))
    };
    let place = ["crown", "roof", "floor", "invert", "wall", "walls", "left", "right"];
    let Some(first) = words.iter().position(|word| is(word, &place)) else {
        let (cavern, label) = key.rsplit_once('.').unwrap_or(("", key));
        return (cavern.into(), label.into(), None);
    };
    let rest = &words[first..];
    let any = |names: &[&str]| rest.iter().any(|word| is(word, names));
    let inward = if any(&["crown", "roof"]) {
        Some((2, -1.0))
    } else if any(&["floor", "invert"]) {
        Some((2, 1.0))
    } else if any(&["left"]) {
        Some((0, 1.0))
    } else if any(&["right"]) {
        Some((0, -1.0))
    } else {
        None
    };
    (words[..first].join("."), rest.join(" "), inward)
}

impl WallPoint {
    /// What it is called on the page.
    pub fn called(&self, language: Language) -> String {
        match self.label.as_str() {
            "crown" => say!(language, "crown"),
            "floor" => say!(language, "floor"),
            "wall left" => say!(language, "wall left"),
            "wall right" => say!(language, "wall right"),
            other => other.to_owned(),
        }
    }

    /// Displacement since the initial equilibrium (m); zero where that has just ended, by definition.
    pub fn moved(&self, stages: &[StageSummary], k: usize) -> [f64; 3] {
        let nothing = if k == 0 { [0.0; 3] } else { [f64::NAN; 3] };
        stages.get(k).and_then(|stage| stage.walls.get(&self.key)).copied().unwrap_or(nothing)
    }

    /// The part of it towards the opening.
    pub fn inwards(&self, stages: &[StageSummary], k: usize) -> Option<f64> {
        self.inward.map(|(component, sign)| {
            let moved = sign * self.moved(stages, k)[component];
            if moved == 0.0 { 0.0 } else { moved }
        })
    }
}

/// Pairs of walls that face each other.
fn facing(points: &[WallPoint]) -> Vec<(&WallPoint, &WallPoint)> {
    let other = |left: &WallPoint| {
        let label = left.label.to_lowercase().replace("left", "right");
        points.iter().find(|p| p.label.to_lowercase() == label && p.inward == Some((0, -1.0)))
    };
    let lefts = points.iter().filter(|p| p.inward == Some((0, 1.0)));
    lefts.filter_map(|left| Some((left, other(left)?))).collect()
}

/// What two walls came nearer to each other: the difference of their horizontal displacements.
fn closure(stages: &[StageSummary], (left, right): (&WallPoint, &WallPoint), k: usize) -> f64 {
    left.moved(stages, k)[0] - right.moved(stages, k)[0]
}

/// What a closure is called beside others.
fn closure_name(language: Language, pairs: &[(&WallPoint, &WallPoint)], k: usize) -> String {
    if pairs.len() == 1 {
        say!(language, "wall to wall")
    } else {
        say!(language, "wall to wall, {wall}", wall = pairs[k].0.called(language))
    }
}

/// The block; nothing for a run without stages after the first.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let stages = &facts.computed.stages;
    if stages.len() < 2 {
        return None;
    }
    let caverns = caverns(stages);
    let mut block = Block { heading: say!(language, "Convergence"), ..Block::default() };
    if caverns.is_empty() {
        block.notes.push(say!(language, "Left out. The summary names no points of walls."));
        return Some(block);
    }
    block.text = say!(
        language,
        "Displacement of the rock nearest to each named point since the initial equilibrium. In the figures motion towards \
                  the opening is positive: crown down, floor up, the left wall (smaller x) to the right, the right one to the \
                  left. Wall to wall: how much nearer the two walls came. Motion should follow the excavation; \
                  where it goes on growing without any, or one wall runs away from the others, take a second look."
    );
    for (number, (cavern, points)) in caverns.iter().enumerate() {
        if points.iter().any(|p| p.inward.is_some()) {
            block.figures.push(figure(source, stages, cavern, points, number));
        } else {
            block.notes.push(if cavern.is_empty() {
                say!(language, "Points: no figure, since no name says crown, wall left, wall right or floor.")
            } else {
                say!(
                    language,
                    "{cavern}: no figure, since no name says crown, wall left, wall right or floor.",
                    cavern = cavern
                )
            });
        }
    }
    block.tables = caverns
        .iter()
        .flat_map(|(cavern, points)| points.chunks(ABREAST).map(move |points| (cavern, points)))
        .map(|(cavern, points)| table(source, stages, cavern, points))
        .collect();
    Some(block)
}

fn figure(
    source: &Source,
    stages: &[StageSummary],
    cavern: &str,
    points: &[WallPoint],
    number: usize,
) -> Figure {
    let language = source.language;
    let mut curves: Vec<PlotCurve> = Vec::new();
    // The dark colour is that of the closure.
    let mut colours = (0..).filter(|k| *k != 3);
    for point in points.iter().filter(|p| p.inward.is_some()) {
        let values = (0..stages.len()).map(|k| (k as f64, point.inwards(stages, k).unwrap_or(f64::NAN)));
        let (name, colour) = (point.called(language), colours.next().unwrap_or(0));
        curves.push(PlotCurve::new(name, colour, Pen::Marked, values.collect()));
    }
    let pairs = facing(points);
    for (k, pair) in pairs.iter().enumerate() {
        let values = (0..stages.len()).map(|k| (k as f64, closure(stages, *pair, k)));
        curves.push(PlotCurve::new(closure_name(language, &pairs, k), 3, Pen::Dashed, values.collect()));
    }
    let (low, high) = plot::ranges(&curves).1;
    let scale = source.scale(Kind::Displacement);
    for point in curves.iter_mut().flat_map(|curve| curve.pieces.iter_mut().flatten()) {
        point.1 *= scale.factor;
    }
    let heading = scale.labelled(&if cavern.is_empty() {
        say!(language, "motion towards the opening")
    } else {
        say!(language, "{name}: motion towards the opening", name = cavern)
    });
    let names: Vec<String> = stages.iter().map(|stage| name(language, &stage.name)).collect();
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &heading, &curves);
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + 250.0,
        across: plot::stages(&names, WIDTH - LEFT - RIGHT),
        up: Ticks::around((low * scale.factor).min(0.0), (high * scale.factor).max(0.0), 6),
    };
    plot::draw(&mut svg, &axes, &curves);
    let along = say!(language, "at the end of each stage");
    svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &along);
    let file =
        format!("convergence{}.svg", if number == 0 { String::new() } else { format!("-{}", number + 1) });
    let most = points
        .iter()
        .filter_map(|p| Some((p, p.inwards(stages, stages.len() - 1).filter(|x| x.is_finite())?)))
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    let caption = most.map_or(String::new(), |(point, moved)| {
        let end = called(language, stages.len() - 1, &stages[stages.len() - 1]);
        let (point, size) = (point.called(language), scale.quantity(moved.abs()));
        if moved < 0.0 {
            say!(
                language,
                "Most at the end ({end}): {point}, {size} away from the opening.",
                end = end,
                point = point,
                size = size
            )
        } else {
            say!(
                language,
                "Most at the end ({end}): {point}, {size} towards the opening.",
                end = end,
                point = point,
                size = size
            )
        }
    });
    let svg = svg.finish(axes.bottom + 42.0, &heading, &caption);
    Figure { heading: say!(language, "Convergence"), file, svg, caption, curves: None, narrow: None }
}

/// Both components of each point, by stage.
fn table(source: &Source, stages: &[StageSummary], cavern: &str, points: &[WallPoint]) -> TextTable {
    let language = source.language;
    let all = || (0..stages.len()).flat_map(|k| points.iter().flat_map(move |p| p.moved(stages, k)));
    let most = all().filter(|x| x.is_finite()).fold(0.0, |most: f64, x| most.max(x.abs()));
    let scale = source.scale(Kind::Displacement);
    let pairs = facing(points);
    let mut over = vec![Head::words(""), Head::words(scale.labelled(cavern).trim())];
    let mut head = vec![Head::number("#"), Head::words(say!(language, "stage"))];
    for point in points {
        over.push(Head::number(point.called(language)).over(2));
        head.extend([Head::number("x"), Head::number(say!(language, "z, up"))]);
    }
    for k in 0..pairs.len() {
        over.push(Head::number(closure_name(language, &pairs, k)));
        head.push(Head::number(say!(language, "closer by")));
    }
    // A tenth of a percent of the largest is as fine as the method.
    let decimals = (2 - (most * scale.factor).max(1e-9).log10().floor() as i32).clamp(0, 6) as usize;
    let number = |x: f64| {
        let text = format!("{:.decimals$}", (x * scale.factor).abs());
        let minus = x < 0.0 && text.contains(|c: char| c.is_ascii_digit() && c != '0');
        Cell::number(if !x.is_finite() {
            "–".into()
        } else if minus {
            format!("−{text}")
        } else {
            text
        })
    };
    let row = |k: usize| {
        let mut row = vec![Cell::number(k.to_string()), Cell::words(&stages[k].name)];
        for point in points {
            let moved = point.moved(stages, k);
            row.extend([number(moved[0]), number(moved[2])]);
        }
        row.extend(pairs.iter().map(|pair| number(closure(stages, *pair, k))));
        row
    };
    TextTable { head: vec![over, head], rows: (1..stages.len()).map(row).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_which_way_is_inward() {
        for (key, cavern, label, inward) in [
            ("powerhouse.crown", "powerhouse", "crown", Some((2, -1.0))),
            ("powerhouse.floor", "powerhouse", "floor", Some((2, 1.0))),
            ("powerhouse.wall.left", "powerhouse", "wall left", Some((0, 1.0))),
            ("east.hall.wall.right", "east.hall", "wall right", Some((0, -1.0))),
            ("hall.left_wall", "hall", "left_wall", Some((0, 1.0))),
            ("crown", "", "crown", Some((2, -1.0))),
            ("hall.pillar", "hall", "pillar", None),
            ("A", "", "A", None),
        ] {
            assert_eq!(parts(key), (cavern.to_owned(), label.to_owned(), inward), "{key}");
        }
    }

    #[test]
    fn walls_that_come_nearer_close() {
        let walls = [("h.wall.left", [0.003, 0.0, 0.0]), ("h.wall.right", [-0.004, 0.0, 0.0])];
        let walls = walls.map(|(name, u)| (name.to_owned(), u)).into();
        let stages = [StageSummary::default(), StageSummary { walls, ..StageSummary::default() }];
        let caverns = caverns(&stages);
        let pairs = facing(&caverns["h"]);
        assert!((closure(&stages, pairs[0], 1) - 0.007).abs() < 1e-15);
        assert_eq!(
            caverns["h"].iter().map(|p| p.inwards(&stages, 1)).collect::<Vec<_>>(),
            [Some(0.003), Some(0.004)]
        );
    }
}
