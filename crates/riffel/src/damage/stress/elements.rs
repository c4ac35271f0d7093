//! Stress in a half-space under shear that is constant on equal rectangles of its surface.

use std::collections::BTreeMap;
use std::f64::consts::TAU;

use super::StressTensor;
use crate::cancel::check;

/// Stress under the elements of a patch, lengths in the semi-axis a.
///
/// Method: the potentials of [`EllipseStress`](super::EllipseStress) for a rectangle are closed (Love 1929): with r the distance from a
/// corner, the differences over the corners of V_x = ln(y + r), V_xx = x/r(y + r), V_z = −atan(xy/zr),
/// φ_xxy = x/r(r + z), F_xxx = y/(r + z) − ln(y + r), F_xxy = −x/(r + z). Elements are put together to cells, some 30 over a diameter, and their
/// stresses summed below the centres of cells, where no edge of one is near, and read in between on straight lines. Error against a smooth
/// traction: 1 % of its largest value below a tenth of a, 3 % above.
#[derive(Debug, Clone, PartialEq)]
pub struct ElementStress {
    /// Of the points along and across: the first, the step, the count.
    axes: [(f64, f64, usize); 2],
    /// Plane by plane, row by row.
    stresses: Vec<StressTensor>,
}

/// Depths of the planes.
const DEPTHS: [f64; 16] = [0.0, 0.03, 0.06, 0.1, 0.15, 0.2, 0.25, 0.3, 0.4, 0.5, 0.6, 0.75, 0.9, 1.2, 1.6, 2.0];
/// How far the points reach along and across, in semi-axes.
const REACH: [f64; 2] = [2.0, 1.5];
/// Cells over a semi-axis.
const POINTS: f64 = 15.0;

impl ElementStress {
    /// Of the tractions along and across at the centres of elements of one size.
    pub fn new(elements: &[([f64; 2], [f64; 2])], size: [f64; 2], poisson_ratio: f64) -> Self {
        use rayon::prelude::*;
        let first = elements.first().map_or([0.0; 2], |(place, _)| *place);
        let half = [0, 1].map(|axis| {
            let places = elements.iter().map(|(place, _)| place[axis].abs());
            places.fold(size[axis], f64::max)
        });
        // Cells of several elements.
        let steps = [0, 1].map(|axis| (half[axis] / (POINTS * size[axis])).round().max(1.0));
        let mut cells: BTreeMap<[isize; 2], [f64; 2]> = BTreeMap::new();
        for (place, traction) in elements {
            let cell = [0, 1].map(|axis| {
                let number = ((place[axis] - first[axis]) / size[axis]).round();
                (number / steps[axis]).floor() as isize
            });
            let sum = cells.entry(cell).or_default();
            for (sum, part) in sum.iter_mut().zip(traction) {
                *sum += part / (steps[0] * steps[1]);
            }
        }
        let cells: Vec<([isize; 2], [f64; 2])> = cells.into_iter().collect();
        let first = [0, 1].map(|axis| first[axis] + 0.5 * (steps[axis] - 1.0) * size[axis]);
        let size = [0, 1].map(|axis| steps[axis] * size[axis]);
        // Points below the cells, and as many beside them.
        let number = |axis: usize, place: f64| (place - first[axis]) / size[axis];
        let begin = [0, 1].map(|axis| number(axis, -REACH[axis] * half[axis]).floor() as isize);
        let end = [0, 1].map(|axis| number(axis, REACH[axis] * half[axis]).ceil() as isize);
        let axes = [0, 1].map(|axis| {
            let from = first[axis] + begin[axis] as f64 * size[axis];
            (from, size[axis], (end[axis] - begin[axis] + 1) as usize)
        });
        let [low, high] = [isize::min, isize::max].map(|of| {
            [0, 1].map(|axis| {
                let numbers = cells.iter().map(|(number, _)| number[axis]);
                numbers.reduce(of).unwrap_or(0)
            })
        });
        // Distances of a point from a cell, in cells.
        let nearest = [0, 1].map(|axis| begin[axis] - high[axis]);
        let counts = [0, 1].map(|axis| (end[axis] - low[axis] - nearest[axis] + 1) as usize);
        let plane = |depth: f64| -> Vec<StressTensor> {
            let corners: Vec<[f64; 12]> = (0..=counts[1])
                .flat_map(|row| (0..=counts[0]).map(move |column| [column, row]))
                .map(|corner| {
                    let [x, y] = [0, 1].map(|axis| {
                        let number = nearest[axis] as f64 + corner[axis] as f64 - 0.5;
                        number * size[axis]
                    });
                    corner_stress([x, y, depth], poisson_ratio)
                })
                .collect();
            let corner = |column: usize, row: usize| &corners[row * (counts[0] + 1) + column];
            let by_distance: Vec<[f64; 12]> = (0..counts[1])
                .flat_map(|row| (0..counts[0]).map(move |column| [column, row]))
                .map(|[column, row]| {
                    let [a, b] = [corner(column + 1, row + 1), corner(column, row)];
                    let [c, d] = [corner(column, row + 1), corner(column + 1, row)];
                    std::array::from_fn(|i| (a[i] + b[i] - c[i] - d[i]) / TAU)
                })
                .collect();
            let points = (0..axes[1].2).flat_map(|row| (0..axes[0].2).map(move |column| [column, row]));
            points
                .map(|point| {
                    check();
                    let at = [0, 1].map(|axis| begin[axis] + point[axis] as isize - nearest[axis]);
                    let mut sum = [0.0; 6];
                    for (number, [along, across]) in &cells {
                        let [column, row] = [0, 1].map(|axis| (at[axis] - number[axis]) as usize);
                        let stress = &by_distance[row * counts[0] + column];
                        for (i, sum) in sum.iter_mut().enumerate() {
                            *sum += along * stress[i] + across * stress[i + 6];
                        }
                    }
                    sum
                })
                .collect()
        };
        let planes: Vec<Vec<StressTensor>> = DEPTHS.par_iter().map(|&depth| plane(depth)).collect();
        Self { axes, stresses: planes.concat() }
    }

