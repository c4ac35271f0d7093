//! A wheel whose web and tyre ring.

use std::f64::consts::TAU;

use rayon::prelude::*;
use riffel::{Complex64, Error};
use riffel_numerics::gauss::panels;

use super::cylinder::efficiency;
use super::{Air, VibratingDisc};

/// A natural mode of a wheel on its axle, of a generalised mass of 1 kg.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelMode {
    /// Number n of nodal diameters.
    pub nodal_diameters: u32,
    /// Natural frequency \[Hz\].
    pub frequency: f64,
    /// Damping ratio ζ without the rail.
    pub damping_ratio: f64,
    /// Displacement of the contact along the radius \[1/√kg\].
    pub radial_at_contact: f64,
    /// Displacement of the tread along the radius, the root mean square over its width \[1/√kg\].
    pub radial_of_tread: f64,
    /// Displacement along the axis at each of the wheel's radii \[1/√kg\].
    pub axial: Vec<f64>,
}

/// What of a mode takes part.
#[derive(Debug, Clone, PartialEq)]
struct Ringing {
    /// Natural angular frequency \[rad/s\].
    natural: f64,
    damping_ratio: f64,
    /// Displacement of the contact \[1/√kg\].
    contact: f64,
    power: Radiated,
}

/// Sound power of a mode per mean square generalised velocity \[1/s\], over the frequency at which it is driven.
#[derive(Debug, Clone, PartialEq)]
struct Radiated {
    /// ln ω and ln of the power, rising.
    nodes: Vec<(f64, f64)>,
}

/// Modes of a wheel with what each radiates.
///
/// Each motion s cos nθ is the one that a force at θ = 0 makes. Along the axis a mode radiates as a [`VibratingDisc`], along the
/// radius as a long cylinder with n waves around it, of which the tread and its underside, 2 · 2πRw, are cut out; both
/// at the frequency at which it is driven, as a power of frequency between half octaves from the natural frequency, to half a
/// decibel. That a wheel turns, by which each frequency becomes two that are nΩ/2π apart,
/// some 10 to 60 Hz, is left out, and so are the hub, the axle and the other wheel.
#[derive(Debug, Clone, PartialEq)]
pub struct WheelModes {
    modes: Vec<Ringing>,
}

/// Frequencies in a narrow band, with their shares of it.
pub(super) type Lines = Vec<(f64, f64)>;

impl WheelModes {
    /// Modes of a wheel of the rolling radius R with a tread of the width w, whose axial displacements are given at some
    /// radii \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for lengths and frequencies that are not positive, damping ratios outside 0–1, radii that do not
    /// increase, or displacements that are not finite, as many as radii.
    pub fn new(rolling_radius: f64, width: f64, radii: &[f64], modes: &[WheelMode], air: &Air) -> Result<Self, Error> {
        Error::unless_positive("rolling radius", rolling_radius, "m")?;
        Error::unless_positive("width of the wheel", width, "m")?;
        let ringing = modes.par_iter().map(|mode| {
            Error::unless_positive("natural frequency of a wheel", mode.frequency, "Hz")?;
            if !(mode.damping_ratio > 0.0 && mode.damping_ratio < 1.0) {
                return Err(Error::OutOfRange {
                    quantity: "damping ratio of a wheel",
                    value: mode.damping_ratio,
                    unit: "",
                    rule: "must be above zero and below one",
                });
            }
            for (quantity, value) in [
                ("radial displacement of the contact", mode.radial_at_contact),
                ("radial displacement of the tread", mode.radial_of_tread),
            ] {
                if !value.is_finite() {
                    return Err(Error::OutOfRange { quantity, value, unit: "1/√kg", rule: "must be finite" });
                }
            }
            let disc = VibratingDisc::new(mode.nodal_diameters, radii, &mode.axial)?;
            let around = if mode.nodal_diameters == 0 { 1.0 } else { 0.5 };
            let tread = air.impedance() * (2.0 * TAU * rolling_radius * width) * around * mode.radial_of_tread.powi(2);
            let power = |frequency: f64| {
                let around = air.wavenumber(frequency) * rolling_radius;
                disc.power(air, frequency) + tread * efficiency(mode.nodal_diameters, around)
            };
            Ok(Ringing {
                natural: TAU * mode.frequency,
                damping_ratio: mode.damping_ratio,
                contact: mode.radial_at_contact,
                power: Radiated::about(mode.frequency, power),
            })
        });
        Ok(Self { modes: ringing.collect::<Result<Vec<Ringing>, Error>>()? })
    }

    /// Modes with dampers on the wheel, by which none has less than a damping ratio.
    #[must_use]
    pub fn damped(&self, damping_ratio: f64) -> Self {
        let damped = |mode: &Ringing| Ringing { damping_ratio: mode.damping_ratio.max(damping_ratio), ..mode.clone() };
        Self { modes: self.modes.iter().map(damped).collect() }
    }

