//! Sites that are known well enough to start from.

use super::{Cavern, CavernShape, CavernSpec, GroundSurface, Lining, Shotcrete};

impl CavernSpec {
    /// Main powerhouse and transformer cavern of the Yingxiuwan hydropower station, as a coarse mesh of about
    /// 8,000 elements (`wang2018`).
    ///
    /// From the paper: length, width and height of the main cavern, 52.8 × 17.0 × 37.2 m; width and height
    /// of the transformer cavern, 7.2 × 27.9 m (its 59.4 m of length are cut to the block's 52.8 m); lining
    /// of 0.5 m on the walls and about 0.9 m at the crown; about 200 m of rock above. Assumed: arch rises,
    /// a centre distance of 33 m, floors at the same level, the same lining in both, no floor slab.
    pub fn yingxiuwan() -> Self {
        let lining = Lining { walls: 0.5, crown: 0.9, floor: 0.0, layers: 1 };
        CavernSpec {
            overburden: 200.0,
            below: 80.0,
            sides: 90.0,
            length: 52.8,
            near: 3.2,
            far: 11.0,
            along: Some(8.8),
            caverns: vec![
                Cavern {
                    name: "powerhouse".to_owned(),
                    shape: CavernShape::Arch,
                    at: [0.0, 0.0],
                    length: None,
                    middle: 0.0,
                    width: 17.0,
                    height: 37.2,
                    arch_rise: 4.5,
                    benches: 6,
                    lining: lining.clone(),
                    shotcrete: Shotcrete::NONE,
                },
                Cavern {
                    name: "transformer".to_owned(),
                    shape: CavernShape::Arch,
                    at: [33.0, 0.0],
                    length: None,
                    middle: 0.0,
                    width: 7.2,
                    height: 27.9,
                    arch_rise: 2.2,
                    benches: 4,
                    lining,
                    shotcrete: Shotcrete::NONE,
                },
            ],
            layers: Vec::new(),
            ground: GroundSurface::Level,
            galleries: Vec::new(),
        }
    }

    /// The same site, about as fine as in the paper, which has 97,652 elements, some 7,300 of them in the linings:
    /// here 98,080 and 7,200, two through the thickness of the linings.
    pub fn yingxiuwan_fine() -> Self {
        let mut spec = CavernSpec { near: 1.7, far: 17.0, along: Some(1.32), ..CavernSpec::yingxiuwan() };
        for cavern in &mut spec.caverns {
            cavern.lining.layers = 2;
        }
        spec
    }
}
