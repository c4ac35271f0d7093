//! Wear by regime: coefficients that depend on how hard a contact works.

use std::f64::consts::PI;

use riffel_numerics::gauss::{equal_panels, panels};

use crate::contact::MeanRolling;
use crate::damage::Ramps;
use crate::wear::WearRegime;
use crate::{EnergyWear, Error, HertzContact, STEEL_DENSITY};

/// How regimes of wear meet.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WearCorners {
    /// Corners as results of twin discs are drawn (the USFD law): a slope, a plateau, a slope. On the plateau a wave is answered by
    /// its load alone, h₁/h₀ = ⅔P₁/P₀.
    Sharp,
    /// The corner at 10.4 N/mm² by a fourth power, that at 77.2 over 5 N/mm².
    Rounded,
}

/// A law of wear with regimes.
///
/// A step from a slope to a plateau makes the growth of a wave vanish on the plateau but for what its patch does, and a step
/// upward makes it infinite: contacts of traffic work on either side of a corner, so that their mean has none.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum WearRegimes {
    /// Mass per metre and area over Tγ/A, energy per metre and area of the patch: 5.3 µg/m/mm² per N/mm² to 10.4 N/mm², then
    /// 55.1 µg/m/mm², above 77.2 N/mm² rising by 61.9. R8T wheel on UIC60 900A rail, twin disc, dry (Lewis & Dwyer-Joyce 2004 as
    /// quoted by others; the offset of the last regime is contradictory there, here the law is continuous). Contacts of traffic are
    /// spread about the mean state as their median.
    TgammaArea {
        /// How its regimes meet.
        corners: WearCorners,
        /// Standard deviation of ln(Tγ/A) over traffic \[-\]; zero: all contacts are alike.
        spread: f64,
    },
    /// k(v, p) of V = kNs/H (Jendel, *Wear* 253 (2002) 89, recalled and not looked up; the middle of each range): 5e-4 mild, 35e-4
    /// from 0.2 to 0.7 m/s, 350e-4 above 0.8 H; H = 2.75 GPa.
    ArchardMap {
        /// Speed of the wheel \[m/s\], of which the creepage makes the sliding speed v.
        speed: f64,
    },
}

/// What a law of regimes is at a mean state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct AtMeanState {
    /// Mass over energy \[kg/J\].
    pub(crate) coefficient: f64,
    /// d ln m/d ln e at constant load \[-\].
    pub(crate) by_energy: f64,
    /// d ln m/d ln P at constant energy \[-\].
    pub(crate) by_load: f64,
    /// d ln m/dκ of the curvature of a wave at constant energy and load \[-\].
    pub(crate) by_curvature: f64,
}

/// Hardness of rail steel \[Pa\], 280 HV.
const HARDNESS: f64 = 2.75e9;

impl WearRegimes {
    /// The law of wear of a contact in a mean state, divided by a factor for natural lubrication.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a contact that dissipates nothing, and for a factor or density that is not above zero.
    pub fn wear(
        self,
        hertz: &HertzContact,
        steady: &MeanRolling,
        density: f64,
        lubrication: f64,
    ) -> Result<EnergyWear, Error> {
        Error::unless_positive("energy per metre", steady.energy_per_metre(), "J/m")?;
        Error::unless_positive("factor of natural lubrication", lubrication, "")?;
        let [a, b] = [hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral()];
        let at = self.at(steady, PI * a * b, hertz.pressure_by_curvature()?);
        let wear = EnergyWear::new(at.coefficient / lubrication, density, b)?;
        Ok(wear.by_regime(WearRegime {
            by_energy: at.by_energy,
            by_load: at.by_load * steady.energy_per_metre() / steady.normal_force,
            by_curvature: at.by_curvature * steady.energy_per_metre(),
        }))
    }

    /// `rise` is d ln p₀/dκ.
    fn at(self, steady: &MeanRolling, area: f64, rise: f64) -> AtMeanState {
        let (energy, load) = (steady.energy_per_metre(), steady.normal_force);
        match self {
            Self::TgammaArea { corners, spread } => {
                // [N/mm²], and [µg/m/mm²] = 1e-9 kg/m/mm².
                let x = 1e-6 * energy / area;
                let [rate, slope] = match corners {
                    WearCorners::Sharp => REGIMES.over_log_normal(x, spread),
                    WearCorners::Rounded => rounded_over_log_normal(x, spread),
                };
                let by_energy = slope / rate;
                AtMeanState {
                    coefficient: 1e-9 * rate / x,
                    by_energy,
                    // A ∝ P^(2/3), and over waves by −c.
                    by_load: 2.0 / 3.0 * (1.0 - by_energy),
                    by_curvature: -rise * (1.0 - by_energy),
                }
            }
            Self::ArchardMap { speed } => {
                // As if all slid: s per metre is e/μP.
                let sliding = speed * energy / (steady.friction * load);
                let pressure = 1.5 * load / area;
                let [k, by_speed, by_pressure] = archard_map(sliding, pressure);
                AtMeanState {
                    coefficient: STEEL_DENSITY * k / (steady.friction * HARDNESS),
                    by_energy: 1.0 + by_speed,
                    // v ∝ e/P, p ∝ P^(1/3).
                    by_load: by_pressure / 3.0 - by_speed,
                    // A metre of a crest takes the longer by κ: v ∝ e/(1 + κ).
                    by_curvature: rise * by_pressure - by_speed,
                }
            }
        }
    }
}

