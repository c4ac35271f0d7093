//! A network of made surveys, whose levels are known.

mod damaged;
mod growing;
mod kinds;
mod planning;
mod rails;
mod records;
mod spellings;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use riffel_network::{Judgement, NetworkError, Sections, Store, StoreSettings, SurveyFile, growth};
use riffel_rail::LimitTable;
use tempfile::TempDir;

/// A survey of two rails in blocks of a metre between two places \[m\], with RMS of `rms(rail, place)` \[µm\] between 30 and
/// 100 mm and a tenth of that between 100 and 300 mm.
fn survey(folder: &Path, name: &str, ends: [i32; 2], rms: impl Fn(usize, f64) -> f64) -> (PathBuf, SurveyFile) {
    let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um,rms_100_to_300_mm_um\n".to_owned();
    for (index, rail) in ["left", "right"].iter().enumerate() {
        for from in ends[0]..ends[1] {
            let value = rms(index, f64::from(from) + 0.5);
            writeln!(text, "{rail},{from},{},{value},{}", from + 1, 0.1 * value).unwrap();
        }
    }
    let path = folder.join(name);
    fs::write(&path, text).unwrap();
    let file = SurveyFile::check(&path).unwrap();
    (path, file)
}

fn store(folder: &TempDir) -> Store {
    Store::create_or_open(&folder.path().join("network"), StoreSettings::default()).unwrap()
}

fn take(store: &Store, line: &str, date: &str, file: &SurveyFile) {
    store.ingest(line, date, file, false, &|_| ()).unwrap();
}

fn grassie(store: &Store) -> Judgement {
    Judgement::new(store, &LimitTable::find("grassie-1999").unwrap()).unwrap()
}

/// Every file below a folder with what is in it.
fn files(folder: &Path) -> Vec<(PathBuf, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(files(&path));
        } else {
            found.push((path.clone(), fs::read(&path).unwrap()));
        }
    }
    found.sort();
    found
}

/// At a long kilometre the places of a rail go back, by whole blocks or by a part of one: both stretches are kept, as the mean of their
/// energies where both lie, and it is told.
#[test]
fn a_long_kilometre_is_kept() -> Result<(), NetworkError> {
    for back in [0.4, 20.0, 640.0] {
        let folder = tempfile::tempdir().unwrap();
        let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um\n".to_owned();
        for (begins, rms) in [(5000.0, 3.0), (6000.0 - back, 4.0)] {
            for block in 0..1000 {
                let from = begins + f64::from(block);
                writeln!(text, "left,{from},{},{rms}", from + 1.0).unwrap();
            }
        }
        let path = folder.path().join("long.csv");
        fs::write(&path, text).unwrap();
        let store = store(&folder);
        let found = store.ingest("A", "2026-01-31", &SurveyFile::check(&path)?, false, &|_| ())?;
        let [told] = &found.goes_back[..] else {
            panic!("{found:?}");
        };
        assert_eq!((told.line, told.end_m, told.from_m), (1002, 6000.0, 6000.0 - back));
        let measured = (2000.0 - back).ceil() as u64;
        assert_eq!(found.measured["left"], measured);
        let survey = &store.surveys()?[0];
        let sections = Sections::of(&store, survey, &survey.rails[0], 20.0)?.sections;
        let at = |place: f64| sections.iter().find(|one| one.from == place).unwrap().rms[0];
        assert!((at(5000.0) - 3e-6).abs() < 1e-12 && (at(6200.0) - 4e-6).abs() < 1e-12);
        if back >= 20.0 {
            assert!((at(5980.0) - 1e-6 * 12.5f64.sqrt()).abs() < 1e-12);
        }
    }
    Ok(())
}

