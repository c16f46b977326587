use super::*;
use std::fs;

const STUDY: &str = r#"
title = "t"
case = "case.toml"
[[record]]
name = "a"
file = "a"
[[record]]
name = "b"
file = "b"
[[record]]
name = "c"
file = "c"
[scale]
measure = "PGA"
levels = ["0.1 g", "0.2 g", "0.3 g", "0.4 g"]
[measure]
m = { summary = "x.value" }
[[fragility]]
measure = "m"
above = [0.5, 10.0]
failed = "exceeds"
"#;

/// A study with results: of record and level the measure, or the status.
fn with(text: &str, result: impl Fn(usize, usize) -> Result<f64, &'static str>) -> (Study, Vec<Missing>) {
    let study = StudyFile::parse(Path::new("study.toml"), text).unwrap_or_else(|e| panic!("{e}"));
    let plan = Plan::of(&study, None).unwrap_or_else(|e| panic!("{e:?}"));
    let out = tempfile::tempdir().unwrap();
    let prepared: Vec<Prepared> = plan
        .runs
        .iter()
        .map(|run| {
            let folder = RunFolder::new(out.path(), &run.name);
            fs::create_dir_all(folder.results()).unwrap();
            fs::write(folder.bare(), &run.name).unwrap();
            let summary = folder.results().join("summary.json");
            match result(run.record.unwrap(), run.level.unwrap()) {
                Ok(x) => {
                    let classes = r#""state": {"class": "withstands"}, "reliance": {"class": "sound"}"#;
                    let text = format!("{{\"status\": \"done\", {classes}, \"x\": {{\"value\": {x}}}}}");
                    fs::write(summary, text).unwrap();
                }
                Err("error") => fs::write(folder.broken(), "refused\n").unwrap(),
                Err("pending") => {}
                Err("missing") => fs::write(summary, "{\"status\": \"done\"}").unwrap(),
                Err(word) => {
                    if word == "failed" {
                        fs::write(folder.results().join("energy.csv"), "").unwrap();
                    }
                    fs::write(summary, "{\"status\": \"failed\", \"outcome\": \"It failed.\"}").unwrap();
                }
            }
            let level = plan.levels[run.level.unwrap()].value;
            let intensities = vec![Some(level), Some(level / 10.0)];
            Prepared { bare: run.name.clone(), factor: Some(1.0), intensities }
        })
        .collect();
    gather(&study, &plan, &prepared, out.path())
}

#[test]
fn runs_that_have_no_result_are_told_and_counted_as_asked_for() {
    // Record 0 cracks from 0.2 g on, 1 from 0.3 g on; 2 is stopped at 0.4 g, does not come to rest at 0.1 g, and is not yet there.
    let result = |record: usize, level: usize| match (record, level) {
        (2, 3) => Err("failed"),
        (2, 0) => Err("not_converged"),
        (2, 1) => Err("pending"),
        (2, 2) => Ok(0.2),
        (record, level) => Ok(if level > record { 1.0 } else { 0.1 }),
    };
    let (found, missing) = with(STUDY, result);
    assert_eq!(missing, []);
    let [half, ten] = &found.fragilities[..] else { panic!("{:?}", found.fragilities) };
    assert_eq!((half.counted, half.exceeded, half.stopped_counted), (10, 6, 1));
    assert_eq!(half.left_out, [("not_converged".to_owned(), 1), ("pending".to_owned(), 1)]);
    let shares: Vec<(usize, usize)> = half.shares.iter().map(|s| (s.exceeded, s.of)).collect();
    assert_eq!(shares, [(0, 2), (1, 2), (2, 3), (3, 3)]);
    assert!(half.fit.is_some_and(|fit| fit.theta > 0.15 && fit.theta < 0.3), "{half:?}");
    // At 10 the stopped run alone, at the highest level.
    assert!(
        ten.fit.is_none() && ten.no_curve.starts_with("only the highest level, 0.4 g, exceeds"),
        "{ten:?}"
    );
    assert!(ten.no_curve.contains("(1 of 3 runs)") && ten.no_curve.contains("add levels above 0.4 g"));
    let left_out = STUDY.replace("\"exceeds\"", "\"left-out\"");
    let (found, _) = with(&left_out, result);
    assert_eq!(found.fragilities[0].counted, 9);
    assert!(found.fragilities[0].left_out.contains(&("failed".to_owned(), 1)));
    assert!(found.fragilities[1].no_curve.contains("no run is beyond"), "{:?}", found.fragilities[1]);
    let table = csv(&found);
    assert!(table.lines().count() == 13 && table.contains("not_converged,It failed."), "{table}");
}

