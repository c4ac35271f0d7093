//! Whether heights, steps and levels are those of a rail.

use std::ops::RangeInclusive;

use riffel::roughness::{Profile, WavelengthBand};
use riffel_keys::Message;

use crate::rail::Rail;
use crate::refusal::Refusal;

/// Root mean square of a rail's heights between 10 mm and 1 m, least and most \[m\]. Each of the 21 one-third octaves
/// of the smoothest rail has some −21 dB re 1 µm and more, together −8 dB or 0.4 µm; the worst corrugation has +50 dB or
/// 0.3 mm in one band, with a factor of three for all others. Heights in mm taken for µm, or the other way round, are
/// 60 dB off.
const RMS: (f64, f64) = (0.4e-6, 1e-3);
/// One-third octaves between 10 mm and 1 m.
const BANDS: f64 = 21.0;
/// Step between the samples of a record that shows corrugation, least and most \[m\]: a wave of 20 mm needs two samples,
/// and no instrument on a rail resolves hundredths of a millimetre.
const SPACING: (f64, f64) = (0.01e-3, 10e-3);
/// Step between the samples of track geometry \[m\]: recording cars write one each 0.25 m, some each 0.16 m, 0.5 m or foot.
const GEOMETRY: RangeInclusive<f64> = 0.15..=0.55;
/// Median of one-third-octave levels of a rail, least and most \[dB re 1 µm\].
const LEVEL: (f64, f64) = (-50.0, 60.0);
/// Windows of the two moving means whose difference passes the band \[m\].
const WINDOWS: (f64, f64) = (0.01, 1.0);
/// Units that are tried, the likeliest first, in metres.
const UNITS: [(&str, f64); 4] = [("um", 1e-6), ("mm", 1e-3), ("m", 1.0), ("nm", 1e-9)];

/// The step \[m\] of positions in a unit, or of `--spacing` where there are none.
pub(super) fn check_spacing(spacing: f64, unit: Option<(&str, f64)>) -> Result<(), Refusal> {
    // Positions are rounded.
    if (0.99 * SPACING.0..=1.01 * SPACING.1).contains(&spacing) {
        return Ok(());
    }
    if GEOMETRY.contains(&spacing) {
        let message = format!(
            "the samples are {} m apart, as those of track geometry are; a record that shows corrugation has a sample every \
             0.01 to 10 mm",
            short(spacing)
        );
        return Err(Refusal::new(None, message));
    }
    let (known, factor) = unit.unwrap_or(("m", 1.0));
    let fits = |other: f64| (SPACING.0..=SPACING.1).contains(&(spacing / factor * other));
    let likely = ["m", "mm", "um", "km"].into_iter().find(|&name| {
        let size = if name == "km" { Some(1e3) } else { UNITS.iter().find(|unit| unit.0 == name).map(|unit| unit.1) };
        name != known && size.is_some_and(fits)
    });
    let mut message = format!(
        "the samples are {} mm apart; a record that shows corrugation has a sample every 0.01 to 10 mm",
        short(1e3 * spacing)
    );
    let help = match (likely, unit) {
        (Some(likely), Some(_)) => {
            message += &format!("; the positions, read in {known}, look like {likely}");
            Some(format!(
                "give --position-unit {likely}, or write the unit in the head of the column, as in position [{likely}]"
            ))
        }
        (Some(likely), None) => Some(format!("did you mean --spacing \"{} {likely}\"?", short(spacing))),
        (None, _) => None,
    };
    Err(Refusal { line: None, message: message.into(), help: help.map(Into::into) })
}

/// Heights \[m\] that somebody gave as numbers, where they are unlike a rail: they are taken, and asked about.
pub fn unlike_a_rail(rails: &[Rail]) -> Option<Message> {
    let checked: Vec<_> = rails.iter().map(|rail| (rail, "m", 1.0)).collect();
    let refusal = check_heights(&checked).err()?;
    Some(refusal.message)
}

/// Message on one-third-octave levels \[dB re 1 µm\] that are unlike a rail.
pub fn levels_unlike_a_rail(levels: impl Iterator<Item = f64>) -> Option<Message> {
    let refusal = check_levels(levels).err()?;
    Some(refusal.message)
}

