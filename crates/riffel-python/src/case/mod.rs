//! A case, with everything that is computed of it alone.

mod points;
mod portable;
mod ridge;
mod work;

use std::path::PathBuf;
use std::sync::Arc;

use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadwriteArray2};
use points::{Column, columns};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use ridge::over_speed;
use riffel::growth::Bay;
use riffel::receptance::DecayRate;
use riffel::tile::TILE;
use riffel::{Direction, GrowthMap};
use riffel_answers::contact::{ContactPatch, CreepCurves, FrequencyResponse, RollingTheories};
use riffel_answers::receptance::ReceptanceCurves;
use riffel_answers::ridge::{BranchDocument, best_fit_frequency};
use riffel_case::{CaseContact, CaseStructure, DrawnSupports, ask};
use work::ends;

use crate::array::owned;
use crate::document::{document, sentences};
use crate::errors::{of_case, wrong};
use crate::interrupt::{interruptible, interruptible_while};
use crate::receptance_arg::{self, CallableReceptance};
use crate::tables;

pub(crate) use portable::PortableCase;

type Real<'py> = Bound<'py, PyArray1<f64>>;
type Complex<'py> = Bound<'py, PyArray1<Complex64>>;
/// Input, output, its name, response and error.
type Response<'py> = (&'static str, &'static str, &'static str, Complex<'py>, Real<'py>);

/// A case, checked and complete.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Case {
    pub(crate) case: Arc<riffel_case::Case>,
    /// Receptances that are asked in Python, for their failures.
    pub(crate) callables: Vec<Arc<CallableReceptance>>,
}

/// Overrides `key=value` of a dict of dotted keys.
pub(crate) fn assignments(overrides: &Bound<'_, PyDict>) -> PyResult<Vec<String>> {
    overrides
        .iter()
        .map(|(key, item)| {
            let key: String = key.extract()?;
            let value = tables::value(&item, &key)?;
            Ok(format!("{key}={value}"))
        })
        .collect()
}

pub(crate) fn direction(name: &str) -> PyResult<Direction> {
    match name {
        "vertical" => Ok(Direction::Vertical),
        "lateral" => Ok(Direction::Lateral),
        "longitudinal" => Ok(Direction::Longitudinal),
        _ => Err(wrong(format!("direction is \"{name}\", but must be \"vertical\", \"lateral\" or \"longitudinal\""))),
    }
}

impl Case {
    pub(crate) fn new(case: riffel_case::Case) -> Self {
        Self { case: Arc::new(case), callables: Vec::new() }
    }
}

