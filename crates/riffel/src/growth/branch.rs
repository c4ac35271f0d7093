//! Branches of the ridge: lines of growth that continue from speed to speed.

use super::RidgePoint;

/// A line of growth: one local minimum of Re Ŵ₁ < 0 at each of its speeds, whose frequency changes continuously
/// from one speed to the next.
///
/// Each is a mechanism of its own, mostly a resonance of the track. It may be the highest at some of its speeds, at
/// all, or at none, where a stronger branch grows at another wavelength.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct RidgeBranch {
    /// One point per speed, in order of speed; never empty.
    points: Vec<RidgePoint>,
}

impl RidgeBranch {
    /// A branch of its points in order of speed, one or more.
    pub(super) fn new(points: Vec<RidgePoint>) -> Self {
        Self { points }
    }

    /// Its points in order of speed.
    pub fn points(&self) -> &[RidgePoint] {
        &self.points
    }

    /// The points where its crest lies inside the window; all, where it shows no more than a flank.
    ///
    /// At the points at an end of the window growth rises beyond it: they belong to the branch but say nothing of its
    /// frequency.
    pub fn crest(&self) -> impl Iterator<Item = &RidgePoint> {
        let only_at_edge = self.only_at_edge();
        let points = self.points.iter();
        points.filter(move |point| only_at_edge || !point.at_edge)
    }

    /// Whether all of it lies at an end of the window.
    pub fn only_at_edge(&self) -> bool {
        self.points.iter().all(|point| point.at_edge)
    }

    /// Frequency \[Hz\] of the ray λ = V/f that fits the branch best: least absolute deviations in wavelength over
    /// the points inside the window; over all, where there are none inside.
    ///
    /// Σ|λ − V/f| = ΣV|λ/V − 1/f| is least where 1/f is the median of λ/V with the weights V.
    pub fn frequency(&self) -> f64 {
        let mut points: Vec<&RidgePoint> = self.crest().collect();
        points.sort_by(|a, b| a.frequency.total_cmp(&b.frequency));
        let half = points.iter().map(|point| point.speed).sum::<f64>() / 2.0;
        let mut sum = 0.0;
        points
            .iter()
            .find(|point| {
                sum += point.speed;
                sum >= half
            })
            .map_or(f64::NAN, |point| point.frequency)
    }

    /// Lowest and highest speed \[m/s\] of the points that [`frequency`](Self::frequency) goes by.
    pub fn speeds(&self) -> (f64, f64) {
        self.range(|point| point.speed)
    }

    /// Shortest and longest wavelength \[m\] of the points that [`frequency`](Self::frequency) goes by.
    pub fn wavelengths(&self) -> (f64, f64) {
        self.range(|point| point.wavelength)
    }

    fn range(&self, value: impl Fn(&RidgePoint) -> f64) -> (f64, f64) {
        self.crest()
            .map(value)
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), value| (value.min(least), value.max(most)))
    }

    /// The point of highest growth rate per passage.
    pub fn highest(&self) -> &RidgePoint {
        let higher = |best: usize, index: usize| {
            let rate = |index: usize| self.points[index].growth_rate;
            if rate(index) > rate(best) { index } else { best }
        };
        &self.points[(0..self.points.len()).fold(0, higher)]
    }
}

/// A local minimum of Re Ŵ₁ < 0 in a row.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Minimum {
    /// Its place in the row.
    pub(super) index: usize,
    /// Re Ŵ₁ there.
    pub(super) value: f64,
    /// Its neighbours, or itself at an end of the row \[m\].
    pub(super) between: [f64; 2],
    /// It is the first or the last of the row.
    at_end: bool,
    /// Wavelength \[m\] of the vertex of the parabola through it and its neighbours; itself at an end of the row.
    wavelength: f64,
}

