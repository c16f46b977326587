//! Reading a grid.

use std::fs;
use std::path::Path;

use roxmltree::{Document, Node};

use super::data::{Kind, Layout, Source, bytes};
use super::header::UNIT_KEY;
use super::{Array, Grid, Values, VtuError};

/// Marks the start of the appended data; everything before it is XML, but for the closing tag.
const APPENDED: &[u8] = b"<AppendedData";
/// What to do about a file that cannot be read.
const EXPORT: &str = "open it in ParaView and save it as .vtu with zlib or no compression";

impl Grid {
    /// Reads a VTU file: ASCII, base64 or raw, inline or appended, with zlib or without, in either byte
    /// order, of one piece or several.
    ///
    /// # Errors
    /// If the file cannot be opened, is damaged, or is no unstructured grid.
    pub fn read(path: &Path) -> Result<Grid, VtuError> {
        let bytes = fs::read(path).map_err(|source| VtuError::Io { path: path.to_owned(), source })?;
        parse(&bytes).map_err(|reason| VtuError::Format { path: path.to_owned(), reason })
    }
}

/// The appended data of a file.
struct Appended<'a> {
    data: &'a [u8],
    base64: bool,
}

/// What is needed to read an array.
struct File<'a> {
    layout: Layout,
    appended: Option<Appended<'a>>,
}

/// The grid in a file's bytes.
pub(super) fn parse(bytes: &[u8]) -> Result<Grid, String> {
    let mark = bytes.windows(APPENDED.len()).position(|w| w == APPENDED);
    let text = std::str::from_utf8(&bytes[..mark.unwrap_or(bytes.len())]);
    let mut xml = text.map_err(|_| "the header is not UTF-8")?.to_owned();
    let appended = match mark {
        None => None,
        Some(mark) => {
            // The XML proper, closed where the appended data begin, is well formed.
            xml.push_str("</VTKFile>");
            let rest = &bytes[mark + APPENDED.len()..];
            let end = rest.iter().position(|&b| b == b'>').ok_or("the appended data do not begin")?;
            let base64 = rest[..end].windows(8).any(|w| w == b"\"base64\"");
            let start = rest[end..]
                .iter()
                .position(|&b| b == b'_')
                .ok_or("the appended data have no start mark `_`")?;
            Some(Appended { data: &rest[end + start + 1..], base64 })
        }
    };
    let document = Document::parse(&xml).map_err(|e| format!("the header is not XML: {e}"))?;
    let root = document.root_element();
    let kind = root.attribute("type").unwrap_or("nothing");
    if kind != "UnstructuredGrid" {
        return Err(format!("type is {kind}, expected UnstructuredGrid; {EXPORT}"));
    }
    let file = File { layout: layout(root)?, appended };
    let grid = child(root, "UnstructuredGrid")?;
    let mut all: Option<Grid> = None;
    for piece in grid.children().filter(|n| n.has_tag_name("Piece")) {
        let piece = file.piece(piece)?;
        match &mut all {
            None => all = Some(piece),
            Some(all) => append(all, piece)?,
        }
    }
    let mut all = all.ok_or("the header has no <Piece>")?;
    if let Some(fields) = grid.children().find(|n| n.has_tag_name("FieldData")) {
        for node in fields.children().filter(|n| n.has_tag_name("DataArray")) {
            let array = file.array(node)?;
            if array.name != "TimeValue" {
                all.field_data.push(array);
            } else if array.values.len() == 1 {
                all.time = Some(array.values.get(0));
            } else {
                return Err(format!("TimeValue has {} numbers", array.values.len()));
            }
        }
    }
    all.check()?;
    Ok(all)
}

fn layout(root: Node) -> Result<Layout, String> {
    let one_of = |name: &str, default: &'static str, known: [&str; 2]| {
        let found = root.attribute(name).unwrap_or(default);
        match known.iter().position(|k| *k == found) {
            Some(index) => Ok(index == 1),
            None => Err(format!("{name} is {found}, expected {} or {}; {EXPORT}", known[0], known[1])),
        }
    };
    let compressor = root.attribute("compressor").unwrap_or_default();
    if !["", "vtkZLibDataCompressor"].contains(&compressor) {
        return Err(format!("compressor is {compressor}, expected vtkZLibDataCompressor or none; {EXPORT}"));
    }
    Ok(Layout {
        big_endian: one_of("byte_order", "LittleEndian", ["LittleEndian", "BigEndian"])?,
        word: if one_of("header_type", "UInt32", ["UInt32", "UInt64"])? { 8 } else { 4 },
        compressed: !compressor.is_empty(),
    })
}

