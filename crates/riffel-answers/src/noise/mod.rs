//! Rolling noise of a train on a rough rail, and what would make it quieter.

mod course;
mod document;
mod figure;
mod levels;
mod measure;
mod range;

use riffel_keys::{Message, Value, fixed, number, say};
use std::io::{self, Write};

use riffel::STEEL_DENSITY;
use riffel::contact::ContactFilter;
use riffel::noise::{
    Air, Excitation, FrequencyBand, OscillatingCylinder, OscillatingSphere, PassBy, Piston,
    RailDecay, RollingSource, Sleepers, SoundPower, Surroundings, WheelModes,
};
use riffel::roughness::{LevelLimit, Spectrum};
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_plot::LineFigure;
use riffel_rail::{LimitTable, TransferTable, WheelModesTable};

pub use course::Course;
pub use document::NoiseDocument;
pub use levels::{BandPressure, Part, PassByLevels, PowerLevels};
pub use measure::Measure;

use crate::AnswerError;

/// Width of a wheel across its tread \[m\], that of the profiles of EN 13715.
const WHEEL_WIDTH: f64 = 0.135;
/// Area of the 60E1 section \[m²\], for a rail of which nothing is known but its receptance.
const RAIL_AREA: f64 = 76.7e-4;
/// Distance of pass-by measurements up to which what absorbs is left out by the field \[m\]: ISO 3095 measures at 7.5 and 25 m.
const FAR: f64 = 25.0;
/// Difference of radii up to which modes are taken to be those of the wheel.
const LARGEST_DIFFERENCE: f64 = 0.05;
/// Distance of sleepers \[m\] where a model has them spread evenly.
const SLEEPER_SPACING: f64 = 0.6;

/// A train past a receiver.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Train {
    /// Wheels on one rail.
    pub wheels: u32,
    /// Length \[m\].
    pub length: f64,
    /// Distance of the receiver from the middle of the track \[m\].
    pub distance: f64,
    /// Height of the receiver over the rail head \[m\].
    pub height: f64,
    /// What is around it.
    pub surroundings: Surroundings,
}

impl Train {
    /// Length of train to a wheel on one rail \[m\]: a coach of 26.4 m on four wheelsets (UIC 567).
    pub const LENGTH_PER_WHEEL: f64 = 6.6;
}

/// The rail in months to come.
pub struct Future {
    /// The traffic.
    pub traffic: Traffic,
    /// How far to look ahead \[months\].
    pub months: f64,
    /// Highest level that is allowed \[dB(A)\].
    pub limit: Option<f64>,
}

/// What is asked.
pub struct NoiseRequest {
    /// Speed of the train \[m/s\].
    pub speed: f64,
    /// Roughness of the rail.
    pub roughness: Spectrum,
    /// Roughness of the wheels, with its name; none for smooth ones.
    pub wheels: Option<(String, Spectrum)>,
    /// Modes of the web and tyre of the wheels; none for rigid ones.
    pub wheel_modes: Option<WheelModesTable>,
    /// Measured decay rates of the track \[dB/m\], in place of those of the model.
    pub decay: Option<Vec<(FrequencyBand, f64)>>,
    /// Transfer functions of track and vehicle, for the level by the directive beside that by the model.
    pub transfer: Option<[TransferTable; 2]>,
    /// What the rail may be ground to.
    pub limit: (LimitTable, LevelLimit),
    /// The train.
    pub train: Train,
    /// Breadth of the rail foot \[m\].
    pub rail_foot: f64,
    /// Face of a sleeper that belongs to one rail \[m²\].
    pub sleeper_area: f64,
    /// What becomes of the rail.
    pub future: Option<Future>,
}

