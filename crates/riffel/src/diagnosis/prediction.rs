//! What wavelength a mechanism predicts.

use riffel_numerics::normal_distribution::{above, density};

use super::{GrowthDensity, MechanismKind, TrafficSpeeds};

/// Wavelength or frequency that a mechanism fixes.
#[derive(Debug, Clone, PartialEq)]
pub enum Prediction {
    /// A frequency f: λ = V/f at each speed.
    Frequency {
        /// f \[Hz\].
        frequency: f64,
        /// Standard deviation of ln f.
        spread: f64,
        /// Damping ratio \[-\], where it was measured.
        damping_ratio: Option<f64>,
    },
    /// Growth over wavelength.
    Growth(GrowthDensity),
    /// Any wavelength between two \[m\], the same at every speed.
    Range {
        /// Shortest \[m\].
        from: f64,
        /// Longest \[m\].
        to: f64,
    },
    /// Some wavelengths \[m\], the same at every speed: a length and its parts.
    Orders {
        /// The length \[m\].
        length: f64,
        /// Highest order n of length/n; the orders weigh 1/n, as evenly as they lie over ln λ.
        orders: u32,
        /// Standard deviation of the logarithm of the length.
        spread: f64,
    },
}

/// A mechanism with what it predicts.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct Mechanism {
    /// What it is.
    pub kind: MechanismKind,
    /// Which of several of its kind, as the wheel under which something grows.
    pub of: Option<String>,
    /// What it predicts.
    pub prediction: Prediction,
}

/// Grinding: trains at 3 to 15 km/h with stones of 60 to 50 turns a second.
const GRINDING: (f64, f64) = (3.0 / 3.6 / 60.0, 15.0 / 3.6 / 50.0);

impl Mechanism {
    /// A mechanism of constant frequency f \[Hz\] whose uncertainty is that of its kind.
    pub fn of_frequency(kind: MechanismKind, frequency: f64) -> Self {
        use MechanismKind::{LateralPinnedPinned, PinnedPinned, WheelsetBending, WheelsetTorsion};
        // Stiffnesses of pads and ballast are uncertain by ±30 % and more, distances are not.
        let spread = match kind {
            PinnedPinned | LateralPinnedPinned | WheelsetBending | WheelsetTorsion => 0.05,
            _ => 0.15,
        };
        Self { kind, of: None, prediction: Prediction::Frequency { frequency, spread, damping_ratio: None } }
    }

    /// A peak or dip at f \[Hz\] of the receptance of this very track, with its damping ratio ζ \[-\] if that is known and the
    /// distance of the lines of the measurement δf \[Hz\].
    ///
    /// Standard deviation of ln f: √(s² + ζ² + (δf/2f)²). A resonance acts over its width at half power, ±ζ, and may
    /// stand half a line from where it is seen. s = 5 % is for the place along the line, the temperature of the
    /// pads and the load of a wheel, which a hammer test has not.
    pub fn of_receptance(
        kind: MechanismKind,
        frequency: f64,
        damping_ratio: Option<f64>,
        resolution: Option<f64>,
    ) -> Self {
        const ANOTHER_DAY: f64 = 0.05;
        let half_a_line = resolution.map_or(0.0, |resolution| 0.5 * resolution / frequency);
        let spread = ANOTHER_DAY.hypot(damping_ratio.unwrap_or(0.0)).hypot(half_a_line);
        Self { kind, of: None, prediction: Prediction::Frequency { frequency, spread, damping_ratio } }
    }

    /// The growth of a case.
    pub fn growth_ridge(density: GrowthDensity) -> Self {
        Self { kind: MechanismKind::GrowthRidge, of: None, prediction: Prediction::Growth(density) }
    }

    /// Marks of grinding stones.
    pub fn grinding_mark() -> Self {
        let (from, to) = GRINDING;
        Self { kind: MechanismKind::GrindingMark, of: None, prediction: Prediction::Range { from, to } }
    }

    /// Orders of a wheel of the rolling radius R \[m\].
    pub fn wheel_circumference(rolling_radius: f64) -> Self {
        Self {
            kind: MechanismKind::WheelCircumference,
            of: None,
            prediction: Prediction::Orders { length: std::f64::consts::TAU * rolling_radius, orders: 30, spread: 0.03 },
        }
    }

