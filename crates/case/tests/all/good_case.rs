//! Good cases are read into the values they state, in SI.

use std::path::Path;

use tremolite_case::*;
use tremolite_laws::materials::MATERIALS;
use tremolite_laws::parameter::Values;

const EVERY_KEY: &str = include_str!("../cases/every-key.toml");
const FIRST_SHAKE: &str = include_str!("../../../../cases/first-shake/case.toml");

fn read(source: &str) -> Case {
    Case::parse(Path::new("study/case.toml"), source, MATERIALS).unwrap_or_else(|e| panic!("{e}"))
}

#[test]
fn every_value_arrives_in_si() {
    let case = read(EVERY_KEY);
    assert_eq!(case.title.value, "every key");
    assert_eq!(case.source, EVERY_KEY);
    assert_eq!(
        case.defaulted.iter().map(|d| d.key.as_str()).collect::<Vec<_>>(),
        [
            "mesh.caverns.cavern[transformer].at",
            "mesh.caverns.cavern[transformer].length",
            "mesh.caverns.cavern[transformer].benches",
            "mesh.caverns.cavern[transformer].lining",
            "mesh.caverns.cavern[transformer].shotcrete",
            "mesh.plane[fault].seam",
            "reinforcement[1].face",
            "reinforcement[1].young",
            "reinforcement[1].yield",
            "reinforcement[2].yield",
            "section[1].bar_diameter",
            "dynamic.base.side_springs",
            "monitor[free].body",
        ]
    );
    assert_eq!(case.warnings, []);

    let Mesh::Caverns(mesh) = &case.mesh else { panic!("caverns") };
    assert_eq!((mesh.near.value, mesh.far.value), (1.2, 10.0));
    assert_eq!(mesh.along.as_ref().map(|a| a.value), Some(2.0));
    let [powerhouse, transformer] = &mesh.caverns[..] else { panic!("two caverns") };
    assert_eq!((powerhouse.width.value, powerhouse.height.value), (17.0, 37.2));
    assert_eq!((powerhouse.at.value, powerhouse.benches.value), ([1.0, -2.0], 6));
    let length = powerhouse.length.as_ref().expect("a length");
    assert_eq!((length.length.value, length.middle.value, &transformer.length), (40.0, -1.5, &None));
    let lining = powerhouse.lining.as_ref().expect("a lining");
    assert_eq!((lining.walls.value, lining.crown.value, lining.floor.value), (0.5, 0.9, 0.3));
    assert_eq!(lining.layers.value, 2);
    let shotcrete = powerhouse.shotcrete.as_ref().expect("shotcrete");
    assert_eq!((shotcrete.thickness.value, shotcrete.layers.value), (0.15, 2));
    assert_eq!((transformer.at.value, &transformer.lining), ([0.0, 0.0], &None));
    assert_eq!([powerhouse.shape.value, transformer.shape.value], [CavernShape::Arch, CavernShape::Ellipse]);
    let [weathered, sound] = &mesh.layers[..] else { panic!("two layers") };
    assert_eq!((weathered.name.value.as_str(), weathered.depth.value), ("weathered", 0.0));
    assert_eq!((sound.depth.value, sound.dip.value), (30.0, 12_f64.to_radians()));
    // From x towards y: x points 30 deg east of north, and the layer falls towards 300 deg.
    assert!((sound.dip_direction.value - (-270_f64).to_radians()).abs() < 1e-12);
    let [busbar] = &mesh.galleries[..] else { panic!("a gallery") };
    assert_eq!(busbar.between.each_ref().map(|b| b.value.as_str()), ["powerhouse", "transformer"]);
    assert_eq!((busbar.at.value, busbar.width.value, busbar.height.value), ([5.0, 14.0], 4.0, 3.5));
    let heights = GroundSurface::Heights { x: vec![-50.0, 50.0], y: vec![0.0], heights: vec![10.0, -5.0] };
    assert_eq!(mesh.ground, Some(heights));

    assert_eq!(case.initial.gravity.value, 10.0);
    let [rock, concrete] = &case.materials[..] else { panic!("two materials") };
    assert_eq!((rock.name.value.as_str(), rock.density.value), ("rock", 2700.0));
    assert_eq!((concrete.name.value.as_str(), concrete.density.value), ("concrete", 2752.0));
    assert_eq!(rock.parameters, Values::default().with("young", 10e9).with("poisson", 0.25));
    assert_eq!(concrete.parameters, Values::default().with("young", 25e9).with("poisson", 0.17));

    let fills: Vec<Option<(usize, Element, Option<f64>)>> = case
        .regions
        .iter()
        .map(|r| match &r.fill {
            Fill::Void => None,
            Fill::Solid { material, element, viscosity, .. } => {
                Some((material.value, element.as_ref()?.value, viscosity.as_ref().map(|b| b.value)))
            }
        })
        .collect();
    let expected = [Some((0, Element::OnePoint, Some(0.02))), Some((1, Element::Layered, Some(0.0))), None];
    assert_eq!(fills, expected);
    assert!(case.regions[0].holds("transformer.bench3") && !case.regions[0].holds("powerhouse.bench3"));

    let [rings, along, given] = &case.reinforcement[..] else { panic!("three sets of bars") };
    assert_eq!(rings.name.as_ref().map(|n| n.value.as_str()), Some("rings"));
    assert_eq!(rings.on.iter().map(|p| p.value.as_str()).collect::<Vec<_>>(), ["*.lining"]);
    assert_eq!((rings.area.value, rings.cover.value), (1.57e-3, 0.05));
    assert_eq!((rings.direction.value, rings.face.value), (BarDirection::Across, BarFace::Intrados));
    assert_eq!(rings.young.value, 210e9);
    assert_eq!(rings.yields.as_ref().map(|y| y.value), Some(500e6));
    assert_eq!(rings.breaks.as_ref().map(|b| b.value), Some(0.05));
    assert_eq!((along.area.value, along.face.value, along.young.value), (1.57e-3, BarFace::Both, 200e9));
    assert_eq!((&along.name, &along.yields, &along.breaks), (&None, &None, &None));
    assert_eq!((given.area.value, given.direction.value), (3e-3, BarDirection::Along));

    let dynamic = &case.dynamic;
    let Base::ViscousSpring { normal, tangential, distance, side_springs: false } = &dynamic.base.value
    else {
        panic!("spring")
    };
    let distance = distance.as_ref().map(|d| d.value);
    assert_eq!((normal.value, tangential.value, distance), (1.5, 0.5, Some(100.0)));
    assert_eq!(dynamic.sides.each_ref().map(|s| s.value), [Side::Viscous, Side::Roller]);
    assert_eq!(dynamic.top.value, Top::Viscous);
    assert_eq!((dynamic.rayleigh.mass.value, dynamic.rayleigh.stiffness.value), (0.3, 1e-4));
    assert_eq!(dynamic.time_step.as_ref().map(|t| t.value), Some(50e-6));
    assert_eq!((dynamic.duration.as_ref().map(|t| t.value), dynamic.safety.value), (Some(19.5), 0.8));
    assert_eq!(dynamic.levels.value, 3);

    assert_eq!(case.monitors[0].at.value, Place::Named("powerhouse.crown".to_owned()));
    assert_eq!(case.monitors[1].at.value, Place::Point([0.0, 1.0, -210.0]));
    assert_eq!(case.relatives[0].between, [1, 0]);
    assert_eq!((case.output.histories.value, case.output.snapshots.as_ref()), (0.02, None));
    assert_eq!(case.output.checkpoint.as_ref().map(|c| c.value), Some(3600.0));
    let fields: Vec<&str> = case.output.fields.iter().map(|f| f.value.as_str()).collect();
    assert_eq!(fields, ["displacement", "s1"]);
}

