//! Closed forms of linear steering theory.

/// Lateral shift \[m\] of a free wheelset that rolls without creepage through a curve: y = −r₀ s/(λ R), its axle radial.
///
/// `rolling_radius` r₀ \[m\], `contact_spacing` 2s \[m\], `conicity` λ \[-\], `radius` R \[m\] of the curve, above zero to
/// the right. Source: Redtenbacher (1855); Wickens (2003), *Fundamentals of Rail Vehicle Dynamics*, chapter 1.
pub fn free_curving_shift(rolling_radius: f64, contact_spacing: f64, conicity: f64, radius: f64) -> f64 {
    -rolling_radius * 0.5 * contact_spacing / (conicity * radius)
}

/// A single conical wheelset held in a frame at rest by springs, after linear steering theory.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearWheelset {
    /// Rolling radius r₀ \[m\].
    pub rolling_radius: f64,
    /// Spacing of the contacts 2s \[m\].
    pub contact_spacing: f64,
    /// Conicity λ \[-\].
    pub conicity: f64,
    /// Radius of the curve R \[m\], above zero to the right.
    pub radius: f64,
    /// Longitudinal creep coefficient f₁₁ of a contact \[N\].
    pub longitudinal_creep_coefficient: f64,
    /// Lateral creep coefficient f₂₂ \[N\].
    pub lateral_creep_coefficient: f64,
    /// Coefficient f₂₃ of the lateral force of spin \[N m\].
    pub spin_creep_coefficient: f64,
    /// Stiffness that holds the wheelset laterally \[N/m\].
    pub lateral_stiffness: f64,
    /// Stiffness that holds it in yaw \[N m/rad\].
    pub yaw_stiffness: f64,
    /// Lateral force on the wheelset \[N\].
    pub lateral_force: f64,
    /// Yaw of the frame \[rad\].
    pub frame_yaw: f64,
}

/// The equilibrium of a [`LinearWheelset`].
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct LinearWheelsetState {
    /// Lateral shift y \[m\].
    pub lateral_shift: f64,
    /// Yaw ψ \[rad\].
    pub yaw: f64,
    /// Longitudinal creepage of the right wheel \[-\]; the left one has the opposite.
    pub longitudinal_creepage_right: f64,
    /// Lateral creepage of both wheels \[-\].
    pub lateral_creepage: f64,
    /// Longitudinal force on the right rail \[N\].
    pub longitudinal_force_right: f64,
    /// Lateral force on both rails \[N\].
    pub lateral_force_sum: f64,
}

impl LinearWheelset {
    /// The equilibrium: −ΣQ_y − K_y y + F = 0 and 2s Q_x − K_ψ(ψ − ψ_b) = 0 with Q_x = −f₁₁(s/R + λy/r₀) on the right and
    /// ΣQ_y = −2f₂₂ψ + 2f₂₃/R, in which the spin of the cones cancels.
    pub fn equilibrium(&self) -> LinearWheelsetState {
        let s = 0.5 * self.contact_spacing;
        let [f11, f22] = [self.longitudinal_creep_coefficient, self.lateral_creep_coefficient];
        let spin_force = 2.0 * self.spin_creep_coefficient / self.radius;
        // Yaw: ψ = c − d y; lateral: 2 f₂₂ ψ − K_y y = spin force − F.
        let turning = 2.0 * s * f11 / self.yaw_stiffness;
        let (c, d) = (self.frame_yaw - turning * s / self.radius, turning * self.conicity / self.rolling_radius);
        let lateral_shift =
            (self.lateral_force - spin_force + 2.0 * f22 * c) / (self.lateral_stiffness + 2.0 * f22 * d);
        let yaw = c - d * lateral_shift;
        let creepage = -(s / self.radius + self.conicity * lateral_shift / self.rolling_radius);
        LinearWheelsetState {
            lateral_shift,
            yaw,
            longitudinal_creepage_right: creepage,
            lateral_creepage: -yaw,
            longitudinal_force_right: f11 * creepage,
            lateral_force_sum: spin_force - 2.0 * f22 * yaw,
        }
    }
}
