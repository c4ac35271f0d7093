//! The wavelengths whose growth is told.

use riffel::Axis;
use riffel::forecast::TrafficGrowth;

use crate::Case;
use crate::file::ContactDynamics;
use crate::parts::short_waves::shortest_not_averaged;

/// The wavelengths of the map of which the fastest growth is told: without those that the contact averages out, shorter than
/// one and a half of its lengths, where its response does not have that filter. `None` if all of them are.
pub fn growth_window(case: &Case) -> Option<Axis> {
    told_of(case, case.wavelength)
}

/// The shortest wavelength \[m\] of which the fastest growth is told; zero where the response of the contact has the filter.
pub fn shortest_told(case: &Case) -> f64 {
    match case.file.contact.response {
        ContactDynamics::NonSteady => 0.0,
        _ => shortest_not_averaged(case.hertz),
    }
}

/// The wavelength of the bands of the case that grows fastest under a traffic \[m\], its growth rate per axle passage, and whether it
/// sits at an edge: of those that the contact does not average out; of all, where it averages out all. Bands reach a little beyond the map.
pub fn fastest_under(case: &Case, growth: &TrafficGrowth) -> Option<(f64, f64, bool)> {
    let told = growth.fastest(shortest_told(case));
    told.or_else(|| growth.fastest(0.0))
}

/// Wavelengths of another window of which growth is told.
pub fn told_of(case: &Case, window: Axis) -> Option<Axis> {
    let shortest = shortest_told(case);
    if window.min() >= shortest {
        return Some(window);
    }
    Axis::new(shortest, window.max(), window.points()).ok()
}
