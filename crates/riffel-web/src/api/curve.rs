//! `POST /api/curve`: profiles of a wheel and a rail, and how a bogie stands on them in a curve.

use std::path::Path;

use axum::extract::State;
use riffel_answers::curve::CurveAnswer;
use riffel_answers::profile::OutlineAnswer;
use riffel_case::file::ProfileOrientation;
use riffel_case::{CurvingCase, METRO_CURVE_CASE, ProfileReading};
use riffel_keys::{CaseError, Message};
use serde::Deserialize;
use serde_json::{Value, json};

use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::queue::Wanted;
use crate::request::{Asked, Asker};
use crate::told::Told;
use crate::uploads::Uploads;
use riffel_page::Note;

/// Longest name of a file that is shown, in letters.
const LONGEST_NAME: usize = 120;
/// Endings of names by which a reader tells formats apart; others are left out.
const ENDINGS: [&str; 8] = ["ban", "mpt", "prr", "prw", "rai", "slcs", "whe", "whl"];

#[derive(Deserialize)]
pub(crate) struct Question {
    wheel: ProfileText,
    rail: ProfileText,
    /// Above zero to the right.
    radius_m: f64,
    speed_m_per_s: f64,
    cant_m: f64,
    gauge_m: f64,
    wheelbase_m: f64,
    mass_per_axle_kg: f64,
    /// Of an axle box, along and across.
    longitudinal_stiffness_n_per_m: f64,
    lateral_stiffness_n_per_m: f64,
    friction_high: f64,
    friction_low: f64,
}

/// A nominal profile, or a file.
#[derive(Deserialize)]
struct ProfileText {
    /// Nominal name, or that of the file to the user.
    name: String,
    /// The file.
    text: Option<String>,
    /// How its coordinates stand; none for what the format says.
    orientation: Option<ProfileOrientation>,
}

impl Question {
    /// `Ok` if the numbers are those of a curve.
    pub(super) fn check(&self) -> Result<(), Fault> {
        for (what, value, unit, most) in [
            ("the radius", self.radius_m.abs(), "m", 1e6),
            ("the speed", self.speed_m_per_s, "m/s", 150.0),
        ] {
            if !(value > 0.0 && value <= most) {
                return Err(Fault::bad(format!(
                    "{what} is {value} {unit}, but must be above zero and at most {most} {unit}"
                )));
            }
        }
        Ok(())
    }
}

pub(crate) async fn post(
    State(page): State<Page>,
    asker: Asker,
    Asked(question): Asked<Question>,
) -> Result<Told<Value>, Refusal> {
    question.check()?;
    let uploads = page.uploads.clone();
    page.queue
        .run(asker.subject("curve"), move |wanted| {
            question.answer(wanted, &uploads)
        })
        .await
}

impl Question {
    fn answer(&self, wanted: &Wanted, uploads: &Uploads) -> Result<Told<Value>, Fault> {
        let folder = place(uploads)?;
        let paths = self.put(folder.path())?;
        let named =
            |error: CaseError| Fault::from(error).in_words(|words| self.named(words, &paths));
        let profiles = [&self.wheel, &self.rail].into_iter().zip(&paths);
        let outlines = OutlineAnswer::new(profiles.map(|(profile, path)| {
            let reading = ProfileReading {
                orientation: profile.orientation,
                ..ProfileReading::default()
            };
            (path.into(), reading)
        }))
        .map_err(named)?;
        // Short of an equilibrium the profiles are still worth seeing.
        let vehicle = self
            .curving(&paths)
            .and_then(|case| Ok((case.vehicle_in_curve()?, case)));
        if !wanted.still() {
            return Err(Fault::superseded());
        }
        let curve = vehicle
            .and_then(|(vehicle, case)| CurveAnswer::of_vehicle(&case, vehicle))
            .map_err(named);
        let curve = match curve {
            Ok(answer) => {
                let mut document = json!(answer.document(None));
                document["remarks"] = json!(self.told(&answer.remarks, &paths));
                document
            }
            Err(fault) => json!({ "fault": fault }),
        };
        let remarks = self.told(&outlines.remarks, &paths);
        let mut document =
            json!({ "outlines": outlines.document(), "curve": curve, "remarks": remarks });
        self.name(&mut document, &paths);
        Ok(Told(document))
    }

