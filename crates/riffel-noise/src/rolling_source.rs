//! Wheel and rail that vibrate, and what they radiate.

use std::f64::consts::{LN_10, TAU};

use riffel::feedback::Loop;
use riffel::receptance::{CrossReceptance, Support, one_sided_places};
use riffel::{Complex64, Error};

use super::{Air, Excitation, FrequencyBand, OscillatingCylinder, OscillatingSphere, Piston, WheelModes};

/// Frequencies in a band, evenly spaced in their logarithm.
const LINES: u32 = 8;
/// Places of the wheel between a support and mid-span, to which a bay is symmetric.
const PLACES: u32 = 4;
/// Length of a bay \[m\] where supports are continuous.
const NOMINAL_BAY: f64 = 0.6;

/// How the rail vibrates away from the wheel.
#[derive(Clone)]
pub enum RailDecay<'a> {
    /// Decay by the model of the track.
    Track(&'a dyn CrossReceptance),
    /// From what it does under the wheel, at measured decay rates.
    Rates {
        /// Decay rates \[dB/m\] by band.
        rates: Vec<(FrequencyBand, f64)>,
        /// What the rail does under the wheel at any place; `None` if it is known at that of the loop alone.
        track: Option<&'a dyn CrossReceptance>,
    },
}

impl RailDecay<'_> {
    /// Whether more than a tenth of |H|² is left at the last place of the integral along the rail, 66 bays away: as much of
    /// the integral lies beyond, where |H|² falls by the same share each metre.
    pub fn runs_on(track: &dyn CrossReceptance, frequency: f64) -> bool {
        let bay = track.support_spacing().unwrap_or(NOMINAL_BAY);
        let last = one_sided_places(bay).fold(0.0, |_, (away, _)| away);
        let from = 0.5 * bay;
        let energy = |to| track.cross_receptance(TAU * frequency, from, to).norm_sqr();
        energy(from + last) > 0.1 * energy(from)
    }
}

/// The sleepers under one rail.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sleepers {
    /// What carries the rail, pads on sleepers.
    pub support: Support,
    /// The face of the half of a sleeper that belongs to one rail.
    pub face: Piston,
    /// Distance of sleepers \[m\].
    pub spacing: f64,
}

/// What a wheel on a rail radiates in a band \[W\], where it rolls on one rail; and what roughness puts into both.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct SoundPower {
    /// The band.
    pub band: FrequencyBand,
    /// Sound power of the rail \[W\].
    pub rail: f64,
    /// Sound power of the sleepers \[W\].
    pub sleepers: f64,
    /// Sound power of the wheel \[W\].
    pub wheel: f64,
    /// Mean square of the contact force \[N²\].
    pub force: f64,
    /// Power that the force puts into the rail \[W\].
    pub into_rail: f64,
}

impl SoundPower {
    /// All of it \[W\].
    pub fn total(&self) -> f64 {
        self.rail + self.sleepers + self.wheel
    }

    fn none(band: FrequencyBand) -> Self {
        Self { band, rail: 0.0, sleepers: 0.0, wheel: 0.0, force: 0.0, into_rail: 0.0 }
    }
}

/// What a wheel on a rail makes of any roughness in a band, at one speed.
#[derive(Debug, Clone, PartialEq)]
pub struct BandRadiation {
    band: FrequencyBand,
    /// Parts of the band by their ends \[Hz\], with all powers of a mean square roughness of 1 m².
    lines: Vec<([f64; 2], SoundPower)>,
}

impl BandRadiation {
    /// Sound power under a roughness at the same speed; `None` if the roughness is not known.
    ///
    /// # Errors
    /// [`Error`] of the roughness.
    pub fn power(&self, excitation: &Excitation) -> Result<Option<SoundPower>, Error> {
        if !excitation.covers(self.band) {
            return Ok(None);
        }
        let mut power = SoundPower::none(self.band);
        for ([low, high], unit) in &self.lines {
            let roughness = excitation.mean_square(*low, *high)?;
            power.rail += roughness * unit.rail;
            power.sleepers += roughness * unit.sleepers;
            power.wheel += roughness * unit.wheel;
            power.force += roughness * unit.force;
            power.into_rail += roughness * unit.into_rail;
        }
        Ok(Some(power))
    }
}

/// A wheel that rolls on a rough rail, radiating.
///
/// Method after P. J. Remington, *Journal of the Acoustical Society of America* 81 (1987) 1805–1823, and D. J. Thompson,
/// *Journal of Sound and Vibration* 161 (1993) 387–482: roughness r between wheel and rail makes the force
///
/// ```text
/// |P|² = r²/|H_r + H_w + 1/k_H|²
/// ```
///
/// and velocities ωH_rP of the rail under it and ωH_wP of the wheel. The rail radiates W = w(f) ∫|v(x)|²dx with the
/// power per length and velocity w of its [`OscillatingCylinder`]; where decay rates Δ \[dB/m\] are measured, the integral
/// is |v(0)|² · (20/ln 10)/Δ. The sleepers move as the rail over them, times their share k_p/(k_p + k_b − ω²m_s). The
/// wheel moves as a rigid body, to which [`WheelModes`] add what its web and tyre do: their receptance, and their sound. Where
/// they are given, wheel and rail share the force that their resonances leave, which a band sums peak by peak.
///
/// Vertical motion alone, at frequencies where the roughness is incoherent from wheel to wheel. Integrals reach 66 bays to
/// either side: rails with less than 0.2 dB/m are louder than said here. The mean is taken over eight frequencies of a band,
/// and over four places of half a bay.
#[derive(Clone)]
pub struct RollingSource<'a> {
    /// Wheel, contact and, where the decay is measured, the track under the wheel.
    pub feedback: &'a Loop,
    /// The rail away from the wheel.
    pub decay: RailDecay<'a>,
    /// The rail as a radiator.
    pub rail: OscillatingCylinder,
    /// The sleepers as radiators; `None` if the rail stands on a slab.
    pub sleepers: Option<Sleepers>,
    /// The wheel as a radiator that moves as a rigid body.
    pub wheel: OscillatingSphere,
    /// The modes of its web and tyre; none for a rigid wheel.
    pub wheel_modes: Option<&'a WheelModes>,
    /// The air.
    pub air: Air,
}

