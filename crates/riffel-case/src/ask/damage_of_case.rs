//! What a case says of damage.

use riffel::HertzContact;
use riffel::damage::ShakedownLimit;

use crate::Case;
use crate::file::{Damage as DamageKeys, LimitName};

/// Shear yield k of the rail \[Pa\]: that of the case, or a usual one.
pub fn shear_yield(case: &Case) -> f64 {
    let keys = case.file.damage.as_ref();
    keys.map_or(DamageKeys::SHEAR_YIELD, DamageKeys::yield_in_shear)
}

/// Whether the case says the shear yield of its rail.
pub fn has_shear_yield(case: &Case) -> bool {
    let keys = case.file.damage.as_ref();
    keys.is_some_and(|keys| keys.shear_yield.is_some() || keys.grade.is_some())
}

/// Name of the limit against which the demand of the case is measured.
pub fn limit_name(case: &Case) -> LimitName {
    let keys = case.file.damage.as_ref();
    keys.map_or_else(LimitName::default, |keys| keys.limit)
}

/// Limit of the pressure under the contact of the case.
pub fn shakedown_limit(case: &Case, name: LimitName) -> ShakedownLimit {
    shakedown_limit_of(case, name, case.hertz)
}

/// Limit of the pressure under another ellipse.
pub fn shakedown_limit_of(case: &Case, name: LimitName, hertz: HertzContact) -> ShakedownLimit {
    case.keys.shakedown_limit(name, hertz)
}
