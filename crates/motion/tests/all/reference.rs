//! Against figures of SciPy 1.17.1 on NumPy 2.4.6 (detrend, butter and sosfiltfilt, cumulative trapezoid) and of an
//! independent exact Nigam–Jennings integration, for three recorded motions. Intensities and spectra are of
//! the detrended and band-passed record; the band is 0.1 Hz to the smaller of 25 Hz and 0.9 of Nyquist.
//!
//! Two of the records come with the repository. The third may not be copied: see [`crate::records`].

use crate::records::{local, shipped};
use tremolite_motion::{
    Channel, Intensity, Orientation, Process, ReadOptions, Units, cumulative_trapezoid, linear_trend,
    process, pseudo_acceleration, read,
};

const PERIODS: [f64; 10] = [0.05, 0.1, 0.2, 0.3, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0];

/// A peak with its sign and the index of its sample.
struct Peak(f64, usize);

struct Expected {
    npts: usize,
    dt: f64,
    /// Slope per second and intercept of the linear trend.
    trend: [f64; 2],
    raw: [Peak; 3],
    /// Velocity and displacement at the end, as recorded.
    raw_end: [f64; 2],
    detrended: [Peak; 3],
    /// Velocity and displacement at the end, detrended.
    detrended_end: [f64; 2],
    upper_corner: f64,
    filtered: [Peak; 3],
    filtered_end: [f64; 2],
    /// Every so many samples one of the filtered record.
    stride: usize,
    samples: [f64; 13],
    psa: [f64; 10],
    arias: f64,
    /// Times (s) from the first sample at which 5 % and 95 % of the Arias intensity are reached.
    t5: f64,
    t95: f64,
    d5_95: f64,
    cav: f64,
}

/// Equal to 1e-9 of a scale.
fn near(what: &str, value: f64, expected: f64, scale: f64) {
    within(what, value, expected, 1e-9 * scale.abs());
}

fn within(what: &str, value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{what}: {value} against {expected}, +- {tolerance}");
}

/// What round-off the filters leave, as a part of the peak: 1.1e-16 over the poles' distance of 1e-3 from the
/// unit circle. It can be a constant offset, which integration turns into a drift.
const ROUND_OFF: f64 = 1.1e-13;

/// Peaks of acceleration, velocity and displacement, and the last velocity and displacement.
fn check_series(what: &str, acceleration: &[f64], dt: f64, peaks: &[Peak; 3], end: [f64; 2]) {
    let velocity = cumulative_trapezoid(acceleration, dt);
    let displacement = cumulative_trapezoid(&velocity, dt);
    let time = dt * acceleration.len() as f64;
    let offset = ROUND_OFF * peaks[0].0.abs();
    let drift = [offset, offset * time, 0.5 * offset * time * time];
    let all = [acceleration, &velocity, &displacement];
    for ((series, Peak(value, index)), drift) in all.iter().zip(peaks).zip(drift) {
        let largest = (0..series.len()).max_by(|&i, &j| series[i].abs().total_cmp(&series[j].abs()));
        assert_eq!(largest, Some(*index), "{what}: place of the peak {value}");
        within(what, series[*index], *value, 1e-9 * value.abs() + drift);
    }
    for k in [1, 2] {
        within(what, all[k][all[k].len() - 1], end[k - 1], 1e-9 * peaks[k].0.abs() + drift[k]);
    }
}

fn check(channel: &Channel, e: &Expected) {
    assert_eq!(channel.acceleration.len(), e.npts);
    near("dt", channel.dt, e.dt, 1e-3 * e.dt);
    check_series("raw", &channel.acceleration, e.dt, &e.raw, e.raw_end);

    let trend = linear_trend(&channel.acceleration);
    near(
        "slope of the trend",
        trend.slope / e.dt * e.npts as f64 * e.dt,
        e.trend[0] * e.npts as f64 * e.dt,
        e.raw[0].0,
    );
    near("intercept of the trend", trend.intercept, e.trend[1], e.raw[0].0);
    let mut record = channel.clone();
    process(&mut [&mut record], &[Process::DetrendLinear]).unwrap();
    check_series("detrended", &record.acceleration, e.dt, &e.detrended, e.detrended_end);

    process(&mut [&mut record], &[Process::Bandpass { low: 0.1, high: e.upper_corner }]).unwrap();
    check_series("filtered", &record.acceleration, e.dt, &e.filtered, e.filtered_end);
    for (i, sample) in e.samples.iter().enumerate() {
        near("filtered sample", record.acceleration[i * e.stride], *sample, e.filtered[0].0);
    }

    let intensity = Intensity::of_samples(&record.acceleration, e.dt);
    near("pga", intensity.pga, e.filtered[0].0.abs(), e.filtered[0].0);
    near("pgv", intensity.pgv, e.filtered[1].0.abs(), e.filtered[1].0);
    near("pgd", intensity.pgd, e.filtered[2].0.abs(), e.filtered[2].0);
    near("arias", intensity.arias, e.arias, e.arias);
    near("t5", intensity.t5, e.t5, e.t5);
    near("t95", intensity.t95, e.t95, e.t95);
    near("d5_95", intensity.d5_95, e.d5_95, e.d5_95);
    near("cav", intensity.cav, e.cav, e.cav);
    let psa = pseudo_acceleration(&record.acceleration, e.dt, &PERIODS, 0.05).unwrap();
    for (value, expected) in psa.iter().zip(e.psa) {
        near("psa", *value, expected, expected);
    }
}

