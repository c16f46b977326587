//! `tremolite law`: a material along a path, from files to files.

use std::path::Path;
use std::process::{Command, Output};
use tempfile::TempDir;
use tremolite_results::Table;

const CONCRETE: &str = r#"
[material]
law = "concrete-damage"
young = "25 GPa"
poisson = 0.17
tensile_strength = "1.2 MPa"
cohesion = "2.0 MPa"
friction_angle = "46 deg"
residual_tension = 0.1
ultimate_strain_ratio = 10.0
rate = "none"
evolution = "residual"
split = "effective"
"#;
const FREE_SIDES: &str = "time,exx,syy,szz,sxy,syz,szx\n";

/// A folder with a law and a path.
pub fn folder(law: &str, path: &str) -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("law.toml"), law).unwrap();
    std::fs::write(folder.path().join("path.csv"), path).unwrap();
    folder
}

pub fn law(folder: &Path, more: &[&str]) -> Output {
    let args = [&["law", "law.toml", "--path", "path.csv"], more].concat();
    Command::new(env!("CARGO_BIN_EXE_tremolite")).current_dir(folder).args(args).output().unwrap()
}

pub fn status(output: &Output) -> i32 {
    output.status.code().unwrap()
}

pub fn errors(output: &Output) -> String {
    String::from_utf8(output.stderr.clone()).unwrap()
}

/// The table that comes of a law and a path, and the status.
pub fn answer(law_file: &str, path: &str, more: &[&str]) -> (Table, i32) {
    let folder = folder(law_file, path);
    let output = law(folder.path(), &[&["--out", "out.csv"], more].concat());
    let table = Table::read(&folder.path().join("out.csv"));
    (table.unwrap_or_else(|e| panic!("{e}\n{}", errors(&output))), status(&output))
}

#[test]
fn concrete_in_tension_cracks_to_its_plateau_and_then_carries_nothing() {
    // The strain at f_t = 1.2 MPa is 48e-6, the last at which the plateau is carried 480e-6.
    let path = format!("{FREE_SIDES}0,0,0,0,0,0,0\n1,6e-4,0,0,0,0,0\n");
    let (table, code) = answer(CONCRETE, &path, &["--divide", "600"]);
    assert_eq!((code, table.rows()), (0, 601));
    let [strain, stress, damage] = ["exx", "sxx", "d_tension"].map(|name| table.column(name).unwrap());
    for row in 0..601 {
        let exact = match row {
            0..=47 => 25e9 * strain[row],
            // On the threshold itself round-off decides.
            48 | 480 => continue,
            49..=479 => 0.1 * 1.2e6,
            _ => 0.0,
        };
        assert!((stress[row] - exact).abs() < 1e-9 * 1.2e6, "row {row}: {} {exact}", stress[row]);
        assert_eq!(damage[row] > 0.0, row > 48, "row {row}");
        for side in ["syy", "szz", "sxy"] {
            assert!(table.column(side).unwrap()[row].abs() < 1e-3, "{side} in row {row}");
        }
    }
}

#[test]
fn concrete_under_cell_pressure_fails_at_mohr_coulomb() {
    // f_c + N p with f_c = 2 c cos φ/(1 − sin φ), N = (1 + sin φ)/(1 − sin φ).
    let (sine, cosine) = 46f64.to_radians().sin_cos();
    let (crushing, slope) = (2.0 * 2e6 * cosine / (1.0 - sine), (1.0 + sine) / (1.0 - sine));
    for pressure in [0.5e6, 2e6, 5e6] {
        let start = -(1.0 - 2.0 * 0.17) * pressure / 25e9;
        let megapascal = pressure / 1e6;
        let path = format!(
            "time,exx,syy [MPa],szz [MPa],sxy,syz,szx\n0,{start},-{megapascal},-{megapascal},0,0,0\n\
             1,-4e-3,-{megapascal},-{megapascal},0,0,0\n"
        );
        let (table, code) = answer(CONCRETE, &path, &["--divide", "4000"]);
        assert_eq!(code, 0);
        let value = |name: &str, row: usize| table.column(name).unwrap()[row];
        let broken = (0..table.rows()).find(|row| value("d_shear", *row) > 0.0).unwrap();
        let strength = crushing + slope * pressure;
        // A step is 1e-6 of strain.
        let short = strength + value("sxx", broken - 1);
        assert!((0.0..=1.001 * 25e3).contains(&short), "{pressure}: {short} Pa short of {strength}");
        // At the drop (1 − D⁻) E e is β times what it was; the sides go on carrying the pressure.
        let after = 0.2 * (strength - 0.34 * pressure) + 0.34 * pressure;
        assert!((value("sxx", broken) + after).abs() < 1.001 * 25e3, "{}", value("sxx", broken));
        for row in 0..table.rows() {
            assert!((value("syy", row) + pressure).abs() < 1e-9 * strength, "row {row}");
        }
    }
}

