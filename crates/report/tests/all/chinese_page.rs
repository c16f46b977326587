//! A page in Chinese is Chinese throughout: in no part of it three English words stand in a row, but in names.

use std::fs;

use tremolite_report::{Language, write_in};
use tremolite_results::{EARTHQUAKE, Pvd, ResultFolder, Summary};

use super::interface_results::{self, fault, pairs, tunnel};
use super::{bolts, deconvolved, free_field, report, stages};

/// Parts of the page, by the headings above them.
const STAGES: &[&str] = &[
    "施工阶段",
    "模型趋于平衡的过程",
    "洞周收敛",
    "围岩特征曲线",
    "施工阶段结束时的监测点",
    "衬砌内力",
    "tunnel.lining",
    "hall.lining",
];
const BOLTS: &[&str] = &["锚杆", "各阶段轴力与屈服力之比", "受力最大锚杆的轴力分布"];
const FREE_FIELD: &[&str] = &["输入波与自由场响应", "自由场柱的速度峰值", "模型角点的速度峰值"];
const DECONVOLVED: &[&str] = &["输入地震动", "模型与地震动"];
const INTERFACES: &[&str] = &["接触面时程", "接触面上的监测点"];
const DAMAGE: &[&str] = &["混凝土损伤", "围岩屈服：塑性应变"];

/// The page's drawn and told text: a line for each text between two tags.
fn texts(html: &str) -> String {
    let mut out = String::new();
    let mut rest = html;
    while let Some((text, behind)) = rest.split_once('<') {
        out.push_str(text);
        // A name may break behind its dots.
        out.push_str(if behind.starts_with("wbr>") { "" } else { "\n" });
        let end = if behind.starts_with("code") { behind.find("</code>") } else { None };
        rest = behind[end.unwrap_or(0)..].split_once('>').map_or("", |(_, after)| after);
    }
    out + rest
}

/// Three or more English words in a row in a text without `names`.
fn english(text: &str, names: &[&str]) -> Vec<String> {
    let mut names = names.to_vec();
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    let text = names.iter().fold(text.to_owned(), |text, name| text.replace(name, "\n"));
    let between = |c: char| c == ' ' || c == '\u{a0}' || ",:;.'()/".contains(c);
    // A hyphen joins the parts of a name.
    let other = |c: char| !(c.is_ascii_alphabetic() || c == '-' || between(c));
    let rows = text.split(other).map(|row| row.split(between).filter(|word| word.len() > 1));
    rows.filter(|row| row.clone().count() > 2).map(|row| row.collect::<Vec<_>>().join(" ")).collect()
}

/// What stands below a heading up to the next.
fn below<'a>(page: &'a str, heading: &str) -> &'a str {
    let plain = |part: &str| part.split_once("</h").map_or(String::new(), |(h, _)| h.replace("<wbr>", ""));
    let headed = |part: &&str| plain(part).split_once('>').is_some_and(|(_, own)| own == heading);
    let parts = ["<h2", "<h3", "<h4"]
        .into_iter()
        .fold(vec![page], |parts, tag| parts.into_iter().flat_map(|part| part.split(tag)).collect());
    let part = parts.into_iter().find(headed).unwrap_or_else(|| panic!("no heading {heading}"));
    part.split_once("</section>").map_or(part, |(own, _)| own)
}

fn page(folder: &ResultFolder) -> String {
    fs::read_to_string(write_in(folder.root(), Language::Chinese).unwrap()).unwrap()
}

/// Fails on English below any of the headings.
fn assert_chinese(page: &str, headings: &[&str], names: &[&str]) {
    for heading in headings {
        let found = english(&texts(below(page, heading)), names);
        assert!(found.is_empty(), "{heading}: {found:?}");
    }
}

#[test]
fn stages_and_section_forces_are_told_in_chinese() {
    // Stages, groups, and what the run itself says of a change.
    let own = ["top heading, rest", "top heading", "bench, rest", "tunnel.lining becomes hardened concrete"];
    for shaken in [false, true] {
        let temp = tempfile::tempdir().unwrap();
        let folder = stages::example(temp.path(), shaken);
        let page = page(&folder);
        assert_chinese(&page, STAGES, &own);
        let mut summary = Summary::read(&folder.summary()).unwrap();
        for stage in &mut summary.computed.stages {
            stage.tolerance = f64::NAN;
            stage.walls.retain(|name, _| !name.starts_with("tunnel"));
            stage.walls.insert("pillar".into(), [1e-3; 3]);
            stage.walls.insert("store.rib".into(), [1e-3; 3]);
        }
        let values = summary.computed.stages[5].monitors["A"].clone();
        summary.computed.stages[5]
            .monitors
            .extend(["B", "A-B"].map(|name| (name.to_owned(), values.clone())));
        summary.write(&folder.summary()).unwrap();
        let headings: Vec<_> = STAGES[1..5].iter().copied().filter(|h| *h != "围岩特征曲线").collect();
        assert_chinese(&self::page(&folder), &headings, &own);
        fs::write(folder.relaxation(), "stage []\n1\n").unwrap();
        fs::write(folder.sections(), "lining\n").unwrap();
        let page = self::page(&folder);
        assert!(below(&page, "模型趋于平衡的过程").contains("未列出。"));
        assert!(below(&page, "衬砌内力").contains("未列出。"));
    }
}

