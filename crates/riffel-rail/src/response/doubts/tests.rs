//! Made-up responses of random tracks, as they are and with one fault each.

use riffel::receptance::{Beam, ContinuousTrack, Layer, PeriodicTrack, ShearSection, Support};
use riffel::{ElasticMaterial, Receptance};

use super::double_hit::time_between_hits;
use super::mirrored::mirrored_from;
use super::phase::{PhaseFault, phase_fault};
use super::*;

/// Responses of each kind.
const COUNT: u32 = 200;

/// Numbers that are drawn one after the other.
struct Draws(u64);

impl Draws {
    fn uniform(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        low + (high - low) * (self.0 >> 33) as f64 / (1u64 << 31) as f64
    }

    /// Evenly drawn logarithm.
    fn of_scale(&mut self, low: f64, high: f64) -> f64 {
        self.uniform(low.ln(), high.ln()).exp()
    }

    fn one_of<T: Copy>(&mut self, all: &[T]) -> T {
        all[self.uniform(0.0, all.len() as f64) as usize]
    }

    /// Of a standard deviation of one.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.uniform(-0.5, 0.5)).sum()
    }

    /// Free, on one layer or two, evenly spread or at discrete places under the wheel or beside it.
    fn track(&mut self) -> Box<dyn Receptance> {
        let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
        let moment = self.uniform(1.5e-5, 3.2e-5);
        let section = ShearSection {
            area: self.uniform(5.5e-3, 8.5e-3),
            shear_coefficient: 0.4,
            shear_modulus: 81e9,
            density: 7850.0,
        };
        let rail = Beam::timoshenko(steel, moment, 7850.0 * section.area, section);
        let rail = rail.unwrap().with_loss_factor(self.of_scale(0.002, 0.03)).unwrap();
        let mut layer = |low: f64, high: f64, loss: f64| {
            let layer = Layer::new(self.of_scale(low, high), self.of_scale(5e3, 1e5));
            layer.unwrap().with_loss_factor(self.uniform(0.0, loss)).unwrap()
        };
        let (pad, ballast) = (layer(3e7, 1.5e9, 0.3), layer(2e7, 3e8, 1.5));
        let two = Support::two_layer(pad, self.uniform(50.0, 170.0), ballast).unwrap();
        let support = self.one_of(&[Support::one_layer(pad), two, two]);
        let spacing = self.uniform(0.5, 0.75);
        match self.one_of(&[0, 1, 1, 2, 2, 2]) {
            0 => Box::new(ContinuousTrack::free(rail)),
            1 => Box::new(ContinuousTrack::new(rail, support.per_metre(spacing).unwrap())),
            _ => {
                let track = PeriodicTrack::new(rail, support, spacing).unwrap();
                Box::new(track.at(self.one_of(&[0.0, 0.5]) * spacing))
            }
        }
    }

    /// Frequencies \[Hz\] from 20 to 120 up to 1000 to 4000, in even steps or in shares of an octave.
    fn frequencies(&mut self, even: bool) -> Vec<f64> {
        let (lowest, highest) = (self.uniform(20.0, 120.0), self.of_scale(1000.0, 4000.0));
        if even || self.uniform(0.0, 1.0) < 0.6 {
            let step = self.one_of(&[1.0, 2.0, 4.0, 8.0]);
            let (first, last) = ((lowest / step).ceil() as u32, (highest / step) as u32);
            return (first..=last).map(|line| step * f64::from(line)).collect();
        }
        let ratio = self.one_of(&[3.0f64, 6.0, 12.0, 24.0]).recip().exp2();
        let all = std::iter::successors(Some(lowest), |f| Some(f * ratio));
        all.take_while(|f| *f < highest).collect()
    }

    /// A response with noise of 1 to 5 % on each part.
    fn response(&mut self, even: bool) -> Vec<Line> {
        let (track, frequencies) = (self.track(), self.frequencies(even));
        let lines = frequencies.into_iter().map(|f| (f, track.receptance(TAU * f, 0.0)));
        self.noisy(lines.collect())
    }

    fn noisy(&mut self, mut lines: Vec<Line>) -> Vec<Line> {
        let noise = self.uniform(0.01, 0.05);
        for (_, h) in &mut lines {
            *h *= 1.0 + noise * Complex64::new(self.normal(), self.normal());
        }
        lines
    }
}

