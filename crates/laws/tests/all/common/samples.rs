//! Parameters of every law, for the tests that run on all of them: the one place where those of a new law are entered.

use tremolite_laws::{Value, Values};

/// Names of parameters that are moduli and make all stresses larger together, at the same ratio of moduli.
pub const MODULI: &[&str] = &["young"];

/// Parameters of a law, in SI, angles in radians.
pub struct Sample {
    pub law: &'static str,
    /// What sets it apart from the law's other samples.
    pub variant: &'static str,
    pub numbers: &'static [(&'static str, f64)],
    pub words: &'static [(&'static str, &'static str)],
    /// Tables by their keys, columns by theirs.
    pub tables: &'static [(&'static str, Columns)],
}

pub type Columns = &'static [(&'static str, &'static [f64])];

impl Sample {
    pub fn values(&self) -> Values {
        let mut values = Values::default();
        for (name, x) in self.numbers {
            values = values.with(name, *x);
        }
        for (name, word) in self.words {
            values.0.insert((*name).to_owned(), Value::Word((*word).to_owned()));
        }
        self.tables.iter().fold(values, |values, (name, columns)| values.with_table(name, columns))
    }
}

/// The samples of a law.
pub fn samples(law: &str) -> Vec<&'static Sample> {
    let found: Vec<_> = SAMPLES.iter().filter(|sample| sample.law == law).collect();
    assert!(!found.is_empty(), "{law}: enter parameters of it in {}", file!());
    found
}

const fn deg(angle: f64) -> f64 {
    angle.to_radians()
}

const fn sample(
    law: &'static str,
    variant: &'static str,
    numbers: &'static [(&'static str, f64)],
    words: &'static [(&'static str, &'static str)],
) -> Sample {
    Sample { law, variant, numbers, words, tables: &[] }
}

/// Numbers on top of the moduli of a rock.
macro_rules! rock {
    ($($key:ident $value:expr),* $(,)?) => {
        &[("young", 10e9), ("poisson", 0.25), $((stringify!($key), $value)),*]
    };
}

/// Numbers on top of the concrete of `wang2018`, table 1.
macro_rules! concrete {
    ($($key:ident $value:expr),* $(,)?) => {
        &[
            ("young", 25e9),
            ("poisson", 0.17),
            ("tensile_strength", 1.2e6),
            ("cohesion", 2e6),
            ("friction_angle", deg(46.0)),
            ("residual_tension", 0.1),
            ("residual_shear", 0.2),
            $((stringify!($key), $value)),*
        ]
    };
}

const CONE: &[(&str, f64)] =
    rock!(cohesion 2.18e6, friction_angle deg(42.0), dilation_angle deg(42.0), tensile_strength 1e6);

/// Numbers on top of the closure of a joint of rock and lining.
macro_rules! joint {
    ($($key:ident $value:expr),* $(,)?) => {
        &[("normal_stiffness", 20e9), ("max_closure", 0.5e-3), ("friction_coefficient", 0.7), $((stringify!($key), $value)),*]
    };
}

/// Numbers on top of the stiffness of a joint without a closure.
macro_rules! linear_joint {
    ($($key:ident $value:expr),* $(,)?) => {
        &[("normal_stiffness", 20e9), ("friction_coefficient", 0.7), $((stringify!($key), $value)),*]
    };
}

