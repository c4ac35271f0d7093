//! A store with damage, and what is refused.

use std::fs;

use riffel_network::{Judgement, NetworkError, Store, StoreSettings, SurveyFile, worst};
use riffel_rail::LimitTable;

use super::{files, grassie, store, survey, take};

#[test]
fn what_is_wrong_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wrong.csv");
    let head = "rail,from_m,to_m,rms_30_to_100_mm_um";
    for (text, part) in [
        (String::new(), "no column from_m"),
        (format!("{head}\n"), "no block"),
        ("rail,from_m,to_m,level\n".to_owned(), "no column of RMS"),
        ("rail,from_m,to_m,rms_30_to_100_mm\n".to_owned(), "no band and unit"),
        ("rail,from_m,to_m,rms_100_to_30_mm_m\n".to_owned(), "no band and unit"),
        (format!("{head}\nleft,0,1,5\nleft,1,2\n"), "line 3: has 3 columns"),
        (format!("{head}\nleft,0,1,5\nleft,1,2,rough\n"), "line 3: column 4 is \"rough\""),
        (format!("{head}\nleft,0,1,-5\n"), "line 2: the RMS between 30 and 100 mm is"),
        (format!("{head}\nleft,0,1,5e5\n"), "is its unit right"),
        (format!("{head}\nleft,1,0,5\n"), "must end after it begins"),
        (format!("{head}\nleft,0,1,5\nleft,0.5,1.5,5\n"), "must rise and not overlap"),
        (format!("{head}\nleft,0,1,5\nleft,1,inf,5\n"), "must end after it begins"),
        (format!("{head}\nleft,0,10,5\nleft,5,15,5\nleft,10,20,5\n"), "line 3: left: the block begins at 5.000 m"),
        (format!("{head}\nleft,0,1,5\nleft,1,2,5\nleft,0,1,5\nleft,1,2,5\n"), "not to the first block"),
        (format!("{head}\nleft,5000,5001,5\nleft,6001,6002,5\nleft,5001,5002,5\n"), "by 1000 m at most"),
        (format!("{head}\n ,0,1,5\n"), "the rail has no name"),
    ] {
        fs::write(&path, &text).unwrap();
        let refusal = SurveyFile::check(&path).unwrap_err().in_words();
        assert!(refusal.contains(part), "{text}: {refusal}");
    }
    let store = store(&folder);
    assert!(matches!(Store::open(&folder.path().join("network")), Err(NetworkError::NoNetwork { .. })));
    let (_, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    let put = |line: &str, date: &str| store.ingest(line, date, &file, false, &|_| ());
    for (line, date, part) in [
        ("", "2026-01-01", "the line is"),
        ("A", "2026-02-30", "the date \"2026-02-30\" is not in the calendar"),
        ("A", "yesterday", "the date \"yesterday\" is no date"),
    ] {
        let refusal = put(line, date).unwrap_err().to_string();
        assert!(refusal.contains(part), "{refusal}");
    }
    assert!(!folder.path().join("network/network.json").exists());
    put("A", "2026-01-01").unwrap();
    fs::write(&path, "rail,from_m,to_m,rms_10_to_30_mm_um\nleft,0,1,5\n").unwrap();
    let other = SurveyFile::check(&path).unwrap();
    let refusal = store.ingest("A", "2026-02-01", &other, false, &|_| ()).unwrap_err();
    assert!(refusal.to_string().contains("must be of those of the store, 30–100 mm, 100–300 mm"), "{refusal}");
    let levels = LimitTable::find("iso-3095-2013").unwrap();
    assert!(Judgement::new(&store, &levels).is_err());
    assert!(worst(&store, &grassie(&store), 0.5, None, 1).is_err());
    let foreign = Store::create_or_open(folder.path(), StoreSettings::default());
    assert!(matches!(foreign, Err(NetworkError::NotANetwork { .. })));
}

/// A survey of which a file is lost, empty or changed is named and left out, and keeps no other from being read or added; the
/// same file takes its place if that is asked for.
#[test]
fn what_is_damaged_is_left_out_and_can_be_replaced() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let network = folder.path().join("network");
    let (_, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    let record = network.join("surveys/A/2026-01-01.json");
    let text = fs::read_to_string(&record).unwrap();
    let entries = fs::read_dir(record.parent().unwrap()).unwrap();
    let mut entries = entries.map(|entry| entry.unwrap().path());
    let arrays = entries.find(|path| path.is_dir()).unwrap();
    let chunk = arrays.join("left/c/0/0");
    let damages: [(&str, &dyn Fn()); 5] = [
        ("an empty record", &|| fs::write(&record, "").unwrap()),
        ("a record beyond reason", &|| {
            let text = text.replace("\"cells\": 10", "\"cells\": 10000000000");
            fs::write(&record, text).unwrap();
        }),
        ("a lost record", &|| fs::remove_file(&record).unwrap()),
        ("a lost chunk", &|| fs::remove_file(&chunk).unwrap()),
        ("lost arrays", &|| fs::remove_dir_all(&arrays).unwrap()),
    ];
    for (number, (what, damage)) in damages.into_iter().enumerate() {
        damage();
        let opened = Store::open(&network)?;
        assert_eq!(opened.damaged().count(), 1, "{what}");
        let of_line = opened.surveys()?;
        assert!(of_line.iter().all(|survey| survey.line != "A"), "{what}");
        take(&store, &format!("other {number}"), "2026-01-01", &file);
        if what != "a lost record" {
            let refusal = store.ingest("A", "2026-01-01", &file, false, &|_| ());
            assert!(refusal.is_err(), "{what}");
        }
        store.ingest("A", "2026-01-01", &file, true, &|_| ())?;
        assert_eq!(Store::open(&network)?.damaged().count(), 0, "{what}");
    }
    fs::write(
        network.join("network.json"),
        "{\"format\":1,\"riffel_version\":\"0\",\"resolution_m\":1,\"bands_m\":[]}",
    )
    .unwrap();
    assert!(matches!(Store::open(&network), Err(NetworkError::DamagedStore { .. })));
    Ok(())
}

/// A byte that changed on the disk is found.
#[test]
fn damage_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    let chunk = files(&folder.path().join("network")).into_iter().find(|(path, _)| path.ends_with("left/c/0/0"));
    let (path, mut bytes) = chunk.unwrap();
    bytes[3] ^= 1;
    fs::write(path, bytes).unwrap();
    let refusal = worst(&store, &grassie(&store), 10.0, None, 1);
    assert!(matches!(refusal, Err(NetworkError::Damaged { .. })));
}
