//! Records of a rail that users give: files, heights or spectra.

use std::path::{Path, PathBuf};

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel_keys::Message;
use riffel_keys::quantity::Quantity;
use riffel_rail::{
    EarlierRails, LabelledSpectrum, Layout, LengthUnit, Rail, RailRecord, RailRoughness, ReaderFormat, RoughnessFile,
    Survey, coarse_sampling, unlike_a_rail,
};

use crate::array::owned;
use crate::arrays_of_rails::{Stretch, profiles, spectrum};
use crate::errors::{of_case, wrong};
use crate::interrupt::interruptible;

/// Labels of a spectrum, its wavelengths \[m\] and levels.
type LabelledLevels<'py> = (Vec<(String, String)>, (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>));

/// What was measured: a file, the spacing and rails of a profile, or spectra.
#[derive(FromPyObject)]
pub(crate) enum GivenRoughness<'py> {
    File(PathBuf),
    Profile((f64, Vec<(String, Vec<Stretch<'py>>)>)),
    Spectra(Vec<LabelledLevels<'py>>),
}

/// How files are laid out: reader profile, step of a file without positions \[m\], units of heights and positions.
#[derive(FromPyObject)]
pub(crate) struct GivenLayout(Option<PathBuf>, Option<f64>, Option<String>, Option<String>);

impl GivenLayout {
    pub(crate) fn layout(self) -> PyResult<Layout> {
        let Self(format, spacing, height_unit, position_unit) = self;
        let format = format.as_deref().map(ReaderFormat::read).transpose();
        let unit = |name: &str, unit: Option<String>| {
            let unit = unit.map(|unit| unit.parse::<LengthUnit>()).transpose();
            unit.map_err(|error| wrong(format!("{name}: {error}")))
        };
        Ok(Layout {
            format: format.map_err(of_case)?,
            spacing: spacing.map(Quantity::new),
            height_unit: unit("height_unit", height_unit)?,
            position_unit: unit("position_unit", position_unit)?,
        })
    }
}

pub(crate) fn read(py: Python<'_>, path: &Path, layout: &Layout) -> PyResult<RoughnessFile> {
    let (path, layout) = (path.to_owned(), layout.clone());
    let file = interruptible(py, move || RoughnessFile::read(&path, &layout, &|_| ()))?;
    file.map_err(of_case)
}

/// A date as in 2026-01-31, from any way to write it that leaves no doubt.
#[pyfunction]
pub(crate) fn read_date(text: &str) -> PyResult<String> {
    let date = riffel_rail::read_date(text).map_err(|said| wrong(said.to_string()))?;
    Ok(date.to_string())
}

/// A record whose numbers need the interpreter no more.
pub(crate) struct Record {
    name: PathBuf,
    /// As in 2026-01-31.
    date: Option<String>,
    roughness: Roughness,
}

enum Roughness {
    Profile(Vec<Rail>, Dated, Vec<Message>),
    Spectra(Vec<LabelledSpectrum>),
}

/// The date of rails, and the rails before.
type Dated = Option<(jiff::civil::Date, Vec<EarlierRails>)>;

impl Record {
    pub(crate) fn new(
        py: Python<'_>,
        (name, date, given): &(PathBuf, Option<String>, GivenRoughness<'_>),
        layout: &Layout,
    ) -> PyResult<Self> {
        let roughness = match given {
            GivenRoughness::File(path) => match read(py, path, layout)? {
                RoughnessFile::Profile(record) => {
                    let dated = record.date.map(|date| (date, record.earlier));
                    Roughness::Profile(record.rails, dated, record.warnings)
                }
                RoughnessFile::Spectra(spectra, _) => Roughness::Spectra(spectra),
            },
            GivenRoughness::Profile((spacing, given)) => {
                let mut rails = Vec::new();
                for (name, stretches) in given {
                    rails.push(Rail { name: name.clone(), stretches: profiles(stretches, *spacing)? });
                }
                let doubts = unlike_a_rail(&rails);
                let warnings = coarse_sampling(*spacing).into_iter().chain(doubts);
                Roughness::Profile(rails, None, warnings.collect())
            }
            GivenRoughness::Spectra(spectra) => Roughness::Spectra(labelled(spectra)?),
        };
        Ok(Self { name: name.clone(), date: date.clone(), roughness })
    }

    pub(crate) fn borrowed(&self) -> RailRecord<'_> {
        RailRecord {
            name: &self.name,
            // Checked where it was given.
            date: self.date.as_ref().and_then(|date| date.parse().ok()),
            roughness: match &self.roughness {
                Roughness::Profile(rails, dated, warnings) => RailRoughness::Profile {
                    rails,
                    before: dated.as_ref().map(|(date, before)| (*date, &before[..])),
                    warnings,
                },
                Roughness::Spectra(spectra) => RailRoughness::Spectra(spectra),
            },
        }
    }
}

fn labelled(spectra: &[LabelledLevels<'_>]) -> PyResult<Vec<LabelledSpectrum>> {
    let labelled = spectra.iter().map(|(labels, (wavelengths, levels))| {
        Ok(LabelledSpectrum { labels: labels.clone(), spectrum: spectrum(&owned(wavelengths), &owned(levels))? })
    });
    labelled.collect()
}

/// The records of a rail whose profile was measured twice, place by place; `None` of others.
pub(crate) fn places_of_both(
    py: Python<'_>,
    earlier: &(PathBuf, GivenRoughness<'_>),
    later: &(PathBuf, GivenRoughness<'_>),
    layout: &Layout,
) -> PyResult<Option<[Survey; 2]>> {
    let (GivenRoughness::File(before), GivenRoughness::File(now)) = (&earlier.1, &later.1) else {
        return Ok(None);
    };
    let growing = |path| Ok::<_, PyErr>(read(py, path, layout)?.without_defects());
    let (before, now) = (growing(before)?, growing(now)?);
    let names = (earlier.0.clone(), later.0.clone());
    let places = interruptible(py, move || Survey::at_same_places((&names.0, &before), (&names.1, &now)))?;
    places.map_err(of_case)
}

/// The spectra of what was measured, those of a profile in a file computed.
pub(crate) fn survey(
    py: Python<'_>,
    (name, given): &(PathBuf, GivenRoughness<'_>),
    layout: &Layout,
) -> PyResult<Survey> {
    let survey = match given {
        GivenRoughness::File(path) => {
            let (name, file) = (name.clone(), read(py, path, layout)?);
            interruptible(py, move || Survey::of(&name, file.without_defects()))?
        }
        GivenRoughness::Spectra(spectra) => Survey::new(name, labelled(spectra)?, Vec::new()),
        GivenRoughness::Profile(_) => {
            return Err(wrong("heights have no level without their spectrum"));
        }
    };
    survey.map_err(of_case)
}
