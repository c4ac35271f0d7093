//! Limits and identities of curving.

use std::sync::Arc;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::Rail;
use riffel::contact::{CreepEllipse, ShenHedrickElkins};

use super::*;

fn ellipse() -> CreepEllipse {
    CreepEllipse::of_coefficients(10.5e6, 9.2e6, 22e3, 54e3).unwrap()
}

pub(super) fn creep(friction: f64) -> Creep {
    Creep::Law(Arc::new(ShenHedrickElkins::new(ellipse(), friction).unwrap()))
}

pub(super) fn axle() -> Axle {
    Axle {
        primary_spacing: 2.0,
        primary_longitudinal_stiffness: 10e6,
        primary_lateral_stiffness: 5e6,
        mass_per_axle: 11_000.0,
        wheelset_mass: 1400.0,
        rolling_radii: [0.46, 0.46],
        contact_spacing: 1.5,
        centre_of_mass_height: 1.7,
    }
}

pub(super) fn bogie(yaw_moment: f64) -> RunningGear {
    RunningGear::Bogie(BogieFrame { wheelbase: 2.5, yaw_moment })
}

pub(super) fn tilted(shift_moment: bool) -> Kinematics {
    Kinematics::Nonlinear {
        surfaces: Arc::new(ConeWithFlangePlane { conicity: 0.05, slope: 2.5, shift: 7e-3, width: 0.4e-3 }),
        contact_plane: ContactPlane::Tilted { shift_moment },
        flange: None,
    }
}

/// Conical treads with a conical flange, between which the contact jumps at a shift of 6.2 mm.
struct ConeAndFlange {
    two_points: Vec<TwoPoints>,
}

impl ConeAndFlange {
    const CONICITY: f64 = 0.05;
    const SLOPE: f64 = 2.5;
    const SHIFT: f64 = 6.2e-3;
    /// The flange's rolling radius is larger by this where both touch \[m\].
    const DEPTH: f64 = 9e-3;

    fn new() -> Self {
        let at = |rail: Rail| {
            let outward = [Self::side(Self::SHIFT, false), Self::side(Self::SHIFT, true)];
            let [below, above] = match rail {
                Rail::Right => outward,
                Rail::Left => [outward[1], outward[0]],
            };
            TwoPoints { rail, shift: rail.sign() * Self::SHIFT, positions: [below, above] }
        };
        Self { two_points: vec![at(Rail::Left), at(Rail::Right)] }
    }

    fn side(toward: f64, on_flange: bool) -> RollingPosition {
        let (slope, depth) = match on_flange {
            true => (Self::SLOPE, Self::CONICITY * Self::SHIFT + Self::DEPTH + Self::SLOPE * (toward - Self::SHIFT)),
            false => (Self::CONICITY, Self::CONICITY * toward),
        };
        RollingPosition { radius_change: depth, contact_angle: slope.atan(), lateral_curvature: None }
    }
}

impl RunningSurfaces for ConeAndFlange {
    fn position(&self, rail: Rail, lateral_shift: f64) -> Option<RollingPosition> {
        let toward = rail.sign() * lateral_shift;
        Some(Self::side(toward, toward > Self::SHIFT))
    }

    fn two_points(&self) -> &[TwoPoints] {
        &self.two_points
    }
}

fn on_two_points(radius: f64) -> VehicleInCurve {
    VehicleInCurve {
        curve: Curve { radius, cant: 0.05, speed: (0.6 * radius.abs()).sqrt() },
        axle: axle(),
        running_gear: bogie(0.0),
        drive_torque: vec![0.0; 2],
        kinematics: Kinematics::Nonlinear {
            surfaces: Arc::new(ConeAndFlange::new()),
            contact_plane: ContactPlane::Tilted { shift_moment: false },
            flange: None,
        },
        creep: [creep(0.4), creep(0.25)],
    }
}

