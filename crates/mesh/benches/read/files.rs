//! A mesh of hexahedra in every format: by the crate's writers where there is one, else in the plainest form.

use std::fs::File;
use std::io::{BufWriter, Write};
use std::path::Path;
use tremolite_mesh::Mesh;
use tremolite_mesh::write::{WRITERS, write_as};

type Out<'a> = &'a mut dyn Write;

/// What writes a file.
type Writer = fn(&Path, &Mesh);

/// Formats by name.
pub const FILES: [(&str, Writer); 15] = [
    ("MSH 4.1 binary", |p, m| own(p, m, "Gmsh MSH 4.1 binary")),
    ("MSH 4.1 ASCII", |p, m| own(p, m, "Gmsh MSH 4.1 ASCII")),
    ("MSH 2.2 binary", |p, m| with(p, |o| msh2(o, m, true))),
    ("MSH 2.2 ASCII", |p, m| with(p, |o| msh2(o, m, false))),
    ("Abaqus .inp", |p, m| own(p, m, "Abaqus")),
    ("VTU zlib, appended", |p, m| own(p, m, "VTU")),
    ("VTU raw, appended", |p, m| with(p, |o| vtu(o, m, true))),
    ("VTU ASCII", |p, m| with(p, |o| vtu(o, m, false))),
    ("VTK 4.2 binary", |p, m| with(p, |o| vtk(o, m, true, false))),
    ("VTK 4.2 ASCII", |p, m| with(p, |o| vtk(o, m, false, false))),
    ("VTK 5.1 binary", |p, m| with(p, |o| vtk(o, m, true, true))),
    ("VTK 5.1 ASCII", |p, m| with(p, |o| vtk(o, m, false, true))),
    ("FLAC3D ASCII", |p, m| with(p, |o| f3grid(o, m))),
    ("FLAC3D binary", |p, m| with(p, |o| f3grid_binary(o, m))),
    ("ANSYS .cdb", |p, m| with(p, |o| cdb(o, m))),
];

fn own(path: &Path, mesh: &Mesh, name: &str) {
    let writer = WRITERS.iter().find(|w| w.name == name).unwrap();
    write_as(path, mesh, writer).unwrap();
}

fn with(path: &Path, write: impl Fn(Out) -> std::io::Result<()>) {
    let mut out = BufWriter::new(File::create(path).unwrap());
    write(&mut out).unwrap();
    out.flush().unwrap();
}

fn msh2(out: Out, mesh: &Mesh, binary: bool) -> std::io::Result<()> {
    writeln!(out, "$MeshFormat\n2.2 {} 8", u8::from(binary))?;
    if binary {
        out.write_all(&1_i32.to_le_bytes())?;
        writeln!(out)?;
    }
    writeln!(
        out,
        "$EndMeshFormat\n$PhysicalNames\n1\n3 1 \"rock\"\n$EndPhysicalNames\n$Nodes\n{}",
        mesh.nodes.len()
    )?;
    for (n, x) in (1_i32..).zip(&mesh.nodes) {
        if binary {
            out.write_all(&n.to_le_bytes())?;
            x.iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))?;
        } else {
            writeln!(out, "{n} {} {} {}", x[0], x[1], x[2])?;
        }
    }
    writeln!(out, "$EndNodes\n$Elements\n{}", mesh.elements.len())?;
    if binary {
        [5, mesh.elements.len() as i32, 2].iter().try_for_each(|n| out.write_all(&n.to_le_bytes()))?;
    }
    for (e, element) in (1..).zip(&mesh.elements) {
        let nodes = element.nodes.map(|n| n as i32 + 1);
        if binary {
            [e, 1, 1].iter().chain(&nodes).try_for_each(|n| out.write_all(&n.to_le_bytes()))?;
        } else {
            write!(out, "{e} 5 2 1 1")?;
            nodes.iter().try_for_each(|n| write!(out, " {n}"))?;
            writeln!(out)?;
        }
    }
    writeln!(out, "$EndElements")
}

