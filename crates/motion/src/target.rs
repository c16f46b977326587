//! Spectra that motions are made to fit.

use std::path::Path;

use crate::shown::{rounded, shown};
use crate::{Error, Units};

/// What [`TargetSpectrum::parse`] reads, for messages.
const FORMS: &str = "write \"EN 1998-1 type 1 ground B 2 m/s2\" (type 1 or 2, ground A to E, a_g with its unit), or give a CSV file \
                     with the columns `period [s]` and `sa [m/s2]` or `sa [g]`, the spectrum of any other code by its points: \
                     docs/records.md shows how few do";

/// An elastic response spectrum of pseudo-acceleration, horizontal, that a motion is to have.
#[derive(Debug, Clone, PartialEq)]
pub struct TargetSpectrum {
    /// What to call it.
    pub name: String,
    /// Ratio to critical damping for which it holds, where its source says so.
    pub damping: f64,
    shape: Shape,
}

#[derive(Debug, Clone, PartialEq)]
enum Shape {
    /// ln of period \[s\] and of acceleration \[m/s²\], by rising period.
    Table(Vec<[f64; 2]>),
    /// `en1998`, 3.2.2.2.
    En1998 { a_g: f64, soil: f64, corners: [f64; 3] },
}

/// Ground types A to E: S, T_B, T_C, T_D \[s\] of `en1998`, tables 3.2 (type 1) and 3.3 (type 2).
const GROUND: [[[f64; 4]; 5]; 2] = [
    [
        [1.0, 0.15, 0.4, 2.0],
        [1.2, 0.15, 0.5, 2.0],
        [1.15, 0.2, 0.6, 2.0],
        [1.35, 0.2, 0.8, 2.0],
        [1.4, 0.15, 0.5, 2.0],
    ],
    [
        [1.0, 0.05, 0.25, 1.2],
        [1.35, 0.05, 0.25, 1.2],
        [1.5, 0.1, 0.25, 1.2],
        [1.8, 0.1, 0.3, 1.2],
        [1.6, 0.05, 0.25, 1.2],
    ],
];

/// Where EN 1998-1 ends the elastic spectrum without its annex A \[s\].
const EN1998_LONGEST: f64 = 4.0;

/// Shortest period above 0 of a code's spectrum \[s\]: below lies the peak acceleration of all but the finest records.
const SHORTEST: f64 = 0.02;

impl TargetSpectrum {
    /// A spectrum by points of period (s) and pseudo-acceleration (m/s²), straight between them in logarithms.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] for less than two points, periods that do not rise, or values that are not above 0.
    pub fn of_table(name: impl Into<String>, damping: f64, points: &[[f64; 2]]) -> Result<Self, Error> {
        let name = name.into();
        let wrong = |problem: String| {
            Error::unsuitable(
                format!("target spectrum '{}': {problem}", shown(&name)),
                "give two rows and more of a period in s and an acceleration, periods rising, all above 0",
            )
        };
        if points.len() < 2 {
            return Err(wrong(format!("it has {} points", points.len())));
        }
        if let Some([t, a]) = points.iter().find(|point| !point.iter().all(|x| *x > 0.0 && x.is_finite())) {
            return Err(wrong(format!("the point {t} s, {a} m/s2 is not above 0")));
        }
        if let Some(pair) = points.windows(2).find(|pair| pair[1][0] <= pair[0][0]) {
            return Err(wrong(format!("{} s follows {} s", pair[1][0], pair[0][0])));
        }
        if !(damping > 0.0 && damping < 1.0) {
            return Err(wrong(format!("the damping ratio {damping} is not between 0 and 1")));
        }
        let table = points.iter().map(|point| point.map(f64::ln)).collect();
        Ok(TargetSpectrum { name, damping, shape: Shape::Table(table) })
    }

    /// Reads a table of two columns, `period [s]` and `sa` in a unit of acceleration, as CSV; for 5 % damping.
    ///
    /// # Errors
    /// [`Error::Io`] if the file cannot be read; [`Error::Record`] with the line of what is no such table.
    pub fn read(file: &Path) -> Result<Self, Error> {
        let text =
            std::fs::read_to_string(file).map_err(|source| Error::Io { file: file.to_path_buf(), source })?;
        Self::of_csv(file, &text)
    }