    /// Put the profiles into a folder: what the reader is given for each.
    pub(super) fn put(&self, folder: &Path) -> Result<[String; 2], Fault> {
        Ok([
            self.wheel.put(folder, "wheel")?,
            self.rail.put(folder, "rail")?,
        ])
    }

    /// The case of `riffel curve`.
    pub(super) fn curving(&self, paths: &[String; 2]) -> Result<CurvingCase, CaseError> {
        let mut overrides = vec![
            format!("profiles.wheel={}", paths[0]),
            format!("profiles.rail={}", paths[1]),
            format!("curve.radius={}", self.radius_m),
            format!("curve.speed={}", self.speed_m_per_s),
            format!("curve.cant={}", self.cant_m),
            format!("profiles.gauge={}", self.gauge_m),
            format!("bogie.wheelbase={}", self.wheelbase_m),
            format!("bogie.mass_per_axle={}", self.mass_per_axle_kg),
            format!(
                "bogie.primary_longitudinal_stiffness={}",
                self.longitudinal_stiffness_n_per_m
            ),
            format!(
                "bogie.primary_lateral_stiffness={}",
                self.lateral_stiffness_n_per_m
            ),
            // The outer rail of a curve to the right is the left one.
            match self.radius_m > 0.0 {
                true => format!(
                    "contact.friction={{left={}, right={}}}",
                    self.friction_high, self.friction_low
                ),
                false => format!(
                    "contact.friction={{left={}, right={}}}",
                    self.friction_low, self.friction_high
                ),
            },
        ];
        let oriented = [("wheel", &self.wheel), ("rail", &self.rail)].into_iter();
        overrides.extend(oriented.filter_map(|(kind, profile)| {
            let name = profile.orientation?.name();
            Some(format!("profiles.{kind}_orientation={name}"))
        }));
        CurvingCase::parse("the curve of the page", METRO_CURVE_CASE, &overrides)
    }

    /// Put the names that the user knows in place of paths in all texts of a document.
    pub(super) fn name(&self, document: &mut Value, paths: &[String]) {
        match document {
            Value::String(words) => *words = self.named(words, paths),
            Value::Array(items) => items.iter_mut().for_each(|item| self.name(item, paths)),
            Value::Object(fields) => {
                fields
                    .values_mut()
                    .for_each(|field| self.name(field, paths));
            }
            _ => {}
        }
    }

    fn told(&self, remarks: &[Message], paths: &[String]) -> Vec<Note> {
        let told = remarks.iter().map(Note::from);
        told.map(|note| note.in_words(|words| self.named(words, paths)))
            .collect()
    }

    /// Words with the names that the user knows in place of paths.
    pub(super) fn named(&self, words: &str, paths: &[String]) -> String {
        let both = [&self.wheel, &self.rail].into_iter().zip(paths);
        both.fold(words.to_owned(), |words, (profile, path)| {
            let name: String = profile.name.chars().take(LONGEST_NAME).collect();
            words.replace(path.as_str(), &name)
        })
    }
}

/// A folder of its own for each question: gone with it, or with the program.
pub(super) fn place(uploads: &Uploads) -> Result<tempfile::TempDir, Fault> {
    let folder = uploads.folder();
    folder.map_err(|error| Fault::defect(format!("there is no place for files: {error}")))
}

/// Put a file of a question, a profile or the curve on them, into its folder.
pub(super) fn store(path: &Path, text: &str) -> Result<(), Fault> {
    std::fs::write(path, text)
        .map_err(|error| Fault::defect(format!("the profile cannot be stored: {error}")))
}

impl ProfileText {
    /// What the reader is given: the nominal name, or the path of the text in a folder. Nothing of a name becomes part of a path but an ending that
    /// is known.
    fn put(&self, folder: &Path, kind: &str) -> Result<String, Fault> {
        let Some(text) = &self.text else {
            return match riffel::profile::NominalProfile::named(&self.name) {
                Some(nominal) => Ok(nominal.name.to_owned()),
                None => Err(Fault::bad("there is no such nominal profile".to_owned())),
            };
        };
        let ending = self
            .name
            .rsplit('.')
            .next()
            .unwrap_or_default()
            .to_lowercase();
        let ending = ENDINGS
            .iter()
            .find(|known| **known == ending)
            .unwrap_or(&"csv");
        let path = folder.join(format!("{kind}.{ending}"));
        store(&path, text)?;
        Ok(path.display().to_string())
    }
}