#[pymethods]
impl Case {
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf, overrides: &Bound<'_, PyDict>) -> PyResult<Self> {
        let overrides = assignments(overrides)?;
        let case = interruptible(py, move || riffel_case::Case::read(&path, &overrides))?;
        case.map(Self::new).map_err(of_case)
    }

    #[staticmethod]
    fn parse(py: Python<'_>, text: String, name: String, overrides: &Bound<'_, PyDict>) -> PyResult<Self> {
        let overrides = assignments(overrides)?;
        let case = interruptible(py, move || riffel_case::Case::parse(&name, &text, &overrides))?;
        case.map(Self::new).map_err(of_case)
    }

    #[staticmethod]
    fn from_dict(py: Python<'_>, keys: &Bound<'_, PyDict>) -> PyResult<Self> {
        let text = tables::table(keys, "")?.to_string();
        let case = interruptible(py, move || riffel_case::Case::parse("", &text, &[]))?;
        case.map(Self::new).map_err(of_case)
    }

    fn with_overrides(&self, py: Python<'_>, overrides: &Bound<'_, PyDict>) -> PyResult<Self> {
        let overrides = assignments(overrides)?;
        let case = self.compute(py, move |case| case.with(&overrides[..]))?;
        Ok(Self { case: Arc::new(case.map_err(of_case)?), callables: self.callables.clone() })
    }

    fn with_track(&self, py: Python<'_>, track: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.with_given(py, track, "track", CaseStructure::Track)
    }

    fn with_wheel(&self, py: Python<'_>, wheel: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.with_given(py, wheel, "wheel", CaseStructure::Wheel)
    }

    /// A case that was written, with the receptances that were given with it.
    #[staticmethod]
    fn restore(
        py: Python<'_>,
        portable: &PortableCase,
        track: Option<&Bound<'_, PyAny>>,
        wheel: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let mut callables = Vec::new();
        let mut extract = |given: Option<&Bound<'_, PyAny>>, what| {
            let (receptance, callable) = match given {
                Some(given) => {
                    let (receptance, callable) = receptance_arg::extract(given, what)?;
                    (Some(receptance), callable)
                }
                None => (None, None),
            };
            callables.extend(callable);
            PyResult::Ok(receptance)
        };
        let (track, wheel) = (extract(track, "track")?, extract(wheel, "wheel")?);
        let portable = portable.0.clone();
        let built = interruptible(py, move || portable.restore(track, wheel))?;
        Self::built(built, callables)
    }

    /// What makes the case anew elsewhere.
    fn portable(&self) -> PortableCase {
        PortableCase(riffel_case::PortableCase::of(&self.case))
    }

    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut table = toml::Table::try_from(&self.case.file).map_err(|error| wrong(error.to_string()))?;
        // What the wear measured has made is none of the keys beside it.
        if self.case.file.wear.measured.is_some()
            && let Some(wear) = table.get_mut("wear").and_then(toml::Value::as_table_mut)
        {
            wear.remove("coefficient");
        }
        document(py, &table)
    }

    #[getter]
    fn title(&self) -> Option<String> {
        self.case.file.title.clone()
    }

    #[getter]
    fn remarks(&self) -> Vec<String> {
        sentences(&self.case.remarks)
    }

    /// Wavelengths of the window.
    fn wavelengths<'py>(&self, py: Python<'py>) -> Real<'py> {
        self.case.wavelength.values().into_pyarray(py)
    }

    /// Speeds of the window.
    fn speeds<'py>(&self, py: Python<'py>) -> Real<'py> {
        self.case.speed.values().into_pyarray(py)
    }

    /// What the growth rate at a point answers to: key, unit, value, derivative, elasticity and its error of each.
    fn sensitivities(
        &self,
        py: Python<'_>,
        wavelength: f64,
        speed: f64,
    ) -> PyResult<Vec<(String, &'static str, f64, f64, f64, f64)>> {
        let case = self.case.clone();
        let all = interruptible(py, move || ask::sensitivities(&case, wavelength, speed))?;
        let all = self.unless_callable_failed(all)?.map_err(of_case)?;
        let row =
            |one: riffel_case::Sensitivity| (one.key, one.unit, one.value, one.derivative, one.elasticity, one.error);
        Ok(all.into_iter().map(row).collect())
    }

    /// Growth on supports at drawn distances: places, growth at each, growth over a bay of equal ones, and where the supports stand.
    fn growth_on_irregular_supports(
        &self,
        py: Python<'_>,
        point: [f64; 2],
        deviation: f64,
        supports: usize,
        seed: u64,
    ) -> PyResult<[Vec<f64>; 4]> {
        let [wavelength, speed] = point;
        let drawn = DrawnSupports { deviation, supports, seed };
        let case = self.case.clone();
        let growth = interruptible(py, move || ask::growth_on_irregular_supports(&case, wavelength, speed, drawn))?;
        let growth = self.unless_callable_failed(growth)?.map_err(of_case)?;
        Ok([growth.places, growth.growth_rates, growth.even, growth.supports])
    }

    /// Quantities at pairs of wavelength and speed: key, unit, name and values of each.
    fn points<'py>(
        &self,
        py: Python<'py>,
        wavelengths: PyReadonlyArray1<'py, f64>,
        speeds: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<Column<'py>>> {
        let (wavelengths, speeds) = (owned(&wavelengths), owned(&speeds));
        let case = self.over(py, &wavelengths, &speeds)?;
        let points = points::at(py, case, wavelengths, speeds)?;
        let points = self.unless_callable_failed(points)?;
        columns(py, &points)
    }

    /// Write Ŵ₁ to `values`, a row for each speed, filled up to whole tiles. While it is computed `meanwhile` is called
    /// with the growth rate for Ŵ₁ = 1; its result is returned.
    fn growth_map<'py>(
        &self,
        py: Python<'py>,
        wavelengths: PyReadonlyArray1<'py, f64>,
        speeds: PyReadonlyArray1<'py, f64>,
        mut values: PyReadwriteArray2<'py, Complex64>,
        meanwhile: &Bound<'py, PyAny>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (wavelengths, speeds) = (owned(&wavelengths), owned(&speeds));
        let case = self.over(py, &wavelengths, &speeds)?;
        let rate = case.feedback.growth_rate_per_dissipation();
        let (tiles, _) = values.as_slice_mut()?.as_chunks_mut::<TILE>();
        let work = || GrowthMap::compute_into(&case.feedback, &wavelengths, &speeds, tiles, |_| ());
        let give_up = |error: &PyErr| {
            for callable in &self.callables {
                callable.fail(error.clone_ref(py));
            }
        };
        let done = interruptible_while(py, work, || meanwhile.call1((rate,)), give_up);
        self.unless_callable_failed(done)?
    }

    /// Ŵ₁ over a support, in mid-span and in the mean over the bay, over the window of the case.
    fn bay_maps<'py>(&self, py: Python<'py>) -> PyResult<([Bound<'py, PyArray2<Complex64>>; 3], f64)> {
        self.case.check_window().map_err(of_case)?;
        let track = self.case.track.structure.clone();
        let bay = track.and_then(|track| Bay::new(&self.case.feedback, track));
        let Some(bay) = bay else {
            return Err(wrong(format!(
                "growth over the bay needs discrete supports, but track.model = \"{}\" is the same everywhere along \
                 the rail",
                self.case.file.track.model.name()
            )));
        };
        let maps = self.compute(py, move |case| bay.maps(case.wavelength, case.speed, |_| ()))?;
        let rate = self.case.feedback.growth_rate_per_dissipation();
        let array = |map: &GrowthMap| {
            let values: Vec<Complex64> = map.rows().flat_map(|(_, row)| row).copied().collect();
            let shape = [map.speed().points(), map.wavelength().points()];
            values.into_pyarray(py).reshape(shape)
        };
        let arrays = [array(&maps.over_support)?, array(&maps.mid_span)?, array(&maps.mean)?];
        Ok((arrays, rate))
    }

    /// Wavelength, frequency, Re Ŵ₁, growth rate and whether it sits at the edge, for each speed; and the
    /// frequency of the strongest branch.
    fn ridge<'py>(
        &self,
        py: Python<'py>,
        wavelength: (f64, f64, usize),
        speeds: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<([Real<'py>; 4], Bound<'py, PyArray1<bool>>, Option<f64>)> {
        let (_, ridge) = self.search_ridge(py, wavelength, &speeds)?;
        let (columns, edges) = over_speed(py, &ridge.points);
        Ok((columns, edges, best_fit_frequency(&ridge)))
    }

    /// Of each branch of the ridge, the strongest first: its frequency, highest growth rate and mechanism; speed,
    /// wavelength, frequency, Re Ŵ₁ and growth rate of its points; and whether each sits at the edge.
    #[expect(clippy::type_complexity, reason = "columns of a dataset")]
    fn ridge_branches<'py>(
        &self,
        py: Python<'py>,
        wavelength: (f64, f64, usize),
        speeds: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<(Bound<'py, PyDict>, [Real<'py>; 5], Bound<'py, PyArray1<bool>>)>> {
        let (case, ridge) = self.search_ridge(py, wavelength, &speeds)?;
        let documents = self.unless_callable_failed(BranchDocument::all(&case, &ridge))?;
        let branches = documents.iter().zip(&ridge.branches);
        branches
            .map(|(document, branch)| {
                let known = PyDict::new(py);
                known.set_item("frequency", document.frequency_hz)?;
                known.set_item("growth_rate", document.highest_growth_rate_per_passage)?;
                known.set_item("mechanism", document.mechanism)?;
                let points = branch.points();
                let speeds: Vec<f64> = points.iter().map(|point| point.speed).collect();
                let (columns, edges) = over_speed(py, points);
                let [wavelength, frequency, dissipation, rate] = columns;
                let speeds = speeds.into_pyarray(py);
                let columns = [speeds, wavelength, frequency, dissipation, rate];
                Ok((known, columns, edges))
            })
            .collect()
    }

    /// Frequencies, and key, name and receptance of each joint.
    fn receptance<'py>(
        &self,
        py: Python<'py>,
        frequencies: Option<PyReadonlyArray1<'py, f64>>,
        speed: Option<f64>,
        direction: &str,
    ) -> PyResult<(Real<'py>, Vec<(&'static str, &'static str, Complex<'py>)>)> {
        /// Of the program.
        const POINTS: u32 = 600;
        let direction = self::direction(direction)?;
        let track = self.case.track_in(direction).map_err(of_case)?;
        let speed = speed.unwrap_or_else(|| self.case.speed.max());
        let frequencies = match frequencies {
            Some(frequencies) => owned(&frequencies),
            None => {
                let (from, to) = ReceptanceCurves::default_range(&*track.receptance);
                ReceptanceCurves::frequencies(from, to, POINTS)
            }
        };
        let (lowest, highest) = ends(&frequencies);
        self.case.check_frequencies(lowest, highest).map_err(of_case)?;
        let curves =
            self.compute(py, move |case| ReceptanceCurves::new(case, &track, direction, speed, frequencies))?;
        let all = curves.joints.into_iter().chain(curves.places);
        let all = all.map(|curve| (curve.key, curve.label, curve.values.into_pyarray(py)));
        Ok((curves.frequencies.into_pyarray(py), all.collect()))
    }

    /// Name, frequency and modulus of the receptance at each resonance of the track.
    fn resonances(&self, py: Python<'_>) -> PyResult<Vec<(String, f64, f64)>> {
        self.compute(py, |case| {
            ask::resonances(case)
                .iter()
                .map(|resonance| {
                    (
                        resonance.kind.to_string(),
                        resonance.angular_frequency / std::f64::consts::TAU,
                        resonance.receptance.norm(),
                    )
                })
                .collect()
        })
    }

    /// Frequency of the P2 resonance in closed form \[Hz\]; `None` if the case has none.
    fn p2_closed_form(&self) -> Option<f64> {
        let closed = ask::p2_closed_form(&self.case)?;
        Some(closed.angular_frequency() / std::f64::consts::TAU)
    }

    /// Nominal frequency, decay rate and whether it is an upper bound, for each one-third octave.
    fn decay_rate(&self, py: Python<'_>, direction: &str) -> PyResult<Vec<(f64, f64, bool)>> {
        let track = self.case.track_in(self::direction(direction)?).map_err(of_case)?;
        let Some(structure) = track.structure.filter(|_| track.support.is_some()) else {
            return Err(wrong(
                "a decay rate needs a track whose supports are known: a rail without support hardly decays",
            ));
        };
        self.compute(py, move |_| {
            DecayRate::of_track(&*structure)
                .iter()
                .map(|rate| (rate.nominal_frequency, rate.decay_rate, rate.upper_bound))
                .collect()
        })
    }

    /// Creepages, and key, name and tractive ratio of each law.
    fn creep_curve<'py>(
        &self,
        py: Python<'py>,
        creepages: Option<PyReadonlyArray1<'py, f64>>,
    ) -> PyResult<(Real<'py>, Vec<(&'static str, &'static str, Real<'py>)>)> {
        let creepages = creepages.map(|creepages| owned(&creepages));
        let curves = self.compute(py, move |case| {
            let theories = CaseContact::of(case).and_then(RollingTheories::new)?;
            let creepages = creepages.unwrap_or_else(|| theories.default_creepages());
            CreepCurves::new(&theories, creepages, || ())
        })?;
        let curves = curves.map_err(of_case)?;
        let laws = curves.laws.into_iter();
        let laws = laws.map(|law| (law.key, law.label, law.tractive_ratios.into_pyarray(py)));
        Ok((curves.creepages.into_pyarray(py), laws.collect()))
    }

    /// Wavelengths over the semi-axis; input, output, name, response and error of each pair; and whether they are responses
    /// over the quasi-static ones.
    fn frequency_response<'py>(
        &self,
        py: Python<'py>,
        ratios: Option<PyReadonlyArray1<'py, f64>>,
    ) -> PyResult<(Real<'py>, Vec<Response<'py>>, bool)> {
        let ratios = ratios.map(|ratios| owned(&ratios));
        let response = self.compute(py, move |case| {
            let theories = CaseContact::of(case).and_then(RollingTheories::new)?;
            theories.check_slope()?;
            let ratios = ratios.unwrap_or_else(FrequencyResponse::default_ratios);
            FrequencyResponse::new(&theories, ratios, || ())
        })?;
        let response = response.map_err(of_case)?;
        let inputs = response.inputs.into_iter();
        let all = inputs.flat_map(|input| {
            input.outputs.into_iter().map(move |output| {
                let values = output.values.into_pyarray(py);
                let errors = output.errors.into_pyarray(py);
                (input.key, output.key, output.name, values, errors)
            })
        });
        let all = all.collect();
        Ok((response.ratios.into_pyarray(py), all, response.normalized))
    }

    /// The contact patch by the keys of `riffel contact --json`.
    fn contact<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let laws = self.case.creep_laws().map_err(of_case)?;
        let steady = self.compute(py, |case| CaseContact::of(case)?.steady())?;
        document(py, &ContactPatch::new(&self.case.hertz, laws.kalker, &steady.map_err(of_case)?))
    }
}
