//! Bad cases: each problem is reported at its place, with a way out.

use std::path::Path;

use tremolite_case::{Case, Diagnostic, Report};
use tremolite_laws::materials::MATERIALS;

const GOOD: &str = include_str!("../cases/every-key.toml");

/// A change to the good case, and the one problem that must come of it.
pub struct Bad {
    from: &'static str,
    to: &'static str,
    /// How the text that is underlined starts.
    marks: &'static str,
    says: &'static str,
    remedy: &'static str,
}

pub const fn bad(
    from: &'static str,
    to: &'static str,
    marks: &'static str,
    says: &'static str,
    remedy: &'static str,
) -> Bad {
    Bad { from, to, marks, says, remedy }
}

fn report(source: &str) -> Report {
    match Case::parse(Path::new("case.toml"), source, MATERIALS) {
        Ok(_) => panic!("must be refused:\n{source}"),
        Err(report) => report,
    }
}

#[rustfmt::skip]
const BAD: &[Bad] = &[
    // Keys
    bad("overburden =", "overburdn = 1\noverburden =", "overburdn", "no key of `mesh.caverns`", "did you mean `overburden`?"),
    bad("safety = 0.8", "safety = 0.8\ndt = 3", "dt", "no key of `dynamic`", "`dt` belongs to [motion.east]"),
    bad("safety = 0.8", "safety = 0.8\ntitle = 3", "title", "no key of `dynamic`", "`title` belongs above all tables"),
    bad("poisson = 0.25", "poisson = 0.25\ncohesion = 3", "cohesion", "no key of `material.rock`", "keys here: law, density, unit_weight, water, young, poisson"),
    bad("kind = \"within\"\ndepth = \"50 m\"\n", "", "[motion]", "`kind` is missing", "\"outcrop\" | \"incident\" | \"within\" | \"surface\""),
    bad("depth = \"50 m\"\n", "", "[motion]", "`depth` is missing", "depth = \"… m\""),
    bad("kind = \"within\"\ndepth", "kind = \"surface\"\ndepth", "depth", "only with `kind = \"within\"`", "leave it out"),
    bad("kind = \"within\"\ndepth = \"50 m\"\nsite = { layers", "kind = \"outcrop\"\nsite = { layers", "{ layers", "`site` has a meaning only for a record on or within layered ground", "kind = \"surface\""),
    bad("poisson = 0.3, density", "poisson = 0.5, density", "0.5", "from 0 to 0.499", "give a value from 0 to 0.499"),
    bad("{ thickness = \"30 m\", shear", "{ shear", "{ shear", "`thickness` is missing", "thickness = \"… m\""),
    bad("{ thickness = \"30 m\", shear_wave_velocity = \"600 m/s\", poisson = 0.3, density = \"2100 kg/m3\", ", "{ thickness = \"30 m\", shear_wave_velocity = \"600 m/s\", poisson = 0.3, ", "{ thickness", "needs one of `density`, `unit_weight`", "give one of"),
    bad("{ thickness = \"8 m\", shear_wave_velocity = \"220 m/s\", poisson = 0.48, unit_weight = \"19 kN/m3\", damping = 0.05 }", "{ thickness = \"8 m\", shear_wave_velocity = \"220 m/s\", poisson = 0.48, unit_weight = \"19 kN/m3\" }", "{ thickness", "`damping` is missing", "damping"),
    bad("unit_weight = \"19 kN/m3\", damping = 0.05", "unit_weight = \"19 kN/m3\", vucetic_dobry = 15", "15", "was taken within the ground", "`damping`"),
    bad("target = { period = [\"0.1 s\", \"0.5 s\"], sa", "target = { period = [\"0.1 s\"], sa", "{ period", "this is no spectrum", "as many accelerations"),
    bad("target = { period = [\"0.1 s\", \"0.5 s\"], sa", "target = { file = \"a.csv\", sa", "sa", "cannot stand beside", "exactly one of"),
    bad("title = \"every key\"\n", "", "", "`title` is missing in the case", "add title = \"…\""),
    bad("young = \"10 GPa\"\n", "", "[material.rock]", "`young` is missing", "young = \"… GPa\" (Young's modulus E)"),
    bad("sides = { x = \"viscous\", y = \"roller\" }\n", "", "[dynamic]", "`sides` is missing", "periodic"),
    bad("[[region]]\ngroups = [\"powerhouse.bench*\"]", "[[region]]\nelement = \"full-integration\"\ngroups = [\"powerhouse.bench*\"]", "element", "only where `material` is not \"void\"", "leave it out"),
    bad("kind = \"viscous-spring\", normal = 1.5, tangential = 0.5, distance", "kind = \"fixed\", distance", "distance", "only with `kind = \"viscous-spring\"`", "leave it out"),
    bad("unit_weight = \"27 kN/m3\"", "unit_weight = \"27 kN/m3\"\ndensity = \"2700 kg/m3\"", "unit_weight", "`unit_weight` cannot stand beside `density`", "exactly one of"),
    bad("unit_weight = \"27 kN/m3\"\n", "", "[material.rock]", "needs one of `density`, `unit_weight`", "give one of"),
    bad("[material.rock]", "[mesh.file]\npath = \"a\"\n[material.rock]", "file", "`file` cannot stand beside `caverns`", "exactly one of `caverns`, `box`, `file`"),
    bad("kind = \"within\"", "kind = \"within\"\nfile = \"x.V2A\"", "east", "`east` cannot stand beside `file`", "exactly one of"),
    bad("factor = 0.667", "factor = 0.667, units = \"g\"", "units", "only beside `file`", "leave it out"),
    // Units
    bad("young = \"10 GPa\"", "young = \"10 m\"", "\"10 m\"", "is a length (`m`), a stress or modulus is expected", "10 GPa"),
    bad("young = \"10 GPa\"", "young = \"10 Gpa\"", "\"10 Gpa\"", "unknown unit `Gpa`", "did you mean `GPa`?"),
    bad("young = \"10 GPa\"", "young = \"10 GPa rock\"", "\"10 GPa rock\"", "cannot be read", "such as \"10 GPa\""),
    bad("young = \"10 GPa\"", "young = nan", "nan", "not a finite number", "finite"),
    bad("young = \"10 GPa\"", "young = -inf", "-inf", "not a finite number", "finite"),
    bad("young = \"10 GPa\"", "young = \"1e999 Pa\"", "\"1e999 Pa\"", "too large", "finite"),
    bad("young = \"10 GPa\"", "young = 25", "25", "`young` has no unit: a stress or modulus is expected", "\"25 GPa\", or put units = \"SI\" at the top"),
    bad("young = \"10 GPa\"", "young = 25e3", "25e3", "`young` has no unit", "\"25000 MPa\""),
    bad("young = \"10 GPa\"", "young = \"10 GPa/m\"", "\"10 GPa/m\"", "is a unit weight or a stiffness per area (`GPa/m`), a stress or modulus", "such as \"10 GPa\""),
    bad("unit_weight = \"27 kN/m3\"", "unit_weight = \"2700 kg/m3\"", "\"2700", "is a density (`kg/m3`), a unit weight is expected", "as `density`"),
    bad("unit_weight = \"27 kN/m3\"", "density = \"27 kN/m3\"", "\"27 kN", "a density is expected", "as `unit_weight`"),
    bad("unit_weight = \"27 kN/m3\"", "unit_weight = \"27\"", "\"27\"", "has no unit, a unit weight is expected", "\"27 kN/m3\""),
    bad("size_near = \"120 cm\"", "size_near = \"1,2 m\"", "\"1,2 m\"", "comma", "as a dot"),
    bad("size_near = \"120 cm\"", "size_near = \"1.2\"", "\"1.2\"", "has no unit", "\"1.2 m\""),
    bad("model_x_azimuth = \"30 deg\"", "model_x_azimuth = 30", "30", "has no unit", "deg"),
    bad("units = \"cm/s2\"", "units = \"cm/s\"", "\"cm/s\"", "is a velocity", "units = \"m/s2\""),
    bad("units = \"cm/s2\"", "units = \"cm/s\"", "\"cm/s\"", "is a velocity", "or \"counts\""),
    bad("units = \"cm/s2\"", "units = \"count\"", "\"count\"", "", "or \"counts\""),
    bad("histories = \"20 ms\"", "histories = true", "true", "should be a time, not true or false", "\"… s\""),
    // Limits
    bad("width = \"17 m\"", "width = 0", "0", "must be above 0", "above 0"),
    bad("poisson = 0.25", "poisson = 0.5", "0.5", "must be at least 0 and below 0.5", "0.15 to 0.35"),
    bad("safety = 0.8", "safety = 1.2", "1.2", "above 0 and at most 1", "at most 1"),
    bad("mass = \"0.3 1/s\"", "mass = \"-0.3 1/s\"", "\"-0.3 1/s\"", "must be 0 or more", "0 or more"),
    bad("benches = 6", "benches = 0", "0", "a whole number from 1 to 50, not 0", "benches"),
    bad("benches = 6", "benches = 2.5", "2.5", "a whole number from 1 to 50, not a number", "benches"),
    bad("benches = 6", "benches = 99999999999999999999", "99999", "a whole number from 1 to 50", "benches"),
    bad("duration = \"19.5 s\"", "duration = \"0 s\"", "\"0 s\"", "must be above 0", "above 0"),
    bad("snapshots = \"none\"", "snapshots = \"0 s\"", "\"0 s\"", "must be above 0", "or \"none\""),
    bad("snapshots = \"none\"", "snapshots = \"never\"", "\"never\"", "does not start with a number", "or \"none\""),
    bad("window = [\"20.5 s\", \"40 s\"]", "window = [\"40 s\", \"20 s\"]", "[\"40 s\"", "ends before it begins", "earlier time first"),
    bad("window = [\"20.5 s\", \"40 s\"]", "window = [\"40 s\"]", "[\"40 s\"]", "a list of 2", "window"),
    bad("window = [\"20.5 s\", \"40 s\"]", "window = { strongest = \"0 s\" }", "\"0 s\"", "must be above 0", "above 0"),
    bad("size_near = \"120 cm\"", "size_near = \"12 m\"", "\"12 m\"", "`size_near` is larger than `size_far`", "smaller size"),
    bad("height = \"37.2 m\"", "height = \"4.4 m\"", "\"4.5 m\"", "must be below `height`", "the arch included"),
    bad("arch_rise = \"2.2 m\"\n", "", "[[mesh.caverns.cavern]]", "must be above 0", "rectangle"),
    bad("shape = \"ellipse\"", "shape = \"circle\"", "\"2.2 m\"", "no meaning", "leave it out"),
    bad("length = \"4000 cm\"", "length = \"52.9 m\"", "\"52.9 m\"", "longer than the block", "goes through the block"),
    bad("length = \"4000 cm\"", "length = \"0 m\"", "\"0 m\"", "must be above 0", "above 0"),
    bad("length = \"4000 cm\"\n", "", "middle", "only beside `length`", "leave it out"),
    bad("arch_rise = \"4.5 m\"", "arch_rise = \"9 m\"", "\"9 m\"", "more than half the width", "a semicircle"),
    // Words and names
    bad("kind = \"within\"\ndepth = \"50 m\"", "kind = \"outcrp\"", "\"outcrp\"", "`kind` cannot be \"outcrp\"", "did you mean \"outcrop\"?"),
    bad("sides = { x = \"viscous\"", "sides = { x = \"freefield\"", "\"freefield\"", "`x` cannot be \"freefield\"", "did you mean \"free-field\"?"),
    bad("top = \"viscous\"", "top = \"roller\"", "\"roller\"", "`top` cannot be \"roller\"", "one of \"free\", \"viscous\""),
    bad("element = \"layered\"\npoints_through = 13", "element = \"quadratic\"", "\"quadratic\"", "cannot be", "one of \"reduced-integration\", \"full-integration\", \"layered\""),
    bad("element = \"layered\"", "element = \"full-integration\"", "points_through", "only with `element = \"layered\"`", "leave it out"),
    bad("law = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0.25", "law = \"elastik\"", "\"elastik\"", "cannot be \"elastik\"", "did you mean \"elastic\"?"),
    bad("name = \"A\"", "name = \"A.1\"", "\"A.1\"", "cannot be used as a name", "no blanks or quotes"),
    bad("title = \"every key\"", "title = \" \"", "\" \"", "an empty text", "title"),
    bad("material = \"rock\"", "material = \"rok\"", "\"rok\"", "no material `rok`", "did you mean \"rock\"?"),
    bad("material = \"rock\"", "material = \"marble\"", "\"marble\"", "no material `marble`", "add [material.marble]"),
    bad("[material.concrete]", "[material.void]\nlaw = \"elastic\"\ndensity = \"1 kg/m3\"\nyoung = \"10 GPa\"\npoisson = 0\n[material.concrete]", "void", "cannot be called `void`", "another name"),
    bad("between = [\"free\", \"A\"]", "between = [\"free\", \"B\"]", "\"B\"", "no monitor `B`", "known monitors: A, free"),
    bad("between = [\"free\", \"A\"]", "between = [\"A\", \"A\"]", "\"A\"]", "against itself", "another monitor"),
    bad("between = [\"free\", \"A\"]", "between = [\"free\", \"A\"]\n[[monitor_pair]]\nbetween = ['free', 'A']", "'A'", "are called `free-A`", "stands there twice"),
    bad("name = \"free\"\nat = [\"0 m\", \"1 m\", \"-210 m\"]", "name = \"A\"\nat = [\"1 m\", \"2 m\", \"3 m\"]\n[[monitor]]\nname = \"free\"\nat = [\"0 m\", \"1 m\", \"-210 m\"]", "\"A\"", "monitor `A` is named twice", "its own name"),
    bad("name = \"transformer\"", "name = \"powerhouse\"", "\"powerhouse\"", "two caverns are called `powerhouse`", "its own name"),
    bad("between = [\"powerhouse\", \"transformer\"]", "between = [\"powerhouse\", \"hall\"]", "\"hall\"", "there is no cavern `hall`", "two caverns of this block"),
    bad("name = \"busbar\"", "name = \"transformer\"", "\"transformer\"", "a cavern or another gallery is called `transformer`", "its own name"),
    bad("name = \"sound\"", "name = \"weathered\"", "\"weathered\"", "two layers are called `weathered`", "its own name"),
    bad("groups = [\"*.lining\"]", "groups = [\"*.lining\", \"rock\"]", "\"rock\"", "group `rock` is named twice", "one region only"),
    bad("fields = [\"displacement\", \"s1\"]", "fields = [\"s1\", \"s1\"]", "\"s1\"]", "field `s1` is named twice", "once"),
    bad("from = \"east\"", "from = \"up\"", "\"up\"", "`up` is not a record of its own", "has a `file`"),
    bad("columns = [\"time\", \"acceleration\"]", "columns = [\"time\", \"skip\"]", "\"time\"", "one column must be the acceleration", "\"acceleration\""),
    bad("columns = [\"time\", \"acceleration\"]", "columns = [\"time\", \"acceleration\"], dt = \"1 s\"", "\"1 s\"", "`dt` beside a column of times", "leave `dt` out"),
    bad("at = [\"0 m\", \"1 m\", \"-210 m\"]", "at = [0, 1]", "[0, 1]", "a list of 3, each a length, not a list of 2", "[\"… m\", \"… m\", \"… m\"]"),
    bad("groups = [\"*.lining\"]", "groups = \"*.lining\"", "\"*.lining\"", "should be a list", "groups = [\"…\"]"),
    bad("[[monitor_pair]]", "[monitor_pair]", "[monitor_pair]", "should be a list of tables", "[[monitor_pair]]"),
    // What later versions bring
    bad("[initial]", "[water]\nlevel = \"3 m\"\nheads = { sides = \"3 m\" }\n[initial]", "{ sides = \"3 m\" }", "`heads` has a meaning only with steady seepage", "pressure = \"seepage\""),
    bad("language = \"zh\"", "language = \"fr\"", "\"fr\"", "`language`", "zh"),
    bad("damping = { rayleigh", "damping = { ratio = 0.03, rayleigh", "ratio", "`ratio` has a meaning only beside `band`", "leave it out"),
    // TOML
    bad("size_near = \"120 cm\"", "size_near = 120 cm", "120 cm", "not in quotes", "\"120 cm\""),
    bad("size_near = \"120 cm\"", "size_near =", "\n", "a value is missing", "write a value"),
    bad("size_near = \"120 cm\"", "near = \"120 cm", "\n", "a quotation mark is missing", "close the text"),
    bad("file = \"b.txt\"", "file = \"C:\\Users\\d\\b.txt\"", "\"C:", "a backslash in double quotes", "\"C:/Users/d/b.txt\", or in single quotes, 'C:\\Users\\d\\b.txt'"),
    bad("file = \"b.txt\"", "file = \"records\\xb.txt\"", "\"records", "a backslash in double quotes", "\"records/xb.txt\""),
    bad("size_near = \"120 cm\"", "size_near = 1\nsize_near = 2", "size_near = 2", "given twice", "keep one"),
    bad("size_near = \"120 cm\"", "near \"120 cm\"", "\"120 cm\"", "a key without `=`", "key = value"),
];

