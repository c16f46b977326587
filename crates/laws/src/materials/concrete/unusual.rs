//! What is unusual about a concrete's parameters though the law accepts them.

use super::parameters::PARAMETERS;
use super::{Concrete, Split};
use crate::materials::elastic::soft_for_its_strength;
use crate::parameter::{Need, Value, Values};

/// What keys are idle beside the words chosen, a sentence each.
pub(super) type Idle = [Option<&'static str>; 5];

/// Model Code's reference rate in compression \[1/s\], which may stand beside any rate law without a word; the paper prints 0.3.
const MODEL_CODE_RATE: f64 = 3e-5;

/// Finds the keys that say something other than their default and have no effect.
pub(super) fn idle(values: &Values, exponential: bool, static_alone: bool, split: Split) -> Idle {
    let says = |name: &str| {
        let declared = PARAMETERS.iter().find(|p| p.name == name).map(|p| p.need);
        match (values.0.get(name), declared) {
            (Some(Value::Number(x)), Some(Need::Number(own))) => *x != own,
            (Some(Value::Word(word)), Some(Need::Word(own))) => word != own,
            (given, _) => given.is_some(),
        }
    };
    let both = says("cohesion") && says("compressive_strength");
    let rate = values.optional("reference_rate").is_some_and(|rate| rate != MODEL_CODE_RATE);
    [
        both.then_some("cohesion has no effect beside compressive_strength, which f_c is taken from"),
        (exponential && says("residual_tension"))
            .then_some("residual_tension has no effect with evolution = exponential, which falls to nothing"),
        (static_alone && rate).then_some("reference_rate has no effect with rate = none"),
        (static_alone && says("rate_filter_time"))
            .then_some("rate_filter_time has no effect with rate = none"),
        (split == Split::Compliance && says("shear_tension")).then_some(
            "shear_tension has no effect with split = compliance, which tests what the point carries",
        ),
    ]
}

impl Concrete {
    /// A sentence each.
    pub(super) fn unusual(&self) -> Vec<String> {
        let mut warnings = Vec::from_iter(soft_for_its_strength(&self.moduli, self.fc));
        warnings.extend(self.idle.iter().flatten().map(|&sentence| sentence.to_owned()));
        if let Some(grade) = self.replaced {
            warnings.push(format!(
                "cohesion gives f_c = {:.2} MPa, which is used in place of the grade's {:.2} MPa; leave the cohesion \
                 out to use the grade's",
                self.fc / 1e6,
                grade / 1e6
            ));
        }
        if self.slope * self.ft >= self.fc {
            let cracked = if self.split == Split::Effective && !self.nominal {
                "and so does any such pressure on an open crack (shear_tension = effective)"
            } else {
                "and on an open crack as long as it carries so much"
            };
            warnings.push(format!(
                "N f_t = {:.3} MPa reaches f_c = {:.3} MPa: any pressure across a tension of f_c/N = {:.3} MPa counts as \
                 shear failure (D⁻ of 1 − β or more) before the concrete cracks, {cracked}; raise the compressive \
                 strength or the cohesion, or lower the friction angle",
                self.slope * self.ft / 1e6,
                self.fc / 1e6,
                self.fc / self.slope / 1e6,
            ));
        }
        warnings
    }
}
