//! Whether two result folders hold the same results, bit by bit: `same ONE OTHER` names what differs beyond what may, and then ends with
//! status 1.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    let folders: Vec<String> = std::env::args().skip(1).collect();
    let [one, other] = &folders[..] else {
        eprintln!("usage: same ONE OTHER, two result folders");
        return ExitCode::from(2);
    };
    match tremolite_results::differences(Path::new(one), Path::new(other)) {
        Ok(found) if found.is_empty() => ExitCode::SUCCESS,
        Ok(found) => {
            found.iter().for_each(|one| println!("{one}"));
            ExitCode::from(1)
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}
