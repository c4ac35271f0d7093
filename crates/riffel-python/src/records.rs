//! Records of a rail that users give: files, heights or spectra.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use numpy::PyReadonlyArray1;
use pyo3::prelude::*;
use riffel_keys::quantity::Quantity;
use riffel_rail::{LabelledSpectrum, Layout, LengthUnit, Rail, ReaderFormat, RoughnessFile};

use crate::array::owned;
use crate::arrays_of_rails::{Stretch, profiles, spectrum};
use crate::errors::{of_case, wrong};
use crate::interrupt::interruptible;

/// Labels of a spectrum, its wavelengths \[m\] and levels.
type LabelledLevels<'py> = (Vec<(String, String)>, (PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>));

/// What was measured: the spacing and rails of a profile, or spectra.
#[derive(FromPyObject)]
pub(crate) enum RoughnessArg<'py> {
    Profile((f64, Vec<(String, Vec<Stretch<'py>>)>)),
    Spectra(Vec<LabelledLevels<'py>>),
}

/// How files are laid out: reader profile, step of a file without positions \[m\], units of heights and positions.
#[derive(FromPyObject)]
pub(crate) struct LayoutArg(Option<PathBuf>, Option<f64>, Option<String>, Option<String>);

impl LayoutArg {
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
    fn new(name: String, given: RoughnessArg<'_>) -> PyResult<Self> {
        let file = match given {
            RoughnessArg::Profile((spacing, given)) => {
                let rails = given
                    .into_iter()
                    .map(|(name, stretches)| Ok::<_, PyErr>(Rail { name, stretches: profiles(&stretches, spacing)? }));
                RoughnessFile::Profile(riffel_rail::Record::of_rails(rails.collect::<PyResult<_>>()?, spacing))
            }
            RoughnessArg::Spectra(spectra) => {
                let spectra = spectra.into_iter().map(|(labels, (wavelengths, levels))| {
                    let spectrum = spectrum(&owned(&wavelengths), &owned(&levels))?;
                    Ok::<_, PyErr>(LabelledSpectrum { labels, spectrum })
                });
                RoughnessFile::Spectra(spectra.collect::<PyResult<_>>()?, Vec::new())
            }
        };
        Ok(Self { name, file: Arc::new(file) })
    }
}
