//! Steel, rails, layers and the nominal wheel that tests share.

use std::sync::Arc;

use riffel::contact::{MeanState, QuasiStatic};
use riffel::feedback::OneWheel;
use riffel::receptance::{Beam, EulerBernoulliBeam, Layer, PeriodicTrack, ShearSection, Support};
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{
    Carter3d, DissipationPhase, ElasticMaterial, EnergyWear, HertzContact, PlaceOfWear, Receptance, RollingContact,
};

/// The steel of the paper.
pub(crate) fn steel() -> ElasticMaterial {
    ElasticMaterial::new(207e9, 0.3).unwrap()
}

/// The rail of the paper, BS 113A, free and without loss.
pub(crate) fn rail() -> EulerBernoulliBeam {
    EulerBernoulliBeam::new(steel(), 2.35e-5, 56.0).unwrap()
}

/// 60E1 that shears, of a second moment of area \[m⁴\] and a viscous damping \[N s/m²\].
pub(crate) fn sheared(second_moment: f64, damping: f64) -> Beam {
    let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.4, shear_modulus: 79.6e9, density: 7850.0 };
    Beam::timoshenko(steel(), second_moment, 60.2, shear).and_then(|rail| rail.with_damping(damping)).unwrap()
}

/// A layer of a stiffness \[N/m\] and a damping \[N s/m\].
pub(crate) fn layer(stiffness: f64, damping: f64) -> Layer {
    Layer::new(stiffness, damping).unwrap()
}

/// Concrete sleepers on viscous layers.
pub(crate) fn sleepers() -> Support {
    Support::two_layer(layer(300e6, 40e3), 150.0, layer(80e6, 80e3)).unwrap()
}

/// 60E1 on concrete sleepers every 0.6 m with viscous loss everywhere: causal, and pinned-pinned at 1060 Hz.
pub(crate) fn on_sleepers(damping: f64) -> PeriodicTrack<Beam> {
    PeriodicTrack::new(sheared(3.04e-5, damping), sleepers(), 0.6).unwrap()
}

/// The contact of the paper: a wheel of 0.46 m under 50 kN.
pub(crate) fn hertz() -> HertzContact {
    HertzContact::new(steel(), 0.46, 0.23, 50e3).unwrap()
}

/// A wheel of 350 kg that turns with its inertia under a contact of Carter's law, on a track.
pub(crate) fn one_wheel(track: Arc<dyn Receptance>, hertz: HertzContact, friction: f64, ratio: f64) -> OneWheel {
    let law = Carter3d::new(hertz, friction).unwrap();
    let contact = QuasiStatic::new(law, hertz.normal_force(), MeanState::TractiveRatio(ratio)).unwrap();
    let inertia = RigidInertia::reduced_inertia(350.0, hertz.rolling_radius());
    OneWheel {
        track,
        wheel: Arc::new(RigidMass::new(350.0).unwrap()),
        contact_stiffness: hertz.stiffness(),
        rotation: Motion::compliant(RigidInertia::new(inertia, hertz.rolling_radius()).unwrap()),
        wave: None,
        place_of_wear: PlaceOfWear::new(
            DissipationPhase::Lag,
            hertz.semi_axis_longitudinal(),
            contact.steady().tractive_ratio(),
        ),
        contact: Arc::new(contact),
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz.semi_axis_lateral()).unwrap(),
        amplitude: 1e-6,
    }
}
