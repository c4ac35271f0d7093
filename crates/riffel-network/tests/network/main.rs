//! A network of made surveys, whose levels are known.

mod growing;
mod records;

use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};

use riffel_network::{
    Aim, Budget, ExpectedGrowth, Judgement, NetworkError, Sections, Store, StoreSettings,
    SurveyFile, growth, plan, status, worst,
};
use riffel_rail::LimitTable;
use tempfile::TempDir;

/// A survey of two rails in blocks of a metre between two places \[m\], with RMS of `rms(rail, place)` \[µm\] between 30 and
/// 100 mm and a tenth of that between 100 and 300 mm.
fn survey(
    folder: &Path,
    name: &str,
    ends: [i32; 2],
    rms: impl Fn(usize, f64) -> f64,
) -> (PathBuf, SurveyFile) {
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

/// A kilometre of 5 µm on which 100 m have 40 µm: found where they are, on the rail on which they are.
#[test]
fn the_worst_place_is_found() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [12_000, 13_000], |rail, place| {
        if rail == 1 && (12_300.0..12_400.0).contains(&place) {
            40.0
        } else {
            5.0
        }
    });
    take(&store, "Main line", "2026-01-31", &file);
    let judgement = grassie(&store);
    let places = worst(&store, &judgement, 100.0, None, 3)?;
    assert_eq!(places.len(), 3);
    let first = &places[0];
    assert_eq!(
        (first.line.as_str(), first.rail.as_str()),
        ("Main line", "right")
    );
    assert_eq!((first.from_m, first.to_m), (12_300.0, 12_400.0));
    assert!((first.rms_m / 40e-6 - 1.0).abs() < 1e-12);
    assert!((places[1].rms_m / 5e-6 - 1.0).abs() < 1e-12);
    // 8 times as rough, 8 times as far over.
    assert!((first.rms_over_limit / places[1].rms_over_limit - 8.0).abs() < 1e-9);

    let found = status(&store)?;
    assert_eq!(found.lines[0].ends_m, [12_000.0, 13_000.0]);
    assert_eq!(found.lines[0].measured_m[0], ("left".to_owned(), 1000.0));
    // 1900 m of 25 and 100 m of 1600 µm².
    let mean = ((1900.0 * 25.0 + 100.0 * 1600.0) / 2000.0f64).sqrt() * 1e-6;
    assert!((found.lines[0].rms_m[0].unwrap() / mean - 1.0).abs() < 1e-12);
    Ok(())
}

/// Of a line with one survey, and of a rail that was ground, the growth that is expected stands in; where surveys show how a rail
/// grows it stands beside that alone. 5 dB below the limit and 10 dB a year are 6 months.
#[test]
fn growth_that_is_expected_stands_in_where_surveys_show_none() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 100], |_, _| 1.0);
    take(&store, "Probe", "2026-01-01", &file);
    let judgement = grassie(&store);
    let limit = 1e-6 / worst(&store, &judgement, 100.0, None, 1)?[0].rms_over_limit;
    let rms = |decibels: f64| 1e6 * limit * 10f64.powf(decibels / 20.0);
    let flat = |name: &str, decibels: f64| {
        let (_, file) = survey(folder.path(), name, [0, 100], |_, _| rms(decibels));
        file
    };
    take(&store, "One", "2026-01-01", &flat("one.csv", -5.0));
    take(&store, "Ground", "2026-01-01", &flat("before.csv", 2.0));
    take(&store, "Ground", "2026-03-15", &flat("after.csv", -10.0));
    take(&store, "Measured", "2026-01-01", &flat("earlier.csv", -7.0));
    take(&store, "Measured", "2026-03-15", &flat("later.csv", -5.0));
    let expected = ExpectedGrowth {
        median: 10.0,
        band_50: [8.0, 12.0],
        band_80: [5.0, 20.0],
    };
    let bands = judgement.ends_of_bands().len();
    let judgement = judgement.expecting(&store, None, vec![Some(expected); bands])?;
    let grown = growth(&store, &judgement, 100.0, None)?;
    let of = |line: &str| grown.iter().find(|section| section.line == line).unwrap();
    let [one, ground, measured] = ["One", "Ground", "Measured"].map(of);
    assert!((one.months_to_limit.unwrap() - 6.0).abs() < 1e-9);
    assert_eq!((one.growth_db_per_year, one.surveys), (None, 1));
    assert!(ground.ground && (ground.months_to_limit.unwrap() - 12.0).abs() < 1e-9);
    let yearly = 2.0 / 73.0 * 365.2425;
    assert!((measured.months_to_limit.unwrap() - 12.0 * 5.0 / yearly).abs() < 1e-6);
    assert_eq!(measured.expected_growth_db_per_year, Some(expected));

    // After seven months the first and the last are over it, but not the ground one.
    let budget = Budget::of_length(1000.0);
    let planned = plan(&store, &judgement, 100.0, 7.0, &budget, Aim::WorstFirst)?;
    let mut lines: Vec<&str> = planned.sites.iter().map(|site| &*site.line).collect();
    lines.sort_unstable();
    assert_eq!(lines, ["Measured", "One"]);

    let refused = grassie(&store).expecting(&store, Some("Two"), Vec::new());
    let sentence = refused.unwrap_err().to_string();
    assert!(
        sentence.contains("\"Two\"") && sentence.contains("Measured, One"),
        "{sentence}"
    );
    Ok(())
}

