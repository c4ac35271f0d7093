//! The arrays of results: names, dimensions, units.

use super::file::{MapQuantity, PointFile};

/// An array of results: one value, or a table of values, for each sample.
#[derive(Debug, Clone, PartialEq)]
pub struct Variable {
    /// Its name.
    pub name: String,
    /// Dimensions after the sample, the last fastest.
    pub dimensions: Vec<Dimension>,
    /// Whether its values are complex.
    pub complex: bool,
    /// SI unit, `1` for none.
    pub unit: &'static str,
    /// What it is.
    pub description: String,
}

/// A dimension of the results besides the sample.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dimension {
    /// Speeds of the map.
    Speed,
    /// Wavelengths of the map.
    Wavelength,
    /// Bands of wavelength.
    Band,
}

impl Dimension {
    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Speed => "speed",
            Self::Wavelength => "wavelength",
            Self::Band => "band",
        }
    }
}

/// The name of the output that may be missing where nothing grows.
pub(super) const RIDGE_FREQUENCY: &str = "ridge_frequency";

/// An array of real numbers: its name, its dimensions after the sample, its unit, and what it is.
pub(super) type Row = (&'static str, &'static [Dimension], &'static str, &'static str);

/// Of the ridge of the map.
pub(super) const RIDGE: &[Row] = &[
    (
        RIDGE_FREQUENCY,
        &[],
        "Hz",
        "frequency that the strongest branch of the ridge follows, missing where nothing grows",
    ),
    ("highest_growth_rate", &[], "1", "highest growth rate per passage in the window"),
    ("highest_growth_wavelength", &[], "m", "wavelength of the highest growth rate"),
    ("highest_growth_speed", &[], "m/s", "speed of the highest growth rate"),
    ("highest_growth_frequency", &[], "Hz", "frequency of the highest growth rate"),
    (
        "highest_growth_at_edge",
        &[],
        "1",
        "1 where the highest growth sits at an end of the window, of wavelengths or of speeds, else 0",
    ),
];

/// Of the ridge at each speed.
pub(super) const RIDGE_OVER_SPEED: &[Row] = &[
    ("ridge_wavelength", &[Dimension::Speed], "m", "wavelength of highest growth at each speed"),
    ("ridge_growth_rate", &[Dimension::Speed], "1", "highest growth rate per passage at each speed"),
    ("ridge_at_edge", &[Dimension::Speed], "1", "1 where the ridge sits at an end of the window, else 0"),
];

/// Of the mean over the speeds.
pub(super) const GROWTH_BY_WAVELENGTH: &[Row] = &[(
    "mean_growth_rate",
    &[Dimension::Wavelength],
    "1",
    "growth rate per passage in the mean over the speeds of the window",
)];

/// Of the bands of wavelength.
pub(super) const GROWTH_BY_BAND: &[Row] = &[(
    "band_growth_rate",
    &[Dimension::Band],
    "1",
    "highest growth rate per passage of the wavelengths of a band, in the mean over the speeds",
)];

/// Under the traffic.
pub(super) const UNDER_TRAFFIC: &[Row] = &[
    ("traffic_growth_rate", &[], "1", "highest growth rate per axle passage under the traffic"),
    ("traffic_growth_wavelength", &[], "m", "wavelength of the highest growth rate under the traffic"),
    (
        "traffic_growth_at_edge",
        &[],
        "1",
        "1 where the highest growth under the traffic sits at an end of the wavelengths, else 0",
    ),
];

const MAP_OF_GROWTH: Row = ("growth_rate", &[Dimension::Speed, Dimension::Wavelength], "1", "growth rate per passage");
const MAP_OF_DISSIPATION: Row = (
    "normalized_dissipation",
    &[Dimension::Speed, Dimension::Wavelength],
    "1",
    "W1/(mu P0 V xi0), growth where its real part is negative",
);

impl Variable {
    pub(super) fn of((name, dimensions, unit, description): &Row) -> Self {
        Self {
            name: (*name).to_owned(),
            dimensions: dimensions.to_vec(),
            complex: false,
            unit,
            description: (*description).to_owned(),
        }
    }

    /// Of a quantity over the whole map.
    pub(super) fn of_map(quantity: &MapQuantity) -> Self {
        match quantity {
            MapQuantity::GrowthRate => Self::of(&MAP_OF_GROWTH),
            MapQuantity::NormalizedDissipation => Self { complex: true, ..Self::of(&MAP_OF_DISSIPATION) },
        }
    }
}

impl PointFile {
    /// The arrays of a point whose names begin with `name`.
    pub(super) fn variables(&self, name: &str) -> impl Iterator<Item = Variable> {
        self.quantities.iter().map(move |quantity| Variable {
            name: format!("{name}_{}", quantity.key()),
            dimensions: Vec::new(),
            complex: quantity.is_complex(),
            unit: quantity.unit(),
            description: format!("{} at {} and {}", quantity.name(), self.wavelength, self.speed),
        })
    }
}
