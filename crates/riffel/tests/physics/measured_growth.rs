//! How often the bands of measured growth hold the truth.

use rand_xoshiro::Xoshiro256PlusPlus;
use rand_xoshiro::rand_core::{Rng, SeedableRng};
use riffel::forecast::MeasuredGrowth;
use riffel::roughness::{Spectrum, ThirdOctave};

/// Growth of the bands \[dB a year\], about those of a corrugated rail.
const GROWTH: [f64; 6] = [0.2, 1.0, 4.0, 5.5, 1.5, 0.5];
/// The limit is so much over the level now \[dB\].
const LEFT: f64 = 6.0;

/// What a rail is read with.
struct Made {
    dates: usize,
    places: usize,
    paired: bool,
    /// Scatter of a place, of which a share is that of its neighbour, and what all places of a date have in common \[dB\].
    scatter: f64,
    shared: f64,
    common: f64,
    /// Scatter of the growth of places \[dB a year\].
    growing: f64,
}

struct Random(Xoshiro256PlusPlus);

impl Random {
    /// Box & Muller.
    fn normal(&mut self) -> f64 {
        let mut uniform = || ((self.0.next_u64() >> 11) as f64 + 0.5) / (1u64 << 53) as f64;
        let (a, b) = (uniform(), uniform());
        (-2.0 * a.ln()).sqrt() * (std::f64::consts::TAU * b).cos()
    }
}

impl Made {
    /// A rail that grows exactly so, as it was read at each date; with its true levels now.
    fn rail(&self, random: &mut Random) -> (Vec<(f64, Vec<Spectrum>)>, Vec<f64>) {
        let own: Vec<Vec<f64>> =
            (0..self.places).map(|_| GROWTH.iter().map(|_| 1.5 * random.normal()).collect()).collect();
        let faster: Vec<Vec<f64>> =
            (0..self.places).map(|_| GROWTH.iter().map(|_| self.growing * random.normal()).collect()).collect();
        // Dates of a measuring train: not every year is the same.
        let times: Vec<f64> = (0..self.dates).map(|k| k as f64 + 0.3 * (k as f64).sin()).collect();
        let now = times[self.dates - 1];
        let dates = times.iter().map(|&time| {
            let common: Vec<f64> = GROWTH.iter().map(|_| self.common * random.normal()).collect();
            let mut error = vec![0.0; GROWTH.len()];
            let records = own.iter().zip(&faster).map(|(own, faster)| {
                let levels = GROWTH.iter().enumerate().map(|(k, growth)| {
                    let fresh = (1.0 - self.shared * self.shared).sqrt() * random.normal();
                    error[k] = self.shared * error[k] + fresh;
                    let other = if self.paired { own[k] } else { 1.5 * random.normal() };
                    let level = (growth + faster[k]) * (time - now) + other + common[k] + self.scatter * error[k];
                    (ThirdOctave::new(k as i32 - 13), level)
                });
                Spectrum::new(levels).unwrap()
            });
            (time, records.collect())
        });
        let dates = dates.collect();
        let truth = (0..GROWTH.len()).map(|k| {
            let mean = match self.paired {
                true => own.iter().map(|own| 10f64.powf(own[k] / 10.0)).sum::<f64>() / self.places as f64,
                // Of the log-normal squares.
                false => (0.5 * (0.15 * std::f64::consts::LN_10).powi(2)).exp(),
            };
            // Errors, too, raise the mean of squares.
            10.0 * mean.log10() + 0.05 * std::f64::consts::LN_10 * self.scatter.powi(2)
        });
        let truth = truth.collect();
        (dates, truth)
    }
}

/// On 1000 rails each, of 2, 3 and 6 dates, the bands of 80 % of growth, of the level in a year and of the time to a limit hold the truth
/// 75 to 85 times of 100: with independent places, with places that scatter as their neighbours do, with other places at every date,
/// with an instrument that reads all of a date too high or low, which two dates alone cannot tell, and with places that grow each at its
/// own rate.
// Long: fits 14 000 drawn rails, as many as its bounds of coverage are of.
#[test]
fn the_bands_hold_the_truth_as_often_as_they_say() {
    const RAILS: usize = 1000;
    let mut random = Random(Xoshiro256PlusPlus::seed_from_u64(54));
    let made = |dates, places, paired, shared, common| Made {
        dates,
        places,
        paired,
        scatter: 0.6,
        shared,
        common,
        growing: 0.0,
    };
    let unlike = |dates| Made { growing: 0.15, ..made(dates, 20, true, 0.0, 0.0) };
    let cases = [
        made(2, 20, true, 0.0, 0.0),
        made(3, 20, true, 0.0, 0.0),
        made(6, 20, true, 0.0, 0.0),
        made(2, 5, true, 0.0, 0.0),
        made(2, 40, true, 0.3, 0.0),
        made(2, 20, false, 0.0, 0.0),
        made(6, 20, false, 0.0, 0.0),
        made(3, 20, true, 0.0, 0.5),
        made(6, 20, true, 0.0, 0.5),
        made(3, 1, true, 0.0, 0.0),
        made(6, 1, true, 0.0, 0.0),
        unlike(2),
        unlike(3),
        unlike(6),
    ];
    for case in cases {
        let mut held = [0.0; 3];
        for _ in 0..RAILS {
            let (dates, now) = case.rail(&mut random);
            let growth = MeasuredGrowth::new(&dates, case.paired).unwrap();
            let last = Spectrum::energy_mean(&dates[case.dates - 1].1).unwrap();
            for (k, band) in growth.bands().iter().enumerate() {
                let share = 1.0 / (RAILS * GROWTH.len()) as f64;
                let is_in = |[low, high]: [f64; 2], truth: f64| {
                    if low <= truth && truth <= high { share } else { 0.0 }
                };
                held[0] += is_in(band.slope_within()[1], GROWTH[k]);
                let measured = last.level(band.band).unwrap();
                let change = band.change_80(1.0, true);
                held[1] += is_in(change.map(|it| measured + it), now[k] + GROWTH[k]);
                let limit = now[k] + LEFT;
                let [early, late] = band.time_80(limit - measured, true);
                let within = [early.unwrap_or(f64::INFINITY), late.unwrap_or(f64::INFINITY)];
                held[2] += is_in(within, LEFT / GROWTH[k]);
            }
        }
        let Made { dates, places, paired, shared, common, growing, .. } = case;
        // The mean of places that grow unlike bends upward, and its level is none of a straight line.
        let told = if growing > 0.0 { 1 } else { 3 };
        assert!(
            held.iter().take(told).all(|share| (0.75..=0.85).contains(share)),
            "{dates} dates of {places} places, {paired} {shared} {common} {growing}: {held:?}"
        );
    }
}
