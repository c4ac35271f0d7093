//! Folders of results.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use riffel_study::{ChunkState, ParameterValue, ResultFolder, Shard, Stop, Study, StudyError};

use crate::{PLAN, folder_with, read, study_of};

/// All files below a folder with their bytes.
fn files(folder: &Path) -> BTreeMap<PathBuf, Vec<u8>> {
    fn walk(folder: &Path, root: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                walk(&path, root, files);
            } else {
                let name = path.strip_prefix(root).unwrap().to_owned();
                files.insert(name, fs::read(&path).unwrap());
            }
        }
    }
    let mut found = BTreeMap::new();
    walk(folder, folder, &mut found);
    found
}

fn run(study: &Study, path: &Path, shard: Shard) -> ResultFolder {
    let folder = ResultFolder::begin(study, path).unwrap();
    let chunks = folder.pending(shard).unwrap();
    study.run(&folder, &chunks, &|| (), &Stop::default()).unwrap();
    folder
}

fn states_of(folder: &ResultFolder) -> Vec<ChunkState> {
    let states = folder.states(Shard::ALL).unwrap();
    states.into_iter().map(|(_, state)| state).collect()
}

// Long: computes a study in several ways.
#[test]
fn threads_shards_and_chunks_change_nothing() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    let whole = place.path().join("whole");
    let folder = run(&study, &whole, Shard::ALL);
    assert!(folder.pending(Shard::ALL).unwrap().is_empty());

    // One chunk after the other on one thread.
    let serial = place.path().join("serial");
    let one = ResultFolder::begin(&study, &serial).unwrap();
    for chunk in one.pending(Shard::ALL).unwrap().into_iter().rev() {
        one.commit(&study.compute(chunk)).unwrap();
    }
    assert!(files(&whole) == files(&serial));

    // Seven shards, each in its folder, merged.
    let parts: Vec<PathBuf> = (1..=7).map(|part| place.path().join(format!("part-{part}"))).collect();
    for (part, path) in (1..).zip(&parts) {
        run(&study, path, Shard::new(part, 7).unwrap());
    }
    let merged = place.path().join("merged");
    let paths: Vec<&Path> = parts.iter().map(PathBuf::as_path).collect();
    let report = ResultFolder::merge(&merged, &paths).unwrap();
    assert_eq!((report.copied, report.there_already, report.missing.len()), (6, 0, 0));
    assert!(files(&whole) == files(&merged));
    let again = ResultFolder::merge(&merged, &paths).unwrap();
    assert_eq!((again.copied, again.there_already), (0, 6));

    // Chunks of another size hold the same numbers.
    let other = study_of(&PLAN.replace("samples_per_chunk = 4", "samples_per_chunk = 9"));
    let others = run(&other, &place.path().join("other"), Shard::ALL);
    for variable in study.outputs().variables() {
        let [one, other] = [&folder, &others].map(|folder| folder.output(&variable.name).unwrap());
        assert!(one.iter().zip(&other).all(|(a, b)| a.to_bits() == b.to_bits()));
        assert_eq!(one.len(), 23 * study.outputs().length(variable));
    }
}

#[test]
fn what_is_written_is_read() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    run(&study, place.path(), Shard::ALL);
    let (recorded, folder) = ResultFolder::open(place.path()).unwrap();
    assert_eq!(recorded.fingerprint, study.fingerprint);
    let rates = folder.output("highest_growth_rate").unwrap();
    let sections = folder.parameter("rail.section").unwrap();
    let force = folder.output("point_1_normal_force_n").unwrap();
    for sample in 0..23 {
        let computed = recorded.sample(sample as u64);
        let outputs = computed.outputs.unwrap();
        assert_eq!(rates[sample], outputs[1]);
        assert_eq!(sections[sample], computed.parameters[2]);
        // The last three numbers of a sample are those of the point.
        assert_eq!(force[2 * sample..2 * sample + 2], outputs[outputs.len() - 3..outputs.len() - 1]);
    }
    assert!(matches!(&sections[0], ParameterValue::Text(name) if name.contains('E') || name == "BS113A"));
}