#[test]
fn bolts_are_told_in_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = bolts::results(temp.path());
    assert_chinese(&page(&folder), BOLTS, &[]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.bolts["toe"].there = false;
    (summary.parts.bolts["walls"].placed, summary.parts.bolts["walls"].largest.stage) =
        (EARTHQUAKE.into(), "bench 1".into());
    summary.write(&folder.summary()).unwrap();
    let lines = folder.bolt_fields();
    fs::rename(lines.join("000012.vtu"), lines.join("stage-3.vtu")).unwrap();
    Pvd::create(&folder.bolts_pvd()).unwrap().add(3.0, "bolts/stage-3.vtu").unwrap();
    assert_chinese(&page(&folder), BOLTS, &[]);
    fs::remove_file(folder.bolts()).unwrap();
    fs::remove_file(folder.bolts_pvd()).unwrap();
    assert_chinese(&page(&folder), &BOLTS[..1], &[]);
}

#[test]
fn the_free_field_is_told_in_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = free_field::results(temp.path());
    free_field::motion(&folder);
    let small = |t| 1e-9 * free_field::surface(t);
    let all: [(&str, &dyn Fn(f64) -> f64); 9] = [
        ("reference-xmin-ymin.top.vx", &free_field::too_much),
        ("reference-xmin-ymin.top.vx_theory", &free_field::surface),
        ("reference-xmin-ymin.base.vx", &free_field::base),
        ("reference-xmin-ymin.top.vz", &small),
        ("xmin-ymax.top.vx", &free_field::base),
        ("xmin-ymax.top.vx_theory", &free_field::surface),
        ("xmax-ymax.top.vx", &free_field::base),
        ("model.xmin-ymin.surface.vx", &free_field::surface),
        ("model.xmin-ymax.surface.vx", &free_field::surface),
    ];
    // With everything, without corners, with one column, without columns, with the mean of the corners.
    let mean: [(&str, &dyn Fn(f64) -> f64); 3] =
        [all[4], all[6], ("model.surface.vx", &free_field::too_much)];
    for columns in [&all[..], &all[..7], &all[5..], &all[7..], &mean] {
        free_field::free_field(&folder, columns);
        let page = page(&folder);
        let parts = if columns.len() == all.len() { FREE_FIELD } else { &FREE_FIELD[..1] };
        assert_chinese(&page, parts, &[]);
    }
    fs::remove_file(folder.motion()).unwrap();
    free_field::free_field(&folder, &all);
    assert_chinese(&page(&folder), FREE_FIELD, &[]);
    free_field::free_field(&folder, &[("model.surface.vx", &|_| 0.0)]);
    assert!(below(&page(&folder), FREE_FIELD[0]).contains("free_field.csv 中没有运动。"));
}

#[test]
fn a_record_that_was_deconvolved_is_told_in_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = deconvolved::recorded(temp.path());
    // The theory's author.
    assert_chinese(&page(&folder), DECONVOLVED, &["Kramer"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    if let Some(site) = &mut summary.computed.motion.deconvolved {
        (site.depth, site.reach) = (30.0, f64::NAN);
        site.corner.clear();
    }
    summary.write(&folder.summary()).unwrap();
    fs::remove_file(folder.transfer()).unwrap();
    assert_chinese(&page(&folder), DECONVOLVED, &[]);
}

#[test]
fn interfaces_are_told_in_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = interface_results::results(temp.path());
    let patches: Vec<_> = tunnel(0, 0.0, 100).into_iter().chain(fault(1, 60.0)).collect();
    pairs(&folder, &patches, |_| (1e-3, 1e-4, 2));
    let page = page(&folder);
    assert_chinese(&page, INTERFACES, &[]);
    let (_, table) = page.split_once("<table class=\"interfaces\">").unwrap();
    let table = table.split_once("</table>").unwrap().0;
    assert_eq!(english(&texts(table), &[]), [""; 0]);
}

#[test]
fn damage_is_told_in_chinese() {
    let temp = tempfile::tempdir().unwrap();
    let folder = report::results(temp.path(), &["A"]);
    let mut summary = Summary::read(&folder.summary()).unwrap();
    summary.parts.damage.insert("hall.lining".into(), report::cracked());
    summary.write(&folder.summary()).unwrap();
    assert_chinese(&page(&folder), DAMAGE, &[]);
}

#[test]
fn english_is_found_and_names_are_not() {
    let html =
        "<p>开挖 top heading, rest 之后<b>of the</b><code>a b cc dd ee</code>worst</p><p>x.<wbr>yy</p>";
    let text = texts(html);
    assert_eq!(
        text.split_whitespace().collect::<Vec<_>>().join(" "),
        "开挖 top heading, rest 之后 of the worst x.yy"
    );
    assert_eq!(english(&text, &[]), ["top heading rest"]);
    assert_eq!(english(&text, &["top heading, rest"]), [""; 0]);
    assert_eq!(english("第 3 阶段: the bolt that came nearest", &[]), ["the bolt that came nearest"]);
    assert_eq!(english("66.2 mm/s at 3.9 s 的 M (kN m/m)", &[]), [""; 0]);
    assert_eq!(below("<h2>甲</h2>one<h3>乙.<wbr>丙</h3>two</section>three", "乙.丙"), ">乙.<wbr>丙</h3>two");
}
