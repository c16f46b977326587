//! The keys of a study file, but for those whose names or values the case knows alone (`set`, `vary`, `row`).

use tremolite_laws::parameter::Dimension;

use super::{Checks, Design, FailedRun, Keep, SampleKind, Take};
use crate::Language;
use crate::check::UNITS;
use crate::keys::{Key, Kind, Limit, Table, When};
use crate::motion::{COMPONENT, WINDOW_KIND};

const NUMBER: Kind = Kind::Number(Dimension::NONE, Limit::Any);
const COUNT: Kind = Kind::Count(20_000);

pub(super) static STUDY: Table = Table {
    path: "",
    doc: "A study: runs of one case beside one another.",
    keys: &[
        Key::required("title", Kind::Text, "what the study asks"),
        UNITS,
        Key::required("case", Kind::File, "the case file that its runs are made of, from the study's folder"),
        Key::optional(
            "language",
            Kind::Word(Language::WORDS),
            "",
            "The page's language; that of the case where it is left out",
        ),
        Key::optional("sample", Kind::Table(&SAMPLE), "", "How values of the varied keys are chosen"),
        Key::optional("correlation", Kind::Tables(&CORRELATION), "", "Varied keys whose ranks go together"),
        Key::optional("record", Kind::Tables(&RECORD), "", "Records in place of the case's own"),
        Key::optional("scale", Kind::Table(&SCALE), "", "How strong the motions are made"),
        Key::optional(
            "measure",
            Kind::Map("cracked", &Kind::Table(&MEASURE)),
            "",
            "Columns of the table of results",
        ),
        Key::optional("fragility", Kind::Tables(&FRAGILITY), "", "Fragility curves"),
        Key::default("run", Kind::Table(&RUN), "{}", "How it is run, which changes no result"),
    ],
    choice: &[],
};

static SAMPLE: Table = Table {
    path: "sample",
    doc: "How values of the varied keys are chosen.",
    keys: &[
        Key::required("kind", Kind::Word(SampleKind::WORDS), "how samples are chosen"),
        Key::optional("count", COUNT, "", "Number of samples of latin-hypercube and sobol"),
        Key::default("seed", Kind::Count(u32::MAX), "1", "Another number gives another sample"),
        Key::required("file", Kind::File, "the table of values").when(When::Is("kind", "table")),
        Key::optional(
            "quantiles",
            Kind::List(&Kind::Number(Dimension::NONE, Limit::Within(1.0)), 1, 100),
            "",
            "Shares of a distribution at which one-at-a-time and grid take its values",
        ),
    ],
    choice: &[],
};

static CORRELATION: Table = Table {
    path: "correlation",
    doc: "A rank correlation between two varied keys.",
    keys: &[
        Key::required("between", Kind::List(&Kind::Text, 2, 2), "the paths of two varied keys"),
        Key::required("rank", NUMBER, "Spearman's correlation of their ranks, above -1 and below 1"),
    ],
    choice: &[],
};

static RECORD: Table = Table {
    path: "record",
    doc: "A record in place of the case's own; the case's processing stays unless it is given here.",
    keys: &[
        Key::required("name", Kind::Name, "by which runs are called"),
        Key::optional("file", Kind::File, "", "File with all components, taken by their orientation"),
        Key::optional("sensitivity", Kind::Text, "", "What a count is, where the file holds counts")
            .when(When::Beside("file")),
        Key::optional("east", Kind::Table(&COMPONENT), "", "Component towards east"),
        Key::optional("north", Kind::Table(&COMPONENT), "", "Component towards north"),
        Key::optional("up", Kind::Table(&COMPONENT), "", "Component upwards"),
        Key::optional("window", WINDOW_KIND, "", "The part of the record that is used"),
        Key::optional(
            "processing",
            Kind::List(&Kind::Text, 0, 100),
            "",
            "Steps of processing, in place of the case's",
        ),
        Key::optional(
            "model_x_azimuth",
            Kind::Number(Dimension::ANGLE, Limit::Any),
            "",
            "Direction of the model's x axis, clockwise from north: turns the record",
        ),
    ],
    choice: &[&["file"], &["east", "north", "up"]],
};

