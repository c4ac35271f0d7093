//! The settled state over a sinusoid.

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel::contact::ContactFilter;
use riffel::error::readable;
use riffel::passage::{PassageModel, Settled, Sinusoid};
use riffel_case::{Case, ContactName};
use riffel_keys::{CaseError, Message};
use riffel_plot::{Arrangement, LineFigure};

use super::{ContactOverSinusoidDocument, Course, HarmonicDocument, SinusoidDocument, remarks};
use crate::AnswerError;
use crate::parameters::parameters_on_rail;

/// A sinusoid to roll over.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SinusoidRequest {
    /// \[m/s\].
    pub speed: f64,
    /// The profile.
    pub profile: Sinusoid,
    /// Steps to a wave.
    pub steps: usize,
    /// The wheel feels the mean over the patch in the place of the height.
    pub contact_filter: bool,
    /// The contact of the half-space, followed element by element, in the place of that of the case.
    pub transient: bool,
}

/// The settled state of a case over a sinusoid.
pub struct SinusoidAnswer {
    /// What was asked.
    pub request: SinusoidRequest,
    /// The model, of which the answer is.
    pub model: PassageModel,
    /// The state of the first contact.
    pub settled: Settled,
    /// Names of all contacts of a loop on all axes, and states of those after the first; none of one wheel and one axis.
    pub contacts: Vec<ContactName>,
    /// Those states.
    pub others: Vec<Settled>,
    /// Harmonics of the energy that a place of the rail receives \[J/m\], of a transient contact.
    pub energy_at_rail: Option<[Complex64; 6]>,
    /// What the reader should know.
    pub remarks: Vec<Message>,
}

impl SinusoidRequest {
    /// A sinusoid at a speed \[m/s\], with as many steps to a wave as none is longer than asked \[m\].
    ///
    /// Where nothing is asked, they are the [usual ones](Sinusoid::usual_steps).
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a step or a slow wave that gives a wave too few or too many steps.
    pub fn new(speed: f64, profile: Sinusoid, step: Option<f64>) -> Result<Self, AnswerError> {
        let wavelength = profile.wavelength;
        let (least, most) = (Sinusoid::LEAST_STEPS as f64, Sinusoid::MOST_STEPS as f64);
        let steps = match step {
            Some(step) => (wavelength / step).ceil(),
            None => profile.usual_steps(speed) as f64,
        };
        if (least..=most).contains(&steps) {
            return Ok(Self { speed, profile, steps: steps as usize, contact_filter: false, transient: false });
        }
        Err(match step {
            Some(step) => AnswerError::Argument {
                argument: "--step",
                value: format!("{step} m"),
                rule: format!(
                    "between {:.1e} and {:.1e} m, so that a wave has {least} to {most} steps",
                    wavelength / most,
                    wavelength / least,
                ),
            },
            None => AnswerError::Argument {
                argument: "--sinusoid",
                value: format!("{} m, which passes in {:.2} s", readable(wavelength), wavelength / speed),
                rule:
                    "a wave that passes in 0.65 s or less: what is slower is followed by the whole vehicle, not by the \
                       wheel"
                        .to_owned(),
            },
        })
    }

    /// Length of a step of the march \[m\].
    pub fn step(&self) -> f64 {
        self.profile.wavelength / self.steps as f64
    }
}

impl SinusoidAnswer {
    /// A case over a sinusoid.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Case::in_time`] and for a point outside its physical range; [`riffel::Error`] where the motion
    /// does not settle.
    pub fn new(case: &Case, request: SinusoidRequest) -> Result<Self, AnswerError> {
        let SinusoidRequest { speed, profile, steps, contact_filter, transient } = request;
        case.check_points([profile.wavelength; 2], [speed; 2])?;
        let mut model = case.in_time(speed)?;
        model.contact_filter = contact_filter.then(|| ContactFilter::of(&case.hertz));
        let of_sinusoid = |error| CaseError::Physics { input: "--sinusoid".to_owned(), error };
        let even = model.structures.support_spacing().is_none();
        let one_wheel = even && case.feedback.is_along_one_axis();
        let (settled, others, energy_at_rail) = match (transient, one_wheel) {
            (false, _) => {
                let mut all = model.settle(profile, steps).map_err(of_sinusoid)?;
                (all.remove(0), all, None)
            }
            (true, true) => {
                let contact = case.transient_contact();
                let rolled = model.settle_transient(profile, steps, contact);
                let rolled = rolled.map_err(of_sinusoid)?;
                (rolled.settled, Vec::new(), Some(rolled.energy_at_rail))
            }
            (true, false) => {
                return Err(AnswerError::Argument {
                    argument: "--transient",
                    value: "given".to_owned(),
                    rule: "for one wheel with longitudinal creepage on a track that is even along the rail".to_owned(),
                });
            }
        };
        let radius = case.hertz.rolling_radius();
        let troughs = remarks::of_troughs(profile.amplitude, profile.wavelength, radius);
        let supports = remarks::of_supports(&model, &profile);
        let elements = transient.then(|| remarks::of_elements(&case.transient_contact(), &settled, profile)).flatten();
        let remarks = remarks::of_track(&model).into_iter().chain(troughs).chain(supports).chain(elements);
        Ok(Self {
            remarks: remarks.collect(),
            request,
            model,
            contacts: case.contact_names(),
            settled,
            others,
            energy_at_rail,
        })
    }