#[test]
fn the_motion_arrives_with_its_records_and_the_places_of_its_steps() {
    let case = read(EVERY_KEY);
    let motion = case.motion.as_ref().expect("an earthquake");
    assert_eq!(motion.kind.value, MotionKind::Within);
    assert_eq!(motion.depth.as_ref().map(|d| d.value), Some(50.0));
    let Some(Site::Layers(layers)) = &motion.site else { panic!("layers") };
    let [soil, gravel] = &layers[..] else { panic!("two layers") };
    // 19 kN/m³ at the case's 10 m/s².
    let damping = |layer: &SiteLayer| match &layer.softening {
        Softening::None(damping) => damping.value,
        other => panic!("{other:?}"),
    };
    assert_eq!((soil.thickness.value, soil.density.value, damping(soil)), (8.0, 1900.0, 0.05));
    assert_eq!((gravel.density.value, damping(gravel)), (2100.0, 0.02));
    // c_p/c_s = √(2 (1 − ν)/(1 − 2ν)) = √3.5
    assert!((gravel.compression_wave_velocity() / 600.0 - 3.5_f64.sqrt()).abs() < 1e-12);
    assert_eq!(motion.window.as_ref().map(|w| w.value), Some(Window::Between(20.5, 40.0)));
    assert_eq!(motion.model_x_azimuth.value, 30_f64.to_radians());
    let steps: Vec<&str> = motion.processing.iter().map(|s| &case.source[s.span.clone()]).collect();
    assert_eq!(steps, ["\"detrend linear\"", "\"scale 0.35\""]);
    let Records::Components(components) = &motion.records else { panic!("components") };
    let [Some(Component::Record(east)), Some(Component::Record(north)), Some(up)] = &**components else {
        panic!("three components")
    };
    assert_eq!(case.resolve(&east.file.value), Path::new("study/a.txt"));
    assert_eq!(east.units.as_ref().map(|u| u.value), Some(RecordUnit::Acceleration(0.01)));
    assert_eq!(east.dt.as_ref().map(|t| t.value), Some(0.005));
    let sensitivity = east.sensitivity.as_ref().map(|s| s.value.as_str());
    assert_eq!((sensitivity, &motion.sensitivity), (Some("4e5 counts/(m/s2)"), &None));
    assert_eq!(east.channel.as_ref().map(|c| c.value.as_str()), Some("EW"));
    let columns: Vec<TextColumn> = north.columns.iter().map(|c| c.value).collect();
    assert_eq!(columns, [TextColumn::Time, TextColumn::Acceleration]);
    let Component::Scaled { from, factor } = up else { panic!("scaled") };
    assert_eq!((from.value, factor.value), (Direction::East, 0.667));
}