impl Bad {
    /// Where the problem must be marked: a missing key at the header before the change, all else in the change.
    fn place(&self, source: &str) -> usize {
        let change = GOOD.find(self.from).expect("the change applies to the good case");
        if self.marks.is_empty() {
            0
        } else if self.marks.starts_with('[') && !self.to.contains(self.marks) {
            let end = change + self.to.len();
            source[..end].rfind(self.marks).expect("the mark stands before the change")
        } else {
            change + source[change..].find(self.marks).expect("the mark stands in the change")
        }
    }

    /// What is wrong with the report, if anything is.
    pub fn failure(&self) -> Option<String> {
        let source = GOOD.replacen(self.from, self.to, 1);
        let report = report(&source);
        let place = self.place(&source);
        let line = source[..place].matches('\n').count() + 1;
        let good = matches!(&report.problems[..], [problem]
            if problem.message.contains(self.says)
                && problem.remedy.contains(self.remedy)
                && problem.span.start == place
                && report.position(problem).0 == line
                && report.to_string().contains(&format!("case.toml:{line}:")));
        (!good).then(|| format!("{}\n    must give one problem in line {line}, but:\n{report}", self.to))
    }
}

#[test]
fn each_mistake_is_reported_once_at_its_place_with_a_way_out() {
    let failures: Vec<String> = BAD.iter().filter_map(Bad::failure).collect();
    assert!(failures.is_empty(), "{} of {}:\n{}", failures.len(), BAD.len(), failures.join("\n\n"));
}

