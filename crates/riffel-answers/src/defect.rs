//! A weld, joint or squat as data.

use riffel::roughness::RailDefect;
use serde::Serialize;

#[derive(Serialize)]
pub(crate) struct Defect {
    rail: String,
    /// weld-or-joint | squat
    kind: &'static str,
    from_m: f64,
    to_m: f64,
    /// Over the line from its beginning to its end; negative for a dip.
    height_m: f64,
}

impl Defect {
    pub(crate) fn new(rail: &str, defect: &RailDefect) -> Self {
        Self {
            rail: rail.to_owned(),
            kind: match defect.is_short() {
                true => "squat",
                false => "weld-or-joint",
            },
            from_m: defect.from,
            to_m: defect.to,
            height_m: defect.height,
        }
    }

    pub(crate) fn all(rail: &str, defects: &[RailDefect]) -> Vec<Self> {
        defects.iter().map(|defect| Self::new(rail, defect)).collect()
    }
}
