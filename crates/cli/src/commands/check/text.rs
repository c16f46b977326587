//! What is said of a case, for people.

use super::Lines;
use super::bolts::print_bolts;
use super::judged::print_judged;
use super::stages::print_stages;
use crate::terminal::{bytes, duration, print};
use tremolite::engine::{Proof, TRIED};
use tremolite::job::Checked;
use tremolite::job::defaulted::text;
use tremolite::setup::MotionFacts;
use tremolite::survey::Survey;
use tremolite_case::{Dynamic, Mesh, units};
use tremolite_laws::Dimension;
use tremolite_results::{MaterialFacts, Origin};

/// Four digits: more would say more than is known.
fn rounded(x: f64) -> f64 {
    format!("{x:.3e}").parse().unwrap_or(x)
}

pub(super) fn print_lines(checked: &Checked, lines: Lines) {
    let survey = &checked.job.survey;
    let case = &checked.job.case;
    let units = if case.bare_si { " (units = \"SI\": numbers without a unit are in SI)" } else { "" };
    print(&format!("{}{units}", case.title.value));
    print(&format!(
        "\nMesh       {} elements ({} excavated), {} nodes",
        survey.active_elements, survey.void_elements, survey.nodes
    ));
    match lines {
        Lines::Deciding => print(&format!("           in {} groups", checked.job.groups.len())),
        Lines::All => {
            let groups = checked.job.groups.iter();
            groups.for_each(|(name, elements)| print(&format!("           {name:28} {elements:>8}")));
        }
    }
    print_rotation(checked);
    print_materials(checked, lines);
    print_interfaces(checked);
    print_pairs(checked);
    print_bolts(checked);
    print_stages(checked, lines);
    if let Some(motion) = &checked.job.motion {
        print_boundaries(checked);
        print_shaking(checked, motion);
    }
    print_judged(checked);
    print_estimate(checked);
    match (checked.left_out.len(), lines) {
        (0, _) => {}
        (_, Lines::All) => {
            print("\nLeft out, and taken as");
            checked.left_out.iter().for_each(|d| print(&format!("           {} = {}", d.key, d.value)));
        }
        (count, Lines::Deciding) => {
            print(&format!(
                "\n{count} keys are left out: `check --verbose` says what they are taken as, with groups, stages and constants"
            ));
        }
    }
}

fn print_rotation(checked: &Checked) {
    if let Mesh::File(file) = &checked.job.case.mesh
        && file.rotate.value != 0.0
    {
        // With the digits that it was written with.
        let angle = checked.job.case.source[file.rotate.span.clone()].trim_matches(['"', '\'']);
        print(&format!(
            "           turned by {angle} about z; coordinates, stresses, results and model_x_azimuth are in the axes after it"
        ));
    }
}

fn print_boundaries(checked: &Checked) {
    let Dynamic { base, sides: [x, y], top, .. } = &checked.job.case.dynamic;
    print("\nBoundaries in the earthquake");
    print(&format!(
        "           base {}; sides across x {}, across y {}; top {}",
        base.value.word(),
        x.value.word(),
        y.value.word(),
        top.value.word()
    ));
    let Survey { slab_elements: slabs, column_elements: columns, active_elements, .. } = checked.job.survey;
    if slabs > 0 {
        let share = 100.0 * (slabs + columns) as f64 / active_elements as f64;
        print(&format!(
            "           outside the free-field sides stand {slabs} elements of slabs and {columns} of columns, {share:.1} % of the model's"
        ));
    }
}

