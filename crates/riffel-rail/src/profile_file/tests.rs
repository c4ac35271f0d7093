//! Files of profiles, one profile in each format.

use std::path::PathBuf;

use riffel::Rail;
use riffel_keys::Language;

use super::*;

/// Scatter is told, and smoothed if it is given; a spike is left out with its line.
#[test]
fn scatter_is_told_and_smoothed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.csv");
    // Alternate by 10 µm: their deviation.
    let mut text = String::from("x_mm,y_mm\n");
    for index in -100..=100 {
        let x = 0.25 * f64::from(index);
        let off = if index % 2 == 0 { 0.01 } else { -0.01 };
        let spike = if index == 40 { 0.4 } else { 0.0 };
        text += &format!("{x},{}\n", -x * x / 600.0 + off + spike);
    }
    std::fs::write(&path, text).unwrap();
    let through = read_profile(&path, ProfileReading::default()).unwrap();
    let told = through.remarks[0].to_string();
    assert!(told.contains("the points scatter by") && told.contains("profiles.scatter"), "{told}");
    let smooth = read_profile(&path, ProfileReading { scatter: Some(10e-6), ..ProfileReading::default() }).unwrap();
    let told: Vec<String> = smooth.remarks.iter().map(ToString::to_string).collect();
    assert!(told[0].contains("1 points far off") && told[0].contains("line 142"), "{told:?}");
    assert!(told[1].contains("at x = 0"), "{told:?}");
    let of = |profile: &Profile| profile.at(0.1e-3).unwrap().curvature;
    assert!((of(&smooth.profile) + 1.0 / 0.3).abs() < 1.0, "{}", of(&smooth.profile));
    assert!((of(&through.profile) + 1.0 / 0.3).abs() > 100.0);
}

/// An arc of 300 mm in each way of writing is one profile.
#[test]
fn every_way_of_writing_is_one_profile() {
    let arc = |factor: f64, separator: &str| {
        (-20..=20)
            .map(|index| {
                let x = 1e-3 * f64::from(index);
                format!("{:.9}{separator}{:.9}\n", factor * x, -factor * x * x / 0.6)
            })
            .collect::<String>()
    };
    let folder = tempfile::tempdir().unwrap();
    let read = |text: &str| {
        let path = folder.path().join("rail.csv");
        std::fs::write(&path, text).unwrap();
        read_profile(&path, ProfileReading::default()).map(|read| read.profile)
    };
    for text in [
        arc(1e3, ","),
        format!("# crown at the origin\nx_mm,y_mm\n{}", arc(1e3, ",")),
        format!("x [m]; y [m]\n{}", arc(1.0, ";")),
        arc(1.0, "  ").replace('\n', "\r\n"),
        arc(1e3, ";").replace('.', ","),
        arc(1e3, "\t").replace('.', ","),
        arc(1e3, " ").replace('.', ","),
        arc(1e3, " ").replace('-', "\u{2212}"),
        arc(1e3, ",").replace(',', "D+00,").replace('\n', "D+00\n"),
        format!(
            "\"x_mm\";\"y_mm\"\n{}",
            arc(1e3, "\";\"").replace('\n', "\"\n\"").trim_end_matches('"').replacen("-20", "\"-20", 1)
        ),
    ] {
        let point = read(&text).unwrap().at(5e-3).unwrap();
        assert!((point.height + 25e-6 / 0.6).abs() < 1e-9, "{text}");
    }
    let refused = |text: String| read(&text).unwrap_err().to_string();
    let broken = arc(1e3, ",").replacen("-18.0", "-18,0", 1);
    assert!(refused(broken).contains("line 3: "));
    for (head, says) in [
        ("x_um,y_um", "the head says um"),
        ("x [µm], y [µm]", "the head says µm"),
        ("x_mm,y_m", "units of their own"),
        ("x_m,y_m", "40.0000 m across"),
    ] {
        let message = refused(format!("{head}\n{}", arc(1e3, ",")));
        assert!(message.contains(says), "{head}: {message}");
    }
    let message = refused(format!("x_mm,y_mm\n{}", arc(1.0, ",")));
    assert!(message.contains("0.040 mm across, narrower"), "{message}");
    let mut lines: Vec<String> = arc(1e3, ",").lines().map(str::to_owned).collect();
    lines.swap(9, 14);
    let message = refused(lines.join("\n"));
    assert!(message.contains("line ") && message.contains("wrong order"), "{message}");
    assert!(refused("1,2\n3,4\n".to_owned()).contains("8 points or more"));
}