/// The local minima of Re Ŵ₁ < 0 in a row of rising wavelengths, in their order.
pub(super) fn minima(wavelengths: &[f64], values: &[f64]) -> Vec<Minimum> {
    let last = values.len() - 1;
    (0..=last)
        .filter(|&j| {
            let lower_left = j == 0 || values[j] < values[j - 1];
            let lower_right = j == last || values[j] <= values[j + 1];
            values[j] < 0.0 && lower_left && lower_right
        })
        .map(|j| {
            let at_end = j == 0 || j == last;
            let [left, right] = [j.saturating_sub(1), (j + 1).min(last)];
            let vertex = || {
                let before = wavelengths[j] - wavelengths[left];
                let after = wavelengths[right] - wavelengths[j];
                let (fall, rise) = (values[left] - values[j], values[right] - values[j]);
                0.5 * (after * after * fall - before * before * rise) / (after * fall + before * rise)
            };
            Minimum {
                index: j,
                value: values[j],
                between: [wavelengths[left], wavelengths[right]],
                at_end,
                wavelength: wavelengths[j] + if at_end { 0.0 } else { vertex() },
            }
        })
        .collect()
}

/// Where a minimum stands: row and place in the row.
pub(super) type Place = (usize, usize);

/// Rows in a row that a chain may miss: a minimum may pass below zero or behind another for some speeds.
const MISSED: usize = 3;
/// Points over which the slope of a chain is taken.
const SLOPE_POINTS: usize = 8;
/// Change of ln f from one point to the next, beyond which a line is no longer called continuous on a coarse axis of
/// speeds: a fifth, less than a one-third octave.
const LARGEST_STEP: f64 = 0.2;

/// A point of a branch in the making.
#[derive(Clone, Copy)]
struct Step {
    ln_speed: f64,
    ln_frequency: f64,
    /// At an end of the window, where the wavelength says nothing of the crest beyond.
    at_end: bool,
}

/// A branch in the making; never empty.
struct Chain {
    members: Vec<Place>,
    course: Vec<Step>,
}

impl Chain {
    fn last(&self) -> Step {
        self.course[self.course.len() - 1]
    }

    /// ln f expected at ln V of a minimum at an end of the window or inside it.
    fn expected(&self, ln_speed: f64, at_end: bool) -> f64 {
        let last = self.last();
        let slope = match (last.at_end, at_end) {
            // The wavelength is that of the end.
            (true, true) => 1.0,
            // A crest comes in where it is at the end.
            (true, false) => 0.0,
            (false, _) => self.slope(),
        };
        last.ln_frequency + slope * (ln_speed - last.ln_speed)
    }

    /// ∂ ln f/∂ ln V over the last points inside the window, zero for a single one.
    fn slope(&self) -> f64 {
        let last = self.last();
        let inside = self.course.iter().rev().take_while(|step| !step.at_end);
        let first = inside.take(SLOPE_POINTS + 1).last().unwrap_or(&last);
        if first.ln_speed < last.ln_speed {
            let rise = last.ln_frequency - first.ln_frequency;
            // From constant wavelength to its mirror image: what is steeper is noise of the grid.
            (rise / (last.ln_speed - first.ln_speed)).clamp(-1.0, 1.0)
        } else {
            0.0
        }
    }
}

