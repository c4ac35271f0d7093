//! From the axle to the contacts.

use num_complex::Complex64;

use super::ContactReceptances;
use crate::Error;

/// Where a wheelset touches the rails: at (0, ±s, R) from the middle of its axle, y to the right and z down.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ContactGeometry {
    /// Distance of the two contacts across the track, 2s \[m\].
    pub contact_spacing: f64,
    /// Rolling radius R \[m\].
    pub rolling_radius: f64,
}

impl ContactGeometry {
    /// Itself, if both lengths are positive.
    pub(super) fn checked(self) -> Result<Self, Error> {
        Error::unless_positive("contact spacing", self.contact_spacing, "m")?;
        Error::unless_positive("rolling radius", self.rolling_radius, "m")?;
        Ok(self)
    }

    /// Distance of the contacts from the middle of the track, left and right \[m\].
    pub(super) fn places(&self) -> [f64; 2] {
        [-0.5 * self.contact_spacing, 0.5 * self.contact_spacing]
    }
}

/// A receptance between the axle's sections over the two contacts, `[at][from]`, left and right.
pub(super) type Between = [[Complex64; 2]; 2];

/// Receptances of an axle that is symmetric about its line, at its sections over the contacts.
///
/// u and θ are displacements and rotations of the section: u_x, u_z and θ_x by bending, θ_y by torsion, u_y by stretch.
#[derive(Debug, Clone, Copy)]
pub(super) struct SectionReceptances {
    /// u_x by a force along x \[m/N\].
    pub(super) forward: Between,
    /// u_z by a force along z \[m/N\].
    pub(super) downward: Between,
    /// u_z by a moment about x \[1/N\].
    pub(super) downward_by_tilt: Between,
    /// θ_x by a moment about x \[rad/(N m)\].
    pub(super) tilt: Between,
    /// θ_y by a moment about y \[rad/(N m)\].
    pub(super) twist: Between,
    /// u_y by a force along y \[m/N\].
    pub(super) sideward: Between,
}

impl SectionReceptances {
    /// Receptances at the contacts, a rigid radius R \[m\] below the sections: u_c = u + θ × (0, 0, R) and the moments
    /// (−RF_y, RF_x, 0).
    pub(super) fn at_contacts(&self, radius: f64) -> ContactReceptances {
        let mut receptances = [[Complex64::ZERO; 6]; 6];
        for at in 0..2 {
            for from in 0..2 {
                let (row, column) = (3 * at, 3 * from);
                receptances[row][column] = self.forward[at][from] + radius * radius * self.twist[at][from];
                receptances[row + 1][column + 1] = self.sideward[at][from] + radius * radius * self.tilt[at][from];
                receptances[row + 2][column + 2] = self.downward[at][from];
                receptances[row + 2][column + 1] = -radius * self.downward_by_tilt[at][from];
                receptances[row + 1][column + 2] = -radius * self.downward_by_tilt[from][at];
            }
        }
        receptances
    }
}
