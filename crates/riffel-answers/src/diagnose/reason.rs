//! What speaks for a mechanism or against it, and what would tell it from others, in words.

use riffel::diagnosis::{Expectation, LevelTrend, Measurement, Reason, Slope, TimeUnit, TrafficSpeeds, TrendPoint};
use riffel_keys::{Message, Value, fixed, number, range, say, significant};

use super::finding::UNLIKELY;
use super::mechanism_words::settled_by;

/// A reason in a sentence. That of a course is not there without one.
pub(super) fn in_words(reason: &Reason, speeds: &TrafficSpeeds, course: Option<&LevelTrend>) -> Message {
    match *reason {
        Reason::Unlisted => say!(explains_any_wavelength),
        Reason::AverageOverPatch { wavelength, passes } => {
            say!(patch_averages, wavelength = millimetres(wavelength), percent = fixed(100.0 * passes, 0))
        }
        Reason::WithoutWheels => say!(trolley_measures_rail_alone),
        Reason::HigherThanGround { rms, accepted } => {
            say!(higher_than_ground, rms = significant(1e6 * rms, 2), accepted = fixed(1e6 * accepted, 0))
        }
        Reason::Frequency { frequency, spread, damping_ratio, wavelengths: (from, to), measured } => {
            let spread = fixed(100.0 * spread, 0);
            let known = match damping_ratio {
                Some(ratio) => {
                    let ratio = fixed(100.0 * ratio, 1);
                    say!(known_with_damping, ratio, spread)
                }
                None => say!(known_to, spread),
            };
            say!(
                frequency_makes,
                frequency = fixed(frequency, 0),
                known,
                range = span(1e3 * from, 1e3 * to, "mm"),
                speeds = speeds.words(),
                measured = millimetres(measured),
                frequencies = frequencies(measured, speeds)
            )
        }
        Reason::Growth { highest: (at, highest), measured, rate } => {
            growth_in_words(at, highest, measured, rate, speeds)
        }
        Reason::NothingGrows { measured } => {
            say!(case_lets_nothing_grow, speeds = speeds.words(), measured = millimetres(measured))
        }
        Reason::OutsideGrowth { measured } => {
            say!(measured_outside_growth, measured = millimetres(measured))
        }
        Reason::Range { wavelengths: (from, to), measured } => {
            say!(wavelengths_at_any_speed, range = span(1e3 * from, 1e3 * to, "mm"), measured = millimetres(measured))
        }
        Reason::Order { length, order, nearest, measured } => say!(
            order_of_length,
            length = millimetres(length),
            order = number(order),
            nearest = millimetres(nearest),
            ratio = fixed(nearest / measured, 2),
            measured = millimetres(measured)
        ),
        Reason::LevelTrend(expectation) => {
            let course = course.map_or_else(|| Message::verbatim(""), course_in_words);
            match expectation {
                Expectation::Fades => say!(marks_fade_under_traffic, course),
                _ => say!(corrugation_grows_under_traffic, course),
            }
        }
    }
}

/// What a case lets grow at the measured wavelength \[m\], beside where it grows fastest.
fn growth_in_words(at: f64, highest: f64, measured: f64, rate: f64, speeds: &TrafficSpeeds) -> Message {
    let own = number(format_args!("{:.1e}", rate.abs()));
    let [at, measured] = [at, measured].map(millimetres);
    let (speeds, shown) = (speeds.words(), number(format_args!("{highest:.1e}")));
    match rate > 0.0 {
        true => say!(
            case_grows_at_measured,
            speeds,
            wavelength = at,
            rate = shown,
            measured,
            own,
            percent = fixed(100.0 * rate / highest, 0)
        ),
        false => say!(case_decays_at_measured, speeds, wavelength = at, rate = shown, measured, own),
    }
}

/// A measurement that tells candidates for a wavelength \[m\] apart.
pub(super) fn measurement(measurement: Measurement, wavelength: f64, speeds: &TrafficSpeeds) -> Message {
    let millimetres = |length: f64| fixed(1e3 * length, 1);
    let when = match measurement {
        Measurement::OtherSpeed => {
            return say!(
                measure_at_other_speed,
                frequencies = frequencies(wavelength, speeds),
                moved = millimetres(0.8 * wavelength),
                wavelength = millimetres(wavelength)
            );
        }
        Measurement::Of(kind) => return settled_by(kind),
        Measurement::Again(Some((TimeUnit::Year, years))) => {
            say!(in_weeks_moves, weeks = fixed((52.0 * years).ceil(), 0))
        }
        Measurement::Again(Some((TimeUnit::Record, records))) => {
            say!(intervals_move, records = fixed(records, 1))
        }
        Measurement::Again(None) => say!(after_three_months),
    };
    say!(measure_again, when)
}

/// A course: levels of the records, what they do, and how fast.
pub(crate) fn course_in_words(course: &LevelTrend) -> Message {
    let levels = |points: &[TrendPoint]| -> Value { points.iter().map(|point| fixed(point.level, 1)).collect() };
    let (all, fall) = (levels(&course.points), course.fall().unwrap_or(0.0));
    let record = course.points[course.since].label.as_str();
    match course.slope {
        Some(slope) if course.since == 0 => line_in_words(course, slope, all),
        Some(slope) => say!(
            course_since_ground,
            levels = all,
            fall = fixed(fall, 1),
            record,
            since = line_in_words(course, slope, levels(course.on_line()))
        ),
        None => say!(course_ends_ground, levels = all, fall = fixed(fall, 1), record),
    }
}

/// The line of a course, with the levels that it goes through.
fn line_in_words(course: &LevelTrend, slope: Slope, levels: Value) -> Message {
    let scatter = fixed(slope.scatter, 1);
    let slope = number(format_args!("{:+.1}", slope.mean));
    let unit = match course.unit {
        TimeUnit::Year => say!(year),
        TimeUnit::Record => say!(record),
    };
    let rises = course.probability_of_rise().unwrap_or(0.5);
    macro_rules! told {
        ($id:ident) => {
            say!($id, levels, slope, scatter, unit)
        };
    }
    // Two records rise or fall once, whether by chance or not.
    match course.on_line().len() == 2 {
        true if (UNLIKELY..=1.0 - UNLIKELY).contains(&rises) => told!(course_of_two_is_open),
        true if rises > 0.5 => told!(course_of_two_rises),
        true => told!(course_of_two_falls),
        false if course.falls_every_time() => told!(course_falls),
        false if course.rises_every_time() => told!(course_rises),
        false => told!(course_is_open),
    }
}

/// A wavelength \[m\] in millimetres.
fn millimetres(wavelength: f64) -> Value {
    let value = 1e3 * wavelength;
    let digits = usize::from(value < 100.0);
    number(format_args!("{value:.digits$} mm"))
}

/// Two numbers with a unit: "31–39 mm", or one where they are the same.
fn span(from: f64, to: f64, unit: &str) -> Value {
    let digits = usize::from(to < 100.0 && unit == "mm");
    let ends = range([from, to], |end| format!("{end:.digits$}"));
    number(format_args!("{ends} {unit}"))
}

/// Frequencies of a wavelength \[m\] at the speeds of the traffic: "1375–1958 Hz".
fn frequencies(wavelength: f64, speeds: &TrafficSpeeds) -> Value {
    let [slowest, fastest] = [speeds.slowest(), speeds.fastest()].map(|speed| speed / wavelength);
    span(slowest, fastest, "Hz")
}
