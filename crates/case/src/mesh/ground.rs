//! What is made of a mesh once it is there: planes that cut generated ground, groups by place, and linings of holes.

use std::collections::BTreeSet;

use super::lining::HoleLining;
use super::place::PlacedGroup;
use super::plane::CutPlane;
use crate::Diagnostic;
use crate::fields::Fields;

/// What is made of a mesh once it is generated or read, in this order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ground {
    /// Planes that cut it, which generated meshes alone have; names unique.
    pub planes: Vec<CutPlane>,
    /// Groups by place; names unique.
    pub groups: Vec<PlacedGroup>,
    /// Linings of holes; names unique.
    pub linings: Vec<HoleLining>,
}

impl Ground {
    /// `x_azimuth` \[rad\] is that of the model's x axis.
    pub(crate) fn read(mesh: &Fields, x_azimuth: f64) -> Option<Ground> {
        Some(Ground {
            planes: mesh
                .tables("plane")
                .map(|plane| CutPlane::read(plane, x_azimuth))
                .collect::<Option<_>>()?,
            groups: mesh
                .tables("group")
                .map(|group| PlacedGroup::read(group, x_azimuth))
                .collect::<Option<_>>()?,
            linings: mesh.tables("lining").map(HoleLining::read).collect::<Option<_>>()?,
        })
    }

    /// What lies between keys.
    pub(crate) fn check(mesh: &Fields, problems: &mut Vec<Diagnostic>) {
        mesh.tables("group").for_each(|group| PlacedGroup::check(group, problems));
        mesh.tables("lining").for_each(|lining| HoleLining::check(lining, problems));
        let generated = mesh.table("caverns").is_some() || mesh.table("box").is_some();
        if let (Some(_), Some(planes), false) = (mesh.table("file"), mesh.get("plane"), generated) {
            problems.push(Diagnostic::new(
                planes.span.clone(),
                "planes cut meshes that are generated, not those that are read",
                "mesh the plane with the file's own program, as docs/meshes.md says of Gmsh; [[mesh.group]] makes groups by place",
            ));
        }
        for key in ["plane", "group", "lining"] {
            let mut names = BTreeSet::new();
            for name in mesh.tables(key).filter_map(|table| table.text("name")) {
                if !names.insert(name.value.clone()) {
                    let message = format!("two {key}s are called `{}`", name.value);
                    problems.push(Diagnostic::at(&name, message, format!("give each {key} its own name")));
                }
            }
        }
    }
}
