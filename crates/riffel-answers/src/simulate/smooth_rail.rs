//! Wheels of a case on a smooth rail.

use riffel::passage::{ContactInstant, ContactSwing, Outcome, PassageModel};
use riffel_case::{Case, ContactName, ask};
use riffel_keys::{Message, fixed, say};
use serde::{Serialize, Serializer};

use super::along_rail::check_step;
use super::run::March;
use super::{ContactHistory, Run, refused, remarks};
use crate::{AnswerError, Result, Rows, Table};

/// What becomes of a push on a smooth rail: rest, or the limit cycle of a loop that is unstable without any profile; serialised, what
/// `riffel simulate --smooth --json` prints.
#[derive(Serialize)]
pub struct SmoothRailAnswer {
    speed_m_per_s: f64,
    /// Of the march.
    step_m: f64,
    /// `at-rest`, `limit-cycle`, `runs-away` or `irregular`.
    #[serde(serialize_with = "as_written")]
    outcome: Outcome,
    /// Until that was seen.
    rolled_s: f64,
    /// With which all forces repeat themselves; none at rest.
    frequency_hz: Option<f64>,
    /// In the half-plane of growing oscillations; `None` if the phase of the linear loop cannot be followed.
    linear_unstable_roots: Option<usize>,
    /// That grows in the linear loop.
    linear_frequency_hz: Option<f64>,
    /// Of its amplitude.
    linear_growth_rate_per_s: Option<f64>,
    /// That of the first wheel on the rail under study first.
    contacts: Vec<ContactSwings>,
    /// Mean square of the relative error of track and wheels in time.
    track_share_cut: f64,
    /// The march; its courses are a few periods at the end.
    #[serde(flatten, serialize_with = "first_course")]
    pub run: Run,
}

fn first_course<S: Serializer>(run: &Run, serializer: S) -> Result<S::Ok, S::Error> {
    run.courses[0].serialize(serializer)
}

/// Least and largest of what a contact did over the last half second.
#[derive(Serialize)]
struct ContactSwings {
    #[serde(flatten)]
    name: ContactName,
    normal_force_n: [f64; 2],
    /// Along the rail.
    tangential_force_n: [f64; 2],
    lateral_force_n: [f64; 2],
    /// Along the rail.
    creepage: [f64; 2],
    lateral_creepage: [f64; 2],
    /// Share of the time below the creepage of the greatest creep force.
    stick_fraction: f64,
    mean_dissipation_j_per_m: f64,
}

impl ContactSwings {
    fn new(name: ContactName, swing: &ContactSwing) -> Self {
        Self {
            name,
            normal_force_n: swing.normal_force,
            tangential_force_n: swing.tangential_force,
            lateral_force_n: swing.lateral_force,
            creepage: swing.creepage,
            lateral_creepage: swing.lateral_creepage,
            stick_fraction: swing.stick,
            mean_dissipation_j_per_m: swing.dissipation,
        }
    }

    /// Of its forces, the largest range.
    fn span(&self) -> f64 {
        let span = |[least, most]: [f64; 2]| most - least;
        span(self.tangential_force_n).max(span(self.lateral_force_n)).max(span(self.normal_force_n))
    }
}

fn as_written<S: Serializer>(outcome: &Outcome, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(match outcome {
        Outcome::AtRest => "at-rest",
        Outcome::LimitCycle => "limit-cycle",
        Outcome::RunsAway => "runs-away",
        Outcome::Irregular => "irregular",
    })
}

impl SmoothRailAnswer {
    /// A case at a speed \[m/s\], in steps of at most the length given \[m\].
    ///
    /// # Errors
    /// [`CaseError`](riffel_keys::CaseError) for a case of one wheel and longitudinal creepage alone, which has nothing to swing against, and those of
    /// [`ask::in_time_without_profile`](riffel_case::ask::in_time_without_profile).
    pub fn new(case: &Case, speed: f64, step: Option<f64>) -> Result<Self> {
        let longest = PassageModel::LONGEST_TIME_STEP * speed;
        let step = step.unwrap_or(longest);
        check_step(step)?;
        if step > longest {
            return Err(AnswerError::argument(
                "--step",
                format!("{step} m"),
                format!("at most {longest:.1e} m on a smooth rail, 10 µs at this speed"),
            ));
        }
        case.check_points([case.wavelength.min(); 2], [speed; 2])?;
        let model = ask::in_time_without_profile(case, speed)?;
        if case.feedback.is_along_one_axis() {
            return Err(case
                .refuse(
                    "contact.creepage",
                    "one wheel with longitudinal creepage alone has nothing to swing against on a smooth rail: give a \
                     [wheelset], or contact.creepage as a table",
                )
                .into());
        }
        let stability = ask::stability(case, speed);
        // Where the root is not found, an unstable loop is given its time all the same.
        let growth = stability
            .as_ref()
            .filter(|stability| stability.unstable_roots > 0)
            .map(|stability| stability.growth_rate.unwrap_or(1.0));
        let motion = model.on_smooth_rail(step, growth).map_err(refused("--smooth"))?;
        let roots = stability.as_ref().map(|stability| stability.unstable_roots);
        let own_remarks = remarks::of_track(&model)
            .into_iter()
            .chain((motion.outcome == Outcome::RunsAway).then(remarks::of_sliding))
            .chain(remarks::of_linear_loop(&motion, roots));
        let run = Run::new(case, own_remarks, &ask::remarks_at(case, speed));
        let names = ask::contact_names(case);
        let course = |course: &Vec<ContactInstant>| {
            let places = (0..course.len()).map(|index| index as f64 * motion.step);
            ContactHistory::new(places.collect(), vec![0.0; course.len()], course, true)
        };
        Ok(Self {
            speed_m_per_s: speed,
            step_m: motion.step,
            outcome: motion.outcome,
            rolled_s: motion.seconds,
            frequency_hz: motion.frequency,
            linear_unstable_roots: roots,
            linear_frequency_hz: stability.as_ref().and_then(|stability| stability.frequency),
            linear_growth_rate_per_s: stability.as_ref().and_then(|stability| stability.growth_rate),
            contacts: names
                .iter()
                .copied()
                .zip(&motion.contacts)
                .map(|(name, it)| ContactSwings::new(name, it))
                .collect(),
            track_share_cut: model.structures.share_cut(),
            run: Run { courses: motion.course.iter().map(course).collect(), contacts: names, ..run },
        })
    }

