//! The wavelength that grows fastest.

use std::f64::consts::LN_2;

use riffel::Axis;
use riffel::growth::GrowthSpectrum;
use riffel_case::{Case, ask};
use riffel_keys::{Message, decimal, fixed, say};
use serde::Serialize;

use crate::number_alone;

/// The wavelength that grows fastest.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(into = "HighestDocument")]
pub struct Highest {
    /// Wavelength \[m\].
    pub wavelength: f64,
    /// Frequency \[Hz\].
    pub frequency: f64,
    /// Growth rate per passage \[-\].
    pub rate: f64,
    /// It stands at an end of the wavelengths: a shorter or longer one may grow faster.
    pub at_edge: bool,
}

impl Highest {
    /// Of a course of growth at one speed \[m/s\]; `None` if nothing grows.
    pub(crate) fn of(course: &GrowthSpectrum, speed: f64) -> Option<Self> {
        let place = course.highest();
        let (wavelength, rate) = (course.wavelengths[place], course.rates[place]);
        (rate > 0.0).then(|| Self {
            wavelength,
            frequency: speed / wavelength,
            rate,
            at_edge: place == 0 || place + 1 == course.rates.len(),
        })
    }

    /// Of a course of growth under a traffic of a mean speed \[m/s\], from a shortest wavelength \[m\] on where it has longer ones; none
    /// where nothing grows.
    pub(crate) fn beyond(course: &GrowthSpectrum, shortest: f64, speed: f64) -> Option<Self> {
        let from = course.wavelengths.partition_point(|&wavelength| wavelength < shortest);
        let from = if from < course.wavelengths.len() { from } else { 0 };
        let [wavelengths, rates] = [&course.wavelengths, &course.rates].map(|values| values[from..].to_vec());
        Self::of(&GrowthSpectrum::of_values(wavelengths, rates), speed)
    }

    /// The wavelength in a table.
    pub(crate) fn millimetres(&self) -> Message {
        match self.at_edge {
            true => say!(at_edge_in_table, value = fixed(1e3 * self.wavelength, 1)),
            false => number_alone(decimal(1e3 * self.wavelength, 1)),
        }
    }

    /// Passages in which the amplitude doubles.
    pub fn doubling_passages(&self) -> f64 {
        LN_2 / self.rate
    }
}

/// The fastest wavelength, as documents hold it.
#[derive(Serialize)]
pub(crate) struct HighestDocument {
    wavelength_m: f64,
    frequency_hz: f64,
    growth_rate_per_passage: f64,
    doubling_passages: f64,
    /// It sits at an end of the wavelengths: another may grow faster.
    at_edge: bool,
}

impl From<Highest> for HighestDocument {
    fn from(highest: Highest) -> Self {
        Self {
            wavelength_m: highest.wavelength,
            frequency_hz: highest.frequency,
            growth_rate_per_passage: highest.rate,
            doubling_passages: highest.doubling_passages(),
            at_edge: highest.at_edge,
        }
    }
}

/// Growth of a case at one speed \[m/s\] over the wavelengths of its map, with its narrow lines, and the wavelength that grows
/// fastest of those of which that is told: all, where growth is filtered by the contact.
pub(crate) fn over_the_window(
    case: &Case,
    filtered: bool,
    speed: f64,
    rate: impl Fn(f64) -> f64 + Sync,
) -> (GrowthSpectrum, Option<Highest>) {
    let window = case.wavelength;
    let told = match filtered {
        true => Some(window),
        false => ask::growth_window(case),
    };
    let Some(told) = told else {
        return (GrowthSpectrum::of(window, rate), None);
    };
    let course = GrowthSpectrum::of(told, &rate);
    let highest = Highest::of(&course, speed);
    let below = Axis::new(window.min(), told.min(), 2).ok();
    let course = match below {
        Some(below) => GrowthSpectrum::of(below, rate).followed_by(course),
        None => course,
    };
    (course, highest)
}

/// The wavelengths of courses, rising, each once: those at which all of them are drawn.
pub(crate) fn wavelengths_of<'a>(courses: impl Iterator<Item = &'a GrowthSpectrum>) -> Vec<f64> {
    /// Wavelengths whose ratio is nearer to one are the same.
    const SAME: f64 = 1e-7;
    let mut all: Vec<f64> = courses.flat_map(|course| course.wavelengths.iter().copied()).collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|later, earlier| *later < *earlier * (1.0 + SAME));
    all
}
