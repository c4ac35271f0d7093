//! A case, with everything that is computed of it alone.

use std::path::PathBuf;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use num_complex::Complex64;
use numpy::{IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadwriteArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple, PyType};
use rayon::prelude::*;
use riffel::contact::KalkerCoefficients;
use riffel::growth::Bay;
use riffel::receptance::DecayRate;
use riffel::tile::TILE;
use riffel::{Axis, Direction, GrowthMap, Ridge};
use riffel_answers::WearLimitDocument;
use riffel_answers::contact::{CreepCurves, FrequencyResponse, RollingTheories, SteadyDocument};
use riffel_answers::receptance::ReceptanceCurves;
use riffel_answers::ridge::{BranchDocument, best_fit_frequency};
use riffel_case::{CaseContact, DamagePoint, DrawnSupports, Point, PointValue};
use riffel_keys::CaseError;
use serde_json::Value;

use crate::array::owned;
use crate::errors::{of_case, of_physics, wrong};
use crate::given::{self, CallableReceptance};
use crate::interrupt::{interruptible, interruptible_while};
use crate::tables;

type Real<'py> = Bound<'py, PyArray1<f64>>;
type Complex<'py> = Bound<'py, PyArray1<Complex64>>;
/// Input, output, its name, response and error.
type Response<'py> = (
    &'static str,
    &'static str,
    &'static str,
    Complex<'py>,
    Real<'py>,
);

/// A case, checked and complete.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct Case {
    pub(crate) case: Arc<riffel_case::Case>,
    /// Receptances that are asked in Python, for their failures.
    pub(crate) callables: Vec<Arc<CallableReceptance>>,
}

/// What makes a case anew elsewhere: it is pickled as the strings that it is made of.
#[pyclass(frozen, module = "riffel._riffel")]
pub(crate) struct PortableCase(riffel_case::PortableCase);

#[pymethods]
impl PortableCase {
    #[new]
    fn new(
        name: String,
        text: String,
        keys: String,
        overrides: Vec<(String, String)>,
        folder: Option<PathBuf>,
    ) -> Self {
        Self(riffel_case::PortableCase {
            name,
            text,
            keys,
            overrides,
            folder,
        })
    }

    fn __reduce__<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<(Bound<'py, PyType>, Bound<'py, PyTuple>)> {
        let written = self.0.clone();
        let arguments = (
            written.name,
            written.text,
            written.keys,
            written.overrides,
            written.folder.map(PathBuf::into_os_string),
        );
        Ok((py.get_type::<Self>(), arguments.into_pyobject(py)?))
    }
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
        _ => Err(wrong(format!(
            "direction is \"{name}\", but must be \"vertical\", \"lateral\" or \"longitudinal\""
        ))),
    }
}

/// The first failure of callables. Those of all are taken, so that none is left for the next computation.
fn take_failure(callables: &[Arc<CallableReceptance>]) -> Option<PyErr> {
    let failures = callables.iter().map(|callable| callable.take_failure());
    failures.fold(None, Option::or)
}

/// Smallest and largest value.
fn ends(values: &[f64]) -> (f64, f64) {
    let fold = |fold: fn(f64, f64) -> f64| values.iter().copied().fold(values[0], fold);
    (fold(f64::min), fold(f64::max))
}

impl Case {
    pub(crate) fn new(case: riffel_case::Case) -> Self {
        Self {
            case: Arc::new(case),
            callables: Vec::new(),
        }
    }

    /// What a callable of the case raised goes before any result.
    pub(crate) fn unless_callable_failed<T>(&self, result: T) -> PyResult<T> {
        match take_failure(&self.callables) {
            Some(error) => Err(error),
            None => Ok(result),
        }
    }

