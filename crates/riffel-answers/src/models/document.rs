//! Models of the field as data and as a table.

use std::io::{self, Write};

use riffel::Complex64;
use riffel_case::Case;
use riffel_case::file::CaseFile;
use riffel_case::model::{Joint, Joints};
use serde::Serialize;
use serde_json::{Map, Value};

use super::{ComplexPlane, Difference, Growth, ModelGrowth, ModelsAnswer};
use crate::WearLimitDocument;
use crate::column;
use crate::highest::HighestDocument;

/// What `riffel compare --models --json` prints.
#[derive(Serialize)]
pub struct ModelsDocument<'a> {
    riffel_version: &'static str,
    case: &'a CaseFile,
    /// The speed, or the mean of the usual traffic.
    speed_m_per_s: f64,
    /// Slowest and fastest trains of the usual traffic, over which growth is the mean; null at one speed.
    speeds_m_per_s: Option<[f64; 2]>,
    wavelength_m: &'a [f64],
    models: Vec<ModelDocument<'a>>,
}

#[derive(Serialize)]
struct ModelDocument<'a> {
    name: &'static str,
    title: &'static str,
    source: &'static str,
    assumptions: &'static [&'static str],
    leaves_out: &'static [&'static str],
    not_given: &'static [&'static str],
    /// What stands at each joint, in words.
    joints: Map<String, Value>,
    applies: bool,
    /// What the case lacks; null where the model applies.
    not_on_this_case: Option<&'a str>,
    /// Null where the model does not apply.
    growth_rate_per_passage: Option<&'a [f64]>,
    /// Null where nothing grows.
    highest: Option<HighestDocument>,
    /// For that growth; left out where the model does not apply.
    #[serde(flatten)]
    wear_limit: Option<WearLimitDocument>,
    /// The joint that moves growth most first.
    differs_by: Vec<DifferenceDocument>,
    /// Null but for a model whose papers draw it, on discrete supports.
    complex_plane: Option<ComplexPlaneDocument<'a>>,
    remarks: Vec<&'a String>,
}

#[derive(Serialize)]
struct DifferenceDocument {
    joint: &'static str,
    /// Null where the joint cannot be replaced alone.
    largest_change_of_growth_rate_per_passage: Option<f64>,
    /// With the joint replaced; null where nothing grows then.
    highest: Option<HighestDocument>,
    sentence: String,
}

#[derive(Serialize)]
struct ComplexPlaneDocument<'a> {
    frequency_hz: &'a [f64],
    /// Energy left on a metre of rail over the amplitude, [re, im].
    over_support_j_per_m2: Vec<[f64; 2]>,
    mid_span_j_per_m2: Vec<[f64; 2]>,
}

pub(super) fn document<'a>(answer: &'a ModelsAnswer, case: &'a Case) -> ModelsDocument<'a> {
    ModelsDocument {
        riffel_version: env!("CARGO_PKG_VERSION"),
        case: &case.file,
        speed_m_per_s: answer.speed,
        speeds_m_per_s: answer.usual_traffic.map(|usual| usual.speeds),
        wavelength_m: &answer.wavelengths,
        models: answer.models.iter().map(of).collect(),
    }
}

fn of(of: &ModelGrowth) -> ModelDocument<'_> {
    let ModelGrowth { model, growth } = of;
    let known = growth.as_ref().ok();
    let difference = |growth: &Growth, difference: &Difference| DifferenceDocument {
        joint: difference.joint.key(),
        largest_change_of_growth_rate_per_passage: difference
            .effect
            .as_ref()
            .ok()
            .map(|effect| effect.largest_change),
        highest: difference
            .effect
            .as_ref()
            .ok()
            .and_then(|effect| effect.highest)
            .map(Into::into),
        sentence: difference.sentence(growth.highest),
    };
    ModelDocument {
        name: model.name,
        title: model.title,
        source: model.source,
        assumptions: model.assumptions,
        leaves_out: model.leaves_out,
        not_given: model.not_given,
        joints: joints(&model.joints),
        applies: known.is_some(),
        not_on_this_case: growth.as_ref().err().map(String::as_str),
        growth_rate_per_passage: known.map(|growth| growth.rates.as_slice()),
        highest: known.and_then(|growth| growth.highest).map(Into::into),
        wear_limit: known.map(|growth| growth.wear_limit.clone()),
        differs_by: known.map_or_else(Vec::new, |growth| {
            let differences = growth.differs_by.iter();
            differences.map(|by| difference(growth, by)).collect()
        }),
        complex_plane: known
            .and_then(|growth| growth.complex_plane.as_ref())
            .map(plane),
        remarks: known.map_or_else(Vec::new, |growth| {
            growth.remarks.iter().chain(&growth.unstable).collect()
        }),
    }
}

fn joints(joints: &Joints) -> Map<String, Value> {
    let all = Joint::ALL.into_iter();
    all.map(|joint| (joint.key().to_owned(), joints.words(joint).into()))
        .collect()
}

fn plane(plane: &ComplexPlane) -> ComplexPlaneDocument<'_> {
    let pairs = |values: &[Complex64]| values.iter().map(|value| [value.re, value.im]).collect();
    ComplexPlaneDocument {
        frequency_hz: &plane.frequencies,
        over_support_j_per_m2: pairs(&plane.over_support),
        mid_span_j_per_m2: pairs(&plane.mid_span),
    }
}

pub(super) fn growth_table(answer: &ModelsAnswer, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let names = answer.on_case().map(|(model, _)| model.name);
    let columns = column::names(names, "growth_rate_per_passage");
    writer.write_record(["wavelength_m".to_owned()].iter().chain(&columns))?;
    for (place, wavelength) in answer.wavelengths.iter().enumerate() {
        let rates = answer.on_case().map(|(_, growth)| growth.rates[place]);
        let row = std::iter::once(*wavelength).chain(rates);
        writer.write_record(row.map(|value| value.to_string()))?;
    }
    writer.flush()
}
