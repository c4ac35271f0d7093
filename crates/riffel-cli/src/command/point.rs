//! `riffel point`

use riffel::LoopState;
use riffel_answers::for_whom;
use riffel_answers::point::{IrregularSupportsDocument, NeighboursDocument, PointAnswer, PointRequest};
use riffel_case::{Case, CaseKey, DrawnSupports, Point, Sensitivity};
use riffel_keys::quantity::{Kind, Length, Speed};

use crate::arguments::{Point as Arguments, covering, positive};
use crate::error::CliError;
use crate::messages::{language, print_remarks};
use crate::output::{print, print_json, table};

pub(crate) fn run(arguments: &Arguments) -> miette::Result<()> {
    let case = arguments.case.read_at(arguments.position)?;
    let wavelength = arguments.wavelength.within("--wavelength")?;
    let speed = arguments.speed.within("--speed")?;
    case.check_points([wavelength; 2], [speed; 2])?;
    let case = covering(&case, wavelength, wavelength)?;
    let request = PointRequest {
        wavelength,
        speed,
        sensitivity: arguments.sensitivity,
        neighbours: arguments.neighbours,
        irregular: arguments
            .spacing_deviation
            .map(|deviation| -> Result<_, CliError> {
                Ok(DrawnSupports {
                    deviation: positive("--spacing-deviation", deviation)?,
                    supports: arguments.supports.unwrap_or(DrawnSupports::USUAL_SUPPORTS),
                    seed: arguments.seed.unwrap_or(1),
                })
            })
            .transpose()?,
    };
    let answer = PointAnswer::new(&case, request)?;
    if arguments.json {
        print_json(&answer)?;
    } else {
        let unlikely = answer.wear_limit.unlikely_wear.iter();
        let unlikely: String = unlikely.map(|it| it.text(language()) + "\n").collect();
        print(&(unlikely + &readable(&case, &answer)))?;
        if let Some(growth) = &answer.with_neighbours {
            print(&with_neighbours(growth))?;
        }
        if let Some(growth) = &answer.irregular_supports {
            print(&on_irregular_supports(growth))?;
        }
        if let Some(sensitivity) = &answer.sensitivity {
            print(&sensitivities(sensitivity))?;
        }
    }
    print_remarks(answer.reported_growth.as_slice());
    print_remarks(&case.remarks_at_point(wavelength, speed));
    Ok(())
}

/// Growth of the wave with its neighbours.
fn with_neighbours(growth: &NeighboursDocument) -> String {
    let mut table = table(&["wavelength mm", "share of the pattern", "phase"]);
    for (wavelength, [re, im]) in growth.wavelengths_m.iter().zip(&growth.pattern) {
        table.add_row([
            format!("{:.2}", 1e3 * wavelength),
            format!("{:.3}", re.hypot(*im)),
            format!("{:.0}°", im.atan2(*re).to_degrees()),
        ]);
    }
    format!(
        "\nwith the supports passing, growth rate per passage: {:.3e} of the wave alone, {:.3e} of the pattern that grows \
         fastest\n{table}\nthe pattern is highest {:.0} mm from a support, {:.2} times its least\n",
        growth.growth_rate_alone,
        growth.growth_rate_of_pattern,
        1e3 * growth.highest_at_m,
        growth.modulation,
    )
}

/// Growth along drawn supports beside equal ones.
fn on_irregular_supports(growth: &IrregularSupportsDocument) -> String {
    let mut table = table(&["growth rate per passage", "mean", "least", "tenth", "nine tenths", "largest"]);
    for (name, spread) in [("equal distances", &growth.even), ("drawn", &growth.along)] {
        let values = [spread.mean, spread.least, spread.tenth, spread.nine_tenths, spread.largest];
        let cells = values.map(|value| format!("{value:.3e}"));
        table.add_row(std::iter::once(name.to_owned()).chain(cells));
    }
    format!(
        "\n{} supports at distances that scatter by {:.1} mm, seed {}\n{table}\n",
        growth.support_position_m.len(),
        1e3 * growth.spacing_deviation_m,
        growth.seed,
    )
}

/// What the growth rate answers to, the strongest first.
fn sensitivities(all: &[Sensitivity]) -> String {
    let mut table = table(&["parameter", "value", "unit", "growth for +1 %"]);
    for sensitivity in all {
        let kind = match sensitivity.key.as_str() {
            "wavelength" => Some(Kind::of::<Length>()),
            "speed" => Some(Kind::of::<Speed>()),
            key => CaseKey::find(key).and_then(|key| key.quantity),
        };
        let (value, unit) =
            kind.map_or((sensitivity.value, sensitivity.unit), |kind| kind.in_engineers_unit(sensitivity.value));
        table.add_row([
            sensitivity.key.clone(),
            short(value),
            unit.to_owned(),
            format!("{:+.3} %", sensitivity.elasticity),
        ]);
    }
    format!("{table}\n")
}

/// A number to five digits, with an exponent where it is far from one.
fn short(value: f64) -> String {
    let scientific = format!("{value:.4e}");
    let rounded: f64 = scientific.parse().unwrap_or(value);
    if (1e-4..1e6).contains(&rounded.abs()) { rounded.to_string() } else { format!("{rounded:e}") }
}