static SCALE: Table = Table {
    path: "scale",
    doc: "How strong the motions are made: one factor for all components.",
    keys: &[
        Key::required(
            "measure",
            Kind::Text,
            "the intensity measure: \"PGA\", \"PGV\", \"Arias\", \"Sa(0.5 s)\", \"RotD50 Sa(0.5 s, 5 %)\", \"target(0.2 s, 2 s)\"",
        ),
        Key::optional(
            "levels",
            Kind::List(&Kind::Text, 1, 1000),
            "",
            "Its values, the same for all records: [\"0.1 g\", \"0.2 g\"]",
        ),
        Key::optional(
            "ida",
            Kind::Table(&IDA),
            "",
            "Rising levels for each record until it is beyond a limit",
        ),
        Key::default(
            "design",
            Kind::Word(Design::WORDS),
            "\"cross\"",
            "How samples, records and levels go together",
        ),
        Key::optional(
            "target",
            Kind::Text,
            "",
            "The spectrum of \"target(0.2 s, 2 s)\": \"EN 1998-1 type 1 ground B 2 m/s2\" or a CSV file; [motion.target] of the case where it is \
             left out",
        ),
    ],
    choice: &[&["levels"], &["ida"]],
};

static IDA: Table = Table {
    path: "scale.ida",
    doc: "Incremental dynamic analysis (`vamvatsikos2002`): rising levels until a limit.",
    keys: &[
        Key::required("first", Kind::Text, "the lowest level: \"0.1 g\""),
        Key::required("step", Kind::Text, "from level to level: \"0.1 g\""),
        Key::default("most", Kind::Count(1000), "20", "Number of levels at most"),
        Key::required("until", Kind::Text, "the measure that ends it"),
        Key::required(
            "above",
            NUMBER,
            "the measure's value beyond which it ends; a run that the guard stops ends it too",
        ),
    ],
    choice: &[],
};

static MEASURE: Table = Table {
    path: "measure",
    doc: "A column of the table of results.",
    keys: &[
        Key::optional(
            "summary",
            Kind::Text,
            "",
            "A number of summary.json, by its path: 'damage.\"powerhouse.lining\".volume'",
        ),
        Key::optional("over", Kind::Text, "", "Another number there that it is divided by")
            .when(When::Beside("summary")),
        Key::optional(
            "unit",
            Kind::Text,
            "",
            "SI unit of a number of summary.json, for headers and axes: \"m\"",
        )
        .when(When::Beside("summary")),
        Key::optional("table", Kind::Text, "", "A table of the results: \"monitors.csv\""),
        Key::required("column", Kind::Text, "its column: \"A-B.u\"").when(When::Beside("table")),
        Key::required("take", Kind::Word(Take::WORDS), "which of its numbers").when(When::Beside("table")),
        Key::optional("checks", Kind::Word(Checks::WORDS), "", "How many checks of the run"),
        Key::optional("otherwise", NUMBER, "", "The value where the results hold no such number"),
        Key::optional(
            "unless",
            Kind::Text,
            "",
            "A text of summary.json by its path: the measure stays empty where it lists one of `names`",
        ),
        Key::required(
            "names",
            Kind::List(&Kind::Text, 1, 100),
            "which names, such as those of the monitors that it is of",
        )
        .when(When::Beside("unless")),
    ],
    choice: &[&["summary"], &["table"], &["checks"]],
};

static FRAGILITY: Table = Table {
    path: "fragility",
    doc: "Fragility curves: the probability that a measure is beyond a limit, over intensity.",
    keys: &[
        Key::required("measure", Kind::Text, "which measure"),
        Key::required(
            "above",
            Kind::Either(&[NUMBER, Kind::List(&NUMBER, 1, 20)]),
            "the limit, or several that rise",
        ),
        Key::optional("by", Kind::Text, "", "The intensity measure; that of [scale] where it is left out"),
        Key::required(
            "failed",
            Kind::Word(FailedRun::WORDS),
            "what a run counts as that the guard stopped in its earthquake",
        ),
        Key::default("bootstrap", Kind::Count(100_000), "1000", "Samples of the bootstrap over records"),
    ],
    choice: &[],
};

static RUN: Table = Table {
    path: "run",
    doc: "How it is run, which changes no result.",
    keys: &[
        Key::optional("at_once", Kind::Count(4096), "", "Runs beside one another"),
        Key::optional("threads", Kind::Count(4096), "", "Threads of each"),
        Key::default("keep", Kind::Word(Keep::WORDS), "\"all\"", "What stays of a run that is done"),
        Key::default(
            "share",
            Kind::Flag,
            "true",
            "Whether runs that are equal before the earthquake share what comes before it",
        ),
    ],
    choice: &[],
};
