//! Arguments of `profile`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use riffel_keys::quantity::{Angle, Force, Length, Quantity};

use super::ResultsArguments;

/// By what a profile is laid on the nominal one.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Alignment {
    /// A wheel by its flange back and the tip of its flange.
    Flange,
    /// A rail by its field side, which wheels do not touch.
    FieldSide,
    /// By nothing.
    AsWritten,
}

/// How coordinates of profiles stand.
#[derive(Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum Orientation {
    /// As the shape tells.
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

#[derive(Args)]
#[command(
    after_help = "Examples:\n  riffel profile S1002 60E1\n  riffel profile wheel.whl --against S1002\n  riffel profile case.toml --wheelset --yaw \"5 mrad\" --lateral-shift \"-3 mm,0 mm,3 mm\"\n  riffel profile case.toml --wheelset --load \"60 kN\""
)]
pub(crate) struct Profile {
    /// Nominal names, or files: two columns x, y, or of MiniProf, Simpack or Vampire; with --wheelset a case file.
    #[arg(value_name = "FILE", required = true)]
    pub(crate) files: Vec<PathBuf>,

    /// Wear against a nominal profile or an earlier file.
    #[arg(long, value_name = "NAME", conflicts_with = "wheelset")]
    pub(crate) against: Option<String>,

    /// By what profiles are laid on the nominal one [default: flange of wheels, field-side of rails].
    #[arg(long, value_enum, value_name = "PART", requires = "against")]
    pub(crate) align: Option<Alignment>,

    /// Inclination of the rail in its coordinates, as in 1:40 [default: none].
    #[arg(long, value_name = "SLOPE", requires = "against")]
    pub(crate) inclination: Option<String>,

    /// Depth below the nominal crown at which wear of the gauge face is measured [default: 14 mm].
    #[arg(long, value_name = "LENGTH", requires = "against")]
    pub(crate) gauge_height: Option<Quantity<Length>>,

    /// How coordinates of files stand [default: as-written in columns, found in other formats].
    #[arg(long, value_enum, value_name = "WAY", conflicts_with = "wheelset")]
    pub(crate) orientation: Option<Orientation>,

    /// Smooth the points of files, which scatter with this standard deviation across the profile.
    #[arg(long, value_name = "LENGTH", conflicts_with = "wheelset")]
    pub(crate) scatter: Option<Quantity<Length>>,

    /// Where the wheelset of a case touches its track, and its equivalent conicity.
    #[arg(long)]
    pub(crate) wheelset: bool,

    /// Yaw of the wheelset, in rad or with its unit.
    #[arg(long, value_name = "ANGLE", requires = "wheelset")]
    pub(crate) yaw: Option<Quantity<Angle>>,

    /// Lateral shifts, separated by commas, in metres or with their unit [default: from -10 mm to 10 mm
    /// every 0.1 mm, as far as both wheels touch their rails].
    #[arg(long, value_name = "LIST", value_delimiter = ',', requires = "wheelset")]
    pub(crate) lateral_shift: Vec<Quantity<Length>>,

    /// Normal force on each wheel, in N or with its unit: patch, pressure and stiffness of both contacts, at the shift 0 or those
    /// of --lateral-shift.
    #[arg(long, value_name = "FORCE", requires = "wheelset")]
    pub(crate) load: Option<Quantity<Force>>,

    /// Override a value of the case, as in --set "profiles.gauge=1432 mm"; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "wheelset")]
    pub(crate) overrides: Vec<String>,

    #[command(flatten)]
    pub(crate) results: ResultsArguments,
}
