//! The settled state over a sinusoid.

use std::f64::consts::TAU;

use riffel::Complex64;
use riffel::error::as_typed;
use riffel::passage::{Harmonic, Settled, Sinusoid};
use riffel_case::{Case, ContactName, ask};
use riffel_keys::{Message, fixed, say};
use serde::Serialize;

use super::run::{March, model};
use super::{ContactHistory, Extremes, Run, refused, remarks};
use crate::number_alone;
use crate::{AnswerError, Column, Result, Table};

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

/// The settled state of a case over a sinusoid: serialised, what `riffel simulate --sinusoid --json` prints.
#[derive(Serialize)]
pub struct SinusoidAnswer {
    wavelength_m: f64,
    speed_m_per_s: f64,
    /// Of the profile.
    amplitude_m: f64,
    /// Of the march.
    step_m: f64,
    /// Those n = 0 … 5 of the first contact.
    pub harmonics: Vec<HarmonicDocument>,
    /// Harmonics of the energy that a place of the rail receives from a transient contact.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub energy_at_rail_j_per_m: Option<[[f64; 2]; 6]>,
    /// Loss of contact and normal forces of the first contact.
    #[serde(flatten)]
    pub extremes: Extremes,
    /// Mean square of the relative error of the track in time, with the wheels of a loop on all axes.
    track_share_cut: f64,
    /// Every contact of a loop on all axes, the one above first.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub contacts: Vec<ContactOverSinusoid>,
    /// The march; its courses are at the times at which the first wheel is at the places.
    #[serde(skip)]
    pub run: Run,
    #[serde(skip)]
    on_supports: bool,
}

/// One of several contacts over a sinusoid.
#[derive(Serialize)]
pub struct ContactOverSinusoid {
    #[serde(flatten)]
    name: ContactName,
    harmonics: Vec<HarmonicDocument>,
    #[serde(flatten)]
    extremes: Extremes,
}

/// One harmonic: complex amplitudes for exp(+inωt) relative to the profile Δ cos ωt upward; of harmonic zero the means.
#[derive(Clone, Serialize)]
pub struct HarmonicDocument {
    normal_force_n: [f64; 2],
    tangential_force_n: [f64; 2],
    /// Of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    lateral_force_n: Option<[f64; 2]>,
    creepage: [f64; 2],
    /// Of a loop on all axes.
    #[serde(skip_serializing_if = "Option::is_none")]
    lateral_creepage: Option<[f64; 2]>,
    /// At the wheel centre.
    dissipation_j_per_m: [f64; 2],
}

impl HarmonicDocument {
    /// With what is across the rail where the loop is `on_all_axes`.
    fn new(harmonic: &Harmonic, on_all_axes: bool) -> Self {
        let pair = |value: Complex64| [value.re, value.im];
        let across = |value| on_all_axes.then(|| pair(value));
        Self {
            normal_force_n: pair(harmonic.normal_force),
            tangential_force_n: pair(harmonic.tangential_force),
            lateral_force_n: across(harmonic.lateral_force),
            creepage: pair(harmonic.creepage),
            lateral_creepage: across(harmonic.lateral_creepage),
            dissipation_j_per_m: pair(harmonic.dissipation),
        }
    }

    /// Of a settled state.
    fn all(settled: &Settled, on_all_axes: bool) -> Vec<Self> {
        settled.harmonics.iter().map(|harmonic| Self::new(harmonic, on_all_axes)).collect()
    }
}

