//! VTK's legacy files (`.vtk`) with an unstructured grid: ASCII and binary, versions 1 to 5.
//!
//! Cells, groups and named faces are understood as in VTU files.

mod arrays;

use std::path::Path;

use arrays::Content;

use crate::fault::Fault;
use crate::format::{Format, Outcome};
use crate::input::{Input, real, shown, text};
use crate::vtu::{Grid, Kind, NO_SOLIDS, solids};

/// VTK's legacy format, for [`crate::read::read`].
pub(crate) const FORMAT: Format = Format { name: "VTK legacy", recognises: is_vtk, parse };

/// What to do about files that cannot be read.
const EXPORT: &str =
    "open it in ParaView (there, Filters > Append Datasets makes any grid unstructured) and save it as .vtu";

fn is_vtk(head: &[u8]) -> bool {
    head.len() > 5 && head[..5].eq_ignore_ascii_case(b"# vtk")
}

fn parse(input: &mut Input, _: &Path) -> Outcome {
    let grid = Reader::open(input)?.grid()?;
    grid.check().and_then(|()| solids(grid)).map_err(Fault::whole)?.finish(NO_SOLIDS)
}

/// What arrays belong to.
#[derive(Clone, Copy)]
enum Owner {
    File,
    Points,
    Cells,
}

struct Reader<'i, 'a> {
    input: &'i mut Input<'a>,
    binary: bool,
    /// Whether cells are offsets and a list of points; before version 5 each has its number of points in front.
    with_offsets: bool,
    grid: Grid,
    /// Cells, and points of all cells.
    cells: Option<(Vec<u32>, Vec<u32>)>,
    owner: Owner,
    tuples: usize,
}

impl<'i, 'a> Reader<'i, 'a> {
    /// The first lines.
    fn open(input: &'i mut Input<'a>) -> Result<Self, Fault> {
        input.expect("the version")?;
        let version = input.text().rsplit(|&b| b == b' ').next().and_then(real).unwrap_or(0.0);
        // The title may be blank.
        for wanted in ["a title", "ASCII or BINARY"] {
            input.expect(wanted)?;
            let text = input.text().to_ascii_uppercase();
            if text == b"ASCII" || text == b"BINARY" {
                return Ok(Reader {
                    input,
                    binary: text == b"BINARY",
                    with_offsets: version >= 5.0,
                    grid: Grid::default(),
                    cells: None,
                    owner: Owner::File,
                    tuples: 0,
                });
            }
        }
        Err(input.misplaced(input.text(), "ASCII or BINARY"))
    }

    fn grid(mut self) -> Result<Grid, Fault> {
        while self.input.advance()? {
            if !self.metadata()? {
                self.section()?;
            }
        }
        if let Some((offsets, connectivity)) = self.cells {
            (self.grid.offsets, self.grid.connectivity) = (offsets, connectivity);
        }
        Ok(self.grid)
    }

    /// The next word of the line, in upper case.
    fn word(&mut self, what: &str) -> Result<String, Fault> {
        match self.input.field() {
            Some(word) => Ok(text(word)),
            None => Err(self.input.fault(format!("the line ends where {what} should stand"))),
        }
    }

    fn size(&mut self, what: &str) -> Result<usize, Fault> {
        let count = self.input.count(what)?;
        usize::try_from(count).map_err(|_| self.input.fault(format!("{what} is {count}, which is too large")))
    }

