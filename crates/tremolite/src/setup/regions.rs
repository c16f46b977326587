//! Which elements are made of what.

use super::groups::nothing_fits;
use std::sync::Arc;
use tremolite_case::{Case, Diagnostic, Element, Fill, Material, Region, Spanned, pattern};
use tremolite_engine::Body;
use tremolite_engine::extent::extents;
use tremolite_engine::hexahedra::{centroid, hex};
use tremolite_kernels::{AnyMaterial, Law, Layers, Quadrature};
use tremolite_laws::band::Band;
use tremolite_mesh::Mesh;

/// A body for each solid region. Every element must belong to exactly one region.
pub fn build(
    case: &Case,
    mesh: &Mesh,
    laws: &[Law],
    band: Option<Band>,
    problems: &mut Vec<Diagnostic>,
) -> Vec<Body> {
    let mut region_of: Vec<Option<usize>> = vec![None; mesh.elements.len()];
    for (r, region) in case.regions.iter().enumerate() {
        for pattern in &region.groups {
            let mut fits = false;
            for (name, elements) in &mesh.groups {
                if !pattern::matches(pattern, name) {
                    continue;
                }
                fits = true;
                let before = elements.iter().find_map(|&e| region_of[e as usize].filter(|&first| first != r));
                if let Some(first) = before {
                    let earlier = case.regions[first].groups.iter().map(|g| g.value.as_str());
                    let earlier: Vec<&str> = earlier.collect();
                    problems.push(Diagnostic::at(
                        pattern,
                        format!("elements of '{name}' are in the region of {} already", earlier.join(", ")),
                        "let each element be in one region only",
                    ));
                    continue;
                }
                elements.iter().for_each(|&e| region_of[e as usize] = Some(r));
            }
            if !fits {
                problems.push(nothing_fits(mesh, pattern));
            }
        }
    }
    report_unassigned(case, mesh, &region_of, problems);

    let mut bodies = Vec::new();
    for (r, region) in case.regions.iter().enumerate() {
        let Fill::Solid { material, .. } = &region.fill else { continue };
        let elements: Vec<u32> =
            (0u32..).zip(&region_of).filter(|(_, of)| **of == Some(r)).map(|(e, _)| e).collect();
        let material = &case.materials[material.value];
        bodies.extend(body(case, mesh, region, material, elements, laws, band, problems));
    }
    bodies
}

/// A region's elements, or some of them, as a body of a material.
pub fn body(
    case: &Case,
    mesh: &Mesh,
    region: &Region,
    material: &Material,
    elements: Vec<u32>,
    laws: &[Law],
    band: Option<Band>,
    problems: &mut Vec<Diagnostic>,
) -> Option<Body> {
    let Fill::Solid { element, through, viscosity, .. } = &region.fill else { return None };
    let law = laws.iter().find(|l| l.info.name == material.law.value)?;
    if let Some(b) = viscosity.as_ref().filter(|b| b.value > MOST_VISCOSITY) {
        problems.push(Diagnostic::at(
            b,
            format!("a viscosity of {} of critical damping is more than any ringing needs", b.value),
            "give at most 0.5; 0.06 is usual",
        ));
    }
    let element = match element {
        Some(word) => word.value,
        None => generated(case, mesh, region).or_else(|| {
            problems.push(Diagnostic::new(
                region.span.clone(),
                "a region that is not of generated linings or shotcrete alone must say how its elements are integrated",
                "write element = \"reduced-integration\" for rock; \"layered\" for linings one element thick, \"full-integration\" for others",
            ));
            None
        })?,
    };
    let quadrature = match element {
        Element::OnePoint => Quadrature::OnePoint,
        Element::Full => Quadrature::Full,
        Element::Layered => Quadrature::Layered(layers(through.as_ref(), problems)),
    };
    let built = match band {
        Some(band) => (law.build_banded)(&material.parameters, band),
        None => (law.build)(&material.parameters),
    };
    match built {
        Ok(built) => {
            problems.extend(oversized(case, mesh, &elements, material, &built));
            Some(Body {
                name: name(mesh, region, &material.name.value),
                elements,
                material: built,
                density: material.density.value,
                quadrature,
                viscosity: match viscosity {
                    Some(given) => given.value,
                    None if law.info.damages => DAMAGING_VISCOSITY,
                    None => 0.0,
                },
            })
        }
        // The case has checked the values, so this is a law that changes its mind.
        Err(bad) => {
            problems.extend(bad.into_iter().map(|b| {
                Diagnostic::new(material.span.clone(), format!("{} {}", b.name, b.problem), b.remedy)
            }));
            None
        }
    }
}