#[test]
fn a_step_that_cannot_be_carried_ends_with_status_1_its_line_and_the_rows_before() {
    let path =
        "# too much\ntime,sxx,syy,szz,sxy,syz,szx\n0,0,0,0,0,0,0\n1,1e6,0,0,0,0,0\n\n2,2e6,0,0,0,0,0\n";
    let folder = folder(CONCRETE, path);
    let output = law(folder.path(), &["--out", "out.csv", "--plot", "out.svg"]);
    assert_eq!(status(&output), 1);
    assert!(errors(&output).contains("path.csv, line 6: no strain was found"), "{}", errors(&output));
    let table = Table::read(&folder.path().join("out.csv")).unwrap();
    assert_eq!(table.column("time"), Some(&[0.0, 1.0][..]));
    assert!((table.column("sxx").unwrap()[1] - 1e6).abs() < 1.0);
    assert!((table.column("exx").unwrap()[1] - 4e-5).abs() < 1e-12);
    assert!(folder.path().join("out.svg").is_file());
}

#[test]
fn the_table_has_the_promised_columns_and_goes_to_standard_output_without_out() {
    let rows = "0,0,0,0,0,0,0\n0.5,1e-6,-2e-6,3e-6,4e-6,-5e-6,6e-6\n";
    let folder = folder(CONCRETE, &format!("\u{feff}time,exx,eyy,ezz,gxy,gyz,gzx\r\n{rows}"));
    let output = law(folder.path(), &[]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    let mut lines = text.lines();
    let header = lines.next().unwrap();
    let words: Vec<&str> = header.split(',').map(|h| h.split(' ').next().unwrap()).collect();
    let fixed = "time exx eyy ezz gxy gyz gzx sxx syy szz sxy syz szx d_tension d_shear d_b";
    assert_eq!(words[..16].join(" "), fixed);
    assert_eq!(header.matches("[Pa]").count(), 6);
    let values: Vec<f64> = lines.nth(1).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    assert_eq!(values[..7], [0.5, 1e-6, -2e-6, 3e-6, 4e-6, -5e-6, 6e-6]);
    let mu = 25e9 / (2.0 * 1.17);
    assert!(
        (values[10] - mu * 4e-6).abs() < 1e-6 * mu * 4e-6,
        "shear is the engineering angle: {}",
        values[10]
    );

    // The same bits in a file and under every instruction set this machine has.
    assert_eq!(status(&law(folder.path(), &["--out", "out.csv"])), 0);
    assert_eq!(std::fs::read_to_string(folder.path().join("out.csv")).unwrap(), text);
    for isa in tremolite_laws::Isa::ALL.into_iter().filter(|isa| isa.available()) {
        assert_eq!(law(folder.path(), &["--isa", isa.name()]).stdout, output.stdout, "{}", isa.name());
    }
    assert_eq!(status(&law(folder.path(), &["--isa", "mmx"])), 2);
}

#[test]
fn bad_files_are_refused_with_file_line_and_way_out_and_nothing_is_written() {
    let good = "time,exx,eyy,ezz,gxy,gyz,gzx\n0,0,0,0,0,0,0\n";
    let energy = CONCRETE.replace("ultimate_strain_ratio = 10.0", "fracture_energy = \"130 N/m\"");
    #[rustfmt::skip]
    let cases: &[(&str, &str, &[&str])] = &[
        (CONCRETE, "", &["path.csv: the file is empty", "time,exx"]),
        (CONCRETE, "0,0,0,0,0,0,0\n", &["path.csv, line 1", "line of names is missing"]),
        (CONCRETE, "time,exx,eyy,ezz,gxy,gyz,gzx\n", &["line 1", "no rows"]),
        (CONCRETE, "exx,eyy,ezz,gxy,gyz,gzx\n0,0,0,0,0,0\n", &["line 1", "no column time"]),
        (CONCRETE, "time,exx,eyy,ezz,exy,gyz,gzx\n", &["line 1", "gxy = 2 exy"]),
        (CONCRETE, "time,exx,eyy,gxy,gyz,gzx\n", &["line 1", "neither ezz nor szz", "add the one to be prescribed"]),
        (CONCRETE, "time,exx,sxx,eyy,ezz,gxy,gyz,gzx\n", &["line 1", "exx and sxx are both there"]),
        (CONCRETE, "time,exx,exx,eyy,ezz,gxy,gyz,gzx\n", &["line 1", "exx is there twice"]),
        (CONCRETE, "time,gap,slip1,slip2\n", &["line 1", "'gap' belongs to the path of an interface", "[interface]", "exx (or sxx)"]),
        (CONCRETE, "time,exy0\n", &["line 1", "'exy0' is no column of a path; columns are time, exx (or sxx)"]),
        (CONCRETE, "time,sxx [m],eyy,ezz,gxy,gyz,gzx\n", &["line 1", "sxx", "is a length"]),
        (CONCRETE, "time;exx;eyy\n", &["line 1", "neither ezz nor szz"]),
        (CONCRETE, "time,exx,eyy,ezz,gxy,gyz,gzx\r0,0,0,0,0,0,0\r", &["path.csv", "carriage return", "line ends of Unix"]),
        (CONCRETE, &format!("{good}1,x,0,0,0,0,0\n"), &["path.csv, line 3", "'x' is not a number"]),
        (CONCRETE, &format!("{good}# note\n1,nan,0,0,0,0,0\n"), &["path.csv, line 4", "not finite"]),
        (CONCRETE, &format!("{good}1,0,0\n"), &["path.csv, line 3", "3 values under 7 names"]),
        (CONCRETE, &format!("{good}0,1,0,0,0,0,0,0,0,0,0,0,0,0\n"), &["path.csv, line 3", "14 values under 7 names", "decimal commas"]),
        (CONCRETE, &(good.replace(',', ";") + "0,1;0;0;0;0;0;0\n"), &["path.csv, line 3", "'0,1' has a decimal comma", "0.1"]),
        (CONCRETE, &good.replace("\n0", "\ns,-,-,-,-,-,-\n0"), &["path.csv, line 2", "no numbers on this line", "one line of names"]),
        (CONCRETE, &format!("{good}-1,0,0,0,0,0,0\n"), &["path.csv, line 3", "time falls"]),
        (&CONCRETE.replace("young", "yung"), good, &["law.toml:4:", "did you mean `young`?"]),
        (&CONCRETE.replace("25 GPa", "25 m"), good, &["law.toml:4:", "is a length"]),
        (&CONCRETE.replace("0.17", "0.5"), good, &["law.toml:5:", "below 0.5"]),
        ("", good, &["law.toml", "no material"]),
        (&energy, good, &["law.toml:2:", "element's extent", "size = "]),
        (&format!("size = \"5 m\"{energy}"), good, &["law.toml:1:", "`size` must be below 4.514 m"]),
        (&format!("size = \"5 m\"{}", energy.replace("25 GPa", "25 MPa")), good, &["E or G_f looks too low"]),
        (&CONCRETE.replace("46 deg", "89.99 deg"), good, &["from 0 to 89.9 deg"]),
        ("[material]\nlaw = \"hoek-brown\"\nyoung = \"10 GPa\"\npoisson = 0.2\ncompressive_strength = \"80 MPa\"\ngsi = \"55 %\"\nm_i = 12\n", good,
            &["law.toml:6:", "GSI runs from 5 to 100, e.g. 55 (not 0.55)"]),
    ];
    for (text, path, words) in cases {
        let folder = folder(text, path);
        let output = law(folder.path(), &["--out", "out.csv", "--plot", "out.svg"]);
        assert_eq!(status(&output), 2, "{path}\n{}", errors(&output));
        for word in *words {
            assert!(
                errors(&output).contains(word),
                "'{word}' is missing for\n{path}{text}:\n{}",
                errors(&output)
            );
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "something was written for {path}");
    }
    let folder = folder(CONCRETE, good);
    std::fs::write(folder.path().join("path.csv"), b"time,exx\n\xff\n").unwrap();
    assert!(errors(&law(folder.path(), &[])).contains("path.csv, line 2: not text in UTF-8"));
    std::fs::remove_file(folder.path().join("path.csv")).unwrap();
    assert_eq!(status(&law(folder.path(), &[])), 2);
    assert!(errors(&law(folder.path(), &[])).contains("path.csv: cannot read this file"));
}

#[test]
fn no_output_destroys_an_input_or_another_output() {
    let path = format!("{FREE_SIDES}0,0,0,0,0,0,0\n1,1e-5,0,0,0,0,0\n");
    let folder = folder(CONCRETE, &path);
    std::fs::create_dir(folder.path().join("sub")).unwrap();
    let mut cases = vec![
        (vec!["--out", "path.csv"], "--out would overwrite --path"),
        (vec!["--out", "sub/../path.csv"], "--out would overwrite --path"),
        (vec!["--out", "./law.toml"], "--out would overwrite LAW.toml"),
        (vec!["--plot", "law.toml"], "--plot would overwrite LAW.toml"),
        (vec!["--out", "a.svg", "--plot", "./sub/../a.svg"], "--plot would overwrite --out"),
        (vec!["--plot", "x.png"], "figures are SVG"),
        (vec!["--plot", "x"], "figures are SVG"),
    ];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("path.csv", folder.path().join("link.svg")).unwrap();
        cases.push((vec!["--plot", "link.svg"], "--plot would overwrite --path"));
    }
    let before = std::fs::read_dir(folder.path()).unwrap().count();
    for (more, words) in cases {
        let output = law(folder.path(), &more);
        assert_eq!(status(&output), 2, "{more:?}");
        assert!(errors(&output).contains(words), "{more:?}: {}", errors(&output));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), before, "{more:?}");
    }
    assert_eq!(std::fs::read_to_string(folder.path().join("path.csv")).unwrap(), path);
    assert_eq!(std::fs::read_to_string(folder.path().join("law.toml")).unwrap(), CONCRETE);
    // One row is an answer, but no figure.
    std::fs::write(folder.path().join("path.csv"), format!("{FREE_SIDES}0,0,0,0,0,0,0\n")).unwrap();
    assert_eq!(status(&law(folder.path(), &["--out", "one.csv"])), 0);
    let output = law(folder.path(), &["--plot", "one.svg"]);
    assert!(status(&output) == 2 && errors(&output).contains("one row makes no figure"));
}

