//! Interfaces of several problems.

use crate::VerifyError;
use tremolite::{Interface, interface_laws};
use tremolite_laws::{Choice, Need, Value, Values};
use tremolite_mesh::{Element, Mesh};

/// An interface of a law of the list between two sets of elements, normals out of the first into the second; what is not
/// given has the law's default, or is left to be chosen.
///
/// # Errors
/// If there is no such law, or it refuses the values.
pub fn joint(
    sides: [Vec<u32>; 2],
    law: &str,
    numbers: &[(&str, f64)],
    words: &[(&str, &str)],
) -> Result<Interface, VerifyError> {
    let known = interface_laws().into_iter().find(|known| known.info.name == law);
    let law = known.ok_or_else(|| VerifyError::Setup(format!("there is no interface law '{law}'")))?;
    let mut values = Values::default();
    for parameter in law.info.parameters {
        let default = match parameter.need {
            Need::Number(x) => Value::Number(x),
            Need::Word(word) => Value::Word(word.into()),
            _ => continue,
        };
        values.0.insert(parameter.name.into(), default);
    }
    values = numbers.iter().fold(values, |values, (name, x)| values.with(name, *x));
    for (name, word) in words {
        values.0.insert((*name).into(), Value::Word((*word).into()));
    }
    let choice = Choice { stiffness: 1e15, least: 0.0, pressure: Interface::PRESSURE };
    let whole = (law.info.chosen)(&values, &choice);
    (law.build)(&whole).map_err(|faults| VerifyError::Setup(format!("{faults:?}")))?;
    Ok(Interface::new("joint", sides, law, values))
}

/// Two meshes as one, the second's nodes and elements behind the first's; nodes at one place stay two.
pub fn together(first: &Mesh, second: &Mesh) -> Mesh {
    let shift = first.nodes.len() as u32;
    let moved = second
        .elements
        .iter()
        .map(|&Element { shape, nodes }| Element { shape, nodes: nodes.map(|n| n + shift) });
    Mesh {
        nodes: first.nodes.iter().chain(&second.nodes).copied().collect(),
        elements: first.elements.iter().copied().chain(moved).collect(),
        ..Mesh::default()
    }
}
