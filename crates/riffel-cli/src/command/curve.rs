//! `riffel curve`

use riffel::contact::{CreepForces, Creepages};
use riffel::curving::VehicleState;
use riffel_answers::curve::CurveAnswer;
use riffel_case::CurvingCase;

use crate::arguments::Curve;
use crate::error::CliError;
use crate::messages::print_remarks;
use crate::output::{Table, json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Curve) -> miette::Result<()> {
    let case = arguments.case.read_curving()?;
    let radii = radii(arguments, &case)?;
    let answer = CurveAnswer::new(&case)?;
    let results = Results::of("curve", &arguments.case, &arguments.results);
    results.hand_out(
        || json(&answer.document(radii.as_deref())),
        |staging| {
            let over_radius = answer.over_radius(radii.as_deref());
            staging.write_figure("curve", &over_radius.figure())?;
            staging.write_with("curve.csv", |file| over_radius.csv(file))
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks);
    print_remarks(&answer.remarks);
    Ok(())
}

/// The radii that are listed \[m\]; none where none are.
fn radii(arguments: &Curve, case: &CurvingCase) -> miette::Result<Option<Vec<f64>>> {
    let listed: Vec<f64> = arguments.radius.iter().map(|radius| radius.length.si()).collect();
    let bare = arguments.radius.iter().find(|radius| radius.is_bare);
    let with_unit = arguments.radius.iter().find(|radius| !radius.is_bare);
    if let (Some(bare), Some(_)) = (bare, with_unit) {
        Err(CliError::Argument {
            argument: "--radius",
            value: format!("{} without a unit beside others with one", bare.length.si()),
            rule: "a list whose items all have a unit or none; commas part the items, so that 3,800 m are two"
                .to_owned(),
        })?;
    }
    if let Some((radius, rule)) = case.radius_that_no_curve_has(&listed) {
        Err(CliError::Argument { argument: "--radius", value: format!("{radius} m"), rule })?;
    }
    Ok((!listed.is_empty()).then_some(listed))
}

/// The equilibrium for the terminal.
fn readable(case: &CurvingCase, answer: &CurveAnswer) -> String {
    let state = &answer.state;
    let usual = match state.wheelsets.len() {
        1 => "Wheelset in a curve",
        2 => "Bogie in a curve",
        _ => "Vehicle in a curve",
    };
    let title = case.file.title.as_deref().unwrap_or(usual);
    let mut text = format!(
        "{title}\nuncompensated acceleration {:.2} m/s2, frictional power {:.0} W\n",
        state.uncompensated_acceleration, state.frictional_power
    );
    text += &format!(
        "{}\n{}\nlargest residual {:.0e} of the load of a wheel",
        wheelsets(state),
        wheels(state),
        state.residual
    );
    text += &match state.continuation.len() {
        0 => "; straight track does not lead here, other starts do\n".to_owned(),
        steps => format!(", in {steps} steps from straight track\n"),
    };
    for wheel in &state.wheels {
        if let Some(second) = &wheel.second_contact {
            let rail = wheel.rail.name();
            let share = 100.0 * second.normal_force / (wheel.normal_force + second.normal_force);
            text += &format!(
                "wheelset {} stands on two points of the {rail} wheel, {share:.0} % of their normal forces on the second\n",
                wheel.wheelset
            );
        }
    }
    text += &others(&answer.others);
    text
}

/// Shift and yaw of each wheelset.
fn wheelsets(state: &VehicleState) -> Table {
    let mut rows = table(&["wheelset", "shift mm", "yaw mrad", "angle of attack mrad"]);
    for (index, wheelset) in state.wheelsets.iter().enumerate() {
        rows.add_row([
            (index + 1).to_string(),
            format!("{:.3}", 1e3 * wheelset.lateral_shift),
            format!("{:.3}", 1e3 * wheelset.yaw),
            format!("{:.3}", 1e3 * wheelset.angle_of_attack),
        ]);
    }
    rows
}

/// Creepages and forces of each wheel, and of its second contact.
fn wheels(state: &VehicleState) -> Table {
    let head =
        ["wheel", "creepage along %", "across %", "spin 1/m", "angle deg", "P kN", "Qx kN", "Qy kN", "|Q|/μP", "Tγ N"];
    let mut rows = table(&head);
    let mut row =
        |wheel: String, creepages: Creepages, angle: f64, force: f64, creep: CreepForces, shares: [f64; 2]| {
            rows.add_row([
                wheel,
                format!("{:.4}", 100.0 * creepages.longitudinal),
                format!("{:.4}", 100.0 * creepages.lateral),
                format!("{:.3}", creepages.spin),
                format!("{:.1}", angle.to_degrees()),
                format!("{:.1}", 1e-3 * force),
                format!("{:.2}", 1e-3 * creep.longitudinal),
                format!("{:.2}", 1e-3 * creep.lateral),
                format!("{:.3}", shares[0]),
                format!("{:.1}", shares[1]),
            ]);
        };
    for wheel in &state.wheels {
        let name = format!("{} {}", wheel.wheelset, wheel.rail.name());
        let shares = [wheel.tractive_ratio, wheel.t_gamma];
        row(name.clone(), wheel.creepages, wheel.contact_angle, wheel.normal_force, wheel.creep_forces, shares);
        if let Some(second) = &wheel.second_contact {
            let shares = [second.tractive_ratio, second.t_gamma];
            let name = format!("{name}, second");
            row(name, second.creepages, second.contact_angle, second.normal_force, second.creep_forces, shares);
        }
    }
    rows
}

/// Equilibria beside the one that straight track leads to.
fn others(others: &[VehicleState]) -> String {
    if others.is_empty() {
        return "no other equilibrium found\n".to_owned();
    }
    let shifts = others.iter().map(|other| {
        let wheelsets = other.wheelsets.iter();
        let shifts = wheelsets.map(|wheelset| format!("{:.3}", 1e3 * wheelset.lateral_shift));
        format!("{} mm", shifts.collect::<Vec<_>>().join(" and "))
    });
    let shifts: Vec<String> = shifts.collect();
    format!("other equilibria, wheelsets shifted by {}\n", shifts.join("; "))
}
