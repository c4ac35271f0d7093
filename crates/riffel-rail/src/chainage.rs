//! Positions along the rail, and where they break off.

use std::ops::Range;

use riffel_keys::{Message, fixed, say};

/// Longest run of missing samples that is filled \[m\].
pub(super) const LONGEST_FILLED: f64 = 0.010;
/// Share of rows that may be defective before the file is refused.
const MOST_DEFECTS: f64 = 0.01;
/// Steps of which the median is taken.
const SAMPLE: usize = 100_000;
/// Largest distance of positions from even ones, as root mean square over the step, at which rows count as even: then a
/// wave of ten steps is blurred by no more than 2π/10 · 0.1 = 6 %, −24 dB.
const EVEN: f64 = 0.1;
/// Largest such distance that is put right by resampling.
const MOST_UNEVEN: f64 = 0.5;
/// Largest ratio of the longest to the shortest local step of an even record.
const EVEN_ALONG: f64 = 1.02;
/// Rows over which a local step is taken, and places where it is.
const LOCAL: (usize, usize) = (64, 1000);
/// Share of rows behind the one before that may be left out of an uneven record.
const MOST_OVERTAKEN: f64 = 0.05;

/// Rows in the order of rising position, without breaks in it.
#[derive(Debug, PartialEq)]
pub(super) struct Stretch {
    /// Position of the first sample \[m\].
    pub(super) start: f64,
    /// Rows that follow each other without a missing or repeated one, and the samples missing before
    /// each.
    pub(super) rows: Vec<(usize, Range<usize>)>,
}

/// What a column of positions says.
#[derive(Debug)]
pub(super) struct Chainage {
    /// Step between samples \[m\].
    pub(super) spacing: f64,
    /// Whether positions fall from row to row.
    pub(super) falling: bool,
    pub(super) stretches: Vec<Stretch>,
    /// Positions of the rows \[m\], where they are so uneven that heights must be resampled.
    pub(super) uneven: Option<Vec<f64>>,
    /// What was put right, each with the first row.
    pub(super) warnings: Vec<(usize, Message)>,
}

/// Something wrong with some rows.
#[derive(Debug, PartialEq)]
pub(super) struct Defect {
    /// The first row.
    pub(super) row: usize,
    pub(super) message: String,
}

impl Chainage {
    /// Divide rows by their positions \[m\] into stretches of even steps.
    pub(super) fn new(positions: &[f64]) -> Result<Self, Defect> {
        let refuse = |row, message: String| Err(Defect { row, message });
        let (median, falling) = typical_step(positions);
        if !(median.is_finite() && median > 0.0) {
            return refuse(
                1,
                "the position hardly changes from row to row: it repeats or has too few decimals; \
                 --spacing with a --format that names no position reads the heights alone"
                    .to_owned(),
            );
        }
        let sign = if falling { -1.0 } else { 1.0 };
        let unevenness = Unevenness::of(positions, sign * median);
        if unevenness.deviation > MOST_UNEVEN {
            return refuse(
                0,
                format!(
                    "positions are {:.2} mm rms off even steps of {:.3} mm, more than half a step: no profile can be \
                     made of them",
                    1e3 * unevenness.deviation * median,
                    1e3 * median
                ),
            );
        }
        let uneven = unevenness.is_uneven();
        let mut builder = Builder::default();
        let (mut even, even_sum) = builder.divide(positions, sign, median, uneven);
        builder.check_shares(positions.len() as f64)?;
        let overtaken = builder.overtaken.rows;
        // The steps of rows that were left out are in those of others.
        even += overtaken;
        // Positions are rounded by whoever wrote them: no more digits than they can have.
        let spacing = (even_sum / even.max(1) as f64 * 1e9).round() / 1e9;
        if spacing <= 0.0 {
            return refuse(0, format!("the step of {median} m is too small for a profile"));
        }
        let mut warnings = builder.warnings(spacing);
        if uneven {
            let off = fixed(1e3 * unevenness.deviation * median, 2);
            let said = say!(uneven_positions, off, step = fixed(1e3 * spacing, 3));
            warnings.push((0, said));
        }
        Ok(Self {
            spacing,
            falling,
            stretches: builder.stretches,
            uneven: uneven.then(|| positions.to_vec()),
            warnings,
        })
    }
}

