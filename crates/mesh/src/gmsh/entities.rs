//! Physical names, and which geometrical entities bear them.

use std::collections::{BTreeMap, HashMap};

use super::numbers::Numbers;
use crate::fault::Fault;
use crate::input::{Input, text};

/// Names by dimension and tag.
pub(super) type Names = HashMap<(u64, i64), String>;

/// The section $PhysicalNames, which is text in binary files too.
pub(super) fn physical_names(input: &mut Input) -> Result<Names, Fault> {
    input.expect("the number of physical names")?;
    let count = input.count("the number of physical names")?;
    let mut names = Names::new();
    for _ in 0..count {
        input.expect("a physical name")?;
        let dimension = input.count("a dimension")?;
        let tag = input.integer("a physical tag")?;
        let name = input.text();
        let name = name.strip_prefix(b"\"").unwrap_or(name);
        let name = name.strip_suffix(b"\"").unwrap_or(name);
        let name = text(name).trim().to_owned();
        if name.is_empty() {
            return Err(input.fault("the physical name is empty; give it one, or remove the line"));
        }
        names.insert((dimension, tag), name);
    }
    Ok(names)
}

/// The name of a physical group.
pub(super) fn physical_name(names: &Names, dimension: u64, tag: i64) -> String {
    let kind = ["point", "curve", "surface", "volume"][dimension.min(3) as usize];
    names.get(&(dimension, tag)).cloned().unwrap_or_else(|| format!("{kind} {tag}"))
}

/// Points by name. A name that several share is numbered, as none of them can have it alone.
pub(super) fn named_points(points: BTreeMap<String, Vec<[f64; 3]>>) -> BTreeMap<String, [f64; 3]> {
    let mut named = BTreeMap::new();
    for (name, places) in points {
        match places.as_slice() {
            [one] => drop(named.insert(name, *one)),
            several => {
                named.extend(several.iter().zip(1..).map(|(place, k)| (format!("{name}.{k}"), *place)))
            }
        }
    }
    named
}

/// What the section $Entities says.
#[derive(Default)]
pub(super) struct Entities {
    /// Names of the physical groups of a surface or volume, by its dimension and tag.
    pub groups: HashMap<(u64, i64), Vec<String>>,
    /// Named points.
    pub points: BTreeMap<String, [f64; 3]>,
}

impl Entities {
    pub(super) fn parse(numbers: &mut Numbers, names: &Names) -> Result<Self, Fault> {
        numbers.begin("the numbers of entities")?;
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = numbers.count("a number of entities")?;
        }
        let mut entities = Entities::default();
        let mut points: BTreeMap<String, Vec<[f64; 3]>> = BTreeMap::new();
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                numbers.begin("an entity")?;
                let tag = numbers.tag("an entity's tag")?;
                let mut place = [0.0; 6];
                for x in &mut place[..if dimension == 0 { 3 } else { 6 }] {
                    *x = numbers.real("a coordinate")?;
                }
                let mut groups = Vec::new();
                for _ in 0..numbers.count("the number of physical groups")? {
                    // A negative tag means the same group with the entity turned.
                    let physical = numbers.tag("a physical tag")?.saturating_abs();
                    groups.push(physical_name(names, dimension, physical));
                }
                if dimension > 0 {
                    let boundary = numbers.count("the number of bounding entities")?;
                    numbers.pass(boundary, 4, "a bounding entity")?;
                }
                match dimension {
                    0 => {
                        for name in groups {
                            points.entry(name).or_default().push([place[0], place[1], place[2]]);
                        }
                    }
                    1 => {}
                    _ => drop(entities.groups.insert((dimension, tag), groups)),
                }
            }
        }
        entities.points = named_points(points);
        Ok(entities)
    }
}
