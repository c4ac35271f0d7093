//! How a level changes from record to record.

use riffel_numerics::normal_distribution::below;

use crate::Error;

/// Fall of a level between two records \[dB\] that no wear makes: the rail was ground between them. Riffel's choice.
pub const FALL_BY_GRINDING: f64 = 3.0;

/// Place of the first record since the rail was last ground, of the falls from each record to the next \[dB\]: behind the last fall of
/// more than [`FALL_BY_GRINDING`]; zero where there is none.
pub fn first_since_ground(falls: impl IntoIterator<Item = f64>) -> usize {
    let falls = falls.into_iter().enumerate();
    let ground = falls.filter(|(_, fall)| *fall > FALL_BY_GRINDING);
    ground.last().map_or(0, |(place, _)| place + 1)
}

/// By how much a rail fell from one record to the next, of the falls of its bands \[dB\]: their median over the bands that moved.
///
/// Bands that moved by 1 dB or less say nothing: stones do not reach waves that are too long, and the floor of an instrument stays. Where
/// fewer than three bands moved, but not all, it is zero: a mark of grinding that fades is one or two bands wide. Of 1000 made-up rails
/// that were ground and 1000 that were not, 95 % or more are told right (a test). Riffel's choice.
pub fn fall_of_bands(falls: impl IntoIterator<Item = f64>) -> f64 {
    const MOVED: f64 = 1.0;
    const LEAST: usize = 3;
    let all: Vec<f64> = falls.into_iter().collect();
    let mut moved: Vec<f64> = all.iter().copied().filter(|fall| fall.abs() > MOVED).collect();
    moved.sort_by(f64::total_cmp);
    let count = moved.len();
    match moved[..] {
        [] => 0.0,
        _ if count < LEAST.min(all.len()) => 0.0,
        _ => 0.5 * (moved[(count - 1) / 2] + moved[count / 2]),
    }
}

/// What time is counted in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TimeUnit {
    /// Years between dated records.
    Year,
    /// Steps between records in their order, for records without dates.
    Record,
}

impl TimeUnit {
    /// In words: "year", "record".
    pub fn name(self) -> &'static str {
        match self {
            Self::Year => "year",
            Self::Record => "record",
        }
    }
}

/// A level at one time.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct TrendPoint {
    /// Name or date of the record.
    pub label: String,
    /// Time in the unit of the course.
    pub time: f64,
    /// Level \[dB re 1 µm\].
    pub level: f64,
    /// Standard deviation of the level by chance \[dB\]; unknown for a single spectrum.
    pub scatter: Option<f64>,
}

/// A straight line through the levels of several records, or of those since the rail was ground.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
#[non_exhaustive]
pub struct LevelTrend {
    /// The records, by time.
    pub points: Vec<TrendPoint>,
    /// Place of the first record of the line: the first of all, or the first since the rail was ground, as it seems.
    pub since: usize,
    /// What time is counted in.
    pub unit: TimeUnit,
    /// The line; `None` if all but one record are from before the rail was ground.
    pub slope: Option<Slope>,
}

/// Change of a level in a unit of time.
#[derive(Debug, Clone, Copy, PartialEq)]
#[must_use]
pub struct Slope {
    /// The change \[dB\].
    pub mean: f64,
    /// Its standard deviation \[dB\].
    pub scatter: f64,
}

impl LevelTrend {
    /// Least squares through two records or more, of equal weight.
    ///
    /// The scatter of the slope is the larger of that which follows from the scatter of the levels and that
    /// which follows from their distance from the line (three records or more). A level whose scatter is
    /// unknown is taken to be good to `ASSUMED_SCATTER`.
    ///
    /// A fall of more than 3 dB, and of more than three times its scatter, is taken for grinding, and the line goes through
    /// the records since the last of them; unless the level falls by more than twice its scatter from every record to the next, three at
    /// least, as that of a mark which fades.
    ///
    /// # Errors
    /// [`Error::Measurement`] for less than two records, or where all are of one time.
    pub fn new(mut points: Vec<TrendPoint>, unit: TimeUnit) -> Result<Self, Error> {
        points.sort_by(|a, b| a.time.total_cmp(&b.time));
        let since = since_ground(&points);
        let slope = Slope::of(&points[since..]);
        match slope.is_none() && since == 0 {
            true => Err(Error::Measurement {
                index: points.len().saturating_sub(1),
                rule: "a course must have records of two times",
            }),
            false => Ok(Self { points, since, unit, slope }),
        }
    }

    /// Scatter of a one-third-octave level of which there is one spectrum only \[dB\]: some dozen metres of
    /// rail at 30 mm. Riffel's choice.
    pub const ASSUMED_SCATTER: f64 = 1.0;

    /// The records of the line.
    pub fn on_line(&self) -> &[TrendPoint] {
        &self.points[self.since..]
    }

    /// By how much the level fell when the rail was ground, if it was \[dB\].
    pub fn fall(&self) -> Option<f64> {
        let before = self.since.checked_sub(1)?;
        Some(self.points[before].level - self.points[self.since].level)
    }

