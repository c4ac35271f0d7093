//! What a case says of damage.

use riffel::HertzContact;
use riffel::damage::{DamageLaw, ShakedownLimit};

use crate::Case;
use crate::file::{Damage as DamageKeys, LimitName};

impl Case {
    /// Shear yield k of the rail \[Pa\]: that of the case, or a usual one.
    pub fn shear_yield(&self) -> f64 {
        let keys = self.file.damage.as_ref();
        keys.map_or(DamageKeys::SHEAR_YIELD, DamageKeys::yield_in_shear)
    }

    /// Whether laws of damage beside wear have a part in growth.
    pub fn has_other_damage(&self) -> bool {
        let damage = self.feedback.contacts()[0].damage.as_ref();
        damage.is_some_and(|damage| damage.laws != [DamageLaw::Wear])
    }

    /// Whether the case says the shear yield of its rail.
    pub fn has_shear_yield(&self) -> bool {
        let keys = self.file.damage.as_ref();
        keys.is_some_and(|keys| keys.shear_yield.is_some() || keys.grade.is_some())
    }

    /// Name of the limit against which the demand of the case is measured.
    pub fn limit_name(&self) -> LimitName {
        let keys = self.file.damage.as_ref();
        keys.map_or_else(LimitName::default, |keys| keys.limit)
    }

    /// Limit of the pressure under the contact of the case.
    pub fn shakedown_limit(&self, name: LimitName) -> ShakedownLimit {
        self.shakedown_limit_of(name, self.hertz)
    }

    /// Limit of the pressure under another ellipse.
    pub fn shakedown_limit_of(&self, name: LimitName, hertz: HertzContact) -> ShakedownLimit {
        self.keys.shakedown_limit(name, hertz)
    }
}