const SAMPLES: &[Sample] = &[
    sample("elastic", "", rock!(), &[]),
    sample(
        "concrete-damage",
        "effective",
        concrete!(),
        &[("split", "effective"), ("evolution", "residual"), ("rate", "none")],
    ),
    sample(
        "concrete-damage",
        "compliance",
        concrete!(),
        &[("split", "compliance"), ("evolution", "residual"), ("rate", "none")],
    ),
    sample(
        "concrete-damage",
        "effective, exponential",
        concrete!(fracture_energy 130.0),
        &[("split", "effective"), ("evolution", "exponential"), ("rate", "none")],
    ),
    sample(
        "concrete-damage",
        "compliance, exponential",
        concrete!(fracture_energy 130.0),
        &[("split", "compliance"), ("evolution", "exponential"), ("rate", "none")],
    ),
    sample(
        "mohr-coulomb",
        "perfect",
        rock!(cohesion 2.18e6, friction_angle deg(42.0), dilation_angle deg(10.0), tensile_strength 1e6),
        &[],
    ),
    sample("mohr-coulomb", "associated", CONE, &[]),
    sample(
        "mohr-coulomb",
        "without tension",
        rock!(cohesion 2.18e6, friction_angle deg(42.0), tensile_strength 0.0),
        &[],
    ),
    sample("mohr-coulomb", "without friction", rock!(cohesion 1e6, friction_angle 0.0), &[]),
    Sample {
        law: "mohr-coulomb",
        variant: "softening",
        numbers: rock!(cohesion 2e6, friction_angle deg(42.0), dilation_angle deg(10.0), tensile_strength 1e6),
        words: &[],
        tables: &[(
            "softening",
            &[
                ("plastic_shear_strain", &[0.0, 1e-3, 5e-3]),
                ("plastic_tension_strain", &[0.0, 1e-4, 1e-3]),
                ("cohesion", &[2e6, 1e6, 0.5e6]),
                ("friction_angle", &[deg(42.0), deg(45.0), deg(30.0)]),
                ("dilation_angle", &[deg(10.0), deg(5.0), 0.0]),
                ("tensile_strength", &[1e6, 2e5, 0.0]),
            ],
        )],
    },
    Sample {
        law: "mohr-coulomb",
        variant: "softening over displacement",
        numbers: rock!(cohesion 2e6, friction_angle deg(42.0), dilation_angle deg(10.0), tensile_strength 1e6),
        words: &[],
        tables: &[(
            "softening",
            &[
                ("plastic_shear_displacement", &[0.0, 2e-3, 1e-2]),
                ("plastic_tension_displacement", &[0.0, 1e-4, 1e-3]),
                ("cohesion", &[2e6, 1e6, 0.5e6]),
                ("friction_angle", &[deg(42.0), deg(45.0), deg(30.0)]),
                ("dilation_angle", &[deg(10.0), deg(5.0), 0.0]),
                ("tensile_strength", &[1e6, 2e5, 0.0]),
            ],
        )],
    },
    Sample {
        law: "mohr-coulomb",
        variant: "softening over strain, with a relaxation time",
        numbers: rock!(cohesion 2e6, friction_angle deg(42.0), tensile_strength 1e6, relaxation_time 1e-3),
        words: &[],
        tables: &[(
            "softening",
            &[
                ("plastic_shear_strain", &[0.0, 5e-3]),
                ("cohesion", &[2e6, 0.5e6]),
                ("tensile_strength", &[1e6, 0.0]),
            ],
        )],
    },
    sample("drucker-prager", "outer", CONE, &[("fit", "outer")]),
    sample("drucker-prager", "inner", CONE, &[("fit", "inner")]),
    sample("drucker-prager", "plane strain", CONE, &[("fit", "plane-strain")]),
    sample("hoek-brown", "fair rock", rock!(compressive_strength 80e6, gsi 55.0, m_i 15.0), &[]),
    sample(
        "hoek-brown",
        "intact, dilates",
        rock!(compressive_strength 60e6, gsi 100.0, m_i 12.0, dilation_angle 0.2, tensile_strength 1e4),
        &[],
    ),
    sample(
        "hoek-brown",
        "poor, dilates",
        rock!(compressive_strength 60e6, gsi 12.0, m_i 12.0, dilation_angle 0.6),
        &[],
    ),
    Sample {
        law: "hoek-brown",
        variant: "residual state after a slip",
        numbers: rock!(compressive_strength 80e6, gsi 70.0, m_i 15.0, dilation_angle 0.1),
        words: &[],
        tables: &[(
            "residual",
            &[("gsi", &[30.0]), ("disturbance", &[0.5]), ("plastic_shear_displacement", &[1e-2])],
        )],
    },
    Sample {
        law: "hoek-brown",
        variant: "residual state after a strain",
        numbers: rock!(compressive_strength 80e6, gsi 70.0, m_i 15.0, tensile_strength 1e5),
        words: &[],
        tables: &[("residual", &[("gsi", &[25.0]), ("plastic_shear_strain", &[5e-3])])],
    },
    Sample {
        law: "hoek-brown",
        variant: "residual state after a strain, with a relaxation time",
        numbers: rock!(compressive_strength 80e6, gsi 70.0, m_i 15.0, relaxation_time 1e-3),
        words: &[],
        tables: &[("residual", &[("gsi", &[25.0]), ("plastic_shear_strain", &[5e-3])])],
    },
    sample("bandis", "following, bonded", joint!(cohesion 1e6), &[]),
    sample("bandis", "following, without bond", joint!(), &[]),
    sample(
        "bandis",
        "following, straight early, weak in tension",
        joint!(cohesion 1.5e6, tensile_strength 0.4e6, pressure_for_step 4e6, poisson 0.1),
        &[],
    ),
    sample(
        "bandis",
        "constant, bonded",
        joint!(cohesion 1e6, tensile_strength 2e6),
        &[("tangential", "constant")],
    ),
    sample("bandis", "constant, without bond", joint!(closure_floor 0.5), &[("tangential", "constant")]),
    sample("bandis", "straight", joint!(cohesion 0.5e6, closure_floor 1.0), &[]),
    sample("coulomb", "bonded", linear_joint!(cohesion 1e6), &[]),
    sample("coulomb", "without bond", linear_joint!(shear_stiffness 15e9), &[]),
    sample("coulomb", "tension alone", linear_joint!(tensile_strength 1e6), &[]),
];