    /// A section that begins in the current line.
    fn section(&mut self) -> Result<(), Fault> {
        let word = self.word("a keyword")?.to_uppercase();
        match word.as_str() {
            "DATASET" => {
                let kind = self.word("the kind of the data set")?.to_uppercase();
                if kind != "UNSTRUCTURED_GRID" {
                    let kind = shown(kind.as_bytes());
                    return Err(self
                        .input
                        .fault(format!("the data set is {kind}, expected UNSTRUCTURED_GRID; {EXPORT}")));
                }
            }
            "POINTS" => {
                let count = self.size("the number of points")?;
                let kind = self.kind()?;
                let mut points: Vec<[f64; 3]> = Vec::new();
                self.pieces(self.product(count, 3)?, kind, "the points", &mut |values| {
                    // Pieces hold whole points.
                    points.extend((0..values.len() / 3).map(|i| [0, 1, 2].map(|k| values.get(3 * i + k))));
                    Ok(())
                })?;
                self.grid.points = points;
            }
            "CELLS" => self.cells()?,
            "CELL_TYPES" => {
                let count = self.size("the number of cells")?;
                let types = self.whole_numbers(count, Kind::Whole(true, 4), "the cell types")?;
                let narrow: Result<Vec<u8>, _> = types.into_iter().map(u8::try_from).collect();
                self.grid.types = narrow.map_err(|_| self.input.fault("a cell type is larger than 255"))?;
            }
            "POINT_DATA" | "CELL_DATA" => {
                self.owner = if word == "POINT_DATA" { Owner::Points } else { Owner::Cells };
                self.tuples = self.size("the number of tuples")?;
            }
            "FIELD" => {
                self.word("a name")?;
                for _ in 0..self.size("the number of arrays")? {
                    self.input.expect("an array")?;
                    while self.metadata()? {
                        self.input.expect("an array")?;
                    }
                    let name = self.word("a name")?;
                    let components = self.size("the number of components")?;
                    let tuples = self.size("the number of tuples")?;
                    let content = self.content()?;
                    self.array(&name, components, tuples, content)?;
                }
            }
            "SCALARS" => {
                let name = self.word("a name")?;
                let content = self.content()?;
                let components =
                    if self.input.text().is_empty() { 1 } else { self.size("the number of components")? };
                self.input.expect("LOOKUP_TABLE")?;
                if !self.word("LOOKUP_TABLE")?.eq_ignore_ascii_case("LOOKUP_TABLE") {
                    return Err(self
                        .input
                        .fault("expected LOOKUP_TABLE here; if there is none, add `LOOKUP_TABLE default`"));
                }
                self.word("a name")?;
                self.array(&name, components, self.tuples, content)?;
            }
            "COLOR_SCALARS" => {
                let name = self.word("a name")?;
                let components = self.size("the number of components")?;
                self.array(&name, components, self.tuples, Content::Colours)?;
            }
            "LOOKUP_TABLE" => {
                let name = self.word("a name")?;
                let colours = self.size("the number of colours")?;
                self.array(&name, 4, colours, Content::Colours)?;
            }
            "TEXTURE_COORDINATES" => {
                let name = self.word("a name")?;
                let components = self.size("the number of components")?;
                let content = self.content()?;
                self.array(&name, components, self.tuples, content)?;
            }
            "VECTORS" | "NORMALS" | "TENSORS" | "TENSORS6" | "GLOBAL_IDS" | "PEDIGREE_IDS" => {
                let components = match word.as_str() {
                    "TENSORS" => 9,
                    "TENSORS6" => 6,
                    "GLOBAL_IDS" | "PEDIGREE_IDS" => 1,
                    _ => 3,
                };
                let name = self.word("a name")?;
                let content = self.content()?;
                self.array(&name, components, self.tuples, content)?;
            }
            _ => {
                let word = shown(word.as_bytes());
                return Err(self.input.fault(format!("`{word}` is no section that can be read; {EXPORT}")));
            }
        }
        Ok(())
    }

    /// Passes over a block of metadata, which ends with a blank line, if one begins here; whether it did.
    fn metadata(&mut self) -> Result<bool, Fault> {
        if !self.input.text().eq_ignore_ascii_case(b"METADATA") {
            return Ok(false);
        }
        while self.input.next_line()? && !self.input.text().is_empty() {}
        Ok(true)
    }

    fn cells(&mut self) -> Result<(), Fault> {
        let count = self.size("the number of cells")?;
        let size = self.size("the length of the list")?;
        if self.with_offsets {
            self.input.expect("OFFSETS")?;
            self.word("OFFSETS")?;
            let kind = self.kind()?;
            let offsets = self.whole_numbers(count, kind, "the offsets")?;
            self.input.expect("CONNECTIVITY")?;
            self.word("CONNECTIVITY")?;
            let kind = self.kind()?;
            let connectivity = self.whole_numbers(size, kind, "the connectivity")?;
            self.cells = Some((offsets.get(1..).unwrap_or_default().to_vec(), connectivity));
            return Ok(());
        }
        let list = self.whole_numbers(size, Kind::Whole(true, 4), "the cells")?;
        let (mut offsets, mut connectivity) = (Vec::new(), Vec::new());
        let mut rest = list.as_slice();
        for _ in 0..count {
            let cell = rest.split_first().and_then(|(&n, tail)| tail.split_at_checked(n as usize));
            let Some((points, tail)) = cell else {
                return Err(self
                    .input
                    .fault("the list of cells is shorter than its cells; the file is damaged"));
            };
            connectivity.extend_from_slice(points);
            offsets.push(connectivity.len() as u32);
            rest = tail;
        }
        self.cells = Some((offsets, connectivity));
        Ok(())
    }
}

#[cfg(test)]
mod tests;