fn print_shaking(checked: &Checked, motion: &MotionFacts) {
    let survey = &checked.job.survey;
    print("\nMotion");
    print(&format!("           {}", motion.source));
    let [from, to] = motion.window;
    print(&format!("           {from:.2} to {to:.2} s of the record are used"));
    for (k, line) in motion.entering().iter().enumerate() {
        let kind = if k == 0 { format!("kind = {}: ", motion.kind) } else { String::new() };
        print(&format!("           {kind}{line}"));
    }
    let given = motion.intensity.each_ref().map(|m| [m.pga, m.pgv, m.pgd]);
    let enters = motion.incident.map(|p| [p.acceleration, p.velocity, p.displacement]);
    for (what, axes) in [("given", given), ("enters", enters)] {
        for (peaks, name) in axes.into_iter().zip(["x", "y", "z"]) {
            print(&format!("           {what} along {name}: {}", peaks_in_words(peaks)));
        }
    }
    if let Some(displacement) = motion.design_displacement {
        print(&format!(
            "           design displacement of the target, 0.025 a_g S T_C T_D: d_g {} m",
            figures(displacement)
        ));
    }
    if let Some(coarsest) = survey.coarsest().filter(|_| motion.highest_frequency > 0.0) {
        print(&format!(
            "           99.9 % of its energy lies below {:.1} Hz: {:.1} elements a shear wave there (8 or more is good); fewest in {}",
            motion.highest_frequency, coarsest.per_wavelength, checked.coarsest
        ));
    }
    print("\nTime step");
    print(&format!("           {:.4e} s stable, set by {}", checked.job.stable.dt, checked.set_by));
    if let Some(impacts) = &checked.impacts {
        print(&format!("           {impacts}"));
    }
    print(&format!(
        "           {:.4e} s used, {} steps for {:.2} s",
        checked.job.dt, checked.job.steps.total, checked.job.plan.duration
    ));
    if let [_, _, ..] = &checked.job.phase.elements_of_level[..] {
        print_levels(checked);
    }
}

/// Who makes longer steps than that.
fn print_levels(checked: &Checked) {
    let phase = &checked.job.phase;
    let all = phase.counted_elements as f64;
    let shares: Vec<String> = phase
        .elements_of_level
        .iter()
        .enumerate()
        .map(|(level, &count)| format!("{:.1} % {}", 100.0 * count as f64 / all, 1 << level))
        .collect();
    print(&format!(
        "           of the elements step {} times as long: {:.2} evaluations a step of each, where one level has 1",
        shares.join(", "),
        phase.evaluated_elements / all
    ));
    print(&format!(
        "           the surroundings of borders between them were tried for {TRIED} of the longest steps: no motion grows by {:.1} % a step",
        100.0 * Proof::smallest_growth()
    ));
}

fn print_estimate(checked: &Checked) {
    print("\nEstimate");
    print(&format!(
        "           about {} with {} threads and {} ({:.1} million element updates a second), {} of memory, {:.1} kB an element",
        duration(checked.seconds()),
        checked.threads,
        checked.job.model.scheme.isa.name(),
        checked.updates_per_second() / 1e6,
        bytes(checked.job.survey.bytes),
        1e-3 * checked.job.survey.bytes as f64 / checked.job.phase.counted_elements.max(1) as f64
    ));
    if checked.cycles() > 0 {
        let rest = if checked.job.motion.is_some() {
            format!(" of them {}", duration(checked.stage_seconds()))
        } else {
            String::new()
        };
        print(&format!(
            "          {rest} for the stages, if they take {} cycles as models of this size did",
            checked.cycles()
        ));
    }
    print_disk(checked);
}

fn print_disk(checked: &Checked) {
    let disk = checked.disk;
    let bytes = |n: u64| bytes(usize::try_from(n).unwrap_or(usize::MAX));
    print(&format!(
        "           at most {} on disk: {} field files of {}, histories of {}{}, a checkpoint of {} while it runs",
        bytes(disk.total()),
        disk.field_files + disk.stage_files,
        bytes(disk.field_file),
        bytes(disk.histories),
        if disk.bolts > 0 { format!(", bolts {}", bytes(disk.bolts)) } else { String::new() },
        bytes(disk.checkpoint)
    ));
}

fn print_interfaces(checked: &Checked) {
    if checked.interfaces.is_empty() {
        return;
    }
    print("\nInterfaces");
    let stiffness = |k: f64| match k {
        k if k >= 1e8 => format!("{} GPa/m", rounded(k / 1e9)),
        k => format!("{} MPa/m", rounded(k / 1e6)),
    };
    let pressure = |p: f64| units::format(rounded(p), Dimension::PRESSURE);
    for (name, interface) in &checked.interfaces {
        let ends = match interface.ends {
            0 => "no ends inside the model".to_owned(),
            n => format!("at {n} nodes, where it meets linings or its own ends, it cannot slide"),
        };
        print(&format!(
            "           {name}: {}, {} pairs over {:.1} m2, {ends}",
            interface.law, interface.pairs, interface.area
        ));
        let chosen = match (interface.chosen, &checked.job.motion) {
            (true, Some(_)) => ", chosen by the mesh and the step",
            (true, None) => ", chosen",
            (false, _) => "",
        };
        let straight = if interface.straight_from.is_nan() {
            String::new()
        } else {
            format!(", straight from {}", pressure(interface.straight_from))
        };
        print(&format!(
            "             normal stiffness {}{chosen}; closes by {} mm at 1 MPa{straight}",
            stiffness(interface.normal_stiffness),
            rounded(1e3 * interface.closure_at_1_mpa)
        ));
        let case = &checked.job.case;
        let plane = case.ground.planes.iter().find(|plane| plane.name.value == *name);
        if let Some((seam, stand)) =
            plane.and_then(|p| Some((p.seam.as_ref()?, p.seam.as_ref()?.stand(&case.materials)?)))
        {
            print(&format!(
                "             a seam of {}, {} thick, less than half an element: {} normal to it, E(1 - nu)/((1 + nu)(1 - 2 nu)) over its thickness, \
                 {} in shear, G over it; of its rock a bond of {}, gone once it breaks, {} in tension, friction {}",
                seam.material.value,
                units::format(seam.thickness.value, Dimension::LENGTH),
                stiffness(stand.normal),
                stiffness(stand.shear),
                pressure(stand.cohesion),
                pressure(stand.tension),
                rounded(stand.friction)
            ));
        }
    }
}

