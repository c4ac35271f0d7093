//! Growth under a mix of vehicles.

mod vehicle_growth;

use super::cracks::WavePhase;
use super::hardening_wheel::HardeningWheel;
use super::marched::RatesByAmplitude;
use super::{LINES_PER_BAND, MeasuredGrowth, band_lines};
use crate::growth::GrowthSpectrum;
use crate::roughness::ThirdOctave;
use crate::{Error, MeanWear};
use vehicle_growth::mean;

pub use vehicle_growth::VehicleGrowth;
pub(super) use vehicle_growth::lines_of;

/// Growth rates of the lines of some bands under a mix of vehicles.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct TrafficGrowth {
    bands: Vec<ThirdOctave>,
    vehicles: Vec<VehicleGrowth>,
    rates: Vec<f64>,
    /// Bands, by their places, that grow as they were measured to.
    measured: Vec<usize>,
}

impl TrafficGrowth {
    /// The mix of vehicles over the bands for which each was computed; shares are scaled to sum to one.
    ///
    /// The rate of a passage of the mix is g = Σ_v share_v g_v: wheels change the amplitude one after
    /// the other, so their exponents add.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there is a vehicle and a band, and every vehicle has the lines of the
    /// bands.
    pub fn new(bands: Vec<ThirdOctave>, mut vehicles: Vec<VehicleGrowth>) -> Result<Self, Error> {
        let lines = LINES_PER_BAND * bands.len();
        let wrong = |quantity, value: usize, rule| Error::OutOfRange { quantity, value: value as f64, unit: "", rule };
        if bands.is_empty() {
            return Err(wrong("number of bands", 0, "must be one or more"));
        }
        if vehicles.is_empty() {
            return Err(wrong("number of vehicles", 0, "must be one or more"));
        }
        if let Some(other) = vehicles.iter().find(|vehicle| vehicle.growth.rates.len() != lines) {
            let count = other.growth.rates.len();
            return Err(wrong("number of lines of a vehicle", count, "must be that of the bands"));
        }
        let sum: f64 = vehicles.iter().map(|vehicle| vehicle.share).sum();
        Error::unless_positive("sum of the shares of the axle passages", sum, "")?;
        for vehicle in &mut vehicles {
            vehicle.share /= sum;
        }
        let rate = |line: usize| {
            let rates = vehicles.iter().map(|vehicle| vehicle.share * vehicle.growth.rates[line]);
            rates.sum()
        };
        Ok(Self { rates: (0..lines).map(rate).collect(), bands, vehicles, measured: Vec::new() })
    }

    /// The traffic where each band that was measured grows as it did, in place of what the model says; times of the growth are axle
    /// passages. Every vehicle has its share in it.
    pub fn as_measured(mut self, growth: &MeasuredGrowth) -> Self {
        for (place, band) in self.bands.iter().enumerate() {
            let Some(measured) = growth.band(*band) else {
                continue;
            };
            let rate = measured.slope * std::f64::consts::LN_10 / 20.0;
            self.rates[lines_of(place)].fill(rate);
            self.measured.push(place);
            for vehicle in &mut self.vehicles {
                vehicle.growth.rates[lines_of(place)].fill(rate);
                // What was measured does not tell lines apart.
                vehicle.spectrum = None;
            }
        }
        self
    }

    /// The bands.
    pub fn bands(&self) -> &[ThirdOctave] {
        &self.bands
    }

    /// The vehicles, shares summing to one.
    pub fn vehicles(&self) -> &[VehicleGrowth] {
        &self.vehicles
    }

    /// Wavelengths of all lines \[m\].
    pub fn wavelengths(&self) -> Vec<f64> {
        band_lines(&self.bands)
    }

    /// Growth rate of the amplitude per axle passage \[-\] of every line.
    pub fn rates(&self) -> &[f64] {
        &self.rates
    }

    /// The wavelength \[m\] from a shortest one on that grows fastest, its growth rate per axle passage \[-\], and whether a shorter or
    /// longer one may grow faster. Of vehicles with a [spectrum](VehicleGrowth::spectrum) narrow lines count; `None` if no line is so long.
    pub fn fastest(&self, shortest: f64) -> Option<(f64, f64, bool)> {
        let lines = self.wavelengths();
        let spectra = self.vehicles.iter();
        let spectra: Vec<(f64, GrowthSpectrum)> =
            spectra.map(|vehicle| (vehicle.share, vehicle.spectrum_over(&lines))).collect();
        let inside = |wavelength: &&f64| **wavelength >= shortest;
        let places = spectra.iter().flat_map(|(_, spectrum)| &spectrum.wavelengths);
        let mut places: Vec<f64> = places.filter(inside).copied().collect();
        places.sort_by(f64::total_cmp);
        let rate = |wavelength: f64| {
            let rates = spectra.iter();
            rates.map(|(share, spectrum)| share * spectrum.at(wavelength)).sum::<f64>()
        };
        let rates = places.iter().map(|&wavelength| (wavelength, rate(wavelength)));
        let (wavelength, rate) = rates.max_by(|a, b| a.1.total_cmp(&b.1))?;
        let at_edge = [places.first(), places.last()].contains(&Some(&wavelength));
        Some((wavelength, rate, at_edge))
    }

