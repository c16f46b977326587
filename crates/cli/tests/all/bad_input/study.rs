//! Slips in a study.

use super::{Row, refusals_of, row};
use tremolite_case::study::StudyFile;
use tremolite_study::Plan;

const SOUND: &str = include_str!("../../../../../fuzz/corpus/study/every.toml");

#[rustfmt::skip]
const ROWS: &[Row] = &[
    row("title = \"what matters\"\n", "", 1, "`title` is missing", "add title = \"…\" (what the study asks)"),
    row("title = \"what matters\"", "title = \"a\\u001bb\"", 1, "`title` has a control character in it", "leave out tabs"),
    row("uniform = [0.5, 1.2]", "uniform = [1.2, 0.5]", 8, "`uniform`: its end is not above its beginning", "write [least, largest]"),
    row("beta = 0.25", "beta = -0.25", 9, "`median` and `beta` must be above 0", "write { median = \"1.2 MPa\", beta = 0.25 }"),
    row("count = 3", "count = 0", 12, "`range`: `count` is a whole number from 2", "write count = 5"),
    row("\"initial.lateral\" = { uniform", "\"initial.lateral[\" = { uniform", 8, "a bracket is not closed", "\"stage[0].release\""),
    row("rank = 0.3", "rank = 1.3", 16, "a rank correlation lies between −1 and 1, and between two keys", "write rank = 0.3, say"),
    row("between = [\"initial.lateral\", \"stage[*].release\"]", "between = [\"initial.lateral\", \"initial.lateral\"]", 16, "between two keys", "write rank = 0.3, say"),
    row("kind = \"latin-hypercube\"", "kind = \"latin\"", 18, "`kind` cannot be \"latin\"", "\"latin-hypercube\", \"sobol\""),
    row("count = 10", "count = 1e9", 19, "`count` should be a whole number from 1 to 20000", "write count ="),
    row("name = \"b\"", "name = \"a\"", 28, "two records have this name", "give each a name of its own"),
    row("name = \"b\"", "name = \"b/../c\"", 28, "`name` cannot be used as a name", "none of . , [ ] * ?"),
    row("name = \"b\"", "name = \"=b\"", 28, "`name` cannot be used as a name", "begin with another character"),
    row("measure = \"RotD50 Sa(0.5 s, 2 %)\"", "measure = \"RotD50 Sa(0.5)\"", 31, "the period in `RotD50 Sa(0.5)` has no unit", "Sa(0.5 s, 5 %)"),
    row("measure = \"RotD50 Sa(0.5 s, 2 %)\"", "measure = \"PGE\"", 31, "`PGE` is no measure of intensity", "write PGA, PGV"),
    row("levels = [\"0.1 g\", \"0.2 g\"]", "levels = [\"0.2 g\", \"0.1 m\"]", 32, "is a length (`m`), an acceleration is expected", "9.81 m/s2"),
    row("levels = [\"0.1 g\", \"0.2 g\"]", "levels = []", 32, "not a list of 0", "write levels = [\"…\"]"),
    row("levels = [\"0.1 g\", \"0.2 g\"]", "levels = [\"0.1 g\", \"0.1 g\"]", 32, "two levels are equal", "keep one of the two"),
    row("take = \"max-abs\"", "take = \"maximum\"", 37, "`take` cannot be \"maximum\"", "\"max-abs\", \"max\""),
    row("table = \"monitors.csv\"", "table = \"../monitors.csv\"", 37, "`../monitors.csv` does not lie in the results of a run", "\"monitors.csv\""),
    row("table = \"monitors.csv\"", "table = \"/etc/passwd\"", 37, "does not lie in the results of a run", "\"monitors.csv\""),
    row("measure = \"cracked\"\nby", "measure = \"craked\"\nby", 40, "there is no measure `craked`", "did you mean `cracked`?"),
    row("above = [0.1, 0.2]", "above = []", 42, "not a list of 0", "write above = […]"),
    row("above = [0.1, 0.2]", "above = [0.2, 0.1]", 39, "limits that do not rise", "the least first"),
    row("failed = \"exceeds\"\n", "", 39, "`failed` is missing", "\"exceeds\" | \"left-out\""),
    row("at_once = 2", "at_once = 0", 45, "a whole number from 1 to 4096, not 0", "write at_once ="),
    row("keep = \"tables\"", "keep = \"nothing\"", 47, "`keep` cannot be \"nothing\"", "\"all\", \"tables\""),
];

#[test]
fn each_slip_in_a_study_is_told_with_its_line_and_a_way_out() {
    refusals_of("study.toml", SOUND, ROWS, |path, text| {
        let shown = |report: tremolite_case::Report| report.render(false);
        let study = StudyFile::parse(path, text).map_err(shown)?;
        Plan::of(&study, None).map(drop).map_err(|problems| shown(study.report(problems)))
    });
}
