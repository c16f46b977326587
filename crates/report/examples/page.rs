//! Writes the page of a result folder: `cargo run -p tremolite-report --example page -- DIR [en|zh]`.

use std::env;
use std::path::Path;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let [folder, language @ ..] = &arguments[..] else { return Err("give a result folder".into()) };
    let page = match language.first() {
        Some(code) => tremolite_report::write_in(Path::new(folder), code.parse()?)?,
        None => tremolite_report::write(Path::new(folder))?,
    };
    println!("{}", page.display());
    Ok(())
}
