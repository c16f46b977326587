//! A mesh that was put together in memory, made as sound as one from a file.

use crate::assembly::Draft;
use crate::note::Note;
use crate::{Face, Mesh};

/// Checks a mesh that no reader made, and makes of it what they hand out: every element with a positive Jacobian (one numbered in
/// mirror image is renumbered), every node in an element, every element in a group, no group empty. A mesh that a reader made
/// comes back as it is. The notes tell what was done.
///
/// # Errors
/// What cannot be used, and the way out: coordinates that are not finite, indices and numbers that do not fit, flat elements.
pub fn sound(mesh: Mesh) -> Result<(Mesh, Vec<Note>), String> {
    fits(&mesh)?;
    Draft::of(mesh).finish("give some").map_err(|fault| fault.problem)
}

/// Whether all that points to nodes and elements points to those that are there.
fn fits(mesh: &Mesh) -> Result<(), String> {
    let (nodes, elements) = (mesh.nodes.len(), mesh.elements.len());
    if let Some(n) = mesh.nodes.iter().position(|x| x.iter().any(|x| !x.is_finite())) {
        return Err(format!("node {} has coordinates that are not finite; mend them", mesh.node_id(n)));
    }
    for (numbers, count, what) in
        [(&mesh.node_ids, nodes, "nodes"), (&mesh.element_ids, elements, "elements")]
    {
        if !numbers.is_empty() && numbers.len() != count {
            let given = numbers.len();
            return Err(format!("{given} numbers are given for {count} {what}; give one for each, or none"));
        }
    }
    for (e, element) in mesh.elements.iter().enumerate() {
        // The unused tail counts too: it repeats the last node.
        if let Some(node) = element.nodes.iter().find(|&&n| n as usize >= nodes) {
            return Err(format!(
                "element {} has the node of index {node}, where there are {nodes}; indices count from 0",
                mesh.element_id(e)
            ));
        }
    }
    let beyond = |e: u32| e as usize >= elements;
    for (name, list) in &mesh.groups {
        if let Some(e) = list.iter().find(|&&e| beyond(e)) {
            return Err(format!(
                "group '{name}' has the element of index {e}, where there are {elements}; indices count from 0"
            ));
        }
    }
    let no_face = |face: &&Face| {
        beyond(face.element)
            || usize::from(face.side) >= mesh.elements[face.element as usize].shape.faces().len()
    };
    for (name, list) in &mesh.faces {
        if let Some(Face { element, side }) = list.iter().find(no_face) {
            return Err(format!(
                "'{name}' has the face {side} of the element of index {element}, which is not there; indices count from 0"
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boxes::BoxSpec;
    use crate::read_with_notes;
    use std::path::Path;

    #[test]
    fn a_mesh_that_was_read_comes_back_as_it_is() {
        let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
        for name in ["tunnel.msh", "shapes.msh"] {
            let (mesh, _) = read_with_notes(data.join(name)).unwrap();
            assert_eq!(sound(mesh.clone()).unwrap().0, mesh, "{name}");
        }
    }

    #[test]
    fn what_does_not_fit_is_refused_and_what_can_be_mended_is() {
        let good = BoxSpec::uniform([0.0; 3], [2.0, 1.0, 1.0], [2, 1, 1]).mesh().unwrap();
        type Spoil = fn(&mut Mesh);
        let spoil: [(&str, Spoil); 7] = [
            ("not finite", |mesh| mesh.nodes[3][1] = f64::NAN),
            ("node of index 99", |mesh| mesh.elements[1].nodes[2] = 99),
            ("group 'a' has the element of index 2", |mesh| drop(mesh.groups.insert("a".into(), vec![2]))),
            ("face 6 of the element of index 1", |mesh| {
                drop(mesh.faces.insert("top".into(), vec![Face { element: 1, side: 6 }]));
            }),
            ("1 numbers are given for 2 elements", |mesh| mesh.element_ids = vec![7]),
            ("element 1 is flat", |mesh| mesh.elements[0].nodes.swap(0, 1)),
            ("no solid elements", |mesh| (mesh.elements, mesh.faces) = Default::default()),
        ];
        for (says, spoil) in spoil {
            let mut mesh = Mesh { groups: Default::default(), ..good.clone() };
            spoil(&mut mesh);
            let fault = sound(mesh).expect_err(says);
            assert!(fault.contains(says) && fault.contains("; "), "{says}: {fault}");
        }
        let mut mirrored = Mesh { groups: Default::default(), ..good.clone() };
        mirrored.elements[0].nodes.rotate_left(4);
        let (mended, notes) = sound(mirrored).unwrap();
        assert_eq!(mended.elements, good.elements);
        assert_eq!(mended.groups["ungrouped"], [0, 1]);
        assert_eq!(notes.len(), 1, "{notes:?}");
    }
}
