//! Reading a grid from one file.

use std::io::{BufReader, Read, SeekFrom};

use roxmltree::{Document, Node};

use super::base64::Base64;
use super::data::{Layout, Take, binary, text};
use super::header::UNIT_KEY;
use super::kind::Kind;
use super::outline::{Appended, Outline, Place, outline};
use super::{Array, Grid, Values};
use crate::input::Source;

/// What to do about a file that cannot be read.
const EXPORT: &str = "open it in ParaView and save it as .vtu with zlib or no compression";

/// What is needed to read an array.
struct File<'s> {
    layout: Layout,
    appended: Option<Appended>,
    source: &'s mut dyn Source,
    /// Which of the arrays beside points and cells are wanted, by name.
    wanted: fn(&str) -> bool,
}

/// The grid in a file, with the arrays whose names are `wanted`; results of a run would be many times the mesh.
pub(super) fn parse(source: &mut dyn Source, wanted: fn(&str) -> bool) -> Result<Grid, String> {
    let Outline { xml, appended } = outline(source)?;
    let document = Document::parse(&xml).map_err(|e| format!("the header is not XML: {e}"))?;
    let root = document.root_element();
    let kind = root.attribute("type").unwrap_or("nothing");
    if kind != "UnstructuredGrid" {
        return Err(format!("type is {kind}, expected UnstructuredGrid; {EXPORT}"));
    }
    let mut file = File { layout: layout(root)?, appended, source, wanted };
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
            if !wanted(&name(node)) {
                continue;
            }
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
pub(super) fn append(all: &mut Grid, piece: Grid) -> Result<(), String> {
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
            other.is_some_and(|o| array.values.append(&o.values))
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
    fn piece(&mut self, piece: Node) -> Result<Grid, String> {
        let mut grid = Grid::default();
        let mut count = 0;
        self.numbers(child(child(piece, "Points")?, "DataArray")?, &mut |values| {
            if !matches!(values, Values::Float32(_) | Values::Float64(_)) {
                return Err("the points are no real numbers".to_owned());
            }
            for i in 0..values.len() {
                match grid.points.last_mut() {
                    Some(point) if count % 3 != 0 => point[count % 3] = values.get(i),
                    _ => grid.points.push([values.get(i), 0.0, 0.0]),
                }
                count += 1;
            }
            Ok(())
        })?;
        if count % 3 != 0 {
            return Err("the last point has not three coordinates".to_owned());
        }
        let cells = child(piece, "Cells")?;
        for (name, into) in [("connectivity", &mut grid.connectivity), ("offsets", &mut grid.offsets)] {
            self.numbers(named(cells, name)?, &mut |values| append_indices(into, &values))?;
        }
        self.numbers(named(cells, "types")?, &mut |values| {
            let mut types = Vec::new();
            append_indices(&mut types, &values)?;
            let narrow = types.iter().map(|&t| u8::try_from(t).map_err(|_| format!("cell type {t}")));
            narrow.collect::<Result<Vec<u8>, _>>().map(|types| grid.types.extend(types))
        })?;
        grid.point_data = self.arrays(piece, "PointData")?;
        grid.cell_data = self.arrays(piece, "CellData")?;
        let counts = [("NumberOfPoints", grid.points.len()), ("NumberOfCells", grid.offsets.len())];
        for (attribute, found) in counts {
            if number(piece, attribute)? != found {
                return Err(format!("{attribute} disagrees with the data, which have {found}"));
            }
        }
        Ok(grid)
    }

    /// The arrays of numbers in a section; arrays of text are passed over.
    fn arrays(&mut self, piece: Node, tag: &str) -> Result<Vec<Array>, String> {
        let Some(section) = piece.children().find(|n| n.has_tag_name(tag)) else { return Ok(Vec::new()) };
        let arrays = section.children().filter(|n| n.has_tag_name("DataArray"));
        let wanted = self.wanted;
        arrays.filter(|&n| wanted(&name(n))).map(|n| self.array(n)).collect()
    }

    fn array(&mut self, node: Node) -> Result<Array, String> {
        let mut all: Option<Values> = None;
        self.numbers(node, &mut |values| {
            match &mut all {
                Some(all) => drop(all.append(&values)),
                None => all = Some(values),
            }
            Ok(())
        })?;
        let values = match all {
            Some(values) => values,
            None => kind(node)?.parse(std::iter::empty())?,
        };
        // Some programs write it empty where it is 1.
        let components = match node.attribute("NumberOfComponents").map(str::trim) {
            Some(count) if !count.is_empty() => number(node, "NumberOfComponents")?,
            _ => 1,
        };
        let key = node.children().find(|n| n.attribute("name") == Some(UNIT_KEY));
        let unit = key.and_then(|n| n.text()).unwrap_or_default().trim().to_owned();
        Ok(Array { name: name(node), unit, components, values })
    }

    /// Gives an array's numbers to `take`, piece by piece.
    fn numbers(&mut self, node: Node, take: Take) -> Result<(), String> {
        kind(node)
            .and_then(|kind| self.pieces(node, kind, take))
            .map_err(|problem| format!("array `{}`: {problem}", name(node)))
    }

    fn pieces(&mut self, node: Node, kind: Kind, take: Take) -> Result<(), String> {
        // Inline data stand before or after the information keys.
        let texts = node.children().filter(|n| n.is_text()).filter_map(|n| n.text());
        let places = texts.flat_map(str::split_whitespace).filter_map(Place::named);
        let layout = self.layout;
        match node.attribute("format").unwrap_or("ascii") {
            "ascii" => {
                for Place { start, length } in places {
                    text(&mut self.from(start)?.take(length), kind, take)?;
                }
                Ok(())
            }
            "binary" => {
                let mut places = places;
                let Place { start, length } = places.next().unwrap_or(Place { start: 0, length: 0 });
                binary(&mut Base64::new(self.from(start)?.take(length)), layout, kind, take)
            }
            "appended" => {
                let Appended { start, base64 } = self.appended.ok_or("the file has no appended data")?;
                let offset = number(node, "offset")? as u64;
                let from = start.checked_add(offset).ok_or("the data are cut short")?;
                let mut from = self.from(from)?;
                if base64 {
                    binary(&mut Base64::new(from), layout, kind, take)
                } else {
                    binary(&mut from, layout, kind, take)
                }
            }
            other => Err(format!("format is {other}, expected ascii, binary or appended")),
        }
    }

    /// The file from a byte on.
    fn from(&mut self, start: u64) -> Result<BufReader<&mut dyn Source>, String> {
        self.source.seek(SeekFrom::Start(start)).map_err(|e| format!("it cannot be read: {e}"))?;
        Ok(BufReader::with_capacity(1 << 16, &mut *self.source))
    }
}

fn name(node: Node) -> String {
    node.attribute("Name").unwrap_or_default().to_owned()
}

fn kind(node: Node) -> Result<Kind, String> {
    let kind = node.attribute("type").unwrap_or("nothing");
    Kind::named(kind).ok_or_else(|| format!("its type is {kind}"))
}

/// Adds whole numbers that count points or cells.
pub(crate) fn append_indices(all: &mut Vec<u32>, values: &Values) -> Result<(), String> {
    let index = |n: i64| u32::try_from(n).map_err(|_| format!("it holds {n}"));
    match values {
        Values::UInt8(values) => all.extend(values.iter().map(|&n| u32::from(n))),
        Values::Int32(values) => {
            for &n in values {
                all.push(index(i64::from(n))?);
            }
        }
        Values::Int64(values) => {
            for &n in values {
                all.push(index(n)?);
            }
        }
        _ => return Err("it does not hold whole numbers".to_owned()),
    }
    Ok(())
}
