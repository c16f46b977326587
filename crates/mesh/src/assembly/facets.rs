//! Named surfaces that a file gives as triangles and quadrilaterals.

use std::collections::BTreeMap;

use crate::fault::Fault;
use crate::topology::{all_faces, face_key};
use crate::{Face, Mesh};

/// A triangle or quadrilateral of a file that lies on the solid elements.
pub(crate) struct Facet {
    /// Its nodes (indices) ascending, a triangle's fourth `u32::MAX`.
    pub key: [u32; 4],
    /// Its number in the file.
    pub number: u64,
    /// Which list of names it belongs to.
    pub list: u32,
}

impl Facet {
    /// A facet from its 3 or 4 nodes.
    pub(crate) fn new(nodes: &[u32], number: u64, list: u32) -> Self {
        let mut key = [u32::MAX; 4];
        key[..nodes.len()].copy_from_slice(nodes);
        key.sort_unstable();
        Facet { key, number, list }
    }
}

/// What becomes of facets that are no face of a solid element.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) enum Stray {
    /// The file is refused: its surfaces are there to name faces.
    #[default]
    Refused,
    /// They are counted: its surfaces are elements in their own right, such as shells.
    Skipped,
}

/// Puts the elements' faces that coincide with a facet into the groups `names[facet.list]`; how many facets
/// are no element's face.
///
/// A facet inside the mesh is a face of two elements; the group gets both.
///
/// # Errors
/// Facets that are no element's face, if these are refused.
pub(super) fn name_faces(
    mesh: &mut Mesh,
    mut facets: Vec<Facet>,
    names: &[Vec<String>],
    stray: Stray,
) -> Result<usize, Fault> {
    if facets.is_empty() {
        return Ok(0);
    }
    facets.sort_unstable_by_key(|f| f.key);
    let mut on_facet = vec![false; mesh.nodes.len()];
    for &node in facets.iter().flat_map(|f| &f.key) {
        if let Some(flag) = on_facet.get_mut(node as usize) {
            *flag = true;
        }
    }
    let mut found = vec![false; facets.len()];
    let mut groups: BTreeMap<&str, Vec<Face>> = BTreeMap::new();
    for face in all_faces(mesh, None) {
        if !mesh.face_nodes(face).all(|n| on_facet[n as usize]) {
            continue;
        }
        let key = face_key(mesh, face);
        let first = facets.partition_point(|f| f.key < key);
        for (facet, found) in
            facets[first..].iter().zip(&mut found[first..]).take_while(|(f, _)| f.key == key)
        {
            *found = true;
            for name in &names[facet.list as usize] {
                groups.entry(name).or_default().push(face);
            }
        }
    }
    let mut lost: Vec<&Facet> =
        facets.iter().zip(&found).filter(|(_, found)| !**found).map(|(f, _)| f).collect();
    // One that is in several lists counts once.
    lost.dedup_by_key(|f| f.key);
    if let (Some(first), Stray::Refused) = (lost.iter().min_by_key(|f| f.number), stray) {
        let name = names[first.list as usize].first().map_or("", String::as_str);
        return Err(Fault::whole(format!(
            "{} elements of named surfaces are no faces of solid elements (surface `{name}`, element {}); \
             remove that surface from the groups, or mesh the volume to it",
            lost.len(),
            first.number
        )));
    }
    for (name, list) in groups {
        mesh.faces.entry(name.to_owned()).or_default().extend(list);
    }
    Ok(lost.len())
}