/// Rate \[µg/m/mm²\] over Tγ/A \[N/mm²\] with sharp corners.
const REGIMES: Ramps = Ramps::new([(0.0, 5.3), (10.4, -5.3), (77.2, 61.9)]);

/// E W and E x W′ of the rounded law over x = median · e^{σz}.
fn rounded_over_log_normal(median: f64, sigma: f64) -> [f64; 2] {
    /// Standard deviations beyond which nothing counts.
    const TAIL: f64 = 10.0;
    let at = |x: f64| {
        let [rate, slope] = tgamma_area(x);
        [rate, x * slope]
    };
    if sigma == 0.0 {
        return at(median);
    }
    let mut sums = [0.0; 2];
    // The corner at 77.2 is 0.065 wide in ln x.
    let longest = (0.03 / sigma).min(0.25);
    for (z, weight) in panels(&equal_panels([-TAIL, TAIL], longest)) {
        let bell = (-0.5 * z * z).exp() / (2.0 * PI).sqrt();
        for (sum, value) in sums.iter_mut().zip(at(median * (sigma * z).exp())) {
            *sum += weight * bell * value;
        }
    }
    sums
}

/// Rate \[µg/m/mm²\] and its slope at Tγ/A \[N/mm²\], the corner at 10.4 rounded by a fourth power, that at 77.2 over 5 N/mm².
fn tgamma_area(x: f64) -> [f64; 2] {
    const MILD: f64 = 5.3;
    const SEVERE: f64 = 5.3 * 10.4;
    const CATASTROPHIC: f64 = 61.9;
    const CORNER: f64 = 77.2;
    const WIDTH: f64 = 5.0;
    let rounded = ((MILD * x).powi(-4) + SEVERE.powi(-4)).powf(-0.25);
    let slope = rounded.powi(5) * (MILD * x).powi(-5) * MILD;
    let above = (x - CORNER) / WIDTH;
    let soft = above.max(0.0) + (-above.abs()).exp().ln_1p();
    let share = 1.0 / (1.0 + (-above).exp());
    [rounded + CATASTROPHIC * WIDTH * soft, slope + CATASTROPHIC * share]
}

/// k, d ln k/d ln v and d ln k/d ln p at a sliding speed \[m/s\] and a pressure \[Pa\], corners rounded over a tenth of each.
fn archard_map(speed: f64, pressure: f64) -> [f64; 3] {
    const MILD: f64 = 5e-4;
    const SEVERE: f64 = 35e-4;
    const SEIZING: f64 = 350e-4;
    const ROUNDED: f64 = 0.1;
    let step = |ratio: f64| {
        let share = 1.0 / (1.0 + ratio.powf(-1.0 / ROUNDED));
        [share, share * (1.0 - share) / ROUNDED]
    };
    let [begins, of_begin] = step(speed / 0.2);
    let [ends, of_end] = step(speed / 0.7);
    let [seizes, of_seizing] = step(pressure / (0.8 * HARDNESS));
    let severe = (SEVERE / MILD).ln();
    let below = MILD.ln() + severe * (begins - ends);
    let above = SEIZING.ln() - below;
    [(below + above * seizes).exp(), (1.0 - seizes) * severe * (of_begin - of_end), above * of_seizing]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Printed values away from corners: 5.3x below, 55.1 on the plateau, 55.1 + 61.9(x − 77.2) above.
    #[test]
    fn regimes_of_tgamma_over_area() {
        for (x, expected, tolerance) in [(1.0, 5.3, 1e-4), (30.0, 55.12, 5e-3), (150.0, 55.12 + 61.9 * 72.8, 1e-3)] {
            let [rate, slope] = tgamma_area(x);
            assert!((rate / expected - 1.0).abs() < tolerance, "{x}: {rate}");
            let step = 1e-5 * x;
            let difference = (tgamma_area(x + step)[0] - tgamma_area(x - step)[0]) / (2.0 * step);
            assert!((slope - difference).abs() < 1e-5 * slope.abs().max(1e-3), "{x}: {slope} {difference}");
        }
        // The plateau is left with what the rounded corners leave, 2 % of proportion.
        assert!(30.0 * tgamma_area(30.0)[1] < 0.02 * tgamma_area(30.0)[0]);
    }

    #[test]
    fn regimes_of_the_archard_map() {
        for (speed, pressure, expected) in
            [(0.05, 1e9, 5e-4), (0.37, 1e9, 35e-4), (2.0, 1e9, 5e-4), (0.37, 4e9, 350e-4)]
        {
            let [k, by_speed, by_pressure] = archard_map(speed, pressure);
            assert!((k / expected - 1.0).abs() < 0.05, "{speed}: {k}");
            let ln = |speed, pressure| archard_map(speed, pressure)[0].ln();
            let step: f64 = 1e-5;
            let of_speed = (ln(speed * step.exp(), pressure) - ln(speed * (-step).exp(), pressure)) / (2.0 * step);
            let of_pressure = (ln(speed, pressure * step.exp()) - ln(speed, pressure * (-step).exp())) / (2.0 * step);
            assert!((by_speed - of_speed).abs() < 1e-6 && (by_pressure - of_pressure).abs() < 1e-6);
        }
    }
}
