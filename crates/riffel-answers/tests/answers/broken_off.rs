//! Answers that nobody waits for any more.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use riffel::cancel::run_while;
use riffel::passage::Sinusoid;
use riffel_answers::LineGrowth;
use riffel_answers::rail_damage::RailDamage;
use riffel_answers::remedies::RemediesAnswer;
use riffel_answers::ridge::ridge_of;
use riffel_answers::simulate::{SinusoidAnswer, SinusoidRequest};
use riffel_answers::stability_map::StabilityMap;
use riffel_case::{METRO_CURVE_CASE, NOMINAL_CASE};

use crate::coarse;

/// How often work asks whether it is wanted, and whether it ends when it is not from the half of that on.
fn ends_half_way(work: impl Fn() + Send + Sync) -> usize {
    let asked = Arc::new(AtomicUsize::new(0));
    let count = asked.clone();
    let counted = move || {
        count.fetch_add(1, Ordering::Relaxed);
        true
    };
    assert!(run_while(counted, &work).is_some());
    let often = asked.swap(0, Ordering::Relaxed);
    let half = move || asked.fetch_add(1, Ordering::Relaxed) < often / 2;
    assert!(run_while(half, &work).is_none(), "{often}");
    often
}

/// In steps of a fiftieth or less: what takes seconds is gone after hundredths.
// Long: computes seven long answers whole and then up to their half.
#[test]
fn every_long_answer_ends_where_it_stands() {
    let wheelset = include_str!("../../../../cases/wheelset-tram.toml");
    // A case remembers what its parts have answered: each run has its own.
    let nominal = || coarse(NOMINAL_CASE, &[]);
    let curve = || coarse(METRO_CURVE_CASE, &[]);
    let wheelset = || coarse(wheelset, &[]);
    let wave = [0.06, 15.0];
    let often = [
        ends_half_way(|| {
            let case = wheelset();
            drop(ridge_of(&case, &case.feedback));
        }),
        ends_half_way(|| drop(LineGrowth::new(&wheelset(), None).unwrap())),
        ends_half_way(|| drop(LineGrowth::new(&curve(), None).unwrap())),
        ends_half_way(|| drop(RailDamage::new(&nominal(), None, wave).unwrap())),
        ends_half_way(|| drop(RemediesAnswer::new(&nominal(), None, &|_| ()).unwrap())),
        ends_half_way(|| {
            drop(StabilityMap::new(&curve(), &[0.2, 0.4], &|_| ()).unwrap());
        }),
        ends_half_way(|| {
            let profile = Sinusoid { wavelength: 0.06, amplitude: 10e-6 };
            let request = SinusoidRequest::new(15.0, profile, None).unwrap();
            drop(SinusoidAnswer::new(&nominal(), request).unwrap());
        }),
    ];
    assert!(often.iter().all(|&often| often >= 50), "{often:?}");
}