/// A file of the test data.
fn file(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/profiles").join(name)
}

/// 60E1 and S1002 in each format are the nominal profiles. 2 µm: the points have tenths of a micrometre, and splines through points a
/// millimetre apart leave the corner of 8 to 13 mm by one.
#[test]
fn every_format_is_one_profile() {
    for (name, nominal, kind) in [
        ("rail.ban", "60E1", ProfileKind::Rail),
        ("rail.prr", "60E1", ProfileKind::Rail),
        ("rail.rai", "60E1", ProfileKind::Rail),
        ("wheel.whl", "S1002", ProfileKind::Wheel),
        ("wheel.prw", "S1002", ProfileKind::Wheel),
        ("wheel.whe", "S1002", ProfileKind::Wheel),
    ] {
        let nominal = NominalProfile::named(nominal).unwrap().profile();
        for side in Rail::BOTH {
            let reading = ProfileReading { side, ..ProfileReading::default() };
            let read = read_profile(&file(name), reading).unwrap();
            assert_eq!(read.kind, kind, "{name}");
            let places = match kind {
                ProfileKind::Rail => [-33.0, -20.0, 0.3, 11.0, 30.0],
                ProfileKind::Wheel => [-60.0, -39.0, -20.0, 5.0, 50.0],
            };
            for place in places.map(|place| 1e-3 * place) {
                let (one, other) = (read.profile.at(place).unwrap(), nominal.at(place).unwrap());
                let off = (one.height - other.height) / other.slope.hypot(1.0);
                assert!(off.abs() < 2e-6, "{name} at {place}: {off:e}");
            }
        }
    }
}

/// What was found is told; what is asked wins, and a wheel is no rail.
#[test]
fn orientation_is_found_or_asked() {
    let told = |name: &str| {
        let read = read_profile(&file(name), ProfileReading::default()).unwrap();
        let told: Vec<String> = read.remarks.iter().map(ToString::to_string).collect();
        told.join("\n")
    };
    for (name, words) in [
        ("rail.ban", "upside down; x below zero is taken as the gauge side"),
        ("rail.ban", "2 points that were masked"),
        ("wheel.whl", "moved to the datum circle, by x = 70.00 mm"),
        ("rail.rai", "moved to the crown, by x = 753.50 mm"),
        ("rail.rai", "the gauge of the file is 1435.0 mm, 14.0 mm below"),
        ("wheel.whe", "the flange backs of the file are 1360.0 mm apart"),
        ("wheel.prw", "its coordinates stand as they should"),
    ] {
        assert!(told(name).contains(words), "{name}: {}", told(name));
    }
    let asked = |name: &str, orientation, kind| {
        let reading = ProfileReading { orientation: Some(orientation), kind, ..ProfileReading::default() };
        read_profile(&file(name), reading)
    };
    let mirrored = asked("rail.prr", ProfileOrientation::Mirrored, None).unwrap();
    assert!((mirrored.profile.range()[0] + 36.77e-3).abs() < 1e-4, "{:?}", mirrored.profile.range());
    let refused = asked("rail.prr", ProfileOrientation::Found, Some(ProfileKind::Wheel)).err().unwrap();
    assert!(refused.to_string().contains("a wheel is asked for"), "{refused}");
    // A table is taken as written, and turned if that is asked.
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wheel.txt");
    let nominal = NominalProfile::named("S1002").unwrap().profile();
    let text: String = nominal
        .sampled(1e-3)
        .iter()
        .map(|point| format!("{} {} # towards the middle of the track, down\n", -1e3 * point.x, -1e3 * point.height))
        .collect();
    std::fs::write(&path, text).unwrap();
    for (orientation, is_nominal) in [
        (None, false),
        (Some(ProfileOrientation::AsWritten), false),
        (Some(ProfileOrientation::Turned), true),
        (Some(ProfileOrientation::Found), true),
    ] {
        let reading = ProfileReading { orientation, ..ProfileReading::default() };
        let read = read_profile(&path, reading).unwrap().profile;
        let off = read.at(-30e-3).unwrap().height - nominal.at(-30e-3).unwrap().height;
        assert_eq!(off.abs() < 1e-5, is_nominal, "{orientation:?}: {off}");
    }
}

