//! Polynomials in place of a model, by which a sampler finds its way.

use rand_xoshiro::Xoshiro256PlusPlus;
use riffel_numerics::least_squares::least_squares_of_several;
use riffel_numerics::matrix::{Matrix, dot};
use riffel_numerics::random_numbers::normal;

use crate::data::differences;
use crate::gaussian::Density;
use crate::moments::Moments;
use crate::posterior::{Named, Point, Posterior};

/// Most terms of a polynomial: four powers of seven parameters, three of eleven.
const MOST_TERMS: usize = 400;
/// Highest power.
const HIGHEST_POWER: usize = 6;
/// Places of which a polynomial is made, for each of its terms.
const PLACES_PER_TERM: usize = 3;
/// How much wider than the draws these places scatter: what is fitted holds in the tails as well.
const WIDER: f64 = 1.5;
/// Share of these places that a case must take.
const LEAST_SHARE: f64 = 0.8;
/// Distance from the middle, over the √n of n coordinates of unit variance, behind which polynomials are not trusted.
const TRUSTED: f64 = 2.5;

/// ln of the density that polynomials may miss where their slopes are to be trusted: less than a step of a sampler changes it by.
const MOST_MISSED: f64 = 0.5;

/// What a model predicts, by one polynomial for each datum in the values that it depends on.
///
/// Fitted by least squares to predictions at places drawn from a normal distribution. It only proposes: which draws are kept
/// follows from the model itself.
#[derive(Debug, Clone)]
pub(crate) struct Emulator(Vec<Polynomials>);

/// The polynomials of the data of a block.
#[derive(Debug, Clone)]
struct Polynomials {
    touched_by: Vec<usize>,
    /// Of the smooth coordinates of the places, from there to those of unit covariance, and back for slopes.
    middle: Vec<f64>,
    turn: Matrix,
    back: Matrix,
    /// A term is an earlier one times a coordinate; the first is one.
    terms: Vec<(usize, usize)>,
    /// Factors by terms, for all data in turn.
    by_term: Vec<f64>,
    /// Factors by data.
    by_datum: Vec<f64>,
    /// Number of data.
    data: usize,
}

/// A place as polynomials see it.
struct Seen {
    /// Of unit covariance.
    coordinates: Vec<f64>,
    /// From the middle.
    distance: f64,
    /// Derivatives of the smooth coordinates by z.
    slopes: Vec<f64>,
    terms: Vec<f64>,
}

impl Seen {
    /// How far it is behind where polynomials are to be trusted, if that is positive.
    fn beyond(&self) -> f64 {
        self.distance - (self.coordinates.len() as f64).sqrt() - TRUSTED
    }
}