    /// Probability that the level rises, for errors that are normal; `None` if it is not known since the rail was ground.
    pub fn probability_of_rise(&self) -> Option<f64> {
        let Slope { mean, scatter } = self.slope?;
        Some(below(mean / scatter.max(1e-6)))
    }

    /// True where each record is below the one before.
    pub fn falls_every_time(&self) -> bool {
        let mut pairs = self.on_line().windows(2);
        pairs.all(|pair| pair[1].level < pair[0].level)
    }

    /// True where each record is above the one before.
    pub fn rises_every_time(&self) -> bool {
        let mut pairs = self.on_line().windows(2);
        pairs.all(|pair| pair[1].level > pair[0].level)
    }

    /// Time until the level has moved by three times the scatter of one record, in the unit of the course:
    /// when to measure again. `None` if the slope is not known better than its own scatter.
    pub fn until_visible(&self) -> Option<f64> {
        let (last, slope) = (self.points.last()?.known_scatter(), self.slope?);
        (slope.mean.abs() > slope.scatter).then(|| 3.0 * last / slope.mean.abs())
    }
}

impl TrendPoint {
    /// Its scatter, or what is taken for it \[dB\].
    fn known_scatter(&self) -> f64 {
        self.scatter.unwrap_or(LevelTrend::ASSUMED_SCATTER)
    }
}

/// Place of the first record since the rail was ground; zero where it was not.
fn since_ground(points: &[TrendPoint]) -> usize {
    let falls: Vec<(f64, f64)> = points
        .windows(2)
        .map(|pair| {
            let scatter = pair[0].known_scatter().hypot(pair[1].known_scatter());
            (pair[0].level - pair[1].level, scatter)
        })
        .collect();
    let fades = falls.len() > 1 && falls.iter().all(|(fall, scatter)| *fall > 2.0 * scatter);
    let ground = |(fall, scatter): &(f64, f64)| *fall > FALL_BY_GRINDING.max(3.0 * scatter);
    match falls.iter().rposition(ground) {
        Some(last) if !fades => last + 1,
        _ => 0,
    }
}

impl Slope {
    /// The line of least squares; none through less than two times.
    fn of(points: &[TrendPoint]) -> Option<Self> {
        let count = points.len() as f64;
        let mean = |value: &dyn Fn(&TrendPoint) -> f64| points.iter().map(value).sum::<f64>() / count;
        let (time, level) = (mean(&|point| point.time), mean(&|point| point.level));
        let squares: f64 = points.iter().map(|point| (point.time - time).powi(2)).sum();
        if points.len() < 2 || squares <= 0.0 {
            return None;
        }
        let products = points.iter().map(|point| (point.time - time) * (point.level - level));
        let slope = products.sum::<f64>() / squares;
        let known = points.iter().map(|point| ((point.time - time) * point.known_scatter()).powi(2));
        let known = known.sum::<f64>().sqrt() / squares;
        let residuals = points.iter().map(|point| (point.level - level - slope * (point.time - time)).powi(2));
        let left = match points.len() {
            2 => 0.0,
            _ => (residuals.sum::<f64>() / (count - 2.0) / squares).sqrt(),
        };
        Some(Self { mean: slope, scatter: known.max(left) })
    }
}

#[cfg(test)]
pub(super) mod tests {
    use rand_xoshiro::Xoshiro256PlusPlus;
    use rand_xoshiro::rand_core::SeedableRng;

    use super::*;
    use riffel_numerics::random_numbers::{normal, normal_pair};

    /// Levels of one record after the other.
    pub(in crate::diagnosis) fn course(levels: &[f64], scatter: Option<f64>) -> LevelTrend {
        let points = levels.iter().enumerate().map(|(index, &level)| TrendPoint {
            label: index.to_string(),
            time: index as f64,
            level,
            scatter,
        });
        LevelTrend::new(points.collect(), TimeUnit::Record).unwrap()
    }

    #[test]
    fn a_line_is_found_with_its_scatter() {
        let rising = course(&[1.0, 3.0, 5.0, 7.0], Some(0.5));
        let slope = rising.slope.unwrap();
        assert!((slope.mean - 2.0).abs() < 1e-12);
        // σ/√Σ(t − t̄)² = 0.5/√5.
        assert!((slope.scatter - 0.5 / 5f64.sqrt()).abs() < 1e-12);
        assert!(rising.probability_of_rise().unwrap() > 0.999_999 && rising.rises_every_time());
        assert!((rising.until_visible().unwrap() - 0.75).abs() < 1e-12);
        // Residuals ±1 of a flat line scatter more than 0.01 dB lets expect.
        let flat = course(&[1.0, -1.0, 1.0, -1.0], Some(0.01));
        assert!(flat.slope.unwrap().scatter > 0.3);
        assert!(!flat.rises_every_time() && !flat.falls_every_time());
        let even = course(&[0.0, 0.0], None);
        assert!((even.probability_of_rise().unwrap() - 0.5).abs() < 1e-12);
        assert!(even.until_visible().is_none());
    }

