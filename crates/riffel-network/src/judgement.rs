//! The bands of a store against a limit of RMS.

use riffel::roughness::{RmsLimit, WavelengthBand};
use riffel_rail::{Limit, LimitTable};

use crate::store::in_words;
use crate::{NetworkError, Store};

/// How far sections are over a limit.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// Name of the limit table.
    pub limit: String,
    /// Bands of the store.
    pub bands: Vec<WavelengthBand>,
    /// Limit of the RMS in each band \[m\]; none where the table says nothing.
    limits: Vec<Option<f64>>,
}

impl Judgement {
    /// A limit table on the bands of a store.
    ///
    /// # Errors
    /// [`NetworkError::Limit`] for a table of levels, or without a band of the store.
    pub fn new(store: &Store, table: &LimitTable) -> Result<Self, NetworkError> {
        let bands = store.bands()?;
        let wrong = |reason: String| {
            Err(NetworkError::Limit {
                name: table.name.clone(),
                reason,
            })
        };
        let Limit::Rms(limit) = &table.limit else {
            return wrong(
                "is one of levels, but a store holds RMS in bands of wavelength".to_owned(),
            );
        };
        let limits: Vec<Option<f64>> = bands.iter().map(|band| of_band(limit, band)).collect();
        if limits.iter().all(Option::is_none) {
            let held: Vec<[f64; 2]> = bands.iter().map(|band| [band.from(), band.to()]).collect();
            let held = in_words(&held);
            return wrong(format!("says nothing of the bands of the store, {held}"));
        }
        Ok(Self {
            limit: table.name.clone(),
            bands,
            limits,
        })
    }

    /// RMS over limit in each band; none where one of the two is not known.
    pub(crate) fn ratios<'a>(&'a self, rms: &'a [f64]) -> impl Iterator<Item = Option<f64>> + 'a {
        rms.iter().zip(&self.limits).map(|(rms, limit)| {
            limit
                .map(|limit| rms / limit)
                .filter(|ratio| ratio.is_finite())
        })
    }

    /// The band that is farthest over its limit, and RMS over limit there.
    pub(crate) fn worst(&self, rms: &[f64]) -> Option<(usize, f64)> {
        let ratios = self.ratios(rms).enumerate();
        let ratios = ratios.filter_map(|(band, ratio)| Some((band, ratio?)));
        ratios.max_by(|a, b| a.1.total_cmp(&b.1))
    }
}

fn of_band(limit: &RmsLimit, band: &WavelengthBand) -> Option<f64> {
    let same = |a: f64, b: f64| (a / b - 1.0).abs() < 1e-9;
    let mut bands = limit.bands().iter();
    let found =
        bands.find(|(other, _)| same(other.from(), band.from()) && same(other.to(), band.to()));
    found.map(|(_, rms)| *rms)
}
