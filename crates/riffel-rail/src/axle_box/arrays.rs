//! What axle boxes felt, as arrays.

use riffel_keys::CaseError;

use super::head::{PlaceBy, Row};

/// Where the train was while its axle boxes were listened to.
#[derive(Debug, Clone, PartialEq)]
pub enum AxleBoxPlace {
    /// A speed that stays the same \[m/s\].
    Constant(f64),
    /// A speed for each sample \[m/s\].
    Speed(Vec<f64>),
    /// A reading of the odometer for each sample \[m\].
    Odometer(Vec<f64>),
}

impl AxleBoxPlace {
    pub(super) fn by(&self) -> PlaceBy {
        match self {
            Self::Constant(speed) => PlaceBy::Constant(*speed),
            Self::Speed(_) => PlaceBy::Speed,
            Self::Odometer(_) => PlaceBy::Odometer,
        }
    }

    /// One value for each sample, if there are any.
    pub(super) fn values(&self) -> Option<&[f64]> {
        match self {
            Self::Constant(_) => None,
            Self::Speed(values) | Self::Odometer(values) => Some(values),
        }
    }
}

/// Samples of every channel, with the place.
#[derive(Debug)]
pub(super) struct AxleBoxArrays {
    pub(super) channels: Vec<Vec<f64>>,
    pub(super) place: AxleBoxPlace,
}

impl AxleBoxArrays {
    /// Hand on sample by sample; `progress` is told of samples done.
    pub(super) fn each(
        &self,
        take: &mut dyn FnMut(&Row<'_>) -> Result<(), CaseError>,
        progress: &dyn Fn(usize),
    ) -> Result<(), CaseError> {
        let place = self.place.values();
        let mut accelerations = vec![0.0; self.channels.len()];
        for index in 0..self.channels[0].len() {
            for (acceleration, channel) in accelerations.iter_mut().zip(&self.channels) {
                *acceleration = channel[index];
            }
            take(&Row {
                accelerations: &accelerations,
                time: None,
                place: place.map_or(f64::NAN, |values| values[index]),
                witness: f64::NAN,
                marked: None,
                number: index + 1,
            })?;
            progress(1);
        }
        Ok(())
    }
}
