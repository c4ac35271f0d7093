//! Growth, worst places and the plan of grinding.

use riffel_network::{Aim, Budget, ExpectedGrowth, NetworkError, growth, plan, status, worst};

use super::{grassie, store, survey, take};

/// A kilometre of 5 µm on which 100 m have 40 µm: found where they are, on the rail on which they are.
#[test]
fn the_worst_place_is_found() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, file) = survey(folder.path(), "a.csv", [12_000, 13_000], |rail, place| {
        if rail == 1 && (12_300.0..12_400.0).contains(&place) { 40.0 } else { 5.0 }
    });
    take(&store, "Main line", "2026-01-31", &file);
    let judgement = grassie(&store);
    let places = worst(&store, &judgement, 100.0, None, 3)?;
    assert_eq!(places.len(), 3);
    let first = &places[0];
    assert_eq!((first.line.as_str(), first.rail.as_str()), ("Main line", "right"));
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
    let expected = ExpectedGrowth { median: 10.0, band_50: [8.0, 12.0], band_80: [5.0, 20.0] };
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
    assert!(sentence.contains("\"Two\"") && sentence.contains("Measured, One"), "{sentence}");
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
    let (_, before) = survey(folder.path(), "b.csv", [0, 300], |_, place| rms(if place < 100.0 { 6.0 } else { -7.0 }));
    let (_, after) = survey(folder.path(), "c.csv", [0, 300], |_, place| rms(if place < 100.0 { -20.0 } else { -5.0 }));
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
    assert!(ground.iter().all(|section| section.from_m == 0.0 && section.months_to_limit.is_none()));

    // Nothing is over the limit now but in a year two sections of track are.
    let one = Budget::of_length(100.0);
    let now = plan(&store, &judgement, 100.0, 0.0, &one, Aim::WorstFirst)?;
    assert_eq!((now.over_limit_m, now.sites.len()), (0.0, 0));
    let later = plan(&store, &judgement, 100.0, 12.0, &one, Aim::WorstFirst)?;
    assert_eq!((later.over_limit_m, later.length_m, later.left_over_limit_m), (200.0, 100.0, 100.0));
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
    let budget = |money: f64| Budget { money, per_metre: 2.0, per_site: 300.0 };
    let sites = |money: f64| -> Result<Vec<(f64, f64, f64)>, NetworkError> {
        let found = plan(&store, &judgement, 100.0, 0.0, &budget(money), Aim::WorstFirst)?;
        assert!(found.cost <= money);
        let sites = found.sites.iter();
        Ok(sites.map(|site| (site.from_m, site.to_m, site.cost)).collect())
    };
    assert_eq!(sites(499.0)?, []);
    assert_eq!(sites(500.0)?, [(0.0, 100.0, 500.0)]);
    // 21 µm at 500 m does not fit; 20 µm that joins on does.
    assert_eq!(sites(700.0)?, [(0.0, 200.0, 700.0)]);
    assert_eq!(sites(1200.0)?, [(0.0, 200.0, 700.0), (500.0, 600.0, 500.0)]);
    let refused = plan(&store, &judgement, 100.0, 0.0, &budget(-1.0), Aim::WorstFirst);
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
    let budget = Budget { money: 1100.0, per_metre: 2.0, per_site: 300.0 };
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
    assert_eq!([worst, most].map(|plan| plan.least_left_over_limit_m), [100.0; 2]);
    Ok(())
}
