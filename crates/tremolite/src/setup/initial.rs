//! The stress in the ground before anything moves.

use tremolite_case::{Case, InitialStress, MeasuredStress};
use tremolite_engine::hexahedra::centroid;
use tremolite_mesh::Mesh;
use tremolite_mesh::overburden::weight_above;

/// A stress that is linear over height.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Linear {
    /// m
    height: f64,
    /// xx, yy, zz, xy, yz, zx \[Pa\] at that height, and their change per metre of z.
    stress: [f64; 6],
    gradient: [f64; 6],
}

impl Linear {
    fn at(&self, z: f64) -> [f64; 6] {
        [0, 1, 2, 3, 4, 5].map(|c| self.stress[c] + self.gradient[c] * (z - self.height))
    }
}

/// Tensors that differ in height by less than this \[m\] say nothing of a change with it.
const LEVEL: f64 = 1e-3;

/// The straight line over height nearest to measured tensors, component by component; their mean where all were measured at
/// one height.
fn regression(measured: &[MeasuredStress]) -> Linear {
    let count = measured.len() as f64;
    let height = measured.iter().map(|m| m.at[2]).sum::<f64>() / count;
    let square: f64 = measured.iter().map(|m| (m.at[2] - height).powi(2)).sum();
    let stress = [0, 1, 2, 3, 4, 5].map(|c| measured.iter().map(|m| m.stress[c]).sum::<f64>() / count);
    let slope = |c: usize| measured.iter().map(|m| (m.at[2] - height) * m.stress[c]).sum::<f64>() / square;
    let gradient = if square > LEVEL * LEVEL { [0, 1, 2, 3, 4, 5].map(slope) } else { [0.0; 6] };
    Linear { height, stress, gradient }
}

/// How far measured tensors lie from their straight line: root of the mean square of each component \[Pa\].
pub fn residuals(measured: &[MeasuredStress]) -> [f64; 6] {
    let line = regression(measured);
    [0, 1, 2, 3, 4, 5].map(|c| {
        let square = |m: &MeasuredStress| (m.stress[c] - line.at(m.at[2])[c]).powi(2);
        (measured.iter().map(square).sum::<f64>() / measured.len() as f64).sqrt()
    })
}

/// Stress \[Pa\] of every element of a mesh, of which no two stand at one place; `unit_weight` \[N/m³\] is that of what is there
/// at the start, 0 for void. Horizontal stresses are ratios of effective ones where `pore` has the pressures \[Pa\] in pores.
pub fn stresses(
    case: &Case,
    stress: &InitialStress,
    mesh: &Mesh,
    unit_weight: &[f64],
    pore: &[f64],
) -> Vec<[f64; 6]> {
    let centres: Vec<[f64; 3]> = (0..mesh.elements.len() as u32).map(|e| centroid(mesh, e)).collect();
    let linear = match stress {
        InitialStress::Lateral { x, y, .. } => {
            let above = case.initial.overburden.as_ref().map_or(0.0, |p| p.value);
            let vertical = weight_above(mesh, unit_weight, &centres);
            return vertical
                .into_iter()
                .enumerate()
                .map(|(e, weight)| {
                    let vertical = -(weight + above);
                    let p = pore.get(e).copied().unwrap_or(0.0);
                    let lateral = |ratio: f64| ratio * vertical - (1.0 - ratio) * p;
                    [lateral(x.value), lateral(y.value), vertical, 0.0, 0.0, 0.0]
                })
                .collect();
        }
        InitialStress::Field(field) => {
            Linear { height: field.at[2], stress: field.stress, gradient: field.gradient }
        }
        InitialStress::Measured(measured) => regression(measured),
    };
    centres.iter().map(|centre| linear.at(centre[2])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(z: f64, zz: f64, xy: f64) -> MeasuredStress {
        MeasuredStress { at: [3.0, -2.0, z], stress: [0.0, 0.0, zz, xy, 0.0, 0.0], span: 0..0 }
    }

    #[test]
    fn measured_tensors_on_a_line_give_the_line_and_others_what_is_left() {
        let all =
            [measured(-100.0, -2.7e6, 1e5), measured(-200.0, -5.4e6, 2e5), measured(-300.0, -8.1e6, 3e5)];
        let line = regression(&all);
        assert!((line.at(-400.0)[2] + 10.8e6).abs() < 1.0 && (line.at(0.0)[3]).abs() < 1e-6);
        assert!(residuals(&all).iter().all(|r| *r < 1e-6));
        let off = [all[0].clone(), measured(-200.0, -5.4e6 + 3e5, 2e5), all[2].clone()];
        let left = residuals(&off);
        assert!((left[2] - 3e5 * (2.0_f64 / 3.0 / 3.0).sqrt()).abs() < 1.0, "{left:?}");
        let level = [measured(-50.0, -1e6, 0.0), measured(-50.0, -2e6, 0.0)];
        assert_eq!(regression(&level).at(-500.0)[2], -1.5e6);
    }
}
