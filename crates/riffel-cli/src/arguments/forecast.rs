//! Arguments of `forecast`.

use std::path::PathBuf;

use super::earlier::date;
use clap::{Args, ValueEnum};
use jiff::civil::Date;
use riffel_answers::question::GroundSource;
use riffel_case::Hold;

use super::number::plain_number;
use super::{CaseArguments, Earlier, Layout, ResultsArguments};

#[derive(Args)]
#[command(
    after_help = "Example: riffel forecast case.toml --spectrum spectra.csv --traffic traffic.toml --months 24\n\n\
        The interval of a rail that will be ground: riffel forecast case.toml --traffic traffic.toml --from-limit \"-6 dB\""
)]
pub(crate) struct Forecast {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    #[command(flatten)]
    pub(crate) spectra: Spectra,

    #[command(flatten)]
    pub(crate) ground: Ground,

    /// Traffic file: vehicles with their shares, loads, speeds and traction; `riffel init --traffic` writes
    /// one.
    #[arg(long, value_name = "TOML", required_unless_present = "posterior")]
    pub(crate) traffic: Option<PathBuf>,

    /// Folder of a finished calibration of the case: its levels, traffic and draws, with bands of 50 and 90 %.
    #[arg(long, value_name = "DIR", conflicts_with_all = ["traffic", "spectrum", "ground_rail", "passages", "mgt", "date", "files", "dates", "date_column", "choose", "earlier_choose", "passages_between"])]
    pub(crate) posterior: Option<PathBuf>,

    /// Limit of the levels, by name or as a TOML file.
    #[arg(long, value_name = "LIMIT", default_value = "iso-3095-2013")]
    pub(crate) limit: String,

    #[command(flatten)]
    pub(crate) horizon: Horizon,

    /// Date of the spectrum, from which dates are counted [default: that of --date-column].
    #[arg(long, value_name = "DATE", value_parser = date)]
    pub(crate) date: Option<Date>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}

/// How far to look ahead.
#[derive(Args)]
#[group(multiple = false)]
pub(crate) struct Horizon {
    /// Look so many axle passages ahead.
    #[arg(long, value_name = "N", allow_negative_numbers = true, value_parser = plain_number)]
    pub(crate) passages: Option<f64>,

    /// Look so many million gross tonnes ahead.
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = plain_number)]
    pub(crate) mgt: Option<f64>,

    /// Look so many months ahead [default: 12].
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = plain_number)]
    pub(crate) months: Option<f64>,
}

/// What was measured, now and before.
#[derive(Args)]
pub(crate) struct Spectra {
    /// Measured rail: a table of one-third-octave levels or a longitudinal profile; the energy mean of its
    /// records is taken. Of several dates the latest is now, and growth goes on as measured.
    #[arg(long, value_name = "FILE")]
    pub(crate) spectrum: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[arg(long = "where", value_name = "COLUMN=VALUE", requires = "spectrum")]
    pub(crate) choose: Vec<String>,

    /// Column of dates, as 2026-01-31 or 31.01.2026: the latest is now, the earliest before.
    #[arg(long, value_name = "COLUMN", requires = "spectrum")]
    pub(crate) date_column: Option<String>,

    #[command(flatten)]
    pub(crate) earlier: Earlier,

    /// Keep the earlier spectra whose column has this value [default file: that of --spectrum].
    #[arg(long = "earlier-where", value_name = "COLUMN=VALUE", requires = "spectrum")]
    pub(crate) earlier_choose: Vec<String>,

    /// Axle passages between the oldest record and that of now [default: from the dates and the traffic file].
    #[arg(
        long,
        value_name = "N",
        allow_negative_numbers = true,
        value_parser = plain_number,
        requires = "spectrum"
    )]
    pub(crate) passages_between: Option<f64>,
}

/// A rail that will be ground, in place of the rail as it was measured.
#[derive(Args, Clone, Default)]
#[group(id = "ground_rail", multiple = false)]
pub(crate) struct Ground {
    /// Begin with the spectrum that grinding leaves: a limit table of levels by name or as a TOML file, or a file
    /// of spectra measured after grinding.
    #[arg(long, value_name = "SPECTRUM")]
    pub(crate) ground: Option<String>,

    /// Begin so many decibels below the limit, as in "-6 dB".
    #[arg(long, value_name = "DECIBELS", allow_hyphen_values = true)]
    pub(crate) from_limit: Option<String>,
}

impl Ground {
    /// The same in a question.
    pub(crate) fn source(&self) -> GroundSource {
        GroundSource { ground: self.ground.clone(), from_limit: self.from_limit.clone() }
    }
}

/// What is held where a variant changes friction or load.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum HoldArgument {
    /// The traction force, which a train that pulls or brakes asks for.
    Force,
    /// The tractive ratio: less friction means less traction.
    Ratio,
    /// The creepage, which a curve imposes.
    Creepage,
}

impl From<HoldArgument> for Hold {
    fn from(argument: HoldArgument) -> Self {
        match argument {
            HoldArgument::Force => Self::Force,
            HoldArgument::Ratio => Self::Ratio,
            HoldArgument::Creepage => Self::Creepage,
        }
    }
}
