//! The loop on all axes of a case.

use std::sync::Arc;

use riffel::contact::{Conformity, CreepLaw, MeanState, MovingContact, OscillatingCreepages};
use riffel::feedback::{Contact, NormalDirection};
use riffel::receptance::{
    ContactPoint, RememberingTrack, SpatialRail, SpatialTrack, Structure, Supports, Twist, TwistSection, Uncoupled,
};
use riffel::wheelset::{Motion, RememberingWheelset};
use riffel::{Direction, ElasticMaterial, HertzContact, Loop, Rail, Receptance, STEEL_DENSITY};
use riffel_keys::{CaseError, Message, Value, fixed, say};

use super::ClosedLoop;
use crate::file::{Comb, Rotation, TrackModel};
use crate::keys::checked_keys::CheckedKeys;
use crate::keys::general_keys::{ConformityKeys, ContactKeys, GeneralKeys, TwistKeys};
use crate::parts::track::Track;
use crate::parts::wheelset::BuiltWheelset;

/// One side of the wheelsets: its contact but for where it stands.
struct Side {
    contact: Contact,
    hertz: HertzContact,
    law: Option<Arc<dyn CreepLaw>>,
}

/// That the ellipse takes the rolling radius where the wheel is much flatter.
fn of_flatness(keys: &ContactKeys) -> Option<Message> {
    /// Share by which the radius along the rail may differ from the rolling radius without a word.
    const WORTH_A_REMARK: f64 = 0.05;
    let flatter = keys.contact_angle.cos().recip();
    if keys.longitudinal_radius.is_some() || flatter < 1.0 + WORTH_A_REMARK {
        return None;
    }
    let angle = keys.contact_angle.to_degrees();
    Some(say!(wheel_flatter_than_radius, angle = fixed(angle, 0), flatter = fixed(flatter, 2)))
}

impl CheckedKeys {
    pub(super) fn general_loop(
        &self,
        keys: &GeneralKeys,
        steel: ElasticMaterial,
        vertical: &Track,
    ) -> Result<ClosedLoop, CaseError> {
        let mut remarks = Vec::new();
        let study = self.side((keys.rail, true), &keys.contact, keys.mean, 1.0, steel, vertical)?;
        let steady = study.contact.rolling.steady();
        let damage = study.contact.damage.iter();
        remarks.extend(damage.flat_map(|damage| self.damage_remarks(damage, &steady)));
        let (hertz, law) = (study.hertz, study.law);
        remarks.extend(of_flatness(&keys.contact));
        let mut sides = vec![study.contact];
        let mut points = vec![(keys.rail, keys.contact.lateral_offset)];
        if let Some(opposite) = &keys.opposite {
            let rail = keys.rail.opposite();
            let creepages = opposite.creepages.unwrap_or(steady.creepages);
            let mean = MeanState::Creepages(creepages);
            let side = (rail, false);
            let profile = opposite.profile;
            let side = self.side(side, &opposite.contact, mean, profile, steel, vertical)?;
            sides.push(side.contact);
            points.push((rail, opposite.contact.lateral_offset));
        }
        let mut contacts = Vec::with_capacity(sides.len() * keys.wheels.len());
        for side in &sides {
            contacts.extend(keys.wheels.iter().map(|behind| Contact {
                // Not minus zero.
                along: 0.0 - behind,
                ..side.clone()
            }));
        }
        let spatial = self.spatial_track(keys, steel, &points, &mut remarks)?;
        let lateral_resonances = spatial.as_ref().map(SpatialTrack::lateral_resonances);
        let track: Arc<dyn Structure> = match spatial {
            Some(spatial) => self.remembering(spatial)?,
            None => {
                Arc::new(Uncoupled { longitudinal: None, lateral: None, vertical: Some(vertical.receptance.clone()) })
            }
        };
        let wheelset = keys.wheelset.as_ref();
        let wheelset = wheelset.map(|wheelset| {
            let radius = hertz.rolling_radius();
            self.wheelset(wheelset, radius, keys.rail, &mut remarks)
        });
        let wheelset = wheelset.transpose()?;
        let wheels: Arc<dyn Structure> = match &wheelset {
            Some((_, Some(kept))) => kept.clone(),
            Some((wheelset, None)) => wheelset.clone(),
            None => self.lone_wheels(hertz, &mut remarks)?,
        };
        let amplitude = self.file.corrugation.amplitude.si();
        let feedback = Loop::new(track, wheels, contacts, amplitude);
        let position = self.file.track.position;
        let feedback = self
            .physics("contact", feedback)?
            .at_position(position.map_or(0.0, |position| position.si()))
            .with_comb(match keys.comb {
                Comb::Resolved => riffel::feedback::Comb::Resolved,
                Comb::Mean => riffel::feedback::Comb::Mean,
            });
        let feedback = match &wheelset {
            None => self.with_direction_of_lone_wheels(feedback)?,
            Some(wheelset) => self.with_direction_of_wheelsets(feedback, wheelset)?,
        };
        Ok(ClosedLoop {
            feedback,
            hertz,
            steady,
            law,
            wheelset: wheelset.map(|(wheelset, _)| wheelset),
            spatial_track: spatial,
            lateral_resonances: lateral_resonances.unwrap_or_default(),
            remarks,
        })
    }