impl NoiseRequest {
    /// A coach on four wheelsets with smooth wheels, 7.5 m from the track and 1.2 m above the rail, as ISO 3095 measures, on a rail
    /// with a foot of 150 mm and sleepers of which 0.33 m² belong to each rail.
    pub fn of_a_coach(speed: f64, roughness: Spectrum, limit: (LimitTable, LevelLimit)) -> Self {
        const WHEELS: u32 = 4;
        Self {
            speed,
            roughness,
            wheels: None,
            wheel_modes: None,
            decay: None,
            transfer: None,
            limit,
            train: Train {
                wheels: WHEELS,
                length: Train::LENGTH_PER_WHEEL * f64::from(WHEELS),
                distance: 7.5,
                height: 1.2,
                surroundings: Surroundings::HardGround,
            },
            rail_foot: 0.15,
            sleeper_area: 0.33,
            future: None,
        }
    }
}

/// Levels beside the track, and what would lower them.
pub struct NoiseAnswer {
    /// What was asked.
    pub request: NoiseRequest,
    /// Levels now.
    pub levels: PassByLevels,
    /// What a wheel with its rail radiates now.
    pub powers: PowerLevels,
    /// Levels by the transfer functions of the directive.
    pub by_transfer: Option<PassByLevels>,
    /// What would help, each by itself.
    pub measures: Vec<Measure>,
    /// The level in months to come.
    pub course: Option<Course>,
    /// Bands of 100–5000 Hz in which roughness, decay or receptance is not known.
    pub left_out: Vec<FrequencyBand>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

impl NoiseAnswer {
    /// Levels on a case; `progress` is told of each vehicle of the traffic.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] where a number is outside its range, no band is known, or the track has no decay;
    /// [`AnswerError::Case`] with the key at fault.
    pub fn new(
        case: &Case,
        request: NoiseRequest,
        progress: &(dyn Fn(usize) + Sync),
    ) -> Result<Self, AnswerError> {
        if let (None, Some(why)) = (&request.decay, without_decay(case)) {
            return Err(AnswerError::Argument {
                argument: "--decay-rate",
                value: "left out".to_owned(),
                rule: format!("given: {why}"),
            });
        }
        range::check(&request)?;
        let modes = modes_of(&request);
        let powers = powers_of(case, &request, modes, &request.roughness, request.speed)?;
        let levels = heard(&request, &powers)?;
        let left_out: Vec<FrequencyBand> = FrequencyBand::all()
            .filter(|band| levels.bands().iter().all(|level| level.band != *band))
            .collect();
        if levels.bands().is_empty() {
            return Err(AnswerError::Argument {
                argument: "--speed",
                value: format!("{:.1} km/h", 3.6 * request.speed),
                rule: "one at which the wavelengths of the roughness fill a one-third octave \
                       between 100 Hz and 5 kHz"
                    .to_owned(),
            });
        }
        let by_transfer = match &request.transfer {
            Some(tables) => Some(levels_by_transfer(case, &request, tables)?),
            None => None,
        };
        let measures = measure::measures(case, &request, &levels)?;
        let course = match &request.future {
            Some(future) => Some(Course::new(case, &request, future, progress)?),
            None => None,
        };
        Ok(Self {
            remarks: remarks(case, &request, &powers, &left_out),
            powers: PowerLevels::new(powers),
            request,
            levels,
            by_transfer,
            measures,
            course,
            left_out,
        })
    }

    /// Levels by band, and what each measure does.
    pub fn figure(&self, case: &Case) -> LineFigure {
        figure::figure(self, case)
    }

    /// The answer as data: what `riffel noise --json` prints.
    pub fn document(&self) -> NoiseDocument<'_> {
        document::document(self)
    }

    /// One row for each band.
    ///
    /// # Errors
    /// Those of the file.
    pub fn bands_csv(&self, file: &mut impl Write) -> io::Result<()> {
        document::bands_csv(self, file)
    }

    /// Time that the train takes to pass \[s\].
    pub fn duration(&self) -> f64 {
        self.request.train.length / self.request.speed
    }

    /// Sound exposure level of the passage \[dB(A) re (20 µPa)² s\].
    pub fn exposure_level(&self) -> f64 {
        self.levels.a_weighted(Part::Total) + 10.0 * self.duration().log10()
    }
}

