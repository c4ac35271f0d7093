//! Roughness held against limit tables.

use riffel::roughness::{
    BandSummary, JUDGED_LENGTH, JudgedSection, LevelExcess, LevelLimit, RailAnalysis, RmsLimit, Spectrum, ThirdOctave,
};
use riffel_keys::{Message, Value, fixed, number, say};
use riffel_rail::{Limit, LimitTable};
use serde::Serialize;

use super::words::{name, place_in_words};

/// What a limit table says of a record.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Verdict {
    /// Name of the rail, where rails are named.
    rail: Option<String>,
    /// Name of the table.
    limit: String,
    /// Edition of the standard.
    pub edition: String,
    /// Where its numbers come from.
    pub source: String,
    /// Whether it is within the limit.
    pub within: bool,
    /// Of a table of levels, how far the worst band is above its limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    excess_db: Option<f64>,
    /// Of a table of RMS, the share of the length over the limit in the worst band.
    #[serde(skip_serializing_if = "Option::is_none")]
    share_over_limit: Option<f64>,
    /// Of a table of RMS, the highest moving RMS over its limit.
    #[serde(skip_serializing_if = "Option::is_none")]
    rms_over_limit: Option<f64>,
    /// Of a table of RMS, the sections of 100 m that are over the limit, the worst first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sections_over_limit: Vec<SectionOver>,
    /// Of a table of levels, which are means over the record, the sections of 100 m that are over the limit, the worst first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    sections_over_levels: Vec<SectionOverLevels>,
    /// The verdict in a sentence.
    pub sentence: Message,
}

/// A section that is over a limit of RMS on more of its length than that allows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(crate) struct SectionOver {
    from_m: f64,
    to_m: f64,
    band_m: [f64; 2],
    share_over_limit: f64,
    rms_over_limit: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
}

/// A section whose levels are over a limit.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub(crate) struct SectionOverLevels {
    from_m: f64,
    to_m: f64,
    excess_db: f64,
    /// Of the band that is farthest over it.
    wavelength_m: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
}

impl SectionOverLevels {
    /// Verdicts of a rail, the worst first.
    fn all(limit: &LevelLimit, analysis: &RailAnalysis) -> Vec<Self> {
        let sections = analysis.section_spectra.iter().filter_map(|section| {
            let compared = limit.compare(&section.spectrum);
            let worst = worst_band(&compared)?;
            (worst.excess() > 0.0).then(|| Self {
                from_m: section.from,
                to_m: section.to,
                excess_db: worst.excess(),
                wavelength_m: worst.band.wavelength(),
                stretch: analysis.stretch_to_name(section.stretch),
            })
        });
        let mut sections: Vec<Self> = sections.collect();
        sections.sort_by(|one, other| other.excess_db.total_cmp(&one.excess_db));
        sections
    }

    /// The verdict, with where the worst is, where the mean over the record hides it by 3 dB or more.
    fn in_words(verdict: Message, over: &[Self], all: usize, excess: f64) -> Message {
        const HIDDEN: f64 = 3.0;
        let Some(worst) = over.first().filter(|one| one.excess_db >= excess + HIDDEN) else {
            return verdict;
        };
        let wavelength = ThirdOctave::containing(worst.wavelength_m);
        let by_themselves = say!(
            sections_over_levels,
            over = number(over.len()),
            all = number(all),
            length = fixed(JUDGED_LENGTH, 0),
            place = place_in_words(worst.from_m, worst.to_m, worst.stretch),
            decibels = fixed(worst.excess_db, 1),
            wavelength = number(wavelength.map_or(0.0, ThirdOctave::nominal_millimetres))
        );
        say!(one_after_other, one = verdict, other = by_themselves)
    }
}

/// The band that is farthest over its limit, or nearest to it.
pub(super) fn worst_band(compared: &[LevelExcess]) -> Option<&LevelExcess> {
    let bands = compared.iter();
    bands.max_by(|a, b| a.excess().total_cmp(&b.excess()))
}

impl SectionOver {
    fn new(section: &JudgedSection, analysis: &RailAnalysis) -> Self {
        Self {
            from_m: section.from,
            to_m: section.to,
            band_m: [section.band.from(), section.band.to()],
            share_over_limit: section.share,
            rms_over_limit: section.ratio,
            stretch: analysis.stretch_to_name(section.stretch),
        }
    }
}

/// What is judged on its own, with its verdicts.
pub(crate) trait Judged {
    /// The verdicts of all tables.
    fn verdicts(&self) -> &[Verdict];
}

