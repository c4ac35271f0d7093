//! The time from one grinding to the next under the traffic of a line.

use riffel::forecast::LINES_PER_BAND;
use riffel_calibrate::{USUAL_HORIZON, USUAL_RISE, growing_bands};
use riffel_case::traffic::DAYS_PER_MONTH;
use riffel_case::{Case, ask};
use riffel_keys::{Message, number, say};
use serde::Serialize;

use crate::line_growth::time_in_words;
use crate::{Banded, LineGrowth, wear_spread};

/// The time in which the first band rises from what grinding leaves to the limit, as a decision over a calibration has it.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GrindingInterval {
    /// `None` if no band is there within the longest interval, 20 years.
    pub months: Option<f64>,
    /// With the bands of the wear coefficient, whose ends may lie beyond the longest interval; `None` if growth does not go by it, or
    /// no band grows.
    pub months_banded: Option<Banded>,
}

impl GrindingInterval {
    /// Under a traffic on a case, or on what a variant made of it; `None` if it is not known how many axles run, or where no
    /// time follows from the fastest.
    pub(crate) fn new(case: &Case, growth: &LineGrowth) -> Option<Self> {
        if growth.fastest.is_some_and(|fastest| !fastest.has_times()) {
            return None;
        }
        let per_month = growth.passages_per_day? * DAYS_PER_MONTH;
        // As of the fastest: bands that the contact does not average out, or all where it averages out all.
        let is_told = |band: &[[f64; 2]]| band.iter().any(|[line, _]| *line >= ask::shortest_told(case));
        let bands = || growth.curve.chunks(LINES_PER_BAND);
        let any = bands().any(is_told);
        let bands = bands().filter(|band| !any || is_told(band));
        let rates: Vec<f64> = bands.flatten().map(|[_, rate]| *rate).collect();
        let missed = vec![0.0; rates.len() / LINES_PER_BAND];
        let risen = 10f64.powf(0.1 * USUAL_RISE);
        let passages = growing_bands(&rates, &missed).filter_map(|band| band.passages_to(risen));
        let months = passages.min_by(f64::total_cmp).map(|it| it / per_month);
        let banded = |months| Some(Banded::by_wear(months, wear_spread(case)?));
        Some(Self { months: months.filter(|months| *months <= USUAL_HORIZON), months_banded: months.and_then(banded) })
    }

    /// Months that this is longer than another; what is longer than the longest counts as that.
    pub(crate) fn gained_on(&self, other: &Self) -> f64 {
        let [own, other] = [self, other].map(|it| it.months.unwrap_or(USUAL_HORIZON));
        own - other
    }

    /// In the unit of another, so that both can be compared at a glance.
    pub(crate) fn time_beside(&self, other: &Self) -> Message {
        let years = || number(USUAL_HORIZON / 12.0);
        // One that has no unit of its own leaves that of this.
        let other = other.months.map_or(self, |_| other);
        let beside = other.months.unwrap_or(USUAL_HORIZON);
        let banded = other.months_banded;
        let band = self.months_banded.map(|banded| banded.band_80);
        match (self.months, band) {
            (_, Some([early, late])) if late > USUAL_HORIZON && early <= USUAL_HORIZON => {
                let early = time_in_words([early, beside], [None, banded]);
                say!(time_or_longer, early, years = years())
            }
            (Some(months), _) => time_in_words([months, beside], [self.months_banded, banded]),
            (None, _) => say!(longer_than_years, years = years()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use riffel_case::NOMINAL_CASE;

    /// Growth of two bands at the same rate each: 6 dB come after 0.3 ln 10 / g passages, by the faster.
    #[test]
    fn the_first_band_that_has_risen_ends_the_interval() {
        let case = Case::parse("nominal", NOMINAL_CASE, &[]).unwrap();
        let mut growth = LineGrowth::new(&case, None).unwrap();
        growth.passages_per_day = Some(1000.0 / DAYS_PER_MONTH);
        let interval = |growth: &mut LineGrowth, rates: [f64; 2]| {
            let lines = (0..2 * LINES_PER_BAND).map(|k| [0.1 + 0.001 * k as f64, rates[k / LINES_PER_BAND]]);
            growth.curve = lines.collect();
            GrindingInterval::new(&case, growth).unwrap()
        };
        let slow = interval(&mut growth, [1e-6, 1e-5]);
        let expected = 0.3 * std::f64::consts::LN_10 / 1e-5 / 1000.0;
        // Newton's method ends at some roundings.
        assert!((slow.months.unwrap() / expected - 1.0).abs() < 1e-12);
        // Longer than 20 years in the middle, not at the early end; no time of both is cut off.
        let wide = interval(&mut growth, [-1e-5, 2.5e-6]);
        let [early, late] = wide.months_banded.unwrap().band_80;
        assert!(wide.months.is_none() && early < USUAL_HORIZON && late > USUAL_HORIZON);
        let words = wide.time_beside(&wide).to_string();
        let years = riffel_keys::message::significant_digits(early / 12.0, 2);
        assert_eq!(words, format!("{years} years to more than 20 years"));
        let none = interval(&mut growth, [-1e-5, 1e-9]);
        assert_eq!(none.months, None);
        assert!((none.gained_on(&slow) - (USUAL_HORIZON - expected)).abs() < 1e-9);
        assert_eq!(none.time_beside(&slow).to_string(), "more than 20 years");
        growth.passages_per_day = None;
        assert_eq!(GrindingInterval::new(&case, &growth), None);
    }
}