fn print_pairs(checked: &Checked) {
    for (name, pair) in &checked.pairs {
        let [x, y, z] = pair.at;
        let [mx, my, mz] = pair.normal;
        print(&format!(
            "           monitor {name}: the pair at node {} at ({x:.2}, {y:.2}, {z:.2}) m of {}, m = ({mx:.3}, {my:.3}, {mz:.3})",
            pair.node, pair.interface
        ));
    }
}

fn print_materials(checked: &Checked, lines: Lines) {
    print("\nMaterials");
    for (name, facts) in &checked.job.materials {
        print(&format!("           {name}: {}, {}", facts.law, facts.summary));
        for group in &facts.groups {
            let body = checked.job.survey.bodies.iter().find(|b| b.name == group.names);
            let shaken = body.filter(|_| checked.job.motion.is_some());
            let step = shaken.map_or(String::new(), |b| match b.drained_step {
                Some(drained) => {
                    format!(", could run at {:.3e} s (at {drained:.3e} s drained)", b.element_step)
                }
                None => format!(", could run at {:.3e} s", b.element_step),
            });
            let names = if lines == Lines::All { group.names.clone() } else { brief(&group.names) };
            print(&format!("             {} {} in {names}{step}", group.elements, group.element));
        }
        let MaterialFacts { density, wave_speed_p: p, wave_speed_s: s, damping, .. } = facts;
        let waves = format!(", c_p {p:.0} m/s, c_s {s:.0} m/s; damping: {damping}");
        let waves = if checked.job.motion.is_some() { waves } else { String::new() };
        print(&format!("             {density:.0} kg/m3{waves}"));
        let of = |name: &str| facts.values.iter().find(|value| value.name == name).map(|value| value.value);
        if let [Some(b), Some(bulk), Some(speed)] =
            ["skempton_coefficient", "undrained_bulk_modulus", "undrained_wave_speed_p"].map(of)
        {
            let bulk = units::format(rounded(bulk), Dimension::PRESSURE);
            print(&format!(
                "             undrained: B {b:.3}, K_u {bulk}, c_p {speed:.0} m/s where there is water"
            ));
        }
        let constants = [("parameters", false), ("derived", true)];
        for (words, derived) in constants.into_iter().take(if lines == Lines::All { 2 } else { 1 }) {
            let values = facts.values.iter().filter(|v| (v.origin == Origin::Derived) == derived);
            let values: Vec<String> = values.map(|v| format!("{} {}", v.name, text(v))).collect();
            if !values.is_empty() {
                print(&format!("             {words}: {}", values.join(", ")));
            }
        }
    }
}

/// The first of many names.
fn brief(names: &str) -> String {
    let all: Vec<&str> = names.split(", ").collect();
    match all.len() {
        0..=4 => names.to_owned(),
        count => format!("{} and {} groups more", all[..3].join(", "), count - 3),
    }
}

/// Largest acceleration, velocity and displacement along an axis.
fn peaks_in_words([a, v, u]: [f64; 3]) -> String {
    match a > 0.0 {
        true => format!("PGA {} m/s2, PGV {} m/s, PGD {} m", figures(a), figures(v), figures(u)),
        false => "nothing".to_owned(),
    }
}

/// A number to three figures, however small.
fn figures(value: f64) -> String {
    let power = if value > 0.0 { value.log10().floor() } else { 0.0 };
    if power < -5.0 {
        return format!("{value:.2e}");
    }
    format!("{value:.*}", (2.0 - power).max(0.0) as usize)
}
