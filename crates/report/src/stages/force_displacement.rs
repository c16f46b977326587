//! Figure of the force that it takes to move what stages move, over the way.

use tremolite_results::{StageSummary, Summary};

use crate::chapter::figure::{Block, Figure};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::say;
use crate::quantities::scale::Scale;
use crate::script::plot_curves::{self, Plot};
use crate::source::Source;

/// Way and force, with the axis along which they go.
const ALONG: [(&str, &str, &str); 3] =
    [("ux", "reaction_x", "x"), ("uy", "reaction_y", "y"), ("uz", "reaction_z", "z")];

/// What is moved along an axis: way \[m\] and force \[N\], stage by stage.
struct Movement {
    name: String,
    points: Vec<(f64, f64)>,
}

/// The block; nothing where stages move nothing.
pub fn block(source: &Source, facts: &Summary) -> Option<Block> {
    let language = source.language;
    let courses = courses(&facts.computed.stages);
    if courses.is_empty() {
        return None;
    }
    let most = |of: fn(&(f64, f64)) -> f64| {
        courses.iter().flat_map(|course| &course.points).map(|p| of(p).abs()).fold(0.0, f64::max)
    };
    let (way, force) = (Scale::suiting("m", most(|p| p.0)), Scale::suiting("N", most(|p| p.1)));
    let shown = |course: &Movement| -> Vec<(f64, f64)> {
        course.points.iter().map(|(u, f)| (u * way.factor, f * force.factor)).collect()
    };
    let curves: Vec<PlotCurve> = courses
        .iter()
        .enumerate()
        .map(|(k, course)| PlotCurve::new(course.name.clone(), k, Pen::Marked, shown(course)))
        .collect();
    let ((left, right), (low, high)) = plot::ranges(&curves);
    let title = say!(language, "Force over displacement");
    let heading = force.labelled(&title);
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &heading, &curves);
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + 300.0,
        across: Ticks::around(left.min(0.0), right.max(0.0), 10),
        up: Ticks::around(low.min(0.0), high.max(0.0), 6),
    };
    plot::draw(&mut svg, &axes, &curves);
    let along = say!(language, "displacement since the initial equilibrium");
    let across = way.labelled(&along);
    svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &across);
    let plot =
        Plot { title: title.clone(), unit: force.unit.clone(), log: false, ends: None, curves: &curves };
    let answering = plot_curves::curves(&heading, &along, &way.unit, &[plot]);
    let peak = |course: &Movement| {
        let (at, most) = course.points.iter().copied().max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
        let (end, left) = *course.points.last()?;
        Some(say!(
            language,
            "{name}: largest force {force} at {way}; {left} at the end, {end}. ",
            name = &course.name,
            force = force.quantity(most),
            way = way.quantity(at),
            left = force.quantity(left),
            end = way.quantity(end)
        ))
    };
    let caption: String = courses.iter().filter_map(peak).collect();
    let description = say!(language, "force over displacement of what stages move");
    let svg = svg.finish(axes.bottom + 42.0, &heading, &description);
    let figure = Figure {
        heading: title.clone(),
        file: "force-displacement.svg".into(),
        svg,
        caption: caption.trim_end().to_owned(),
        curves: Some(answering),
        narrow: None,
    };
    let text = say!(
        language,
        "The force with which what is moved pushes on the model, positive along the axis, when the model is at rest after each step. \
         All steps are in stages.csv."
    );
    Some(Block { heading: title, text, figures: vec![figure], ..Block::default() })
}

/// Of each name and axis along which it moves.
fn courses(stages: &[StageSummary]) -> Vec<Movement> {
    let names = stages.iter().find(|stage| !stage.moved.is_empty()).map(|stage| stage.moved.keys());
    let mut all = Vec::new();
    for name in names.into_iter().flatten() {
        for (way, force, axis) in ALONG {
            let point = |stage: &StageSummary| {
                let of = stage.moved.get(name)?;
                Some((*of.get(way)?, *of.get(force)?))
            };
            let points: Vec<(f64, f64)> = stages.iter().filter_map(point).collect();
            if points.iter().any(|p| p.0 != 0.0) {
                all.push(Movement { name: format!("{name}, {axis}"), points });
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use indexmap::IndexMap;

    #[test]
    fn what_is_held_but_not_moved_has_no_curve() {
        let stage = |u: f64, f: f64| {
            let of = |pairs: &[(&str, f64)]| -> IndexMap<String, f64> {
                pairs.iter().map(|(name, x)| ((*name).to_owned(), *x)).collect()
            };
            let jaw = of(&[("uz", u), ("reaction_z", f), ("ux", 0.0), ("reaction_x", 3.0)]);
            let moved =
                [("jaw".to_owned(), jaw), ("foot".to_owned(), of(&[("uz", 0.0), ("reaction_z", -f)]))];
            StageSummary { moved: moved.into(), ..StageSummary::default() }
        };
        let found = courses(&[stage(0.0, 0.0), stage(1e-3, 5.0), stage(2e-3, 2.0)]);
        let [course] = &found[..] else { panic!("{} courses", found.len()) };
        assert_eq!(
            (course.name.as_str(), &course.points[..]),
            ("jaw, z", &[(0.0, 0.0), (1e-3, 5.0), (2e-3, 2.0)][..])
        );
    }
}
