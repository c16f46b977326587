use super::*;

fn measure(text: &str) -> Measure {
    Measure::parse(text).unwrap_or_else(|e| panic!("{text}: {e}"))
}

fn motion() -> Motion {
    let wave = |f: f64, a: f64| (0..400).map(|k| a * (f * f64::from(k)).sin()).collect::<Vec<f64>>();
    Motion::from_acceleration(0.01, [wave(0.13, 2.0), wave(0.21, 1.0), wave(0.4, 3.0)]).unwrap()
}

#[test]
fn measures_are_read_and_written_alike() {
    for (text, written) in [
        ("PGA", "PGA"),
        ("pgv", "PGV"),
        (" Sa(0.5 s) ", "Sa(0.5 s, 5 %)"),
        ("sa(500 ms, 0.02)", "Sa(0.5 s, 2 %)"),
        ("RotD50 Sa(1 s, 5 %)", "RotD50 Sa(1 s, 5 %)"),
        ("geometric-mean  Arias", "geometric-mean Arias"),
        ("z PGA", "z PGA"),
        ("geometric-mean Target(200 ms,2 s)", "geometric-mean target(0.2 s, 2 s)"),
    ] {
        assert_eq!(measure(text).to_string(), written);
        assert_eq!(measure(written), measure(text));
    }
    for text in [
        "",
        "PGX",
        "Sa",
        "Sa()",
        "Sa(0.5)",
        "Sa(0.5 m)",
        "Sa(-1 s)",
        "Sa(1 s, 5 s)",
        "Sa(1 s",
        "w PGA",
        "RotD50",
        "ßa(1 s)",
        "target",
        "target(1 s)",
        "target(2 s, 1 s)",
        "target(0.2 s, 2)",
    ] {
        assert!(Measure::parse(text).is_err(), "{text}");
    }
}

#[test]
fn a_scaled_motion_has_the_level_that_was_asked_for() {
    let motion = motion();
    for text in [
        "PGA",
        "PGV",
        "PGD",
        "Arias",
        "CAV",
        "Sa(0.3 s)",
        "RotD50 Sa(0.3 s)",
        "geometric-mean PGV",
        "x Arias",
        "RotD100 PGA",
    ] {
        let measure = measure(text);
        let now = measure.of(&motion, None).unwrap();
        let factor = measure.factor(now, 0.7);
        let found = measure.of(&motion.clone().scaled(factor), None).unwrap();
        assert!((found / 0.7 - 1.0).abs() < 1e-12, "{text}: {found}");
        assert!((measure.scaled(now, factor) / 0.7 - 1.0).abs() < 1e-12);
    }
}

/// Of one component a that does not change its direction: |cos θ| of it in direction θ, the median over a half circle is
/// cos 45° of it, and the largest all of it.
#[test]
fn a_motion_along_one_line_has_the_median_of_a_cosine() {
    let of = |x: f64, y: f64| {
        let a: Vec<f64> = (0..300).map(|k| (0.1 * f64::from(k)).sin()).collect();
        let scaled = |f: f64| a.iter().map(|v| f * v).collect::<Vec<f64>>();
        Motion::from_acceleration(0.01, [scaled(x), scaled(y), scaled(0.0)]).unwrap()
    };
    let along = measure("x PGA").of(&of(1.0, 0.0), None).unwrap();
    for (x, y) in [(1.0, 0.0), (0.6, 0.8), (0.0, 1.0)] {
        let motion = of(x, y);
        // Steps of one degree.
        let median = measure("RotD50 PGA").of(&motion, None).unwrap() / along;
        assert!((median - 0.5_f64.sqrt()).abs() < 0.01, "{median}");
        assert!((measure("RotD100 PGA").of(&motion, None).unwrap() / along - 1.0).abs() < 2e-4);
    }
    let mean = measure("geometric-mean PGA").of(&of(0.5, 2.0), None).unwrap();
    assert!(
        (mean / along - 1.0).abs() < 1e-12 && measure("PGA").of(&of(0.5, 2.0), None).unwrap() == 2.0 * along
    );
}

#[test]
fn a_motion_over_a_target_has_the_factor_that_fits_it_in_the_mean() {
    let target = TargetSpectrum::en1998(1, 'B', 2.0).unwrap();
    let (band, motion) = ([0.2, 2.0], motion());
    let over = |of: &str, motion: &Motion| {
        measure(&format!("{of} target(0.2 s, 2 s)")).of(motion, Some(&target)).unwrap()
    };
    let [x, y] = [0, 1].map(|axis| {
        1.0 / tremolite_motion::scale_to(&motion.acceleration[axis], motion.dt, &target, band).unwrap()
    });
    assert!((over("x", &motion) / x - 1.0).abs() < 1e-12 && (over("y", &motion) / y - 1.0).abs() < 1e-12);
    assert!((over("geometric-mean", &motion) / (x * y).sqrt() - 1.0).abs() < 1e-12);
    let largest = measure("target(0.2 s, 2 s)").of(&motion, Some(&target)).unwrap();
    assert!(largest >= x.max(y) * (1.0 - 1e-12) && largest < x + y);
    let (median, most) = (over("RotD50", &motion), over("RotD100", &motion));
    assert!(median > 0.0 && median < most && most >= largest * (1.0 - 1e-12));
    // Turned by whole degrees, RotD takes the same directions.
    let (sin, cos) = (40f64.to_radians().sin(), 40f64.to_radians().cos());
    let [ax, ay, az] = motion.acceleration.clone();
    let turned = |a: f64, b: f64| ax.iter().zip(&ay).map(move |(x, y)| a * x + b * y).collect::<Vec<f64>>();
    let turned = Motion::from_acceleration(motion.dt, [turned(cos, sin), turned(-sin, cos), az]).unwrap();
    assert!((over("RotD50", &turned) / median - 1.0).abs() < 1e-9);
    assert!((over("x", &turned) / x - 1.0).abs() > 1e-3);
    let one = measure("target(0.2 s, 2 s)");
    assert!(one.of(&motion, None).unwrap_err().to_string().contains("[motion.target]"));
    assert!(
        measure("target(0.2 s, 5 s)").of(&motion, Some(&target)).unwrap_err().to_string().contains("beyond")
    );
    let still = Motion::from_acceleration(0.01, [vec![0.0; 400], vec![0.0; 400], vec![0.0; 400]]).unwrap();
    assert_eq!(one.of(&still, Some(&target)).unwrap(), 0.0);
}
