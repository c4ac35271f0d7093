//! Arguments of `roughness`, `diagnose` and `report`.

use std::path::PathBuf;

use clap::Args;
use riffel::roughness::{AnalysisSettings, GrindSettings};
use riffel_answers::diagnose::DiagnosedRail;
use riffel_answers::question::{RecordLayout, Source};
use riffel_answers::roughness::ProfileRequest;
use riffel_keys::quantity::{Frequency, Length, Quantity};
use riffel_rail::LengthUnit;

use super::number::plain_number;
use super::{Earlier, Ground, HoldArgument};

/// How files of roughness are laid out, and what is taken of them.
#[derive(Args, Default)]
pub(crate) struct Layout {
    /// Reader profile that says how profiles are laid out [default: found from their first lines].
    #[arg(long, value_name = "TOML")]
    pub(crate) format: Option<PathBuf>,

    /// Step between samples of files without positions, in metres or with its unit.
    #[arg(long, value_name = "LENGTH")]
    pub(crate) spacing: Option<Quantity<Length>>,

    /// Unit of the heights, as mm or um, whatever the file says [default: that of its head or of a remark, else um].
    #[arg(long, value_name = "UNIT")]
    pub(crate) height_unit: Option<LengthUnit>,

    /// Unit of the positions, as m or km, whatever the file says [default: that of its head or of a remark, else by
    /// their step].
    #[arg(long, value_name = "UNIT")]
    pub(crate) position_unit: Option<LengthUnit>,

    #[command(flatten)]
    pub(crate) part: Part,

    /// Keep welds, joints and squats in the spectra of a profile that are diagnosed, forecast or heard [default: they are
    /// listed and left out; limits and marches in time always have them].
    #[arg(long)]
    pub(crate) keep_defects: bool,
}

/// One rail, or a place along the line.
#[derive(Args, Clone, Default)]
pub(crate) struct Part {
    /// Take this rail alone [default: all, each judged on its own].
    #[arg(long, value_name = "NAME")]
    pub(crate) rail: Option<String>,

    /// Take profiles from this position on, as in --from "12.4 km".
    #[arg(long, value_name = "POSITION", allow_negative_numbers = true)]
    pub(crate) from: Option<Quantity<Length>>,

    /// Take profiles up to this position.
    #[arg(long, value_name = "POSITION", allow_negative_numbers = true)]
    pub(crate) to: Option<Quantity<Length>>,
}

impl Layout {
    /// The same in a question.
    pub(crate) fn records(&self) -> RecordLayout {
        RecordLayout {
            format: self.format.clone().map(Source::File),
            spacing: self.spacing,
            height_unit: self.height_unit.clone(),
            position_unit: self.position_unit.clone(),
            rail: self.part.rail.clone(),
            from: self.part.from,
            to: self.part.to,
            keep_defects: self.keep_defects,
        }
    }

    /// The first argument given.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let given = [
            ("--format", self.format.is_some()),
            ("--spacing", self.spacing.is_some()),
            ("--height-unit", self.height_unit.is_some()),
            ("--position-unit", self.position_unit.is_some()),
            ("--keep-defects", self.keep_defects),
        ];
        let first = given.into_iter().find(|(_, is)| *is);
        first.map(|(name, _)| name).or_else(|| self.part.given())
    }
}

impl Part {
    /// The first argument given.
    fn given(&self) -> Option<&'static str> {
        let given = [("--rail", self.rail.is_some()), ("--from", self.from.is_some()), ("--to", self.to.is_some())];
        given.into_iter().find(|(_, is)| *is).map(|(name, _)| name)
    }
}

/// What is computed of a profile.
#[derive(Args)]
pub(crate) struct Statistics {
    /// Longest wavelength of the spectrum [default: a quarter of the record, at most 2 m].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) longest: Option<Quantity<Length>>,

    /// Window of the moving RMS and peak-to-peak value [default: ten of the longest wavelength of each
    /// band, at least 1 m].
    #[arg(long, value_name = "LENGTH")]
    pub(crate) window: Option<Quantity<Length>>,

    /// Length of the blocks whose RMS is tabled.
    #[arg(long, value_name = "LENGTH", default_value_t = Self::default().block)]
    pub(crate) block: Quantity<Length>,

    /// Good length up to which two sections are ground as one.
    #[arg(long, value_name = "LENGTH", default_value_t = Self::default().merge)]
    pub(crate) merge: Quantity<Length>,

    /// Shortest length that is ground; shorter sections are widened to it.
    #[arg(long, value_name = "LENGTH", default_value_t = Self::default().grinding_length)]
    pub(crate) grinding_length: Quantity<Length>,
}

impl Statistics {
    /// What is asked of a profile.
    pub(crate) fn request(&self) -> ProfileRequest {
        ProfileRequest {
            longest: self.longest,
            window: self.window.map(|window| window.si()),
            block: self.block.si(),
            grinding: GrindSettings { merge: self.merge.si(), shortest: self.grinding_length.si() },
        }
    }
}

