//! The wheels of a curve as tables.

use std::io::{self, Write};
use std::path::Path;

use riffel::Axis;
use riffel_case::Case;
use riffel_case::file::{ContactOfWheel, CurveRail};

use super::{WheelAnswer, WheelsAnswer};
use crate::netcdf::{Variable, write_netcdf};
use crate::{AnswerError, column};

pub(super) fn words(answer: &WheelsAnswer) -> (Vec<&'static str>, Vec<Vec<String>>) {
    let heading = vec![
        "wheelset",
        "rail",
        "along %",
        "across %",
        "spin 1/m",
        "normal kN",
        "angle deg",
        "highest 10⁻⁶ per passage",
        "mm",
        "Hz",
    ];
    let rows = answer.wheels.iter().map(|wheel| {
        let state = &wheel.state;
        let mut row = vec![
            state.wheelset.to_string(),
            match wheel.contact {
                ContactOfWheel::Tread => wheel.rail.name().to_owned(),
                ContactOfWheel::Flange => format!("{}, flange", wheel.rail.name()),
            },
            format!("{:.3}", 100.0 * state.creepages.longitudinal),
            format!("{:.3}", 100.0 * state.creepages.lateral),
            format!("{:.3}", state.creepages.spin),
            format!("{:.1}", 1e-3 * state.normal_force),
            format!("{:.1}", state.contact_angle.to_degrees()),
        ];
        match &wheel.growth {
            Err(_) => row.push("not in the loop".to_owned()),
            Ok(growth) => match growth.highest {
                None => row.push("no growth".to_owned()),
                Some(highest) => row.extend([
                    format!("{:.2}", 1e6 * highest.rate),
                    format!(
                        "{:.1}{}",
                        1e3 * highest.wavelength,
                        if highest.at_edge { " (edge)" } else { "" }
                    ),
                    format!("{:.0}", highest.frequency),
                ]),
            },
        }
        row
    });
    (heading, rows.collect())
}

pub(super) fn sentence(answer: &WheelsAnswer) -> String {
    let under = answer.under();
    let Some((wheel, highest)) = answer.fastest() else {
        return format!("{under} corrugation grows under no wheel");
    };
    let (rate, mm) = (highest.rate, 1e3 * highest.wavelength);
    format!(
        "{under} it grows fastest at {}: {rate:.2e} per passage at {mm:.0} mm, {:.0} Hz",
        wheel.name, highest.frequency
    )
}

pub(super) fn wheels(answer: &WheelsAnswer, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    writer.write_record([
        "wheelset",
        "rail",
        "side",
        "contact",
        "longitudinal_creepage",
        "lateral_creepage",
        "spin_1_per_m",
        "normal_force_n",
        "contact_angle_rad",
        "tractive_ratio",
        "share_of_second_contact",
        "highest_growth_rate_per_passage",
        "highest_wavelength_m",
        "highest_frequency_hz",
        "not_in_loop",
    ])?;
    for wheel in &answer.wheels {
        let WheelAnswer { state, growth, .. } = wheel;
        let highest = growth.as_ref().ok().and_then(|growth| growth.highest);
        writer.serialize((
            state.wheelset,
            wheel.rail.name(),
            state.rail.name(),
            wheel.contact.name(),
            state.creepages.longitudinal,
            state.creepages.lateral,
            state.creepages.spin,
            state.normal_force,
            state.contact_angle,
            state.tractive_ratio,
            state.share_of_second_contact(),
            highest.map(|highest| highest.rate),
            highest.map(|highest| highest.wavelength),
            highest.map(|highest| highest.frequency),
            growth.as_ref().err(),
        ))?;
    }
    writer.flush()
}

pub(super) fn growth(answer: &WheelsAnswer, file: &mut impl Write) -> io::Result<()> {
    let mut writer = csv::Writer::from_writer(file);
    let names = answer.in_loop().map(|(wheel, _)| wheel.name.as_str());
    let columns = column::names(names, "growth_rate_per_passage");
    writer.write_record(["wavelength_m".to_owned()].iter().chain(&columns))?;
    for (place, wavelength) in answer.wavelengths.iter().enumerate() {
        let rates = answer.in_loop().map(|(_, growth)| growth.rates[place]);
        let row = std::iter::once(*wavelength).chain(rates);
        writer.write_record(row.map(|value| value.to_string()))?;
    }
    writer.flush()
}

pub(super) fn grid(answer: &WheelsAnswer, case: &Case, path: &Path) -> Result<(), AnswerError> {
    let (wavelength, speed) = (case.wavelength, case.speed);
    let points = wavelength.points() * speed.points();
    let of_wheels = |value: fn(&WheelAnswer) -> f64| {
        let values: Vec<f64> = answer.wheels.iter().map(value).collect();
        Box::new(move || values.clone())
    };
    let of_axis = |axis: Axis| Box::new(move || axis.values());
    let variables = [
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
            values: of_wheels(|wheel| wheel.state.wheelset as f64),
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
                    .flat_map(|wheel| match &wheel.growth {
                        Ok(growth) => growth.rates_on_the_grid().collect(),
                        Err(_) => vec![f64::NAN; points],
                    })
                    .collect()
            }),
        },
    ];
    let axes = [
        ("wheel", answer.wheels.len()),
        ("speed", speed.points()),
        ("wavelength", wavelength.points()),
    ];
    let title = case.file.title.as_deref();
    let title = title.unwrap_or("Growth under the wheels of a curve");
    write_netcdf(path, title, &axes, &variables)
}
