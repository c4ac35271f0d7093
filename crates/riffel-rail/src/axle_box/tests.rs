//! What is said of wrong files, in German.

use std::fs;

use riffel_keys::{CaseError, Language, Message};

use super::{AxleBoxFile, AxleBoxLayout, AxleBoxReading};

const HEAD: &str = "time_s;acceleration_left_m_per_s2;speed_km_per_h";
const WITH_ODOMETER: &str = "time_s;acceleration_left_m_per_s2;odometer_m";

/// Rows at 1 kHz; `change` may alter time, acceleration and place of a row.
fn table(head: &str, change: impl Fn(usize, &mut [f64; 3])) -> Vec<u8> {
    let rows = (0..2000).map(|row| {
        let noise = ((row * 7919) % 1000) as f64 / 100.0 - 5.0;
        let mut values = [1e-3 * row as f64, noise, 72.0];
        change(row, &mut values);
        let [time, acceleration, place] = values;
        format!("{time:.4};{acceleration};{place}\n")
    });
    format!("{head}\n{}", rows.collect::<String>()).into_bytes()
}

/// A WAV file of one channel of 16 bits, whose head tells of so many bytes, and the tag of its form.
fn wave(tag: u8, bytes: u32) -> Vec<u8> {
    let mut wave = b"RIFF\x80\x02\0\0WAVEfmt \x10\0\0\0".to_vec();
    wave.extend([tag, 0, 1, 0]);
    wave.extend([1000u32, 2000].iter().flat_map(|value| value.to_le_bytes()));
    wave.extend(*b"\x02\0\x10\0data");
    wave.extend(bytes.to_le_bytes());
    wave.extend([0u8; 600]);
    wave
}

/// A signal of a universal file: its title, kind and unit, begin \[s\] and spacing \[s\].
fn signal(title: &str, kind: &str, unit: &str, [begin, step]: [f64; 2], time: &str) -> String {
    let values = (0..12).map(|row| {
        let end = if row % 6 == 5 { "\n" } else { "" };
        format!("{:13.5e}{end}", f64::from(row) / 50.0)
    });
    let none = "         0    0    0    0 NONE                 NONE                \n";
    format!(
        "    -1\n    58\n{title}\nNONE\nNONE\nNONE\nNONE\n    1         0    0         0 NONE               1   3 NONE               0   0\n\
         {:10}{:10}{:10}{begin:13.5e}{step:13.5e}{:13.5e}\n        17    0    0    0 Time                 {time:<20}\n\
         {kind:>10}    0    0    0 Ordinate             {unit:<20}\n{none}{none}{}    -1\n",
        2,
        12,
        1,
        0.0,
        values.collect::<String>()
    )
}

/// The refusal of a file, or what is said of it when it is read.
fn said(bytes: &[u8], layout: &AxleBoxLayout) -> Vec<Message> {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("run");
    fs::write(&path, bytes).unwrap();
    let mut visit = |_: AxleBoxReading<'_>| Ok(());
    let read = AxleBoxFile::open(&path, layout)
        .and_then(|file| file.read(None, &mut visit, &|_| ()))
        .map(|(remarks, _)| remarks);
    match read {
        Ok(remarks) => remarks,
        Err(CaseError::Data { message, help, .. }) => [message].into_iter().chain(help).collect(),
        Err(other) => panic!("{other}"),
    }
}

/// What lacks in the German of a refusal or remark, or is English in it.
fn fault(bytes: &[u8], layout: &AxleBoxLayout, german: &str) -> Option<String> {
    const ENGLISH: [&str; 9] = [" the ", " is ", " and ", " are ", " but ", " must ", " give ", " has ", " or "];
    let all = said(bytes, layout);
    let all = all.iter().map(|one| one.text(Language::German));
    let all = all.collect::<Vec<String>>().join("; ");
    let padded = format!(" {all} ");
    let english = ENGLISH.iter().find(|english| padded.contains(**english));
    match (all.contains(german), english) {
        (true, None) => None,
        (true, Some(english)) => Some(format!("{english} in: {all}")),
        (false, _) => Some(format!("{german} not in: {all}")),
    }
}

#[track_caller]
fn is_said(bytes: &[u8], layout: &AxleBoxLayout, german: &str) {
    assert_eq!(fault(bytes, layout, german), None);
}

fn plain() -> AxleBoxLayout {
    AxleBoxLayout::default()
}

