//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod compare;
mod energy;
mod histories;
mod page;
mod section_strength;
mod source;
mod verdict;
mod view;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[
    compare::TEXTS,
    energy::TEXTS,
    histories::TEXTS,
    page::TEXTS,
    section_strength::TEXTS,
    source::TEXTS,
    verdict::TEXTS,
    view::TEXTS,
];