/// The open source of CONTACT takes % for a remark in files of Simpack, too.
#[test]
fn remarks_stand_in_files_of_simpack() {
    let text = std::fs::read_to_string(file("rail.prr")).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.prr");
    let remarked = text.replacen("spline.begin", "% a remark\nspline.begin ! another one", 1);
    std::fs::write(&path, format!("% a remark\n{remarked}")).unwrap();
    let [plain, remarked] = [file("rail.prr"), path].map(|path| {
        let read = read_profile(&path, ProfileReading::default()).unwrap();
        read.profile.at(-30e-3).unwrap().height
    });
    assert_eq!(plain, remarked);
}

/// The German of a refusal has no word that only English has.
#[track_caller]
fn assert_german(error: &CaseError) -> String {
    let german = error.message().text(Language::German);
    assert_ne!(german, error.message().text(Language::English));
    for english in [" the ", " is ", " and ", " are ", " but ", " must ", " has ", " or ", " of "] {
        assert!(!german.contains(english), "{english} in: {german}");
    }
    german
}

/// Tables and wheels that are no profile, in German.
#[test]
fn wrong_profiles_are_refused_in_german() {
    let folder = tempfile::tempdir().unwrap();
    let points = |across: f64| -> String {
        let row = |x: i32| format!("{},{}\n", across * f64::from(x), -f64::from(x * x) / 600.0);
        (-30..=30).map(row).collect()
    };
    let wheel = ProfileReading { kind: Some(ProfileKind::Wheel), ..ProfileReading::default() };
    let smooth = ProfileReading { scatter: Some(-1e-5), ..ProfileReading::default() };
    for (name, text, reading, german) in [
        ("a.csv", "1,2\nx,3\n".to_owned(), ProfileReading::default(), "ist kein Zahlenpaar x, y"),
        ("a.csv", "1,2,3\n".to_owned(), ProfileReading::default(), "es gibt 3 Spalten, ein Profil"),
        ("a.csv", "x_um,y_um\n1,2\n".to_owned(), ProfileReading::default(), "der Kopf sagt um:"),
        ("a.csv", "x_mm,y_m\n1,2\n".to_owned(), ProfileReading::default(), "verschiedene Einheiten"),
        ("a.csv", "1,2\n3,4\n".to_owned(), ProfileReading::default(), "braucht mindestens 8 Punkte"),
        ("a.csv", format!("x_m,y_m\n{}", points(1.0)), ProfileReading::default(), "60,0000 m breit, breiter"),
        ("a.csv", format!("x_mm,y_mm\n{}", points(0.01)), ProfileReading::default(), "0,600 mm breit, schmaler"),
        ("a.csv", points(1.0).replacen("-20,", "-26,", 1), ProfileReading::default(), "quer zum Gleis um"),
        ("a.csv", points(1.0), smooth, "die Streuung der Punkte ist -0,00001 m"),
        ("a.ban", format!("X=1\n\n{}", points(1.0)), wheel, "verlangt ist aber ein Rad"),
        ("a.slcs", "0 1 2\n".to_owned(), ProfileReading::default(), "eine Liste von Schnitten"),
        ("a.csv", "\u{89}HDF\0\0".to_owned(), ProfileReading::default(), "die Datei ist binär"),
    ] {
        let path = folder.path().join(name);
        std::fs::write(&path, &text).unwrap();
        let error = read_profile(&path, reading).err().unwrap();
        let said = assert_german(&error);
        assert!(said.contains(german), "{german} not in: {said}");
    }
}