    /// 2 dB a record before and after it was ground; a mark that fades is not ground, and of one record since nothing is known.
    #[test]
    fn a_line_begins_anew_where_the_rail_was_ground() {
        let ground = course(&[22.0, 24.0, 8.0, 10.0], Some(0.5));
        assert_eq!((ground.since, ground.fall()), (2, Some(16.0)));
        assert!((ground.slope.unwrap().mean - 2.0).abs() < 1e-12);
        assert!(ground.rises_every_time() && ground.probability_of_rise().unwrap() > 0.99);
        let mark = course(&[20.0, 12.0, 8.0, 6.0], Some(0.5));
        assert_eq!((mark.since, mark.fall()), (0, None));
        assert!(mark.falls_every_time() && mark.probability_of_rise().unwrap() < 0.01);
        let unknown = course(&[24.0, 8.0], Some(0.5));
        assert_eq!((unknown.since, unknown.slope), (1, None));
        assert_eq!(unknown.probability_of_rise(), None);
        assert_eq!(unknown.until_visible(), None);
        // A fall within the scatter of single spectra is none.
        assert_eq!(course(&[5.0, 1.5], None).since, 0);
    }

    /// Of courses of four records that do not change, four in a thousand are taken for ground: three steps, each with the share of a
    /// normal distribution beyond three deviations. A cut of 16 dB is missed or misplaced as rarely.
    #[test]
    fn chance_does_not_grind() {
        const RAILS: usize = 10_000;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(1);
        let (mut ground, mut seen) = (0, 0);
        for _ in 0..RAILS {
            let noise = [0.0; 4].map(|_| normal(&mut random));
            ground += usize::from(course(&noise, Some(1.0)).since > 0);
            let cut = std::array::from_fn::<f64, 4, _>(|k| noise[k] - 16.0 * f64::from(k > 1));
            seen += usize::from(course(&cut, Some(1.0)).since == 2);
        }
        assert!(ground < 60 && seen > RAILS - 60, "{ground} {seen}");
    }

    /// Twelve bands of a rail that was ground, by 7 dB in the mean, but not in one to three coarse bands, with a mark of grinding that rises
    /// in another; of a rail on which corrugation of three to five bands grows by 1 dB to 5 dB, others wear by up to 2 dB, and a mark of
    /// one or two bands fades by 5 dB to 12 dB. Every level is known to 0.7 dB, and two to four bands lie at the floor.
    #[test]
    fn a_ground_rail_is_told_by_its_bands() {
        const RAILS: usize = 1000;
        let mut random = Xoshiro256PlusPlus::seed_from_u64(2);
        let mut between = |low: f64, high: f64| {
            // The phase of a normal pair is even.
            let turn = normal_pair(&mut random).arg() / std::f64::consts::TAU + 0.5;
            low + turn * (high - low)
        };
        let mut errors = Xoshiro256PlusPlus::seed_from_u64(3);
        let (mut seen, mut wrong) = (0, 0);
        for _ in 0..RAILS {
            let floor = between(2.0, 5.0) as usize;
            let coarse = between(1.0, 4.0) as usize;
            let cut = between(5.0, 9.0);
            let ground = (0..12).map(|band| match band {
                _ if band < floor => 0.0,
                _ if band == floor => -6.0,
                _ if band >= 12 - coarse => 0.0,
                _ => cut,
            });
            let ground: Vec<f64> = ground.collect();
            let (first, waves) = (between(5.0, 7.0) as usize, between(3.0, 6.0) as usize);
            let (grows, wears) = (between(1.0, 5.0), between(0.0, 2.0));
            let (mark, fades) = (between(1.0, 3.0) as usize, between(5.0, 12.0));
            let grown = (0..12).map(|band| match band {
                _ if band < floor => 0.0,
                _ if band < floor + mark && band < first => fades,
                _ if (first..first + waves).contains(&band) => -grows,
                _ => wears,
            });
            let grown: Vec<f64> = grown.collect();
            let mut fall = |falls: &[f64]| {
                let noise = |fall: &f64| fall + 0.7 * 2f64.sqrt() * normal(&mut errors);
                fall_of_bands(falls.iter().map(noise).collect::<Vec<_>>())
            };
            seen += usize::from(fall(&ground) > FALL_BY_GRINDING);
            wrong += usize::from(fall(&grown) > FALL_BY_GRINDING);
        }
        assert!(seen > RAILS * 95 / 100 && wrong < RAILS * 5 / 100, "{seen} {wrong}");
        assert_eq!(fall_of_bands([7.0; 7].into_iter().chain([0.2])), 7.0);
        assert_eq!([fall_of_bands([9.0, 0.0, 0.0]), fall_of_bands([])], [0.0; 2]);
        assert_eq!(fall_of_bands([8.0, 6.0]), 7.0);
    }

    #[test]
    fn one_time_is_no_course() {
        let point = TrendPoint { label: String::new(), time: 1.0, level: 0.0, scatter: None };
        assert!(LevelTrend::new(vec![point.clone()], TimeUnit::Year).is_err());
        assert!(LevelTrend::new(vec![point.clone(), point], TimeUnit::Year).is_err());
    }
}
