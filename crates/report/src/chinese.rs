//! The page's texts in Chinese: for each English pattern one with the same slots, by the rooms in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod assessment;
mod bolts;
mod checked;
mod compare;
mod damage;
mod depth;
mod energy;
mod facts;
mod findings;
mod free_field;
mod histories;
mod input;
mod interface_checks;
mod interfaces;
pub mod materials;
mod outcome;
mod page;
mod section_forces;
mod section_maps;
mod section_strength;
mod sheets;
mod source;
mod spectra;
mod stages;
mod study;
mod trust;
mod verdict;
mod view;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[
    assessment::TEXTS,
    bolts::TEXTS,
    checked::TEXTS,
    compare::TEXTS,
    damage::TEXTS,
    depth::TEXTS,
    energy::TEXTS,
    facts::TEXTS,
    findings::TEXTS,
    free_field::TEXTS,
    histories::TEXTS,
    input::TEXTS,
    interface_checks::TEXTS,
    interfaces::TEXTS,
    materials::LAWS,
    materials::TEXTS,
    outcome::TEXTS,
    page::TEXTS,
    section_forces::TEXTS,
    section_maps::TEXTS,
    section_strength::TEXTS,
    sheets::TEXTS,
    source::TEXTS,
    spectra::TEXTS,
    stages::TEXTS,
    study::TEXTS,
    trust::TEXTS,
    verdict::TEXTS,
    view::TEXTS,
];
