//! The growth forecast on numbers that are known.

use std::f64::consts::LN_10;

use riffel::forecast::{Forecast, MeanGrowth, MeasuredChange, SpeedDistribution, TrafficGrowth, WearFit, WearVerdict};
use riffel::roughness::Spectrum;
use riffel_case::traffic::{Traffic, bands_of};
use riffel_case::{TRAFFIC, Variant};

use crate::Row;
use crate::ground::nominal;
use crate::roughness::campaigns;

/// The example traffic on the nominal case.
fn mixed() -> TrafficGrowth {
    let case = nominal(&[]);
    let traffic = Traffic::parse("traffic.toml", TRAFFIC).expect("the example");
    let on = traffic.on(&case, &bands_of(&case), &Variant::none(""), &|_| {});
    on.expect("the nominal case").growth
}

pub(crate) fn growth_of_levels() -> Row {
    let (mut growth, spectrum) = (mixed(), campaigns()[0][0].clone());
    let mut vehicles = growth.vehicles().to_vec();
    let rate = 2.5e-7;
    for vehicle in &mut vehicles {
        vehicle.growth.rates.fill(rate);
    }
    growth = TrafficGrowth::new(growth.bands().to_vec(), vehicles).expect("the same bands");
    let forecast = Forecast::new(&spectrum, growth).expect("bands of the map");
    let passages = 4e6;
    let worst = forecast
        .bands()
        .iter()
        .map(|band| band.level(passages) - band.now.level - 20.0 / LN_10)
        .fold(0.0, |worst: f64, error| worst.max(error.abs()));
    Row {
        statement: "A growth rate of 2.5e-7 for 4·10⁶ passages raises every level by 20/ln 10",
        source: "ΔL = (20/ln 10) g N",
        expected: "8.685890 dB".to_owned(),
        got: format!("8.685890 dB within {worst:.0e}"),
        tolerance: "1e-10 dB: rounding",
        holds: worst < 1e-10,
    }
}

pub(crate) fn mean_over_speeds() -> Row {
    let feedback = nominal(&[]).feedback;
    let (mean, deviation) = (30.0, 5.0);
    let wavelengths: Vec<f64> = (0..13).map(|k| 0.020 + 0.005 * f64::from(k)).collect();
    let speeds = SpeedDistribution::normal(mean, deviation).expect("speeds above zero");
    let found = MeanGrowth::compute(&[(feedback.clone(), 1.0)], &wavelengths, &speeds);
    let steps = 10_000;
    let fine = wavelengths.iter().map(|&wavelength| {
        let (mut sum, mut weight) = (0.0, 0.0);
        for step in 0..steps {
            let z = 8.0 * (f64::from(step) + 0.5) / f64::from(steps) - 4.0;
            let density = (-0.5 * z * z).exp();
            sum += density * feedback.at(wavelength, mean + z * deviation).growth_rate;
            weight += density;
        }
        sum / weight
    });
    let fine: Vec<f64> = fine.collect();
    let largest = fine.iter().fold(0f64, |largest, rate| largest.max(rate.abs()));
    let pairs = found.rates.iter().zip(&fine);
    let worst = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / largest;
    Row {
        statement: "Growth in the mean over 30 ± 5 m/s, 20–80 mm, is that of a sum over 10 000 speeds",
        source: "the normal distribution",
        expected: "the same".to_owned(),
        got: format!("within {worst:.0e} of the largest, from {} speeds", found.speeds),
        tolerance: "2e-4: the step of both sums at the tails cut off at four deviations",
        holds: worst < 2e-4,
    }
}

pub(crate) fn wear_coefficient_is_found() -> Row {
    let growth = mixed();
    let earlier = campaigns().swap_remove(3);
    // What the same rails would be with 2.2 times the wear, read with an error that repeats.
    let (factor, passages) = (2.2, 4e6);
    let later = earlier.iter().enumerate().map(|(record, spectrum)| {
        let forecast = Forecast::new(spectrum, growth.clone()).expect("bands of the map");
        let then = forecast.spectrum(factor * passages).expect("finite levels");
        let error = |index: i32| 0.5 * (2.4 * record as f64 + 5.3 * f64::from(index)).sin();
        then.map(|band| band.level + error(band.band.index())).expect("finite levels")
    });
    let later: Vec<Spectrum> = later.collect();
    let change = MeasuredChange::paired(earlier, later, passages).expect("pairs");
    let fit = WearFit::new(&change, &growth).expect("bands of the map");
    let (low, high) = fit.interval.unwrap_or((f64::NAN, f64::NAN));
    Row {
        statement: "Eight rails that grow with 2.2 times the wear coefficient of the case give it back",
        source: "spectra of Niederwangen, grown by the model, with an error of ±0.5 dB",
        expected: "2.2".to_owned(),
        got: format!("{:.2}, 95 % interval {low:.2} to {high:.2}", fit.factor),
        tolerance: "the interval, by the scatter of the records",
        holds: fit.verdict == WearVerdict::Fitted && low < factor && factor < high,
    }
}

pub(crate) fn fading_mark_is_not_fitted() -> Row {
    let mut campaigns = campaigns();
    let (later, earlier) = (campaigns.swap_remove(3), campaigns.swap_remove(0));
    // 2014-03-01 to 2015-10-01 with the axles of the example.
    let change = MeasuredChange::paired(earlier, later, 579.0 * 6000.0).expect("pairs");
    let fit = WearFit::new(&change, &mixed()).expect("bands of the map");
    let (low, high) = fit.interval.unwrap_or((f64::NAN, f64::NAN));
    let mark = fit.bands[0];
    Row {
        statement: "Niederwangen: from the first campaign to the last nothing grows as the model says, and no \
                    wear coefficient is claimed",
        source: "16 spectra of Müller-BBM, 2014–2015; traffic and track of the examples",
        expected: "none; −6.5 dB at 20 mm, difference of the energy means".to_owned(),
        got: format!("interval of the factor {low:.2} to {high:.2}; {:.1} dB at 20 mm", mark.measured),
        tolerance: "an interval that holds zero; half of the last digit",
        holds: !fit.verdict.is_fit() && (mark.measured + 6.5).abs() <= 0.05,
    }
}