/// A survey that is stored again changes no byte; another one is refused, and takes the place of the first if asked to. What a
/// process left half when it was killed is not believed, and is removed.
#[test]
fn surveys_are_there_whole_once_or_not_at_all() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let network = folder.path().join("network");
    let (_, file) = survey(folder.path(), "a.csv", [0, 50], |_, _| 5.0);
    let (_, other) = survey(folder.path(), "b.csv", [0, 60], |_, _| 6.0);
    take(&store, "S-Bahn/Süd", "2026-01-01", &file);
    let before = files(&network);
    let again = store.ingest("S-Bahn/Süd", "1.1.2026", &file, false, &|_| ())?;
    assert!(again.there_already);
    assert_eq!(files(&network), before);

    let refusal = store.ingest("S-Bahn/Süd", "2026-01-01", &other, false, &|_| ());
    assert!(matches!(refusal, Err(NetworkError::Conflict { .. })));
    assert_eq!(files(&network), before);

    // Arrays of the day without a record, and half-written ones: a process died. What the store has not written stays.
    let line = fs::read_dir(network.join("surveys")).unwrap().next().unwrap().unwrap().path();
    for (name, file) in [
        ("2026-01-01-0123456789ab.zarr", "zarr.json"),
        (".riffel-abc123", "half-written"),
        ("2026-02-01-0123456789ab.zarr", "zarr.json"),
        (".riffel-diary1", "today.txt"),
        ("raw", "run1.csv"),
    ] {
        fs::create_dir(line.join(name)).unwrap();
        fs::write(line.join(name).join(file), "").unwrap();
    }
    assert_eq!(store.surveys()?.len(), 1);
    store.ingest("S-Bahn/Süd", "2026-01-01", &other, true, &|_| ())?;
    assert_eq!(store.surveys()?[0].cells, 60);
    let names = fs::read_dir(&line).unwrap();
    let mut names: Vec<_> = names.map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names.len(), 5, "{names:?}");
    assert_eq!(names[0], ".riffel-diary1");
    assert_eq!(names[3..], ["2026-02-01-0123456789ab.zarr", "raw"]);
    let sections = Sections::of(&store, &store.surveys()?[0], &store.surveys()?[0].rails[0], 10.0)?;
    assert_eq!(sections.sections.len(), 6);
    assert!((sections.sections[5].rms[0] - 6e-6).abs() < 1e-18);

    // One process at a time adds.
    let _held = riffel_arrays::InUse::take(&network, "network.lock", false).unwrap();
    let refusal = store.ingest("S-Bahn/Süd", "2026-03-01", &other, false, &|_| ());
    assert!(matches!(refusal, Err(NetworkError::Locked { .. })));
    Ok(())
}

/// Files of somebody else are not touched: in a folder without the mark of a store, by way of links, or in place of the lock.
#[test]
fn what_the_store_has_not_written_stays() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let (_, file) = survey(folder.path(), "a.csv", [0, 50], |_, _| 5.0);
    let project = folder.path().join("project");
    fs::create_dir_all(project.join("surveys/A/raw")).unwrap();
    fs::write(project.join("surveys/A/raw/run1.csv"), "x").unwrap();
    let refusal = Store::create_or_open(&project, StoreSettings::default());
    assert!(matches!(refusal, Err(NetworkError::NotANetwork { .. })));

    let store = store(&folder);
    let network = folder.path().join("network");
    fs::create_dir(&network).unwrap();
    fs::write(network.join("network.lock"), "secret").unwrap();
    let refusal = Store::create_or_open(&network, StoreSettings::default());
    assert!(matches!(refusal, Err(NetworkError::NotANetwork { .. })));
    take(&store, "A", "2026-01-01", &file);
    assert_eq!(fs::read(network.join("network.lock")).unwrap(), b"secret");

    // One folder on systems that ignore capitals.
    take(&store, "Main", "2026-01-01", &file);
    let before = files(&network);
    let refusal = store.ingest("main", "2026-02-01", &file, false, &|_| ());
    assert!(matches!(refusal, Err(NetworkError::Value { .. })));
    assert_eq!(files(&network), before);

    // What systems leave everywhere is no line and no survey.
    fs::write(network.join("surveys/.DS_Store"), "x").unwrap();
    fs::write(network.join("surveys/A/._2026-01-01.json"), "x").unwrap();
    assert_eq!(store.surveys()?.len(), 2);
    // A record under another name would speak of arrays that are not its own.
    let copy = network.join("surveys/Main/2026-02-01.json");
    fs::copy(network.join("surveys/Main/2026-01-01.json"), &copy).unwrap();
    assert_eq!(store.surveys()?.len(), 2);
    assert_eq!(Store::open(&network)?.damaged().count(), 1);
    fs::remove_file(copy).unwrap();

    #[cfg(unix)]
    {
        use std::os::unix::fs::symlink;
        symlink(project.join("surveys/A"), network.join("surveys/B")).unwrap();
        symlink("Main", network.join("surveys/main")).unwrap();
        for line in ["B", "main"] {
            let refusal = store.ingest(line, "2026-01-01", &file, false, &|_| ());
            assert!(matches!(refusal, Err(NetworkError::Foreign { .. })));
        }
        assert_eq!(store.surveys()?.len(), 2);
        fs::remove_file(network.join("network.lock")).unwrap();
        symlink(project.join("lock"), network.join("network.lock")).unwrap();
        let refusal = store.ingest("A", "2026-03-01", &file, false, &|_| ());
        assert!(matches!(refusal, Err(NetworkError::Foreign { .. })));
        assert!(!project.join("lock").exists());
    }
    assert_eq!(fs::read(project.join("surveys/A/raw/run1.csv")).unwrap(), b"x");
    Ok(())
}