/// Receptance under the wheel \[m/N\] and the integral ∫|H|²dx along the rail \[m³/N²\].
struct RailAt {
    direct: Complex64,
    integral: f64,
}

impl RollingSource<'_> {
    /// Sound power of one wheel on one rail in a band; `None` if the roughness or the decay of the rail is not known.
    ///
    /// # Errors
    /// [`Error`] of the roughness.
    pub fn power(&self, excitation: &Excitation, band: FrequencyBand) -> Result<Option<SoundPower>, Error> {
        if !excitation.covers(band) {
            return Ok(None);
        }
        match self.radiation(band, excitation.speed()) {
            Some(radiation) => radiation.power(excitation),
            None => Ok(None),
        }
    }

    /// What any roughness of a band makes of it at a speed \[m/s\]; `None` if the decay of the rail is not known.
    pub fn radiation(&self, band: FrequencyBand, speed: f64) -> Option<BandRadiation> {
        let rate = match &self.decay {
            RailDecay::Track(_) => None,
            RailDecay::Rates { rates, .. } => {
                let (_, rate) = rates.iter().find(|(other, _)| *other == band)?;
                Some(*rate)
            }
        };
        let (low, high) = band.range();
        let step = (high / low).powf(f64::from(LINES).recip());
        let lines = (0..LINES).map(|line| {
            let from = low * step.powf(f64::from(line));
            let ends = [from, from * step];
            (ends, self.line(band, ends, speed, rate))
        });
        Some(BandRadiation { band, lines: lines.collect() })
    }

    /// What roughness does of a mean square of 1 m² that is spread evenly between two frequencies \[Hz\], over which the rail is
    /// taken to be the same.
    fn line(&self, band: FrequencyBand, ends: [f64; 2], speed: f64, rate: Option<f64>) -> SoundPower {
        let mut power = SoundPower::none(band);
        let middle = (ends[0] * ends[1]).sqrt();
        let [under_wheel, wheel] = self.feedback.normal_receptances(TAU * middle, speed);
        let places = self.places(TAU * middle, under_wheel, rate);
        let share = (places.len() as f64).recip();
        for rail in places {
            let rest = rail.direct + wheel + self.feedback.contacts()[0].stiffness.recip();
            let lines = match self.wheel_modes {
                Some(modes) => modes.lines(ends, rest),
                None => vec![(middle, 1.0)],
            };
            for (frequency, part) in lines {
                let w = TAU * frequency;
                let (given, radiated) = match self.wheel_modes {
                    Some(modes) => (modes.receptance(w), modes.power(w)),
                    None => (Complex64::ZERO, 0.0),
                };
                let force = part * share / (rest + given).norm_sqr();
                power.force += force;
                power.into_rail -= force * w * rail.direct.im;
                let moved = force * w * w * rail.integral;
                power.rail += moved * self.rail.power_per_length(&self.air, frequency);
                if let Some(sleepers) = &self.sleepers
                    && let Some(share) = sleepers.support.sleeper_share(w)
                {
                    let face = sleepers.face.power(&self.air, frequency) / sleepers.spacing;
                    power.sleepers += moved * share.norm_sqr() * face;
                }
                let rigid = w * w * wheel.norm_sqr() * self.wheel.power(&self.air, frequency);
                power.wheel += force * (rigid + radiated);
            }
        }
        power
    }

    /// The rail with the wheel at each place of the mean.
    fn places(&self, w: f64, under_wheel: Complex64, rate: Option<f64>) -> Vec<RailAt> {
        let reach = rate.map(|rate| 20.0 / LN_10 / rate);
        let at = |direct: Complex64, integral: f64| RailAt { direct, integral };
        let track = match &self.decay {
            RailDecay::Track(track) => Some(*track),
            RailDecay::Rates { track, .. } => *track,
        };
        let Some(track) = track else {
            let integral = under_wheel.norm_sqr() * reach.unwrap_or(0.0);
            return vec![at(under_wheel, integral)];
        };
        let (bay, places) = match track.support_spacing() {
            Some(bay) => (bay, PLACES),
            None => (NOMINAL_BAY, 1),
        };
        (0..places)
            .map(|place| {
                let from = 0.5 * bay * (f64::from(place) + 0.5) / f64::from(places);
                let direct = track.cross_receptance(w, from, from);
                if let Some(reach) = reach {
                    return at(direct, direct.norm_sqr() * reach);
                }
                let integral = one_sided_places(bay)
                    .map(|(away, length)| {
                        let sides = [from - away, from + away];
                        let energy = sides.map(|to| track.cross_receptance(w, from, to).norm_sqr());
                        (energy[0] + energy[1]) * length
                    })
                    .sum();
                at(direct, integral)
            })
            .collect()
    }
}

#[cfg(test)]
mod tests;
