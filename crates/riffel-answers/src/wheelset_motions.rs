//! The modes of a wheelset as motions along its axle, to be drawn as they move.

use riffel_case::{Case, CaseWheelset, ask};
use riffel_keys::{CaseError, Message};
use serde::Serialize;

use crate::mode_in_words;
use crate::wheelset::HIGHEST;

/// Places along the axle.
const ALONG: usize = 61;

/// A wheelset with an elastic axle, and how it moves at each of its natural frequencies.
#[derive(Debug, Clone, Serialize)]
pub struct WheelsetMotions {
    /// Radius of the wheels.
    pub rolling_radius_m: f64,
    /// Distance of the contacts.
    pub contact_spacing_m: f64,
    /// Largest diameter of the axle.
    pub axle_diameter_m: f64,
    /// Places along the axle, from its middle to the right.
    pub position_m: Vec<f64>,
    /// What sits on the axle: wheels, brake discs, gears, axle boxes.
    pub discs: Vec<DiscPlace>,
    /// Up to 2 kHz, the lowest first.
    pub modes: Vec<ModeMotion>,
}

/// Something on the axle.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct DiscPlace {
    /// Place along the axle.
    pub position_m: f64,
    /// Mass.
    pub mass_kg: f64,
    /// Whether it stands on a rail.
    pub is_wheel: bool,
    /// Whether it turns with the axle.
    pub turns: bool,
}

/// How the axle moves in one mode, over the largest displacement of it or of the rim of a wheel that turns with it.
#[derive(Debug, Clone, Serialize)]
pub struct ModeMotion {
    /// Without damping.
    pub frequency_hz: f64,
    /// What moves.
    pub name: Message,
    /// Displacement along the rail, to the right and downward at the places.
    pub displacement: Vec<[f64; 3]>,
    /// Angle about the axle at the places, times the rolling radius.
    pub twist: Vec<f64>,
}

impl WheelsetMotions {
    /// The modes of the wheelset of a case.
    ///
    /// # Errors
    /// [`CaseError`] for a case without a wheelset, and for one whose axle does not deform: a rigid one, or one that is given by
    /// modes or receptances at its contacts.
    pub fn new(case: &Case) -> Result<Self, CaseError> {
        let Some(wheelset) = case.wheelset.clone() else {
            return Err(case.refuse(
                "wheelset",
                "`wheelset` is missing: a lone wheel has no axle; give [wheelset] with its model",
            ));
        };
        let CaseWheelset::Flexible(flexible) = &*wheelset else {
            return Err(case.refuse(
                "wheelset.model",
                "`wheelset.model` has no axle that bends and twists; choose \"flexible\" to see its modes move",
            ));
        };
        let (axle, contacts) = (flexible.axle(), flexible.contacts());
        let half = 0.5 * axle.length();
        let places: Vec<f64> = (0..ALONG).map(|index| half * (2.0 * index as f64 / (ALONG - 1) as f64 - 1.0)).collect();
        let radius = contacts.rolling_radius;
        let modes = ask::wheelset_modes(case, &wheelset, HIGHEST)?;
        let modes = modes.iter().filter_map(|mode| {
            let shape = mode.shape.as_ref()?;
            let motions: Vec<_> = places.iter().map(|&place| shape.motion_at(place)).collect();
            let largest = motions.iter().fold(0.0, |most: f64, motion| {
                let moves = motion.displacement.iter().map(|part| part.abs());
                moves.fold(most, f64::max).max(radius * motion.rotation[1].abs())
            });
            Some(ModeMotion {
                frequency_hz: mode.frequency,
                name: mode_in_words(&mode.name),
                displacement: motions.iter().map(|motion| motion.displacement.map(|part| part / largest)).collect(),
                twist: motions.iter().map(|motion| radius * motion.rotation[1] / largest).collect(),
            })
        });
        // The disc nearest to a contact is its wheel.
        let nearest = |place: f64| {
            let distances = flexible.discs().iter().map(|disc| (disc.position - place).abs());
            distances.enumerate().min_by(|a, b| a.1.total_cmp(&b.1)).map(|(index, _)| index)
        };
        let wheels = [-0.5, 0.5].map(|side| nearest(side * contacts.contact_spacing));
        Ok(Self {
            rolling_radius_m: radius,
            contact_spacing_m: contacts.contact_spacing,
            axle_diameter_m: axle.largest_diameter(),
            modes: modes.collect(),
            position_m: places,
            discs: (flexible.discs().iter().enumerate())
                .map(|(index, disc)| DiscPlace {
                    position_m: disc.position,
                    mass_kg: disc.mass,
                    is_wheel: wheels.contains(&Some(index)),
                    turns: disc.polar_inertia > 0.0,
                })
                .collect(),
        })
    }
}