#[test]
fn the_other_kinds_of_mesh_are_read() {
    let (before, rest) = EVERY_KEY.split_once("[mesh.caverns]").expect("caverns");
    let (_, after) = rest.split_once("[material.rock]").expect("a material");
    let axis = "{ to = \"50 m\", elements = 10 }";
    let source = format!(
        "{before}[mesh.box]\nx = {axis}\ny = {axis}\nz = {{ from = \"-1 m\", to = \"1 m\", elements = 4, growth = 1.2 }}\n\
         [material.rock]{after}"
    );
    let Mesh::Box(mesh) = read(&source).mesh else { panic!("a box") };
    let [x, _, z] = &mesh.axes;
    assert_eq!((x.from.value, x.to.value, x.elements.value, x.growth.value), (0.0, 50.0, 10, 1.0));
    assert_eq!((z.from.value, z.to.value, z.elements.value, z.growth.value), (-1.0, 1.0, 4, 1.2));
    assert_eq!(mesh.group.value, "rock");

    let source = format!(
        "{before}[mesh.file]\npath = \"site.msh\"\nunit = \"1 mm\"\nrotate = \"-20 deg\"\n[material.rock]{after}"
    );
    let Mesh::File(file) = read(&source).mesh else { panic!("a file") };
    assert_eq!((file.path.value.as_path(), file.unit.value), (Path::new("site.msh"), 0.001));
    assert_eq!(file.rotate.value, -20_f64.to_radians());
    let case = read(&source.replace("\nrotate = \"-20 deg\"", ""));
    let Mesh::File(file) = &case.mesh else { panic!("a file") };
    assert_eq!(file.rotate.value, 0.0);
    assert!(case.defaulted.iter().any(|d| d.key == "mesh.file.rotate" && d.value == "0 deg"));
}

#[test]
fn ground_and_shape_take_their_other_forms() {
    let (before, rest) = EVERY_KEY.split_once("x = [\"-50 m\"").expect("the ground");
    let (_, after) = rest.split_once("[material.rock]").expect("a material");
    let source = format!("{before}slope = [\"10 deg\", \"0 deg\"]\n[material.rock]{after}");
    let source =
        source.replace("shape = \"ellipse\"", "shape = \"rectangle\"").replace("arch_rise = \"2.2 m\"\n", "");
    let Mesh::Caverns(mesh) = read(&source).mesh else { panic!("caverns") };
    let Some(GroundSurface::Slope(slope)) = mesh.ground else { panic!("a slope") };
    assert_eq!(slope.value, [10_f64.to_radians(), 0.0]);
    assert_eq!((mesh.caverns[1].shape.value, mesh.caverns[1].arch_rise.value), (CavernShape::Rectangle, 0.0));
}

