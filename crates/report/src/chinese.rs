//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod before;
mod bolts;
mod compare;
mod contact;
mod contacts;
mod damage;
mod energy;
mod facts;
mod findings;
mod forces;
mod free_field;
mod histories;
pub mod materials;
mod outcome;
mod page;
mod section_strength;
mod source;
mod trust;
mod verdict;
mod view;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[
    contacts::TEXTS,
    facts::TEXTS,
    findings::TEXTS,
    materials::TEXTS,
    materials::LAWS,
    outcome::TEXTS,
    page::TEXTS,
    source::TEXTS,
    trust::TEXTS,
    before::TEXTS,
    bolts::TEXTS,
    compare::TEXTS,
    contact::TEXTS,
    damage::TEXTS,
    energy::TEXTS,
    forces::TEXTS,
    free_field::TEXTS,
    histories::TEXTS,
    page::TEXTS,
    section_strength::TEXTS,
    source::TEXTS,
    verdict::TEXTS,
    view::TEXTS,
];