    /// The track, with a memory of its motions where the case shares its parts.
    fn remembering(&self, track: SpatialTrack) -> Result<Arc<dyn Structure>, CaseError> {
        let tracks = &self.given.tracks;
        if !tracks.is_kept() {
            return Ok(Arc::new(track));
        }
        let but_for_contacts =
            Rail::BOTH.into_iter().fold(track, |track, rail| track.with_contact(rail, ContactPoint::default()));
        let memory = tracks.get(|| format!("{but_for_contacts:?}"), || Ok(Arc::default()))?;
        Ok(Arc::new(RememberingTrack::new(track, memory)))
    }

    /// The loop of wheelsets, whose normal forces turn with the wave where the case says so.
    fn with_direction_of_wheelsets(&self, feedback: Loop, (wheelset, kept): &BuiltWheelset) -> Result<Loop, CaseError> {
        let Some(keys) = &self.file.wheelset else {
            return Ok(feedback);
        };
        if !keys.normal_direction {
            return Ok(feedback);
        }
        let hubs = kept.as_ref().map_or_else(|| wheelset.with_hubs(), RememberingWheelset::with_hubs);
        let Some(hubs) = hubs else {
            return Err(self.text.keys.invalid(
                "wheelset.normal_direction",
                say!(is_true_but_wheelset_model_tells, model = keys.model.name()),
                say!(choose_wheelset_model_rigid_or_flexible),
            ));
        };
        Ok(feedback.with_normal_direction(NormalDirection::OfWheelsets(hubs)))
    }

    /// The contact of the first wheel with one rail, which is under study or not.
    fn side(
        &self,
        (rail, studied): (Rail, bool),
        keys: &ContactKeys,
        mean: MeanState,
        profile: f64,
        steel: ElasticMaterial,
        track: &Track,
    ) -> Result<Side, CaseError> {
        if let MeanState::Creepages(creepages) = mean
            && creepages.magnitude() == 0.0
        {
            return Err(self.text.keys.invalid(
                "contact.creepage",
                "is spin alone, but the wear of its moment is not computed",
                say!(give_longitudinal_or_lateral_creepage_with),
            ));
        }
        let hertz = self.hertz_of(steel, keys)?;
        let oscillating = match keys.conformity {
            Some(conformity) if conformity.effects.spin => OscillatingCreepages::All,
            _ => OscillatingCreepages::InPlane,
        };
        let built = self.contact_of(hertz, keys.friction, mean, oscillating)?;
        let steady = built.rolling.steady();
        let moving = keys.conformity.map(|conformity| {
            Ok(MovingContact {
                profiles: self.conformity(conformity, keys.transverse_radius)?,
                rolling_radius: hertz.rolling_radius(),
                cross_slope: conformity.cross_slope,
                effects: conformity.effects,
            })
        });
        Ok(Side {
            contact: Contact {
                along: 0.0,
                rail,
                angle: keys.contact_angle,
                profile,
                stiffness: hertz.stiffness(),
                wave: self.wave(hertz)?,
                place_of_wear: self.place_of_wear(hertz, steady.tractive_ratio()),
                rolling: built.rolling,
                motion: self.motion(),
                moving: moving.transpose()?,
                wear: self.wear(hertz, &steady, studied)?,
                damage: self.damage(hertz, &steady, track)?,
            },
            hertz,
            law: built.law,
        })
    }

