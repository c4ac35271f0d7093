//! A wheel along a rail in time, and a rail under many wheels.

use numpy::{IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use riffel::passage::Sinusoid;
use riffel::roughness::Profile;
use riffel_answers::simulate::{
    ContactHistory, EvolutionRequest, EvolutionRun, PassageAnswer, PassageRequest, SinusoidAnswer, SinusoidRequest,
    SmoothRailAnswer, Surface,
};

use crate::array::owned;
use crate::case::Case;
use crate::document::{document, sentences};
use crate::errors::{of_answer, of_physics};
use crate::interrupt::interruptible;
use crate::traffic::Traffic;

/// Amplitude and wavelength of a sinusoid \[m\], or where a profile begins \[m\], its spacing \[m\] and heights \[m\].
#[derive(FromPyObject)]
pub(crate) enum SurfaceArg<'py> {
    Sinusoid((f64, f64)),
    Profile((f64, f64, PyReadonlyArray1<'py, f64>)),
}

enum Rail {
    Sinusoid(Sinusoid),
    Profile(Profile),
}

impl SurfaceArg<'_> {
    fn rail(&self) -> PyResult<Rail> {
        Ok(match self {
            Self::Sinusoid((amplitude, wavelength)) => {
                Rail::Sinusoid(Sinusoid { amplitude: *amplitude, wavelength: *wavelength })
            }
            Self::Profile((start, spacing, heights)) => {
                Rail::Profile(Profile::new(*start, *spacing, owned(heights)).map_err(of_physics)?)
            }
        })
    }
}

/// One array for each quantity of a course, or of several contacts by rows.
fn arrays<'py>(py: Python<'py>, courses: &[ContactHistory]) -> PyResult<Bound<'py, PyDict>> {
    let arrays = PyDict::new(py);
    let several = courses.len() > 1;
    let Some(first) = courses.first() else {
        return Ok(arrays);
    };
    for (name, values) in [("position", &first.position_m), ("height", &first.height_m)] {
        arrays.set_item(name, values.clone().into_pyarray(py))?;
    }
    type Column = fn(&ContactHistory) -> Option<&Vec<f64>>;
    let columns: [(&str, Column); 7] = [
        ("normal_force", |course| Some(&course.normal_force_n)),
        ("tangential_force", |course| Some(&course.tangential_force_n)),
        ("lateral_force", |course| course.lateral_force_n.as_ref()),
        ("creepage", |course| Some(&course.creepage)),
        ("lateral_creepage", |course| course.lateral_creepage.as_ref()),
        ("dissipation", |course| Some(&course.dissipation_j_per_m)),
        ("approach", |course| Some(&course.approach_m)),
    ];
    for (name, column) in columns {
        let rows: Vec<Vec<f64>> = courses.iter().filter_map(|course| column(course)).cloned().collect();
        match rows.as_slice() {
            [] => {}
            [row] if !several => arrays.set_item(name, row.clone().into_pyarray(py))?,
            rows => arrays.set_item(name, PyArray2::from_vec2(py, rows)?)?,
        }
    }
    Ok(arrays)
}

/// The course over a rail by name, and what else is told of it.
#[pyfunction]
pub(crate) fn simulate<'py>(
    py: Python<'py>,
    case: &Case,
    surface: SurfaceArg<'py>,
    speed: f64,
    step: Option<f64>,
    contact_filter: bool,
    transient: bool,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyDict>)> {
    let told = PyDict::new(py);
    let courses = match surface.rail()? {
        Rail::Sinusoid(profile) => {
            let request = SinusoidRequest {
                contact_filter,
                transient,
                ..SinusoidRequest::new(speed, profile, step).map_err(of_answer)?
            };
            let answer = case.compute(py, move |case| SinusoidAnswer::new(case, request))?;
            let answer = answer.map_err(of_answer)?;
            if answer.contacts.len() > 1 {
                told.set_item("contacts", document(py, &answer.contacts)?)?;
            }
            told.set_item("harmonics", document(py, &answer.harmonics)?)?;
            if let Some(energy) = answer.energy_at_rail_j_per_m {
                told.set_item("energy_at_rail", energy)?;
            }
            told.set_item("contact_loss_fraction", answer.extremes.contact_loss_fraction)?;
            told.set_item("minimum_normal_force", answer.extremes.minimum_normal_force_n)?;
            told.set_item("maximum_normal_force", answer.extremes.maximum_normal_force_n)?;
            told.set_item("remarks", sentences(&answer.run.own_remarks))?;
            arrays(py, &answer.run.courses)?
        }
        Rail::Profile(profile) => {
            let request = PassageRequest {
                speed,
                profile,
                largest_step: step.unwrap_or(PassageRequest::USUAL_STEP),
                contact_filter,
            };
            let answer = case.compute(py, move |case| PassageAnswer::new(case, request))?;
            let answer = answer.map_err(of_answer)?;
            told.set_item("step", answer.step_m)?;
            told.set_item("run_in", answer.run_in_m)?;
            told.set_item("contact_loss_fraction", answer.extremes.contact_loss_fraction)?;
            told.set_item("minimum_normal_force", answer.extremes.minimum_normal_force_n)?;
            told.set_item("maximum_normal_force", answer.extremes.maximum_normal_force_n)?;
            told.set_item("remarks", sentences(&answer.run.own_remarks))?;
            if answer.run.contacts.len() > 1 {
                told.set_item("contacts", document(py, &answer.run.contacts)?)?;
            }
            arrays(py, &answer.run.courses)?
        }
    };
    Ok((courses, told))
}

