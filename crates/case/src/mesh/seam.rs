//! `[mesh.plane.seam]`: a layer too thin to be meshed, which is an interface of its stiffness and strength.

use std::ops::Range;

use tremolite_laws::parameter::{Value, Values};

use super::LENGTH;
use crate::fields::{self, Fields};
use crate::keys::{Key, Kind, Table};
use crate::material::{Material, VOID};
use crate::{Diagnostic, Spanned};

pub(super) static SEAM: Table = Table {
    path: "mesh.plane.seam",
    doc: "A layer in the plane that is thinner than half an element: an interface NAME between its sides, law `coulomb`, of the layer's stiffness \
          over its thickness and of its strength.",
    keys: &[
        Key::required("material", Kind::Text, "material of the layer, of the law `mohr-coulomb`"),
        Key::required("thickness", LENGTH, "thickness of the layer, which the plane is the middle of"),
    ],
    choice: &[],
};

/// The law of the layer.
const LAYER: &str = "mohr-coulomb";

/// A layer too thin to be meshed.
#[derive(Clone, Debug, PartialEq)]
pub struct Seam {
    /// Name of its material.
    pub material: Spanned<String>,
    /// m.
    pub thickness: Spanned<f64>,
    /// Its table in the case: the header, or the braces.
    pub span: Range<usize>,
}

/// What an interface has in the place of a seam. Stiffnesses in Pa/m, strengths in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stand {
    /// M/t, with M = E(1 − ν)/((1 + ν)(1 − 2ν)): the layer cannot widen between its walls, so it is stiffer than E/t.
    pub normal: f64,
    /// G/t, with G = E/(2(1 + ν)).
    pub shear: f64,
    pub cohesion: f64,
    /// tan φ.
    pub friction: f64,
    /// The layer's tension cut-off, no more than its apex c/tan φ.
    pub tension: f64,
}

impl Stand {
    /// Of a Mohr–Coulomb material and a thickness \[m\]; nothing where a parameter is missing.
    fn of(layer: &Values, thickness: f64) -> Option<Stand> {
        let [young, poisson, cohesion, angle] =
            ["young", "poisson", "cohesion", "friction_angle"].map(|name| layer.optional(name));
        let (young, poisson, cohesion, friction) = (young?, poisson?, cohesion?, angle?.tan());
        let apex = if friction > 0.0 { cohesion / friction } else { f64::INFINITY };
        Some(Stand {
            normal: young * (1.0 - poisson) / ((1.0 + poisson) * (1.0 - 2.0 * poisson)) / thickness,
            shear: 0.5 * young / (1.0 + poisson) / thickness,
            cohesion,
            friction,
            tension: layer.optional("tensile_strength").unwrap_or(0.0).min(apex),
        })
    }
}

impl Seam {
    pub(super) fn read(f: &Fields) -> Option<Self> {
        Some(Seam { material: f.text("material")?, thickness: f.number("thickness")?, span: f.span.clone() })
    }

    /// What stands for it; nothing where its material is none of these or of another law.
    pub fn stand(&self, materials: &[Material]) -> Option<Stand> {
        let material = materials.iter().find(|m| m.name.value == self.material.value)?;
        Stand::of(&material.parameters, self.thickness.value)
    }
}

/// What lies between a seam and the materials: one that is known, of a law with a stiffness, a cohesion and a friction angle. Returns
/// what the interface leaves out of it.
pub(crate) fn check(
    mesh: &Fields,
    materials: &[fields::Material],
    problems: &mut Vec<Diagnostic>,
) -> Vec<Diagnostic> {
    let mut warnings = Vec::new();
    for seam in mesh.tables("plane").filter_map(|plane| plane.table("seam")) {
        let Some(name) = seam.text("material") else { continue };
        if name.value == VOID {
            problems.push(Diagnostic::at(
                &name,
                "a seam of nothing bears nothing",
                "name a material of the law `mohr-coulomb`",
            ));
            continue;
        }
        let Some(material) = materials.iter().find(|m| m.name.value == name.value) else { continue };
        let Some(law) = material.fields.text("law") else { continue };
        if law.value != LAYER {
            problems.push(Diagnostic::at(
                &name,
                format!("a seam is made of a material of the law `{LAYER}`, and `{}` is `{}`", name.value, law.value),
                format!("write law = \"{LAYER}\" with the seam's cohesion and friction angle, which the interface takes over"),
            ));
            continue;
        }
        let Some(values) = material.fields.values() else { continue };
        let dilates = values.optional("dilation_angle").is_some_and(|angle| angle > 0.0);
        let softens = matches!(values.0.get("softening"), Some(Value::Table(_)));
        let left: Vec<&str> = [(dilates, "dilation_angle"), (softens, "softening")]
            .into_iter()
            .filter(|x| x.0)
            .map(|x| x.1)
            .collect();
        if !left.is_empty() {
            warnings.push(Diagnostic::at(
                &name,
                format!("the interface that stands for the seam cannot use {} of `{}`", left.join(" and "), name.value),
                "leave them out, or mesh the seam between two planes with elements of half its thickness or less",
            ));
        }
    }
    warnings
}
