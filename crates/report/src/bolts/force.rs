//! Figure of the force along the bolt of each group that carries most.

use tremolite_results::{BoltLine, BoltLines, Summary};

use crate::chapter::figure::{Block, Figure};
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, LINES, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::say;
use crate::quantities::units::Kind;
use crate::source::Source;

/// Bolts that are longer than this many times another are drawn apart: anchors and bars of a lining would hide the others.
const ALIKE: f64 = 3.0;

/// The worst bolt of a group.
struct Worst<'a> {
    name: &'a str,
    bolt: u32,
    own: Vec<&'a BoltLine>,
}

impl Worst<'_> {
    fn length(&self) -> f64 {
        self.own.iter().map(|line| line.at[1]).fold(0.0, f64::max)
    }
}

/// The block; nothing where no bolt carries anything. `when` is in words, and whether that is in the earthquake.
pub fn block(source: &Source, lines: &BoltLines, facts: &Summary, when: (&str, bool)) -> Option<Block> {
    let language = source.language;
    let worst = |(group, name)| {
        let bolt = hardest(lines, group)?;
        let own = lines.lines.iter().filter(|line| line.group == group && line.bolt == bolt).collect();
        Some(Worst { name, bolt, own })
    };
    let names = lines.groups.iter().map(String::as_str).enumerate();
    let mut families: Vec<Vec<Worst>> = Vec::new();
    for worst in names.filter_map(worst) {
        let length = worst.length();
        let alike = |family: &&mut Vec<Worst>| {
            let other = family[0].length();
            family.len() < LINES.len() && length <= ALIKE * other && other <= ALIKE * length
        };
        match families.iter_mut().find(alike) {
            Some(family) => family.push(worst),
            None => families.push(vec![worst]),
        }
    }
    if families.is_empty() {
        return None;
    }
    let figures = families.iter().take(MOST).enumerate();
    let figures = figures.map(|(k, family)| figure(source, family, facts, when, k)).collect();
    let heading = say!(language, "Force along the bolts that carry most");
    Some(Block { heading, figures, ..Block::default() })
}

/// Figures beyond these say nothing new.
const MOST: usize = 3;

