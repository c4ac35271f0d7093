//! What a wave of the rail does to a patch in rolling.

use num_complex::Complex64;

use super::Grid;
use super::forcing::{Deformation, Forcing};
use super::friction::Slip;
use super::influence::{Convolution, Influence};
use super::patch::Field;
use super::response::Oscillation;
use super::wavy_patch::{Degree, WavyPatch};

/// What becomes of a patch in steady rolling on waves, degree by degree, as far as it has been asked for.
pub(super) struct OnWaves {
    patch: WavyPatch,
    /// At the end and at the beginning of every step.
    ends: Vec<Ends>,
    degrees: Vec<OneDegree>,
}

/// What the steady displacement becomes at one end of every step when elements and places move.
struct Ends {
    /// Per stretch along the rail \[m\].
    by_stretch: Field<f64>,
    /// Per stretch across the rail \[m\].
    by_stretch_across: Field<f64>,
    /// Per displacement of the place along the rail \[-\].
    slope: Field<f64>,
}

/// The fields of one degree of [`WavyPatch`], per unit of its amplitude.
struct OneDegree {
    degree: Degree,
    /// Growth of the bound of each element over the bound and of its area \[-\].
    bound: Vec<f64>,
    elements: Vec<f64>,
    /// w_x beside the shift \[m\], its slope \[-\], in the middle of each step.
    along: Vec<(f64, f64)>,
    /// Change of the displacement at the end and at the beginning of every step \[m\].
    moved: [Field<f64>; 2],
}

impl OnWaves {
    pub(super) fn new(grid: &Grid, steady: &Slip) -> Self {
        /// Central difference of influences: leaves 1e-6 of them.
        const STRETCH: f64 = 1e-3;
        let patch = &grid.patch;
        let tractions = [0, 1].map(|part: usize| steady.tractions[part].as_slice());
        let stretched = [1.0, -1.0].map(|sign| {
            let mut stretched = patch.clone();
            stretched.dx *= 1.0 + sign * STRETCH;
            Influence::new(grid.material, &stretched)
        });
        let mut convolution = Convolution::new(&grid.influence, patch);
        let slopes = convolution.slope_along(tractions);
        let whole = convolution.both_ends(tractions);
        let [longer, shorter] =
            [0, 1].map(|index: usize| Convolution::new(&stretched[index], patch).both_ends(tractions));
        let by_stretch = [0, 1]
            .map(|end: usize| combined(1.0 / (2.0 * STRETCH), &longer[end], -1.0 / (2.0 * STRETCH), &shorter[end]));
        let ends = by_stretch.into_iter().zip(whole).zip(slopes);
        // Bodies that grow by a factor move by it.
        let ends = ends.map(|((by_stretch, whole), slope)| Ends {
            by_stretch_across: combined(1.0, &whole, -1.0, &by_stretch),
            by_stretch,
            slope,
        });
        Self { patch: WavyPatch::new(grid.semi_axes), ends: ends.collect(), degrees: Vec::new() }
    }

    /// Make the fields of the degrees that a wave of this number \[rad/m\] needs.
    pub(super) fn prepare(&mut self, wavenumber: f64, grid: &Grid, steady: &Slip, convolution: &mut Convolution) {
        let count = self.patch.amplitudes(wavenumber).by_degree.len();
        for n in self.degrees.len() + 1..=count {
            let degree = self.one_degree(self.patch.degree(n), grid, steady, convolution);
            self.degrees.push(degree);
        }
    }

    fn one_degree(&self, degree: Degree, grid: &Grid, steady: &Slip, convolution: &mut Convolution) -> OneDegree {
        let patch = &grid.patch;
        let half = 0.5 * patch.across as f64;
        // By columns of elements: at their centres, from that behind the first on, and between them.
        let at = |columns: f64| degree.along((columns - half) * patch.dx);
        let centres: Vec<_> = (0..patch.across + 2).map(|index| at(index as f64 - 0.5)).collect();
        let middles: Vec<_> = (0..=patch.across).map(|index| at(index as f64)).collect();
        let weighted = |weight: &dyn Fn((f64, f64)) -> f64| {
            [0, 1].map(|part: usize| -> Vec<f64> {
                let both = patch.places.iter().zip(&steady.tractions[part]);
                both.map(|(place, traction)| weight(centres[place.0 + 1]) * traction).collect()
            })
        };
        let (displaced, grown) = (weighted(&|along| along.0), weighted(&|along| along.1));
        let [displaced, grown] = [&displaced, &grown].map(|field| [field[0].as_slice(), field[1].as_slice()]);
        // Both ends at once, as real and imaginary part.
        let by_displacement = convolution.slope_along(displaced);
        let by_growth = convolution.both_ends(grown);
        let moved = [0, 1].map(|end: usize| {
            let ends = &self.ends[end];
            [0, 1].map(|part: usize| {
                let steps = patch.steps.iter().enumerate();
                let moved = steps.map(|(step, at)| {
                    let column = (at.end.0 + 1) as usize + end;
                    degree.stretch * ends.by_stretch[part][step]
                        + degree.stretch_across * ends.by_stretch_across[part][step]
                        + centres[column].0 * ends.slope[part][step]
                        - by_displacement[end][part][step]
                        + by_growth[end][part][step]
                });
                moved.collect()
            })
        });
        let dilation = degree.stretch + degree.stretch_across;
        let elements: Vec<f64> = patch.places.iter().map(|place| dilation + centres[place.0 + 1].1).collect();
        let mut bound: Vec<f64> = patch.centres.iter().map(|&at| degree.growth_of_pressure(at)).collect();
        // What the sum over elements leaves of the load goes evenly to all.
        let both = bound.iter().zip(&elements).zip(&grid.bound);
        let change: f64 = both.map(|((by, area), bound)| (by + area) * bound).sum();
        let share = change / grid.bound.iter().sum::<f64>();
        bound.iter_mut().for_each(|by| *by -= share);
        let steps = patch.steps.iter().map(|step| {
            let (beside, slope) = middles[(step.end.0 + 1) as usize];
            (degree.stretch * step.middle.0 + beside, degree.stretch + slope)
        });
        OneDegree { along: steps.collect(), bound, elements, moved, degree }
    }
}