    /// Radial receptance of the contact by the modes alone \[m/N\], Σφ²/(ω_n² − ω² + 2iζω_nω).
    pub fn receptance(&self, angular_frequency: f64) -> Complex64 {
        let of_mode = |mode: &Ringing| mode.contact.powi(2) * mode.response(angular_frequency);
        self.modes.iter().map(of_mode).sum()
    }

    /// Sound power per mean square of the force at the contact \[W/N²\].
    pub fn power(&self, angular_frequency: f64) -> f64 {
        let w = angular_frequency;
        let of_mode = |mode: &Ringing| mode.power.at(w) * (w * mode.contact).powi(2) * mode.response(w).norm_sqr();
        self.modes.iter().map(of_mode).sum()
    }

    /// Frequencies \[Hz\] between two, whose shares of the band, on a logarithmic axis, sum up what modes do where the rest of
    /// wheel, contact and rail has some compliance.
    ///
    /// On the rail a mode rings at √(ω_n² + 2iζω_n² + φ²/C), where C is the compliance of all the rest. Panels begin there,
    /// as wide as half the peak, and double.
    pub(super) fn lines(&self, [from, to]: [f64; 2], rest: Complex64) -> Lines {
        const NARROWEST: f64 = 1e-6;
        let mut edges = vec![from, to];
        for (index, mode) in self.modes.iter().enumerate() {
            let others: Complex64 = self
                .modes
                .iter()
                .enumerate()
                .filter(|(other, _)| *other != index)
                .map(|(_, other)| other.contact.powi(2) * other.response(mode.natural))
                .sum();
            let free = Complex64::new(1.0, 2.0 * mode.damping_ratio) * mode.natural.powi(2);
            let loaded = (free + mode.contact.powi(2) / (rest + others)).sqrt() / TAU;
            let alone = free.sqrt() / TAU;
            for pole in [loaded, alone] {
                let narrowest = NARROWEST * pole.re;
                let mut width = (0.5 * pole.im.abs()).max(narrowest).max(f64::MIN_POSITIVE);
                edges.push(pole.re);
                while width < to - from || width < pole.re - to || width < from - pole.re {
                    edges.extend([pole.re - width, pole.re + width]);
                    width *= 2.0;
                }
            }
        }
        edges.retain(|edge| (from..=to).contains(edge));
        edges.sort_by(f64::total_cmp);
        edges.dedup();
        let whole = (to / from).ln();
        panels(&edges).map(|(frequency, weight)| (frequency, weight / frequency / whole)).collect()
    }
}