/// WTMC_0.
const WTMC: Expected = Expected {
    npts: 8192,
    dt: 0.02,
    trend: [1.3492899798766987e-09, -1.5021219047519362e-06],
    raw: [Peak(-9.7331, 2494), Peak(-1.0081460000000002, 2579), Peak(0.2291612799999992, 2568)],
    raw_end: [-0.00023800000000016373, -0.019497580000022694],
    detrended: [
        Peak(-9.73309856518068, 2494),
        Peak(-1.0080703154427209, 2579),
        Peak(0.23111199887274544, 2568),
    ],
    detrended_end: [-1.0027832032175509e-05, -0.00033004079835370566],
    upper_corner: 22.5,
    filtered: [
        Peak(-9.600302232507891, 2494),
        Peak(-1.0079538655267064, 2579),
        Peak(-0.2321341946940261, 2682),
    ],
    filtered_end: [-0.00038239102241391696, -0.054536179763086466],
    stride: 682,
    samples: [
        -4.741735374061408e-05,
        0.000365077663997214,
        -0.0002952706038554251,
        -0.0003015187642455725,
        0.08020303454689995,
        0.4225733333761948,
        -0.25983357287894016,
        -0.12440424551138277,
        0.10938570644518571,
        0.03605589131585745,
        0.05665820098342764,
        0.11058069345928785,
        0.0012723200848630883,
    ],
    psa: [
        10.934595163074585,
        26.754298590218806,
        20.36845475467048,
        31.0302452358143,
        18.074355599439944,
        15.87414819600628,
        13.304815981060836,
        11.133993807251906,
        4.576987554462652,
        1.7487941273051322,
    ],
    arias: 13.53004198254685,
    t5: 48.95630887717899,
    t95: 67.5893791634982,
    d5_95: 18.633070286319203,
    cav: 41.585180465412236,
};

/// WOLONG_EW_20_40s.
const WOLONG: Expected = Expected {
    npts: 3902,
    dt: 0.005,
    trend: [-0.001345062861006379, 0.011467289877951384],
    raw: [Peak(9.58, 2498), Peak(0.5276499999999997, 2086), Peak(0.523671374999998, 3785)],
    raw_end: [-0.030525000000000257, 0.5183673124999985],
    detrended: [
        Peak(9.58533254525602, 2498),
        Peak(-0.5236290117661836, 2486),
        Peak(-0.0967459484155964, 2847),
    ],
    detrended_end: [0.0016667478216297812, 0.0005551501942427769],
    upper_corner: 25.0,
    filtered: [Peak(9.621293842167068, 2499), Peak(0.6454889098083807, 3038), Peak(1.3457770770802098, 3430)],
    filtered_end: [-0.031111845133361633, 0.6182951033396135],
    stride: 325,
    samples: [
        0.015010681377617803,
        0.0623629243063389,
        -0.04936111617971462,
        0.7184858066663651,
        0.3028264900463791,
        3.6979657240450017,
        -3.226668956488089,
        1.5270329768355668,
        0.21689825558819512,
        1.2601967473450844,
        0.059896418567752546,
        -0.9093882231410212,
        0.6828141702866951,
    ],
    psa: [
        10.70840343979696,
        14.350570305061783,
        19.054058666608455,
        23.62943161442728,
        14.818968452321966,
        7.554320487253065,
        3.393727345800613,
        1.8344048448782018,
        1.550871030747874,
        0.7506311633816256,
    ],
    arias: 9.31649901465965,
    t5: 6.214429953169587,
    t95: 14.05804571952515,
    d5_95: 7.843615766355564,
    cav: 21.016648279848468,
};

