//! How often the slow parts are asked for: a slow path shows here without a clock. Bounds are what is needed today and a
//! tenth more.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use riffel::cancel::run_while;
use riffel::contact::{CreepDerivatives, CreepForces, CreepLaw, Creepages, ForceLimit, MeanState, QuasiStatic};
use riffel::passage::{ContactInTime, ImpulseResponse, PassageModel, Sinusoid, StructuresInTime};
use riffel::receptance::{Beam, FreeBeam, Layer, PeriodicTrack, ShearSection, Support, Tabulated};
use riffel::wheelset::{RigidInertia, RigidMass};
use riffel::{Axis, Carter3d, Complex64, ElasticMaterial, GrowthMap, Loop, Receptance, Ridge};

use crate::fixtures::{self, hertz, one_wheel};

/// A structure that counts how often it is asked.
struct Counted<R> {
    structure: R,
    asked: Arc<AtomicUsize>,
    worth_tabulating: bool,
}

impl<R: Receptance> Receptance for Counted<R> {
    fn receptance(&self, angular_frequency: f64, speed: f64) -> Complex64 {
        self.asked.fetch_add(1, Ordering::Relaxed);
        self.structure.receptance(angular_frequency, speed)
    }

    fn worth_tabulating(&self) -> bool {
        self.worth_tabulating
    }
}

/// UIC 60 on stiff pads, discrete, of a loss factor of 0.02.
fn sleepers() -> PeriodicTrack {
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    let shear =
        ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: steel.shear_modulus(), density: 7850.0 };
    let rail = Beam::timoshenko(steel, 3.0383e-5, 60.21, shear).unwrap();
    let rail = rail.with_loss_factor(0.02).unwrap();
    let pad = Layer::new(300e6, 40e3).unwrap();
    let ballast = Layer::new(50e6, 40e3).unwrap();
    let support = Support::two_layer(pad, 150.0, ballast).unwrap();
    PeriodicTrack::new(rail, support, 0.6).unwrap()
}

/// The nominal wheel on a track that counts.
fn feedback<R: Receptance + 'static>(structure: R, worth_tabulating: bool) -> (Loop, Arc<AtomicUsize>) {
    let asked = Arc::new(AtomicUsize::new(0));
    let track = Arc::new(Counted { structure, asked: asked.clone(), worth_tabulating });
    let feedback = one_wheel(track, hertz(), 0.4, 0.1);
    (feedback.close().unwrap(), asked)
}

fn rail() -> FreeBeam {
    FreeBeam::new(fixtures::rail())
}

fn window() -> (Axis, Axis) {
    (Axis::new(0.02, 0.08, 241).unwrap(), Axis::new(5.0, 60.0, 221).unwrap())
}

/// A ridge over a map takes steps of its own, half a per cent of the wavelength, so that it does not depend on those of the map:
/// 278 in this window, of tiles of 64 the last filled up; and some evaluations to refine each crest.
#[test]
fn ridge_of_a_map() {
    let (feedback, asked) = feedback(rail(), false);
    let (wavelength, speed) = window();
    let map = GrowthMap::compute(&feedback, wavelength, speed, |_| ());
    let by_map = asked.swap(0, Ordering::Relaxed);
    // Tiles of 64 wavelengths, the last filled up.
    assert_eq!(by_map, 256 * 221);
    let ridge = Ridge::of_map(&feedback, &map);
    let by_ridge = asked.load(Ordering::Relaxed) - 320 * 221;
    assert_eq!(ridge.points.len(), 221);
    assert!((221..=6500).contains(&by_ridge), "{by_ridge} evaluations for the ridge");
}

/// A map on a structure that is worth it asks for a table and for nothing else.
#[test]
fn table_of_a_receptance() {
    let asked = Arc::new(AtomicUsize::new(0));
    let track = Counted { structure: sleepers(), asked: asked.clone(), worth_tabulating: true };
    let lowest = std::f64::consts::TAU * 62.5;
    let table = Tabulated::new(Arc::new(track), lowest, 48.0 * lowest, 1e-9);
    let by_table = asked.load(Ordering::Relaxed);
    assert!(table.cells() > 10);
    assert!((1..=1960).contains(&by_table), "{by_table} receptances for {} cells", table.cells());
    let (feedback, asked) = feedback(sleepers(), true);
    let (wavelength, speed) = window();
    let _ = GrowthMap::compute(&feedback, wavelength, speed, |_| ());
    let by_map = asked.load(Ordering::Relaxed);
    assert!((1..=1960).contains(&by_map), "{by_map} receptances for a map of {} points", 241 * 221);
}

