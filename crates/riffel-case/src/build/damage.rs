//! The laws of damage of a case.

use std::sync::Arc;

use riffel::HertzContact;
use riffel::contact::MeanRolling;
use riffel::damage::{
    Bending, ClippedPower, Damage, DamageLaw, Demand, Fatigue, Flow, FlowAlong, Load, ShakedownLimit,
};
use riffel_keys::{CaseError, Message, fixed, say, significant};

use crate::file::{Damage as DamageKeys, DamageLawName, LimitName};
use crate::keys::checked_keys::CheckedKeys;
use crate::parts::track::Track;

impl CheckedKeys {
    /// The keys of damage: as written, or those of wear alone where a law of wear is written; `None` if neither is.
    pub(crate) fn damage_keys(&self) -> Option<DamageKeys> {
        let law = self.text.is_written("wear.law");
        let of_wear = || law.then(DamageKeys::default);
        self.file.damage.clone().or_else(of_wear)
    }

    /// The limit of the pressure under a contact.
    pub(crate) fn shakedown_limit(&self, name: LimitName, hertz: HertzContact) -> ShakedownLimit {
        let ratio = hertz.semi_axis_longitudinal() / hertz.semi_axis_lateral();
        match name {
            LimitName::Elastic => ShakedownLimit::Elastic { ratio, poisson_ratio: hertz.material().poisson_ratio() },
            LimitName::Line => ShakedownLimit::Line,
            LimitName::Surface => ShakedownLimit::Surface,
            LimitName::Subsurface => ShakedownLimit::Subsurface { ratio },
        }
    }

    /// The laws of damage under a contact; `None` if wear is alone and nothing is said of it.
    pub(super) fn damage(
        &self,
        hertz: HertzContact,
        steady: &MeanRolling,
        track: &Track,
    ) -> Result<Option<Arc<Damage>>, CaseError> {
        let Some(keys) = self.damage_keys() else {
            return Ok(None);
        };
        let limit = self.shakedown_limit(keys.limit, hertz);
        let demand = Demand::new(steady, hertz.peak_pressure(), keys.yield_in_shear(), limit);
        let mut demand = self.physics("damage.limit", demand)?;
        if self.feels_waves() {
            let on_waves = demand.on_waves(hertz, |curved| self.shakedown_limit(keys.limit, curved));
            demand = self.physics("contact.longitudinal_radius", on_waves)?;
        }
        if keys.laws.is_empty() {
            return Err(self.text.keys.invalid("damage.laws", say!(is_an_empty_list), say!(damage_by_one_law_or_more)));
        }
        let mut laws = Vec::with_capacity(keys.laws.len());
        for (index, &name) in keys.laws.iter().enumerate() {
            if keys.laws[..index].contains(&name) {
                return Err(self.text.keys.invalid(
                    "damage.laws",
                    format!("names {} twice", name.name()),
                    say!(rates_of_the_laws_add_name),
                ));
            }
            laws.push(self.law(name, &keys, hertz, steady, track)?);
        }
        Ok(Some(Arc::new(Damage::new(demand, laws))))
    }