/// A rail that grows by 2 dB in 73 days grows by 10.007 dB a year, of 365.2425 days; from 5 dB below its limit it reaches it in
/// 6 months.
#[test]
fn growth_between_dates_tells_when_a_limit_is_reached() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 300], |_, _| 1.0);
    take(&store, "A", "2026-01-01", &file);
    let judgement = grassie(&store);
    let limit = 1e-6 / worst(&store, &judgement, 100.0, None, 1)?[0].rms_over_limit;
    let rms = |decibels: f64| 1e6 * limit * 10f64.powf(decibels / 20.0);
    // The first of three sections was ground in between.
    let (_, before) = survey(folder.path(), "b.csv", [0, 300], |_, place| {
        rms(if place < 100.0 { 6.0 } else { -7.0 })
    });
    let (_, after) = survey(folder.path(), "c.csv", [0, 300], |_, place| {
        rms(if place < 100.0 { -20.0 } else { -5.0 })
    });
    let line = "B";
    take(&store, line, "2026-01-01", &before);
    take(&store, line, "2026-03-15", &after);
    let grown = growth(&store, &judgement, 100.0, None)?;
    // Three sections of two rails; line A has one survey.
    assert_eq!(grown.len(), 6);
    let first = &grown[0];
    assert!((first.growth_db_per_year.unwrap() - 2.0 / 73.0 * 365.2425).abs() < 1e-6);
    let months = 12.0 * 5.0 / first.growth_db_per_year.unwrap();
    assert!((first.months_to_limit.unwrap() - months).abs() < 1e-6);
    let ground: Vec<_> = grown.iter().filter(|section| section.ground).collect();
    assert_eq!(ground.len(), 2);
    assert!(
        ground
            .iter()
            .all(|section| section.from_m == 0.0 && section.months_to_limit.is_none())
    );

    // Nothing is over the limit now but in a year two sections of track are.
    let one = Budget::of_length(100.0);
    let now = plan(&store, &judgement, 100.0, 0.0, &one, Aim::WorstFirst)?;
    assert_eq!((now.over_limit_m, now.sites.len()), (0.0, 0));
    let later = plan(&store, &judgement, 100.0, 12.0, &one, Aim::WorstFirst)?;
    assert_eq!(
        (later.over_limit_m, later.length_m, later.left_over_limit_m),
        (200.0, 100.0, 100.0)
    );
    Ok(())
}

/// Three sections over the limit by 12, 6 and 6 dB; the first two join on and need one site.
#[test]
fn a_plan_takes_the_worst_first_and_keeps_its_budget() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 600], |_, place| match place {
        place if place < 100.0 => 40.0,
        place if place < 200.0 => 20.0,
        place if place > 500.0 => 21.0,
        _ => 1.0,
    });
    take(&store, "A", "2026-01-01", &file);
    let judgement = grassie(&store);
    let budget = |money: f64| Budget {
        money,
        per_metre: 2.0,
        per_site: 300.0,
    };
    let sites = |money: f64| -> Result<Vec<(f64, f64, f64)>, NetworkError> {
        let found = plan(
            &store,
            &judgement,
            100.0,
            0.0,
            &budget(money),
            Aim::WorstFirst,
        )?;
        assert!(found.cost <= money);
        let sites = found.sites.iter();
        Ok(sites
            .map(|site| (site.from_m, site.to_m, site.cost))
            .collect())
    };
    assert_eq!(sites(499.0)?, []);
    assert_eq!(sites(500.0)?, [(0.0, 100.0, 500.0)]);
    // 21 µm at 500 m does not fit; 20 µm that joins on does.
    assert_eq!(sites(700.0)?, [(0.0, 200.0, 700.0)]);
    assert_eq!(sites(1200.0)?, [(0.0, 200.0, 700.0), (500.0, 600.0, 500.0)]);
    let refused = plan(
        &store,
        &judgement,
        100.0,
        0.0,
        &budget(-1.0),
        Aim::WorstFirst,
    );
    assert!(refused.is_err());
    Ok(())
}

