//! Models so large that a look at them takes longer than the slip of a unit that made them so deserves.

use super::fault::Remark;
use super::loaded::{Given, Loaded, infos};
use crate::setup::unlikely;
use std::path::Path;
use tremolite_case::{Case, Caverns, Laws, Mesh, MeshBox};

/// Elements that are looked at whatever their extent: some five seconds on one core.
const LOOKED_AT: f64 = 50_000.0;

/// What of the lengths that a case file writes is hardly meant, where its mesh would be large as well. Nothing where the mesh is a
/// file's, whose lengths are not known before it is read, and where the case cannot be read, which reading it says.
pub fn oversized(path: &Path, given: &Given) -> Option<Remark> {
    let [materials, interfaces] = infos(&given.laws);
    let laws = Laws { materials: &materials, interfaces: &interfaces };
    let directory = path.parent().unwrap_or(Path::new(""));
    let case = Case::parse_in(path, directory, &Case::text_of(path).ok()?, &given.changes, laws).ok()?;
    let (extent, elements) = match &case.mesh {
        Mesh::Caverns(caverns) => of_caverns(caverns),
        Mesh::Box(bricks) => of_box(bricks),
        Mesh::File(_) => return None,
    };
    Remark::of(&case, &unlikely::sizes(&case, extent)).filter(|_| elements > LOOKED_AT)
}

impl Loaded {
    /// Whether its mesh has lengths that are hardly meant, and is large.
    pub fn is_oversized(&self) -> bool {
        let mesh = &self.setup.problem.mesh;
        mesh.elements.len() as f64 > LOOKED_AT
            && !unlikely::sizes(&self.case, unlikely::extent(mesh)).is_empty()
    }
}

/// Largest extent \[m\] of generated caverns, and about how many elements they take: at the least those of their size far away.
fn of_caverns(c: &Caverns) -> (f64, f64) {
    let mut reach = [[0.0_f64, 0.0]; 2];
    for cavern in &c.caverns {
        let [x, z] = cavern.at.value;
        let half = 0.5 * cavern.width.value;
        let spans = [[x - half, x + half], [z, z + cavern.height.value]];
        for (all, [low, high]) in reach.iter_mut().zip(spans) {
            *all = [all[0].min(low), all[1].max(high)];
        }
    }
    let across = reach[0][1] - reach[0][0] + 2.0 * c.sides.value;
    let upwards = reach[1][1] - reach[1][0] + c.overburden.value + c.below.value;
    let along = c.along.as_ref().map_or(c.near.value, |along| along.value).min(c.far.value);
    // Where all caverns end in rock rows grow along y as well, so this is a bound from above there.
    let rows = (c.length.value / along).max(1.0);
    let elements = (across / c.far.value) * (upwards / c.far.value) * rows;
    (across.max(upwards).max(c.length.value), elements)
}

/// The same of a box.
fn of_box(bricks: &MeshBox) -> (f64, f64) {
    let extent = bricks.axes.iter().map(|axis| axis.to.value - axis.from.value).fold(0.0, f64::max);
    (extent, bricks.axes.iter().map(|axis| f64::from(axis.elements.value)).product())
}
