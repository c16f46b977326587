//! `tremolite law`: a pair of an interface along a path, from files to files.

use crate::law::{answer, errors, folder, law, status};
use std::path::Path;
use tremolite_laws::Isa;
use tremolite_results::Table;

/// k_n0 = 20 GPa/m, T = 0.5 mm, c = 1 MPa, μ = 0.7.
const JOINT: &str = "[interface]\nlaw = \"bandis\"\nnormal_stiffness = \"20 GPa/m\"\nmax_closure = \"0.5 mm\"\n\
                     cohesion = \"1 MPa\"\nfriction_coefficient = 0.7\n";
const LINEAR: &str =
    "[interface]\nlaw = \"coulomb\"\nnormal_stiffness = \"20 GPa/m\"\nfriction_coefficient = 0.7\n";
const NAMES: &str = "time,gap,slip1,slip2\n";

fn column<'a>(table: &'a Table, name: &str) -> &'a [f64] {
    table.column(name).unwrap_or_else(|| panic!("{name} is missing"))
}

#[test]
fn a_closure_test_gives_the_hyperbola_and_its_straight_end() {
    let path = format!("{NAMES}0,0,0,0\n1,-4.5e-4,0,0\n");
    let (table, code) = answer(JOINT, &path, &["--divide", "450"]);
    assert_eq!((code, table.rows()), (0, 451));
    for (gap, pressure) in column(&table, "gap").iter().zip(column(&table, "pressure")) {
        let hyperbola = |g: f64| -20e9 * g / (1.0 + g / 0.5e-3);
        // A quarter of T is left at 0.375 mm, 30 MPa, with sixteen times the stiffness.
        let exact = if *gap > -0.375e-3 { hyperbola(*gap) } else { 30e6 + 320e9 * (-0.375e-3 - gap) };
        assert!((pressure - exact).abs() < 1e-9 * 54e6, "{gap}: {pressure} {exact}");
    }
    assert!(column(&table, "state").iter().all(|s| *s == 0.0), "bonded");
}

#[test]
fn a_shear_test_at_constant_pressure_breaks_the_bond_slides_and_turns() {
    let path = "time,pressure [MPa],slip1 [mm],slip2\n0,0,0,0\n1,1,0,0\n2,1,0.6,0\n3,1,-0.3,0\n";
    let (table, code) = answer(JOINT, path, &["--divide", "600"]);
    assert_eq!(code, 0);
    let [slip, shear, state] = ["slip1", "shear1", "state"].map(|name| column(&table, name));
    // k_t = k_n/(2(1 + ν)) with k_n = k_n0 (1 + p/(k_n0 T))².
    let stiffness = 20e9 * 1.1f64.powi(2) / 2.5;
    let (strength, friction) = (1e6 + 0.7e6, 0.7e6);
    let broken = (0..table.rows()).find(|row| state[*row] == 2.0).unwrap();
    assert!(slip[broken - 1] * stiffness <= strength && slip[broken] * stiffness > strength);
    for row in 601..table.rows() {
        let exact = match row {
            _ if row < broken => stiffness * slip[row],
            _ if row <= 1200 => friction,
            _ => f64::max(-friction, friction - stiffness * (0.6e-3 - slip[row])),
        };
        assert!((shear[row] - exact).abs() < 1e-6 * strength, "row {row}: {} {exact}", shear[row]);
        assert!((column(&table, "pressure")[row] - 1e6).abs() < 1e-3, "row {row}");
    }
    assert_eq!(column(&table, "shear2").iter().fold(0.0, |most, t| f64::max(most, t.abs())), 0.0);
    assert_eq!([state[600], state[1201], state[1800]], [0.0, 1.0, 2.0]);
}

