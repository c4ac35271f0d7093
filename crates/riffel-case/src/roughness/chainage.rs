//! Positions along the rail, and where they break off.

use std::ops::Range;

/// Longest run of missing samples that is filled \[m\].
pub(super) const LONGEST_FILLED: f64 = 0.010;
/// Share of rows that may be defective before the file is refused.
const MOST_DEFECTS: f64 = 0.01;
/// Steps of which the median is taken.
const SAMPLE: usize = 100_000;

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
    pub(super) warnings: Vec<Defect>,
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
        let mut builder = Builder::default();
        let mut last: Option<(usize, f64)> = None;
        let (mut even, mut even_sum) = (0usize, 0.0);
        for (row, &position) in positions.iter().enumerate() {
            if !position.is_finite() {
                builder.missing.count(row);
                continue;
            }
            let Some((_, before)) = last else {
                builder.begin(row, position);
                last = Some((row, position));
                continue;
            };
            let steps = sign * (position - before) / median;
            if steps.abs() < 0.5 {
                builder.repeated.count(row);
                continue;
            }
            if (0.5..1.5).contains(&steps) {
                even += 1;
                even_sum += steps * median;
                builder.go_on(row, 0);
            } else if steps > 0.0 {
                let absent = steps.round() - 1.0;
                if absent * median <= LONGEST_FILLED {
                    builder.filled.count(row);
                    builder.go_on(row, absent as usize);
                } else {
                    builder.gaps.count(row);
                    builder.gap_length += (steps - 1.0) * median;
                    builder.begin(row, position);
                }
            } else {
                builder.back.count(row);
                builder.begin(row, position);
            }
            last = Some((row, position));
        }
        let rows = positions.len() as f64;
        for (defects, what) in [
            (&builder.missing, "have no position"),
            (&builder.repeated, "repeat the position of the row before"),
            (&builder.filled, "come after a step of more than one sample"),
            (&builder.gaps, "come after a gap or jump of the position"),
            (&builder.back, "go back against the direction of the others"),
        ] {
            if defects.rows as f64 > MOST_DEFECTS * rows {
                let share = 100.0 * defects.rows as f64 / rows;
                let message = format!(
                    "{} rows ({share:.1} %) {what}, this one first; up to {:.0} % are put right",
                    defects.rows,
                    100.0 * MOST_DEFECTS
                );
                return refuse(defects.first, message);
            }
        }
        // Positions are rounded by whoever wrote them: no more digits than they can have.
        let spacing = (even_sum / even.max(1) as f64 * 1e9).round() / 1e9;
        if spacing <= 0.0 {
            return refuse(
                0,
                format!("the step of {median} m is too small for a profile"),
            );
        }
        let warnings = builder.warnings(spacing);
        Ok(Self {
            spacing,
            falling,
            stretches: builder.stretches,
            warnings,
        })
    }
}

/// Median of the sizes of the steps, and whether most fall.
fn typical_step(positions: &[f64]) -> (f64, bool) {
    let stride = (positions.len() / SAMPLE).max(1);
    let steps: Vec<f64> = positions
        .windows(2)
        .step_by(stride)
        .map(|pair| pair[1] - pair[0])
        .filter(|step| step.is_finite())
        .collect();
    let falling = 2 * steps.iter().filter(|&&step| step < 0.0).count() > steps.len();
    let mut sizes: Vec<f64> = steps.iter().map(|step| step.abs()).collect();
    sizes.sort_by(f64::total_cmp);
    (sizes.get(sizes.len() / 2).copied().unwrap_or(0.0), falling)
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
}

impl Builder {
    fn begin(&mut self, row: usize, position: f64) {
        self.stretches.push(Stretch {
            start: position,
            rows: vec![(0, row..row + 1)],
        });
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

    fn warnings(&self, spacing: f64) -> Vec<Defect> {
        let millimetres = 1e3 * LONGEST_FILLED;
        [
            (&self.missing, "without a position left out".to_owned()),
            (
                &self.repeated,
                "with the position of the row before left out".to_owned(),
            ),
            (
                &self.filled,
                format!("after a gap of up to {millimetres:.0} mm, filled by straight lines"),
            ),
            (
                &self.gaps,
                format!(
                    "after a longer gap or jump, {:.3} m in all, where the record is divided",
                    self.gap_length.max(spacing)
                ),
            ),
            (
                &self.back,
                "where the position goes back, at which the record is divided".to_owned(),
            ),
        ]
        .into_iter()
        .filter(|(defects, _)| defects.rows > 0)
        .map(|(defects, what)| {
            let rows = if defects.rows == 1 { "row" } else { "rows" };
            Defect {
                row: defects.first,
                message: format!("{} {rows} {what}", defects.rows),
            }
        })
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
        some.iter_mut()
            .skip(4000)
            .for_each(|position| *position += 2.5);
        let chainage = Chainage::new(&some).unwrap();
        assert_eq!(chainage.stretches.len(), 2);
        assert_eq!(
            chainage.stretches[0].rows,
            [
                (0, 0..1000),
                (1, 1001..2000),
                (1, 2001..3000),
                (1, 3000..4000)
            ]
        );
        assert_eq!(chainage.warnings.len(), 4, "{:?}", chainage.warnings);
        assert_eq!(chainage.spacing, 1e-3);
    }

    #[test]
    fn too_many_defects_are_refused_with_the_first() {
        let mut repeated = positions(5000);
        (100..200).for_each(|row| repeated[2 * row] = repeated[2 * row - 1]);
        let error = Chainage::new(&repeated).unwrap_err();
        assert_eq!(error.row, 200);
        assert!(
            error.message.contains("100 rows (2.0 %) repeat"),
            "{error:?}"
        );
        assert!(Chainage::new(&[5.0; 100]).is_err());
        assert!(Chainage::new(&[]).is_err());
    }
}
