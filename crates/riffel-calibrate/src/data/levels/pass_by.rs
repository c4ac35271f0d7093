//! Levels beside the track while trains pass.

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::Path;

use riffel::contact::ContactFilter;
use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_case::{Case, TrackRadiator};
use riffel_keys::CaseError;
use riffel_noise::{Air, BandEnergies, BandRadiation, Energies, Energy, Excitation, FrequencyBand, Part, PassBy};

use super::dated::DatedLevels;
use super::table;
use crate::file::Kind;

/// Standard deviation of the level of one train, whose wheels are its own \[dB\].
const OF_A_TRAIN: f64 = 1.5;
/// Levels that a train beside a microphone may have \[dB(A)\]: from a whisper to the threshold of pain.
const AUDIBLE: RangeInclusive<f64> = 30.0..=140.0;
/// Change of the level of a band by which its share in what is heard is found \[dB\].
const STEP: f64 = 0.01;

/// Levels of trains that pass one place.
#[derive(Clone)]
pub(crate) struct PassBys {
    pub(crate) view: usize,
    pub(crate) rows: Vec<Passing>,
    /// Standard deviation of the level that all of them share \[dB\].
    pub(crate) common_error: f64,
    pub(crate) train: Train,
}

/// One level, or the mean of some trains.
#[derive(Debug, Clone)]
pub(crate) struct Passing {
    /// Since the first date of the levels of roughness.
    pub(super) passages: f64,
    /// \[dB(A)\]
    pub(super) level: f64,
    pub(super) error: f64,
    /// \[m/s\]
    pub(super) speed: f64,
    /// The bands in which the roughness is known.
    pub(super) audible: Vec<FrequencyBand>,
    /// By how much of a dB it rises with one of each band.
    pub(super) shares: Vec<(ThirdOctave, f64)>,
}

/// What passes, and where it is heard.
#[derive(Debug, Clone)]
pub(crate) struct Train {
    pub(crate) pass: PassBy,
    /// Roughness of the wheels; none for smooth ones.
    pub(crate) wheel: Option<Spectrum>,
    /// Roughness of the rail in bands of which no growth is known; none for nothing.
    pub(crate) rest: Option<Spectrum>,
    pub(crate) filter: ContactFilter,
}

impl Train {
    /// The A-weighted level \[dB\] of a train at a speed \[m/s\] on a rail with levels of some bands \[dB re 1 µm\].
    pub(super) fn level(
        &self,
        radiation: &[BandRadiation],
        speed: f64,
        levels: impl Iterator<Item = (ThirdOctave, f64)>,
    ) -> Result<f64, String> {
        let energies = self.energies(radiation, speed, levels)?;
        let total = energies.a_weighted(Part::Total);
        total.ok_or_else(|| "of the train nothing is heard".to_owned())
    }

    /// The bands of frequency in which the roughness is known.
    fn audible(
        &self,
        radiation: &[BandRadiation],
        speed: f64,
        levels: &[(ThirdOctave, f64)],
    ) -> Result<Vec<FrequencyBand>, String> {
        let energies = self.energies(radiation, speed, levels.iter().copied())?;
        Ok(energies.bands.iter().map(|band| band.band).collect())
    }

    /// By how much of a dB the level rises with one of each band: central differences.
    fn shares(
        &self,
        radiation: &[BandRadiation],
        speed: f64,
        levels: &[(ThirdOctave, f64)],
    ) -> Result<Vec<(ThirdOctave, f64)>, String> {
        let share = |moved: usize| {
            let level = |by: f64| {
                let mut levels = levels.to_vec();
                levels[moved].1 += by;
                self.level(radiation, speed, levels.into_iter())
            };
            Ok((levels[moved].0, (level(STEP)? - level(-STEP)?) / (2.0 * STEP)))
        };
        (0..levels.len()).map(share).collect()
    }

    fn energies(
        &self,
        radiation: &[BandRadiation],
        speed: f64,
        levels: impl Iterator<Item = (ThirdOctave, f64)>,
    ) -> Result<Energies, String> {
        let excitation = self.excitation(speed, levels)?;
        let air = Air::default();
        let mut bands = Vec::new();
        for band in radiation {
            let power = band.power(&excitation).map_err(|error| error.to_string())?;
            bands.extend(power.map(|power| BandEnergies {
                band: power.band,
                rail: self.pass.of_wheels(&air, power.rail),
                sleepers: self.pass.of_wheels(&air, power.sleepers),
                wheel: self.pass.of_wheels(&air, power.wheel),
            }));
        }
        Ok(Energies { energy: Energy::Pressure, bands })
    }