/// A file that is cut, or has a letter among its numbers, is refused with its line.
#[test]
fn broken_files_are_refused_with_their_line() {
    let folder = tempfile::tempdir().unwrap();
    let refused = |name: &str, from: &str, to: &str| {
        let text = std::fs::read_to_string(file(name)).unwrap();
        assert!(text.contains(from), "{name}: {from}");
        let path = folder.path().join(name);
        std::fs::write(&path, text.replacen(from, to, 1)).unwrap();
        match read_profile(&path, ProfileReading::default()) {
            Err(error) => {
                assert_german(&error);
                error.to_string()
            }
            Ok(_) => panic!("{name} with {to} was taken"),
        }
    };
    for (name, from, to, words) in [
        ("rail.prr", "spline.end", "", "line 5: spline.begin has no spline.end"),
        ("rail.prr", "units.len.f = 1000.", "units.len.f = mm", "line 6: spline.units.len.f is \"mm\""),
        ("rail.prr", "0.00000   -0.00000", "0.00000", "is not a point y z"),
        ("rail.prr", "header.begin", "spline.begin\nnonsense.begin", "line 2: \"nonsense.begin\" is no section"),
        ("rail.ban", "ColumnDef=X,Y", "ColumnDef=A,B", "line 5: ColumnDef is \"A,B\""),
        ("wheel.whl", "0.0000,", "zero,", "line 6: \"zero,   -5.0000, 0.0\" has no numbers X and Y"),
        ("wheel.whe", "TREADDATUM EUROPEAN", "TREADDATUM TRAM", "line 3: TREADDATUM is \"TRAM\""),
        ("rail.rai", "GAUGE 1435.0", "GAUGE 1435.0\n1 2 3", "line 5: \"1 2 3\" is not y and z of both sides"),
    ] {
        let message = refused(name, from, to);
        assert!(message.contains(words), "{name}: {message}");
    }
    let slices = folder.path().join("rail.slcs");
    std::fs::write(&slices, "0 1 2\n").unwrap();
    let error = read_profile(&slices, ProfileReading::default()).err().unwrap();
    assert!(error.to_string().contains("list of slices"), "{error}");
}

/// Outlines that close or cross themselves are refused with the line at which they do.
#[test]
fn closed_and_crossing_outlines_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.csv");
    let refused = |points: &[(f64, f64)]| {
        let text: String = points.iter().map(|(x, y)| format!("{x:.4},{y:.4}\n")).collect();
        std::fs::write(&path, format!("x_mm,y_mm\n{text}")).unwrap();
        let refused = read_profile(&path, ProfileReading::default());
        let error = refused.err().unwrap();
        assert_german(&error);
        error.to_string()
    };
    let head: Vec<(f64, f64)> = (-30..=30).map(|x| (f64::from(x), -f64::from(x * x) / 600.0)).collect();
    let mut closed = head.clone();
    closed.extend((-30..=30).map(|x| (f64::from(-x), -40.0)));
    closed.push((-30.0, -1.6));
    let message = refused(&closed);
    assert!(message.contains("line 124") && message.contains("closes here"), "{message}");
    let mut crossing = head;
    crossing.extend([(20.0, -2.0), (10.0, 1.0)]);
    let message = refused(&crossing);
    assert!(message.contains("line 6") && message.contains("crosses"), "{message}");
}

/// A wheel of MiniProf 5 mm off its datum circle is put there by XOffset, unless its flange back shows that it is there already;
/// without the offset its place on the axle is said to be off, by 4.9 mm, for the nominal profile begins 0.1 mm before its flange back.
#[test]
fn offsets_of_a_file_are_added() {
    let nominal = NominalProfile::named("S1002").unwrap().profile();
    let folder = tempfile::tempdir().unwrap();
    let read = |off: f64, head: &str| {
        let points = nominal.sampled(2.5e-4);
        let rows = points.iter().map(|point| format!("{:.4}\t{:.4}\n", 1e3 * point.x - off, 1e3 * point.height));
        let text = format!("Filename=x.whl\n{head}ColumnDef=X,Y\n\n{}", rows.collect::<String>());
        let path = folder.path().join("x.whl");
        std::fs::write(&path, text).unwrap();
        let read = read_profile(&path, ProfileReading::default()).unwrap();
        let told: Vec<String> = read.remarks.iter().map(ToString::to_string).collect();
        let height = read.profile.at(-30e-3).unwrap().height;
        (height - nominal.at(-30e-3).unwrap().height, told.join("\n"))
    };
    let (off, told) = read(5.0, "XOffset=5.0\nYOffset=0.0\n");
    assert!(off.abs() < 1e-6 && told.contains("are added, 5.00 mm"), "{off} {told}");
    let (off, told) = read(0.0, "XOffset=5.0\n");
    assert!(off.abs() < 1e-6 && told.contains("is left out"), "{off} {told}");
    let (off, told) = read(5.0, "");
    assert!(off.abs() > 1e-4 && told.contains("the wheel stands 4.9 mm off"), "{off} {told}");
    let (_, told) = read(0.4, "");
    assert!(!told.contains("flange back"), "{told}");
    let bad = folder.path().join("bad.whl");
    std::fs::write(&bad, "XOffset=five\nColumnDef=X,Y\n\n0 0\n").unwrap();
    let refused = read_profile(&bad, ProfileReading::default()).err().unwrap();
    assert!(refused.to_string().contains("no number in millimetres"), "{refused}");
}