    fn law(
        &self,
        name: DamageLawName,
        keys: &DamageKeys,
        hertz: HertzContact,
        steady: &MeanRolling,
        track: &Track,
    ) -> Result<DamageLaw, CaseError> {
        let spread = keys.spread.si();
        let missing = |table: &str| {
            let key = format!("damage.{table}");
            let help = say!(damage_laws_names_give_its_table, law = name.name());
            self.text.keys.missing(&key, &help)
        };
        Ok(match name {
            DamageLawName::Wear => DamageLaw::Wear,
            DamageLawName::Load => {
                let load = keys.load.as_ref().ok_or_else(|| missing("load"))?;
                DamageLaw::Load(Load { depth_per_force: load.depth_per_force.si() })
            }
            DamageLawName::Flow => {
                let flow = keys.flow.as_ref().ok_or_else(|| missing("flow"))?;
                DamageLaw::Flow(Flow {
                    depth: flow.depth.si(),
                    law: ClippedPower::new(flow.exponent.si(), spread),
                    hardening_depth: flow.hardening_depth.map(|depth| depth.si()),
                })
            }
            DamageLawName::FlowAlong => {
                let along = keys.flow_along.as_ref();
                let along = along.ok_or_else(|| missing("flow_along"))?;
                DamageLaw::FlowAlong(FlowAlong {
                    area: along.area.si(),
                    law: ClippedPower::new(along.exponent.si(), spread),
                })
            }
            DamageLawName::Bending => {
                let bending = keys.bending.as_ref().ok_or_else(|| missing("bending"))?;
                let Some(support) = track.support else {
                    return Err(self.text.keys.invalid(
                        "damage.laws",
                        say!(names_bending_but_track_model_does, name = self.file.track.model.name()),
                        say!(choose_a_model_or_no_bending),
                    ));
                };
                let second_moment = self.required("rail.second_moment", self.file.rail.second_moment)?;
                let stiffness = self.file.steel.youngs_modulus.si() * second_moment.si();
                let foundation = support.static_stiffness();
                DamageLaw::Bending(Bending {
                    limit: bending.limit.si(),
                    curvature: bending.curvature.si(),
                    law: ClippedPower::new(bending.exponent.si(), spread),
                    bending_stiffness: stiffness,
                    foundation,
                    mean_moment: Bending::moment_at_rest(hertz.normal_force(), stiffness, foundation),
                })
            }
            DamageLawName::Fatigue => {
                if steady.energy_per_metre() <= 0.0 {
                    return Err(self.text.keys.invalid(
                        "damage.laws",
                        say!(names_fatigue_by_t_but_the),
                        say!(give_contact_creepage_or_contact_tractive),
                    ));
                }
                let fatigue = keys.fatigue.clone().unwrap_or_default();
                let thresholds: Vec<f64> = fatigue.thresholds.iter().map(|force| force.si()).collect();
                let Ok(thresholds) = <[f64; 3]>::try_from(thresholds) else {
                    return Err(self.out_of_range(
                        "damage.fatigue.thresholds",
                        format!("a list of {}", fatigue.thresholds.len()),
                        "one of three forces, as [\"15 N\", \"65 N\", \"175 N\"]",
                    ));
                };
                let law = Fatigue::new(thresholds, fatigue.peak.si());
                let mut law = self.physics("damage.fatigue.thresholds", law)?;
                law.loss = fatigue.loss.si();
                law.crack_growth = fatigue.crack_growth.si();
                law.crack_angle = fatigue.crack_angle.si();
                DamageLaw::Fatigue(law)
            }
        })
    }

    /// What the reader should know of the laws of damage of a contact.
    pub(super) fn damage_remarks(&self, damage: &Damage, steady: &MeanRolling) -> Vec<Message> {
        let mut remarks = Vec::new();
        // Elastic limits of a line and an ellipse lie below the surface of a hundred fields up to here.
        const FRICTION: f64 = 0.6;
        // Mean pressure of 2.8 times the yield in tension, √3 k: the whole patch is plastic.
        const PLASTIC: f64 = 7.3;
        let demand = &damage.demand;
        if demand.utilised_friction > FRICTION {
            remarks.push(say!(damage_beyond_friction, friction = fixed(demand.utilised_friction, 2)));
        }
        let over_yield = demand.contact_pressure / demand.shear_yield;
        if over_yield > PLASTIC {
            remarks.push(say!(
                damage_beyond_elastic,
                pressure = fixed(1e-6 * demand.contact_pressure, 0),
                ratio = fixed(over_yield, 1)
            ));
        }
        for law in &damage.laws {
            match law {
                DamageLaw::Bending(bending) => {
                    let share = bending.mean_moment / bending.limit;
                    remarks.push(say!(
                        moment_beside_its_limit,
                        moment = fixed(1e-3 * bending.mean_moment, 1),
                        share = fixed(share, 2)
                    ));
                }
                DamageLaw::Flow(flow) if flow.hardening_depth.is_some() => {
                    remarks.push(say!(flow_hardens));
                }
                DamageLaw::Flow(_) | DamageLaw::FlowAlong(_) if demand.excess() <= 0.0 => {
                    remarks.push(say!(below_the_limit_of_flow, law = law.name(), demand = fixed(demand.value, 2)));
                }
                DamageLaw::Fatigue(fatigue) if fatigue.loss == 0.0 => {
                    remarks.push(say!(fatigue_loses_nothing));
                }
                DamageLaw::Fatigue(fatigue) if steady.energy_per_metre() < fatigue.first_threshold() => {
                    remarks.push(say!(
                        fatigue_below_threshold,
                        energy = significant(steady.energy_per_metre(), 2),
                        threshold = significant(fatigue.first_threshold(), 3)
                    ));
                }
                _ => {}
            }
        }
        remarks
    }
}
