//! What is asked of profiles.

use std::path::PathBuf;

use riffel_case::CurvingCase;
use riffel_case::file::Inclination;
use riffel_curving::profile::ProfileAlignment;
use riffel_keys::quantity::{Angle, Force, Length, Quantity};
use riffel_rail::{ProfileOrientation, ProfileReading};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{OnTrackAnswer, OutlineAnswer, UnderLoadAnswer, WearAnswer, WearSettings};
use crate::question::{CaseSource, Client, Question, Rule, Source, positive};
use crate::{Answer, AnswerError, Result};

/// Largest yaw \[rad\], far beyond any curve.
const LARGEST_YAW: f64 = 0.1;
/// Most lateral shifts under load: some tenths of a second each.
const MOST_SHIFTS: usize = 201;

/// Profiles of wheels and rails: outline and curvature, or where a wheelset touches its track.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct ProfileQuestion {
    /// Nominal names, or files: two columns x, y, or of MiniProf, Simpack or Vampire; with --wheelset a case file.
    #[schemars(with = "Vec<Source<CurvingCase>>", length(min = 1), extend("positional" = true))]
    file: Vec<PathBuf>,
    /// Wear against a nominal profile or an earlier file.
    #[schemars(extend("value_name" = "NAME"))]
    against: Option<String>,
    /// By what profiles are laid on the nominal one [default: flange of wheels, field-side of rails].
    #[schemars(extend("value_name" = "PART"))]
    align: Option<Alignment>,
    /// Inclination of the rail in its coordinates, as in 1:40 [default: none].
    #[schemars(extend("value_name" = "SLOPE"))]
    inclination: Option<String>,
    /// Depth below the nominal crown at which wear of the gauge face is measured [default: 14 mm].
    #[schemars(extend("value_name" = "LENGTH"))]
    gauge_height: Option<Quantity<Length>>,
    /// How coordinates of files stand [default: as-written in columns, found in other formats].
    #[schemars(extend("value_name" = "WAY"))]
    orientation: Option<Orientation>,
    /// Smooth the points of files, which scatter with this standard deviation across the profile.
    #[schemars(extend("value_name" = "LENGTH"))]
    scatter: Option<Quantity<Length>>,
    /// Where the wheelset of a case touches its track, and its equivalent conicity.
    wheelset: bool,
    /// Yaw of the wheelset, in rad or with its unit.
    #[schemars(extend("value_name" = "ANGLE"))]
    yaw: Option<Quantity<Angle>>,
    /// Lateral shifts, separated by commas, in metres or with their unit [default: from -10 mm to 10 mm
    /// every 0.1 mm, as far as both wheels touch their rails].
    #[schemars(extend("value_name" = "LIST", "separator" = ","))]
    lateral_shift: Vec<Quantity<Length>>,
    /// Normal force on each wheel, in N or with its unit: patch, pressure and stiffness of both contacts, at the shift 0 or those
    /// of --lateral-shift.
    #[schemars(extend("value_name" = "FORCE"))]
    load: Option<Quantity<Force>>,
    /// Override a value of the case, as in --set "profiles.gauge=1432 mm"; may be repeated.
    #[schemars(extend("value_name" = "KEY=VALUE"))]
    set: Vec<String>,
}

/// By what a profile is laid on the nominal one.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
enum Alignment {
    /// A wheel by its flange back and the tip of its flange.
    Flange,
    /// A rail by its field side, which wheels do not touch.
    FieldSide,
    /// By nothing.
    AsWritten,
}

/// How coordinates of profiles stand.
#[derive(Debug, Clone, Copy, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
#[schemars(inline)]
enum Orientation {
    /// Orientation found from the shape.
    Found,
    /// x to the field side, y upward.
    AsWritten,
    /// x to the gauge side.
    Mirrored,
    /// y downward.
    UpsideDown,
    /// x to the gauge side, y downward.
    Turned,
}

impl From<Alignment> for ProfileAlignment {
    fn from(alignment: Alignment) -> Self {
        match alignment {
            Alignment::Flange => Self::Flange,
            Alignment::FieldSide => Self::FieldSide,
            Alignment::AsWritten => Self::AsWritten,
        }
    }
}

