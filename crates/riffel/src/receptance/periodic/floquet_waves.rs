//! Waves over a rail on even supports, and receptances that they make.

use num_complex::Complex64;
use riffel_numerics::square_root::square_root;

use crate::receptance::Waves;

/// The waves of a periodic track at one frequency, and its receptance between any two places.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FloquetWaves {
    rail: RailInBay,
    waves: [FloquetWave; 2],
}

/// One Floquet wave.
#[derive(Debug, Clone, Copy, PartialEq)]
struct FloquetWave {
    /// ρ, |ρ| ≤ 1.
    multiplier: Complex64,
    /// (cosh α₂d − c)/g and its divided difference over g, with g = cosh α_jd − c of the free wave farther from
    /// this one: where a support is weak, that of the nearer one vanishes.
    distance: [Complex64; 2],
    /// 1/(Ĝ'(c) sinh μ), scaled as the distances are.
    norm: Complex64,
}

impl FloquetWaves {
    pub(in crate::receptance) fn new(free: &Waves, stiffness: Complex64, spacing: f64) -> Self {
        let rail = RailInBay::new(free, spacing);
        let shifted = rail.shifted_cosine();
        let sine = rail.sine(spacing);
        // 1 + k Ĝ = 0 for c − 1, Ĝ by the quotient rule of divided differences.
        let product =
            shifted.first * shifted.second + stiffness * (sine.slope * shifted.second - sine.second * shifted.slope);
        let roots = match rail.count {
            1 => [product, Complex64::ZERO],
            _ => {
                let half = 0.5 * (shifted.first + shifted.second + stiffness * sine.slope);
                let root = square_root(half * half - product);
                let larger = if (half.conj() * root).re >= 0.0 { half + root } else { half - root };
                [larger, product / larger]
            }
        };
        let wave = |root: Complex64| {
            let first = shifted.first - root;
            let second = match rail.count {
                1 => Complex64::ONE,
                _ => shifted.second - root,
            };
            let farther = if first.norm_sqr() > second.norm_sqr() { first } else { second };
            let [first, second, slope] = [first, second, shifted.slope].map(|part| part / farther);
            let slope_of_sum = sine.slope * second * second - sine.second * (first + second) * slope;
            let sinh_mu = outgoing_sinh(root, slope_of_sum);
            FloquetWave {
                multiplier: (root + 1.0 + sinh_mu).inv(),
                distance: [second, slope],
                norm: (slope_of_sum * sinh_mu).inv(),
            }
        };
        Self { rail, waves: roots.map(wave) }
    }

    /// Factors ρ by which the waves change from one bay to the next, |ρ| ≤ 1: one for a bar, two for
    /// a beam. |ρ| = 1 for a wave that runs without loss.
    pub fn multipliers(&self) -> impl Iterator<Item = Complex64> {
        self.waves[..self.rail.count].iter().map(|wave| wave.multiplier)
    }

    /// Displacement at `to` per force at `from` \[m/N\], both \[m\] from the support at x = 0.
    pub fn receptance(&self, from: f64, to: f64) -> Complex64 {
        let station = self.station(from);
        if from == to {
            return self.between(&station, &station);
        }
        self.between(&station, &self.station(to))
    }

    /// [`receptance`](Self::receptance) from one place to several. Places that stand alike in their bays share the shapes of the
    /// waves there, to 1e-12 of the spacing.
    pub fn receptances(&self, from: f64, to: &[f64]) -> Vec<Complex64> {
        const ALIKE: f64 = 1e-12;
        let station = self.station(from);
        let waves = &self.waves[..self.rail.count];
        let mut known: Vec<(f64, [Complex64; 2])> = Vec::new();
        let value = |&to: &f64| {
            let place = InBay::new(to, self.rail.spacing);
            if place < station.place {
                return self.between(&station, &self.station(to));
            }
            let within = place.within;
            let like = |shape: &&(f64, [Complex64; 2])| (shape.0 - within).abs() <= ALIKE * self.rail.spacing;
            let shapes = match known.iter().find(like) {
                Some(shape) => shape.1,
                None => {
                    let sines = self.rail.sines(within);
                    let mut shapes = [Complex64::ZERO; 2];
                    for (shape, wave) in shapes.iter_mut().zip(waves) {
                        let ahead = wave.shape(&sines, wave.multiplier);
                        let back = wave.shape(&station.sines, wave.multiplier.inv());
                        *shape = ahead * back * wave.norm;
                    }
                    known.push((within, shapes));
                    shapes
                }
            };
            let bays = (place.bay - station.place.bay) as i32;
            let waves = waves.iter().zip(shapes);
            waves.map(|(wave, shape)| shape * wave.multiplier.powi(bays)).sum()
        };
        to.iter().map(value).collect()
    }

    /// A place \[m\] from the support at x = 0, for as many receptances as start or end there.
    pub(in crate::receptance) fn station(&self, along: f64) -> Station {
        let place = InBay::new(along, self.rail.spacing);
        Station { sines: self.rail.sines(place.within), place }
    }

