//! Straight lines through the levels of a section over its surveys.

use riffel::diagnosis::first_since_ground;
use riffel_numerics::normal_distribution::HALF_OF_80;

/// Two surveys no farther apart are repeats \[years\]: in a week no rail grows by what a survey shows.
const REPEATED: f64 = 7.0 / 365.2425;
/// Scatter of a level that is taken at least \[dB\]: repeats of one instrument on one day differ by some tenths.
const LEAST_SCATTER: f64 = 0.5;
/// Standard deviations of an interval of 95 %.
const INTERVAL: f64 = 2.0;
/// Standard deviation over the median deviation of a normal distribution.
const OF_MEDIAN: f64 = 1.4826;

/// A level over time since the rail was last ground.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Trend {
    /// Time \[years\] and level \[dB\], one or more.
    points: Vec<(f64, f64)>,
    /// Points of surveys before it was ground.
    pub(crate) before: usize,
    /// The level that the first point had before, if the rail was ground there \[dB\].
    fell_from: Option<f64>,
}

impl Trend {
    /// Of points in the order of time; none without one.
    pub(crate) fn new(points: &[(f64, f64)]) -> Option<Self> {
        let from = first_since_ground(points.windows(2).map(|pair| pair[0].1 - pair[1].1));
        (!points.is_empty()).then(|| Self {
            points: points[from..].to_vec(),
            before: from,
            fell_from: from.checked_sub(1).map(|last| points[last].1),
        })
    }

    /// Whether nothing but that it was ground is known.
    pub(crate) fn only_ground(&self) -> bool {
        self.points.len() == 1 && self.fell_from.is_some()
    }

    /// By how much the level fell when the rail was ground, if it was \[dB\].
    pub(crate) fn fall(&self) -> Option<f64> {
        Some(self.fell_from? - self.points.first()?.1)
    }

    fn means(&self) -> (f64, f64, f64) {
        let count = self.points.len() as f64;
        let time = self.points.iter().map(|(time, _)| time).sum::<f64>() / count;
        let level = self.points.iter().map(|(_, level)| level).sum::<f64>() / count;
        let spread = self.points.iter().map(|(own, _)| (own - time).powi(2)).sum();
        (time, level, spread)
    }

    /// Slope \[dB a year\]; none of a single date.
    pub(crate) fn growth(&self) -> Option<f64> {
        let (mean, level, spread) = self.means();
        let products = self.points.iter().map(|(time, own)| (time - mean) * (own - level));
        (spread > 0.0).then(|| products.sum::<f64>() / spread)
    }

    /// Half of the interval of 95 % of the slope, at a scatter of each level \[dB\].
    pub(crate) fn growth_error(&self, scatter: f64) -> f64 {
        INTERVAL * scatter / self.means().2.sqrt()
    }

    /// Between what times from the last survey \[years\] the level rises by some decibels, by 80 %, at a scatter of each level; infinite
    /// where it may never do so. None of a single date.
    ///
    /// Of the time t that is true, rise − slope · t is off zero by the scatter of the last level and of the slope, which share that
    /// level: all t at which it is no farther off than that, a quadratic equation (Fieller 1954).
    pub(crate) fn time_80(&self, rise: f64, scatter: f64) -> Option<[f64; 2]> {
        let slope = self.growth()?;
        let (mean, _, spread) = self.means();
        let weight = (self.points.last()?.0 - mean) / spread;
        let square = (HALF_OF_80 * scatter).powi(2);
        let rises = slope.powi(2) - square / spread;
        let half = rise * slope + square * weight;
        let now = rise.powi(2) - square;
        let root = (half.powi(2) - rises * now).max(0.0).sqrt();
        let early = match now > 0.0 {
            true => now / (half + root),
            false => 0.0,
        };
        let late = match rises > 0.0 {
            true => (half + root) / rises,
            false => f64::INFINITY,
        };
        Some([early, late])
    }
}

