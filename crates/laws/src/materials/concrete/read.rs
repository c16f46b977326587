//! How what a case says of concrete becomes numbers.

use super::faults::Faults;
use super::grade::{self, GRADES, Grade};
use super::rate::Rate;
use super::unusual;
use super::{Concrete, Driver, Evolution, Split};
use crate::material::Moduli;
use crate::materials::elastic::read_moduli;
use crate::materials::plastic::parameters::{ANGLES, is_angle};
use crate::parameter::{BadParameter, Value, Values};

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
                "has no meaning with evolution = exponential, the default",
                "give fracture_energy instead, or evolution = \"residual\" for a plateau that ends there",
            ));
        }
    }
    let idle = unusual::idle(given, exponential, rate == "none", split);
    let of_grade = grade.filter(|_| ratio.is_none()).map(|g| g.fracture_energy);
    let energy = energy.or(of_grade);
    // With evolution = exponential nothing but G_f says how concrete softens.
    let of_strength = fc.filter(|_| exponential && energy.is_none()).map(grade::fracture_energy);
    let energy = energy.or(of_strength);
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
        energy_of_strength: of_strength.is_some(),
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
            energy_of_strength: false,
            idle: unusual::Idle::default(),
        }
    }
}
