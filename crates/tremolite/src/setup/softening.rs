//! Warnings of softening ground whose bands the mesh does not resolve.

use super::regions::mesh_finer;
use tremolite_case::{self as case, Case, Diagnostic};
use tremolite_engine::Body;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::hex;
use tremolite_laws::Softens;
use tremolite_mesh::Mesh;

/// Elements over V_s t_g up to which the slip of a softening layer under a pulse stays within about 5 % of its limit (`docs/laws.md`).
const RESOLVED: f64 = 1.0 / 3.0;

/// Of bodies that soften over displacement in an earthquake, or in elements too large for their relaxation time.
pub fn warnings(case: &Case, mesh: &Mesh, bodies: &[Body]) -> Vec<Diagnostic> {
    let regions = case.regions.iter().filter(|r| matches!(r.fill, case::Fill::Solid { .. }));
    regions.zip(bodies).filter_map(|(region, body)| of_body(case, mesh, region, body)).collect()
}

fn of_body(case: &Case, mesh: &Mesh, region: &case::Region, body: &Body) -> Option<Diagnostic> {
    case.motion.as_ref()?;
    match body.material.softens() {
        // The law itself warns of softening over strain.
        Softens::Never | Softens::OverStrain => None,
        Softens::OverDisplacement => Some(Diagnostic::new(
            region.span.clone(),
            format!(
                "'{}' softens over displacement: its slip depends on the element size where several rows yield together",
                body.name
            ),
            "compare with elements of half the size, or give `plastic_shear_strain` and relaxation_time = \"1 ms\"",
        )),
        Softens::Relaxing(growth) => {
            let (_, shear) = body.material.moduli().wave_speeds(body.density);
            let limit = RESOLVED * shear * growth;
            let extent = |&e: &u32| hex(mesh, e as usize).ok().map(|hex| extents(&hex)[1]);
            let larger: Vec<f64> = body.elements.iter().filter_map(extent).filter(|&h| h > limit).collect();
            let largest = larger.iter().copied().fold(0.0, f64::max);
            (!larger.is_empty()).then(|| {
                Diagnostic::new(
                    region.span.clone(),
                    format!(
                        "elements of '{}' that do not resolve a softening band: {}, up to {largest:.2} m (limit {limit:.2} m, \
                         V_s τ μ/(3 |H|)); its slip depends on their size",
                        body.name,
                        larger.len()
                    ),
                    format!(
                        "{}; or multiply `relaxation_time` by {:.1}",
                        mesh_finer(case, limit),
                        (10.0 * largest / limit).ceil() / 10.0
                    ),
                )
            })
        }
    }
}
