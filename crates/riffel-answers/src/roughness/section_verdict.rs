//! A rail judged section by section: over which limit, what to grind of it, and why these two may differ.

use riffel::roughness::{GrindSection, JudgedSection, RailAnalysis, RmsLimit, Spectrum, ThirdOctave};
use riffel_keys::{Message, fixed, number, say};
use riffel_rail::{Limit, LimitTable, LinePlace};
use serde::Serialize;

use super::verdict::worst_band;
use super::words::name;

/// Length \[m\] below which nothing of a section is ground: what rounding leaves at its ends.
const SHORTEST_GROUND: f64 = 0.01;

/// A section of the length on which rails are judged.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SectionVerdict {
    rail: String,
    from_m: f64,
    to_m: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
    /// Whether it is within every limit.
    within: bool,
    /// How far its worst band is above its limit of levels, and that band.
    excess_db: Option<f64>,
    wavelength_m: Option<f64>,
    /// Share of its length over the limit of RMS in the worst band, the highest ratio, and that band.
    share_over_limit: Option<f64>,
    rms_over_limit: Option<f64>,
    band_m: Option<[f64; 2]>,
    /// Length of it to grind.
    grind_m: f64,
    /// What lies there, by a table.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    along: Vec<LinePlace>,
    /// All this in a sentence.
    sentence: Message,
    /// Number of limits it is over.
    #[serde(skip)]
    over: usize,
}

/// What is known of a section.
struct Judged<'a> {
    levels: Option<(f64, ThirdOctave)>,
    rms: Option<(&'a JudgedSection, &'a RmsLimit)>,
    grind: f64,
}

impl SectionVerdict {
    /// The sections of a rail.
    pub(super) fn of_rail(
        rail: &str,
        analysis: &RailAnalysis,
        grind: &[GrindSection],
        limits: &[LimitTable],
    ) -> Vec<Self> {
        let rms = limits.iter().find_map(|table| match &table.limit {
            Limit::Rms(limit) => Some(limit),
            Limit::Levels(_) => None,
        });
        let judged = analysis.judged_sections();
        let spectra = analysis.section_spectra.iter();
        let mut ends: Vec<(usize, f64, f64)> = spectra
            .map(|section| (section.stretch, section.from, section.to))
            .chain((judged.iter()).map(|section| (section.stretch, section.from, section.to)))
            .collect();
        ends.sort_by(|one, other| one.0.cmp(&other.0).then(one.1.total_cmp(&other.1)));
        ends.dedup();
        if let ([], Some(first), Some(last)) = (&ends[..], analysis.stretches.first(), analysis.stretches.last()) {
            ends.push((1, first.0, last.1));
        }
        let is_only = ends.len() == 1;
        ends.into_iter()
            .map(|(stretch, from, to)| {
                let spectra = analysis.section_spectra.iter();
                let own = spectra.map(|section| (section.stretch, section.from, &section.spectrum));
                // The levels of a record of one section are those of the section.
                let own = own.chain(is_only.then_some((stretch, from, &analysis.spectrum)));
                let spectrum = own.into_iter().find(|(number, begin, _)| (*number, *begin) == (stretch, from));
                let judged = (judged.iter()).find(|section| (section.stretch, section.from) == (stretch, from));
                let ground = analysis.measured_within(grind).into_iter();
                let ground = ground.filter(|(number, ..)| *number == stretch);
                let ground = ground.map(|(_, low, high)| (high.min(to) - low.max(from)).max(0.0));
                let known = Judged {
                    levels: spectrum.and_then(|(.., spectrum)| excess(spectrum, limits)),
                    rms: judged.zip(rms),
                    grind: ground.sum(),
                };
                Self::new(rail, [from, to], &known).on(analysis.stretch_to_name(stretch))
            })
            .collect()
    }

    fn new(rail: &str, [from, to]: [f64; 2], known: &Judged<'_>) -> Self {
        let rms = known.rms.map(|(section, _)| section);
        let sentences = known.sentences().into_iter();
        let sentence = sentences.reduce(Message::followed_by);
        let over = usize::from(known.is_over_levels()) + usize::from(known.is_over_rms());
        Self {
            rail: rail.to_owned(),
            from_m: from,
            to_m: to,
            stretch: None,
            within: over == 0,
            excess_db: known.levels.map(|(excess, _)| excess),
            wavelength_m: known.levels.map(|(_, band)| band.wavelength()),
            share_over_limit: rms.map(|section| section.share),
            rms_over_limit: rms.map(|section| section.ratio),
            band_m: rms.map(|section| [section.band.from(), section.band.to()]),
            grind_m: known.grind,
            along: Vec::new(),
            sentence: sentence.unwrap_or_else(|| "".into()),
            over,
        }
    }

