//! Arguments of files of roughness.

use std::path::PathBuf;

use clap::Args;
use riffel_answers::question::{RecordLayout, Source};
use riffel_keys::quantity::{Length, Quantity};
use riffel_rail::LengthUnit;

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
