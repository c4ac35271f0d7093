//! The wheels of a curve as tables.

use riffel::Axis;
use riffel_case::file::{ContactOfWheel, CurveRail};
use riffel_keys::{Message, decimal, say};

use super::{WheelAnswer, WheelsAnswer};
use crate::netcdf::{Grid, Variable};
use crate::number_alone;
use crate::{Column, Table, growth_lines};

fn rail_in_words(rail: CurveRail) -> Message {
    match rail {
        CurveRail::Low => say!(low),
        _ => say!(high),
    }
}

/// One row for each wheel.
pub(super) fn wheels(answer: &WheelsAnswer) -> Table {
    let wheels = || answer.wheels.iter();
    let shown =
        |head: Message, words: &dyn Fn(&WheelAnswer) -> Message| Column::shown(head, wheels().map(words).collect());
    let digits = |head: Message, digits: usize, of: fn(&WheelAnswer) -> f64| {
        shown(head, &|wheel| number_alone(decimal(of(wheel), digits)))
    };
    let number = |name: &str, of: fn(&WheelAnswer) -> f64| Column::exact(name, wheels().map(of));
    let highest = |name: &str, of: fn(&WheelAnswer) -> Option<f64>| Column::exact(name, wheels().map(of));
    Table {
        name: "wheels",
        columns: vec![
            Column::names("wheelset", wheels().map(|wheel| wheel.wheelset)),
            Column::names("rail", wheels().map(|wheel| wheel.rail.name())),
            Column::names("side", wheels().map(|wheel| wheel.side)),
            Column::names("contact", wheels().map(|wheel| wheel.contact.name())),
            number("longitudinal_creepage", |wheel| wheel.longitudinal_creepage),
            number("lateral_creepage", |wheel| wheel.lateral_creepage),
            number("spin_1_per_m", |wheel| wheel.spin_1_per_m),
            number("normal_force_n", |wheel| wheel.normal_force_n),
            number("contact_angle_rad", |wheel| wheel.contact_angle_rad),
            number("tractive_ratio", |wheel| wheel.tractive_ratio),
            number("share_of_second_contact", |wheel| wheel.share_of_second_contact),
            highest("highest_growth_rate_per_passage", |wheel| Some(wheel.highest?.rate)),
            highest("highest_wavelength_m", |wheel| Some(wheel.highest?.wavelength)),
            highest("highest_frequency_hz", |wheel| Some(wheel.highest?.frequency)),
            Column::names(
                "not_in_loop",
                wheels().map(|wheel| wheel.not_in_loop.as_ref().map_or_else(String::new, ToString::to_string)),
            ),
            shown(say!(wheelset_column), &|wheel| number_alone(wheel.wheelset)),
            shown(say!(rail_column), &|wheel| match wheel.contact {
                ContactOfWheel::Tread => rail_in_words(wheel.rail),
                ContactOfWheel::Flange => say!(flange_of_rail, rail = rail_in_words(wheel.rail)),
            }),
            digits(say!(creeps_along_column), 3, |wheel| 100.0 * wheel.longitudinal_creepage),
            digits(say!(creeps_across_column), 3, |wheel| 100.0 * wheel.lateral_creepage),
            digits(say!(spin_column), 3, |wheel| wheel.spin_1_per_m),
            digits(say!(normal_force_column), 1, |wheel| 1e-3 * wheel.normal_force_n),
            digits(say!(contact_angle_column), 1, |wheel| wheel.contact_angle_rad.to_degrees()),
            shown(say!(highest_growth_column), &|wheel| match wheel.highest {
                Some(highest) => number_alone(decimal(1e6 * highest.rate, 2)),
                None if wheel.in_loop.is_some() => say!(no_growth_in_table),
                None => say!(not_in_loop_in_table),
            }),
            shown(Message::verbatim("mm"), &|wheel| match &wheel.highest {
                Some(highest) => highest.millimetres(),
                None => Message::verbatim(""),
            }),
            shown(Message::verbatim("Hz"), &|wheel| match wheel.highest {
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
        Box::new(move || values.clone())
    };
    let of_axis = |axis: Axis| Box::new(move || axis.values());
    let variables = vec![
        Variable {
            name: "wavelength",
            axes: &["wavelength"],
            unit: "m",
            long_name: "wavelength of the corrugation",
            values: of_axis(wavelength),
        },
        Variable {
            name: "speed",
            axes: &["speed"],
            unit: "m/s",
            long_name: "speed of the vehicle",
            values: of_axis(speed),
        },
        Variable {
            name: "wheelset",
            axes: &["wheel"],
            unit: "1",
            long_name: "wheelset, 1 leads",
            values: of_wheels(|wheel| wheel.wheelset as f64),
        },
        Variable {
            name: "high_rail",
            axes: &["wheel"],
            unit: "1",
            long_name: "one for the high rail, zero for the low one",
            values: of_wheels(|wheel| f64::from(wheel.rail == CurveRail::High)),
        },
        Variable {
            name: "flange",
            axes: &["wheel"],
            unit: "1",
            long_name: "one for the flange of a wheel on two points, else zero",
            values: of_wheels(|wheel| f64::from(wheel.contact == ContactOfWheel::Flange)),
        },
        Variable {
            name: "growth_rate",
            axes: &["wheel", "speed", "wavelength"],
            unit: "1",
            long_name: "growth rate of the amplitude per passage of a wheel",
            values: Box::new(move || {
                let wheels = answer.wheels.iter();
                wheels
                    .flat_map(|wheel| match &wheel.in_loop {
                        Some(wheel) => wheel.rates_on_the_grid().collect(),
                        None => vec![f64::NAN; points],
                    })
                    .collect()
            }),
        },
    ];
    let axes = vec![("wheel", answer.wheels.len()), ("speed", speed.points()), ("wavelength", wavelength.points())];
    let title = case.file.title.as_deref();
    Grid { title: title.unwrap_or("Growth under the wheels of a curve").to_owned(), axes, variables }
}
