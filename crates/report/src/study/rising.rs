//! Results over intensity: curves of rising levels, or the points of stripes, one line a record and sample.

use tremolite_results::study::{RunStatus, Study, StudyRun};

use super::Figure;
use super::fragility::over;
use super::paper::{draw, file_part, suiting};
use crate::drawing::plot::{Pen, PlotCurve, range};
use crate::drawing::svg::LINES;
use crate::drawing::ticks::Ticks;
use crate::language::{Language, say};

/// Lines that are named: so many as have a colour of their own.
const NAMED: usize = LINES.len();

/// One figure a measure, where runs have levels.
pub fn figures(study: &Study, language: Language) -> Vec<Figure> {
    let (Some(by), true) = (study.intensities.first(), study.runs.iter().any(|r| r.level.is_some())) else {
        return Vec::new();
    };
    let mut chains: Vec<(usize, &Option<String>)> = Vec::new();
    for run in &study.runs {
        if !chains.contains(&(run.sample, &run.record)) {
            chains.push((run.sample, &run.record));
        }
    }
    let samples = study.runs.iter().any(|run| run.sample > 0);
    let measure = |k: usize| {
        let name = &study.measures[k].name;
        let scale = suiting(&study.measures[k], study.runs.iter().filter_map(|run| run.measures[k]));
        let curve = |(n, (sample, record)): (usize, &(usize, &Option<String>))| {
            let of_chain = |run: &&StudyRun| run.sample == *sample && run.record == **record;
            let points: Vec<(f64, f64)> = study
                .runs
                .iter()
                .filter(of_chain)
                .filter_map(|run| {
                    Some((
                        run.intensities.first().copied().flatten()? / by.shown_factor,
                        run.measures[k]? * scale.factor,
                    ))
                })
                .collect();
            let title = study.runs.iter().find(|run| of_chain(run)).map_or("", |run| run.title.as_str());
            let name = match record {
                Some(record) if samples => format!("{title}, {record}"),
                Some(record) => record.clone(),
                None => title.to_owned(),
            };
            let name = if chains.len() <= NAMED { name } else { String::new() };
            PlotCurve::new(name, n, if chains.len() <= NAMED { Pen::Marked } else { Pen::Thin }, points)
        };
        let curves: Vec<PlotCurve> = chains.iter().enumerate().map(curve).collect();
        let all = || curves.iter().flat_map(|c| c.pieces.iter().flatten());
        let (low, high) = range(all().map(|p| p.1));
        let (_, right) = range(all().map(|p| p.0));
        if low > high {
            return None;
        }
        let stopped = study.runs.iter().filter(|r| r.status == RunStatus::Failed).count();
        let note =
            say!(language, "{some} runs that the guard stopped have no result and no point.", some = stopped);
        let svg = draw(
            &say!(language, "{measure} over intensity", measure = name),
            (&over(&by.name, &by.shown), &scale.labelled(name)),
            (super::paper::from_zero(right), Ticks::around(low.min(0.0), high, 6)),
            &curves,
            &[],
            &say!(language, "The result at each level of intensity, a line a record and sample."),
        );
        let all = say!(language, "{measure} at each level, a line a record and sample.", measure = name);
        let caption = if stopped > 0 { language.joined(&[all, note]) } else { all };
        Some(Figure { file: format!("levels-{}.svg", file_part(name)), svg, caption })
    };
    (0..study.measures.len()).filter_map(measure).collect()
}