/// Whatever datum a file of Vampire names, the wheel stands where its flange back says.
#[test]
fn a_tread_datum_does_not_move_the_wheel() {
    let text = std::fs::read_to_string(file("wheel.whe")).unwrap();
    assert!(text.contains("TREADDATUM"));
    let folder = tempfile::tempdir().unwrap();
    let read = |datum: &str| {
        let lines = text.lines().map(|line| match line.starts_with("TREADDATUM") {
            true => format!("TREADDATUM {datum}\n"),
            false => format!("{line}\n"),
        });
        let path = folder.path().join("wheel.whe");
        std::fs::write(&path, lines.collect::<String>()).unwrap();
        let read = read_profile(&path, ProfileReading::default()).unwrap();
        let told: Vec<String> = read.remarks.iter().map(ToString::to_string).collect();
        (read.profile.at(-30e-3).unwrap().height, told.join("\n"))
    };
    let (european, plain) = read("EUROPEAN");
    for (datum, place) in [("US1", "72.23"), ("US2", "77.79"), ("65", "65.00")] {
        let (height, told) = read(datum);
        assert_eq!(height, european, "{datum}");
        assert!(told.contains(&format!("its tread datum lies {place} mm")), "{told}");
    }
    assert!(!plain.contains("tread datum"), "{plain}");
}

/// The head of a rail that is inclined 1:40 or 1:20 leans to its gauge side: drawn the other way round it is turned over where the
/// format leaves that open, and said where it does not; a rail that stands upright, worn at its side or not, is not.
#[test]
fn an_inclined_rail_shows_its_gauge_side() {
    let nominal = NominalProfile::named("60E1").unwrap().profile();
    let folder = tempfile::tempdir().unwrap();
    let read = |name: &str, slope: f64, side: f64, worn: f64| {
        // Turned inward: the head leans to x below zero.
        let points = nominal.turned(slope.atan()).sampled(2.5e-4).into_iter();
        let kept = points.filter(|point| point.x > nominal.range()[0] + worn);
        let mut rows: Vec<String> =
            kept.map(|point| format!("{:.4} {:.4}\n", 1e3 * side * point.x, 1e3 * point.height)).collect();
        if side < 0.0 {
            rows.reverse();
        }
        let head = if name.ends_with("ban") { "Filename=x\nColumnDef=X,Y\n\n" } else { "" };
        let path = folder.path().join(name);
        std::fs::write(&path, format!("{head}{}", rows.concat())).unwrap();
        let read = read_profile(&path, ProfileReading::default()).unwrap();
        let told: Vec<String> = read.remarks.iter().map(ToString::to_string).collect();
        (read.profile.at(-30e-3).unwrap().height, told.join("\n"))
    };
    for slope in [1.0 / 40.0, 1.0 / 20.0] {
        let (as_it_is, told) = read("x.ban", slope, 1.0, 0.0);
        assert!(told.contains("stand as they should; its head leans by"), "{told}");
        let (turned, told) = read("x.ban", slope, -1.0, 0.0);
        assert!((turned - as_it_is).abs() < 1e-6, "{turned} {as_it_is}");
        assert!(told.contains("are mirrored; its head leans by"), "{told}");
        let (_, told) = read("x.txt", slope, -1.0, 0.0);
        assert!(told.contains("to x above zero"), "{told}");
        let (_, told) = read("x.txt", slope, 1.0, 0.0);
        assert!(!told.contains("leans"), "{told}");
    }
    for worn in [0.0, 5e-3] {
        let (_, told) = read("x.ban", 0.0, 1.0, worn);
        assert!(told.contains("x below zero is taken as the gauge side"), "{told}");
    }
}

