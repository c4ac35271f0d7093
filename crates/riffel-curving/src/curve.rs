//! A circular curve with cant, run through at one speed.

use riffel::Error;

/// Acceleration of gravity \[m/s²\] of the loads, rounded as in the equilibria that these are checked against; vehicles and units
/// elsewhere take the standard 9.80665.
pub const GRAVITY: f64 = 9.81;

/// A circular curve with cant, run through at one speed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Curve {
    /// Radius R \[m\], above zero to the right, below to the left.
    pub radius: f64,
    /// Height of the outer rail above the inner one \[m\], over the spacing of the contacts.
    pub cant: f64,
    /// Speed V \[m/s\].
    pub speed: f64,
}

impl Curve {
    /// +1 to the right, −1 to the left.
    pub fn side(&self) -> f64 {
        self.radius.signum()
    }

    /// Lateral acceleration in the plane of the track that the cant leaves \[m/s²\], positive outward:
    /// V²/|R| cos θ − g sin θ, with sin θ the cant over the spacing 2s \[m\] of the contacts.
    pub fn uncompensated_acceleration(&self, contact_spacing: f64) -> f64 {
        let (sine, cosine) = self.cant_angle(contact_spacing);
        self.centripetal() * cosine - GRAVITY * sine
    }

    /// Acceleration into the plane of the track \[m/s²\]: g cos θ + V²/|R| sin θ.
    pub fn normal_acceleration(&self, contact_spacing: f64) -> f64 {
        let (sine, cosine) = self.cant_angle(contact_spacing);
        GRAVITY * cosine + self.centripetal() * sine
    }

    fn centripetal(&self) -> f64 {
        self.speed * self.speed / self.radius.abs()
    }

    fn cant_angle(&self, contact_spacing: f64) -> (f64, f64) {
        let sine = self.cant / contact_spacing;
        (sine, ((1.0 - sine) * (1.0 + sine)).sqrt())
    }

    pub(super) fn check(&self, contact_spacing: f64) -> Result<(), Error> {
        Error::unless_positive("curve radius", self.radius.abs(), "m")?;
        Error::unless_not_negative("cant", self.cant, "m")?;
        Error::unless_positive("speed", self.speed, "m/s")?;
        if self.cant >= contact_spacing {
            return Err(Error::OutOfRange {
                quantity: "cant",
                value: self.cant,
                unit: "m",
                rule: "must be less than the spacing of the contacts",
            });
        }
        Ok(())
    }
}