/// Scatter of a level of one survey \[dB\], by the trends of all sections of a line.
///
/// Of repeats within a week it is the scatter of their differences over √2. Without any it is what surveys of three dates and more
/// leave over their trends, and of two dates the scatter of the changes of all sections about their median, over √2: what most sections
/// have in common is growth.
pub(crate) fn scatter(trends: &[Trend]) -> f64 {
    let (mut repeats, mut changes) = (Vec::new(), Vec::new());
    let (mut left, mut freedom) = (0.0, 0usize);
    for trend in trends {
        for pair in trend.points.windows(2) {
            let change = pair[1].1 - pair[0].1;
            match pair[1].0 - pair[0].0 <= REPEATED {
                true => repeats.push(change.abs()),
                false => changes.push(change),
            }
        }
        if let (Some(growth), 3..) = (trend.growth(), trend.points.len()) {
            let (mean, level, _) = trend.means();
            let off = |(time, own): &(f64, f64)| (own - level - growth * (time - mean)).powi(2);
            left += trend.points.iter().map(off).sum::<f64>();
            freedom += trend.points.len() - 2;
        }
    }
    let found = if !repeats.is_empty() {
        OF_MEDIAN * median(repeats) / 2f64.sqrt()
    } else if freedom > 0 {
        (left / freedom as f64).sqrt()
    } else {
        let middle = median(changes.clone());
        let off = changes.iter().map(|change| (change - middle).abs());
        OF_MEDIAN * median(off.collect()) / 2f64.sqrt()
    };
    found.max(LEAST_SCATTER)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Noise of a standard deviation of one, from a sum of twelve.
    fn noise(seed: &mut u64) -> f64 {
        let mut sum = -6.0;
        for _ in 0..12 {
            *seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            sum += (*seed >> 33) as f64 / (1u64 << 31) as f64;
        }
        sum
    }

    /// Sections of which none grows, at surveys with a scatter of 1.5 dB: it is found by repeats, by trends and by changes, and one in
    /// twenty seems to grow or to shrink.
    #[test]
    fn scatter_is_no_growth() {
        for times in [vec![0.0, 0.01, 1.0], vec![0.0, 0.5, 1.0, 1.5], vec![0.0, 1.0]] {
            let mut seed = 7;
            let trends: Vec<Trend> = (0..2000)
                .map(|_| {
                    let points = times.iter().map(|time| (*time, 0.8 * noise(&mut seed)));
                    Trend::new(&points.collect::<Vec<_>>()).unwrap()
                })
                .collect();
            let found = scatter(&trends);
            assert!((found / 0.8 - 1.0).abs() < 0.15, "{times:?}: {found}");
            let seen = trends
                .iter()
                .filter(|trend| trend.growth().is_some_and(|growth| growth.abs() > trend.growth_error(found)));
            assert!((40..180).contains(&seen.count()), "{times:?}");
        }
    }

    /// All dates count, and those before the rail was ground do not.
    #[test]
    fn a_trend_begins_where_the_rail_was_ground() {
        let trend = Trend::new(&[(0.0, 12.0), (1.0, 1.0), (2.0, 3.5), (3.0, 5.0), (4.0, 7.5)]).unwrap();
        assert_eq!(trend.before, 1);
        // By hand: Σ(t − 2.5)(L) / 5 = (−1.5 · 1 − 0.5 · 3.5 + 0.5 · 5 + 1.5 · 7.5) / 5.
        assert!((trend.growth().unwrap() - 2.1).abs() < 1e-12);
        let ground = Trend::new(&[(0.0, 12.0), (1.0, 1.0)]).unwrap();
        assert!(ground.only_ground() && ground.growth().is_none());
    }

    /// A limit that is 4 dB above a level which rises by 2 dB a year is reached after 2 years: the band of 80 % holds that in 75 to 85 %
    /// of 2000 sections (80 % within three standard errors of the count and what an estimated scatter adds).
    #[test]
    fn the_band_of_80_percent_holds_the_true_time() {
        let mut seed = 11;
        let scatter = 0.6;
        for times in [vec![0.0, 1.5], vec![0.0, 0.7, 1.5], vec![0.0, 0.3, 0.6, 0.9, 1.2, 1.5]] {
            let count = 2000;
            let held = (0..count).filter(|_| {
                let points = times.iter().map(|time| (*time, 2.0 * time + scatter * noise(&mut seed)));
                let points: Vec<(f64, f64)> = points.collect();
                let trend = Trend::new(&points).unwrap();
                let rise = 2.0 * (1.5 + 2.0) - points.last().unwrap().1;
                let [early, late] = trend.time_80(rise, scatter).unwrap();
                early <= 2.0 && 2.0 <= late
            });
            let held = held.count() as f64 / f64::from(count);
            assert!((0.75..0.85).contains(&held), "{times:?}: {held}");
        }
    }
}
