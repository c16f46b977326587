//! What columns a path may have, by the kind of law that it is for.

use tremolite_case::units;
use tremolite_laws::interfaces::INTERFACES;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::{Dimension, LawInfo};

/// What a column may hold.
struct Quantity {
    name: &'static str,
    dimension: Dimension,
}

/// A component of a path: a motion, and the stress that works on it.
pub struct Component {
    motion: Quantity,
    stress: Quantity,
    /// Whether the stress may be prescribed in the place of the motion.
    either: bool,
}

/// Columns of the paths of one kind of law; `time` is a column of all.
pub struct Form<const N: usize> {
    /// What its laws are for.
    of: &'static str,
    /// Table of the law file.
    table: &'static str,
    components: [Component; N],
    /// Headers with units, for messages.
    with_units: &'static str,
    /// Laws whose histories may stand in an answer.
    laws: &'static [LawInfo],
}

const fn strain(motion: &'static str, stress: &'static str) -> Component {
    Component {
        motion: Quantity { name: motion, dimension: Dimension::NONE },
        stress: Quantity { name: stress, dimension: Dimension::PRESSURE },
        either: true,
    }
}

const fn way(motion: &'static str, stress: &'static str, either: bool) -> Component {
    let motion = Quantity { name: motion, dimension: Dimension::LENGTH };
    Component { motion, stress: Quantity { name: stress, dimension: Dimension::PRESSURE }, either }
}

/// Strain and stress; shear as the engineering angle.
pub static MATERIAL: Form<6> = Form {
    of: "a material",
    table: "material",
    components: [
        strain("exx", "sxx"),
        strain("eyy", "syy"),
        strain("ezz", "szz"),
        strain("gxy", "sxy"),
        strain("gyz", "syz"),
        strain("gzx", "szx"),
    ],
    with_units: "time [s], sxx [MPa]",
    laws: MATERIALS,
};

/// Gap and slip, pressure and shear.
pub static INTERFACE: Form<3> = Form {
    of: "an interface",
    table: "interface",
    components: [way("gap", "pressure", true), way("slip1", "shear1", false), way("slip2", "shear2", false)],
    with_units: "time [s], gap [mm]",
    laws: INTERFACES,
};

impl<const N: usize> Form<N> {
    /// Names of the motions.
    pub fn motions(&self) -> [&'static str; N] {
        self.components.each_ref().map(|c| c.motion.name)
    }

    /// Names of the stresses.
    pub fn stresses(&self) -> [&'static str; N] {
        self.components.each_ref().map(|c| c.stress.name)
    }

    /// A line of names.
    pub fn names(&self) -> String {
        format!("time,{}", self.motions().join(","))
    }

    pub fn with_units(&self) -> &'static str {
        self.with_units
    }

    fn place(&self, name: &str) -> Option<(Place, Dimension)> {
        if name == "time" {
            return Some((Place::Time, Dimension::TIME));
        }
        self.components.iter().enumerate().find_map(|(k, c)| match name {
            _ if name == c.motion.name => Some((Place::Motion(k), c.motion.dimension)),
            _ if name == c.stress.name => Some((Place::Stress(k), c.stress.dimension)),
            _ => None,
        })
    }

    /// A header `name` or `name [unit]`.
    fn column(&self, header: &str) -> Result<PathColumn, String> {
        let (name, unit) = split(header);
        let Some((place, dimension)) = self.place(&name) else {
            let kept = self.laws.iter().any(|law| law.history.iter().any(|c| c.name == name));
            return if kept {
                Ok(PathColumn { place: Place::Ignored, factor: 1.0 })
            } else {
                Err(self.unknown(&name))
            };
        };
        if unit.is_empty() {
            return Ok(PathColumn { place, factor: 1.0 });
        }
        let inside = unit.strip_prefix('[').and_then(|u| u.strip_suffix(']')).ok_or_else(|| {
            format!("'{}' behind {name} is no unit; write {name} or {name} [unit]", shown(unit))
        })?;
        let factor =
            units::parse_unit(inside, dimension).map_err(|e| format!("{name}: {e}; {}", e.remedy(&name)))?;
        Ok(PathColumn { place, factor })
    }

    fn unknown(&self, name: &str) -> String {
        let columns = self.components.iter().map(|c| match c.either {
            true => format!("{} (or {})", c.motion.name, c.stress.name),
            false => c.motion.name.to_owned(),
        });
        let known = format!("columns are time, {}", columns.collect::<Vec<_>>().join(", "));
        match name {
            "exy" | "eyz" | "ezx" | "exz" | "eyx" | "ezy" if self.table == MATERIAL.table => {
                format!(
                    "'{name}' is no column of a path; shear is the engineering angle: gxy = 2 exy, gyz, gzx"
                )
            }
            _ if name.parse::<f64>().is_ok() => {
                format!("a line of names is missing above the numbers: {}", self.names())
            }
            _ => match owner(name) {
                Some((of, table)) => format!(
                    "'{name}' belongs to the path of {of}, and the law is that of {}; give a law file with [{table}], \
                     or the path of {}: {known}",
                    self.of, self.of
                ),
                None => format!("'{}' is no column of a path; {known}", shown(name)),
            },
        }
    }
}

