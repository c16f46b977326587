//! Parameters of laws as data: what the case reader, the help and the tests all go by.

use std::collections::BTreeMap;

mod reading;

pub(crate) use reading::Reading;

/// Physical dimension as exponents of metre, kilogram, second and plane angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dimension {
    pub length: i8,
    pub mass: i8,
    pub time: i8,
    pub angle: i8,
}

impl Dimension {
    const fn of(length: i8, mass: i8, time: i8) -> Self {
        Dimension { length, mass, time, angle: 0 }
    }

    pub const NONE: Self = Self::of(0, 0, 0);
    pub const LENGTH: Self = Self::of(1, 0, 0);
    pub const TIME: Self = Self::of(0, 0, 1);
    /// Frequency or strain rate, 1/s.
    pub const RATE: Self = Self::of(0, 0, -1);
    pub const VELOCITY: Self = Self::of(1, 0, -1);
    pub const ACCELERATION: Self = Self::of(1, 0, -2);
    /// Stress or modulus, Pa.
    pub const PRESSURE: Self = Self::of(-1, 1, -2);
    pub const DENSITY: Self = Self::of(-3, 1, 0);
    /// Weight per volume, N/m³.
    pub const UNIT_WEIGHT: Self = Self::of(-2, 1, -2);
    pub const FORCE: Self = Self::of(1, 1, -2);
    /// Energy per area, N/m.
    pub const FRACTURE_ENERGY: Self = Self::of(0, 1, -2);
    /// Stiffness per area, Pa/m.
    pub const STIFFNESS: Self = Self::of(-2, 1, -2);
    pub const ANGLE: Self = Dimension { length: 0, mass: 0, time: 0, angle: 1 };
}

/// What a parameter's value looks like.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Kind {
    /// A number with a dimension, in SI once read.
    Number(Dimension),
    /// One word out of a list.
    Word(&'static [&'static str]),
    /// A table: columns of numbers, as many in each, by the columns' own entries.
    Table(&'static [Parameter]),
    /// A table with one number for each of these entries.
    Set(&'static [Parameter]),
}

/// Whether a parameter may be left out.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Need {
    Required,
    /// This value is used, and the run lists it as defaulted.
    Number(f64),
    /// This word is used, and the run lists it as defaulted.
    Word(&'static str),
    /// Nothing is used; the text says what the law does then.
    Optional(&'static str),
    /// Required where a law is driven alone; in a model the program chooses it (see [`LawInfo::chosen`]), by what the text
    /// says.
    Chosen(&'static str),
}

/// One parameter of a law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Parameter {
    pub name: &'static str,
    pub kind: Kind,
    pub need: Need,
    /// Meaning, with the symbol of NOTATION.md.
    pub doc: &'static str,
}

/// A parameter's value, in SI.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    Number(f64),
    Word(String),
    /// The columns that are given; of a set, each with one number.
    Table(BTreeMap<String, Vec<f64>>),
}

/// The values of a law's parameters by name, in SI, defaults filled in.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Values(pub BTreeMap<String, Value>);

impl Values {
    /// The same values with one more number.
    pub fn with(mut self, name: &str, value: f64) -> Self {
        self.0.insert(name.to_owned(), Value::Number(value));
        self
    }

    /// The same values with one more table.
    pub fn with_table(mut self, name: &str, columns: &[(&str, &[f64])]) -> Self {
        let columns = columns.iter().map(|(column, numbers)| ((*column).to_owned(), numbers.to_vec()));
        self.0.insert(name.to_owned(), Value::Table(columns.collect()));
        self
    }

    /// A number, if it is given.
    pub fn optional(&self, name: &str) -> Option<f64> {
        match self.0.get(name) {
            Some(Value::Number(x)) => Some(*x),
            _ => None,
        }
    }

    /// A required number.
    ///
    /// # Errors
    /// If it is missing, a word, or not finite.
    pub fn number(&self, name: &'static str) -> Result<f64, BadParameter> {
        match self.optional(name) {
            Some(x) if x.is_finite() => Ok(x),
            Some(_) => Err(BadParameter::new(name, "is not a finite number", "give a finite value")),
            None => Err(BadParameter::new(name, "is missing", "give it in the law's table")),
        }
    }

    /// A number that satisfies a condition.
    ///
    /// # Errors
    /// As [`Values::number`], and with the words of `problem` and `remedy` where the condition fails.
    pub fn number_where(
        &self,
        name: &'static str,
        holds: impl Fn(f64) -> bool,
        problem: &str,
        remedy: &str,
    ) -> Result<f64, BadParameter> {
        let x = self.number(name)?;
        if holds(x) { Ok(x) } else { Err(BadParameter::new(name, problem, remedy)) }
    }

    /// A word, if it is given.
    pub fn word(&self, name: &str) -> Option<&str> {
        match self.0.get(name) {
            Some(Value::Word(w)) => Some(w),
            _ => None,
        }
    }

    /// A table's columns by their names, if it is given.
    pub fn table(&self, name: &str) -> Option<&BTreeMap<String, Vec<f64>>> {
        match self.0.get(name) {
            Some(Value::Table(columns)) => Some(columns),
            _ => None,
        }
    }
}

/// A constant that a law works with and that its parameters do not show: derived from them, or chosen by a rule.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Derived {
    /// That of the parameter whose place it takes, where there is one.
    pub name: &'static str,
    /// Smallest and largest value in SI over the extents asked for; equal where the element's size is without effect.
    pub range: [f64; 2],
    /// SI unit as in [`Column`]; `1` for a pure number.
    pub unit: &'static str,
    /// Meaning, with the symbol of NOTATION.md.
    pub doc: &'static str,
}

