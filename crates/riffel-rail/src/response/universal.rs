//! A frequency response in a universal file.

use riffel_keys::universal_file::{
    self, ACCELERATION, Axis, DISPLACEMENT, Freedom, Function, Units, VELOCITY, unit_size,
};
use riffel_keys::{Exponents, Message, say};

use super::response_unit::{ValueUnit, response_of};
use super::table::hertz_of;
use super::{FrequencyResponse, Measurement, MeasurementError, Response, UniversalFunction, VerticalAxis};

/// Kinds of the format, dataset 58.
const FREQUENCY_RESPONSE: i32 = 4;
const FREQUENCY: i32 = 18;
const REACTION_FORCE: i32 = 9;
const EXCITATION_FORCE: i32 = 13;
/// Of a function that says by its units alone what it is, or not at all.
const GENERAL: [i32; 2] = [0, 1];

/// The function that the case asks for, or the only vertical frequency response of the file, and what its reader should know.
pub(super) fn read(
    bytes: &[u8],
    measurement: &Measurement,
) -> Result<(FrequencyResponse, Vec<Message>), MeasurementError> {
    let axis = measurement.vertical_axis;
    let file = universal_file::read(bytes).map_err(|error| MeasurementError::file(&error))?;
    let function = match measurement.function {
        Some(number) => {
            number.checked_sub(1).and_then(|index| file.functions.get(index as usize)).ok_or_else(|| {
                MeasurementError::new(
                    "function",
                    format!("is {number}, but the file has {} functions", file.functions.len()),
                )
            })?
        }
        None => only(&file.functions, axis)?,
    };
    let remarks = between_nodes(function).into_iter().collect();
    Ok((response(function, file.units, measurement)?, remarks))
}

/// A point receptance has response and force at one node; on a rail head they stand side by side.
fn between_nodes(function: &Function) -> Option<Message> {
    let (response, reference) = (function.response.node, function.reference.node);
    (response != reference)
        .then(|| say!(response_at_other_node, response = response.to_string(), reference = reference.to_string()))
}

/// Whether a function responds along an axis to a force along it.
fn is_along(function: &Function, axis: VerticalAxis) -> bool {
    let code = match axis {
        VerticalAxis::X => 1,
        VerticalAxis::Y => 2,
        VerticalAxis::Z => 3,
    };
    [&function.response, &function.reference].into_iter().all(|freedom| freedom.direction.abs() == code)
}

/// A direction by its code.
fn direction(code: i32) -> &'static str {
    match code.abs() {
        1 => "x",
        2 => "y",
        _ => "z",
    }
}

fn only(functions: &[Function], axis: VerticalAxis) -> Result<&Function, MeasurementError> {
    let is_response = |function: &&Function| function.function_type == FREQUENCY_RESPONSE;
    let vertical = || {
        let responses = functions.iter().filter(is_response);
        responses.filter(|function| is_along(function, axis))
    };
    if let (Some(function), None) = (vertical().next(), vertical().nth(1)) {
        return Ok(function);
    }
    let mut candidates = functions.iter().filter(is_response);
    match (candidates.next(), candidates.count()) {
        (Some(function), 0) => Ok(function),
        (None, _) => Err(MeasurementError::file("the file has no frequency response (dataset 58, function type 4)")),
        (Some(_), others) => Err(MeasurementError::file(format!(
            "the file has {} frequency responses: choose one by track.measurement.function",
            others + 1
        ))),
    }
}

/// A function by its numbers, whose units are SI where it names none.
pub(super) fn of_function(function: &UniversalFunction) -> Result<FrequencyResponse, MeasurementError> {
    let vertical = function.vertical_axis;
    let axis = |kind: i32, unit: &str| Axis {
        kind,
        length: 0,
        force: 0,
        temperature: 0,
        label: String::new(),
        unit: unit.to_owned(),
    };
    let freedom = |direction: i32| Freedom { entity: String::new(), node: 0, direction };
    let function = Function {
        line: 0,
        title: function.title.clone(),
        function_type: function.function_type,
        load_case: function.load_case,
        response: freedom(function.response_direction),
        reference: freedom(function.reference_direction),
        abscissa_axis: axis(function.abscissa_kind, ""),
        numerator: axis(function.numerator.0, &function.numerator.1),
        denominator: axis(function.denominator.0, &function.denominator.1),
        complex: true,
        abscissa: function.frequencies.clone(),
        ordinate: function.values.clone(),
    };
    let said = Measurement { vertical_axis: vertical, ..Measurement::default() };
    response(&function, Some(SI), &said)
}

/// Units of a file in SI.
const SI: Units = Units { length: 1.0, force: 1.0, temperature: 1.0, temperature_offset: 0.0 };

