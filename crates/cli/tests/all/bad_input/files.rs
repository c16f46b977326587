//! Damaged meshes and records, told at the key of the case that names them, with their own lines.

use super::{Row, refusals, row};

#[rustfmt::skip]
const MESH: &[Row] = &[
    row("2.2 0 8", "3 0 8", 3, "hall.msh, line 2: this is MSH version 3, expected 4.1 or 2", "export it as MSH 4.1 (in Gmsh: File > Export, .msh, `Version 4 ASCII`, or by `gmsh FILE -save -format msh41 -o NEW.msh`)"),
    row("$Nodes\n98", "$Nodes\n99", 3, "hall.msh, line 110: the section ends here, expected a node", "the file is cut short or damaged"),
    row("1 -6 0 -22", "1 -6 0 nan", 3, "hall.msh, line 12: `nan` stands where a coordinate should", "change the mesh"),
    row("1 -6 0 -22", "1 -6 0 1e999", 3, "hall.msh, line 12: `1e999` stands where a coordinate should", "change the mesh"),
    row("1 -6 0 -22", "1 -6 0 twenty", 3, "hall.msh, line 12: `twenty` stands where a coordinate should", "change the mesh"),
    row("1 -6 0 -22", "1 -6 0", 3, "hall.msh, line 12: the line ends where a coordinate should stand", "change the mesh"),
    row("1 -6 0 -22", "1 -6 0 -22\n1 -6 0 -22", 3, "hall.msh, line 109: there are two nodes 1", "renumber the nodes"),
    row("1 5 2 3 3 1 2 9 8 15 16 23 22", "1 5 2 3 3 9999 2 9 8 15 16 23 22", 3, "hall.msh, line 113: node 9999 is not in the section $Nodes", "save the whole mesh again"),
    row("1 5 2 3 3 1 2 9 8 15 16 23 22", "1 5 2 3 3 1 9 2 8 15 16 23 22", 3, "hall.msh: element 1 is flat or partly inside out (its Jacobian is not of one sign)", "repair the mesh there"),
    row("1 5 2 3 3 1 2 9 8 15 16 23 22", "1 5 2 3 3 1 2 9 8 1 2 9 8", 3, "hall.msh: element 1 is flat or partly inside out (its Jacobian is not of one sign)", "repair the mesh there"),
    row("1 5 2 3 3 1 2 9 8 15 16 23 22", "1 5 2 3 3 1 2 9 8 15 16 23", 3, "hall.msh, line 113: the line ends where a node's number should stand", "change the mesh"),
    row("1 5 2 3 3 1 2 9 8 15 16 23 22", "1 99 2 3 3 1 2 9 8 15 16 23 22", 3, "hall.msh, line 113: elements of Gmsh's type 99 are not supported, only tetrahedra, pyramids, wedges and hexahedra of first or second order", "set Mesh.ElementOrder = 1 and mesh again"),
    row("$EndElements\n", "", 3, "hall.msh, line 148: the file ends here, expected $EndElements", "it is cut short"),
    row("$EndNodes\n", "", 3, "hall.msh, line 110: the section $Nodes should end here with $EndNodes", "its counts are wrong, or it is damaged"),
    row("3 1 \"core\"", "3 1 \"\"", 3, "hall.msh, line 6: the physical name is empty", "give it one, or remove the line"),
    row("3 1 \"core\"", "3 7 \"core\"", 24, "no group of the mesh fits 'core'", "the mesh has the groups rock, roof, shell, volume 1"),
    row("$Elements\n", "$Elements\n99999999999", 3, "hall.msh, line 149: the section ends here, expected an element", "the file is cut short or damaged"),
    row("$MeshFormat", "$MeshFormt", 3, "hall.msh: this is no mesh file of a known kind", "known are: Gmsh MSH 4.1 or 2 (ASCII or binary), VTU (VTK's XML), VTK legacy, FLAC3D grid, ANSYS"),
    row("3 1 \"core\"", "3 1 \"=core\"", 3, "no group of a mesh can be called '=core'", "begin with another character"),
];

#[rustfmt::skip]
const RECORD: &[Row] = &[
    row("0.", "x0.", 55, "pulse.txt, line 1: '-x0.000969' is text above the numbers, and a file of plain columns has no header", "put # before each such line, and declare what the columns hold, for example columns = [\"time\","),
    row("\n", "\nnan\n", 55, "pulse.txt, line 2: 'nan' is not a finite number, and the file is of no other format known here", "put # before lines of text; `tremolite list formats` says which formats are read"),
    row("\n", "\ninf\n", 55, "pulse.txt, line 2: 'inf' is not a finite number, and the file is of no other format known here", "put # before lines of text; `tremolite list formats` says which formats are read"),
    row("\n", "\n1 2\n", 55, "pulse.txt, line 2: 2 number(s) on this line, 1 on the first", "complete or remove the line"),
    row("\n", "\n1e400\n", 55, "pulse.txt, line 2: '1e400' is not a finite number, and the file is of no other format known here", "put # before lines of text; `tremolite list formats` says which formats are read"),
    row("\n", "\n1,5\n", 55, "pulse.txt, line 2: '1,5' has a decimal comma, but commas separate numbers here", "write decimal points in the whole file: 0.012"),
    row("\n", "\n1;5\n", 55, "pulse.txt, line 2: 2 number(s) on this line, 1 on the first", "complete or remove the line"),
    row("\n", "\n\u{7}\n", 55, "pulse.txt, line 2: '�…' is not a finite number, and the file is of no other format known here", "put # before lines of text; `tremolite list formats` says which formats are read"),
    row("\n", "\n=1+1\n", 55, "pulse.txt, line 2: '=1+1' is not a finite number, and the file is of no other format known here", "put # before lines of text; `tremolite list formats` says which formats are read"),
];

#[test]
fn each_damage_of_a_mesh_is_told_with_its_line_and_a_way_out() {
    refusals("hall.msh", MESH);
}

#[test]
fn each_damage_of_a_record_is_told_with_its_line_and_a_way_out() {
    refusals("pulse.txt", RECORD);
}