/// The heights of all rails, which were read in units of \[m\]. A sentence where they are unlike a rail.
pub(super) fn check_heights(rails: &[(&Rail, &str, f64)]) -> Result<(), Refusal> {
    for (rail, unit, factor) in rails {
        let blocks = block_mean_squares(&rail.stretches);
        let Some(largest) = blocks.iter().copied().max_by(f64::total_cmp) else {
            continue;
        };
        let mut sorted = blocks;
        sorted.sort_by(f64::total_cmp);
        // Smooth is what is smooth everywhere; rough is what is rough at most places, for joints are rough.
        let (roughest, median) = (largest.sqrt(), sorted[sorted.len() / 2].sqrt());
        let (rms, what) = if roughest < RMS.0 {
            (roughest, "smooth")
        } else if median > RMS.1 {
            (median, "rough")
        } else {
            continue;
        };
        let likely = UNITS.into_iter().find(|(name, size)| {
            let other = rms / factor * size;
            name != unit && (RMS.0..=RMS.1).contains(&other)
        });
        let mut message = format!(
            "rail {}: the heights, read in {unit}, are {} µm rms between 10 mm and 1 m; no rail is so {what} ({} to \
             {} µm)",
            rail.name,
            short(1e6 * rms),
            short(1e6 * RMS.0),
            short(1e6 * RMS.1)
        );
        let help = likely.map(|(likely, _)| {
            message += &format!("; they look like {likely}");
            format!("give --height-unit {likely}, or write the unit in the head of the column, as in height [{likely}]")
        });
        return Err(Refusal { line: None, message: message.into(), help: help.map(Into::into) });
    }
    Ok(())
}

/// One-third-octave levels \[dB re 1 µm\].
pub(super) fn check_levels(levels: impl Iterator<Item = f64>) -> Result<(), Refusal> {
    let mut levels: Vec<f64> = levels.collect();
    levels.sort_by(f64::total_cmp);
    let Some(&median) = levels.get(levels.len() / 2) else {
        return Ok(());
    };
    if (LEVEL.0..=LEVEL.1).contains(&median) {
        return Ok(());
    }
    // 1 m is 120 dB over 1 µm, 1 mm 60 dB, and 1 nm 60 dB under it.
    let likely = [(120.0, "dB re 1 m"), (60.0, "dB re 1 mm"), (-60.0, "dB re 1 nm")]
        .into_iter()
        .find(|(shift, _)| (-40.0..=40.0).contains(&(median + shift)));
    let looks = likely.map_or_else(String::new, |(shift, name)| {
        format!("; they look like {name}, to which {shift:+} dB is to be added")
    });
    let message = format!(
        "the levels are {median:.0} dB in the median; those of a rail are {} to {} dB re 1 µm in a band{looks}",
        LEVEL.0, LEVEL.1
    );
    Err(Refusal::new(None, message))
}

/// Levels \[dB re 1 µm\] of what axle boxes felt of a rail, in bands of these wavelengths. A sentence where they are unlike a
/// rail: bounds are those of heights, in as many bands.
///
/// # Errors
/// The sentence.
pub fn check_axle_box_levels(
    rail: &str,
    levels: impl Iterator<Item = f64>,
    known: WavelengthBand,
) -> Result<(), String> {
    let squares: Vec<f64> = levels.map(|level| 10f64.powf(level / 10.0)).collect();
    let rms = 1e-6 * squares.iter().sum::<f64>().sqrt();
    let least = RMS.0 * (squares.len() as f64 / BANDS).sqrt();
    let (what, why) = if rms < least {
        ("smooth", "is the sensor at rest, or its unit wrong?")
    } else if rms > RMS.1 {
        ("rough", "is the unit of the accelerations right?")
    } else {
        return Ok(());
    };
    Err(format!(
        "rail {rail}: the accelerations make a roughness of {} µm rms between {:.0} and {:.0} mm; no rail is so {what} ({} to {} \
         µm); {why}",
        short(1e6 * rms),
        1e3 * known.from(),
        1e3 * known.to(),
        short(1e6 * least),
        short(1e6 * RMS.1)
    ))
}

/// Mean squares \[m²\] of the heights between the wavelengths of [`WINDOWS`], metre by metre: a moving mean over 10 mm
/// less one over 1 m.
fn block_mean_squares(stretches: &[Profile]) -> Vec<f64> {
    let mut blocks = Vec::new();
    for stretch in stretches {
        let spacing = stretch.spacing();
        let width = |length: f64| ((length / spacing / 2.0).round() as usize).max(1);
        // A window of a single sample is the height itself.
        let short = if WINDOWS.0 < 2.0 * spacing { 0 } else { width(WINDOWS.0) };
        let long = width(WINDOWS.1);
        let heights = stretch.heights();
        let mut sums = Vec::with_capacity(heights.len() + 1);
        sums.push(0.0);
        let first = heights.first().copied().unwrap_or(0.0);
        let mut sum = 0.0;
        for height in heights {
            // Sums of drifted heights would lose their digits.
            sum += height - first;
            sums.push(sum);
        }
        // As long on either side, so that a slope makes no difference; shorter at the ends.
        let mean = |at: usize, half: usize| {
            let half = half.min(at).min(heights.len() - 1 - at);
            (sums[at + half + 1] - sums[at - half]) / (2 * half + 1) as f64
        };
        let samples = (2 * long).max(2);
        for block in (0..heights.len()).step_by(samples) {
            let end = (block + samples).min(heights.len());
            // Some of the samples tell the size.
            let squares =
                (block..end).step_by((samples / 64).max(1)).map(|at| (mean(at, short) - mean(at, long)).powi(2));
            let (count, total) = squares.fold((0, 0.0), |(count, total), square| (count + 1, total + square));
            blocks.push(total / f64::from(count.max(1)));
        }
    }
    blocks
}

