//! A wheelset with its suspension and what it carries.

use riffel::Error;

/// What the wheelsets of a vehicle have in common: their wheels, the springs of their axle boxes and what they carry.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Axle {
    /// Distance of the axle boxes of a wheelset 2b \[m\].
    pub primary_spacing: f64,
    /// Stiffness of the suspension along the track k_x \[N/m\], per axle box.
    pub primary_longitudinal_stiffness: f64,
    /// Stiffness of the suspension across the track k_y \[N/m\], per axle box.
    pub primary_lateral_stiffness: f64,
    /// Everything that an axle carries m_a \[kg\], the wheelset and its share of frame and body included.
    pub mass_per_axle: f64,
    /// Mass of a wheelset m_w \[kg\].
    pub wheelset_mass: f64,
    /// Radii r₀ of the left and the right wheel at the centred wheelset \[m\].
    pub rolling_radii: [f64; 2],
    /// Distance of the contacts of a wheelset 2s \[m\].
    pub contact_spacing: f64,
    /// Height of the centre of mass of what an axle carries above the rails h \[m\].
    pub centre_of_mass_height: f64,
}

impl Axle {
    /// Stiffness of the primary suspension of a wheelset across the track 2k_y \[N/m\].
    pub(super) fn lateral_stiffness(&self) -> f64 {
        2.0 * self.primary_lateral_stiffness
    }

    /// That against yaw 2b²k_x \[N m/rad\].
    pub(super) fn yaw_stiffness(&self) -> f64 {
        0.5 * self.primary_spacing * self.primary_spacing * self.primary_longitudinal_stiffness
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        Error::unless_positive("spacing of the axle boxes", self.primary_spacing, "m")?;
        Error::unless_positive(
            "longitudinal stiffness of the primary suspension",
            self.primary_longitudinal_stiffness,
            "N/m",
        )?;
        Error::unless_positive("lateral stiffness of the primary suspension", self.primary_lateral_stiffness, "N/m")?;
        Error::unless_positive("mass per axle", self.mass_per_axle, "kg")?;
        Error::unless_not_negative("mass of the wheelset", self.wheelset_mass, "kg")?;
        for radius in self.rolling_radii {
            Error::unless_positive("rolling radius", radius, "m")?;
        }
        Error::unless_positive("spacing of the contacts", self.contact_spacing, "m")?;
        Error::unless_not_negative("height of the centre of mass", self.centre_of_mass_height, "m")?;
        if self.wheelset_mass > self.mass_per_axle {
            return Err(Error::OutOfRange {
                quantity: "mass of the wheelset",
                value: self.wheelset_mass,
                unit: "kg",
                rule: "must be at most the mass per axle, which includes it",
            });
        }
        Ok(())
    }
}
