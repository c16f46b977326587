//! What chapters of the page are made of: figures, tables, and texts that stand in the result files.

pub mod figure;
pub mod results_text;
pub mod text_table;