#[test]
fn state_and_reliance_of_each_run_stand_in_the_table() {
    let (found, _) = with(STUDY, |_, level| if level == 0 { Err("missing") } else { Ok(1.0) });
    let table = csv(&found);
    let head: Vec<&str> = table.lines().next().unwrap().split(',').collect();
    let column = |name: &str| head.iter().position(|h| *h == name).unwrap();
    let cells = |line: &str, name: &str| line.split(',').nth(column(name)).unwrap().to_owned();
    let lines: Vec<&str> = table.lines().skip(1).collect();
    assert_eq!(["state", "reliance"].map(|name| cells(lines[1], name)), ["withstands", "sound"]);
    assert_eq!(["state", "reliance"].map(|name| cells(lines[0], name)), ["", ""]);
}

#[test]
fn three_records_give_their_largest_where_all_have_a_result() {
    let (found, _) = with(STUDY, |record, level| Ok((record + 10 * level) as f64));
    let first = &found.over_records[0];
    assert_eq!((first.mean, first.largest, first.by_code), (1.0, 2.0, Some(2.0)));
    let (found, _) =
        with(STUDY, |record, level| if (record, level) == (1, 0) { Err("failed") } else { Ok(1.0) });
    assert_eq!((found.over_records[0].records, found.over_records[0].by_code), (2, None));
}

#[test]
fn a_measure_that_results_lack_is_told() {
    let (found, missing) = with(STUDY, |_, level| if level == 0 { Err("missing") } else { Ok(1.0) });
    assert_eq!(missing.len(), 3);
    assert!(missing[0].why.contains("no `x.value`"), "{missing:?}");
    assert_eq!(found.fragilities[0].left_out, [("without the measure".to_owned(), 3)]);
}

#[test]
fn rising_levels_end_where_the_limit_is_and_are_interpolated() {
    let text = STUDY
        .replace(
            "levels = [\"0.1 g\", \"0.2 g\", \"0.3 g\", \"0.4 g\"]",
            "ida = { first = \"0.1 g\", step = \"0.1 g\", most = 4, until = \"m\", above = 0.5 }",
        )
        .replace("above = [0.5, 10.0]", "above = 0.5");
    // Measures of 0.2, 0.4, 0.6 cross 0.5 at 0.25 g; of 0.4, 0.8 at 0.125 g; of the third never.
    let result = |record: usize, level: usize| match record {
        0 => Ok(0.2 * (level + 1) as f64),
        1 => Ok(0.4 * (level + 1) as f64),
        _ => Ok(0.1),
    };
    let (found, _) = with(&text, result);
    let status: Vec<RunStatus> = found.runs.iter().map(|r| r.status).collect();
    use RunStatus::{Done, NotNeeded};
    assert_eq!(
        status,
        [Done, Done, Done, NotNeeded, Done, Done, NotNeeded, NotNeeded, Done, Done, Done, Done]
    );
    let fragility = &found.fragilities[0];
    assert_eq!(fragility.method, "truncated");
    let at: Vec<f64> = fragility.shares.iter().map(|s| s.intensity).collect();
    assert!((at[0] - 0.125).abs() < 1e-12 && (at[1] - 0.25).abs() < 1e-12, "{at:?}");
    assert!(fragility.shares.iter().all(|s| s.of == 3) && fragility.fit.is_some());
    // All were run beyond where two go through: plain shares.
    assert!(fragility.shares.iter().all(|s| s.probability.is_none()));
}

/// A median in g beside levels in cm/s² would be read as one of these.
#[test]
fn intensities_are_told_in_the_unit_of_the_levels() {
    let result = |record: usize, level: usize| Ok(if level > record { 1.0 } else { 0.0 });
    let (in_g, _) = with(STUDY, result);
    let text = STUDY.replace(
        "\"0.1 g\", \"0.2 g\", \"0.3 g\", \"0.4 g\"",
        "\"98.0665 cm/s2\", \"196.133 cm/s2\", \"294.1995 cm/s2\", \"392.266 cm/s2\"",
    );
    let (in_cm, _) = with(&text, result);
    let told = |found: &Study| {
        let (curve, column) = (&found.fragilities[0], &found.intensities[0]);
        assert_eq!((&curve.unit, column.unit.as_deref()), (&column.shown, Some("m/s2")));
        assert_eq!(curve.unit_value, column.shown_factor);
        (curve.unit.clone(), curve.fit.as_ref().unwrap().theta, curve.unit_value)
    };
    let ((unit, theta, value), (of_cm, theta_cm, value_cm)) = (told(&in_g), told(&in_cm));
    assert_eq!((unit.as_str(), of_cm.as_str(), value_cm), ("g", "cm/s2", 0.01));
    assert!((theta_cm * value_cm / (theta * value) - 1.0).abs() < 1e-9, "{theta} {theta_cm}");
    // Of what is no acceleration the levels say nothing.
    assert_eq!(in_cm.intensities[1].shown, "m/s");
}

