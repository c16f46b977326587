//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod before;
mod bolts;
mod checked;
mod compare;
mod contact;
mod damage;
mod depth;
mod energy;
mod facts;
mod findings;
mod forces;
mod free_field;
mod histories;
mod input;
mod interface_checks;
mod maps;
pub mod materials;
mod outcome;
mod page;
mod section_strength;
mod source;
mod spectra;
mod trust;
mod verdict;
mod view;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[
    before::TEXTS,
    bolts::TEXTS,
    checked::TEXTS,
    compare::TEXTS,
    contact::TEXTS,
    damage::TEXTS,
    depth::TEXTS,
    energy::TEXTS,
    facts::TEXTS,
    findings::TEXTS,
    forces::TEXTS,
    free_field::TEXTS,
    histories::TEXTS,
    input::TEXTS,
    interface_checks::TEXTS,
    maps::TEXTS,
    materials::LAWS,
    materials::TEXTS,
    outcome::TEXTS,
    page::TEXTS,
    section_strength::TEXTS,
    source::TEXTS,
    spectra::TEXTS,
    trust::TEXTS,
    verdict::TEXTS,
    view::TEXTS,
];
