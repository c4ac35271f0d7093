//! The normal contact of two elastic bodies with any gap between them.

mod boussinesq;
mod conjugate_gradients;
mod convolution;
mod grid;

pub use grid::ContactGrid;

use std::f64::consts::FRAC_PI_2;

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
/// the mean square (test `error_falls_with_the_grid`); a wave wants ten elements. Cost: a convolution a
/// step, two where it cuts off pressures, 30 to 60 steps for 64 × 64 elements, some 10 ms, and half as many again for each
/// doubling of n; twice as many steps where elements are ten times as long as wide.
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
    load: f64,
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
        Self::curved(materials, grid, gap, |_| 0.0)
    }

    /// Two bodies on a surface that is curved across: y is its arc length, `inclination` that of a row of elements \[rad\], of
    /// which there are [`ContactGrid::rows`], and the gap is measured along the normal of its row. Load and approach are along
    /// the normal of inclination zero.
    ///
    /// Displacements are those of half-spaces, each along the normal of its pressure, seen along the normal of its place.
    /// Source: J. Blanco-Lorenzo, J. Santamaria, E. G. Vadillo, N. Correa, *Tribology International* 103 (2016), 647–667. Range of
    /// validity: two bodies of one material. In two dimensions, where a disc in a hole is solved exactly (Persson 1964), this
    /// leaves out that both change their radii under their mean pressure, N/2πE\* for N per length: the share b²/8R² of the
    /// difference of the radii, 2 % for half a width over the radius b/R of 0.4 (test `a_disc_in_a_hole`).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the gap is not finite at the centre of an element, or an inclination is not below 90°.
    pub fn curved(
        materials: [ElasticMaterial; 2],
        grid: ContactGrid,
        gap: impl Fn(f64, f64) -> f64,
        inclination: impl Fn(usize) -> f64,
    ) -> Result<Self, Error> {
        for row in 0..grid.rows() {
            let value = inclination(row);
            if !(-FRAC_PI_2..FRAC_PI_2).contains(&value) {
                return Err(Error::OutOfRange {
                    quantity: "inclination of the surface in the contact",
                    value,
                    unit: "rad",
                    rule: "must be below 90°, either way",
                });
            }
        }
        Ok(Self {
            gaps: sample(&grid, gap)?,
            influence: Boussinesq::new(contact_modulus(materials), &grid, inclination),
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
        self.under_load_near(load, None)
    }

    /// Contact under a normal load, begun with pressures where the undeformed bodies overlap at an approach \[m\]: that of a patch as large as
    /// the one expected, about half the approach under load, saves a third of the steps.
    ///
    /// # Errors
    /// Errors of those of [`under_load`](Self::under_load).
    pub fn under_load_near(&self, load: f64, approach: Option<f64>) -> Result<NormalState, Error> {
        Error::unless_positive("normal load", load, "N")?;
        let sum = Condition::PressureSum(load / self.grid.element_area());
        self.solve(sum, approach, MOST_STEPS)
    }

    /// The contact at an approach δ \[m\]. Where that leaves a gap everywhere, there is no pressure.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if the approach is not finite, [`Error::GridTooSmall`] if the patch reaches
    /// the rim of the grid, [`Error::NotConverged`].
    pub fn at_approach(&self, approach: f64) -> Result<NormalState, Error> {
        if !approach.is_finite() {
            return Err(Error::OutOfRange { quantity: "approach", value: approach, unit: "m", rule: "must be finite" });
        }
        self.solve(Condition::Approach(approach), None, MOST_STEPS)
    }

    fn solve(&self, condition: Condition, near: Option<f64>, most_steps: usize) -> Result<NormalState, Error> {
        let Solution { pressures, gaps, approach, steps } =
            conjugate_gradients::solve(&self.influence, &self.gaps, condition, near, most_steps).map_err(
                |residual| Error::NotConverged {
                    problem: "normal contact",
                    residual,
                    tolerance: TOLERANCE,
                    remedy: "try elements that are nearer to squares, or fewer of them",
                },
            )?;
        let touches_rim = |(index, &pressure): (usize, &f64)| pressure > 0.0 && self.grid.is_on_rim(index);
        if pressures.iter().enumerate().any(touches_rim) {
            return Err(Error::GridTooSmall {
                length: self.grid.columns() as f64 * self.grid.dx(),
                width: self.grid.rows() as f64 * self.grid.dy(),
            });
        }
        let along = pressures.iter().zip(self.influence.cosines());
        let sum: f64 = along.map(|(pressure, cosine)| pressure * cosine).sum();
        Ok(NormalState { grid: self.grid, load: sum * self.grid.element_area(), pressures, gaps, approach, steps })
    }
}

/// The gap at the centres.
fn sample(grid: &ContactGrid, gap: impl Fn(f64, f64) -> f64) -> Result<Vec<f64>, Error> {
    let gaps: Vec<f64> = grid.centres().map(|(x, y)| gap(x, y)).collect();
    match gaps.iter().find(|gap| !gap.is_finite()) {
        None => Ok(gaps),
        Some(&value) => {
            Err(Error::OutOfRange { quantity: "gap", value, unit: "m", rule: "must be finite on the whole grid" })
        }
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
        self.load
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

#[cfg(test)]
mod tests;
