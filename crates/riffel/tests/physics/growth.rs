//! Identities and limits of the closed loop over random physical cases.

use std::sync::Arc;

use proptest::prelude::*;
use riffel::feedback::OneWheel;
use riffel::growth::{Bay, GrowthOnIrregularSupports, RidgeRow, RidgeSearch, RowEvaluator};
use riffel::receptance::{
    Beam, ContinuousTrack, EulerBernoulliBeam, FreeBeam, IrregularTrack, Layer, MovingBeam, PeriodicTrack,
    ShearSection, Support,
};
use riffel::tile::TILE;
use riffel::wheelset::{Motion, RigidInertia, RigidMass};
use riffel::{Axis, ElasticMaterial, GrowthMap, HertzContact, Loop, LoopState, Receptance, Ridge};

use crate::fixtures;

/// The range of railways: from a metro car to a freight wagon, from wet to very dry rail.
#[derive(Debug, Clone, Copy)]
struct Railway {
    poisson_ratio: f64,
    rolling_radius: f64,
    transverse_radius: f64,
    normal_force: f64,
    friction: f64,
    tractive_ratio: f64,
    wheel_mass: f64,
    rail_mass: f64,
    second_moment: f64,
    wavelength: f64,
    speed: f64,
}

fn railway() -> impl Strategy<Value = Railway> {
    (
        (0.2..0.35, 0.3..0.6, 0.15..0.6, 15e3..125e3),
        (0.05..0.7, 0.01..0.98, 200.0..1000.0),
        (40.0..75.0, 1.5e-5..4e-5, 0.02..0.3, 3.0..80.0),
    )
        .prop_map(|(contact, wheel, rail)| Railway {
            poisson_ratio: contact.0,
            rolling_radius: contact.1,
            transverse_radius: contact.2,
            normal_force: contact.3,
            friction: wheel.0,
            tractive_ratio: wheel.1,
            wheel_mass: wheel.2,
            rail_mass: rail.0,
            second_moment: rail.1,
            wavelength: rail.2,
            speed: rail.3,
        })
}

impl Railway {
    /// The paper's.
    const PAPER: Self = Self {
        poisson_ratio: 0.3,
        rolling_radius: 0.46,
        transverse_radius: 0.23,
        normal_force: 50e3,
        friction: 0.4,
        tractive_ratio: 0.1,
        wheel_mass: 350.0,
        rail_mass: 56.0,
        second_moment: 2.35e-5,
        wavelength: 0.05,
        speed: 20.0,
    };

    fn rail(&self) -> EulerBernoulliBeam {
        let steel = ElasticMaterial::new(207e9, self.poisson_ratio).unwrap();
        EulerBernoulliBeam::new(steel, self.second_moment, self.rail_mass).unwrap()
    }

    fn feedback(&self, track: impl Receptance + 'static, rotation: Motion) -> Loop {
        self.one_wheel(track, rotation).close().unwrap()
    }

    fn one_wheel(&self, track: impl Receptance + 'static, rotation: Motion) -> OneWheel {
        let steel = ElasticMaterial::new(207e9, self.poisson_ratio).unwrap();
        let (radius, across) = (self.rolling_radius, self.transverse_radius);
        let hertz = HertzContact::new(steel, radius, across, self.normal_force).unwrap();
        OneWheel {
            wheel: Arc::new(RigidMass::new(self.wheel_mass).unwrap()),
            rotation,
            amplitude: 1e-5,
            ..fixtures::one_wheel(Arc::new(track), hertz, self.friction, self.tractive_ratio)
        }
    }

    /// The rotation of a rigid wheel of an inertia \[kg m²\].
    fn turning(&self, inertia: f64) -> Motion {
        let rotation = RigidInertia::new(inertia, self.rolling_radius).unwrap();
        Motion::compliant(rotation)
    }

    fn rotation(&self) -> Motion {
        self.turning(self.inertia())
    }

    fn inertia(&self) -> f64 {
        RigidInertia::reduced_inertia(self.wheel_mass, self.rolling_radius)
    }