/// What the laws are for whose paths have a column, and the table of their law file.
fn owner(name: &str) -> Option<(&'static str, &'static str)> {
    let of_material = MATERIAL.place(name).map(|_| (MATERIAL.of, MATERIAL.table));
    of_material.or_else(|| INTERFACE.place(name).map(|_| (INTERFACE.of, INTERFACE.table)))
}

/// What a column holds, and what turns its numbers into SI.
pub struct PathColumn {
    pub place: Place,
    pub factor: f64,
}

#[derive(Clone, Copy, PartialEq)]
pub enum Place {
    Time,
    Motion(usize),
    Stress(usize),
    /// Part of an answer, not of a path.
    Ignored,
}

/// What a file says above its numbers.
pub struct Header<const N: usize> {
    pub separator: char,
    pub columns: Vec<PathColumn>,
    /// Components whose stress is prescribed.
    pub by_stress: [bool; N],
    /// Names of the columns that belong to an answer.
    pub ignored: Vec<String>,
}

impl<const N: usize> Header<N> {
    /// Reads the line of names.
    ///
    /// # Errors
    /// What is wrong, with the way out.
    pub fn read(header: &str, form: &Form<N>) -> Result<Self, String> {
        let separator = [',', ';', '\t'].into_iter().find(|c| header.contains(*c)).unwrap_or(',');
        let names = || fields(header, separator);
        let mut columns: Vec<PathColumn> = names().map(|name| form.column(name)).collect::<Result<_, _>>()?;
        let has = |place| columns.iter().any(|c| c.place == place);
        // An answer: its motions are a path, its stresses what came of them.
        let answer = (0..N).all(|k| has(Place::Motion(k)) && has(Place::Stress(k)));
        let by_stress = prescribed(&columns, form, answer)?;
        for column in &mut columns {
            if matches!(column.place, Place::Stress(k) if !by_stress[k]) {
                column.place = Place::Ignored;
            }
        }
        let ignored = names().zip(&columns).filter(|(_, c)| c.place == Place::Ignored);
        let ignored = ignored.map(|(name, _)| split(name).0).collect();
        Ok(Header { separator, columns, by_stress, ignored })
    }
}

/// The components whose stress is prescribed.
fn prescribed<const N: usize>(
    columns: &[PathColumn],
    form: &Form<N>,
    answer: bool,
) -> Result<[bool; N], String> {
    let count = |place: Place| columns.iter().filter(|c| c.place == place).count();
    let twice = |name: &str| Err(format!("the column {name} is there twice; keep one"));
    match count(Place::Time) {
        0 => return Err("there is no column time; add it, in s".into()),
        1 => {}
        _ => return twice("time"),
    }
    let mut by_stress = [false; N];
    for (k, Component { motion, stress, either }) in form.components.iter().enumerate() {
        let (motion, stress) = (motion.name, stress.name);
        match (count(Place::Motion(k)), count(Place::Stress(k)), either) {
            (2.., _, _) => return twice(motion),
            (_, 2.., _) => return twice(stress),
            (0, 1, true) => by_stress[k] = true,
            (0, 0, true) => {
                return Err(format!(
                    "neither {motion} nor {stress} is there; add the one to be prescribed, with zeros if it is to stay zero"
                ));
            }
            (0, 1, false) => {
                return Err(format!(
                    "{stress} cannot be prescribed, and {motion} is not there; add {motion}"
                ));
            }
            (0, _, _) => {
                return Err(format!("there is no column {motion}; add it, with zeros if it is to stay zero"));
            }
            (_, 1, true) if !answer => {
                return Err(format!("{motion} and {stress} are both there; keep the one to be prescribed"));
            }
            _ => {}
        }
    }
    Ok(by_stress)
}

/// A line without the separator that some programs put behind the last field.
pub fn fields(line: &str, separator: char) -> impl Iterator<Item = &str> + Clone {
    line.strip_suffix(separator).unwrap_or(line).split(separator)
}

/// Name in small letters, and unit in brackets if there is one: `time [s]`, `Time`, `sxx[MPa]`.
fn split(header: &str) -> (String, &str) {
    let header = header.trim().trim_matches('"').trim();
    let end = header.find(|c: char| c.is_whitespace() || c == '[').unwrap_or(header.len());
    (header[..end].to_ascii_lowercase(), header[end..].trim())
}

/// A piece of a file, safe and short enough for a message.
pub fn shown(text: &str) -> String {
    text.chars().take(30).flat_map(char::escape_debug).collect()
}
