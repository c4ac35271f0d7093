//! Limits of a lone wheelset and of a vehicle on two bogies.

use riffel::contact::CreepEllipse;

use super::tests::{axle, bogie, creep, tilted};
use super::*;

fn frame(yaw_moment: f64) -> BogieFrame {
    BogieFrame { wheelbase: 2.5, yaw_moment }
}

fn vehicle(radius: f64, secondary_yaw_stiffness: f64, yaw_moment: f64) -> VehicleInCurve {
    VehicleInCurve {
        curve: Curve { radius, cant: 0.05, speed: (0.7 * radius.abs()).sqrt() },
        axle: axle(),
        running_gear: RunningGear::Vehicle {
            bogies: frame(yaw_moment),
            body: Body { bogie_spacing: 15.0, mass: 30e3, secondary_lateral_stiffness: 0.4e6, secondary_yaw_stiffness },
        },
        drive_torque: vec![0.0; 4],
        kinematics: tilted(false),
        creep: [creep(0.4), creep(0.3)],
    }
}

fn linear(spin_creep_coefficient: f64) -> Creep {
    Creep::Linear {
        ellipse: CreepEllipse::of_coefficients(10e6, 9e6, spin_creep_coefficient, 54e3).unwrap(),
        friction: 0.4,
    }
}

/// The linear wheelset of the closed form, all its mass in the wheelset so that frames carry no force.
fn lone(frame: FollowingFrame, longitudinal_stiffness: f64) -> VehicleInCurve {
    VehicleInCurve {
        curve: Curve { radius: -700.0, cant: 0.02, speed: 25.0 },
        axle: Axle {
            primary_longitudinal_stiffness: longitudinal_stiffness,
            wheelset_mass: axle().mass_per_axle,
            ..axle()
        },
        running_gear: RunningGear::Wheelset(frame),
        drive_torque: vec![0.0],
        kinematics: Kinematics::Linear { conicity: 0.12 },
        creep: [linear(22e3), linear(22e3)],
    }
}

/// A lone wheelset is that of the closed form: held across the track, and free across it.
#[test]
fn a_lone_wheelset_is_that_of_the_closed_form() {
    for held_at in [None, Some(0.0)] {
        let frame = FollowingFrame { yaw: -2e-3, held_at };
        let wheelset = lone(frame, 2e6);
        let state = wheelset.equilibrium().unwrap();
        let expected = LinearWheelset {
            rolling_radius: 0.46,
            contact_spacing: 1.5,
            conicity: 0.12,
            radius: -700.0,
            longitudinal_creep_coefficient: 10e6,
            lateral_creep_coefficient: 9e6,
            spin_creep_coefficient: 22e3,
            lateral_stiffness: held_at.map_or(0.0, |_| wheelset.axle.lateral_stiffness()),
            yaw_stiffness: wheelset.axle.yaw_stiffness(),
            lateral_force: wheelset.axle.mass_per_axle * wheelset.curve.uncompensated_acceleration(1.5),
            frame_yaw: -2e-3,
        }
        .equilibrium();
        let got = &state.wheelsets[0];
        // Rounding of creepages of 1e-4 beside rotation, over a shift and a yaw of some 1e-3.
        assert!((got.lateral_shift - expected.lateral_shift).abs() < 1e-12 * 5e-3);
        assert!((got.yaw - expected.yaw).abs() < 1e-12 * 5e-3);
        assert_eq!((state.wheels.len(), state.frames.len()), (2, 1));
    }
}

/// Balanced by cant, without spin and springs: y = −r₀s/(λR), its axle radial. The springs' share is 1e-9.
#[test]
fn a_free_wheelset_rolls_without_creepage() {
    let spacing = axle().contact_spacing;
    let mut free = lone(FollowingFrame::default(), 0.01);
    free.curve.cant = spacing * (25.0_f64 * 25.0 / (GRAVITY * 700.0)).atan().sin();
    free.creep = [linear(0.0), linear(0.0)];
    let state = free.equilibrium().unwrap();
    let expected = free_curving_shift(0.46, spacing, 0.12, -700.0);
    assert!((state.wheelsets[0].lateral_shift / expected - 1.0).abs() < 1e-7);
    assert!(state.wheelsets[0].yaw.abs() < 1e-9);
}

/// A frame that is free across the track leaves its inertial force to the wheelset, one that is held does not, and lies then
/// where it is held.
#[test]
fn a_held_frame_takes_what_it_carries() {
    let force = |held_at| {
        let mut wheelset = lone(FollowingFrame { yaw: 0.0, held_at }, 2e6);
        wheelset.axle.wheelset_mass = 1400.0;
        let state = wheelset.equilibrium().unwrap();
        let to_rails: f64 = state.wheels.iter().map(WheelState::whole_track_lateral_force).sum();
        (state, to_rails)
    };
    let acceleration = lone(FollowingFrame::default(), 2e6).curve.uncompensated_acceleration(1.5);
    let (state, to_rails) = force(None);
    // To the left the outside is to the right.
    assert!((to_rails - 11_000.0 * acceleration).abs() < 1e-6);
    let wheelset = &state.wheelsets[0];
    assert!((wheelset.suspension_lateral_force - 9600.0 * acceleration).abs() < 1e-6);
    let (state, to_rails) = force(Some(1e-3));
    let wheelset = &state.wheelsets[0];
    let spring = -10e6 * (wheelset.lateral_shift - 1e-3);
    assert!((to_rails - 1400.0 * acceleration - spring).abs() < 1e-6);
    assert_eq!(state.frames[0].lateral_shift, 1e-3);
}