    fn with_inertia(&self, inertia: f64) -> LoopState {
        self.at(self.turning(inertia))
    }

    fn at(&self, rotation: Motion) -> LoopState {
        self.feedback(FreeBeam::new(self.rail()), rotation).at(self.wavelength, self.speed)
    }
}

/// The sizes of the two terms of W₁, by load and by creepage \[W\].
fn terms(state: &LoopState) -> [f64; 2] {
    let (by_load, by_creepage) = (state.response.by_load, state.response.by_longitudinal);
    [by_load.energy * state.normal_force(), by_creepage.energy * state.creepage()].map(|term| state.speed * term.norm())
}

proptest! {
    /// I_w → 0: the distance to constant tangential force falls in proportion to I_w. Its size there
    /// is that of ωI_wV/(|Q_ξ|R²), a relative change of every quantity.
    #[test]
    fn vanishing_inertia_is_constant_tangential_force(railway in railway()) {
        let limit = railway.at(Motion::Free);
        prop_assert_eq!(limit.tangential_force().norm(), 0.0);
        for inertia in [1e-6, 1e-9] {
            let state = railway.with_inertia(inertia);
            let by_creepage = state.response.by_longitudinal.force[0].norm();
            let small = state.angular_frequency * inertia * railway.speed
                / (by_creepage * railway.rolling_radius.powi(2));
            let distance = (state.normalized_dissipation - limit.normalized_dissipation).norm();
            // W₁ is a difference of two terms, of which the larger bounds the change; x → 1 makes
            // the first-order factor largest.
            let size = terms(&limit).iter().sum::<f64>();
            let scale = size * limit.normalized_dissipation.norm() / limit.dissipation.norm();
            prop_assert!(distance <= 1.01 * small * scale + 1e-12 * scale, "{distance} {small}");
        }
    }

    /// I_w → ∞: the distance to constant creepage falls in proportion to 1/I_w.
    #[test]
    fn infinite_inertia_is_constant_creepage(railway in railway()) {
        let limit = railway.at(Motion::Held);
        prop_assert_eq!(limit.creepage().norm(), 0.0);
        for inertia in [1e9, 1e12] {
            let state = railway.with_inertia(inertia);
            let (by_load, turn) = (state.response.by_load, state.response.by_longitudinal);
            let small = (turn.energy * by_load.force[0]).norm() * railway.rolling_radius.powi(2)
                / (by_load.energy.norm() * railway.speed * state.angular_frequency * inertia);
            let distance = (state.dissipation - limit.dissipation).norm();
            prop_assert!(distance <= (1.01 * small + 1e-12) * limit.dissipation.norm());
        }
    }

    /// V → 0 at constant frequency: the moving beam is the stationary one, the phase shift 3p²/2 with
    /// p² = V²/(4ω√(EI/m)).
    #[test]
    fn slow_load_is_a_stationary_load(railway in railway(), frequency in 50.0..3000.0, speed in 1e-6..1.0f64) {
        let w = std::f64::consts::TAU * frequency;
        let moving = MovingBeam::new(railway.rail());
        let p = speed / moving.critical_speed(w);
        let free = FreeBeam::new(railway.rail()).receptance(w, 0.0);
        let distance = (moving.receptance(w, speed) - free).norm() / free.norm();
        prop_assert!(distance <= 1.6 * p * p + 1e-14, "{distance} {p}");
    }

    /// Passivity of what the wheel meets: track, wheel and contact spring together never feed energy
    /// into the contact, and the normal force leads the profile by 0…180°.
    #[test]
    fn the_vertical_loop_is_passive(railway in railway(), stiffness in 3e7..1e9, damping in 0.0..2e5) {
        let layer = Layer::new(stiffness, damping).unwrap();
        let rail = railway.rail();
        let rotation = || Motion::Held;
        for feedback in [
            railway.feedback(FreeBeam::new(rail), rotation()),
            railway.feedback(MovingBeam::new(rail), rotation()),
            railway.feedback(ContinuousTrack::new(Beam::from(rail), Support::two_layer(layer, 150.0, layer).unwrap()), rotation()),
        ] {
            let state = feedback.at(railway.wavelength, railway.speed);
            prop_assert!(state.normal_receptance().im <= 0.0);
            prop_assert!(state.wheel_receptance[2][2].im <= 0.0);
            prop_assert!(state.normal_force().im >= 0.0);
        }
    }

    /// The growth rate depends on the amplitude of the profile not at all, forces in proportion.
    #[test]
    fn the_loop_is_linear(railway in railway(), factor in 0.01..100.0f64) {
        let rotation = railway.rotation();
        let feedback = railway.one_wheel(FreeBeam::new(railway.rail()), rotation);
        let mut scaled = feedback.clone();
        scaled.amplitude *= factor;
        let [one, other] = [feedback, scaled].map(|f| f.close().unwrap().at(railway.wavelength, railway.speed));
        // Where growth passes zero, rounding is of the size of the whole dissipation.
        let normalized = one.normalized_dissipation;
        let rounding = 1e-12 * one.growth_rate.abs() * normalized.norm() / normalized.re.abs();
        prop_assert!((other.growth_rate - one.growth_rate).abs() < rounding);
        prop_assert!((other.normal_force() / one.normal_force() - factor).norm() < 1e-12 * factor);
    }

    /// The vectorised row is the loop, point by point: another order of the same operations.
    #[test]
    fn a_row_is_its_points(railway in railway(), count in 1..2 * TILE + 3) {
        let rotation = railway.rotation();
        let feedback = railway.feedback(MovingBeam::new(railway.rail()), rotation);
        let wavelengths: Vec<f64> = (0..count).map(|j| railway.wavelength + 1e-3 * j as f64).collect();
        let mut row = vec![Default::default(); count];
        RowEvaluator::new(&feedback, &wavelengths).evaluate(railway.speed, &mut row);
        for (value, &wavelength) in row.iter().zip(&wavelengths) {
            let state = feedback.at(wavelength, railway.speed);
            // Ŵ₁ is a difference of two terms that may nearly cancel.
            let size = terms(&state).iter().sum::<f64>();
            let scale = size * state.normalized_dissipation.norm() / state.dissipation.norm();
            prop_assert!((value - state.normalized_dissipation).norm() < 1e-12 * scale);
        }
    }
}

