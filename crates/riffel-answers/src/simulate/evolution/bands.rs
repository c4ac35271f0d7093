//! Third-octave bands of the waves of a ring.

use std::f64::consts::TAU;
use std::ops::Range;

use riffel::Complex64;
use riffel::roughness::ThirdOctave;
use riffel_case::Case;
use riffel_case::traffic::bands_of;

/// The bands of a case that wear and have a wave on the ring, the shortest first, each with its places in
/// [`waves`](riffel::passage::Evolution::waves).
pub(super) struct Bands {
    bands: Vec<(ThirdOctave, Range<usize>)>,
    /// Bays of the ring, where supports are discrete.
    bays: Option<usize>,
}

impl Bands {
    /// Those above the shortest wavelength that wears \[m\], on a ring of the given number of heights and length \[m\], of whole bays.
    pub(super) fn new(case: &Case, shortest: f64, heights: usize, length: f64) -> Self {
        let places = |band: ThirdOctave| {
            let (low, high) = band.wavelength_range();
            // The wave n of length/n is the entry n − 1.
            let place = |wavelength: f64| ((length / wavelength).floor() as usize).min(heights / 2);
            (low >= shortest).then_some((band, place(high)..place(low)))
        };
        let bands = bands_of(case).into_iter().filter_map(places);
        let bay = case.track.support_spacing();
        Self {
            bands: bands.filter(|(_, places)| !places.is_empty()).collect(),
            bays: bay.map(|bay| (length / bay).round() as usize),
        }
    }

    pub(super) fn count(&self) -> usize {
        self.bands.len()
    }

    pub(super) fn iter(&self) -> impl Iterator<Item = (ThirdOctave, Range<usize>)> + '_ {
        self.bands.iter().cloned()
    }

    /// Mean square of each band \[m²\].
    pub(super) fn mean_squares(&self, waves: &[(f64, Complex64)]) -> Vec<f64> {
        let power = |(_, amplitude): &(f64, Complex64)| 0.5 * amplitude.norm_sqr();
        self.iter().map(|(_, places)| waves[places].iter().map(power).sum()).collect()
    }

    /// Mean square of the waves that fit into a bay, those of the bands alone \[m²\]; none on a track that is even.
    pub(super) fn mean_square_of_bay(&self, waves: &[(f64, Complex64)]) -> Option<f64> {
        let bays = self.bays?;
        let places = self.iter().flat_map(|(_, places)| places);
        // The wave n of the ring is the entry n − 1.
        let of_bay = places.filter(|place| (place + 1).is_multiple_of(bays));
        Some(of_bay.map(|place| 0.5 * waves[place].1.norm_sqr()).sum())
    }

    /// How far the waves of each band have moved along the rail \[m\], in the mean of their power; less than half a wave.
    ///
    /// A wave moved by s has its amplitude times e^{−i2πs/λ}.
    pub(super) fn shifts(&self, before: &[(f64, Complex64)], after: &[(f64, Complex64)]) -> Vec<f64> {
        let mean = |places: Range<usize>| {
            let pairs = before[places.clone()].iter().zip(&after[places]);
            let (moment, power) = pairs.fold((0.0, 0.0), |(moment, power), (one, other)| {
                let product = other.1 * one.1.conj();
                let shift = -product.arg() * one.0 / TAU;
                (moment + shift * product.norm(), power + product.norm())
            });
            match power {
                0.0 => 0.0,
                power => moment / power,
            }
        };
        self.iter().map(|(_, places)| mean(places)).collect()
    }
}
