//! `riffel curve`

use riffel::Rail;
use riffel_answers::curve::CurveAnswer;
use riffel_case::CurvingCase;

use crate::arguments::Curve;
use crate::messages::print_remarks;
use crate::output::{json, table};
use crate::results::Results;

pub(crate) fn run(arguments: &Curve) -> miette::Result<()> {
    let case = arguments.case.read_curving()?;
    let answer = CurveAnswer::new(&case)?;
    let results = Results {
        command: "curve",
        case: &arguments.case,
        output: arguments.output.as_deref(),
        json: arguments.json,
    };
    results.hand_out(
        || json(&answer.document()),
        |staging| {
            let over_radius = answer.over_radius();
            staging.write_figure("curve", &over_radius.figure())?;
            staging.write_with("curve.csv", |file| over_radius.csv(file))
        },
        || readable(&case, &answer),
    )?;
    print_remarks(&case.remarks);
    print_remarks(&answer.remarks);
    Ok(())
}

/// The equilibrium for the terminal.
fn readable(case: &CurvingCase, answer: &CurveAnswer) -> String {
    let state = &answer.state;
    let title = case.file.title.as_deref().unwrap_or("Bogie in a curve");
    let mut text = format!(
        "{title}\nuncompensated acceleration {:.2} m/s2, frictional power {:.0} W\n",
        state.uncompensated_acceleration, state.frictional_power
    );
    let mut wheelsets = table(&["wheelset", "shift mm", "yaw mrad", "angle of attack mrad"]);
    for (index, wheelset) in state.wheelsets.iter().enumerate() {
        wheelsets.add_row([
            (index + 1).to_string(),
            format!("{:.3}", 1e3 * wheelset.lateral_shift),
            format!("{:.3}", 1e3 * wheelset.yaw),
            format!("{:.3}", 1e3 * wheelset.angle_of_attack),
        ]);
    }
    let head = [
        "wheel",
        "creepage along %",
        "across %",
        "spin 1/m",
        "angle deg",
        "P kN",
        "Qx kN",
        "Qy kN",
        "|Q|/μP",
        "Tγ N",
    ];
    let mut wheels = table(&head);
    for wheel in &state.wheels {
        let rail = rail_name(wheel.rail);
        let creepages = wheel.creepages;
        wheels.add_row([
            format!("{} {rail}", wheel.wheelset),
            format!("{:.4}", 100.0 * creepages.longitudinal),
            format!("{:.4}", 100.0 * creepages.lateral),
            format!("{:.3}", creepages.spin),
            format!("{:.1}", wheel.contact_angle.to_degrees()),
            format!("{:.1}", 1e-3 * wheel.normal_force),
            format!("{:.2}", 1e-3 * wheel.creep_forces.longitudinal),
            format!("{:.2}", 1e-3 * wheel.creep_forces.lateral),
            format!("{:.3}", wheel.tractive_ratio),
            format!("{:.1}", wheel.t_gamma),
        ]);
    }
    text += &format!(
        "{wheelsets}\n{wheels}\nlargest residual {:.0e} of the load of a wheel",
        state.residual
    );
    text += &match state.continuation.len() {
        0 => "; straight track does not lead here, other starts do\n".to_owned(),
        steps => format!(", in {steps} steps from straight track\n"),
    };
    for wheel in state.wheels.iter().filter(|wheel| wheel.on_two_points) {
        let rail = rail_name(wheel.rail);
        text += &format!(
            "wheelset {} stands on two points of the {rail} wheel: one contact between them stands for both\n",
            wheel.wheelset
        );
    }
    text += &match &answer.others[..] {
        [] => "no other equilibrium found\n".to_owned(),
        others => {
            let shifts = others.iter().map(|other| {
                let [first, second] = other.wheelsets.map(|wheelset| 1e3 * wheelset.lateral_shift);
                format!("{first:.3} and {second:.3} mm")
            });
            let shifts: Vec<String> = shifts.collect();
            format!(
                "other equilibria, wheelsets shifted by {}\n",
                shifts.join("; ")
            )
        }
    };
    text
}

fn rail_name(rail: Rail) -> &'static str {
    match rail {
        Rail::Left => "left",
        Rail::Right => "right",
    }
}