/// One section far over its limit, and far from it four somewhat over it: for the money of one site the worst first leaves two
/// of these, the most track the one.
#[test]
fn the_most_track_is_that_of_one_site() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 1000], |_, place| match place {
        place if place < 100.0 => 40.0,
        place if place > 600.0 => 20.0,
        _ => 1.0,
    });
    take(&store, "A", "2026-01-01", &file);
    let budget = Budget {
        money: 1100.0,
        per_metre: 2.0,
        per_site: 300.0,
    };
    let judgement = grassie(&store);
    let found = |aim| plan(&store, &judgement, 100.0, 0.0, &budget, aim);
    let (worst, most) = (found(Aim::WorstFirst)?, found(Aim::MostTrack)?);
    let ends = |plan: &riffel_network::GrindingPlan| -> Vec<(f64, f64)> {
        let sites = plan.sites.iter();
        sites.map(|site| (site.from_m, site.to_m)).collect()
    };
    assert_eq!(ends(&worst), [(0.0, 100.0), (600.0, 700.0)]);
    assert_eq!(ends(&most), [(600.0, 1000.0)]);
    assert_eq!((most.cost, most.left_over_limit_m), (1100.0, 100.0));
    assert_eq!(worst.left_over_limit_m, 300.0);
    // 1100 pay for no fifth section, and both say so.
    assert_eq!(
        [worst, most].map(|plan| plan.least_left_over_limit_m),
        [100.0; 2]
    );
    Ok(())
}

/// The same survey again changes no byte; another one is refused, and takes the place of the first if asked to. What a
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
    let line = fs::read_dir(network.join("surveys"))
        .unwrap()
        .next()
        .unwrap()
        .unwrap()
        .path();
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
    let sections = Sections::of(
        &store,
        &store.surveys()?[0],
        &store.surveys()?[0].rails[0],
        10.0,
    )?;
    assert_eq!(sections.sections.len(), 6);
    assert!((sections.sections[5].rms[0] - 6e-6).abs() < 1e-18);

    // One process at a time adds.
    let lock = fs::File::open(network.join("network.lock")).unwrap();
    lock.lock().unwrap();
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
    assert_eq!(
        fs::read(project.join("surveys/A/raw/run1.csv")).unwrap(),
        b"x"
    );
    Ok(())
}

/// Long lines need chunks: places and levels are the same on both sides of an edge, and blocks of 0.5 m are taken together.
#[test]
fn cells_are_where_they_are_across_chunks() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let level = |place: f64| 1.0 + (place / 1000.0).floor();
    let (_, file) = survey(folder.path(), "a.csv", [-1000, 17_500], |_, place| {
        level(place + 1000.0)
    });
    take(&store, "A", "2026-01-01", &file);
    let survey = &store.surveys()?[0];
    assert_eq!((survey.start_m, survey.cells), (-1000.0, 18_500));
    let sections = Sections::of(&store, survey, &survey.rails[1], 1000.0)?.sections;
    assert_eq!(sections.len(), 19);
    for section in &sections {
        let expected = 1e-6 * level(section.from + 1500.0);
        assert!(
            (section.rms[0] / expected - 1.0).abs() < 1e-12,
            "{section:?}"
        );
    }
    Ok(())
}