    /// Long work on the case, without the interpreter.
    pub(crate) fn compute<T: Send + 'static>(
        &self,
        py: Python<'_>,
        work: impl FnOnce(&riffel_case::Case) -> T + Send + 'static,
    ) -> PyResult<T> {
        let case = self.case.clone();
        let result = interruptible(py, move || work(&case));
        self.unless_callable_failed(result?)
    }

    /// The case on wavelengths and speeds that may leave its window.
    fn over(
        &self,
        py: Python<'_>,
        wavelengths: &[f64],
        speeds: &[f64],
    ) -> PyResult<Arc<riffel_case::Case>> {
        let ((shortest, longest), (slowest, fastest)) = (ends(wavelengths), ends(speeds));
        self.case
            .check_points([shortest, longest], [slowest, fastest])
            .map_err(of_case)?;
        if self.case.wavelength.min() <= shortest && longest <= self.case.wavelength.max() {
            return Ok(self.case.clone());
        }
        let covering = self.compute(py, move |case| case.covering(shortest, longest))?;
        Ok(Arc::new(covering.map_err(of_case)?))
    }

    /// The ridge at any speeds, with the case on which it was searched.
    fn search_ridge(
        &self,
        py: Python<'_>,
        (shortest, longest, points): (f64, f64, usize),
        speeds: &PyReadonlyArray1<'_, f64>,
    ) -> PyResult<(Arc<riffel_case::Case>, Ridge)> {
        let axis = Axis::new(shortest, longest, points).map_err(of_physics)?;
        let speeds = owned(speeds);
        let case = self.over(py, &[shortest, longest], &speeds)?;
        let searched = case.clone();
        let ridge = interruptible(py, move || {
            Ridge::search_at(&searched.feedback, axis, &speeds)
        })?;
        Ok((case, self.unless_callable_failed(ridge)?))
    }

    fn with_given(
        &self,
        py: Python<'_>,
        given: &Bound<'_, PyAny>,
        what: &'static str,
        put: fn(
            &riffel_case::Case,
            riffel_case::GivenReceptance,
        ) -> Result<riffel_case::Case, CaseError>,
    ) -> PyResult<Self> {
        let (receptance, callable) = given::extract(given, what)?;
        let mut callables: Vec<_> = self
            .callables
            .iter()
            .filter(|callable| !callable.is_of(what))
            .cloned()
            .collect();
        callables.extend(callable);
        let case = self.case.clone();
        let built = interruptible(py, move || put(&case, receptance))?;
        Self::built(built, callables)
    }

    /// A case that was built with callables, whose failure explains any other.
    fn built(
        built: Result<riffel_case::Case, CaseError>,
        callables: Vec<Arc<CallableReceptance>>,
    ) -> PyResult<Self> {
        match take_failure(&callables) {
            Some(error) => Err(error),
            None => Ok(Self {
                case: Arc::new(built.map_err(of_case)?),
                callables,
            }),
        }
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
    fn parse(
        py: Python<'_>,
        text: String,
        name: String,
        overrides: &Bound<'_, PyDict>,
    ) -> PyResult<Self> {
        let overrides = assignments(overrides)?;
        let case = interruptible(py, move || {
            riffel_case::Case::parse(&name, &text, &overrides)
        })?;
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
        let case = self.compute(py, move |case| case.with(&[&overrides]))?;
        Ok(Self {
            case: Arc::new(case.map_err(of_case)?),
            callables: self.callables.clone(),
        })
    }

    fn with_track(&self, py: Python<'_>, track: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.with_given(py, track, "track", riffel_case::Case::with_track)
    }

    fn with_wheel(&self, py: Python<'_>, wheel: &Bound<'_, PyAny>) -> PyResult<Self> {
        self.with_given(py, wheel, "wheel", riffel_case::Case::with_wheel)
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
                    let (receptance, callable) = given::extract(given, what)?;
                    (Some(receptance), callable)
                }
                None => (None, None),
            };
            callables.extend(callable);
            PyResult::Ok(receptance)
        };
        let (track, wheel) = (extract(track, "track")?, extract(wheel, "wheel")?);
        let portable = portable.0.clone();
        let built = interruptible(py, move || {
            riffel_case::Case::restore(&portable, track, wheel)
        })?;
        Self::built(built, callables)
    }

    /// What makes the case anew elsewhere.
    fn portable(&self) -> PortableCase {
        PortableCase(self.case.portable())
    }

    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let table =
            toml::Table::try_from(&self.case.file).map_err(|error| wrong(error.to_string()))?;
        tables::dict(py, &table)
    }

    #[getter]
    fn title(&self) -> Option<String> {
        self.case.file.title.clone()
    }

    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.case.remarks.iter().map(ToString::to_string).collect()
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
        let all = interruptible(py, move || case.sensitivities(wavelength, speed))?;
        let all = self.unless_callable_failed(all)?.map_err(of_case)?;
        let row = |one: riffel_case::Sensitivity| {
            (
                one.key,
                one.unit,
                one.value,
                one.derivative,
                one.elasticity,
                one.error,
            )
        };
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
        let drawn = DrawnSupports {
            deviation,
            supports,
            seed,
        };
        let case = self.case.clone();
        let growth = interruptible(py, move || {
            case.growth_on_irregular_supports(wavelength, speed, drawn)
        })?;
        let growth = self.unless_callable_failed(growth)?.map_err(of_case)?;
        Ok([
            growth.places,
            growth.growth_rates,
            growth.even,
            growth.supports,
        ])
    }

    /// Quantities at pairs of wavelength and speed: key, unit, name and values of each.
    fn points<'py>(
        &self,
        py: Python<'py>,
        wavelengths: PyReadonlyArray1<'py, f64>,
        speeds: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<Vec<(String, &'static str, &'static str, Bound<'py, PyAny>)>> {
        let (wavelengths, speeds) = (owned(&wavelengths), owned(&speeds));
        let case = self.over(py, &wavelengths, &speeds)?;
        /// From here on the wait may be worth interrupting.
        const MANY: usize = 1000;
        let at = move |wavelength: f64, speed: f64| {
            let state = case.feedback.at(wavelength, speed);
            let wear = case.feedback.mean_wear();
            let limit = WearLimitDocument::new(wear, Some(state.growth_rate));
            (Point::new(&case, &state), limit)
        };
        let points: Vec<(Point, WearLimitDocument)> = if wavelengths.len() < MANY {
            let pairs = wavelengths.iter().zip(&speeds);
            py.detach(|| {
                pairs
                    .map(|(&wavelength, &speed)| at(wavelength, speed))
                    .collect()
            })
        } else {
            interruptible(py, move || {
                let pairs = wavelengths.par_iter().zip(&speeds);
                pairs
                    .map(|(&wavelength, &speed)| at(wavelength, speed))
                    .collect()
            })?
        };
        let points = self.unless_callable_failed(points)?;
        let columns = points[0].0.quantities.iter().enumerate();
        let columns = columns.map(|(index, (quantity, _))| {
            let values = || points.iter().map(|point| point.0.quantities[index].1);
            let reals: Option<Vec<f64>> = values()
                .map(|value| match value {
                    PointValue::Real(value) => Some(value),
                    PointValue::Complex(_) => None,
                })
                .collect();
            let array = match reals {
                Some(reals) => reals.into_pyarray(py).into_any(),
                None => values()
                    .map(|value| match value {
                        PointValue::Real(value) => value.into(),
                        PointValue::Complex(value) => value,
                    })
                    .collect::<Vec<Complex64>>()
                    .into_pyarray(py)
                    .into_any(),
            };
            let key = quantity.key().to_owned();
            (key, quantity.unit(), quantity.name(), array)
        });
        let limits = |value: fn(&WearLimitDocument) -> f64| {
            let values = points.iter().map(|point| value(&point.1));
            values.collect::<Vec<f64>>().into_pyarray(py).into_any()
        };
        let wear = limits(|limit| limit.mean_wear_mm_per_100_mgt);
        let amplitude = limits(|limit| limit.amplitude_limit_m.unwrap_or(f64::NAN));
        let beside = [
            (
                "mean_wear_mm_per_100_mgt".to_owned(),
                "mm",
                "mean wear under 100 MGT",
                wear,
            ),
            (
                "amplitude_limit_m".to_owned(),
                "m",
                "amplitude beyond which the rate cannot last",
                amplitude,
            ),
        ];
        let damage = points.iter().map(|(point, _)| point.damage.as_ref());
        let damage = match damage.collect::<Option<Vec<_>>>() {
            Some(damage) => damage_columns(py, &damage)?,
            None => Vec::new(),
        };
        Ok(columns.chain(damage).chain(beside).collect())
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
        let work = |wanted: &AtomicBool| {
            let wanted = || wanted.load(Ordering::Relaxed);
            GrowthMap::compute_into(&case.feedback, &wavelengths, &speeds, tiles, wanted, |_| ());
        };
        let give_up = |error: &PyErr| {
            for callable in &self.callables {
                callable.fail(error.clone_ref(py));
            }
        };
        let done = interruptible_while(py, work, || meanwhile.call1((rate,)), give_up);
        self.unless_callable_failed(done)?
    }

    /// Ŵ₁ over a support, in mid-span and in the mean over the bay, over the window of the case.
    fn bay_maps<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<([Bound<'py, PyArray2<Complex64>>; 3], f64)> {
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
        let maps = self.compute(py, move |case| {
            bay.maps(case.wavelength, case.speed, |_| ())
        })?;
        let rate = self.case.feedback.growth_rate_per_dissipation();
        let array = |map: &GrowthMap| {
            let values: Vec<Complex64> = map.rows().flat_map(|(_, row)| row).copied().collect();
            let shape = [map.speed().points(), map.wavelength().points()];
            values.into_pyarray(py).reshape(shape)
        };
        let arrays = [
            array(&maps.over_support)?,
            array(&maps.mid_span)?,
            array(&maps.mean)?,
        ];
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
        let column = |value: fn(&riffel::growth::RidgePoint) -> f64| {
            ridge
                .points
                .iter()
                .map(value)
                .collect::<Vec<_>>()
                .into_pyarray(py)
        };
        let columns = [
            column(|point| point.wavelength),
            column(|point| point.frequency),
            column(|point| point.normalized_dissipation),
            column(|point| point.growth_rate),
        ];
        let edges: Vec<bool> = ridge.points.iter().map(|point| point.at_edge).collect();
        Ok((columns, edges.into_pyarray(py), best_fit_frequency(&ridge)))
    }

    /// Of each branch of the ridge, the strongest first: its frequency, highest growth rate and mechanism; speed,
    /// wavelength, frequency, Re Ŵ₁ and growth rate of its points; and whether each sits at the edge.
    #[expect(clippy::type_complexity, reason = "columns of a dataset")]
    fn ridge_branches<'py>(
        &self,
        py: Python<'py>,
        wavelength: (f64, f64, usize),
        speeds: PyReadonlyArray1<'py, f64>,
    ) -> PyResult<
        Vec<(
            Bound<'py, PyDict>,
            [Real<'py>; 5],
            Bound<'py, PyArray1<bool>>,
        )>,
    > {
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
                let column = |value: fn(&riffel::growth::RidgePoint) -> f64| {
                    points
                        .iter()
                        .map(value)
                        .collect::<Vec<_>>()
                        .into_pyarray(py)
                };
                let columns = [
                    column(|point| point.speed),
                    column(|point| point.wavelength),
                    column(|point| point.frequency),
                    column(|point| point.normalized_dissipation),
                    column(|point| point.growth_rate),
                ];
                let edges: Vec<bool> = points.iter().map(|point| point.at_edge).collect();
                Ok((known, columns, edges.into_pyarray(py)))
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
        self.case
            .check_frequencies(lowest, highest)
            .map_err(of_case)?;
        let curves = self.compute(py, move |case| {
            ReceptanceCurves::new(case, &track, direction, speed, frequencies)
        })?;
        let all = curves.joints.into_iter().chain(curves.places);
        let all = all.map(|curve| (curve.key, curve.label, curve.values.into_pyarray(py)));
        Ok((curves.frequencies.into_pyarray(py), all.collect()))
    }

    /// Name, frequency and modulus of the receptance at each resonance of the track.
    fn resonances(&self, py: Python<'_>) -> PyResult<Vec<(String, f64, f64)>> {
        self.compute(py, |case| {
            case.resonances()
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

    /// Frequency of the P2 resonance in closed form \[Hz\]; none where the case has none.
    fn p2_closed_form(&self) -> Option<f64> {
        let closed = self.case.p2_closed_form()?;
        Some(closed.angular_frequency() / std::f64::consts::TAU)
    }

    /// Nominal frequency, decay rate and whether it is an upper bound, for each one-third octave.
    fn decay_rate(&self, py: Python<'_>, direction: &str) -> PyResult<Vec<(f64, f64, bool)>> {
        let track = self
            .case
            .track_in(self::direction(direction)?)
            .map_err(of_case)?;
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
    fn contact<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let laws = self.case.creep_laws().map_err(of_case)?;
        let KalkerCoefficients { c11, c22, c23, c33 } = laws.kalker;
        let hertz = self.case.hertz;
        let contact = PyDict::new(py);
        for (key, value) in [
            ("semi_axis_longitudinal_m", hertz.semi_axis_longitudinal()),
            ("semi_axis_lateral_m", hertz.semi_axis_lateral()),
            ("approach_m", hertz.approach()),
            ("peak_pressure_pa", hertz.peak_pressure()),
            ("stiffness_n_per_m", hertz.stiffness()),
        ] {
            contact.set_item(key, value)?;
        }
        let kalker = PyDict::new(py);
        for (key, value) in [("c11", c11), ("c22", c22), ("c23", c23), ("c33", c33)] {
            kalker.set_item(key, value)?;
        }
        contact.set_item("kalker", kalker)?;
        let steady = self.compute(py, |case| CaseContact::of(case)?.steady())?;
        let steady = SteadyDocument::new(&steady.map_err(of_case)?);
        let document = PyDict::new(py);
        document.set_item("force_n", steady.force_n.to_vec())?;
        document.set_item("spin_moment_nm", steady.spin_moment_nm)?;
        document.set_item("dissipation_j_per_m", steady.dissipation_j_per_m)?;
        contact.set_item("steady", document)?;
        Ok(contact)
    }
}

/// A key with its unit, what it is and its values.
type Column<'py> = (String, &'static str, &'static str, Bound<'py, PyAny>);

/// The object `damage` of points, a column for each of its numbers, `damage.growth_by_law.flow` for one inside.
fn damage_columns<'py>(py: Python<'py>, points: &[&DamagePoint]) -> PyResult<Vec<Column<'py>>> {
    let mut columns: Vec<(String, Vec<Value>)> = Vec::new();
    for (index, point) in points.iter().enumerate() {
        let value = serde_json::to_value(point)
            .map_err(|error| pyo3::exceptions::PyValueError::new_err(error.to_string()))?;
        let mut leaves = Vec::new();
        collect_numbers("damage", &value, &mut leaves);
        for (place, (key, value)) in leaves.into_iter().enumerate() {
            match index {
                0 => columns.push((key, vec![value])),
                // Every point of a case has the same numbers.
                _ => columns[place].1.push(value),
            }
        }
    }
    let number = |value: &Value| value.as_f64().unwrap_or(f64::NAN);
    let columns = columns.into_iter().map(|(key, values)| {
        let array = match values[0].is_array() {
            false => {
                let values: Vec<f64> = values.iter().map(number).collect();
                values.into_pyarray(py).into_any()
            }
            true => {
                let complex = |value: &Value| Complex64::new(number(&value[0]), number(&value[1]));
                let values: Vec<Complex64> = values.iter().map(complex).collect();
                values.into_pyarray(py).into_any()
            }
        };
        // The unit is in the name of the quantity, `damage.depth_by_law_m.flow`.
        let quantity = key.split('.').nth(1).unwrap_or_default();
        let units = [("_pa", "Pa"), ("_m", "m"), ("_nm", "N m"), ("_deg", "deg")];
        let unit = units.iter().find(|(ending, _)| quantity.ends_with(ending));
        let unit = unit.map_or("1", |unit| unit.1);
        (key, unit, "damage beside wear", array)
    });
    Ok(columns.collect())
}

/// The numbers of a document below a key, real or `[re, im]`, in its order.
fn collect_numbers(key: &str, value: &Value, into: &mut Vec<(String, Value)>) {
    match value {
        Value::Object(map) => {
            for (name, value) in map {
                collect_numbers(&format!("{key}.{name}"), value, into);
            }
        }
        value => into.push((key.to_owned(), value.clone())),
    }
}
