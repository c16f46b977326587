//! The tests of this crate, one binary.

mod bolts;
mod chinese_page;
mod compare;
mod cracks;
mod deconvolved;
mod free_field;
mod further_quantities;
mod gaps;
mod interface_results;
mod interfaces;
mod many_monitors;
mod maps;
mod numbers;
mod odd_names;
mod one_unit;
mod page;
mod report;
mod sheets;
mod spectra;
mod stages;
mod verdict;
mod view;
mod view_blocks;
mod view_files;
