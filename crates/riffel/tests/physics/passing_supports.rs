//! A wheel that passes discrete supports: growth with neighbours.

use std::sync::Arc;

use riffel::contact::{MeanState, QuasiStatic};
use riffel::growth::{Bay, GrowthWithNeighbours};
use riffel::receptance::{Beam, Layer, MovingLoadOnSupports, PeriodicTrack, ShearSection, Support};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Carter3d, DissipationPhase, ElasticMaterial, EnergyWear, FeedbackLoop, HertzContact,
    PlaceOfWear,
};

const SPACING: f64 = 0.6;
const SPEED: f64 = 30.0;

fn steel() -> ElasticMaterial {
    ElasticMaterial::new(207e9, 0.3).unwrap()
}

/// 60E1 on concrete sleepers with viscous loss everywhere: causal, and pinned-pinned at 1060 Hz.
fn track() -> PeriodicTrack<Beam> {
    let shear = ShearSection {
        area: 7.67e-3,
        shear_coefficient: 0.4,
        shear_modulus: 79.6e9,
        density: 7850.0,
    };
    let rail = Beam::timoshenko(steel(), 3.04e-5, 60.2, shear)
        .and_then(|rail| rail.with_damping(1500.0))
        .unwrap();
    let layer = |stiffness, damping| Layer::new(stiffness, damping).unwrap();
    let support = Support::two_layer(layer(300e6, 40e3), 150.0, layer(80e6, 80e3));
    PeriodicTrack::new(rail, support.unwrap(), SPACING).unwrap()
}

fn feedback(amplitude: f64) -> FeedbackLoop {
    let hertz = HertzContact::new(steel(), 0.46, 0.3, 50e3).unwrap();
    let law = Carter3d::new(hertz, 0.35).unwrap();
    let contact = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.3)).unwrap();
    let inertia = RigidInertia::reduced_inertia(350.0, 0.46);
    FeedbackLoop {
        track: Arc::new(track()),
        wheel: Arc::new(RigidMass::new(350.0).unwrap()),
        contact_stiffness: hertz.stiffness(),
        contact: Arc::new(contact),
        rotation: Motion::compliant(RigidInertia::new(inertia, 0.46).unwrap()),
        rolling_radius: 0.46,
        place_of_wear: PlaceOfWear::new(DissipationPhase::None, 0.0, 0.3),
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz.semi_axis_lateral()).unwrap(),
        amplitude,
    }
}

fn moving(speed: f64) -> MovingLoadOnSupports {
    MovingLoadOnSupports::new(&track(), speed).unwrap()
}

/// At 2 m/s over 4 mm everything is quasi-static in position: the wave alone grows like the mean over the bay, and the
/// leading pattern faster, towards the fastest place.
#[test]
fn growth_with_neighbours_of_a_slow_wheel_is_local() {
    let feedback = feedback(1e-6);
    let (speed, wavelength) = (2.0, 0.004);
    let bay = Bay::new(feedback.clone(), Arc::new(track())).unwrap();
    let states = bay.states(wavelength, speed, 61);
    let rates: Vec<f64> = states
        .iter()
        .map(|(_, state)| state.growth_rate())
        .collect();
    let mean = feedback.growth_rate_per_dissipation()
        * bay.mean_normalized_dissipation(wavelength, speed).re;
    let highest = rates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let lowest = rates.iter().copied().fold(f64::INFINITY, f64::min);
    let range = highest - lowest;
    let of = |neighbours| {
        GrowthWithNeighbours::at(&feedback, &moving(speed), wavelength, neighbours).unwrap()
    };
    let [few, many] = [of(2), of(6)];
    assert!((many.alone().re - mean).abs() < 2e-3 * range);
    // e_n changes by 4 % over the neighbours, and with it what leads.
    assert!(
        few.leading.re > mean + 0.5 * (highest - mean) && few.leading.re < highest + 0.02 * range
    );
    assert!(many.leading.re < highest + 0.02 * range);
    assert!(many.leading.re > mean + 0.4 * (highest - mean));
}

/// Neighbours need wavelengths.
#[test]
fn too_many_neighbours_are_refused() {
    let refused = GrowthWithNeighbours::at(&feedback(1e-6), &moving(SPEED), 0.1, 6).unwrap_err();
    assert!(refused.to_string().contains("neighbours"), "{refused}");
}
