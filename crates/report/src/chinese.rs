//! The page's texts in Chinese: for each English pattern one with the same slots, by the files in which they stand.
//!
//! Terms follow GB/T 50279 (hydraulic engineering) and GB/T 50083 (structures) where they have one.

mod depth;
mod input;
mod page;
mod source;
mod spectra;

/// English pattern and Chinese.
pub type Texts = &'static [(&'static str, &'static str)];

/// All of them.
pub const TABLES: &[Texts] = &[depth::TEXTS, input::TEXTS, page::TEXTS, source::TEXTS, spectra::TEXTS];