/// Adds a further piece. Arrays that only one of them has are dropped.
fn append(all: &mut Grid, piece: Grid) -> Result<(), String> {
    let (points, corners) = (all.points.len(), all.connectivity.len());
    if points + piece.points.len() > u32::MAX as usize
        || corners + piece.connectivity.len() > u32::MAX as usize
    {
        return Err("there are more points or cells than 32 bits can number".to_owned());
    }
    piece.check()?;
    all.points.extend(piece.points);
    all.connectivity.extend(piece.connectivity.iter().map(|p| p + points as u32));
    all.offsets.extend(piece.offsets.iter().map(|o| o + corners as u32));
    all.types.extend(piece.types);
    for (arrays, more) in [(&mut all.point_data, piece.point_data), (&mut all.cell_data, piece.cell_data)] {
        arrays.retain_mut(|array| {
            let other = more.iter().find(|o| o.name == array.name && o.components == array.components);
            match (&mut array.values, other.map(|o| &o.values)) {
                (Values::Float32(a), Some(Values::Float32(b))) => a.extend(b),
                (Values::Float64(a), Some(Values::Float64(b))) => a.extend(b),
                (Values::Int32(a), Some(Values::Int32(b))) => a.extend(b),
                (Values::Int64(a), Some(Values::Int64(b))) => a.extend(b),
                (Values::UInt8(a), Some(Values::UInt8(b))) => a.extend(b),
                _ => return false,
            }
            true
        });
    }
    Ok(())
}

fn child<'a, 'i>(node: Node<'a, 'i>, tag: &str) -> Result<Node<'a, 'i>, String> {
    node.children().find(|n| n.has_tag_name(tag)).ok_or_else(|| format!("the header has no <{tag}>"))
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

impl File<'_> {
    fn piece(&self, piece: Node) -> Result<Grid, String> {
        let points = self.array(child(child(piece, "Points")?, "DataArray")?)?;
        let coordinates = match points.values {
            Values::Float64(values) => values,
            Values::Float32(values) => values.into_iter().map(f64::from).collect(),
            _ => return Err("the points are no real numbers".to_owned()),
        };
        let cells = child(piece, "Cells")?;
        let whole = |name: &str| self.array(named(cells, name)?).and_then(|a| indices(&a));
        let types: Vec<u32> = whole("types")?;
        let grid = Grid {
            points: coordinates.as_chunks::<3>().0.to_vec(),
            connectivity: whole("connectivity")?,
            offsets: whole("offsets")?,
            types: types
                .iter()
                .map(|&t| u8::try_from(t).map_err(|_| format!("cell type {t}")))
                .collect::<Result<_, _>>()?,
            point_data: self.arrays(piece, "PointData")?,
            cell_data: self.arrays(piece, "CellData")?,
            ..Grid::default()
        };
        let counts = [("NumberOfPoints", grid.points.len()), ("NumberOfCells", grid.offsets.len())];
        for (attribute, found) in counts {
            if number(piece, attribute)? != found {
                return Err(format!("{attribute} disagrees with the data, which have {found}"));
            }
        }
        Ok(grid)
    }

    /// The arrays of numbers in a section; arrays of text are passed over.
    fn arrays(&self, piece: Node, tag: &str) -> Result<Vec<Array>, String> {
        let Some(section) = piece.children().find(|n| n.has_tag_name(tag)) else { return Ok(Vec::new()) };
        section.children().filter(|n| n.has_tag_name("DataArray")).map(|n| self.array(n)).collect()
    }

    fn array(&self, node: Node) -> Result<Array, String> {
        let name = node.attribute("Name").unwrap_or_default().to_owned();
        let kind = node.attribute("type").unwrap_or("nothing");
        let in_array = |problem: String| format!("array `{name}`: {problem}");
        let Some(kind) = Kind::named(kind) else { return Err(in_array(format!("its type is {kind}"))) };
        let values = self.values(node, kind).map_err(in_array)?;
        let components = match node.attribute("NumberOfComponents") {
            Some(_) => number(node, "NumberOfComponents")?,
            None => 1,
        };
        let key = node.children().find(|n| n.attribute("name") == Some(UNIT_KEY));
        let unit = key.and_then(|n| n.text()).unwrap_or_default().trim().to_owned();
        Ok(Array { name, unit, components, values })
    }

    fn values(&self, node: Node, kind: Kind) -> Result<Values, String> {
        // Inline data stand before or after the information keys.
        let texts = || node.children().filter(|n| n.is_text()).filter_map(|n| n.text());
        let source = match node.attribute("format").unwrap_or("ascii") {
            "ascii" => {
                let words = texts().flat_map(str::split_ascii_whitespace).map(str::as_bytes);
                return kind.parse(words);
            }
            "binary" => {
                let text = texts().find(|t| !t.trim().is_empty()).unwrap_or_default();
                Source::Base64(text.as_bytes())
            }
            "appended" => {
                let appended = self.appended.as_ref().ok_or("the file has no appended data")?;
                let offset = number(node, "offset")?;
                let data = appended.data.get(offset..).ok_or("the data are cut short")?;
                if appended.base64 { Source::Base64(data) } else { Source::Raw(data) }
            }
            other => return Err(format!("format is {other}, expected ascii, binary or appended")),
        };
        kind.decode(&bytes(&source, self.layout)?, self.layout.big_endian)
    }
}

/// Whole numbers that count points or cells.
pub(crate) fn indices(array: &Array) -> Result<Vec<u32>, String> {
    let index = |n: i64| u32::try_from(n).map_err(|_| format!("array `{}` holds {n}", array.name));
    match &array.values {
        Values::UInt8(values) => Ok(values.iter().map(|&n| u32::from(n)).collect()),
        Values::Int32(values) => values.iter().map(|&n| index(i64::from(n))).collect(),
        Values::Int64(values) => values.iter().map(|&n| index(n)).collect(),
        _ => Err(format!("array `{}` does not hold whole numbers", array.name)),
    }
}