/// What becomes of a push on a smooth rail: the end of the course of every contact by name, and the document of the program without it.
#[pyfunction]
pub(crate) fn on_smooth_rail<'py>(
    py: Python<'py>,
    case: &Case,
    speed: f64,
    step: Option<f64>,
) -> PyResult<(Bound<'py, PyDict>, Bound<'py, PyAny>, Vec<String>)> {
    let answer = case.compute(py, move |case| SmoothRailAnswer::new(case, speed, step))?;
    let answer = answer.map_err(of_answer)?;
    let courses = arrays(py, &answer.run.courses)?;
    Ok((courses, document(py, &answer)?, sentences(&answer.run.own_remarks)))
}

/// What `riffel simulate --passages --json` prints; passages of the profiles that are kept, their heights \[m\] and spacing
/// \[m\]; remarks. After a signal it ends with the step under way.
#[pyfunction]
pub(crate) fn evolve<'py>(
    py: Python<'py>,
    case: &Case,
    surface: SurfaceArg<'py>,
    periodic: bool,
    traffic: &Traffic,
    passages: u64,
    step: Option<f64>,
    contact_filter: bool,
) -> PyResult<(Bound<'py, PyAny>, Vec<u64>, Bound<'py, PyArray2<f64>>, f64, Vec<String>)> {
    let traffic = riffel_case::traffic::Traffic::clone(&traffic.0);
    let usual_step = step.unwrap_or(PassageRequest::USUAL_STEP);
    let (surface, largest_step) = match surface.rail()? {
        Rail::Sinusoid(sinusoid) => {
            let slowest = traffic.speeds().iter().map(|speeds| speeds.range().0);
            let slowest = slowest.fold(f64::INFINITY, f64::min);
            let step = SinusoidRequest::new(slowest, sinusoid, step).map_err(of_answer)?.step();
            let bay = case.case.track.support_spacing();
            (Surface::of_sinusoid(sinusoid, bay).map_err(of_answer)?, step)
        }
        Rail::Profile(profile) if periodic => (Surface::Ring(profile), usual_step),
        Rail::Profile(profile) => (Surface::Record(profile), usual_step),
    };
    let request = EvolutionRequest { traffic, surface, largest_step, contact_filter };
    let run = case.compute(py, move |case| EvolutionRun::new(case, request))?;
    let mut run = run.map_err(of_answer)?;
    let answer = loop {
        let (back, reached) = interruptible(py, move || {
            let reached = run.go_on(passages);
            (run, reached)
        })?;
        run = back;
        if let Some(answer) = reached.map_err(of_answer)? {
            break answer;
        }
    };
    let document = document(py, &answer)?;
    let stages = answer.profiles.iter().map(|profile| profile.passages);
    let stages: Vec<u64> = stages.collect();
    let count = answer.profiles[0].heights_m.len();
    let heights: Vec<f64> = answer.profiles.into_iter().flat_map(|profile| profile.heights_m).collect();
    let heights = heights.into_pyarray(py).reshape([stages.len(), count])?;
    Ok((document, stages, heights, answer.spacing, sentences(&answer.run.own_remarks)))
}