/// Amplitudes and phases in engineers' units.
fn readable(case: &Case, answer: &PointAnswer) -> String {
    let state = &answer.state;
    let mut table = table(&["oscillation for exp(+iωt)", "amplitude", "unit", "phase"]);
    let w = state.angular_frequency;
    let [_, wheel] = case.feedback.normal_receptances(w, state.speed);
    let mut rows = vec![
        ("receptance of the rail", state.normal_receptance() * 1e9, "nm/N"),
        ("receptance of the wheel", wheel * 1e9, "nm/N"),
        ("normal force P₁", state.normal_force() * 1e-3, "kN"),
        ("tangential force Q₁", state.tangential_force(), "N"),
    ];
    if case.feedback.is_along_one_axis() {
        let angular_velocity = -state.slip() * state.speed / case.hertz.rolling_radius();
        rows.push(("angular velocity Ω₁", angular_velocity * 1e3, "mrad/s"));
    } else {
        rows.push(("lateral force", state.contacts[0].force[1], "N"));
    }
    rows.extend([
        ("dissipation at the wheel W₁", state.dissipation, "W"),
        ("dissipation at the rail", state.dissipation_at_rail, "W"),
        ("normalised, Ŵ₁", state.normalized_dissipation, "-"),
    ]);
    for (name, value, unit) in rows {
        table.add_row([
            name.to_owned(),
            format!("{:.4}", value.norm()),
            unit.to_owned(),
            format!("{:.1}°", value.arg().to_degrees()),
        ]);
    }
    let rate = state.growth_rate;
    let verdict = if answer.oscillates() {
        "the loop oscillates by itself, and the rate means nothing".to_owned()
    } else if rate > 0.0 {
        format!("grows: doubles in {:.2e} passages", std::f64::consts::LN_2 / rate)
    } else if rate == 0.0 {
        "neither grows nor decays".to_owned()
    } else {
        format!("decays: halves in {:.2e} passages", std::f64::consts::LN_2 / -rate)
    };
    let full_slip = case
        .law
        .as_ref()
        .and_then(|law| law.own_slope())
        .map(|slope| format!(" (full slip from {:.4} %)", 100.0 * slope.saturation_creepage))
        .unwrap_or_default();
    let damage = damage(case, state);
    format!(
        "{}{:.1} mm at {:.1} km/h: {:.1} Hz\n\
         tractive ratio {:.3}, creepage {}{full_slip}, contact {:.2} × {:.2} mm\n\
         {table}\n{}{damage}\
         Re Ŵ₁ = {:.5}, growth rate {rate:.3e} per passage: {verdict}\n{}\n",
        case.file.title.as_ref().map(|title| format!("{title}\n")).unwrap_or_default(),
        1e3 * state.wavelength,
        3.6 * state.speed,
        state.speed / state.wavelength,
        case.steady.tractive_ratio(),
        creepage(case),
        2e3 * case.hertz.semi_axis_longitudinal(),
        2e3 * case.hertz.semi_axis_lateral(),
        contacts(case, state),
        state.normalized_dissipation.re,
        for_whom(case),
    )
}

/// What each law of damage does; nothing where wear is alone.
fn damage(case: &Case, state: &LoopState) -> String {
    let Some(damage) = Point::new(case, state).damage else {
        return String::new();
    };
    let mut table = table(&["law", "growth per passage", "depth per passage nm"]);
    for (law, growth) in &damage.growth_by_law.0 {
        let depths = damage.depth_by_law_m.0.iter();
        let depth = depths.clone().find(|(name, _)| name == law);
        table.add_row([
            (*law).to_owned(),
            format!("{growth:.3e}"),
            depth.map_or_else(String::new, |(_, depth)| format!("{:.3e}", 1e9 * depth)),
        ]);
    }
    let demand = format!(
        "demand {:.3}, largest at {:.0}° after the crest, and at its limit at an amplitude of {:.1} µm",
        damage.demand,
        // Later in time is a lag.
        (-damage.place_deg).rem_euclid(360.0),
        1e6 * damage.amplitude_at_limit_m,
    );
    format!("{table}\n{demand}\n")
}

/// The mean creepage of the contact under study.
fn creepage(case: &Case) -> String {
    let creepages = case.steady.creepages;
    let longitudinal = format!("{:.4} %", 100.0 * creepages.longitudinal);
    if case.feedback.is_along_one_axis() {
        return longitudinal;
    }
    format!("{longitudinal} along and {:.4} % across, spin {:.3} 1/m", 100.0 * creepages.lateral, creepages.spin)
}

/// Every contact of a loop that has several; nothing for one.
fn contacts(case: &Case, state: &LoopState) -> String {
    let points = Point::new(case, state).all_axes.map(|all| all.contacts);
    let points = points.unwrap_or_default();
    if points.len() < 2 {
        return String::new();
    }
    let mut table = table(&["wheel", "rail", "normal force kN", "growth per passage"]);
    for (point, at) in points.iter().zip(&state.contacts) {
        table.add_row([
            point.name.wheel.to_string(),
            point.name.rail.to_owned(),
            format!("{:.4}", 1e-3 * at.force[2].norm()),
            at.growth_rate.map_or_else(|| "smooth".to_owned(), |rate| format!("{rate:.3e}")),
        ]);
    }
    format!("{table}\n")
}
