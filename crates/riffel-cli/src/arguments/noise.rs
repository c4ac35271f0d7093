//! Arguments of `noise`.

use std::path::PathBuf;

use clap::Args;
use riffel_keys::quantity::{Area, Length, Speed};

use super::number::plain_number;
use super::{Asked, CaseArguments, Earlier, Layout, Posterior, ResultsArguments};

#[derive(Args)]
#[command(
    after_help = "Example: riffel noise case.toml --roughness spectra.csv --speed \"140 km/h\" --wheel-roughness cnossos-disc-brakes\n\n\
        Months until a level is reached: riffel noise case.toml --roughness spectra.csv --speed \"140 km/h\" --traffic \
        traffic.toml --months 24 --limit-dba 88"
)]
pub(crate) struct Noise {
    #[command(flatten)]
    pub(crate) case: CaseArguments,

    /// Roughness of the rail: a table of one-third-octave levels or a longitudinal profile; the energy mean of its latest
    /// records is taken.
    #[arg(long, visible_alias = "after", value_name = "FILE")]
    pub(crate) roughness: PathBuf,

    /// Roughness of the same rail before, as before grinding: a file like that of --roughness, which is compared with it.
    #[arg(long, value_name = "FILE")]
    pub(crate) before: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) earlier: Earlier,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[arg(long = "where", value_name = "COLUMN=VALUE")]
    pub(crate) choose: Vec<String>,

    /// Speed of the train, in m/s or with its unit.
    #[arg(long, value_name = "SPEED")]
    pub(crate) speed: Asked<Speed>,

    /// Wheels of the train on one rail.
    #[arg(long, value_name = "N", default_value_t = 4, value_parser = clap::value_parser!(u32).range(1..=10_000))]
    pub(crate) wheels: u32,

    /// Length of the train [default: 6.6 m for each wheel, as of a coach of 26.4 m on four wheelsets].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) train_length: Option<Asked<Length>>,

    /// Roughness of the wheels: a file of spectra, or cnossos-cast-iron-blocks, cnossos-composite-blocks or
    /// cnossos-disc-brakes [default: none, smooth wheels].
    #[arg(long, value_name = "FILE")]
    pub(crate) wheel_roughness: Option<String>,

    /// Modes of the web and tyre of the wheels by name, straight-web-920, or as a TOML file [default: none, rigid wheels].
    #[arg(long, value_name = "MODES")]
    pub(crate) wheel_modes: Option<String>,

    /// Measured decay rates of the track, in place of those of the case: a table with the columns frequency_hz and
    /// decay_rate_db_per_m.
    #[arg(long, value_name = "CSV")]
    pub(crate) decay_rate: Option<PathBuf>,

    /// Transfer function of the track by name, such as cnossos-monobloc-medium-pads, or as a TOML file: the level by the
    /// source model of the European directive, beside that of the case.
    #[arg(long, value_name = "TRANSFER", requires = "vehicle_transfer")]
    pub(crate) track_transfer: Option<String>,

    /// Transfer function of the vehicle, such as cnossos-wheel-920.
    #[arg(long, value_name = "TRANSFER", requires = "track_transfer")]
    pub(crate) vehicle_transfer: Option<String>,

    /// Distance of the receiver from the middle of the track.
    #[arg(long, value_name = "LENGTH", default_value = "7.5 m")]
    pub(crate) distance: Asked<Length>,

    /// Height of the receiver above the rail.
    #[arg(long, value_name = "LENGTH", default_value = "1.2 m")]
    pub(crate) height: Asked<Length>,

    /// Breadth of the rail foot.
    #[arg(long, value_name = "LENGTH", default_value = "150 mm")]
    pub(crate) rail_foot: Asked<Length>,

    /// Face of a sleeper that belongs to one rail.
    #[arg(long, value_name = "AREA", default_value = "0.33 m2")]
    pub(crate) sleeper_area: Asked<Area>,

    /// Limit of the levels of roughness to which the rail may be ground, by name or as a TOML file.
    #[arg(long, value_name = "LIMIT", default_value = "iso-3095-2013")]
    pub(crate) limit: String,

    /// Traffic file: the level in months to come.
    #[arg(long, value_name = "TOML", group = "growth_under")]
    pub(crate) traffic: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) posterior: Posterior,

    /// Look so many months ahead.
    #[arg(long, value_name = "M", allow_negative_numbers = true, value_parser = plain_number, default_value = "12", requires = "growth_under")]
    pub(crate) months: f64,

    /// Highest level allowed, to say in how many months it is reached.
    #[arg(long, value_name = "DECIBELS", allow_negative_numbers = true, value_parser = plain_number, requires = "growth_under")]
    pub(crate) limit_dba: Option<f64>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
