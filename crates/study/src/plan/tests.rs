use super::*;
use std::path::Path;

fn study(text: &str) -> StudyFile {
    let text = format!("title = \"t\"\ncase = \"case.toml\"\n{text}");
    StudyFile::parse(Path::new("study.toml"), &text).unwrap_or_else(|e| panic!("{e}"))
}

fn plan(text: &str) -> Plan {
    Plan::of(&study(text), None).unwrap_or_else(|e| panic!("{e:?}"))
}

fn names(plan: &Plan) -> Vec<&str> {
    plan.runs.iter().map(|r| r.name.as_str()).collect()
}

const TWO: &str = "[vary]\n\"initial.lateral\" = { values = [0.5, 1.2] }\n\
                   \"material.c.young\" = { range = { from = \"20 GPa\", to = \"30 GPa\", count = 3 } }\n";

#[test]
fn a_study_of_nothing_is_the_case() {
    assert_eq!(names(&plan("")), ["case"]);
}

#[test]
fn one_at_a_time_begins_with_the_case_as_it_is() {
    let plan = plan(&format!("{TWO}[sample]\nkind = \"one-at-a-time\"\n"));
    assert_eq!(
        names(&plan),
        [
            "as-it-is",
            "initial.lateral=0.5",
            "initial.lateral=1.2",
            "material.c.young=20-gpa",
            "material.c.young=25-gpa",
            "material.c.young=30-gpa"
        ]
    );
    assert_eq!(plan.samples[3].values, [None, Some("\"20 GPa\"".to_owned())]);
    assert_eq!(plan.parameters[1].unit.as_deref(), Some("GPa"));
    assert_eq!(plan.parameters[0].unit.as_deref(), Some(""));
}

#[test]
fn a_grid_has_all_combinations() {
    let plan = plan(&format!("{TWO}[sample]\nkind = \"grid\"\n"));
    assert_eq!(plan.runs.len(), 6);
    let mut values: Vec<_> = plan.samples.iter().map(|s| s.values.clone()).collect();
    values.dedup();
    assert_eq!(values.len(), 6);
}

const RECORDS: &str = "[[record]]\nname = \"A\"\nfile = \"a\"\n[[record]]\nname = \"B\"\nfile = \"b\"\n\
                       [scale]\nmeasure = \"PGA\"\nlevels = [\"0.4 g\", \"0.1 g\"]\n";

#[test]
fn samples_records_and_levels_are_crossed_or_paired() {
    let sampled =
        "[vary]\na = { uniform = [\"1 m\", \"2 m\"] }\n[sample]\nkind = \"latin-hypercube\"\ncount = 3\n";
    let crossed = plan(&format!("{sampled}{RECORDS}"));
    assert_eq!(crossed.runs.len(), 12);
    assert_eq!(names(&crossed)[..3], ["s1_a_0.1-g", "s1_a_0.4-g", "s1_b_0.1-g"]);
    assert_eq!(crossed.chains(), 6);
    let paired = plan(&format!("{sampled}{RECORDS}design = \"paired\"\n"));
    assert_eq!(
        names(&paired),
        ["s1_a_0.1-g", "s1_a_0.4-g", "s2_b_0.1-g", "s2_b_0.4-g", "s3_a_0.1-g", "s3_a_0.4-g"]
    );
}

#[test]
fn shards_are_a_partition_that_keeps_chains_together() {
    let plan = plan(RECORDS);
    for of in 1..6 {
        let mut all: Vec<usize> = (0..of).flat_map(|k| plan.shard(k, of)).collect();
        all.sort_unstable();
        assert_eq!(all, (0..plan.runs.len()).collect::<Vec<_>>());
    }
    let first = plan.shard(0, 2);
    assert!(first.iter().all(|run| plan.runs[*run].record == Some(0)));
}

