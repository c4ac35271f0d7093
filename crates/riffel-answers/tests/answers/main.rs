//! What answers say.

mod all_axes;
mod axlebox;
mod branches;
mod broken_off;
mod cause;
mod comparison;
mod forecast;
mod line_growth;
mod measure;
mod motions;
mod pass_by;
mod questions;
mod remedies;
mod shakedown;

use riffel_case::Case;

/// The case of a text, with overrides.
fn case(text: &str, overrides: &[&str]) -> Case {
    let overrides: Vec<String> = overrides.iter().map(|&text| text.to_owned()).collect();
    Case::parse("case.toml", text, &overrides).unwrap()
}

/// Case of a text with few points of the map.
fn coarse(text: &str, overrides: &[&str]) -> Case {
    let window = ["map.wavelength.points=21", "map.speed.points=5"];
    case(text, &[&window, overrides].concat())
}
