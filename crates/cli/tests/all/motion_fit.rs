//! Motions that fit a spectrum, on the command line.

use crate::motion::{code, errors, json, shipped, told, tremolite};
use std::fs;

const TARGET: &str = "EN 1998-1 type 1 ground B 2 m/s2";

#[test]
fn a_matched_record_is_read_again_and_is_the_nearest_of_its_folder() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let record = shipped("51WCW_EW_20s_40s_gal_int.txt");
    let band = ["--target", TARGET, "--band", "0.3 s", "1.5 s"];
    let mut args = vec!["motion", "match", &record, "--units", "cm/s2", "--out", "records", "--json"];
    args.extend(band);
    let made = json(at, &args);
    let one = &made["motions"][0];
    assert!(one["before"]["largest_misfit"].as_f64().unwrap() > 0.3, "{one}");
    assert!(one["after"]["largest_misfit"].as_f64().unwrap() <= 0.05, "{one}");
    assert!(one["displacement_at_end"].as_f64().unwrap() < 0.01, "{one}");
    let drawn = fs::read_to_string(at.join(one["figure"].as_str().unwrap())).unwrap();
    assert!(drawn.contains("target: EN 1998-1"));
    fs::remove_file(at.join(one["figure"].as_str().unwrap())).unwrap();

    // Its spectrum as the program gives it, at the periods inside the band.
    let written = one["written"].as_str().unwrap();
    let spectrum = &json(at, &["motion", "spectrum", written, "--json"])["channels"][0];
    let [periods, psa] = ["periods", "psa"].map(|key| spectrum[key].as_array().unwrap().clone());
    let plateau = 2.5 * 1.2 * 2.0;
    let mut seen = 0;
    for (period, sa) in periods.iter().zip(&psa) {
        let (period, sa) = (period.as_f64().unwrap(), sa.as_f64().unwrap());
        let exact = if period <= 0.5 { plateau } else { plateau * 0.5 / period };
        if (0.3..=1.5).contains(&period) {
            // 5 %, and what the line of best fit takes, which `spectrum` removes.
            assert!((sa / exact - 1.0).abs() < 0.06, "{period} s: {sa} for {exact} m/s2");
            seen += 1;
        }
    }
    assert!(seen > 20);

    fs::copy(shipped("20161113_110259_WTMC_20.V2A"), at.join("records/other.V2A")).unwrap();
    let mut args = vec!["motion", "select", "records", "--json", "--factors", "0.01", "100"];
    args.extend(band);
    // A channel that stands still is named and does no harm.
    fs::write(
        at.join("records/dead.txt"),
        format!("# units = \"m/s2\"\n# dt = \"0.01 s\"\n{}", "0\n".repeat(500)),
    )
    .unwrap();
    let output = tremolite(at, &args);
    assert!(errors(&output).contains("'dead' does not move"), "{}", errors(&output));
    let list = json(at, &args);
    let first = &list["records"][0];
    assert!(first["file"].as_str().unwrap().ends_with(".matched.txt"), "{list}");
    assert!((first["factor"].as_f64().unwrap() - 1.0).abs() < 0.03, "{list}");
    assert!(list["considered"].as_u64().unwrap() > 2, "{list}");
}

#[test]
fn artificial_motions_repeat_and_wrong_words_have_their_remedy() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    let args = |out| {
        let mut all = vec!["motion", "artificial", "--target", TARGET, "--band", "0.4 s", "2 s"];
        all.extend(["--duration", "10 s", "--dt", "0.02 s", "--no-plot", "--out", out]);
        all
    };
    told(at, &args("a"));
    told(at, &args("b"));
    let read = |out: &str| fs::read(at.join(out).join("artificial_1.txt")).unwrap();
    assert_eq!(read("a"), read("b"));
    for (target, remedy) in [("NB 35047", "CSV"), ("EN 1998-1 type 1 ground F 2 m/s2", "A, B, C, D or E")] {
        let refused = tremolite(at, &["motion", "artificial", "--target", target, "--duration", "10 s"]);
        assert_ne!(code(&refused), 0);
        assert!(errors(&refused).contains(remedy), "{}", errors(&refused));
    }
    let mut args = args("c");
    args.extend(["--count", "2", "--seed", "18446744073709551614"]);
    let refused = tremolite(at, &args);
    assert!(code(&refused) == 2 && errors(&refused).contains("--seed"), "{}", errors(&refused));
}
