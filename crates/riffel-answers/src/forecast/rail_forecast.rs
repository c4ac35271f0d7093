//! The rails of a track under one traffic: growth is the same for all, the levels now are those of each.

use riffel::forecast::{Forecast, Reach, TrafficGrowth};
use riffel::roughness::LevelLimit;
use riffel_rail::RailSpectrum;

/// The forecast of a rail.
#[derive(Debug, Clone, PartialEq)]
pub struct RailForecast {
    /// The rail with all its levels now, bands that are not forecast included.
    pub measured: RailSpectrum,
    /// Its forecast.
    pub forecast: Forecast,
    /// When its first band reaches the limit; none where no limit was given.
    pub reach: Option<Reach>,
}

impl RailForecast {
    /// The forecasts of all rails that have a band in common with the traffic. The rail that leads is first: the one
    /// that reaches the limit first; where none does, the one whose wheel leaves the rail first before that; else
    /// and where both do so now, the one that is highest over the limit.
    ///
    /// # Errors
    /// [`riffel::Error::Measurement`] where no rail has a band in common with the traffic.
    pub fn of_rails(
        rails: &[RailSpectrum],
        growth: &TrafficGrowth,
        limit: Option<&LevelLimit>,
    ) -> Result<Vec<Self>, riffel::Error> {
        let mut found = Vec::new();
        let mut refused = None;
        for measured in rails {
            match Forecast::new(&measured.spectrum, growth.clone()) {
                Ok(forecast) => found.push(Self {
                    reach: limit.map(|limit| forecast.grinding_interval(limit)),
                    measured: measured.clone(),
                    forecast,
                }),
                Err(error) => refused = Some(error),
            }
        }
        if let (true, Some(error)) = (found.is_empty(), refused) {
            return Err(error);
        }
        let order = |one: &Self| {
            let (passages, end) = match one.reach {
                Some(Reach::After(passages)) => (passages, f64::INFINITY),
                Some(Reach::BeyondLinearRange) => (f64::INFINITY, one.forecast.valid_to()),
                Some(Reach::Never) | None => (f64::INFINITY, f64::INFINITY),
            };
            [passages, end, -one.excess(limit)]
        };
        found.sort_by(|a, b| {
            let pairs = order(a).into_iter().zip(order(b));
            pairs.fold(std::cmp::Ordering::Equal, |so_far, (a, b)| {
                so_far.then(a.total_cmp(&b))
            })
        });
        Ok(found)
    }

    /// Name of the rail.
    pub fn name(&self) -> Option<&str> {
        self.measured.rail.as_deref()
    }

    /// The highest level now over the limit \[dB\], or over 1 µm where there is no limit.
    fn excess(&self, limit: Option<&LevelLimit>) -> f64 {
        let bands = self.forecast.bands().iter();
        let over = bands.filter_map(|band| {
            let limit = match limit {
                Some(limit) => limit.spectrum().level(band.now.band)?,
                None => 0.0,
            };
            Some(band.now.level - limit)
        });
        over.fold(f64::NEG_INFINITY, f64::max)
    }
}
