//! Interfaces that stand for thin layers in planes of the mesh.

use std::f64::consts::PI;

use tremolite_laws::parameter::{Dimension, Values};

use crate::defaulted::Defaulted;
use crate::interface::{Contact, Interface};
use crate::material::Material;
use crate::mesh::{CutPlane, Stand};
use crate::{Spanned, units};

/// The law of these interfaces.
const LAW: &str = "coulomb";

fn values(stand: &Stand) -> Values {
    Values::default()
        .with("normal_stiffness", stand.normal)
        .with("shear_stiffness", stand.shear)
        .with("cohesion", stand.cohesion)
        .with("friction", stand.friction)
        .with("tensile_strength", stand.tension)
}

/// A stiffness per area in words.
fn stiffness(k: f64) -> String {
    let (scale, unit) = if k >= 1e8 { (1e9, "GPa/m") } else { (1e6, "MPa/m") };
    format!("{:.4} {unit}", k / scale)
}

/// The interfaces that stand for seams, in the order of their planes.
pub(crate) fn interfaces(planes: &[CutPlane], materials: &[Material]) -> Vec<Interface> {
    let one = |plane: &CutPlane| {
        let seam = plane.seam.as_ref()?;
        let at = |value: f64| Spanned::new(value, seam.span.clone());
        let side = |side: &str| vec![Spanned::new(format!("{}.{side}", plane.name.value), seam.span.clone())];
        Some(Interface {
            name: plane.name.clone(),
            between: [side("below"), side("above")],
            contact: Some(Contact {
                law: Spanned::new(LAW.to_owned(), seam.span.clone()),
                parameters: values(&seam.stand(materials)?),
                // The defaults of [[interface]].
                corner: at(45.0 * PI / 180.0),
                damping: at(0.01),
                limit: at(0.8),
                viscosity: at(0.06),
            }),
            span: seam.span.clone(),
        })
    };
    planes.iter().filter_map(one).collect()
}

/// What is used for the keys of these interfaces, as for keys that are left out.
pub(crate) fn told(planes: &[CutPlane], materials: &[Material]) -> Vec<Defaulted> {
    let mut told = Vec::new();
    for plane in planes {
        let Some((seam, stand)) = plane.seam.as_ref().and_then(|s| Some((s, s.stand(materials)?))) else {
            continue;
        };
        let of = format!(
            "{} of '{}'",
            units::format(seam.thickness.value, Dimension::LENGTH),
            seam.material.value
        );
        let pressure = |p: f64| units::format(p, Dimension::PRESSURE);
        for (key, value) in [
            (
                "normal_stiffness",
                format!("{}: E(1 - nu)/((1 + nu)(1 - 2 nu)) over {of}", stiffness(stand.normal)),
            ),
            ("shear_stiffness", format!("{}: G over {of}", stiffness(stand.shear))),
            (
                "cohesion",
                format!(
                    "{}, that of '{}', gone once it breaks",
                    pressure(stand.cohesion),
                    seam.material.value
                ),
            ),
            (
                "friction",
                format!("{}: tan of the friction angle of '{}'", stand.friction, seam.material.value),
            ),
            ("tensile_strength", format!("{}, that of '{}'", pressure(stand.tension), seam.material.value)),
        ] {
            told.push(Defaulted { key: format!("interface[{}].{key}", plane.name.value), value });
        }
    }
    told
}
