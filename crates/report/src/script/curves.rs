//! The numbers of a figure's curves, for the page's script: with them the curves answer to the pointer.
//!
//! Values are in the units of the figure, to five digits, as single precision whose last bits are zero: what no curve shows
//! would be a quarter of the page. The abscissa has all of single precision; the CSV files hold all digits. The bytes of
//! the numbers stand in planes, first bytes before second ones, since exponents repeat and mantissas do not: on histories
//! that takes a sixth off what zlib alone leaves.

use std::collections::BTreeSet;

use indexmap::IndexMap;
use serde::Serialize;

use crate::drawing::chart::{Chart, Curve, Panel, Stroke};
use crate::language::Language;
use crate::script::blocks::{Blocks, json_element};

/// Of single precision the sign, the exponent and 16 bits: to 8 parts in a million.
const SHOWN: u32 = !0x7f;

/// More rows than this are thinned: at 0.005 s it is 40 s, at four bytes a number 32 kB a line.
const ROWS: usize = 8000;

/// In the place of a value: the row is one of other lines, and this line goes on across it.
pub const PASSED: f64 = f64::INFINITY;

/// What the curves of one figure are made of.
#[derive(Clone, Debug, Serialize)]
pub struct Curves {
    pub title: String,
    /// Above all panels, what they have in common; may be empty.
    pub heading: String,
    pub across: Across,
    pub panels: Vec<CurvePanel>,
    /// Panels beside each other.
    pub abreast: usize,
    pub rules: Vec<Rule>,
    /// How many rows there were before thinning; as many as now where none went.
    pub of_rows: usize,
}

/// The abscissa of all panels of a figure.
#[derive(Clone, Debug, Serialize)]
pub struct Across {
    /// Nothing for the time, which the script names itself.
    pub name: String,
    pub unit: String,
    pub log: bool,
    /// Ascending.
    #[serde(skip)]
    pub values: Vec<f64>,
}

/// A place along the abscissa that has a name.
#[derive(Clone, Debug, Serialize)]
pub struct Rule {
    pub across: f64,
    pub name: String,
    pub side: RuleAnchor,
}

/// Which part of a rule's name stands at it.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum RuleAnchor {
    Start,
    Center,
    End,
}

/// One set of axes.
#[derive(Clone, Debug, Serialize)]
pub struct CurvePanel {
    pub title: String,
    pub unit: String,
    pub log: bool,
    /// The ends of the upright axis, where they do not follow the values.
    pub ends: Option<[f64; 2]>,
    /// Names the marked point; may be empty.
    pub remark: String,
    pub mark: Option<CurveMark>,
    pub lines: Vec<CurveLine>,
}

/// The marked point: number of the line in its panel, abscissa, value in the panel's unit.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct CurveMark {
    pub line: usize,
    pub across: f64,
    pub value: f64,
}

/// One curve.
#[derive(Clone, Debug, Serialize)]
pub struct CurveLine {
    pub name: String,
    /// As [`Svg::lines`](crate::drawing::svg::Svg::lines) takes it.
    pub colour: usize,
    pub stroke: Stroke,
    /// Whether its points are drawn too.
    pub points: bool,
    /// In the panel's unit, one for each of the abscissa; what is not a number leaves a gap, and [`PASSED`] none.
    #[serde(skip)]
    pub values: Vec<f64>,
}

/// A figure in the manifest, with the blocks that hold its numbers: of the lines one behind the other, and of the abscissa.
#[derive(Serialize)]
struct CurvesEntry<'a> {
    #[serde(flatten)]
    curves: &'a Curves,
    rows: usize,
    block: usize,
    across_block: usize,
}

impl Curves {
    /// Panels one below the other.
    pub fn new(title: &str, across: Across, panels: Vec<CurvePanel>) -> Curves {
        let curves = Curves {
            title: title.into(),
            heading: String::new(),
            across,
            panels,
            abreast: 1,
            rules: Vec::new(),
            of_rows: 0,
        };
        curves.thinned(ROWS)
    }