    fn excitation(&self, speed: f64, levels: impl Iterator<Item = (ThirdOctave, f64)>) -> Result<Excitation, String> {
        let rest = self.rest.iter().flat_map(Spectrum::levels);
        let mut rail: BTreeMap<ThirdOctave, f64> = rest.map(|level| (level.band, level.level)).collect();
        rail.extend(levels);
        let of_rail = Spectrum::new(rail).map_err(|error| error.to_string())?;
        Excitation::new(&of_rail, self.wheel.as_ref(), self.filter, speed).map_err(|error| error.to_string())
    }
}

/// How trains passed where the table does not say it.
pub(crate) struct Passage {
    pub(crate) train: Train,
    /// \[m/s\]
    pub(crate) speed: Option<f64>,
}

impl PassBys {
    /// The rows of a table of levels on a rail whose levels of roughness are known, and the frequencies that are known of none of
    /// its trains.
    ///
    /// # Errors
    /// [`CaseError`] with the line, the column and the rule.
    pub(crate) fn rows(
        path: &Path,
        case: &Case,
        dated: &DatedLevels,
        passage: &Passage,
    ) -> Result<(Vec<Passing>, Vec<FrequencyBand>), CaseError> {
        let others = Kind::PassBy.other_columns();
        let numbers = table::Numbers::of(path, Kind::PassBy)?;
        let [passages, levels] = [0, 1].map(|column| &numbers.needed[column]);
        let begins = dated.begins;
        let rule = format!("must not be before the first date of the levels of roughness, {begins}");
        numbers.check(path, "passages", passages, &rule, |it| it >= begins)?;
        let rule = format!("must lie between {} and {} dB(A)", AUDIBLE.start(), AUDIBLE.end());
        numbers.check(path, "level_dba", levels, &rule, |it| AUDIBLE.contains(&it))?;
        for (name, values) in others.iter().zip(&numbers.others) {
            if let Some(values) = values {
                let rule = "must be greater than zero";
                numbers.check(path, name, values, rule, |it| it > 0.0)?;
            }
        }
        let [speeds, trains, errors] = [0, 1, 2].map(|column| numbers.others[column].as_ref());
        let mut radiated: BTreeMap<u64, Vec<BandRadiation>> = BTreeMap::new();
        let mut silent: Vec<FrequencyBand> = FrequencyBand::all().collect();
        let mut rows = Vec::new();
        for (row, passages) in passages.iter().enumerate() {
            let refuse = |message: String| numbers.refuse(path, row, &message);
            let speed = speeds.map(|speeds| speeds[row] / 3.6).or(passage.speed);
            let speed = speed.ok_or_else(|| {
                refuse(
                    "no column `speed_km_per_h` says how fast the train was; add it, or give `speed` in the plan"
                        .to_owned(),
                )
            })?;
            let passages = passages - begins;
            let radiation = match radiated.get(&speed.to_bits()) {
                Some(radiation) => radiation,
                None => {
                    let all = FrequencyBand::all();
                    let made = TrackRadiator::default()
                        .bands(case, &case.feedback, &case.track, None, speed, all)
                        .map_err(|error| refuse(error.to_string()))?;
                    radiated.entry(speed.to_bits()).or_insert(made)
                }
            };
            let measured = dated.nearest(passages);
            let audible = passage.train.audible(radiation, speed, &measured);
            let audible = audible.map_err(&refuse)?;
            if audible.is_empty() {
                return Err(refuse(format!(
                    "at {:.0} km/h the levels of roughness fill no one-third octave between 100 Hz and 5 kHz",
                    3.6 * speed
                )));
            }
            silent.retain(|band| !audible.contains(band));
            let shares = passage.train.shares(radiation, speed, &measured);
            let of_trains = OF_A_TRAIN / trains.map_or(1.0, |trains| trains[row]).sqrt();
            rows.push(Passing {
                passages,
                level: levels[row],
                error: errors.map_or(of_trains, |errors| errors[row]),
                speed,
                audible,
                shares: shares.map_err(&refuse)?,
            });
        }
        Ok((rows, silent))
    }
}