impl Derived {
    /// A constant of one value.
    pub const fn new(name: &'static str, value: f64, unit: &'static str, doc: &'static str) -> Self {
        Derived { name, range: [value; 2], unit, doc }
    }

    /// A constant that goes by the element's extent: its values at two of them, in either order.
    pub fn between(name: &'static str, [a, b]: [f64; 2], unit: &'static str, doc: &'static str) -> Self {
        Derived { name, range: [a.min(b), a.max(b)], unit, doc }
    }
}

/// A parameter's value that a law refuses.
#[derive(Clone, Debug, PartialEq)]
pub struct BadParameter {
    /// The offending key; of a table's column, both: `softening.cohesion`.
    pub name: &'static str,
    /// What is wrong, to be read after the key: 'must be below 0.5'.
    pub problem: String,
    /// What to do about it.
    pub remedy: String,
}

impl BadParameter {
    pub fn new(name: &'static str, problem: impl Into<String>, remedy: impl Into<String>) -> Self {
        BadParameter { name, problem: problem.into(), remedy: remedy.into() }
    }
}

impl std::fmt::Display for BadParameter {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} {}; {}", self.name, self.problem, self.remedy)
    }
}

impl std::error::Error for BadParameter {}

/// What a history column means to those who report on it, whatever its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Role {
    /// The law's own business.
    Own,
    /// Damage in tension, 0 sound to 1 broken.
    TensionDamage,
    /// Damage in shear or compression, 0 to 1.
    ShearDamage,
    /// Mean of the damage over the principal directions as the stress now feels it, 0 to 1.
    MeanDamage,
    /// The largest mean damage so far.
    MeanDamagePeak,
    /// How many times the strength in tension was its static one at first damage in tension, since the point was strained fast; 0 before.
    TensionRateFactor,
    /// The same of the strength in compression at first damage in shear or compression.
    ShearRateFactor,
    /// Extent \[m\] across the crack, from first damage on.
    CrackExtent,
    /// Width \[m\] of the widest crack as it is open now, across the element's extent along the crack's present normal.
    CrackWidth,
    /// xx \[m²\] of the openings squared, e⁺·G·e⁺, the five other components behind it (yy, zz, xy, yz, zx): principal values are the squares
    /// of how far cracks are open now, principal directions the normals of these.
    CrackOpenings,
    /// Accumulated plastic strain of shear.
    PlasticShear,
    /// Accumulated plastic strain of tension.
    PlasticTension,
    /// A component of the plastic strain.
    PlasticStrain,
    /// A sum of flags (powers of two) of what the point does and did: shear and tension now 1 and 2, in the past 4 and 8.
    PlasticState,
    /// Energy \[J/m³\] that the law has booked as dissipated.
    Dissipated,
    /// Energy \[J/m³\] that the law has booked as given out beyond what it took.
    Created,
}

/// One history variable of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Column {
    pub name: &'static str,
    /// SI unit, '1' for a pure number.
    pub unit: &'static str,
    pub doc: &'static str,
    pub role: Role,
}

impl Column {
    /// A column that is the law's own business.
    pub const fn new(name: &'static str, unit: &'static str, doc: &'static str) -> Self {
        Column { name, unit, doc, role: Role::Own }
    }

    /// A column that others report on.
    pub const fn with_role(name: &'static str, unit: &'static str, role: Role, doc: &'static str) -> Self {
        Column { name, unit, doc, role }
    }
}

/// Position of the first column of a role.
pub const fn position(columns: &[Column], role: Role) -> Option<usize> {
    let mut k = 0;
    while k < columns.len() {
        if columns[k].role as u8 == role as u8 {
            return Some(k);
        }
        k += 1;
    }
    None
}

/// What a model knows when it chooses parameters of an interface law.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Choice {
    /// Normal stiffness \[Pa/m\] that no state should exceed.
    pub stiffness: f64,
    /// Normal stiffness \[Pa/m\] that the closed, unloaded joint has at least, though some state then exceeds `stiffness`.
    pub least: f64,
    /// Pressure \[Pa\] that is not expected to be exceeded: from there on a law may go straight.
    pub pressure: f64,
}

/// What is known of a law without an instance of it.
#[derive(Clone, Copy)]
pub struct LawInfo {
    /// The word after `law =` in a case.
    pub name: &'static str,
    /// One line for `tremolite list`.
    pub summary: &'static str,
    /// Where the equations come from: key of references.bib and equation numbers.
    pub source: &'static str,
    pub parameters: &'static [Parameter],
    pub history: &'static [Column],
    /// See [`crate::Material::PRESSURE_DEPENDENT`].
    pub pressure_dependent: bool,
    /// See [`crate::Material::DAMAGES`].
    pub damages: bool,
    /// Whether the law accepts these values.
    pub check: fn(&Values) -> Result<(), Vec<BadParameter>>,
    /// The values with what [`Need::Chosen`] leaves open filled in ([`crate::Interface::chosen`]); the same values for a
    /// material.
    pub chosen: fn(&Values, &Choice) -> Values,
}
