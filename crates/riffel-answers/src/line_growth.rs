//! What grows fastest under the traffic of a line, and in what time.

use std::f64::consts::LN_2;

use riffel::MeanWear;
use riffel::forecast::{SpeedDistribution, TrafficGrowth};
use riffel_case::traffic::{
    DAYS_PER_MONTH, LineKind, Traffic, TrafficOnCase, UsualTraffic, bands_of, is_faster_than_known, reported_growth,
    traffic_at_speeds,
};
use riffel_case::{Case, Variant, ask};
use riffel_keys::{CaseError, Message, fixed, number, range, say, significant, significant_digits};
use serde::{Serialize, Serializer};

use crate::{Banded, Cause, unlikely_wear, wear_spread};

/// Growth under the traffic of a line: serialised, what documents hold as `under_traffic`.
#[derive(Debug, Clone, Serialize)]
pub struct LineGrowth {
    /// The kind of line whose usual traffic it is; none for a traffic that was given.
    #[serde(serialize_with = "name_of")]
    pub usual_traffic_of: Option<LineKind>,
    /// Slowest and fastest trains \[m/s\].
    pub speeds_m_per_s: [f64; 2],
    /// Axles a day, if that is known.
    pub passages_per_day: Option<f64>,
    /// Frequency \[Hz\] at which the loop of a vehicle oscillates by itself, if one does: growth rates mean nothing then.
    pub unstable_frequency_hz: Option<f64>,
    /// What grows fastest; `None` if nothing grows.
    pub fastest: Option<FastestGrowth>,
    /// What that follows; `None` if nothing grows under the wheel of the case.
    pub cause: Option<Cause>,
    /// The answer in sentences, and whether growth is faster than any that was seen.
    pub remarks: Vec<Message>,
    /// Wavelengths \[m\] with their growth rates per passage.
    #[serde(skip)]
    pub curve: Vec<[f64; 2]>,
    /// Mean wear of the rail under the traffic.
    #[serde(skip)]
    mean_wear: MeanWear,
}

/// The wavelengths that grow fastest.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct FastestGrowth {
    /// The fastest of all \[m\].
    pub wavelength_m: f64,
    /// About it, those that grow at half its rate and more \[m\].
    pub wavelengths_m: [f64; 2],
    /// The fastest sits at an end of the wavelengths: a shorter or longer one may grow faster.
    pub at_edge: bool,
    /// Its growth rate, in the mean over all axles.
    pub growth_rate_per_passage: f64,
    /// Axle passages in which its amplitude doubles.
    pub doubling_passages: f64,
    /// Passages in which the amplitude doubles, with the bands of the wear coefficient; `None` if growth does not go by it.
    pub doubling_passages_banded: Option<Banded>,
    /// It grows faster than any railway known: wavelengths and order hold, the rate does not, so no months follow.
    pub faster_than_known: bool,
    /// The loop of a vehicle oscillates by itself, so that its rate means nothing.
    #[serde(skip)]
    pub oscillates: bool,
    /// Months of that, if it is known how many axles run and the rate has a meaning.
    pub doubling_months: Option<f64>,
    /// Months in which the amplitude doubles, with their bands.
    pub doubling_months_banded: Option<Banded>,
}

fn name_of<S: Serializer>(line: &Option<LineKind>, serializer: S) -> Result<S::Ok, S::Error> {
    line.map(LineKind::name).serialize(serializer)
}

impl LineGrowth {
    /// Growth of a case under a traffic, or else under the usual one of its line.
    ///
    /// # Errors
    /// [`CaseError`] as of [`Traffic::on`].
    pub fn new(case: &Case, traffic: Option<&Traffic>) -> Result<Self, CaseError> {
        let usual = UsualTraffic::of(case);
        let (line, traffic) = match traffic {
            Some(traffic) => (None, traffic),
            None => (Some(usual.line), &usual.traffic()?),
        };
        let mut growth = Self::under(case, traffic, &Variant::none(""))?;
        growth.usual_traffic_of = line;
        growth.remarks.extend(unlikely_wear(case, growth.mean_wear));
        growth.remarks.push(growth.sentence(case));
        if let Some(fastest) = growth.fastest.filter(|fastest| !fastest.oscillates) {
            growth.cause = Cause::of(case, fastest.wavelength_m, growth.speeds_m_per_s);
            let cause = growth.cause.iter().map(|cause| cause.sentence().clone());
            growth.remarks.extend(cause);
            growth.remarks.extend(fastest.doubts(case, growth.passages_per_day));
        }
        Ok(growth)
    }