#[test]
fn wrong_tables_are_refused_in_german() {
    let refused = [
        (table(HEAD, |row, values| values[0] -= if row > 99 { 0.05 } else { 0.0 }), "die Zeit fällt von 0,099 s auf"),
        (table(HEAD, |_, values| values[0] = 1.0), "die Zeiten steigen nicht"),
        (table(HEAD, |row, values| values[0] *= 1.0 + 3e-5 * row as f64), "müssen aber auf 2 % eine Rate ergeben"),
        (table(HEAD, |row, values| values[2] = 50.0 - 0.1 * row as f64), "darf aber nicht kleiner als null sein"),
        (table(HEAD, |_, values| values[2] = 900.0), "250,0 m/s, 900 km/h, und damit höher"),
        (
            table(WITH_ODOMETER, |row, values| values[2] = 100.0 - 0.02 * row as f64),
            "der Weg fällt von 100 m auf 99,98 m",
        ),
        (table(WITH_ODOMETER, |row, values| values[2] = 0.3 * row as f64), "nach dem Weg fährt der Zug 300,"),
        (
            table(HEAD, |_, values| values[1] = values[1].min(3.0)),
            "left: bei 3,0000 m/s² übersteuert, in 228 Abtastwerten, 11,40 %; zuerst bei Zeile",
        ),
        (
            table(HEAD, |_, values| values[1] = values[1].clamp(-3.0, 3.0)),
            "bei 3,0000 m/s² und -3,0000 m/s² übersteuert",
        ),
        (
            table(HEAD, |_, values| values[1] = 0.01 * values[1] + 1.0),
            "so groß wie die Erdbeschleunigung in g: die Einheit ist falsch; in g angeben",
        ),
        (table(HEAD, |_, values| values[1] *= 1e4), "mehr als an jedem Achslager"),
        (table("time_s;acceleration_left;speed_km_per_h", |_, _| ()), "hat keine Einheit, die"),
        (table("time_s;acceleration_g;temperature", |_, _| ()), "keine Spalte mit Geschwindig"),
        (table("time_s;kettle;speed_km_per_h", |_, _| ()), "keine Spalte mit Beschleunigungen;"),
        (table("row;acceleration_g;speed_m_per_s", |_, _| ()), "keine Spalte mit Zeiten"),
        (table(HEAD, |_, values| values[2] = f64::NAN), "ist in den meisten Zeilen leer"),
        (b"1;2;3\n4;5;6\n".to_vec(), "keine Tabelle unter einem Kopf"),
        (b"\xff\xfet\0;\0a\0\n\0".to_vec(), "die Datei ist UTF-16"),
        (b"\x89HDF\r\n\x1a\n".to_vec(), "die Datei ist HDF5, wie MATLAB"),
        (b"ab\0\0\0cd".to_vec(), "die Datei ist binär: Byte 3"),
        (format!("{HEAD}\nnow;1;2\nthen;3;4\n").into_bytes(), "Spalte 1, `time_s`, enthält keine Zahlen"),
        ([table(HEAD, |_, _| ()), vec![b'1'; 70_000]].concat(), "die Zeile ist länger als 65536 Bytes"),
        (table("time_s;acceleration_g;acceleration_g", |_, _| ()), "keine Spalte mit Geschwindigkeiten"),
    ];
    let faults = refused.into_iter();
    let faults: Vec<String> = faults.filter_map(|(bytes, german)| fault(&bytes, &plain(), german)).collect();
    assert!(faults.is_empty(), "{faults:#?}");
    let rate = AxleBoxLayout { rate: Some(1200.0), ..plain() };
    is_said(&table(HEAD, |_, _| ()), &rate, "--rate sagt aber 1200");
    let rate = AxleBoxLayout { rate: Some(1005.0), ..plain() };
    is_said(&table(HEAD, |_, _| ()), &rate, "eine der beiden Uhren geht falsch");
    let channels = AxleBoxLayout { channels: vec!["acceleration_g=1".to_owned()], ..plain() };
    is_said(&table(HEAD, |_, _| ()), &channels, "--channels ist für WAV-Dateien");
}

