//! Against printed numbers: the worked example of an interaction diagram in a textbook, and a table of a handbook.

use tremolite_sections::{Concrete, Diagram, Layer, Section};

/// Example 18.6 of `shah1972`, as its companion `manaqibwala2019` has it: a column of 250 × 450 mm, 1472 mm² of mild steel (250 MPa,
/// γ_s = 1/0.87) 50 mm from either face, f_ck 15 MPa. Parabola and rectangle with 0.446 f_ck, strains of 0.002 and 0.0035, the pivot
/// at 3/7 of the depth: the law of EN 1992-1-1 3.1.7. Concrete is not taken out for the steel, as here.
const WIDTH: f64 = 0.25;
const DEPTH: f64 = 0.45;
const COVER: f64 = 0.05;
const STEEL: f64 = 1472e-6;
const F_CK: f64 = 15e6;

fn column(steel: f64) -> Section {
    // A metre wide.
    let bars = |depth| Layer {
        area: steel / WIDTH,
        depth,
        young: 200e9,
        yields: 0.87 * 250e6,
        breaks: f64::INFINITY,
    };
    let (intrados, extrados) = (bars(0.5 * DEPTH - COVER), bars(COVER - 0.5 * DEPTH));
    let layers = if steel > 0.0 { vec![intrados, extrados] } else { Vec::new() };
    Section { thickness: DEPTH, concrete: Concrete::en(0.446 * F_CK), layers }
}

/// Thrust in compression \[N\] and moment \[N m\] of the column whose neutral axis lies at this depth \[m\], compressed most at the extrados.
fn at(steel: f64, axis: f64) -> [f64; 2] {
    let slope = if axis < DEPTH { 3.5e-3 / axis } else { 2e-3 / (axis - 3.0 / 7.0 * DEPTH) };
    let [n, m] = column(steel).forces(slope * (0.5 * DEPTH - axis), slope);
    [-n * WIDTH, m * WIDTH]
}

/// Neutral axis over depth, and the book's parameters of its block of stress: area over f_ck D, and its centre over D.
const OUTSIDE: [(f64, f64, f64); 5] =
    [(1.5, 0.422, 0.480), (1.3, 0.409, 0.468), (1.2, 0.399, 0.458), (1.1, 0.384, 0.443), (1.0, 0.361, 0.416)];
/// The same over f_ck x and x where it lies inside, at the depths that the book takes \[m\].
const INSIDE: (f64, f64) = (0.36, 0.416);
const DEPTHS: [f64; 11] = [0.4, 0.375, 0.35, 0.325, 0.3, 0.275, 0.25, 0.225, 0.2, 0.15, 0.1];

#[test]
fn the_block_of_stress_has_the_book_s_parameters_to_their_last_digit() {
    let block = |axis: f64, depth: f64| {
        let [n, m] = at(0.0, axis);
        (n / (F_CK * WIDTH * depth), (0.5 * DEPTH - m / n) / depth)
    };
    for (share, area, centre) in OUTSIDE {
        let found = block(share * DEPTH, DEPTH);
        assert_eq!(format!("{:.3} {:.3}", found.0, found.1), format!("{area:.3} {centre:.3}"), "{share}");
    }
    for depth in DEPTHS {
        let found = block(depth, depth);
        assert_eq!(format!("{:.2} {:.3}", found.0, found.1), format!("{:.2} {:.3}", INSIDE.0, INSIDE.1));
    }
}

/// Thrust \[kN\] and moment \[kN m\] of the book's points: with its parameters as printed, and 0.43 for 3/7.
const POINTS: [(f64, f64); 16] = [
    (1352.4, 6.41),
    (1288.6, 17.28),
    (1231.4, 27.12),
    (1153.7, 40.18),
    (1044.1, 58.97),
    (860.2, 87.67),
    (757.7, 102.98),
    (645.5, 119.30),
    (521.1, 137.04),
    (405.0, 152.64),
    (371.2, 153.12),
    (337.5, 152.89),
    (303.7, 151.97),
    (270.0, 150.34),
    (202.5, 144.98),
    (135.0, 136.81),
];