    /// The numbers of growth under a traffic on what a variant makes of a case.
    pub(crate) fn under(case: &Case, traffic: &Traffic, variant: &Variant) -> Result<Self, CaseError> {
        let case = &case.sharing_parts();
        let on = traffic.on(case, &bands_of(case), variant, &|_| ())?;
        let speeds = traffic.speeds().iter().map(span);
        let speeds = speeds.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        let per_day = on.passages_per_day;
        let fastest = FastestGrowth::of(case, &on);
        let rates = on.growth.rates().iter();
        let lines = on.growth.wavelengths().into_iter().zip(rates);
        Ok(Self {
            usual_traffic_of: None,
            speeds_m_per_s: speeds.unwrap_or_default(),
            passages_per_day: per_day,
            unstable_frequency_hz: on.unstable,
            fastest,
            cause: None,
            remarks: Vec::new(),
            mean_wear: on.growth.mean_wear(),
            curve: lines.map(|(wavelength, rate)| [wavelength, *rate]).collect(),
        })
    }

    /// Whose traffic it is: "the usual traffic of a metro, 40–70 km/h, 6000 axles a day".
    fn whose(&self) -> Message {
        let traffic = match self.usual_traffic_of {
            Some(line) => line.usual_traffic(),
            None => say!(traffic_given),
        };
        traffic_at_speeds(traffic, self.speeds_m_per_s, self.passages_per_day)
    }

    /// The answer.
    fn sentence(&self, case: &Case) -> Message {
        let millimetres = |wavelength: f64| significant(1e3 * wavelength, 2);
        let traffic = self.whose();
        if let Some(frequency) = self.unstable_frequency_hz {
            return say!(oscillates_under, frequency = fixed(frequency, 0), traffic);
        }
        let Some(fastest) = &self.fastest else {
            return say!(
                nothing_grows_under,
                traffic,
                shortest = millimetres(case.wavelength.min()),
                longest = millimetres(case.wavelength.max())
            );
        };
        let ends = range(fastest.wavelengths_m, |end| significant_digits(1e3 * end, 2));
        let range = say!(one_wavelength, wavelength = number(ends));
        let wavelength = millimetres(fastest.wavelength_m);
        if fastest.faster_than_known {
            return say!(grows_fastest_without_rate, traffic, range, wavelength);
        }
        let time = fastest.time();
        match fastest.doubling_passages_banded {
            Some(_) => {
                say!(grows_fastest_under_within, traffic, range, wavelength, time)
            }
            None if case.has_other_damage() => {
                say!(grows_fastest_by_damage, traffic, range, wavelength, time)
            }
            None => say!(grows_fastest_under, traffic, range, wavelength, time),
        }
    }
}

impl FastestGrowth {
    fn of(case: &Case, on: &TrafficOnCase) -> Option<Self> {
        let (growth, per_day) = (&on.growth, on.passages_per_day);
        let (wavelength, rate, at_edge) = ask::fastest_under(case, growth)?;
        if rate <= 0.0 {
            return None;
        }
        let spread = wear_spread(case);
        let passages = LN_2 / rate;
        let faster_than_known = per_day.is_some_and(|per_day| is_faster_than_known(rate, per_day));
        let oscillates = on.unstable.is_some();
        let months =
            per_day.filter(|_| !faster_than_known && !oscillates).map(|per_day| passages / per_day / DAYS_PER_MONTH);
        let banded = |value: f64| Some(Banded::by_wear(value, spread?));
        Some(Self {
            wavelength_m: wavelength,
            wavelengths_m: about(growth, wavelength, 0.5 * rate, ask::shortest_told(case)),
            at_edge,
            growth_rate_per_passage: rate,
            doubling_passages: passages,
            doubling_passages_banded: banded(passages),
            faster_than_known,
            oscillates,
            doubling_months: months,
            doubling_months_banded: months.and_then(banded),
        })
    }

    /// Whether times follow from its rate: none do from one that oscillates or is faster than any railway known.
    pub(crate) fn has_times(&self) -> bool {
        !self.oscillates && !self.faster_than_known
    }