#[test]
fn only_missing_and_damaged_chunks_are_computed() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    let folder = run(&study, place.path(), Shard::ALL);
    let before = files(place.path());
    let arrays = folder.arrays_path();

    // A file cut short, one with a wrong bit, one lost; a record cut short, one lost.
    let cut = arrays.join("ridge_frequency/c/0");
    let bytes = fs::read(&cut).unwrap();
    fs::write(&cut, &bytes[..bytes.len() / 2]).unwrap();
    let wrong = arrays.join("growth_rate/c/1/0/0");
    let mut bytes = fs::read(&wrong).unwrap();
    bytes[100] ^= 1;
    fs::write(&wrong, bytes).unwrap();
    fs::remove_file(arrays.join("failure/c/2")).unwrap();
    fs::write(place.path().join("finished/000003.json"), "{").unwrap();
    fs::remove_file(place.path().join("finished/000004.json")).unwrap();
    // And what a killed process leaves.
    fs::write(arrays.join("failure/c/.riffel-abc123"), "half").unwrap();

    let states = states_of(&folder);
    assert_eq!(states[0], ChunkState::Damaged(cut));
    assert_eq!(states[1], ChunkState::Damaged(wrong));
    assert!(matches!(states[2], ChunkState::Damaged(_)));
    assert!(matches!(states[3], ChunkState::Damaged(_)));
    assert_eq!(states[4], ChunkState::Missing);
    assert_eq!(states[5], ChunkState::Finished);
    assert_eq!(folder.pending(Shard::ALL).unwrap(), [0, 1, 2, 3, 4]);
    assert!(matches!(folder.output("growth_rate"), Err(StudyError::Incomplete { missing: 1, .. })));

    let kept = place.path().join("finished/000005.json");
    let time = fs::metadata(&kept).unwrap().modified().unwrap();
    let folder = run(&study, place.path(), Shard::ALL);
    folder.sweep().unwrap();
    assert_eq!(fs::metadata(&kept).unwrap().modified().unwrap(), time);
    assert!(files(place.path()) == before);
}

#[test]
fn a_folder_of_another_plan_is_left_alone() {
    let place = tempfile::tempdir().unwrap();
    run(&study_of(PLAN), place.path(), Shard::new(1, 3).unwrap());
    let before = files(place.path());
    let other = study_of(&PLAN.replace("seed = 4", "seed = 5"));
    let error = ResultFolder::begin(&other, place.path()).err().unwrap();
    assert!(matches!(error, StudyError::OtherPlan { .. }), "{error}");
    assert!(error.to_string().ends_with("holds the results of another plan"));

    let record = place.path().join("study.json");
    let text = fs::read_to_string(&record).unwrap();
    let version = env!("CARGO_PKG_VERSION");
    fs::write(&record, text.replace(version, "0.0.1")).unwrap();
    let error = ResultFolder::begin(&study_of(PLAN), place.path()).err().unwrap();
    assert!(matches!(error, StudyError::OtherVersion { .. }), "{error}");
    fs::write(&record, text).unwrap();
    assert!(files(place.path()) == before);

    let strange = tempfile::tempdir().unwrap();
    fs::write(strange.path().join("thesis.tex"), "").unwrap();
    let error = ResultFolder::begin(&other, strange.path()).err().unwrap();
    assert!(matches!(error, StudyError::NotAStudy { .. }), "{error}");
    assert_eq!(files(strange.path()).len(), 1);
}