/// Join the minima of rows in order of speed to chains, so that each minimum is in one chain.
///
/// A chain is expected to go on along the straight line of ln f over ln V through its last points inside the window; f
/// is expected to stay where there is one such point, and where a crest comes in from an end; λ along an end. Minima and chains are joined in the order of their distance
/// from there in ln f, each once. A distance is allowed that the step of speed makes at constant wavelength, which is
/// the steepest course of a filter of the contact, but no more than 0.2; and one step of the grid besides.
pub(super) fn chains(rows: &[(f64, &[Minimum])]) -> Vec<Vec<Place>> {
    let mut chains: Vec<Chain> = Vec::new();
    for (row, &(speed, minima)) in rows.iter().enumerate() {
        let ln_speed = speed.ln();
        let ln_frequency = |minimum: &Minimum| ln_speed - minimum.wavelength.ln();
        let mut pairs: Vec<(f64, usize, usize)> = Vec::new();
        for (index, chain) in chains.iter().enumerate() {
            let missed = row - 1 - chain.members.last().map_or(0, |&(row, _)| row);
            let last_speed = chain.last().ln_speed;
            // The same speed twice is no course.
            if missed > MISSED || last_speed >= ln_speed {
                continue;
            }
            for (place, minimum) in minima.iter().enumerate() {
                let expected = chain.expected(ln_speed, minimum.at_end);
                let distance = (ln_frequency(minimum) - expected).abs();
                let [shortest, longest] = minimum.between;
                let at = minimum.wavelength;
                let step = (longest - at).max(at - shortest) / at;
                let allowed = (ln_speed - last_speed).min(LARGEST_STEP) + step;
                if distance <= allowed {
                    pairs.push((distance, index, place));
                }
            }
        }
        pairs.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut continued: Vec<Option<usize>> = vec![None; minima.len()];
        for (_, chain, place) in pairs {
            if continued[place].is_none() && !continued.contains(&Some(chain)) {
                continued[place] = Some(chain);
            }
        }
        for (place, (minimum, chain)) in minima.iter().zip(continued).enumerate() {
            let chain = chain.unwrap_or_else(|| {
                chains.push(Chain { members: Vec::new(), course: Vec::new() });
                chains.len() - 1
            });
            chains[chain].members.push((row, place));
            chains[chain].course.push(Step { ln_speed, ln_frequency: ln_frequency(minimum), at_end: minimum.at_end });
        }
    }
    chains.into_iter().map(|chain| chain.members).collect()
}

#[cfg(test)]
mod tests {
    use super::super::Axis;
    use super::*;

    /// A dip of Re Ŵ₁ at a wavelength \[m\], of a relative width.
    fn dip(depth: f64, wavelength: f64, at: f64, width: f64) -> f64 {
        -depth / (1.0 + ((wavelength / at).ln() / width).powi(2))
    }

    fn window() -> Axis {
        Axis::new(0.02, 0.08, 241).unwrap()
    }

    /// The chains of a field over the window, as courses of speed and wavelength.
    fn courses(speeds: &[f64], field: impl Fn(f64, f64) -> f64) -> Vec<Vec<(f64, f64)>> {
        let rows: Vec<(f64, Vec<Minimum>)> = speeds
            .iter()
            .map(|&speed| {
                let values = window().values();
                let row: Vec<f64> = values.iter().map(|&wavelength| field(wavelength, speed)).collect();
                (speed, minima(&values, &row))
            })
            .collect();
        let borrowed: Vec<(f64, &[Minimum])> = rows.iter().map(|(speed, minima)| (*speed, &minima[..])).collect();
        chains(&borrowed)
            .iter()
            .map(|chain| chain.iter().map(|&(row, place)| (rows[row].0, rows[row].1[place].wavelength)).collect())
            .collect()
    }

    fn speeds(from: f64, to: f64) -> Vec<f64> {
        Axis::new(from, to, 101).unwrap().values()
    }

    /// A resonance at 500 Hz and a filter at 40 mm cross at 20 m/s; each keeps its course.
    #[test]
    fn branches_that_cross_keep_their_course() {
        let found = courses(&speeds(15.0, 30.0), |wavelength, speed| {
            dip(1.0, wavelength, speed / 500.0, 0.01) + dip(0.7, wavelength, 0.04, 0.01) + 0.01
        });
        let mut long: Vec<_> = found.iter().filter(|course| course.len() > 50).collect();
        long.sort_by_key(|course| course[0].1 < 0.035);
        let [filter, resonance] = long[..] else {
            panic!("{} courses of more than half the speeds", long.len());
        };
        // Where they run into each other one minimum stands for both: a width of 1 % and a grid step of 0.25 mm.
        const WITHIN: f64 = 6.5e-4;
        for (speed, wavelength) in resonance {
            assert!((wavelength - speed / 500.0).abs() < WITHIN, "{speed} {wavelength}");
        }
        for (_, wavelength) in filter {
            assert!((wavelength - 0.04).abs() < WITHIN, "{wavelength}");
        }
        let ends = |course: &[(f64, f64)]| (course[0].0, course[course.len() - 1].0);
        assert_eq!(ends(resonance), (15.0, 30.0));
        assert_eq!(ends(filter), (15.0, 30.0));
    }