#[test]
fn the_plan_is_a_function_of_file_and_seed() {
    let text = |seed: u32| {
        format!(
            "[vary]\na = {{ normal = {{ mean = 1.0, sd = 0.1 }} }}\nb = {{ lognormal = {{ median = \"2 MPa\", beta = 0.3 }} }}\n\
             [sample]\nkind = \"latin-hypercube\"\ncount = 4\nseed = {seed}\n"
        )
    };
    assert_eq!(plan(&text(7)), plan(&text(7)));
    assert_ne!(plan(&text(7)).samples, plan(&text(8)).samples);
    // Kept, so that no version draws others.
    let values: Vec<_> = plan(&text(7))
        .samples
        .iter()
        .map(|s| s.values.iter().flatten().cloned().collect::<Vec<_>>())
        .collect();
    let kept = [
        ["1.15289", "\"2.07339 MPa\""],
        ["0.994264", "\"2.5915 MPa\""],
        ["1.03771", "\"1.45421 MPa\""],
        ["0.902063", "\"1.72741 MPa\""],
    ];
    assert_eq!(values, kept);
}

#[test]
fn rising_levels_are_numbered_on() {
    let plan = plan(
        "[measure]\nm = { summary = \"a\" }\n[scale]\nmeasure = \"PGV\"\nida = { first = \"0.1 m/s\", step = \"0.1 m/s\", most = 3, until = \"m\", above = 1.0 }\n",
    );
    assert!(plan.rises);
    assert_eq!(names(&plan), ["0.1-m-s", "0.2-m-s", "0.3-m-s"]);
    assert_eq!(plan.levels[2].value, 0.3);
}

#[test]
fn rows_have_their_names_and_what_they_stand_beside() {
    let plan = plan(
        "[[row]]\nname = \"as it is\"\n[[row]]\nname = \"interface μ 0.5\"\nbeside = \"as it is\"\nset = { \"interface[a].friction_coefficient\" = 0.5 }\n",
    );
    assert_eq!(names(&plan), ["as-it-is", "interface-mu-0.5"]);
    assert_eq!(plan.samples[1].beside, Some(0));
    assert_eq!(plan.samples[0].values, [None]);
}

#[test]
fn what_cannot_be_planned_is_told_at_its_place() {
    for (text, says) in [
        ("[scale]\nmeasure = \"PGX\"\nlevels = [\"1 g\"]\n", "no measure of intensity"),
        ("[scale]\nmeasure = \"PGA\"\nlevels = [\"1 m/s\"]\n", "level"),
        ("[scale]\nmeasure = \"PGA\"\nlevels = [\"0.3\"]\n", "level"),
        ("[scale]\nmeasure = \"PGA\"\nlevels = [\"-1 g\"]\n", "above 0"),
        ("[scale]\nmeasure = \"PGA\"\nlevels = [\"1 g\", \"1.0 g\"]\n", "equal"),
        (
            "[vary]\na = { normal = { mean = 1, sd = 0.1, min = 5 } }\n[sample]\nkind = \"sobol\"\ncount = 4\n",
            "nearly nothing",
        ),
        (
            "[vary]\na = { uniform = [0, 1] }\nb = { uniform = [0, 1] }\n[sample]\nkind = \"latin-hypercube\"\ncount = 4\n\
             [[correlation]]\nbetween = [\"a\", \"b\"]\nrank = 1.0\n",
            "between −1 and 1",
        ),
        ("[[row]]\nname = \"a b\"\n[[row]]\nname = \"a-b\"\n", "two runs would be called"),
    ] {
        let problems = Plan::of(&study(text), None).expect_err(text);
        assert!(problems.iter().any(|p| p.message.contains(says)), "{text}: {problems:?}");
    }
}

#[test]
fn a_table_gives_its_rows_by_their_names() {
    let study = study("[sample]\nkind = \"table\"\nfile = \"rows.csv\"\n");
    let plan = Plan::of(&study, Some("name,initial.lateral\nLow K0,0.5\n,1.2\n")).unwrap();
    assert_eq!(names(&plan), ["low-k0", "s2"]);
    assert_eq!(plan.samples[0].title, "Low K0");
    let problems = Plan::of(&study, Some("")).unwrap_err();
    assert!(problems[0].message.contains("rows.csv: line 1"), "{problems:?}");
}