    /// The harmonics as data: what `riffel simulate --sinusoid --json` prints.
    pub fn document(&self) -> SinusoidDocument {
        let SinusoidRequest { speed, profile, .. } = self.request;
        let [least, largest] = self.settled.normal_force;
        SinusoidDocument {
            wavelength_m: profile.wavelength,
            speed_m_per_s: speed,
            amplitude_m: profile.amplitude,
            step_m: self.request.step(),
            harmonics: self.harmonics(&self.settled),
            energy_at_rail_j_per_m: self.energy_at_rail.map(|harmonics| harmonics.map(|value| [value.re, value.im])),
            contact_loss_fraction: self.settled.contact_loss,
            minimum_normal_force_n: least,
            maximum_normal_force_n: largest,
            track_share_cut: self.model.structures.share_cut(),
            contacts: self
                .contacts
                .iter()
                .zip(std::iter::once(&self.settled).chain(&self.others))
                .map(|(&name, settled)| ContactOverSinusoidDocument {
                    name,
                    harmonics: self.harmonics(settled),
                    contact_loss_fraction: settled.contact_loss,
                    minimum_normal_force_n: settled.normal_force[0],
                    maximum_normal_force_n: settled.normal_force[1],
                })
                .collect(),
        }
    }

    fn harmonics(&self, settled: &Settled) -> Vec<HarmonicDocument> {
        let on_all_axes = !self.contacts.is_empty();
        let harmonics = settled.harmonics.iter();
        harmonics.map(|harmonic| HarmonicDocument::new(harmonic, on_all_axes)).collect()
    }

    /// One wave under the first contact, from crest to crest.
    pub fn course(&self) -> Course {
        self.course_of(&self.settled)
    }

    /// The same for all contacts in their order, each at the times at which the first wheel is at the places.
    pub fn courses(&self) -> Vec<Course> {
        let all = std::iter::once(&self.settled).chain(&self.others);
        all.map(|settled| self.course_of(settled)).collect()
    }

    fn course_of(&self, settled: &Settled) -> Course {
        let SinusoidRequest { profile, .. } = self.request;
        let steps = settled.wave.len();
        let wave = settled.wave.iter().copied();
        let contacts: Vec<_> = std::iter::once(settled.crest).chain(wave).collect();
        let share = |step: usize| step as f64 / steps as f64;
        Course::new(
            (0..=steps).map(|step| profile.wavelength * share(step)).collect(),
            (0..=steps).map(|step| profile.amplitude * (TAU * share(step)).cos()).collect(),
            &contacts,
            !self.contacts.is_empty(),
        )
    }

    /// One wave as strips.
    pub fn figure(&self, case: &Case) -> LineFigure {
        let SinusoidRequest { speed, profile, .. } = self.request;
        let state = match self.model.structures.support_spacing() {
            _ if self.energy_at_rail.is_some() => "Settled state of the exact contact",
            Some(_) => "The last wave of many bays",
            None => "Settled state",
        };
        LineFigure {
            title: format!(
                "A wave of {:.1} mm and {:.1} µm at {:.1} km/h",
                1e3 * profile.wavelength,
                1e6 * profile.amplitude,
                3.6 * speed
            ),
            caption: format!("{state}, wheel centre at x. {}", parameters_on_rail(case)),
            panels: self.course().panels(),
            arrangement: Arrangement::Strips,
        }
    }
}
