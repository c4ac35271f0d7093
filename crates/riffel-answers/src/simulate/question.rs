//! What is asked of a wheel in time.

use std::path::PathBuf;

use riffel::forecast::SpeedDistribution;
use riffel::passage::Sinusoid;
use riffel::roughness::Weld;
use riffel_case::Case;
use riffel_case::traffic::Traffic;
use riffel_keys::quantity::{Length, Quantity, QuantityError, Speed};
use riffel_keys::say;
use schemars::JsonSchema;
use serde::Deserialize;

use super::{
    EvolutionRequest, EvolutionRun, PassageAnswer, PassageRequest, SinusoidAnswer, SinusoidRequest, SmoothRailAnswer,
    Surface, rail, refused,
};
use crate::question::{AsWritten, CaseSource, Client, Question, RecordLayout, Rule, Source, positive};
use crate::{Answer, AnswerError, Result};

/// Length of a rail that is made, where none is asked for \[m\].
const USUAL_LENGTH: f64 = 20.0;
/// Longest rail that is made \[m\]: two million heights.
const MOST_LENGTH: f64 = 1000.0;
/// Largest number of passages: a century of a train a second has a third.
const MOST_PASSAGES: f64 = 1e10;

/// A wheel along a rail in time: large amplitudes, loss of contact.
#[derive(Debug, Deserialize, JsonSchema)]
pub struct SimulateQuestion {
    #[serde(flatten)]
    case: CaseSource,
    /// Speed, in m/s or with its unit.
    speed: Option<AsWritten<Speed>>,
    /// Traffic file, in place of a speed: passages of every vehicle at the speeds of its distribution, each as often as its
    /// share says.
    #[schemars(extend("value_name" = "FILE"))]
    traffic: Option<Source<Traffic>>,
    /// Roll over a sinusoid of this amplitude and wavelength until every wave is like the one before.
    #[schemars(with = "Option<String>", extend("value_name" = "AMPLITUDE,WAVELENGTH", "type" = ["string", "number"]))]
    sinusoid: Option<LengthPair>,
    /// Roll along the profile of a file, such as a trolley's.
    #[schemars(with = "Option<Source<()>>", extend("value_name" = "FILE"))]
    profile: Option<PathBuf>,
    /// Roll along a rail drawn with the spectrum of a limit table, such as iso-3095-2013, or of a file of levels or
    /// profiles.
    spectrum: Option<String>,
    /// Seed of the drawn rail [default: 1].
    #[schemars(extend("value_name" = "N"))]
    seed: Option<u64>,
    /// Roll over a dipped weld, -DEPTH/2 (1 - cos 2πx/LENGTH), in the middle of a smooth rail.
    #[schemars(with = "Option<String>", extend("value_name" = "DEPTH,LENGTH", "type" = ["string", "number"]))]
    weld: Option<LengthPair>,
    /// Roll on a smooth rail after a small push, with a wheelset or with creepage on two axes: rest, or the limit cycle of a loop
    /// that is unstable without any profile, as squeal and as stick and slip.
    smooth: bool,
    /// Take this much of the profile [default: all], or make the rail so long [default: 20 m].
    length: Option<Quantity<Length>>,
    /// Wear the rail by so many wheels, one after another: levels and profile over passages, beside the linear loop. A run that
    /// was stopped goes on from where it was, and so does one that is asked for more.
    #[schemars(extend("value_name" = "N"))]
    passages: Option<f64>,
    /// Let the wheel feel the mean of the profile over the patch in the place of its height: sin(ka)/(ka) of a wave.
    contact_filter: bool,
    /// Over a sinusoid: follow the contact of the half-space element by element, contact.grid of them across, in the place of the creep law
    /// of the case. The reference for contact.response; seconds.
    transient: bool,
    #[serde(flatten)]
    layout: RecordLayout,
    /// Largest distance between two steps [default: 1/256 of a sinusoid's wavelength, 0.5 mm along a profile].
    #[schemars(extend("value_name" = "LENGTH"))]
    step: Option<Quantity<Length>>,
}