    fn of_csv(file: &Path, text: &str) -> Result<Self, Error> {
        let mut lines = text
            .trim_start_matches('\u{feff}')
            .lines()
            .enumerate()
            .map(|(i, line)| (i + 1, line.trim()))
            .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
        let header = "begin with a line of names and units: period [s], sa [m/s2] or sa [g]";
        let (at, names) =
            lines.next().ok_or_else(|| Error::record(file, 1, "the file has no lines", header))?;
        let names: Vec<&str> = names.split(',').map(str::trim).collect();
        let column = |name: &str| names.iter().position(|n| n.split('[').next().unwrap_or("").trim() == name);
        let unit = |k: usize| names[k].split('[').nth(1).and_then(|u| u.split(']').next()).unwrap_or("");
        let (Some(period), Some(sa)) = (column("period"), column("sa")) else {
            return Err(Error::record(file, at, "the columns `period` and `sa` are not there", header));
        };
        if unit(period) != "s" {
            return Err(Error::record(file, at, "the periods' unit is not [s]", header));
        }
        let factor = unit(sa).parse::<Units>().ok().and_then(Units::factor).ok_or_else(|| {
            Error::record(file, at, format!("'{}' is no unit of acceleration", shown(unit(sa))), header)
        })?;
        let mut points = Vec::new();
        for (at, line) in lines {
            let cells: Vec<&str> = line.split(',').map(str::trim).collect();
            let number =
                |k: usize| cells.get(k).and_then(|cell| cell.parse::<f64>().ok()).filter(|x| x.is_finite());
            let (Some(t), Some(a)) = (number(period), number(sa)) else {
                return Err(Error::record(
                    file,
                    at,
                    "a period and an acceleration are expected",
                    "correct the line",
                ));
            };
            // A peak acceleration may stand at period 0; the table begins behind it.
            if t != 0.0 {
                points.push([t, a * factor]);
            }
        }
        let stem = file.file_stem().map_or_else(String::new, |stem| stem.to_string_lossy().into_owned());
        Self::of_table(stem, 0.05, &points).map_err(|error| {
            let (problem, remedy) = error.message_and_remedy();
            Error::record(file, at, problem, remedy)
        })
    }

    /// The elastic spectrum of `en1998`, 3.2.2.2, for 5 % damping: `kind` 1 or 2, `ground` A to E, design ground
    /// acceleration on type A ground `a_g` (m/s²). Nationally determined parameters are those that the standard recommends.
    ///
    /// # Errors
    /// A sentence that names what is not of the standard.
    pub fn en1998(kind: u8, ground: char, a_g: f64) -> Result<Self, String> {
        let table = match kind {
            1 | 2 => &GROUND[usize::from(kind) - 1],
            _ => return Err(format!("there is no type {kind}; it is 1 or 2")),
        };
        let place = "ABCDE".find(ground.to_ascii_uppercase());
        let [soil, corners @ ..] = *place
            .map(|place| &table[place])
            .ok_or_else(|| format!("there is no ground '{ground}' with a spectrum; it is A, B, C, D or E"))?;
        if !(a_g > 0.0 && a_g.is_finite()) {
            return Err(format!("a_g of {a_g} m/s2 is not above 0"));
        }
        let name =
            format!("EN 1998-1, type {kind}, ground {}, {} m/s2", ground.to_ascii_uppercase(), rounded(a_g));
        Ok(TargetSpectrum { name, damping: 0.05, shape: Shape::En1998 { a_g, soil, corners } })
    }

    /// Reads "EN 1998-1 type 1 ground B 2 m/s2", or else the name of a CSV file.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] with the forms that are read; else those of [`TargetSpectrum::read`].
    pub fn parse(text: &str) -> Result<Self, Error> {
        match Path::new(text).is_file() {
            true => Self::read(Path::new(text)),
            false => Self::parse_code(text),
        }
    }