/// Without secondary yaw stiffness each bogie is alone, whatever stiffness across the track and mass of the body.
#[test]
fn a_body_that_turns_freely_leaves_two_lone_bogies() {
    for (lateral_stiffness, mass) in [(1.0, 30e3), (0.4e6, 30e3), (1e9, 1.0)] {
        let mut both = vehicle(250.0, 0.0, 1.5e3);
        let RunningGear::Vehicle { body, .. } = &mut both.running_gear else { unreachable!() };
        (body.secondary_lateral_stiffness, body.mass) = (lateral_stiffness, mass);
        let alone = VehicleInCurve { running_gear: bogie(1.5e3), drive_torque: vec![0.0; 2], ..both.clone() };
        let (both, alone) = (both.equilibrium().unwrap(), alone.equilibrium().unwrap());
        for (index, wheel) in both.wheels.iter().enumerate() {
            let lone = &alone.wheels[index % 4];
            // The residuals of both, 1e-10 of the load of a wheel at most.
            assert!((wheel.normal_force - lone.normal_force).abs() < 1e-9 * 54e3);
            let (one, other) = (wheel.creep_forces, lone.creep_forces);
            assert!((one.lateral - other.lateral).abs() < 1e-9 * 54e3);
            assert!((one.longitudinal - other.longitudinal).abs() < 1e-9 * 54e3);
        }
    }
    // A soft one hardly differs from none.
    let [soft, none] = [10.0, 0.0].map(|stiffness| vehicle(250.0, stiffness, 0.0));
    let (soft, none) = (soft.equilibrium().unwrap(), none.equilibrium().unwrap());
    let difference = soft.wheelsets[0].yaw - none.wheelsets[0].yaw;
    assert!(difference != 0.0 && difference.abs() < 1e-8);
}

/// Stiffness against yaw turns the leading bogie out of the curve and the trailing one into it by equal and opposite moments
/// of nearly K l/R: the leading wheelset has a larger angle of attack and guiding force, that of the trailing bogie a smaller one.
#[test]
fn stiffness_against_yaw_turns_the_bogies() {
    let radius = 300.0;
    let (soft, stiff) =
        (vehicle(radius, 0.0, 0.0).equilibrium().unwrap(), vehicle(radius, 0.3e6, 0.0).equilibrium().unwrap());
    let attack = |state: &VehicleState, wheelset: usize| state.wheelsets[wheelset].angle_of_attack;
    assert!(attack(&stiff, 0) > attack(&soft, 0));
    assert!(attack(&stiff, 2) < attack(&soft, 2));
    let guiding = |state: &VehicleState, wheelset: usize| -state.wheels[2 * wheelset].whole_track_lateral_force();
    assert!(guiding(&stiff, 0) > guiding(&soft, 0) && guiding(&stiff, 2) < guiding(&soft, 2));
    let moments = [0, 1].map(|frame| stiff.frames[frame].secondary_yaw_moment);
    // But for the yaw of the frames, some mrad beside l/R of 25 mrad.
    let rigid = 0.3e6 * 7.5 / radius;
    assert!(moments[0] < -0.7 * rigid && moments[0] > -1.3 * rigid, "{moments:?}");
    // The body is in equilibrium.
    let forces = [0, 1].map(|frame| stiff.frames[frame].secondary_lateral_force);
    let body = stiff.body.unwrap();
    assert!((forces[0] + forces[1] - body.inertial_lateral_force).abs() < 1e-6);
    assert!((moments[0] + moments[1] + 7.5 * (forces[0] - forces[1])).abs() < 1e-6);
}

/// A curve to the other side with the rails exchanged is the mirror image, and friction takes what forces and torques give.
#[test]
fn vehicles_have_mirror_images_and_lose_no_energy() {
    let mut one = vehicle(220.0, 0.5e6, 2e3);
    one.drive_torque = vec![800.0, 0.0, 300.0, -200.0];
    let mut other = vehicle(-220.0, 0.5e6, -2e3);
    other.creep.swap(0, 1);
    other.drive_torque = one.drive_torque.clone();
    let speed = one.curve.speed;
    let (one, other) = (one.equilibrium().unwrap(), other.equilibrium().unwrap());
    for (one, other) in one.wheelsets.iter().zip(&other.wheelsets) {
        assert!((one.lateral_shift + other.lateral_shift).abs() < 1e-10);
        assert!((one.yaw + other.yaw).abs() < 1e-10);
    }
    let mut given = one.drive_power;
    for pair in one.wheels.chunks_exact(2) {
        let [left, right] = [pair[0], pair[1]].map(|wheel| wheel.creep_forces.longitudinal);
        given += speed * (left + right) - speed / 220.0 * 0.75 * (right - left);
    }
    // Rounding and residuals of forces of 50 kN at 12 m/s.
    assert!((given - one.frictional_power).abs() < 1e-3);
    assert_eq!((one.wheels.len(), one.frames.len()), (8, 2));
}

/// What cannot be is refused.
#[test]
fn impossible_vehicles_are_refused() {
    let with = |change: fn(&mut VehicleInCurve)| {
        let mut vehicle = vehicle(300.0, 0.3e6, 0.0);
        change(&mut vehicle);
        vehicle.equilibrium().unwrap_err().to_string()
    };
    assert!(with(|vehicle| vehicle.drive_torque.truncate(2)).contains("number of drive torques"));
    let heavy = with(|vehicle| {
        if let RunningGear::Vehicle { body, .. } = &mut vehicle.running_gear {
            body.mass = 50e3;
        }
    });
    assert!(heavy.contains("mass of the body"), "{heavy}");
}
