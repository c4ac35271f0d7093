//! What hardening and cracks make of the waves of a rail.

use riffel::forecast::{Forecast, ForecastBand, WavePhase};
use riffel_case::traffic::TrafficOnCase;
use riffel_keys::{Message, Value, number as numeral, say, significant};
use serde::Serialize;

use super::number;
use super::words::millions;

/// Where flow that hardens takes the waves of a band by itself.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct HardenedWave {
    /// Of the middle of the band.
    pub wavelength_m: f64,
    /// −D_h Re(u₁/Δ) of its line that comes nearest to running away: above one that outgrows hardening.
    pub runaway_number: f64,
    /// What flow multiplies the band by until it rests; `None` if it runs away.
    pub hardened_wave_ratio: Option<f64>,
}

/// Contact fatigue beside wear at one phase of the waves of a band.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct CrackedWave {
    /// Of the middle of the band.
    pub wavelength_m: f64,
    /// crest, falling-flank, trough, rising-flank: the wheel runs up the last.
    pub phase: &'static str,
    /// FI_surf, in the mean of the passages.
    pub fatigue_index: f64,
    /// D(Tγ) per passage, below zero where wear removes cracks.
    pub damage_per_passage: f64,
    /// Depth of wear per passage.
    pub wear_m_per_passage: f64,
    /// What a crack grows by in a passage now, less the wear.
    pub crack_growth_m_per_passage: f64,
    /// Growth of the crack in a month, if the traffic says how much of it there is.
    pub crack_growth_mm_per_month: Option<f64>,
    /// Length of a crack at the end of the forecast that begins with none.
    pub crack_length_m: f64,
}

fn nominal(band: &ForecastBand) -> f64 {
    band.now.band.nominal_millimetres()
}

impl HardenedWave {
    /// Damage of all bands in which something flows and hardens.
    pub fn all(forecast: &Forecast) -> Vec<Self> {
        let waves = forecast.bands().iter().filter_map(|band| {
            let end = band.hardening()?;
            Some(Self {
                wavelength_m: band.now.band.wavelength(),
                runaway_number: end.runaway_number,
                hardened_wave_ratio: end.wave_ratio,
            })
        });
        waves.collect()
    }

    /// What they mean, of the band that comes nearest to running away.
    pub fn in_words(forecast: &Forecast, on: &TrafficOnCase) -> Option<Message> {
        let bands = forecast.bands().iter();
        let ends = bands.filter_map(|band| Some((band, band.hardening()?)));
        let (band, end) = ends.max_by(|a, b| a.1.runaway_number.total_cmp(&b.1.runaway_number))?;
        let (wavelength, runaway) = (numeral(nominal(band)), number(end.runaway_number));
        Some(match end.wave_ratio {
            None => say!(hardening_runs_away, wavelength, runaway),
            Some(ratio) => say!(
                hardening_ends_wave,
                wavelength,
                runaway,
                ratio = significant(ratio, 4),
                when = match (band.rests_after(), on.passages_per_month()) {
                    (None, _) => Value::from(""),
                    (Some(passages), None) => {
                        say!(rests_after_passages, passages = millions(passages)).into()
                    }
                    (Some(passages), Some(per_month)) => {
                        say!(rests_after_months, months = number(passages / per_month)).into()
                    }
                }
            ),
        })
    }
}

impl CrackedWave {
    /// Cracks of all bands after some passages; empty if fatigue is not among the laws.
    pub fn all(forecast: &Forecast, on: &TrafficOnCase, passages: f64) -> Vec<Self> {
        let per_month = on.passages_per_month();
        let bands = forecast.bands().iter();
        let phases = bands.filter_map(|band| Some((band, forecast.cracks(band, passages)?)));
        let rows = phases.flat_map(|(band, phases)| {
            let phases = phases.into_iter().zip(WavePhase::NAMES);
            phases.map(move |(at, phase)| Self {
                wavelength_m: band.now.band.wavelength(),
                phase,
                fatigue_index: at.now.fatigue_index,
                damage_per_passage: at.now.damage,
                wear_m_per_passage: at.now.wear,
                crack_growth_m_per_passage: at.now.crack_growth,
                crack_growth_mm_per_month: per_month.map(|per_month| 1e3 * per_month * at.now.crack_growth),
                crack_length_m: at.length,
            })
        });
        rows.collect()
    }

    /// The longest crack, and what is opposite on its wave.
    pub fn in_words(waves: &[Self], on: &TrafficOnCase, passages: f64) -> Option<Message> {
        let longest = |a: &&Self, b: &&Self| a.crack_length_m.total_cmp(&b.crack_length_m);
        let most = waves.iter().max_by(longest)?;
        if most.crack_length_m <= 0.0 {
            return Some(say!(cracks_are_worn_off));
        }
        let place = WavePhase::NAMES.iter().position(|name| *name == most.phase)?;
        let opposite = WavePhase::NAMES[(place + 2) % 4];
        let other = waves.iter().find(|wave| wave.wavelength_m == most.wavelength_m && wave.phase == opposite)?;
        let [length, other_length] = [most, other].map(|wave| number(1e3 * wave.crack_length_m));
        let wavelength = numeral((1e3 * most.wavelength_m).round());
        let (at, opposite) = (place_in_words(most.phase), place_in_words(opposite));
        Some(match on.passages_per_month() {
            Some(per_month) => say!(
                cracks_grow_in_months,
                at,
                wavelength,
                months = number(passages / per_month),
                length,
                opposite,
                other = other_length
            ),
            None => {
                say!(cracks_grow, at, wavelength, passages = millions(passages), length, opposite, other = other_length)
            }
        })
    }
}

/// Where on a wave.
fn place_in_words(phase: &str) -> Message {
    match phase {
        "crest" => say!(on_crests),
        "trough" => say!(in_troughs),
        "rising-flank" => say!(on_rising_flanks),
        _ => say!(on_falling_flanks),
    }
}
