//! A smooth curve across the track.

use riffel_numerics::bisection::bisection;
use riffel_numerics::cubic::{cubic_at, cubic_slope, hermite};

use super::crossing::check_outline;
use super::side::{OVERHANG, Side};
use super::spline::slopes;
use super::{PointFault, ProfileError};

/// Fewest points of a profile.
const LEAST: usize = 8;

/// A profile: a curve of cubic pieces with a continuous tangent, its lateral coordinate increasing, and the sides that go down from its
/// ends so steeply that points of them hang over.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// Lateral coordinates of the ends of the pieces \[m\], one more than there are pieces.
    ends: Vec<f64>,
    pieces: Vec<Piece>,
    pub(super) sides: [Side; 2],
    /// Longest distance of points that have measured what lies between them \[m\].
    pub(super) longest_step: f64,
}

/// A piece over a parameter u from 0 to 1.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Piece {
    x: [f64; 4],
    height: [f64; 4],
}

/// `Ok` for points that are finite and do not stand twice.
pub(super) fn check_points(points: &[[f64; 2]]) -> Result<(), ProfileError> {
    let at_fault = |index: usize, fault: PointFault| Err(ProfileError::Point { index, fault });
    let finite = |point: &[f64; 2]| point.iter().all(|value| value.is_finite());
    if let Some(index) = points.iter().position(|point| !finite(point)) {
        return at_fault(index, PointFault::NotFinite);
    }
    match points.windows(2).position(|pair| pair[0] == pair[1]) {
        Some(index) => at_fault(index + 1, PointFault::Twice),
        None => Ok(()),
    }
}

/// Length of the chords from the first point to each \[m\].
pub(super) fn chords(points: &[[f64; 2]]) -> Vec<f64> {
    let mut length = 0.0;
    let steps = points.windows(2).map(|pair| {
        length += (pair[1][0] - pair[0][0]).hypot(pair[1][1] - pair[0][1]);
        length
    });
    std::iter::once(0.0).chain(steps).collect()
}

/// Longest distance of points \[m\], at these lengths of the chords, that have measured what lies between them: 5 mm, and five times what the others have.
fn longest_step(parameter: &[f64]) -> f64 {
    const LONGEST: (f64, f64) = (5e-3, 5.0);
    let mut steps: Vec<f64> = parameter.windows(2).map(|pair| pair[1] - pair[0]).collect();
    steps.sort_by(f64::total_cmp);
    LONGEST.0.max(LONGEST.1 * steps[steps.len() / 2])
}

/// A place on a profile.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ProfilePoint {
    /// Lateral coordinate \[m\].
    pub x: f64,
    /// Height \[m\].
    pub height: f64,
    /// Slope dh/dx \[-\].
    pub slope: f64,
    /// Curvature \[1/m\], positive where the curve is hollow seen from above.
    pub curvature: f64,
}

/// An end of pieces: place and unit tangent or any multiple of it, by one parameter.
#[derive(Debug, Clone, Copy)]
pub(super) struct Knot {
    pub(super) x: f64,
    pub(super) height: f64,
    pub(super) by_parameter: [f64; 2],
}

