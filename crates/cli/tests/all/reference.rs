//! docs/reference.md is what the program prints, and docs/meshes.md holds a case that is read.

use std::path::Path;
use tremolite_case::Case;
use tremolite_laws::materials::MATERIALS;

fn docs(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs").join(name);
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

#[test]
fn the_reference_is_the_one_that_the_program_prints() {
    let printed = tremolite_case::reference(MATERIALS);
    assert!(
        docs("reference.md").trim_end() == printed.trim_end(),
        "write it anew: tremolite list keys > docs/reference.md"
    );
}

#[test]
fn pictures_of_the_reference_are_there() {
    let page = docs("reference.md");
    let pictures: Vec<&str> =
        page.split("](reference/").skip(1).filter_map(|rest| rest.split(')').next()).collect();
    assert!(pictures.len() >= 2);
    for picture in pictures {
        assert!(docs(&format!("reference/{picture}")).starts_with("<svg"), "{picture}");
    }
}

/// The blocks of TOML that are whole cases.
#[test]
fn whole_cases_of_the_docs_are_read() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs");
    let mut cases = 0;
    for file in std::fs::read_dir(folder).unwrap().map(|file| file.unwrap().path()) {
        if file.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let text = std::fs::read_to_string(&file).unwrap();
        for block in text.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next()) {
            if block.starts_with("title") && block.contains("[[region]]") {
                cases += 1;
                let read = Case::parse(Path::new("case.toml"), block, MATERIALS);
                assert!(
                    read.is_ok(),
                    "{}: {}",
                    file.display(),
                    read.err().map_or_else(String::new, |e| e.to_string())
                );
            }
        }
    }
    assert!(cases >= 1);
}
