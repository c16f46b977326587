//! Kinds of files that are not read: what each is, and one way on.

use crate::input::whole;

/// A kind that is known and not read.
pub(crate) struct Foreign {
    /// With its article.
    kind: &'static str,
    recognises: fn(&[u8]) -> bool,
    /// What to do. Each command was tried on the mesh of the tests: Gmsh 4.15, meshio 5.3.5.
    way: &'static str,
}

impl Foreign {
    /// What the user is to know.
    pub(crate) fn problem(&self) -> String {
        format!("this is {}, which is not read; {}", self.kind, self.way)
    }
}

/// The kind of a file that begins so.
pub(crate) fn foreign(head: &[u8]) -> Option<&'static Foreign> {
    KINDS.iter().find(|kind| (kind.recognises)(head))
}

const fn kind(kind: &'static str, recognises: fn(&[u8]) -> bool, way: &'static str) -> Foreign {
    Foreign { kind, recognises, way }
}

/// All of them; the first that fits counts.
const KINDS: &[Foreign] = &[
    kind(
        "a pointer of Git LFS, not the file itself",
        |head| head.starts_with(b"version https://git-lfs"),
        "fetch the file: `git lfs pull`",
    ),
    kind(
        "an Exodus mesh",
        |head| {
            let netcdf =
                head.starts_with(b"CDF\x01") || head.starts_with(b"CDF\x02") || head.starts_with(b"CDF\x05");
            (netcdf || is_hdf5(head)) && holds(head, &["num_nod_per_el", "eb_prop1"])
        },
        "convert it, without its blocks: `meshio convert in.e out.vtu`",
    ),
    kind(
        "a MED mesh (Salome, Code_Aster)",
        |head| is_hdf5(head) && holds(head, &["ENS_MAA", "INFOS_GENERALES"]),
        "convert it: `gmsh in.med -save -o out.msh`",
    ),
    kind(
        "a VTKHDF file",
        |head| is_hdf5(head) && holds(head, &["VTKHDF"]),
        "open it in ParaView and save it as VTU",
    ),
    kind("an HDF5 file", is_hdf5, EXPORT),
    kind("a NetCDF file", |head| head.starts_with(b"CDF\x01") || head.starts_with(b"CDF\x02"), EXPORT),
    kind(
        "an XDMF mesh",
        |head| head.trim_ascii_start().starts_with(b"<") && holds(head, &["<Xdmf"]),
        "convert it: `meshio convert in.xdmf out.vtu`",
    ),
    kind("a UNV universal file", is_unv, "convert it: `gmsh in.unv -save -o out.msh`"),
    kind("a GiD mesh", is_gid, EXPORT),
    kind(
        "an AVS UCD mesh",
        is_ucd,
        "convert it, without materials: `meshio convert --input-format avsucd in.inp out.vtu`",
    ),
    kind(
        "a listing of ANSYS (NLIST, ELIST)",
        |head| holds(head, &["LIST ALL SELECTED", "LIST NODES FOR ALL SELECTED"]),
        "write the mesh with CDWRITE,DB,NAME,cdb",
    ),
    kind("a zip archive", |head| head.starts_with(b"PK\x03\x04"), "unpack it first (unzip)"),
    kind("a file packed by bzip2", |head| head.starts_with(b"BZh"), "unpack it first (bunzip2)"),
    kind("a file packed by xz", |head| head.starts_with(b"\xfd7zXZ\0"), "unpack it first (unxz)"),
    kind("a file packed by zstd", |head| head.starts_with(b"\x28\xb5\x2f\xfd"), "unpack it first (unzstd)"),
    kind("a 7z archive", |head| head.starts_with(b"7z\xbc\xaf\x27\x1c"), "unpack it first (7z x)"),
    kind("a rar archive", |head| head.starts_with(b"Rar!\x1a\x07"), "unpack it first (unrar x)"),
    kind("a tar archive", |head| head.get(257..262) == Some(b"ustar"), "unpack it first (tar -x)"),
];

const EXPORT: &str = "export the mesh as Abaqus, Gmsh, Nastran or VTU from the program that wrote it";

fn is_hdf5(head: &[u8]) -> bool {
    head.starts_with(b"\x89HDF\r\n\x1a\n")
}

