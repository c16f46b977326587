//! Which lines and accounts the balance has.

use crate::ready::{Ready, body, joint};
use std::sync::Arc;
use tremolite_engine::parts::{Motion, Own, Part, Scratch, Tick};
use tremolite_engine::{Line, Lines, Member, Problem, Side};
use tremolite_laws::Row;
use tremolite_mesh::boxes::BoxSpec;

fn layers() -> Problem {
    let mesh = BoxSpec::uniform([0.0; 3], [3.0, 3.0, 4.0], [3, 3, 4]).mesh().unwrap();
    Problem::new(mesh, vec![body("below", (0..18).collect()), body("above", (18..36).collect())])
}

/// Lines of the balance that a model cannot have are no columns of its tables.
#[test]
fn a_balance_has_the_lines_that_a_model_can_have() {
    let lines = |ready: &Ready| ready.assembly.lines().collect::<Vec<_>>();
    let mut plain = layers();
    let none = [Line::Own, Line::Levels, Line::FreeField, Line::Interface, Line::Bolts];
    let found = lines(&Ready::new(plain.clone()));
    assert!(none.iter().all(|line| !found.contains(line)), "{found:?}");
    let without = found.len();
    plain.sides = [Side::FreeField; 2];
    let found = lines(&Ready::new(plain.clone()));
    assert!(found.contains(&Line::FreeField) && found.len() == without + 1, "{found:?}");
    let found = lines(&Ready::new(plain).levelled(|[.., z]| u8::from(z > 2.0)));
    assert!(found.contains(&Line::Levels) && found.len() == without + 2, "{found:?}");
    let mut parted = layers();
    parted.interfaces = vec![joint(&parted, [0, 1], 1e11)];
    let found = lines(&Ready::new(parted));
    assert!(found.contains(&Line::Interface) && !found.contains(&Line::Bolts), "{found:?}");
}

/// Elements of a program's own, without stiffness.
struct Slack {
    nodes: [u32; 2],
    elements: usize,
}

impl Part for Slack {
    fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    fn elements(&self) -> (usize, usize) {
        (self.elements, 1)
    }

    fn forces(&self, _: &Tick, _: &Motion, _: Own, out: &mut [Row], _: &mut Scratch) -> Lines {
        out.fill(Row::ZERO);
        Lines::default()
    }

    fn stiffness_times(&self, _: &[Row], out: &mut [Row], _: &mut Scratch) {
        out.fill(Row::ZERO);
    }
}

/// Behind those of the user's bodies, in their order; what has no elements has none.
#[test]
fn parts_of_a_programs_own_with_elements_have_accounts_behind_those_of_bodies() {
    let mut problem = layers();
    for (name, elements) in [("truss", 3), ("spring", 0), ("cable", 1)] {
        problem.parts.push(Arc::new(move |_, engine: &[u32]| {
            let part = Slack { nodes: [engine[0], engine[1]], elements };
            Member::new(name, Box::new(part))
        }));
    }
    let ready = Ready::new(problem);
    let assembly = &ready.assembly;
    assert_eq!(assembly.accounts, ["below", "above", "truss", "cable"]);
    let account = |name: &str| {
        let m = assembly.members.iter().position(|member| member.name == name).unwrap();
        assembly.account[m].map(|account| assembly.accounts[usize::from(account)].as_str())
    };
    assert_eq!(["truss", "spring", "cable"].map(account), [Some("truss"), None, Some("cable")]);
    for (m, member) in assembly.members.iter().enumerate() {
        if let Some(body) = member.body {
            assert_eq!(assembly.account[m], Some(body as u16), "{}", member.name);
        }
    }
}