/// RSN753_LOMAP_CLS000.AT2.
const RSN753: Expected = Expected {
    npts: 7995,
    dt: 0.005,
    trend: [-1.3521405658215712e-07, 3.5102446657086057e-06],
    raw: [Peak(6.3226061505599995, 525), Peak(-0.5594930481225456, 505), Peak(0.09439379770934213, 475)],
    raw_end: [-2.34055194711358e-06, -1.7006566718181374e-06],
    detrended: [Peak(6.3226029952522325, 525), Peak(-0.559501480453267, 505), Peak(0.09438419962193513, 475)],
    detrended_end: [-3.463598199124301e-05, -0.0013666450978902828],
    upper_corner: 25.0,
    filtered: [Peak(6.335144531581164, 525), Peak(-0.5617213314618571, 505), Peak(0.08812645684015132, 475)],
    filtered_end: [-0.002108901986987916, -0.07204868125728546],
    stride: 666,
    samples: [
        0.008634151256288383,
        0.5426839231883247,
        -1.6210805865353095,
        -0.6282718975291945,
        -0.0032355788446879995,
        0.2623233257654361,
        -0.11796476513887713,
        -0.07621359760995602,
        -0.014104732361587578,
        -0.0705191708465909,
        -0.010332750123858973,
        -0.029629040452460897,
        0.0001265476886378558,
    ],
    psa: [
        7.065486085808557,
        8.600134801969988,
        10.048880384521839,
        21.223602912684473,
        14.13757783562622,
        10.147646664731667,
        3.885198526142652,
        1.8298967593386435,
        1.6858853812575576,
        0.6914749514294982,
    ],
    arias: 3.2436156043664304,
    t5: 2.3627685943346446,
    t95: 9.219294566771136,
    d5_95: 6.856525972436492,
    cav: 12.49787205483731,
};

#[test]
fn geonet_wtmc_kaikoura_2016() {
    let channels = read(&shipped("20161113_110259_WTMC_20.V2A"), &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), 3);
    check(&channels[0], &WTMC);
    // Bearings, units and peaks [mm/s²] as the file's own headers state them.
    for (channel, (name, orientation, peak, at)) in channels.iter().zip([
        ("N28W", Orientation::from_degrees(332.0), -9733.1, 44.88),
        ("S62W", Orientation::from_degrees(242.0), 7966.4, 45.96),
        ("Up", Orientation::Up, 18021.9, 44.14),
    ]) {
        assert!(channel.name.ends_with(name) && channel.orientation == Some(orientation));
        assert_eq!(
            (channel.units, channel.dt, channel.acceleration.len()),
            (Units::MillimetrePerSecond2, 0.02, 8192)
        );
        // The header counts time from 5 s after the first sample.
        let sample = channel.acceleration[((at + 5.0) / 0.02_f64).round() as usize];
        assert!((sample - 1e-3 * peak).abs() < 1e-12);
        assert!(channel.acceleration.iter().all(|a| a.abs() <= sample.abs()));
    }
}

#[test]
fn wolong_table_wenchuan_2008() {
    let options = ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() };
    let channels = read(&shipped("51WCW_EW_20s_40s_gal_int.txt"), &options).unwrap();
    assert_eq!((channels.len(), channels[0].start, channels[0].dt), (1, 20.52, 0.005));
    check(&channels[0], &WOLONG);
}

#[test]
fn peer_corralitos_loma_prieta_1989() {
    for (name, npts, degrees) in [("000", 7995, 0.0), ("090", 7999, 90.0)] {
        let Some(path) = local(&format!("peer_at2/RSN753_LOMAP_CLS{name}.AT2")) else { return };
        let channel = read(&path, &ReadOptions::default()).unwrap().remove(0);
        assert_eq!((channel.acceleration.len(), channel.dt, channel.units), (npts, 0.005, Units::G));
        assert_eq!(channel.orientation, Some(Orientation::from_degrees(degrees)));
        if npts == 7995 {
            check(&channel, &RSN753);
        }
    }
}

#[test]
fn other_headers_and_plain_files_in_circulation() {
    for (name, units, npts, dt, first, last) in [
        ("peer_at2/OpenSees_ARL360.at2", None, 2000, 0.02, 0.1297983e-2, -0.1822073e-3),
        ("peer_at2/OpenSees_elCentro.at2", None, 1559, 0.02, 0.0063, 0.0),
        ("plain/OSM_Kobe.dat", Some(Units::G), 1250, 0.02, 0.0, -0.03241176912),
        ("plain/OpenSees_tabasFN.txt", Some(Units::G), 2500, 0.02, 0.039111, f64::NAN),
    ] {
        let Some(path) = local(name) else { return };
        let dt_given = name.contains("tabas").then_some(0.02);
        let options = ReadOptions { units, dt: dt_given, ..ReadOptions::default() };
        let channel = read(&path, &options).unwrap().remove(0);
        assert_eq!((channel.acceleration.len(), channel.dt), (npts, dt), "{name}");
        assert!((channel.acceleration[0] / 9.80665 - first).abs() < 1e-15, "{name}");
        if last.is_finite() {
            assert!((channel.acceleration[npts - 1] / 9.80665 - last).abs() < 1e-15, "{name}");
        }
    }
}
