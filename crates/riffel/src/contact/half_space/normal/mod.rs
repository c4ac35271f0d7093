//! The normal contact of two elastic bodies with any gap between them.

mod boussinesq;
mod conjugate_gradients;
mod convolution;
mod grid;
#[cfg(test)]
mod tests;

pub use grid::ContactGrid;

use self::boussinesq::Boussinesq;
use self::conjugate_gradients::{Condition, MOST_STEPS, Solution, TOLERANCE};
use crate::contact::ellipse::contact_modulus;
use crate::{ElasticMaterial, Error};

/// Two elastic bodies with a gap z(x, y) between their undeformed surfaces: quadratic, wavy or rough.
///
/// Pressures are constant on each element of a grid; their displacements are those of half-spaces. At
/// every element's centre the deformed surfaces are g = z + u − δ ≥ 0 apart, the pressure is p ≥ 0, and
/// one of the two is zero. Positive z separates the bodies; the approach δ of their distant points is
/// counted from the position in which the gap is z.
///
/// Method: conjugate gradients on the elements under pressure (Polonsky & Keer 1999), displacements by
/// Boussinesq's solution integrated over a rectangle (Love 1929) as a convolution. Tolerance: no overlap,
/// and no gap under pressure, above 1e-9 of the largest displacement. Error of the discretisation, Hertz
/// contact with n elements over 2.5 semi-axes: approach below 0.4/n², semi-axes 1.8/n², pressures 0.6/n in
/// the mean square (test `error_falls_with_the_grid`); a wave wants ten elements. Cost: two convolutions a
/// step, 30 to 60 steps for 64 × 64 elements, some 15 ms, and half as many again for each doubling of n; twice as
/// many steps where elements are ten times as long as wide.
///
/// Source: K. L. Johnson (1985), *Contact Mechanics*, chapters 3 and 5, for the theory; I. A. Polonsky and
/// L. M. Keer, *Wear* 231 (1999), 206–219, for the iteration. Range of validity: small slopes, bodies much
/// larger than the patch, elastic, no friction between unlike materials. Pressure does not tilt the
/// bodies: the resultant need not pass through the origin.
///
/// ```
/// use riffel::{ElasticMaterial, HertzContact, contact::{ContactGrid, NormalContact}};
///
/// # fn main() -> Result<(), riffel::Error> {
/// let steel = ElasticMaterial::new(207e9, 0.3)?;
/// let grid = ContactGrid::over(64, 64, 8e-3, 6e-3)?;
/// // A wheel of 0.46 m on a rail of 0.23 m across, with a groove of 20 µm along the rail.
/// let groove = |y: f64| if y.abs() < 0.5e-3 { 20e-6 } else { 0.0 };
/// let gap = |x: f64, y: f64| x * x / 0.92 + y * y / 0.46 + groove(y);
/// let state = NormalContact::new([steel; 2], grid, gap)?.under_load(50e3)?;
/// let smooth = HertzContact::exact(steel, 0.46, 0.23, 50e3)?;
/// assert!(state.peak_pressure() > 1.5 * smooth.peak_pressure());
/// assert!(state.approach() > smooth.approach());
/// # Ok(())
/// # }
/// ```
pub struct NormalContact {
    grid: ContactGrid,
    influence: Boussinesq,
    gaps: Vec<f64>,
}

/// A solved [`NormalContact`].
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct NormalState {
    grid: ContactGrid,
    pressures: Vec<f64>,
    gaps: Vec<f64>,
    approach: f64,
    steps: usize,
}

impl NormalContact {
    /// Two bodies of the given materials on a grid. `gap` is z \[m\] at a place (x, y) \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the gap is not finite at the centre of an element.
    pub fn new(
        materials: [ElasticMaterial; 2],
        grid: ContactGrid,
        gap: impl Fn(f64, f64) -> f64,
    ) -> Result<Self, Error> {
        Ok(Self {
            gaps: sample(&grid, gap)?,
            influence: Boussinesq::new(contact_modulus(materials), &grid),
            grid,
        })
    }

