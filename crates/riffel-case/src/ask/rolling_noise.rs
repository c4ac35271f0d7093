//! What a case says of the sound of a wheel on its rail.

use riffel::{Error, Loop, STEEL_DENSITY};
use riffel_keys::{Message, say};
use riffel_noise::{
    Air, BandRadiation, FrequencyBand, OscillatingCylinder, OscillatingSphere, Piston, RailDecay, RollingSource,
    Sleepers, WheelModes,
};

use crate::{Case, Track};

/// Width of a wheel across its tread \[m\], that of the profiles of EN 13715.
const WHEEL_WIDTH: f64 = 0.135;
/// Area of the 60E1 section \[m²\], for a rail of which nothing is known but its receptance.
const RAIL_AREA: f64 = 76.7e-4;
/// Distance of sleepers \[m\] where a model has them spread evenly.
const SLEEPER_SPACING: f64 = 0.6;

/// Rail and sleepers as radiators: what a case does not say of them.
#[derive(Debug, Clone, PartialEq)]
pub struct TrackRadiator {
    /// Breadth of the rail foot \[m\].
    pub rail_foot: f64,
    /// Face of a sleeper that belongs to one rail \[m²\].
    pub sleeper_area: f64,
    /// Bands with their decay rates \[dB/m\], in place of those of the case.
    pub decay_rate: Option<Vec<(FrequencyBand, f64)>>,
}

impl Default for TrackRadiator {
    /// A rail with a foot of 150 mm on sleepers of which 0.33 m² belong to each rail, which decays as the case says.
    fn default() -> Self {
        Self { rail_foot: 0.15, sleeper_area: 0.33, decay_rate: None }
    }
}

impl TrackRadiator {
    /// What a wheel on the rail of a case makes of any roughness at a speed \[m/s\], in those of some bands that are known: loop and
    /// track are those of the case, or have other numbers.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] where rail foot, sleeper or wheel have no size.
    pub fn bands(
        &self,
        case: &Case,
        feedback: &Loop,
        track: &Track,
        wheel_modes: Option<&WheelModes>,
        speed: f64,
        bands: impl Iterator<Item = FrequencyBand>,
    ) -> Result<Vec<BandRadiation>, Error> {
        let file = &case.file;
        let area = match (file.rail.area, track.rail_mass) {
            (Some(area), _) => area.si(),
            (None, Some(mass)) => mass / file.rail.density.map_or(STEEL_DENSITY, |rho| rho.si()),
            (None, None) => RAIL_AREA,
        };
        let spacing = file.track.support_spacing.map(|spacing| spacing.si());
        let face = Piston::new(self.sleeper_area)?;
        let source = RollingSource {
            feedback,
            decay: match (&self.decay_rate, track.structure.as_deref()) {
                (None, Some(track)) => RailDecay::Track(track),
                (rates, track) => RailDecay::Rates { rates: rates.clone().unwrap_or_default(), track },
            },
            rail: OscillatingCylinder::of_rail(self.rail_foot, area)?,
            sleepers: track.support.map(|support| Sleepers {
                support,
                face,
                spacing: spacing.unwrap_or(SLEEPER_SPACING),
            }),
            wheel: OscillatingSphere::of_wheel(case.hertz.rolling_radius(), WHEEL_WIDTH)?,
            wheel_modes,
            air: Air::default(),
        };
        let (lowest, highest) = case.known_frequencies();
        let known = bands.filter(|band| {
            let (low, high) = band.range();
            low >= lowest && high <= highest
        });
        Ok(known.filter_map(|band| source.radiation(band, speed)).collect())
    }
}

/// Why the track has no level of its own, if it has none: nothing is known of how far its rail carries vibration, or it carries
/// it further than a length can be told, at every frequency, so that the level would be that of where the length is cut.
pub fn without_decay(case: &Case) -> Option<Message> {
    let model = case.file.track.model.name();
    let Some(track) = case.track.structure.as_deref() else {
        return Some(say!(track_model_says_what_the_rail, model));
    };
    let runs_on = FrequencyBand::all().all(|band| RailDecay::runs_on(track, band.centre()));
    runs_on.then(|| say!(the_rail_of_track_model_carries, model))
}
