//! The units a case may be written in, and how values are written back.

use tremolite_laws::parameter::Dimension;

/// One unit. Its SI value is `factor · 10^tens`; powers of ten are kept apart so that "7 cm" is exactly 0.07.
pub(super) struct Symbol {
    pub name: &'static str,
    /// Prefixes that engineers use with it. The others are refused: "mPa" is a slip for "MPa".
    pub prefixes: &'static str,
    pub tens: i32,
    pub factor: f64,
    pub dimension: Dimension,
}

const fn unit(name: &'static str, prefixes: &'static str, tens: i32, dimension: Dimension) -> Symbol {
    Symbol { name, prefixes, tens, factor: 1.0, dimension }
}

const fn scaled(name: &'static str, factor: f64, dimension: Dimension) -> Symbol {
    Symbol { name, prefixes: "", tens: 0, factor, dimension }
}

const DEGREE: f64 = std::f64::consts::PI / 180.0;
const MASS: Dimension = Dimension { length: 0, mass: 1, time: 0, angle: 0 };
const ENERGY: Dimension = Dimension { length: 2, mass: 1, time: -2, angle: 0 };

pub(super) const SYMBOLS: &[Symbol] = &[
    unit("m", "nuµμmcdk", 0, Dimension::LENGTH),
    unit("g", "mkM", -3, MASS),
    unit("t", "k", 3, MASS),
    unit("s", "nuµμm", 0, Dimension::TIME),
    scaled("min", 60.0, Dimension::TIME),
    scaled("h", 3600.0, Dimension::TIME),
    unit("Hz", "mk", 0, Dimension::RATE),
    unit("N", "kMG", 0, Dimension::FORCE),
    unit("Pa", "hkMG", 0, Dimension::PRESSURE),
    unit("bar", "mk", 5, Dimension::PRESSURE),
    unit("J", "kMG", 0, ENERGY),
    unit("gal", "m", -2, Dimension::ACCELERATION),
    unit("Gal", "m", -2, Dimension::ACCELERATION),
    scaled("deg", DEGREE, Dimension::ANGLE),
    scaled("°", DEGREE, Dimension::ANGLE),
    unit("rad", "m", 0, Dimension::ANGLE),
    unit("%", "", -2, Dimension::NONE),
    unit("1", "", 0, Dimension::NONE),
];

pub(super) const PREFIXES: &[(char, i32)] = &[
    ('n', -9),
    ('u', -6),
    ('µ', -6),
    ('μ', -6),
    ('m', -3),
    ('c', -2),
    ('d', -1),
    ('h', 2),
    ('k', 3),
    ('M', 6),
    ('G', 9),
];

/// How a dimension is called and written.
pub(super) struct Named {
    pub dimension: Dimension,
    pub name: &'static str,
    pub example: &'static str,
    /// Units for writing: name, SI value, and the smallest magnitude (SI) it is used for. Ascending.
    pub units: &'static [(&'static str, f64, f64)],
}

const WEIGHT_OR_STIFFNESS: &[(&str, f64, f64)] =
    &[("N/m3", 1.0, 0.0), ("kN/m3", 1e3, 1e3), ("MPa/m", 1e6, 1e6), ("GPa/m", 1e9, 1e9)];

pub(super) const NAMED: &[Named] = &[
    Named { dimension: Dimension::NONE, name: "a pure number", example: "0.25", units: &[("", 1.0, 0.0)] },
    Named {
        dimension: Dimension::LENGTH,
        name: "a length",
        example: "0.5 m",
        units: &[("mm", 1e-3, 0.0), ("m", 1.0, 0.1), ("km", 1e3, 1e4)],
    },
    Named {
        dimension: Dimension::TIME,
        name: "a time",
        example: "0.5 s",
        units: &[("ms", 1e-3, 0.0), ("s", 1.0, 0.1)],
    },
    Named { dimension: Dimension::RATE, name: "a rate", example: "0.3 1/s", units: &[("1/s", 1.0, 0.0)] },
    Named {
        dimension: Dimension::VELOCITY,
        name: "a velocity",
        example: "1.2 m/s",
        units: &[("m/s", 1.0, 0.0)],
    },
    Named {
        dimension: Dimension::ACCELERATION,
        name: "an acceleration",
        example: "9.81 m/s2",
        units: &[("m/s2", 1.0, 0.0)],
    },
    Named {
        dimension: Dimension::PRESSURE,
        name: "a stress or modulus",
        example: "10 GPa",
        units: &[("Pa", 1.0, 0.0), ("kPa", 1e3, 1e3), ("MPa", 1e6, 1e6), ("GPa", 1e9, 1e9)],
    },
    Named {
        dimension: Dimension::DENSITY,
        name: "a density",
        example: "2700 kg/m3",
        // Nobody is told a density in t/m3, but some write it.
        units: &[("kg/m3", 1.0, 0.0), ("t/m3", 1e3, f64::INFINITY)],
    },
    // Weight per volume and stiffness per area have one dimension: N/m³ is Pa/m. Which is wanted, the key tells.
    Named {
        dimension: Dimension::UNIT_WEIGHT,
        name: "a unit weight",
        example: "27 kN/m3",
        units: WEIGHT_OR_STIFFNESS,
    },
    Named {
        dimension: Dimension::STIFFNESS,
        name: "a stiffness per area",
        example: "20 GPa/m",
        units: WEIGHT_OR_STIFFNESS,
    },
    Named {
        dimension: Dimension::FORCE,
        name: "a force",
        example: "150 kN",
        units: &[("N", 1.0, 0.0), ("kN", 1e3, 1e3), ("MN", 1e6, 1e6)],
    },
    Named {
        dimension: Dimension::FRACTURE_ENERGY,
        name: "an energy per area",
        example: "130 N/m",
        units: &[("N/m", 1.0, 0.0), ("kN/m", 1e3, 1e4)],
    },
    // Energy per area and force per length have one dimension as well.
    Named {
        dimension: Dimension::FRACTURE_ENERGY,
        name: "a force per length",
        example: "300 kN/m",
        units: &[("N/m", 1.0, 0.0), ("kN/m", 1e3, 1e3), ("MN/m", 1e6, 1e6)],
    },
    Named {
        dimension: Dimension::ANGLE,
        name: "an angle",
        example: "42 deg",
        units: &[("deg", DEGREE, 0.0)],
    },
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_listed_prefix_has_a_power_of_ten() {
        for symbol in SYMBOLS {
            for prefix in symbol.prefixes.chars() {
                assert!(PREFIXES.iter().any(|(c, _)| *c == prefix), "{prefix}{}", symbol.name);
            }
        }
    }

    #[test]
    fn no_prefixed_unit_reads_as_another_unit() {
        let mut all: Vec<String> = SYMBOLS.iter().map(|s| s.name.to_owned()).collect();
        for symbol in SYMBOLS {
            all.extend(symbol.prefixes.chars().map(|p| format!("{p}{}", symbol.name)));
        }
        let count = all.len();
        all.sort();
        all.dedup();
        assert_eq!(all.len(), count);
    }
}