    /// Whether it sits at the edge of the bands, and whether it is faster than any growth that was seen.
    fn doubts(&self, case: &Case, per_day: Option<f64>) -> impl Iterator<Item = Message> {
        let middle = (case.wavelength.min() * case.wavelength.max()).sqrt();
        let edge = self.at_edge.then(|| {
            say!(
                fastest_at_edge,
                wavelength = significant(1e3 * self.wavelength_m, 2),
                beyond = match self.wavelength_m < middle {
                    true => say!(shorter_waves),
                    false => say!(longer_waves),
                }
            )
        });
        let reported =
            per_day.and_then(|per_day| reported_growth(case, self.wavelength_m, self.growth_rate_per_passage, per_day));
        edge.into_iter().chain(reported)
    }

    /// In what it doubles, as in "5 to 14 months": years above three of them, days below two months.
    #[must_use]
    pub fn time(&self) -> Message {
        self.time_beside(self)
    }

    /// Time of doubling in the unit of another, so that both can be compared at a glance.
    pub(crate) fn time_beside(&self, other: &Self) -> Message {
        if self.oscillates {
            return say!(oscillates_by_itself);
        }
        if self.faster_than_known {
            return say!(faster_than_known);
        }
        let Some(months) = self.doubling_months else {
            let million = |passages: f64| significant(1e-6 * passages, 2);
            return match self.doubling_passages_banded {
                Some(Banded { band_80, .. }) => {
                    let [early, late] = band_80.map(million);
                    say!(million_axles_between, early, late)
                }
                None => say!(million_axles, axles = million(self.doubling_passages)),
            };
        };
        let other_months = other.doubling_months.unwrap_or(months);
        time_in_words([months, other_months], [self, other].map(|growth| growth.doubling_months_banded))
    }
}

/// Months, with their bands where they have some, in the unit of others that are second in each.
pub(crate) fn time_in_words([months, others]: [f64; 2], banded: [Option<Banded>; 2]) -> Message {
    let [own_band, band] = banded.map(|banded| banded.map(|it| it.band_80));
    let unit = unit_of(band.unwrap_or([others; 2]));
    if let Some(own_band) = own_band {
        return between(own_band, unit);
    }
    alone(months, unit)
}

fn alone(months: f64, unit: Unit) -> Message {
    let two = |time: f64| significant(time, 2);
    match unit {
        Unit::Days => say!(days_of, days = two(DAYS_PER_MONTH * months)),
        Unit::Months => say!(months_of, months = two(months)),
        Unit::Years => say!(years_of, years = two(months / 12.0)),
    }
}

enum Unit {
    Days,
    Months,
    Years,
}

/// Years above three of them, days below two months.
fn unit_of([early, late]: [f64; 2]) -> Unit {
    match (early, late) {
        (_, late) if late < 2.0 => Unit::Days,
        (early, _) if early >= 36.0 => Unit::Years,
        _ => Unit::Months,
    }
}

/// Between so many months, in the unit that suits both.
pub(crate) fn time_between(months: [f64; 2]) -> Message {
    between(months, unit_of(months))
}

fn between(months: [f64; 2], unit: Unit) -> Message {
    let [early, late] = months.map(|time| significant(time, 2));
    if early == late {
        return alone(months[0], unit);
    }
    let in_unit = |size: f64| months.map(|time| significant(size * time, 2));
    match unit {
        Unit::Days => {
            let [early, late] = in_unit(DAYS_PER_MONTH);
            say!(days_between, early, late)
        }
        Unit::Months => {
            let [early, late] = in_unit(1.0);
            say!(months_between, early, late)
        }
        Unit::Years => {
            let [early, late] = in_unit(1.0 / 12.0);
            say!(years_between, early, late)
        }
    }
}

/// Slowest and fastest of a distribution; of a normal one, those of even speeds with its deviation.
fn span(speeds: &SpeedDistribution) -> [f64; 2] {
    if speeds.listed().is_some() {
        let (slowest, fastest) = speeds.range();
        return [slowest, fastest];
    }
    let half = 3f64.sqrt() * speeds.deviation();
    [speeds.mean() - half, speeds.mean() + half]
}

/// The wavelengths about one, of those that are told, that grow at a rate and more without a gap.
fn about(growth: &TrafficGrowth, wavelength: f64, rate: f64, shortest: f64) -> [f64; 2] {
    let lines = growth.wavelengths();
    let middle = lines.partition_point(|&line| line < wavelength);
    let grows = |&(line, own): &(f64, f64)| own >= rate && line >= shortest;
    let line = |place: usize| (lines[place], growth.rates()[place]);
    let above = (middle..lines.len()).map(line).take_while(grows).last();
    let below = (0..middle).rev().map(line).take_while(grows).last();
    [below, above].map(|end| end.map_or(wavelength, |(line, _)| line))
}