/// A map that nobody waits for any more ends with the row that each thread is in, however often it is divided until then.
#[test]
fn end_of_a_map() {
    const MANY: usize = 10_000;
    let (feedback, asked) = feedback(rail(), false);
    let (wavelength, speed) = (Axis::new(0.02, 0.08, 2000).unwrap(), Axis::new(5.0, 60.0, 500).unwrap());
    let counted = asked.clone();
    let wanted = move || counted.load(Ordering::Relaxed) < MANY;
    assert!(run_while(wanted, || GrowthMap::compute(&feedback, wavelength, speed, |_| ())).is_none());
    // Tiles of 64 wavelengths, the last filled up.
    let rows = rayon::current_num_threads() + 1;
    let asked = asked.load(Ordering::Relaxed);
    assert!((MANY..=MANY + 2048 * rows).contains(&asked), "{asked} receptances");
}

/// A creep law that counts how often it is asked for forces.
struct CountedLaw {
    law: Carter3d,
    asked: Arc<AtomicUsize>,
}

impl CreepLaw for CountedLaw {
    fn friction(&self) -> f64 {
        self.law.friction()
    }

    fn forces(&self, normal_force: f64, creepages: Creepages) -> CreepForces {
        self.asked.fetch_add(1, Ordering::Relaxed);
        self.law.forces(normal_force, creepages)
    }

    fn derivatives(&self, normal_force: f64, creepages: Creepages) -> CreepDerivatives {
        self.law.derivatives(normal_force, creepages)
    }

    fn limit(&self, normal_force: f64) -> ForceLimit {
        self.law.limit(normal_force)
    }
}

/// A track in time is fitted from some frequencies, and a wheel over a wave asks its law a few times a step until it settles.
#[test]
fn fit_and_march_of_a_wheel() {
    const STEPS: usize = 100;
    let track = Counted { structure: rail(), asked: Arc::default(), worth_tabulating: false };
    let response = ImpulseResponse::of(&track, 30.0).unwrap();
    let by_fit = track.asked.load(Ordering::Relaxed);
    assert!((1..=770).contains(&by_fit), "{by_fit} receptances for a fit");

    let hertz = hertz();
    let law = Arc::new(CountedLaw { law: Carter3d::new(hertz, 0.4).unwrap(), asked: Arc::default() });
    let contact = QuasiStatic::new(law.clone(), 50e3, MeanState::TractiveRatio(0.1)).unwrap();
    let mean = riffel::RollingContact::steady(&contact);
    let wheel = RigidMass::new(350.0).unwrap();
    let rotation = RigidInertia::new(27.77, 0.46).unwrap();
    let in_time = ContactInTime::of_one_wheel(mean, hertz.stiffness(), law.clone());
    let model = PassageModel {
        structures: StructuresInTime::of_one_wheel(response, &wheel, Some(&rotation)),
        contacts: vec![in_time.unwrap()],
        contact_filter: None,
        speed: 30.0,
    };
    law.asked.store(0, Ordering::Relaxed);
    let wave = Sinusoid { amplitude: 10e-6, wavelength: 0.05 };
    let settled = model.settle(wave, STEPS).unwrap().swap_remove(0);
    let a_step = law.asked.load(Ordering::Relaxed) as f64 / (STEPS * settled.waves) as f64;
    assert!(settled.waves <= 132, "{} waves to settle", settled.waves);
    assert!((1.0..=2.25).contains(&a_step), "{a_step} forces a step");

    // What nobody waits for any more ends after a wave.
    law.asked.store(0, Ordering::Relaxed);
    assert!(run_while(|| false, || model.settle(wave, STEPS)).is_none());
    assert!(law.asked.load(Ordering::Relaxed) <= STEPS);
}
