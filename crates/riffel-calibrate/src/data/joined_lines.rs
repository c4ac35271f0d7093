//! Lines of a frequency response that are taken together.

use riffel::Complex64;

/// Most lines that are compared one by one: a posterior of so many is drawn within a minute.
const MOST: usize = 100;
/// Most lines of each place if there are many: ten for each of the rail on its pads, the track on its bed and two modes between.
const MOST_OF_A_PLACE: usize = 40;
/// Squares over variances of two means that noise brings: once in three thousand. Below it they do not choose what is taken together,
/// or neighbours that err alike would be, and their means err by more than their errors say.
const BY_NOISE: f64 = 16.0;
/// Change of ln H over ln f that is expected everywhere, as above and below a resonance: where noise hides the response, lines are
/// taken together evenly.
const SLOPE: f64 = 1.0;

/// What is known of a line.
pub(super) struct Line {
    /// Where the rail was hit \[m\].
    pub(super) place: f64,
    /// \[Hz\]
    pub(super) frequency: f64,
    /// Receptance.
    pub(super) response: Complex64,
    /// Variance of ln |H| and arg H each.
    pub(super) variance: f64,
}

/// The mean of neighbouring lines of a place.
#[derive(Debug, Clone)]
pub(super) struct Band {
    /// The lines with their weights, in sum one.
    pub(super) lines: Vec<(usize, f64)>,
    /// Mean frequency and its standard deviation over the lines \[Hz\].
    pub(super) frequency: [f64; 2],
    /// Mean of ln |H| and, from line to line without jumps, arg H.
    pub(super) log: Complex64,
}

/// Bands under way: the sum of the weights, and means of ln |H|, arg H and ln f by them.
struct Joining {
    rows: Vec<usize>,
    weight: f64,
    means: [f64; 3],
}

impl Joining {
    /// What the squares about the mean, in variances of the lines, gain by taking two bands together: those that noise does not bring,
    /// and those of a slope.
    fn loss(&self, other: &Self) -> f64 {
        let weight = self.weight * other.weight / (self.weight + other.weight);
        let square = |of: usize| weight * (self.means[of] - other.means[of]).powi(2);
        (square(0) + square(1) - BY_NOISE).max(0.0) + square(2)
    }

    fn take(&mut self, other: Self) {
        let weight = self.weight + other.weight;
        for (mean, other_mean) in self.means.iter_mut().zip(other.means) {
            *mean += (other_mean - *mean) * other.weight / weight;
        }
        self.weight = weight;
        self.rows.extend(other.rows);
    }
}

/// The lines, in the order of the table; of more than 100, and 40 of each place, means of neighbours, in the order of places and
/// frequencies: those of two bands are taken together that lose least by it. Means are weighted by the inverse of the variance, so
/// that nothing of what lines say of a smooth response is lost.
///
/// Method: agglomeration of neighbours by least loss of squares, Ward (1963), J. Am. Stat. Assoc. 58. Accuracy: 196 lines in 100 bands
/// leave a posterior whose widths are within 5 % of those of all lines; see the test of the frequency responses. Cost: the square of the
/// number of lines.
pub(super) fn joined(lines: &[Line]) -> Vec<Band> {
    let mut places: Vec<f64> = lines.iter().map(|line| line.place).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let most = MOST.max(MOST_OF_A_PLACE * places.len());
    joined_to(lines, most.max(2 * places.len()))
}

/// Lines joined to so many bands, more than places.
pub(super) fn joined_to(lines: &[Line], most: usize) -> Vec<Band> {
    let single = |row: usize, phase: f64| Joining {
        rows: vec![row],
        weight: lines[row].variance.recip(),
        means: [lines[row].response.norm().ln(), phase, SLOPE * lines[row].frequency.ln()],
    };
    let own_phase = |row: usize| lines[row].response.arg();
    if lines.len() <= most {
        let bands = (0..lines.len()).map(|row| single(row, own_phase(row)));
        return bands.map(|band| band.done(lines)).collect();
    }
    let mut order: Vec<usize> = (0..lines.len()).collect();
    order.sort_by(|one, other| {
        let (one, other) = (&lines[*one], &lines[*other]);
        let by_place = one.place.total_cmp(&other.place);
        by_place.then(one.frequency.total_cmp(&other.frequency))
    });
    let mut bands: Vec<Joining> = Vec::new();
    for (at, row) in order.iter().enumerate() {
        let phase = match (at.checked_sub(1).map(|at| order[at]), bands.last()) {
            (Some(last), Some(before)) if lines[last].place == lines[*row].place => {
                before.means[1] + (lines[*row].response / lines[last].response).arg()
            }
            _ => own_phase(*row),
        };
        bands.push(single(*row, phase));
    }
    let loss = |bands: &[Joining], at: usize| {
        let (one, other) = (&bands[at], &bands[at + 1]);
        match lines[one.rows[0]].place == lines[other.rows[0]].place {
            true => one.loss(other),
            false => f64::INFINITY,
        }
    };
    let mut losses: Vec<f64> = (0..bands.len() - 1).map(|at| loss(&bands, at)).collect();
    while bands.len() > most {
        let least = (0..losses.len()).min_by(|a, b| losses[*a].total_cmp(&losses[*b]));
        let Some(least) = least else { break };
        let other = bands.remove(least + 1);
        bands[least].take(other);
        losses.remove(least);
        for at in [least.checked_sub(1), Some(least)].into_iter().flatten() {
            if at < losses.len() {
                losses[at] = loss(&bands, at);
            }
        }
    }
    bands.into_iter().map(|band| band.done(lines)).collect()
}