#[test]
fn a_merge_checks_before_it_writes() {
    let place = tempfile::tempdir().unwrap();
    let [one, two, into] = ["one", "two", "into"].map(|name| place.path().join(name));
    let study = study_of(PLAN);
    run(&study, &one, Shard::new(1, 3).unwrap());
    run(&study, &two, Shard::new(2, 3).unwrap());
    let report = ResultFolder::merge(&into, &[&one, &two]).unwrap();
    assert_eq!((report.copied, &report.missing[..]), (4, &[2, 5][..]));
    fs::remove_dir_all(&into).unwrap();

    let file = two.join("results.zarr/ridge_frequency/c/1");
    let whole = fs::read(&file).unwrap();
    fs::write(&file, &whole[..10]).unwrap();
    let error = ResultFolder::merge(&into, &[&one, &two]).unwrap_err();
    assert!(matches!(error, StudyError::Damaged { chunk: 1, .. }), "{error}");
    assert!(!into.exists());
    fs::write(&file, whole).unwrap();

    let other = place.path().join("other");
    run(&study_of(&PLAN.replace("seed = 4", "seed = 5")), &other, Shard::new(3, 3).unwrap());
    let error = ResultFolder::merge(&into, &[&one, &other]).unwrap_err();
    assert!(matches!(error, StudyError::OtherPlan { .. }), "{error}");
    assert!(!into.exists());

    // The same chunk with other numbers, checksums and all.
    let mut chunk = study.compute(0);
    if let Ok(values) = &mut chunk.samples[0].outputs {
        values[0] += 1.0;
    }
    ResultFolder::begin(&study, &two).unwrap().commit(&chunk).unwrap();
    let error = ResultFolder::merge(&into, &[&one, &two]).unwrap_err();
    assert!(matches!(error, StudyError::Conflict { chunk: 0, .. }), "{error}");
    assert!(!into.exists());
}

/// Where nothing can be written the study ends with a sentence, and what was finished stays.
#[test]
fn a_place_that_takes_no_file_ends_the_study() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    let folder = run(&study, place.path(), Shard::new(1, 2).unwrap());
    let blocked = folder.arrays_path().join("ridge_wavelength/c/1/0");
    fs::create_dir_all(&blocked).unwrap();
    let pending = folder.pending(Shard::ALL).unwrap();
    let error = study.run(&folder, &pending, &|| (), &Stop::default()).unwrap_err();
    assert!(matches!(error, StudyError::Write { .. }), "{error}");
    fs::remove_dir_all(&blocked).unwrap();
    let folder = run(&study, place.path(), Shard::ALL);
    assert!(folder.pending(Shard::ALL).unwrap().is_empty());
}

#[test]
fn a_wish_to_stop_keeps_finished_chunks() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    let folder = ResultFolder::begin(&study, place.path()).unwrap();
    let stop = Stop::default();
    let count = std::sync::atomic::AtomicU64::new(0);
    let progress = || {
        if count.fetch_add(1, std::sync::atomic::Ordering::Relaxed) == 9 {
            stop.ask();
        }
    };
    study.run(&folder, &folder.pending(Shard::ALL).unwrap(), &progress, &stop).unwrap();
    let left = folder.pending(Shard::ALL).unwrap().len();
    assert!((1..6).contains(&left), "{left}");
    let summary = folder.summary().unwrap();
    assert_eq!(summary.chunks_finished as usize, 6 - left);
}

/// The data that a case reads is part of the study, and goes with its results.
#[test]
fn data_of_the_case_is_recorded() {
    let plan = "case = \"measured.toml\"\ndesign = { method = \"grid\" }\noutputs.ridge = true\n[[parameter]]\n\
                key = \"contact.friction\"\nvalues = [0.3, 0.4]\n";
    let place = folder_with(plan);
    let table: String = (0..60).map(|k| format!("{},1e-9,-1e-9\n", 50.0 * 1.08f64.powi(k))).collect();
    fs::write(place.path().join("hammer.csv"), format!("frequency_hz,re,im\n{table}")).unwrap();
    let case = riffel_case::NOMINAL_CASE.replace("model = \"free-beam\" ", "model = \"measured\" ")
        + "\n[track.measurement]\nfile = \"hammer.csv\"\nreal = \"re\"\nimaginary = \"im\"\n";
    fs::write(place.path().join("measured.toml"), case).unwrap();
    let study = read(place.path()).unwrap_or_else(|error| panic!("{error}"));
    let results = place.path().join("results");
    run(&study, &results, Shard::ALL);
    let moved = place.path().join("moved");
    fs::rename(&results, &moved).unwrap();
    fs::remove_file(place.path().join("hammer.csv")).unwrap();
    let (recorded, folder) = ResultFolder::open(&moved).unwrap();
    assert_eq!(recorded.sample(1).outputs.unwrap()[1], folder.output("highest_growth_rate").unwrap()[1]);

    fs::write(moved.join("hammer.csv"), format!("frequency_hz,re,im\n{table}").replace("-1e-9", "-2e-9")).unwrap();
    assert!(matches!(ResultFolder::open(&moved), Err(StudyError::OtherPlan { .. })));
}

