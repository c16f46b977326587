//! What the elements of a mesh are made of, as far as the time step goes: moduli, density, quadrature.

use tremolite::{Body, Layers, Quadrature};
use tremolite_case::{pattern, units};
use tremolite_laws::Moduli;
use tremolite_laws::parameter::Dimension;
use tremolite_mesh::Mesh;

/// How `--material` is written, for its messages.
const EXAMPLE: &str = "\"rock*: E = 10 GPa, nu = 0.25, density = 2752 kg/m3\"";

/// One material and the elements made of it.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeOf {
    /// As the user wrote it, or the groups of a case's region.
    pub name: String,
    /// The stiffest that it can show.
    pub moduli: Moduli,
    /// kg/m³
    pub density: f64,
    pub quadrature: Quadrature,
    /// Indices into the mesh's elements, ascending.
    pub elements: Vec<u32>,
}

impl MadeOf {
    /// Part of a case.
    pub fn body(body: &Body) -> Self {
        MadeOf {
            name: body.name.clone(),
            moduli: body.material.stiffest(),
            density: body.density,
            quadrature: body.quadrature,
            elements: body.elements.clone(),
        }
    }

    /// Speed of P waves \[m/s\].
    pub fn p_wave(&self) -> f64 {
        self.moduli.wave_speeds(self.density).0
    }
}

/// The rock that stands in where no material is given: that of the paper's section 3 (`wang2018`).
pub fn stand_in(mesh: &Mesh) -> Vec<MadeOf> {
    vec![MadeOf {
        name: "assumed rock".into(),
        moduli: Moduli::from_young_poisson(10e9, 0.25),
        density: 2752.0,
        quadrature: Quadrature::OnePoint,
        elements: (0..mesh.elements.len() as u32).collect(),
    }]
}

/// The materials of the options `--material`, on the groups that they name. Where several fit an element the last counts.
///
/// # Errors
/// What cannot be read in an option, or a pattern that fits no group, with the way out.
pub fn options(mesh: &Mesh, options: &[String]) -> Result<Vec<MadeOf>, String> {
    let mut of = vec![None; mesh.elements.len()];
    let mut all = Vec::new();
    for (k, option) in options.iter().enumerate() {
        // A group's name may hold a colon; the values hold none.
        let Some((groups, values)) = option.rsplit_once(':') else {
            return Err(format!("--material \"{option}\" names no group; write {EXAMPLE}"));
        };
        let groups = groups.trim();
        let (moduli, density, quadrature) =
            read(values).map_err(|problem| format!("--material \"{option}\": {problem}; write {EXAMPLE}"))?;
        let mut fits = false;
        for (_, elements) in mesh.groups.iter().filter(|(name, _)| pattern::matches(groups, name)) {
            fits = true;
            elements.iter().for_each(|&e| of[e as usize] = Some(k));
        }
        if !fits {
            let known: Vec<&str> = mesh.groups.keys().map(String::as_str).collect();
            return Err(format!(
                "--material \"{option}\": no group of the mesh fits '{groups}'; it has {}",
                known.join(", ")
            ));
        }
        all.push(MadeOf { name: groups.to_owned(), moduli, density, quadrature, elements: Vec::new() });
    }
    for (e, of) in (0..).zip(&of) {
        if let Some(k) = of {
            all[*k].elements.push(e);
        }
    }
    all.retain(|made| !made.elements.is_empty());
    Ok(all)
}