    /// Verdict with its stretch named where there are several at the same places.
    fn on(mut self, stretch: Option<usize>) -> Self {
        if let Some(stretch) = stretch {
            let named = say!(stretch_named, stretch = number(stretch));
            self.sentence = self.sentence.about(named);
        }
        Self { stretch, ..self }
    }

    /// Sort the worst first: over the most limits, then the furthest above its limit of levels, then on the largest share
    /// over its limit of RMS, then the most to grind.
    pub(super) fn worst_first(all: &mut [Self]) {
        let or_none = |value: Option<f64>| value.unwrap_or(f64::NEG_INFINITY);
        all.sort_by(|one, other| {
            let by = |value: &dyn Fn(&Self) -> f64| value(other).total_cmp(&value(one));
            (other.over.cmp(&one.over))
                .then_with(|| by(&|section| or_none(section.excess_db)))
                .then_with(|| by(&|section| or_none(section.share_over_limit)))
                .then_with(|| by(&|section| section.grind_m))
        });
    }

    /// Tell what of a table lies there.
    pub(super) fn beside(&mut self, places: &[LinePlace]) {
        let own = places.iter();
        let own = own.filter(|place| place.from < self.to_m && place.to >= self.from_m);
        self.along = own.cloned().collect();
    }
}

/// How far the worst band of a spectrum is above the limits of levels.
fn excess(spectrum: &Spectrum, limits: &[LimitTable]) -> Option<(f64, ThirdOctave)> {
    let excesses = limits.iter().filter_map(|table| match &table.limit {
        Limit::Levels(limit) => {
            let compared = limit.compare(spectrum);
            worst_band(&compared).map(|worst| (worst.excess(), worst.band))
        }
        Limit::Rms(_) => None,
    });
    excesses.max_by(|one, other| one.0.total_cmp(&other.0))
}

