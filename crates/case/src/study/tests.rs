use super::*;

const GOOD: &str = r#"
title = "what matters"
case = "case.toml"
[set]
"output.snapshots" = "10 s"
[vary]
"initial.lateral" = { uniform = [0.5, 1.2] }
"material.concrete.tensile_strength" = { lognormal = { median = "1.2 MPa", beta = 0.25, max = "2 MPa" } }
"stage[*].release" = { normal = { mean = 0.6, sd = 0.1, min = 0.2 } }
"mesh.near" = { range = { from = "1 m", to = "2 m", count = 3 } }
[[correlation]]
between = ["initial.lateral", "stage[*].release"]
rank = 0.3
[sample]
kind = "latin-hypercube"
count = 10
[[record]]
name = "a"
east = { file = "a.txt", units = "cm/s2" }
[scale]
measure = "PGA"
levels = ["0.1 g", "0.2 g"]
[measure]
cracked = { summary = 'damage."x.lining".volume', over = "model.volume" }
drift = { table = "monitors.csv", column = "A-B.u", take = "max-abs" }
[[fragility]]
measure = "cracked"
above = [0.1, 0.2]
failed = "exceeds"
"#;

fn parse(source: &str) -> Result<StudyFile, Report> {
    StudyFile::parse(Path::new("study.toml"), source)
}

#[test]
fn a_study_is_read_with_its_units() {
    let study = parse(GOOD).unwrap_or_else(|e| panic!("{e}"));
    assert_eq!(study.vary.len(), 4);
    assert_eq!(
        study.vary[3].how,
        Variation::Values(vec!["\"1 m\"".into(), "\"1.5 m\"".into(), "\"2 m\"".into()])
    );
    let Variation::Distributed(Distribution::Lognormal { median, within, unit, .. }) = &study.vary[1].how
    else {
        panic!("{:?}", study.vary[1])
    };
    assert_eq!((*median, within.max, unit.as_str()), (1.2, 2.0, "MPa"));
    let motion = study.records[0].motion(|file| Path::new("../records").join(file));
    assert_eq!(
        motion,
        [("east".to_owned(), "{ file = \"../records/a.txt\", units = \"cm/s2\" }".to_owned())]
    );
    assert_eq!(study.fragilities[0].above, [0.1, 0.2]);
    assert_eq!(study.set[0].value, "\"10 s\"");
}

#[test]
fn what_is_wrong_is_told_at_its_line_with_a_way_out() {
    for (from, to, says) in [
        ("title =", "tittle =", "did you mean `title`?"),
        ("uniform = [0.5, 1.2]", "unifrom = [0.5, 1.2]", "did you mean `uniform`?"),
        ("uniform = [0.5, 1.2]", "uniform = [1.2, 0.5]", "write [least, largest]"),
        ("uniform = [0.5, 1.2]", "uniform = [0.5, \"1.2 MPa\"]", "different units"),
        ("beta = 0.25, max = \"2 MPa\"", "beta = 0.25, max = \"2 GPa\"", "in another unit"),
        ("\"stage[*].release\" =", "\"stage[*.release\" =", "not closed"),
        ("sd = 0.1", "sd = 0", "`sd` must be above 0"),
        ("count = 3", "count = 1", "whole number from 2"),
        (
            "between = [\"initial.lateral\"",
            "between = [\"initial.latral\"",
            "did you mean `initial.lateral`?",
        ),
        (
            "kind = \"latin-hypercube\"\ncount = 10",
            "kind = \"sobol\"\ncount = 8",
            "a correlation has no meaning",
        ),
        ("count = 10", "", "`count` is missing beside"),
        ("levels = [\"0.1 g\", \"0.2 g\"]", "target = \"x\"", "levels"),
        ("measure = \"cracked\"", "measure = \"craked\"", "did you mean `cracked`?"),
        ("above = [0.1, 0.2]", "above = [0.2, 0.1]", "the least first"),
        ("failed = \"exceeds\"", "", "`failed` is missing"),
        ("east = {", "west = {", "`west` is no key"),
        ("take = \"max-abs\"", "", "`take` is missing"),
    ] {
        assert!(GOOD.contains(from), "{from}");
        let text = parse(&GOOD.replacen(from, to, 1)).expect_err(to).to_string();
        assert!(text.contains(says) && text.contains("study.toml:"), "{to}: {text}");
    }
}

#[test]
fn nothing_that_is_cut_short_or_turned_round_makes_it_panic() {
    for end in (0..GOOD.len()).filter(|end| GOOD.is_char_boundary(*end)) {
        let _ = parse(&GOOD[..end]);
    }
    for (from, to) in
        [("{", "["), ("[", "{"), ("\"", "'"), ("=", "= ="), ("0.", "nan"), ("1", "1e999"), ("[[", "[")]
    {
        let _ = parse(&GOOD.replace(from, to));
    }
}

#[test]
fn every_default_is_a_good_value() {
    let study = parse("title = \"a\"\ncase = \"b\"\n").unwrap_or_else(|e| panic!("{e}"));
    assert!(study.run.share && study.run.keep == Keep::All);
}