impl Emulator {
    /// For draws about a middle with the covariance LLᵀ of their `spread`. `None` if the model refuses too many of them.
    pub(crate) fn train(
        posterior: &Posterior,
        (middle, spread): (&[f64], &Matrix),
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Self> {
        let train = |named| Polynomials::train(posterior, named, (middle, spread), random);
        let blocks: Option<Vec<Polynomials>> = posterior.blocks.iter().map(train).collect();
        blocks.map(Self)
    }

    /// ln of the density and its gradient as the polynomials have them; `None` if the priors or they themselves end.
    pub(crate) fn at(&self, posterior: &Posterior, place: &[f64]) -> Option<Point> {
        let seen: Vec<Seen> = self.0.iter().map(|it| it.seen(posterior, place)).collect();
        let known = posterior.with_predictions(place, &self.predict(&seen))?;
        let mut point = self.with_slopes(known, &seen)?;
        // Far from where they were made, polynomials go anywhere.
        for (polynomials, seen) in self.0.iter().zip(&seen) {
            let beyond = seen.beyond();
            if beyond > 0.0 {
                point.log_density -= 2.0 * beyond * beyond;
                let factor = -4.0 * beyond / seen.distance;
                let slopes = seen.coordinates.iter().map(|it| factor * it).collect();
                polynomials.add_slopes(&mut point.gradient, seen, slopes);
            }
        }
        Some(point)
    }

    /// ln of the density as the model has it, with the slopes of the polynomials where these are to be trusted: near where they were
    /// made, and where they have the density of the model. Elsewhere with those of the model, or a chain that the polynomials misled
    /// would stay where they led it.
    pub(crate) fn along(&self, posterior: &Posterior, place: &[f64]) -> Option<Point> {
        let seen: Vec<Seen> = self.0.iter().map(|it| it.seen(posterior, place)).collect();
        if seen.iter().any(|seen| seen.beyond() > 0.0) {
            return posterior.at(place);
        }
        let predicted = posterior.predictions_at(place)?;
        let known = posterior.with_predictions(place, &predicted)?;
        let emulated = posterior.with_predictions(place, &self.predict(&seen));
        let misses = |(point, _): (Point, _)| (point.log_density - known.0.log_density).abs();
        match emulated.map(misses) {
            Some(misses) if misses < MOST_MISSED => self.with_slopes(known, &seen),
            _ => posterior.at(place),
        }
    }

    fn predict(&self, seen: &[Seen]) -> Vec<Vec<f64>> {
        let predicted = self.0.iter().zip(seen);
        predicted.map(|(it, seen)| it.predict(seen)).collect()
    }

    fn with_slopes(&self, (mut point, densities): (Point, Vec<Density>), seen: &[Seen]) -> Option<Point> {
        for ((polynomials, density), seen) in self.0.iter().zip(densities).zip(seen) {
            let slopes = polynomials.by_coordinates(seen, &density.by_prediction);
            polynomials.add_slopes(&mut point.gradient, seen, slopes);
        }
        point.is_finite().then_some(point)
    }
}

impl Polynomials {
    fn train(
        posterior: &Posterior,
        named: &Named,
        (middle, spread): (&[f64], &Matrix),
        random: &mut Xoshiro256PlusPlus,
    ) -> Option<Self> {
        let own = &named.touched_by;
        let covariance = Matrix::of(own.len(), |i, j| dot(spread.row(own[i]), spread.row(own[j])));
        let lower = covariance.cholesky()?;
        let terms = terms_of(own.len());
        let count = terms.len();
        let wanted = PLACES_PER_TERM * count;
        let (mut places, mut data, mut place) = (Vec::new(), Vec::new(), middle.to_vec());
        for _ in 0..wanted {
            let drawn: Vec<f64> = own.iter().map(|_| WIDER * normal(random)).collect();
            let beside = lower.times(&drawn).into_iter().zip(own);
            beside.for_each(|(beside, index)| place[*index] = middle[*index] + beside);
            let values = posterior.values(&place);
            if let Ok(predicted) = named.block.predict(&posterior.model.trial(&values)) {
                places.push(place.clone());
                data.push(predicted);
            }
        }
        if (places.len() as f64) < LEAST_SHARE * wanted as f64 {
            return None;
        }
        let mut moments = Moments::new(own.len());
        for place in &places {
            let smooth = own.iter().map(|index| posterior.smooth(place, *index).0);
            moments.add(&smooth.collect::<Vec<f64>>());
        }
        let scale = WIDER * WIDER * moments.count;
        moments.scatter.values.iter_mut().for_each(|it| *it /= scale);
        let turn = moments.scatter.cholesky()?.inverse_of_triangle();
        let mut polynomials = Self {
            touched_by: own.clone(),
            back: turn.transposed(),
            turn,
            middle: moments.mean,
            terms,
            by_term: Vec::new(),
            by_datum: Vec::new(),
            data: named.block.observed().len(),
        };
        let rows = places.iter();
        let rows: Vec<Vec<f64>> = rows.map(|it| polynomials.seen(posterior, it).terms).collect();
        let column = |rows: &[Vec<f64>], k: usize| rows.iter().map(|row| row[k]).collect::<Vec<f64>>();
        let mut columns: Vec<Vec<f64>> = (0..count).map(|k| column(&rows, k)).collect();
        let sides = (0..polynomials.data).map(|datum| column(&data, datum)).collect();
        let factors = least_squares_of_several(&mut columns, sides);
        polynomials.by_term = (0..count).flat_map(|k| column(&factors, k)).collect();
        polynomials.by_datum = factors.concat();
        Some(polynomials)
    }

    fn seen(&self, posterior: &Posterior, place: &[f64]) -> Seen {
        let own = self.touched_by.iter();
        let smooth = own.map(|index| posterior.smooth(place, *index));
        let (smooth, slopes): (Vec<f64>, Vec<f64>) = smooth.unzip();
        let coordinates = self.turn.times(&differences(&smooth, &self.middle));
        let mut terms = vec![1.0; self.terms.len()];
        for (k, (before, coordinate)) in self.terms.iter().enumerate().skip(1) {
            terms[k] = terms[*before] * coordinates[*coordinate];
        }
        Seen { distance: dot(&coordinates, &coordinates).sqrt(), coordinates, slopes, terms }
    }

    fn predict(&self, seen: &Seen) -> Vec<f64> {
        let mut predicted = vec![0.0; self.data];
        let factors = self.by_term.chunks_exact(self.data.max(1));
        let terms = seen.terms.iter().zip(factors);
        terms.for_each(|(term, factors)| add(&mut predicted, *term, factors));
        predicted
    }

    /// Derivatives by the coordinates of what has derivatives by the predictions.
    fn by_coordinates(&self, seen: &Seen, by_prediction: &[f64]) -> Vec<f64> {
        let Seen { coordinates, terms, .. } = seen;
        let mut by_terms = vec![0.0; terms.len()];
        let factors = self.by_datum.chunks_exact(terms.len());
        let data = by_prediction.iter().zip(factors);
        data.for_each(|(by, factors)| add(&mut by_terms, *by, factors));
        let mut by_coordinates = vec![0.0; coordinates.len()];
        for (k, (before, coordinate)) in self.terms.iter().enumerate().skip(1).rev() {
            by_coordinates[*coordinate] += by_terms[k] * terms[*before];
            by_terms[*before] += by_terms[k] * coordinates[*coordinate];
        }
        by_coordinates
    }