    /// The profiles across the track, of which the relative radius \[m\] is known.
    fn conformity(&self, keys: ConformityKeys, relative_radius: f64) -> Result<Conformity, CaseError> {
        const KEY: &str = "contact.conformity.rail_radius";
        // That of the profiles is what it is: the wheel is convex.
        if keys.rail_radius > relative_radius && self.text.is_written(KEY) {
            return Err(self.text.keys.invalid(
                KEY,
                format!(
                    "is {} m, but must be at most the transverse radius of the contact, {relative_radius} m",
                    keys.rail_radius
                ),
                say!(transverse_radius_is_the_relative_one),
            ));
        }
        let rail = keys.rail_radius.recip();
        let wheel = rail - relative_radius.recip();
        self.physics(KEY, Conformity::of_curvatures(rail, wheel))
    }

    /// What holds or frees the surfaces: structures say, but where the case says how a lone wheel turns.
    fn motion(&self) -> [Motion<()>; 2] {
        let along = match (self.file.wheelset.is_some(), self.file.wheel.rotation()) {
            (true, _) | (false, Rotation::Inertia) => Motion::Compliant(()),
            (false, Rotation::ConstantTangentialForce) => Motion::Free,
            (false, Rotation::ConstantCreepage) => Motion::Held,
        };
        [along, Motion::Compliant(())]
    }

    /// Lone wheels, as in the loop of one axis.
    fn lone_wheels(&self, hertz: HertzContact, remarks: &mut Vec<Message>) -> Result<Arc<dyn Structure>, CaseError> {
        let (vertical, of_wheel) = self.wheel()?;
        remarks.extend(of_wheel);
        let inertia = match self.file.wheel.rotation() {
            Rotation::Inertia => Some(self.required("wheel.inertia", self.file.wheel.inertia)?),
            _ => None,
        };
        let longitudinal = inertia
            .map(|inertia| {
                self.turning_wheel(inertia.si(), hertz.rolling_radius())
                    .map(|rigid| Arc::new(rigid) as Arc<dyn Receptance>)
            })
            .transpose()?;
        Ok(Arc::new(Uncoupled { longitudinal, lateral: None, vertical: Some(vertical) }))
    }

    /// The track along all axes it has: without wheelsets and without twist downward alone, as in the loop of one axis.
    /// None for one whose model knows its vertical receptance under the load alone.
    fn spatial_track(
        &self,
        keys: &GeneralKeys,
        steel: ElasticMaterial,
        points: &[(Rail, f64)],
        remarks: &mut Vec<Message>,
    ) -> Result<Option<SpatialTrack>, CaseError> {
        let model = self.file.track.model;
        let modelled = self.given.track.is_none() && !matches!(model, TrackModel::MovingBeam | TrackModel::Measured);
        if !modelled {
            if keys.wheels.len() > 1 {
                return Err(self.text.keys.invalid(
                    "train.wheels",
                    say!(are_several_but_track_model_does, model = model.name()),
                    say!(choose_a_model_or_one_wheel),
                ));
            }
            if keys.wheelset.is_some() {
                remarks.push(say!(track_moves_downward_only));
            }
            return Ok(None);
        }
        let on_supports = model != TrackModel::FreeBeam;
        let [across, along] = self.axes_of_track(keys, on_supports, remarks);
        let spatial = SpatialRail {
            vertical: self.beam(steel, Direction::Vertical)?,
            lateral: across.then(|| self.beam(steel, Direction::Lateral)).transpose()?,
            twist: match &keys.twist {
                Some(twist) if across => Some(self.twist_of(twist, steel)?),
                Some(_) => {
                    return Err(self.text.keys.invalid(
                        "rail.torsion_constant",
                        "is given, but the rail does not move across the track",
                        say!(give_rail_lateral_second_moment_and),
                    ));
                }
                None => None,
            },
            longitudinal: along.then(|| self.bar(steel)).transpose()?,
        };
        let track = match on_supports {
            true => self.spatial_on_supports(spatial)?,
            false => SpatialTrack::free(spatial),
        };
        let height = keys.twist.map_or(0.0, |twist| twist.head_height);
        let track = points.iter().fold(track, |track, &(rail, lateral_offset)| {
            let point = ContactPoint { height, lateral_offset };
            track.with_contact(rail, point)
        });
        Ok(Some(track))
    }

