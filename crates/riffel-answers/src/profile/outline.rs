//! Outline and curvature of profiles.

use std::path::{Path, PathBuf};

use riffel_curving::profile::{Profile, ProfilePoint};
use riffel_keys::{CaseError, Message, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, Series};
use riffel_rail::{ProfileReading, profile_of};
use serde::Serialize;

use super::or_dash;
use crate::number_alone;
use crate::{Answer, Rows, Table};

/// Distance of the points that are drawn and listed \[m\].
const STEP: f64 = 2.5e-4;
/// Curvature beyond which nothing is drawn \[1/m\]: a radius of 5 mm.
const MOST_CURVATURE: f64 = 200.0;

/// Profiles beside each other: serialised, what `riffel profile FILE… --json` prints.
#[derive(Serialize)]
pub struct OutlineAnswer {
    profiles: Vec<Outline>,
    /// Of points that scatter.
    #[serde(skip)]
    pub remarks: Vec<Message>,
}

#[derive(Serialize)]
struct Outline {
    name: String,
    x_m: Vec<f64>,
    height_m: Vec<f64>,
    slope: Vec<f64>,
    curvature_1_per_m: Vec<f64>,
    #[serde(skip)]
    profile: Profile,
    #[serde(skip)]
    points: Vec<ProfilePoint>,
}

impl Outline {
    fn new(name: String, profile: Profile) -> Self {
        let points = profile.sampled(STEP);
        let of = |value: fn(&ProfilePoint) -> f64| points.iter().map(value).collect();
        Self {
            name,
            x_m: of(|point| point.x),
            height_m: of(|point| point.height),
            slope: of(|point| point.slope),
            curvature_1_per_m: of(|point| point.curvature),
            profile,
            points,
        }
    }

    /// Radius at x = 0.
    fn radius(&self) -> Message {
        /// Curvature \[1/m\] of what is straight.
        const STRAIGHT: f64 = 1e-3;
        match self.profile.at(0.0) {
            Some(origin) if origin.curvature.abs() < STRAIGHT => say!(straight_profile),
            origin => or_dash(origin.map(|origin| -1e3 / origin.curvature), 1),
        }
    }
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
            profiles.push(Outline::new(name, read.profile));
            remarks.extend(read.remarks);
        }
        Ok(Self { profiles, remarks })
    }

    /// One row for each point.
    fn points(&self) -> Table {
        let points = self.profiles.iter().flat_map(|outline| outline.points.iter().map(move |point| (outline, point)));
        let points: Vec<(&Outline, &ProfilePoint)> = points.collect();
        Table {
            name: "profile",
            columns: vec![
                points.names("profile", |(outline, _)| &outline.name),
                points.exact("x_mm", |(_, point)| 1e3 * point.x),
                points.exact("y_mm", |(_, point)| 1e3 * point.height),
                points.exact("slope", |(_, point)| point.slope),
                points.exact("curvature_1_per_m", |(_, point)| point.curvature),
            ],
        }
    }
}

impl Answer for OutlineAnswer {
    fn name(&self) -> &'static str {
        "profile"
    }

    fn tables(&self) -> Vec<Table> {
        let millimetres = |metres: f64| number_alone(format_args!("{:.2}", 1e3 * metres));
        let profiles = &self.profiles;
        let ends = Table {
            name: "profiles",
            columns: vec![
                profiles.shown(say!(profile_column), |outline| Message::verbatim(&outline.name)),
                profiles.shown(say!(from_millimetres_column), |outline| millimetres(outline.profile.range()[0])),
                profiles.shown(say!(to_millimetres_column), |outline| millimetres(outline.profile.range()[1])),
                profiles.shown(say!(radius_at_origin_column), Outline::radius),
            ],
        };
        vec![ends, self.points()]
    }

    /// Outline and curvature.
    fn figure(&self) -> LineFigure {
        let panel = |label: &str, value: fn(&ProfilePoint) -> Option<f64>| {
            let series = self.profiles.iter().map(|outline| {
                let drawn = outline.points.iter();
                let (x, y) = drawn.filter_map(|point| Some((1e3 * point.x, value(point)?))).unzip();
                Series::new(outline.name.clone(), x, y)
            });
            LinePanel::new("lateral x, field side positive [mm]", label, series)
        };
        LineFigure::new(
            "Profiles",
            "Curvature is positive where a profile is hollow seen from above; beyond ±200 1/m it is not drawn.",
            [
                panel("height [mm]", |point| Some(1e3 * point.height)),
                panel("curvature [1/m]", |point| (point.curvature.abs() <= MOST_CURVATURE).then_some(point.curvature)),
            ],
        )
        .arranged(Arrangement::Stacked)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
