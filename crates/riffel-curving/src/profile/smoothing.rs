//! Measured points of a profile without their scatter.

use super::profile::{check_points, chords};
use super::{ProfileError, ShapeFault};

/// Fewest points that are smoothed: fewer do not tell scatter from shape.
const LEAST: usize = 30;

/// Points of a profile on a smooth curve, and what is left of their scatter.
///
/// A measured profile scatters by hundredths of a millimetre. A curve through its points bends with them: scatter σ on points Δ apart leaves a
/// curvature of some 3σ/Δ², 10³ 1/m where a rail has 3 to 80. Here each coordinate over the length s of the chords is the f with the least
/// Σ(y − f)² + ∫pf″² ds (Whittaker 1923, Reinsch 1967), so that waves longer than 2πa stay, a⁴ = pΔ. a follows the profile: it is as
/// √R, R the radius over 10 mm and 0.3 m at most, for a head is flat and its corners are not.
///
/// Method: the size of a from Mallows' C_p, the least RSS/n + 2.8σ²ν/n with the degrees of freedom ν = ∫ds/(2√2 a), first for an even a, from which R
/// comes, and twice more; one system of five diagonals for each of some hundred sizes. Points that lie five deviations off what the four beside
/// them say are dropped, the worst of neighbours first. The error of the curvature is that of white scatter, σ√(0.0884 Δ/a⁵); where the curvature
/// itself jumps, as between the arcs of a nominal head, the curve takes some 4a for it, and at the
/// ends, where its curvature vanishes, as much (test `curvature_of_a_measured_rail`). Cost: some
/// ten milliseconds for a thousand points.
#[derive(Debug, Clone, PartialEq)]
pub struct SmoothedPoints {
    /// The points (x, height) \[m\], without those that were dropped.
    pub points: Vec<[f64; 2]>,
    /// Numbers of those that were dropped.
    pub dropped: Vec<usize>,
    /// Standard deviation of the curvature that scatter leaves at each point \[1/m\].
    pub curvature_errors: Vec<f64>,
}

impl SmoothedPoints {
    /// Points (x, height) \[m\] that scatter with this standard deviation \[m\] across the curve.
    ///
    /// # Errors
    /// [`ProfileError`] for fewer than 30 points, points that are not finite or stand twice, and a deviation that is not positive.
    pub fn new(points: &[[f64; 2]], scatter: f64) -> Result<Self, ProfileError> {
        /// Deviations off its neighbours at which a point is dropped.
        const OUTLIER: f64 = 5.0;
        /// Times that R is taken from the curve.
        const REFINEMENTS: usize = 2;
        if points.len() < LEAST {
            return Err(ProfileError::TooFew { count: points.len(), least: LEAST });
        }
        if !(scatter > 0.0 && scatter.is_finite()) {
            return Err(ProfileError::Shape(ShapeFault::Scatter(scatter)));
        }
        check_points(points)?;
        let mut kept: Vec<usize> = (0..points.len()).collect();
        let place = |kept: &[usize]| -> Vec<[f64; 2]> { kept.iter().map(|&index| points[index]).collect() };
        let mut dropped = Vec::new();
        loop {
            let off = off_neighbours(&place(&kept));
            let near = |index: usize| index.saturating_sub(2)..(index + 3).min(off.len());
            let worst: Vec<usize> = (0..off.len())
                .filter(|&index| off[index] > OUTLIER * scatter && near(index).all(|other| off[other] <= off[index]))
                .collect();
            if worst.is_empty() || kept.len() - worst.len() < LEAST {
                break;
            }
            for index in worst.into_iter().rev() {
                dropped.push(kept.remove(index));
            }
        }
        dropped.sort_unstable();
        let rough = place(&kept);
        let even = vec![1.0; rough.len()];
        let (mut points, mut lengths) = least_risk(&rough, &chords(&rough), &even, scatter);
        for _ in 0..REFINEMENTS {
            // Scatter lengthens the chords of close points.
            let parameter = chords(&points);
            let relative = relative_lengths(&points);
            (points, lengths) = least_risk(&rough, &parameter, &relative, scatter);
        }
        let step = mean_step(&chords(&points));
        Ok(Self {
            points,
            dropped,
            curvature_errors: lengths.iter().map(|a| scatter * (0.0884 * step / a.powi(5)).sqrt()).collect(),
        })
    }