#[test]
fn what_is_wrong_is_refused_with_its_line() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("wrong.csv");
    let head = "rail,from_m,to_m,rms_30_to_100_mm_um";
    for (text, part) in [
        (String::new(), "no column from_m"),
        (format!("{head}\n"), "no block"),
        ("rail,from_m,to_m,level\n".to_owned(), "no column of RMS"),
        (
            "rail,from_m,to_m,rms_30_to_100_mm\n".to_owned(),
            "no band and unit",
        ),
        (
            "rail,from_m,to_m,rms_100_to_30_mm_m\n".to_owned(),
            "no band and unit",
        ),
        (
            format!("{head}\nleft,0,1,5\nleft,1,2\n"),
            "line 3: has 3 columns",
        ),
        (
            format!("{head}\nleft,0,1,5\nleft,1,2,rough\n"),
            "line 3: column 4 is \"rough\"",
        ),
        (
            format!("{head}\nleft,0,1,-5\n"),
            "line 2: the RMS between 30 and 100 mm is",
        ),
        (format!("{head}\nleft,0,1,5e5\n"), "is its unit right"),
        (format!("{head}\nleft,1,0,5\n"), "must end after it begins"),
        (
            format!("{head}\nleft,0,1,5\nleft,0.5,1.5,5\n"),
            "must rise and not overlap",
        ),
        (
            format!("{head}\nleft,0,1,5\nleft,1,inf,5\n"),
            "must end after it begins",
        ),
        (format!("{head}\n ,0,1,5\n"), "the rail has no name"),
    ] {
        fs::write(&path, &text).unwrap();
        let refusal = SurveyFile::check(&path).unwrap_err().in_words();
        assert!(refusal.contains(part), "{text}: {refusal}");
    }
    let store = store(&folder);
    assert!(matches!(
        Store::open(&folder.path().join("network")),
        Err(NetworkError::NoNetwork { .. })
    ));
    let (_, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    let put = |line: &str, date: &str| store.ingest(line, date, &file, false, &|_| ());
    for (line, date, part) in [
        ("", "2026-01-01", "the line is"),
        (
            "A",
            "2026-02-30",
            "the date \"2026-02-30\" is not in the calendar",
        ),
        ("A", "yesterday", "the date \"yesterday\" is no date"),
    ] {
        let refusal = put(line, date).unwrap_err().to_string();
        assert!(refusal.contains(part), "{refusal}");
    }
    assert!(!folder.path().join("network/network.json").exists());
    put("A", "2026-01-01").unwrap();
    fs::write(&path, "rail,from_m,to_m,rms_10_to_30_mm_um\nleft,0,1,5\n").unwrap();
    let other = SurveyFile::check(&path).unwrap();
    let refusal = store
        .ingest("A", "2026-02-01", &other, false, &|_| ())
        .unwrap_err();
    assert!(
        refusal
            .to_string()
            .contains("must be of those of the store, 30–100 mm, 100–300 mm"),
        "{refusal}"
    );
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
    assert!(matches!(
        Store::open(&network),
        Err(NetworkError::DamagedStore { .. })
    ));
    Ok(())
}

/// A byte that changed on the disk is found.
#[test]
fn damage_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    let chunk = files(&folder.path().join("network"))
        .into_iter()
        .find(|(path, _)| path.ends_with("left/c/0/0"));
    let (path, mut bytes) = chunk.unwrap();
    bytes[3] ^= 1;
    fs::write(path, bytes).unwrap();
    let refusal = worst(&store, &grassie(&store), 10.0, None, 1);
    assert!(matches!(refusal, Err(NetworkError::Damaged { .. })));
}

/// A first block that was cut short says nothing of the others; a name that differs by a capital is told; a thousandth of any
/// roughness that rails have is another unit.
#[test]
fn cells_are_as_long_as_most_blocks_and_names_alike_are_told() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let write = |name: &str, rms: f64| {
        let path = folder.path().join(name);
        let blocks = format!(
            "rail,from_m,to_m,rms_30_to_100_mm_um\nleft,7,10,{rms}\nleft,10,20,{rms}\nleft,20,30,{rms}\n"
        );
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
    assert!(
        refused.to_string().contains("is the unit right?"),
        "{refused}"
    );
    Ok(())
}

/// A survey of some of the bands leaves the others unknown, in whatever order its columns stand.
#[test]
fn a_survey_may_have_fewer_bands() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (path, file) = survey(folder.path(), "a.csv", [0, 10], |_, _| 5.0);
    take(&store, "A", "2026-01-01", &file);
    fs::write(
        &path,
        "rail,from_m,to_m,rms_100_to_300_mm_um\nleft,0,10,7\n",
    )
    .unwrap();
    take(
        &store,
        "A",
        "2026-02-01",
        &SurveyFile::check(&path).unwrap(),
    );
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