#[test]
fn series_that_were_not_run_so_high_count_up_to_where_they_were() {
    let text = STUDY
        .replace(
            "levels = [\"0.1 g\", \"0.2 g\", \"0.3 g\", \"0.4 g\"]",
            "ida = { first = \"0.1 g\", step = \"0.1 g\", most = 4, until = \"m\", above = 0.5 }",
        )
        .replace("above = [0.5, 10.0]", "above = 0.5");
    // 0.5 is passed at 0.15 and 0.35 g; the third holds at 0.1 and 0.2 g, and is lost above.
    let result = |record: usize, level: usize| match (record, level) {
        (0, level) => Ok(level as f64),
        (1, level) => Ok(0.4 * level as f64 - 0.5),
        (_, 0 | 1) => Ok(0.1),
        _ => Err("missing"),
    };
    let (found, _) = with(&text, result);
    let shares: Vec<(f64, usize, f64)> =
        found.fragilities[0].shares.iter().map(|s| (s.intensity, s.exceeded, s.probability())).collect();
    // 1 - 2/3, then 1 - 2/3 · 0: above 0.2 g one series alone is known, and it goes through.
    assert_eq!(shares.len(), 2, "{shares:?}");
    assert!((shares[0].0 - 0.15).abs() < 1e-12 && (shares[0].2 - 1.0 / 3.0).abs() < 1e-12, "{shares:?}");
    assert!((shares[1].0 - 0.35).abs() < 1e-12 && (shares[1].2 - 1.0).abs() < 1e-12, "{shares:?}");
}

#[test]
fn one_at_a_time_gives_bars_the_widest_first() {
    let text = "title = \"t\"\ncase = \"c\"\n[vary]\na = { values = [1, 2] }\nb = { values = [\"3 m\"] }\n[sample]\nkind = \"one-at-a-time\"\n[measure]\nm = { summary = \"x\" }\n";
    let study = StudyFile::parse(Path::new("study.toml"), text).unwrap();
    let plan = Plan::of(&study, None).unwrap();
    let out = tempfile::tempdir().unwrap();
    let prepared: Vec<Prepared> = plan
        .runs
        .iter()
        .map(|r| Prepared { bare: r.name.clone(), factor: None, intensities: vec![None; 2] })
        .collect();
    for (run, x) in plan.runs.iter().zip([1.0, 1.5, 0.5, 4.0]) {
        let folder = RunFolder::new(out.path(), &run.name);
        fs::create_dir_all(folder.results()).unwrap();
        fs::write(folder.bare(), &run.name).unwrap();
        fs::write(folder.results().join("summary.json"), format!("{{\"status\": \"done\", \"x\": {x}}}"))
            .unwrap();
    }
    let (found, _) = gather(&study, &plan, &prepared, out.path());
    let [tornado] = &found.tornados[..] else { panic!("{found:?}") };
    assert_eq!(tornado.base, 1.0);
    let bars: Vec<(&str, &str, f64, &str, f64)> = tornado
        .bars
        .iter()
        .map(|b| (b.name.as_str(), b.low.0.as_str(), b.low.1, b.high.0.as_str(), b.high.1))
        .collect();
    assert_eq!(bars, [("b", "as it is", 1.0, "3 m", 4.0), ("a", "2", 0.5, "1", 1.5)]);
}

#[test]
fn every_row_that_others_stand_beside_has_bars_of_its_own() {
    let text = "title = \"t\"\ncase = \"c\"\n[[row]]\nname = \"a\"\n[[row]]\nname = \"b\"\nset = { x = 1 }\n[[row]]\nname = \"a2\"\nset = { y = 2 }\nbeside = \"a\"\n\
        [[row]]\nname = \"b2\"\nset = { x = 1, y = 2 }\nbeside = \"b\"\n[measure]\nm = { summary = \"x\" }\n";
    let study = StudyFile::parse(Path::new("study.toml"), text).unwrap();
    let plan = Plan::of(&study, None).unwrap();
    let out = tempfile::tempdir().unwrap();
    let prepared: Vec<Prepared> = plan
        .runs
        .iter()
        .map(|r| Prepared { bare: r.name.clone(), factor: None, intensities: vec![None; 2] })
        .collect();
    for (run, x) in plan.runs.iter().zip([1.0, 10.0, 2.0, 30.0]) {
        let folder = RunFolder::new(out.path(), &run.name);
        fs::create_dir_all(folder.results()).unwrap();
        fs::write(folder.bare(), &run.name).unwrap();
        fs::write(folder.results().join("summary.json"), format!("{{\"status\": \"done\", \"x\": {x}}}"))
            .unwrap();
    }
    let (found, _) = gather(&study, &plan, &prepared, out.path());
    let bars: Vec<(&str, f64, f64)> =
        found.tornados.iter().map(|t| (t.beside.as_str(), t.bars[0].low.1, t.bars[0].high.1)).collect();
    assert_eq!(bars, [("a", 1.0, 2.0), ("b", 10.0, 30.0)]);
}
