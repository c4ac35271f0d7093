//! A case, checked and complete.

pub(crate) mod edit;
pub(crate) mod hold;
pub(crate) mod idle_key;
pub(crate) mod kept_state;
pub(crate) mod measured_wear;
pub(crate) mod on_curve;
pub(crate) mod own_values;
pub(crate) mod portable_case;
pub(crate) mod variant;
pub(crate) mod wheels_of_curve;

use std::path::Path;
use std::sync::Arc;

use riffel::contact::{CreepLaw, MeanRolling};
use riffel::damage::DamageLaw;
use riffel::receptance::{ResonanceKind, SpatialTrack};
use riffel::{Axis, Direction, HertzContact, Loop};
use riffel_keys::quantity::Quantity;
use riffel_keys::{CaseError, Message, PhysicalRange, fixed, say, text_file};

use crate::build::{BuiltCase, CreepLaws};
use crate::case::measured_wear::with_measured_wear;
use crate::curve::{CurvingCase, Equilibrium, SharedProfiles};
use crate::file::setting::Setting;
use crate::file::{BeamModel, CaseFile, ContactDynamics, CreepLawName, FromCurve};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::substitutes::{CaseStructure, SubstituteReceptance, Substitutes};
use crate::keys::written_keys::WrittenKeys;
use crate::parts::shared::Shared;
use crate::parts::track::{Track, known_range};
use crate::parts::wheelset::CaseWheelset;
use crate::parts::window::Window;
use crate::text::case_text::CaseText;

/// A case ready to compute.
#[derive(Clone)]
pub struct Case {
    pub(crate) keys: CheckedKeys,
    /// The keys as they were written and overridden, before presets.
    pub(crate) unfilled: CaseText,
    /// Every key with its value, presets and defaults filled in.
    pub file: CaseFile,
    /// The loop of the case.
    pub feedback: Loop,
    /// The track, vertically.
    pub track: Track,
    /// The contact patch.
    pub hertz: HertzContact,
    /// The mean state of rolling.
    pub steady: MeanRolling,
    /// The creep law; `None` if that is Kalker's exact theory.
    pub law: Option<Arc<dyn CreepLaw>>,
    /// The wheelset; none for a lone wheel.
    pub wheelset: Option<Arc<CaseWheelset>>,
    /// The track on all axes of a general loop, where a model tells it.
    pub(crate) spatial_track: Option<SpatialTrack>,
    /// Named angular frequencies \[rad/s\] of the rail across the track, undamped, lowest first: cut-on of lateral motion
    /// and of roll, pinned-pinned. Empty where the rail does not move so in the loop.
    pub lateral_resonances: Vec<(ResonanceKind, f64)>,
    /// Wavelengths of the map \[m\].
    pub wavelength: Axis,
    /// Speeds of the map \[m/s\].
    pub speed: Axis,
    /// What the reader should know about the validity of the model in the window of the map.
    pub remarks: Vec<Message>,
}