/// A sum of two fields with factors.
fn combined(factor: f64, one: &Field<f64>, other_factor: f64, other: &Field<f64>) -> Field<f64> {
    [0, 1].map(|part| {
        let both = one[part].iter().zip(&other[part]);
        both.map(|(one, other)| factor * one + other_factor * other).collect()
    })
}

/// The sum of the fields of all degrees by their amplitudes, which a closure tells by index.
fn summed<'a>(
    by_degree: impl Iterator<Item = (&'a Complex64, &'a OneDegree)>,
    count: usize,
    of: impl Fn(&OneDegree, usize) -> f64,
) -> Vec<Complex64> {
    let mut sum = vec![Complex64::ZERO; count];
    for (amplitude, one) in by_degree {
        for (index, sum) in sum.iter_mut().enumerate() {
            *sum += amplitude * of(one, index);
        }
    }
    sum
}

impl Oscillation<'_> {
    /// By a wave of the rail. In the coordinates x + w of a [`WavyPatch`] the displacement is that of tractions on elements
    /// that are displaced and grow; the material passes at V(1 + ikw_x − w_x′), carried across by ik w_y; the slip *speed* stays, but
    /// for the spin, which turns about the place where rail and wheel are parallel.
    pub(super) fn by_profile(&self, on_waves: &OnWaves) -> Forcing {
        let tangent = self.tangent;
        let patch = &tangent.grid.patch;
        let (wavenumber, [of_here, of_ahead]) = (self.wavenumber, self.difference());
        let amplitudes = on_waves.patch.amplitudes(wavenumber);
        let by_degree = || amplitudes.by_degree.iter().zip(&on_waves.degrees);
        let sum =
            |of: fn(&OneDegree) -> f64| -> Complex64 { by_degree().map(|(amplitude, one)| amplitude * of(one)).sum() };
        let turning = Complex64::new(0.0, wavenumber);
        // k times the shift of the patch and that of the centre of its pressure, the tilt's alone.
        let shift = amplitudes.semi_axis * sum(|one| one.degree.shift);
        let centre = amplitudes.semi_axis * amplitudes.by_degree[0];
        let from_pivot = match wavenumber == 0.0 {
            true => Complex64::ZERO,
            false => (shift - amplitudes.pivot) / wavenumber,
        };
        let across = sum(|one| one.degree.stretch_across);
        let spin = tangent.creepages.spin;
        // The sums of fields, degree by degree.
        let along = summed(by_degree(), patch.steps.len(), |one, index| one.along[index].0);
        let slopes = summed(by_degree(), patch.steps.len(), |one, index| one.along[index].1);
        let moved = [0, 1].map(|end: usize| {
            [0, 1].map(|part: usize| summed(by_degree(), patch.steps.len(), |one, index| one.moved[end][part][index]))
        });
        let mut slip = [0, 1].map(|_| Vec::with_capacity(patch.steps.len()));
        let mut steps = Vec::with_capacity(patch.steps.len());
        let mut displaced = Vec::with_capacity(patch.steps.len());
        for (index, step) in patch.steps.iter().enumerate() {
            let y = step.middle.1;
            let (along, slope) = (along[index], slopes[index]);
            let behind = -(Complex64::I * shift + turning * along);
            let spinning = [-spin * across * y, spin * (from_pivot + along)];
            for part in 0..2 {
                let passed = tangent.ahead[part][index] - tangent.here[part][index];
                let carried = turning * across * y * tangent.across[part][index];
                let [here, ahead] = [0, 1].map(|end: usize| moved[end][part][index]);
                slip[part].push(
                    patch.dx * (spinning[part] + carried)
                        - (behind + slope) * passed
                        - of_here * here
                        - of_ahead * ahead,
                );
            }
            steps.push(slope + across);
            displaced.push(behind);
        }
        Forcing {
            slip,
            deformation: Some(Deformation {
                bound: summed(by_degree(), patch.len(), |one, index| one.bound[index]),
                elements: summed(by_degree(), patch.len(), |one, index| one.elements[index]),
                steps,
                displaced,
                slower: Complex64::new(0.0, -1.0) * centre,
            }),
        }
    }
}
