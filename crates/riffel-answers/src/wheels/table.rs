//! The wheels of a curve as tables.

use riffel::Axis;
use riffel_case::file::{ContactOfWheel, CurveRail};
use riffel_keys::{Message, decimal, say};

use super::{WheelAnswer, WheelsAnswer};
use crate::netcdf::{Grid, Variable};
use crate::number_alone;
use crate::{Rows, Table, growth_lines};

fn rail_in_words(rail: CurveRail) -> Message {
    match rail {
        CurveRail::Low => say!(low),
        _ => say!(high),
    }
}

/// One row for each wheel.
pub(super) fn wheels(answer: &WheelsAnswer) -> Table {
    let wheels = &answer.wheels;
    let digits = |head: Message, digits: usize, of: fn(&WheelAnswer) -> f64| {
        wheels.numbers(head, |wheel| decimal(of(wheel), digits))
    };
    Table {
        name: "wheels",
        columns: vec![
            wheels.names("wheelset", |wheel| wheel.wheelset),
            wheels.names("rail", |wheel| wheel.rail.name()),
            wheels.names("side", |wheel| wheel.side),
            wheels.names("contact", |wheel| wheel.contact.name()),
            wheels.exact("longitudinal_creepage", |wheel| wheel.longitudinal_creepage),
            wheels.exact("lateral_creepage", |wheel| wheel.lateral_creepage),
            wheels.exact("spin_1_per_m", |wheel| wheel.spin_1_per_m),
            wheels.exact("normal_force_n", |wheel| wheel.normal_force_n),
            wheels.exact("contact_angle_rad", |wheel| wheel.contact_angle_rad),
            wheels.exact("tractive_ratio", |wheel| wheel.tractive_ratio),
            wheels.exact("share_of_second_contact", |wheel| wheel.share_of_second_contact),
            wheels.exact("highest_growth_rate_per_passage", |wheel| Some(wheel.highest?.rate)),
            wheels.exact("highest_wavelength_m", |wheel| Some(wheel.highest?.wavelength)),
            wheels.exact("highest_frequency_hz", |wheel| Some(wheel.highest?.frequency)),
            wheels
                .names("not_in_loop", |wheel| wheel.not_in_loop.as_ref().map_or_else(String::new, ToString::to_string)),
            wheels.numbers(say!(wheelset_column), |wheel| wheel.wheelset),
            wheels.shown(say!(rail_column), |wheel| match wheel.contact {
                ContactOfWheel::Tread => rail_in_words(wheel.rail),
                ContactOfWheel::Flange => say!(flange_of_rail, rail = rail_in_words(wheel.rail)),
            }),
            digits(say!(creeps_along_column), 3, |wheel| 100.0 * wheel.longitudinal_creepage),
            digits(say!(creeps_across_column), 3, |wheel| 100.0 * wheel.lateral_creepage),
            digits(say!(spin_column), 3, |wheel| wheel.spin_1_per_m),
            digits(say!(normal_force_column), 1, |wheel| 1e-3 * wheel.normal_force_n),
            digits(say!(contact_angle_column), 1, |wheel| wheel.contact_angle_rad.to_degrees()),
            wheels.shown(say!(highest_growth_column), |wheel| match wheel.highest {
                Some(highest) => number_alone(decimal(1e6 * highest.rate, 2)),
                None if wheel.in_loop.is_some() => say!(no_growth_in_table),
                None => say!(not_in_loop_in_table),
            }),
            wheels.shown(Message::verbatim("mm"), |wheel| match &wheel.highest {
                Some(highest) => highest.millimetres(),
                None => Message::verbatim(""),
            }),
            wheels.shown(Message::verbatim("Hz"), |wheel| match wheel.highest {
                Some(highest) => number_alone(decimal(highest.frequency, 0)),
                None => Message::verbatim(""),
            }),
        ],
    }
}

/// One row for each wavelength under the traffic of the curve, a column for each wheel in the loop.
pub(super) fn growth(answer: &WheelsAnswer) -> Table {
    let wheels = answer.wheels.iter();
    let grown = wheels.filter_map(|wheel| Some((&*wheel.name, wheel.growth_rate_per_passage.as_deref()?)));
    growth_lines::table(&answer.wavelength_m, grown)
}

/// Growth rates of all wheels on the grid of the map, by wheel, speed and wavelength; NaN for a wheel that is not in the loop.
pub(super) fn grid(answer: &WheelsAnswer) -> Grid<'_> {
    let case = &answer.case;
    let (wavelength, speed) = (case.wavelength, case.speed);
    let points = wavelength.points() * speed.points();
    let of_wheels = |value: fn(&WheelAnswer) -> f64| {
        let values: Vec<f64> = answer.wheels.iter().map(value).collect();
        move || values.clone()
    };
    let of_axis = |axis: Axis| move || axis.values();
    let variables = vec![
        Variable::new("wavelength", &["wavelength"], "m", "wavelength of the corrugation", of_axis(wavelength)),
        Variable::new("speed", &["speed"], "m/s", "speed of the vehicle", of_axis(speed)),
        Variable::new("wheelset", &["wheel"], "1", "wheelset, 1 leads", of_wheels(|wheel| wheel.wheelset as f64)),
        Variable::new(
            "high_rail",
            &["wheel"],
            "1",
            "one for the high rail, zero for the low one",
            of_wheels(|wheel| f64::from(wheel.rail == CurveRail::High)),
        ),
        Variable::new(
            "flange",
            &["wheel"],
            "1",
            "one for the flange of a wheel on two points, else zero",
            of_wheels(|wheel| f64::from(wheel.contact == ContactOfWheel::Flange)),
        ),
        Variable::new(
            "growth_rate",
            &["wheel", "speed", "wavelength"],
            "1",
            "growth rate of the amplitude per passage of a wheel",
            move || {
                let wheels = answer.wheels.iter();
                wheels
                    .flat_map(|wheel| match &wheel.in_loop {
                        Some(wheel) => wheel.rates_on_the_grid().collect(),
                        None => vec![f64::NAN; points],
                    })
                    .collect()
            },
        ),
    ];
    let axes = vec![("wheel", answer.wheels.len()), ("speed", speed.points()), ("wavelength", wavelength.points())];
    let title = case.file.title.as_deref();
    Grid { title: title.unwrap_or("Growth under the wheels of a curve").to_owned(), axes, variables }
}
