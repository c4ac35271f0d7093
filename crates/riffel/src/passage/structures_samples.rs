//! Receptances of track and wheels over the band in which they are fitted.

use std::f64::consts::TAU;

use num_complex::Complex64;
use rayon::prelude::*;

use super::{ImpulseResponse, StructuresInTime};
use crate::Error;

/// Receptances at one frequency.
pub(super) struct Sample {
    pub(super) w: f64,
    /// H by rows.
    pub(super) whole: Vec<Complex64>,
    /// What of it is fitted together.
    pub(super) fitted: Vec<Complex64>,
    /// That along the rail by forces through the hubs; empty where normal forces stay upright.
    pub(super) direction: Vec<Complex64>,
}

/// Receptances by rows at an angular frequency: the whole, what of it is fitted together, and along the rail by forces through the hubs.
pub(super) type Receptances<'a> = dyn Fn(f64) -> [Vec<Complex64>; 3] + Sync + 'a;

/// Receptances of hubs with those of a rail along itself, of which all axes are given by rows.
pub(super) fn with_rail_along(mut hubs: Vec<Complex64>, rail: &[Complex64]) -> Vec<Complex64> {
    let contacts = hubs.len().isqrt();
    for (index, hub) in hubs.iter_mut().enumerate() {
        let (to, from) = (index / contacts, index % contacts);
        *hub += rail[9 * to * contacts + 3 * from];
    }
    hubs
}

/// Receptances over the band: evenly over the decades, around the lines, and between neighbours that differ much.
pub(super) fn samples(size: usize, receptances: &Receptances<'_>, lines: &[f64]) -> Result<Vec<Sample>, Error> {
    const TO_A_DECADE: f64 = 60.0;
    /// How far around a line, over its frequency.
    const AROUND: [f64; 7] = [-0.01, -0.003, -0.001, 0.0, 0.001, 0.003, 0.01];
    /// Largest change between neighbours, over the smaller.
    const CHANGE: f64 = 0.4;
    const HALVINGS: usize = 8;
    /// More frequencies would be fitted for minutes.
    const MOST: usize = 2500;
    let (lowest, _) = ImpulseResponse::BAND;
    let highest = TAU * StructuresInTime::HIGHEST;
    let count = ((highest / lowest).log10() * TO_A_DECADE).ceil();
    let mut frequencies: Vec<f64> =
        (0..=count as usize).map(|index| lowest * (highest / lowest).powf(index as f64 / count)).collect();
    for line in lines {
        frequencies.extend(AROUND.map(|by| (1.0 + by) * line));
    }
    frequencies.retain(|w| (lowest..=highest).contains(w));
    frequencies.sort_by(f64::total_cmp);
    frequencies.dedup();
    let take = |frequencies: Vec<f64>| -> Result<Vec<Sample>, Error> {
        frequencies
            .into_par_iter()
            .map(|w| {
                let [whole, fitted, direction] = receptances(w);
                match whole.iter().all(|value| value.is_finite()) {
                    true => Ok(Sample { w, whole, fitted, direction }),
                    false => Err(Error::OutOfRange {
                        quantity: "frequency of a receptance that is not finite",
                        value: w / TAU,
                        unit: "Hz",
                        rule: "motion in time needs all frequencies: give track and wheelset some damping",
                    }),
                }
            })
            .collect()
    };
    let far = |one: &Sample, other: &Sample| {
        (0..size).any(|axis| {
            let [one, other] = [one, other].map(|sample| sample.fitted[axis * (size + 1)]);
            (one - other).norm() > CHANGE * one.norm().min(other.norm())
        })
    };
    let mut samples = take(frequencies)?;
    for _ in 0..HALVINGS {
        let between: Vec<f64> = samples
            .windows(2)
            .filter(|pair| pair[0].w < TAU * StructuresInTime::KNOWN && far(&pair[0], &pair[1]))
            .map(|pair| (pair[0].w * pair[1].w).sqrt())
            .collect();
        if between.is_empty() || samples.len() + between.len() > MOST {
            break;
        }
        samples.extend(take(between)?);
        samples.sort_by(|one, other| one.w.total_cmp(&other.w));
    }
    Ok(samples)
}