    /// Reads the words of a code, "EN 1998-1 type 1 ground B 2 m/s2".
    ///
    /// # Errors
    /// [`Error::Unsuitable`] with the forms that are read.
    pub fn parse_code(text: &str) -> Result<Self, Error> {
        let words: Vec<&str> = text.split([' ', ',']).filter(|word| !word.is_empty()).collect();
        let wrong = |problem: String| Error::unsuitable(format!("'{}': {problem}", shown(text)), FORMS);
        match words[..] {
            ["EN", "1998-1", "type", kind, "ground", ground, ref peak @ ..] => {
                let kind = kind.parse().map_err(|_| wrong(format!("'{}' is no type", shown(kind))))?;
                let mut letters = ground.chars();
                let (Some(letter), None) = (letters.next(), letters.next()) else {
                    return Err(wrong(format!("'{}' is no ground", shown(ground))));
                };
                let value = match *peak {
                    [number, unit] => {
                        number.parse::<f64>().ok().zip(unit.parse().ok().and_then(Units::factor))
                    }
                    _ => None,
                };
                let Some((number, factor)) = value else {
                    return Err(wrong("the acceleration a_g is expected with its unit".into()));
                };
                Self::en1998(kind, letter, number * factor).map_err(wrong)
            }
            ["EN" | "NB" | "NB/T" | "GB" | "GB/T" | "DL" | "DL/T" | "SL", ..] => {
                Err(wrong("this is not a spectrum that is known by its words".into()))
            }
            _ => Err(wrong("it is neither a file nor a spectrum".into())),
        }
    }

    /// The shortest and the longest period (s) for which it says something.
    pub fn range(&self) -> [f64; 2] {
        match &self.shape {
            // Two points at least.
            Shape::Table(table) => [table[0][0].exp(), table[table.len() - 1][0].exp()],
            Shape::En1998 { .. } => [SHORTEST, EN1998_LONGEST],
        }
    }

    /// Pseudo-acceleration (m/s²) at a period (s); beyond [`range`](Self::range) that of its end.
    pub fn at(&self, period: f64) -> f64 {
        match &self.shape {
            Shape::Table(table) => {
                let x = period.ln();
                let behind = table.partition_point(|point| point[0] < x).clamp(1, table.len() - 1);
                let [[t0, a0], [t1, a1]] = [table[behind - 1], table[behind]];
                let share = ((x - t0) / (t1 - t0)).clamp(0.0, 1.0);
                // Both ends come out as they were given but for round-off.
                ((1.0 - share) * a0 + share * a1).exp()
            }
            Shape::En1998 { a_g, soil, corners: [b, c, d] } => {
                let t = period.clamp(0.0, EN1998_LONGEST);
                let form = if t <= *b {
                    1.0 + t / b * 1.5
                } else if t <= *c {
                    2.5
                } else if t <= *d {
                    2.5 * c / t
                } else {
                    2.5 * c * d / (t * t)
                };
                a_g * soil * form
            }
        }
    }

    /// The design displacement of the ground d_g = 0.025 a_g S T_C T_D (m) of `en1998`, 3.2.2.4; none of a spectrum by points.
    pub fn design_displacement(&self) -> Option<f64> {
        match self.shape {
            Shape::Table(_) => None,
            Shape::En1998 { a_g, soil, corners: [_, c, d] } => Some(0.025 * a_g * soil * c * d),
        }
    }

    /// The band in which a motion is to fit, of `asked` (s) or all that the spectrum knows, 4 s at most.
    ///
    /// # Errors
    /// [`Error::Unsuitable`] for a band that is none or reaches beyond what is known.
    pub fn band(&self, asked: Option<[f64; 2]>) -> Result<[f64; 2], Error> {
        let [shortest, longest] = self.range();
        let [from, to] = asked.unwrap_or([shortest.max(0.04), longest.min(EN1998_LONGEST)]);
        if !(from > 0.0 && to >= 1.5 * from) {
            return Err(Error::unsuitable(
                format!("{} s to {} s is no band of periods", rounded(from), rounded(to)),
                "give the shorter period first, the longer at least half as long again",
            ));
        }
        let slack = 1e-9;
        if from < shortest * (1.0 - slack) || to > longest * (1.0 + slack) {
            return Err(Error::unsuitable(
                format!(
                    "the band from {} s to {} s reaches beyond '{}', which runs from {} s to {} s",
                    rounded(from),
                    rounded(to),
                    shown(&self.name),
                    rounded(shortest),
                    rounded(longest)
                ),
                "give a band within it",
            ));
        }
        Ok([from, to])
    }
}