#[test]
fn all_problems_of_a_file_are_reported_in_its_order() {
    let source = GOOD
        .replace("size_near = \"120 cm\"", "size_near = \"120 MPa\"")
        .replace("poisson = 0.25", "poisson = 0.7")
        .replace("element = \"reduced-integration\"", "elemnt = \"one-point\"")
        .replace("kind = \"within\"\ndepth = \"50 m\"\n", "")
        .replace("safety = 0.8", "safety = 7")
        .replace("between = [\"free\", \"A\"]", "between = [\"free\", \"Q\"]")
        .replace("[output]", "[water]\n[output]");
    let report = report(&source);
    let found: Vec<(usize, &str)> =
        report.problems.iter().map(|p| (report.position(p).0, p.message.as_str())).collect();
    let line = |text: &str| source.lines().position(|l| l.contains(text)).expect(text) + 1;
    assert_eq!(
        found,
        [
            (line("120 MPa"), "`size_near` is a stress or modulus (`MPa`), a length is expected"),
            (line("poisson = 0.7"), "`poisson` must be at least 0 and below 0.5"),
            (line("elemnt"), "`elemnt` is no key of `region[0]`"),
            (line("[motion]"), "`kind` is missing in `motion`"),
            (line("safety"), "`safety` must be above 0 and at most 1"),
            (line("\"Q\""), "there is no monitor `Q`"),
            (line("[water]"), "`level` is missing in `water`"),
        ]
    );
}