/// Levels of a case with some roughness of the rail at some speed.
pub(crate) fn levels_of(
    case: &Case,
    request: &NoiseRequest,
    roughness: &Spectrum,
    speed: f64,
) -> Result<PassByLevels, AnswerError> {
    let powers = powers_of(case, request, modes_of(request), roughness, speed)?;
    heard(request, &powers)
}

/// Levels of a case where dampers leave no mode of the wheel with less than a damping ratio; none for a rigid wheel.
pub(crate) fn levels_with_wheel_dampers(
    case: &Case,
    request: &NoiseRequest,
    damping_ratio: f64,
) -> Result<Option<PassByLevels>, AnswerError> {
    let Some(modes) = modes_of(request) else {
        return Ok(None);
    };
    let damped = modes.damped(damping_ratio);
    let powers = powers_of(
        case,
        request,
        Some(&damped),
        &request.roughness,
        request.speed,
    )?;
    heard(request, &powers).map(Some)
}

fn modes_of(request: &NoiseRequest) -> Option<&WheelModes> {
    request.wheel_modes.as_ref().map(|table| &table.modes)
}

/// Why a track has no level of its own, if it has none: nothing is known of how far its rail carries vibration, or it carries it
/// further than a length can be told, at every frequency, so that the level would be that of where the length is cut.
pub fn without_decay(case: &Case) -> Option<String> {
    let model = case.file.track.model.name();
    let Some(track) = case.track.structure.as_deref() else {
        return Some(format!(
            "track.model = \"{model}\" says what the rail does under the wheel alone, not how far its vibration runs"
        ));
    };
    let runs_on = FrequencyBand::all().all(|band| RailDecay::runs_on(track, band.centre()));
    runs_on.then(|| {
        format!("the rail of track.model = \"{model}\" carries its vibration on without end at every frequency")
    })
}

/// Pressures beside the track of some sound powers of a wheel on one rail.
fn heard(request: &NoiseRequest, powers: &[SoundPower]) -> Result<PassByLevels, AnswerError> {
    let (air, pass) = (Air::default(), pass_by(request)?);
    let bands = powers.iter().map(|power| BandPressure {
        band: power.band,
        rail: pass.of_wheels(&air, power.rail),
        sleepers: pass.of_wheels(&air, power.sleepers),
        wheel: pass.of_wheels(&air, power.wheel),
    });
    Ok(PassByLevels::new(bands.collect()))
}

/// Sound powers of a wheel on one rail, in the bands that are known.
fn powers_of(
    case: &Case,
    request: &NoiseRequest,
    modes: Option<&WheelModes>,
    roughness: &Spectrum,
    speed: f64,
) -> Result<Vec<SoundPower>, AnswerError> {
    let excitation = excitation(case, request, roughness, speed)?;
    let file = &case.file;
    let area = match (file.rail.area, case.track.rail_mass) {
        (Some(area), _) => area.si(),
        (None, Some(mass)) => mass / file.rail.density.map_or(STEEL_DENSITY, |rho| rho.si()),
        (None, None) => RAIL_AREA,
    };
    let spacing = file.track.support_spacing.map(|spacing| spacing.si());
    let face = Piston::new(request.sleeper_area)?;
    let source = RollingSource {
        feedback: &case.feedback,
        decay: match (&request.decay, case.track.structure.as_deref()) {
            (None, Some(track)) => RailDecay::Track(track),
            (rates, track) => RailDecay::Rates {
                rates: rates.clone().unwrap_or_default(),
                track,
            },
        },
        rail: OscillatingCylinder::of_rail(request.rail_foot, area)?,
        sleepers: case.track.support.map(|support| Sleepers {
            support,
            face,
            spacing: spacing.unwrap_or(SLEEPER_SPACING),
        }),
        wheel: OscillatingSphere::of_wheel(case.hertz.rolling_radius(), WHEEL_WIDTH)?,
        wheel_modes: modes,
        air: Air::default(),
    };
    let (lowest, highest) = case.known_frequencies();
    let mut powers = Vec::new();
    for band in FrequencyBand::all() {
        let (low, high) = band.range();
        if low >= lowest && high <= highest {
            powers.extend(source.power(&excitation, band)?);
        }
    }
    Ok(powers)
}

