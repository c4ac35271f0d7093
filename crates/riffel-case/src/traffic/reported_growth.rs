//! How fast corrugation has been seen to grow.

use std::f64::consts::LN_2;

use riffel::forecast::TrafficGrowth;
use riffel_keys::{Message, fixed, say, significant};

/// Days in which the amplitude of the fastest growth known here from a railway doubled: +10.1 dB in the 161 days
/// between the 139th and the 300th after grinding, wavelengths of 4 to 14 cm on the low rail of a metro curve of
/// 120 m radius in Stockholm (Torstensson & Nielsen 2009, *Wear* 267). 20 lg 2 = 6.02 dB.
const FASTEST_DOUBLING: f64 = 161.0 * 6.020_599_913 / 10.1;

/// Whether a remark is that growth is faster than any seen: dates that follow from it are not to be believed.
pub fn is_of_reported_growth(remark: &Message) -> bool {
    remark.id()
        == say!(
            growth_faster_than_any_seen,
            wavelength = "",
            days = "",
            known = ""
        )
        .id()
}

/// A remark where a wavelength \[m\] grows faster than that, at its growth rate per passage \[-\] and so many axle passages a day.
pub fn reported_growth(wavelength: f64, rate: f64, passages_per_day: f64) -> Option<Message> {
    let days = LN_2 / (rate * passages_per_day);
    (rate > 0.0 && days < FASTEST_DOUBLING).then(|| {
        say!(
            growth_faster_than_any_seen,
            wavelength = significant(1e3 * wavelength, 3),
            days = significant(days, 2),
            known = fixed(FASTEST_DOUBLING, 0)
        )
    })
}

/// The same of the band that grows fastest.
pub(super) fn remark(growth: &TrafficGrowth, passages_per_day: f64) -> Option<Message> {
    let bands = growth.bands().iter().enumerate();
    let (band, rate) = bands
        .map(|(place, band)| (band, growth.band_rate(place)))
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    reported_growth(1e-3 * band.nominal_millimetres(), rate, passages_per_day)
}