impl Default for Statistics {
    fn default() -> Self {
        Self {
            longest: None,
            window: None,
            block: Quantity::new(AnalysisSettings::default().block),
            merge: Quantity::new(GrindSettings::default().merge),
            grinding_length: Quantity::new(GrindSettings::default().shortest),
        }
    }
}

#[derive(Args)]
#[command(
    after_help = "Example: riffel roughness --synthesise -o profile.csv && riffel roughness profile.csv -o results\n\n\
        A file whose heights are in mm and does not say so: riffel roughness trolley.txt --height-unit mm"
)]
pub(crate) struct Roughness {
    /// Longitudinal profile, or table of one-third-octave levels: text in columns, or - for standard input.
    #[arg(value_name = "FILE", required_unless_present = "synthesise")]
    pub(crate) path: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) layout: Layout,

    /// Save how the file was read as a reader profile.
    #[arg(long, value_name = "TOML")]
    pub(crate) save_format: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) statistics: Statistics,

    /// Limit table, by name or as a TOML file; may be repeated [default: iso-3095-2013, grassie-1999].
    #[arg(long, value_name = "LIMIT")]
    pub(crate) limit: Vec<String>,

    /// Curves, stations, welds and joints along the line, told with the sections of a profile: a table with the columns position, or
    /// from and to, and kind and name.
    #[arg(long, value_name = "FILE")]
    pub(crate) along: Option<PathBuf>,

    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[arg(long = "where", value_name = "COLUMN=VALUE")]
    pub(crate) choose: Vec<String>,

    /// Group the spectra of a table by a column and compare the groups.
    #[arg(long, value_name = "COLUMN")]
    pub(crate) by: Option<String>,

    /// Make a profile to a recipe instead of reading one [default recipe: built in]; written to --output or
    /// to standard output.
    #[arg(long, value_name = "RECIPE", num_args = 0..=1, conflicts_with = "path")]
    pub(crate) synthesise: Option<Option<PathBuf>>,

    /// Folder for the results, made if need be [default: FILE-roughness]; with --synthesise the file.
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: Option<PathBuf>,

    /// With --synthesise, replace the file if it is there.
    #[arg(long, requires = "synthesise")]
    pub(crate) force: bool,

    /// Print one JSON document; files are written only with --output.
    #[arg(long)]
    pub(crate) json: bool,
}

/// A measured rail held against a case: what `diagnose` and `report` have in common.
#[derive(Args)]
pub(crate) struct DiagnosisArguments {
    #[command(flatten)]
    pub(crate) layout: Layout,

    #[command(flatten)]
    pub(crate) earlier: Earlier,

    /// Keep the spectra of a table whose column has this value; may be repeated.
    #[arg(long = "where", value_name = "COLUMN=VALUE")]
    pub(crate) choose: Vec<String>,

    /// Column of a table that tells its records apart in time [default: date, if there is one].
    #[arg(long, value_name = "COLUMN")]
    pub(crate) by: Option<String>,

    /// Speeds of the traffic, as "80 km/h" or a range "60 km/h..90 km/h"; may be repeated [default: those
    /// of the map of the case].
    #[arg(long, value_name = "SPEED")]
    pub(crate) speed: Vec<String>,

    /// Traffic file, for the speeds of its vehicles where no --speed is given, and for growth and forecast of a report.
    #[arg(long, value_name = "TOML")]
    pub(crate) traffic: Option<PathBuf>,

    /// Frequency of a torsional mode of the wheelset; may be repeated.
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) torsion: Vec<Quantity<Frequency>>,

    /// Frequency of a bending mode of the wheelset; may be repeated.
    #[arg(long, value_name = "FREQUENCY")]
    pub(crate) bending: Vec<Quantity<Frequency>>,

    /// The record was taken from a vehicle, whose wheels are in it, and not with a trolley.
    #[arg(long)]
    pub(crate) from_vehicle: bool,
}

impl DiagnosisArguments {
    /// The same in a question.
    pub(crate) fn rail(&self) -> DiagnosedRail {
        DiagnosedRail {
            layout: self.layout.records(),
            earlier: self.earlier.records(),
            choose: self.choose.clone(),
            by: self.by.clone(),
            speed: self.speed.clone(),
            traffic: self.traffic.clone().map(Source::File),
            torsion: self.torsion.clone(),
            bending: self.bending.clone(),
            from_vehicle: self.from_vehicle,
        }
    }

