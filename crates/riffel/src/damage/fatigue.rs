//! Rolling contact fatigue by Tγ, and cracks beside wear.

use num_complex::Complex64;

use super::Ramps;
use crate::Error;

/// D(Tγ) of the whole-life rail model (Burstow 2004; heights recalled, not looked up): zero below the first threshold, rising to
/// its peak per axle at the second, falling through zero at the third, below zero beyond, where wear removes cracks.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fatigue {
    /// D, with its sign.
    damage: Ramps,
    /// ⟨D⟩, without it.
    growing: Ramps,
    /// Depth spalled off per unit of ⟨D⟩ \[m\].
    pub loss: f64,
    /// c_D \[m\]: growth of a crack per unit of ⟨D⟩.
    pub crack_growth: f64,
    /// α \[rad\] of a crack against the surface.
    pub crack_angle: f64,
}

impl Fatigue {
    /// The law of thresholds of Tγ \[N\] and the peak of D per axle \[-\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the thresholds rise and the peak is above zero.
    pub fn new(thresholds: [f64; 3], peak: f64) -> Result<Self, Error> {
        Error::unless_positive("peak of the fatigue damage", peak, "")?;
        let [first, second, third] = thresholds;
        if !(0.0 <= first && first < second && second < third) {
            return Err(Error::OutOfRange {
                quantity: "second threshold of Tγ",
                value: second,
                unit: "N",
                rule: "must lie between the first and the third",
            });
        }
        let [rise, fall] = [peak / (second - first), peak / (third - second)];
        let damage = [(first, rise), (second, -rise - fall), (third, 0.0)];
        let growing = [damage[0], damage[1], (third, fall)];
        Ok(Self {
            damage: Ramps::new(damage),
            growing: Ramps::new(growing),
            loss: 0.0,
            crack_growth: 0.0,
            crack_angle: std::f64::consts::FRAC_PI_6,
        })
    }

    /// First threshold of Tγ \[N\], below which nothing grows.
    pub fn first_threshold(&self) -> f64 {
        self.damage.begin()
    }

    /// D with its sign.
    pub fn damage(&self) -> &Ramps {
        &self.damage
    }

    /// ⟨D⟩.
    pub fn growing(&self) -> &Ramps {
        &self.growing
    }

    /// h₁ \[m\] of the energy e₁ \[N\] at a point of the rail about the mean e₀.
    pub fn depth_1(&self, mean: f64, oscillation: Complex64) -> Complex64 {
        oscillation * (self.loss * self.growing.rate(mean, oscillation.norm()))
    }

    /// Net growth of a crack per passage \[m\], mean and first harmonic: c_D⟨D⟩ less the wear over sin α, of a wear in proportion
    /// to energy by a depth per joule \[m²/J\].
    pub fn crack(&self, mean: f64, oscillation: Complex64, wear: f64) -> (f64, Complex64) {
        let size = oscillation.norm();
        let worn = wear / self.crack_angle.sin();
        (
            self.crack_growth * self.growing.mean(mean, size) - worn * mean,
            oscillation * (self.crack_growth * self.growing.rate(mean, size) - worn),
        )
    }
}
