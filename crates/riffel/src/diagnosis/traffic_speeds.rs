//! The speeds at which trains pass.

use crate::Error;

/// Speeds with their shares of the passages.
#[derive(Debug, Clone, PartialEq)]
pub struct TrafficSpeeds {
    /// Speed \[m/s\] and share, by speed; shares add up to one.
    shares: Vec<(f64, f64)>,
    /// Speeds and shares over which growth is averaged, where they are others.
    of_growth: Option<Vec<(f64, f64)>>,
}

impl TrafficSpeeds {
    /// Speeds \[m/s\] with their weights, in any order and of any sum.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless there is a speed, each is above zero and each weight, too.
    pub fn new(speeds: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, Error> {
        let mut shares: Vec<(f64, f64)> = speeds.into_iter().collect();
        for &(speed, weight) in &shares {
            Error::unless_positive("speed", speed, "m/s")?;
            Error::unless_positive("weight of a speed", weight, "")?;
        }
        let sum: f64 = shares.iter().map(|share| share.1).sum();
        Error::unless_positive("sum of the weights of the speeds", sum, "")?;
        shares.sort_by(|a, b| a.0.total_cmp(&b.0));
        for share in &mut shares {
            share.1 /= sum;
        }
        Ok(Self { shares, of_growth: None })
    }

    /// Speeds from one to another \[m/s\], evenly; one speed where the two are the same.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn between(slowest: f64, fastest: f64) -> Result<Self, Error> {
        /// Enough that their steps are below every spread of a frequency, up to a ratio of three.
        const STEPS: u32 = 60;
        if slowest == fastest {
            return Self::new([(slowest, 1.0)]);
        }
        let step = (fastest - slowest) / f64::from(STEPS);
        Self::new((0..=STEPS).map(|index| (slowest + step * f64::from(index), 1.0)))
    }

    /// Speeds of several ranges from one to another \[m/s\], each range as common as any other.
    ///
    /// # Errors
    /// Errors of [`new`](Self::new).
    pub fn of_ranges(ranges: impl IntoIterator<Item = (f64, f64)>) -> Result<Self, Error> {
        let mut shares = Vec::new();
        for (slowest, fastest) in ranges {
            shares.extend(Self::between(slowest, fastest)?.shares);
        }
        Self::new(shares)
    }

    /// Speeds with growth in the mean over those of a traffic: its normal distribution stands for an even range.
    #[must_use]
    pub fn growing_under(self, traffic: Self) -> Self {
        Self { of_growth: Some(traffic.shares), ..self }
    }

    /// Each speed \[m/s\] over which growth is averaged, with its share.
    pub fn of_growth(&self) -> &[(f64, f64)] {
        self.of_growth.as_ref().unwrap_or(&self.shares)
    }

    /// Each speed \[m/s\] with its share.
    pub fn shares(&self) -> &[(f64, f64)] {
        &self.shares
    }

    /// The lowest \[m/s\].
    pub fn slowest(&self) -> f64 {
        self.shares.first().map_or(f64::NAN, |share| share.0)
    }

    /// The highest \[m/s\].
    pub fn fastest(&self) -> f64 {
        self.shares.last().map_or(f64::NAN, |share| share.0)
    }

    /// The mean \[m/s\].
    pub fn mean(&self) -> f64 {
        self.shares.iter().map(|(speed, share)| speed * share).sum()
    }

    /// The speeds in words: "136 km/h", "99–141 km/h".
    pub fn words(&self) -> String {
        let (low, high) = (3.6 * self.slowest(), 3.6 * self.fastest());
        if high - low < 0.5 { format!("{low:.0} km/h") } else { format!("{low:.0}–{high:.0} km/h") }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_add_up() -> Result<(), Error> {
        let speeds = TrafficSpeeds::new([(30.0, 1.0), (10.0, 3.0)])?;
        assert_eq!(speeds.shares(), [(10.0, 0.75), (30.0, 0.25)]);
        assert_eq!(speeds.mean(), 15.0);
        assert_eq!(speeds.words(), "36–108 km/h");
        let mixed = TrafficSpeeds::of_ranges([(10.0, 10.0), (20.0, 40.0)])?;
        let first = mixed.shares()[0];
        assert!(first.0 == 10.0 && (first.1 - 0.5).abs() < 1e-12);
        assert_eq!(mixed.shares().len(), 62);
        let even = TrafficSpeeds::between(20.0, 40.0)?;
        assert!((even.mean() - 30.0).abs() < 1e-12);
        assert_eq!(even.fastest(), 40.0);
        assert!(TrafficSpeeds::new([]).is_err());
        assert!(TrafficSpeeds::between(-1.0, 2.0).is_err());
        Ok(())
    }
}