    /// Whether the track moves across and along itself, with remarks on keys that it lacks.
    fn axes_of_track(&self, keys: &GeneralKeys, on_supports: bool, remarks: &mut Vec<Message>) -> [bool; 2] {
        let all_axes = keys.wheelset.is_some() || keys.twist.is_some();
        let has = |rail: bool, pad: bool| all_axes && rail && (pad || !on_supports);
        let pad = self.file.track.pad.as_ref();
        let rail = &self.file.rail;
        let across = has(rail.lateral_second_moment.is_some(), pad.is_some_and(|pad| pad.lateral_stiffness.is_some()));
        let along = has(rail.area.is_some(), pad.is_some_and(|pad| pad.longitudinal_stiffness.is_some()));
        if all_axes {
            for (has, key, pad, direction) in [
                (across, "rail.lateral_second_moment", "track.pad.lateral_stiffness", say!(across_track)),
                (along, "rail.area", "track.pad.longitudinal_stiffness", say!(along_itself)),
            ] {
                if !has {
                    let keys = match on_supports {
                        true => Value::from(say!(both, one = key, other = pad)),
                        false => Value::from(key),
                    };
                    remarks.push(say!(rail_taken_as_rigid, direction, keys));
                }
            }
        }
        [across, along]
    }

    /// A rail on its supports, along the axes that the rail has.
    fn spatial_on_supports(&self, rail: SpatialRail) -> Result<SpatialTrack, CaseError> {
        let model = self.file.track.model;
        let (across, along) = (rail.lateral.is_some(), rail.longitudinal.is_some());
        let two_layers = matches!(model, TrackModel::TwoLayer | TrackModel::TwoLayerPeriodic);
        let support = |has: bool, direction| has.then(|| self.support(two_layers, direction)).transpose();
        let (down, spacing) = self.support(two_layers, Direction::Vertical)?;
        let supports = Supports {
            vertical: Some(down),
            lateral: support(across, Direction::Lateral)?.map(|(support, _)| support),
            longitudinal: support(along, Direction::Longitudinal)?.map(|(support, _)| support),
        };
        if model.is_periodic() {
            let track = SpatialTrack::discrete(rail, supports, spacing);
            self.physics("track.support_spacing", track)
        } else {
            let supports = supports.per_metre(spacing);
            let supports = self.physics("track.support_spacing", supports)?;
            Ok(SpatialTrack::continuous(rail, supports))
        }
    }

    fn twist_of(&self, keys: &TwistKeys, steel: ElasticMaterial) -> Result<Twist, CaseError> {
        let rail = &self.file.rail;
        // A rail without supports has no foot that matters.
        let [foot_depth, foot_width] = keys.foot.unwrap_or([0.0, 1.0]);
        let section = TwistSection {
            torsion_constant: keys.torsion_constant,
            polar_second_moment: keys.polar_second_moment,
            warping_constant: keys.warping_constant,
            centroid_height: keys.centroid_height,
            foot_depth,
            foot_width,
            shear_modulus: rail.shear_modulus.map_or(steel.shear_modulus(), |modulus| modulus.si()),
            density: rail.density.map_or(STEEL_DENSITY, |density| density.si()),
        };
        let loss_factor = rail.loss_factor.map_or(0.0, |loss| loss.si());
        let twist = Twist::new(steel, section).and_then(|twist| twist.with_loss_factor(loss_factor));
        self.physics("rail.torsion_constant", twist)
    }
}
