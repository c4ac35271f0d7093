//! Pressures to which a rail may be loaded again and again.

use riffel_numerics::bisection::bisection;

use crate::cancel::check;

/// Which limit S, as p₀/k over the utilised friction f = |Q|/P, the demand is measured against.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ShakedownLimit {
    /// First yield by von Mises under an ellipse in full slip of friction f.
    Elastic {
        /// a/b.
        ratio: f64,
        /// Poisson's ratio.
        poisson_ratio: f64,
    },
    /// Elastic shakedown of line contact: 1/max|τ_xz|, which residual stress cannot change (Melan; exact for Tresca). Below
    /// the surface up to f = 0.367, there 1/f.
    Line,
    /// 1/f, that of the surface.
    Surface,
    /// 1/max|τ_xz| of an ellipse without friction (Lundberg & Palmgren 1947): an upper bound.
    Subsurface {
        /// a/b.
        ratio: f64,
    },
}

impl ShakedownLimit {
    /// S and its relative slope d ln S/df at a utilised friction.
    pub fn at(&self, friction: f64) -> [f64; 2] {
        check();
        match *self {
            Self::Elastic { ratio, poisson_ratio } => super::stress::elastic_limit(ratio, poisson_ratio, friction),
            Self::Line => {
                let [shear, by_friction] = line_shear(friction);
                [shear.recip(), -by_friction / shear]
            }
            Self::Surface => [friction.recip(), -friction.recip()],
            Self::Subsurface { ratio } => [orthogonal_shear(ratio).0.recip(), 0.0],
        }
    }
}

/// Largest |τ_xz|/p₀ under an ellipse a/b without friction, a along x, and its depth over a (Lundberg & Palmgren 1947).
pub fn orthogonal_shear(ratio: f64) -> (f64, f64) {
    // a/b = √((t² − 1)(2t − 1)) rises with t.
    let square = ratio * ratio;
    let is_beyond = |t: f64| (t * t - 1.0) * (2.0 * t - 1.0) >= square;
    let mut high = 2.0;
    while !is_beyond(high) {
        high *= 2.0;
    }
    let [low, high] = bisection([1.0, high], 0.0, is_beyond);
    let t = 0.5 * (low + high);
    let root = (2.0 * t - 1.0).sqrt();
    (root / (2.0 * t * (t + 1.0)), ((t + 1.0) * root).recip())
}

/// Largest |τ_xz|/p₀ under a line contact in full slip of a friction, and its slope over friction: |σ_x| of the pressure there.
fn line_shear(friction: f64) -> [f64; 2] {
    // The stress of a traction f p is τ_xz = f σ_x of p; σ_x < 0 is even over the middle, τ_xz odd.
    let at = |x: f64, z: f64| {
        let [along, shear] = line_stress(x, z);
        shear.abs() + friction * along.abs()
    };
    /// Steps to each side of the best point, and by what they narrow.
    const SIDE: i32 = 8;
    const NARROW: f64 = 0.3;
    let mut best = ([0.0, 0.0], at(0.0, 0.0));
    let (mut middle, mut half) = ([0.75, 0.75], 0.75);
    for _ in 0..30 {
        for i in -SIDE..=SIDE {
            for j in -SIDE..=SIDE {
                let place = [i, j].map(|step| half * f64::from(step) / f64::from(SIDE));
                let [x, z] = [middle[0] + place[0], middle[1] + place[1]].map(|v: f64| v.max(0.0));
                let value = at(x, z);
                if value > best.1 {
                    best = ([x, z], value);
                }
            }
        }
        (middle, half) = (best.0, NARROW * half);
    }
    let [x, z] = best.0;
    [best.1, line_stress(x, z)[0].abs()]
}

/// σ_x and τ_xz over p₀ under the pressure of a line contact, x and z ≥ 0 over its half width (McEwen; Johnson 1985, 4.49).
fn line_stress(x: f64, z: f64) -> [f64; 2] {
    let real = 1.0 - x * x + z * z;
    let modulus = real.hypot(2.0 * x * z);
    let [m2, n2] = [0.5 * (modulus + real), 0.5 * (modulus - real)];
    let [m, n] = [m2, n2].map(|square| square.max(0.0).sqrt());
    if modulus == 0.0 {
        return [0.0, 0.0];
    }
    let n = n.copysign(x);
    [-(m * (1.0 + (z * z + n2) / modulus) - 2.0 * z), -n * (m2 - z * z) / modulus]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// 4 without friction, 1/f from 0.367 on; printed values of the page in between.
    #[test]
    fn line_contact() {
        for (friction, limit) in [(0.0, 4.0), (0.1, 3.564), (0.2, 3.202), (0.3, 2.900), (0.36, 2.741)] {
            let [value, _] = ShakedownLimit::Line.at(friction);
            assert!((value - limit).abs() < 6e-4, "{friction}: {value}");
        }
        for friction in [0.37, 0.5, 0.6] {
            let [value, slope] = ShakedownLimit::Line.at(friction);
            assert!((value * friction - 1.0).abs() < 1e-12);
            assert!((slope * friction + 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn slope_is_that_of_the_limit() {
        for friction in [0.05, 0.2, 0.34] {
            let step = 1e-4;
            let ln = |friction: f64| ShakedownLimit::Line.at(friction)[0].ln();
            let difference = (ln(friction + step) - ln(friction - step)) / (2.0 * step);
            let [_, slope] = ShakedownLimit::Line.at(friction);
            assert!((difference - slope).abs() < 1e-6, "{difference} {slope}");
        }
    }

    /// 4.675 under a circle, 4 of a long ellipse across, and the depth 0.35 of a circle.
    #[test]
    fn without_friction_under_an_ellipse() {
        for (ratio, limit) in [(0.5, 4.216), (1.0, 4.675), (1.587, 5.31), (2.0, 5.78), (1e-6, 4.0)] {
            let [value, slope] = ShakedownLimit::Subsurface { ratio }.at(0.3);
            assert!((value - limit).abs() < 6e-3, "{ratio}: {value}");
            assert_eq!(slope, 0.0);
        }
    }
}