/// How many of the drawn ones hold.
fn count(mut holds: impl FnMut(&mut Draws) -> bool) -> u32 {
    let mut draws = Draws(53);
    (0..COUNT).filter(|_| holds(&mut draws)).count() as u32
}

// Long: looks at 400 drawn hammer tests, as many as its counts are of.
#[test]
fn faults_of_phase_are_found() {
    let mut draws = Draws(53);
    let mut found = [0; 5];
    for _ in 0..COUNT {
        let lines = draws.response(false);
        let degrees = draws.of_scale(180.0, 1500.0) * draws.one_of(&[-1.0, 1.0]);
        let tau = degrees / 360.0 / lines.last().unwrap().0;
        let fault = |change: &dyn Fn(f64, Complex64) -> Complex64| {
            let changed: Vec<Line> = lines.iter().map(|(f, h)| (*f, change(*f, *h))).collect();
            phase_fault(&changed)
        };
        let delayed = |fault| matches!(fault, Some(PhaseFault::Delayed(delay)) if (delay / tau - 1.0).abs() < 0.5);
        let right = fault(&|_, h| h);
        for (count, is_found) in found.iter_mut().zip([
            right.is_none(),
            fault(&|_, h| h.conj()) == Some(PhaseFault::Conjugated),
            fault(&|_, h| -h) == Some(PhaseFault::Negated),
            fault(&|_, h| -h.conj()) == Some(PhaseFault::ConjugatedAndNegated),
            delayed(fault(&|f, h| h * Complex64::from_polar(1.0, -TAU * f * tau))),
        ]) {
            *count += u32::from(is_found);
        }
    }
    assert!(found[0] >= 198 && found.iter().all(|count| *count >= 190), "{found:?}");
}

// Long: looks at 400 drawn hammer tests, as many as its counts are of.
#[test]
fn double_hits_are_found() {
    let right = count(|draws| time_between_hits(&draws.response(true)).is_none());
    let found = count(|draws| {
        let (lines, strength) = (draws.response(true), draws.uniform(0.2, 0.7));
        let (first, last) = (lines[0].0, lines[lines.len() - 1].0);
        let step = (last - first) / (lines.len() - 1) as f64;
        let longest = (0.3 / step).min(0.3 * 1024.0 / (last - first)).min(0.05);
        let tau = draws.of_scale(15.0 / (last - first), longest);
        let inverse = draws.one_of(&[-1.0, 1.0]);
        let hit = |f: f64| 1.0 + Complex64::from_polar(strength, -TAU * f * tau);
        let lines: Vec<Line> = lines.iter().map(|(f, h)| (*f, h * hit(*f).powf(inverse))).collect();
        time_between_hits(&lines).is_some_and(|found| (found / tau - 1.0).abs() < 0.05)
    });
    assert!(right >= 198 && found >= 190, "{right} {found}");
}

#[test]
fn mirrored_halves_are_found() {
    let right = count(|draws| mirrored_from(&draws.response(false)).is_none());
    let found = count(|draws| {
        let (track, frequencies) = (draws.track(), draws.frequencies(true));
        let (last, share) = (frequencies[frequencies.len() - 1], draws.uniform(0.1, 1.0));
        let mut lines: Vec<Line> = frequencies.iter().map(|f| (*f, track.receptance(TAU * f, 0.0))).collect();
        let above = (share * lines.len() as f64) as usize;
        let mirrored = lines.iter().rev().skip(1).take(above);
        let mirrored: Vec<Line> = mirrored.map(|(f, h)| (2.0 * last - f, h.conj())).collect();
        lines.extend(mirrored);
        mirrored_from(&draws.noisy(lines)).is_some_and(|found| (found / last - 1.0).abs() < 0.01)
    });
    assert!(right >= 198 && found >= 190, "{right} {found}");
}
