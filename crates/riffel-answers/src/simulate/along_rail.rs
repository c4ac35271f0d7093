//! A wheel along a measured profile.

use riffel::contact::ContactFilter;
use riffel::passage::ContactInstant;
use riffel::roughness::Profile;
use riffel_case::{Case, ContactName};
use riffel_keys::{CaseError, Message, fixed, say};
use riffel_plot::{Arrangement, LineFigure};
use serde::Serialize;

use super::{Course, files, force_in_words, remarks};
use crate::answer::titled;
use crate::parameters::parameters_on_rail;
use crate::{Answer, AnswerError, ResultFile, Table};

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
    /// Share of the time without contact.
    pub contact_loss_fraction: f64,
    /// Least normal force at any step.
    pub minimum_normal_force_n: f64,
    /// Largest normal force at any step.
    pub maximum_normal_force_n: f64,
    /// Mean square of the relative error of the track in time.
    track_share_cut: f64,
    /// The first contact, height by height.
    #[serde(flatten)]
    pub course: Course,
    /// All others of a loop on all axes, each at its own places.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub other_contacts: Vec<ContactCourse>,
    /// Names of all contacts of a loop on all axes; none of one wheel and one axis.
    #[serde(skip)]
    pub contacts: Vec<ContactName>,
    /// What the reader should know of the passage.
    #[serde(skip)]
    pub own_remarks: Vec<Message>,
    /// And of the case.
    #[serde(skip)]
    remarks: Vec<Message>,
    #[serde(skip)]
    profile: Profile,
    #[serde(skip)]
    case: Case,
}

/// One of several contacts place by place.
#[derive(Serialize)]
pub struct ContactCourse {
    #[serde(flatten)]
    name: ContactName,
    /// Place by place.
    #[serde(flatten)]
    pub course: Course,
}

impl PassageAnswer {
    /// A case along a profile.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Case::in_time`], for a profile coarser than the patch is long, and for one shorter than the
    /// motion remembers.
    pub fn new(case: &Case, request: PassageRequest) -> Result<Self, AnswerError> {
        let profile = &request.profile;
        check_sampling(case, profile)?;
        check_step(request.largest_step)?;
        let mut model = case.in_time(request.speed)?;
        model.contact_filter = request.contact_filter.then(|| ContactFilter::of(&case.hertz));
        let passage = model.pass(profile, request.largest_step).map_err(refused)?;
        let contacts = case.contact_names();
        let on_all_axes = !contacts.is_empty();
        let own_remarks: Vec<Message> =
            remarks::of_profile(profile).into_iter().chain(remarks::of_track(&model)).collect();
        let course = course(profile, &passage.contacts, 0.0, on_all_axes);
        let along = case.feedback.contacts().iter().map(|contact| contact.along);
        let others = contacts.iter().zip(along).skip(1).zip(&passage.others);
        let others = others.map(|((name, along), contacts)| ContactCourse {
            name: *name,
            course: self::course(profile, contacts, along, on_all_axes),
        });
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let [least, largest] = passage.normal_force;
        Ok(Self {
            speed_m_per_s: request.speed,
            step_m: passage.step,
            run_in_m: passage.run_in,
            mean_dissipation_j_per_m: mean(&course.dissipation_j_per_m),
            mean_creepage: mean(&course.creepage),
            contact_loss_fraction: passage.contact_loss,
            minimum_normal_force_n: least,
            maximum_normal_force_n: largest,
            track_share_cut: model.structures.share_cut(),
            other_contacts: others.collect(),
            course,
            remarks: case.remarks_at(request.speed).iter().chain(&own_remarks).cloned().collect(),
            own_remarks,
            contacts,
            profile: request.profile,
            case: case.clone(),
        })
    }
}

/// What a contact does at the heights of a profile, so far \[m\] ahead of the first wheel.
fn course(profile: &Profile, contacts: &[ContactInstant], along: f64, on_all_axes: bool) -> Course {
    let (spacing, heights) = (profile.spacing(), profile.heights());
    let place = |index: usize| profile.position(index) + along;
    let height = |index: usize| {
        let nearest = (index as f64 + along / spacing).round();
        heights[(nearest.max(0.0) as usize).min(heights.len() - 1)]
    };
    Course::new(
        (0..heights.len()).map(place).collect(),
        (0..heights.len()).map(height).collect(),
        contacts,
        on_all_axes,
    )
}

impl Answer for PassageAnswer {
    fn name(&self) -> &'static str {
        "passage"
    }
    fn document_name(&self) -> &'static str {
        "passage.json"
    }

    fn introduction(&self) -> Vec<Message> {
        let force = [self.minimum_normal_force_n, self.maximum_normal_force_n];
        vec![
            titled(self.case.file.title.as_ref(), say!(wheel_along_a_profile)),
            say!(
                length_of_passage,
                length = fixed(self.profile.length(), 2),
                start = fixed(self.profile.start(), 3),
                speed = fixed(3.6 * self.speed_m_per_s, 1),
                run_in = fixed(self.run_in_m, 2),
                step = fixed(1e3 * self.step_m, 3)
            ),
            force_in_words(force, self.contact_loss_fraction),
            say!(
                means_of_passage,
                creepage = fixed(100.0 * self.mean_creepage, 4),
                dissipation = fixed(self.mean_dissipation_j_per_m, 4)
            ),
        ]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.course.table(self.name())]
    }

    /// The passage as strips.
    fn figure(&self) -> LineFigure {
        LineFigure {
            title: format!("A passage at {:.1} km/h", 3.6 * self.speed_m_per_s),
            caption: format!("Wheel centre at x. {}", parameters_on_rail(&self.case)),
            panels: self.course.panels(),
            arrangement: Arrangement::Strips,
        }
    }

    fn files(&self) -> Vec<ResultFile<'_>> {
        let others = self.other_contacts.iter().map(|other| (other.name, &other.course));
        files(self, &self.course, others)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

/// `Ok` if a step along a profile \[m\] is no shorter than a micrometre, a million to a metre.
pub(super) fn check_step(step: f64) -> Result<(), AnswerError> {
    const LEAST: f64 = 1e-6;
    if step >= LEAST {
        return Ok(());
    }
    Err(AnswerError::Argument {
        argument: "--step",
        value: format!("{step:e} m"),
        rule: format!("at least {LEAST:e} m, a million steps to a metre"),
    })
}

/// `Ok` if a profile is sampled at least once in a semi-axis of the contact.
pub(super) fn check_sampling(case: &Case, profile: &Profile) -> Result<(), AnswerError> {
    let largest = case.hertz.semi_axis_longitudinal();
    if profile.spacing() <= largest {
        return Ok(());
    }
    Err(AnswerError::Argument {
        argument: "--profile",
        value: format!("sampled every {:.3} mm", 1e3 * profile.spacing()),
        rule: format!("sampled at least every {:.3} mm, the semi-axis of the contact along the rail", 1e3 * largest),
    })
}

/// A refusal of the physics, of the profile.
pub(super) fn refused(error: riffel::Error) -> CaseError {
    CaseError::Physics { input: "--profile".to_owned(), error }
}