/// Levels by transfer functions: those of the track are the rail's, those of the vehicle the wheel's.
fn levels_by_transfer(
    case: &Case,
    request: &NoiseRequest,
    [track, vehicle]: &[TransferTable; 2],
) -> Result<PassByLevels, AnswerError> {
    let excitation = excitation(case, request, &request.roughness, request.speed)?;
    let (air, pass) = (Air::default(), pass_by(request)?);
    let mut bands = Vec::new();
    for band in FrequencyBand::all().filter(|band| excitation.covers(*band)) {
        let (low, high) = band.range();
        let roughness = excitation.mean_square(low, high)?;
        let powers = [track, vehicle].map(|table| table.function.power(band, roughness));
        if let [Some(track), Some(vehicle)] = powers {
            bands.push(BandPressure {
                band,
                rail: pass.of_wheelsets(&air, track),
                sleepers: 0.0,
                wheel: pass.of_wheelsets(&air, vehicle),
            });
        }
    }
    Ok(PassByLevels::new(bands))
}

fn excitation(
    case: &Case,
    request: &NoiseRequest,
    roughness: &Spectrum,
    speed: f64,
) -> Result<Excitation, AnswerError> {
    let wheel = request.wheels.as_ref().map(|(_, spectrum)| spectrum);
    let filter = ContactFilter::of(&case.hertz);
    Ok(Excitation::new(roughness, wheel, filter, speed)?)
}

fn pass_by(request: &NoiseRequest) -> Result<PassBy, AnswerError> {
    let train = &request.train;
    Ok(PassBy::new(
        train.distance,
        train.height,
        f64::from(train.wheels),
        train.length,
        train.surroundings,
    )?)
}

fn remarks(
    case: &Case,
    request: &NoiseRequest,
    powers: &[SoundPower],
    left_out: &[FrequencyBand],
) -> Vec<Message> {
    let mut remarks = Vec::new();
    match &request.wheel_modes {
        None => remarks.push(say!(rigid_wheel)),
        Some(table) => {
            remarks.push(say!(ringing_wheel));
            let radius = case.hertz.rolling_radius();
            if (table.rolling_radius / radius - 1.0).abs() > LARGEST_DIFFERENCE {
                remarks.push(say!(
                    modes_of_other_wheel,
                    of_modes = fixed(2e3 * table.rolling_radius, 0),
                    of_case = fixed(2e3 * radius, 0)
                ));
            }
        }
    }
    if request.train.distance > FAR {
        remarks.push(say!(far_away, distance = request.train.distance, far = FAR));
    }
    if request.wheels.is_none() {
        remarks.push(say!(smooth_wheels));
    }
    // The amplitude of a sinusoid of the same mean square, as in the forecast.
    let force = powers.iter().map(|power| 2.0 * power.force).sum::<f64>();
    let ratio = force.sqrt() / case.hertz.normal_force();
    if ratio >= 1.0 {
        remarks.push(say!(noise_beyond_linear_range, ratio = fixed(ratio, 2)));
    }
    if let (None, Some(track)) = (&request.decay, case.track.structure.as_deref()) {
        let bands = powers.iter().map(|power| power.band);
        let far: Vec<FrequencyBand> = bands
            .filter(|band| RailDecay::runs_on(track, band.centre()))
            .collect();
        if !far.is_empty() {
            remarks.push(say!(rail_cut_short, frequencies = nominal(&far)));
        }
    }
    if !left_out.is_empty() {
        remarks.push(say!(bands_left_out, frequencies = nominal(left_out)));
    }
    remarks
}

/// Nominal frequencies in a row.
fn nominal(bands: &[FrequencyBand]) -> Value {
    bands.iter().map(|band| number(band.nominal())).collect()
}
