//! How fast corrugation has been seen to grow.

use std::f64::consts::LN_2;

use riffel::forecast::TrafficGrowth;
use riffel_keys::{Message, fixed, say, significant};

use crate::Case;

/// Days in which the amplitude of the fastest growth known here from a railway doubled: +10.1 dB in the 161 days
/// between the 139th and the 300th after grinding, wavelengths of 4 to 14 cm on the low rail of a metro curve of
/// 120 m radius in Stockholm (Torstensson & Nielsen 2009, *Wear* 267). 20 lg 2 = 6.02 dB.
pub const FASTEST_DOUBLING_DAYS: f64 = 161.0 * 6.020_599_913 / 10.1;

/// Whether a remark is that growth is faster than any seen: dates that follow from it are not to be believed.
pub fn is_of_reported_growth(remark: &Message) -> bool {
    remark.id() == say!(growth_faster_than_any_seen, wavelength = "", known = "", keys = "").id()
}

/// Whether a growth rate per passage \[-\] is faster than that under so many axle passages a day: then no time that follows from
/// it is told, only wavelengths and order.
pub fn is_faster_than_known(rate: f64, passages_per_day: f64) -> bool {
    rate * passages_per_day * FASTEST_DOUBLING_DAYS > LN_2
}

/// A remark where a wavelength \[m\] of a case grows faster than any railway known.
pub fn reported_growth(case: &Case, wavelength: f64, rate: f64, passages_per_day: f64) -> Option<Message> {
    is_faster_than_known(rate, passages_per_day).then(|| {
        say!(
            growth_faster_than_any_seen,
            wavelength = significant(1e3 * wavelength, 3),
            known = fixed(FASTEST_DOUBLING_DAYS, 0),
            keys = match case.steady.slides() {
                true => say!(keys_of_sliding),
                false => say!(keys_of_traction),
            }
        )
    })
}

/// Remark on the band that grows fastest.
pub(super) fn remark(case: &Case, growth: &TrafficGrowth, passages_per_day: f64) -> Option<Message> {
    let bands = growth.bands().iter().enumerate();
    let (band, rate) = bands.map(|(place, band)| (band, growth.band_rate(place))).max_by(|a, b| a.1.total_cmp(&b.1))?;
    reported_growth(case, 1e-3 * band.nominal_millimetres(), rate, passages_per_day)
}
