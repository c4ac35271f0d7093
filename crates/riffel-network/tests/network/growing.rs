//! What grows, and what grinding takes off.

use riffel_network::{Aim, Budget, DefectKind, NetworkError, SurveyFile, growth, plan, worst};

use crate::{grassie, store, survey, take};

/// Joints every 18 m from one place on, and between 200 and 300 m corrugation \[µm\].
fn line(place: f64, joint: f64, corrugation: f64) -> f64 {
    if (place - joint).rem_euclid(18.0) < 1.0 {
        36.0
    } else if (200.0..300.0).contains(&place) {
        corrugation
    } else {
        2.0 + 0.1 * (place * 7.3).sin()
    }
}

/// Joints that a second survey has a metre off do not grow by 22.8 dB a year; corrugation between them does grow, is told first, and is
/// what is ground. Joints are named as what they are.
#[test]
fn joints_a_metre_off_do_not_grow() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let (_, before) = survey(folder.path(), "a.csv", [0, 600], |_, place| line(place, 17.0, 8.0));
    let (_, after) = survey(folder.path(), "b.csv", [0, 600], |_, place| line(place - 1.0, 17.0, 10.0));
    take(&store, "A", "2026-03-16", &before);
    take(&store, "A", "2026-11-16", &after);
    let judgement = grassie(&store);
    let grown = growth(&store, &judgement, 100.0, None)?;
    let yearly = 20.0 * (10.0f64 / 8.0).log10() / 245.0 * 365.2425;
    for section in &grown {
        match section.from_m {
            200.0 => {
                // Joints grow no more than the rail between them: their share of the energy stays.
                assert!(section.growth_db_per_year.unwrap() > 0.5, "{section:?}");
                assert!(section.growth_db_per_year.unwrap() < yearly + 0.1, "{section:?}");
                assert_eq!(section.kind, Some(DefectKind::Corrugation));
            }
            _ => {
                // A joint that comes in at an end or goes out there.
                assert!(section.growth_db_per_year.unwrap().abs() < 2.5, "{section:?}");
                assert_eq!(section.months_to_limit.filter(|months| *months > 0.0), None);
            }
        }
    }
    let places = worst(&store, &judgement, 100.0, None, 20)?;
    assert_eq!((places[0].from_m, places[0].kind), (200.0, Some(DefectKind::Corrugation)));
    assert!(places[2..].iter().all(|place| place.kind != Some(DefectKind::Corrugation)));
    assert!(places.iter().any(|place| place.kind == Some(DefectKind::Joint)));
    let budget = Budget::of_length(600.0);
    let found = plan(&store, &judgement, 100.0, 12.0, &budget, Aim::WorstFirst)?;
    let sites: Vec<(f64, f64)> = found.sites.iter().map(|site| (site.from_m, site.to_m)).collect();
    assert_eq!(sites, [(200.0, 300.0)]);
    assert!(found.single_places_m > 0.0);
    let told = found.remarks.concat();
    assert!(told.contains("at single places alone"), "{told}");
    Ok(())
}

/// The first section of a record that begins 30 m later than the one before, or a cell, where a joint or rough rail is at its beginning: what
/// one of the two has not does not grow, and neither does it fall. All 1.6 dB of the rest are told.
#[test]
fn the_end_of_a_record_does_not_grow() -> Result<(), NetworkError> {
    for (first, second, rough) in
        [(0, 30, 0.0..20.0), (30, 0, 0.0..20.0), (31, 30, 30.0..31.0), (30, 31, 30.0..31.0), (0, 49, 48.0..49.0)]
    {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        for (date, begins, level) in [("2026-03-16", first, 2.0), ("2026-11-16", second, 2.4)] {
            let (_, file) = survey(folder.path(), "a.csv", [begins, 300], |_, place| match rough.contains(&place) {
                true => 60.0,
                false => level + 0.1 * (place * 7.3).sin(),
            });
            take(&store, "A", date, &file);
        }
        let yearly = 20.0 * 1.2f64.log10() / 245.0 * 365.2425;
        let grown = growth(&store, &grassie(&store), 100.0, None)?;
        assert_eq!(grown.len(), 6);
        for section in grown {
            let growth = section.growth_db_per_year.unwrap();
            assert!(!section.ground && (growth - yearly).abs() < 0.2, "{first} {second}: {section:?}");
        }
    }
    Ok(())
}