    /// What becomes of the push.
    fn outcome(&self) -> Message {
        let frequency = self.frequency_hz.map(|frequency| fixed(frequency, 1));
        match (self.outcome, frequency) {
            (Outcome::LimitCycle, Some(frequency)) => say!(limit_cycle_of, frequency),
            (_, Some(frequency)) => say!(no_settled_period, frequency),
            (Outcome::RunsAway, None) => say!(wheels_slide_off),
            (_, None) => say!(push_dies_out),
        }
    }

    /// What the linear loop says.
    fn linear(&self) -> Message {
        let frequency = self.linear_frequency_hz.map(|frequency| fixed(frequency, 0));
        match (self.linear_unstable_roots, frequency) {
            (Some(0), _) => say!(linear_loop_stable),
            (Some(_), Some(frequency)) => match self.linear_growth_rate_per_s {
                Some(growth) => {
                    say!(linear_loop_grows, frequency, seconds = fixed(growth.recip(), 3))
                }
                None => say!(linear_loop_unstable_near, frequency),
            },
            (Some(_), None) => say!(linear_loop_unstable),
            (None, _) => say!(linear_loop_not_judged),
        }
    }

    /// What each contact does, for a reader.
    fn swings(&self) -> Table {
        let range = |head, scale: f64, digits: usize, of: fn(&ContactSwings) -> [f64; 2]| {
            self.contacts.shown(head, |contact| {
                let [least, most] = of(contact).map(|end| fixed(scale * end, digits));
                say!(from_one_to_another, least, most)
            })
        };
        Table {
            name: "swings",
            columns: vec![
                self.contacts.numbers(say!(wheel_column), |contact| contact.name.wheel),
                self.contacts.shown(say!(rail_column), |contact| match contact.name.rail {
                    "left" => say!(left),
                    _ => say!(right),
                }),
                range(say!(normal_force_in_kilonewton), 1e-3, 2, |contact| contact.normal_force_n),
                range(say!(creep_force_column), 1e-3, 2, |contact| contact.tangential_force_n),
                range(say!(lateral_in_kilonewton_column), 1e-3, 2, |contact| contact.lateral_force_n),
                range(say!(creepage_in_percent_column), 100.0, 3, |contact| contact.creepage),
                range(say!(lateral_in_percent_column), 100.0, 3, |contact| contact.lateral_creepage),
                self.contacts.numbers(say!(stick_column), |contact| format!("{:.0}", 100.0 * contact.stick_fraction)),
                self.contacts
                    .numbers(say!(dissipation_column), |contact| format!("{:.1}", contact.mean_dissipation_j_per_m)),
            ],
        }
    }
}

impl March for SmoothRailAnswer {
    const NAME: &'static str = "smooth";
    const DOCUMENT: &'static str = "smooth.json";

    fn run(&self) -> &Run {
        &self.run
    }

    fn about(&self) -> Vec<Message> {
        vec![
            self.run.titled(say!(wheels_on_a_smooth_rail)),
            say!(
                smooth_rail_at,
                speed = fixed(3.6 * self.speed_m_per_s, 1),
                seconds = fixed(self.rolled_s, 1),
                outcome = self.outcome(),
                linear = self.linear()
            ),
        ]
    }

    fn shown(&self) -> Option<Table> {
        Some(self.swings())
    }

    /// A few periods of the contact that swings most.
    fn picture(&self) -> (String, String, usize) {
        let spans = self.contacts.iter().map(ContactSwings::span).enumerate();
        let largest = spans.max_by(|one, other| one.1.total_cmp(&other.1));
        let most = largest.map_or(0, |(index, _)| index);
        let ContactName { wheel, rail } = self.contacts[most].name;
        let what = match (self.outcome, self.frequency_hz) {
            (Outcome::RunsAway, _) => "the wheels slide off".to_owned(),
            (Outcome::AtRest, _) | (_, None) => "at rest".to_owned(),
            (Outcome::LimitCycle, Some(frequency)) => {
                format!("limit cycle of {frequency:.0} Hz")
            }
            (Outcome::Irregular, Some(frequency)) => {
                format!("motion that has not settled, like itself at {frequency:.0} Hz")
            }
        };
        let title = format!("A smooth rail at {:.1} km/h: {what}", 3.6 * self.speed_m_per_s);
        (title, format!("Wheel {wheel} on the {rail} rail."), most)
    }
}