    /// Put another gap \[m\] in the place of this one; the influence of the pressures stays.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if it is not finite at the centre of an element; the old one is then kept.
    pub fn set_gap(&mut self, gap: impl Fn(f64, f64) -> f64) -> Result<(), Error> {
        self.gaps = sample(&self.grid, gap)?;
        Ok(())
    }

    /// The grid.
    pub fn grid(&self) -> &ContactGrid {
        &self.grid
    }

    /// The contact under a normal load P \[N\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the load is not positive, [`Error::GridTooSmall`] if the patch reaches
    /// the rim of the grid, [`Error::NotConverged`].
    pub fn under_load(&self, load: f64) -> Result<NormalState, Error> {
        Error::unless_positive("normal load", load, "N")?;
        self.solve(
            Condition::PressureSum(load / self.grid.element_area()),
            MOST_STEPS,
        )
    }

    /// The contact at an approach δ \[m\]. Where that leaves a gap everywhere, there is no pressure.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the approach is not finite, [`Error::GridTooSmall`] if the patch reaches
    /// the rim of the grid, [`Error::NotConverged`].
    pub fn at_approach(&self, approach: f64) -> Result<NormalState, Error> {
        if !approach.is_finite() {
            return Err(Error::OutOfRange {
                quantity: "approach",
                value: approach,
                unit: "m",
                rule: "must be finite",
            });
        }
        self.solve(Condition::Approach(approach), MOST_STEPS)
    }

    fn solve(&self, condition: Condition, most_steps: usize) -> Result<NormalState, Error> {
        let Solution {
            pressures,
            gaps,
            approach,
            steps,
        } = conjugate_gradients::solve(&self.influence, &self.gaps, condition, most_steps)
            .map_err(|residual| Error::NotConverged {
                problem: "normal contact",
                residual,
                tolerance: TOLERANCE,
                remedy: "try elements that are nearer to squares, or fewer of them",
            })?;
        let touches_rim =
            |(index, &pressure): (usize, &f64)| pressure > 0.0 && self.grid.is_on_rim(index);
        if pressures.iter().enumerate().any(touches_rim) {
            return Err(Error::GridTooSmall {
                length: self.grid.columns() as f64 * self.grid.dx(),
                width: self.grid.rows() as f64 * self.grid.dy(),
            });
        }
        Ok(NormalState {
            grid: self.grid,
            pressures,
            gaps,
            approach,
            steps,
        })
    }
}

/// The gap at the centres.
fn sample(grid: &ContactGrid, gap: impl Fn(f64, f64) -> f64) -> Result<Vec<f64>, Error> {
    let gaps: Vec<f64> = grid.centres().map(|(x, y)| gap(x, y)).collect();
    match gaps.iter().find(|gap| !gap.is_finite()) {
        None => Ok(gaps),
        Some(&value) => Err(Error::OutOfRange {
            quantity: "gap",
            value,
            unit: "m",
            rule: "must be finite on the whole grid",
        }),
    }
}

impl NormalState {
    /// The grid.
    pub fn grid(&self) -> &ContactGrid {
        &self.grid
    }

    /// Pressures p ≥ 0 of the elements \[Pa\], as [`ContactGrid`] orders them.
    pub fn pressures(&self) -> &[f64] {
        &self.pressures
    }

    /// Distances g of the deformed surfaces at the centres of the elements \[m\]; zero to the
    /// tolerance under pressure.
    pub fn gaps(&self) -> &[f64] {
        &self.gaps
    }

    /// Normal load P \[N\].
    pub fn load(&self) -> f64 {
        self.pressures.iter().sum::<f64>() * self.grid.element_area()
    }

    /// Approach δ \[m\].
    pub fn approach(&self) -> f64 {
        self.approach
    }

    /// Largest pressure of an element \[Pa\].
    pub fn peak_pressure(&self) -> f64 {
        self.pressures.iter().copied().fold(0.0, f64::max)
    }

    /// Area of the elements under pressure \[m²\]. Its error is the staircase of the edge: of the order
    /// of one element's width over the patch's.
    pub fn contact_area(&self) -> f64 {
        let elements = self.pressures.iter().filter(|pressure| **pressure > 0.0);
        elements.count() as f64 * self.grid.element_area()
    }

    /// Steps of the iteration.
    pub fn steps(&self) -> usize {
        self.steps
    }
}
