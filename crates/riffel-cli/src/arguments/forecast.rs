//! Arguments of `forecast` and `compare`.

use std::path::PathBuf;

use super::earlier::date;
use clap::{Args, ValueEnum};
use jiff::civil::Date;
use riffel_answers::question::AsWritten;
use riffel_case::Hold;
use riffel_case::model::{FieldModel, UnknownModel};
use riffel_keys::quantity::{Quantity, Speed};

use super::number::{plain_number, sum_of_money};
use super::{CaseArguments, Earlier, Layout, Posterior, ResultsArguments};

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

/// Models of the field that are named; none for all that fit.
#[derive(Clone)]
pub(crate) struct Models(pub(crate) Vec<&'static FieldModel>);

/// What a remedy costs, by its id.
fn cost(text: &str) -> Result<(String, f64), String> {
    let (id, number) = text.split_once('=').unwrap_or((text, ""));
    if number.trim().is_empty() {
        return Err("write it as in softer-pads=9000".to_owned());
    }
    Ok((id.trim().to_owned(), sum_of_money(number)?))
}

/// Models by name, commas between them.
fn models(text: &str) -> Result<Models, UnknownModel> {
    match text {
        "all" => Ok(Models(Vec::new())),
        names => FieldModel::named(names.split(',').map(str::trim)).map(Models),
    }
}

#[derive(Args)]
#[command(
    after_help = "Example: riffel compare case.toml --with soft-pads.toml --with slower.toml --speed \"100 km/h\"\n\n\
        A file of changes has a title and the keys of the case that change, in their tables:\n\n  \
        title = \"soft pads, slower\"\n  [track]\n  pad = { stiffness = \"120 MN/m\" }\n  [speed]\n  factor = 0.8\n\n\
        [speed] takes mean or factor, and standard_deviation or standard_deviation_factor. What lasts longest after grinding: \
        riffel compare case.toml --with soft-pads.toml --traffic traffic.toml --from-limit \"-6 dB\"\n\n\
        What helps most: riffel compare case.toml --remedies\n\n\
        The same case by the models of the field: riffel compare case.toml --models --speed \"100 km/h\""
)]
pub(crate) struct Compare {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// File of changes to the case and its speeds; may be repeated.
    #[arg(long = "with", value_name = "TOML", required_unless_present_any = ["models", "remedies"])]
    pub(crate) variants: Vec<PathBuf>,

    /// Remedies in place of variants: those that the case has keys for, ranked by what each does to growth.
    #[arg(long, conflicts_with_all = [
        "variants", "models", "speed", "posterior", "hold", "spectrum", "ground", "from_limit", "format", "spacing",
        "height_unit", "position_unit", "rail", "from", "to", "choose", "limit",
    ])]
    pub(crate) remedies: bool,

    /// What a remedy costs by its id in --json, as in --cost softer-pads=9000, in one currency for all; what then gains
    /// most months of grinding interval for it comes first; may be repeated.
    #[arg(long = "cost", value_name = "REMEDY=NUMBER", value_parser = cost, requires = "remedies")]
    pub(crate) costs: Vec<(String, f64)>,

    /// The case by models of the field in place of variants: all that fit, or those named, as in --models
    /// grassie-johnson-1985,riffel.
    #[arg(long, value_name = "NAMES", num_args = 0..=1, default_missing_value = "all", value_parser = models,
        conflicts_with_all = [
            "variants", "speed_deviation", "traffic", "hold", "spectrum", "ground", "from_limit", "format", "spacing",
            "height_unit", "position_unit", "rail", "from", "to", "choose", "limit",
        ])]
    pub(crate) models: Option<Models>,

    /// Speed of the wheel of the case, in m/s or with its unit [default: the usual traffic of its line].
    #[arg(long, value_name = "SPEED", conflicts_with_all = ["traffic", "posterior"])]
    pub(crate) speed: Option<AsWritten<Speed>>,

    /// Standard deviation of the speed.
    #[arg(long, value_name = "SPEED", requires = "speed", conflicts_with = "traffic")]
    pub(crate) speed_deviation: Option<Quantity<Speed>>,

    /// Traffic file, in place of the wheel of the case.
    #[arg(long, value_name = "TOML", conflicts_with = "posterior")]
    pub(crate) traffic: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) posterior: Posterior,

    /// What variants of friction or load hold: force, ratio (Q₀/μP₀) or creepage [default: what the case or the
    /// vehicle gives, ratio or creepage].
    #[arg(long, value_enum, value_name = "WHAT", hide_possible_values = true)]
    pub(crate) hold: Option<HoldArgument>,

    /// Measured rail, to say when each variant reaches the limit; of several dates growth goes on as measured.
    #[arg(long, value_name = "FILE")]
    pub(crate) spectrum: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) earlier: Earlier,

    #[command(flatten)]
    pub(crate) ground: Ground,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[arg(long = "where", value_name = "COLUMN=VALUE", requires = "spectrum")]
    pub(crate) choose: Vec<String>,

    /// Limit of the levels, by name or as a TOML file.
    #[arg(long, value_name = "LIMIT", default_value = "iso-3095-2013")]
    pub(crate) limit: String,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
