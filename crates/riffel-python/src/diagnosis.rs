//! What may have made the wavelengths that stand out.

use std::path::PathBuf;

use pyo3::prelude::*;
use riffel::diagnosis::{Instrument, TrafficSpeeds};
use riffel_answers::diagnose::{Diagnosis, DiagnosisSettings};
use riffel_rail::history::SpectraChoice;

use crate::case::Case;
use crate::document::document;
use crate::errors::{of_case, of_physics, wrong};
use crate::forecast::GivenTraffic;
use crate::records::{GivenLayout, GivenRoughness, Record};

/// Speeds of the traffic: ranges \[m/s\], each as common as any other, or a traffic file or its keys.
#[derive(FromPyObject)]
pub(crate) enum GivenSpeeds<'py> {
    Ranges(Vec<(f64, f64)>),
    Traffic(GivenTraffic<'py>),
}

/// The document of `riffel diagnose --json`; `choose` and `by` are for spectra.
#[pyfunction]
pub(crate) fn diagnose<'py>(
    py: Python<'py>,
    case: &Case,
    rail: (PathBuf, Option<String>, GivenRoughness<'py>),
    earlier: Vec<(PathBuf, Option<String>, GivenRoughness<'py>)>,
    layout: GivenLayout,
    speeds: Option<GivenSpeeds<'py>>,
    torsion: Vec<f64>,
    bending: Vec<f64>,
    choose: Vec<String>,
    by: Option<String>,
    from_vehicle: bool,
    keep_defects: bool,
) -> PyResult<Bound<'py, PyAny>> {
    let (speeds, remark) = match speeds {
        Some(GivenSpeeds::Ranges(ranges)) => (TrafficSpeeds::of_ranges(ranges), None),
        Some(GivenSpeeds::Traffic(traffic)) => {
            let speeds = traffic.traffic()?.passing_speeds();
            let speeds = speeds.map_err(|error| wrong(format!("traffic has no speeds: {error}")))?;
            (Ok(speeds), None)
        }
        None => match Diagnosis::usual_speeds(&case.case) {
            Ok((speeds, sentence)) => (Ok(speeds), Some(sentence.about("neither speed nor traffic given"))),
            Err(error) => (Err(error), None),
        },
    };
    let speeds = speeds.map_err(of_physics)?;
    let layout = layout.layout()?;
    let rail = Record::new(py, &rail, &layout)?;
    let earlier = earlier.iter();
    let earlier = earlier.map(|given| Record::new(py, given, &layout)).collect::<PyResult<Vec<_>>>()?;
    let diagnosis = case.compute(py, move |case| {
        let settings = DiagnosisSettings {
            speeds,
            spectra: SpectraChoice { choose: &choose, by: by.as_deref(), keep_defects },
            torsion,
            bending,
            instrument: if from_vehicle { Instrument::Vehicle } else { Instrument::Trolley },
        };
        let earlier: Vec<_> = earlier.iter().map(Record::borrowed).collect();
        Diagnosis::new(case, &rail.borrowed(), &earlier, &settings)
    })?;
    let mut diagnosis = diagnosis.map_err(of_case)?;
    diagnosis.warnings.splice(0..0, remark);
    document(py, &diagnosis)
}
