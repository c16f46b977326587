//! Fragility curves of the runs of a study: what is counted, what is not, and the curve with its bounds.

use std::collections::BTreeMap;

use tremolite_case::study::{FailedRun, Fragility, StudyFile, rounded};
use tremolite_results::study::{RunStatus, Share, Study, StudyBounds, StudyFit, StudyFragility, StudyRun};
use tremolite_results::{Said, said};

use crate::bootstrap;
use crate::fragility::{Curve, NoCurve, Risen, Seen, of_risen, of_stripes};
use crate::intensity::Measure;
use crate::plan::Plan;

/// Points of a curve that is drawn.
const POINTS: usize = 81;

/// One for each limit of each fragility of the study.
pub fn of(study: &StudyFile, plan: &Plan, found: &Study) -> Vec<StudyFragility> {
    let mut all = Vec::new();
    for fragility in &study.fragilities {
        let by = match &fragility.by {
            Some(by) => Measure::parse(&by.value).ok(),
            None => plan.scaled_by,
        };
        let Some(by) = by else { continue };
        for above in &fragility.above {
            all.push(one(study, plan, found, fragility, by, *above));
        }
    }
    all
}

/// What a run counts as.
#[derive(Clone, Copy, PartialEq)]
enum Counted {
    Exceeded,
    Held,
    LeftOut,
}

struct Asked<'a> {
    fragility: &'a Fragility,
    /// The column of the measure, and its limit.
    measure: usize,
    above: f64,
    /// The column of the intensity, and its unit.
    by: usize,
    unit_value: f64,
}

impl Asked<'_> {
    fn counted(&self, run: &StudyRun) -> Counted {
        match (run.status, run.measures[self.measure]) {
            (RunStatus::Done, Some(x)) if x > self.above => Counted::Exceeded,
            (RunStatus::Done, Some(_)) => Counted::Held,
            (RunStatus::Failed, _) if self.fragility.failed == FailedRun::Exceeds => Counted::Exceeded,
            _ => Counted::LeftOut,
        }
    }

    fn intensity(&self, run: &StudyRun) -> Option<f64> {
        run.intensities[self.by].map(|x| x / self.unit_value).filter(|x| *x > 0.0)
    }
}

fn one(
    study: &StudyFile,
    plan: &Plan,
    found: &Study,
    fragility: &Fragility,
    by: Measure,
    above: f64,
) -> StudyFragility {
    let measure =
        study.measures.iter().position(|m| m.name.value == fragility.measure.value).unwrap_or_default();
    let column = plan.intensities.iter().position(|m| *m == by).unwrap_or_default();
    let (unit, unit_value) = plan.told_in(&by);
    let asked = Asked { fragility, measure, above, by: column, unit_value };
    let seed = study.sample.as_ref().map_or(1, |s| s.seed);
    let mut out = StudyFragility {
        measure: fragility.measure.value.clone(),
        above,
        by: by.to_string(),
        unit,
        unit_value,
        ..StudyFragility::default()
    };
    count(&asked, found, &mut out);
    let clusters = Clusters::of(study, plan);
    let bootstrap = (fragility.bootstrap as usize, seed);
    if plan.rises {
        out.method = "truncated".to_owned();
        let risen = risen(&asked, plan, found, &clusters);
        out.shares = cumulated(&risen);
        let at_first = beyond_at_first(&asked, plan, found);
        if at_first > 0 {
            out.no_curve_message = said!(
                "{some} of {all} series of levels are beyond the limit at their first level, and how far below is not known: begin lower",
                some = at_first.to_string(),
                all = risen.len().to_string()
            );
            out.no_curve = out.no_curve_message.to_string();
            return out;
        }
        finish(&mut out, &risen, |r| r.cluster, |r| r.intensity, clusters.count, bootstrap, of_risen);
    } else {
        out.method = "binomial".to_owned();
        let seen = seen(&asked, plan, found, &clusters);
        if plan.scaled_by == Some(by) {
            out.shares = stripes(&seen);
        }
        finish(&mut out, &seen, |s| s.cluster, |s| s.intensity, clusters.count, bootstrap, of_stripes);
    }
    out
}

/// What a bootstrap draws together: runs of a record, or of a sample where there is one record alone.
struct Clusters {
    by_record: bool,
    count: usize,
}

impl Clusters {
    fn of(study: &StudyFile, plan: &Plan) -> Clusters {
        let by_record = study.records.len() > 1;
        Clusters { by_record, count: if by_record { study.records.len() } else { plan.samples.len() } }
    }

