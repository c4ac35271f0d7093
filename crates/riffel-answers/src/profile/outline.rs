//! Outline and curvature of profiles.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use riffel::profile::{Profile, ProfilePoint};
use riffel_case::{ProfileReading, profile_of};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure, LinePanel, Scale, Series};
use serde::Serialize;

/// Distance of the points that are drawn and listed \[m\].
const STEP: f64 = 2.5e-4;
/// Curvature beyond which nothing is drawn \[1/m\]: a radius of 5 mm.
const MOST_CURVATURE: f64 = 200.0;

/// Profiles beside each other.
pub struct OutlineAnswer {
    profiles: Vec<(String, Profile)>,
    /// Of points that scatter.
    pub remarks: Vec<Message>,
}

/// What `riffel profile FILE… --json` prints.
#[derive(Serialize)]
pub struct OutlineDocument {
    profiles: Vec<Outline>,
}

#[derive(Serialize)]
struct Outline {
    name: String,
    x_m: Vec<f64>,
    height_m: Vec<f64>,
    slope: Vec<f64>,
    curvature_1_per_m: Vec<f64>,
}

impl OutlineAnswer {
    /// The profiles of nominal names and files, each as it is to be read.
    ///
    /// # Errors
    /// [`CaseError`] with file and line.
    pub fn new(files: impl IntoIterator<Item = (PathBuf, ProfileReading)>) -> Result<Self, CaseError> {
        let (mut profiles, mut remarks) = (Vec::new(), Vec::new());
        for (file, reading) in files {
            let name = file.display().to_string();
            let read = profile_of(&name, Path::new(""), reading)?;
            profiles.push((name, read.profile));
            remarks.extend(read.remarks);
        }
        Ok(Self { profiles, remarks })
    }

    /// Each profile with its name.
    pub fn profiles(&self) -> &[(String, Profile)] {
        &self.profiles
    }

    /// What `riffel profile FILE… --json` prints.
    pub fn document(&self) -> OutlineDocument {
        let outlines = self.profiles.iter().map(|(name, profile)| {
            let points = profile.sampled(STEP);
            let of = |value: fn(&ProfilePoint) -> f64| points.iter().map(value).collect();
            Outline {
                name: name.clone(),
                x_m: of(|point| point.x),
                height_m: of(|point| point.height),
                slope: of(|point| point.slope),
                curvature_1_per_m: of(|point| point.curvature),
            }
        });
        OutlineDocument { profiles: outlines.collect() }
    }

    /// One row for each point.
    ///
    /// # Errors
    /// Those of the file.
    pub fn csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["profile", "x_mm", "y_mm", "slope", "curvature_1_per_m"])?;
        for (name, profile) in &self.profiles {
            for point in profile.sampled(STEP) {
                writer.serialize((name, 1e3 * point.x, 1e3 * point.height, point.slope, point.curvature))?;
            }
        }
        writer.flush()
    }

    /// Outline and curvature.
    pub fn figure(&self) -> LineFigure {
        let panel = |label: &str, value: fn(&ProfilePoint) -> Option<f64>| {
            let series = self.profiles.iter().map(|(name, profile)| {
                let drawn = profile.sampled(STEP).into_iter();
                let (x, y) = drawn.filter_map(|point| Some((1e3 * point.x, value(&point)?))).unzip();
                Series { label: name.clone(), x, y, ..Series::default() }
            });
            LinePanel {
                x_label: "lateral x, field side positive [mm]".to_owned(),
                y_label: label.to_owned(),
                x_scale: Scale::Linear,
                y_scale: Scale::Linear,
                series: series.collect(),
                ..LinePanel::default()
            }
        };
        LineFigure {
            title: "Profiles".to_owned(),
            caption:
                "Curvature is positive where a profile is hollow seen from above; beyond ±200 1/m it is not drawn."
                    .to_owned(),
            panels: vec![
                panel("height [mm]", |point| Some(1e3 * point.height)),
                panel("curvature [1/m]", |point| (point.curvature.abs() <= MOST_CURVATURE).then_some(point.curvature)),
            ],
            arrangement: Arrangement::Stacked,
        }
    }
}
