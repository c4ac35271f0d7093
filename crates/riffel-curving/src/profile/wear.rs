//! Wear of a measured profile against a nominal one.

use riffel_numerics::bisection::{bisection, fallible_bisection};

use super::{Profile, ProfileError, ProfilePoint, ShapeFault};

/// Distance of the points of the nominal profile along it \[m\].
const STEP: f64 = 2.5e-4;
/// Farthest that wear or metal that has flowed is looked for across the profile \[m\], and the step.
const DEEPEST: f64 = 0.02;
const LOOK: f64 = 5e-5;
/// How near a crossing is found \[m\].
const TOLERANCE: f64 = 5e-14;
/// Slope beyond which the field side of a rail is steep enough to hold it across and upward: 20 degrees.
const FIELD_SIDE: f64 = 0.364;
/// Fewest points of the field side.
const LEAST: usize = 20;

/// By what a measured profile is laid on the nominal one, which wear does not touch.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ProfileAlignment {
    /// By nothing: as the coordinates are.
    AsWritten,
    /// A wheel across the track by its coordinates, which are measured from the flange back, and upward by the tip of its flange.
    Flange,
    /// A rail by the least squares of the distances on its field side, where the nominal profile is steeper than 20°.
    FieldSide,
}

/// A point of a nominal profile, and what is worn off there.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct WornPoint {
    /// The point.
    pub nominal: ProfilePoint,
    /// Depth across the nominal profile \[m\], positive where metal is missing; `None` if nothing is measured, as in a gap of the points.
    pub depth: Option<f64>,
}

/// A measured profile beside a nominal one.
#[derive(Debug, Clone, PartialEq)]
#[non_exhaustive]
pub struct ProfileWear {
    /// The measured profile where it was laid.
    pub measured: Profile,
    /// By how much it was moved (x, height) \[m\].
    pub shift: [f64; 2],
    /// Root mean square of the distances on the field side, where a rail is laid by it \[m\].
    pub misfit: Option<f64>,
    /// Points every quarter of a millimetre along the nominal profile.
    pub points: Vec<WornPoint>,
    /// Cross section that is worn off, less what has flowed beyond the nominal profile \[m²\].
    pub area: f64,
}

impl ProfileWear {
    /// The wear of a wheel or a rail, laid on its nominal profile.
    ///
    /// Depth is measured from points of the nominal profile along its normal into the metal, to the nearest crossing of the measured one
    /// within 20 mm. With the curvature κ, positive where the centre lies in the metal, the area is ∫(d − κd²/2) ds, exact as long as
    /// κd < 1: wear shallower than the corner of a rail. Method: steps of 0.05 mm, then bisection; the field side by Gauss and Newton for
    /// two shifts, no rotation. Accuracy: that of the profiles (test `what_is_cut_off_is_found`). Cost: some ten milliseconds.
    ///
    /// # Errors
    /// [`ProfileError::Shape`] where the tip of the flange or the field side is not on both profiles.
    pub fn new(
        measured: &Profile,
        nominal: &Profile,
        is_wheel: bool,
        alignment: ProfileAlignment,
    ) -> Result<Self, ProfileError> {
        let (mut shift, mut misfit) = ([0.0, 0.0], None);
        match alignment {
            ProfileAlignment::AsWritten => {}
            ProfileAlignment::Flange => {
                shift[1] = tip(nominal, ShapeFault::NoNominalTip)?.height - tip(measured, ShapeFault::NoTip)?.height;
            }
            ProfileAlignment::FieldSide => {
                let found = on_field_side(measured, nominal)?;
                (shift, misfit) = (found.0, Some(found.1));
            }
        }
        let measured = measured.moved(shift);
        let points: Vec<WornPoint> = nominal
            .along(STEP)
            .into_iter()
            .map(|point| WornPoint { nominal: point, depth: depth(&measured, &point, is_wheel) })
            .collect();
        if points.iter().all(|point| point.depth.is_none()) {
            return Err(ProfileError::Shape(ShapeFault::Elsewhere));
        }
        let area = points.windows(2).map(|pair| {
            let of = |point: &WornPoint| {
                let inward = if is_wheel { 1.0 } else { -1.0 };
                let curvature = inward * point.nominal.curvature;
                point.depth.map(|depth| depth - 0.5 * curvature * depth * depth)
            };
            let [one, other] = [pair[0], pair[1]].map(|point| of(&point));
            let (from, to) = (pair[0].nominal, pair[1].nominal);
            let length = (to.x - from.x).hypot(to.height - from.height);
            one.zip(other).map_or(0.0, |(one, other)| 0.5 * (one + other) * length)
        });
        Ok(Self { area: area.sum(), measured, shift, misfit, points })
    }