    /// Displacement at one place per force at another \[m/N\].
    pub(in crate::receptance) fn between(&self, one: &Station, other: &Station) -> Complex64 {
        let (left, right) = if one.place <= other.place { (one, other) } else { (other, one) };
        let bays = right.place.bay - left.place.bay;
        self.waves[..self.rail.count]
            .iter()
            .map(|wave| {
                let ahead = wave.shape(&right.sines, wave.multiplier);
                let back = wave.shape(&left.sines, wave.multiplier.inv());
                let within = ahead * back * wave.norm;
                if bays == 0.0 {
                    return within;
                }
                within * wave.multiplier.powi(bays as i32)
            })
            .sum()
    }
}

/// A place along a rail between two supports.
#[derive(Debug, Clone, Copy, PartialEq, PartialOrd)]
pub(in crate::receptance) struct InBay {
    /// Number of the support at or before it.
    pub(in crate::receptance) bay: f64,
    /// Distance from that \[m\].
    pub(in crate::receptance) within: f64,
}

impl InBay {
    pub(in crate::receptance) fn new(along: f64, spacing: f64) -> Self {
        let bay = (along / spacing).floor();
        Self { bay, within: (along - bay * spacing).clamp(0.0, spacing) }
    }
}

/// A place along the rail, with the sines of its free waves over the rest of the bay and over what is gone of it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::receptance) struct Station {
    place: InBay,
    sines: [OverWaves; 2],
}

impl FloquetWave {
    /// φ± with the factor of the wave, ρ or 1/ρ.
    fn shape(&self, [rest, gone]: &[OverWaves; 2], multiplier: Complex64) -> Complex64 {
        let [second, slope] = self.distance;
        (rest.slope + multiplier * gone.slope) * second - (rest.second + multiplier * gone.second) * slope
    }
}

/// A function f of z = α² at the free waves. A bar has one: f and its slope are then f(z₁), and what stands for
/// the second is the neutral number of the quotient rule.
#[derive(Debug, Clone, Copy, PartialEq)]
struct OverWaves {
    first: Complex64,
    second: Complex64,
    /// (f(z₁) − f(z₂))/(z₁ − z₂).
    slope: Complex64,
}

/// The rail between two supports: q(z) sinh(√z x)/√z and cosh(√z d) − 1 over z = α² of its free waves.
///
/// With q of [`Waves::Beam`], A_j sinh α_jx = q(z_j) S(z_j)/(z_j − z_i), S(z) = sinh(√z x)/√z. A sum
/// ΣA_j sinh(α_jx)/(cosh α_jd − c) is then the divided difference of qS/(C − c) over the two waves, by the quotient
/// rule \[(qS)\[z₁, z₂\] (C(z₂) − c) − q(z₂)S(z₂) C\[z₁, z₂\]\]/\[(C(z₁) − c)(C(z₂) − c)\]. S and C are entire
/// functions of z. Where |z|d² ≤ 1 their divided differences come from their power series, in which nothing
/// cancels; beyond, from their values.
#[derive(Debug, Clone, Copy, PartialEq)]
struct RailInBay {
    spacing: f64,
    /// How many free waves there are.
    count: usize,
    /// α.
    propagation: [Complex64; 2],
    /// z = α².
    squares: [Complex64; 2],
    /// q₀ and q₁ of q(z) = q₀ + q₁z.
    transfer: [Complex64; 2],
    /// e^{αd/2}; `None` if the bay is short beside every wave.
    half_bay: Option<[Complex64; 2]>,
}

impl RailInBay {
    pub(in crate::receptance) fn new(free: &Waves, spacing: f64) -> Self {
        let (propagation, transfer) = match free {
            Waves::Bar(wave) => {
                ([wave.propagation, Complex64::ZERO], [wave.amplitude * wave.propagation, Complex64::ZERO])
            }
            Waves::Beam { waves, transfer } => (waves.map(|wave| wave.propagation), *transfer),
        };
        let squares = propagation.map(|alpha| alpha * alpha);
        let is_short = squares.iter().all(|z| z.norm_sqr() <= spacing.powi(-4));
        Self {
            spacing,
            count: free.as_slice().len(),
            propagation,
            squares,
            transfer,
            half_bay: (!is_short).then(|| propagation.map(|alpha| (0.5 * spacing * alpha).exp())),
        }
    }

    /// cosh(√z d) − 1.
    fn shifted_cosine(&self) -> OverWaves {
        let cosine = match self.half_bay {
            None => self.series(self.spacing, 0.5 * self.spacing * self.spacing, 2.0, 1),
            // 2 sinh²(αd/2) does not cancel.
            Some(half) => self.over_waves(half.map(|half| {
                let sine = 0.5 * (half - half.inv());
                2.0 * sine * sine
            })),
        };
        match self.count {
            1 => OverWaves { second: Complex64::ONE, slope: Complex64::ZERO, ..cosine },
            _ => cosine,
        }
    }