    /// Supports at the distance d \[m\].
    pub fn support_spacing(spacing: f64) -> Self {
        Self {
            kind: MechanismKind::SupportSpacing,
            of: None,
            prediction: Prediction::Orders { length: spacing, orders: 2, spread: 0.02 },
        }
    }

    /// Prediction of one of several.
    pub fn of(mut self, which: impl Into<String>) -> Self {
        self.of = Some(which.into());
        self
    }

    /// Whether what it predicts at the speeds of the traffic covers a wavelength \[m\] known to ±`uncertainty` of ln λ, within one
    /// standard deviation of both; of growth, whether it grows there at least half as fast as anywhere.
    pub fn covers(&self, wavelength: f64, uncertainty: f64, speeds: &TrafficSpeeds) -> bool {
        let within = |from: f64, to: f64, spread: f64| {
            let room = spread.hypot(uncertainty).exp();
            from / room <= wavelength && wavelength <= to * room
        };
        match &self.prediction {
            Prediction::Frequency { frequency, spread, .. } => {
                let shares = speeds.shares().windows(2);
                // Between speeds that are no further apart than the spread there are others.
                let between = shares.map(|pair| match (pair[1].0 / pair[0].0).ln() < *spread {
                    true => (pair[0].0, pair[1].0),
                    false => (pair[0].0, pair[0].0),
                });
                let fastest = (speeds.fastest(), speeds.fastest());
                between.chain([fastest]).any(|(slower, faster)| within(slower / frequency, faster / frequency, *spread))
            }
            Prediction::Growth(density) => density.covers(wavelength, uncertainty),
            Prediction::Range { from, to } => within(*from, *to, 0.0),
            Prediction::Orders { spread, .. } => {
                self.nearest_order(wavelength).is_some_and(|(_, nearest)| within(nearest, nearest, *spread))
            }
        }
    }

    /// Density of ln λ that the mechanism predicts at a wavelength \[m\] known to ±`uncertainty` of ln λ,
    /// for the speeds of the traffic.
    pub fn density(&self, wavelength: f64, uncertainty: f64, speeds: &TrafficSpeeds) -> f64 {
        let place = wavelength.ln();
        match &self.prediction {
            Prediction::Frequency { frequency, spread, .. } => {
                let spread = spread.hypot(uncertainty);
                let at = |speed: f64| density((place - (speed / frequency).ln()) / spread) / spread;
                let shares = speeds.shares().iter();
                shares.map(|&(speed, share)| share * at(speed)).sum()
            }
            Prediction::Growth(density) => density.at(wavelength, uncertainty),
            Prediction::Range { from, to } => {
                let below = |edge: f64| above((place - edge.ln()) / uncertainty);
                (below(*to) - below(*from)) / (to / from).ln()
            }
            Prediction::Orders { length, orders, spread } => {
                let spread = spread.hypot(uncertainty);
                let weight = |n: u32| f64::from(n).recip();
                let sum: f64 = (1..=*orders).map(weight).sum();
                let at = |n: u32| {
                    let distance = place - (length / f64::from(n)).ln();
                    weight(n) * density(distance / spread) / spread
                };
                (1..=*orders).map(at).sum::<f64>() / sum
            }
        }
    }

    /// Frequency \[Hz\] that it fixes, if it does.
    pub fn frequency(&self) -> Option<f64> {
        match &self.prediction {
            Prediction::Frequency { frequency, .. } => Some(*frequency),
            Prediction::Growth(density) => density.peak_frequency(),
            _ => None,
        }
    }

    /// Shortest and longest wavelength \[m\] that it predicts for the speeds of the traffic, its own
    /// uncertainty aside.
    pub fn wavelengths(&self, speeds: &TrafficSpeeds) -> Option<(f64, f64)> {
        match &self.prediction {
            Prediction::Frequency { frequency, .. } => {
                Some((speeds.slowest() / frequency, speeds.fastest() / frequency))
            }
            Prediction::Growth(density) => density.range(),
            Prediction::Range { from, to } => Some((*from, *to)),
            Prediction::Orders { length, orders, .. } => Some((length / f64::from(*orders), *length)),
        }
    }