/// Sort by verdicts, the worst first: over the most limits, then the furthest above a limit of levels, then over
/// a limit of RMS in the most sections, then on the longest share, then nearest to it.
pub(crate) fn worst_first<T: Judged>(all: &mut [T]) {
    all.sort_by(|a, b| {
        let over = |one: &T| one.verdicts().iter().filter(|one| !one.within).count();
        let most = |one: &T, value: fn(&Verdict) -> Option<f64>| {
            let values = one.verdicts().iter().filter_map(value);
            values.fold(f64::NEG_INFINITY, f64::max)
        };
        let by = |value| most(b, value).total_cmp(&most(a, value));
        over(b)
            .cmp(&over(a))
            .then_with(|| by(|one| one.excess_db))
            .then_with(|| by(|one| Some(one.sections_over_limit.len() as f64)))
            .then_with(|| by(|one| one.share_over_limit))
            .then_with(|| by(|one| one.rms_over_limit))
    });
}

impl Verdict {
    fn new(table: &LimitTable, within: bool, rest: Message) -> Self {
        let edition = &table.edition;
        Self {
            rail: None,
            excess_db: None,
            share_over_limit: None,
            rms_over_limit: None,
            sections_over_limit: Vec::new(),
            sections_over_levels: Vec::new(),
            limit: table.name.clone(),
            edition: table.edition.clone(),
            source: table.source.clone(),
            within,
            sentence: match within {
                true => say!(verdict_within, edition, rest),
                false => say!(verdict_over, edition, rest),
            },
        }
    }

    /// The edition of a table of RMS.
    pub(crate) fn edition_of_rms(&self) -> Option<&str> {
        self.share_over_limit.map(|_| &*self.edition)
    }

    /// The verdict with the name of what it is on in front, where that is named.
    pub(crate) fn of(mut self, subject: Option<&Message>) -> Self {
        if let Some(subject) = subject {
            self.sentence = self.sentence.about(subject.clone());
        }
        self
    }

    /// The verdict on a rail of this name.
    pub(crate) fn on_rail(self, name: &str) -> Self {
        Self { rail: Some(name.to_owned()), ..self }
    }

    /// The verdicts of all tables that have something to say of the spectrum of a rail and of its profile, where that is known.
    pub(crate) fn all(tables: &[LimitTable], spectrum: &Spectrum, analysis: Option<&RailAnalysis>) -> Vec<Self> {
        let verdicts = tables.iter().map(|table| match &table.limit {
            Limit::Levels(limit) => {
                let compared = limit.compare(spectrum);
                let all = limit.spectrum().levels().len();
                let over = compared.iter().filter(|band| band.excess() > 0.0);
                let worst = worst_band(&compared)?;
                let (excess, count) = (worst.excess(), over.count());
                let wavelength = number(worst.band.nominal_millimetres());
                let (measured, all) = (number(compared.len()), number(all));
                let are_all = measured == all;
                let rest = match (count, fixed(excess.abs(), 1)) {
                    (0, room) if are_all => {
                        say!(all_bands_within, all, room, wavelength)
                    }
                    (0, room) => say!(measured_bands_within, measured, all, room, wavelength),
                    (count, decibels) if are_all => {
                        say!(bands_over, count = number(count), all, decibels, wavelength)
                    }
                    (count, decibels) => {
                        say!(measured_bands_over, count = number(count), measured, all, decibels, wavelength)
                    }
                };
                let sections = analysis.map_or_else(Vec::new, |analysis| SectionOverLevels::all(limit, analysis));
                let judged = analysis.map_or(0, |analysis| analysis.section_spectra.len());
                let rest = SectionOverLevels::in_words(rest, &sections, judged, excess);
                Some(Self {
                    excess_db: Some(excess),
                    sections_over_levels: sections,
                    ..Self::new(table, count == 0, rest)
                })
            }
            Limit::Rms(limit) => Self::by_sections(table, limit, analysis?),
        });
        verdicts.flatten().collect()
    }