    /// q(z) sinh(√z x)/√z, 0 ≤ x ≤ d.
    fn sine(&self, x: f64) -> OverWaves {
        let sine = match self.half_bay {
            None => self.series(x, x, 1.0, 0),
            Some(_) => self.over_waves(self.propagation.map(|alpha| {
                let growth = (alpha * x).exp();
                0.5 * (growth - growth.inv()) / alpha
            })),
        };
        let [constant, linear] = self.transfer;
        if self.count == 1 {
            let value = constant * sine.first;
            return OverWaves { first: value, second: Complex64::ZERO, slope: value };
        }
        let q = self.squares.map(|z| constant + linear * z);
        OverWaves {
            first: q[0] * sine.first,
            second: q[1] * sine.second,
            slope: q[1] * sine.slope + linear * sine.first,
        }
    }

    /// The sines of the way ahead, d − x, and of that behind, x.
    fn sines(&self, x: f64) -> [OverWaves; 2] {
        [self.sine(self.spacing - x), self.sine(x)]
    }

    fn over_waves(&self, [first, second]: [Complex64; 2]) -> OverWaves {
        OverWaves { first, second, slope: (first - second) / (self.squares[0] - self.squares[1]) }
    }

    /// Σ aₙzⁿ from n = `first_power` on, with aₙ₊₁/aₙ = x²/((m + 1)(m + 2)), m rising by two from `m`: the series
    /// of sine and cosine. That of zⁿ has the divided difference hₙ₋₁ = z₁hₙ₋₂ + z₂ⁿ⁻¹.
    fn series(&self, x: f64, first_coefficient: f64, m: f64, first_power: u32) -> OverWaves {
        /// 1/(2n + 2)! is below a rounding from here on.
        const TERMS: u32 = 10;
        let [first, second] = self.squares;
        let mut coefficient = first_coefficient;
        let mut powers = self.squares.map(|z| z.powu(first_power));
        let mut difference = Complex64::from(f64::from(first_power));
        let mut m = m;
        let mut sum = OverWaves { first: Complex64::ZERO, second: Complex64::ZERO, slope: Complex64::ZERO };
        for _ in 0..TERMS {
            sum.first += coefficient * powers[0];
            sum.second += coefficient * powers[1];
            sum.slope += coefficient * difference;
            difference = first * difference + powers[1];
            powers = [powers[0] * first, powers[1] * second];
            coefficient *= x * x / ((m + 1.0) * (m + 2.0));
            m += 2.0;
        }
        sum
    }
}

/// The rail's answer to waves e^{ikx} of any wavenumber, at one frequency.
pub(in crate::receptance) struct AlongBay {
    rail: RailInBay,
    shifted: OverWaves,
    sine: OverWaves,
}

impl AlongBay {
    pub(in crate::receptance) fn new(free: &Waves, spacing: f64) -> Self {
        let rail = RailInBay::new(free, spacing);
        Self { shifted: rail.shifted_cosine(), sine: rail.sine(spacing), rail }
    }

    /// Displacement by forces e^{ikx} along a beam without supports, where they are one \[m²/N\]:
    /// Σ 2A_jα_j/(α_j² + k²) = 2(q₁k² − q₀)/∏(α_j² + k²).
    pub(in crate::receptance) fn wave_receptance(&self, k: f64) -> Complex64 {
        let [constant, linear] = self.rail.transfer;
        let [first, second] = self.rail.squares;
        let square = k * k;
        2.0 * (linear * square - constant) / ((first + square) * (second + square))
    }

    /// Ĝ \[m/N\]: displacement at a support by forces e^{ikmd} at all of them, m = 0, ±1, …
    pub(in crate::receptance) fn support_receptance(&self, k: f64) -> Complex64 {
        let half_sine = (0.5 * k * self.rail.spacing).sin();
        let cosine = -2.0 * half_sine * half_sine;
        let [first, second] = [self.shifted.first, self.shifted.second].map(|c| c - cosine);
        (self.sine.slope * second - self.sine.second * self.shifted.slope) / (first * second)
    }
}

/// sinh μ of the outgoing wave, |e^{−μ}| < 1, for c = cosh μ given as c − 1.
pub(in crate::receptance) fn outgoing_sinh(shifted: Complex64, slope: Complex64) -> Complex64 {
    /// Below this the imaginary part of c is rounding, not loss.
    const NOISE: f64 = 1e-12;
    let c = shifted + 1.0;
    let sinh = square_root(shifted * (shifted + 2.0));
    if c.im.abs() <= NOISE && c.re.abs() < 1.0 {
        // μ = iθ. A little damping, k + i0, moves c by i0 dc/dk, of the sign of 1/Ĝ'; the outgoing
        // wave is the one it makes decay: sin θ has the sign of Re dc/dk.
        let travelling = Complex64::new(0.0, (1.0 - c.re * c.re).sqrt());
        return if slope.re >= 0.0 { travelling } else { -travelling };
    }
    if (c.conj() * sinh).re >= 0.0 { sinh } else { -sinh }
}
