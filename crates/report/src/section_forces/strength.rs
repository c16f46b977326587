//! Figure of moment over thrust against the strength of the plain section: where it cracks, and what it can bear at all.
//!
//! Both are made dimensionless by the section's own thickness t and the concrete's compressive strength f_c, so that walls
//! and crown of unlike thickness share one diagram: n = N/(f_c t), m = M/(f_c t²). A section that is straight and elastic
//! cracks where a fibre's n ± 6m reaches f_t/f_c, and its concrete reaches f_c where n ± 6m = −1. Cracked, without
//! tension, and with f_c over the whole of the compressed part it bears m = ½|n|(1 − |n|) at most. Plain concrete bears what
//! lies within either.

use tremolite_results::{EFFECTIVE, MaterialFacts, Summary};

use crate::chapter::figure::Figure;
use crate::drawing::axes::Axes;
use crate::drawing::plot::{self, LEFT, NARROW, Pen, PlotCurve, RIGHT, WIDTH};
use crate::drawing::svg::{Anchor, Style, Svg};
use crate::drawing::ticks::Ticks;
use crate::language::say;
use crate::quantities::units::Kind;
use crate::section_forces::stations::{Lining, Station};
use crate::source::Source;

/// The material that a group is made of; nothing where the summary does not say.
fn material_of<'a>(group: &str, facts: &'a Summary) -> Option<&'a MaterialFacts> {
    let made = |names: &str| names.split(", ").any(|name| name == group);
    facts.computed.materials.values().find(|m| m.groups.iter().any(|g| made(&g.names)))
}

/// Static strengths of a lining's concrete (Pa).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strength {
    pub tension: f64,
    pub compression: f64,
}

impl Strength {
    /// Of the material that the group is made of; nothing where the summary does not say.
    pub fn of(group: &str, facts: &Summary) -> Option<Self> {
        // Forces of effective stress have the group's name and a word more.
        let group = group.strip_suffix(EFFECTIVE).unwrap_or(group);
        let material = material_of(group, facts)?;
        let value = |name: &str| material.values.iter().find(|v| v.name == name).map(|v| v.value);
        let found =
            Strength { tension: value("tensile_strength")?, compression: value("compressive_strength")? };
        (found.tension > 0.0 && found.compression > 0.0).then_some(found)
    }

    /// Whether no fibre of an elastic section leaves its strength.
    pub fn sound(self, [n, m]: [f64; 2]) -> bool {
        let most = 6.0 * m.abs();
        n + most <= self.tension / self.compression && n - most >= -1.0
    }

    /// Whether plain concrete bears it: uncracked, or cracked with what is left of the section.
    pub fn bears(self, state: [f64; 2]) -> bool {
        self.sound(state) || Strength::cracked_bears(state)
    }

    /// Whether a cracked section without tension can bear it.
    fn cracked_bears([n, m]: [f64; 2]) -> bool {
        n <= 0.0 && m.abs() <= 0.5 * n.abs() * (1.0 - n.abs())
    }

    /// The border of [`Strength::sound`], closed.
    fn elastic(self) -> Vec<(f64, f64)> {
        let cracks = self.tension / self.compression;
        // Where both limits meet: n + 6m = f_t/f_c, n − 6m = −1.
        let (n, m) = (0.5 * (cracks - 1.0), (1.0 + cracks) / 12.0);
        vec![(cracks, 0.0), (n, m), (-1.0, 0.0), (n, -m), (cracks, 0.0)]
    }

    /// The border of [`Strength::cracked_bears`], closed.
    fn ultimate() -> Vec<(f64, f64)> {
        let upper = (0..=60).map(|k| f64::from(k) / 60.0).map(|n| (-n, 0.5 * n * (1.0 - n)));
        let lower: Vec<(f64, f64)> = upper.clone().rev().map(|(n, m)| (n, -m)).collect();
        upper.chain(lower).collect()
    }
}

/// Thrust and moment that occurred together, dimensionless: when the stages are done, and at the extremes of both.
fn states(station: &Station, strength: Strength) -> (Option<[f64; 2]>, Vec<[f64; 2]>) {
    let t = station.thickness;
    let state = |n: f64, m: f64| {
        let found = [n / (strength.compression * t), m / (strength.compression * t * t)];
        found.iter().all(|x| x.is_finite()).then_some(found)
    };
    let shaken = [station.least, station.most].into_iter().flatten();
    let together = shaken.flat_map(|e| [state(e.thrust, e.forces[1]), state(e.forces[0], e.moment)]);
    (state(station.after[0], station.after[1]), together.flatten().collect())
}