    /// At a place x, y, z, all in a; beyond the points as at the last of them.
    pub fn at(&self, [x, y, z]: [f64; 3]) -> StressTensor {
        let plane = DEPTHS[1..DEPTHS.len() - 1].partition_point(|depth| *depth < z);
        let down = (z - DEPTHS[plane]) / (DEPTHS[plane + 1] - DEPTHS[plane]);
        let along = |axis: usize, value: f64| {
            let (from, step, count) = self.axes[axis];
            let place = ((value - from) / step).clamp(0.0, (count - 1) as f64);
            let cell = (place as usize).min(count - 2);
            (cell, place - cell as f64)
        };
        let ((column, right), (row, up)) = (along(0, x), along(1, y));
        let [width, height] = self.axes.map(|(_, _, count)| count);
        let mut sum = [0.0; 6];
        for (plane, depth) in [(plane, 1.0 - down), (plane + 1, down)] {
            for (row, across) in [(row, 1.0 - up), (row + 1, up)] {
                for (column, share) in [(column, 1.0 - right), (column + 1, right)] {
                    let stress = &self.stresses[(plane * height + row) * width + column];
                    let weight = depth.clamp(0.0, 1.0) * across * share;
                    for (sum, stress) in sum.iter_mut().zip(stress) {
                        *sum += weight * stress;
                    }
                }
            }
        }
        sum
    }
}

/// 2π times what one corner has in the stress by q_x = 1, and by q_y = 1.
fn corner_stress([x, y, z]: [f64; 3], poisson_ratio: f64) -> [f64; 12] {
    let [xx, yy, zz, xy, yz, zx] = along([x, y, z], poisson_ratio);
    let across = along([y, x, z], poisson_ratio);
    [xx, yy, zz, xy, yz, zx, across[1], across[0], across[2], across[3], across[5], across[4]]
}

fn along([x, y, z]: [f64; 3], nu: f64) -> StressTensor {
    let r = (x * x + y * y + z * z).sqrt();
    // u + r without loss where u is below zero.
    let sum = |u: f64, rest: f64| match u < 0.0 {
        true => rest / (r - u),
        false => u + r,
    };
    let [of_x, of_y] = [sum(x, y * y + z * z), sum(y, x * x + z * z)];
    let deep = r + z;
    let [v_x, v_y] = [of_y.ln(), of_x.ln()];
    let v_z = -(x * y).atan2(z * r);
    let [v_xx, v_xy, v_xz] = [x / (r * of_y), 1.0 / r, z / (r * of_y)];
    let [phi_xxy, phi_xyy] = [x / (r * deep), y / (r * deep)];
    let phi_xxx = -phi_xyy - v_xz;
    let [f_xxx, f_xxy, f_xyy] = [y / deep - v_x, -x / deep, -y / deep];
    [
        2.0 * (1.0 + nu) * v_x + 2.0 * nu * f_xxx - z * phi_xxx,
        2.0 * nu * (v_x + f_xyy) - z * phi_xyy,
        -z * v_xz,
        v_y + 2.0 * nu * f_xxy - z * phi_xxy,
        -z * v_xy,
        v_z - z * v_xx,
    ]
}
