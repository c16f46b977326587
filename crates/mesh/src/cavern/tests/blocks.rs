//! Descriptions that the tests share.

use crate::cavern::{Cavern, CavernShape, CavernSpec, Gallery, Lining, Shotcrete};

pub fn lining(walls: f64, crown: f64, floor: f64, layers: u32) -> Lining {
    Lining { walls, crown, floor, layers }
}

pub fn cavern(name: &str, size: [f64; 3], benches: u32, at: [f64; 2], lining: Lining) -> Cavern {
    let [width, height, arch_rise] = size;
    Cavern { name: name.to_owned(), at, width, height, arch_rise, benches, lining, ..Cavern::default() }
}

pub fn shaped(shape: CavernShape, size: [f64; 3], benches: u32, lining: Lining) -> Cavern {
    Cavern { shape, ..cavern("t", size, benches, [0.0, 0.0], lining) }
}

/// The paper's caverns, of six and four benches, with galleries.
pub fn with_galleries(galleries: Vec<Gallery>) -> CavernSpec {
    CavernSpec { galleries, ..CavernSpec::yingxiuwan() }
}

pub fn gallery(name: &str, at: [f64; 2]) -> Gallery {
    let between = ["powerhouse".to_owned(), "transformer".to_owned()];
    Gallery { name: name.to_owned(), between, at, width: 3.0, height: 3.4 }
}

/// With so much shotcrete, of so many layers, all round its caverns.
fn sprayed(mut spec: CavernSpec, thickness: f64, layers: u32) -> CavernSpec {
    spec.caverns.iter_mut().for_each(|c| c.shotcrete = Shotcrete { thickness, layers });
    spec
}

/// With a length for each cavern, in a block so long; `None`: it goes through.
pub fn ending(mut spec: CavernSpec, block: f64, lengths: &[Option<f64>]) -> CavernSpec {
    spec.length = block;
    spec.caverns.iter_mut().zip(lengths).for_each(|(c, length)| c.length = *length);
    spec
}

/// The paper's caverns with their own lengths, in a block of 160 m.
pub fn finite() -> CavernSpec {
    ending(CavernSpec { along: Some(4.4), ..CavernSpec::yingxiuwan() }, 160.0, &[Some(52.8), Some(59.4)])
}

pub fn block(near: f64, caverns: Vec<Cavern>) -> CavernSpec {
    let along = Some(3.0);
    CavernSpec {
        overburden: 60.0,
        below: 45.0,
        sides: 50.0,
        length: 6.0,
        near,
        far: 7.0,
        along,
        caverns,
        ..CavernSpec::default()
    }
}