/// How linings and shotcrete are integrated that the case's own generator makes, alone in a region; none of other groups.
fn generated(case: &Case, mesh: &Mesh, region: &Region) -> Option<Element> {
    let tremolite_case::Mesh::Caverns(made) = &case.mesh else { return None };
    let layers = |group: &String| {
        let mut parts = group.split('.');
        let cavern = parts.next().and_then(|name| made.caverns.iter().find(|c| c.name.value == name))?;
        match parts.next()? {
            "lining" => cavern.lining.as_ref().map(|lining| lining.layers.value),
            "shotcrete" => cavern.shotcrete.as_ref().map(|shotcrete| shotcrete.layers.value),
            _ => None,
        }
    };
    let fits = |name: &&String| region.groups.iter().any(|pattern| pattern::matches(pattern, name));
    let layers: Option<Vec<u32>> = mesh.groups.keys().filter(fits).map(layers).collect();
    let most = layers?.into_iter().max()?;
    Some(if most == 1 { Element::Layered } else { Element::Full })
}

/// Points through the thickness, as many as there are rules for.
fn layers(given: Option<&Spanned<u32>>, problems: &mut Vec<Diagnostic>) -> Layers {
    let Some(given) = given else { return Layers::default() };
    Layers::ALL.into_iter().find(|layers| layers.count() == given.value as usize).unwrap_or_else(|| {
        let message = format!("there are no elements with {} points through their thickness", given.value);
        problems.push(Diagnostic::at(given, message, "write 7, 9 or 13"));
        Layers::default()
    })
}

/// Artificial viscosity of bodies whose law damages: pieces between cracks would ring undamped at the mesh's frequencies. The
/// usual choice of explicit programs, and an assumption.
const DAMAGING_VISCOSITY: f64 = 0.06;
/// More leaves less than two thirds of the step.
const MOST_VISCOSITY: f64 = 0.5;

/// Groups by which a body is called; of more it is called by its material.
const CALLED_BY: usize = 3;

/// What a region's body is called: its groups, or its material with the first of many.
fn name(mesh: &Mesh, region: &Region, material: &str) -> String {
    match &groups(mesh, region)[..] {
        [first, more @ ..] if more.len() >= CALLED_BY => {
            format!("{material} ({first} and {} more groups)", more.len())
        }
        few => few.join(", "),
    }
}

/// The groups that a region's patterns fit, without those that others of them hold.
pub fn groups<'m>(mesh: &'m Mesh, region: &Region) -> Vec<&'m str> {
    let fits = |name: &str| region.groups.iter().any(|pattern| pattern::matches(pattern, name));
    let groups: Vec<(&String, &Vec<u32>)> = mesh.groups.iter().filter(|(name, _)| fits(name)).collect();
    let held = |k: usize| {
        let (_, inner) = groups[k];
        groups.iter().enumerate().any(|(j, (_, outer))| {
            let larger = outer.len() > inner.len() || (outer.len() == inner.len() && j < k);
            larger && inner.iter().all(|e| outer.binary_search(e).is_ok())
        })
    };
    (0..groups.len()).filter(|&k| !held(k)).map(|k| groups[k].0.as_str()).collect()
}

/// A limit of size \[m\] below this is no concrete's: 1 m and more is.
const LEAST_SIZE: f64 = 0.1;

