//! A wheel along a measured profile.

use riffel::contact::ContactFilter;
use riffel::passage::{ContactInstant, Passage, PassageModel};
use riffel::roughness::Profile;
use riffel_case::{Case, ContactName};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure};

use super::{ContactCourseDocument, Course, PassageDocument, remarks};
use crate::AnswerError;
use crate::parameters::parameters_on_rail;

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

/// One passage of a case along a profile.
pub struct PassageAnswer {
    /// What was asked.
    pub request: PassageRequest,
    /// The passage.
    pub passage: Passage,
    /// The model, of which the answer is.
    pub model: PassageModel,
    /// Names of all contacts of a loop on all axes, and how far each is ahead of the first wheel \[m\], below zero behind it; none of
    /// one wheel and one axis.
    pub contacts: Vec<(ContactName, f64)>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
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
        Ok(Self {
            remarks: remarks::of_profile(profile).into_iter().chain(remarks::of_track(&model)).collect(),
            contacts: case
                .contact_names()
                .into_iter()
                .zip(case.feedback.contacts().iter().map(|contact| contact.along))
                .collect(),
            request,
            passage,
            model,
        })
    }

    /// The passage as data: what `riffel simulate --profile --json` prints.
    pub fn document(&self) -> PassageDocument {
        let [least, largest] = self.passage.normal_force;
        let course = self.course();
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        PassageDocument {
            speed_m_per_s: self.request.speed,
            step_m: self.passage.step,
            run_in_m: self.passage.run_in,
            mean_dissipation_j_per_m: mean(&course.dissipation_j_per_m),
            mean_creepage: mean(&course.creepage),
            contact_loss_fraction: self.passage.contact_loss,
            minimum_normal_force_n: least,
            maximum_normal_force_n: largest,
            track_share_cut: self.model.structures.share_cut(),
            course,
            other_contacts: self.other_courses(),
        }
    }

    /// The passage of the first contact, height by height.
    pub fn course(&self) -> Course {
        self.course_of(&self.passage.contacts, 0.0)
    }

    /// That of all others, each at its own places.
    pub fn other_courses(&self) -> Vec<ContactCourseDocument> {
        let others = self.contacts.iter().skip(1).zip(&self.passage.others);
        let others = others
            .map(|(&(name, along), contacts)| ContactCourseDocument { name, course: self.course_of(contacts, along) });
        others.collect()
    }

    fn course_of(&self, contacts: &[ContactInstant], along: f64) -> Course {
        let profile = &self.request.profile;
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
            !self.contacts.is_empty(),
        )
    }

    /// The passage as strips.
    pub fn figure(&self, case: &Case) -> LineFigure {
        LineFigure {
            title: format!("A passage at {:.1} km/h", 3.6 * self.request.speed),
            caption: format!("Wheel centre at x. {}", parameters_on_rail(case)),
            panels: self.course().panels(),
            arrangement: Arrangement::Strips,
        }
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
