//! What moves the point of contact across two profiles, and what that does to creepage.

use crate::Error;

/// Two circular profiles that touch: the rail head, convex, of the transverse radius R_c, and the wheel, concave, of R_t,
/// or a cone. The closer the radii, the further the contact moves across them when they shift or roll.
///
/// With the lateral displacement s of the wheel against the rail, to the right, and the roll ψ of the wheel against the
/// rail, its right side down, where the cross slope of a ripple counts as roll of the rail:
///
/// ```text
/// 1/R_r = 1/R_c − 1/R_t                  relative radius
/// y_r = R_r (ψ − s/R_t)                  shift of the contact on the rail
/// y_w = R_r (ψ − s/R_c) = y_r − s        on the wheel
/// ξ_x = ± (sin γ/R) y_w                  by the rolling radius there, + on the right rail
/// ```
///
/// s, y_r and y_w lie in the plane of contact; γ is the contact angle: towards the flange, inward, the wheel is larger. Source: A. Bhaskar, K. L. Johnson, G. D. Wood,
/// J. Woodhouse, *Proc. IMechE F* 211 (1997), who find this the main cause of an oscillating longitudinal creepage;
/// derived here. Range of validity: shifts far below the semi-axis b, circles over the width of the patch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Conformity {
    /// 1/R_c \[1/m\].
    rail: f64,
    /// 1/R_t \[1/m\].
    wheel: f64,
}

impl Conformity {
    /// A rail head and a wheel of transverse radii \[m\]; none for a cone.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the radii are positive and that of the wheel is the larger one: as they come together
    /// the profiles touch everywhere, and no point moves.
    pub fn new(rail_radius: f64, wheel_radius: Option<f64>) -> Result<Self, Error> {
        Error::unless_positive("transverse radius of the rail", rail_radius, "m")?;
        if let Some(radius) = wheel_radius {
            Error::unless_positive("transverse radius of the wheel", radius, "m")?;
            if radius <= rail_radius {
                return Err(Error::OutOfRange {
                    quantity: "transverse radius of the wheel",
                    value: radius,
                    unit: "m",
                    rule: "must be greater than that of the rail, or the profiles do not touch at one point",
                });
            }
        }
        Self::of_curvatures(rail_radius.recip(), wheel_radius.map_or(0.0, f64::recip))
    }

    /// A rail head and a wheel of curvatures across the track \[1/m\], positive for a convex head and a hollow wheel; a wheel may be
    /// convex too, for only the difference has to part the profiles.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the rail is curved more than the wheel.
    pub fn of_curvatures(rail: f64, wheel: f64) -> Result<Self, Error> {
        let relative = rail - wheel;
        if !(relative > 0.0 && relative.is_finite()) {
            return Err(Error::OutOfRange {
                quantity: "curvature of the rail less that of the wheel",
                value: relative,
                unit: "1/m",
                rule: "must be positive, or the profiles do not touch at one point",
            });
        }
        Ok(Self { rail, wheel })
    }

    /// Relative transverse radius R_r \[m\], that of the contact ellipse.
    pub fn relative_radius(&self) -> f64 {
        (self.rail - self.wheel).recip()
    }

    /// 1/R_t \[1/m\], positive for a hollow wheel.
    pub fn wheel_curvature(&self) -> f64 {
        self.wheel
    }

    /// Shift of the contact on the rail \[m\], to the right, by a roll \[rad\] and a lateral displacement \[m\].
    pub fn shift_on_rail(&self, roll: f64, lateral: f64) -> f64 {
        self.relative_radius() * (roll - self.wheel * lateral)
    }

    /// Shift of the contact on the wheel \[m\], to the right.
    pub fn shift_on_wheel(&self, roll: f64, lateral: f64) -> f64 {
        self.relative_radius() * (roll - self.rail * lateral)
    }

    /// Longitudinal creepage \[-\] of a wheel of the rolling radius \[m\] under a contact angle γ \[rad\] on the right rail,
    /// by a roll \[rad\] and a lateral displacement \[m\]; on the left rail it has the other sign.
    pub fn longitudinal_creepage(&self, contact_angle: f64, rolling_radius: f64, roll: f64, lateral: f64) -> f64 {
        contact_angle.sin() / rolling_radius * self.shift_on_wheel(roll, lateral)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The place where the gap of two parabolas is smallest.
    #[test]
    fn the_contact_is_where_the_gap_is_smallest() {
        let (rail, wheel, roll, lateral) = (0.3, 0.35, 1e-3, 2e-3);
        let conformity = Conformity::new(rail, Some(wheel)).unwrap();
        let gap = |y: f64| y * y / (2.0 * rail) - (y - lateral).powi(2) / (2.0 * wheel) - roll * y;
        let shift = conformity.shift_on_rail(roll, lateral);
        for off in [-1e-4, 1e-4] {
            assert!(gap(shift + off) > gap(shift));
        }
        // The gap is a parabola: its sides are alike about the smallest one.
        assert!((gap(shift + 1e-3) - gap(shift - 1e-3)).abs() < 1e-15);
        let on_wheel = conformity.shift_on_wheel(roll, lateral);
        assert!((on_wheel - (shift - lateral)).abs() < 1e-15);
    }

    /// Shift per milliradian: 0.3 mm under a cone, 0.75, 2.1 and 4.8 mm under wheels of 0.5, 0.35 and 0.32 m.
    #[test]
    fn close_radii_move_the_contact_far() {
        for (wheel, shift) in [(None, 0.3), (Some(0.5), 0.75), (Some(0.35), 2.1), (Some(0.32), 4.8)] {
            let conformity = Conformity::new(0.3, wheel).unwrap();
            assert!((1e3 * conformity.shift_on_rail(1e-3, 0.0) - shift).abs() < 1e-12);
        }
    }

    /// On a cylinder the radius is the same everywhere, and no conformity makes it creep.
    #[test]
    fn without_a_slope_nothing_creeps() {
        for wheel in [None, Some(0.32)] {
            let conformity = Conformity::new(0.3, wheel).unwrap();
            assert_eq!(conformity.longitudinal_creepage(0.0, 0.46, 1e-3, 1e-3), 0.0);
        }
        // A wheel that moves to the right touches further in, where its radius is larger: it drives.
        let cone = Conformity::new(0.3, None).unwrap();
        let creepage = cone.longitudinal_creepage(0.025, 0.46, 0.0, 1e-3);
        assert!((creepage + 0.025f64.sin() / 0.46 * 1e-3).abs() < 1e-15);
    }

    #[test]
    fn profiles_that_touch_everywhere_are_refused() {
        for wheel in [0.3, 0.29, 0.0, -0.5, f64::NAN] {
            assert!(Conformity::new(0.3, Some(wheel)).is_err(), "{wheel}");
        }
        assert!(Conformity::new(0.0, None).is_err());
        assert!(Conformity::of_curvatures(3.0, 3.0).is_err());
        // A convex wheel parts faster: the contact moves less than under a cone.
        let convex = Conformity::of_curvatures(1.0 / 0.3, -2.0).unwrap();
        assert!(convex.shift_on_rail(1e-3, 0.0) < 0.3e-3);
        assert!(Conformity::new(0.3, Some(0.300_001)).is_ok());
    }
}