#[test]
fn what_is_passed_over_is_said_in_german() {
    let leaping = table(HEAD, |row, values| {
        values[0] += if row > 500 { 1.0 } else { 0.0 };
    });
    is_said(&leaping, &plain(), "wo die Zeit springt: einmal, bei Zeile 503");
    let dead = table(HEAD, |row, values| {
        if (800..1000).contains(&row) {
            values[1] = 0.123;
        }
    });
    is_said(&dead, &plain(), "left: fällt einmal aus und behält länger als 50 ms");
    let jumping = table(WITH_ODOMETER, |row, values| {
        values[2] = 0.02 * row as f64 + 100.0 * (row / 900) as f64;
    });
    is_said(&jumping, &plain(), "der Weg springt um mehr als 20 m: 2-mal, zuerst");
    let filtered = table("time_s;acceleration_left_bandpass_g;speed_km_per_h", |_, _| ());
    is_said(&filtered, &plain(), "\"left bandpass\" ist, was ein Filter übrig ließ");
    let drifting = table(HEAD, |row, values| values[0] *= 1.0 + 3e-6 * row as f64);
    is_said(&drifting, &plain(), "die Uhr driftet");
    let lacking = table(HEAD, |row, values| {
        values[1] = if row == 7 { 99999.0 } else { values[1] };
    });
    is_said(&lacking, &plain(), "99999 steht für einen fehlenden Wert: einmal");
    let clipped = table(HEAD, |row, values| {
        values[1] = if (50..54).contains(&row) { 9.0 } else { values[1] };
    });
    is_said(&clipped, &plain(), "Pegel sind dort zu niedrig");
    let rows = (0..2000)
        .map(|row| format!("{:.3};{};72;{}\n", 1e-3 * f64::from(row), row * 7919 % 1000 - 500, 0.03 * f64::from(row)));
    let head = "time_s;acceleration_left_m_per_s2;speed_km_per_h;odometer_m\n";
    let contrary = (head.to_owned() + &rows.collect::<String>()).into_bytes();
    is_said(&contrary, &plain(), "km/h: eines von beiden ist falsch oder hat eine andere Einheit");
}

#[test]
fn wrong_wav_files_are_refused_in_german() {
    for (tag, bytes, channels, german) in [
        (1, 600, "", "eine WAV-Datei hat keine Einheiten"),
        (1, 600, "acceleration_g=1,speed_km_per_h=2", "die Datei hat 1 Kanal, --channels nennt aber 2"),
        (1, 600, "acceleration_g", "muss aber jedem Kanal seinen Wert"),
        (1, 600, "acceleration=2", "--channels: Spalte `acceleration` hat keine Einheit"),
        (1, 600, "speed_km_per_h=2", "nennt keine Beschleunigung"),
        (1, 600, "acceleration_g=2", "kein Kanal ist die Geschwindigkeit oder der Weg"),
        (2, 600, "", "nur ganze Zahlen von 8 bis 32 Bit"),
        (1, 800, "acceleration_g=2", "Abtastwert 301: die WAV-Datei endet"),
    ] {
        let layout = AxleBoxLayout {
            channels: channels.split(',').filter(|one| !one.is_empty()).map(str::to_owned).collect(),
            speed: (bytes == 800).then_some(20.0),
            ..plain()
        };
        is_said(&wave(tag, bytes), &layout, german);
    }
    let other = AxleBoxLayout { channels: vec!["acceleration_g=2".to_owned()], speed: Some(20.0), rate: Some(2000.0) };
    is_said(&wave(1, 600), &other, "die Datei nennt 1000 Abtastwerte je Sekunde");
    is_said(b"RIFX\0\0\0\0WAVE", &plain(), "keine RIFF- oder RF64-Datei");
    is_said(b"RIFF\0\0\0\0WAVEdata\x01\0\0\0", &plain(), "stehen vor deren Format");
    is_said(b"RIFF\0\0\0\0WAVEfmt \x01\0\0\0", &plain(), "ihr Format ist abgeschnitten");
}

#[test]
fn wrong_universal_files_are_refused_in_german() {
    const EVEN: [f64; 2] = [0.0, 1e-3];
    let left = |times, second| signal("left", "12", "m/s^2", times, second);
    let odometer = |unit: &str, times| signal("way", "8", unit, times, "s");
    for (text, german) in [
        (odometer("m", EVEN), "keine Beschleunigung über der Zeit"),
        (left(EVEN, "s"), "weder Geschwindigkeit (Art 11) noch Weg"),
        (left(EVEN, "s") + &odometer("m", [0.0, 2e-3]), "muss 12 reelle Werte mit einem Schritt"),
        (left(EVEN, "s") + &odometer("m", [3.0, 1e-3]), "\"way\" beginnt bei 3 s und \"left\" bei 0 s"),
        (left(EVEN, "bar") + &odometer("m", EVEN), "und das ist keine Zeiteinheit"),
        (left(EVEN, "s") + &odometer("kg", EVEN), "\"way\" ist ein Weg, trägt aber die Einheit \"kg\""),
        (left(EVEN, "s") + &odometer("NONE", EVEN), "\"way\" ist ein Weg ohne Einheit"),
    ] {
        is_said(text.as_bytes(), &plain(), german);
    }
    let cut = b"    -1\n    58\nleft\n";
    is_said(cut, &plain(), "Zeile 1: das Dataset, das hier beginnt, ist vom Ende");
    let letter = left(EVEN, "s").replace("        12 ", "        xx ");
    is_said(letter.as_bytes(), &plain(), "die Anzahl der Punkte muss eine ganze Zahl");
}
