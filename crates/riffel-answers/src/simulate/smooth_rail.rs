//! Wheels of a case on a smooth rail.

use riffel::feedback::Stability;
use riffel::passage::{Outcome, PassageModel, SmoothRail};
use riffel_case::{Case, ContactName};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure};

use super::along_rail::check_step;
use super::{ContactSwingDocument, Course, SmoothRailDocument, remarks};
use crate::AnswerError;
use crate::parameters::parameters_on_rail;

/// What becomes of a push on a smooth rail: rest, or the limit cycle of a loop that is unstable without any profile.
pub struct SmoothRailAnswer {
    /// \[m/s\]
    pub speed: f64,
    /// What the wheels do.
    pub motion: SmoothRail,
    /// What the linear loop says, where its phase can be followed.
    pub stability: Option<Stability>,
    /// Names of the contacts.
    pub contacts: Vec<ContactName>,
    share_cut: f64,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

impl SmoothRailAnswer {
    /// A case at a speed \[m/s\], in steps of at most the length given \[m\].
    ///
    /// # Errors
    /// [`CaseError`] for a case of one wheel and longitudinal creepage alone, which has nothing to swing against, and those of
    /// [`Case::in_time_without_profile`].
    pub fn new(case: &Case, speed: f64, step: Option<f64>) -> Result<Self, AnswerError> {
        let longest = PassageModel::LONGEST_TIME_STEP * speed;
        let step = step.unwrap_or(longest);
        check_step(step)?;
        if step > longest {
            return Err(AnswerError::Argument {
                argument: "--step",
                value: format!("{step} m"),
                rule: format!("at most {longest:.1e} m on a smooth rail, 10 µs at this speed"),
            });
        }
        case.check_points([case.wavelength.min(); 2], [speed; 2])?;
        let model = case.in_time_without_profile(speed)?;
        if case.feedback.is_along_one_axis() {
            return Err(case
                .refuse(
                    "contact.creepage",
                    "one wheel with longitudinal creepage alone has nothing to swing against on a smooth rail: give a \
                     [wheelset], or contact.creepage as a table",
                )
                .into());
        }
        let stability = case.stability(speed);
        // Where the root is not found, an unstable loop is given its time all the same.
        let growth = stability
            .as_ref()
            .filter(|stability| stability.unstable_roots > 0)
            .map(|stability| stability.growth_rate.unwrap_or(1.0));
        let motion = model
            .on_smooth_rail(step, growth)
            .map_err(|error| CaseError::Physics { input: "--smooth".to_owned(), error })?;
        let roots = stability.as_ref().map(|stability| stability.unstable_roots);
        Ok(Self {
            speed,
            stability,
            contacts: case.contact_names(),
            share_cut: model.structures.share_cut(),
            remarks: remarks::of_track(&model)
                .into_iter()
                .chain((motion.outcome == Outcome::RunsAway).then(remarks::of_sliding))
                .chain(remarks::of_linear_loop(&motion, roots))
                .collect(),
            motion,
        })
    }

    /// How it ends, as it is written.
    pub fn outcome(&self) -> &'static str {
        match self.motion.outcome {
            Outcome::AtRest => "at-rest",
            Outcome::LimitCycle => "limit-cycle",
            Outcome::RunsAway => "runs-away",
            Outcome::Irregular => "irregular",
        }
    }

    /// What `riffel simulate --smooth --json` prints.
    pub fn document(&self) -> SmoothRailDocument {
        let pairs = self.contacts.iter().zip(&self.motion.contacts);
        SmoothRailDocument {
            speed_m_per_s: self.speed,
            step_m: self.motion.step,
            outcome: self.outcome(),
            rolled_s: self.motion.seconds,
            frequency_hz: self.motion.frequency,
            linear_unstable_roots: self.stability.as_ref().map(|stability| stability.unstable_roots),
            linear_frequency_hz: self.stability.as_ref().and_then(|stability| stability.frequency),
            linear_growth_rate_per_s: self.stability.as_ref().and_then(|stability| stability.growth_rate),
            contacts: pairs.map(|(&name, swing)| ContactSwingDocument::new(name, swing)).collect(),
            track_share_cut: self.share_cut,
            course: self.course(),
        }
    }

    /// A few periods of the first contact.
    pub fn course(&self) -> Course {
        self.course_of(0)
    }

    /// The same of all contacts in their order.
    pub fn courses(&self) -> Vec<Course> {
        (0..self.contacts.len()).map(|contact| self.course_of(contact)).collect()
    }

    fn course_of(&self, contact: usize) -> Course {
        let course = &self.motion.course[contact];
        let places = (0..course.len()).map(|index| index as f64 * self.motion.step);
        Course::new(places.collect(), vec![0.0; course.len()], course, true)
    }

    /// A few periods of the contact that swings most, as strips.
    pub fn figure(&self, case: &Case) -> LineFigure {
        let span = |[least, most]: [f64; 2]| most - least;
        let swings = self
            .motion
            .contacts
            .iter()
            .map(|swing| span(swing.tangential_force).max(span(swing.lateral_force)).max(span(swing.normal_force)));
        let largest = swings.enumerate().max_by(|one, other| one.1.total_cmp(&other.1));
        let most = largest.map_or(0, |(index, _)| index);
        let ContactName { wheel, rail } = self.contacts[most];
        let what = match (self.motion.outcome, self.motion.frequency) {
            (Outcome::RunsAway, _) => "the wheels slide off".to_owned(),
            (Outcome::AtRest, _) | (_, None) => "at rest".to_owned(),
            (Outcome::LimitCycle, Some(frequency)) => {
                format!("limit cycle of {frequency:.0} Hz")
            }
            (Outcome::Irregular, Some(frequency)) => {
                format!("motion that has not settled, like itself at {frequency:.0} Hz")
            }
        };
        LineFigure {
            title: format!("A smooth rail at {:.1} km/h: {what}", 3.6 * self.speed),
            caption: format!("Wheel {wheel} on the {rail} rail. {}", parameters_on_rail(case)),
            panels: self.course_of(most).panels(),
            arrangement: Arrangement::Strips,
        }
    }
}
