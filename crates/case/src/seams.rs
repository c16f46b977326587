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
        .with("friction_coefficient", stand.friction)
        .with("tensile_strength", stand.tension)
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
                water: None,
            }),
            span: seam.span.clone(),
        })
    };
    planes.iter().filter_map(one).collect()
}

/// Where the values of these interfaces come from, as of keys that are left out.
pub(crate) fn told(planes: &[CutPlane]) -> Vec<Defaulted> {
    let of_plane = |plane: &CutPlane| {
        let seam = plane.seam.as_ref()?;
        let of = format!("'{}'", seam.material.value);
        let over = format!("over {} of {of}", units::format(seam.thickness.value, Dimension::LENGTH));
        let told = [
            ("normal_stiffness", format!("E(1 - nu)/((1 + nu)(1 - 2 nu)) {over}")),
            ("shear_stiffness", format!("G {over}")),
            ("cohesion", format!("that of {of}, gone once it breaks")),
            ("friction_coefficient", format!("tan of the friction angle of {of}")),
            ("tensile_strength", format!("that of {of}")),
        ];
        let name = &plane.name.value;
        Some(told.map(|(key, value)| Defaulted { key: format!("interface[{name}].{key}"), value }))
    };
    planes.iter().filter_map(of_plane).flatten().collect()
}