/// A number with three digits that mean something.
fn short(value: f64) -> String {
    if (1e-3..1e5).contains(&value.abs()) {
        let decimals = (2 - value.abs().log10().floor() as i32).clamp(0, 5);
        let text = format!("{value:.*}", decimals as usize);
        if text.contains('.') { text.trim_end_matches('0').trim_end_matches('.').to_owned() } else { text }
    } else {
        format!("{value:.2e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    fn rail(amplitude: f64, wavelength: f64) -> Rail {
        let height = |n: i32| amplitude * (TAU * f64::from(n) * 1e-3 / wavelength).sin() + 1e-3 * f64::from(n) * 1e-3;
        Rail {
            name: "left".to_owned(),
            stretches: vec![Profile::new(0.0, 1e-3, (0..20_000).map(height).collect()).unwrap()],
        }
    }

    /// The two moving means pass a wave of 50 mm to some per cent, and a slope of 1 mm in a metre is not counted.
    #[test]
    fn the_band_is_measured() {
        let blocks = block_mean_squares(&rail(10e-6, 0.05).stretches);
        // Windows are shorter at the ends.
        let inner = &blocks[2..blocks.len() - 2];
        for square in inner {
            assert!((square.sqrt() / (10e-6 / 2f64.sqrt()) - 1.0).abs() < 0.1, "{}", square.sqrt());
        }
    }

    #[test]
    fn heights_in_the_wrong_unit_are_no_rail() {
        let check = |amplitude: f64, unit: &str, factor: f64| {
            let rail = rail(amplitude, 0.04);
            check_heights(&[(&rail, unit, factor)]).map_err(|refusal| refusal.message.to_string())
        };
        for amplitude in [1e-6, 10e-6, 100e-6, 450e-6] {
            assert_eq!(check(amplitude, "um", 1e-6), Ok(()));
            // Written in mm and read in µm, and the other way round.
            let wrong = check(1e-3 * amplitude, "um", 1e-6).unwrap_err();
            assert!(wrong.contains("so smooth") && wrong.ends_with("look like mm"), "{wrong}");
        }
        for amplitude in [2e-6, 10e-6, 450e-6] {
            let wrong = check(1e3 * amplitude, "mm", 1e-3).unwrap_err();
            assert!(wrong.contains("so rough") && wrong.ends_with("look like um"), "{wrong}");
        }
    }

    #[test]
    fn steps_in_the_wrong_unit_are_no_record() {
        assert!(check_spacing(1e-3, Some(("m", 1.0))).is_ok());
        let wrong = check_spacing(1.0, Some(("m", 1.0))).unwrap_err();
        assert!(wrong.message.to_string().contains("look like mm"), "{}", wrong.message.to_string());
        let wrong = check_spacing(1e-6, Some(("mm", 1e-3))).unwrap_err();
        assert!(wrong.message.to_string().contains("look like m"), "{}", wrong.message.to_string());
        assert!(check_spacing(1.0, None).unwrap_err().help.unwrap().to_string().contains("1 mm"));
    }

    /// What a sensor at rest makes is no rail, whatever bands are known of it; the smoothest rail is one.
    #[test]
    fn a_sensor_at_rest_is_no_rail() {
        let known = WavelengthBand::new(0.02, 0.2).unwrap();
        let check = |levels: &[f64]| check_axle_box_levels("left", levels.iter().copied(), known);
        for bands in [3, 11, 21] {
            assert_eq!(check(&vec![-20.9; bands]), Ok(()));
            let refused = check(&vec![-23.0; bands]).unwrap_err();
            assert!(refused.contains("is the sensor at rest"), "{refused}");
        }
        assert_eq!(check(&[-40.0, 50.0]), Ok(()));
        assert!(check(&[10.0, 61.0]).unwrap_err().contains("so rough"));
    }

    #[test]
    fn levels_of_another_reference_are_named() {
        assert!(check_levels([-20.0, 5.0, 12.0].into_iter()).is_ok());
        let wrong = check_levels([-130.0, -120.0, -110.0].into_iter()).unwrap_err();
        assert!(wrong.message.to_string().contains("dB re 1 m,"), "{}", wrong.message.to_string());
    }
}
