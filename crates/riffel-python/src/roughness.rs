//! Roughness of arrays and of files.

use std::path::PathBuf;

use numpy::{IntoPyArray, PyArray1, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::Axis;
use riffel::diagnosis::{DominantWavelength, FineSpectrum, dominant_levels};
use riffel::roughness::{
    AnalysisSettings, BandPass, GrindSettings, PIT_DEPTH, Profile, RailAnalysis, RmsLimit, Spectrum, SpikeCriterion,
    WHEEL_RADIUS, WavelengthBand,
};
use riffel_rail::{DEFAULT_RECIPE, Limit, LimitTable, RecipeFile, RoughnessFile};

use crate::array::owned;
use crate::arrays_of_rails::{Stretch, profiles, spectrum};
use crate::document::sentences;
use crate::errors::{of_answer, of_case, of_physics, wrong};
use crate::interrupt::interruptible;
use crate::records::{LayoutArg, read};
use crate::tables;

type Real<'py> = Bound<'py, PyArray1<f64>>;

/// Wavelengths of the centres \[m\], nominal ones \[mm\] and levels.
type Levels<'py> = (Real<'py>, Real<'py>, Real<'py>);

fn levels<'py>(py: Python<'py>, spectrum: &Spectrum) -> Levels<'py> {
    let column = |value: fn(&riffel::roughness::BandLevel) -> f64| {
        spectrum.levels().iter().map(value).collect::<Vec<_>>().into_pyarray(py)
    };
    (
        column(|level| level.band.wavelength()),
        column(|level| level.band.nominal_millimetres()),
        column(|level| level.level),
    )
}

/// Equally spaced values, both ends included.
#[pyfunction]
pub(crate) fn axis(py: Python<'_>, min: f64, max: f64, points: usize) -> PyResult<Real<'_>> {
    let axis = Axis::new(min, max, points).map_err(of_physics)?;
    Ok(axis.values().into_pyarray(py))
}

/// Levels of mean squares \[m²\].
#[pyfunction]
pub(crate) fn level<'py>(py: Python<'py>, mean_squares: PyReadonlyArray1<'py, f64>) -> Real<'py> {
    let levels = mean_squares.as_array();
    let levels = levels.iter().map(|&square| riffel::roughness::level(square));
    levels.collect::<Vec<_>>().into_pyarray(py)
}

/// Mean squares \[m²\] of levels.
#[pyfunction]
pub(crate) fn mean_square<'py>(py: Python<'py>, levels: PyReadonlyArray1<'py, f64>) -> Real<'py> {
    let squares = levels.as_array();
    let squares = squares.iter().map(|&level| riffel::roughness::mean_square(level));
    squares.collect::<Vec<_>>().into_pyarray(py)
}

/// Heights without spikes, and where these were, in samples.
#[pyfunction]
pub(crate) fn remove_spikes<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray1<'py, f64>,
    spacing: f64,
) -> PyResult<(Real<'py>, Vec<(usize, usize)>)> {
    let mut profile = Profile::new(0.0, spacing, owned(&heights)).map_err(of_physics)?;
    let (profile, removed) = interruptible(py, move || {
        let removed = profile.remove_spikes(SpikeCriterion::EN_15610);
        (profile, removed)
    })?;
    let removed = removed.into_iter().map(|range| (range.start, range.end));
    Ok((profile.heights().to_vec().into_pyarray(py), removed.collect()))
}

/// What a wheel sees that rolls over, and where pits are, in samples.
#[pyfunction]
pub(crate) fn roll_over<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray1<'py, f64>,
    spacing: f64,
    radius: Option<f64>,
    pit_depth: Option<f64>,
) -> PyResult<(Real<'py>, Vec<(usize, usize)>)> {
    let mut profile = Profile::new(0.0, spacing, owned(&heights)).map_err(of_physics)?;
    let (radius, depth) = (radius.unwrap_or(WHEEL_RADIUS), pit_depth.unwrap_or(PIT_DEPTH));
    let (profile, pits) = interruptible(py, move || {
        let pits = profile.roll_over(radius, depth);
        (profile, pits)
    })?;
    let pits = pits.into_iter().map(|range| (range.start, range.end));
    Ok((profile.heights().to_vec().into_pyarray(py), pits.collect()))
}

/// One-third-octave levels of a record by method A of EN 15610.
#[pyfunction]
pub(crate) fn third_octaves<'py>(
    py: Python<'py>,
    stretches: Vec<Stretch<'py>>,
    spacing: f64,
    longest: f64,
) -> PyResult<Levels<'py>> {
    let stretches = profiles(&stretches, spacing)?;
    let spectrum = interruptible(py, move || Spectrum::of_record(&stretches, longest))?;
    Ok(levels(py, &spectrum.map_err(of_physics)?))
}