    /// A rail is over a limit of RMS where a section of it is.
    fn by_sections(table: &LimitTable, limit: &RmsLimit, analysis: &RailAnalysis) -> Option<Self> {
        let judged: Vec<(&BandSummary, f64)> = (analysis.bands.iter())
            .filter(|band| limit.of(band.band).is_some())
            .filter_map(|band| Some((band, band.share_over_limit?)))
            .collect();
        let worst = judged.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
        let sections = analysis.judged_sections();
        let over: Vec<&JudgedSection> = (sections.iter()).filter(|section| section.is_over(limit)).collect();
        let shares: Value = (judged.iter())
            .map(|(band, share)| {
                let share = fixed(100.0 * share, 1);
                say!(share_of_band, band = name(&band.band), share)
            })
            .collect();
        let (allowed, all) = (fixed(100.0 * limit.share(), 0), number(sections.len()));
        let length = fixed(JUDGED_LENGTH, 0);
        let rule = match (sections.len(), over.first()) {
            (..=1, _) => say!(length_may_be_over, allowed),
            (_, None) => say!(no_section_over, allowed, length, all),
            (_, Some(worst)) => say!(
                sections_over,
                allowed,
                length,
                over = number(over.len()),
                all,
                place = place_in_words(worst.from, worst.to, analysis.stretch_to_name(worst.stretch)),
                share = fixed(100.0 * worst.share, 0),
                band = name(&worst.band),
                ratio = fixed(worst.ratio, 1)
            ),
        };
        let ratios = judged.iter().filter_map(|(band, _)| Some(band.moving_rms_max / limit.of(band.band)?));
        Some(Self {
            share_over_limit: Some(worst.1),
            rms_over_limit: Some(ratios.fold(0.0, f64::max)),
            sections_over_limit: over.iter().map(|section| SectionOver::new(section, analysis)).collect(),
            ..Self::new(table, over.is_empty(), say!(one_after_other, one = rule, other = shares))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use riffel::roughness::{AnalysisSettings, Profile};

    use super::*;
    use crate::roughness::rms_limit;

    /// 150 m of 5 µm at 50 mm in 6 km are within the limit of levels in the mean, by which the standard judges, and the verdict says that
    /// by themselves two sections are over it, where and by how much; alone it says nothing more.
    #[test]
    fn a_rough_place_is_told_where_the_mean_hides_it() {
        let limits = [LimitTable::find("iso-3095-2013").unwrap()];
        let settings = AnalysisSettings { section_levels: true, ..AnalysisSettings::default() };
        let verdict = |length: f64, from: f64| {
            let height = |n: usize| {
                let x = 5e-3 * n as f64;
                let is_rough = (from..from + 150.0).contains(&x);
                let amplitude = if is_rough { 5e-6 } else { 0.05e-6 };
                amplitude * (TAU * x / 0.05).sin()
            };
            let heights = (0..(length / 5e-3) as usize).map(height).collect();
            let profile = Profile::new(0.0, 5e-3, heights).unwrap();
            let analysis = RailAnalysis::new(vec![profile], &settings, &|| ()).unwrap();
            Verdict::all(&limits, &analysis.spectrum, Some(&analysis)).remove(0)
        };
        let long = verdict(6000.0, 1200.0);
        // 5 µm are 11.0 dB, over 6 km 16.0 dB less; the limit at 50 mm is -1.1 dB.
        assert!(long.within && (long.excess_db.unwrap() + 3.9).abs() < 0.4, "{long:?}");
        let said = "by themselves 2 of 60 sections of 100 m are over it, at worst 1200–1300 m by 12.1 dB at 50 mm";
        assert!(long.sentence.to_string().contains(said), "{long:?}");
        assert_eq!(long.sections_over_levels.len(), 2);
        let short = verdict(150.0, 0.0);
        assert!(!short.within && !short.sentence.to_string().contains("themselves"), "{short:?}");
    }

    /// 12 m at twice the limit in 800 m are 1.5 % of the length, and over it in their section; the sentence says where.
    #[test]
    fn a_rough_place_is_over_however_long_the_record_is() {
        let limits = [LimitTable::find("grassie-1999").unwrap()];
        let settings = AnalysisSettings { limit: rms_limit(&limits).unwrap(), ..AnalysisSettings::default() };
        let verdict = |length: f64| {
            let height = |n: usize| {
                let x = 5e-3 * n as f64;
                let amplitude = if (130.0..142.0).contains(&x) { 20e-6 } else { 2e-6 };
                amplitude * (TAU * x / 0.05).sin()
            };
            let heights = (0..(length / 5e-3) as usize).map(height).collect();
            let profile = Profile::new(0.0, 5e-3, heights).unwrap();
            let analysis = RailAnalysis::new(vec![profile], &settings, &|| ()).unwrap();
            let mut all = Verdict::all(&limits, &analysis.spectrum, Some(&analysis));
            all.pop().unwrap()
        };
        for length in [200.0, 800.0] {
            let found = verdict(length);
            let said = found.sentence.to_string();
            assert!(!found.within, "{said}");
            let all = length / 100.0;
            assert!(said.contains(&format!("1 of {all} sections are more, at worst 100–200 m")), "{said}");
            let [section] = &found.sections_over_limit[..] else {
                panic!("{said}");
            };
            assert!((section.share_over_limit - 0.12).abs() < 0.02, "{section:?}");
            assert!((section.rms_over_limit - 2.02).abs() < 0.1, "{section:?}");
        }
    }
}
