//! Formats and their messages, on small files written here.

use std::path::Path;

use tremolite_motion::{
    Channel, Error, Orientation, ReadOptions, Sensitivity, TextColumn, Units, read, read_bytes, write_text,
};

fn parse(text: &str, options: &ReadOptions) -> Result<Vec<Channel>, Error> {
    read_bytes(Path::new("small.txt"), text.as_bytes(), options)
}

fn one(text: &str, options: &ReadOptions) -> Channel {
    let mut channels = parse(text, options).unwrap();
    assert_eq!(channels.len(), 1);
    channels.remove(0)
}

fn message(text: &str, options: &ReadOptions) -> String {
    parse(text, options).unwrap_err().to_string()
}

fn gal() -> ReadOptions {
    ReadOptions { units: Some(Units::CentimetrePerSecond2), ..ReadOptions::default() }
}

/// A GeoNet component of three samples whose numbers touch in their columns of eight.
fn geonet(component: &str) -> String {
    let mut text = String::from("Corrected accelerogram X\n");
    for line in 2..=16 {
        text += &match line {
            10 => "Number of points     3    Duration 0.04 sec\n".to_string(),
            11 => "Instrument corrected data at 0.020 sec intervals\n".to_string(),
            13 => format!("Component {component}  Longitudinal Accelerometer Axis\n"),
            14 => "Acceleration:  peak -11024.7 mm/s/s at   0.02 sec     rms    719.0 mm/s/s\n".to_string(),
            _ => "\n".to_string(),
        };
    }
    text += "\n\n\n   65536     250     250       3       3       3\n\n\n\n\n\n\n";
    text + "   100.0-11024.7-11024.6\n     0.0     0.0     0.0\n     0.0     0.0     0.0\n"
}

#[test]
fn geonet_numbers_are_read_by_column_for_every_component() {
    let text = geonet("N28W") + &geonet("Up");
    let channels = parse(&text, &ReadOptions::default()).unwrap();
    assert_eq!(channels.len(), 2);
    assert_eq!(channels[0].name, "small N28W");
    assert_eq!(channels[1].orientation, Some(Orientation::Up));
    for (a, expected) in channels[1].acceleration.iter().zip([0.1, -11.0247, -11.0246]) {
        assert!((a - expected).abs() < 1e-14);
    }
}

#[test]
fn a_geonet_file_cut_short_or_at_odds_with_itself_is_refused() {
    let whole = geonet("N28W");
    let cut = whole.trim_end().rsplit_once('\n').unwrap().0;
    assert!(message(cut, &ReadOptions::default()).contains("ends within component N28W"));
    let wrong = whole.replace("points     3", "points     4");
    assert!(message(&wrong, &ReadOptions::default()).contains("both 4 and 3 points"));
    let blank = whole.replace("   100.0-11024.7", "   100.0        ");
    assert!(message(&blank, &ReadOptions::default()).contains("line 27: fewer than 10 numbers"));
    let huge =
        whole.replace("points     3", "points 99999999").replace("       3       3", "9999999999999999");
    assert!(message(&huge, &ReadOptions::default()).contains("small.txt, line"));
}

#[test]
fn peer_headers_of_all_styles_give_the_same_record() {
    let title = "PEER\nSomewhere, 01/02/03, Station, 090\nACCELERATION TIME SERIES IN UNITS OF G\n";
    for (text, known) in [
        (format!("{title}NPTS=   4, DT=   .0050 SEC,\n .1E-02 .2E-02\n -.3E-02 .0E+00\n   \n"), true),
        (format!("{title}4 0.005 NPTS, DT\n .1E-02 .2E-02\n -.3D-02 0\n"), true),
        (format!("{title}NPTS=4,DT=.0050SEC\n.1E-02\n.2E-02\n-.3E-02\n0\n").replace('\n', "\r\r\n"), true),
        (
            "Data\nThe units are (g)\nNPTS= 4, DT= .005 SEC\n 0.001 0.002 -0.003 0.0\n*** End Data ***\n"
                .into(),
            false,
        ),
        (format!("{title}NPTS= 4, DT= .005 SEC\n.1E-02 .2E-02 -.3E-02 0\n").replace('\n', "\r"), true),
    ] {
        let channel = one(&text, &ReadOptions::default());
        assert_eq!((channel.dt, channel.start, channel.acceleration.len()), (0.005, 0.0, 4), "{text}");
        for (a, expected) in channel.acceleration.iter().zip([1e-3, 2e-3, -3e-3, 0.0]) {
            assert!((a - expected * 9.80665).abs() < 1e-16);
        }
        assert_eq!(channel.orientation, known.then_some(Orientation::EAST));
    }
}