    fn number(&self, run: &crate::plan::Run) -> usize {
        if self.by_record { run.record.unwrap_or_default() } else { run.sample }
    }
}

fn count(asked: &Asked<'_>, found: &Study, out: &mut StudyFragility) {
    let mut left_out: BTreeMap<&str, usize> = BTreeMap::new();
    for run in found.runs.iter().filter(|run| run.status != RunStatus::NotNeeded) {
        match asked.counted(run) {
            _ if asked.intensity(run).is_none() => *left_out.entry("without an intensity").or_default() += 1,
            Counted::LeftOut => {
                let why =
                    if run.status == RunStatus::Done { "without the measure" } else { run.status.word() };
                *left_out.entry(why).or_default() += 1;
            }
            counted => {
                out.counted += 1;
                out.exceeded += usize::from(counted == Counted::Exceeded);
                out.stopped_counted += usize::from(run.status == RunStatus::Failed);
            }
        }
    }
    out.left_out = left_out.into_iter().map(|(why, n)| (why.to_owned(), n)).collect();
}

fn seen(asked: &Asked<'_>, plan: &Plan, found: &Study, clusters: &Clusters) -> Vec<Seen> {
    let of = |(run, row): (&crate::plan::Run, &StudyRun)| {
        let exceeded = match asked.counted(row) {
            Counted::LeftOut => return None,
            counted => counted == Counted::Exceeded,
        };
        Some(Seen { intensity: asked.intensity(row)?, exceeded, cluster: clusters.number(run) })
    };
    plan.runs.iter().zip(&found.runs).filter_map(of).collect()
}

/// Each chain by where it exceeds the limit, between the last level that does not and the first that does.
fn risen(asked: &Asked<'_>, plan: &Plan, found: &Study, clusters: &Clusters) -> Vec<Risen> {
    let mut out: Vec<Risen> = Vec::new();
    for chain in 0..plan.chains() {
        let runs = || plan.runs.iter().zip(&found.runs).filter(|(run, _)| run.chain == chain);
        let mut held: Option<(f64, Option<f64>)> = None;
        let mut end: Option<Risen> = None;
        for (run, row) in runs() {
            let (Some(intensity), cluster) = (asked.intensity(row), clusters.number(run)) else { continue };
            match asked.counted(row) {
                Counted::Held => {
                    held = Some((intensity, row.measures[asked.measure]));
                    end = Some(Risen { intensity, exceeded: false, cluster });
                }
                Counted::Exceeded => {
                    let there = (intensity, row.measures[asked.measure]);
                    let intensity = held.map_or(intensity, |held| crossing(held, there, asked.above));
                    end = Some(Risen { intensity, exceeded: true, cluster });
                    break;
                }
                Counted::LeftOut => break,
            }
        }
        out.extend(end);
    }
    out
}

/// How many chains are beyond the limit at their first level.
fn beyond_at_first(asked: &Asked<'_>, plan: &Plan, found: &Study) -> usize {
    let first = |chain: usize| {
        let mut runs = plan.runs.iter().zip(&found.runs).filter(move |(run, _)| run.chain == chain);
        runs.find(|(_, row)| asked.intensity(row).is_some()).map(|(_, row)| asked.counted(row))
    };
    (0..plan.chains()).filter(|chain| first(*chain) == Some(Counted::Exceeded)).count()
}

/// Where a result goes through a limit, linear between two levels; halfway where one of the two has no result.
fn crossing((x0, m0): (f64, Option<f64>), (x1, m1): (f64, Option<f64>), limit: f64) -> f64 {
    match (m0, m1) {
        (Some(m0), Some(m1)) if m1 > m0 => x0 + (limit - m0) / (m1 - m0) * (x1 - x0),
        _ => 0.5 * (x0 + x1),
    }
}

fn stripes(seen: &[Seen]) -> Vec<Share> {
    let mut shares: Vec<Share> = Vec::new();
    for s in seen {
        let known = shares.iter_mut().find(|share| (share.intensity / s.intensity - 1.0).abs() < 1e-6);
        match known {
            Some(share) => {
                share.of += 1;
                share.exceeded += usize::from(s.exceeded);
            }
            None => shares.push(Share {
                intensity: s.intensity,
                exceeded: usize::from(s.exceeded),
                of: 1,
                probability: None,
            }),
        }
    }
    shares.sort_by(|a, b| a.intensity.total_cmp(&b.intensity));
    shares
}