/// Cells of 10 m tell no joint by themselves; where the survey names the joints they do, and they are no corrugation, nor is what is left
/// of corrugation once they are out a joint.
#[test]
fn joints_that_a_survey_names_are_told() -> Result<(), NetworkError> {
    for (named, rail, kind) in
        [(false, 3.0, DefectKind::Unknown), (true, 3.0, DefectKind::Joint), (true, 9.0, DefectKind::Corrugation)]
    {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um".to_owned();
        text += if named { ",defects_m\n" } else { "\n" };
        let joints: Vec<f64> = (0..20u32).map(|joint| 4.0 + 18.3 * f64::from(joint)).collect();
        for cell in 0..30u32 {
            let from = 10.0 * f64::from(cell);
            let own: Vec<String> =
                joints.iter().filter(|at| (from..from + 10.0).contains(at)).map(|at| format!("{at:.2}")).collect();
            let rms = if own.is_empty() { rail } else { 20.0 };
            text += &format!("left,{from},{},{rms}", from + 10.0);
            text += &if named { format!(",{}\n", own.join(";")) } else { "\n".to_owned() };
        }
        let path = folder.path().join("a.csv");
        std::fs::write(&path, &text).unwrap();
        take(&store, "A", "2026-03-16", &SurveyFile::check(&path).unwrap());
        let judgement = grassie(&store);
        for place in worst(&store, &judgement, 100.0, None, 20)? {
            assert_eq!(place.kind, Some(kind), "{place:?}");
        }
        assert_eq!(judgement.remark().is_some(), !named);
        if named {
            std::fs::write(&path, text.replacen("4.00", "44.00", 1)).unwrap();
            let refusal = SurveyFile::check(&path).unwrap_err().in_words();
            assert!(refusal.contains("line 2: defects_m is \"44.00\""), "{refusal}");
        }
    }
    Ok(())
}

/// Welds every 37.3 m that odometers of four surveys have 2.3 m to 1.7 m off, in cells of 10 m, which no alignment by whole cells
/// puts right: none grows, though some come over the ends of sections. Such cells do not tell welds from corrugation, and say so.
// Long: stores four surveys of twelve lines.
#[test]
fn welds_that_come_over_the_end_of_a_section_do_not_grow() -> Result<(), NetworkError> {
    for first in 0..12u32 {
        let folder = tempfile::tempdir().unwrap();
        let store = store(&folder);
        let surveys = [("2024-01-15", 0.0), ("2024-07-20", 1.7), ("2025-02-01", -2.3), ("2025-08-10", 0.6)];
        for (date, shift) in surveys {
            let mut text = "rail,from_m,to_m,rms_100_to_300_mm_um\n".to_owned();
            for cell in 0..150u32 {
                let from = 10.0 * f64::from(cell);
                let welds = (0..40u32).map(|weld| {
                    let at = 3.1 * f64::from(first) + 37.3 * f64::from(weld) + shift;
                    let height = 30.0 + f64::from((weld * 7 + first) % 5) * 8.0;
                    let share = (at + 1.0).min(from + 10.0) - at.max(from);
                    0.1 * share.max(0.0) * height * height
                });
                let square = 4.0 + welds.sum::<f64>();
                text += &format!("left,{from},{},{}\n", from + 10.0, square.sqrt());
            }
            let path = folder.path().join(format!("{date}.csv"));
            std::fs::write(&path, text).unwrap();
            take(&store, "A", date, &SurveyFile::check(&path).unwrap());
        }
        let judgement = grassie(&store);
        for section in growth(&store, &judgement, 100.0, None)? {
            let error = section.growth_error_db_per_year.unwrap();
            assert!(section.growth_db_per_year.unwrap() < error, "{first}: {section:?}");
            assert_eq!(section.surveys, 4, "{first}: {section:?}");
            let kinds = [None, Some(DefectKind::Unknown)];
            assert!(kinds.contains(&section.kind), "{section:?}");
        }
        let budget = Budget::of_length(600.0);
        let found = plan(&store, &judgement, 100.0, 12.0, &budget, Aim::WorstFirst)?;
        assert!(found.remarks[0].contains("cells of 10 m do not tell joints"));
    }
    Ok(())
}

