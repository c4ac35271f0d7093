//! The command line of `riffel simulate`.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{ArgGroup, Args};
use riffel_keys::PhysicalRange;
use riffel_keys::quantity::{Length, Quantity, Speed};

use super::number::plain_number;
use super::{Asked, CaseArguments, Layout};
use crate::error::CliError;
use crate::messages::print_remarks;

#[derive(Args)]
#[command(
    group = ArgGroup::new("surface").required(true),
    after_help = "Example: riffel simulate case.toml --speed \"108 km/h\" --sinusoid 20um,55mm\n\n\
        A rail that wears: riffel simulate case.toml --speed 30 --profile trolley.csv --length \"20 m\" --passages 1e6"
)]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Speed, in m/s or with its unit.
    #[arg(long, value_name = "SPEED", allow_hyphen_values = true)]
    pub(crate) speed: Asked<Speed>,

    /// Roll over a sinusoid of this amplitude and wavelength until every wave is like the one before.
    #[arg(
        long,
        value_name = "AMPLITUDE,WAVELENGTH",
        group = "surface",
        allow_hyphen_values = true
    )]
    pub(crate) sinusoid: Option<SinusoidArgument>,

    /// Roll along the profile of a file, such as a trolley's.
    #[arg(long, value_name = "FILE", group = "surface")]
    pub(crate) profile: Option<PathBuf>,

    /// Take this much of the profile [default: all].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub(crate) length: Option<Quantity<Length>>,

    /// Wear the rail by so many wheels, one after another: levels and profile over passages, beside the linear loop. A run that
    /// was stopped goes on from where it was, and so does one that is asked for more.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = plain_number)]
    pub(crate) passages: Option<f64>,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Largest distance between two steps [default: 1/256 of a sinusoid's wavelength, 0.5 mm along a profile].
    #[arg(long, value_name = "LENGTH", allow_hyphen_values = true)]
    pub(crate) step: Option<Quantity<Length>>,

    /// Folder for the results, made if need be [default: CASE-simulate].
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// Print one JSON document, complex numbers as [re, im]; files are written only with --output.
    #[arg(long)]
    pub(crate) json: bool,
}

/// Amplitude and wavelength as they were written.
#[derive(Clone)]
pub(crate) struct SinusoidArgument {
    amplitude: String,
    wavelength: String,
}

impl FromStr for SinusoidArgument {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (amplitude, wavelength) = text
            .split_once(',')
            .ok_or("give amplitude and wavelength with a comma between them, as in 20um,55mm")?;
        for part in [amplitude, wavelength] {
            let read: Result<Quantity<Length>, _> = part.trim().parse();
            read.map_err(|error| error.to_string())?;
        }
        Ok(Self {
            amplitude: amplitude.trim().to_owned(),
            wavelength: wavelength.trim().to_owned(),
        })
    }
}

impl SinusoidArgument {
    /// Amplitude and wavelength \[m\] within their physical ranges. What is not usual is asked about on standard error.
    pub(crate) fn within(&self) -> Result<[f64; 2], CliError> {
        let read = |key: &str, what: &str, text: &str| {
            let (si, remark) =
                PhysicalRange::read::<Length>(key, text).map_err(|rule| CliError::Range {
                    argument: "--sinusoid",
                    message: format!(": {what} {rule}"),
                })?;
            print_remarks(remark.as_slice());
            Ok::<f64, CliError>(si)
        };
        Ok([
            read("corrugation.amplitude", "amplitude", &self.amplitude)?,
            read("--wavelength", "wavelength", &self.wavelength)?,
        ])
    }
}
