//! Growth at a site with one draw of its choices.

use riffel::forecast::TrafficGrowth;
use riffel_case::Variant;
use riffel_case::traffic::{DAYS_PER_MONTH, Traffic, bands_of};
use riffel_keys::CaseError;
use toml::Value;

use super::site::Site;

/// Level \[dB\] of an e-fold of the amplitude.
const DECIBELS: f64 = 20.0 / std::f64::consts::LN_10;

/// What grows at a site with one draw of its choices.
#[derive(Debug, Clone, Copy)]
pub(super) struct Sample {
    /// Of the fastest growth \[m\].
    pub(super) wavelength: f64,
    /// Of the two strongest peaks, the shorter first \[m\]; twice the same where there is but one.
    pub(super) strongest: [f64; 2],
    /// Mean speed over the wavelength \[Hz\].
    pub(super) frequency: f64,
    /// \[dB per million axles\]; below zero where everything decays.
    pub(super) growth: f64,
    /// \[dB a month\], where the axles a day are known.
    pub(super) growth_per_month: Option<f64>,
    /// \[mm per 100 MGT\].
    pub(super) mean_wear: f64,
    /// Frequency \[Hz\] at which its loop oscillates by itself, if it does: growth means nothing then.
    pub(super) unstable: Option<f64>,
}

impl Sample {
    /// Growth \[dB per million axles\] that counts as none: 1 dB, which a measurement hardly tells, in ten million axles, the traffic
    /// of years.
    pub(super) const NONE: f64 = 0.1;

    /// Whether anything grows.
    pub(super) fn grows(&self) -> bool {
        self.growth > Self::NONE
    }

    pub(super) fn of(site: &Site, seed: u64, sample: usize, set: &[(String, Value)]) -> Result<Self, CaseError> {
        let traffic = site.traffic(seed, sample, set)?;
        let name = format!("validation/field/{}/traffic.toml", site.name);
        let traffic = Traffic::parse(&name, &traffic.to_string())?;
        let on = traffic.on(&site.case, &bands_of(&site.case), &Variant::none(""), &|_| ())?;
        let growth = &on.growth;
        let (wavelengths, rates) = (growth.wavelengths(), growth.rates());
        let peaks = peaks(rates);
        let first = peaks[0];
        let second = peaks.get(1).copied().unwrap_or(first);
        let (short, long) = (first.min(second), first.max(second));
        let decibels = DECIBELS * 1e6 * rates[first];
        let per_month = |per_day: f64| 1e-6 * per_day * DAYS_PER_MONTH * decibels;
        Ok(Self {
            wavelength: wavelengths[first],
            strongest: [wavelengths[short], wavelengths[long]],
            frequency: mean_speed(growth) / wavelengths[first],
            growth: decibels,
            growth_per_month: on.passages_per_day.map(per_month),
            unstable: on.unstable,
            mean_wear: 1e3 * growth.mean_wear().depth_per_100_mgt(),
        })
    }
}

/// In the mean over the axles \[m/s\].
fn mean_speed(growth: &TrafficGrowth) -> f64 {
    let vehicles = growth.vehicles().iter();
    vehicles.map(|vehicle| vehicle.share * vehicle.speeds.mean()).sum()
}

/// Places of the local maxima, the highest first; the highest of all where there is no other.
fn peaks(rates: &[f64]) -> Vec<usize> {
    let at = |place: usize| rates.get(place).copied().unwrap_or(f64::NEG_INFINITY);
    let before = |place: usize| place.checked_sub(1).map_or(f64::NEG_INFINITY, at);
    let mut peaks: Vec<usize> =
        (0..rates.len()).filter(|&place| at(place) >= before(place) && at(place) > at(place + 1)).collect();
    peaks.sort_by(|&a, &b| rates[b].total_cmp(&rates[a]));
    peaks
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_found_in_their_order() {
        assert_eq!(peaks(&[0.0, 2.0, 1.0, 3.0, 3.0, -1.0, 0.5]), [4, 1, 6]);
        assert_eq!(peaks(&[1.0]), [0]);
    }
}