    /// Standard deviation of points across their curve \[m\], from how far each lies off what the four beside it say: 5 % off for a hundred
    /// points that scatter like white noise, and some 10⁻⁹ m for points of an exact arc. None for fewer than 30.
    pub fn scatter_of(points: &[[f64; 2]]) -> Option<f64> {
        /// Of a normal distribution, median of the size over the deviation.
        const MEDIAN: f64 = 0.6745;
        if points.len() < LEAST || check_points(points).is_err() {
            return None;
        }
        let mut off = off_neighbours(points);
        off.sort_by(f64::total_cmp);
        Some(off[off.len() / 2] / MEDIAN)
    }
}

/// How far each point lies across the curve off the cubic through the four beside it, over what scatter of one makes of that; zero at
/// the ends.
fn off_neighbours(points: &[[f64; 2]]) -> Vec<f64> {
    let parameter = chords(points);
    let mut off = vec![0.0; points.len()];
    for index in 2..points.len() - 2 {
        let beside = [index - 2, index - 1, index + 1, index + 2];
        let weights = beside.map(|one| {
            let others = beside.iter().filter(|&&other| other != one);
            others
                .map(|&other| (parameter[index] - parameter[other]) / (parameter[one] - parameter[other]))
                .product::<f64>()
        });
        let at = |axis: usize| -> f64 {
            let terms = weights.iter().zip(beside);
            points[index][axis] - terms.map(|(weight, one)| weight * points[one][axis]).sum::<f64>()
        };
        let (along, up) = (points[index + 1][0] - points[index - 1][0], points[index + 1][1] - points[index - 1][1]);
        let across = (along * at(1) - up * at(0)) / along.hypot(up);
        let variance = 1.0 + weights.iter().map(|weight| weight * weight).sum::<f64>();
        off[index] = across.abs() / variance.sqrt();
    }
    off
}

fn mean_step(parameter: &[f64]) -> f64 {
    parameter[parameter.len() - 1] / (parameter.len() - 1) as f64
}

/// √R of a curve at its points, R the radius over some millimetres.
fn relative_lengths(points: &[[f64; 2]]) -> Vec<f64> {
    /// Over which the curve turns \[m\].
    const OVER: f64 = 10e-3;
    /// Of the flattest part \[m\]: a rail head.
    const FLATTEST: f64 = 0.3;
    let parameter = chords(points);
    let angle = |from: usize, to: usize| (points[to][1] - points[from][1]).atan2(points[to][0] - points[from][0]);
    (0..points.len())
        .map(|index| {
            let beside = |place: f64| {
                let found = parameter.partition_point(|&other| other < place);
                found.min(points.len() - 1)
            };
            let from = beside(parameter[index] - 0.5 * OVER);
            let to = beside(parameter[index] + 0.5 * OVER);
            // Two chords turn against each other by half of what their ends do.
            let turn = match from < index && index < to {
                true => (angle(index, to) - angle(from, index)).abs(),
                false => 0.0,
            };
            let radius = 0.5 * (parameter[to] - parameter[from]) / turn;
            radius.min(FLATTEST).sqrt()
        })
        .collect()
}

/// The smooth points of the size of a, as these relative lengths, that has the least risk; with a at each point \[m\].
fn least_risk(points: &[[f64; 2]], parameter: &[f64], relative: &[f64], scatter: f64) -> (Vec<[f64; 2]>, Vec<f64>) {
    /// The mean of a over the mean step and over the whole length, between which it is sought, and steps to a factor of ten.
    const SHORTEST: f64 = 0.5;
    const LONGEST: f64 = 0.1;
    const TO_A_DECADE: f64 = 16.0;
    /// Of a degree of freedom, against the scatter of the choice itself, which else is too rough now and then (Kim & Gu 2004).
    const COSTLIER: f64 = 1.4;
    let (count, step) = (points.len() as f64, mean_step(parameter));
    let length = parameter[points.len() - 1];
    let mean = relative.iter().sum::<f64>() / count;
    let (from, to) = (SHORTEST * step, LONGEST * length);
    let candidates = ((to / from).log10() * TO_A_DECADE).ceil().max(1.0) as i32;
    let tried = (0..=candidates).map(|candidate| {
        let size = from * (to / from).powf(f64::from(candidate) / f64::from(candidates));
        let lengths: Vec<f64> = relative.iter().map(|one| size * one / mean).collect();
        let smooth = smooth(parameter, points, &lengths, step);
        let rest: f64 = points
            .iter()
            .zip(&smooth)
            .map(|(point, curve)| (point[0] - curve[0]).powi(2) + (point[1] - curve[1]).powi(2))
            .sum();
        let freedom: f64 = lengths.iter().map(|a| step / (8f64.sqrt() * a)).sum();
        (rest + 2.0 * COSTLIER * scatter * scatter * freedom, smooth, lengths)
    });
    let best = tried.min_by(|one, other| one.0.total_cmp(&other.0));
    best.map_or((points.to_vec(), relative.to_vec()), |(_, smooth, lengths)| (smooth, lengths))
}