#[test]
fn a_problem_is_shown_with_its_line_underlined() {
    let source = GOOD.replace("size_near = \"120 cm\"", "size_near = \"120 Cm\"");
    let text = report(&source).render(false);
    assert_eq!(
        text,
        "error: `size_near` has an unknown unit `Cm`\n  \
          --> case.toml:10:13\n   \
            |\n\
         10 | size_near = \"120 Cm\"\n   \
            |             ^^^^^^^^\n   \
            |\n\
         help: did you mean `cm`?\n\n\
         case.toml: 1 error"
    );
    assert!(report(&source).render(true).contains("\u{1b}["), "colour only where it is asked for");
}

#[test]
fn problems_found_later_are_shown_in_the_same_way() {
    let case = Case::parse(Path::new("case.toml"), GOOD, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    let at = &case.monitors[1].at;
    let report = case.report(vec![
        Diagnostic::at(at, "monitor `free` lies outside the mesh", "move it"),
        Diagnostic::at(&case.regions[0].groups[0], "the mesh has no group `rock`", "name one that it has"),
    ]);
    let lines: Vec<usize> = report.problems.iter().map(|p| report.position(p).0).collect();
    assert!(lines[0] < lines[1], "sorted by place");
    assert!(report.to_string().contains("at = [\"0 m\", \"1 m\", \"-210 m\"]"), "{report}");
}

#[test]
fn what_is_allowed_but_hardly_meant_is_a_warning() {
    let unused = "[material.spare]\nlaw = \"elastic\"\nyoung = \"10 GPa\"\npoisson = 0\ndensity = \"1 kg/m3\"\n[initial]";
    let source = GOOD.replace("[initial]", unused);
    let case = Case::parse(Path::new("case.toml"), &source, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    let [warning] = &case.warnings[..] else { panic!("one warning") };
    assert_eq!(warning.message, "no region is made of `spare`");
    let text = case.report(case.warnings.clone()).as_warnings().to_string();
    assert!(text.starts_with("warning: ") && text.ends_with("1 warning"), "{text}");
}

/// What follows from a refused key alone is not told beside it.
#[test]
fn one_cause_in_the_water_is_told_once() {
    let water = "[water]\nlevel = \"3 m\"\npressure = \"seepage\"\nheads = { sides = \"3 m\" }\n[initial]";
    let pores = "poisson = 0.25\nwater = { hydraulic_conductivity = \"1e-7 m/s\" }";
    let wet = GOOD.replacen("[initial]", water, 1).replacen("poisson = 0.25", pores, 1);
    assert!(Case::parse(Path::new("case.toml"), &wet, MATERIALS).is_ok());
    let told = |from: &str, to: &str| -> Vec<String> {
        assert!(wet.contains(from), "{from}");
        report(&wet.replacen(from, to, 1)).problems.iter().map(|p| p.message.clone()).collect()
    };
    let heads = "heads = { sides = \"3 m\" }";
    assert_eq!(
        told(heads, "heads = {}"),
        ["`heads` should be a table, each value a length, not an empty one"]
    );
    for (from, to) in [
        (heads, "heads = { sides = \"3\" }"),
        (heads, "heads = \"3 m\""),
        (heads, "haeds = { sides = \"3 m\" }"),
        ("\"1e-7 m/s\"", "\"1e-7\""),
        ("\"1e-7 m/s\"", "\"-1e-7 m/s\""),
        ("hydraulic_conductivity", "hydraulic_conductivty"),
        ("{ hydraulic_conductivity", "{ biot = 2, hydraulic_conductivity"),
        ("material = \"rock\"", "material = \"rok\""),
    ] {
        let found = told(from, to);
        assert_eq!(found.len(), 1, "{to}: {found:?}");
    }
    assert_eq!(told(heads, ""), ["nothing says where the water of the seepage comes from"]);
    let tight = ["no material of a region has a hydraulic conductivity, so that no water flows"];
    assert_eq!(told("{ hydraulic_conductivity = \"1e-7 m/s\" }", "{ biot = 0.8 }"), tight);
}

/// A field that nothing writes is told of.
#[test]
fn a_field_of_seepage_without_seepage_is_a_warning() {
    let source = GOOD.replacen("fields = [", "fields = [\"seepage\", ", 1);
    let case = Case::parse(Path::new("case.toml"), &source, MATERIALS).unwrap_or_else(|e| panic!("{e}"));
    let [warning] = &case.warnings[..] else { panic!("{:?}", case.warnings) };
    assert!(warning.message.contains("no water flows") && warning.remedy.contains("seepage"), "{warning:?}");
}