/// `count` periods (s) from one to the other, equally spaced in the logarithm, the `shift`th part of a spacing late.
pub(crate) fn spread([from, to]: [f64; 2], count: usize, shift: f64, spacings: usize) -> Vec<f64> {
    let step = (to / from).ln() / spacings as f64;
    (0..count).map(|i| from * ((i as f64 + shift) * step).exp()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_spectrum_of_en_1998_has_its_plateau_corners_and_decays() {
        let target = TargetSpectrum::parse("EN 1998-1 type 1 ground C 0.2 g").unwrap();
        let peak = 0.2 * 9.80665 * 1.15;
        for (period, form) in
            [(0.0, 1.0), (0.1, 1.75), (0.2, 2.5), (0.6, 2.5), (1.2, 1.25), (2.0, 0.75), (4.0, 0.1875)]
        {
            assert!((target.at(period) / (peak * form) - 1.0).abs() < 1e-12, "{period}");
        }
    }

    /// By hand: type 1, ground A has S = 1, T_C = 0.4 s, T_D = 2 s; type 2, ground D has 1.8, 0.3 s, 1.2 s.
    #[test]
    fn the_design_displacement_of_en_1998_is_0_025_a_g_s_t_c_t_d() {
        for (code, exact) in
            [("type 1 ground A 3.2 m/s2", 0.025 * 3.2 * 0.8), ("type 2 ground D 1 m/s2", 0.025 * 1.8 * 0.36)]
        {
            let target = TargetSpectrum::parse(&format!("EN 1998-1 {code}")).unwrap();
            assert!((target.design_displacement().unwrap() / exact - 1.0).abs() < 1e-12, "{code}");
        }
        let table = TargetSpectrum::of_table("t", 0.05, &[[0.1, 1.0], [1.0, 1.0]]).unwrap();
        assert_eq!(table.design_displacement(), None);
    }

    #[test]
    fn a_table_is_straight_in_logarithms_and_keeps_its_points() {
        let text = "# a code's\nperiod [s], sa [g]\n0, 0.1\n0.1, 0.25\n0.4, 0.25\n1.6, 0.0625\n";
        let target = TargetSpectrum::of_csv(Path::new("code.csv"), text).unwrap();
        for (t, a) in [(0.1, 0.25), (0.2, 0.25), (0.8, 0.125), (1.6, 0.0625), (3.0, 0.0625)] {
            assert!((target.at(t) / (a * 9.80665) - 1.0).abs() < 1e-12, "{t}");
        }
        assert!((target.range()[1] - 1.6).abs() < 1e-12);
    }

    #[test]
    fn what_is_no_spectrum_is_refused_with_its_line_or_the_forms() {
        let told = |text: &str| TargetSpectrum::of_csv(Path::new("t.csv"), text).unwrap_err().to_string();
        assert!(told("").contains("line 1"));
        assert!(told("T, Sa\n1, 2\n").contains("period [s]"));
        assert!(told("period [s], sa [m]\n1, 2\n").contains("no unit of acceleration"));
        assert!(told("period [s], sa [g]\n1, 2\nx, 2\n").contains("line 3"));
        assert!(told("period [s], sa [g]\n1, 2\n1, 3\n").contains("follows"));
        for text in
            ["EN 1998-1 type 3 ground A 2 m/s2", "EN 1998-1 type 1 ground S1 1 g", "NB 35047", "no.csv"]
        {
            let told = TargetSpectrum::parse(text).unwrap_err().to_string();
            assert!(told.contains("CSV"), "{told}");
        }
        assert!(TargetSpectrum::en1998(1, 'A', 2.0).unwrap().band(Some([0.1, 5.0])).is_err());
    }
}
