//! Records of heights.

use jiff::civil::Date;
use riffel::diagnosis::{CleanRail, Course, CoursePoint, LocatedWavelength, WINDOW};
use riffel_keys::{CaseError, decimal};

use super::{Curves, Measured, RailHistory, SpectraChoice, counted, dates, times};
use crate::{DefectsAre, Rail, RailRecord, RailRoughness, defects_in_words};

/// The history of rails whose heights were measured.
pub(super) fn history(
    present: &RailRecord<'_>,
    rails: &[Rail],
    warnings: &[String],
    earlier: &[RailRecord<'_>],
    choice: SpectraChoice<'_>,
) -> Result<RailHistory, CaseError> {
    if !choice.choose.is_empty() || choice.by.is_some() {
        return Err(CaseError::data(
            present.name,
            "is a profile; a choice among spectra is for tables of them",
        ));
    }
    if rails.is_empty() {
        return Err(CaseError::data(
            present.name,
            "there is no rail in the record",
        ));
    }
    let mut warnings = warnings.to_vec();
    let wrong = |error: riffel::Error| CaseError::data(present.name, error.to_string());
    let clean: Vec<CleanRail> = rails.iter().map(|rail| clean_rail(rail, choice)).collect();
    let mut defects = Vec::new();
    for (rail, clean) in rails.iter().zip(&clean) {
        let own = clean.defects().iter();
        defects.extend(own.map(|defect| (rail.name.clone(), *defect)));
        let left_out = defects_in_words(&rail.name, clean.defects(), DefectsAre::LeftOut);
        warnings.extend(left_out.map(|said| said.to_string()));
    }
    let mut found: Vec<(usize, Vec<LocatedWavelength>)> = Vec::new();
    for (index, rail) in clean.iter().enumerate() {
        found.push((index, rail.dominant().map_err(wrong)?));
    }
    // The rail with the highest of all levels leads.
    let highest = |peaks: &[LocatedWavelength]| {
        let levels = peaks.iter().map(|one| one.peak.level);
        levels.fold(f64::NEG_INFINITY, f64::max)
    };
    found.sort_by(|a, b| highest(&b.1).total_cmp(&highest(&a.1)));
    let mut curves = Vec::new();
    for (index, peaks) in &found {
        let name = &rails[*index].name;
        curves.push((name.clone(), clean[*index].spectrum().map_err(wrong)?));
        // The place of the peak that stands out most, if it has one.
        let local = peaks.iter().find(|one| !one.all_along);
        curves.extend(local.and_then(|one| {
            let place = one.places.first()?;
            let label = format!("{name}, {}–{:.0} m", decimal(place.from, 0), place.to);
            Some((label, clean[*index].spectrum_between(place.from, place.to)?))
        }));
    }
    let words = format!(
        "profile, {} of {:.1} m{}, {} segments of {:.2} m averaged{}",
        counted(rails.len(), "rail", "rails"),
        rails.iter().map(Rail::length).sum::<f64>() / rails.len().max(1) as f64,
        if clean.iter().any(|rail| rail.length() >= 2.0 * WINDOW) {
            format!(", whole and in windows of {WINDOW:.0} m")
        } else {
            String::new()
        },
        curves[0].1.segments(),
        curves[0].1.segment_length(),
        match earlier.len() {
            0 => String::new(),
            count => format!("; {}", counted(count, "earlier record", "earlier records")),
        }
    );
    let records = || earlier.iter().chain([present]);
    let dates = dates(records()).unwrap_or_default();
    let labels: Vec<String> = if dates.is_empty() {
        records()
            .map(|record| record.name.display().to_string())
            .collect()
    } else {
        dates.iter().map(Date::to_string).collect()
    };
    let (times, unit) = times(labels.len(), &dates);
    let mut points: Vec<Vec<CoursePoint>> = Vec::new();
    points.resize_with(found.iter().map(|rail| rail.1.len()).sum(), Vec::new);
    let mut point = |finding: usize, record: usize, rail: &CleanRail, one: &LocatedWavelength| {
        let level = level_at(rail, one);
        points[finding].extend(level.map(|(level, scatter)| CoursePoint {
            label: labels[record].clone(),
            time: times[record],
            level,
            scatter: Some(scatter),
        }));
        level.is_some()
    };
    let all = || {
        let rails = found.iter();
        rails.flat_map(|(index, peaks)| peaks.iter().map(move |one| (*index, one)))
    };
    for (place, record) in earlier.iter().enumerate() {
        let RailRoughness::Profile {
            rails: past,
            warnings: remarks,
        } = record.roughness
        else {
            return Err(CaseError::data(
                record.name,
                format!(
                    "is a table of levels, but {} is a profile; both must be the same",
                    present.name.display()
                ),
            ));
        };
        let name = record.name.display();
        warnings.extend(remarks.iter().map(|remark| format!("{name}: {remark}")));
        for (index, rail) in rails.iter().enumerate() {
            let findings = || all().enumerate().filter(move |(_, (own, _))| *own == index);
            if findings().next().is_none() {
                continue;
            }
            let Some(same) = same_rail(past, rails, index) else {
                warnings.push(format!(
                    "{name}: has no rail {}, whose course is not known",
                    rail.name
                ));
                continue;
            };
            let same = clean_rail(same, choice);
            for (finding, (_, one)) in findings() {
                if !point(finding, place, &same, one) {
                    let place = one.places[0];
                    warnings.push(format!(
                        "{name}: rail {} was not measured from {:.1} m to {:.1} m, so that its course there is not known",
                        rail.name, place.from, place.to
                    ));
                }
            }
        }
    }
    for (finding, (index, one)) in all().enumerate() {
        point(finding, earlier.len(), &clean[index], one);
    }
    let measured = all().zip(points).map(|((index, one), points)| {
        let levels = clean
            .iter()
            .zip(rails)
            .filter_map(|(rail, named)| Some((named.name.clone(), level_at(rail, one)?.0)));
        Measured {
            record: None,
            rail: Some(rails[index].name.clone()),
            places: one.places.clone(),
            all_along: one.all_along,
            peak: one.peak.clone(),
            course: Course::new(points, unit).ok(),
            energy_levels: None,
            rails: if rails.len() > 1 {
                levels.collect()
            } else {
                Vec::new()
            },
        }
    });
    Ok(RailHistory {
        measured: measured.collect(),
        words,
        curves: Curves::Fine(curves),
        defects,
        warnings,
    })
}

/// A rail with its welds, joints and squats, or without.
fn clean_rail(rail: &Rail, choice: SpectraChoice<'_>) -> CleanRail {
    let stretches = rail.stretches.clone();
    match choice.keep_defects {
        true => CleanRail::with_defects(stretches),
        false => CleanRail::new(stretches),
    }
}

/// The rail of an earlier record that is this one: that of the same name, or where no name agrees the one at the
/// same place in the file.
fn same_rail<'a>(past: &'a [Rail], rails: &[Rail], index: usize) -> Option<&'a Rail> {
    let named = |name: &str| past.iter().find(|rail| rail.name == name);
    if let Some(same) = named(&rails[index].name) {
        return Some(same);
    }
    let strange = past.len() == rails.len() && rails.iter().all(|rail| named(&rail.name).is_none());
    strange.then(|| past.get(index)).flatten()
}

/// Level of a wavelength at its first place \[dB re 1 µm\], and its standard deviation by chance; None where the
/// rail was not measured there.
fn level_at(rail: &CleanRail, one: &LocatedWavelength) -> Option<(f64, f64)> {
    let spectrum = if one.all_along {
        rail.spectrum().ok()?
    } else {
        let place = one.places.first()?;
        rail.spectrum_between(place.from, place.to)?
    };
    Some(spectrum.level_between(one.peak.from, one.peak.to))
}