/// Both coordinates of the curve with the least Σ(y − f)² + Σ p_j r_j f″_j², p = a⁴/Δ, over the knots.
///
/// f″ by differences, r the part of the length that is nearer to a knot than to others: (1 + Q diag(p/r) Qᵀ) f = y, five diagonals, by LDLᵀ.
fn smooth(parameter: &[f64], points: &[[f64; 2]], lengths: &[f64], step: f64) -> Vec<[f64; 2]> {
    let count = points.len();
    // diagonal, next, next but one
    let mut rows = vec![[1.0, 0.0, 0.0]; count];
    for j in 0..count - 2 {
        let (before, after) = (parameter[j + 1] - parameter[j], parameter[j + 2] - parameter[j + 1]);
        let q = [before.recip(), -before.recip() - after.recip(), after.recip()];
        let weight = lengths[j + 1].powi(4) / step / (0.5 * (before + after));
        for one in 0..3 {
            for other in one..3 {
                rows[j + one][other - one] += weight * q[one] * q[other];
            }
        }
    }
    for j in 0..count {
        let [mut pivot, mut one, two] = rows[j];
        if j >= 1 {
            let [d, l, m] = rows[j - 1];
            pivot -= l * l * d;
            one -= l * m * d;
        }
        if j >= 2 {
            let [d, _, m] = rows[j - 2];
            pivot -= m * m * d;
        }
        rows[j] = [pivot, one / pivot, two / pivot];
    }
    let mut smooth = points.to_vec();
    let less = |one: [f64; 2], factor: f64, other: [f64; 2]| [0, 1].map(|axis| one[axis] - factor * other[axis]);
    for j in 1..count {
        smooth[j] = less(smooth[j], rows[j - 1][1], smooth[j - 1]);
        if j >= 2 {
            smooth[j] = less(smooth[j], rows[j - 2][2], smooth[j - 2]);
        }
    }
    for j in (0..count).rev() {
        smooth[j] = smooth[j].map(|value| value / rows[j][0]);
        if j + 1 < count {
            smooth[j] = less(smooth[j], rows[j][1], smooth[j + 1]);
        }
        if j + 2 < count {
            smooth[j] = less(smooth[j], rows[j][2], smooth[j + 2]);
        }
    }
    smooth
}

#[cfg(test)]
mod tests {
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::SeedableRng;

    use super::*;
    use crate::profile::{NominalProfile, Profile};
    use riffel_numerics::random_numbers::normal;

    /// A profile measured at equal steps of its length with scatter across it \[m\].
    fn measured(name: &str, step: f64, scatter: f64, seed: u64) -> Vec<[f64; 2]> {
        let nominal = NominalProfile::named(name).unwrap().profile();
        let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
        let mut points = Vec::new();
        let mut x = -0.034;
        while x < 0.034 {
            let point = nominal.at(x).unwrap();
            let along = (1.0 + point.slope * point.slope).sqrt();
            let off = scatter * normal(&mut random);
            points.push([x - off * point.slope / along, point.height + off / along]);
            x += step / along;
        }
        points
    }

    /// Root mean square of a curvature less what it should be \[1/m\], up to this distance from the middle \[m\].
    fn error(points: &[[f64; 2]], expected: impl Fn(f64) -> f64, farthest: f64) -> f64 {
        let profile = Profile::through(points).unwrap();
        let places = (-200..=200).map(|index| farthest * f64::from(index) / 200.0);
        let square: f64 = places.map(|x| (profile.at(x).unwrap().curvature - expected(x)).powi(2)).sum();
        (square / 401.0).sqrt()
    }

