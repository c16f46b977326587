//! Physical names, and which geometrical entities bear them.

use std::collections::{BTreeMap, HashMap};

use super::sections::Section;
use crate::read::Fault;

/// Names by dimension and tag.
pub(super) fn physical_names(section: &Section) -> Result<HashMap<(u64, i64), String>, Fault> {
    let mut lines = section.lines();
    let count = lines.expect("the number of physical names")?.count("the number of physical names")?;
    let mut names = HashMap::new();
    for _ in 0..count {
        let mut line = lines.expect("a physical name")?;
        let dimension = line.count("a dimension")?;
        let tag = line.integer("a physical tag")?;
        let name = line.text.strip_prefix(b"\"").unwrap_or(line.text);
        let name = name.strip_suffix(b"\"").unwrap_or(name);
        let name = String::from_utf8_lossy(name).trim().to_owned();
        if name.is_empty() {
            return Err(Fault::at(line.line, "the physical name is empty; give it one, or remove the line"));
        }
        names.insert((dimension, tag), name);
    }
    Ok(names)
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
    pub(super) fn parse(section: &Section, names: &HashMap<(u64, i64), String>) -> Result<Self, Fault> {
        let mut lines = section.lines();
        let mut header = lines.expect("the numbers of entities")?;
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = header.count("a number of entities")?;
        }
        let mut entities = Entities::default();
        // A name that several points share is numbered, as none of them can have it alone.
        let mut points: BTreeMap<String, Vec<[f64; 3]>> = BTreeMap::new();
        for (dimension, count) in (0..).zip(counts) {
            for _ in 0..count {
                let mut line = lines.expect("an entity")?;
                let tag = line.integer("an entity's tag")?;
                let mut place = [0.0; 6];
                let numbers = if dimension == 0 { 3 } else { 6 };
                for x in &mut place[..numbers] {
                    *x = line.real("a coordinate")?;
                }
                let mut groups = Vec::new();
                for _ in 0..line.count("the number of physical groups")? {
                    // A negative tag means the same group with the entity turned.
                    let physical = line.integer("a physical tag")?.saturating_abs();
                    let kind = ["point", "curve", "surface", "volume"][dimension as usize];
                    let name = names.get(&(dimension, physical)).cloned();
                    groups.push(name.unwrap_or_else(|| format!("{kind} {physical}")));
                }
                match dimension {
                    0 => {
                        for name in groups {
                            points.entry(name).or_default().push([place[0], place[1], place[2]]);
                        }
                    }
                    1 => {}
                    _ => {
                        entities.groups.insert((dimension, tag), groups);
                    }
                }
            }
        }
        for (name, places) in points {
            match places.as_slice() {
                [one] => {
                    entities.points.insert(name, *one);
                }
                several => entities
                    .points
                    .extend(several.iter().zip(1..).map(|(place, k)| (format!("{name}.{k}"), *place))),
            }
        }
        Ok(entities)
    }
}
