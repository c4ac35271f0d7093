//! What is asked of axle boxes.

use std::path::PathBuf;

use riffel_case::Case;
use riffel_keys::quantity::{Frequency, Length, Quantity, Speed};
use riffel_keys::say;
use riffel_rail::{AxleBoxFile, AxleBoxLayout, LimitTable};
use schemars::JsonSchema;
use serde::Deserialize;

use super::{AxleBoxAnswer, AxleBoxRequest};
use crate::question::{AsWritten, CaseSource, Client, Question, Source, called, positive};
use crate::{Answer, AnswerError, Result};

/// A rail as the axle boxes of a train felt it: roughness from acceleration, limits, what to grind.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct AxleBoxQuestion {
    /// Accelerations over time with speed or odometer: text under a head with units, as in
    /// time_s,acceleration_left_m_per_s2,speed_km_per_h, a WAV file, or a universal file (dataset 58); every channel of
    /// accelerations is a rail.
    #[schemars(with = "Vec<Source<()>>", length(min = 1), extend("positional" = true))]
    file: Vec<PathBuf>,
    /// Case file of the track and the wheel, or - for standard input.
    #[schemars(extend("value_name" = "CASE"))]
    case: Source<Case>,
    /// Override a value of the case, as in --set track.pad.stiffness="80 MN/m"; may be repeated.
    #[schemars(extend("value_name" = "KEY=VALUE"))]
    set: Vec<String>,
    /// Samples per second, in place of a column of times.
    #[schemars(extend("value_name" = "FREQUENCY"))]
    rate: Option<Quantity<Frequency>>,
    /// Speed of the train, in place of a column of speeds or of an odometer.
    speed: Option<AsWritten<Speed>>,
    /// Channels of a WAV file in their order, each called as a column is, with its value at full scale.
    #[schemars(extend("value_name" = "NAME=FULL_SCALE", "separator" = ","))]
    channels: Vec<String>,
    /// Shortest wavelength; the sampling rate may not reach it.
    #[schemars(extend("value_name" = "LENGTH", "default" = "10 mm"))]
    shortest: Quantity<Length>,
    /// Longest wavelength; longer ones need a sensor that is quiet at low frequencies.
    #[schemars(extend("value_name" = "LENGTH", "default" = "400 mm"))]
    longest: Quantity<Length>,
    /// Lowest speed at which the train is listened to.
    #[schemars(extend("value_name" = "SPEED", "default" = "20 km/h"))]
    slowest: Quantity<Speed>,
    /// Give back what the contact patch does not let through, for the roughness of the rail itself.
    contact_filter: bool,
    /// Keep welds, joints and squats in the levels [default: they are listed and left out; statistics of bands and what to
    /// grind always have them].
    keep_defects: bool,
    /// Limit table, by name or as a TOML file; may be repeated [default: all].
    #[schemars(extend("value_name" = "LIMIT"))]
    limit: Vec<String>,
    /// Length of the blocks whose RMS is tabled.
    #[schemars(extend("value_name" = "LENGTH", "default" = "10 m"))]
    block: Quantity<Length>,
}

impl AxleBoxQuestion {
    /// What is said of the files.
    fn layout(&self, client: &dyn Client) -> Result<AxleBoxLayout> {
        Ok(AxleBoxLayout {
            rate: self.rate.map(|rate| positive("--rate", rate)).transpose()?,
            speed: self.speed.as_ref().map(|speed| speed.within("--speed", client)).transpose()?,
            channels: self.channels.clone(),
        })
    }

    /// What is computed of them.
    fn request(&self) -> Result<AxleBoxRequest> {
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
        let rule = "at least twice --shortest".to_owned();
        Err(AnswerError::argument("--longest", self.longest, rule))
    }
}

impl Question for AxleBoxQuestion {
    const NAME: &'static str = "axlebox";
    const EXAMPLE: &'static str = "\
        Example: riffel axlebox run.csv --case case.toml -o results && riffel roughness results/spectrum.csv\n\n\
        A run of constant speed without a column of times: riffel axlebox run.csv --case case.toml --rate \"10 kHz\" --speed \
        \"80 km/h\"\n\n\
        A WAV file whose full scale is 50 g on two channels and 250 km/h on the third: riffel axlebox run.wav --case case.toml \
        --channels acceleration_left_g=50,acceleration_right_g=50,speed_km_per_h=250";

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        let (layout, request) = (self.layout(client)?, self.request()?);
        let limits = LimitTable::named(&self.limit)?;
        let case = CaseSource::new(self.case.clone(), self.set.clone()).read(client)?;
        let open = |path: &PathBuf| {
            let file = Source::File(path.clone()).value(|path| AxleBoxFile::open(path, &layout))?;
            Ok((called(path).to_owned(), file))
        };
        let files = self.file.iter().map(open).collect::<Result<Vec<_>>>()?;
        let sizes = self.file.iter().filter_map(|path| std::fs::metadata(path).ok());
        let size: u64 = sizes.map(|file| file.len()).sum();
        let step = client.begin(say!(progress_listening), size as usize);
        Ok(Box::new(AxleBoxAnswer::new(&case, &files, &limits, &request, &step)?))
    }
}
