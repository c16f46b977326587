//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod contacts;
mod facts;
mod findings;
pub mod materials;
mod outcome;
mod page;
mod source;
mod trust;

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
];