/// A map large enough for a table agrees with the points to the table's accuracy, and the ridge with
/// the smallest value of each row.
#[test]
fn a_tabulated_map_is_its_points() {
    let railway = Railway { tractive_ratio: 0.3, ..Railway::PAPER };
    let (pad, ballast) = (Layer::new(1.1e8, 3e4).unwrap(), Layer::new(8.6e7, 4e4).unwrap());
    let track = ContinuousTrack::new(Beam::from(railway.rail()), Support::two_layer(pad, 157.0, ballast).unwrap());
    let rotation = railway.rotation();
    let feedback = railway.feedback(track, rotation);
    let (wavelength, speed) = (Axis::new(0.02, 0.2, 301).unwrap(), Axis::new(3.0, 60.0, 101).unwrap());
    let map = GrowthMap::compute(&feedback, wavelength, speed, |_| ());
    let ridge = Ridge::search(&feedback, wavelength, speed);
    assert_eq!(Ridge::of_map(&feedback, &map), ridge);
    for ((speed, row), ridge) in map.rows().zip(&ridge.points) {
        let mut smallest = f64::INFINITY;
        for (index, value) in row.iter().enumerate() {
            let state = feedback.at(wavelength.value(index), speed);
            let expected = state.normalized_dissipation;
            // 1e-9 of the receptance, amplified where the joints nearly cancel: ten times that.
            assert!((value - expected).norm() < 1e-8 * expected.norm());
            smallest = smallest.min(value.re);
        }
        assert!(ridge.normalized_dissipation <= smallest + 1e-9);
        assert_eq!(ridge.speed, speed);
    }
}