#[test]
fn an_answer_is_a_path_and_tables_of_other_programs_are_read() {
    let rows = ["0,0,0,0,0,0,0", "0.5,1e-4,-2e-5,-2e-5,0,0,0", "1,-2e-4,3e-5,3e-5,0,0,0"];
    let names = "time,exx,eyy,ezz,gxy,gyz,gzx";
    let table = |separator: &str, names: &str| {
        let lines: Vec<String> =
            std::iter::once(names).chain(rows).map(|l| l.replace(',', separator)).collect();
        lines.join("\n") + "\n"
    };
    let folder = folder(CONCRETE, &table(",", names));
    let output = law(folder.path(), &[]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    assert!(!String::from_utf8_lossy(&output.stdout).contains("-0,"), "a zero has no sign");
    for text in [
        table(";", names),
        table("\t", names),
        table(",", "Time[s],EXX,eyy,ezz [1e-3],gxy,gyz,gzx").replace(" [1e-3]", ""),
        table(",", names).replace('\n', ",\n"),
        table(";", names).replace('\n', ";\r\n"),
        String::from_utf8(output.stdout.clone()).unwrap(),
    ] {
        std::fs::write(folder.path().join("path.csv"), &text).unwrap();
        let again = law(folder.path(), &[]);
        assert_eq!(again.stdout, output.stdout, "{text}{}", errors(&again));
        assert_eq!(
            errors(&again).contains("sxx, syy, szz"),
            text.contains("d_tension"),
            "{}",
            errors(&again)
        );
    }
}

#[test]
fn crushing_is_followed_in_the_compliance_split_and_noted_with_its_line() {
    let text = CONCRETE.replace("split = \"effective\"", "split = \"compliance\"");
    let folder = folder(&text, &format!("{FREE_SIDES}0,0,0,0,0,0,0\n1,-2e-3,0,0,0,0,0\n"));
    let mut answers = Vec::new();
    for isa in tremolite_laws::Isa::ALL.into_iter().filter(|isa| isa.available()) {
        let output = law(folder.path(), &["--divide", "100", "--isa", isa.name()]);
        assert_eq!(status(&output), 0, "{}", errors(&output));
        assert!(errors(&output).contains("drops at once on the way to line 3"), "{}", errors(&output));
        answers.push(output.stdout);
    }
    assert!(answers.windows(2).all(|pair| pair[0] == pair[1]), "the same bits in every instruction set");
    let text = String::from_utf8(answers.swap_remove(0)).unwrap();
    let last: Vec<f64> = text.lines().last().unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    // β f_c with f_c = 2 c cos φ/(1 − sin φ), within the first order of a step of 2e-5.
    let (sine, cosine) = 46f64.to_radians().sin_cos();
    let left = 0.2 * 2.0 * 2e6 * cosine / (1.0 - sine);
    assert!((last[7] / -left - 1.0).abs() < 2e-3, "{} {left}", last[7]);
}

#[test]
fn the_energy_of_a_grade_is_named_where_the_size_is_missing() {
    let text = "[material]\nlaw = \"concrete-damage\"\ngrade = \"C30/37\"\nfriction_angle = \"46 deg\"\n";
    let folder = folder(text, &format!("{FREE_SIDES}0,0,0,0,0,0,0\n"));
    let output = law(folder.path(), &[]);
    assert_eq!(status(&output), 2);
    for words in ["that of grade C30/37", "size = ", "ultimate_strain_ratio"] {
        assert!(errors(&output).contains(words), "{}", errors(&output));
    }
}

#[test]
fn states_of_rock_are_drawn_as_strips() {
    let rock = "[material]\nlaw = \"mohr-coulomb\"\nyoung = \"10 GPa\"\npoisson = 0.25\ncohesion = \"2 MPa\"\n\
                friction_angle = \"42 deg\"\n";
    let folder = folder(rock, &format!("{FREE_SIDES}0,0,0,0,0,0,0\n1,-2e-3,0,0,0,0,0\n"));
    assert_eq!(status(&law(folder.path(), &["--divide", "50", "--plot", "f.svg"])), 0);
    let svg = std::fs::read_to_string(folder.path().join("f.svg")).unwrap();
    for (name, drawn) in
        [("shear now", true), ("shear earlier", true), ("tension now", false), ("tension earlier", false)]
    {
        assert_eq!(svg.contains(name), drawn, "{name}");
    }
}

#[test]
fn the_figure_shows_loops_the_tension_side_and_the_damage() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/laws");
    let folder = tempfile::tempdir().unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_tremolite"))
        .current_dir(folder.path())
        .arg("law")
        .arg(cases.join("concrete.toml"))
        .args(["--divide", "100", "--plot", "loops.svg", "--path"])
        .arg(cases.join("cyclic.csv"))
        .output()
        .unwrap();
    assert_eq!(status(&output), 0, "{}", errors(&output));
    assert!(output.stdout.is_empty(), "only the figure was asked for");
    let svg = std::fs::read_to_string(folder.path().join("loops.svg")).unwrap();
    for word in [
        "normal stress (MPa)",
        "tension side",
        "d_tension",
        "d_shear",
        "eyy = ezz",
        "lowest: xx, −9.",
        "time (s)",
    ] {
        assert!(svg.contains(word), "'{word}' is missing");
    }
    assert!(!svg.contains("NaN") && !svg.contains("factor"));
}