/// Half a unit in the last digit of the parameters moves a point by what is written here, and no more is allowed. The book's last point,
/// pure bending, is left out: it has the formula of a section without steel in compression.
#[test]
fn the_diagram_of_a_worked_example_is_met_within_its_digits() {
    let diagram = Diagram::of(&column(STEEL));
    let axes = OUTSIDE.map(|o| o.0 * DEPTH).into_iter().chain(DEPTHS);
    for (axis, (n, m)) in axes.zip(POINTS) {
        let found = at(STEEL, axis);
        let inside = axis < DEPTH;
        // Of the area, of its centre, and of the printed points themselves.
        let (depth, area) = if inside { (axis, 0.005) } else { (DEPTH, 0.0005) };
        let block = at(0.0, axis);
        let thrust = area * F_CK * WIDTH * depth;
        // The less strained steel outside: 0.002 (x − D + c)/(x − 0.43 D), elastic.
        let pivot = 0.005 * DEPTH * 2e-3 * (axis - DEPTH + COVER) / (axis - 0.43 * DEPTH).powi(2);
        let steel = if inside { 0.0 } else { STEEL * 200e9 * pivot };
        let bounds = [
            thrust + steel + 50.0,
            thrust * block[1] / block[0] + 0.0005 * depth * block[0] + steel * (0.5 * DEPTH - COVER) + 5.0,
        ];
        assert!((found[0] - 1e3 * n).abs() <= bounds[0], "{axis}: {found:?} {n} ± {bounds:?}");
        assert!((found[1] - 1e3 * m).abs() <= bounds[1], "{axis}: {found:?} {m} ± {bounds:?}");
        // And the border goes through it, to what its chords are off.
        let used = diagram.utilisation([-found[0] / WIDTH, found[1] / WIDTH]);
        assert!((used - 1.0).abs() < 1e-4, "{axis}: {used}");
    }
    // Pure compression, where the book does take the concrete out for the steel.
    let squashed = 0.446 * F_CK * (WIDTH * DEPTH) + 2.0 * STEEL * 0.87 * 250e6;
    assert!((diagram.utilisation([-squashed / WIDTH, 0.0]) - 1.0).abs() < 1e-9);
}

/// Design of rectangular sections with steel on one side (`goris2011`, the table with dimensionless values): ω at μ = 0.01, 0.02 … 0.37, where
/// M − N z_s = μ b d² f_cd and A_s f_yd = ω b d f_cd + N, N positive in tension. Steel is strained by 2.5 % at most.
const OMEGA: [f64; 37] = [
    0.0101, 0.0203, 0.0306, 0.0410, 0.0515, 0.0621, 0.0728, 0.0836, 0.0946, 0.1057, 0.1170, 0.1285, 0.1401,
    0.1518, 0.1638, 0.1759, 0.1882, 0.2007, 0.2134, 0.2263, 0.2395, 0.2529, 0.2665, 0.2804, 0.2946, 0.3091,
    0.3239, 0.3391, 0.3546, 0.3706, 0.3869, 0.4038, 0.4211, 0.4391, 0.4576, 0.4768, 0.4968,
];

/// What is borne with half a unit less in ω than printed is less than the table has, with half a unit more it is more, whatever the thrust.
#[test]
fn a_handbook_s_table_of_reinforcement_is_met_within_its_digits() {
    let (h, d, f_cd, f_yd) = (0.6, 0.55, 20e6, 435e6);
    let lever = d - 0.5 * h;
    for (k, omega) in OMEGA.into_iter().enumerate() {
        let moment = 0.01 * (k + 1) as f64 * d * d * f_cd;
        // In shares of ω b d f_cd, so that some steel is left.
        for share in [-0.5, 0.0, 0.7] {
            let n = share * omega * d * f_cd;
            let used = |omega: f64| {
                let area = (omega * d * f_cd + n) / f_yd;
                let layers = vec![Layer { area, depth: lever, young: 200e9, yields: f_yd, breaks: 0.025 }];
                let section = Section { thickness: h, concrete: Concrete::en(f_cd), layers };
                Diagram::of(&section).utilisation([n, moment + n * lever])
            };
            let (less, more) = (used(omega - 0.5e-4), used(omega + 0.5e-4));
            // The chords of the border are off by less than 10⁻⁴.
            assert!(less > 1.0 - 1e-4 && more < 1.0 + 1e-4, "{k} {share}: {less} {more}");
        }
    }
}