/// The figure, or a sentence why there is none.
pub fn figure(source: &Source, lining: &Lining, facts: &Summary, suffix: &str) -> Result<Figure, String> {
    let language = source.language;
    let strength = Strength::of(&lining.name, facts).ok_or_else(|| {
        let name = lining.name.strip_suffix(EFFECTIVE).unwrap_or(&lining.name);
        match material_of(name, facts) {
            Some(material) => say!(
                language,
                "No strength is known for {lining} (law {law}). Add a [[section]] to judge it.",
                lining = name,
                law = material.law
            ),
            None => say!(language, "No strength is known for {lining}.", lining = name),
        }
    })?;
    let all: Vec<_> = lining.stations.iter().map(|s| states(s, strength)).collect();
    let after: Vec<[f64; 2]> = all.iter().filter_map(|(after, _)| *after).collect();
    let shaken: Vec<[f64; 2]> = all.iter().flat_map(|(_, shaken)| shaken.clone()).collect();
    if after.is_empty() && shaken.is_empty() {
        return Err(say!(
            language,
            "sections.csv holds no thickness and no thrust at the time of the largest moment."
        ));
    }
    let points = |states: &[[f64; 2]]| states.iter().map(|[n, m]| (*n, *m)).collect::<Vec<_>>();
    let mut curves = vec![
        PlotCurve::new(
            say!(language, "elastic section: a fibre reaches f_t or f_c"),
            1,
            Pen::Curve,
            strength.elastic(),
        ),
        PlotCurve::new(
            say!(language, "cracked section: no tension, f_c in compression"),
            1,
            Pen::Dashed,
            Strength::ultimate(),
        ),
    ];
    if !shaken.is_empty() {
        let name = say!(language, "largest M or N in the earthquake, with the other at that instant");
        curves.push(PlotCurve::new(name, 6, Pen::Dots, points(&shaken)));
    }
    if !after.is_empty() {
        curves.push(PlotCurve::new(&lining.after, 3, Pen::Dots, points(&after)));
    }
    let ((left, right), (low, high)) = plot::ranges(&curves);
    let title = say!(language, "{lining}: moment over thrust against strength", lining = lining.name);
    let below = say!(language, "N / (f_c t), tension positive; upwards M / (f_c t²)");
    let drawn = |width: f64, heading: &str| {
        let mut svg = Svg::new(width);
        let top = plot::title(&mut svg, (LEFT, 0.0), width - LEFT - RIGHT, heading, &curves);
        let axes = Axes {
            left: LEFT,
            right: width - RIGHT,
            top,
            bottom: top + if width < WIDTH { 250.0 } else { 320.0 },
            across: Ticks::around(left, right, if width < WIDTH { 6 } else { 10 }),
            up: Ticks::around(low, high, 7),
        };
        plot::draw(&mut svg, &axes, &curves);
        svg.text((width - RIGHT, axes.bottom + 34.0), Anchor::End, 12.0, Style::Muted, &below);
        svg.finish(axes.bottom + 42.0, &title, &below)
    };
    let (svg, narrow) = (drawn(WIDTH, &title), Some(drawn(NARROW, "")));
    let count =
        |states: &[[f64; 2]], fine: &dyn Fn([f64; 2]) -> bool| states.iter().filter(|s| !fine(**s)).count();
    let beyond = |fine: &dyn Fn([f64; 2]) -> bool| {
        let each = all.iter().filter(|(_, shaken)| !shaken.iter().all(|s| fine(*s)));
        each.count()
    };
    let mut caption = say!(
        language,
        "f_c {compression} and f_t {tension}, static, t the thickness at each of {stations} stations. Outside the full line an \
         uncracked section cracks or crushes; a cracked one bears what lies inside the dashed line. Outside both plain concrete \
         cannot bear what is there, and what keeps it is reinforcement, which the lines leave out, or strength that grows with \
         the rate.",
        compression = source.quantity(Kind::Stress, strength.compression),
        tension = source.quantity(Kind::Stress, strength.tension),
        stations = lining.stations.len(),
    );
    if !after.is_empty() {
        caption.push_str(&say!(
            language,
            " Counted over the rows of sections.csv: when the stages are done {elastic} stations lie outside the full line, {ultimate} outside both.",
            elastic = count(&after, &|s| strength.sound(s)),
            ultimate = count(&after, &|s| strength.bears(s)),
        ));
    }
    if !shaken.is_empty() {
        caption.push_str(&say!(
            language,
            " At one of those extremes, counted over the same file: {elastic} and {ultimate}. There may be more cracks: N and M contain no stress along the cavern, and a cracked section no longer carries the forces that cracked it.",
            elastic = beyond(&|s| strength.sound(s)),
            ultimate = beyond(&|s| strength.bears(s)),
        ));
    }
    Ok(Figure {
        heading: title,
        file: format!("section-strength{suffix}.svg"),
        svg,
        caption,
        curves: None,
        narrow,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const CONCRETE: Strength = Strength { tension: 1.0, compression: 10.0 };

    /// By hand: t = 0.5 m, N = −1 MN/m at an eccentricity e: fibres −2 (1 ± 6e/t) MPa.
    #[test]
    fn an_elastic_section_cracks_where_its_fibre_reaches_the_tensile_strength() {
        let state = |e: f64| [-1e6 / (10e6 * 0.5), -1e6 * e / (10e6 * 0.25)];
        // −2 (1 − 12e) = 1 at e = 0.125 m.
        assert!(CONCRETE.sound(state(0.124)) && !CONCRETE.sound(state(0.126)));
        assert!(!CONCRETE.sound([-1.01, 0.0]) && !CONCRETE.sound([0.101, 0.0]));
        // The block: N = f_c (t − 2e), e = ½(t − N/f_c) = 0.2 m.
        assert!(Strength::cracked_bears(state(0.199)) && !Strength::cracked_bears(state(0.201)));
    }

    /// Almost no thrust and a small moment: outside the dashed line, and yet nothing cracks.
    #[test]
    fn what_the_tensile_strength_holds_is_borne() {
        let state = [-1e-4, 1e-3];
        assert!(!Strength::cracked_bears(state) && CONCRETE.sound(state) && CONCRETE.bears(state));
        assert!(!CONCRETE.bears([-0.05, 0.06]) && CONCRETE.bears([-0.5, 0.12]));
    }

    #[test]
    fn the_lines_are_where_the_judgement_turns() {
        for (n, m) in CONCRETE.elastic() {
            assert!(
                CONCRETE.sound([0.999 * n, 0.999 * m]) && !CONCRETE.sound([1.001 * n, 1.001 * m]),
                "{n} {m}"
            );
        }
        for (n, m) in Strength::ultimate().into_iter().filter(|(_, m)| *m != 0.0) {
            assert!(
                Strength::cracked_bears([n, 0.999 * m]) && !Strength::cracked_bears([n, 1.001 * m]),
                "{n} {m}"
            );
        }
    }
}