    /// The first argument given of those that speak of a rail.
    pub(crate) fn given(&self) -> Option<&'static str> {
        let given = [
            ("--format", self.layout.format.is_some()),
            ("--spacing", self.layout.spacing.is_some()),
            ("--height-unit", self.layout.height_unit.is_some()),
            ("--position-unit", self.layout.position_unit.is_some()),
            ("--earlier", !self.earlier.files.is_empty()),
            ("--where", !self.choose.is_empty()),
            ("--by", self.by.is_some()),
            ("--keep-defects", self.layout.keep_defects),
            ("--speed", !self.speed.is_empty()),
            ("--torsion", !self.torsion.is_empty()),
            ("--bending", !self.bending.is_empty()),
            ("--from-vehicle", self.from_vehicle),
        ];
        let own = given.into_iter().find(|(_, is)| *is).map(|(name, _)| name);
        own.or(self.layout.part.given())
    }
}

#[derive(Args)]
#[command(
    after_help = "Example: riffel report case.toml --roughness profile.csv --traffic traffic.toml --with soft-pads.toml --site site.toml -o report.html\n\n\
        Without --roughness it is a report on the case alone: its growth map and, by --with, what would help.\n\n\
        With an earlier record and the traffic since then, the wear coefficient is fitted to the change, and where its 95 % \
        interval lies above zero the whole report goes by it in place of that of the case."
)]
pub(crate) struct Report {
    /// Case file, for growth map and diagnosis [default: none, and the report goes without them].
    #[arg(value_name = "CASE")]
    pub(crate) case: Option<PathBuf>,

    /// Override a value of the case, as in --set contact.friction=0.3; may be repeated.
    #[arg(long = "set", value_name = "KEY=VALUE", requires = "case")]
    pub(crate) overrides: Vec<String>,

    /// Longitudinal profile, or table of one-third-octave levels [default: none, and the report is on the case].
    #[arg(long, value_name = "FILE")]
    pub(crate) roughness: Option<PathBuf>,

    /// Folder of a finished calibration of the case: growth, what becomes of the rail, variants and noise over its draws.
    #[arg(long, value_name = "DIR", requires = "case")]
    pub(crate) posterior: Option<PathBuf>,

    #[command(flatten)]
    pub(crate) record: DiagnosisArguments,

    /// Limit table, by name or as a TOML file; may be repeated [default: iso-3095-2013, grassie-1999].
    #[arg(long, value_name = "LIMIT")]
    pub(crate) limit: Vec<String>,

    /// File of changes to the case, as for riffel compare; may be repeated.
    #[arg(long = "with", value_name = "TOML", requires = "case")]
    pub(crate) variants: Vec<PathBuf>,

    /// What variants of friction or load hold, as for riffel compare: force, ratio or creepage.
    #[arg(long, value_enum, value_name = "WHAT", requires = "variants", hide_possible_values = true)]
    pub(crate) hold: Option<HoldArgument>,

    #[command(flatten)]
    pub(crate) ground: Ground,

    /// Months that the forecast looks ahead.
    #[arg(
        long,
        value_name = "M",
        requires = "traffic",
        allow_negative_numbers = true,
        value_parser = plain_number
    )]
    pub(crate) months: Option<f64>,

    /// Let growth go by the wear coefficient of the case, also where another is fitted to the records; the fit is told.
    #[arg(long, requires = "case")]
    pub(crate) keep_coefficient: bool,

    /// Axle passages between the oldest --earlier and --roughness, to fit the wear coefficient to [default: from the dates
    /// and the traffic file].
    #[arg(
        long,
        value_name = "N",
        requires = "traffic",
        allow_negative_numbers = true,
        value_parser = plain_number
    )]
    pub(crate) passages_between: Option<f64>,

    /// Highest level of a passing coach that is allowed, to say in how many months it is reached.
    #[arg(
        long,
        value_name = "DECIBELS",
        requires = "traffic",
        allow_negative_numbers = true,
        value_parser = plain_number
    )]
    pub(crate) limit_dba: Option<f64>,

    /// Roughness of the wheels for rolling noise: a file of spectra, or cnossos-cast-iron-blocks, cnossos-composite-blocks or
    /// cnossos-disc-brakes [default: none, smooth wheels].
    #[arg(long, value_name = "FILE")]
    pub(crate) wheel_roughness: Option<String>,

    /// Modes of the web and tyre of the wheels for rolling noise by name, straight-web-920, or as a TOML file [default: none,
    /// rigid wheels].
    #[arg(long, value_name = "MODES")]
    pub(crate) wheel_modes: Option<String>,

    /// Title [default: that of the site, or "Rail roughness and corrugation"].
    #[arg(long, value_name = "WORDS")]
    pub(crate) title: Option<String>,

    /// TOML file with the table `site`: title, railway, line, track, place, measured_on, instrument, author,
    /// date, remarks.
    #[arg(long, value_name = "TOML")]
    pub(crate) site: Option<PathBuf>,

    /// Page to write.
    #[arg(short, long, value_name = "HTML", default_value = "report.html")]
    pub(crate) output: PathBuf,

    /// Replace the file if it is there and is no report of an earlier run.
    #[arg(long)]
    pub(crate) force: bool,
}