impl Judged<'_> {
    fn is_over_levels(&self) -> bool {
        self.levels.is_some_and(|(excess, _)| excess > 0.0)
    }

    fn is_over_rms(&self) -> bool {
        self.rms.is_some_and(|(section, limit)| section.is_over(limit))
    }

    /// Over what it is, then what to grind, with the reason where these two differ.
    fn sentences(&self) -> Vec<Message> {
        let length = || fixed(self.grind, 1);
        let is_ground = self.grind > SHORTEST_GROUND;
        let mut sentences = Vec::new();
        if let Some((excess, band)) = self.levels.filter(|_| self.is_over_levels()) {
            sentences.push(say!(
                section_over_levels,
                excess = fixed(excess, 1),
                wavelength = number(band.nominal_millimetres())
            ));
        }
        let Some((section, limit)) = self.rms else {
            if sentences.is_empty() {
                sentences.push(say!(section_within_levels));
            }
            return sentences;
        };
        let share = || fixed(100.0 * section.share, 1);
        let (band, ratio) = (|| name(&section.band), || fixed(section.ratio, 1));
        let allowed = || fixed(100.0 * limit.share(), 0);
        if section.is_over(limit) {
            sentences.push(say!(
                section_over_rms,
                share = share(),
                band = band(),
                ratio = ratio(),
                allowed = allowed()
            ));
        }
        sentences.push(match (is_ground, section.share > 0.0) {
            (true, true) if self.is_over_levels() || section.is_over(limit) => {
                say!(section_to_grind, length = length())
            }
            (true, true) => say!(
                section_short_places,
                length = length(),
                share = share(),
                band = band(),
                ratio = ratio(),
                allowed = allowed()
            ),
            (true, false) => say!(section_ground_along, length = length()),
            (false, _) if self.is_over_levels() => say!(section_nothing_to_grind),
            (false, _) => say!(section_within),
        });
        sentences
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use riffel::roughness::{AnalysisSettings, GrindSettings, Profile};

    use super::*;
    use crate::roughness::rms_limit;

    /// The sections of 400 m with waves of amplitude and length \[m\] from one place to another.
    fn sections(waves: &[(f64, f64, [f64; 2])], limits: &[&str]) -> Vec<SectionVerdict> {
        let limits: Vec<LimitTable> = (limits.iter()).map(|name| LimitTable::find(name).unwrap()).collect();
        let settings = AnalysisSettings {
            limit: rms_limit(&limits).unwrap(),
            section_levels: true,
            ..AnalysisSettings::default()
        };
        let height = |n: usize| {
            let x = 5e-3 * n as f64;
            let own = waves.iter().filter(|(_, _, [from, to])| (*from..*to).contains(&x));
            let own = own.map(|(amplitude, length, _)| amplitude * (TAU * x / length).sin());
            0.05e-6 * (TAU * x / 0.05).sin() + own.sum::<f64>()
        };
        let heights = (0..80_000).map(height).collect();
        let profile = Profile::new(0.0, 5e-3, heights).unwrap();
        let analysis = RailAnalysis::new(vec![profile], &settings, &|| ()).unwrap();
        let grind = analysis.grind(&GrindSettings::default());
        let mut sections = SectionVerdict::of_rail("left", &analysis, &grind, &limits);
        SectionVerdict::worst_first(&mut sections);
        sections
    }

    const BOTH: [&str; 2] = ["iso-3095-2013", "grassie-1999"];

    /// 20 m of 20 µm at 50 mm are over both limits; 1 m of 16 µm at 90 mm is 20 dB less in the mean of its section and 1 % of it, and
    /// ground all the same; 3 µm at 50 mm all along are over the limit of levels and below that of the moving RMS, 7 µm.
    #[test]
    fn what_is_over_and_what_is_ground_are_told_apart_the_worst_first() {
        let waves = [(20e-6, 0.05, [30.0, 50.0]), (3e-6, 0.05, [100.0, 200.0]), (16e-6, 0.09, [250.0, 250.99])];
        let sections = sections(&waves, &BOTH);
        let from: Vec<f64> = sections.iter().map(|section| section.from_m).collect();
        assert_eq!(from, [0.0, 100.0, 200.0, 300.0], "{sections:#?}");
        let [both, levels, short, within] = &sections[..] else {
            panic!("four sections");
        };
        // The moving RMS has a window of 1 m, half of which reaches beyond either end.
        assert!((both.grind_m - 20.0).abs() < 2.0 && both.sentence.to_string().contains("limit of levels by"));
        assert!(both.sentence.to_string().contains("over the limit of RMS on 2") && !both.within);
        assert!(!levels.within && levels.grind_m == 0.0);
        assert!(levels.sentence.to_string().ends_with("nowhere over its limit here"));
        assert!(short.within && (short.grind_m - 10.0).abs() < 0.1, "{short:?}");
        assert!(short.sentence.to_string().starts_with("within the limits, but 10.0 m to grind:"));
        assert!(within.within && within.sentence.to_string().starts_with("within the limits; nothing"));
    }

    /// A weld is put where it lies, a curve into each section that it reaches.
    #[test]
    fn what_lies_beside_a_section_is_told() {
        let place = |from, to, kind: &str| LinePlace { from, to, kind: kind.to_owned(), name: String::new() };
        let places = [place(150.0, 250.0, "curve"), place(230.0, 230.0, "weld")];
        let mut sections = sections(&[], &BOTH);
        sections.sort_by(|one, other| one.from_m.total_cmp(&other.from_m));
        let kinds: Vec<Vec<String>> = (sections.iter_mut())
            .map(|section| {
                section.beside(&places);
                section.along.iter().map(|place| place.kind.clone()).collect()
            })
            .collect();
        let expected: [&[&str]; 4] = [&[], &["curve"], &["curve", "weld"], &[]];
        assert_eq!(kinds, expected);
    }

    /// Without a limit of RMS nothing is said of grinding.
    #[test]
    fn levels_alone_do_not_say_what_to_grind() {
        let sections = sections(&[(3e-6, 0.05, [100.0, 200.0])], &BOTH[..1]);
        assert!(sections[0].sentence.to_string().starts_with("over the limit of levels by"));
        assert!(sections.iter().all(|section| !section.sentence.to_string().contains("to grind;")));
        assert!(sections[1].sentence.to_string().ends_with("no limit says what to grind"));
    }

    /// A metre of 20 µm at 50 mm just beyond the end of a section is ground over the shortest length, which reaches back into it:
    /// nothing is over a limit there, and its sentence says why it is ground.
    #[test]
    fn a_section_is_ground_along_with_what_lies_beside() {
        let sections = sections(&[(20e-6, 0.05, [101.0, 102.0])], &["grassie-1999"]);
        let [beside, ..] = &sections.iter().filter(|one| one.from_m == 0.0).collect::<Vec<_>>()[..] else {
            panic!("{sections:?}");
        };
        assert!(beside.within && beside.share_over_limit == Some(0.0), "{beside:?}");
        assert!(beside.grind_m > SHORTEST_GROUND, "{beside:?}");
        let expected = say!(section_ground_along, length = fixed(beside.grind_m, 1)).to_string();
        assert_eq!(beside.sentence.to_string(), expected);
    }
}