impl Profile {
    /// The natural cubic spline over the arc length of the chords through points (x, height) \[m\]. Points may run
    /// either way. Only the part around the highest point counts in which x increases: flanks that hang over are cut.
    ///
    /// # Errors
    /// [`ProfileError`] for fewer than eight points, points that are not finite or stand twice, an outline that closes or crosses
    /// itself, and for a curve that turns back across the track between points that do not.
    pub fn through(points: &[[f64; 2]]) -> Result<Self, ProfileError> {
        if points.len() < LEAST {
            return Err(ProfileError::TooFew { count: points.len(), least: LEAST });
        }
        check_points(points)?;
        let mut points = points.to_vec();
        let backward = points[0][0] > points[points.len() - 1][0];
        if backward {
            points.reverse();
        }
        let count = points.len();
        let original = |index: usize| if backward { count - 1 - index } else { index };
        let parameter = chords(&points);
        check_outline(&points, parameter[count - 1]).map_err(|error| match error {
            ProfileError::Point { index, fault } => ProfileError::Point { index: original(index), fault },
            error => error,
        })?;
        let coordinate = |axis: usize| points.iter().map(|point| point[axis]).collect::<Vec<f64>>();
        let (x, height) = (coordinate(0), coordinate(1));
        let (along, up) = (slopes(&parameter, &x), slopes(&parameter, &height));
        let knots = (0..count).map(|index| Knot {
            x: x[index],
            height: height[index],
            by_parameter: [along[index], up[index]],
        });
        let knots: Vec<Knot> = knots.collect();
        let longest_step = longest_step(&parameter);
        let pieces: Vec<Piece> = (0..count - 1)
            .map(|index| {
                let (begin, end) = (&knots[index], &knots[index + 1]);
                let length = parameter[index + 1] - parameter[index];
                let piece = Piece::between(begin, end, length);
                // The scatter at its ends makes loops of the curve over a gap.
                match length > longest_step && end.x > begin.x && !piece.goes_outward() {
                    true => Piece::straight(begin, end),
                    false => piece,
                }
            })
            .collect();
        let rises: Vec<bool> = pieces.iter().map(Piece::goes_outward).collect();
        // The longest run across the track; what hangs over at its ends is cut off.
        let (mut from, mut to) = (0, 0);
        let mut begin = 0;
        for index in 0..=pieces.len() {
            if index == pieces.len() || !rises[index] {
                if x[index] - x[begin] > x[to] - x[from] {
                    (from, to) = (begin, index);
                }
                begin = index + 1;
            }
        }
        let sides =
            [Side::down(&mut points[..=from].iter().rev().copied()), Side::down(&mut points[to..].iter().copied())];
        let [inner, outer] = sides.each_ref().map(|side| side.points().iter());
        let low = inner.fold(x[from], |low, [x, _]| low.min(*x));
        let high = outer.fold(x[to], |high, [x, _]| high.max(*x));
        // An overhang lies inside what stands over it, a side that leans outward below; points in a wrong order lie beyond.
        let is_beyond = |place: &f64| *place < low - OVERHANG || *place > high + OVERHANG;
        if to == 0 || x.iter().any(is_beyond) {
            let turns = rises.iter().position(|outward| !outward).unwrap_or(0);
            return Err(ProfileError::Point { index: original(turns), fault: PointFault::TurnsBack });
        }
        let profile = Self { ends: x[from..=to].to_vec(), pieces: pieces[from..to].to_vec(), sides, longest_step };
        // What hangs over lies below; another pass over the same surface does not.
        let above = |index: &usize| {
            let place = x[*index];
            let inside = place > x[from] + OVERHANG && place < x[to] - OVERHANG;
            inside && profile.at(place).is_some_and(|point| height[*index] > point.height)
        };
        match (0..from).chain(to + 1..count).find(above) {
            Some(index) => Err(ProfileError::Point { index: original(index), fault: PointFault::ComesBack }),
            None => Ok(profile),
        }
    }

    /// A curve of knots, each pair with one length of the parameter between them.
    pub(super) fn of_knots(spans: &[(Knot, Knot, f64)]) -> Self {
        let mut ends: Vec<f64> = spans.iter().map(|(begin, ..)| begin.x).collect();
        ends.extend(spans.last().map(|(_, end, _)| end.x));
        Self {
            ends,
            sides: <[Side; 2]>::default(),
            longest_step: f64::INFINITY,
            pieces: spans.iter().map(|(begin, end, length)| Piece::between(begin, end, *length)).collect(),
        }
    }

    /// Ends of the lateral coordinate \[m\].
    pub fn range(&self) -> [f64; 2] {
        [self.ends[0], self.ends[self.ends.len() - 1]]
    }

    /// The place at a lateral coordinate \[m\]; none outside the range.
    pub fn at(&self, x: f64) -> Option<ProfilePoint> {
        let [low, high] = self.range();
        if !(low..=high).contains(&x) {
            return None;
        }
        let index = self.ends.partition_point(|end| *end <= x).clamp(1, self.pieces.len()) - 1;
        Some(self.pieces[index].at(x, self.ends[index], self.ends[index + 1]))
    }