impl Case {
    /// Read a case file, or standard input for the path `-`, and apply overrides `key=value` in their order.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn read(path: &Path, overrides: &[String]) -> Result<Self, CaseError> {
        Self::read_text(path, |text| text.apply(overrides))
    }

    /// [`read`](Self::read) a case file, and give keys values.
    ///
    /// # Errors
    /// Errors of [`read`](Self::read), and as [`edit`](Self::edit) for the settings.
    pub fn read_with(path: &Path, settings: &[Setting]) -> Result<Self, CaseError> {
        Self::read_text(path, |text| text.write(settings))
    }

    fn read_text(path: &Path, change: impl FnOnce(&mut CaseText) -> Result<(), CaseError>) -> Result<Self, CaseError> {
        let text = text_file::read_keys(path, "case file")?;
        let folder = path.parent().unwrap_or_else(|| Path::new(""));
        let mut text = CaseText::parse(&path.display().to_string(), &text)?;
        change(&mut text)?;
        Self::of_text(text, Some(folder), Substitutes::default(), Window::Map)
    }

    /// Read a case from TOML; `name` is the one shown in errors. Files that the case names are relative
    /// to the present folder.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn parse(name: &str, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        Self::build(name, Some(Path::new("")), text, overrides)
    }

    /// Read a case from TOML that somebody else has sent: it may name presets, but no files, and none is
    /// opened.
    ///
    /// # Errors
    /// [`CaseError`] with the key, the value and the rule.
    pub fn parse_sealed(name: &str, text: &str) -> Result<Self, CaseError> {
        Self::build(name, None, text, &[])
    }

    fn build(name: &str, folder: Option<&Path>, text: &str, overrides: &[String]) -> Result<Self, CaseError> {
        let mut unfilled = CaseText::parse(name, text)?;
        unfilled.apply(overrides)?;
        Self::of_text(unfilled, folder, Substitutes::default(), Window::Map)
    }

    /// `folder` is the one to which files are relative; without it the case may not name any.
    pub(crate) fn of_text(
        unfilled: CaseText,
        folder: Option<&Path>,
        given: Substitutes,
        window: Window,
    ) -> Result<Self, CaseError> {
        let keys = CheckedKeys::of_text(unfilled.clone(), folder, given.within(window), window)?;
        with_measured_wear(Self::of_keys(keys, unfilled)?)
    }

    /// The case of written keys with the mean state of one contact of a balanced vehicle.
    pub(crate) fn placed(
        written: &WrittenKeys,
        equilibrium: &Arc<Equilibrium>,
        from: &FromCurve,
        given: Substitutes,
        window: Window,
    ) -> Result<Self, CaseError> {
        let mut unfilled = written.unfilled.clone();
        unfilled.write(&from.settings())?;
        let keys = written.on_wheel(equilibrium, from, given.within(window), window)?;
        with_measured_wear(Self::of_keys(keys, unfilled)?)
    }

    fn of_keys(keys: CheckedKeys, unfilled: CaseText) -> Result<Self, CaseError> {
        let BuiltCase { track, closed, wavelength, speed, mut remarks } = keys.build()?;
        let other_forces = Self::of_other_forces(&keys, &closed.steady);
        let of_curve = keys.mean.wheel().into_iter().flat_map(|wheel| wheel.remarks.iter().cloned());
        remarks.splice(0..0, of_curve.chain(other_forces));
        Ok(Self {
            file: keys.file.clone(),
            keys,
            unfilled,
            feedback: closed.feedback,
            track,
            hertz: closed.hertz,
            steady: closed.steady,
            law: closed.law,
            wheelset: closed.wheelset,
            spatial_track: closed.spatial_track,
            lateral_resonances: closed.lateral_resonances,
            wavelength,
            speed,
            remarks,
        })
    }

    /// That the law of the loop makes other forces of the creepages of a curve than the equilibrium has, if so.
    fn of_other_forces(keys: &CheckedKeys, steady: &MeanRolling) -> Option<Message> {
        /// Of |Q|/μP.
        const WORTH_A_REMARK: f64 = 0.05;
        let in_curve = keys.mean.wheel()?.tractive_ratio?;
        let here = steady.tractive_ratio();
        ((here - in_curve).abs() > WORTH_A_REMARK).then(|| {
            let law = keys.creep_law_name().name();
            say!(creep_law_unlike_equilibrium, law, here = fixed(here, 2), in_curve = fixed(in_curve, 2))
        })
    }

    /// The case of another text, with all that was given beside it.
    pub(crate) fn rebuilt(&self, text: CaseText, window: Window) -> Result<Self, CaseError> {
        let (folder, given) = (self.keys.folder.as_deref(), self.keys.given.clone());
        Self::of_text(text, folder, given, window)
    }

    pub(crate) fn text_with(&self, sets: &[&[Setting]]) -> Result<CaseText, CaseError> {
        let mut text = self.unfilled.clone();
        sets.iter().try_for_each(|settings| text.write(settings))?;
        Ok(text)
    }

    /// The case with a receptance in the place of one of its structures. It goes where the case goes: into overrides, traffic and
    /// variants. The model of the file is still checked, but is not asked; the rotation of a wheel stays that of the file.
    ///
    /// # Errors
    /// [`CaseError`] as of [`with`](Self::with).
    pub fn substitute(&self, structure: CaseStructure, receptance: SubstituteReceptance) -> Result<Self, CaseError> {
        let mut keys = self.keys.clone();
        match structure {
            CaseStructure::Track => keys.given.track = Some(receptance),
            CaseStructure::Wheel => keys.given.wheel = Some(receptance),
        }
        Self::of_keys(keys, self.unfilled.clone())
    }

    /// The case, keeping the tables of its exact contact and its wheelset for all cases that are built from it.
    #[must_use]
    pub fn sharing_parts(&self) -> Self {
        let mut case = self.clone();
        case.keys.given.tables = Shared::kept();
        case.keys.given.wheelsets = Shared::kept();
        case.keys.given.tracks = Shared::kept();
        case.sharing_profiles()
    }

    /// The case, keeping what its profiles are on their track for all cases that are built from it.
    #[must_use]
    pub fn sharing_profiles(mut self) -> Self {
        self.keys.given.profiles = SharedProfiles::kept();
        self
    }

    /// The loop of the case at every place of the wheel that counts for a long profile, with weights that
    /// sum to one: over a bay where supports are discrete, else one.
    pub fn places(&self) -> Vec<(Loop, f64)> {
        self.track.places(&self.feedback)
    }

    /// The creep law: as written, or the one that goes with the response.
    pub fn creep_law(&self) -> CreepLawName {
        self.keys.creep_law_name()
    }

    /// The creep laws that are formulas of the ellipse of the case, whichever is its own.
    ///
    /// # Errors
    /// [`CaseError`] for a Poisson's ratio or an ellipse beyond the table of Kalker's coefficients.
    pub fn creep_laws(&self) -> Result<CreepLaws, CaseError> {
        self.keys.creep_laws(self.hertz, self.steady.friction)
    }

    /// The case with a contact that answers at wavelengths \[m\] outside the window of its map, too: a
    /// non-steady one is tabulated over the window.
    ///
    /// # Errors
    /// [`CaseError`] where the grid of the contact does not resolve the shortest.
    pub fn covering(&self, from: f64, to: f64) -> Result<Self, CaseError> {
        let tabulated = self.file.contact.response == ContactDynamics::NonSteady;
        let (shortest, longest) = (self.wavelength.min(), self.wavelength.max());
        if !tabulated || shortest <= from && to <= longest {
            return Ok(self.clone());
        }
        let mut keys = self.keys.clone();
        let window = &mut keys.file.map.wavelength;
        window.min = Quantity::new(shortest.min(from));
        window.max = Quantity::new(longest.max(to));
        let built = keys.build()?;
        if built.wavelength.min() > from {
            return Err(self.keys.text.keys.invalid(
                "map.wavelength.min",
                say!(response_known_from, wavelength = fixed(1e3 * built.wavelength.min(), 1)),
                say!(take_longer_waves_or_another_grid),
            ));
        }
        Ok(Self { feedback: built.closed.feedback, ..self.clone() })
    }

    /// `Ok` if wavelengths \[m\] and speeds \[m/s\] from the smallest to the largest are within their physical
    /// ranges, and the track is known there.
    ///
    /// # Errors
    /// [`CaseError`] with the value and the rule.
    pub fn check_points(&self, wavelengths: [f64; 2], speeds: [f64; 2]) -> Result<(), CaseError> {
        PhysicalRange::check("--wavelength", "wavelength", wavelengths)?;
        PhysicalRange::check("--speed", "speed", speeds)?;
        self.check_frequencies(speeds[0] / wavelengths[1], speeds[1] / wavelengths[0])
    }

    /// How the rail bends: as written, or with shear where supports are discrete.
    pub fn beam_model(&self) -> BeamModel {
        self.keys.beam_model()
    }

    /// The track in any direction.
    ///
    /// # Errors
    /// [`CaseError`] where the case lacks a value for it, or its model has no such direction.
    pub fn track_in(&self, direction: Direction) -> Result<Track, CaseError> {
        self.keys.track(direction)
    }

    /// `Ok` if track and wheels are known over the frequencies \[Hz\]: a measured receptance is not
    /// extrapolated.
    ///
    /// # Errors
    /// [`CaseError`] with the frequencies at which they are known.
    pub fn check_frequencies(&self, lowest: f64, highest: f64) -> Result<(), CaseError> {
        self.check_known(self.known_receptances(), lowest, highest)
    }

    /// `Ok` if the wheelset is known over the frequencies \[Hz\].
    ///
    /// # Errors
    /// [`CaseError`] with the frequencies at which it is known.
    pub fn check_wheelset_frequencies(&self, lowest: f64, highest: f64) -> Result<(), CaseError> {
        self.check_known(self.known_wheelset(), lowest, highest)
    }

    fn check_known(
        &self,
        known: impl IntoIterator<Item = (&'static str, (f64, f64))>,
        lowest: f64,
        highest: f64,
    ) -> Result<(), CaseError> {
        /// Frequencies come from V/λ and pass through ω: some roundings.
        const ROUNDING: f64 = 1e-9;
        let outside = |&(_, (low, high)): &(&'static str, (f64, f64))| {
            lowest < low * (1.0 - ROUNDING) || highest > high * (1.0 + ROUNDING)
        };
        let Some((key, (low, high))) = known.into_iter().find(outside) else {
            return Ok(());
        };
        let asked = if lowest == highest { format!("{lowest:.4}") } else { format!("{lowest:.4}–{highest:.4}") };
        Err(self.keys.text.keys.invalid(
            key,
            say!(
                is_known_between,
                low = fixed(low, 4),
                high = fixed(high, 4),
                asked = riffel_keys::message::number(asked),
            ),
            say!(narrow_the_window_or_measure_further),
        ))
    }

    /// Lowest and highest frequency \[Hz\] at which track and wheels are known.
    pub fn known_frequencies(&self) -> (f64, f64) {
        let ranges = self.known_receptances().into_iter();
        ranges.fold((0.0, f64::INFINITY), |known, (_, (low, high))| (f64::max(known.0, low), f64::min(known.1, high)))
    }

    /// Receptances that may end: what a sentence calls them, and the frequencies \[Hz\] they are known at.
    fn known_receptances(&self) -> Vec<(&'static str, (f64, f64))> {
        let track = match self.keys.given.track {
            Some(_) => "receptance of the track",
            None => "track.measurement.file",
        };
        let mut known = vec![(track, known_range(&*self.track.receptance))];
        let wheel = self.keys.given.wheel.as_ref();
        known.extend(wheel.map(|wheel| {
            let range = known_range(&*wheel.receptance);
            ("receptance of the wheel", range)
        }));
        known.extend(self.known_wheelset());
        known
    }

    /// Range of the wheelset.
    fn known_wheelset(&self) -> Option<(&'static str, (f64, f64))> {
        let wheelset = self.wheelset.as_ref()?;
        Some(("wheelset.file", wheelset.frequency_range()))
    }

    /// [`check_frequencies`](Self::check_frequencies) for the whole window of the map.
    ///
    /// # Errors
    /// [`CaseError`] with the frequencies at which the track is known.
    pub fn check_window(&self) -> Result<(), CaseError> {
        self.check_frequencies(self.speed.min() / self.wavelength.max(), self.speed.max() / self.wavelength.min())
    }

    /// The tables of curving of the case, with overrides after those it was read with.
    ///
    /// # Errors
    /// Errors of [`CurvingCase::read`].
    pub fn curving(&self, overrides: &[String]) -> Result<CurvingCase, CaseError> {
        let mut text = self.unfilled.clone();
        text.apply(overrides)?;
        CurvingCase::of_tables(text, self.keys.folder.as_deref())
    }

    /// Whether laws of damage beside wear have a part in growth.
    pub fn has_other_damage(&self) -> bool {
        let damage = self.feedback.contacts()[0].damage.as_ref();
        damage.is_some_and(|damage| damage.laws != [DamageLaw::Wear])
    }

    /// A sentence about a key of the case.
    pub fn refuse(&self, key: &str, message: impl Into<Message>) -> CaseError {
        self.keys.text.keys.refuse(key, message)
    }
}