    /// An arc of 300 mm at the scatter and the step of laser devices: the error of the curvature is the one stated, within a factor of
    /// three for so few waves, of which the scatter itself has chosen a.
    #[test]
    fn curvature_of_a_measured_arc() {
        for (step, scatter) in [(0.2e-3, 10e-6), (0.5e-3, 20e-6), (0.1e-3, 30e-6)] {
            let (mut missed, mut stated) = (0.0, 0.0);
            for seed in 0..8 {
                let mut random = Xoshiro256PlusPlus::seed_from_u64(seed);
                let count = (0.035 / step) as i32;
                let points: Vec<[f64; 2]> = (-count..=count)
                    .map(|index| {
                        let angle = step * f64::from(index) / 0.3;
                        let radius = 0.3 + scatter * normal(&mut random);
                        [radius * angle.sin(), radius * angle.cos() - 0.3]
                    })
                    .collect();
                let found = SmoothedPoints::scatter_of(&points).unwrap();
                assert!((found / scatter - 1.0).abs() < 0.2, "{found:e} {scatter:e}");
                let smooth = SmoothedPoints::new(&points, scatter).unwrap();
                assert!(smooth.dropped.is_empty());
                missed += error(&smooth.points, |_| -1.0 / 0.3, 10e-3).powi(2) / 8.0;
                let near = smooth.points.iter().zip(&smooth.curvature_errors);
                let near = near.filter(|(point, _)| point[0].abs() < 10e-3);
                let squares: Vec<f64> = near.map(|(_, error)| error * error).collect();
                stated += squares.iter().sum::<f64>() / squares.len() as f64 / 8.0;
            }
            let ratio = (missed / stated).sqrt();
            assert!((0.5..3.0).contains(&ratio), "{missed} {stated}");
        }
    }

    /// 60E1, whose head of 3.3 1/m goes over into 12.5 1/m at 10 mm and into a corner of 77 1/m at 26 mm, at once: its crown comes out to 1 1/m (0.3
    /// to 0.9), its corner to a third, where a curve through the points is hundreds off.
    #[test]
    fn curvature_of_a_measured_rail() {
        let nominal = NominalProfile::named("60E1").unwrap().profile();
        let expected = |x: f64| nominal.at(x).unwrap().curvature;
        for (step, scatter) in [(0.2e-3, 10e-6), (0.5e-3, 20e-6), (0.1e-3, 30e-6)] {
            for seed in 0..4 {
                let points = measured("60E1", step, scatter, seed);
                let found = SmoothedPoints::scatter_of(&points).unwrap();
                assert!((found / scatter - 1.0).abs() < 0.3, "{found:e} {scatter:e}");
                let smooth = SmoothedPoints::new(&points, scatter).unwrap();
                assert!(smooth.dropped.is_empty());
                let missed = error(&smooth.points, expected, 6e-3);
                assert!(missed < 1.5, "{step:e} {scatter:e}: {missed}");
                // With 30 µm on 0.1 mm the points turn back.
                if Profile::through(&points).is_ok() {
                    assert!(error(&points, expected, 6e-3) > 100.0 * missed);
                }
                let corner = Profile::through(&smooth.points).unwrap();
                let corner = corner.at(30e-3).unwrap().curvature / expected(30e-3);
                assert!((corner - 1.0).abs() < 0.45, "{step:e} {scatter:e}: {corner}");
            }
        }
    }

    /// A chip of half a millimetre is dropped, and what is exact stays within a micrometre.
    #[test]
    fn outliers_are_dropped() {
        let mut points = measured("60E1", 0.25e-3, 10e-6, 3);
        points[100][1] += 0.5e-3;
        points[150][1] -= 0.2e-3;
        let smooth = SmoothedPoints::new(&points, 10e-6).unwrap();
        assert_eq!(smooth.dropped, [100, 150]);
        let exact = measured("60E1", 0.25e-3, 0.0, 1);
        assert!(SmoothedPoints::scatter_of(&exact).unwrap() < 1e-7);
        let smooth = SmoothedPoints::new(&exact, 1e-6).unwrap();
        for (point, curve) in exact.iter().zip(&smooth.points) {
            let off = (point[0] - curve[0]).hypot(point[1] - curve[1]);
            assert!(off < 5e-6, "{off:e}");
        }
    }

    #[test]
    fn what_cannot_be_smoothed_is_refused() {
        let points = measured("60E1", 0.25e-3, 10e-6, 3);
        assert!(SmoothedPoints::new(&points[..20], 10e-6).is_err());
        for scatter in [0.0, -1e-6, f64::NAN] {
            assert!(SmoothedPoints::new(&points, scatter).is_err());
        }
        let mut twice = points;
        twice[7] = twice[6];
        assert!(SmoothedPoints::new(&twice, 10e-6).is_err());
    }
}