    /// The order n of its length that lies nearest to a wavelength \[m\], and length/n \[m\].
    pub fn nearest_order(&self, wavelength: f64) -> Option<(u32, f64)> {
        let Prediction::Orders { length, orders, .. } = self.prediction else {
            return None;
        };
        let order = ((length / wavelength).round() as u32).clamp(1, orders);
        Some((order, length / f64::from(order)))
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    /// Densities over ln λ add up to one.
    #[test]
    fn densities_are_densities() {
        let speeds = TrafficSpeeds::between(20.0, 40.0).unwrap();
        for mechanism in [
            Mechanism::of_frequency(MechanismKind::PinnedPinned, 1000.0),
            Mechanism::of_frequency(MechanismKind::P2, 70.0),
            Mechanism::grinding_mark(),
            Mechanism::wheel_circumference(0.46),
            Mechanism::support_spacing(0.6),
            Mechanism::of_receptance(MechanismKind::MeasuredPeak, 490.0, Some(0.08), Some(5.0)),
        ] {
            let step = 0.002;
            let sum: f64 = (-4000..2000)
                .map(|index| (step * f64::from(index)).exp())
                .map(|wavelength| step * mechanism.density(wavelength, 0.03, &speeds))
                .sum();
            assert!((sum - 1.0).abs() < 1e-3, "{:?} {sum}", mechanism.kind);
        }
    }

    /// √(0.05² + 0.08² + (20/980)²).
    #[test]
    fn damping_and_lines_widen_a_measured_peak() {
        let spread = |damping, resolution| {
            let peak = Mechanism::of_receptance(MechanismKind::MeasuredPeak, 490.0, damping, resolution);
            match peak.prediction {
                Prediction::Frequency { spread, .. } => spread,
                _ => f64::NAN,
            }
        };
        assert_eq!(spread(None, None), 0.05);
        assert!((spread(Some(0.08), Some(20.0)) - 0.096_522).abs() < 1e-6);
    }

    /// 45 km/h at 125 Hz is 100 mm ±15 %: 89 mm is covered, 70 mm is not; of speeds in between neither is what none makes.
    #[test]
    fn covers_what_it_makes() {
        let one = TrafficSpeeds::between(12.5, 12.5).unwrap();
        let pads = Mechanism::of_frequency(MechanismKind::RailOnPad, 125.0);
        let covered = |mechanism: &Mechanism, wavelength| mechanism.covers(wavelength, 0.02, &one);
        assert!(covered(&pads, 0.100) && covered(&pads, 0.089) && covered(&pads, 0.115));
        assert!(!covered(&pads, 0.0697) && !covered(&pads, 0.120));
        let two = TrafficSpeeds::new([(12.5, 1.0), (25.0, 1.0)]).unwrap();
        assert!(pads.covers(0.1, 0.02, &two) && pads.covers(0.2, 0.02, &two));
        assert!(!pads.covers(0.14, 0.02, &two));
        let range = TrafficSpeeds::between(12.5, 25.0).unwrap();
        assert!(pads.covers(0.14, 0.02, &range) && !pads.covers(0.25, 0.02, &range));
        let wheel = Mechanism::wheel_circumference(0.5);
        assert!(covered(&wheel, PI / 2.0) && !covered(&wheel, PI / 2.4));
    }

    #[test]
    fn wavelengths_follow_the_speed_or_do_not() {
        let speeds = TrafficSpeeds::between(20.0, 40.0).unwrap();
        let pinned = Mechanism::of_frequency(MechanismKind::PinnedPinned, 1000.0);
        assert_eq!(pinned.wavelengths(&speeds), Some((0.02, 0.04)));
        let wheel = Mechanism::wheel_circumference(0.5);
        let (order, wavelength) = wheel.nearest_order(0.315).unwrap();
        assert_eq!(order, 10);
        assert!((wavelength - 0.314_159).abs() < 1e-6);
        let (from, to) = Mechanism::grinding_mark().wavelengths(&speeds).unwrap();
        assert!((from - 0.0139).abs() < 1e-4 && (to - 0.0833).abs() < 1e-4);
    }
}
