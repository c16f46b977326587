//! Driving laws along paths: mixed control, names, refusals.

use crate::common::concrete::*;
use tremolite_laws::path::{Control, Path, PathError, drive, drive_named};
use tremolite_laws::{Material, Values};

fn rock() -> Values {
    Values::default().with("young", 10e9).with("poisson", 0.25)
}

#[test]
fn prescribed_stresses_are_met_with_the_elastic_strain() {
    let target = [-3e6, 1e6, -2e6, 0.5e6, -0.25e6, 0.1e6];
    let path = Path {
        time: vec![0.0; 2],
        values: vec![[0.0; 6], target],
        control: [Control::Stress; 6],
        size: None,
    };
    let response = drive_named("elastic", &rock(), &path).unwrap();
    let trace = target[0] + target[1] + target[2];
    for k in 0..6 {
        let exact = if k < 3 { (1.25 * target[k] - 0.25 * trace) / 10e9 } else { 2.5 * target[k] / 10e9 };
        assert!((response.strain[1][k] - exact).abs() <= 1e-12 * 3e-4, "{k}");
        assert!((response.stress[1][k] - target[k]).abs() <= 1e-12 * 3e6, "{k}");
    }
}

#[test]
fn triaxial_test_at_constant_cell_pressure_peaks_at_mohr_coulomb() {
    for confinement in [1e6, 5e6] {
        let strength = fc() + slope() * confinement;
        let axial = (strength - 2.0 * POISSON * confinement) / YOUNG;
        let mut values = vec![[-confinement, -confinement, -confinement, 0.0, 0.0, 0.0]];
        // The first row is the cell pressure alone: its axial strain is the elastic one.
        values[0][0] = elastic_strain([-confinement; 3])[0];
        let steps = 400;
        for e in ramp(values[0][0], -axial * 0.9999, steps) {
            values.push([e, -confinement, -confinement, 0.0, 0.0, 0.0]);
        }
        let mut control = [Control::Stress; 6];
        control[0] = Control::Strain;
        let path = Path { time: vec![0.0; values.len()], values, control, size: None };
        let response = drive(&concrete(&[]), &path).unwrap();
        let last = response.stress.last().unwrap();
        assert_eq!(*response.column("d_shear").unwrap().last().unwrap(), 0.0);
        assert!((-last[0] / strength - 1.0).abs() < 2e-4, "{} {strength}", last[0]);
        assert!((last[1] + confinement).abs() < 1e-6 * confinement);
    }
}

#[test]
fn columns_are_found_by_name() {
    let response = uniaxial(&concrete(&[]), &[0.0, 2.0 * THRESHOLD], None);
    assert!(response.column("d_tension").unwrap()[1] > 0.9);
    assert!(response.column("no such thing").is_none());
    assert_eq!(response.columns.len(), response.history.len());
}

#[test]
fn what_cannot_be_followed_is_refused_with_the_row() {
    let law = concrete(&[]);
    let still = [0.0; 6];
    let refuse = |path: &Path| drive(&law, path).unwrap_err();
    assert_eq!(
        refuse(&Path::strains(vec![0.0], vec![still, still])),
        PathError::Lengths { time: 1, values: 2 }
    );
    let nan = [f64::NAN, 0.0, 0.0, 0.0, 0.0, 0.0];
    assert_eq!(refuse(&Path::strains(vec![0.0, 1.0], vec![still, nan])), PathError::NotFinite { row: 1 });
    assert_eq!(refuse(&Path::strains(vec![1.0, 0.0], vec![still, still])), PathError::Time { row: 1 });
    assert_eq!(drive(&law, &Path::strains(vec![], vec![])).unwrap().stress.len(), 0);

    let with_energy = values().with("fracture_energy", 130.0);
    let mut path = Path::strains(vec![0.0], vec![still]);
    let run = |path: &Path| drive_named("concrete-damage", &with_energy, path);
    assert_eq!(run(&path).unwrap_err(), PathError::SizeMissing);
    for size in [0.0, -1.0, 5.0, f64::NAN, f64::INFINITY] {
        path.size = Some(size);
        assert!(matches!(run(&path), Err(PathError::Size { .. })), "{size}");
    }
    path.size = Some(0.5);
    assert!(run(&path).is_ok());

    let unknown = drive_named("concrete", &with_energy, &path).unwrap_err();
    assert!(unknown.to_string().contains("concrete-damage"), "{unknown}");
    let bad = drive_named("elastic", &Values::default(), &path).unwrap_err();
    assert!(matches!(bad, PathError::Parameters(_)) && bad.to_string().contains("young"));

    // More tension than there is: no strain gives it.
    let beyond = Path {
        time: vec![0.0; 2],
        values: vec![still, [2.0 * FT, 0.0, 0.0, 0.0, 0.0, 0.0]],
        control: [Control::Stress; 6],
        size: None,
    };
    assert!(matches!(drive(&law, &beyond), Err(PathError::NotConverged { row: 1, .. })));
    assert_eq!(tremolite_laws::materials::Concrete::NAME, "concrete-damage");
}