/// Heights between two wavelengths, without a shift.
#[pyfunction]
pub(crate) fn band_pass<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray1<'py, f64>,
    spacing: f64,
    from: f64,
    to: f64,
) -> PyResult<Real<'py>> {
    let profile = Profile::new(0.0, spacing, owned(&heights)).map_err(of_physics)?;
    let band = WavelengthBand::new(from, to).map_err(of_physics)?;
    if !BandPass::resolves(band, spacing) {
        return Err(wrong(format!("samples {spacing} m apart do not resolve wavelengths of {from} m")));
    }
    let filtered = interruptible(py, move || {
        let bank = BandPass::new(spacing, profile.heights().len(), &[band])?;
        Ok(bank.filter(&profile).swap_remove(0))
    })?;
    Ok(filtered.map_err(of_physics)?.into_pyarray(py))
}

/// Root mean square of each window.
#[pyfunction]
pub(crate) fn moving_rms<'py>(
    py: Python<'py>,
    values: PyReadonlyArray1<'py, f64>,
    window: usize,
) -> PyResult<Real<'py>> {
    let borrowed = values.as_slice()?;
    Ok(py.detach(|| riffel::roughness::moving_rms(borrowed, window)).into_pyarray(py))
}

/// Peak-to-peak value of each window.
#[pyfunction]
pub(crate) fn moving_peak_to_peak<'py>(
    py: Python<'py>,
    values: PyReadonlyArray1<'py, f64>,
    window: usize,
) -> PyResult<Real<'py>> {
    let borrowed = values.as_slice()?;
    Ok(py.detach(|| riffel::roughness::moving_peak_to_peak(borrowed, window)).into_pyarray(py))
}

/// Everything about one rail.
#[pyfunction]
pub(crate) fn analyse<'py>(
    py: Python<'py>,
    stretches: Vec<Stretch<'py>>,
    spacing: f64,
    longest: f64,
    window: Option<f64>,
    block: f64,
    limit: Option<&str>,
    merge: f64,
    grinding_length: f64,
) -> PyResult<Bound<'py, PyDict>> {
    let settings = AnalysisSettings {
        longest_wavelength: longest,
        window,
        block,
        limit: limit.map(rms_limit).transpose()?,
        ..AnalysisSettings::default()
    };
    let profiles = profiles(&stretches, spacing)?;
    let analysis = interruptible(py, move || RailAnalysis::new(profiles, &settings, &|| ()))?;
    let analysis = analysis.map_err(of_physics)?;
    let sections = analysis.grind(&GrindSettings { merge, shortest: grinding_length });
    let result = PyDict::new(py);
    result.set_item("spikes", analysis.spikes)?;
    result.set_item("pits", analysis.pits)?;
    result.set_item("segments", analysis.segments)?;
    result.set_item("segment_length", analysis.segment_length)?;
    result.set_item("spectrum", levels(py, &analysis.spectrum))?;
    let missing = |value: Option<f64>| value.unwrap_or(f64::NAN);
    let bands = analysis.bands.iter().map(|band| {
        vec![
            band.band.from(),
            band.band.to(),
            band.window,
            band.length,
            band.rms,
            band.moving_rms_max,
            band.peak_to_peak_max,
            missing(band.limit),
            missing(band.share_over_limit),
        ]
    });
    result.set_item("bands", bands.collect::<Vec<_>>())?;
    let blocks = analysis.blocks.iter().map(|block| {
        let rms = block.rms.iter().chain(&block.moving_rms_max);
        let rms = rms.map(|&rms| missing(rms));
        [block.from, block.to].into_iter().chain(rms).collect::<Vec<_>>()
    });
    result.set_item("blocks", blocks.collect::<Vec<_>>())?;
    let sections = sections
        .iter()
        .map(|section| vec![section.from, section.to, section.band.from(), section.band.to(), section.ratio]);
    result.set_item("sections", sections.collect::<Vec<_>>())?;
    Ok(result)
}

fn rms_limit(name: &str) -> PyResult<RmsLimit> {
    match LimitTable::find(name).map_err(of_case)?.limit {
        Limit::Rms(limit) => Ok(limit),
        Limit::Levels(_) => {
            Err(wrong(format!("limit is \"{name}\", but must be a table of RMS in bands of wavelength")))
        }
    }
}

/// Every limit table that comes with Riffel: name, title, edition, source, and its levels if it has any.
#[pyfunction]
pub(crate) fn limits(
    py: Python<'_>,
) -> Vec<(String, String, String, String, Option<Levels<'_>>, Vec<(f64, f64, f64)>)> {
    LimitTable::all()
        .into_iter()
        .map(|table| {
            let (of_levels, of_rms) = match &table.limit {
                Limit::Levels(limit) => (Some(levels(py, limit.spectrum())), Vec::new()),
                Limit::Rms(limit) => {
                    let bands = limit.bands().iter();
                    (None, bands.map(|(band, rms)| (band.from(), band.to(), *rms)).collect())
                }
            };
            (table.name, table.title.to_string(), table.edition, table.source, of_levels, of_rms)
        })
        .collect()
}