/// Median of the sizes of the steps, and whether most fall.
fn typical_step(positions: &[f64]) -> (f64, bool) {
    let stride = (positions.len() / SAMPLE).max(1);
    let steps: Vec<f64> =
        positions.windows(2).step_by(stride).map(|pair| pair[1] - pair[0]).filter(|step| step.is_finite()).collect();
    let falling = 2 * steps.iter().filter(|&&step| step < 0.0).count() > steps.len();
    let mut sizes: Vec<f64> = steps.iter().map(|step| step.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    (sizes.get(sizes.len() / 2).copied().unwrap_or(0.0), falling)
}

/// How far positions are from even ones.
struct Unevenness {
    /// Root mean square of the distances from local straight lines, over the step.
    deviation: f64,
    /// Root mean square of the distances that come of rounding alone.
    rounding: f64,
    /// Ratio of long to short local steps.
    along: f64,
}

impl Unevenness {
    /// Of rows with this typical step \[m\], negative for falling positions. Places with gaps do not count.
    fn of(positions: &[f64], step: f64) -> Self {
        let (length, places) = LOCAL;
        let count = positions.len() / length;
        let (mut deviations, mut slopes) = (Vec::new(), Vec::new());
        let mut quantum = f64::INFINITY;
        for place in (0..count).step_by((count / places).max(1)) {
            let rows = &positions[place * length..(place + 1) * length];
            let mut steps: Vec<f64> = rows.windows(2).map(|pair| (pair[1] - pair[0]) / step).collect();
            if !steps.iter().all(|step| (-1.0..2.5).contains(step)) {
                continue;
            }
            let (slope, deviation) = straight_line(rows);
            deviations.push(deviation / step.abs());
            slopes.push((slope / step).abs());
            // Rounded positions have few different steps.
            steps.sort_by(f64::total_cmp);
            let between = steps.windows(2).map(|pair| pair[1] - pair[0]);
            quantum = between.filter(|step| *step > 1e-3).fold(quantum, f64::min);
        }
        deviations.sort_by(f64::total_cmp);
        slopes.sort_by(f64::total_cmp);
        let at = |values: &[f64], share: f64| values.get((share * values.len() as f64) as usize).copied();
        let ends = at(&slopes, 0.95).zip(at(&slopes, 0.05));
        Self {
            deviation: at(&deviations, 0.5).unwrap_or(0.0),
            rounding: if quantum.is_finite() { quantum / 12f64.sqrt() } else { 0.0 },
            along: ends.map_or(1.0, |(long, short)| long / short.max(f64::MIN_POSITIVE)),
        }
    }

    fn is_uneven(&self) -> bool {
        self.deviation > EVEN.max(1.2 * self.rounding) || self.along > EVEN_ALONG
    }
}

/// Slope of the straight line through values one after the other, and the root mean square of what is off it.
fn straight_line(values: &[f64]) -> (f64, f64) {
    let count = values.len() as f64;
    let centre = (count - 1.0) / 2.0;
    let mean = values.iter().map(|value| value - values[0]).sum::<f64>() / count;
    let (mut products, mut squares) = (0.0, 0.0);
    for (index, value) in values.iter().enumerate() {
        let place = index as f64 - centre;
        products += place * (value - values[0] - mean);
        squares += place * place;
    }
    let slope = products / squares;
    let off = values.iter().enumerate().map(|(index, value)| {
        let line = mean + slope * (index as f64 - centre);
        (value - values[0] - line).powi(2)
    });
    (slope, (off.sum::<f64>() / count).sqrt())
}

/// Rows of one kind of defect.
#[derive(Default)]
struct Count {
    rows: usize,
    first: usize,
}

impl Count {
    fn count(&mut self, row: usize) {
        if self.rows == 0 {
            self.first = row;
        }
        self.rows += 1;
    }
}

#[derive(Default)]
struct Builder {
    stretches: Vec<Stretch>,
    missing: Count,
    repeated: Count,
    filled: Count,
    gaps: Count,
    /// \[m\].
    gap_length: f64,
    back: Count,
    /// Of an uneven record: behind the row before, by less than a step.
    overtaken: Count,
}

impl Builder {
    /// Take up rows by their positions; the number of even steps, and their sum \[m\].
    fn divide(&mut self, positions: &[f64], sign: f64, step: f64, uneven: bool) -> (usize, f64) {
        let longest_step = if uneven { (LONGEST_FILLED / step).max(2.5) } else { 1.5 };
        let mut last: Option<(usize, f64)> = None;
        let (mut even, mut even_sum) = (0usize, 0.0);
        for (row, &position) in positions.iter().enumerate() {
            if !position.is_finite() {
                self.missing.count(row);
                continue;
            }
            let Some((_, before)) = last else {
                self.begin(row, position);
                last = Some((row, position));
                continue;
            };
            let steps = sign * (position - before) / step;
            if uneven && (-1.0..=0.0).contains(&steps) {
                let kind = if steps == 0.0 { &mut self.repeated } else { &mut self.overtaken };
                kind.count(row);
                continue;
            }
            if !uneven && steps.abs() < 0.5 {
                self.repeated.count(row);
                continue;
            }
            if (0.0..longest_step).contains(&steps) {
                even += 1;
                even_sum += steps * step;
                self.go_on(row, 0);
            } else if steps > 0.0 {
                let absent = steps.round() - 1.0;
                if absent * step <= LONGEST_FILLED {
                    self.filled.count(row);
                    self.go_on(row, absent as usize);
                } else {
                    self.gaps.count(row);
                    self.gap_length += (steps - 1.0) * step;
                    self.begin(row, position);
                }
            } else {
                self.back.count(row);
                self.begin(row, position);
            }
            last = Some((row, position));
        }
        (even, even_sum)
    }

    /// Refuse a record of which too many rows are defective.
    fn check_shares(&self, rows: f64) -> Result<(), Defect> {
        for (defects, what) in [
            (&self.missing, "have no position"),
            (&self.repeated, "repeat the position of the row before"),
            (&self.filled, "come after a step of more than one sample"),
            (&self.gaps, "come after a gap or jump of the position"),
            (&self.back, "go back against the direction of the others"),
        ] {
            if defects.rows as f64 > MOST_DEFECTS * rows {
                let share = 100.0 * defects.rows as f64 / rows;
                let message = format!(
                    "{} rows ({share:.1} %) {what}, this one first; up to {:.0} % are put right",
                    defects.rows,
                    100.0 * MOST_DEFECTS
                );
                return Err(Defect { row: defects.first, message });
            }
        }
        let overtaken = self.overtaken.rows;
        if overtaken as f64 > MOST_OVERTAKEN * rows {
            let share = 100.0 * overtaken as f64 / rows;
            let message = format!("{overtaken} rows ({share:.1} %) lie behind the row before, this one first");
            return Err(Defect { row: self.overtaken.first, message });
        }
        Ok(())
    }

    fn begin(&mut self, row: usize, position: f64) {
        self.stretches.push(Stretch { start: position, rows: vec![(0, row..row + 1)] });
    }

    fn go_on(&mut self, row: usize, absent: usize) {
        let Some(stretch) = self.stretches.last_mut() else {
            return;
        };
        match stretch.rows.last_mut() {
            Some((_, rows)) if absent == 0 && rows.end == row => rows.end += 1,
            _ => stretch.rows.push((absent, row..row + 1)),
        }
    }

    fn warnings(&self, spacing: f64) -> Vec<(usize, Message)> {
        let gap = fixed(1e3 * LONGEST_FILLED, 0);
        let length = fixed(self.gap_length.max(spacing), 3);
        let rows = |defects: &Count| defects.rows;
        [
            (&self.missing, say!(rows_without_position, count = rows(&self.missing))),
            (&self.repeated, say!(rows_repeat_position, count = rows(&self.repeated))),
            (&self.filled, say!(rows_after_gap, count = rows(&self.filled), gap)),
            (&self.gaps, say!(rows_after_jump, count = rows(&self.gaps), length)),
            (&self.back, say!(rows_go_back, count = rows(&self.back))),
            (&self.overtaken, say!(rows_behind, count = rows(&self.overtaken))),
        ]
        .into_iter()
        .filter(|(defects, _)| defects.rows > 0)
        .map(|(defects, said)| (defects.first, said))
        .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn positions(count: usize) -> Vec<f64> {
        (0..count).map(|row| 100.0 + 1e-3 * row as f64).collect()
    }

    #[test]
    fn even_steps_are_one_stretch() {
        let chainage = Chainage::new(&positions(5000)).unwrap();
        assert_eq!(chainage.spacing, 1e-3);
        assert_eq!(chainage.stretches.len(), 1);
        assert_eq!(chainage.stretches[0].rows, [(0, 0..5000)]);
        assert!(chainage.warnings.is_empty() && !chainage.falling);
        let falling: Vec<f64> = positions(5000).into_iter().rev().collect();
        assert!(Chainage::new(&falling).unwrap().falling);
    }

    #[test]
    fn defects_are_put_right_and_counted() {
        let mut some = positions(5000);
        some[1000] = some[999];
        some[2000] = f64::NAN;
        some.remove(3000);
        // A gap of 2.5 m.
        some.iter_mut().skip(4000).for_each(|position| *position += 2.5);
        let chainage = Chainage::new(&some).unwrap();
        assert_eq!(chainage.stretches.len(), 2);
        assert_eq!(chainage.stretches[0].rows, [(0, 0..1000), (1, 1001..2000), (1, 2001..3000), (1, 3000..4000)]);
        assert_eq!(chainage.warnings.len(), 4, "{:?}", chainage.warnings);
        assert_eq!(chainage.spacing, 1e-3);
    }

    /// Positions with an error of the encoder of 0.2 mm rms; the true step and the gap stay.
    #[test]
    fn uneven_positions_are_kept_for_resampling() {
        let jitter = |row: usize| 0.28e-3 * (row as f64 * 78.233).sin();
        let mut some: Vec<f64> = (0..6000).map(|row| 100.0 + 1e-3 * row as f64 + jitter(row)).collect();
        some.iter_mut().skip(4000).for_each(|position| *position += 2.5);
        let chainage = Chainage::new(&some).unwrap();
        assert!((chainage.spacing - 1e-3).abs() < 2e-6, "{}", chainage.spacing);
        assert_eq!(chainage.stretches.len(), 2);
        assert_eq!(chainage.uneven.as_deref(), Some(&some[..]));
        let words = chainage.warnings.last().unwrap().1.to_string();
        assert!(words.starts_with("positions are 0.20 mm rms off even steps of 1.000 mm"), "{words}");
        // Samples in time from a trolley that slows down.
        let slower: Vec<f64> = (0..6000).map(|row| 0.02 * (f64::from(row) * 1e-4).sin()).collect();
        let slower: Vec<f64> = slower.iter().map(|x| 50.0 * x).collect();
        assert!(Chainage::new(&slower).unwrap().uneven.is_some());
    }

    /// Positions with too few decimals are rounded and not uneven.
    #[test]
    fn rounded_positions_are_even() {
        let some: Vec<f64> = (0..5000).map(|row| (f64::from(row) * 2.5).round() * 1e-4).collect();
        let chainage = Chainage::new(&some).unwrap();
        assert!(chainage.uneven.is_none());
        assert!((chainage.spacing - 0.25e-3).abs() < 1e-7, "{}", chainage.spacing);
    }

    #[test]
    fn too_many_defects_are_refused_with_the_first() {
        let mut repeated = positions(5000);
        (100..200).for_each(|row| repeated[2 * row] = repeated[2 * row - 1]);
        let error = Chainage::new(&repeated).unwrap_err();
        assert_eq!(error.row, 200);
        assert!(error.message.to_string().contains("100 rows (2.0 %) repeat"), "{error:?}");
        assert!(Chainage::new(&[5.0; 100]).is_err());
        assert!(Chainage::new(&[]).is_err());
    }
}
