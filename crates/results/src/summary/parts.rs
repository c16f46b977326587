//! What became of groups of elements, interfaces and bolts.

use indexmap::IndexMap;
use serde::{Deserialize, Serialize};

use crate::{
    BoltPlace, BoltSummary, FailureModes, GroupDamage, GroupStress, InterfaceSummary, PairPlace,
    SectionStrength,
};

/// What became of the parts of the model, by name: groups of elements, interfaces, groups of bolts.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PartFacts {
    /// Group of elements → its largest stresses; groups may overlap.
    pub stress: IndexMap<String, GroupStress>,
    /// Group of elements → how far it is damaged or yielded; groups whose laws know neither are left out, and groups
    /// may overlap.
    pub damage: IndexMap<String, GroupDamage>,
    /// Interface → what it did.
    pub interfaces: IndexMap<String, InterfaceSummary>,
    /// Monitor on an interface → its pair.
    pub pairs: IndexMap<String, PairPlace>,
    /// Lining → what its sections use of their strength; those that no code judges are left out.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub sections: IndexMap<String, SectionStrength>,
    /// Lining → what judges each of its modes of failure; empty in files of older versions.
    #[serde(skip_serializing_if = "IndexMap::is_empty")]
    pub failure_modes: IndexMap<String, FailureModes>,
    /// Group of bolts → what became of them.
    pub bolts: IndexMap<String, BoltSummary>,
    /// Monitor on a bolt → its segment.
    pub bolt_monitors: IndexMap<String, BoltPlace>,
}