/// From wide curves to tight ones the outer leading wheel goes onto its flange: first on the tread alone, then on both, with a
/// normal force of the flange that grows from zero without a jump. Complementarity: no force below zero, and a force of the
/// flange only at the shift of contact. The energy balance holds with both contacts, and the mirror image is one.
#[test]
fn a_wheel_goes_onto_its_flange_without_a_jump() {
    let mut last: Option<(f64, f64)> = None;
    let mut shares = Vec::new();
    for step in 0..60 {
        let radius = 20_000.0 * 0.92_f64.powi(step);
        let tight = on_two_points(radius);
        let state = tight.equilibrium().unwrap();
        assert!(state.residual < 1e-10);
        let wheel = &state.wheels[0];
        let flange = wheel.second_contact.map_or(0.0, |second| second.normal_force);
        let shift = state.wheelsets[0].lateral_shift;
        assert!(wheel.normal_force > 0.0 && flange >= 0.0);
        assert_eq!(wheel.on_two_points(), shift == -ConeAndFlange::SHIFT, "{radius} {shift}");
        if let Some((before, force)) = last {
            // Steps of the radius are of 8 %: neither shift nor force leaps by more than a share of its range.
            assert!((shift - before).abs() < 1.5e-3, "{radius}: {before} {shift}");
            assert!((flange - force).abs() < 1.2e4, "{radius}: {force} {flange}");
        }
        last = Some((shift, flange));
        shares.push(flange / (flange + wheel.normal_force));

        let mirror = VehicleInCurve {
            curve: Curve { radius: -radius, ..tight.curve },
            creep: [creep(0.25), creep(0.4)],
            ..tight.clone()
        };
        let mirror = mirror.equilibrium().unwrap();
        assert!((mirror.wheelsets[0].lateral_shift + shift).abs() < 1e-10);
        let mirrored = mirror.wheels[1].second_contact.map_or(0.0, |second| second.normal_force);
        assert!((mirrored - flange).abs() < 1e-3);
        for (index, wheelset) in state.wheelsets.iter().enumerate() {
            let [left, right] = [&state.wheels[2 * index], &state.wheels[2 * index + 1]];
            let along = |wheel: &WheelState| {
                let second = wheel.second_contact.map_or(0.0, |second| second.creep_forces.longitudinal);
                wheel.creep_forces.longitudinal + second
            };
            let turning = 0.75 * (along(right) - along(left));
            let given = along(left) + along(right) - turning / radius;
            let taken = left.whole_t_gamma() + right.whole_t_gamma();
            let scale = 0.5 * axle().mass_per_axle * GRAVITY;
            assert!((given - taken).abs() < 1e-9 * scale, "{given} {taken} {}", wheelset.yaw);
        }
    }
    assert_eq!(shares[0], 0.0);
    assert!(shares.iter().any(|share| *share > 0.2), "{shares:?}");
}

/// Wheelsets on springs so soft that they are free, balanced by cant, roll without creepage; the springs' share of the
/// creep forces is 1e-9.
#[test]
fn soft_springs_leave_the_wheelsets_free() {
    let (spacing, radius, speed) = (1.5_f64, 700.0, 20.0_f64);
    // tan θ = V²/gR balances the curve.
    let cant = spacing * (speed * speed / (GRAVITY * radius)).atan().sin();
    let linear = Creep::Linear { ellipse: CreepEllipse::of_coefficients(10e6, 9e6, 0.0, 54e3).unwrap(), friction: 0.4 };
    let free = VehicleInCurve {
        curve: Curve { radius, cant, speed },
        axle: Axle { primary_longitudinal_stiffness: 0.01, primary_lateral_stiffness: 0.01, ..axle() },
        running_gear: bogie(0.0),
        drive_torque: vec![0.0; 2],
        kinematics: Kinematics::Linear { conicity: 0.1 },
        creep: [linear.clone(), linear],
    };
    let state = free.equilibrium().unwrap();
    let expected = free_curving_shift(0.46, spacing, 0.1, radius);
    for wheelset in state.wheelsets {
        assert_relative_eq!(wheelset.lateral_shift, expected, max_relative = 1e-7);
        assert!(wheelset.yaw.abs() < 1e-9);
    }
}

/// Where every contact slides, no tangential force is above μP, and tight curves with stiff springs bring it there.
#[test]
fn tight_curves_slide() {
    let tight = VehicleInCurve {
        curve: Curve { radius: 100.0, cant: 0.0, speed: 3.0 },
        axle: axle(),
        running_gear: bogie(0.0),
        drive_torque: vec![0.0; 2],
        kinematics: Kinematics::Nonlinear {
            surfaces: Arc::new(Cone { conicity: 0.05 }),
            contact_plane: ContactPlane::Horizontal,
            flange: Some(FlangeSpring { clearance: 7e-3, stiffness: 50e6 }),
        },
        creep: [creep(0.3), creep(0.3)],
    };
    let state = tight.equilibrium().unwrap();
    assert!(state.wheels[..2].iter().all(|wheel| (wheel.tractive_ratio - 1.0).abs() < 1e-12));
    assert!(state.wheels.iter().all(|wheel| wheel.tractive_ratio < 1.0 + 1e-12));
    assert!(state.wheelsets[0].flange_force > 0.0 && state.wheelsets[0].angle_of_attack > 0.0);
}