#[test]
fn a_tension_that_nothing_carries_ends_with_status_1_its_line_and_the_rows_before() {
    let rows = "# joint\ntime,pressure,slip1,slip2\n0,0,0,0\n1,1e6,0,0\n\n2,-1e5,0,0\n";
    for (text, code) in [(LINEAR, 1), (JOINT, 0)] {
        let folder = folder(text, rows);
        let output = law(folder.path(), &["--out", "out.csv", "--plot", "out.svg"]);
        assert_eq!(status(&output), code, "{}", errors(&output));
        let table = Table::read(&folder.path().join("out.csv")).unwrap();
        assert!((column(&table, "pressure")[1] - 1e6).abs() < 1e-3);
        if code == 0 {
            assert!((column(&table, "pressure")[2] + 1e5).abs() < 1e-3, "the bond holds");
        } else {
            assert!(errors(&output).contains("path.csv, line 6: no gap was found"), "{}", errors(&output));
            assert!(errors(&output).contains("prescribe the gap"));
            assert_eq!(column(&table, "time"), [0.0, 1.0]);
            assert!((column(&table, "gap")[1] + 5e-5).abs() < 1e-15);
        }
        assert!(folder.path().join("out.svg").is_file());
    }
}

#[test]
fn the_table_has_the_promised_columns_and_the_same_bits_on_every_instruction_set() {
    let folder =
        folder(JOINT, &format!("{NAMES}0,0,0,0\n1,-1e-4,1e-5,2e-5\n2,-1e-4,1e-3,2e-5\n3,1e-3,1e-3,2e-5\n"));
    let output = law(folder.path(), &["--divide", "50"]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    let text = String::from_utf8(output.stdout.clone()).unwrap();
    let header = text.lines().next().unwrap();
    let fixed = "time [s],gap [m],slip1 [m],slip2 [m],pressure [Pa],shear1 [Pa],shear2 [Pa],state,slid,opened,\
                 friction_work [J/m2],created [J/m2],last_gap [m],";
    assert!(header.starts_with(fixed), "{header}");
    assert_eq!(header.matches("state").count(), 1);
    let row: Vec<f64> = text.lines().nth(51).unwrap().split(',').map(|x| x.parse().unwrap()).collect();
    assert_eq!(row[..4], [1.0, -1e-4, 1e-5, 2e-5]);
    assert!(row[5] > 0.0 && row[6] > row[5], "shear along the slip that caused it");
    assert!(text.lines().last().unwrap().split(',').nth(7) == Some("3"), "open");
    for isa in Isa::ALL.into_iter().filter(|isa| isa.available()) {
        assert_eq!(law(folder.path(), &["--divide", "50", "--isa", isa.name()]).stdout, output.stdout);
    }
}

#[test]
fn an_answer_is_a_path_by_its_gap_and_tables_of_other_programs_are_read() {
    let rows = "0,0,0,0\n1,1e6,0,0\n2,1e6,1e-3,0\n3,0,1e-3,1e-4\n";
    let folder = folder(JOINT, &format!("time,pressure,slip1,slip2\n{rows}"));
    let output = law(folder.path(), &["--divide", "20"]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    let answer = String::from_utf8(output.stdout.clone()).unwrap();
    assert!(!answer.contains("-0,"), "a zero has no sign");
    std::fs::write(folder.path().join("path.csv"), &answer).unwrap();
    let again = law(folder.path(), &[]);
    assert_eq!(again.stdout, output.stdout, "{}", errors(&again));
    assert!(errors(&again).contains("pressure, shear1, shear2, state, slid"), "{}", errors(&again));
    let [metres, separated] = [
        "time,gap,slip1,slip2\n0,0,0,0\n1,-2e-4,5e-4,0\n",
        "\u{feff}Time [s];Slip1 [mm];slip2;GAP [mm]\r\n0;0;0;0\r\n1;0.5;0;-0.2\r\n",
    ]
    .map(|text| {
        std::fs::write(folder.path().join("path.csv"), text).unwrap();
        law(folder.path(), &[]).stdout
    });
    assert!(!metres.is_empty() && metres == separated);
}

#[test]
fn bad_files_are_refused_with_file_line_and_way_out_and_nothing_is_written() {
    let good = format!("{NAMES}0,0,0,0\n");
    #[rustfmt::skip]
    let cases: &[(&str, &str, &[&str])] = &[
        (JOINT, "", &["path.csv: the file is empty", "time,gap,slip1,slip2"]),
        (JOINT, "0,0,0,0\n", &["line 1", "line of names is missing", "time,gap,slip1,slip2"]),
        (JOINT, "time,exx,eyy,ezz,gxy,gyz,gzx\n", &["line 1", "'exx' belongs to the path of a material", "[material]", "gap (or pressure)"]),
        (JOINT, "time,sxx\n", &["line 1", "'sxx' belongs to the path of a material"]),
        (JOINT, "time,exy\n", &["line 1", "'exy' is no column of a path; columns are time, gap (or pressure), slip1, slip2"]),
        (JOINT, "time,slip1,slip2\n", &["line 1", "neither gap nor pressure"]),
        (JOINT, "time,gap,slip1\n", &["line 1", "there is no column slip2", "zeros"]),
        (JOINT, "time,gap,shear1,slip2\n", &["line 1", "shear1 cannot be prescribed", "add slip1"]),
        (JOINT, "time,gap,pressure,slip1,slip2\n", &["line 1", "gap and pressure are both there"]),
        (JOINT, "time,gap,gap,slip1,slip2\n", &["line 1", "gap is there twice"]),
        (JOINT, "time,pressure [mm],slip1,slip2\n", &["line 1", "pressure", "is a length"]),
        (JOINT, "time,gap [MPa],slip1,slip2\n", &["line 1", "gap: "]),
        (JOINT, &(NAMES.to_owned() + "s,m,m,m\n0,0,0,0\n"), &["line 2", "no numbers on this line", "gap [mm]"]),
        (JOINT, &format!("{good}1,x,0,0\n"), &["path.csv, line 3", "'x' is not a number"]),
        (JOINT, &format!("{good}-1,0,0,0\n"), &["path.csv, line 3", "time falls"]),
        (JOINT, &good, &["one row makes no figure"]),
        (&JOINT.replace("friction_coefficient = 0.7", "friction_coefficient = -1"), &good, &["law.toml:6:", "friction"]),
        (&JOINT.replace("max_closure", "max_closur"), &good, &["law.toml:4:", "did you mean `max_closure`?"]),
        (&JOINT.replace("normal_stiffness = \"20 GPa/m\"\n", ""), &good, &["law.toml:1:", "`normal_stiffness` is missing"]),
    ];
    for (text, path, words) in cases {
        let folder = folder(text, path);
        let output = law(folder.path(), &["--out", "out.csv", "--plot", "out.svg"]);
        assert_eq!(status(&output), 2, "{path}\n{}", errors(&output));
        for word in *words {
            let said = errors(&output);
            assert!(said.contains(word), "'{word}' is missing for\n{path}{text}:\n{said}");
        }
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2, "something was written for {path}");
    }
}

#[test]
fn defaults_and_what_is_unusual_are_said() {
    let folder = folder(&JOINT.replace("0.7", "35"), &format!("{NAMES}0,0,0,0\n"));
    let output = law(folder.path(), &[]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    for words in [
        "by default: poisson 0.25, tangential following, closure_floor 0.25\n",
        "warning",
        "give an angle as `friction_angle`",
        "law.toml:1:",
    ] {
        assert!(errors(&output).contains(words), "{words}:\n{}", errors(&output));
    }
}

#[test]
fn the_figure_shows_closure_shear_what_was_booked_and_the_states() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/laws");
    let read = |name: &str| std::fs::read_to_string(cases.join(name)).unwrap();
    let folder = folder(&read("joint.toml"), &read("shear.csv"));
    let output = law(folder.path(), &["--divide", "200", "--plot", "f.svg"]);
    assert_eq!(status(&output), 0, "{}", errors(&output));
    assert!(output.stdout.is_empty(), "only the figure was asked for");
    let svg = std::fs::read_to_string(folder.path().join("f.svg")).unwrap();
    for word in [
        "pressure (MPa)",
        "closure (µm)",
        "shear (MPa)",
        "slip (µm)",
        "highest: shear1, 2.10",
        "lowest: shear1, −0.700",
        "friction_work (J/m²)",
        "created (J/m²)",
        ">sliding<",
        ">stuck<",
        "time (s)",
    ] {
        assert!(svg.contains(word), "'{word}' is missing");
    }
    // What varies in no row, repeats a line or never was is not drawn.
    for word in ["NaN", "shear2", "slip2", "last_", "anchor1", "opened", ">open<"] {
        assert!(!svg.contains(word), "'{word}' is drawn");
    }
}