    /// The point of the greatest depth.
    pub fn deepest(&self) -> Option<(ProfilePoint, f64)> {
        let worn = self.points.iter().filter_map(|point| Some((point.nominal, point.depth?)));
        worn.max_by(|one, other| one.1.total_cmp(&other.1))
    }
}

/// The lowest point of a wheel, the tip of its flange; `without` is at fault where it ends there.
pub(super) fn tip(profile: &Profile, without: ShapeFault) -> Result<ProfilePoint, ProfileError> {
    let samples = profile.sampled(1e-4);
    let lowest = (0..samples.len()).min_by(|&one, &other| samples[one].height.total_cmp(&samples[other].height));
    let place = lowest.filter(|&place| place > 0 && place + 1 < samples.len());
    let Some(place) = place else {
        return Err(ProfileError::Shape(without));
    };
    // The slope rises through zero.
    let around = [samples[place - 1].x, samples[place + 1].x];
    let [low, high] = bisection(around, 0.0, |x| profile.at(x).is_none_or(|point| point.slope >= 0.0));
    Ok(profile.at(0.5 * (low + high)).unwrap_or(samples[place]))
}

/// Unit normal of a profile, into the metal.
fn inward(point: &ProfilePoint, is_wheel: bool) -> [f64; 2] {
    let length = if is_wheel { 1.0 } else { -1.0 } * point.slope.hypot(1.0);
    [-point.slope / length, 1.0 / length]
}

/// Depth at a point of the nominal profile.
pub(super) fn depth(measured: &Profile, point: &ProfilePoint, is_wheel: bool) -> Option<f64> {
    let [across, up] = inward(point, is_wheel);
    let place = |depth: f64| [point.x + depth * across, point.height + depth * up];
    let is_worn = |depth: f64| Some(!measured.covers(place(depth), is_wheel)?);
    let worn = is_worn(0.0)?;
    let sign = if worn { 1.0 } else { -1.0 };
    let (mut near, mut far) = (0.0, sign * LOOK);
    while is_worn(far)? == worn {
        if far.abs() > DEEPEST {
            return None;
        }
        (near, far) = (far, far + sign * LOOK);
    }
    let is_beyond = |depth: f64| is_worn(depth).map(|there| there != worn).ok_or(());
    let [near, far] = fallible_bisection([near, far], TOLERANCE, is_beyond).ok()?;
    let depth = 0.5 * (near + far);
    measured.is_measured(place(depth)).then_some(depth)
}

/// The shift that lays a rail on the field side of its nominal profile, and the root mean square of what is left.
fn on_field_side(measured: &Profile, nominal: &Profile) -> Result<([f64; 2], f64), ProfileError> {
    /// Steps; three are enough but for a profile that lies far off.
    const STEPS: usize = 12;
    let crown = nominal.crown().x;
    let side: Vec<ProfilePoint> =
        nominal.along(STEP).into_iter().filter(|point| point.x > crown && point.slope < -FIELD_SIDE).collect();
    // Laid by the crown and the outer end first.
    let [_, end] = measured.range();
    let below = measured.sides[1].points().iter();
    let outer = below.fold(end, |outer, [x, _]| outer.max(*x));
    let [_, nominal_outer] = nominal.range();
    let crowns = nominal.crown().height - measured.crown().height;
    let mut shift = [nominal_outer - outer, crowns];
    let mut misfit = f64::INFINITY;
    for _ in 0..STEPS {
        let moved = measured.moved(shift);
        // Σ (d + s·m)² least: two equations.
        let (mut sums, mut right, mut squares, mut count) = ([0.0; 3], [0.0; 2], 0.0, 0);
        for point in &side {
            let Some(depth) = depth(&moved, point, false) else {
                continue;
            };
            let [across, up] = inward(point, false);
            sums[0] += across * across;
            sums[1] += across * up;
            sums[2] += up * up;
            right[0] -= across * depth;
            right[1] -= up * depth;
            squares += depth * depth;
            count += 1;
        }
        let determinant = sums[0] * sums[2] - sums[1] * sums[1];
        if count < LEAST || determinant <= 1e-6 * sums[0] * sums[2] {
            return Err(ProfileError::Shape(ShapeFault::NoFieldSide));
        }
        // A shift of the surface by s makes it −s·m deeper.
        let step = [
            (right[0] * sums[2] - right[1] * sums[1]) / determinant,
            (right[1] * sums[0] - right[0] * sums[1]) / determinant,
        ];
        misfit = (squares / f64::from(count as u32)).sqrt();
        shift = [shift[0] + step[0], shift[1] + step[1]];
        if step[0].hypot(step[1]) < 1e-9 {
            break;
        }
    }
    Ok((shift, misfit))
}
