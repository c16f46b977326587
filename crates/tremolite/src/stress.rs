//! The largest stresses of each group of elements over the run.

use crate::groups::{Group, all_groups};
use crate::observers::Envelopes;
use indexmap::IndexMap;
use tremolite_engine::hexahedra::centroid;
use tremolite_engine::model::Model;
use tremolite_engine::phase::Phase;
use tremolite_engine::state::Memory;
use tremolite_results::{GroupStress, StressPeak};

/// By group, what envelopes remember; nothing before the first row.
pub fn stresses(model: &Model, phase: &Phase, memory: &Memory) -> IndexMap<String, GroupStress> {
    let groups = all_groups(model);
    groups
        .iter()
        .filter_map(|group| Some((group.name.to_owned(), of_group(model, phase, memory, group)?)))
        .collect()
}

fn of_group(model: &Model, phase: &Phase, memory: &Memory, group: &Group) -> Option<GroupStress> {
    let peak = |values: &str, times: &str, sign: f64| {
        let (values, times) = (memory.get(values)?, memory.get(times)?);
        let slot = |e: u32| Some(phase.element_slot[e as usize]?.element as usize);
        let own = group.elements.iter().filter_map(|&e| Some((e, slot(e)?)));
        let (element, at) = own.max_by(|a, b| (sign * values[a.1]).total_cmp(&(sign * values[b.1])))?;
        Some(StressPeak {
            value: values[at],
            time: times[at],
            element: model.mesh.element_id(element as usize),
            at: centroid(&model.mesh, element),
        })
    };
    Some(GroupStress {
        whole: group.whole,
        s1: peak(Envelopes::S1, Envelopes::S1_TIME, 1.0)?,
        s3: peak(Envelopes::S3, Envelopes::S3_TIME, -1.0)?,
    })
}