impl Radiated {
    /// Of a function of the frequency \[Hz\], about a natural frequency.
    fn about(natural: f64, power: impl Fn(f64) -> f64) -> Self {
        /// Lowest frequency that is heard \[Hz\].
        const LOWEST: f64 = 50.0;
        const HIGHEST: f64 = 10e3;
        // Octaves from the natural frequency.
        let halves = (1..30).map(|half| 0.5 * f64::from(half));
        let below = halves.clone().map(|octave| -octave);
        let below = below.take_while(|octave| natural * octave.exp2() > 0.7 * LOWEST);
        let above = halves.take_while(|octave| natural * octave.exp2() < 1.5 * HIGHEST);
        let mut places: Vec<f64> = below.chain(above).chain([0.0, -0.5, 0.5]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let node = |octave: f64| {
            let frequency = natural * octave.exp2();
            let power = power(frequency).max(f64::MIN_POSITIVE);
            ((TAU * frequency).ln(), power.ln())
        };
        Self { nodes: places.into_iter().map(node).collect() }
    }

    /// At an angular frequency \[rad/s\]; beyond the nodes it goes on as between the last of them.
    fn at(&self, w: f64) -> f64 {
        let place = w.ln();
        let after = self.nodes.partition_point(|node| node.0 < place);
        let after = after.clamp(1, self.nodes.len() - 1);
        let [before, after] = [self.nodes[after - 1], self.nodes[after]];
        let share = (place - before.0) / (after.0 - before.0);
        (before.1 + share * (after.1 - before.1)).exp()
    }
}

impl Ringing {
    /// 1/(ω_n² − ω² + 2iζω_nω).
    fn response(&self, w: f64) -> Complex64 {
        let detuning = (self.natural - w) * (self.natural + w);
        Complex64::new(detuning, 2.0 * self.damping_ratio * self.natural * w).inv()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RADII: [f64; 4] = [0.14, 0.25, 0.39, 0.46];

    fn mode(frequency: f64, contact: f64) -> WheelMode {
        WheelMode {
            nodal_diameters: 2,
            frequency,
            damping_ratio: 1e-4,
            radial_at_contact: contact,
            radial_of_tread: contact,
            axial: vec![0.0, 0.02, 0.05, 0.06],
        }
    }

    fn wheel(modes: &[WheelMode]) -> Result<WheelModes, Error> {
        WheelModes::new(0.46, 0.135, &RADII, modes, &Air::default())
    }

    /// The lines sum a spectrum as a million equal steps do, with two modes 0.1 % apart on a compliance that damps them: 1e-4,
    /// what the steps leave.
    #[test]
    fn lines_are_enough() -> Result<(), Error> {
        let wheel = wheel(&[mode(2000.0, 0.06), mode(2002.0, 0.05), mode(2300.0, 0.07)])?;
        let rest = Complex64::new(1e-9, -4e-10);
        let force = |frequency: f64| {
            let w = TAU * frequency;
            (rest + wheel.receptance(w)).norm_sqr().recip() * wheel.power(w)
        };
        for ends in [[1900.0, 1960.0], [1980.0, 2040.0], [2040.0, 2100.0]] {
            let lines = wheel.lines(ends, rest);
            let found: f64 = lines.iter().map(|(f, share)| force(*f) * share).sum();
            let steps = 1_000_000;
            let step = (ends[1] / ends[0]).powf(f64::from(steps).recip());
            let expected: f64 = (0..steps).map(|index| force(ends[0] * step.powf(f64::from(index) + 0.5))).sum::<f64>()
                / f64::from(steps);
            assert!((found / expected - 1.0).abs() < 1e-4, "{ends:?}: {found} {expected}");
            let shares: f64 = lines.iter().map(|(_, share)| share).sum();
            assert!((shares - 1.0).abs() < 1e-9);
        }
        Ok(())
    }

    /// A steel wheel loses as much to the air as it loses in all, 2ζω_n, within an order of magnitude: ζ is measured in air.
    #[test]
    fn what_is_radiated_is_of_the_order_of_what_is_lost() -> Result<(), Error> {
        let ringing = wheel(&[mode(2000.0, 0.06)])?.modes[0].clone();
        let power = ringing.power.at(ringing.natural);
        let lost = 2.0 * ringing.damping_ratio * ringing.natural;
        assert!(power > 0.1 * lost && power < 2.0 * lost, "{ringing:?} {lost}");
        Ok(())
    }

    /// Driven far below its natural frequency a mode radiates with the efficiency of the frequency that drives it: as disc and
    /// tread do there, exactly on octaves and within a decibel between them; with many waves around next to nothing.
    #[test]
    fn a_mode_radiates_at_the_frequency_that_drives_it() -> Result<(), Error> {
        let (air, natural) = (Air::default(), 9000.0);
        let mode = mode(natural, 0.06);
        let ringing = wheel(std::slice::from_ref(&mode))?.modes[0].clone();
        let disc = VibratingDisc::new(mode.nodal_diameters, &RADII, &mode.axial)?;
        let expected = |frequency: f64| {
            let tread = air.impedance() * (2.0 * TAU * 0.46 * 0.135) * 0.5 * 0.06_f64.powi(2);
            disc.power(&air, frequency) + tread * efficiency(2, air.wavenumber(frequency) * 0.46)
        };
        for octave in [0, -1, -2, -4, -6] {
            let frequency = natural * f64::from(octave).exp2();
            let found = ringing.power.at(TAU * frequency) / expected(frequency);
            assert!((found - 1.0).abs() < 1e-9, "{frequency}: {found}");
        }
        for frequency in [200.0, 330.0, 7000.0] {
            let off = 10.0 * (ringing.power.at(TAU * frequency) / expected(frequency)).log10();
            assert!(off.abs() < 1.0, "{frequency}: {off} dB");
        }
        // Six waves around are short-circuited at 200 Hz, where two still radiate half of what they do above.
        let six = WheelMode { nodal_diameters: 6, ..mode };
        let ringing = wheel(&[six])?.modes[0].clone();
        let below = ringing.power.at(TAU * 200.0) / ringing.power.at(TAU * natural);
        assert!(below < 1e-3, "{below}");
        Ok(())
    }

    #[test]
    fn a_wheel_below_its_modes_is_a_spring() -> Result<(), Error> {
        let wheel = wheel(&[mode(2000.0, 0.06)])?;
        let expected = (0.06 / (TAU * 2000.0)).powi(2);
        assert!((wheel.receptance(1.0).re / expected - 1.0).abs() < 1e-6);
        assert!(wheel.receptance(1.0).im < 0.0);
        let damped = wheel.damped(0.01);
        let peak = |wheel: &WheelModes| wheel.receptance(TAU * 2000.0).im;
        assert!((peak(&wheel) / peak(&damped) - 100.0).abs() < 1e-6);
        Ok(())
    }

    #[test]
    fn impossible_modes_are_refused() {
        for wrong in [
            WheelMode { damping_ratio: 0.0, ..mode(2000.0, 0.06) },
            WheelMode { damping_ratio: 1.0, ..mode(2000.0, 0.06) },
            WheelMode { frequency: -1.0, ..mode(2000.0, 0.06) },
            WheelMode { radial_at_contact: f64::NAN, ..mode(2000.0, 0.06) },
            WheelMode { axial: vec![1.0], ..mode(2000.0, 0.06) },
        ] {
            assert!(wheel(std::slice::from_ref(&wrong)).is_err(), "{wrong:?}");
        }
    }
}