fn figure(
    source: &Source,
    family: &[Worst],
    facts: &Summary,
    (when, shaken): (&str, bool),
    number: usize,
) -> Figure {
    let language = source.language;
    let (mut curves, mut named) = (Vec::new(), Vec::new());
    for (colour, Worst { name, bolt, own }) in family.iter().enumerate() {
        let label = say!(language, "{group}, bolt {bolt}", group = name, bolt = bolt);
        curves.push(PlotCurve::new(label, colour, Pen::Curve, steps(own, |line| line.force)));
        curves.push(PlotCurve::new("", colour, Pen::Dashed, steps(own, |line| line.force_max)));
        let yields =
            facts.parts.bolts.get(*name).map(|group| group.yield_force).filter(|force| force.is_finite());
        let named_at = |force| {
            say!(language, "{group} at {force}", group = name, force = source.quantity(Kind::Force, force))
        };
        named.extend(yields.map(named_at));
    }
    let ((_, far), (low, high)) = plot::ranges(&curves);
    let scale = source.scale(Kind::Force);
    for point in curves.iter_mut().flat_map(|curve| curve.pieces.iter_mut().flatten()) {
        point.1 *= scale.factor;
    }
    let title = scale.labelled(&say!(language, "force, tension positive"));
    let mut svg = Svg::new(WIDTH);
    let top = plot::title(&mut svg, (LEFT, 0.0), WIDTH - LEFT - RIGHT, &title, &curves) + 6.0;
    let axes = Axes {
        left: LEFT,
        right: WIDTH - RIGHT,
        top,
        bottom: top + 240.0,
        across: Ticks::within(0.0, far.max(1e-9), 10),
        up: Ticks::around((low * scale.factor).min(0.0), (high * scale.factor).max(0.0), 6),
    };
    plot::draw(&mut svg, &axes, &curves);
    let along = say!(language, "from the head (m)");
    svg.text((WIDTH - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &along);
    let mut caption = match (number, shaken) {
        (0, true) => say!(
            language,
            "Of each group the bolt that came nearest to yield, or carries most where none yields: full line {when}, dashed \
             that of largest size in any step since the earthquake began. A force that falls to nothing at both ends is \
             carried by the bond; one that is large at the head hangs on the plate.",
            when = when
        ),
        (0, false) => say!(
            language,
            "Of each group the bolt that came nearest to yield, or carries most where none yields: full line {when}, dashed \
             that of largest size in any step since the stage began. A force that falls to nothing at both ends is carried \
             by the bond; one that is large at the head hangs on the plate.",
            when = when
        ),
        _ => say!(language, "The same of those of another length."),
    };
    if !named.is_empty() {
        let list = named.join(&say!(language, "; "));
        caption.push_str(&say!(language, " Yield: {list}.", list = list));
    }
    let description = say!(language, "force over the distance from the head");
    let svg = svg.finish(axes.bottom + 42.0, &title, &description);
    let file = if number == 0 { "bolts-force.svg".into() } else { format!("bolts-force-{}.svg", number + 1) };
    Figure {
        heading: say!(language, "Force along the bolts that carry most"),
        file,
        svg,
        caption,
        curves: None,
        narrow: None,
    }
}

/// The number of the bolt of a group that came nearest to yield, or carried most; none where all carry nothing.
fn hardest(lines: &BoltLines, group: usize) -> Option<u32> {
    let own = lines.lines.iter().filter(|line| line.group == group && line.force_max != 0.0);
    let load = |line: &BoltLine| (line.force_over_yield_max, line.force_max.abs());
    let most = own.max_by(|a, b| {
        let ((over_a, force_a), (over_b, force_b)) = (load(a), load(b));
        over_a.total_cmp(&over_b).then(force_a.total_cmp(&force_b))
    });
    most.map(|line| line.bolt)
}

/// A force that is constant in each segment; broken where segments do not follow one another.
fn steps(own: &[&BoltLine], force: impl Fn(&BoltLine) -> f64) -> Vec<(f64, f64)> {
    let mut points: Vec<(f64, f64)> = Vec::new();
    let mut end = f64::NAN;
    for line in own {
        let value = if line.state == 4 { f64::NAN } else { force(line) };
        if !points.is_empty() && (line.at[0] - end).abs() > 1e-3 {
            points.push((end, f64::NAN));
        }
        points.extend(line.at.map(|at| (at, value)));
        end = line.at[1];
    }
    points
}

#[cfg(test)]
mod tests {
    use super::*;

    fn line(at: [f64; 2], force: f64, state: u8) -> BoltLine {
        BoltLine { at, force, force_max: force.abs(), state, ..BoltLine::default() }
    }

    #[test]
    fn a_force_is_level_in_a_segment_and_breaks_where_something_is_missing() {
        let all = [
            line([0.0, 1.0], 5.0, 0),
            line([1.0, 2.0], 7.0, 1),
            line([3.0, 4.0], 2.0, 0),
            line([4.0, 5.0], 9.0, 4),
        ];
        let points = steps(&all.iter().collect::<Vec<_>>(), |line| line.force);
        let drawn: Vec<_> = points.iter().filter(|p| p.1.is_finite()).copied().collect();
        assert_eq!(drawn, [(0.0, 5.0), (1.0, 5.0), (1.0, 7.0), (2.0, 7.0), (3.0, 2.0), (4.0, 2.0)]);
        assert!(points[4].1.is_nan() && points[7].1.is_nan());
    }

    #[test]
    fn a_group_that_carries_nothing_has_no_curve() {
        let lines = BoltLines { groups: vec!["idle".into()], lines: vec![line([0.0, 1.0], 0.0, 0)] };
        assert!(hardest(&lines, 0).is_none());
    }
}