impl SinusoidRequest {
    /// A sinusoid at a speed \[m/s\], with as many steps to a wave as none is longer than asked \[m\].
    ///
    /// Where nothing is asked, they are the [usual ones](Sinusoid::usual_steps).
    ///
    /// # Errors
    /// [`AnswerError::Argument`] for a step or a slow wave that gives a wave too few or too many steps.
    pub fn new(speed: f64, profile: Sinusoid, step: Option<f64>) -> Result<Self> {
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
            Some(step) => AnswerError::argument(
                "--step",
                format!("{step} m"),
                format!(
                    "between {:.1e} and {:.1e} m, so that a wave has {least} to {most} steps",
                    wavelength / most,
                    wavelength / least,
                ),
            ),
            None => AnswerError::argument(
                "--sinusoid",
                format!("{} m, which passes in {:.2} s", as_typed(wavelength), wavelength / speed),
                "a wave that passes in 0.65 s or less: what is slower is followed by the whole vehicle, not by the \
                       wheel",
            ),
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
    /// [`CaseError`](riffel_keys::CaseError) as of [`ask::in_time`](riffel_case::ask::in_time) and for a point outside its physical range; [`riffel::Error`] where the motion
    /// does not settle.
    pub fn new(case: &Case, request: SinusoidRequest) -> Result<Self> {
        let SinusoidRequest { speed, profile, steps, contact_filter, transient } = request;
        case.check_points([profile.wavelength; 2], [speed; 2])?;
        let model = model(case, speed, contact_filter)?;
        let of_sinusoid = refused("--sinusoid");
        let even = model.structures.support_spacing().is_none();
        let one_wheel = even && case.feedback.is_along_one_axis();
        let (settled, others, energy_at_rail) = match (transient, one_wheel) {
            (false, _) => {
                let mut all = model.settle(profile, steps).map_err(&of_sinusoid)?;
                (all.remove(0), all, None)
            }
            (true, true) => {
                let contact = ask::transient_contact(case);
                let rolled = model.settle_transient(profile, steps, contact);
                let rolled = rolled.map_err(&of_sinusoid)?;
                (rolled.settled, Vec::new(), Some(rolled.energy_at_rail))
            }
            (true, false) => {
                return Err(AnswerError::argument(
                    "--transient",
                    "given",
                    "for one wheel with longitudinal creepage on a track that is even along the rail",
                ));
            }
        };
        let radius = case.hertz.rolling_radius();
        let troughs = remarks::of_troughs(profile.amplitude, profile.wavelength, radius);
        let supports = remarks::of_supports(&model, &profile);
        let elements =
            transient.then(|| remarks::of_elements(&ask::transient_contact(case), &settled, profile)).flatten();
        let remarks = remarks::of_track(&model).into_iter().chain(troughs).chain(supports).chain(elements);
        let run = Run::new(case, remarks, &ask::remarks_at(case, speed));
        let names = ask::contact_names(case);
        let on_all_axes = !names.is_empty();
        let all = || std::iter::once(&settled).chain(&others);
        let contacts = names.into_iter().zip(all()).map(|(name, settled)| ContactOverSinusoid {
            name,
            harmonics: HarmonicDocument::all(settled, on_all_axes),
            extremes: Extremes::new(settled.normal_force, settled.contact_loss),
        });
        Ok(Self {
            wavelength_m: profile.wavelength,
            speed_m_per_s: speed,
            amplitude_m: profile.amplitude,
            step_m: request.step(),
            harmonics: HarmonicDocument::all(&settled, on_all_axes),
            energy_at_rail_j_per_m: energy_at_rail.map(|harmonics| harmonics.map(|value| [value.re, value.im])),
            extremes: Extremes::new(settled.normal_force, settled.contact_loss),
            track_share_cut: model.structures.share_cut(),
            contacts: contacts.collect(),
            run: Run { courses: all().map(|settled| course(profile, settled, on_all_axes)).collect(), ..run },
            on_supports: !even,
        })
    }

    /// Harmonics for a reader: amplitudes, and of harmonic zero the means.
    fn harmonics(&self) -> Table {
        let size = |(number, [re, im]): (usize, [f64; 2])| match number {
            0 => re,
            _ => Complex64::new(re, im).norm(),
        };
        let column = |head, scale: f64, of: fn(&HarmonicDocument) -> [f64; 2]| {
            Column::digits(head, 4, self.harmonics.iter().map(of).enumerate().map(|harmonic| scale * size(harmonic)))
        };
        let numbers = (0..self.harmonics.len()).map(|number| match number {
            0 => say!(mean_column),
            number => number_alone(number),
        });
        let mut columns = vec![
            Column::shown(say!(harmonic_column), numbers.collect()),
            column(say!(normal_force_in_kilonewton), 1e-3, |harmonic| harmonic.normal_force_n),
            column(say!(creep_force_column), 1e-3, |harmonic| harmonic.tangential_force_n),
            column(say!(creepage_in_percent_column), 100.0, |harmonic| harmonic.creepage),
            column(say!(dissipation_column), 1.0, |harmonic| harmonic.dissipation_j_per_m),
        ];
        if !self.contacts.is_empty() {
            columns.extend([
                column(say!(lateral_force_column), 1e-3, |harmonic| harmonic.lateral_force_n.unwrap_or_default()),
                column(say!(lateral_creepage_column), 100.0, |harmonic| harmonic.lateral_creepage.unwrap_or_default()),
            ]);
        }
        if let Some(energy) = self.energy_at_rail_j_per_m {
            columns.push(Column::digits(
                say!(dissipation_at_the_rail_column),
                4,
                energy.into_iter().enumerate().map(size),
            ));
        }
        Table { name: "harmonics", columns }
    }
}

/// One wave under a contact, from crest to crest.
fn course(profile: Sinusoid, settled: &Settled, on_all_axes: bool) -> ContactHistory {
    let steps = settled.wave.len();
    let wave = settled.wave.iter().copied();
    let contacts: Vec<_> = std::iter::once(settled.crest).chain(wave).collect();
    let share = |step: usize| step as f64 / steps as f64;
    ContactHistory::new(
        (0..=steps).map(|step| profile.wavelength * share(step)).collect(),
        (0..=steps).map(|step| profile.amplitude * (TAU * share(step)).cos()).collect(),
        &contacts,
        on_all_axes,
    )
}

impl March for SinusoidAnswer {
    const NAME: &'static str = "wave";
    const DOCUMENT: &'static str = "harmonics.json";

    fn run(&self) -> &Run {
        &self.run
    }

    fn about(&self) -> Vec<Message> {
        vec![
            self.run.titled(say!(wheel_over_a_sinusoid)),
            say!(
                wave_and_speed,
                wavelength = fixed(1e3 * self.wavelength_m, 1),
                amplitude = fixed(1e6 * self.amplitude_m, 1),
                speed = fixed(3.6 * self.speed_m_per_s, 1),
                frequency = fixed(self.speed_m_per_s / self.wavelength_m, 1)
            ),
        ]
    }

    fn shown(&self) -> Option<Table> {
        Some(self.harmonics())
    }

    fn below_tables(&self) -> Vec<Message> {
        vec![self.extremes.sentence()]
    }

    fn picture(&self) -> (String, String, usize) {
        let state = match self.on_supports {
            _ if self.energy_at_rail_j_per_m.is_some() => "Settled state of the exact contact",
            true => "The last wave of many bays",
            false => "Settled state",
        };
        let title = format!(
            "A wave of {:.1} mm and {:.1} µm at {:.1} km/h",
            1e3 * self.wavelength_m,
            1e6 * self.amplitude_m,
            3.6 * self.speed_m_per_s
        );
        (title, format!("{state}, wheel centre at x."), 0)
    }
}
