//! A wheel along a measured profile.

use riffel::passage::ContactInstant;
use riffel::roughness::Profile;
use riffel_case::{Case, ContactName, ask};
use riffel_keys::{Message, fixed, say};
use serde::{Serialize, Serializer};

use super::run::{March, model};
use super::{ContactHistory, Extremes, Run, refused, remarks};
use crate::{AnswerError, Result};

/// A profile to roll over.
#[derive(Debug, Clone, PartialEq)]
pub struct PassageRequest {
    /// \[m/s\].
    pub speed: f64,
    /// The profile.
    pub profile: Profile,
    /// Longest step of the march \[m\].
    pub largest_step: f64,
    /// The wheel feels the mean over the patch in the place of the height.
    pub contact_filter: bool,
}

impl PassageRequest {
    /// Longest step where nothing else is asked \[m\].
    pub const USUAL_STEP: f64 = 5e-4;
}

/// One passage of a case along a profile: serialised, what `riffel simulate --profile --json` prints.
#[derive(Serialize)]
pub struct PassageAnswer {
    speed_m_per_s: f64,
    /// Step of the march.
    pub step_m: f64,
    /// Run-in before the profile.
    pub run_in_m: f64,
    mean_dissipation_j_per_m: f64,
    mean_creepage: f64,
    /// Loss of contact and normal forces at any step.
    #[serde(flatten)]
    pub extremes: Extremes,
    /// Mean square of the relative error of the track in time.
    track_share_cut: f64,
    /// The march; its courses go height by height, each contact at its own places.
    #[serde(flatten, serialize_with = "courses")]
    pub run: Run,
    #[serde(skip)]
    profile: Profile,
}

/// The first contact, height by height, and all others of a loop on all axes.
fn courses<S: Serializer>(run: &Run, serializer: S) -> Result<S::Ok, S::Error> {
    #[derive(Serialize)]
    struct Other<'a> {
        #[serde(flatten)]
        name: ContactName,
        #[serde(flatten)]
        course: &'a ContactHistory,
    }
    #[derive(Serialize)]
    struct Courses<'a> {
        #[serde(flatten)]
        first: &'a ContactHistory,
        #[serde(skip_serializing_if = "Vec::is_empty")]
        other_contacts: Vec<Other<'a>>,
    }
    let other_contacts = run.others().map(|(name, course)| Other { name, course }).collect();
    Courses { first: &run.courses[0], other_contacts }.serialize(serializer)
}

impl PassageAnswer {
    /// A case along a profile.
    ///
    /// # Errors
    /// [`CaseError`](riffel_keys::CaseError) as of [`ask::in_time`](riffel_case::ask::in_time), for a profile coarser than the patch is long, and for one shorter than the
    /// motion remembers.
    pub fn new(case: &Case, request: PassageRequest) -> Result<Self> {
        let profile = &request.profile;
        check_sampling(case, profile)?;
        check_step(request.largest_step)?;
        let model = model(case, request.speed, request.contact_filter)?;
        let passage = model.pass(profile, request.largest_step).map_err(refused("--profile"))?;
        let contacts = ask::contact_names(case);
        let own_remarks = remarks::of_profile(profile).into_iter().chain(remarks::of_track(&model));
        let along = case.feedback.contacts().iter().map(|contact| contact.along).skip(1);
        let courses = [(0.0, &passage.contacts)].into_iter().chain(along.zip(&passage.others));
        let courses = courses.map(|(along, instants)| course(profile, instants, along, !contacts.is_empty()));
        let courses: Vec<ContactHistory> = courses.collect();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        Ok(Self {
            speed_m_per_s: request.speed,
            step_m: passage.step,
            run_in_m: passage.run_in,
            mean_dissipation_j_per_m: mean(&courses[0].dissipation_j_per_m),
            mean_creepage: mean(&courses[0].creepage),
            extremes: Extremes::new(passage.normal_force, passage.contact_loss),
            track_share_cut: model.structures.share_cut(),
            run: Run { courses, contacts, ..Run::new(case, own_remarks, &ask::remarks_at(case, request.speed)) },
            profile: request.profile,
        })
    }
}

/// What a contact does at the heights of a profile, so far \[m\] ahead of the first wheel.
fn course(profile: &Profile, contacts: &[ContactInstant], along: f64, on_all_axes: bool) -> ContactHistory {
    let (spacing, heights) = (profile.spacing(), profile.heights());
    let place = |index: usize| profile.position(index) + along;
    let height = |index: usize| {
        let nearest = (index as f64 + along / spacing).round();
        heights[(nearest.max(0.0) as usize).min(heights.len() - 1)]
    };
    ContactHistory::new(
        (0..heights.len()).map(place).collect(),
        (0..heights.len()).map(height).collect(),
        contacts,
        on_all_axes,
    )
}

impl March for PassageAnswer {
    const NAME: &'static str = "passage";
    const DOCUMENT: &'static str = "passage.json";

    fn run(&self) -> &Run {
        &self.run
    }

    fn about(&self) -> Vec<Message> {
        vec![
            self.run.titled(say!(wheel_along_a_profile)),
            say!(
                length_of_passage,
                length = fixed(self.profile.length(), 2),
                start = fixed(self.profile.start(), 3),
                speed = fixed(3.6 * self.speed_m_per_s, 1),
                run_in = fixed(self.run_in_m, 2),
                step = fixed(1e3 * self.step_m, 3)
            ),
            self.extremes.sentence(),
            say!(
                means_of_passage,
                creepage = fixed(100.0 * self.mean_creepage, 4),
                dissipation = fixed(self.mean_dissipation_j_per_m, 4)
            ),
        ]
    }

    fn picture(&self) -> (String, String, usize) {
        (format!("A passage at {:.1} km/h", 3.6 * self.speed_m_per_s), "Wheel centre at x.".to_owned(), 0)
    }
}

/// `Ok` if a step along a profile \[m\] is no shorter than a micrometre, a million to a metre.
pub(super) fn check_step(step: f64) -> Result<()> {
    const LEAST: f64 = 1e-6;
    if step >= LEAST {
        return Ok(());
    }
    Err(AnswerError::argument(
        "--step",
        format!("{step:e} m"),
        format!("at least {LEAST:e} m, a million steps to a metre"),
    ))
}

/// `Ok` if a profile is sampled at least once in a semi-axis of the contact.
pub(super) fn check_sampling(case: &Case, profile: &Profile) -> Result<()> {
    let largest = case.hertz.semi_axis_longitudinal();
    if profile.spacing() <= largest {
        return Ok(());
    }
    Err(AnswerError::argument(
        "--profile",
        format!("sampled every {:.3} mm", 1e3 * profile.spacing()),
        format!("sampled at least every {:.3} mm, the semi-axis of the contact along the rail", 1e3 * largest),
    ))
}
