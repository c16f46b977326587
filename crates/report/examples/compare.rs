//! Writes the comparison of result folders: `cargo run -p tremolite-report --example compare -- PAGE DIR1 DIR2 …`.

use std::env;
use std::path::PathBuf;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<PathBuf> = env::args().skip(1).map(PathBuf::from).collect();
    let [page, folders @ ..] = &arguments[..] else { return Err("give a page and result folders".into()) };
    tremolite_report::compare(folders, page, None)?;
    Ok(())
}