    /// Those of a chart.
    pub fn of_chart(chart: &Chart<'_>, language: Language) -> Curves {
        let panel = |panel: &Panel<'_>| {
            let factor = panel.scale.factor;
            let peak = panel.peak(chart.time);
            let mark = peak.and_then(|peak| {
                let line = panel.lines.iter().position(|line| std::ptr::eq(line, peak.line))?;
                Some(CurveMark { line, across: peak.time, value: peak.value * factor })
            });
            let line = |line: &Curve<'_>| CurveLine {
                name: line.name.clone(),
                colour: line.colour,
                stroke: line.stroke,
                points: false,
                values: line
                    .values
                    .iter()
                    .map(|x| if x.is_finite() { x * factor } else { f64::NAN })
                    .collect(),
            };
            CurvePanel {
                title: panel.title.clone(),
                unit: panel.scale.unit.clone(),
                log: false,
                ends: None,
                remark: chart.remark(panel, language),
                mark,
                lines: panel.lines.iter().map(line).collect(),
            }
        };
        let across =
            Across { name: String::new(), unit: "s".into(), log: false, values: chart.time.to_vec() };
        let panels = chart.panels.iter().map(panel).collect();
        Curves::new(&chart.title, across, panels)
    }

    /// Those rows alone that can be drawn, and of very many those that show every line's peaks.
    fn thinned(mut self, limit: usize) -> Curves {
        let rows = ascending(&self.across.values);
        self.of_rows = rows.len();
        let lines = || self.panels.iter().flat_map(|panel| &panel.lines);
        let keep = if rows.len() > limit {
            let values: Vec<&[f64]> = lines().map(|line| line.values.as_slice()).collect();
            peaks(&rows, &values, limit)
        } else {
            rows
        };
        if keep.len() < self.across.values.len() {
            let at = |values: &[f64]| {
                keep.iter().map(|&row| values.get(row).copied().unwrap_or(f64::NAN)).collect()
            };
            for line in self.panels.iter_mut().flat_map(|panel| &mut panel.lines) {
                line.values = at(&line.values);
            }
            self.across.values = at(&self.across.values);
        }
        self
    }
}

/// Rows whose abscissa goes on: what a resumed or broken run repeats is passed over.
fn ascending(across: &[f64]) -> Vec<usize> {
    let mut last = f64::NEG_INFINITY;
    let goes_on = |row: &usize| {
        let on = across[*row].is_finite() && across[*row] > last;
        last = if on { across[*row] } else { last };
        on
    };
    (0..across.len()).filter(goes_on).collect()
}

/// Of these rows at most `limit`, more only with more than half as many lines: those in which some line is largest or smallest
/// of its stretch, for stretches of equally many rows; each as it is in the file.
fn peaks(rows: &[usize], lines: &[&[f64]], limit: usize) -> Vec<usize> {
    let stretches = (limit.saturating_sub(2) / (2 * lines.len()).max(1)).max(1);
    let mut kept: BTreeSet<usize> = rows.first().into_iter().chain(rows.last()).copied().collect();
    for stretch in rows.chunks(rows.len().div_ceil(stretches)) {
        for line in lines {
            let finite =
                || stretch.iter().copied().filter(|&row| line.get(row).is_some_and(|x| x.is_finite()));
            kept.extend(finite().min_by(|&a, &b| line[a].total_cmp(&line[b])));
            kept.extend(finite().max_by(|&a, &b| line[a].total_cmp(&line[b])));
        }
    }
    kept.into_iter().collect()
}

/// The page's manifest of the curves of figures, by their files, their numbers in `blocks`; empty where there are none.
/// They take at most `room` bytes: a figure that does not find its room stays a drawing, later ones first. Also how many do.
pub fn embedded<'a>(
    figures: impl Iterator<Item = (&'a str, &'a Curves)>,
    blocks: &mut Blocks,
    room: usize,
) -> (String, usize) {
    let (mut taken, mut left) = (0, 0);
    let mut known: Vec<(Vec<u8>, usize)> = Vec::new();
    let mut entries: IndexMap<&str, CurvesEntry<'_>> = IndexMap::new();
    for (file, curves) in figures {
        let lines = curves.panels.iter().flat_map(|panel| &panel.lines);
        let numbers = packed(lines.flat_map(|line| &line.values), SHOWN);
        let Some(block) = blocks.add_within(&numbers, room - taken) else {
            left += 1;
            continue;
        };
        taken += blocks.size(block);
        let across = packed(curves.across.values.iter(), u32::MAX);
        let across_block = match known.iter().find(|(bytes, _)| *bytes == across) {
            Some((_, block)) => *block,
            None => {
                let block = blocks.add(&across);
                known.push((across, block));
                block
            }
        };
        let rows = curves.across.values.len();
        entries.insert(file, CurvesEntry { curves, rows, block, across_block });
    }
    let manifest = match serde_json::to_string(&entries) {
        Ok(json) if !entries.is_empty() => json_element("curves-data", &json),
        _ => String::new(),
    };
    (manifest, left)
}

