//! What is said of bolts, for people.

use crate::terminal::print;
use std::path::Path;
use tremolite::bolts::BoltSet;
use tremolite::job::Checked;
use tremolite_results::{BoltSummary, EARTHQUAKE};

/// Writes the straight bolts of each group, as they were cut: x1,y1,z1,x2,y2,z2 in m to a
/// micrometre, head first.
pub(super) fn write(folder: &Path, sets: &[BoltSet]) -> Result<(), String> {
    let said = |path: &Path, e: std::io::Error| format!("{} cannot be written: {e}", path.display());
    std::fs::create_dir_all(folder).map_err(|e| said(folder, e))?;
    for set in sets {
        let mut text = String::from("x1,y1,z1,x2,y2,z2\n");
        for bolt in &set.bolts {
            let along = || bolt.points.iter();
            let head = along().min_by(|a, b| a.at.total_cmp(&b.at));
            let tail = along().max_by(|a, b| a.at.total_cmp(&b.at));
            let (Some(head), Some(tail)) = (head, tail) else { continue };
            let numbers: Vec<String> =
                head.place.iter().chain(&tail.place).map(|x| format!("{x:.6}")).collect();
            text += &(numbers.join(",") + "\n");
        }
        let plain = |c: char| if c.is_alphanumeric() || "-_ .".contains(c) { c } else { '_' };
        let name: String = set.kind.name.chars().map(plain).collect();
        let path = folder.join(format!("{name}.csv"));
        std::fs::write(&path, text).map_err(|e| said(&path, e))?;
    }
    Ok(())
}

pub(super) fn print_bolts(checked: &Checked) {
    if checked.bolts.is_empty() {
        return;
    }
    // Reinforcement stands behind all bolts.
    let bolts = checked.bolts.len().saturating_sub(checked.job.plan.bars);
    for (heading, skipped, count) in [("Bolts", 0, bolts), ("Bars", bolts, usize::MAX)] {
        let own = || checked.bolts.iter().skip(skipped).take(count);
        if own().next().is_some() {
            print(&format!("\n{heading}"));
        }
        for (name, group) in own() {
            group_in_words(name, group).iter().for_each(|line| print(line));
        }
    }
    for (name, bolt) in &checked.bolt_monitors {
        let [x, y, z] = bolt.at;
        print(&format!(
            "           monitor {name}: bolt {} of {}, {:.2} m from its head, at ({x:.2}, {y:.2}, {z:.2}) m",
            bolt.bolt, bolt.group, bolt.from_head
        ));
    }
}

fn group_in_words(name: &str, group: &BoltSummary) -> Vec<String> {
    let BoltSummary { bolts, given, shortened, left_out, crossings, length, segments, .. } = group;
    let placed = match group.placed.as_str() {
        "" => "there from the start".to_owned(),
        EARTHQUAKE => "placed for the earthquake".to_owned(),
        stage => format!("placed in '{stage}'"),
    };
    let bond = if group.bonded { "slide along a bond" } else { "follow what they lie in" };
    let yields = match group.yield_force.is_finite() {
        true => format!("yield at {:.0} kN", group.yield_force / 1e3),
        false => "never yield".to_owned(),
    };
    let tension = match group.pretension {
        t if t > 0.0 => format!(", pretension {:.0} kN", t / 1e3),
        _ => String::new(),
    };
    let mut lines = vec![
        format!("           {name}: {bolts} of {length:.1} m in all, {placed}; {segments} segments"),
        format!("             {bond}, {yields}{tension}"),
    ];
    let counts = [
        (*left_out, "left out, since they begin in no ground that stands then"),
        (*shortened, "shortened, since they run into a void or out of the model"),
    ];
    let cut = counts.iter().filter(|(count, _)| *count > 0).map(|(count, what)| format!("{count} {what}"));
    let mut cut: Vec<String> = cut.collect();
    if !cut.is_empty() {
        cut.insert(0, format!("of {given} given"));
        lines.push(format!("             {}", cut.join("; ")));
    }
    if *crossings > 0 {
        lines.push(format!("             they cross interfaces at {crossings} places"));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_group_is_told_with_what_was_cut_of_it() {
        let group = BoltSummary {
            bolts: 238,
            given: 240,
            left_out: 2,
            shortened: 5,
            crossings: 3,
            length: 1421.25,
            segments: 2380,
            placed: "bench 1".into(),
            bonded: true,
            yield_force: 1.96e5,
            pretension: 5e4,
            ..BoltSummary::default()
        };
        let text = group_in_words("crown", &group).join("\n");
        for part in [
            "crown: 238 of 1421.2 m in all, placed in 'bench 1'; 2380 segments",
            "slide along a bond, yield at 196 kN, pretension 50 kN",
            "of 240 given; 2 left out, since",
            "; 5 shortened, since",
            "cross interfaces at 3 places",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        let whole = BoltSummary {
            bolts: 4,
            given: 4,
            length: 24.0,
            segments: 40,
            yield_force: f64::NAN,
            pretension: 0.0,
            ..BoltSummary::default()
        };
        let lines = group_in_words("bars", &whole);
        assert_eq!(lines.len(), 2);
        assert!(
            lines[0].contains("there from the start")
                && lines[1].ends_with("follow what they lie in, never yield")
        );
    }
}
