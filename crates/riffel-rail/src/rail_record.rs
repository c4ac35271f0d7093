//! What was measured of a rail at one time.

use std::path::Path;

use jiff::civil::Date;
use riffel_keys::Message;

use crate::{EarlierRails, LabelledSpectrum, Rail, RoughnessFile};

/// A record of a rail: one file, or what another program has in memory.
#[derive(Debug, Clone, Copy)]
pub struct RailRecord<'a> {
    /// The file, or what the record is called.
    pub name: &'a Path,
    /// When it was measured.
    pub date: Option<Date>,
    /// What was measured.
    pub roughness: RailRoughness<'a>,
}

/// Heights or levels.
#[derive(Debug, Clone, Copy)]
pub enum RailRoughness<'a> {
    /// A longitudinal profile.
    Profile {
        /// Its rails as they were last.
        rails: &'a [Rail],
        /// The date of these and the rails before, where the file is of several dates.
        before: Option<(Date, &'a [EarlierRails])>,
        /// What was put right in it.
        warnings: &'a [Message],
    },
    /// One-third-octave spectra.
    Spectra(&'a [LabelledSpectrum]),
}

impl<'a> From<&'a RoughnessFile> for RailRoughness<'a> {
    fn from(file: &'a RoughnessFile) -> Self {
        match file {
            RoughnessFile::Profile(record) => Self::Profile {
                rails: &record.rails,
                before: (record.date).map(|date| (date, &record.earlier[..])),
                warnings: &record.warnings,
            },
            RoughnessFile::Spectra(spectra, _) => Self::Spectra(spectra),
        }
    }
}
