//! What the program says of records, and what it refuses: seismometers, files that a case cannot read, processing without a word.

use std::path::Path;

use crate::motion::{burst, code, errors, json, shipped, told, tremolite};

/// Whole numbers of one channel as miniSEED 2, in a record of 512 bytes that says Int32, big-endian.
fn miniseed(path: &Path, code: &str, samples: &[i32]) {
    let mut bytes = vec![0_u8; 512];
    bytes[..20].copy_from_slice(format!("000001D STAT {:2}{code}XX", "").as_bytes());
    // 2020, day 1, 0:00; samples; 100 a second; no flags; one blockette, data from 64 and blockettes from 48.
    for (at, word) in [
        (20, 2020_u16),
        (22, 1),
        (30, samples.len() as u16),
        (32, 100),
        (34, 1),
        (44, 64),
        (46, 48),
        (48, 1000),
    ] {
        bytes[at..at + 2].copy_from_slice(&word.to_be_bytes());
    }
    bytes[39] = 1;
    bytes[52..55].copy_from_slice(&[3, 1, 9]);
    for (i, sample) in samples.iter().enumerate() {
        bytes[64 + 4 * i..68 + 4 * i].copy_from_slice(&sample.to_be_bytes());
    }
    std::fs::write(path, bytes).unwrap();
}

#[test]
fn counts_of_a_seismometer_come_into_no_case_by_no_way() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    told(at, &["new", "study"]);
    let samples: Vec<i32> = (0..100).map(|i| (i * 37) % 101 - 50).collect();
    miniseed(&at.join("study/a.mseed"), "BHE", &samples);
    let info = json(at, &["motion", "info", "study/a.mseed", "--json"]);
    assert_eq!(info["channels"][0]["other_sensor"], true);
    let text = told(at, &["motion", "info", "study/a.mseed"]);
    assert!(text.contains("seismometer") && text.contains("no record of acceleration"), "{text}");
    assert!(!text.contains("--sensitivity"), "{text}");
    for args in [&["motion", "process", "study/a.mseed"][..], &["motion", "spectrum", "study/a.mseed"]] {
        let refused = tremolite(at, args);
        let words = errors(&refused);
        assert_eq!(code(&refused), 2, "{args:?}");
        assert!(words.contains("does not record acceleration") && !words.contains("sensitivity"), "{words}");
    }
    assert!(!at.join("a_1.txt").exists());
    let case = at.join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let (component, whole) = ("east    = { file = \"a.mseed\" }", "file = \"a.mseed\"");
    for record in [component, whole] {
        std::fs::write(&case, text.replace("east    = { file = \"pulse.txt\" }", record)).unwrap();
        let refused = tremolite(at, &["check", "study/case.toml"]);
        let words = errors(&refused);
        assert_eq!(code(&refused), 2, "{record}");
        assert!(words.contains("does not record acceleration") && !words.contains("sensitivity"), "{words}");
    }
    // An accelerometer's go on to the question what a count is.
    miniseed(&at.join("study/a.mseed"), "BNE", &samples);
    let refused = tremolite(at, &["check", "study/case.toml"]);
    assert!(errors(&refused).contains("sensitivity"), "{}", errors(&refused));
    told(at, &["motion", "process", "study/a.mseed"]);
}