/// Numbers in single precision, of which `bits` are kept, little-endian, their bytes in four planes.
fn packed<'a>(values: impl Iterator<Item = &'a f64>, bits: u32) -> Vec<u8> {
    // What single precision cannot hold is not drawn, and is not to be taken for PASSED.
    let single = |x: &f64| if x.is_finite() && !(*x as f32).is_finite() { f32::NAN } else { *x as f32 };
    // Rounded to the bits that are kept; the largest numbers of all would become infinite, and are left alone.
    let kept = |x: f32| {
        let rounded = f32::from_bits(x.to_bits().saturating_add((!bits).div_ceil(2)) & bits);
        if x.is_finite() && rounded.is_finite() { rounded } else { x }
    };
    let numbers: Vec<[u8; 4]> = values.map(|x| kept(single(x)).to_le_bytes()).collect();
    (0..4).flat_map(|plane| numbers.iter().map(move |bytes| bytes[plane])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn long(rows: usize) -> Curves {
        let time: Vec<f64> = (0..rows).map(|row| row as f64 * 0.001).collect();
        let line = |k: usize| CurveLine {
            name: format!("m{k}"),
            colour: k,
            stroke: Stroke::Thin,
            points: false,
            values: time.iter().map(|t| (t * 7.0 + k as f64).sin() + f64::from(*t == 31.234) * 5.0).collect(),
        };
        let lines = (0..7).map(line).collect();
        let panel = CurvePanel {
            title: "x".into(),
            unit: "mm".into(),
            log: false,
            ends: None,
            remark: String::new(),
            mark: None,
            lines,
        };
        let across = Across { name: String::new(), unit: "s".into(), log: false, values: time };
        let title = "x".into();
        let (heading, rules) = (String::new(), Vec::new());
        Curves { title, heading, across, panels: vec![panel], abreast: 1, rules, of_rows: 0 }
    }

    #[test]
    fn a_long_history_keeps_rows_as_they_are_and_every_peak() {
        let (whole, thin) = (long(100_000), long(100_000).thinned(ROWS));
        assert_eq!(thin.of_rows, 100_000);
        let rows = thin.across.values.len();
        assert!((ROWS / 4..=ROWS).contains(&rows), "{rows}");
        for (line, all) in thin.panels[0].lines.iter().zip(&whole.panels[0].lines) {
            for (t, x) in thin.across.values.iter().zip(&line.values) {
                assert_eq!(*x, all.values[(t * 1000.0).round() as usize]);
            }
            let most = |values: &[f64]| values.iter().copied().fold(f64::MIN, f64::max);
            let least = |values: &[f64]| values.iter().copied().fold(f64::MAX, f64::min);
            assert_eq!(most(&line.values), most(&all.values));
            assert_eq!(least(&line.values), least(&all.values));
        }
    }

    #[test]
    fn a_history_of_usual_length_is_whole() {
        let whole = long(ROWS).thinned(ROWS);
        assert_eq!((whole.across.values.len(), whole.of_rows), (ROWS, ROWS));
    }

    #[test]
    fn rows_that_repeat_the_time_are_passed_over() {
        assert_eq!(ascending(&[0.0, 0.1, 0.1, f64::NAN, 0.05, 0.2]), [0, 1, 5]);
    }

    #[test]
    fn figures_beyond_the_room_stay_drawings() {
        let (first, second) = (long(300), long(3000));
        let weight = |room: usize| {
            let mut blocks = Blocks::default();
            let figures = [("first.svg", &first), ("second.svg", &second), ("third.svg", &first)];
            let (json, left) = embedded(figures.into_iter(), &mut blocks, room);
            let there = figures.map(|(file, _)| json.contains(file));
            assert_eq!(left, there.iter().filter(|there| !**there).count());
            there
        };
        assert_eq!(weight(usize::MAX), [true; 3]);
        let lines = second.panels.iter().flat_map(|panel| &panel.lines);
        let mut alone = Blocks::default();
        let block = alone.add(&packed(lines.flat_map(|line| &line.values), SHOWN));
        let larger = alone.size(block);
        // The large one alone is too much, and the small one behind it still finds its place.
        assert_eq!(weight(larger), [true, false, true]);
        assert_eq!(weight(0), [false; 3]);
    }

    #[test]
    fn numbers_come_back_from_their_planes_to_seven_digits() {
        let values = [1.5, -2.345_678_9e-7, f64::NAN, 1e300, 15.01, PASSED];
        let bytes = packed(values.iter(), u32::MAX);
        assert_eq!(bytes.len(), 24);
        let number = |k: usize| f32::from_le_bytes([0, 1, 2, 3].map(|plane| bytes[plane * values.len() + k]));
        assert_eq!(number(0), 1.5);
        assert!((f64::from(number(1)) / values[1] - 1.0).abs() < f64::from(f32::EPSILON) / 2.0);
        assert!(number(2).is_nan() && number(3).is_nan() && number(5).is_infinite());
        assert_eq!(number(4), 15.01);
    }

    #[test]
    fn what_is_drawn_keeps_five_digits_and_its_last_byte_is_zero_or_half() {
        let values = [1.5, -2.345_678_9e-7, f64::NAN, f64::from(f32::MAX), 15.01, PASSED, 0.0];
        let bytes = packed(values.iter(), SHOWN);
        let number = |k: usize| f32::from_le_bytes([0, 1, 2, 3].map(|plane| bytes[plane * values.len() + k]));
        for k in [0, 1, 3, 4] {
            assert!((f64::from(number(k)) / values[k] - 1.0).abs() < 8e-6, "{}", number(k));
        }
        assert!(number(2).is_nan() && number(5).is_infinite() && number(6) == 0.0);
        assert!([0, 1, 4].iter().all(|&k| bytes[k] & 0x7f == 0));
    }
}