    /// The profile turned by an angle \[rad\], positive where the field side goes up, about its origin; parts that then
    /// hang over are cut off.
    pub fn turned(&self, angle: f64) -> Self {
        let (sine, cosine) = angle.sin_cos();
        let pieces: Vec<Piece> = self.pieces.iter().map(|piece| piece.turned(sine, cosine)).collect();
        // From the middle outward, as far as x increases.
        let middle = pieces.len() / 2;
        let from = (0..middle).rev().find(|&index| !pieces[index].goes_outward()).map_or(0, |index| index + 1);
        let to = (middle..pieces.len()).find(|&index| !pieces[index].goes_outward()).unwrap_or(pieces.len());
        let mut ends: Vec<f64> = pieces[from..to].iter().map(|piece| piece.x[0]).collect();
        ends.push(pieces[to - 1].x.iter().sum());
        let side = |end: usize| {
            let points = self.sides[end].points().iter();
            points.map(|[x, height]| [cosine * x - sine * height, sine * x + cosine * height])
        };
        let inner = (0..=from).rev().map(|index| pieces[index].begin());
        let outer = (to - 1..pieces.len()).map(|index| pieces[index].end());
        Self {
            ends,
            sides: [Side::down(&mut inner.chain(side(0))), Side::down(&mut outer.chain(side(1)))],
            longest_step: self.longest_step,
            pieces: pieces[from..to].to_vec(),
        }
    }

    /// The profile moved by (x, height) \[m\].
    pub fn moved(&self, by: [f64; 2]) -> Self {
        let mut moved = self.clone();
        for end in &mut moved.ends {
            *end += by[0];
        }
        for side in &mut moved.sides {
            *side = side.map(|[x, height]| [x + by[0], height + by[1]]);
        }
        for piece in &mut moved.pieces {
            piece.x[0] += by[0];
            piece.height[0] += by[1];
        }
        moved
    }

    /// Points from one end to the other, a step \[m\] apart across the track.
    pub fn sampled(&self, step: f64) -> Vec<ProfilePoint> {
        let [low, high] = self.range();
        let count = ((high - low) / step).ceil().max(1.0) as usize;
        let places = (0..=count).map(|index| low + (high - low) * index as f64 / count as f64);
        places.filter_map(|x| self.at(x)).collect()
    }

    /// Points from one end to the other, at most a step \[m\] apart along the curve.
    pub fn along(&self, step: f64) -> Vec<ProfilePoint> {
        let mut points = Vec::new();
        for (piece, ends) in self.pieces.iter().zip(self.ends.windows(2)) {
            let rise = piece.height[1] + piece.height[2] + piece.height[3];
            let count = ((ends[1] - ends[0]).hypot(rise) / step).ceil().max(1.0);
            points.extend((0..count as usize).map(|index| piece.by_parameter(index as f64 / count)));
        }
        points.extend(self.pieces.last().map(|piece| piece.by_parameter(1.0)));
        points
    }

    /// The highest point.
    pub fn crown(&self) -> ProfilePoint {
        let coarse = self.sampled(1e-4);
        let highest = coarse.iter().enumerate().max_by(|one, other| one.1.height.total_cmp(&other.1.height));
        let place = highest.map_or(0, |(index, _)| index);
        let around = [place.saturating_sub(1), (place + 1).min(coarse.len() - 1)].map(|place| coarse[place].x);
        // The slope falls through zero.
        let [low, high] = bisection(around, 0.0, |x| self.at(x).is_none_or(|point| point.slope <= 0.0));
        self.at(0.5 * (low + high)).unwrap_or(coarse[place])
    }

    /// The lateral coordinate \[m\] left of the crown at which the curve or the side below its end has a height \[m\]; `None` if they end
    /// above.
    pub fn inner_face(&self, height: f64) -> Option<f64> {
        if let Some(face) = self.sides[0].at(height) {
            return Some(face.x);
        }
        let (low, high) = (self.range()[0], self.crown().x);
        if self.at(low)?.height > height || self.at(high)?.height < height {
            return None;
        }
        let [low, high] = bisection([low, high], 0.0, |x| self.at(x).is_none_or(|point| point.height >= height));
        Some(0.5 * (low + high))
    }