/// Long lines need chunks: places and levels are the same on both sides of an edge, and blocks of 0.5 m are taken together.
#[test]
fn cells_are_where_they_are_across_chunks() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let level = |place: f64| 1.0 + (place / 1000.0).floor();
    let (_, file) = survey(folder.path(), "a.csv", [-1000, 17_500], |_, place| level(place + 1000.0));
    take(&store, "A", "2026-01-01", &file);
    let survey = &store.surveys()?[0];
    assert_eq!((survey.start_m, survey.cells), (-1000.0, 18_500));
    let sections = Sections::of(&store, survey, &survey.rails[1], 1000.0)?.sections;
    assert_eq!(sections.len(), 19);
    for section in &sections {
        let expected = 1e-6 * level(section.from + 1500.0);
        assert!((section.rms[0] / expected - 1.0).abs() < 1e-12, "{section:?}");
    }
    Ok(())
}

/// A first block that was cut short says nothing of the others; a name that differs by a capital is told; a thousandth of any
/// roughness that rails have is another unit.
#[test]
fn cells_are_as_long_as_most_blocks_and_names_alike_are_told() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let write = |name: &str, rms: f64| {
        let path = folder.path().join(name);
        let blocks =
            format!("rail,from_m,to_m,rms_30_to_100_mm_um\nleft,7,10,{rms}\nleft,10,20,{rms}\nleft,20,30,{rms}\n");
        fs::write(&path, blocks).unwrap();
        path
    };
    let file = SurveyFile::check(&write("a.csv", 5.0)).unwrap();
    let first = store.ingest("Nord 1", "2026-01-01", &file, false, &|_| ())?;
    assert_eq!((first.resolution_m, &first.alike), (10.0, &None));
    let other = store.ingest("nord-1", "2026-02-01", &file, false, &|_| ())?;
    assert_eq!(other.alike.as_deref(), Some("Nord 1"));
    let again = store.ingest("Nord 1", "2026-02-01", &file, false, &|_| ())?;
    assert_eq!(again.alike, None);
    let refused = SurveyFile::check(&write("b.csv", 0.005)).unwrap_err();
    assert!(refused.to_string().contains("is the unit right?"), "{refused}");
    Ok(())
}

/// A survey of some of the bands leaves the others unknown, in whatever order its columns stand.
#[test]
fn a_survey_may_have_fewer_bands() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (path, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    fs::write(&path, "rail,from_m,to_m,rms_100_to_300_mm_um\nleft,0,10,7\n").unwrap();
    take(&store, "A", "2026-02-01", &SurveyFile::check(&path).unwrap());
    let later = &store.surveys()?[1];
    let sections = Sections::of(&store, later, &later.rails[0], 10.0)?.sections;
    let [unknown, known] = sections[0].rms[..] else {
        panic!("{:?}", sections[0]);
    };
    assert!(unknown.is_nan());
    assert!((known - 7e-6).abs() < 1e-18);
    // Growth is told in the band that both have.
    let grown = growth(&store, &grassie(&store), 10.0, None)?;
    assert_eq!(grown.len(), 1);
    assert_eq!(grown[0].band_m, [0.1, 0.3]);
    Ok(())
}
