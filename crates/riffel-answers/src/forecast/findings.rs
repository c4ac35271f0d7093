//! What a forecast finds, in sentences.

use riffel::forecast::Reach;
use riffel_case::traffic::SpreadEffect;
use riffel_keys::{Message, fixed, number as numeral, say};

use super::ForecastAnswer;
use super::damage::{CrackedWave, HardenedWave};
use super::rail_forecast::RailForecast;
use super::words::number;

/// What a spread does, where it is worth a word.
fn spread_in_words(spread: &SpreadEffect) -> Option<String> {
    /// Less is no reduction to speak of.
    const WORTH_A_WORD: f64 = 1.05;
    let reduction = spread
        .reduction
        .filter(|reduction| *reduction >= WORTH_A_WORD)?;
    let what = match &*spread.what {
        "speed" => say!(spread_of_speed),
        "wheel_radius" => say!(spread_of_wheel_radius),
        "load" => say!(spread_of_load),
        "friction" => say!(spread_of_friction),
        "lateral_position" => say!(spread_of_position),
        key => say!(spread_of_key, key = key),
    };
    let factor = match reduction < 10.0 {
        true => fixed(reduction, 1),
        false => fixed(reduction, 0),
    };
    let vehicle = &spread.vehicle;
    Some(
        say!(
            spread_takes_down,
            vehicle = vehicle,
            what = what,
            factor = factor
        )
        .to_string(),
    )
}

impl ForecastAnswer {
    /// Between which months the leading rail reaches its limit, by what the wear coefficient may be.
    fn months_within(&self) -> Option<String> {
        let crossings = self.crossings(self.leading());
        let months = self.months(crossings.first()?.passages)?;
        let [early, late] = self.wear_spread?.band_80(months).map(number);
        (months > 0.0).then(|| say!(months_within, early = early, late = late).to_string())
    }

    /// Between what the fastest growth lies, by what the wear coefficient may be.
    fn fastest_within(&self) -> Option<String> {
        let (band, rate) = self.fastest().filter(|(_, rate)| *rate > 0.0)?;
        let spread = self.wear_spread?;
        let wavelength = numeral(band.now.band.nominal_millimetres());
        let [low, high] = spread.band_80(rate).map(number);
        let said = match self.on.passages_per_month() {
            None => say!(
                grows_within,
                wavelength = wavelength,
                low = low,
                high = high
            ),
            Some(passages) => {
                let a_month = spread.band_80(1e-6 * passages * rate);
                let [low_a_month, high_a_month] = a_month.map(number);
                say!(
                    grows_within_a_month,
                    wavelength = wavelength,
                    low = low,
                    high = high,
                    low_a_month = low_a_month,
                    high_a_month = high_a_month
                )
            }
        };
        Some(said.to_string())
    }

    /// What hardening and cracks make of the waves of the rail that leads.
    pub(crate) fn damage_in_words(&self) -> impl Iterator<Item = Message> {
        let hardened = HardenedWave::in_words(&self.leading().forecast);
        let cracked = CrackedWave::in_words(&self.cracks(), &self.on, self.until());
        hardened.into_iter().chain(cracked)
    }

    /// What follows, in sentences; those on the rail that leads first.
    pub fn findings(&self) -> Vec<String> {
        let mut findings: Vec<String> = self
            .rails
            .iter()
            .enumerate()
            .map(|(place, rail)| {
                let sentence = self.interval(rail);
                match (self.prefix(rail).trim_end(), place) {
                    ("", _) => sentence,
                    (name, 0) => format!("{name} leads: {sentence}"),
                    (name, _) => format!("{name}: {sentence}"),
                }
            })
            .collect();
        // Of the rail that leads, which is the first.
        findings.splice(1..1, self.months_within());
        findings.extend(self.rails.iter().map(|rail| {
            let sentence = self.linear_range(rail);
            match self.prefix(rail).trim_end() {
                "" => sentence,
                name => format!("{name}: {sentence}"),
            }
        }));
        let decays = |rail: &RailForecast| {
            let mut bands = rail.forecast.bands().iter();
            bands.any(|band| rail.forecast.growth_rate(band) < 0.0)
        };
        if self.rails.iter().any(decays) {
            findings.push(say!(decaying_bands_stay).to_string());
        }
        findings.extend(self.fastest_within());
        findings.extend(self.damage_in_words().map(|said| said.to_string()));
        findings.extend(self.bend());
        findings.extend(self.spreads.iter().filter_map(spread_in_words));
        let left_out = self.left_out();
        if let (Some(first), Some(last)) = (left_out.first(), left_out.last()) {
            findings.push(format!(
                "not forecast: {} bands from {first} to {last} mm that lie outside map.wavelength of the case",
                left_out.len()
            ));
        }
        findings
    }

    /// Which band of the leading rail bends over first, if one does before the end of the forecast.
    fn bend(&self) -> Option<String> {
        let bands = self.leading().forecast.bands().iter();
        let bends = bands.filter_map(|band| Some((band, band.bends_after()?)));
        let (band, passages) = bends.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let wear = self.growth().mean_wear();
        (passages <= self.passages).then(|| {
            say!(
                band_bends_over,
                wavelength = numeral(band.now.band.nominal_millimetres()),
                passages = number(passages),
                wear = fixed(1e3 * wear.depth_per_100_mgt(), 2)
            )
            .to_string()
        })
    }

    /// When a rail reaches the limit.
    fn interval(&self, rail: &RailForecast) -> String {
        let edition = &self.table.edition;
        let from = match &self.ground {
            Some(ground) => format!(" from {}", ground.words),
            None => String::new(),
        };
        match (self.crossings(rail).first(), rail.reach) {
            (Some(first), _) if first.passages == 0.0 => format!(
                "over the limit now: {edition} at {} mm by {:.1} dB",
                first.band.now.band.nominal_millimetres(),
                first.band.now.level - first.limit
            ),
            (Some(first), _) => format!(
                "grinding interval{from}: {edition} is reached at {} mm after {}",
                first.band.now.band.nominal_millimetres(),
                self.amount(first.passages)
            ),
            (None, Some(Reach::Never)) => format!("no band forecast ever reaches {edition}"),
            (None, _) => format!(
                "grinding interval{from}: {edition} is not reached before the wheel leaves the rail, where the forecast \
                 ends"
            ),
        }
    }

    /// How far the linear loop holds on a rail.
    pub(super) fn linear_range(&self, rail: &RailForecast) -> String {
        let linear = rail.forecast.linear_range(rail.forecast.bands());
        let vehicle = &self.growth().vehicles()[linear.vehicle].name;
        match linear.passages {
            Some(0.0) => format!(
                "beyond the linear range now: |P₁| is {:.2} P₀ under \"{vehicle}\", so that wheel and rail part; \
                 corrugation then grows otherwise than the linear loop says, and nothing is forecast",
                linear.force_ratio
            ),
            Some(passages) => format!(
                "linear range: |P₁| is {:.2} P₀ now and reaches P₀ under \"{vehicle}\" after {}; there the wheel \
                 leaves the rail, and the forecast ends",
                linear.force_ratio,
                self.amount(passages)
            ),
            None => format!(
                "linear range: |P₁| is {:.2} P₀ now under \"{vehicle}\" and never reaches P₀",
                linear.force_ratio
            ),
        }
    }
}