impl From<Orientation> for ProfileOrientation {
    fn from(orientation: Orientation) -> Self {
        match orientation {
            Orientation::Found => Self::Found,
            Orientation::AsWritten => Self::AsWritten,
            Orientation::Mirrored => Self::Mirrored,
            Orientation::UpsideDown => Self::UpsideDown,
            Orientation::Turned => Self::Turned,
        }
    }
}

impl ProfileQuestion {
    /// Wear against a nominal profile.
    fn wear(&self, nominal: &str, reading: ProfileReading) -> Result<WearAnswer> {
        let default = WearSettings::default();
        let inclination = self.inclination.as_deref().map(|text| {
            let wrong = |rule| AnswerError::argument("--inclination", text, rule);
            Inclination::read(text).map_err(wrong)
        });
        let gauge_height = self.gauge_height.map(|height| positive("--gauge-height", height));
        let settings = WearSettings {
            reading,
            alignment: self.align.map(Into::into),
            inclination: inclination.transpose()?.unwrap_or(default.inclination),
            gauge_height: gauge_height.transpose()?.unwrap_or(default.gauge_height),
            ..default
        };
        Ok(WearAnswer::new(&self.file, nominal, settings)?)
    }

    /// A wheelset on its track, under load if one is given.
    fn on_track(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let wrong = |argument, value, rule: String| Err(AnswerError::argument(argument, value, rule));
        if let Some(second) = self.file.get(1) {
            let rule = "the only one with --wheelset, a case file".to_owned();
            return wrong("FILE", second.display().to_string(), rule);
        }
        let case = CaseSource::<CurvingCase>::new(Source::File(self.file[0].clone()), self.set.clone()).read(client)?;
        let yaw = self.yaw.map_or(0.0, |yaw| yaw.si());
        if yaw.abs() > LARGEST_YAW {
            return wrong("--yaw", format!("{yaw} rad"), format!("between -{LARGEST_YAW} and {LARGEST_YAW} rad"));
        }
        let mut shifts: Vec<f64> = self.lateral_shift.iter().map(Quantity::si).collect();
        let Some(load) = self.load else {
            return Ok(Box::new(OnTrackAnswer::new(&case, &shifts, yaw)?));
        };
        let load = positive("--load", load)?;
        if shifts.len() > MOST_SHIFTS {
            let rule = format!("at most {MOST_SHIFTS} with --load");
            return wrong("--lateral-shift", format!("{} shifts", shifts.len()), rule);
        }
        if shifts.is_empty() {
            shifts.push(0.0);
        }
        Ok(Box::new(UnderLoadAnswer::new(&case, &shifts, yaw, load)?))
    }
}

impl Question for ProfileQuestion {
    const NAME: &'static str = "profile";
    const EXAMPLE: &'static str = "Examples:\n  riffel profile S1002 60E1\n  riffel profile wheel.whl --against S1002\n  \
        riffel profile case.toml --wheelset --yaw \"5 mrad\" --lateral-shift \"-3 mm,0 mm,3 mm\"\n  \
        riffel profile case.toml --wheelset --load \"60 kN\"";
    const RULES: &'static [Rule] = &[
        Rule::OneOf(&["against", "wheelset"]),
        Rule::Needs(&["align", "inclination", "gauge_height"], &["against"]),
        Rule::OneOf(&["orientation", "wheelset"]),
        Rule::OneOf(&["scatter", "wheelset"]),
        Rule::Needs(&["yaw", "lateral_shift", "load", "set"], &["wheelset"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        if self.wheelset {
            return self.on_track(client);
        }
        let scatter = self.scatter.map(|scatter| positive("--scatter", scatter)).transpose()?;
        let orientation = self.orientation.map(Into::into);
        let reading = ProfileReading { orientation, scatter, ..ProfileReading::default() };
        if let Some(nominal) = &self.against {
            return Ok(Box::new(self.wear(nominal, reading)?));
        }
        Ok(Box::new(OutlineAnswer::new(self.file.iter().map(|file| (file.clone(), reading)))?))
    }
}
