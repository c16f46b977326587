//! `[[section]]`: by which code the sections of a lining are judged.

use std::ops::Range;

use tremolite_laws::parameter::Dimension;

use crate::fields::Fields;
use crate::keys::{Key, Kind, Limit, Table, When, words};
use crate::{Diagnostic, Spanned};

const STRESS: Kind = Kind::Number(Dimension::PRESSURE, Limit::Positive);
const FACTOR: Kind = Kind::Number(Dimension::NONE, Limit::Positive);

pub(crate) static SECTION: Table = Table {
    path: "section",
    doc: "By which code the sections of a lining are judged: thrust with moment, and shear, of one instant each, in every step. Factors \
          are 1 unless they are given.",
    keys: &[
        Key::required(
            "on",
            Kind::List(&Kind::Text, 1, 1000),
            "groups of the mesh that have a thickness, such as \"*.lining\"; * stands for any text",
        ),
        Key::required("code", Kind::Word(SectionCode::WORDS), "whose rules are followed"),
        Key::optional(
            "grade",
            Kind::Text,
            "",
            "Grade of the concrete: \"C30/37\" by EN 1992-1-1 (table 3.1), \"C30\" by GB 50010 (tables 4.1.3)",
        ),
        Key::optional(
            "compressive_strength",
            STRESS,
            "",
            "Characteristic strength f_ck, in place of a grade",
        )
        .when(When::Without("grade")),
        Key::optional(
            "tensile_strength",
            STRESS,
            "",
            "Characteristic strength f_ctk,0.05 or f_tk, in place of a grade",
        )
        .when(When::Without("grade")),
        Key::default(
            "gamma_c",
            FACTOR,
            "1",
            "By which strengths of concrete are divided (EN 1992-1-1 2.4.2.4; GB 50010 4.1.4: 1.4)",
        ),
        Key::default(
            "gamma_s",
            FACTOR,
            "1",
            "By which the yield stress of bars is divided (EN 1992-1-1 2.4.2.4; GB 50010 4.2.3)",
        ),
        Key::default(
            "alpha_cc",
            FACTOR,
            "1",
            "By which the compressive strength is multiplied (EN 1992-1-1 3.1.6 (1); for plain concrete 12.3.1 (1), which recommends 0.8)",
        ),
        Key::default(
            "alpha_ct",
            FACTOR,
            "1",
            "By which the tensile strength is multiplied (EN 1992-1-1 3.1.6 (2); for plain concrete 12.3.1 (1), which recommends 0.8)",
        ),
        Key::default(
            "gamma_d",
            FACTOR,
            "1",
            "By which resistances are divided beyond that: structural factor, importance and situation of formats that have them, all in one",
        ),
        Key::default(
            "dynamic_factor",
            FACTOR,
            "1",
            "By which strengths of concrete are multiplied while the ground shakes",
        ),
        Key::optional(
            "bar_diameter",
            Kind::Number(Dimension::LENGTH, Limit::Positive),
            "no crack widths of sections with bars",
            "Diameter of the bars, by which the widths of the cracks that the earthquake leaves are computed (EN 1992-1-1 7.3.4)",
        ),
        Key::default(
            "plain_tension",
            Kind::Flag,
            "true",
            "Whether the tensile strength counts in thrust and moment of a section without bars (EN 1992-1-1 12.3.1 (2)); its shear counts it always",
        ),
    ],
    choice: &[],
};

words! {
    /// A code of concrete structures.
    SectionCode {
        /// EN 1992-1-1:2004: plane sections (6.1), plain concrete (12.6.1), shear (6.2.2, 12.6.3).
        En = "EN 1992-1-1",
        /// GB 50010-2010: plane sections (6.2.1), plain concrete (the form of D.2.1), shear of slabs with bars (6.3.3).
        Gb = "GB 50010",
    }
}

/// The rules for sections of some groups. Factors are those of the keys of the same name.
#[derive(Clone, Debug, PartialEq)]
pub struct Section {
    /// Groups: names in which `*` stands for any text (see [`pattern::matches`](crate::pattern::matches)).
    pub on: Vec<Spanned<String>>,
    pub code: Spanned<SectionCode>,
    /// The grade; nothing where strengths are given.
    pub grade: Option<Spanned<String>>,
    /// f_ck and f_ctk,0.05 or f_tk, Pa; both where there is no grade.
    pub strengths: Option<[f64; 2]>,
    pub gamma_c: f64,
    pub gamma_s: f64,
    pub alpha_cc: f64,
    pub alpha_ct: f64,
    pub gamma_d: f64,
    pub dynamic: f64,
    /// Of the bars, m; nothing: no crack widths.
    pub bar_diameter: Option<Spanned<f64>>,
    pub plain_tension: bool,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

impl Section {
    pub(crate) fn read(f: &Fields) -> Option<Self> {
        let strengths = [f.number("compressive_strength"), f.number("tensile_strength")];
        let strengths = match strengths {
            [Some(c), Some(t)] => Some([c.value, t.value]),
            _ => None,
        };
        let number = |key| Some(f.number(key)?.value);
        Some(Section {
            on: f.texts("on"),
            code: f.word("code", SectionCode::from_word)?,
            grade: f.text("grade"),
            strengths,
            gamma_c: number("gamma_c")?,
            gamma_s: number("gamma_s")?,
            alpha_cc: number("alpha_cc")?,
            alpha_ct: number("alpha_ct")?,
            gamma_d: number("gamma_d")?,
            dynamic: number("dynamic_factor")?,
            bar_diameter: f.number("bar_diameter"),
            plain_tension: f.flag("plain_tension")?,
            span: f.span.clone(),
        })
    }

    /// Refuses a section whose concrete is not known.
    pub(crate) fn check(f: &Fields, problems: &mut Vec<Diagnostic>) {
        let given = ["compressive_strength", "tensile_strength"].map(|key| f.number(key).is_some());
        if f.text("grade").is_none() && given != [true, true] {
            problems.push(Diagnostic::new(
                f.span.clone(),
                "it is not said how strong the concrete is",
                "give `grade`, or both `compressive_strength` and `tensile_strength`",
            ));
        }
        let most = match f.word("code", SectionCode::from_word).map(|code| code.value) {
            Some(SectionCode::Gb) => 32.4e6,
            _ => 50e6,
        };
        if let Some(strength) = f.number("compressive_strength").filter(|strength| strength.value > most) {
            problems.push(Diagnostic::new(
                strength.span,
                format!(
                    "{:.1} MPa is beyond C50, whose {:.1} MPa are the most that the diagram of this code here is for",
                    1e-6 * strength.value,
                    1e-6 * most
                ),
                "concrete beyond C50 fails at smaller strains: judge its sections apart",
            ));
        }
    }
}