    /// A crest that comes in at the short end of the window while its frequency falls is one with its flank, however
    /// coarse the speeds are.
    #[test]
    fn a_crest_that_comes_in_is_one_with_its_flank() {
        for points in [23, 56, 111, 221] {
            let speeds = Axis::new(5.0, 60.0, points).unwrap().values();
            let found = courses(&speeds, |wavelength, speed| {
                // f = 1000 Hz (20 m/s / V)^0.3, inside from 20 to 54 m/s.
                let crest = speed / (1000.0 * (20.0 / speed).powf(0.3));
                if speed < 12.0 { 1.0 } else { dip(1.0, wavelength, crest, 0.3) }
            });
            assert_eq!(found.len(), 1, "{points} speeds: {found:?}");
        }
    }

    /// A weak line under a strong one at every speed is a chain of its own.
    #[test]
    fn a_hidden_line_is_found() {
        let found = courses(&speeds(15.0, 30.0), |wavelength, speed| {
            dip(1.0, wavelength, speed / 500.0, 0.02) + dip(0.1, wavelength, speed / 700.0, 0.02)
        });
        let lengths: Vec<usize> = found.iter().map(Vec::len).collect();
        assert!(lengths.contains(&101), "{lengths:?}");
        // Both lie inside the window at all of these speeds.
        assert_eq!(lengths.iter().filter(|&&length| length > 95).count(), 2, "{lengths:?}");
    }

    /// Lines narrower than the grid are seen in some rows; up to three in a row may be missed.
    #[test]
    fn a_chain_may_miss_rows() {
        let every = |every: usize| {
            courses(&speeds(15.0, 30.0), |wavelength, speed| {
                let row = ((speed - 15.0) / 0.15).round() as usize;
                let seen = row.is_multiple_of(every);
                if seen { dip(1.0, wavelength, speed / 500.0, 0.02) } else { 1.0 }
            })
            .len()
        };
        assert_eq!(every(4), 1);
        assert_eq!(every(5), 21);
    }

    #[test]
    fn one_speed_has_a_chain_for_each_minimum_and_decay_has_none() {
        let found =
            courses(&[20.0], |wavelength, _| dip(1.0, wavelength, 0.03, 0.02) + dip(1.0, wavelength, 0.06, 0.02));
        assert_eq!(found.len(), 2);
        assert!((found[0][0].1 - 0.03).abs() < 1e-5 && (found[1][0].1 - 0.06).abs() < 1e-5);
        assert!(courses(&speeds(15.0, 30.0), |wavelength, speed| wavelength * speed).is_empty());
        assert!(courses(&speeds(15.0, 30.0), |_, _| f64::NAN).is_empty());
        assert!(courses(&speeds(15.0, 30.0), |_, _| 0.0).is_empty());
    }

    fn point(speed: f64, frequency: f64, at_edge: bool) -> RidgePoint {
        RidgePoint {
            speed,
            wavelength: speed / frequency,
            frequency,
            normalized_dissipation: -speed,
            growth_rate: speed,
            at_edge,
        }
    }

    /// What lies at the edge of the window counts for the growth of a branch, and for its frequency only where it is
    /// all there is.
    #[test]
    fn the_edge_says_nothing_of_the_frequency() {
        let branch = RidgeBranch::new(vec![
            point(10.0, 400.0, true),
            point(20.0, 500.0, false),
            point(30.0, 501.0, false),
            point(40.0, 900.0, true),
        ]);
        assert_eq!(branch.frequency(), 501.0);
        assert_eq!(branch.speeds(), (20.0, 30.0));
        assert_eq!(branch.wavelengths(), (20.0 / 500.0, 30.0 / 501.0));
        assert_eq!(branch.highest().speed, 40.0);
        assert!(!branch.only_at_edge());
        let flank = RidgeBranch::new(vec![point(10.0, 400.0, true), point(20.0, 800.0, true)]);
        assert!(flank.only_at_edge());
        assert_eq!((flank.frequency(), flank.speeds()), (800.0, (10.0, 20.0)));
    }
}