/// FASTSIM has the slopes of Kalker's linear theory, as the law of Shen, Hedrick & Elkins does: in a wide curve both lead to one
/// equilibrium, but for what FASTSIM's parabolic bound lets slide at the edge. In a tight one it keeps its own residual,
/// its mirror image and μP.
#[test]
fn fastsim_finds_its_equilibrium_from_a_closed_law() {
    let local = |law: LawOnEllipse, friction: f64| Creep::Local {
        law,
        material: riffel::ElasticMaterial::new(210e9, 0.3).unwrap(),
        rolling_radius: 0.46,
        lateral_curvature: 1.0 / 0.3,
        friction,
    };
    let vehicle = |law: LawOnEllipse, radius: f64, friction: [f64; 2]| VehicleInCurve {
        curve: Curve { radius, cant: 0.05, speed: 15.0 },
        axle: axle(),
        running_gear: bogie(0.0),
        drive_torque: vec![0.0; 2],
        kinematics: tilted(false),
        creep: friction.map(|friction| local(law, friction)),
    };
    let [closed, fastsim] = [LawOnEllipse::ShenHedrickElkins, LawOnEllipse::Fastsim]
        .map(|law| vehicle(law, 20e3, [0.6; 2]).equilibrium().unwrap());
    for (closed, fastsim) in closed.wheels.iter().zip(&fastsim.wheels) {
        let (closed, fastsim) = (closed.creep_forces, fastsim.creep_forces);
        let off = [closed.longitudinal - fastsim.longitudinal, closed.lateral - fastsim.lateral];
        // 3 % of the largest force, 8 kN.
        assert!(off.iter().all(|off| off.abs() < 250.0), "{off:?}");
    }
    let tight = vehicle(LawOnEllipse::Fastsim, 300.0, [0.4, 0.2]);
    let states = tight.equilibria().unwrap();
    assert!(states.iter().all(|state| state.residual < 1e-10));
    let mirrored = vehicle(LawOnEllipse::Fastsim, -300.0, [0.2, 0.4]).equilibrium().unwrap();
    for (one, other) in states[0].wheelsets.iter().zip(&mirrored.wheelsets) {
        assert!((one.lateral_shift + other.lateral_shift).abs() < 1e-9);
        assert!((one.yaw + other.yaw).abs() < 1e-9);
    }
    let ratios = states[0].wheels.iter().map(|wheel| wheel.tractive_ratio);
    assert!(ratios.fold(0.0, f64::max) < 1.0 + 1e-9);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// A curve to the other side with the rails' friction exchanged and the moment turned is the mirror image, and what
    /// friction takes is what the springs, the drive and the motion along the track give: per wheelset
    /// V ΣQ·ξ = V ΣQ_x − (V/R) s(Q_xR − Q_xL) + ΩT, but for the lateral slip of rails in a curve.
    #[test]
    fn mirror_and_energy(
        radius in 150.0..2000.0_f64, speed in 5.0..25.0_f64, left in 0.15..0.5_f64, right in 0.15..0.5_f64,
        moment in -5e3..5e3_f64, torque in -1e3..1e3_f64,
    ) {
        let curve = Curve { radius, cant: 0.05, speed };
        prop_assume!(curve.uncompensated_acceleration(1.5) < 1.5);
        let one = VehicleInCurve {
            curve,
            axle: axle(),
            running_gear: bogie(moment),
            drive_torque: vec![torque, 0.0],
            kinematics: tilted(false),
            creep: [creep(left), creep(right)],
        };
        let other = VehicleInCurve {
            curve: Curve { radius: -radius, ..curve },
            running_gear: bogie(-moment),
            creep: [creep(right), creep(left)],
            ..one.clone()
        };
        let (one, other) = (one.equilibrium().unwrap(), other.equilibrium().unwrap());
        for (one, other) in one.wheelsets.iter().zip(&other.wheelsets) {
            prop_assert!((one.lateral_shift + other.lateral_shift).abs() < 1e-10);
            prop_assert!((one.yaw + other.yaw).abs() < 1e-10);
        }
        for (index, wheel) in one.wheels.iter().enumerate() {
            let mirrored = &other.wheels[index ^ 1];
            prop_assert!((wheel.normal_force - mirrored.normal_force).abs() < 1e-4);
        }
        for (index, wheelset) in one.wheelsets.iter().enumerate() {
            let [left, right] = [&one.wheels[2 * index], &one.wheels[2 * index + 1]];
            let along = left.creep_forces.longitudinal + right.creep_forces.longitudinal;
            let turning = 0.75 * (right.creep_forces.longitudinal - left.creep_forces.longitudinal);
            let turn = wheelset.rotation_ratio * speed / 0.46;
            let drive = if index == 0 { turn * torque } else { 0.0 };
            let given = speed * along - speed / radius * turning + drive;
            let taken = speed * (left.t_gamma + right.t_gamma);
            // Rounding of forces of 50 kN at 25 m/s, and the equilibrium's of 1e-12.
            prop_assert!((given - taken).abs() < 1e-4, "{given} {taken}");
        }
    }
}
