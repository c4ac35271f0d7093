//! The command line of `riffel simulate`.

use std::path::PathBuf;
use std::str::FromStr;

use clap::{ArgGroup, Args};
use riffel::passage::Sinusoid;
use riffel_answers::question::AsWritten;
use riffel_keys::PhysicalRange;
use riffel_keys::quantity::{Length, Quantity, Speed};

use super::number::plain_number;
use super::{CaseArguments, Layout, ResultsArguments, positive};
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::terminal::Terminal;

#[derive(Args)]
#[command(
    group = ArgGroup::new("surface").required(true),
    after_help = "Example: riffel simulate case.toml --speed \"108 km/h\" --sinusoid 20um,55mm\n\n\
        A rail that wears: riffel simulate case.toml --speed 30 --profile trolley.csv --length \"20 m\" --passages 1e6\n\n\
        Squeal: riffel simulate curve.toml --speed \"36 km/h\" --smooth\n\n\
        Under traffic: riffel simulate case.toml --traffic traffic.toml --spectrum iso-3095-2013 --passages 1e6"
)]
pub(crate) struct Simulate {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Speed, in m/s or with its unit.
    #[arg(long, value_name = "SPEED", required_unless_present = "traffic")]
    speed: Option<AsWritten<Speed>>,

    /// Traffic file, in place of a speed: passages of every vehicle at the speeds of its distribution, each as often as its
    /// share says.
    #[arg(long, value_name = "FILE", conflicts_with = "speed", requires = "passages")]
    pub(crate) traffic: Option<PathBuf>,

    /// Roll over a sinusoid of this amplitude and wavelength until every wave is like the one before.
    #[arg(long, value_name = "AMPLITUDE,WAVELENGTH", group = "surface")]
    pub(crate) sinusoid: Option<LengthPair>,

    /// Roll along the profile of a file, such as a trolley's.
    #[arg(long, value_name = "FILE", group = "surface")]
    pub(crate) profile: Option<PathBuf>,

    /// Roll along a rail drawn with the spectrum of a limit table, such as iso-3095-2013, or of a file of levels or
    /// profiles.
    #[arg(long, value_name = "SPECTRUM", group = "surface")]
    pub(crate) spectrum: Option<String>,

    /// Seed of the drawn rail [default: 1].
    #[arg(long, value_name = "N", conflicts_with = "sinusoid")]
    pub(crate) seed: Option<u64>,

    /// Roll over a dipped weld, -DEPTH/2 (1 - cos 2πx/LENGTH), in the middle of a smooth rail.
    #[arg(long, value_name = "DEPTH,LENGTH", group = "surface")]
    pub(crate) weld: Option<LengthPair>,

    /// Roll on a smooth rail after a small push, with a wheelset or with creepage on two axes: rest, or the limit cycle of a loop
    /// that is unstable without any profile, as squeal and as stick and slip.
    #[arg(
        long,
        group = "surface",
        conflicts_with_all = ["passages", "traffic", "seed", "length", "contact_filter"]
    )]
    pub(crate) smooth: bool,

    /// Take this much of the profile [default: all], or make the rail so long [default: 20 m].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) length: Option<Quantity<Length>>,

    /// Wear the rail by so many wheels, one after another: levels and profile over passages, beside the linear loop. A run that
    /// was stopped goes on from where it was, and so does one that is asked for more.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = plain_number)]
    pub(crate) passages: Option<f64>,

    /// Let the wheel feel the mean of the profile over the patch in the place of its height: sin(ka)/(ka) of a wave.
    #[arg(long)]
    pub(crate) contact_filter: bool,

    /// Over a sinusoid: follow the contact of the half-space element by element, contact.grid of them across, in the place of the creep law
    /// of the case. The reference for contact.response; seconds.
    #[arg(
        long,
        conflicts_with_all = ["profile", "spectrum", "weld", "smooth", "passages", "traffic"]
    )]
    pub(crate) transient: bool,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Largest distance between two steps [default: 1/256 of a sinusoid's wavelength, 0.5 mm along a profile].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) step: Option<Quantity<Length>>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

impl Simulate {
    /// Speed of the wheel \[m/s\].
    pub(crate) fn speed(&self) -> Result<f64, CliError> {
        match &self.speed {
            Some(speed) => Ok(speed.within("--speed", &Terminal)?),
            // The parser asks for it where there is no traffic, which is for passages.
            None => Err(CliError::Argument {
                argument: "--speed",
                value: "missing".to_owned(),
                rule: "given for one passage".to_owned(),
            }),
        }
    }

    /// `Ok` without an argument that is for profiles of files.
    pub(crate) fn only_for_profiles(&self, given: Option<&'static str>) -> Result<(), CliError> {
        given.map_or(Ok(()), |argument| {
            Err(CliError::Argument {
                argument,
                value: "given".to_owned(),
                rule: match argument {
                    "--length" => "left out: it is for --profile, --spectrum and --weld",
                    _ => "left out: it is for --profile",
                }
                .to_owned(),
            })
        })
    }
}

/// Two lengths as they were written.
#[derive(Clone)]
pub(crate) struct LengthPair([String; 2]);

impl FromStr for LengthPair {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (first, second) =
            text.split_once(',').ok_or("give two lengths with a comma between them, as in 20um,55mm")?;
        let pair = [first, second].map(|part| part.trim().to_owned());
        for part in &pair {
            let read: Result<Quantity<Length>, _> = part.parse();
            read.map_err(|error| error.to_string())?;
        }
        Ok(Self(pair))
    }
}

impl LengthPair {
    /// Amplitude and wavelength within their physical ranges. What is not usual is asked about on standard error.
    pub(crate) fn of_sinusoid(&self) -> Result<Sinusoid, CliError> {
        let read = |key: &str, what: &str, text: &str| {
            let (si, remark) = PhysicalRange::read::<Length>(key, text)
                .map_err(|rule| CliError::Range { argument: "--sinusoid", message: format!(": {what} {rule}") })?;
            print_remarks(remark.as_slice());
            Ok::<f64, CliError>(si)
        };
        let [amplitude, wavelength] = &self.0;
        Ok(Sinusoid {
            amplitude: read("corrugation.amplitude", "amplitude", amplitude)?,
            wavelength: read("--wavelength", "wavelength", wavelength)?,
        })
    }

    /// Both \[m\], above zero.
    pub(crate) fn positive(&self, argument: &'static str) -> Result<[f64; 2], CliError> {
        let mut lengths = [0.0; 2];
        for (length, text) in lengths.iter_mut().zip(&self.0) {
            let quantity: Quantity<Length> =
                text.parse().map_err(|error| CliError::Range { argument, message: format!(": {error}") })?;
            *length = positive(argument, quantity)?;
        }
        Ok(lengths)
    }
}