/// Two lengths as they were written.
#[derive(Debug, Deserialize)]
#[serde(try_from = "String")]
struct LengthPair([AsWritten<Length>; 2]);

impl TryFrom<String> for LengthPair {
    type Error = String;

    fn try_from(text: String) -> Result<Self, String> {
        let parts = text.split_once(',').ok_or("give two lengths with a comma between them, as in 20um,55mm")?;
        let read = |part: &str| part.trim().parse().map_err(|error: QuantityError| error.to_string());
        Ok(Self([read(parts.0)?, read(parts.1)?]))
    }
}

impl LengthPair {
    /// Amplitude and wavelength within their physical ranges; `client` is told what is not usual.
    fn sinusoid(&self, client: &dyn Client) -> Result<Sinusoid> {
        let read = |key, what, length: &AsWritten<Length>| {
            length.within(key, client).map_err(|error| match error {
                AnswerError::Range { message, .. } => {
                    AnswerError::Range { argument: "--sinusoid", message: format!(": {what}{message}") }
                }
                error => error,
            })
        };
        let [amplitude, wavelength] = &self.0;
        Ok(Sinusoid {
            amplitude: read("corrugation.amplitude", "amplitude", amplitude)?,
            wavelength: read("--wavelength", "wavelength", wavelength)?,
        })
    }

    fn weld(&self) -> Result<Weld> {
        let read = |length: &AsWritten<Length>| positive("--weld", Quantity::<Length>::new(length.si()));
        let [depth, length] = &self.0;
        Ok(Weld { depth: read(depth)?, length: read(length)? })
    }
}

impl SimulateQuestion {
    /// A rail before many wheels, and how many are to pass; `None` where one passage is asked for.
    ///
    /// # Errors
    /// [`AnswerError::Argument`] with the key at fault, [`AnswerError::Case`] with the key of the case or the file.
    pub fn evolution(&self, client: &dyn Client) -> Result<Option<(EvolutionRun, u64)>> {
        let Some(passages) = self.passages else {
            return Ok(None);
        };
        let (case, step) = (self.case.read(client)?, self.step()?);
        if passages.fract() != 0.0 || !(1.0..=MOST_PASSAGES).contains(&passages) {
            return Err(AnswerError::argument(
                "--passages",
                passages,
                format!("a whole number from 1 to {MOST_PASSAGES:e}"),
            ));
        }
        let traffic = match &self.traffic {
            Some(traffic) => Traffic::clone(&*traffic.value(Traffic::read)?),
            None => {
                let speed = SpeedDistribution::single(self.speed(client)?);
                Traffic::of_case(speed.map_err(refused("--speed"))?)
            }
        };
        client.remark(traffic.remarks());
        let (surface, largest_step) = match &self.sinusoid {
            Some(sinusoid) => {
                let sinusoid = sinusoid.sinusoid(client)?;
                let slowest = traffic.speeds().iter().map(|speeds| speeds.range().0);
                let slowest = slowest.fold(f64::INFINITY, f64::min);
                let step = SinusoidRequest::new(slowest, sinusoid, step)?.step();
                (Surface::of_sinusoid(sinusoid, case.track.support_spacing())?, step)
            }
            None => {
                let step = step.unwrap_or(PassageRequest::USUAL_STEP);
                (self.surface(&case, step, client)?, step)
            }
        };
        let request = EvolutionRequest { traffic, surface, largest_step, contact_filter: self.contact_filter };
        Ok(Some((EvolutionRun::new(&case, request)?, passages as u64)))
    }

    /// Speed of the wheel \[m/s\].
    fn speed(&self, client: &dyn Client) -> Result<f64> {
        // The rules ask for it where there is no traffic, which is for passages.
        self.speed.as_ref().map_or(Ok(f64::NAN), |speed| speed.within("--speed", client))
    }

    /// Longest step that is asked for \[m\].
    fn step(&self) -> Result<Option<f64>> {
        let step = self.step.map(|step| positive("--step", step)).transpose()?;
        match step.filter(|step| self.sinusoid.is_none() && !(0.05e-3..=0.1).contains(step)) {
            Some(step) => Err(AnswerError::argument(
                "--step",
                format!("{step:e} m"),
                "between 0.05 and 100 mm: the contact is some millimetres long",
            )),
            None => Ok(step),
        }
    }

