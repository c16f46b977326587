//! Instances of parts, and included files.

use super::*;

/// A unit cube, twice: as it is, and moved by (2, 0, 0) and turned a quarter about z through the origin.
pub(super) const ASSEMBLED: &str = "\
*Heading
*Part, name=Block
*Node
1, 0, 0, 0
2, 1, 0, 0
3, 1, 1, 0
4, 0, 1, 0
5, 0, 0, 1
6, 1, 0, 1
7, 1, 1, 1
8, 0, 1, 1
*Element, type=C3D8
1, 1, 2, 3, 4, 5, 6, 7, 8
*Elset, elset=rock
1
*End Part
*Part, name=Empty
*End Part
*Assembly, name=Assembly
*Instance, name=Block-1, part=Block
*End Instance
*Instance, name=Block-2, part=block
2, 0, 0
0, 0, 0, 0, 0, 1, 90
*End Instance
*Instance, name=Own, part=Empty
*Node
1, 0, 0, 5
2, 1, 0, 5
3, 0, 1, 5
4, 0, 0, 6
*Element, type=C3D4
1, 1, 2, 3, 4
*End Instance
*Node
1, 0, 0, 9
*Nset, nset=ref
1
*Nset, nset=corner, instance=Block-2
7
*Elset, elset=_top_S2, internal, instance=Block-1
1
*Elset, elset=_top_S2, internal, instance=Block-2
1
*Surface, type=ELEMENT, name=top
_top_S2, S2
*Elset, elset=pair
Block-1.rock, Block-2.1
*End Assembly
";

#[test]
fn instances_are_moved_and_turned_and_their_sets_told_apart() {
    let (mesh, notes) = with_notes(ASSEMBLED).unwrap();
    assert_eq!((mesh.nodes.len(), mesh.elements.len()), (20, 3));
    assert_eq!((mesh.element_ids.len(), mesh.node_ids.len()), (0, 20), "the node of the assembly is dropped");
    let groups: Vec<(&str, &[u32])> = mesh.groups.iter().map(|(n, g)| (n.as_str(), g.as_slice())).collect();
    let wanted: [(&str, &[u32]); 4] =
        [("Block-1.rock", &[0]), ("Block-2.rock", &[1]), ("Own", &[2]), ("pair", &[0, 1])];
    assert_eq!(groups, wanted);
    // Corner 7 at (1, 1, 1) moves to (3, 1, 1) and turns to (-1, 3, 1).
    for (x, wanted) in mesh.points["corner"].iter().zip([-1.0, 3.0, 1.0]) {
        assert!((x - wanted).abs() < 1e-15);
    }
    assert_eq!(mesh.points["ref"], [0.0, 0.0, 9.0]);
    assert_eq!(mesh.faces["top"], [Face { element: 0, side: 5 }, Face { element: 1, side: 5 }]);
    assert!(notes.contains(&Note::Renumbered), "{notes:?}");
}

#[test]
fn includes_are_followed_and_circles_refused() {
    let folder = std::env::temp_dir().join(format!("tremolite-abaqus-{}", std::process::id()));
    fs::create_dir_all(folder.join("mesh")).unwrap();
    let path = folder.join("main.inp");
    let (nodes, rest) = FLAT.split_once("*ELEMENT").unwrap();
    let (title, nodes) = nodes.split_once("*NODE, nset=ALL\n").unwrap();
    fs::write(&path, format!("{title}*INCLUDE, INPUT=mesh/nodes.inp\n*ELEMENT{rest}")).unwrap();
    fs::write(folder.join("mesh/nodes.inp"), "*NODE, INPUT=\"list.txt\", nset=ALL\n").unwrap();
    fs::write(folder.join("mesh/list.txt"), nodes).unwrap();
    let read = crate::read_with_notes(&path).unwrap();
    assert!(read == with_notes(FLAT).unwrap());

    let message = |file: &str, text: &str| {
        fs::write(folder.join(file), text).unwrap();
        crate::read(&path).unwrap_err().to_string()
    };
    let problem = message("mesh/list.txt", &nodes.replace("1e0", "1eO"));
    assert!(problem.contains("mesh/list.txt, line 4: `1eO` stands where a coordinate should"), "{problem}");
    let problem = message("mesh/list.txt", "1, 0, 0, 0\n*INCLUDE, INPUT=../main.inp\n");
    assert!(problem.contains("list.txt, line 2") && problem.contains("includes itself"), "{problem}");
    let problem = message("mesh/list.txt", "*INCLUDE, INPUT=nodes.inp\n");
    assert!(problem.contains("includes itself"), "{problem}");
    let problem = message("mesh/nodes.inp", "*include, input=absent.inp\n");
    assert!(
        problem.contains("nodes.inp, line 1: the included file") && problem.contains("absent.inp"),
        "{problem}"
    );
    fs::remove_dir_all(&folder).unwrap();
}
