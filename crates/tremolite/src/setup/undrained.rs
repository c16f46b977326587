//! Rock whose water cannot leave its pores in the earthquake: Biot's modulus, and what no rock can have.
//!
//! 1/M = n/K_w + (α − n)/K_s with the grains' K_s = K/(1 − α), or M = BK/(α(1 − αB)) by Skempton's coefficient; K_u = K + α²M and
//! B = αM/K_u (`detournay1993`, `skempton1954`). K is that of the law at rest.

use tremolite_case::{Case, Diagnostic, Earthquake, Material, MaterialWater, Pores};
use tremolite_engine::Body;
use tremolite_laws::{Dimension, Moduli};
use tremolite_results::{MaterialValue, Origin};

/// Pa: what hardly any rock is stiffer than, grains and all.
const STIFFEST_GRAINS: f64 = 60e9;

/// Name of the value c_v of a material, which it has where its permeability is given.
pub const DIFFUSIVITY: &str = "diffusivity";
/// What the values of a material say that water in its pores has: B, K_u, the speed of P waves, c_v.
pub const MEANINGS: [&str; 4] = [
    "share of a pressure all round that water takes where it cannot leave",
    "K + α²M, with water that cannot leave its pores",
    "speed of P waves where water was in the pores as the earthquake began",
    "c_v of the water in its pores: a pressure goes √(c_v T) far in the time T",
];

/// Whether water cannot leave its pores in a case's earthquake.
pub fn is_undrained(case: &Case) -> bool {
    case.water.as_ref().is_some_and(|water| water.earthquake.value == Earthquake::Undrained)
}

/// A rock with water that cannot leave its pores.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Undrained {
    /// M \[Pa\]
    pub modulus: f64,
    /// K_u \[Pa\]
    pub bulk: f64,
    /// B
    pub skempton: f64,
    /// K_s \[Pa\], infinite with α = 1.
    pub grains: f64,
}

impl Undrained {
    /// From what a case says of the pores and the moduli that the law has at rest; none where the earthquake is drained.
    pub fn of(case: &Case, pores: &Pores, moduli: Moduli) -> Option<Self> {
        let water = case.water.as_ref().filter(|_| is_undrained(case))?;
        let (alpha, bulk) = (pores.biot.value, moduli.lambda + 2.0 / 3.0 * moduli.mu);
        let grains = if alpha < 1.0 { bulk / (1.0 - alpha) } else { f64::INFINITY };
        let modulus = match (&pores.porosity, &pores.skempton) {
            (Some(n), _) => 1.0 / (n.value / water.bulk_modulus.value + (alpha - n.value) / grains),
            (None, Some(b)) => b.value * bulk / (alpha * (1.0 - alpha * b.value)),
            (None, None) => return None,
        };
        let undrained = bulk + alpha * alpha * modulus;
        Some(Undrained { modulus, bulk: undrained, skempton: alpha * modulus / undrained, grains })
    }
}

/// What a material comes to with water that cannot leave: B, K_u and c_p,u, for reports; nothing where the earthquake is drained.
pub fn values(case: &Case, material: &Material, body: &Body) -> Vec<MaterialValue> {
    let Some(MaterialWater::Pores(pores)) = &material.water else { return Vec::new() };
    let Some(undrained) = Undrained::of(case, pores, body.material.relaxed()) else { return Vec::new() };
    let moduli = body.material.moduli();
    let stiffened = pores.biot.value * pores.biot.value * undrained.modulus;
    let (speed, _) = Moduli { lambda: moduli.lambda + stiffened, ..moduli }.wave_speeds(body.density);
    // How fast pressures even out, with no strain sideways.
    let oedometric = |bulk: f64| bulk + 4.0 / 3.0 * moduli.mu;
    let bulk = moduli.lambda + 2.0 / 3.0 * moduli.mu;
    let weight = case.water.as_ref().map_or(f64::NAN, |water| water.unit_weight.value);
    let evens_out = pores
        .hydraulic_conductivity
        .as_ref()
        .map(|k| k.value / weight * undrained.modulus * oedometric(bulk) / oedometric(bulk + stiffened));
    let [of_skempton, of_bulk, of_speed, of_diffusivity] = MEANINGS;
    let diffusivity = evens_out.map(|c| (DIFFUSIVITY, c, "m2/s", of_diffusivity));
    let all = [
        ("skempton_coefficient", undrained.skempton, "", of_skempton),
        ("undrained_bulk_modulus", undrained.bulk, "Pa", of_bulk),
        ("undrained_wave_speed_p", speed, "m/s", of_speed),
    ];
    let value = |(name, value, unit, meaning): (&str, f64, &str, &str)| MaterialValue {
        name: name.into(),
        value,
        most: value,
        word: String::new(),
        unit: unit.into(),
        meaning: meaning.into(),
        origin: Origin::Derived,
    };
    all.into_iter().chain(diffusivity).map(value).collect()
}

/// Refuses pores of bodies, of which these are the materials, with which water would stiffen rock beyond its grains.
pub fn check(case: &Case, bodies: &[Body], materials: &[usize], problems: &mut Vec<Diagnostic>) {
    let mut told = vec![false; case.materials.len()];
    for (body, &material) in bodies.iter().zip(materials) {
        let Some(MaterialWater::Pores(of)) = &case.materials[material].water else { continue };
        let Some(undrained) = Undrained::of(case, of, body.material.relaxed()) else { continue };
        let most = undrained.grains.min(STIFFEST_GRAINS);
        if undrained.bulk <= most || std::mem::replace(&mut told[material], true) {
            continue;
        }
        let shown = |modulus: f64| tremolite_case::units::format(modulus, Dimension::PRESSURE);
        let whose = match of.biot.value < 1.0 && undrained.grains <= STIFFEST_GRAINS {
            true => "that of its own grains, K/(1 − biot)",
            false => "that of any grains",
        };
        problems.push(Diagnostic::at(
            of.porosity.as_ref().or(of.skempton.as_ref()).unwrap_or(&of.biot),
            format!(
                "undrained, '{}' would have a bulk modulus of {}, more than {whose}, {}",
                case.materials[material].name.value,
                shown(undrained.bulk),
                shown(most)
            ),
            "give a smaller `biot` (1 less the bulk modulus of the rock over that of its grains, 40 to 60 GPa), a larger `porosity`, or a smaller \
             `skempton`",
        ));
    }
}