#[test]
fn peer_faults_are_named_with_their_line() {
    let file = |units: &str, counts: &str, data: &str| format!("PEER\nX\n{units}\n{counts}\n{data}\n");
    let none = ReadOptions::default();
    let g = "IN UNITS OF G";
    for (text, parts) in [
        (file(g, "NPTS= 9, DT= .005 SEC", "1 2 3"), ["after 3 of 9", "line 6"]),
        (file(g, "NPTS= 2, DT= .005 SEC", "1 2 3"), ["go on after the 2", "line 5"]),
        (file(g, "NPTS= 2, DT= .005 SEC", "1 NaN"), ["'NaN' is not a finite number", "line 5"]),
        (file(g, "NPTS= 2, DT= 0 SEC", "1 2"), ["interval 0 s", "line 4"]),
        (file(g, "NPTS, DT", "1 2"), ["cannot be read", "line 4"]),
        (file(g, "NPTS= 99999999999999999999, DT= .005", "1 2"), ["cannot be read", "line 4"]),
        (file(g, "NPTS= 1, DT= .005 SEC", "1"), ["1 sample", "at least two"]),
        (
            file("VELOCITY IN UNITS OF CM/S", "NPTS= 2, DT= .005 SEC", "1 2"),
            ["'CM/S' is not a unit", "line 3"],
        ),
        (file("?", "NPTS= 2, DT= .005 SEC", "1 2"), ["does not state the units", "units = \"g\""]),
    ] {
        let message = message(&text, &none);
        assert!(parts.iter().all(|p| message.contains(p)), "{message}");
    }
    let text = file(g, "NPTS= 2, DT= .005 SEC", "1 2");
    assert!(message(&text, &gal()).contains("states units of g"));
    assert!(message(&text, &ReadOptions { dt: Some(0.01), ..none.clone() }).contains("dt = \"0.01 s\""));
    assert!(message(&text, &ReadOptions { columns: Some(vec![]), ..none }).contains("'columns'"));
}

#[test]
fn two_columns_are_time_and_acceleration() {
    assert_eq!(one("0,12\n1,15\n2,-3\n", &gal()).acceleration, [0.12, 0.15, -0.03], "whole numbers");
    assert_eq!(one("0, 12\n1, 15\n", &gal()).acceleration, [0.12, 0.15]);
    let channel = one("# a comment\n20.520 0\n20.525\t100 # peak\n\n20.530, -50\n20.535; 1D1\n", &gal());
    assert_eq!((channel.start, channel.dt, channel.name.as_str()), (20.52, 0.005, "small"));
    assert_eq!(channel.acceleration, [0.0, 1.0, -0.5, 0.1]);
    assert_eq!(channel.units, Units::CentimetrePerSecond2);
}

#[test]
fn columns_can_be_declared_and_carry_directions() {
    let columns = ["skip", "time", "N28W", "up"].map(|c| c.parse::<TextColumn>().unwrap());
    let options = ReadOptions { columns: Some(columns.to_vec()), ..gal() };
    let channels = parse("7 0.0 1 4\n7 0.1 2 5\n7 0.2 3 6\n", &options).unwrap();
    assert_eq!(channels.len(), 2);
    assert_eq!(channels[0].orientation, Some(Orientation::from_degrees(332.0)));
    assert_eq!(channels[1].name, "small up");
    assert_eq!(channels[1].acceleration, [0.04, 0.05, 0.06]);
    assert!("sideways".parse::<TextColumn>().is_err());
}

