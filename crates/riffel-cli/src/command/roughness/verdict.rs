//! Roughness held against limit tables.

use riffel::roughness::{BandSummary, Spectrum};
use riffel_case::roughness::{Limit, LimitTable};
use serde::Serialize;

/// What a limit table says of a record.
#[derive(Clone, Serialize)]
pub(super) struct Verdict {
    /// Name of the table.
    limit: String,
    edition: String,
    source: String,
    within: bool,
    pub(super) sentence: String,
}

impl Verdict {
    fn new(table: &LimitTable, within: bool, rest: &str) -> Self {
        let verdict = if within { "within" } else { "over" };
        Self {
            limit: table.name.clone(),
            edition: table.edition.clone(),
            source: table.source.clone(),
            within,
            sentence: format!("{}: {verdict} the limit, {rest}", table.edition),
        }
    }

    /// The verdict with the name of what it is on.
    pub(super) fn of(mut self, name: &str) -> Self {
        if name != "all" {
            self.sentence = format!("{name}: {}", self.sentence);
        }
        self
    }

    /// The verdicts of all tables that have something to say of a spectrum and its bands.
    pub(super) fn all(
        tables: &[LimitTable],
        spectrum: &Spectrum,
        bands: &[BandSummary],
    ) -> Vec<Self> {
        let verdicts = tables.iter().map(|table| match &table.limit {
            Limit::Levels(limit) => {
                let compared = limit.compare(spectrum);
                let all = limit.spectrum().levels().len();
                let over = compared.iter().filter(|band| band.excess() > 0.0);
                let worst = compared
                    .iter()
                    .max_by(|a, b| a.excess().total_cmp(&b.excess()))?;
                let (excess, wavelength) = (worst.excess(), worst.band.nominal_millimetres());
                let count = over.count();
                let measured = match compared.len() {
                    measured if measured == all => format!("{all} bands"),
                    measured => format!("{measured} bands that were measured, of {all}"),
                };
                let rest = if count == 0 {
                    let room = -excess;
                    format!("{measured}; {room:.1} dB are left at {wavelength} mm")
                } else {
                    format!("{count} of {measured}, at worst by {excess:.1} dB at {wavelength} mm")
                };
                Some(Self::new(table, count == 0, &rest))
            }
            Limit::Rms(limit) => {
                let judged: Vec<(&BandSummary, f64)> = bands
                    .iter()
                    .filter(|band| limit.of(band.band).is_some())
                    .filter_map(|band| Some((band, band.share_over_limit?)))
                    .collect();
                let worst = judged.iter().max_by(|a, b| a.1.total_cmp(&b.1))?;
                let within = worst.1 <= limit.share();
                let shares: Vec<String> = judged
                    .iter()
                    .map(|(band, share)| format!("{} mm {:.1} %", millimetres(band), 100.0 * share))
                    .collect();
                let allowed = 100.0 * limit.share();
                let rest = format!(
                    "{allowed:.0} % of the length may be over; {}",
                    shares.join(", ")
                );
                Some(Self::new(table, within, &rest))
            }
        });
        verdicts.flatten().collect()
    }
}

fn millimetres(band: &BandSummary) -> String {
    format!("{:.0}–{:.0}", 1e3 * band.band.from(), 1e3 * band.band.to())
}