    /// The rail, whose heights lie no farther apart than a step \[m\] where they are made.
    fn surface(&self, case: &Case, step: f64, client: &dyn Client) -> Result<Surface> {
        let length = self.length.map(|length| positive("--length", length)).transpose()?;
        if let Some(path) = &self.profile {
            return Ok(Surface::Record(rail::record(path, &self.layout, length, client)?));
        }
        if let Some(length) = length.filter(|length| *length > MOST_LENGTH) {
            return Err(AnswerError::argument(
                "--length",
                format!("{length} m"),
                format!("at most {MOST_LENGTH} m for a rail that is made"),
            ));
        }
        let length = length.unwrap_or(USUAL_LENGTH);
        let length = match case.track.support_spacing() {
            Some(bay) if self.passages.is_some() => rail::whole_bays(length, bay, client),
            _ => length,
        };
        if let Some(weld) = &self.weld {
            return Ok(Surface::Ring(rail::dipped(weld.weld()?, [length, step])?));
        }
        // The rules ask for one of them.
        let name = self.spectrum.as_deref().unwrap_or_default();
        Ok(Surface::Ring(rail::drawn((name, self.seed.unwrap_or(1)), case, [length, step], client)?))
    }
}

impl Question for SimulateQuestion {
    const NAME: &'static str = "simulate";
    const EXAMPLE: &'static str = "\
        Example: riffel simulate case.toml --speed \"108 km/h\" --sinusoid 20um,55mm\n\n\
        A rail that wears: riffel simulate case.toml --speed 30 --profile trolley.csv --length \"20 m\" --passages 1e6\n\n\
        Squeal: riffel simulate curve.toml --speed \"36 km/h\" --smooth\n\n\
        Under traffic: riffel simulate case.toml --traffic traffic.toml --spectrum iso-3095-2013 --passages 1e6";
    const RULES: &'static [Rule] = &[
        Rule::JustOneOf(&["sinusoid", "profile", "spectrum", "weld", "smooth"]),
        Rule::AnyOf(&["speed", "traffic"]),
        Rule::OneOf(&["speed", "traffic"]),
        Rule::Needs(&["traffic"], &["passages"]),
        Rule::Needs(&["seed"], &["spectrum"]),
        Rule::Needs(&["length"], &["profile", "spectrum", "weld"]),
        Rule::Excludes("smooth", &["passages", "traffic", "contact_filter"]),
        Rule::Needs(&["transient"], &["sinusoid"]),
        Rule::Excludes("transient", &["passages", "traffic"]),
        Rule::Needs(RecordLayout::KEYS, &["profile"]),
    ];

    fn ask(&self, client: &dyn Client) -> Result<Box<dyn Answer>> {
        if let Some((mut run, passages)) = self.evolution(client)? {
            let step = client.begin(say!(progress_passages), passages as usize);
            loop {
                let before = run.passages();
                if let Some(answer) = run.go_on(passages)? {
                    return Ok(Box::new(answer));
                }
                step((run.passages() - before) as usize);
            }
        }
        let (case, step, speed) = (self.case.read(client)?, self.step()?, self.speed(client)?);
        let contact_filter = self.contact_filter;
        if self.smooth {
            return Ok(Box::new(SmoothRailAnswer::new(&case, speed, step)?));
        }
        if let Some(sinusoid) = &self.sinusoid {
            let request = SinusoidRequest::new(speed, sinusoid.sinusoid(client)?, step)?;
            let request = SinusoidRequest { contact_filter, transient: self.transient, ..request };
            return Ok(Box::new(SinusoidAnswer::new(&case, request)?));
        }
        let largest_step = step.unwrap_or(PassageRequest::USUAL_STEP);
        let profile = self.surface(&case, largest_step, client)?.into_profile();
        let request = PassageRequest { speed, profile, largest_step, contact_filter };
        Ok(Box::new(PassageAnswer::new(&case, request)?))
    }
}
