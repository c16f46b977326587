//! `tremolite study` as a user meets it: the same plan and table however it is run, stopped and shared.

use std::fs;
use std::path::Path;
use std::process::{Command, Output};
use std::time::Duration;
use tremolite_results::Table;

/// A column under its weight, with a stage, so that there is a hand-over.
const CASE: &str = r#"title = "a column"
[mesh.box]
group = "rock"
x = { from = 0, to = "4 m", elements = 2 }
y = { from = 0, to = "4 m", elements = 2 }
z = { from = "-40 m", to = 0, elements = 10 }
[material.rock]
law = "elastic"
young = "2 GPa"
poisson = 0.25
density = "2500 kg/m3"
[[region]]
groups = ["rock"]
material = "rock"
element = "reduced-integration"
[initial]
lateral = 0.6
[motion]
kind = "incident"
east = { file = "pulse.txt" }
[dynamic]
base = "viscous"
sides = "periodic"
duration = "0.6 s"
[[monitor]]
name = "top"
at = ["1 m", "1 m", "-1 m"]
[output]
histories = "0.01 s"
snapshots = "1 s"
[report.limits]
displacement = "10 mm"
"#;

const STUDY: &str = r#"title = "what moves the column"
case = "case.toml"
[vary]
"initial.lateral" = { uniform = [0.4, 1.0] }
[sample]
kind = "latin-hypercube"
count = 2
seed = 7
[[record]]
name = "east"
east = { file = "pulse.txt" }
[[record]]
name = "north"
north = { file = "pulse.txt" }
[scale]
measure = "RotD50 PGV"
levels = ["0.02 m/s", "0.04 m/s"]
[measure]
top = { table = "monitors.csv", column = "top.ux", take = "max-abs" }
[[fragility]]
measure = "top"
above = 0.001
failed = "exceeds"
"#;

/// A folder with the case, its pulse and a study.
fn folder(study: &str) -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    let pulse = |k: u32| {
        let t = 0.01 * f64::from(k) - 0.15;
        format!("{:.2} {:.6}\n", 0.01 * f64::from(k), 100.0 * t * (-200.0 * t * t).exp())
    };
    let samples: String = (0..31).map(pulse).collect();
    fs::write(folder.path().join("pulse.txt"), format!("# units = \"cm/s2\"\n{samples}")).unwrap();
    fs::write(folder.path().join("case.toml"), CASE).unwrap();
    fs::write(folder.path().join("study.toml"), study).unwrap();
    folder
}

fn command(folder: &Path, args: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_tremolite"));
    command.current_dir(folder).args(["study", "study.toml", "--threads", "1"]).args(args);
    command
}

