//! Why two models differ: one joint changed at a time.

use riffel::growth::GrowthSpectrum;
use riffel_case::Case;
use riffel_case::model::Joints;
use serde::Serialize;

use super::on_case;
use super::passing::Passing;
use crate::Highest;

/// A joint of a model, replaced alone by that of the case with the exact contact, and what that does to growth.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Difference {
    /// Key of the joint.
    pub joint: &'static str,
    /// Over the wavelengths, without its sign; null where the model cannot be built with this joint alone replaced.
    pub largest_change_of_growth_rate_per_passage: Option<f64>,
    /// With the joint replaced; null where nothing grows then.
    pub highest: Option<Highest>,
    /// Next to the fastest wavelength of the model.
    pub sentence: String,
}

impl Difference {
    /// All joints by which a model with its growth rates differs, the one that moves growth most first; joints that move
    /// none are left out, as a free beam on a case that has one.
    pub(super) fn all(
        case: &Case,
        joints: Joints,
        (course, highest): (&GrowthSpectrum, Option<Highest>),
        passing: &Passing,
    ) -> Vec<Self> {
        let exact = Joints::OURS;
        let mut differences: Vec<Self> = joints
            .differences(exact)
            .map(|joint| {
                let replaced = joints.with(joint, exact);
                let effect = on_case(case, replaced, passing).map(|on| {
                    let (changed, highest) = passing.course(&on);
                    let places = course.wavelengths.iter().chain(&changed.wavelengths);
                    let changes = places.map(|&place| (changed.at(place) - course.at(place)).abs());
                    (changes.fold(0.0, f64::max), highest)
                });
                let (name, exact) = (joint.name(), replaced.words(joint));
                let sentence = match &effect {
                    Ok((_, with)) => format!("{name}: from {} to {} with: {exact}", fastest(highest), fastest(*with)),
                    Err(reason) => format!("{name}: {exact} cannot take its place alone: {reason}"),
                };
                let effect = effect.ok();
                Self {
                    joint: joint.key(),
                    largest_change_of_growth_rate_per_passage: effect.map(|effect| effect.0),
                    highest: effect.and_then(|effect| effect.1),
                    sentence,
                }
            })
            .collect();
        let change = |difference: &Self| difference.largest_change_of_growth_rate_per_passage;
        differences.retain(|difference| change(difference) != Some(0.0));
        differences.sort_by(|a, b| {
            let [a, b] = [a, b].map(|difference| change(difference).unwrap_or(-1.0));
            b.total_cmp(&a)
        });
        differences
    }
}

fn fastest(highest: Option<Highest>) -> String {
    match highest {
        Some(Highest { wavelength, rate, .. }) => format!("{rate:.3e} at {:.1} mm", 1e3 * wavelength),
        None => "no growth".to_owned(),
    }
}