/// The refusal of elements that store more energy than a crack or a band of shear across them takes.
fn oversized(
    case: &Case,
    mesh: &Mesh,
    elements: &[u32],
    material: &Material,
    law: &Arc<dyn AnyMaterial>,
) -> Option<Diagnostic> {
    let limit = law.size_limit();
    if limit == f64::INFINITY {
        return None;
    }
    let mut count = 0;
    let mut worst = (limit, None);
    for &element in elements {
        // An element without a usable shape is refused by the model.
        let Ok(hex) = hex(mesh, element as usize) else { continue };
        let [_, extent] = extents(&hex);
        if extent >= limit {
            count += 1;
            if extent >= worst.0 {
                worst = (extent, Some(element));
            }
        }
    }
    let (extent, Some(element)) = worst else { return None };
    // The smallest group says most about where it is.
    let group = mesh.groups.iter().filter(|(_, e)| e.contains(&element)).min_by_key(|(_, e)| e.len());
    let place = group.map_or(String::new(), |(name, _)| format!(" of '{name}'"));
    let others =
        if count > 1 { format!(", and {} others are too large as well", count - 1) } else { String::new() };
    let [x, y, z] = centroid(mesh, element);
    let cracks = law.info().damages;
    let remedy = match (cracks, limit < LEAST_SIZE) {
        (true, true) => {
            "the limit is 2 G_f E/f_t²: E or G_f looks too low, or f_t too high, by its unit".to_owned()
        }
        (true, false) => {
            format!(
                "{}; or give that energy up: `ultimate_strain_ratio` in place of `fracture_energy`, with evolution = \"residual\"; what \
                 a crack takes then grows with the element; or judge an elastic lining by `[[section]]`",
                finer(case, limit, extent)
            )
        }
        (false, _) => {
            let factor = (10.0 * extent / limit).floor() / 10.0 + 0.1;
            let longer = format!("the plastic displacements of the softening {factor:.1} times as long");
            match limit < LEAST_SIZE {
                true => format!("give {longer}"),
                false => format!("{}; or give {longer}", mesh_finer(case, limit)),
            }
        }
    };
    // What is too large is the generator's size, where there is one.
    let span = match &case.mesh {
        tremolite_case::Mesh::Caverns(caverns) if cracks && limit >= LEAST_SIZE => caverns.near.span.clone(),
        _ => material.span.clone(),
    };
    Some(Diagnostic::new(
        span,
        format!(
            "element {}{place} at ({x:.1}, {y:.1}, {z:.1}) m extends over {extent:.2} m{others}; with this material's \
             {} elements must stay below {} m, or a {} would release more than it takes",
            mesh.element_id(element as usize),
            if cracks { "fracture energy" } else { "softening" },
            if limit < LEAST_SIZE { format!("{limit:.1e}") } else { format!("{limit:.2}") },
            if cracks { "crack" } else { "band of shear" }
        ),
        remedy,
    ))
}

/// How elements of concrete become small enough, of which the largest now has this extent \[m\].
fn finer(case: &Case, limit: f64, extent: f64) -> String {
    let below = below(limit);
    match &case.mesh {
        // Round a vault elements are larger than the size that is asked for, by the same share in a finer mesh; along it there is an even
        // number of them.
        tremolite_case::Mesh::Caverns(caverns) => {
            let near = (100.0 * caverns.near.value * (limit / extent).min(1.0) - 1.0).floor() / 100.0;
            let pairs = (0.5 * caverns.length.value / below).ceil();
            let along = (100.0 * 0.5 * caverns.length.value / pairs).floor() / 100.0;
            format!(
                "give `size_near` {near} m and `size_along` {along} m, or more layers of lining where it is thick"
            )
        }
        _ => mesh_finer(case, limit),
    }
}

/// A size \[m\] below a limit, rounded down to centimetres, so that it holds as it is written.
fn below(limit: f64) -> f64 {
    (100.0 * limit - 1.0).floor() / 100.0
}

/// How elements of rock become smaller than a limit \[m\].
pub(super) fn mesh_finer(case: &Case, limit: f64) -> String {
    let below = below(limit);
    match &case.mesh {
        // Elements of the generator may be a little larger than what is asked for.
        tremolite_case::Mesh::Caverns(_) => {
            format!("give `size_near`, `size_far` and `size_along` {:.2} m or less", 0.9 * below)
        }
        tremolite_case::Mesh::Box(_) => format!("give more `elements` along the axes, for {below} m or less"),
        tremolite_case::Mesh::File(_) => format!("mesh it with {below} m or less"),
    }
}

fn report_unassigned(case: &Case, mesh: &Mesh, region_of: &[Option<usize>], problems: &mut Vec<Diagnostic>) {
    let count = region_of.iter().filter(|r| r.is_none()).count();
    if count == 0 {
        return;
    }
    let groups: Vec<&str> = mesh
        .groups
        .iter()
        .filter(|(_, elements)| elements.iter().any(|&e| region_of[e as usize].is_none()))
        .map(|(name, _)| name.as_str())
        .collect();
    let place = case.regions.last().map_or(case.title.span.clone(), |r| r.span.clone());
    let message = format!("{count} elements belong to no region; they are in {}", groups.join(", "));
    problems.push(Diagnostic::new(
        place,
        message,
        "add a [[region]] with these groups; material = \"void\" if they are excavated",
    ));
}