#[test]
fn a_direction_in_a_comment_is_that_of_the_only_acceleration() {
    let text = "# direction = unknown\n# direction = \"up\"\n0 1\n0.1 2\n";
    assert_eq!(one(text, &gal()).orientation, Some(Orientation::Up));
    let columns = ["east", "north"].map(|c| c.parse::<TextColumn>().unwrap());
    let options = ReadOptions { columns: Some(columns.to_vec()), dt: Some(0.1), ..gal() };
    let channels = parse(text, &options).unwrap();
    assert_eq!(channels[1].orientation, Some(Orientation::NORTH));
    let only = ReadOptions { columns: Some(vec![columns[0], TextColumn::Skip]), dt: Some(0.1), ..gal() };
    assert_eq!(one(text, &only).orientation, Some(Orientation::EAST), "what is declared goes before");
    let none = ReadOptions { columns: Some(vec![TextColumn::Acceleration(None); 2]), dt: Some(0.1), ..gal() };
    assert!(parse(text, &none).unwrap().iter().all(|c| c.orientation.is_none()));
}

#[test]
fn missing_declarations_are_asked_for_by_key() {
    let none = ReadOptions::default();
    assert!(message("0.0 1\n0.1 2\n", &none).contains("units = \"cm/s2\""));
    assert!(message("1\n2\n", &gal()).contains("dt = \"0.005 s\""));
    // A case has no columns of directions.
    let several = message("0 1 2 3\n1 4 5 6\n", &gal());
    assert!(several.contains("columns = [\"time\", \"acceleration\", \"skip\"]"), "{several}");
    let ok = one("1\n2\n", &ReadOptions { dt: Some(0.02), ..gal() });
    assert_eq!((ok.dt, ok.acceleration), (0.02, vec![0.01, 0.02]));
}

#[test]
fn a_sensitivity_says_that_text_without_units_holds_counts() {
    let options = ReadOptions { sensitivity: "200 counts/(m/s2)".parse().ok(), ..Default::default() };
    let channel = one("0.0 100\n0.1 -50\n", &options);
    assert_eq!((channel.acceleration, channel.units, channel.raw), (vec![0.5, -0.25], Units::Counts, false));
    assert!(message("# units = \"cm/s2\"\n0.0 1\n0.1 2\n", &options).contains("not in counts"));
}

#[test]
fn a_text_file_can_declare_its_own_units_and_interval_but_not_contradict() {
    let text = "# units = \"mm/s2\"\n# dt = \"0.02 s\"\n# dt = see below\n1000\n2000\n";
    let channel = one(text, &ReadOptions::default());
    assert_eq!((channel.dt, channel.acceleration.as_slice()), (0.02, &[1.0, 2.0][..]));
    assert!(message(text, &gal()).contains("line 1: the file states units of mm/s2"));
    assert!(message(text, &ReadOptions { dt: Some(0.01), ..Default::default() }).contains("line 2"));
}

/// A gap puts the mean interval off from the second line on; the median step shows where it is.
#[test]
fn a_gap_in_a_column_of_times_is_named_at_its_line_with_the_usual_step() {
    let time = |i: usize| 0.005 * (if i < 199 { i } else { i + 60 }) as f64;
    let text: String = (0..500).map(|i| format!("{:.3} {}\n", time(i), i % 7)).collect();
    let told = message(&format!("# units = \"m/s2\"\n{text}"), &ReadOptions::default());
    for part in ["line 201:", "0.305 s from 0.99 s to 1.295 s", "usual step 0.005 s", "60 (0.3 s)"] {
        assert!(told.contains(part), "'{part}' is not in: {told}");
    }
    // A declared interval does not hide it.
    let declared = message(&text, &ReadOptions { dt: Some(0.005), ..gal() });
    assert!(declared.contains("line 200:") && declared.contains("60 (0.3 s)"), "{declared}");
}

