//! Where a wheelset touches its track over its lateral shift, and its equivalent conicity.

use riffel_case::CurvingCase;
use riffel_curving::profile::{EquivalentConicity, ProfileContact, WheelsetContact};
use riffel_keys::{Message, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Series};
use serde::{Serialize, Serializer};

use crate::answer::titled;
use crate::number_alone;
use crate::{Answer, AnswerError, Result, Rows, Table};

/// Amplitudes of the equivalent conicity \[mm\].
const AMPLITUDES: [f64; 7] = [1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

/// Lateral shifts where none are asked for \[mm\]: to either side, in tenths.
const USUAL_TENTHS: i32 = 100;

/// A wheelset on its track over its lateral shift: serialised, what `riffel profile CASE --wheelset --json` prints, in SI.
#[derive(Serialize)]
pub struct OnTrackAnswer {
    lateral_shift: Vec<f64>,
    yaw: Vec<f64>,
    roll: Vec<f64>,
    centre_z: Vec<f64>,
    #[serde(flatten, serialize_with = "by_rail")]
    contacts: Vec<WheelsetContact>,
    rolling_radius_difference: Vec<f64>,
    /// Without yaw, by amplitude.
    equivalent_conicity: Conicities,
    #[serde(skip)]
    conicities: Vec<ConicityAtAmplitude>,
    #[serde(skip)]
    title: Option<String>,
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// Equivalent conicity at an amplitude; null if no motion between the flanges has it.
struct ConicityAtAmplitude {
    /// Half of peak to peak \[m\].
    amplitude: f64,
    /// Of an axle that stays level, by the definition of EN 15302.
    standard: Option<EquivalentConicity>,
    /// Of an axle that rolls as both wheels touch, as a real one does.
    rolling: Option<EquivalentConicity>,
}

#[derive(Serialize)]
struct Conicities {
    amplitude_m: Vec<f64>,
    /// Rules for an axle that rolls.
    #[serde(flatten)]
    rolling: Rules,
    /// By the definition of EN 15302: the axle stays level.
    en_15302: Rules,
}

/// By the three rules; null if no motion has the amplitude.
#[derive(Serialize)]
struct Rules {
    klingel: Vec<Option<f64>>,
    harmonic: Vec<Option<f64>>,
    regression: Vec<Option<f64>>,
}

impl Rules {
    fn new<'a>(found: impl Iterator<Item = &'a Option<EquivalentConicity>> + Clone) -> Self {
        let of = |value: fn(&EquivalentConicity) -> f64| found.clone().map(|one| one.as_ref().map(value)).collect();
        Self {
            klingel: of(|found| found.klingel),
            harmonic: of(|found| found.harmonic),
            regression: of(|found| found.regression),
        }
    }
}

/// A quantity of a contact: its name, its unit in a table with the factor from SI, and its value.
type Quantity = (&'static str, &'static str, f64, fn(&ProfileContact) -> Option<f64>);

/// What is told of the contact on each rail.
const QUANTITIES: [Quantity; 10] = [
    ("rolling_radius", "mm", 1e3, |on| Some(on.rolling_radius)),
    ("contact_angle", "rad", 1.0, |on| Some(on.contact_angle)),
    ("y_wheel", "mm", 1e3, |on| Some(on.x_wheel)),
    ("y_track", "mm", 1e3, |on| Some(on.on_track[1])),
    ("z_track", "mm", 1e3, |on| Some(on.on_track[2])),
    ("x_track", "mm", 1e3, |on| Some(on.on_track[0])),
    ("rail_curvature", "1_per_mm", 1e-3, |on| Some(on.rail_curvature)),
    ("wheel_curvature", "1_per_mm", 1e-3, |on| Some(on.wheel_curvature)),
    ("second_gap", "mm", 1e3, |on| on.second.map(|second| second.0)),
    ("second_y_wheel", "mm", 1e3, |on| on.second.map(|second| second.1)),
];

/// Quantities of both contacts over the lateral shift, the right one first: name with the rail, unit, factor, values.
fn on_both_rails(contacts: &[WheelsetContact]) -> impl Iterator<Item = (String, &'static str, f64, Vec<Option<f64>>)> {
    [("right", 1), ("left", 0)].into_iter().flat_map(move |(rail, index)| {
        QUANTITIES.iter().map(move |(name, unit, factor, of)| {
            let values = contacts.iter().map(|contact| of(&contact.contacts[index]));
            (format!("{rail}_{name}"), *unit, *factor, values.collect())
        })
    })
}

fn by_rail<S: Serializer>(contacts: &[WheelsetContact], serializer: S) -> Result<S::Ok, S::Error> {
    serializer.collect_map(on_both_rails(contacts).map(|(name, .., values)| (name, values)))
}

/// The results without errors around that in the middle; that one alone where it is an error.
fn around_the_middle<T, E>(mut results: Vec<Result<T, E>>) -> Vec<Result<T, E>> {
    let middle = results.len() / 2;
    let before = results[..middle].iter().rposition(Result::is_err);
    let after = results[middle + 1..].iter().position(Result::is_err);
    let to = after.map_or(results.len(), |after| middle + 1 + after);
    let from = before.map_or(0, |before| before + 1);
    match results[middle].is_ok() {
        true => results.drain(from..to).collect(),
        false => results.drain(middle..=middle).collect(),
    }
}

impl OnTrackAnswer {
    /// The wheelset of a case at lateral shifts \[m\] and a yaw \[rad\]; without shifts, at those from -10 mm to 10 mm, every tenth
    /// of a millimetre, as far as both wheels touch their rails.
    ///
    /// # Errors
    /// [`AnswerError`] for profiles that cannot be read or do not fit, and where a wheel has left its rail.
    pub fn new(case: &CurvingCase, shifts: &[f64], yaw: f64) -> Result<Self> {
        let wheelset = case.wheelset_on_track()?;
        let at = |shifts: &[f64]| {
            let places: Vec<(f64, f64)> = shifts.iter().map(|shift| (*shift, yaw)).collect();
            wheelset.contacts(&places).into_iter()
        };
        let found: Vec<_> = match shifts {
            [] => {
                let tenths = -USUAL_TENTHS..=USUAL_TENTHS;
                let usual: Vec<f64> = tenths.map(|tenth| 1e-4 * f64::from(tenth)).collect();
                around_the_middle(at(&usual).collect())
            }
            listed => at(listed).collect(),
        };
        let contacts: Vec<WheelsetContact> =
            found.into_iter().collect::<Result<_, _>>().map_err(AnswerError::Profile)?;
        let [level, rolling] = case.radius_differences(&wheelset)?;
        let spacing = wheelset.wheels.spacing();
        let conicities = AMPLITUDES.iter().map(|amplitude| {
            let amplitude = 1e-3 * amplitude;
            ConicityAtAmplitude {
                amplitude,
                standard: level.equivalent_conicity(amplitude, spacing),
                rolling: rolling.equivalent_conicity(amplitude, spacing),
            }
        });
        let conicities: Vec<ConicityAtAmplitude> = conicities.collect();
        let of = |value: fn(&WheelsetContact) -> f64| contacts.iter().map(value).collect();
        Ok(Self {
            lateral_shift: of(|contact| contact.lateral_shift),
            yaw: of(|contact| contact.yaw),
            roll: of(|contact| contact.roll),
            centre_z: of(|contact| contact.centre_z),
            rolling_radius_difference: of(WheelsetContact::rolling_radius_difference),
            equivalent_conicity: Conicities {
                amplitude_m: conicities.iter().map(|one| one.amplitude).collect(),
                rolling: Rules::new(conicities.iter().map(|one| &one.rolling)),
                en_15302: Rules::new(conicities.iter().map(|one| &one.standard)),
            },
            title: case.file.title.clone(),
            remarks: case.remarks.iter().cloned().chain(case.remarks_of_profiles()?).collect(),
            contacts,
            conicities,
        })
    }

    /// One row for each lateral shift, in mm and rad.
    fn over_shift(&self) -> Table {
        let column = |name: &str, values: &[f64], factor: f64| values.exact(name, |value| factor * value);
        let sides = on_both_rails(&self.contacts).map(|(name, unit, factor, values)| {
            values.exact(&format!("{name}_{unit}"), |value| Some(factor * (*value)?))
        });
        let before = [
            column("lateral_shift_mm", &self.lateral_shift, 1e3),
            column("yaw_rad", &self.yaw, 1.0),
            column("roll_rad", &self.roll, 1.0),
            column("centre_z_mm", &self.centre_z, 1e3),
        ];
        let difference = column("rolling_radius_difference_mm", &self.rolling_radius_difference, 1e3);
        Table { name: "wheelset", columns: before.into_iter().chain(sides).chain([difference]).collect() }
    }

    /// By amplitude, for a reader.
    fn conicities(&self) -> Table {
        let of = |found: &Option<EquivalentConicity>, value: fn(&EquivalentConicity) -> f64| {
            let found = found.as_ref().map(value);
            found.map_or_else(|| say!(no_motion), |value| number_alone(format_args!("{value:.4}")))
        };
        let wavelength = |found: &Option<EquivalentConicity>| match found.as_ref().map(|found| found.wavelength) {
            None => say!(no_motion),
            Some(wavelength) if wavelength.is_finite() => number_alone(format_args!("{wavelength:.2}")),
            Some(_) => say!(endless_wavelength),
        };
        let rows = &self.conicities;
        Table {
            name: "conicity",
            columns: vec![
                rows.numbers(say!(amplitude_in_millimetres_column), |row| format!("{:.0}", 1e3 * row.amplitude)),
                rows.shown(say!(equivalent_conicity_column), |row| of(&row.standard, |found| found.klingel)),
                rows.shown(say!(conicity_with_roll_column), |row| of(&row.rolling, |found| found.klingel)),
                rows.shown(say!(conicity_harmonic_column), |row| of(&row.standard, |found| found.harmonic)),
                rows.shown(say!(conicity_regression_column), |row| of(&row.standard, |found| found.regression)),
                rows.shown(say!(wavelength_in_metres_column), |row| wavelength(&row.standard)),
            ],
        }
    }
}

impl Answer for OnTrackAnswer {
    fn name(&self) -> &'static str {
        "wheelset"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![titled(self.title.as_ref(), say!(wheelset_on_its_track))]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.conicities(), self.over_shift()]
    }

    fn sentences(&self) -> Vec<Message> {
        vec![say!(conicity_by_standard)]
    }

    /// Rolling radius difference, place and angle of the contact over the lateral shift.
    fn figure(&self) -> LineFigure {
        let shifts: Vec<f64> = self.contacts.iter().map(|contact| 1e3 * contact.lateral_shift).collect();
        let series = |label: &str, style: LineStyle, value: &dyn Fn(&WheelsetContact) -> f64| {
            Series::new(label, shifts.clone(), self.contacts.iter().map(value).collect()).styled(style)
        };
        let panel = |label: &str, series: Vec<Series>| {
            LinePanel::new("lateral shift y, to the right positive [mm]", label, series)
        };
        let both = |value: fn(&ProfileContact) -> f64| {
            vec![
                series("right", LineStyle::Solid, &|contact| value(&contact.contacts[1])),
                series("left", LineStyle::Dashed, &|contact| value(&contact.contacts[0])),
            ]
        };
        let difference = series("", LineStyle::Solid, &|contact| 1e3 * contact.rolling_radius_difference());
        LineFigure::new(
            "Wheelset on its track",
            "Rigid contact at two points, one on each rail; places \
                      on the wheel from its datum circle, the flange at the negative side.",
            [
                panel("Δr, right less left [mm]", vec![difference]),
                panel("place on the wheel [mm]", both(|contact| 1e3 * contact.x_wheel)),
                panel("contact angle [deg]", both(|contact| contact.contact_angle.to_degrees())),
            ],
        )
        .arranged(Arrangement::Stacked)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