fn study(folder: &Path, args: &[&str]) -> Output {
    command(folder, args).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

fn bytes(folder: &Path, file: &str) -> Vec<u8> {
    fs::read(folder.join(file)).unwrap_or_else(|e| panic!("{file}: {e}"))
}

#[test]
fn the_table_is_the_same_at_once_in_shards_unshared_and_killed() {
    let folder = folder(STUDY);
    let folder = folder.path();
    let done = study(folder, &["--out", "one", "--jobs", "1"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let table = String::from_utf8(bytes(folder, "one/study.csv")).unwrap();
    assert_eq!(table.lines().filter(|line| line.contains(",done,")).count(), 8, "{table}");
    assert!(table.starts_with("run,sample,record,level,factor,initial.lateral,RotD50 PGV [m/s]"), "{table}");
    let page = String::from_utf8(bytes(folder, "one/study.html")).unwrap();
    assert!(page.contains("8 at their end") && page.contains("fragility-1-top.svg"), "{page}");
    // Each run leads to its page, and tells whether the case's limit is met: as the measure of the same monitor is.
    assert_eq!(page.matches("<a href=\"runs&#x2f;").count(), 8, "{page}");
    assert!(folder.join("one/runs/s1_north_0.04-m-s/results/report.html").exists());
    let cells = |name: &str| -> Vec<String> {
        let rows = table.lines().map(|line| line.split(',').map(str::to_owned).collect::<Vec<String>>());
        let rows: Vec<Vec<String>> = rows.collect();
        let at = rows[0].iter().position(|h| h == name).unwrap_or_else(|| panic!("{name}: {table}"));
        rows[1..].iter().map(|row| row[at].clone()).collect()
    };
    let found = cells("limits.displacement [m]").into_iter().map(|cell| cell.parse::<f64>().unwrap());
    let held: Vec<(f64, bool)> =
        found.zip(cells("limits.displacement.met").iter().map(|met| met == "true")).collect();
    assert!(held.iter().all(|(found, met)| (*found <= 1e-2) == *met), "{held:?}");
    assert!(held.iter().any(|(_, met)| *met) && held.iter().any(|(_, met)| !met), "{held:?}");
    let same = |out: &str| {
        for file in ["study.csv", "study.json", "plan.csv", "study.html"] {
            assert!(
                bytes(folder, &format!("{out}/{file}")) == bytes(folder, &format!("one/{file}")),
                "{out}: {file}"
            );
        }
    };

    // What is done is not run again.
    let again = study(folder, &["--out", "one"]);
    assert!(!said(&again).contains('…') && said(&again).contains("8 at their end"), "{}", said(&again));

    // Several at once; two shares that know nothing of one another, put together.
    let done = study(folder, &["--out", "three", "--jobs", "3"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    same("three");
    for share in ["2/2", "1/2"] {
        let done = study(folder, &["--out", "shards", "--shard", share]);
        assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    }
    same("shards");

    // Without a shared hand-over every byte of the tables of a run is the same.
    let shared = fs::read_to_string(folder.join("one/runs/s1_north_0.04-m-s/results/log.txt")).unwrap();
    assert!(shared.contains("--start-from"), "{shared}");
    fs::write(folder.join("study.toml"), format!("{STUDY}[run]\nshare = false\n")).unwrap();
    let done = study(folder, &["--out", "unshared"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    for run in ["s1_north_0.04-m-s", "s2_east_0.02-m-s", "s2_north_0.04-m-s"] {
        for file in ["monitors.csv", "stages.csv", "energy.csv", "spectra.csv", "free_field.csv"] {
            let of = |out: &str| bytes(folder, &format!("{out}/runs/{run}/results/{file}"));
            assert!(of("one") == of("unshared"), "{run}/{file}");
        }
    }
    assert!(bytes(folder, "unshared/study.csv") == bytes(folder, "one/study.csv"));
    fs::write(folder.join("study.toml"), STUDY).unwrap();

    // Killed again and again, with its runs left alone in the middle of their work.
    for moment in [30, 70, 150, 110, 260, 40, 190] {
        let mut child = command(folder, &["--out", "killed", "--jobs", "2"]).spawn().unwrap();
        std::thread::sleep(Duration::from_millis(moment));
        child.kill().unwrap();
        child.wait().unwrap();
    }
    let done = study(folder, &["--out", "killed", "--jobs", "2"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    same("killed");

    // Killed between a summary and its page; and while another, who holds the folder, still writes that page.
    let page = folder.join("killed/runs/s1_east_0.02-m-s/results/report.html");
    let lost = fs::read(&page).unwrap();
    fs::remove_file(&page).unwrap();
    let done = study(folder, &["--out", "killed"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    same("killed");
    assert!(fs::read(&page).unwrap() == lost);
    let held =
        fs::File::options().append(true).open(folder.join("killed/runs/s1_east_0.02-m-s/lock")).unwrap();
    held.lock().unwrap();
    let mut waits = command(folder, &["--out", "killed"]).spawn().unwrap();
    std::thread::sleep(Duration::from_millis(1500));
    assert!(waits.try_wait().unwrap().is_none(), "it does not wait for who holds a folder");
    drop(held);
    assert_eq!(waits.wait().unwrap().code(), Some(0));
    same("killed");
}

#[test]
fn wrong_keys_are_refused_before_the_first_run() {
    for (from, to, says) in [
        ("\"initial.lateral\"", "\"initial.latral\"", "did you mean `lateral`?"),
        ("uniform = [0.4, 1.0]", "uniform = [-4.0, -1.0]", "`lateral`"),
        ("north = { file = \"pulse.txt\" }", "north = { file = \"puls.txt\" }", "there is no file puls.txt"),
        ("case = \"case.toml\"", "case = \"cas.toml\"", "there is no file cas.toml"),
        ("0.04 m/s", "40 m/s", "more than any earthquake"),
        ("measure = \"RotD50 PGV\"", "measure = \"z PGV\"", "no factor brings it to a level"),
        ("[scale]", "[scales]", "did you mean `scale`?"),
        (
            "[vary]\n",
            "[set]\n\"motion.east.units\" = \"g\"\n[vary]\n",
            "`motion.east.units`: no effect, since each [[record]] brings its own",
        ),
        ("\"top.ux\"", "\"tip.ux\"", "write `top.ux`"),
        ("\"monitors.csv\"", "\"monitor.csv\"", "write `monitors.csv`"),
        (
            "{ table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }",
            "{ summary = 'monitors.top.ux.maxx' }",
            "write `monitors.top.ux.max`",
        ),
        (
            "{ table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }",
            "{ summary = 'monitors.tip.ux.max' }",
            "write `monitors.top.ux.max`",
        ),
    ] {
        assert!(STUDY.contains(from), "{from}");
        let folder = folder(&STUDY.replace(from, to));
        let refused = study(folder.path(), &["--out", "out"]);
        assert_eq!(refused.status.code(), Some(2), "{to}: {}", said(&refused));
        assert!(
            said(&refused).contains(says) && said(&refused).contains("study.toml:"),
            "{to}: {}",
            said(&refused)
        );
        assert!(!folder.path().join("out").exists(), "{to}");
    }
    let folder = folder(STUDY);
    for (args, says) in
        [(&["--shard", "3/2"][..], "write K/N"), (&["--only", "nothing"], "--list names them")]
    {
        let refused = study(folder.path(), args);
        assert_eq!(refused.status.code(), Some(2));
        assert!(said(&refused).contains(says), "{}", said(&refused));
    }
}

#[test]
fn a_run_that_fails_stays_with_its_reason_until_it_is_asked_for_again() {
    // Stress that does not bear the weight, and no time to come to rest.
    let text = "title = \"t\"\ncase = \"case.toml\"\n[[row]]\nname = \"as it is\"\n\
                [[row]]\nname = \"no rest\"\nbeside = \"as it is\"\nset = { \"initial\" = { stress = { zz = \"-1 MPa\" }, max_cycles = 2, release_cycles = 1 } }\n\
                [measure]\ntop = { table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }\n";
    let folder = folder(text);
    let folder = folder.path();
    let done = study(folder, &["--out", "out"]);
    assert_eq!(done.status.code(), Some(1), "{}", said(&done));
    assert!(said(&done).contains("1 at their end, 1 not at rest before it"), "{}", said(&done));
    let table = String::from_utf8(bytes(folder, "out/study.csv")).unwrap();
    assert!(table.contains("not_converged,") && table.contains("did not come to rest"), "{table}");
    let again = study(folder, &["--out", "out"]);
    assert!(!said(&again).contains('…'), "{}", said(&again));
    let again = study(folder, &["--out", "out", "--retry", "not-converged"]);
    assert!(said(&again).contains("no-rest …") && !said(&again).contains("as-it-is …"), "{}", said(&again));
    // What the file calls otherwise now is another run; what was computed is set aside.
    fs::write(
        folder.join("study.toml"),
        text.replace(
            "\"initial\" = { stress = { zz = \"-1 MPa\" }, max_cycles = 2, release_cycles = 1 }",
            "\"initial.lateral\" = 0.9",
        ),
    )
    .unwrap();
    let done = study(folder, &["--out", "out"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    assert!(folder.join("out/runs/no-rest.old/results/summary.json").exists());
    // A measure that the results do not have is told at its line.
    fs::write(folder.join("study.toml"), text.replace("top.ux", "top.vw")).unwrap();
    let done = study(folder, &["--out", "wrong"]);
    assert_eq!(done.status.code(), Some(2), "{}", said(&done));
    assert!(said(&done).contains("study.toml:10") && said(&done).contains("top.vx"), "{}", said(&done));
}

#[test]
fn rising_levels_stop_where_the_limit_is() {
    let text = STUDY
        .replace(
            "levels = [\"0.02 m/s\", \"0.04 m/s\"]",
            "ida = { first = \"0.02 m/s\", step = \"0.02 m/s\", most = 5, until = \"top\", above = 0.02 }",
        )
        .replace("count = 2", "count = 1")
        .replace(
            "[[fragility]]\nmeasure = \"top\"\nabove = 0.001",
            "[[fragility]]\nmeasure = \"top\"\nabove = 0.02",
        );
    let folder = folder(&text);
    let folder = folder.path();
    let done = study(folder, &["--out", "out", "--jobs", "2"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let table = String::from_utf8(bytes(folder, "out/study.csv")).unwrap();
    let count = |word: &str| table.lines().filter(|line| line.contains(&format!(",{word},"))).count();
    assert!(count("not-needed") > 0 && count("done") + count("not-needed") == 10, "{table}");
    // Across the column the other record moves nothing along x, and goes up to the end.
    assert_eq!(table.lines().filter(|l| l.contains("_north_") && l.contains(",done,")).count(), 5, "{table}");
}

#[test]
fn array_tasks_of_slurm_take_the_commands_of_shares() {
    let folder = folder(STUDY);
    let place = "100% array";
    let done = study(folder.path(), &["--out", "out", "--slurm", place, "--tasks", "3", "--jobs", "2"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let script = String::from_utf8(bytes(folder.path(), &format!("{place}/study.sbatch"))).unwrap();
    for line in [
        "#SBATCH --array=1-3",
        "#SBATCH --cpus-per-task=2",
        "/100%% array/%a.log\"",
        "--shard \"$SLURM_ARRAY_TASK_ID/3\" --jobs 2 --threads 1",
    ] {
        assert!(script.contains(line), "{script}");
    }
    assert!(said(&done).contains("--gather") && !folder.path().join("out").exists(), "{}", said(&done));
    let checked = Command::new("bash")
        .args(["-n", &format!("{place}/study.sbatch")])
        .current_dir(folder.path())
        .status();
    assert!(checked.is_ok_and(|status| status.success()));
}

#[test]
fn the_shipped_study_has_five_motions_at_five_levels() {
    let cases = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../cases/first-shake");
    let mut listing = Command::new(env!("CARGO_BIN_EXE_tremolite"));
    let listed = listing.current_dir(cases).args(["study", "fragility.toml", "--list"]).output().unwrap();
    assert_eq!(listed.status.code(), Some(0), "{}", said(&listed));
    let table = String::from_utf8(listed.stdout).unwrap();
    assert_eq!(table.lines().count(), 26, "{table}");
    // The intensity of each run is its level, to the digits that its factor is told with.
    for line in table.lines().skip(1) {
        let cells: Vec<&str> = line.split(',').collect();
        let level: f64 = cells[3].trim_end_matches(" m/s").parse().unwrap();
        let found: f64 = cells[5].parse().unwrap();
        assert!((found / level - 1.0).abs() < 1e-8, "{line}");
    }
}

/// A grid of one key: bare numbers of a study are refused, unless it says that they are in SI.
#[test]
fn numbers_without_a_unit_are_those_of_a_study_in_si_alone() {
    let grid = "title = \"grid\"\ncase = \"case.toml\"\n[sample]\nkind = \"grid\"\n[vary]\n\"material.rock.young\" = { values = [2e9, 4e9] }\n\
                [measure]\ntop = { table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }\n";
    let folder = folder(grid);
    let refused = study(folder.path(), &["--out", "grid", "--list"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(
        said(&refused).contains("write \"2 GPa\"") && said(&refused).contains("study.toml:6"),
        "{}",
        said(&refused)
    );
    fs::write(folder.path().join("study.toml"), format!("units = \"SI\"\n{grid}")).unwrap();
    let done = study(folder.path(), &["--out", "grid", "--jobs", "2"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let table = String::from_utf8(bytes(folder.path(), "grid/study.csv")).unwrap();
    assert_eq!(table.lines().filter(|line| line.contains(",done,")).count(), 2, "{table}");
}

#[test]
fn a_record_that_has_changed_is_another_run_and_a_measure_that_is_lacking_stops_every_start() {
    let grid = "title = \"grid\"\ncase = \"case.toml\"\n[sample]\nkind = \"grid\"\n[vary]\n\"initial.lateral\" = { values = [0.6] }\n\
                [measure]\ntop = { table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }\n";
    let folder = folder(grid);
    let folder = folder.path();
    let top = || {
        let done = study(folder, &["--out", "grid"]);
        assert_eq!(done.status.code(), Some(0), "{}", said(&done));
        let table = String::from_utf8(bytes(folder, "grid/study.csv")).unwrap();
        let names: Vec<&str> = table.lines().next().unwrap().split(',').collect();
        let column =
            names.iter().position(|name| name.starts_with("top")).unwrap_or_else(|| panic!("{table}"));
        table.lines().nth(1).unwrap().split(',').nth(column).unwrap().parse::<f64>().unwrap()
    };
    let before = top();
    let text = fs::read_to_string(folder.join("pulse.txt")).unwrap();
    let (head, samples) = text.split_once('\n').unwrap();
    let doubled = |line: &str| {
        let (t, x) = line.split_once(' ').unwrap();
        format!("{t} {}\n", 2.0 * x.parse::<f64>().unwrap())
    };
    let twice: String = samples.lines().map(doubled).collect();
    fs::write(folder.join("pulse.txt"), format!("{head}\n{twice}")).unwrap();
    assert!((top() / before - 2.0).abs() < 1e-6);

    // A quantity that no monitor has; that is known with the first results.
    let lacks = grid.replace("top.ux", "top.uxx");
    fs::write(folder.join("study.toml"), lacks).unwrap();
    for _ in 0..2 {
        let refused = study(folder, &["--out", "grid"]);
        assert_eq!(refused.status.code(), Some(2), "{}", said(&refused));
        assert!(
            said(&refused).contains("have no `top`") && said(&refused).contains("study.toml:"),
            "{}",
            said(&refused)
        );
    }
}

/// What the runs of a study shook from, by the names of the runs.
fn hand_overs(out: &Path) -> Vec<String> {
    let runs = fs::read_dir(out.join("runs")).unwrap().map(|entry| entry.unwrap());
    let has = runs.filter(|run| run.path().join("results/checkpoint/hand-over.bin").is_file());
    has.map(|run| run.file_name().to_string_lossy().into_owned()).collect()
}

/// The one that goes through the stages for all is killed as the ground shakes, before its first checkpoint: it goes on from where its stages
/// ended, and so do the others. (It went through them again.)
#[test]
fn a_leader_that_was_killed_does_not_go_through_its_stages_again() {
    let folder = folder(STUDY);
    let folder = folder.path();
    let done = study(folder, &["--out", "out", "--jobs", "1"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let table = bytes(folder, "out/study.csv");
    let results = folder.join("out/runs/s1_east_0.02-m-s/results");
    let log = fs::read_to_string(results.join("log.txt")).unwrap();
    assert!(!log.contains("--start-from"), "{log}");
    let kept = |name: &str| fs::read(results.join(name)).unwrap();
    let (stages, monitors) = (kept("stages.csv"), kept("monitors.csv"));
    // As a run that goes on leaves it.
    ["summary.json", "SHA256SUMS"].iter().for_each(|name| fs::remove_file(results.join(name)).unwrap());
    fs::write(results.join("monitors.csv"), &monitors[..monitors.len() / 2]).unwrap();
    fs::remove_dir_all(folder.join("out/runs/s1_north_0.02-m-s")).unwrap();
    let began = results.join("checkpoint/hand-over.bin");
    let when = fs::metadata(&began).unwrap().modified().unwrap();

    let again = study(folder, &["--out", "out", "--jobs", "2"]);
    assert_eq!(again.status.code(), Some(0), "{}", said(&again));
    assert_eq!(
        fs::metadata(&began).unwrap().modified().unwrap(),
        when,
        "its stages are not gone through again"
    );
    assert!(fs::read_to_string(results.join("log.txt")).unwrap().contains("--resume"));
    assert!(kept("stages.csv") == stages && kept("monitors.csv") == monitors);
    assert!(bytes(folder, "out/study.csv") == table);
    let other = folder.join("out/runs/s1_north_0.02-m-s/results/log.txt");
    assert!(fs::read_to_string(other).unwrap().contains("--start-from"));

    // Of another version they cannot be gone on from: it begins anew.
    fs::write(&began, "of another version").unwrap();
    ["summary.json", "SHA256SUMS"].iter().for_each(|name| fs::remove_file(results.join(name)).unwrap());
    let again = study(folder, &["--out", "out"]);
    assert_eq!(again.status.code(), Some(0), "{}", said(&again));
    assert!(kept("monitors.csv") == monitors && bytes(folder, "out/study.csv") == table);
}

#[test]
fn hand_overs_stay_while_a_run_may_want_them_and_go_once_none_does() {
    let text = STUDY.replace("count = 2", "count = 1") + "[run]\nkeep = \"tables\"\n";
    let folder = folder(&text);
    let folder = folder.path();
    let out = folder.join("out");
    let some = study(folder, &["--out", "out", "--only", "east"]);
    assert!(said(&some).contains("of 2 runs 2 at their end"), "{}", said(&some));
    assert_eq!(hand_overs(&out).len(), 2, "runs are left that may want them");
    let all = study(folder, &["--out", "out"]);
    assert_eq!(all.status.code(), Some(0), "{}", said(&all));
    assert_eq!(hand_overs(&out), Vec::<String>::new());

    // Killed between the end of a run and what is not kept of it: the next start sees to it, or who gathers.
    for args in [&["--out", "out"][..], &["--out", "out", "--gather"]] {
        let results = out.join("runs/s1_north_0.04-m-s/results");
        fs::create_dir_all(results.join("fields")).unwrap();
        fs::create_dir_all(results.join("checkpoint")).unwrap();
        fs::write(results.join("checkpoint/hand-over.bin"), "").unwrap();
        let again = study(folder, args);
        assert_eq!(again.status.code(), Some(0), "{}", said(&again));
        assert!(!results.join("fields").exists() && hand_overs(&out).is_empty(), "{args:?}");
    }

    // Levels that are not needed want none.
    let rising = text
        .replace(
            "levels = [\"0.02 m/s\", \"0.04 m/s\"]",
            "ida = { first = \"0.02 m/s\", step = \"0.02 m/s\", most = 5, until = \"top\", above = 0.02 }",
        )
        .replace("above = 0.001", "above = 0.02");
    fs::write(folder.join("study.toml"), rising).unwrap();
    let done = study(folder, &["--out", "rising"]);
    assert!(said(&done).contains("not needed"), "{}", said(&done));
    assert_eq!(hand_overs(&folder.join("rising")), Vec::<String>::new());

    // One that the guard stopped, or that came to no rest, may be the last.
    let rows = "title = \"t\"\ncase = \"case.toml\"\n[[row]]\nname = \"rest\"\n[[row]]\nname = \"none\"\n\
                set = { \"initial.max_cycles\" = 2, \"initial.release_cycles\" = 1 }\n\
                [measure]\ntop = { table = \"monitors.csv\", column = \"top.ux\", take = \"max-abs\" }\n[run]\nkeep = \"tables\"\nat_once = 1\n";
    fs::write(folder.join("study.toml"), rows).unwrap();
    study(folder, &["--out", "rows"]);
    assert_eq!(hand_overs(&folder.join("rows")), Vec::<String>::new());
}

/// Somebody, or a failing disk, changed a table of a run that was done: `--gather` takes no number from it, and the next start runs it again.
#[test]
fn a_run_whose_tables_were_changed_is_told_and_run_again() {
    for keep in ["all", "tables"] {
        let folder = folder(&format!("{STUDY}[run]\nkeep = \"{keep}\"\n"));
        let folder = folder.path();
        let done = study(folder, &["--out", "out"]);
        assert_eq!(done.status.code(), Some(0), "{}", said(&done));
        let table = String::from_utf8(bytes(folder, "out/study.csv")).unwrap();
        let run = "s1_north_0.04-m-s";
        let results = folder.join(format!("out/runs/{run}/results"));
        // What is not kept is not missed.
        let report = || {
            let mut report = Command::new(env!("CARGO_BIN_EXE_tremolite"));
            said(&report.arg("report").arg(&results).output().unwrap())
        };
        assert!(!report().contains("the run wrote it"), "{}", report());

        let path = results.join("monitors.csv");
        let sound = fs::read_to_string(&path).unwrap();
        let mut rows: Vec<String> = sound.lines().map(str::to_owned).collect();
        let last = rows.last_mut().unwrap();
        *last = last.replacen(',', ",9", 1);
        let changed = rows.join("\n") + "\n";
        fs::write(&path, &changed).unwrap();
        assert!(report().contains("monitors.csv: it is not what the run wrote"), "{}", report());

        let gathered = study(folder, &["--out", "out", "--gather"]);
        assert_eq!(gathered.status.code(), Some(1), "{}", said(&gathered));
        let told = format!("{run} pending: ");
        assert!(
            said(&gathered).contains(&told) && said(&gathered).contains("it is not what the run wrote"),
            "{}",
            said(&gathered)
        );
        let without = String::from_utf8(bytes(folder, "out/study.csv")).unwrap();
        let rows = || table.lines().zip(without.lines());
        for (with, without) in rows() {
            assert_eq!(with == without, !with.starts_with(run), "{without}");
        }
        assert!(fs::read_to_string(&path).unwrap() == changed, "{keep}: nothing is touched");

        let summary = results.join("summary.json");
        let whole = fs::read(&summary).unwrap();
        fs::write(&summary, &whole[..whole.len() / 2]).unwrap();
        let gathered = study(folder, &["--out", "out", "--gather"]);
        assert!(said(&gathered).contains("summary.json: it cannot be read"), "{}", said(&gathered));
        let again = study(folder, &["--out", "out"]);
        assert_eq!(again.status.code(), Some(0), "{}", said(&again));
        assert!(
            said(&again).contains("summary.json: it cannot be read; what is there is kept"),
            "{}",
            said(&again)
        );
        assert!(fs::read_to_string(&path).unwrap() == sound);
        fs::remove_dir_all(&results).unwrap();
        fs::rename(folder.join(format!("out/runs/{run}/results.old")), &results).unwrap();
        fs::write(&summary, whole).unwrap();

        let again = study(folder, &["--out", "out"]);
        assert_eq!(again.status.code(), Some(0), "{}", said(&again));
        assert!(said(&again).contains("results.old, and it is run again"), "{}", said(&again));
        assert_eq!(said(&again).matches('…').count(), 1, "{}", said(&again));
        assert!(fs::read_to_string(&path).unwrap() == sound);
        assert!(String::from_utf8(bytes(folder, "out/study.csv")).unwrap() == table);
        let old = folder.join(format!("out/runs/{run}/results.old/monitors.csv"));
        assert!(fs::read_to_string(old).unwrap() == changed);
    }
}

/// A motion that fits a spectrum in the mean over a band has the level 1; twice the spectrum is half of it.
#[test]
fn motions_are_scaled_to_a_target_spectrum_over_a_band() {
    let scaled = STUDY.replace("measure = \"RotD50 PGV\"", "measure = \"target(0.1 s, 1 s)\"").replace(
        "levels = [\"0.02 m/s\", \"0.04 m/s\"]",
        "target = \"code.csv\"\nlevels = [\"0.1\", \"20 %\"]",
    );
    let folder = folder(&scaled.replace("target = \"code.csv\"\n", ""));
    let folder = folder.path();
    let refused = study(folder, &["--out", "out", "--list"]);
    assert_eq!(refused.status.code(), Some(2));
    assert!(said(&refused).contains("[motion.target]"), "{}", said(&refused));
    let target = "\n[motion.target]\nperiod = [\"0.1 s\", \"0.5 s\", \"2 s\"]\nsa = [\"4 m/s2\", \"4 m/s2\", \"1 m/s2\"]\n";
    fs::write(folder.join("case.toml"), format!("{CASE}{target}")).unwrap();
    let factors = || {
        let listed = study(folder, &["--out", "out", "--list"]);
        assert_eq!(listed.status.code(), Some(0), "{}", said(&listed));
        let table = String::from_utf8(listed.stdout).unwrap();
        assert!(table.lines().next().unwrap().contains("target(0.1 s, 1 s)"), "{table}");
        let cell = |line: &str, k: usize| line.split(',').nth(k).unwrap().parse::<f64>().unwrap();
        table.lines().skip(1).map(|line| cell(line, 4)).collect::<Vec<_>>()
    };
    let by_case = factors();
    assert!((by_case[1] / by_case[0] - 2.0).abs() < 1e-8, "{by_case:?}");
    // The same spectrum twice as high, by the study's own file.
    fs::write(folder.join("code.csv"), "period [s], sa [m/s2]\n0.1, 8\n0.5, 8\n2, 2\n").unwrap();
    fs::write(folder.join("study.toml"), &scaled).unwrap();
    let by_file = factors();
    assert!(by_file.iter().zip(&by_case).all(|(a, b)| (a / b - 2.0).abs() < 1e-8), "{by_file:?}");
    fs::write(folder.join("study.toml"), scaled.replace("code.csv", "cod.csv")).unwrap();
    let refused = study(folder, &["--out", "out", "--list"]);
    assert!(
        said(&refused).contains("EN 1998-1") && said(&refused).contains("study.toml:"),
        "{}",
        said(&refused)
    );
}

/// `up` is made of the record's own component; what cannot be kept is refused or warned of.
#[test]
fn a_record_keeps_what_the_case_makes_of_another_component() {
    let folder = folder(STUDY);
    let folder = folder.path();
    let up = "east = { file = \"pulse.txt\" }\nup = { from = \"east\", factor = 0.5 }";
    fs::write(folder.join("case.toml"), CASE.replace("east = { file = \"pulse.txt\" }", up)).unwrap();
    let north = "[[record]]\nname = \"north\"\nnorth = { file = \"pulse.txt\" }\n";
    let study_with =
        |record: &str| fs::write(folder.join("study.toml"), STUDY.replace(north, record)).unwrap();
    study_with("");
    let done = study(folder, &["--out", "out", "--jobs", "1"]);
    assert_eq!(done.status.code(), Some(0), "{}", said(&done));
    let case = |run: &str| fs::read_to_string(folder.join(format!("out/runs/{run}/case.toml"))).unwrap();
    assert!(case("s1_east_0.02-m-s").contains("up = { factor = 0.5, from = \"east\" }"));
    let motion = Table::read(&folder.join("out/runs/s1_east_0.02-m-s/results/motion.csv")).unwrap();
    let peak = |name: &str| motion.column(name).unwrap().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    assert!((peak("given.vz") / peak("given.vx") - 0.5).abs() < 1e-9 && peak("given.vz") > 1e-3);

    // The component that it is made of is not there.
    study_with(north);
    let refused = study(folder, &["--list"]);
    assert_eq!(refused.status.code(), Some(2));
    let words = said(&refused);
    assert!(words.contains("the case makes `up` of `east`, which is not given"), "{words}");
    assert!(words.contains("study.toml:") && words.contains("give `east` or `up`"), "{words}");
    // Both remedies work; the record's own goes before the case's.
    for (own, up) in [
        ("up = { from = \"north\", factor = 0.7 }", "up = { factor = 0.7, from = \"north\" }"),
        ("east = { file = \"pulse.txt\" }", "up = { factor = 0.5, from = \"east\" }"),
    ] {
        study_with(&format!("{north}{own}\n"));
        let done = study(folder, &["--out", up, "--only", "s1_north_0.02"]);
        assert_eq!(done.status.code(), Some(0), "{}", said(&done));
        let runs = fs::read_dir(folder.join(up).join("runs")).unwrap().map(|run| run.unwrap().path());
        let texts: Vec<String> = runs.map(|run| fs::read_to_string(run.join("case.toml")).unwrap()).collect();
        assert!(!texts.is_empty() && texts.iter().all(|text| text.contains(up)), "{texts:?}");
    }

    // A recorded component belongs to its earthquake: the runs of another record do without it.
    let recorded = "east = { file = \"pulse.txt\" }\nup = { file = \"pulse.txt\" }";
    fs::write(folder.join("case.toml"), CASE.replace("east = { file = \"pulse.txt\" }", recorded)).unwrap();
    study_with("");
    let listed = study(folder, &["--list"]);
    assert_eq!(listed.status.code(), Some(0));
    assert!(
        said(&listed).contains("record 'east': it has no `up`, which the case has of another record"),
        "{}",
        said(&listed)
    );
}

/// What check would warn of a motion stands at its record before the first run.
#[test]
fn what_a_record_is_warned_of_is_printed_before_the_first_run() {
    let folder =
        folder(&STUDY.replace("name = \"east\"\n", "name = \"east\"\nwindow = [\"0 s\", \"3 s\"]\n"));
    let listed = study(folder.path(), &["--list"]);
    assert_eq!(listed.status.code(), Some(0), "{}", said(&listed));
    let words = said(&listed);
    assert!(words.contains("record 'east': window: 0 s to 3 s") && words.contains("study.toml:"), "{words}");
    assert_eq!(words.matches("record 'east': window").count(), 1, "{words}");
    assert!(!words.contains("record 'north': window"), "{words}");
}
