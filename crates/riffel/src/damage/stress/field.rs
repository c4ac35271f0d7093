//! Stress under all points of a grid.

use rayon::prelude::*;

use super::{EllipseStress, UnitStress};
use crate::cancel::check;

/// Stresses under the points of a grid, of which mirror images are evaluated once.
pub(super) struct Field {
    /// |x/a| and |y/b|, rising, each once.
    sizes: [Vec<f64>; 2],
    /// Plane by plane, row by row.
    quarter: Vec<UnitStress>,
}

impl Field {
    /// At x/a, y/b and z/a, to 1e-3 of p₀.
    pub(super) fn new(ellipse: &EllipseStress, [x, y, z]: [&[f64]; 3]) -> Self {
        let sizes = [x, y].map(|axis| {
            let mut sizes: Vec<f64> = axis.iter().map(|place| place.abs()).collect();
            sizes.sort_by(f64::total_cmp);
            sizes.dedup();
            sizes
        });
        let [along, across] = &sizes;
        let mut quarter = vec![UnitStress::default(); along.len() * across.len() * z.len()];
        let rows = quarter.par_chunks_mut(along.len()).enumerate();
        rows.for_each(|(index, row)| {
            check();
            let (y, z) = (across[index % across.len()], z[index / across.len()]);
            for (unit, &x) in row.iter_mut().zip(along) {
                *unit = ellipse.nearly_at([x, y, z]);
            }
        });
        Self { quarter, sizes }
    }

    /// In a plane, by its place among the depths, at one of the places x/a and y/b.
    pub(super) fn at(&self, [x, y]: [f64; 2], plane: usize) -> UnitStress {
        let [along, across] = &self.sizes;
        let column = along.partition_point(|size| *size < x.abs());
        let row = across.partition_point(|size| *size < y.abs());
        let mut unit = self.quarter[(plane * across.len() + row) * along.len() + column];
        // Stresses xy and zx turn over with x, xy and yz with y; all with a traction that does.
        let flip = |stress: &mut [f64; 6], sign: f64, shears: [usize; 2]| {
            stress.iter_mut().for_each(|part| *part *= sign);
            shears.into_iter().for_each(|part| stress[part] = -stress[part]);
        };
        if x < 0.0 {
            flip(&mut unit.normal, 1.0, [3, 5]);
            flip(&mut unit.along, -1.0, [3, 5]);
            flip(&mut unit.across, 1.0, [3, 5]);
        }
        if y < 0.0 {
            flip(&mut unit.normal, 1.0, [3, 4]);
            flip(&mut unit.along, 1.0, [3, 4]);
            flip(&mut unit.across, -1.0, [3, 4]);
        }
        unit
    }
}
