//! Results over the values of a key, where all keys were drawn at random.

use tremolite_results::study::{Study, StudyRun};

use super::Figure;
use super::paper::{draw, file_part, suiting, told};
use crate::drawing::plot::{Pen, PlotCurve, range};
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};

/// Figures at most, those whose ranks go together most.
const MOST: usize = 12;

/// One figure a pair of key and measure, the strongest first.
pub fn figures(study: &Study, language: Language) -> Vec<Figure> {
    let mut pairs: Vec<_> = study.influences.iter().collect();
    pairs.sort_by(|a, b| b.rank.abs().total_cmp(&a.rank.abs()));
    let figure = |pair: &&tremolite_results::study::Influence| {
        let parameter = study.parameters.iter().position(|p| p.name == pair.parameter)?;
        let measure = study.measures.iter().position(|m| m.name == pair.measure)?;
        let scale =
            suiting(&study.measures[measure], study.runs.iter().filter_map(|run| run.measures[measure]));
        let mut levels: Vec<&Option<String>> = Vec::new();
        for run in &study.runs {
            if !levels.contains(&&run.level) {
                levels.push(&run.level);
            }
        }
        let of_level = |(colour, level): (usize, &&Option<String>)| {
            let runs = study.runs.iter().filter(|run| run.level == **level);
            let points = runs
                .filter_map(|run| Some((number(run, parameter)?, run.measures[measure]? * scale.factor)))
                .collect();
            PlotCurve::new((*level).clone().unwrap_or_default(), colour, Pen::Dots, points)
        };
        let curves: Vec<PlotCurve> = levels.iter().enumerate().map(of_level).collect();
        let points = || curves.iter().flat_map(|c| c.pieces.iter().flatten());
        let ((left, right), (low, high)) = (range(points().map(|p| p.0)), range(points().map(|p| p.1)));
        let unit = |u: &Option<String>| {
            u.clone().filter(|u| !u.is_empty()).map_or_else(String::new, |u| format!(" ({u})"))
        };
        let across = format!("{}{}", pair.parameter, unit(&study.parameters[parameter].unit));
        let up = scale.labelled(&pair.measure);
        let svg = draw(
            &say!(language, "{measure} over {key}", measure = pair.measure, key = pair.parameter),
            (&across, &up),
            (Ticks::around(left, right, 8), Ticks::around(low, high, 6)),
            &curves,
            &[],
            &say!(language, "One point a run."),
        );
        let caption = say!(
            language,
            "Spearman's correlation of ranks {rank}, over {runs} runs, within each record and level.",
            rank = told(pair.rank),
            runs = pair.runs
        );
        let file = format!("scatter-{}-{}.svg", file_part(&pair.measure), file_part(&pair.parameter));
        Some(Figure { file, svg, caption })
    };
    pairs.iter().take(MOST).filter_map(figure).collect()
}

/// The number that the value of a key begins with.
fn number(run: &StudyRun, parameter: usize) -> Option<f64> {
    let text = run.values[parameter].as_deref()?.trim_matches('"');
    text.split_whitespace().next()?.parse().ok()
}
