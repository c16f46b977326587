//! Draws how near concrete comes to tests: `cargo run --release -p tremolite-cli --example test_figures`, some minutes.
//!
//! The runs are those of `tremolite verify l_panel half_notched_beam mixed_mode_beam askew_crack`; the figures go to docs/laws, and
//! every curve as CSV to the folder that is named behind, if one is.

use std::borrow::Cow;
use std::path::{Path as File, PathBuf};
use tremolite::Quadrature;
use tremolite_report::loops::{Curve, Loops, Named, Plane, Quantity};
use tremolite_verify::VerifyError;
use tremolite_verify::problems::{half_notched_beam, mixed_mode_beam};
use tremolite_verify::specimen::beams::{Beam, HALF_NOTCHED, MIXED};
use tremolite_verify::specimen::l_panel::{self, Lie, MIX};
use tremolite_verify::specimen::{BAND, Mix, PLATEAU, Reading, STRESS, Tested, Words, measured, steps};

/// A curve by its name: pairs of lengths \[m\] and forces \[N\].
type Drawn = (String, Vec<[f64; 2]>);

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/laws");
    let csv = std::env::args().nth(1).map(PathBuf::from);
    let figures = [
        ("test-l-panel", "L-shaped panel (Winkler 2001): force over the way of its arm", "way", panel()?),
        (
            "test-half-notched",
            "Half-notched beam (Grégoire et al. 2013): force over the opening of the notch",
            "opening",
            half_notched()?,
        ),
        (
            "test-mixed-mode",
            "Notch beside the load (García-Álvarez et al. 2012): columns upright, and leaning by 20 to 40°",
            "opening",
            mixed()?,
        ),
    ];
    for (name, title, along, planes) in figures {
        if let Some(csv) = &csv {
            std::fs::create_dir_all(csv)?;
            for (curve, rows) in planes.iter().flatten() {
                let mut text = format!("{along} [m],force [N]\n");
                rows.iter().for_each(|[x, y]| text += &format!("{x:.7},{y:.1}\n"));
                let word: String =
                    curve.chars().map(|c| if c.is_alphanumeric() || c == '.' { c } else { '-' }).collect();
                std::fs::write(csv.join(format!("{name}-{word}.csv")), text)?;
            }
        }
        std::fs::write(folder.join(format!("{name}.svg")), draw(title, along, planes))?;
    }
    Ok(())
}

/// Two planes of curves, those of tests first and in one colour.
fn draw(title: &str, along: &str, planes: [Vec<Drawn>; 2]) -> String {
    let planes = planes.into_iter().map(|curves| {
        let mut colour = 0;
        let curves = curves.into_iter().map(|(name, rows)| {
            let test = name.starts_with("test");
            colour += usize::from(!test);
            let (across, up): (Vec<f64>, Vec<f64>) = rows.into_iter().map(|[x, y]| (x, y)).unzip();
            let colour = if test { 0 } else { colour };
            Curve { name, colour, across: Cow::from(across), up: Cow::from(up), points: test }
        });
        let (across, up) = (Quantity::new(along, "m"), Quantity::new("force", "N"));
        Plane { across, up, curves: curves.collect(), named: Named::Nothing }
    });
    Loops {
        title: title.into(),
        along: Quantity::new("", ""),
        time: &[],
        planes: planes.collect(),
        tracks: vec![],
        states: None,
    }
    .draw()
}

/// Rows of a curve in millimetres.
fn test<const N: usize>(name: &str, curve: &[[f64; N]], column: usize) -> Drawn {
    (name.into(), curve.iter().map(|row| [1e-3 * row[0], row[column]]).collect())
}

fn run(name: &str, tested: &Tested, across: fn(&Reading) -> f64, most: f64) -> Drawn {
    let rows = tested.readings.iter().map(|r| [across(r), r.force]);
    (name.into(), rows.filter(|row| row[0] <= most).collect())
}