/// Where nothing was measured over 25 mm, that is said; points that lie evenly, near or far, have no gap.
#[test]
fn gaps_are_told() {
    let points = |keep: fn(f64) -> bool, step: f64| -> Vec<[f64; 2]> {
        let count = (0.12 / step) as usize;
        let across = (0..=count).map(|index| -0.06 + step * index as f64);
        across.filter(|x| keep(*x)).map(|x| [x, 0.05 * x]).collect()
    };
    let told = of_gaps("w", &points(|x| !(-0.045..-0.02).contains(&x), 0.25e-3));
    let told = told.unwrap().to_string();
    assert!(told.contains("no points across -45.") && told.contains("to -20.0 mm"), "{told}");
    assert_eq!(of_gaps("w", &points(|_| true, 0.25e-3)), None);
    assert_eq!(of_gaps("w", &points(|_| true, 8e-3)), None);
}

/// Columns are taken by their names in whichever order, beside row numbers; of two rails in one file none is taken.
#[test]
fn columns_are_found_by_their_names() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.csv");
    let read = |head: &str, row: &dyn Fn(usize, f64, f64) -> String| {
        let rows = (0..=40).map(|index| {
            let across = f64::from(index) - 20.0;
            row(index as usize, across, -across * across / 600.0) + "\n"
        });
        std::fs::write(&path, format!("{head}\n{}", rows.collect::<String>())).unwrap();
        let read = read_profile(&path, ProfileReading::default());
        read.map(|read| read.profile.at(5e-3).unwrap().height).map_err(|error| error.to_string())
    };
    let there = |_: usize, across: f64, up: f64| format!("{across},{up}");
    let back = |_: usize, across: f64, up: f64| format!("{up},{across}");
    let numbered = |index: usize, across: f64, up: f64| format!("{index},{across},{up}");
    let twice = |_: usize, across: f64, up: f64| format!("{across},{up},{across},{up}");
    type Row<'a> = &'a dyn Fn(usize, f64, f64) -> String;
    let cases: [(&str, Row<'_>); 15] = [
        ("y_mm,z_mm", &there),
        ("z_mm,y_mm", &back),
        ("Y [mm];Z [mm]", &|i, x, h| there(i, x, h).replace(',', ";")),
        ("y_mm,x_mm", &back),
        ("height_mm,lateral_mm", &back),
        ("Höhe [mm],Querlage [mm]", &back),
        ("Querlage_mm,Höhe_mm", &there),
        ("vertical,horizontal", &back),
        ("horizontal,vertical", &there),
        ("Höhe,Ort", &back),
        ("korkeus,leveys", &there),
        (",y_mm,z_mm", &numbered),
        ("Nr,x_mm,y_mm", &numbered),
        (",z_mm,y_mm", &|i, x, h| numbered(i, h, x)),
        ("station_mm,y_mm,z_mm", &numbered),
    ];
    for (head, row) in cases {
        let height = read(head, row).unwrap();
        assert!((height + 25e-3 / 600.0).abs() < 1e-9, "{head}: {height}");
    }
    let four = "y_left_mm,z_left_mm,y_right_mm,z_right_mm";
    for (head, row, says) in [
        (four, &twice as &dyn Fn(usize, f64, f64) -> String, "line 1: there are 4 columns"),
        ("# no head", &twice, "line 2: there are 4 columns"),
        ("x_mm,y_mm,z_mm", &numbered, "line 1: there are 3 columns"),
        ("# no head", &numbered, "line 2: there are 3 columns"),
    ] {
        let refusal = read(head, row).unwrap_err();
        assert!(refusal.contains(says), "{head}: {refusal}");
    }
}

