//! The loop closed over a tile of wavelengths, in vector instructions.

use pulp::{Simd, WithSimd};

use crate::tile::SplitComplex;
use crate::vector::Vector;

/// All that enters one tile.
pub(super) struct Closing<'a> {
    pub(super) track: &'a SplitComplex,
    pub(super) wheel: &'a SplitComplex,
    pub(super) speeds: &'a SplitComplex,
    pub(super) by_force: &'a SplitComplex,
    pub(super) by_speed: &'a SplitComplex,
    pub(super) slip: &'a SplitComplex,
    /// Two columns of the wave's own geometry.
    pub(super) wave: Option<&'a [SplitComplex; 2]>,
    /// e_ξ Δ/(μP₀ξ₀) and, by the direction of the normal force, T k²P₀, see [`NormalDirection`](crate::feedback::NormalDirection).
    pub(super) direction: Option<[&'a SplitComplex; 2]>,
    /// z, the share of the force.
    pub(super) force: f64,
    /// 1/k_H \[m/N\].
    pub(super) contact: f64,
    /// 1/V \[s/m\].
    pub(super) per_speed: f64,
    pub(super) result: &'a mut SplitComplex,
}

impl WithSimd for Closing<'_> {
    type Output = ();

    /// Ŵ₁ = (by_force z + by_speed y/V) / ((H + H_w + 1/k_H)(z + slip y/V)), z and y the shares of force and
    /// speed, and the receptance times the same of the wave in the numerator: one division for each wavelength.
    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let [track, wheel, speeds, by_force, by_speed, slip] =
            [self.track, self.wheel, self.speeds, self.by_force, self.by_speed, self.slip]
                .map(|row| Rows::<S>::of(row));
        let wave = self.wave.map(|wave| wave.each_ref().map(Rows::<S>::of));
        let direction = self.direction.map(|rows| rows.map(Rows::<S>::of));
        let contact = simd.splat_f64s(self.contact);
        let per_speed = simd.splat_f64s(self.per_speed);
        let one = simd.splat_f64s(1.0);
        let force = Vector { re: simd.splat_f64s(self.force), im: simd.splat_f64s(0.0) };
        let (re, _) = S::as_mut_simd_f64s(&mut self.result.re);
        let (im, _) = S::as_mut_simd_f64s(&mut self.result.im);
        for (j, (re, im)) in re.iter_mut().zip(im).enumerate() {
            let speed = speeds.at(j).scaled(simd, per_speed);
            let receptance = Vector {
                re: simd.add_f64s(simd.add_f64s(track.at(j).re, wheel.at(j).re), contact),
                im: simd.add_f64s(track.at(j).im, wheel.at(j).im),
            };
            let numerator = by_force.at(j).scaled(simd, force.re);
            let mut numerator = by_speed.at(j).times_plus(simd, speed, numerator);
            if let Some([by_force, by_speed]) = &wave {
                let geometry = by_force.at(j).scaled(simd, force.re);
                let geometry = by_speed.at(j).times_plus(simd, speed, geometry);
                numerator = geometry.times_plus(simd, receptance, numerator);
            }
            if let Some([by_creepage, slip]) = &direction {
                let by_profile = by_creepage.at(j).times(simd, slip.at(j));
                let by_profile = by_profile.scaled(simd, force.re);
                numerator = by_profile.times_plus(simd, receptance, numerator);
            }
            let sliding = slip.at(j).times_plus(simd, speed, force);
            let denominator = receptance.times(simd, sliding);
            let inverse = simd.div_f64s(one, denominator.norm_sqr(simd));
            let quotient = denominator.conj(simd).times(simd, numerator);
            let quotient = quotient.scaled(simd, inverse);
            (*re, *im) = (quotient.re, quotient.im);
        }
    }
}

/// A row seen as vectors.
struct Rows<'a, S: Simd> {
    re: &'a [S::f64s],
    im: &'a [S::f64s],
}

impl<'a, S: Simd> Rows<'a, S> {
    #[inline(always)]
    fn of(row: &'a SplitComplex) -> Self {
        Self { re: S::as_simd_f64s(&row.re).0, im: S::as_simd_f64s(&row.im).0 }
    }

    #[inline(always)]
    fn at(&self, index: usize) -> Vector<S> {
        Vector { re: self.re[index], im: self.im[index] }
    }
}