fn panel() -> Result<[Vec<Drawn>; 2], VerifyError> {
    let drive = |name: &str, size: f64, lie: Lie, mix: Mix, words: &'static Words, quadrature| {
        let plate = l_panel::plate(size, lie);
        let mut ways = l_panel::ways(0.02e-3);
        if std::ptr::eq(words, PLATEAU) {
            ways.splice(0..1, steps(&[(0.05e-3, 5e-6)]));
        }
        let tested = l_panel::test(&plate, mix, words, quadrature, l_panel::ramp(size), ways)?;
        Ok::<_, VerifyError>(run(name, &tested, |r| r.way, 1.01e-3))
    };
    let measured = || test("test", measured::L_PANEL, 1);
    let turn = 20f64.to_radians();
    Ok([
        vec![
            measured(),
            drive("25 mm", 0.025, Lie::Along, MIX, BAND, Quadrature::Full)?,
            drive("10 mm", 0.01, Lie::Along, MIX, BAND, Quadrature::Full)?,
            drive("5 mm", 0.005, Lie::Along, MIX, BAND, Quadrature::Full)?,
            drive("plateau 25 mm", 0.025, Lie::Along, MIX, PLATEAU, Quadrature::Full)?,
            drive("plateau 10 mm", 0.01, Lie::Along, MIX, PLATEAU, Quadrature::Full)?,
            test("embedded cracks", measured::EMBEDDED_CRACKS, 1),
            test("phase field", measured::PHASE_FIELD, 1),
        ],
        vec![
            measured(),
            drive("one point", 0.01, Lie::Along, MIX, BAND, Quadrature::OnePoint)?,
            drive("rows up by 20°", 0.01, Lie::Turned(-turn), MIX, BAND, Quadrature::Full)?,
            drive("rows down by 20°", 0.01, Lie::Turned(turn), MIX, BAND, Quadrature::Full)?,
            drive("by 45°", 0.01, Lie::Diamonds, MIX, BAND, Quadrature::Full)?,
            drive("G_f 117 N/m", 0.01, Lie::Along, Mix { energy: 117.0, ..MIX }, BAND, Quadrature::Full)?,
        ],
    ])
}

fn half_notched() -> Result<[Vec<Drawn>; 2], VerifyError> {
    let beam = HALF_NOTCHED;
    let drive = |name: &str, size: f64, mix: Mix, words, quadrature| {
        let plate = beam.plate(size, [0.01; 2]);
        let tested =
            beam.test(&plate, mix, words, quadrature, Beam::ramp(size), half_notched_beam::ways())?;
        Ok::<_, VerifyError>(run(name, &tested, |r| r.opening, 0.21e-3))
    };
    let tests = || [1, 2].map(|column| test(["test", "test 2"][column - 1], measured::HALF_NOTCHED, column));
    let mut meshes = Vec::from(tests());
    for (name, size) in [("5 mm", 5e-3), ("2.5 mm", 2.5e-3), ("1.25 mm", 1.25e-3)] {
        meshes.push(drive(name, size, beam.mix, BAND, Quadrature::Full)?);
    }
    let mut others = Vec::from(tests());
    others.push(drive("one point", 2.5e-3, beam.mix, BAND, Quadrature::OnePoint)?);
    others.push(drive("G_f 96 N/m", 2.5e-3, Mix { energy: 96.0, ..beam.mix }, BAND, Quadrature::Full)?);
    others.push(drive("driver stress", 2.5e-3, beam.mix, STRESS, Quadrature::Full)?);
    Ok([meshes, others])
}

fn mixed() -> Result<[Vec<Drawn>; 2], VerifyError> {
    let drive = |name: &str, size: f64, lean: f64| {
        let reach = mixed_mode_beam::REACH;
        let upright = lean == 0.0;
        let plate =
            if upright { MIXED.plate(size, reach) } else { MIXED.turned(size, reach, lean.to_radians()) };
        let ways = mixed_mode_beam::ways();
        let tested = MIXED.test(&plate, MIXED.mix, BAND, Quadrature::Full, Beam::ramp(size), ways)?;
        Ok::<_, VerifyError>(run(name, &tested, |r| r.opening, 0.21e-3))
    };
    let tests = || [1, 2].map(|column| test(["test", "test 2"][column - 1], measured::MIXED, column));
    let mut upright = Vec::from(tests());
    upright.push(drive("5 mm", 5e-3, 0.0)?);
    upright.push(drive("2.5 mm", 2.5e-3, 0.0)?);
    let mut leaning = Vec::from(tests());
    for (name, lean) in [("20°", 20.0), ("30°", 30.0), ("40°", 40.0)] {
        leaning.push(drive(name, 5e-3, lean)?);
    }
    Ok([upright, leaning])
}