    /// The fastest growth rate per axle passage \[-\] within a tenth of a wavelength \[m\]; `None` if there is no line.
    pub fn fastest_near(&self, wavelength: f64) -> Option<f64> {
        let lines = self.wavelengths().into_iter().zip(&self.rates);
        let near = lines.filter(|(own, _)| (own / wavelength - 1.0).abs() <= 0.1);
        near.map(|(_, rate)| *rate).reduce(f64::max)
    }

    /// Growth rates of the lines of a band \[-\], by its place among the bands.
    pub fn lines(&self, band: usize) -> &[f64] {
        &self.rates[lines_of(band)]
    }

    /// Growth rates as a forecast takes them: lines that decay keep their level.
    pub(super) fn forecast_lines(&self, band: usize) -> impl Iterator<Item = f64> {
        self.lines(band).iter().map(|rate| rate.max(0.0))
    }

    /// Rates of the lines of a band over the amplitude of the wave; `None` if they do not depend on it, or were measured.
    pub(super) fn rates_by_amplitude(&self, band: usize) -> Option<RatesByAmplitude> {
        let mut vehicles = self.vehicles.iter();
        let known = vehicles.find(|vehicle| vehicle.depends_on_amplitude())?;
        if !self.is_of_loop(band) {
            return None;
        }
        let rates = known.by_amplitude.iter().enumerate();
        let rates = rates.map(|(index, (amplitude, _))| {
            let mean = lines_of(band).map(|line| {
                let rates = self.vehicles.iter();
                rates.map(|vehicle| vehicle.share * vehicle.rate_at(index, line)).sum()
            });
            (*amplitude, mean.collect())
        });
        Some(RatesByAmplitude { rates: rates.collect() })
    }

    /// Wheels under which a band of the loop, by its place, flows and hardens.
    pub(super) fn hardening(&self, band: usize) -> Vec<HardeningWheel> {
        if !self.is_of_loop(band) {
            return Vec::new();
        }
        let wheels = self.vehicles.iter().flat_map(|vehicle| {
            let wheels = vehicle.hardening.iter();
            wheels.map(|wheel| wheel.part(lines_of(band), vehicle.share))
        });
        wheels.collect()
    }

    /// Cracks per passage at the phases of a wave of some amplitude \[m\] in the middle of a band, by its place; `None` if no
    /// vehicle has fatigue among its laws.
    pub(super) fn cracks(&self, band: usize, amplitude: f64) -> Option<[WavePhase; 4]> {
        let vehicles = self.vehicles.iter();
        let each = vehicles.filter_map(|vehicle| {
            let phases = vehicle.cracks.as_ref()?.at(band, amplitude);
            Some(phases.map(|own| vehicle.share * own))
        });
        let sum = each.reduce(|sum, other| std::array::from_fn(|i| sum[i] + other[i]))?;
        Some(WavePhase::all(&sum))
    }

    /// Whether growth depends on the amplitude of the wave under any vehicle.
    pub fn depends_on_amplitude(&self) -> bool {
        let mut vehicles = self.vehicles.iter();
        vehicles.any(VehicleGrowth::depends_on_amplitude)
    }

    /// Whether the rates of a band, by its place, are those of the loop and not measured ones.
    pub(super) fn is_of_loop(&self, band: usize) -> bool {
        !self.measured.contains(&band)
    }

    /// Mean growth rate of the amplitude per axle passage in a band \[-\], by its place among the bands: that
    /// of the RMS of a band whose energy is spread evenly.
    pub fn band_rate(&self, band: usize) -> f64 {
        mean(self.lines(band))
    }

    /// Mean wear of the rail under the mix.
    pub fn mean_wear(&self) -> MeanWear {
        let depths = self.vehicles.iter().map(|v| v.share * v.wear_depth);
        MeanWear {
            depth: depths.sum(),
            axle_mass: self.axle_mass(),
            bounds_growth: self.vehicles.iter().all(|v| v.bounded_by_wear),
        }
    }

    /// Mean mass of an axle \[kg\].
    pub fn axle_mass(&self) -> f64 {
        let masses = self.vehicles.iter().map(|v| v.share * v.axle_mass);
        masses.sum()
    }

    /// Gross mass over the track \[million tonnes, MGT\] after some axle passages.
    pub fn mgt(&self, passages: f64) -> f64 {
        1e-9 * passages * self.axle_mass()
    }

    /// Axle passages of a gross mass \[million tonnes, MGT\].
    pub fn passages(&self, mgt: f64) -> f64 {
        1e9 * mgt / self.axle_mass()
    }

    /// The least accurate rate of any vehicle by its share: change on halving the step in speed \[-\].
    pub fn rate_error(&self) -> f64 {
        let errors = self.vehicles.iter().map(|v| v.share * v.growth.rate_error);
        errors.sum()
    }
}