#[test]
fn text_faults_are_named_with_their_line() {
    for (text, parts) in [
        ("", ["line 1", "holds no numbers"]),
        ("# only words\n\n", ["line 1", "holds no numbers"]),
        ("time,acc\nx 1\n", ["line 1: 'time' is not a finite number", "put # before"]),
        (
            "\ntime,acc\n0 1\n0.1 2\n",
            ["line 2: 'time' is text above the numbers", "columns = [\"time\", \"acc"],
        ),
        ("Zeit;a\n0,00;0,012\n", ["line 1: 'Zeit' is text above the numbers", "put # before"]),
        (
            "0,00;0,012\n0,01;0,013\n",
            ["line 1: '0,00' has a decimal comma", "decimal points in the whole file"],
        ),
        ("0 0\n1 1,5\n", ["line 2: '1,5' has a decimal comma", "0.012"]),
        ("1,3\n1,04\n", ["line 2: '1,04' has a decimal comma", "0.012"]),
        ("1,3\n1,4\n", ["line 1: '1,3' has a decimal comma", "0.012"]),
        ("-1,3e-2\n7\n", ["line 2: 1 number(s)", "complete or remove"]),
        ("0 1\n0.1 x\n", ["line 2: 'x' is not", "finite number"]),
        ("0 1\n0.1 inf\n", ["line 2: 'inf' is not", "finite number"]),
        ("0 1\n0.1\n", ["line 2: 1 number(s)", "complete or remove"]),
        ("0 1\n0.1 2\n0.3 3\n0.4 4\n", ["line 3: time step: 0.2 s from 0.1 s", "missing samples: 1 (0.1 s)"]),
        ("0 1\n0.1 2\n0.2 3\n0.25 4\n0.3 5\n0.4 6\n0.5 7\n", ["line 4: time step: 0.05 s", "resample"]),
        ("0 1\n0 2\n0 3\n", ["line 1: time: 0", "equally spaced"]),
        ("0.2 1\n0.1 2\n0 3\n", ["line 1", "equally spaced"]),
        ("0 1\n", ["line 1", "at least two"]),
        ("0 1e306\n1 1e308\n", ["line", "finite"]),
    ] {
        let options = ReadOptions { units: Some(Units::G), ..ReadOptions::default() };
        let message = message(text, &options);
        let too_large = message.contains("too large");
        assert!(parts.iter().all(|p| message.contains(p)) || too_large, "{text:?}: {message}");
        assert_eq!(too_large, text.contains("1e308"));
    }
}

#[test]
fn files_that_cannot_be_records_say_why() {
    let none = ReadOptions::default();
    let refuse = |bytes: &[u8]| read_bytes(Path::new("x"), bytes, &none).unwrap_err().to_string();
    assert!(refuse(&[0x1f, 0x8b, 8, 0]).contains("broken"));
    assert!(refuse(&[0xff, 0xfe, 0, 1]).contains("not a finite number"));
    assert!(
        read(Path::new("/no/such/record"), &none).unwrap_err().to_string().starts_with("/no/such/record: ")
    );
    assert!(read(Path::new("/"), &none).is_err());
}

#[test]
fn what_is_written_as_text_reads_back_bit_for_bit() {
    let record = Channel {
        file: "a".into(),
        start: 20.5,
        units: Units::G,
        ..Channel::new("a\nname", 1.0 / 300.0, (0..500).map(|i| (f64::from(i) * 0.7).sin() / 3.0).collect())
    };
    let path = std::env::temp_dir().join(format!("tremolite-motion-{}.txt", std::process::id()));
    write_text(&record, &["detrend linear".into()], &path).unwrap();
    let back = read(&path, &ReadOptions::default());
    std::fs::remove_file(&path).unwrap();
    let back = back.unwrap().remove(0);
    assert_eq!((back.dt, back.start, &back.acceleration), (record.dt, record.start, &record.acceleration));
    assert_eq!(back.orientation, None);
    for direction in [
        Orientation::Up,
        Orientation::EAST,
        Orientation::NORTH,
        Orientation::from_degrees(332.0),
        Orientation::from_degrees(4.25),
    ] {
        write_text(&Channel { orientation: Some(direction), ..record.clone() }, &[], &path).unwrap();
        let back = read(&path, &ReadOptions::default()).unwrap().remove(0);
        std::fs::remove_file(&path).unwrap();
        assert_eq!((back.orientation, &back.acceleration), (Some(direction), &record.acceleration));
    }
    assert!(write_text(&record, &[], Path::new("/no/such/folder/x.txt")).is_err());
}

#[test]
fn intervals_and_samples_beyond_all_records_are_refused() {
    let counts = "# units = \"counts\"\n1\n2\n3\n";
    for (dt, sensitivity, part) in [
        (1e300, None, "interval of 1000000"),
        (1e-300, None, "none of a record"),
        (0.01, Some(1e-300), "too large for a record"),
    ] {
        let sensitivity = sensitivity.and_then(Sensitivity::new);
        let message = message(counts, &ReadOptions { dt: Some(dt), sensitivity, ..ReadOptions::default() });
        assert!(message.contains(part) && message.contains("line"), "{message}");
    }
}