    /// Add derivatives by the coordinates to a gradient by all z.
    fn add_slopes(&self, gradient: &mut [f64], seen: &Seen, by_coordinates: Vec<f64>) {
        let by_smooth = self.back.times(&by_coordinates);
        let own = self.touched_by.iter().zip(by_smooth).zip(&seen.slopes);
        own.for_each(|((index, by_smooth), slope)| gradient[*index] += by_smooth * slope);
    }
}

/// All products of some coordinates up to a power, each as an earlier one times a coordinate.
fn terms_of(coordinates: usize) -> Vec<(usize, usize)> {
    let mut terms = vec![(0, 0)];
    // Terms of the last power, and the coordinate from which on they may be multiplied.
    let mut last = vec![(0, 0)];
    for _ in 0..HIGHEST_POWER {
        let next: Vec<(usize, usize)> =
            last.iter().flat_map(|(term, from)| (*from..coordinates).map(|coordinate| (*term, coordinate))).collect();
        if next.is_empty() || terms.len() + next.len() > MOST_TERMS {
            break;
        }
        let first = terms.len();
        last = next.iter().enumerate().map(|(k, (_, coordinate))| (first + k, *coordinate)).collect();
        terms.extend(next);
    }
    terms
}

/// sum += factor · of.
fn add(sum: &mut [f64], factor: f64, of: &[f64]) {
    sum.iter_mut().zip(of).for_each(|(sum, of)| *sum += factor * of);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::draw::random;

    /// Products up to the highest power or to 400: of no coordinate, of one, two, seven and eleven.
    #[test]
    fn terms_are_products_of_earlier_ones() {
        let counts = [0, 1, 2, 7, 11].map(|coordinates| terms_of(coordinates).len());
        assert_eq!(counts, [1, 7, 28, 330, 364]);
        // 1; x, y; x², xy, y²; …
        assert_eq!(terms_of(2)[..6], [(0, 0), (0, 0), (0, 1), (1, 0), (1, 1), (2, 1)]);
    }

    /// About the truth of three dates with a third of the width of the priors: levels to a tenth of their error of 0.5 dB in the
    /// mean, the gradient as the differences of the density have it, and along the model the density of the model.
    #[test]
    fn an_emulator_follows_its_model() {
        let plan = crate::fixtures::folder("b-three-dates").join("plan.toml");
        let posterior = crate::Plan::read(&plan).unwrap().posterior;
        let middle = posterior.place(&[3.5e-9, 0.6, 0.17, 32.0, 2.5, 460.0, 2.3e8, 0.4]);
        let parameters = posterior.parameters();
        let size = parameters.len();
        let deviation: Vec<f64> = parameters.iter().map(|it| it.prior.variance().sqrt() / 3.0).collect();
        let spread = Matrix::of(size, |i, j| if i == j { deviation[i] } else { 0.0 });
        let mut random = random(1, 0, 0);
        let emulator = Emulator::train(&posterior, (&middle, &spread), &mut random).unwrap();
        let mut squares = 0.0;
        for _ in 0..20 {
            let beside = deviation.iter().map(|it| it * normal(&mut random));
            let place: Vec<f64> = beside.zip(&middle).map(|(beside, middle)| middle + beside).collect();
            let expected = posterior.predictions_at(&place).unwrap();
            let polynomials = &emulator.0[0];
            let predicted = polynomials.predict(&polynomials.seen(&posterior, &place));
            let errors = differences(&predicted, &expected[0]);
            squares += dot(&errors, &errors) / (20 * errors.len()) as f64;
            let point = emulator.at(&posterior, &place).unwrap();
            for (index, slope) in point.gradient.iter().enumerate() {
                let h = 1e-5;
                let moved = |sign: f64| {
                    let mut place = place.clone();
                    place[index] += sign * h;
                    emulator.at(&posterior, &place).unwrap().log_density
                };
                let difference = (moved(1.0) - moved(-1.0)) / (2.0 * h);
                assert!((slope - difference).abs() < 1e-6 * (1.0 + slope.abs()), "{index}: {slope} {difference}");
            }
            let along = emulator.along(&posterior, &place).unwrap();
            assert_eq!(Some(along.log_density), posterior.log_density(&place));
            let exact = posterior.at(&place).unwrap().gradient;
            let scaled = |gradient: &[f64]| -> Vec<f64> {
                let pairs = gradient.iter().zip(&deviation);
                pairs.map(|(slope, deviation)| slope * deviation).collect()
            };
            let (slopes, exact) = (scaled(&along.gradient), scaled(&exact));
            let lengths = (dot(&slopes, &slopes) * dot(&exact, &exact)).sqrt();
            assert!(dot(&slopes, &exact) > 0.98 * lengths, "{slopes:?} {exact:?}");
        }
        assert!(squares.sqrt() < 0.05, "{} dB", squares.sqrt());
    }
}
