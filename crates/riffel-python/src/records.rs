//! Records of a rail that users give: files, heights or spectra.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel_keys::quantity::Quantity;
use riffel_rail::{LabelledSpectrum, Layout, LengthUnit, Rail, ReaderFormat, RoughnessFile, Survey};

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

/// Heights or levels in memory, in place of a file.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Record {
    pub(crate) name: String,
    pub(crate) file: Arc<RoughnessFile>,
}

#[pymethods]
impl Record {
    /// Of the spacing and the rails of a profile, or of spectra.
    #[new]
    fn new(name: String, given: GivenRoughness<'_>) -> PyResult<Self> {
        let file = match given {
            GivenRoughness::Profile((spacing, given)) => {
                let rails = given
                    .into_iter()
                    .map(|(name, stretches)| Ok::<_, PyErr>(Rail { name, stretches: profiles(&stretches, spacing)? }));
                RoughnessFile::Profile(riffel_rail::Record::of_rails(rails.collect::<PyResult<_>>()?, spacing))
            }
            GivenRoughness::Spectra(spectra) => RoughnessFile::Spectra(labelled(&spectra)?, Vec::new()),
            GivenRoughness::File(path) => return Err(wrong(format!("{} is a file", path.display()))),
        };
        Ok(Self { name, file: Arc::new(file) })
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
