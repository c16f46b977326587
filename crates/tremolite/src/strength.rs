//! By which code the sections of a lining are judged: what a case asks for, with the elements that it is meant for.

use tremolite_results::Factors;
use tremolite_sections::{Grade, Rule};

/// The rule for some elements.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedBy {
    /// Elements of the mesh, ascending.
    pub elements: Vec<u32>,
    /// The code and the grade, as the case names them; the grade is empty where strengths are given.
    pub code: String,
    pub grade: String,
    pub rule: Rule,
    /// By which strengths of concrete grow while the ground shakes.
    pub dynamic: f64,
    /// Of the bars \[m\]; nothing: crack widths are not wanted.
    pub bar_diameter: Option<f64>,
}

impl JudgedBy {
    /// Whether a station with these elements is meant: all of it.
    pub fn holds(&self, elements: impl IntoIterator<Item = u32>) -> bool {
        elements.into_iter().all(|e| self.elements.binary_search(&e).is_ok())
    }

    /// The factors, as a summary has them.
    pub fn factors(&self) -> Factors {
        let rule = &self.rule;
        Factors {
            gamma_c: rule.concrete_factor,
            gamma_s: rule.steel_factor,
            alpha_cc: rule.compression_factor,
            alpha_ct: rule.tension_factor,
            gamma_d: rule.resistance_factor,
            dynamic: self.dynamic,
        }
    }

    /// Characteristic strengths.
    pub fn grade(&self) -> Grade {
        self.rule.grade
    }
}
