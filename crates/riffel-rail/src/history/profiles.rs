//! Records of heights.

use jiff::civil::Date;
use riffel::diagnosis::{CleanRail, FineSpectrum, LevelTrend, LocatedWavelength, TrendPoint, WINDOW};
use riffel_keys::{CaseError, Message, fixed, number, say};

use super::{Curves, Measured, RailHistory, SpectraChoice, dates, times};
use crate::{DefectsAre, Rail, RailRecord, RailRoughness, defects_in_words, find_rail, name_in_words};

/// The history of rails whose heights were measured.
pub(super) fn history(
    present: &RailRecord<'_>,
    rails: &[Rail],
    warnings: &[Message],
    earlier: &[RailRecord<'_>],
    choice: SpectraChoice<'_>,
) -> Result<RailHistory, CaseError> {
    if !choice.choose.is_empty() || choice.by.is_some() {
        return Err(CaseError::data(present.name, "is a profile; a choice among spectra is for tables of them"));
    }
    if rails.is_empty() {
        return Err(CaseError::data(present.name, "there is no rail in the record"));
    }
    let mut warnings = warnings.to_vec();
    let wrong = |error: riffel::Error| CaseError::data(present.name, error.to_string());
    let clean: Vec<CleanRail> = rails.iter().map(|rail| clean_rail(rail, choice)).collect();
    let mut defects = Vec::new();
    for (rail, clean) in rails.iter().zip(&clean) {
        let own = clean.defects().iter();
        defects.extend(own.map(|defect| (rail.name.clone(), *defect)));
        let left_out = defects_in_words(&rail.name, clean.defects(), DefectsAre::LeftOut);
        warnings.extend(left_out);
    }
    let found = FoundWavelengths::of(&clean).map_err(wrong)?;
    let curves = found.curves(rails, &clean).map_err(wrong)?;
    let words = in_words(rails, &clean, &curves[0].1, earlier.len());
    let records = || earlier.iter().chain([present]);
    let dates = dates(records()).unwrap_or_default();
    let labels: Vec<String> = if dates.is_empty() {
        records().map(|record| record.name.display().to_string()).collect()
    } else {
        dates.iter().map(Date::to_string).collect()
    };
    let (times, unit) = times(labels.len(), &dates);
    let mut points = found.earlier_levels(present, rails, earlier, choice, &mut warnings)?;
    for ((index, one), levels) in found.all().zip(&mut points) {
        let level = level_at(&clean[index], one);
        levels.extend(level.map(|level| (earlier.len(), level)));
    }
    let measured = found.all().zip(points).map(|((index, one), levels)| {
        let points = levels.into_iter().map(|(record, (level, scatter))| TrendPoint {
            label: labels[record].clone(),
            time: times[record],
            level,
            scatter: Some(scatter),
        });
        let levels =
            clean.iter().zip(rails).filter_map(|(rail, named)| Some((named.name.clone(), level_at(rail, one)?.0)));
        Measured {
            record: None,
            rail: Some(rails[index].name.clone()),
            places: one.places.clone(),
            all_along: one.all_along,
            gone: false,
            peak: one.peak.clone(),
            course: LevelTrend::new(points.collect(), unit).ok(),
            energy_levels: None,
            rails: if rails.len() > 1 { levels.collect() } else { Vec::new() },
        }
    });
    Ok(RailHistory { measured: measured.collect(), words, curves: Curves::Fine(curves), defects, warnings })
}

/// What the record is, in words.
fn in_words(rails: &[Rail], clean: &[CleanRail], spectrum: &FineSpectrum, earlier: usize) -> Message {
    let length = rails.iter().map(Rail::length).sum::<f64>() / rails.len().max(1) as f64;
    let is_windowed = clean.iter().any(|rail| rail.length() >= 2.0 * WINDOW);
    let windows = match is_windowed {
        true => say!(in_windows, window = fixed(WINDOW, 0)),
        false => Message::verbatim(""),
    };
    let words = say!(
        profile_of_rails,
        count = rails.len(),
        length = fixed(length, 1),
        windows,
        segments = number(spectrum.segments()),
        segment = fixed(spectrum.segment_length(), 2)
    );
    match earlier {
        0 => words,
        count => say!(one_after_other, one = words, other = say!(earlier_records, count)),
    }
}

/// Dominant wavelengths of each rail, by its place in the record; the rail with the highest of all levels leads.
struct FoundWavelengths(Vec<(usize, Vec<LocatedWavelength>)>);

/// Level of a wavelength in a record, by its place among all, with its standard deviation by chance \[dB\].
type LevelOfRecord = (usize, (f64, f64));

impl FoundWavelengths {
    fn of(rails: &[CleanRail]) -> Result<Self, riffel::Error> {
        let mut found = Vec::new();
        for (index, rail) in rails.iter().enumerate() {
            found.push((index, rail.dominant()?));
        }
        let highest = |peaks: &[LocatedWavelength]| {
            let levels = peaks.iter().map(|one| one.peak.level);
            levels.fold(f64::NEG_INFINITY, f64::max)
        };
        found.sort_by(|a, b| highest(&b.1).total_cmp(&highest(&a.1)));
        Ok(Self(found))
    }

    /// Every wavelength with the place of its rail.
    fn all(&self) -> impl Iterator<Item = (usize, &LocatedWavelength)> {
        let rails = self.0.iter();
        rails.flat_map(|(index, peaks)| peaks.iter().map(move |one| (*index, one)))
    }

    /// Spectra of each rail, and of the place of the peak that stands out most, if it has one.
    fn curves(&self, rails: &[Rail], clean: &[CleanRail]) -> Result<Vec<(Message, FineSpectrum)>, riffel::Error> {
        let mut curves = Vec::new();
        for (index, peaks) in &self.0 {
            let name = || name_in_words(&rails[*index].name);
            curves.push((name(), clean[*index].spectrum()?));
            let local = peaks.iter().find(|one| !one.all_along);
            curves.extend(local.and_then(|one| {
                let place = one.places.first()?;
                let (from, to) = (fixed(place.from, 0), fixed(place.to, 0));
                let label = say!(rail_from_to, rail = name(), from, to);
                Some((label, clean[*index].spectrum_between(place.from, place.to)?))
            }));
        }
        Ok(curves)
    }

    /// Levels of every wavelength in the earlier records, with a warning where one is not known.
    fn earlier_levels(
        &self,
        present: &RailRecord<'_>,
        rails: &[Rail],
        earlier: &[RailRecord<'_>],
        choice: SpectraChoice<'_>,
        warnings: &mut Vec<Message>,
    ) -> Result<Vec<Vec<LevelOfRecord>>, CaseError> {
        let mut levels = vec![Vec::new(); self.all().count()];
        for (place, record) in earlier.iter().enumerate() {
            let RailRoughness::Profile { rails: past, warnings: remarks, .. } = record.roughness else {
                return Err(CaseError::data(
                    record.name,
                    format!("is a table of levels, but {} is a profile; both must be the same", present.name.display()),
                ));
            };
            let of_record = |said: Message| said.about(record.name.display());
            warnings.extend(remarks.iter().cloned().map(of_record));
            for (index, rail) in rails.iter().enumerate() {
                let findings = || self.all().enumerate().filter(move |(_, (own, _))| *own == index);
                if findings().next().is_none() {
                    continue;
                }
                let Some(same) = same_rail(past, rails, index) else {
                    let name = name_in_words(&rail.name);
                    warnings.push(of_record(say!(record_lacks_rail, rail = name)));
                    continue;
                };
                let same = clean_rail(same, choice);
                for (finding, (_, one)) in findings() {
                    let level = level_at(&same, one);
                    levels[finding].extend(level.map(|level| (place, level)));
                    if level.is_none() {
                        let place = one.places[0];
                        warnings.push(of_record(say!(
                            rail_not_measured_there,
                            rail = name_in_words(&rail.name),
                            from = fixed(place.from, 1),
                            to = fixed(place.to, 1)
                        )));
                    }
                }
            }
        }
        Ok(levels)
    }
}

/// A rail with its welds, joints and squats, or without.
fn clean_rail(rail: &Rail, choice: SpectraChoice<'_>) -> CleanRail {
    let stretches = rail.stretches.clone();
    match choice.keep_defects {
        true => CleanRail::with_defects(stretches),
        false => CleanRail::new(stretches),
    }
}

/// The rail of an earlier record that is this one: that of a name for the same rail, or where no name agrees the one at the
/// same place in the file.
fn same_rail<'a>(past: &'a [Rail], rails: &[Rail], index: usize) -> Option<&'a Rail> {
    let named = |name: &str| {
        let place = find_rail(past.iter().map(|rail| rail.name.as_str()), name);
        place.and_then(|place| past.get(place))
    };
    if let Some(same) = named(&rails[index].name) {
        return Some(same);
    }
    let strange = past.len() == rails.len() && rails.iter().all(|rail| named(&rail.name).is_none());
    strange.then(|| past.get(index)).flatten()
}

/// Level of a wavelength at its first place \[dB re 1 µm\], and its standard deviation by chance; `None` if the
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
