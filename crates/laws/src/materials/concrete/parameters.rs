//! The concrete law's parameters: what a case may say, and how it becomes numbers.

use super::faults::Faults;
use super::grade::{GRADES, Grade};
use super::rate::{RATES, Rate};
use super::unusual;
use super::{Concrete, Driver, Evolution, Split};
use crate::material::Moduli;
use crate::materials::elastic::read_moduli;
use crate::materials::plastic::parameters::{ANGLES, is_angle, number};
use crate::parameter::{BadParameter, Dimension, Kind, Need, Parameter, Value, Values};

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
            "that of the grade unless ultimate_strain_ratio is given; without a grade that ratio is used",
        ),
        "G_f, energy per area of a crack; the element's size across the crack then sets the softening, in either evolution",
    ),
    word(
        "evolution",
        &["residual", "exponential"],
        Need::Word("residual"),
        "softening in tension: plateau or crack band",
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
    word("split", &["effective", "compliance"], Need::Word("effective"), "how damage enters the stress"),
];

/// Fills what is not given from the grade; a given value always wins.
fn with_grade(values: &Values) -> Result<(Values, Option<Grade>), BadParameter> {
    let mut all = values.clone();
    let Some(name) = values.word("grade") else { return Ok((all, None)) };
    let Some(grade) = Grade::named(name) else {
        return Err(BadParameter::new(
            "grade",
            format!("{name} is not known"),
            format!("one of {}", GRADES.join(", ")),
        ));
    };
    for (key, value) in
        [("young", grade.young), ("poisson", grade.poisson), ("tensile_strength", grade.tensile_strength)]
    {
        all.0.entry(key.to_owned()).or_insert(Value::Number(value));
    }
    if values.optional("cohesion").is_none() {
        all.0.entry("compressive_strength".to_owned()).or_insert(Value::Number(grade.compressive_strength));
    }
    Ok((all, Some(grade)))
}

pub(super) fn read(given: &Values) -> Result<Concrete, Vec<BadParameter>> {
    let (values, grade) = with_grade(given).map_err(|fault| vec![fault])?;
    let mut faults = Faults::default();
    let moduli = read_moduli(&values).map_err(|f| faults.0.extend(f)).ok();
    let positive = |x: f64| x > 0.0;
    let fraction = |x: f64| x > 0.0 && x <= 1.0;
    let ft = faults.number(&values, "tensile_strength", positive, "positive");
    let angle = faults.number(&values, "friction_angle", is_angle, ANGLES);
    let fc = match (values.optional("compressive_strength"), values.optional("cohesion")) {
        (None, Some(_)) => {
            let c = faults.number(&values, "cohesion", positive, "positive");
            c.zip(angle).map(|(c, phi)| 2.0 * c * phi.cos() / (1.0 - phi.sin()))
        }
        (None, None) => {
            faults.0.push(BadParameter::new(
                "compressive_strength",
                "is missing, and so are cohesion and grade",
                "give one of the three",
            ));
            None
        }
        _ => faults.number(&values, "compressive_strength", positive, "positive"),
    };
    let alpha = faults.number(&values, "residual_tension", fraction, "above 0 and at most 1");
    let beta = faults.number(&values, "residual_shear", fraction, "above 0 and at most 1");
    let filter = faults.number(&values, "rate_filter_time", |x| x >= 0.0, "zero or positive");
    let reference = faults.optional(&values, "reference_rate");
    let ratio = faults.optional(&values, "ultimate_strain_ratio");
    let energy = faults.optional(&values, "fracture_energy");
    let rate = faults.word(&values, "rate");
    let driver = if faults.word(&values, "driver") == "stress" { Driver::Stress } else { Driver::Strain };
    let split =
        if faults.word(&values, "split") == "compliance" { Split::Compliance } else { Split::Effective };
    let nominal = faults.word(&values, "shear_tension") == "nominal";
    let exponential = faults.word(&values, "evolution") == "exponential";

    if let Some(x) = ratio {
        if x <= 1.0 {
            faults.0.push(BadParameter::new("ultimate_strain_ratio", "must be above 1", "10 is usual"));
        }
        if energy.is_some() {
            faults.0.push(BadParameter::new(
                "ultimate_strain_ratio",
                "is given together with fracture_energy",
                "keep one: each determines the other for an element's size",
            ));
        } else if exponential {
            faults.0.push(BadParameter::new(
                "ultimate_strain_ratio",
                "has no meaning with evolution = exponential",
                "give fracture_energy instead",
            ));
        }
    }
    let idle = unusual::idle(given, exponential, rate == "none", split);
    let of_grade = grade.filter(|_| ratio.is_none()).map(|g| g.fracture_energy);
    let energy = energy.or(of_grade);
    if exponential && energy.is_none() {
        faults.0.push(BadParameter::new(
            "fracture_energy",
            "is missing, and evolution = exponential goes by it",
            "give it (about 130 N/m for concrete) or a grade",
        ));
    }
    let (Some(moduli), Some(ft), Some(angle), Some(fc)) = (moduli, ft, angle, fc) else {
        return Err(faults.0);
    };
    let (Some(alpha), Some(beta), Some(filter)) = (alpha, beta, filter) else { return Err(faults.0) };
    if !faults.0.is_empty() {
        return Err(faults.0);
    }
    let evolution = match (exponential, energy) {
        (true, Some(energy)) => Evolution::Exponential { energy },
        (false, Some(energy)) => Evolution::Energy { energy },
        _ => Evolution::Ratio { ratio: ratio.unwrap_or(10.0) },
    };
    let law = Concrete::from_parts(moduli, ft, fc, angle, [alpha, beta], evolution);
    let by_cohesion = values.optional("compressive_strength").is_none();
    let replaced = grade.filter(|_| by_cohesion).map(|g| g.compressive_strength);
    Ok(Concrete {
        driver,
        split,
        nominal,
        replaced,
        idle,
        rate: Rate::named(rate, fc, reference, filter),
        ..law
    })
}

impl Concrete {
    /// Static, effective split, strain driver: what the words refine.
    fn from_parts(
        moduli: Moduli,
        ft: f64,
        fc: f64,
        angle: f64,
        [alpha, beta]: [f64; 2],
        evolution: Evolution,
    ) -> Self {
        Concrete {
            moduli,
            young: moduli.young(),
            poisson: moduli.poisson(),
            ft,
            fc,
            slope: (1.0 + angle.sin()) / (1.0 - angle.sin()),
            alpha,
            beta,
            evolution,
            rate: None,
            driver: Driver::Strain,
            split: Split::Effective,
            nominal: true,
            replaced: None,
            idle: unusual::Idle::default(),
        }
    }
}
