//! Arguments of `axlebox`.

use std::path::PathBuf;

use clap::Args;
use riffel_answers::axlebox::AxleBoxRequest;
use riffel_keys::quantity::{Frequency, Length, Quantity, Speed};
use riffel_rail::AxleBoxLayout;

use super::{Asked, CaseArguments, ResultsArguments, positive};
use crate::error::CliError;

#[derive(Args)]
#[command(
    after_help = "Example: riffel axlebox run.csv --case case.toml -o results && riffel roughness results/spectrum.csv\n\n\
        A run of constant speed without a column of times: riffel axlebox run.csv --case case.toml --rate \"10 kHz\" --speed \
        \"80 km/h\"\n\n\
        A WAV file whose full scale is 50 g on two channels and 250 km/h on the third: riffel axlebox run.wav --case case.toml \
        --channels acceleration_left_g=50,acceleration_right_g=50,speed_km_per_h=250"
)]
pub(crate) struct AxleBox {
    /// Accelerations over time with speed or odometer: text under a head with units, as in
    /// time_s,acceleration_left_m_per_s2,speed_km_per_h, a WAV file, or a universal file (dataset 58); every channel of
    /// accelerations is a rail.
    #[arg(value_name = "FILE", required = true)]
    pub(crate) paths: Vec<PathBuf>,

    /// Case file of the track and the wheel, or - for standard input.
    #[arg(long, value_name = "CASE")]
    case: PathBuf,

    /// Override a value of the case, as in --set track.pad.stiffness="80 MN/m"; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,

    /// Samples per second, in place of a column of times.
    #[arg(long, value_name = "FREQUENCY")]
    rate: Option<Quantity<Frequency>>,

    /// Speed of the train, in place of a column of speeds or of an odometer.
    #[arg(long, value_name = "SPEED")]
    speed: Option<Asked<Speed>>,

    /// Channels of a WAV file in their order, each called as a column is, with its value at full scale.
    #[arg(long, value_name = "NAME=FULL_SCALE", value_delimiter = ',')]
    channels: Vec<String>,

    /// Shortest wavelength; the sampling rate may not reach it.
    #[arg(long, value_name = "LENGTH", default_value = "10 mm")]
    shortest: Quantity<Length>,

    /// Longest wavelength; longer ones need a sensor that is quiet at low frequencies.
    #[arg(long, value_name = "LENGTH", default_value = "400 mm")]
    longest: Quantity<Length>,

    /// Lowest speed at which the train is listened to.
    #[arg(long, value_name = "SPEED", default_value = "20 km/h")]
    slowest: Quantity<Speed>,

    /// Give back what the contact patch does not let through, for the roughness of the rail itself.
    #[arg(long)]
    contact_filter: bool,

    /// Keep welds, joints and squats in the levels [default: they are listed and left out; statistics of bands and what to
    /// grind always have them].
    #[arg(long)]
    keep_defects: bool,

    /// Limit table, by name or as a TOML file; may be repeated [default: all].
    #[arg(long, value_name = "LIMIT")]
    pub(crate) limit: Vec<String>,

    /// Length of the blocks whose RMS is tabled.
    #[arg(long, value_name = "LENGTH", default_value = "10 m")]
    block: Quantity<Length>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

impl AxleBox {
    /// The case with its overrides.
    pub(crate) fn case(&self) -> CaseArguments {
        CaseArguments::of(&self.case, &self.overrides)
    }

    /// What is said of the files.
    pub(crate) fn layout(&self) -> Result<AxleBoxLayout, CliError> {
        let rate = self.rate.map(|rate| positive("--rate", rate)).transpose()?;
        let speed = self.speed.as_ref();
        Ok(AxleBoxLayout {
            rate,
            speed: speed.map(|speed| speed.within("--speed")).transpose()?,
            channels: self.channels.clone(),
        })
    }

    /// What is asked.
    pub(crate) fn request(&self) -> Result<AxleBoxRequest, CliError> {
        let request = AxleBoxRequest {
            shortest: positive("--shortest", self.shortest)?,
            longest: positive("--longest", self.longest)?,
            slowest: positive("--slowest", self.slowest)?,
            contact_filter: self.contact_filter,
            keep_defects: self.keep_defects,
            block: positive("--block", self.block)?,
            ..AxleBoxRequest::default()
        };
        if request.longest >= 2.0 * request.shortest {
            return Ok(request);
        }
        Err(CliError::Argument {
            argument: "--longest",
            value: self.longest.to_string(),
            rule: "at least twice --shortest".to_owned(),
        })
    }
}
