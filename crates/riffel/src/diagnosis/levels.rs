//! Dominant wavelengths of one-third-octave spectra.

use riffel_numerics::normal_distribution;

use super::DominantWavelength;
use super::median_line::median_line;
use super::normal;
use crate::roughness::{Spectrum, ThirdOctave};

/// Bands to either side from which the trend is taken: half a decade.
const TREND: i32 = 5;
/// Decibels above the trend from which a band is called dominant: twice the power.
const PROMINENT: f64 = 3.0;
/// How many bands may look like this by chance in one set of spectra.
const FALSE_ALARMS: f64 = 0.05;

/// Prominence of a band: its level less that of the line through its neighbours up to half a decade away
/// with the median of all slopes; `None` if either side has less than two.
fn prominence(spectrum: &Spectrum, band: ThirdOctave) -> Option<f64> {
    let own = spectrum.level(band)?;
    let neighbours = |range: std::ops::RangeInclusive<i32>| -> Vec<(f64, f64)> {
        range
            .filter_map(|by| {
                let level = spectrum.level(ThirdOctave::new(band.index() + by))?;
                Some((f64::from(by), level))
            })
            .collect()
    };
    let (mut points, longer) = (neighbours(-TREND..=-1), neighbours(1..=TREND));
    if points.len() < 2 || longer.len() < 2 {
        return None;
    }
    points.extend(longer);
    Some(own - median_line(&points, 0.0)?)
}

/// One-third octaves of several spectra of one rail, or of like rails, that stand 3 dB or more over the
/// trend of their neighbours and are higher than the two next to them; the most prominent first.
///
/// With two spectra or more the scatter of the prominence between them says how sure it is (Student's t).
/// A single spectrum is taken as it is.
pub fn dominant_levels(spectra: &[Spectrum]) -> Vec<DominantWavelength> {
    let Some(mean) = Spectrum::arithmetic_mean(spectra) else {
        return Vec::new();
    };
    let count = mean.levels().len() as f64;
    let mut peaks: Vec<DominantWavelength> = mean
        .levels()
        .iter()
        .filter_map(|own| {
            let higher = |by: i32| {
                let next = mean.level(ThirdOctave::new(own.band.index() + by));
                next.is_some_and(|next| own.level > next)
            };
            let above = prominence(&mean, own.band)?;
            if above < PROMINENT || !higher(-1) || !higher(1) {
                return None;
            }
            let each: Vec<f64> = spectra.iter().filter_map(|spectrum| prominence(spectrum, own.band)).collect();
            let scatter = standard_error(&each);
            let false_peaks = scatter.map(|scatter| {
                let freedom = each.len() as f64 - 1.0;
                count * normal_distribution::above(normal::of_student(above / scatter, freedom))
            });
            if false_peaks.is_some_and(|peaks| peaks > FALSE_ALARMS) {
                return None;
            }
            let (from, to) = own.band.wavelength_range();
            Some(DominantWavelength {
                wavelength: 1e-3 * own.band.nominal_millimetres(),
                from,
                to,
                level: own.level,
                prominence: above,
                scatter,
                false_peaks,
                harmonic_of: None,
            })
        })
        .collect();
    peaks.sort_by(|a, b| b.prominence.total_cmp(&a.prominence));
    peaks
}

/// Standard error of the mean of some values; None for less than two.
pub(super) fn standard_error(values: &[f64]) -> Option<f64> {
    let count = values.len() as f64;
    let mean = values.iter().sum::<f64>() / count;
    let squares: f64 = values.iter().map(|value| (value - mean).powi(2)).sum();
    // Spectra that were copied scatter by nothing; they still were rounded to tenths of a decibel.
    const ROUNDED: f64 = 0.03;
    (count > 1.0).then(|| (squares / (count - 1.0) / count).sqrt().max(ROUNDED))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn spectrum(change: impl Fn(i32) -> f64) -> Spectrum {
        Spectrum::new((-25..=-5).map(|index| {
            let band = ThirdOctave::new(index);
            (band, 1.5 * f64::from(index) + 20.0 + change(index))
        }))
        .unwrap()
    }

    #[test]
    fn a_band_above_its_neighbours_is_found() {
        let peaks = dominant_levels(&[spectrum(|index| if index == -14 { 6.0 } else { 0.0 })]);
        assert_eq!(peaks.len(), 1);
        assert!((peaks[0].prominence - 6.0).abs() < 1e-9);
        assert_eq!(peaks[0].wavelength, 0.040);
        assert_eq!(peaks[0].scatter, None);
        assert!(dominant_levels(&[spectrum(|_| 0.0)]).is_empty());
        assert!(dominant_levels(&[]).is_empty());
    }

    /// A band that is high in one spectrum of four and not in the others is no finding.
    #[test]
    fn what_scatters_is_not_sure() {
        let one = |high: f64| spectrum(move |index| if index == -14 { high } else { 0.0 });
        let unsure = dominant_levels(&[one(16.0), one(0.5), one(-1.0), one(0.0)]);
        assert!(unsure.is_empty(), "{unsure:?}");
        let sure = dominant_levels(&[one(6.0), one(5.0), one(4.5), one(5.5)]);
        assert!(sure[0].false_peaks.unwrap() < 0.05 && sure[0].scatter.unwrap() < 0.4);
    }
}
