//! Growth over wavelength at one speed, with its narrow lines.

use riffel_numerics::golden_section::golden_section;

use super::Axis;
use super::branch::minima;
use super::fine_row::FineRow;

/// Growth rates at rising wavelengths of a window, close together where growth changes fast, and at its maxima. Both ends of the
/// window are there.
///
/// Method: that of [`Ridge::search`](super::Ridge::search), so that both say the same of one loop; for growth that is a mean over
/// loops or is filtered besides.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct GrowthSpectrum {
    /// Wavelengths \[m\].
    pub wavelengths: Vec<f64>,
    /// Growth rates per passage \[-\].
    pub rates: Vec<f64>,
}

impl GrowthSpectrum {
    /// The course of a growth rate per passage over a window of wavelengths \[m\], whose number of points has no part; asked from
    /// several threads.
    pub fn of(window: Axis, rate: impl Fn(f64) -> f64 + Sync) -> Self {
        Self::found(window, &rate)
    }

    // Compiled here, and once, whoever asks.
    fn found(window: Axis, rate: &(dyn Fn(f64) -> f64 + Sync)) -> Self {
        let row = FineRow::of(window, |wavelength| -rate(wavelength));
        let tolerance = 1e-7 * (window.max() - window.min());
        let maxima = minima(&row.wavelengths, &row.values);
        let maxima: Vec<(usize, f64, f64)> = maxima
            .iter()
            .map(|minimum| {
                let place = golden_section(minimum.between, tolerance, |wavelength| -rate(wavelength));
                (minimum.index, place, rate(place))
            })
            .filter(|&(index, place, rate)| rate > -row.values[index] && place != row.wavelengths[index])
            .collect();
        let FineRow { mut wavelengths, values } = row;
        let mut rates: Vec<f64> = values.iter().map(|value| -value).collect();
        for (index, place, rate) in maxima.into_iter().rev() {
            let after = index + usize::from(place > wavelengths[index]);
            if after > 0 && after < wavelengths.len() {
                wavelengths.insert(after, place);
                rates.insert(after, rate);
            }
        }
        Self { wavelengths, rates }
    }

    /// The course of growth rates per passage at wavelengths \[m\], rising, one for each.
    pub fn of_values(wavelengths: Vec<f64>, rates: Vec<f64>) -> Self {
        Self { wavelengths, rates }
    }

    /// This course and the one that begins where it ends.
    pub fn followed_by(mut self, next: Self) -> Self {
        self.wavelengths.pop();
        self.rates.pop();
        self.wavelengths.extend(next.wavelengths);
        self.rates.extend(next.rates);
        self
    }

    /// The growth rate between the values, in a straight line; that of the end beyond an end.
    pub fn at(&self, wavelength: f64) -> f64 {
        let after = self.wavelengths.partition_point(|&other| other < wavelength);
        let last = self.wavelengths.len() - 1;
        if after == 0 || after > last {
            return self.rates[after.min(last)];
        }
        let [before, here] = [self.wavelengths[after - 1], self.wavelengths[after]];
        if here == wavelength {
            return self.rates[after];
        }
        let share = (wavelength - before) / (here - before);
        self.rates[after - 1] + share * (self.rates[after] - self.rates[after - 1])
    }

    /// Place of the highest growth rate among the values.
    pub fn highest(&self) -> usize {
        let places = 0..self.rates.len();
        let highest = places.max_by(|&a, &b| self.rates[a].total_cmp(&self.rates[b]));
        highest.unwrap_or(0)
    }
}