fn vtu(out: Out, mesh: &Mesh, raw: bool) -> std::io::Result<()> {
    let (points, cells) = (mesh.nodes.len() as u64, mesh.elements.len() as u64);
    writeln!(
        out,
        "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
    )?;
    writeln!(out, "<UnstructuredGrid><Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">")?;
    let sizes = [24 * points, 64 * cells, 8 * cells, cells];
    let mut offset = 0;
    let mut open = |out: Out, k: usize, attributes: &str| {
        let end = if raw { "/>" } else { ">" };
        let format = if raw { format!("appended\" offset=\"{offset}") } else { "ascii".to_owned() };
        offset += 8 + sizes[k];
        writeln!(out, "<DataArray {attributes} format=\"{format}\"{end}")
    };
    let close = |out: Out| if raw { Ok(()) } else { writeln!(out, "</DataArray>") };
    writeln!(out, "<Points>")?;
    open(out, 0, "type=\"Float64\" NumberOfComponents=\"3\"")?;
    if !raw {
        mesh.nodes.iter().try_for_each(|x| writeln!(out, "{} {} {}", x[0], x[1], x[2]))?;
    }
    close(out)?;
    writeln!(out, "</Points><Cells>")?;
    open(out, 1, "type=\"Int64\" Name=\"connectivity\"")?;
    if !raw {
        for element in &mesh.elements {
            element.nodes.iter().try_for_each(|n| write!(out, "{n} "))?;
            writeln!(out)?;
        }
    }
    close(out)?;
    open(out, 2, "type=\"Int64\" Name=\"offsets\"")?;
    if !raw {
        (1..=cells).try_for_each(|c| writeln!(out, "{}", 8 * c))?;
    }
    close(out)?;
    open(out, 3, "type=\"UInt8\" Name=\"types\"")?;
    if !raw {
        (0..cells).try_for_each(|_| writeln!(out, "12"))?;
    }
    close(out)?;
    writeln!(out, "</Cells></Piece></UnstructuredGrid>")?;
    if raw {
        write!(out, "<AppendedData encoding=\"raw\">_")?;
        out.write_all(&sizes[0].to_le_bytes())?;
        mesh.nodes.iter().flatten().try_for_each(|x| out.write_all(&x.to_le_bytes()))?;
        out.write_all(&sizes[1].to_le_bytes())?;
        mesh.elements
            .iter()
            .flat_map(|e| e.nodes)
            .try_for_each(|n| out.write_all(&i64::from(n).to_le_bytes()))?;
        out.write_all(&sizes[2].to_le_bytes())?;
        (1..=cells).try_for_each(|c| out.write_all(&(8 * c).to_le_bytes()))?;
        out.write_all(&sizes[3].to_le_bytes())?;
        (0..cells).try_for_each(|_| out.write_all(&[12]))?;
        writeln!(out, "</AppendedData>")?;
    }
    writeln!(out, "</VTKFile>")
}

fn vtk(out: Out, mesh: &Mesh, binary: bool, offsets: bool) -> std::io::Result<()> {
    let version = if offsets { "5.1" } else { "4.2" };
    let word = if binary { "BINARY" } else { "ASCII" };
    let (points, cells) = (mesh.nodes.len(), mesh.elements.len());
    writeln!(
        out,
        "# vtk DataFile Version {version}\nmesh\n{word}\nDATASET UNSTRUCTURED_GRID\nPOINTS {points} double"
    )?;
    for x in &mesh.nodes {
        if binary {
            x.iter().try_for_each(|x| out.write_all(&x.to_be_bytes()))?;
        } else {
            writeln!(out, "{} {} {}", x[0], x[1], x[2])?;
        }
    }
    let long = |out: Out, n: i64| {
        if binary { out.write_all(&n.to_be_bytes()) } else { writeln!(out, "{n}") }
    };
    let int = |out: Out, n: i32| {
        if binary { out.write_all(&n.to_be_bytes()) } else { write!(out, "{n} ") }
    };
    if offsets {
        writeln!(out, "\nCELLS {} {}\nOFFSETS vtktypeint64", cells + 1, 8 * cells)?;
        (0..=cells as i64).try_for_each(|c| long(out, 8 * c))?;
        writeln!(out, "\nCONNECTIVITY vtktypeint64")?;
        mesh.elements.iter().flat_map(|e| e.nodes).try_for_each(|n| long(out, i64::from(n)))?;
    } else {
        writeln!(out, "\nCELLS {cells} {}", 9 * cells)?;
        for element in &mesh.elements {
            int(out, 8)?;
            element.nodes.iter().try_for_each(|&n| int(out, n as i32))?;
            if !binary {
                writeln!(out)?;
            }
        }
    }
    writeln!(out, "\nCELL_TYPES {cells}")?;
    (0..cells).try_for_each(|_| int(out, 12))?;
    writeln!(out)
}

/// Where FLAC3D's gridpoints stand in our order.
const FLAC: [usize; 8] = [0, 1, 3, 4, 2, 7, 5, 6];

fn f3grid(out: Out, mesh: &Mesh) -> std::io::Result<()> {
    writeln!(out, "* GRIDPOINTS")?;
    for (n, x) in (1..).zip(&mesh.nodes) {
        writeln!(out, "G {n} {} {} {}", x[0], x[1], x[2])?;
    }
    writeln!(out, "* ZONES")?;
    for (e, element) in (1..).zip(&mesh.elements) {
        write!(out, "Z B8 {e}")?;
        FLAC.iter().try_for_each(|&k| write!(out, " {}", element.nodes[k] + 1))?;
        writeln!(out)?;
    }
    for (name, list) in &mesh.groups {
        writeln!(out, "ZGROUP \"{name}\" SLOT 1")?;
        for line in list.chunks(10) {
            line.iter().try_for_each(|e| write!(out, " {}", e + 1))?;
            writeln!(out)?;
        }
    }
    Ok(())
}

fn f3grid_binary(out: Out, mesh: &Mesh) -> std::io::Result<()> {
    out.write_all(&[0xe6, 0xe7, 0xf6, 0x51, 3, 0, 0, 0])?;
    let int = |out: Out, n: u32| out.write_all(&n.to_le_bytes());
    int(out, mesh.nodes.len() as u32)?;
    for (n, x) in (1..).zip(&mesh.nodes) {
        int(out, n)?;
        x.iter().try_for_each(|x| out.write_all(&x.to_le_bytes()))?;
    }
    int(out, mesh.elements.len() as u32)?;
    for (e, element) in (1..).zip(&mesh.elements) {
        int(out, e)?;
        int(out, 8)?;
        FLAC.iter().try_for_each(|&k| int(out, element.nodes[k] + 1))?;
    }
    int(out, mesh.groups.len() as u32)?;
    for (name, list) in &mesh.groups {
        for text in [name.as_str(), "1"] {
            out.write_all(&(text.len() as u16).to_le_bytes())?;
            out.write_all(text.as_bytes())?;
        }
        int(out, list.len() as u32)?;
        list.iter().try_for_each(|e| int(out, e + 1))?;
    }
    // No faces, no groups of them.
    int(out, 0)?;
    int(out, 0)
}

fn cdb(out: Out, mesh: &Mesh) -> std::io::Result<()> {
    writeln!(out, "/PREP7\nET,1,185\nNBLOCK,6,SOLID,{0},{0}\n(3i9,6e21.13e3)", mesh.nodes.len())?;
    for (n, x) in (1..).zip(&mesh.nodes) {
        write!(out, "{n:9}{:9}{:9}", 0, 0)?;
        for x in x {
            let text = format!("{x:.13e}");
            let (digits, power) = text.split_once('e').unwrap();
            let power: i32 = power.parse().unwrap();
            write!(out, "{:>21}", format!("{digits}E{power:+04}"))?;
        }
        writeln!(out)?;
    }
    writeln!(out, "N,R5.3,LOC,       -1,\nEBLOCK,19,SOLID,{0},{0}\n(19i9)", mesh.elements.len())?;
    for (e, element) in (1..).zip(&mesh.elements) {
        for n in [1, 1, 1, 1, 0, 0, 0, 0, 8, 0, e] {
            write!(out, "{n:9}")?;
        }
        element.nodes.iter().try_for_each(|n| write!(out, "{:9}", n + 1))?;
        writeln!(out)?;
    }
    writeln!(out, "       -1")?;
    for (name, list) in &mesh.groups {
        writeln!(out, "CMBLOCK,{name},ELEM,{}\n(8i10)", list.len())?;
        for line in list.chunks(8) {
            line.iter().try_for_each(|e| write!(out, "{:10}", e + 1))?;
            writeln!(out)?;
        }
    }
    writeln!(out, "FINISH")
}