#[test]
fn processing_tells_what_became_of_each_record() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    burst(&at.join("a.txt"), "m/s2", 0.01, 0.0, 2.0);
    // An offset as of a digitiser, far above the shaking.
    let text = std::fs::read_to_string(at.join("a.txt")).unwrap();
    let offset = text.lines().filter_map(|l| l.split_once(' ').filter(|(t, _)| *t != "#"));
    let offset: String = offset.map(|(t, a)| format!("{t} {}\n", a.parse::<f64>().unwrap() + 50.0)).collect();
    std::fs::write(at.join("a.txt"), format!("# units = \"m/s2\"\n{offset}")).unwrap();

    let words = told(at, &["motion", "process", "a.txt", "--step", "detrend linear", "--step", "pga 3 m/s2"]);
    for word in [
        "before, less its mean: PGA 1.87",
        "after: PGA 3.000 m/s2",
        "displacement at the end",
        "pga 3 m/s2: multiplied by 1.60",
    ] {
        assert!(words.contains(word), "'{word}' is not in\n{words}");
    }
    let figure = std::fs::read_to_string(at.join("a_1.svg")).unwrap();
    assert!(figure.contains("before, less its mean") && figure.contains("largest: before −1.87"));
    let made =
        json(at, &["motion", "process", "a.txt", "--step", "scale 2", "--step", "pga 3 m/s2", "--json"]);
    assert_eq!(made["records"][0]["after"]["pga"].as_f64().map(|x| (x * 1e6).round()), Some(3e6));
    assert!((1.85..1.9).contains(&made["records"][0]["before"]["pga"].as_f64().unwrap()));
    // Of this step alone.
    let factor = made["pga_factors"][0].as_f64().unwrap();
    assert!((factor - 3.0 / 103.74).abs() < 1e-3, "{factor}");

    // Without a step the text is the record as it was read.
    let words = told(at, &["motion", "process", "a.txt", "--out", "seen"]);
    assert!(words.contains("less its mean: PGA 1.87") && !words.contains("after:"), "{words}");
    let info = |name: &str| json(at, &["motion", "info", name, "--json"])["channels"][0]["pga"].clone();
    assert_eq!(info("seen/a_1.txt"), info("a.txt"));
    assert!(std::fs::read_to_string(at.join("seen/a_1.svg")).unwrap().contains("no steps"));

    let reaches = |window: [&str; 2]| {
        let output =
            tremolite(at, &["motion", "process", "a.txt", "--no-plot", "--window", window[0], window[1]]);
        assert_eq!(code(&output), 0);
        errors(&output)
    };
    assert!(reaches(["1", "10"]).contains("runs from 0 s to 3.99 s; kept 1 s to 3.99 s"));
    assert_eq!(reaches(["1", "3.995"]), "");
    std::fs::write(at.join("one.txt"), "1\n2\n4\n").unwrap();
    let one = json(at, &["motion", "info", "one.txt", "--units", "g", "--dt", "5 ms", "--json"]);
    assert_eq!(one["channels"][0]["dt"], 0.005);
    let wrong = tremolite(at, &["motion", "info", "one.txt", "--units", "g", "--dt", "5 Hz"]);
    assert!(code(&wrong) == 2 && errors(&wrong).contains("0.005 s"), "{}", errors(&wrong));
}

#[test]
fn a_record_that_cannot_be_read_has_one_remedy_and_it_is_one_of_a_case() {
    let folder = tempfile::tempdir().unwrap();
    let at = folder.path();
    told(at, &["new", "study"]);
    let case = at.join("study/case.toml");
    let text = std::fs::read_to_string(&case).unwrap();
    let kind = text.lines().find(|l| l.starts_with("kind ")).unwrap();
    for word in ["outcrop", "incident", "within", "surface"] {
        assert!(kind.split('#').nth(1).unwrap().contains(word), "{word} is not in {kind}");
    }
    let with = |record: &str| {
        std::fs::write(&case, text.replace("east    = { file = \"pulse.txt\" }", record)).unwrap();
        let output = tremolite(at, &["check", "study/case.toml"]);
        (code(&output), errors(&output))
    };
    std::fs::write(at.join("study/several.txt"), "0 1 2 3\n0.01 4 5 6\n").unwrap();
    let (refused, words) = with("east = { file = \"several.txt\" }");
    assert_eq!((refused, words.matches("help: ").count()), (2, 1), "{words}");
    assert!(words.contains("columns = [\"time\"") && words.contains("columns = [\"rows\"]"), "{words}");
    assert!(!words.contains("mend the file"), "{words}");
    let (refused, words) = with("file = \"several.txt\"");
    assert!(refused == 2 && words.contains("such files go in as components"), "{words}");
    // What the remedies say is taken: counts in a plain file, and a sensitivity that implies them.
    burst(&at.join("study/raw.txt"), "m/s2", 0.01, 0.0, 1e5);
    let plain = std::fs::read_to_string(at.join("study/raw.txt")).unwrap();
    let plain: String = plain.split_inclusive('\n').skip(1).collect();
    std::fs::write(at.join("study/raw.txt"), plain).unwrap();
    for units in ["", "units = \"counts\", "] {
        let (done, words) =
            with(&format!("east = {{ file = \"raw.txt\", {units}sensitivity = \"427336counts/(m/s2)\" }}"));
        assert_eq!(done, 0, "{units}: {words}");
    }
    let (refused, words) = with("east = { file = \"raw.txt\", units = \"counts\" }");
    assert!(refused == 2 && words.contains("nothing says what a count is"), "{words}");

    // A vertical record that was processed is not east's.
    let file = shipped("20161113_110259_WTMC_20.V2A");
    told(at, &["motion", "process", &file, "--out", "study", "--no-plot"]);
    let up = (1..=3).find(|i| {
        let text =
            std::fs::read_to_string(at.join(format!("study/20161113_110259_WTMC_20_{i}.txt"))).unwrap();
        text.contains("# direction = \"up\"")
    });
    let record = format!("east = {{ file = \"20161113_110259_WTMC_20_{}.txt\" }}", up.unwrap());
    let (_, words) = with(&record);
    assert!(words.contains("is given as `east`, but its file states its direction as up"), "{words}");
}
