//! Roughness felt by axle boxes as data.

use riffel::roughness::{GrindSection, RailAnalysis, line_length};
use serde::Serialize;

use super::{AxleBoxAnswer, AxleBoxRail, WheelMark};
use crate::defect_document::DefectDocument;
use crate::roughness::{Band, Verdict, bands};

/// What `riffel axlebox --json` prints; levels in dB re 1 µm.
#[derive(Serialize)]
pub struct AxleBoxDocument<'a> {
    riffel_version: &'static str,
    files: Vec<String>,
    /// The worst first.
    rails: Vec<RailDocument<'a>>,
    /// Flats of wheels and waves around them, left out of all else.
    wheels: &'a [WheelMark],
    remarks: Vec<String>,
}

#[derive(Serialize)]
struct RailDocument<'a> {
    name: &'a str,
    length_m: f64,
    lowest_speed_m_per_s: f64,
    mean_speed_m_per_s: f64,
    highest_speed_m_per_s: f64,
    shortest_wavelength_m: f64,
    longest_wavelength_m: f64,
    spectrum: Vec<Level>,
    bands: Vec<Band>,
    verdicts: &'a [Verdict],
    /// Welds, joints and squats.
    defects: Vec<DefectDocument>,
    grind: Vec<Section>,
    grind_share_of_length: f64,
}

#[derive(Serialize)]
struct Level {
    wavelength_m: f64,
    level_db: f64,
    /// With pads of half to twice the stiffness, the lowest without waves that may be the wheel's.
    lowest_db: f64,
    highest_db: f64,
}

#[derive(Serialize)]
struct Section {
    from_m: f64,
    to_m: f64,
    band_from_m: f64,
    band_to_m: f64,
    rms_over_limit: f64,
    /// Which of the stretches that lie over each other, where places go back.
    #[serde(skip_serializing_if = "Option::is_none")]
    stretch: Option<usize>,
}

impl Section {
    fn new(section: &GrindSection, analysis: &RailAnalysis) -> Self {
        Self {
            from_m: section.from,
            to_m: section.to,
            band_from_m: section.band.from(),
            band_to_m: section.band.to(),
            rms_over_limit: section.ratio,
            stretch: analysis.stretch_to_name(section.stretch),
        }
    }
}

pub(super) fn document(answer: &AxleBoxAnswer) -> AxleBoxDocument<'_> {
    AxleBoxDocument {
        riffel_version: env!("CARGO_PKG_VERSION"),
        files: answer.files.iter().map(|path| path.display().to_string()).collect(),
        rails: answer.rails.iter().map(rail).collect(),
        wheels: &answer.wheels,
        remarks: answer.remarks.iter().map(ToString::to_string).collect(),
    }
}

fn rail(answer: &AxleBoxRail) -> RailDocument<'_> {
    let (rail, [slowest, mean, fastest]) = (&answer.rail, answer.speeds);
    let analysis = &rail.analysis;
    RailDocument {
        name: &rail.name,
        length_m: analysis.length(),
        lowest_speed_m_per_s: slowest,
        mean_speed_m_per_s: mean,
        highest_speed_m_per_s: fastest,
        shortest_wavelength_m: answer.known.from(),
        longest_wavelength_m: answer.known.to(),
        spectrum: answer
            .levels
            .iter()
            .map(|level| Level {
                wavelength_m: level.band.wavelength(),
                level_db: level.level,
                lowest_db: level.range[0],
                highest_db: level.range[1],
            })
            .collect(),
        bands: bands(&rail.name, &analysis.bands),
        verdicts: &rail.verdicts,
        defects: DefectDocument::all(&rail.name, &analysis.defects),
        grind: (rail.sections.iter()).map(|section| Section::new(section, analysis)).collect(),
        grind_share_of_length: line_length(analysis.measured_within(&rail.sections)) / analysis.length(),
    }
}