/// A second run of the same shard is told, and so is one of all beside shards; other shards go on, and nothing is left.
#[test]
fn two_runs_into_one_folder_are_noticed() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    let folder = ResultFolder::begin(&study, place.path()).unwrap();
    let before = files(place.path());
    let shard = |index: u64| format!("{index}/3").parse::<Shard>().unwrap();
    let is_taken = |shard: Shard| {
        let taken = folder.occupy(shard);
        matches!(taken, Err(riffel_study::StudyError::InUse { .. }))
    };
    let whole = folder.occupy(Shard::ALL).unwrap();
    assert!(is_taken(Shard::ALL) && is_taken(shard(1)));
    drop(whole);
    let one = folder.occupy(shard(1)).unwrap();
    let two = folder.occupy(shard(2)).unwrap();
    assert!(is_taken(shard(1)) && is_taken(Shard::ALL) && !is_taken(shard(3)));
    drop((one, two));
    assert!(!is_taken(Shard::ALL));
    assert!(files(place.path()) == before);
}

/// Links in a folder of results lead to files of somebody else: the study is refused, and they stay as they are.
#[cfg(unix)]
#[test]
fn nothing_is_written_through_links() {
    use std::os::unix::fs::symlink;

    let place = tempfile::tempdir().unwrap();
    let [results, victim] = ["results", "victim"].map(|name| place.path().join(name));
    let study = study_of(PLAN);
    run(&study, &results, Shard::ALL);
    for name in ["000000.json", "zarr.json", "c/0", "contact.friction/zarr.json"] {
        fs::create_dir_all(victim.join(name).parent().unwrap()).unwrap();
        fs::write(victim.join(name), "precious").unwrap();
    }
    let precious = files(&victim);
    for (name, to) in [
        ("finished", "../victim"),
        ("results.zarr", "../victim"),
        ("results.zarr/contact.friction", "../../victim"),
        ("in-use.lock", "../victim/lock"),
    ] {
        let aside = place.path().join("aside");
        let link = results.join(name);
        let is_there = fs::rename(&link, &aside).is_ok();
        symlink(to, &link).unwrap();
        let begun = ResultFolder::begin(&study, &results);
        let error = begun.and_then(|folder| folder.occupy(Shard::ALL)).err();
        let told = error.map(|error| error.to_string()).unwrap_or_default();
        assert!(told.contains("is a link"), "{name}: {told}");
        assert!(files(&victim) == precious, "{name}");
        fs::remove_file(&link).unwrap();
        if is_there {
            fs::rename(&aside, &link).unwrap();
        }
    }
    ResultFolder::begin(&study, &results).unwrap();
}

/// Of two studies that begin in one folder at once one has it, with all of its files; the other is refused.
// Long: begins thirty pairs of studies.
#[test]
fn two_studies_that_begin_at_once_do_not_mix() {
    let studies = [study_of(PLAN), study_of(&PLAN.replace("seed = 4", "seed = 5"))];
    assert_ne!(studies[0].fingerprint, studies[1].fingerprint);
    for _ in 0..30 {
        let place = tempfile::tempdir().unwrap();
        let path = place.path().join("results");
        let begin = |study| ResultFolder::begin(study, &path).map(drop);
        let begun = std::thread::scope(|scope| {
            let threads = studies.each_ref().map(|study| scope.spawn(move || begin(study)));
            threads.map(|thread| thread.join().unwrap())
        });
        let (study, _) = ResultFolder::open(&path).unwrap();
        for (own, begun) in studies.iter().zip(begun) {
            assert_eq!(own.fingerprint == study.fingerprint, begun.is_ok());
        }
    }
}

/// Whoever removes the arrays has them again, with what makes them open.
#[test]
fn what_was_removed_is_written_again() {
    let place = tempfile::tempdir().unwrap();
    let study = study_of(PLAN);
    run(&study, place.path(), Shard::ALL);
    let before = files(place.path());
    fs::remove_dir_all(place.path().join("results.zarr")).unwrap();
    run(&study, place.path(), Shard::ALL);
    assert!(files(place.path()) == before);
}