/// The values of one material.
fn read(text: &str) -> Result<(Moduli, f64, Quadrature), String> {
    let (mut young, mut poisson, mut density, mut quadrature) = (None, None, None, Quadrature::OnePoint);
    for part in text.split(',').map(str::trim).filter(|p| !p.is_empty()) {
        let Some((key, value)) = part.split_once('=') else {
            return Err(format!("`{part}` is no KEY = VALUE"));
        };
        let (key, value) = (key.trim(), value.trim());
        let number = |dimension| {
            units::parse(value, dimension)
                .map_err(|e| format!("`{key}` {} ({})", e.message(key), e.remedy(key)))
        };
        let place = match key {
            "E" | "young" => (&mut young, number(Dimension::PRESSURE)?),
            "nu" | "poisson" => (&mut poisson, number(Dimension::NONE)?),
            "density" => (&mut density, number(Dimension::DENSITY)?),
            "element" => {
                quadrature = match value {
                    "reduced-integration" => Quadrature::OnePoint,
                    "full-integration" => Quadrature::Full,
                    "layered" => Quadrature::Layered(Layers::default()),
                    _ => {
                        return Err(format!(
                            "`element` is {value}, expected reduced-integration, full-integration or layered"
                        ));
                    }
                };
                continue;
            }
            _ => return Err(format!("there is no `{key}`; known are E, nu, density and element")),
        };
        if place.0.replace(place.1).is_some() {
            return Err(format!("`{key}` is given twice"));
        }
    }
    let needed = |value: Option<f64>, key: &str| value.ok_or_else(|| format!("`{key}` is missing"));
    let (young, poisson, density) =
        (needed(young, "E")?, needed(poisson, "nu")?, needed(density, "density")?);
    if !(young > 0.0 && density > 0.0) {
        return Err("E and density must be positive".into());
    }
    if !(0.0..0.5).contains(&poisson) {
        return Err("nu is at least 0 and below 0.5".into());
    }
    Ok((Moduli::from_young_poisson(young, poisson), density, quadrature))
}

#[cfg(test)]
mod tests {
    use super::*;
    use tremolite_mesh::boxes::BoxSpec;

    fn mesh() -> Mesh {
        let mut mesh = BoxSpec::uniform([0.0; 3], [4.0, 1.0, 1.0], [4, 1, 1]).mesh().unwrap();
        mesh.groups.clear();
        mesh.groups.insert("rock".into(), vec![0, 1, 2, 3]);
        mesh.groups.insert("hall: lining".into(), vec![1, 2]);
        mesh
    }

    #[test]
    fn materials_go_to_the_groups_that_they_name_and_the_last_counts() {
        let options = [
            "*: E = 10 GPa, nu = 0.25, density = 2.752 t/m3".to_owned(),
            "hall: lin*: poisson=0.17,young=25e9 Pa,density=2400 kg/m3,element=full-integration".to_owned(),
        ];
        let made = super::options(&mesh(), &options).unwrap();
        assert_eq!(
            (made[0].elements.as_slice(), made[1].elements.as_slice()),
            ([0, 3].as_slice(), [1, 2].as_slice())
        );
        // c_p = √((λ + 2μ)/ρ), with λ = μ = 4 GPa at ν = ¼.
        assert!((made[0].p_wave() - (12e9_f64 / 2752.0).sqrt()).abs() < 1e-9);
        assert_eq!((made[1].quadrature, made[1].density), (Quadrature::Full, 2400.0));
    }

    #[test]
    fn what_cannot_be_meant_is_refused_with_the_way_out() {
        for (option, words) in [
            ("E = 10 GPa, nu = 0.25, density = 2752 kg/m3", "names no group"),
            (
                "rok: E = 10 GPa, nu = 0.25, density = 2752 kg/m3",
                "no group of the mesh fits 'rok'; it has hall: lining",
            ),
            (
                "rock: E = 10 m, nu = 0.25, density = 2752 kg/m3",
                "is a length (`m`), a stress or modulus is expected",
            ),
            ("rock: E = 10, nu = 0.25, density = 2752 kg/m3", "has no unit"),
            ("rock: E = 10 GPa, nu = 0.5, density = 2752 kg/m3", "below 0.5"),
            ("rock: E = -1 GPa, nu = 0.2, density = 2752 kg/m3", "must be positive"),
            ("rock: E = 10 GPa, nu = 0.2", "`density` is missing"),
            ("rock: E = 10 GPa, E = 11 GPa, nu = 0.2", "given twice"),
            ("rock: E = 10 GPa, mu = 0.2", "there is no `mu`"),
            ("rock: stiff", "is no KEY = VALUE"),
        ] {
            let problem = options(&mesh(), &[option.to_owned()]).unwrap_err();
            assert!(problem.contains(words), "{problem}");
        }
    }
}