/// The branches of the ridge over random railways on pads and ballast.
#[test]
fn branches_of_the_ridge_are_apart_and_the_strongest_leads() {
    let wavelength = Axis::new(0.02, 0.2, 121).unwrap();
    let speeds: Vec<f64> = (0..60).map(|index| 5.0 + 0.9 * f64::from(index)).collect();
    let runner = ProptestConfig::with_cases(48);
    proptest!(runner, |(railway in railway(), pad in 5e7..1e9f64, ballast in 3e7..2e8f64, damping in 1e4..1e5f64)| {
        let (pad, ballast) = (
            Layer::new(pad, damping).unwrap(),
            Layer::new(ballast, damping).unwrap(),
        );
        let rail = Beam::from(railway.rail());
        let track = ContinuousTrack::new(rail, Support::two_layer(pad, 150.0, ballast).unwrap());
        let rotation = railway.rotation();
        let feedback = railway.feedback(track, rotation);
        let ridge = Ridge::search_at(&feedback, wavelength, &speeds);
        prop_assert_eq!(ridge.points.len(), speeds.len());
        let highest = *ridge.highest().unwrap();
        let Some(strongest) = ridge.branches.first() else {
            prop_assert!(highest.growth_rate <= 0.0);
            return Ok(());
        };
        prop_assert!(strongest.points().contains(&highest));
        prop_assert_eq!(ridge.best_fit_frequency(), Some(strongest.frequency()));
        let rates: Vec<f64> = ridge.branches.iter().map(|branch| branch.highest().growth_rate).collect();
        prop_assert!(rates.is_sorted_by(|a, b| a >= b));
        prop_assert!(rates.iter().all(|&rate| rate > 0.0099 * rates[0]));
        for branch in &ridge.branches {
            // One point a speed, in order of speed, and every one a line of growth at that speed.
            prop_assert!(branch.points().is_sorted_by(|a, b| a.speed < b.speed));
            let (slowest, fastest) = branch.speeds();
            prop_assert!(slowest <= fastest);
        }
        for &speed in &[speeds[3], speeds[30]] {
            let lines = Ridge::lines_at(&feedback, wavelength, speed);
            let members: Vec<_> = ridge
                .branches
                .iter()
                .flat_map(|branch| branch.points())
                .filter(|point| point.speed == speed)
                .collect();
            for point in &members {
                // A map of this size reads the track itself, as `lines_at` does.
                let same = |line: &&riffel::growth::RidgePoint| {
                    (line.wavelength / point.wavelength - 1.0).abs() < 1e-6
                };
                prop_assert_eq!(lines.iter().filter(same).count(), 1);
                let twins = members.iter().filter(|other| other.wavelength == point.wavelength);
                prop_assert_eq!(twins.count(), 1);
            }
        }
    });
}

/// Speeds in any order, one speed alone, and a row of the ridge kept by hand give the same branches.
#[test]
fn branches_do_not_depend_on_the_order_of_speeds() {
    let railway = Railway::PAPER;
    let rotation = railway.rotation();
    let feedback = railway.feedback(FreeBeam::new(railway.rail()), rotation);
    let wavelength = Axis::new(0.02, 0.08, 241).unwrap();
    let rising: Vec<f64> = (0..80).map(|index| 5.0 + 0.5 * f64::from(index)).collect();
    let ridge = Ridge::search_at(&feedback, wavelength, &rising);
    let falling: Vec<f64> = rising.iter().rev().copied().collect();
    let reversed = Ridge::search_at(&feedback, wavelength, &falling);
    assert_eq!(ridge.branches, reversed.branches);
    assert_eq!(ridge.branches.len(), 1);

    let mut search = RidgeSearch::new(&feedback, wavelength, &rising);
    let rows: Vec<RidgeRow> = rising.iter().map(|&speed| search.row(speed)).collect();
    let kept = search.ridge(&rows, 1);
    assert_eq!(kept, ridge);

    let alone = Ridge::search_at(&feedback, wavelength, &[20.0]);
    assert_eq!(alone.branches.len(), 1);
    assert_eq!(alone.branches[0].points(), &alone.points[..]);
    // Without traction nothing is dissipated in antiphase: a window of long waves decays.
    let long = Axis::new(1.0, 2.0, 41).unwrap();
    let decaying = Ridge::search_at(&feedback, long, &[5.0, 6.0]);
    assert!(decaying.branches.is_empty() && decaying.best_fit_frequency().is_none());
}