fn holds(head: &[u8], words: &[&str]) -> bool {
    words.iter().any(|word| head.windows(word.len()).any(|window| window == word.as_bytes()))
}

/// The first lines that are neither blank nor a comment after `#`.
fn lines(head: &[u8]) -> impl Iterator<Item = &[u8]> {
    let lines = head.split(|&b| b == b'\n').map(<[u8]>::trim_ascii);
    lines.filter(|line| !line.is_empty() && !line.starts_with(b"#"))
}

/// Whether a dataset begins: -1, then its number.
fn is_unv(head: &[u8]) -> bool {
    let mut lines = lines(head);
    lines.next() == Some(b"-1") && lines.next().is_some_and(|line| whole(line).is_some())
}

fn is_gid(head: &[u8]) -> bool {
    let first = lines(head).next().unwrap_or_default().to_ascii_lowercase();
    first.starts_with(b"gid post results file")
        || (first.starts_with(b"mesh") && holds(&first, &["elemtype"]))
}

/// Whether five counts come first, then a node of a number and three coordinates.
fn is_ucd(head: &[u8]) -> bool {
    let mut lines = lines(head);
    let mut fields = |count: usize| {
        let fields: Vec<&[u8]> =
            lines.next()?.split(u8::is_ascii_whitespace).filter(|field| !field.is_empty()).collect();
        (fields.len() == count).then_some(fields)
    };
    fields(5).is_some_and(|counts| counts.iter().all(|field| whole(field).is_some()))
        && fields(4).is_some_and(|node| whole(node[0]).is_some())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kinds_that_are_not_read_are_named_with_a_way_on() {
        let hdf5 = |inside: &str| [b"\x89HDF\r\n\x1a\n", inside.as_bytes()].concat();
        let tar = [vec![0; 257], b"ustar".to_vec()].concat();
        let text = |text: &str| text.as_bytes().to_vec();
        for (head, kind, way) in [
            (text("version https://git-lfs.github.com/spec/v1\noid sha256:0\n"), "Git LFS", "git lfs pull"),
            (text("CDF\x01 .. num_nod_per_el1"), "Exodus", "meshio convert in.e out.vtu"),
            (hdf5("connect1 eb_prop1"), "Exodus", "meshio convert in.e out.vtu"),
            (hdf5("ENS_MAA"), "MED", "gmsh in.med -save -o out.msh"),
            (hdf5("VTKHDF"), "VTKHDF", "ParaView"),
            (hdf5(""), "HDF5", "from the program that wrote it"),
            (text("CDF\x02"), "NetCDF", "from the program that wrote it"),
            (text("<?xml version=\"1.0\"?>\n<Xdmf Version=\"3.0\">"), "XDMF", "meshio convert in.xdmf"),
            (text("    -1\n  2411\n"), "UNV", "gmsh in.unv -save -o out.msh"),
            (text("# x\nMESH \"a\" dimension 3 ElemType Hexahedra Nnode 8\n"), "GiD", "export the mesh"),
            (text("# x\n2 1 0 0 0\n1 0.0 0.0 0.0\n"), "UCD", "--input-format avsucd"),
            (text("\n LIST ALL SELECTED NODES.   DSYS=      0\n"), "ANSYS", "CDWRITE"),
            (text("PK\x03\x04"), "zip", "unzip"),
            (text("BZh9"), "bzip2", "bunzip2"),
            (b"\xfd7zXZ\0".to_vec(), "xz", "unxz"),
            (b"\x28\xb5\x2f\xfd".to_vec(), "zstd", "unzstd"),
            (b"7z\xbc\xaf\x27\x1c".to_vec(), "7z", "7z x"),
            (b"Rar!\x1a\x07".to_vec(), "rar", "unrar"),
            (tar, "tar", "tar -x"),
        ] {
            let problem = foreign(&head).unwrap_or_else(|| panic!("{kind} is not known")).problem();
            assert!(problem.contains(kind) && problem.contains(way), "{kind}: {problem}");
        }
        for other in ["", "-1\nx\n", "MESH\n", "1 2 3 4 5\n1 2 3\n", "1 2 3 4\n", "a,b\n"] {
            assert!(foreign(other.as_bytes()).is_none(), "{other}");
        }
    }
}
