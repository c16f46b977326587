//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod maps;
mod page;
mod source;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[maps::TEXTS, page::TEXTS, source::TEXTS];
