//! Writing a grid.

use std::fmt::Write as _;
use std::io::{self, Write};
use std::path::Path;

use flate2::Compression;
use flate2::write::ZlibEncoder;

use super::header::{UNIT_KEY, type_name};
use super::{Array, Grid, Values, VtuError};

/// Uncompressed length of a block: large enough that zlib's window pays, small enough to stream.
const BLOCK: usize = 1 << 18;

impl Grid {
    /// Writes the grid to `path`.
    ///
    /// The file appears complete or not at all: it is written under a neighbouring name that ends in
    /// `.part` and then renamed.
    ///
    /// # Errors
    /// If the grid contradicts itself (see [`Grid::check`]), or the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), VtuError> {
        self.check().map_err(|reason| VtuError::Grid { path: path.to_owned(), reason })?;
        tremolite_files::replace(path, |out| self.write_to(out))
            .map_err(|source| VtuError::Io { path: path.to_owned(), source })
    }

    pub(super) fn write_to(&self, mut out: impl Write) -> io::Result<()> {
        let mut body = Body::default();
        body.line("<?xml version=\"1.0\"?>");
        body.line(
            "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" \
             header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">",
        );
        body.line("<UnstructuredGrid>");
        if self.time.is_some() || !self.field_data.is_empty() {
            body.line("<FieldData>");
            if let Some(time) = self.time {
                let attributes = "type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\"";
                body.data(attributes, "", time.to_le_bytes().into_iter())?;
            }
            for array in &self.field_data {
                let tuples = array.values.len().checked_div(array.components).unwrap_or(0);
                body.array(array, &format!(" NumberOfTuples=\"{tuples}\""))?;
            }
            body.line("</FieldData>");
        }
        let (points, cells) = (self.points.len(), self.offsets.len());
        body.line(&format!("<Piece NumberOfPoints=\"{points}\" NumberOfCells=\"{cells}\">"));
        body.arrays("PointData", &self.point_data)?;
        body.arrays("CellData", &self.cell_data)?;
        body.line("<Points>");
        let coordinates = self.points.iter().flatten().flat_map(|x| x.to_le_bytes());
        body.data("type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", "m", coordinates)?;
        body.line("</Points>");
        body.line("<Cells>");
        // Int64 is what VTK holds cells in, so it need not convert.
        for (name, numbers) in [("connectivity", &self.connectivity), ("offsets", &self.offsets)] {
            let bytes = numbers.iter().flat_map(|&n| i64::from(n).to_le_bytes());
            body.data(&format!("type=\"Int64\" Name=\"{name}\""), "", bytes)?;
        }
        body.data("type=\"UInt8\" Name=\"types\"", "", self.types.iter().copied())?;
        body.line("</Cells>");
        body.line("</Piece>");
        body.line("</UnstructuredGrid>");
        out.write_all(body.xml.as_bytes())?;
        write!(out, "<AppendedData encoding=\"raw\">\n_")?;
        out.write_all(&body.appended)?;
        out.write_all(b"\n</AppendedData>\n</VTKFile>\n")
    }
}

/// The header so far and the data it points into.
#[derive(Default)]
struct Body {
    xml: String,
    appended: Vec<u8>,
}

impl Body {
    fn line(&mut self, text: &str) {
        self.xml.push_str(text);
        self.xml.push('\n');
    }

    fn arrays(&mut self, tag: &str, arrays: &[Array]) -> io::Result<()> {
        self.line(&format!("<{tag}>"));
        for array in arrays {
            self.array(array, "")?;
        }
        self.line(&format!("</{tag}>"));
        Ok(())
    }

    fn array(&mut self, array: &Array, more: &str) -> io::Result<()> {
        let attributes = format!(
            "type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\"{more}",
            type_name(&array.values),
            escape(&array.name),
            array.components
        );
        let unit = &array.unit;
        match &array.values {
            Values::Float32(v) => self.data(&attributes, unit, v.iter().flat_map(|x| x.to_le_bytes())),
            Values::Float64(v) => self.data(&attributes, unit, v.iter().flat_map(|x| x.to_le_bytes())),
            Values::Int32(v) => self.data(&attributes, unit, v.iter().flat_map(|x| x.to_le_bytes())),
            Values::Int64(v) => self.data(&attributes, unit, v.iter().flat_map(|x| x.to_le_bytes())),
            Values::UInt8(v) => self.data(&attributes, unit, v.iter().copied()),
        }
    }

    /// One `DataArray`: its tag in the header, its bytes in the appended part.
    fn data(&mut self, attributes: &str, unit: &str, bytes: impl Iterator<Item = u8>) -> io::Result<()> {
        let offset = self.appended.len();
        let _ = write!(self.xml, "<DataArray {attributes} format=\"appended\" offset=\"{offset}\"");
        if unit.is_empty() {
            self.line("/>");
        } else {
            let unit = escape(unit);
            self.line(&format!(
                "><InformationKey name=\"{UNIT_KEY}\" location=\"vtkDataArray\">{unit}</InformationKey></DataArray>"
            ));
        }
        self.append(bytes)
    }

    /// Appends the bytes in compressed blocks, led by VTK's header: number of blocks, length of a
    /// block, length of the last one if it is shorter (else 0), compressed length of each.
    fn append(&mut self, bytes: impl Iterator<Item = u8>) -> io::Result<()> {
        let bytes: Vec<u8> = bytes.collect();
        let count = bytes.len().div_ceil(BLOCK);
        let header = [count, BLOCK, bytes.len() % BLOCK];
        self.appended.extend(header.iter().flat_map(|&n| (n as u64).to_le_bytes()));
        let lengths = self.appended.len();
        self.appended.resize(lengths + 8 * count, 0);
        for (i, block) in bytes.chunks(BLOCK).enumerate() {
            let start = self.appended.len();
            let mut encoder = ZlibEncoder::new(&mut self.appended, Compression::fast());
            encoder.write_all(block)?;
            encoder.finish()?;
            let length = (self.appended.len() - start) as u64;
            self.appended[lengths + 8 * i..lengths + 8 * i + 8].copy_from_slice(&length.to_le_bytes());
        }
        Ok(())
    }
}

/// Text as XML may hold it; control characters, which XML cannot hold, become spaces.
pub(super) fn escape(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => out.push_str("&amp;"),
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '"' => out.push_str("&quot;"),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out
}
