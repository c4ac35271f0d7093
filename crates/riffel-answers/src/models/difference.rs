//! Why two models differ: one joint changed at a time.

use riffel::growth::GrowthCourse;
use riffel_case::Case;
use riffel_case::model::{FieldModel, Joint, Joints};

use super::on_case;
use super::passing::Passing;
use crate::Highest;

/// A joint of a model, replaced alone by that of the case with the exact contact.
#[derive(Debug, Clone, PartialEq)]
pub struct Difference {
    /// The joint.
    pub joint: Joint,
    /// What takes its place, in words.
    pub replaced_by: &'static str,
    /// What it does to growth; where the model cannot be built with this joint alone replaced, why.
    pub effect: Result<Effect, String>,
}

/// What replacing one joint does to growth.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Effect {
    /// Largest change of the growth rate per passage \[-\] over the wavelengths, without its sign.
    pub largest_change: f64,
    /// The fastest wavelength with the joint replaced; none where nothing grows then.
    pub highest: Option<Highest>,
}

impl Difference {
    /// All joints by which a model with its growth rates differs, the one that moves growth most first; joints that move
    /// none are left out, as a free beam on a case that has one.
    pub(super) fn all(
        case: &Case,
        joints: Joints,
        course: &GrowthCourse,
        passing: &Passing,
    ) -> Vec<Self> {
        let exact = FieldModel::EXACT.joints;
        let mut differences: Vec<Self> = joints
            .differences(exact)
            .map(|joint| {
                let replaced = joints.with(joint, exact);
                let changed = on_case(case, replaced, passing);
                let effect = changed.map(|on| {
                    let (changed, highest) = passing.course(&on);
                    let places = course.wavelengths.iter().chain(&changed.wavelengths);
                    let changes = places.map(|&place| (changed.at(place) - course.at(place)).abs());
                    Effect {
                        largest_change: changes.fold(0.0, f64::max),
                        highest,
                    }
                });
                Self {
                    joint,
                    replaced_by: replaced.words(joint),
                    effect,
                }
            })
            .collect();
        differences.retain(|difference| difference.change() != Some(0.0));
        differences.sort_by(|a, b| {
            let [a, b] = [a, b].map(|difference| difference.change().unwrap_or(-1.0));
            b.total_cmp(&a)
        });
        differences
    }

    fn change(&self) -> Option<f64> {
        let effect = self.effect.as_ref().ok()?;
        Some(effect.largest_change)
    }

    /// The difference in a sentence, next to the fastest wavelength of the model.
    pub fn sentence(&self, highest: Option<Highest>) -> String {
        let name = self.joint.name();
        let exact = self.replaced_by;
        let fastest = |highest: Option<Highest>| match highest {
            Some(Highest {
                wavelength, rate, ..
            }) => format!("{:.3e} at {:.1} mm", rate, 1e3 * wavelength),
            None => "no growth".to_owned(),
        };
        match &self.effect {
            Ok(effect) => format!(
                "{name}: from {} to {} with: {exact}",
                fastest(highest),
                fastest(effect.highest),
            ),
            Err(reason) => format!("{name}: {exact} cannot take its place alone: {reason}"),
        }
    }
}
