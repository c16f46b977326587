//! Reading back the files that [`Grid::write`] makes.

use std::fs;
use std::io::Read;
use std::path::Path;

use flate2::read::ZlibDecoder;
use roxmltree::{Document, Node};

use super::header::{APPENDED, UNIT_KEY};
use super::{Array, Grid, Values, VtuError};

impl Grid {
    /// Reads a VTU file of the kind [`Grid::write`] makes.
    ///
    /// # Errors
    /// If the file cannot be opened, is damaged, or has another layout (inline or base64 data, another
    /// compressor, several pieces, big endian, 32-bit headers).
    pub fn read(path: &Path) -> Result<Grid, VtuError> {
        let bytes = fs::read(path).map_err(|source| VtuError::Io { path: path.to_owned(), source })?;
        parse(&bytes).map_err(|reason| VtuError::Format { path: path.to_owned(), reason })
    }
}

/// The grid in a file's bytes.
pub(super) fn parse(bytes: &[u8]) -> Result<Grid, String> {
    let mark = bytes
        .windows(APPENDED.len())
        .position(|w| w == APPENDED.as_bytes())
        .ok_or("no raw appended data; read it with ParaView or meshio and save it from there")?;
    // The XML proper, closed where the raw data begin, is well formed.
    let mut xml = std::str::from_utf8(&bytes[..mark]).map_err(|_| "the header is not UTF-8")?.to_owned();
    xml.push_str("</VTKFile>");
    let rest = &bytes[mark + APPENDED.len()..];
    let start = rest.iter().position(|&b| b == b'_').ok_or("the appended data have no start mark `_`")?;
    let data = &rest[start + 1..];

    let document = Document::parse(&xml).map_err(|e| format!("the header is not XML: {e}"))?;
    let root = document.root_element();
    for (name, wanted) in [
        ("type", "UnstructuredGrid"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
        ("compressor", "vtkZLibDataCompressor"),
    ] {
        let found = root.attribute(name).unwrap_or("nothing");
        if found != wanted {
            return Err(format!("{name} is {found}, expected {wanted}"));
        }
    }
    let grid = child(root, "UnstructuredGrid")?;
    let piece = child(grid, "Piece")?;
    if grid.children().filter(|n| n.has_tag_name("Piece")).count() != 1 {
        return Err("it has several pieces".to_owned());
    }

    let Values::Float64(coordinates) = read_array(only(child(piece, "Points")?)?, data)?.values else {
        return Err("the points are not Float64".to_owned());
    };
    let cells = child(piece, "Cells")?;
    let read = Grid {
        points: coordinates.as_chunks::<3>().0.to_vec(),
        connectivity: indices(named(cells, "connectivity")?, data)?,
        offsets: indices(named(cells, "offsets")?, data)?,
        types: raw(named(cells, "types")?, data)?,
        point_data: arrays(piece, "PointData", data)?,
        cell_data: arrays(piece, "CellData", data)?,
        time: time(grid, data)?,
    };
    let counts = [("NumberOfPoints", read.points.len()), ("NumberOfCells", read.offsets.len())];
    for (attribute, found) in counts {
        if number(piece, attribute)? != found {
            return Err(format!("{attribute} disagrees with the data, which have {found}"));
        }
    }
    read.check()?;
    Ok(read)
}

fn child<'a, 'i>(node: Node<'a, 'i>, tag: &str) -> Result<Node<'a, 'i>, String> {
    node.children().find(|n| n.has_tag_name(tag)).ok_or_else(|| format!("the header has no <{tag}>"))
}

fn only<'a, 'i>(node: Node<'a, 'i>) -> Result<Node<'a, 'i>, String> {
    child(node, "DataArray")
}

fn named<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Result<Node<'a, 'i>, String> {
    node.children()
        .find(|n| n.attribute("Name") == Some(name))
        .ok_or_else(|| format!("the header has no array `{name}`"))
}

fn number(node: Node, attribute: &str) -> Result<usize, String> {
    let text = node.attribute(attribute).ok_or_else(|| format!("an element has no {attribute}"))?;
    text.trim().parse().map_err(|_| format!("{attribute} is `{text}`, expected a number"))
}

fn arrays(piece: Node, tag: &str, data: &[u8]) -> Result<Vec<Array>, String> {
    let Some(section) = piece.children().find(|n| n.has_tag_name(tag)) else { return Ok(Vec::new()) };
    section.children().filter(|n| n.has_tag_name("DataArray")).map(|n| read_array(n, data)).collect()
}

fn time(grid: Node, data: &[u8]) -> Result<Option<f64>, String> {
    let Some(field) = grid.children().find(|n| n.has_tag_name("FieldData")) else { return Ok(None) };
    let values = read_array(named(field, "TimeValue")?, data)?.values;
    if values.len() != 1 {
        return Err(format!("TimeValue has {} numbers", values.len()));
    }
    Ok(Some(values.get(0)))
}

fn read_array(node: Node, data: &[u8]) -> Result<Array, String> {
    let name = node.attribute("Name").unwrap_or_default().to_owned();
    let bytes = raw(node, data)?;
    let values = match node.attribute("type") {
        Some("Float32") => Values::Float32(numbers(&name, &bytes, f32::from_le_bytes)?),
        Some("Float64") => Values::Float64(numbers(&name, &bytes, f64::from_le_bytes)?),
        Some("Int32") => Values::Int32(numbers(&name, &bytes, i32::from_le_bytes)?),
        Some("UInt8") => Values::UInt8(bytes),
        other => return Err(format!("array `{name}` has type {}", other.unwrap_or("unknown"))),
    };
    let components = match node.attribute("NumberOfComponents") {
        Some(_) => number(node, "NumberOfComponents")?,
        None => 1,
    };
    let key = node.children().find(|n| n.attribute("name") == Some(UNIT_KEY));
    let unit = key.and_then(|n| n.text()).unwrap_or_default().trim().to_owned();
    Ok(Array { name, unit, components, values })
}

fn indices(node: Node, data: &[u8]) -> Result<Vec<u32>, String> {
    let name = node.attribute("Name").unwrap_or_default();
    if node.attribute("type") != Some("Int64") {
        return Err(format!("array `{name}` is not Int64"));
    }
    let wide = numbers(name, &raw(node, data)?, i64::from_le_bytes)?;
    let narrow = wide.iter().map(|&n| u32::try_from(n).map_err(|_| format!("array `{name}` holds {n}")));
    narrow.collect()
}

fn numbers<T, const N: usize>(name: &str, bytes: &[u8], of: fn([u8; N]) -> T) -> Result<Vec<T>, String> {
    let (whole, rest) = bytes.as_chunks::<N>();
    if !rest.is_empty() {
        return Err(format!("array `{name}` has a broken last number"));
    }
    Ok(whole.iter().map(|&b| of(b)).collect())
}

/// The uncompressed bytes of an array. Memory grows with what is really there, not with what a
/// header claims.
fn raw(node: Node, data: &[u8]) -> Result<Vec<u8>, String> {
    let name = node.attribute("Name").unwrap_or_default();
    let short = || format!("the data of array `{name}` are cut short");
    let mut rest = data.get(number(node, "offset")?..).ok_or_else(short)?;
    let mut next = || -> Result<u64, String> {
        let (head, tail) = rest.split_first_chunk::<8>().ok_or_else(short)?;
        rest = tail;
        Ok(u64::from_le_bytes(*head))
    };
    let (count, block, last) = (next()?, next()?, next()?);
    let mut lengths = Vec::new();
    for _ in 0..count {
        lengths.push(next()?);
    }
    let mut out = Vec::new();
    for (i, &length) in lengths.iter().enumerate() {
        let length = usize::try_from(length).map_err(|_| short())?;
        let (packed, tail) = rest.split_at_checked(length).ok_or_else(short)?;
        rest = tail;
        let wanted = if last != 0 && i + 1 == lengths.len() { last } else { block };
        let before = out.len();
        ZlibDecoder::new(packed)
            .take(wanted.saturating_add(1))
            .read_to_end(&mut out)
            .map_err(|e| format!("array `{name}`, block {i}: {e}"))?;
        if (out.len() - before) as u64 != wanted {
            return Err(format!("array `{name}`, block {i} does not have {wanted} bytes"));
        }
    }
    Ok(out)
}
