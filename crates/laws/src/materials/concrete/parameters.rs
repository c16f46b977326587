//! The concrete law's parameters: what a case may say.

use super::grade::GRADES;
use super::rate::RATES;
use crate::materials::plastic::parameters::number;
use crate::parameter::{Dimension, Kind, Need, Parameter};

const FROM_GRADE: Need = Need::Optional("that of the grade");

const fn word(
    name: &'static str,
    words: &'static [&'static str],
    need: Need,
    doc: &'static str,
) -> Parameter {
    Parameter { name, kind: Kind::Word(words), need, doc }
}

pub(super) const PARAMETERS: &[Parameter] = &[
    word(
        "grade",
        GRADES,
        Need::Optional("young, tensile_strength and a compressive strength or cohesion must be given"),
        "grade of Model Code 2010; gives mean E, ν, f_t, f_c and G_f, each of which its own key overrides; G_f needs the \
         element's size, unless ultimate_strain_ratio is given",
    ),
    number("young", Dimension::PRESSURE, FROM_GRADE, "Young's modulus E"),
    number("poisson", Dimension::NONE, FROM_GRADE, "Poisson's ratio ν, from 0 up to below 0.5"),
    number("tensile_strength", Dimension::PRESSURE, FROM_GRADE, "static uniaxial tensile strength f_t"),
    number("friction_angle", Dimension::ANGLE, Need::Required, "friction angle φ, from 0 up to 89.9°"),
    number(
        "cohesion",
        Dimension::PRESSURE,
        Need::Optional("f_c is given or comes from the grade"),
        "cohesion c, in place of compressive_strength: f_c = 2 c cos φ/(1 − sin φ)",
    ),
    number(
        "compressive_strength",
        Dimension::PRESSURE,
        Need::Optional("from the cohesion, else from the grade"),
        "static uniaxial compressive strength f_c, in place of the cohesion",
    ),
    number(
        "residual_tension",
        Dimension::NONE,
        Need::Number(0.1),
        "α, residual strength over f_t after cracking (evolution = residual alone), above 0 up to 1",
    ),
    number(
        "residual_shear",
        Dimension::NONE,
        Need::Number(0.2),
        "β, residual strength over the peak in shear, above 0 up to 1",
    ),
    number(
        "ultimate_strain_ratio",
        Dimension::NONE,
        Need::Optional("from the fracture energy, the given or the grade's, else 10"),
        "ε_us/ε_ts, ultimate over threshold strain in tension (evolution = residual), above 1",
    ),
    number(
        "fracture_energy",
        Dimension::FRACTURE_ENERGY,
        Need::Optional(
            "that of the grade unless ultimate_strain_ratio is given; without a grade 73 f_c^0.18 with f_c in MPa (Model Code \
             2010), but with evolution = residual that ratio is used",
        ),
        "G_f, energy per area of a crack; the element's size across the crack then sets the softening, in either evolution",
    ),
    word(
        "evolution",
        &["residual", "exponential"],
        Need::Word("exponential"),
        "softening in tension: plateau or crack band; the plateau is the paper's, and its strength at corners falls with the \
         element size",
    ),
    word("rate", RATES, Need::Word("ceb"), "how strength grows with the rate of strain"),
    number(
        "reference_rate",
        Dimension::RATE,
        Need::Optional("that of the rate law"),
        "ε̇_s, rate of strain below which strength is static (not with rate = none)",
    ),
    number(
        "rate_filter_time",
        Dimension::TIME,
        Need::Number(5e-3),
        "τ, time over which rates are averaged (not with rate = none)",
    ),
    word(
        "driver",
        &["strain", "stress"],
        Need::Word("strain"),
        "what drives tension: strains or effective stresses",
    ),
    word(
        "shear_tension",
        &["nominal", "effective"],
        Need::Word("nominal"),
        "tension across a crack in the shear criterion: what the crack carries, or the effective stress as printed \
         (split = effective alone: split = compliance tests what the point carries)",
    ),
    word(
        "split",
        &["effective", "compliance"],
        Need::Word("compliance"),
        "how damage enters the stress; effective is the paper's, which gives out energy once cracked",
    ),
];