impl Joining {
    fn done(self, lines: &[Line]) -> Band {
        let share = |row: usize| lines[row].variance.recip() / self.weight;
        let shares: Vec<(usize, f64)> = self.rows.iter().map(|row| (*row, share(*row))).collect();
        let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
            let shares = shares.iter();
            shares.map(|(row, share)| share * of(lines[*row].frequency)).sum()
        };
        let frequency = match self.rows[..] {
            [row] => lines[row].frequency,
            _ => mean(&|f| f),
        };
        let deviation = mean(&|f| (f - frequency).powi(2)).sqrt();
        Band { frequency: [frequency, deviation], log: Complex64::new(self.means[0], self.means[1]), lines: shares }
    }
}

#[cfg(test)]
mod tests {
    use riffel_numerics::random_numbers::normal;

    use super::*;
    use crate::draw::random;

    /// 1600 lines of a mass on a spring of loss factor 0.02 at 500 Hz: of 100 bands eight or more lie within 2 % of it, where there are
    /// 40 of the lines, and every line is in one of them with a share.
    #[test]
    fn a_resonance_keeps_its_lines() {
        let line = |row: u32| {
            let frequency = 40.0 + f64::from(row);
            let ratio = (frequency / 500.0).powi(2);
            Line { place: 0.0, frequency, response: Complex64::new(1.0 - ratio, 0.02).inv() * 1e-9, variance: 2.5e-3 }
        };
        let lines: Vec<Line> = (0..1600).map(line).collect();
        let bands = joined(&lines);
        assert_eq!(bands.len(), MOST);
        let mut rows: Vec<usize> = bands.iter().flat_map(|it| &it.lines).map(|it| it.0).collect();
        rows.sort_unstable();
        assert_eq!(rows, (0..1600).collect::<Vec<usize>>());
        let near = |band: &&Band| (band.frequency[0] / 500.0 - 1.0).abs() < 0.02;
        let count = bands.iter().filter(near).count();
        assert!(count >= 8, "{count}");
        for band in &bands {
            let shares: f64 = band.lines.iter().map(|it| it.1).sum();
            let mean: f64 = band.lines.iter().map(|it| it.1 * lines[it.0].frequency).sum();
            assert!((shares - 1.0).abs() < 1e-12 && (mean - band.frequency[0]).abs() < 1e-9);
        }
    }

    /// Where lines err, by 5 % about a pad of loss factor 0.2 in 100 records, means of neighbours scatter as their weights say: to four
    /// standard errors of 20 000 squares.
    #[test]
    fn means_err_as_lines_do() {
        let mut random = random(7, 0, 0);
        let (mut sum, mut count) = (0.0, 0.0);
        for _ in 0..100 {
            let truth = |f: f64| (Complex64::new(1.0 - (f / 800.0).powi(2), 0.2).inv() * 1e-9).ln();
            let line = |row: u32| {
                let frequency = 40.0 + 4.0 * f64::from(row);
                let error = Complex64::new(normal(&mut random), normal(&mut random));
                Line { place: 0.0, frequency, response: (truth(frequency) + 0.05 * error).exp(), variance: 2.5e-3 }
            };
            let lines: Vec<Line> = (0..400).map(line).collect();
            for band in joined(&lines) {
                let truths = band.lines.iter().map(|(row, share)| share * truth(lines[*row].frequency));
                let error = band.log - truths.sum::<Complex64>();
                sum += error.norm_sqr() / 2.5e-3 * band.lines.len() as f64;
                count += 2.0;
            }
        }
        assert!((sum / count - 1.0).abs() < 4.0 * f64::sqrt(2.0 / count), "{}", sum / count);
    }

    /// Lines stay as they are, in their order, if they are no more than there may be; those of two places never meet.
    #[test]
    fn few_lines_and_places_stay_apart() {
        let line = |row: u32| Line {
            place: f64::from(row % 2),
            frequency: 900.0 - f64::from(row),
            response: Complex64::new(1.0, -0.1),
            variance: 1e-3,
        };
        let lines: Vec<Line> = (0..20).map(line).collect();
        for (row, band) in joined(&lines).iter().enumerate() {
            assert_eq!(band.lines, [(row, 1.0)]);
            assert_eq!(band.frequency, [lines[row].frequency, 0.0]);
        }
        for band in joined_to(&lines, 5) {
            let place = lines[band.lines[0].0].place;
            assert!(band.lines.iter().all(|it| lines[it.0].place == place));
        }
    }
}