/// Of 200 made-up rails, with points 0.1 to 0.5 mm apart that scatter by 20 µm, worn by up to 8 mm at the gauge face and flattened by up to
/// 0.3 mm at the crown, mirrored or not, measured up to 5 mrad aslant, all are read alike with their rows in either order; of the 100 that are inclined 56 are
/// told by their lean, all of them rightly, and 44, flat or worn, are taken as they are written; of the 100 that stand upright none is turned.
// Long: reads 400 files of drawn rails, as many as its counts are of.
#[test]
fn a_head_shows_its_gauge_side() {
    let mut state = 53_u64;
    let mut drawn = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 53) as f64
    };
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.ban");
    let (mut right, mut open, mut wrong, mut upright_turned, mut unequal) = (0, 0, 0, 0, 0);
    for index in 0..200 {
        let slope: f64 = [0.0, 1.0 / 40.0, 0.0, 1.0 / 20.0][index % 4];
        let name = ["60E1", "60E2", "54E1"][(3.0 * drawn()) as usize];
        let aslant = (10.0 * drawn() - 5.0) * 1e-3;
        let nominal = NominalProfile::named(name).unwrap().profile();
        let nominal = nominal.turned(slope.atan() + aslant);
        let worn = if drawn() < 0.5 { 0.0 } else { 8e-3 * drawn() };
        let flat = nominal.crown().height - 3e-4 * drawn();
        let face = nominal.range()[0] + worn;
        let outline = nominal.along([1e-4, 2.5e-4, 5e-4][(3.0 * drawn()) as usize]);
        let kept = outline.iter().filter(|point| worn == 0.0 || point.x > face);
        let kept: Vec<[f64; 2]> = kept.map(|point| [point.x, point.height.min(flat)]).collect();
        let below = (0..40).rev().map(|step| [face, kept[0][1] - 2.5e-4 * f64::from(step + 1)]);
        let below: Vec<[f64; 2]> = below.filter(|_| worn > 0.0).collect();
        let side = if drawn() < 0.5 { 1.0 } else { -1.0 };
        let rows: Vec<String> = (below.iter().chain(&kept))
            .map(|[x, height]| {
                let scatter = 20e-6 * ((0..12).map(|_| drawn()).sum::<f64>() - 6.0);
                format!("{:.3} {:.3}\n", 1e3 * side * x, 1e3 * (height + scatter))
            })
            .collect();
        let is_mirrored = |rows: &[String]| {
            let text = format!("Filename=x\nColumnDef=X,Y\n\n{}", rows.concat());
            std::fs::write(&path, text).unwrap();
            let reading = ProfileReading { scatter: Some(20e-6), ..ProfileReading::default() };
            let read = read_profile(&path, reading).unwrap();
            let told: String = read.remarks.iter().map(ToString::to_string).collect();
            (told.contains("are mirrored"), told.contains("leans by"))
        };
        let (mirrored, leans) = is_mirrored(&rows);
        let reversed: Vec<String> = rows.iter().rev().cloned().collect();
        unequal += usize::from(is_mirrored(&reversed) != (mirrored, leans));
        match (slope > 0.0, leans) {
            (true, true) if mirrored == (side < 0.0) => right += 1,
            (true, true) => wrong += 1,
            (true, false) => open += 1,
            (false, _) => upright_turned += usize::from(mirrored),
        }
    }
    assert_eq!([wrong, upright_turned, unequal], [0; 3]);
    assert!(right >= 56, "{right}, {open} left open");
}

/// The head of a flat crown of 1 m, 50 mrad aslant, leans by some 24 mm: it is taken as it is written, and said to be undecided.
#[test]
fn a_head_that_leans_too_far_is_undecided() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("x.ban");
    let (flat, corner) = (0.026_f64, 13.0);
    let place = |index: i32| {
        let turn = 0.01 * f64::from(index.abs() - 26);
        let angle = flat + turn.max(0.0);
        let x = match index.abs() <= 26 {
            true => f64::from(index.abs()),
            false => (1000.0 - corner) * flat.sin() + corner * angle.sin(),
        };
        let height = match index.abs() <= 26 {
            true => (1e6 - x * x).sqrt() - 1000.0,
            false => (1000.0 - corner) * flat.cos() + corner * angle.cos() - 1000.0,
        };
        [x.copysign(f64::from(index)), height]
    };
    let points: Vec<[f64; 2]> = (-170..=170).map(place).collect();
    let rail = Profile::through(&points.iter().map(|point| point.map(|it| 1e-3 * it)).collect::<Vec<_>>());
    let rows = rail.unwrap().turned(0.05).along(2.5e-4).into_iter();
    let rows = rows.map(|point| format!("{:.4} {:.4}\n", 1e3 * point.x, 1e3 * point.height));
    let text = format!("Filename=x\nColumnDef=X,Y\n\n{}", rows.collect::<String>());
    std::fs::write(&path, text).unwrap();
    let read = read_profile(&path, ProfileReading::default()).unwrap();
    let told: String = read.remarks.iter().map(ToString::to_string).collect();
    assert!(told.contains("leans by 24.") && told.contains("is undecided"), "{told}");
}
