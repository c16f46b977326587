//! Binary FLAC3D grids: gridpoints, zones, zone groups, faces, face groups, each after its count.

use super::{Cell, Grid, Group};
use crate::fault::Fault;
use crate::input::{Input, text};

/// The first bytes.
const MARK: [u8; 4] = [0xe6, 0xe7, 0xf6, 0x51];

/// The number after the mark in files of FLAC3D 7.
const LAYOUT: u32 = 3;

pub(super) fn is_binary(head: &[u8]) -> bool {
    head.starts_with(&MARK)
}

pub(super) fn read(input: &mut Input) -> Result<Grid, Fault> {
    let mut grid = Grid::default();
    take::<4>(input)?;
    let layout = number(input)?;
    if layout != LAYOUT {
        let problem =
            format!("its layout is {layout}, of which only {LAYOUT} is known; export the grid in ASCII");
        return Err(input.fault(problem));
    }
    for _ in 0..number(input)? {
        grid.draft.mesh.node_ids.push(u64::from(number(input)?));
        let mut x = [0.0; 3];
        for x in &mut x {
            *x = f64::from_le_bytes(take(input)?);
            if !x.is_finite() {
                return Err(input.fault("a coordinate is no finite number; export the grid again"));
            }
        }
        grid.draft.mesh.nodes.push(x);
    }
    cells(input, 4..=8, "zone", &mut |zone| grid.zone(&zone))?;
    grid.zone_groups = groups(input)?;
    cells(input, 3..=4, "face", &mut |face| {
        grid.faces.push(face);
        Ok(())
    })?;
    grid.face_groups = groups(input)?;
    if input.bytes(1)?.is_some() {
        return Err(input.fault("the grid ends here and the file goes on; export the grid in ASCII"));
    }
    Ok(grid)
}

fn take<const N: usize>(input: &mut Input) -> Result<[u8; N], Fault> {
    let bytes = input.bytes(N)?.and_then(|bytes| bytes.first_chunk().copied());
    bytes.ok_or_else(|| input.fault("the file ends here; it is cut short"))
}

fn number(input: &mut Input) -> Result<u32, Fault> {
    Ok(u32::from_le_bytes(take(input)?))
}

fn cells(
    input: &mut Input,
    counts: std::ops::RangeInclusive<u32>,
    what: &str,
    take: &mut dyn FnMut(Cell) -> Result<(), String>,
) -> Result<(), Fault> {
    for _ in 0..number(input)? {
        let (id, count) = (number(input)?, number(input)?);
        if !counts.contains(&count) {
            let problem = format!("{what} {id} has {count} gridpoints; export the grid in ASCII");
            return Err(input.fault(problem));
        }
        let mut gridpoints = [0; 8];
        for gridpoint in &mut gridpoints[..count as usize] {
            *gridpoint = u64::from(number(input)?);
        }
        let cell = Cell { number: u64::from(id), count: count as u8, gridpoints, line: 0 };
        take(cell).map_err(|problem| input.fault(problem))?;
    }
    Ok(())
}

fn groups(input: &mut Input) -> Result<Vec<Group>, Fault> {
    let mut groups = Vec::new();
    for _ in 0..number(input)? {
        let (name, slot) = (name(input)?, name(input)?);
        let mut numbers = Vec::new();
        for _ in 0..number(input)? {
            numbers.push(u64::from(number(input)?));
        }
        groups.push(Group { name, slot, numbers, line: 0 });
    }
    Ok(groups)
}

fn name(input: &mut Input) -> Result<String, Fault> {
    let length = u16::from_le_bytes(take(input)?);
    let bytes = input.bytes(usize::from(length))?.map(text);
    bytes.ok_or_else(|| input.fault("the file ends in a name; it is cut short"))
}