fn response(
    function: &Function,
    units: Option<Units>,
    said: &Measurement,
) -> Result<FrequencyResponse, MeasurementError> {
    let vertical = said.vertical_axis;
    // What was not read here has no line.
    let place = |value: String| match function.line {
        0 => value,
        line => format!("line {line}, {value}"),
    };
    let wrong = |rule: &str| {
        let function = place(format!("\"{}\"", function.title));
        Err(MeasurementError::file(format!("{function}: {rule}")))
    };
    if function.function_type != FREQUENCY_RESPONSE || !function.complex {
        return wrong("is not a complex frequency response");
    }
    if function.load_case != 0 {
        return wrong("belongs to a load case, not to a force at one point");
    }
    if function.abscissa_axis.kind != FREQUENCY {
        return wrong("does not run over frequency");
    }
    let Some(hertz) = hertz(&function.abscissa_axis, said)? else {
        return wrong(&format!(
            "has its frequencies in {}, which is no unit of a frequency: give theirs by track.measurement.frequency_unit",
            function.abscissa_axis.unit.trim()
        ));
    };
    let (quantity, size) = match size(function, units, said)? {
        Ok(known) => known,
        Err(rule) => return wrong(rule),
    };
    let translation = |direction: i32| (1..=3).contains(&direction.abs());
    let directions = [function.response.direction, function.reference.direction];
    let unsaid = directions == [0, 0] && (said.function.is_some() || function.line == 0);
    if !unsaid && !directions.into_iter().all(translation) {
        return wrong(
            "is not along x, y or z: say that it is the vertical response to a vertical force by track.measurement.function",
        );
    }
    if !unsaid && !is_along(function, vertical) {
        return wrong(&format!(
            "responds along {} to a force along {}, but a vertical receptance has both along the vertical axis, here {}: \
             choose another function, or the axis by track.measurement.vertical_axis",
            direction(function.response.direction),
            direction(function.reference.direction),
            vertical.name()
        ));
    }
    // The sign of a direction that points against its axis.
    let sign: i32 = directions.into_iter().filter(|one| *one != 0).map(i32::signum).product();
    let factor = f64::from(sign) * size;
    Ok(FrequencyResponse {
        response: quantity,
        frequencies: function.abscissa.iter().map(|value| hertz * value).collect(),
        values: function.ordinate.iter().map(|value| value * factor).collect(),
        coherence: None,
        places: (1..=function.ordinate.len()).map(|number| place(format!("value {number}"))).collect(),
    })
}

/// Hertz in one unit of the abscissa, as the case or else the file says it; none for another unit.
fn hertz(axis: &Axis, said: &Measurement) -> Result<Option<f64>, MeasurementError> {
    match &said.frequency_unit {
        Some(unit) => hertz_of(unit).map(Some).ok_or_else(|| {
            MeasurementError::new(
                "frequency_unit",
                format!("is \"{unit}\", which is no unit of a frequency: write \"Hz\", \"kHz\" or \"rad/s\""),
            )
        }),
        None if axis.has_unit() => Ok(hertz_of(axis.unit.trim())),
        None => Ok(Some(1.0)),
    }
}

/// What was measured, and SI units in one unit of it: as the case says, as its parts do, or as the unit of the whole does;
/// else the rule that is broken.
fn size(
    function: &Function,
    units: Option<Units>,
    said: &Measurement,
) -> Result<Result<(Response, f64), &'static str>, MeasurementError> {
    let Function { numerator, denominator, .. } = function;
    if said.unit.is_some() {
        let decoded = ValueUnit {
            key: said.unit.as_deref(),
            quantity: said.quantity,
            column: &function.title,
            in_file: None,
            is_modulus: false,
        }
        .decode()?;
        return Ok(Ok((decoded.response, decoded.linear())));
    }
    let is_general = GENERAL.contains(&numerator.kind);
    if is_general
        && !denominator.has_unit()
        && let Some(known) = response_of(numerator.unit.trim())
    {
        return Ok(Ok(known));
    }
    let quantity = match numerator.kind {
        DISPLACEMENT => Response::Receptance,
        VELOCITY => Response::Mobility,
        ACCELERATION => Response::Accelerance,
        _ if is_general => match said.quantity {
            Some(quantity) => quantity,
            None => {
                return Ok(Err("does not say what it is: give track.measurement.quantity and unit"));
            }
        },
        _ => return Ok(Err("is no displacement, velocity or acceleration")),
    };
    let is_force = [REACTION_FORCE, EXCITATION_FORCE].contains(&denominator.kind);
    let is_said = GENERAL.contains(&denominator.kind) && said.quantity.is_some();
    if !(is_force || is_said) {
        return Ok(Err("is not per force"));
    }
    if units.is_none() && !(numerator.has_unit() && denominator.has_unit()) {
        return Ok(Err("names no unit, nor does its file (dataset 164): give it by track.measurement.unit"));
    }
    let (length, force) = units.map_or((1.0, 1.0), |units| (units.length, units.force));
    let motion = match quantity {
        Response::Receptance => Exponents::new(0, 1, 0),
        Response::Mobility => Exponents::new(0, 1, -1),
        Response::Accelerance => Exponents::new(0, 1, -2),
    };
    let newton = Exponents::new(1, 1, -2);
    let factors = unit_size(numerator, motion, length).zip(unit_size(denominator, newton, force));
    Ok(factors
        .map(|(numerator, denominator)| (quantity, numerator / denominator))
        .ok_or("is labelled with a unit that does not fit what it is"))
}
