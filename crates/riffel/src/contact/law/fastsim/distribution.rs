//! Tractions, slip and dissipation over the patch.

use super::grid::Grid;
use super::{CreepForces, Creepages, Flexibility};

/// One cell of the contact patch.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct ContactCell {
    /// Middle of the cell along the rail, from the centre of the patch \[m\]; the leading edge is at
    /// positive x.
    pub x: f64,
    /// Middle of the cell across the rail \[m\].
    pub y: f64,
    /// Area \[m²\].
    pub area: f64,
    /// Longitudinal traction p_x \[Pa\].
    pub traction_longitudinal: f64,
    /// Lateral traction p_y \[Pa\].
    pub traction_lateral: f64,
    /// Longitudinal slip per metre rolled, ξ − φy L₁/L₃ + L₁ ∂p_x/∂x \[-\].
    pub slip_longitudinal: f64,
    /// Lateral slip per metre rolled, η + φx L₂/L₃ + L₂ ∂p_y/∂x \[-\].
    pub slip_lateral: f64,
    /// Whether the traction in the middle of the cell is below the bound. The slip is a central
    /// difference, so the last cell of stick may carry some.
    pub sticks: bool,
}

impl ContactCell {
    /// Energy dissipated per metre rolled and per area of contact \[J/m³ = Pa\]; times the speed V it is
    /// the power per area \[W/m²\].
    pub fn energy_density(&self) -> f64 {
        self.traction_longitudinal * self.slip_longitudinal + self.traction_lateral * self.slip_lateral
    }
}

/// Tractions over the patch, strip by strip from negative to positive y, each from its leading edge.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct TractionDistribution {
    /// The cells.
    pub cells: Vec<ContactCell>,
}

impl TractionDistribution {
    pub(super) fn new(patch: &Flexibility, grid: &Grid, creepages: Creepages) -> Self {
        let loading = patch.loading(creepages);
        let strips = grid.strips();
        let n = strips.len() as f64;
        let mut cells = Vec::with_capacity(strips.len() * strips.len());
        for strip in strips {
            let length = 2.0 * patch.a * strip.half_length / n;
            let area = length * 2.0 * patch.b / n;
            let y = patch.b * strip.y;
            let peak = patch.traction * strip.height;
            let marched: Vec<_> = grid.march(strip, loading).collect();
            // Traction half-way between two cells; at both edges there is none.
            let between = |i: usize, axis: usize| match i {
                0 => 0.0,
                i => match marched.get(i) {
                    Some((here, _)) => 0.5 * peak * (marched[i - 1].0[axis] + here[axis]),
                    None => 0.0,
                },
            };
            for (i, &(traction, sticks)) in marched.iter().enumerate() {
                let x = patch.a * strip.half_length * (1.0 - (2.0 * i as f64 + 1.0) / n);
                let fall = |axis: usize| (between(i + 1, axis) - between(i, axis)) / length;
                let rigid_longitudinal = creepages.longitudinal / patch.longitudinal - creepages.spin * y / patch.spin;
                let rigid_lateral = creepages.lateral / patch.lateral + creepages.spin * x / patch.spin;
                cells.push(ContactCell {
                    x,
                    y,
                    area,
                    traction_longitudinal: peak * traction[0],
                    traction_lateral: peak * traction[1],
                    slip_longitudinal: patch.longitudinal * (rigid_longitudinal - fall(0)),
                    slip_lateral: patch.lateral * (rigid_lateral - fall(1)),
                    sticks,
                });
            }
        }
        Self { cells }
    }

    /// Creep forces \[N\].
    pub fn forces(&self) -> CreepForces {
        self.cells.iter().fold(CreepForces::default(), |sum, cell| CreepForces {
            longitudinal: sum.longitudinal + cell.area * cell.traction_longitudinal,
            lateral: sum.lateral + cell.area * cell.traction_lateral,
        })
    }

    /// Energy dissipated per metre rolled \[J/m\]; times the speed V it is the power \[W\].
    ///
    /// Without spin it is ξF_x + ηF_y but for the grid, which leaves an error of order μPξ_max/n².
    pub fn energy_per_metre(&self) -> f64 {
        self.cells.iter().map(|cell| cell.area * cell.energy_density()).sum()
    }
}