/// Bands of a spectrum that a limit speaks of: wavelengths, levels and limits.
#[pyfunction]
pub(crate) fn compare_with_limit<'py>(
    py: Python<'py>,
    wavelengths: PyReadonlyArray1<'py, f64>,
    levels: PyReadonlyArray1<'py, f64>,
    limit: &str,
) -> PyResult<Levels<'py>> {
    let spectrum = spectrum(&owned(&wavelengths), &owned(&levels))?;
    let compared = riffel_answers::level_limit(limit).map_err(of_answer)?.1.compare(&spectrum);
    let column = |value: fn(&riffel::roughness::LevelExcess) -> f64| {
        compared.iter().map(value).collect::<Vec<_>>().into_pyarray(py)
    };
    Ok((column(|band| band.band.wavelength()), column(|band| band.level), column(|band| band.limit)))
}

/// Mean of several spectra on mean squares.
#[pyfunction]
pub(crate) fn energy_mean<'py>(
    py: Python<'py>,
    spectra: Vec<(PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>)>,
) -> PyResult<Levels<'py>> {
    let spectra = spectra.iter().map(|(wavelengths, levels)| spectrum(&owned(wavelengths), &owned(levels)));
    let spectra = spectra.collect::<PyResult<Vec<_>>>()?;
    let mean = Spectrum::energy_mean(&spectra).ok_or_else(|| wrong("there is no spectrum to average"))?;
    Ok(levels(py, &mean))
}

/// Wavelength, its ends, level, prominence, scatter and false peaks.
type Dominant = (f64, f64, f64, f64, f64, Option<f64>, Option<f64>);

fn named(peaks: &[DominantWavelength]) -> Vec<Dominant> {
    let peaks = peaks
        .iter()
        .map(|peak| (peak.wavelength, peak.from, peak.to, peak.level, peak.prominence, peak.scatter, peak.false_peaks));
    peaks.collect()
}

/// Wavelengths that stand out of a profile.
#[pyfunction]
pub(crate) fn dominant_of_profile(
    py: Python<'_>,
    stretches: Vec<Stretch<'_>>,
    spacing: f64,
) -> PyResult<Vec<Dominant>> {
    let stretches = profiles(&stretches, spacing)?;
    let fine = interruptible(py, move || FineSpectrum::of_record(&stretches))?;
    Ok(named(&fine.map_err(of_physics)?.dominant()))
}

/// Wavelengths that stand out of one-third-octave spectra of the same rail.
#[pyfunction]
pub(crate) fn dominant_of_spectra(
    spectra: Vec<(PyReadonlyArray1<'_, f64>, PyReadonlyArray1<'_, f64>)>,
) -> PyResult<Vec<Dominant>> {
    let spectra = spectra.iter().map(|(wavelengths, levels)| spectrum(&owned(wavelengths), &owned(levels)));
    Ok(named(&dominant_levels(&spectra.collect::<PyResult<Vec<_>>>()?)))
}

/// A file: its spacing and rails where it holds profiles, else its labelled spectra; and warnings.
#[pyfunction]
pub(crate) fn read_roughness<'py>(
    py: Python<'py>,
    path: PathBuf,
    layout: LayoutArg,
) -> PyResult<(
    Option<(f64, Vec<(String, Vec<(f64, Real<'py>)>)>)>,
    Vec<(Vec<(String, String)>, Levels<'py>)>,
    Vec<String>,
)> {
    Ok(match read(py, &path, &layout.layout()?)? {
        RoughnessFile::Profile(record) => {
            let rails = record.rails.into_iter().map(|rail| {
                let stretches = rail
                    .stretches
                    .into_iter()
                    .map(|stretch| (stretch.start(), stretch.heights().to_vec().into_pyarray(py)));
                (rail.name, stretches.collect())
            });
            (Some((record.spacing, rails.collect())), Vec::new(), sentences(&record.warnings))
        }
        RoughnessFile::Spectra(spectra, warnings) => {
            let spectra = spectra.into_iter().map(|record| {
                let levels = levels(py, &record.spectrum);
                (record.labels, levels)
            });
            (None, spectra.collect(), sentences(&warnings))
        }
    })
}

/// Name, spacing and heights of each rail made to a recipe, by default that of the guide.
#[pyfunction]
pub(crate) fn synthesise<'py>(
    py: Python<'py>,
    recipe: Option<&Bound<'py, PyDict>>,
) -> PyResult<Vec<(String, f64, Real<'py>)>> {
    let text = match recipe {
        Some(recipe) => tables::table(recipe, "")?.to_string(),
        None => DEFAULT_RECIPE.to_owned(),
    };
    let rails = RecipeFile::parse("", &text).map_err(of_case)?.rails;
    let made = interruptible(py, move || {
        let rails = rails.into_iter();
        let rails = rails.map(|(name, recipe)| Ok((name, recipe.spacing, recipe.heights()?)));
        rails.collect::<Result<Vec<_>, riffel::Error>>()
    })?;
    let made = made.map_err(of_physics)?.into_iter();
    Ok(made.map(|(name, spacing, heights)| (name, spacing, heights.into_pyarray(py))).collect())
}