/// The share of all chains that are beyond the limit up to each intensity at which one is; where some were not run so high and hold until
/// then, by the product limit (`kaplan1958`), since nobody knows of them further up.
fn cumulated(risen: &[Risen]) -> Vec<Share> {
    let mut at: Vec<f64> = risen.iter().filter(|r| r.exceeded).map(|r| r.intensity).collect();
    at.sort_by(f64::total_cmp);
    let (mut hold, mut left) = (1.0, false);
    let mut shares = Vec::new();
    for (k, &intensity) in at.iter().enumerate() {
        // Those that go through here, and those that were run up to here and hold.
        let known = (at.len() - k) + risen.iter().filter(|r| !r.exceeded && r.intensity >= intensity).count();
        hold *= 1.0 - 1.0 / known as f64;
        // Once one was left behind, all above differ from the plain share.
        left |= known + k < risen.len();
        let probability = left.then_some(1.0 - hold);
        shares.push(Share { intensity, exceeded: k + 1, of: risen.len(), probability });
    }
    shares
}

/// Fits the curve, with its bounds.
fn finish<T: Copy>(
    out: &mut StudyFragility,
    data: &[T],
    cluster: impl Fn(&T) -> usize,
    intensity: impl Fn(&T) -> f64,
    clusters: usize,
    bootstrap: (usize, u32),
    fit: impl Fn(&[T]) -> Result<Curve, NoCurve>,
) {
    let curve = match fit(data) {
        Ok(curve) => curve,
        Err(why) => {
            out.no_curve_message = in_words(why, &out.unit);
            out.no_curve = out.no_curve_message.to_string();
            return;
        }
    };
    let highest =
        data.iter().map(&intensity).fold(0.0, f64::max).max(curve.theta * libm::exp(2.0 * curve.beta));
    let at: Vec<f64> = (0..POINTS).map(|k| highest * k as f64 / (POINTS - 1) as f64).collect();
    let probability = |x: f64| if x > 0.0 { curve.at(x) } else { 0.0 };
    out.curve = at.iter().map(|x| [*x, probability(*x)]).collect();
    let Curve { theta, beta, covariance, log_likelihood } = curve;
    out.fit = Some(StudyFit { theta, beta, covariance, log_likelihood });
    let bounds = bootstrap::bounds(data, cluster, clusters, bootstrap, &at[1..], fit);
    out.no_bounds = match (&bounds, clusters) {
        (Some(_), _) => String::new(),
        (None, 0 | 1) => "there is one record alone, and nothing to draw from".to_owned(),
        (None, _) => "fewer than half of the samples have a curve: there are too few records".to_owned(),
    };
    out.bounds = bounds.map(|b| StudyBounds {
        theta: b.theta,
        beta: b.beta,
        band: std::iter::once([0.0, 0.0]).chain(b.band).collect(),
        clusters,
        samples: b.samples,
        without: b.without,
    });
}

fn in_words(why: NoCurve, unit: &str) -> Said {
    let told = |x: f64| format!("{} {unit}", rounded(x)).trim_end().to_owned();
    match why {
        NoCurve::NoData => said!("there are no runs to count"),
        NoCurve::Never { highest } => {
            said!("no run is beyond the limit, up to {highest}: add higher levels", highest = told(highest))
        }
        NoCurve::Always { lowest } => {
            said!("every run is beyond the limit, from {lowest} on: add lower levels", lowest = told(lowest))
        }
        NoCurve::HighestAlone { level, exceeded, of } => said!(
            "only the highest level, {level}, exceeds the limit ({exceeded} of {of} runs): too few to fit a curve; add levels above \
             {level}, or records",
            level = told(level),
            exceeded = exceeded.to_string(),
            of = of.to_string(),
        ),
        NoCurve::Separated { below, above } if told(below) == told(above) => said!(
            "no run exceeds the limit below {level}, every run above it, and some at {level}: beta cannot be told from 0; add levels \
             around {level}, or records",
            level = told(below)
        ),
        NoCurve::Separated { below, above } => said!(
            "no run exceeds the limit up to {below}, every run from {above} on: beta cannot be told from 0; add levels between them, \
             or records",
            below = told(below),
            above = told(above)
        ),
        NoCurve::Falling => {
            said!(
                "the limit is not exceeded more often at higher intensities: this measure of intensity does not govern it"
            )
        }
        NoCurve::TooFew => said!("fewer than two different intensities at which the limit is exceeded"),
    }
}