/// Growth over a sleeper bay: the mean by Simpson's rule against two thousand places, and the maps
/// against their points.
#[test]
fn bay_mean() {
    let railway = Railway {
        transverse_radius: 0.3,
        normal_force: 60e3,
        friction: 0.35,
        tractive_ratio: 0.2,
        wheel_mass: 600.0,
        rail_mass: 60.2,
        second_moment: 3.04e-5,
        speed: 30.0,
        ..Railway::PAPER
    };
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80e9, density: 7850.0 };
    let rail = Beam::timoshenko(steel, railway.second_moment, railway.rail_mass, shear)
        .and_then(|rail| rail.with_loss_factor(0.01))
        .unwrap();
    let pad = Layer::new(3e8, 3e4).unwrap();
    let ballast = Layer::new(8e7, 6e4).unwrap();
    let support = Support::two_layer(pad, 150.0, ballast).unwrap();
    let track = PeriodicTrack::new(rail, support, 0.6).unwrap();
    let rotation = railway.rotation();
    let feedback = railway.feedback(track, rotation);
    let bay = Bay::new(&feedback, Arc::new(track)).unwrap();

    // Low, at the rail on its pads, at the pinned-pinned resonance, and above.
    for (wavelength, speed) in [(0.08, 10.0), (0.05, 25.0), (0.03, 31.7), (0.03, 33.0), (0.03, 45.0)] {
        let mean = bay.mean_normalized_dissipation(wavelength, speed);
        let states = bay.states(wavelength, speed, 2001);
        // The trapezoidal rule: both ends are supports and count once together.
        let sum: riffel::Complex64 = states[1..].iter().map(|(_, s)| s.normalized_dissipation).sum();
        let expected = sum / 2000.0;
        let error = (mean - expected).norm() / expected.norm();
        assert!(error < 1e-3, "{wavelength} m {speed} m/s: {error}");
    }

    // Supports that have hardly moved, by the mean of the quasi-static growth over their places.
    let irregular = IrregularTrack::drawn(track, 1e-6, 12, 1).unwrap();
    for (wavelength, speed) in [(0.05, 25.0), (0.03, 31.7), (0.03, 33.0)] {
        let growth = GrowthOnIrregularSupports::new(&feedback, &irregular, wavelength, speed);
        let growth = growth.unwrap();
        let states = bay.states(wavelength, speed, 2001);
        let expected = states[1..].iter().map(|(_, s)| s.growth_rate).sum::<f64>() / 2000.0;
        for values in [&growth.even, &growth.growth_rates] {
            let mean = values.iter().sum::<f64>() / values.len() as f64;
            let error = (mean / expected - 1.0).abs();
            assert!(error < 2e-3, "{wavelength} m {speed} m/s: {error}");
        }
    }

    let (wavelength, speed) = (Axis::new(0.02, 0.08, 40).unwrap(), Axis::new(5.0, 60.0, 30).unwrap());
    let maps = bay.maps(wavelength, speed, |_| ());
    for (row, column) in [(0, 0), (7, 20), (29, 39)] {
        let (v, l) = (speed.value(row), wavelength.value(column));
        let pairs = [
            (maps.over_support.row(row)[column], bay.at(0.0).at(l, v).normalized_dissipation),
            (maps.mid_span.row(row)[column], bay.at(0.3).at(l, v).normalized_dissipation),
            (maps.mean.row(row)[column], bay.mean_normalized_dissipation(l, v)),
        ];
        for (got, expected) in pairs {
            assert!((got - expected).norm() < 1e-12 * expected.norm(), "{got} {expected}");
        }
    }
    let ridge = bay.ridge(&maps.mean, wavelength);
    assert_eq!(ridge.points.len(), 30);
    assert!(Bay::new(&feedback, Arc::new(ContinuousTrack::free(rail))).is_none());
}