/// A section over its limit in a band that does not grow, with corrugation in another that will be far over it in a year, is ground before
/// one that is and stays farther over it than the first.
#[test]
fn the_band_that_grows_is_planned_for() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    for (date, level) in [("2024-07-01", 3.2), ("2025-07-01", 6.4)] {
        let mut text = "rail,from_m,to_m,rms_30_to_100_mm_um,rms_100_to_300_mm_um\n".to_owned();
        for from in 0..1000 {
            let (short, long) = match from / 100 {
                2 => (level, 8.0),
                6 => (1.0, 9.0),
                _ => (1.0, 1.0),
            };
            text += &format!("left,{from},{},{short},{long}\n", from + 1);
        }
        let path = folder.path().join(format!("{date}.csv"));
        std::fs::write(&path, text).unwrap();
        take(&store, "A", date, &SurveyFile::check(&path).unwrap());
    }
    let judgement = grassie(&store);
    let budget = Budget::of_length(100.0);
    let found = plan(&store, &judgement, 100.0, 12.0, &budget, Aim::WorstFirst)?;
    let sites: Vec<f64> = found.sites.iter().map(|site| site.from_m).collect();
    assert_eq!(sites, [200.0]);
    // 6.4 µm grow to 12.8, and are now within 7.
    let ratio = found.sites[0].rms_over_limit;
    assert!((ratio / (12.8 / 7.0) - 1.0).abs() < 0.02, "{ratio}");
    // The band that is told does not grow.
    let places = worst(&store, &judgement, 100.0, None, 20)?;
    let told: Vec<_> = places[..2].iter().map(|place| (place.from_m, place.growth_db_per_year)).collect();
    assert_eq!(told, [(600.0, None), (200.0, None)]);
    Ok(())
}

/// A trend goes through all dates, from where the rail was ground; a repeated survey tells the scatter, within which nothing grows.
#[test]
fn a_trend_goes_through_all_dates() -> Result<(), NetworkError> {
    let folder = tempfile::tempdir().unwrap();
    let store = store(&folder);
    let levels =
        [("2024-01-01", 12.0), ("2025-01-01", 1.0), ("2025-07-02", 2.4), ("2026-01-01", 3.0), ("2026-01-03", 3.4)];
    for (date, level) in levels {
        // Sections scatter: by half a decibel at every date, and each in its own way.
        let (_, file) = survey(folder.path(), &format!("{date}.csv"), [0, 1000], |rail, place| {
            let section = (place / 100.0).floor() + 10.0 * rail as f64;
            let off = 0.5 * (section * 12.9898 + level * 78.233).sin();
            10f64.powf((level + off) / 20.0)
        });
        take(&store, "A", date, &file);
    }
    let judgement = grassie(&store);
    let grown = growth(&store, &judgement, 100.0, None)?;
    assert_eq!(grown.len(), 20);
    for section in &grown {
        assert_eq!((section.surveys, &*section.dates[0]), (4, "2025-01-01"));
        let error = section.growth_error_db_per_year.unwrap();
        // By hand: 2.1 dB a year through the four means; their spread of 0.86 years and 0.5 dB leave 1.2.
        assert!((section.growth_db_per_year.unwrap() - 2.2).abs() < 1.6, "{section:?}");
        assert!((0.8..2.0).contains(&error), "{error}");
    }
    let mean = grown.iter().map(|section| section.growth_db_per_year.unwrap()).sum::<f64>() / 20.0;
    assert!((mean - 2.2).abs() < 0.5, "{mean}");
    // Two surveys within a week show no growth.
    let between = Some(["2026-01-01".parse().unwrap(), "2026-01-03".parse().unwrap()]);
    let repeated = growth(&store, &judgement, 100.0, between)?;
    assert!(repeated.iter().all(|section| section.months_to_limit.is_none()));
    Ok(())
}
