//! Cases on disk.

use std::fs;
use std::path::PathBuf;

use tremolite_case::Case;
use tremolite_laws::materials::MATERIALS;

const GOOD: &str = include_str!("../cases/every-key.toml");

/// A folder of its own for each test, removed at the end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let path = std::env::temp_dir().join(format!("tremolite-case-{name}-{}", std::process::id()));
        fs::create_dir_all(&path).expect("a folder for the test");
        Folder(path)
    }

    fn file(&self, name: &str, content: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        fs::write(&path, content).expect("a file for the test");
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        // A folder that stays behind in the temporary directory harms nothing.
        let _ = fs::remove_dir_all(&self.0);
    }
}

#[test]
fn files_are_looked_for_beside_the_case() {
    let folder = Folder::new("beside");
    let path = folder.file("case.toml", GOOD);
    folder.file("a.txt", "");
    let report = Case::read(&path, MATERIALS).expect_err("b.txt is missing");
    let [problem] = &report.problems[..] else { panic!("{report}") };
    assert_eq!(&report.source[problem.span.clone()], "\"b.txt\"");
    assert!(problem.message.contains("no file b.txt"), "{report}");
    assert!(problem.remedy.contains(&folder.0.join("b.txt").display().to_string()), "{report}");
    folder.file("b.txt", "");
    let case = Case::read(&path, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(case.source, GOOD);
    assert_eq!(case.directory(), folder.0);
}

#[test]
fn paths_with_backslashes_are_pointed_at_forward_slashes() {
    let folder = Folder::new("backslashes");
    folder.file("a.txt", "");
    folder.file("b.txt", "");
    for (written, shown) in [
        ("\"records\\new.txt\"", "records\\new.txt"),
        ("\"records\\\\new.txt\"", "records\\\\new.txt"),
        ("'records\\new.txt'", "records\\\\new.txt"),
    ] {
        let path = folder.file("case.toml", GOOD.replace("\"b.txt\"", written));
        let report = Case::read(&path, MATERIALS).expect_err("no such file");
        let [problem] = &report.problems[..] else { panic!("{report}") };
        assert_eq!(&report.source[problem.span.clone()], written);
        assert_eq!(problem.message, format!("there is no file {shown}"));
        assert!(problem.remedy.contains("forward slashes, \"records/new.txt\""), "{report}");
    }
}

#[test]
fn a_case_that_cannot_be_read_is_reported_by_name() {
    let folder = Folder::new("unreadable");
    let report = Case::read(&folder.0.join("none.toml"), MATERIALS).expect_err("no such file");
    assert!(report.to_string().contains("none.toml"), "{report}");
    let path = folder.file("latin1.toml", b"title = \"Pr\xfcfung\"");
    let report = Case::read(&path, MATERIALS).expect_err("not UTF-8");
    assert!(report.to_string().contains("UTF-8"), "{report}");
    let report = Case::read(&folder.0, MATERIALS).expect_err("a folder");
    assert!(report.to_string().contains("cannot be read"), "{report}");
}