/// Blocks that between them take every path: flat and steep arches, with and without slab, unlined, shotcreted, several
/// layers, caverns beside and above one another, rectangles that share a line, ends in rock.
pub fn blocks() -> Vec<(&'static str, CavernSpec)> {
    let horseshoe = cavern("t", [10.0, 8.0, 5.0], 2, [0.0, 0.0], lining(0.4, 0.5, 0.6, 2));
    let three = vec![
        cavern("a", [10.0, 12.0, 3.0], 3, [0.0, 0.0], lining(0.4, 0.6, 0.0, 1)),
        cavern("b", [6.0, 6.0, 2.5], 2, [6.0, -12.0], lining(0.3, 0.3, 0.3, 1)),
        cavern("c", [14.0, 20.0, 3.0], 4, [-25.0, 5.0], lining(0.5, 0.8, 0.0, 2)),
    ];
    let tight = vec![
        cavern("a", [8.0, 10.0, 2.5], 2, [0.0, 0.0], lining(0.4, 0.4, 0.0, 1)),
        cavern("b", [8.0, 10.0, 2.5], 2, [13.0, 0.0], lining(0.4, 0.4, 0.0, 1)),
    ];
    let beside = |shape: CavernShape, name: &str, x: f64| Cavern {
        name: name.to_owned(),
        at: [x, 0.0],
        ..shaped(shape, [8.0, 8.0, 0.0], 1, lining(0.4, 0.5, 0.4, 1))
    };
    let shapes = vec![
        beside(CavernShape::Circle, "a", 0.0),
        beside(CavernShape::Horseshoe, "b", 18.0),
        beside(CavernShape::Rectangle, "c", 36.0),
    ];
    let galleries = with_galleries(vec![gallery("bus1", [-1.5, 14.4]), gallery("bus2", [3.0, 14.4])]);
    // On the floor, on a slab and without one, and beside that at a level of its own.
    let mut floors = with_galleries(vec![gallery("adit", [-8.0, 0.0]), gallery("bus", [8.0, 19.1])]);
    floors.caverns[0].lining.floor = 0.6;
    let alone = |shape: CavernShape, size: [f64; 3]| block(1.2, vec![shaped(shape, size, 2, Lining::NONE)]);
    let mut aside = ending(block(1.3, three.clone()), 60.0, &[Some(20.0), None, Some(12.0)]);
    aside.caverns[0].middle = -6.0;
    aside.caverns[2].middle = 7.0;
    let ended = |spec: &CavernSpec| ending(spec.clone(), 110.0, &[Some(52.8), Some(59.4)]);
    vec![
        ("galleries", galleries.clone()),
        ("galleries on the floor", floors.clone()),
        ("yingxiuwan", CavernSpec::yingxiuwan()),
        ("horseshoe", block(1.0, vec![horseshoe.clone()])),
        ("horseshoe, coarse", block(2.5, vec![horseshoe.clone()])),
        ("unlined", block(1.5, vec![cavern("t", [10.0, 12.0, 5.0], 1, [0.0, 0.0], Lining::NONE)])),
        ("three", block(1.3, three.clone())),
        ("tight", block(1.5, tight)),
        (
            "elliptic",
            block(1.2, vec![shaped(CavernShape::Ellipse, [14.0, 20.0, 4.0], 3, lining(0.5, 0.8, 0.4, 2))]),
        ),
        (
            "tall ellipse",
            block(1.0, vec![shaped(CavernShape::Ellipse, [6.0, 10.0, 5.0], 2, lining(0.3, 0.3, 0.0, 1))]),
        ),
        (
            "rectangle",
            block(1.0, vec![shaped(CavernShape::Rectangle, [8.0, 6.0, 0.0], 2, lining(0.5, 0.6, 0.5, 2))]),
        ),
        (
            "unlined rectangle",
            block(1.5, vec![shaped(CavernShape::Rectangle, [9.0, 12.0, 0.0], 1, Lining::NONE)]),
        ),
        (
            "circle",
            block(1.0, vec![shaped(CavernShape::Circle, [9.0, 9.0, 0.0], 2, lining(0.4, 0.5, 0.6, 2))]),
        ),
        ("coarse circle", block(3.0, vec![shaped(CavernShape::Circle, [9.0, 9.0, 0.0], 1, Lining::NONE)])),
        (
            "round horseshoe",
            block(0.8, vec![shaped(CavernShape::Horseshoe, [8.0, 8.0, 0.0], 3, lining(0.4, 0.4, 0.5, 2))]),
        ),
        (
            "low horseshoe",
            block(1.5, vec![shaped(CavernShape::Horseshoe, [12.0, 9.5, 0.0], 1, lining(0.4, 0.6, 0.8, 1))]),
        ),
        ("shapes", block(1.2, shapes.clone())),
        ("thick", block(3.0, vec![cavern("t", [12.0, 18.0, 4.0], 3, [0.0, 0.0], lining(0.9, 0.8, 0.5, 3))])),
        ("sprayed yingxiuwan", sprayed(CavernSpec::yingxiuwan(), 0.15, 1)),
        ("sprayed horseshoe", sprayed(block(1.0, vec![horseshoe]), 0.15, 2)),
        ("sprayed three", sprayed(block(1.3, three), 0.1, 1)),
        ("sprayed galleries", sprayed(floors.clone(), 0.2, 1)),
        ("sprayed arch alone", sprayed(alone(CavernShape::Arch, [12.0, 15.0, 3.0]), 0.12, 1)),
        ("sprayed ellipse alone", sprayed(alone(CavernShape::Ellipse, [14.0, 20.0, 4.0]), 0.15, 1)),
        ("sprayed rectangle alone", sprayed(alone(CavernShape::Rectangle, [8.0, 6.0, 0.0]), 0.15, 1)),
        ("sprayed circle alone", sprayed(alone(CavernShape::Circle, [9.0, 9.0, 0.0]), 0.15, 1)),
        (
            "sprayed rectangle",
            sprayed(
                block(
                    1.0,
                    vec![shaped(CavernShape::Rectangle, [8.0, 6.0, 0.0], 2, lining(0.5, 0.6, 0.5, 2))],
                ),
                0.1,
                1,
            ),
        ),
        ("sprayed shapes", sprayed(block(1.2, shapes.clone()), 0.15, 1)),
        ("ends", finite()),
        ("ends and galleries", ended(&galleries)),
        ("ends and sprayed galleries", sprayed(ended(&floors), 0.2, 1)),
        ("ends here and there", aside),
        ("ends of shapes", ending(block(1.2, shapes), 40.0, &[Some(6.0), Some(12.0), Some(7.0)])),
        (
            "ends, unlined",
            ending(
                block(1.5, vec![cavern("t", [10.0, 12.0, 5.0], 1, [0.0, 0.0], Lining::NONE)]),
                50.0,
                &[Some(9.0)],
            ),
        ),
        (
            "ends, shotcrete alone",
            ending(sprayed(alone(CavernShape::Arch, [12.0, 15.0, 3.0]), 0.12, 1), 50.0, &[Some(9.0)]),
        ),
    ]
}
