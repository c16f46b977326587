//! A grid in one file or in several: a PVTU file, which names the files of its pieces and the arrays that all of them have.
//!
//! Of points on the border of pieces each piece has its own. Where a point array [`NODE`] numbers them, they are one again in what is read,
//! in the order of these numbers.

use std::fmt::Write as _;
use std::fs;
use std::io::{Read, Seek, Write as _};
use std::path::Path;

use roxmltree::Document;

use super::header::{UNIT_KEY, type_name};
use super::read::{append, parse};
use super::write::escape;
use super::{Array, Grid, Values, VtuError};

/// The point array by which points of several pieces are the same.
pub const NODE: &str = "node";

/// VTK's word for what a PVTU file is.
const KIND: &str = "PUnstructuredGrid";

impl Grid {
    /// Reads a VTU file: ASCII, base64 or raw, inline or appended, with zlib or without, in either byte
    /// order, of one piece or several; and all pieces of a PVTU file, whose points are joined where a point array [`NODE`] numbers
    /// them.
    ///
    /// # Errors
    /// If the file cannot be opened, is damaged, or is no unstructured grid.
    pub fn read(path: &Path) -> Result<Grid, VtuError> {
        let mut file =
            fs::File::open(path).map_err(|source| VtuError::Io { path: path.to_owned(), source })?;
        if is_list(&mut file).map_err(|source| VtuError::Io { path: path.to_owned(), source })? {
            return all_pieces(path);
        }
        parse(&mut file, |_| true).map_err(|reason| VtuError::Format { path: path.to_owned(), reason })
    }
}

/// Writes a PVTU file beside the files of its pieces, which are there and have the arrays of one of them, `like`.
///
/// # Errors
/// If the file cannot be written.
pub fn write_list(path: &Path, like: &Grid, pieces: &[String]) -> Result<(), VtuError> {
    let mut xml = format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"{KIND}\" version=\"1.0\" byte_order=\"LittleEndian\" \
         header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<{KIND} GhostLevel=\"0\">\n"
    );
    for (tag, arrays) in [("PPointData", &like.point_data), ("PCellData", &like.cell_data)] {
        let _ = writeln!(xml, "<{tag}>");
        for Array { name, unit, components, values } in arrays {
            let (kind, name) = (type_name(values), escape(name));
            let _ = write!(
                xml,
                "<PDataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\""
            );
            let _ = match unit.as_str() {
                "" => writeln!(xml, "/>"),
                unit => writeln!(
                    xml,
                    "><InformationKey name=\"{UNIT_KEY}\" location=\"vtkDataArray\">{}</InformationKey></PDataArray>",
                    escape(unit)
                ),
            };
        }
        let _ = writeln!(xml, "</{tag}>");
    }
    xml.push_str(
        "<PPoints>\n<PDataArray type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"/>\n</PPoints>\n",
    );
    for piece in pieces {
        let _ = writeln!(xml, "<Piece Source=\"{}\"/>", escape(piece));
    }
    let _ = write!(xml, "</{KIND}>\n</VTKFile>\n");
    tremolite_files::replace(path, |out| out.write_all(xml.as_bytes()))
        .map_err(|source| VtuError::Io { path: path.to_owned(), source })
}

/// Whether a file names pieces.
fn is_list(file: &mut fs::File) -> std::io::Result<bool> {
    let mut head = Vec::new();
    Read::by_ref(file).take(512).read_to_end(&mut head)?;
    file.rewind()?;
    let named = format!("type=\"{KIND}\"");
    Ok(head.windows(named.len()).any(|w| w == named.as_bytes()))
}

/// All pieces of a grid, from the files that a file beside them names.
fn all_pieces(path: &Path) -> Result<Grid, VtuError> {
    let io = |path: &Path| {
        let path = path.to_owned();
        move |source| VtuError::Io { path, source }
    };
    let format = |path: &Path| {
        let path = path.to_owned();
        move |reason: String| VtuError::Format { path, reason }
    };
    let text = fs::read_to_string(path).map_err(io(path))?;
    let document = Document::parse(&text).map_err(|e| format(path)(format!("it is not XML: {e}")))?;
    let mut all: Option<Grid> = None;
    for node in document.descendants().filter(|node| node.has_tag_name("Piece")) {
        let source = node.attribute("Source").unwrap_or_default();
        // A folder may come from anybody: nothing outside it is read.
        if source.is_empty() || source.contains(['/', '\\', ':']) || source == ".." {
            return Err(format(path)(format!("`Source` of a piece is no file beside it: {source:?}")));
        }
        let file = path.with_file_name(source);
        let mut opened = fs::File::open(&file).map_err(io(&file))?;
        let piece = parse(&mut opened, |_| true).map_err(format(&file))?;
        match &mut all {
            None => all = Some(piece),
            Some(all) => append(all, piece).map_err(format(&file))?,
        }
    }
    let mut all = all.ok_or_else(|| format(path)("it names no <Piece>".into()))?;
    join(&mut all);
    Ok(all)
}

/// Makes points of one number one, in the order of the numbers.
fn join(grid: &mut Grid) {
    let numbered = |array: &Array| {
        array.name == NODE && array.components == 1 && matches!(array.values, Values::Int64(_))
    };
    let Some(at) = grid.point_data.iter().position(numbered) else { return };
    let Values::Int64(numbers) = grid.point_data.remove(at).values else { return };
    let mut order: Vec<usize> = (0..numbers.len()).collect();
    order.sort_by_key(|&point| numbers[point]);
    let (mut kept, mut place) = (Vec::new(), vec![0; numbers.len()]);
    for point in order {
        if kept.last().is_none_or(|&last: &usize| numbers[last] != numbers[point]) {
            kept.push(point);
        }
        place[point] = kept.len() as u32 - 1;
    }
    grid.points = kept.iter().map(|&point| grid.points[point]).collect();
    grid.connectivity.iter_mut().for_each(|point| *point = place[*point as usize]);
    for Array { components, values, .. } in &mut grid.point_data {
        let count = *components;
        *values = match &*values {
            Values::Float32(all) => Values::Float32(some(all, &kept, count)),
            Values::Float64(all) => Values::Float64(some(all, &kept, count)),
            Values::Int32(all) => Values::Int32(some(all, &kept, count)),
            Values::Int64(all) => Values::Int64(some(all, &kept, count)),
            Values::UInt8(all) => Values::UInt8(some(all, &kept, count)),
        };
    }
}

/// So many numbers of each of some points.
fn some<T: Copy>(values: &[T], points: &[usize], count: usize) -> Vec<T> {
    points.iter().flat_map(|&point| &values[count * point..count * (point + 1)]).copied().collect()
}