#[test]
fn words_stand_for_bases_and_sides() {
    for (word, base) in [("viscous", Base::Viscous), ("fixed", Base::Fixed), ("free", Base::Free)] {
        let source = EVERY_KEY.replace(
            "{ kind = \"viscous-spring\", normal = 1.5, tangential = 0.5, distance = \"100 m\" }",
            &format!("\"{word}\""),
        );
        let case = read(&source);
        assert_eq!(case.dynamic.base.value, base);
        assert!(case.defaulted.iter().all(|d| !d.key.starts_with("dynamic.base")));
        assert_eq!(case.warnings.len(), usize::from(word == "free"), "only a free base is warned of");
    }
    let case = read(&EVERY_KEY.replace("{ x = \"viscous\", y = \"roller\" }", "\"periodic\""));
    assert_eq!(case.dynamic.sides.each_ref().map(|s| s.value), [Side::Periodic, Side::Periodic]);
    let case = read(&EVERY_KEY.replace("\"viscous\", y = \"roller\"", "\"free-field\", y = \"symmetry\""));
    assert_eq!(case.dynamic.sides.each_ref().map(|s| s.value), [Side::FreeField, Side::Symmetry]);
    let words = case.dynamic.sides.each_ref().map(|s| &case.source[s.span.clone()]);
    assert_eq!(words, ["\"free-field\"", "\"symmetry\""]);
    let case = read(&EVERY_KEY.replace("top = \"viscous\"\n", ""));
    assert_eq!(case.dynamic.top.value, Top::Free);
    assert!(case.defaulted.iter().any(|d| d.key == "dynamic.top" && d.value == "free"));
}

#[test]
fn what_is_left_out_takes_its_default_and_is_listed() {
    let source = FIRST_SHAKE.split("[output]").next().expect("text before the output");
    let case = read(source);
    let listed = |key: &str| case.defaulted.iter().find(|d| d.key == key).map(|d| d.value.as_str());
    assert_eq!(listed("initial.gravity"), Some("9.81 m/s2"));
    assert_eq!(case.initial.gravity.value, 9.81);
    assert_eq!(listed("dynamic.base.normal"), Some("1.33"));
    let Base::ViscousSpring { normal, .. } = &case.dynamic.base.value else { panic!("spring") };
    assert_eq!(normal.value, 1.33);
    assert_eq!(listed("dynamic.damping.rayleigh.stiffness"), Some("0 s"));
    assert_eq!(listed("dynamic.duration"), Some("the length of the processed motion"));
    assert_eq!(listed("output.histories"), Some("0.01 s"));
    assert_eq!(case.output.histories.value, 0.01);
    assert_eq!(case.output.checkpoint.map(|c| c.value), Some(600.0));
}

#[test]
fn windows_line_ends_and_a_byte_order_mark_change_nothing_but_places() {
    let plain = read(FIRST_SHAKE);
    let source = format!("\u{feff}{}", FIRST_SHAKE.replace('\n', "\r\n"));
    let case = read(&source);
    assert_eq!(case.defaulted, plain.defaulted);
    let text =
        |c: &Case| c.monitors.iter().map(|m| c.source[m.at.span.clone()].to_owned()).collect::<Vec<_>>();
    assert_eq!(text(&case), text(&plain));
}

#[test]
fn the_example_reads_without_a_warning() {
    let case = read(FIRST_SHAKE);
    assert_eq!(case.warnings, []);
    assert_eq!(case.monitors.iter().map(|m| m.name.value.as_str()).collect::<String>(), "ABCDEF");
    let motion = case.motion.expect("an earthquake");
    assert_eq!(motion.window.map(|w| w.value), Some(Window::Strongest(15.0)));
    assert!(matches!(motion.records, Records::File(_)));
    // 27 kN/m³ at 9.81 m/s²
    assert_eq!(case.materials[0].density.value, 27_000.0 / 9.81);
}

#[test]
fn a_body_is_a_group_or_stands_behind_a_dot() {
    let case = read(EVERY_KEY);
    let monitor = &case.monitors[0];
    for group in ["lining", "powerhouse.lining", "powerhouse.lining.crown"] {
        assert!(monitor.lies_in(group), "{group}");
    }
    for group in ["rock", "prelining", "powerhouse.relining"] {
        assert!(!monitor.lies_in(group), "{group}");
    }
    assert!(case.monitors[1].lies_in("rock"), "no body: any group");
}