    /// Whether a place lies under the curve and between its sides; `None` if nothing was measured. Height counts downward on a wheel,
    /// whose metal lies above its curve.
    pub(super) fn covers(&self, [x, height]: [f64; 2], is_wheel: bool) -> Option<bool> {
        let up = if is_wheel { -1.0 } else { 1.0 };
        let faces = [0, 1].map(|end| self.sides[end].at(height).map(|face| face.x));
        if faces[0].is_some_and(|face| x < face) || faces[1].is_some_and(|face| x > face) {
            return Some(false);
        }
        let [low, high] = self.range();
        let end = usize::from(x > low);
        match self.at(x) {
            Some(point) => Some(up * height <= up * point.height),
            None if up * height > up * self.at([low, high][end])?.height => Some(false),
            None => faces[end].map(|_| true),
        }
    }

    /// Whether the points of a place on the curve or on a side have measured it: no gap between them reaches over it.
    pub(super) fn is_measured(&self, [x, height]: [f64; 2]) -> bool {
        /// How near a place on a side lies to it \[m\].
        const ON_SIDE: f64 = 1e-6;
        let mut faces = self.sides.iter().filter_map(|side| side.at(height));
        let on_side = faces.rfind(|face| (face.x - x).abs() < ON_SIDE);
        let step = on_side.map(|face| face.step).or_else(|| {
            let index = self.ends.partition_point(|end| *end <= x);
            let piece = self.pieces.get(index.checked_sub(1)?)?;
            let ([x, height], [to, up]) = (piece.begin(), piece.end());
            Some((to - x).hypot(up - height))
        });
        step.is_none_or(|step| step <= self.longest_step)
    }
}

impl Piece {
    fn begin(&self) -> [f64; 2] {
        [self.x[0], self.height[0]]
    }

    fn end(&self) -> [f64; 2] {
        [self.x.iter().sum(), self.height.iter().sum()]
    }

    /// Hermite's cubics between two knots.
    fn between(begin: &Knot, end: &Knot, length: f64) -> Self {
        let slopes = |axis: usize| [begin.by_parameter[axis] * length, end.by_parameter[axis] * length];
        Self { x: hermite([begin.x, end.x], slopes(0)), height: hermite([begin.height, end.height], slopes(1)) }
    }

    fn straight(begin: &Knot, end: &Knot) -> Self {
        Self { x: [begin.x, end.x - begin.x, 0.0, 0.0], height: [begin.height, end.height - begin.height, 0.0, 0.0] }
    }

    /// Whether x increases all along.
    fn goes_outward(&self) -> bool {
        let [_, _, c, d] = self.x;
        let slope = |u: f64| cubic_slope(self.x, u);
        let inner = if d == 0.0 { 0.5 } else { -c / (3.0 * d) };
        slope(0.0) > 0.0 && slope(1.0) > 0.0 && slope(inner.clamp(0.0, 1.0)) > 0.0
    }

    fn turned(&self, sine: f64, cosine: f64) -> Self {
        let mut turned = *self;
        for power in 0..4 {
            let (x, height) = (self.x[power], self.height[power]);
            turned.x[power] = cosine * x - sine * height;
            turned.height[power] = sine * x + cosine * height;
        }
        turned
    }

    /// The place at x, between the ends of the piece.
    fn at(&self, x: f64, low: f64, high: f64) -> ProfilePoint {
        let mut u = (x - low) / (high - low);
        // Pieces are nearly straight in x: a few steps reach rounding, and none leaves the piece for good.
        for _ in 0..20 {
            let step = (cubic_at(self.x, u) - x) / cubic_slope(self.x, u);
            u = (u - step).clamp(0.0, 1.0);
            if step.abs() < 1e-14 {
                break;
            }
        }
        ProfilePoint { x, ..self.by_parameter(u) }
    }

    fn by_parameter(&self, u: f64) -> ProfilePoint {
        let [along, up] = [self.x, self.height].map(|cubic| cubic_slope(cubic, u));
        let [along_bend, up_bend] = [self.x, self.height].map(|[_, _, c, d]| 2.0 * c + 6.0 * d * u);
        ProfilePoint {
            x: cubic_at(self.x, u),
            height: cubic_at(self.height, u),
            slope: up / along,
            curvature: (along * up_bend - up * along_bend) / along.hypot(up).powi(3),
        }
    }
}
