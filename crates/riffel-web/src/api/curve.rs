//! `POST /api/curve`: profiles of a wheel and a rail, and how a bogie stands on them in a curve.

use std::collections::BTreeMap;

use axum::extract::State;
use riffel_answers::curve::CurveAnswer;
use riffel_answers::profile::OutlineAnswer;
use riffel_case::{CurvingCase, METRO_CURVE_CASE};
use riffel_curving::profile::NominalProfile;
use riffel_keys::text_file::with_texts;
use riffel_keys::{CaseError, Message};
use riffel_rail::{ProfileOrientation, ProfileReading};
use serde::{Deserialize, Serialize};

use crate::Page;
use crate::fault::{Fault, Refusal};
use crate::json_with_messages::JsonWithMessages;
use crate::request::{ClientId, Json};

/// What errors call the case of a question.
pub(super) const NAME: &str = "the curve of the page";
/// Longest name of a file that is shown, in letters.
const LONGEST_NAME: usize = 120;

/// Keys of the case of a curve that a page may give: none of them names a file.
const KEYS: [&str; 10] = [
    "curve.radius",
    "curve.speed",
    "curve.cant",
    "profiles.gauge",
    "bogie.wheelbase",
    "bogie.mass_per_axle",
    "bogie.primary_longitudinal_stiffness",
    "bogie.primary_lateral_stiffness",
    "contact.friction.left",
    "contact.friction.right",
];

#[derive(Deserialize)]
pub(crate) struct Question {
    wheel: ProfileText,
    rail: ProfileText,
    /// Keys of the case of the curve besides its profiles, with their values.
    set: BTreeMap<String, toml::Value>,
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

#[derive(Serialize)]
pub(crate) struct Answer {
    outlines: OutlineAnswer,
    curve: InCurve,
    remarks: Vec<Message>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum InCurve {
    Found(Box<CurveAnswer>),
    Refused { fault: Fault },
}

impl Question {
    /// `Ok` if its profiles are known ones or come with it, and its keys are those of a page.
    pub(super) fn check(&self) -> Result<(), Fault> {
        if let Some(key) = self.set.keys().find(|key| !KEYS.contains(&key.as_str())) {
            return Err(Fault::misunderstood(&format!("{key} is no key of the curve of a page")));
        }
        // No other name may reach a reader: it would be a file of this machine.
        let is_known = |profile: &ProfileText| profile.text.is_some() || NominalProfile::named(&profile.name).is_some();
        match [&self.wheel, &self.rail].into_iter().all(is_known) {
            true => Ok(()),
            false => Err(Fault::bad("there is no such nominal profile")),
        }
    }
}

pub(crate) async fn post(
    State(page): State<Page>,
    client: ClientId,
    Json(question): Json<Question>,
) -> Result<JsonWithMessages<Answer>, Refusal> {
    question.check()?;
    page.queue.run(client.subject("curve"), move |_| with_texts(question.texts(), || question.answer())).await
}

impl Question {
    fn answer(&self) -> Result<JsonWithMessages<Answer>, Fault> {
        let names = self.names();
        let profiles = [&self.wheel, &self.rail].into_iter().zip(&names);
        let outlines = OutlineAnswer::new(profiles.map(|(profile, name)| {
            let reading = ProfileReading { orientation: profile.orientation, ..ProfileReading::default() };
            (name.into(), reading)
        }))?;
        // Short of an equilibrium the profiles are still worth seeing.
        let vehicle = self.curving().and_then(|case| Ok((case.vehicle_in_curve()?, case)));
        let curve = vehicle.and_then(|(vehicle, case)| CurveAnswer::of_vehicle(&case, vehicle));
        let curve = match curve {
            Ok(answer) => InCurve::Found(Box::new(answer)),
            Err(error) => InCurve::Refused { fault: error.into() },
        };
        Ok(JsonWithMessages(Answer { curve, remarks: outlines.remarks.clone(), outlines }))
    }

    /// What the readers are given for each profile: the nominal name, or that of the text, which is no other's.
    fn names(&self) -> [String; 2] {
        let [wheel, rail] = [&self.wheel, &self.rail].map(ProfileText::shown);
        match self.rail.text.is_some() && wheel == rail {
            true => [wheel, format!("rail/{rail}")],
            false => [wheel, rail],
        }
    }

    /// The texts with their names.
    pub(super) fn texts(&self) -> Vec<(String, String)> {
        let texts = [&self.wheel.text, &self.rail.text].into_iter();
        let named = self.names().into_iter().zip(texts);
        named.filter_map(|(name, text)| Some((name, text.clone()?))).collect()
    }

    /// The case of `riffel curve`.
    pub(super) fn curving(&self) -> Result<CurvingCase, CaseError> {
        let mut keys = self.set.clone();
        let [wheel, rail] = self.names();
        for (kind, profile, name) in [("wheel", &self.wheel, wheel), ("rail", &self.rail, rail)] {
            keys.insert(format!("profiles.{kind}"), name.into());
            let orientation = profile.orientation.map(|orientation| orientation.name().into());
            keys.extend(orientation.map(|orientation| (format!("profiles.{kind}_orientation"), orientation)));
        }
        let overrides: Vec<String> = keys.iter().map(|(key, value)| format!("{key}={value}")).collect();
        CurvingCase::parse(NAME, METRO_CURVE_CASE, &overrides)
    }
}

impl ProfileText {
    /// The name by which it is read, which is no nominal one where there is a text.
    fn shown(&self) -> String {
        let beyond = self.name.chars().count().saturating_sub(LONGEST_NAME);
        let name: String = self.name.chars().skip(beyond).collect();
        match self.text.is_some() && NominalProfile::named(&name).is_some() {
            true => format!("{name}.csv"),
            false => name,
        }
    }
}
