//! What the reader of levels should know.

use riffel_case::Case;
use riffel_keys::{Message, Value, fixed, number, say};
use riffel_noise::{FrequencyBand, RailDecay, SoundPower};
use riffel_rail::name_in_words;

use super::train::Train;

/// Distance of pass-by measurements up to which what absorbs is left out by the field \[m\]: ISO 3095 measures at 7.5 and 25 m.
const FAR: f64 = 25.0;
/// Difference of radii up to which modes are taken to be those of the wheel.
const LARGEST_DIFFERENCE: f64 = 0.05;

pub(super) fn remarks(case: &Case, train: &Train, powers: &[SoundPower], left_out: &[FrequencyBand]) -> Vec<Message> {
    let mut remarks = Vec::new();
    if let [_, _, ..] = &train.rails[..] {
        let rails = train.rails.iter();
        let rails: Value = rails.map(|rail| name_in_words(rail)).collect();
        remarks.push(say!(noise_on_mean_of_rails, rails));
    }
    match &train.modes {
        None => remarks.push(say!(rigid_wheel)),
        Some((_, table)) => {
            remarks.push(say!(ringing_wheel));
            let radius = case.hertz.rolling_radius();
            if (table.rolling_radius / radius - 1.0).abs() > LARGEST_DIFFERENCE {
                remarks.push(say!(
                    modes_of_other_wheel,
                    of_modes = fixed(2e3 * table.rolling_radius, 0),
                    of_case = fixed(2e3 * radius, 0)
                ));
            }
        }
    }
    if train.distance > FAR {
        remarks.push(say!(far_away, distance = train.distance, far = FAR));
    }
    if train.wheel_roughness.is_none() {
        remarks.push(say!(smooth_wheels));
    }
    // The amplitude of a sinusoid of the same mean square, as in the forecast.
    let force = powers.iter().map(|power| 2.0 * power.force).sum::<f64>();
    let ratio = force.sqrt() / case.hertz.normal_force();
    if ratio >= 1.0 {
        remarks.push(say!(noise_beyond_linear_range, ratio = fixed(ratio, 2)));
    }
    if let (None, Some(track)) = (&train.radiator.decay_rate, case.track.structure.as_deref()) {
        let bands = powers.iter().map(|power| power.band);
        let far: Vec<FrequencyBand> = bands.filter(|band| RailDecay::runs_on(track, band.centre())).collect();
        if !far.is_empty() {
            remarks.push(say!(rail_cut_short, frequencies = nominal(&far)));
        }
    }
    if !left_out.is_empty() {
        remarks.push(say!(bands_left_out, frequencies = nominal(left_out)));
    }
    remarks
}

/// Nominal frequencies in a row.
fn nominal(bands: &[FrequencyBand]) -> Value {
    bands.iter().map(|band| number(band.nominal())).collect()
}
