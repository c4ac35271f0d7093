//! The contact of Hertz as a spring that hardens and lets go.

use crate::Error;

/// Normal force P = C_H δ^{3/2} of the approach δ of two bodies, and zero if they part, δ < 0.
///
/// Made from the normal force P₀ and the linearised stiffness there, so that dP/dδ = k_H at P₀: δ₀ = 3P₀/2k_H,
/// C_H = P₀/δ₀^{3/2}.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HertzSpring {
    normal_force: f64,
    approach: f64,
    constant: f64,
}

impl HertzSpring {
    /// The spring with the stiffness k_H \[N/m\] under the normal force P₀ \[N\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless both are positive.
    pub fn new(normal_force: f64, stiffness: f64) -> Result<Self, Error> {
        Error::unless_positive("normal force", normal_force, "N")?;
        Error::unless_positive("contact stiffness", stiffness, "N/m")?;
        let approach = 1.5 * normal_force / stiffness;
        Ok(Self { normal_force, approach, constant: normal_force / (approach * approach.sqrt()) })
    }

    /// P₀ \[N\].
    pub fn normal_force(&self) -> f64 {
        self.normal_force
    }

    /// δ₀ \[m\], the approach under P₀.
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// The approach δ \[m\] and force P \[N\] with δ + gP = `gap`, where g ≥ 0 \[m/N\] is what the bodies give way; `near` is
    /// an approach to begin at. Newton's method in √δ, to rounding.
    pub(super) fn meet(&self, gap: f64, give_way: f64, near: f64) -> (f64, f64) {
        if gap <= 0.0 {
            return (gap, 0.0);
        }
        // F(q) = q² + gC q³ − gap grows and bends upward: from the second step on q comes down to the root.
        let mut root = match near > 0.0 {
            true => near.sqrt(),
            false => gap.sqrt(),
        };
        let cubic = give_way * self.constant;
        for _ in 0..60 {
            let step = ((cubic * root + 1.0) * root * root - gap) / ((3.0 * cubic * root + 2.0) * root);
            root -= step;
            // What a step of Newton's leaves goes with its square.
            if step.abs() <= 1e-8 * root {
                break;
            }
        }
        let approach = root * root;
        (approach, self.constant * approach * root)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        /// Force and approach fulfil both laws, from any beginning.
        #[test]
        fn meets_the_bodies_that_give_way(
            gap in -5e-5..3e-4f64, give_way in 0.0..1e-9f64, near in -1e-5..1e-3f64,
        ) {
            let spring = HertzSpring::new(5e4, 1.08e9).unwrap();
            let (approach, force) = spring.meet(gap, give_way, near);
            prop_assert!((approach + give_way * force - gap).abs() <= 1e-15 * (1.0 + gap.abs()));
            let law = 5e4 * (approach.max(0.0) / spring.approach()).powf(1.5);
            prop_assert!((force - law).abs() <= 1e-9 * 5e4);
        }
    }

    #[test]
    fn has_the_stiffness_given() {
        let spring = HertzSpring::new(5e4, 1.08e9).unwrap();
        let force = |approach: f64| spring.meet(approach, 0.0, approach).1;
        let step = 1e-4 * spring.approach();
        let slope = (force(spring.approach() + step) - force(spring.approach() - step)) / (2.0 * step);
        // Central differences: truncation 1e-9.
        assert!((slope / 1.08e9 - 1.0).abs() < 1e-8);
        assert!((force(spring.approach()) / 5e4 - 1.0).abs() < 1e-14);
    }
}
