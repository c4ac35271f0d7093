//! Nominal profiles from their published arcs and polynomials.

use super::Profile;
use super::profile::Knot;

/// A nominal profile, by name.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub struct NominalProfile {
    /// Name in case files.
    pub name: &'static str,
    /// What it is, and where its dimensions come from.
    pub source: &'static str,
    /// Whether it is a wheel; else a rail.
    pub is_wheel: bool,
    shape: Shape,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Shape {
    /// Tangent arcs from the crown outward: radius and half width at its end \[mm\]. The last one ends at the flank of 1:20.
    RailHead(&'static [(f64, f64)]),
    S1002,
    /// A tread of this slope between the flange of S1002 and the field side.
    Cone(f64),
}

/// The nominal profiles.
pub static NOMINAL: [NominalProfile; 7] = [
    NominalProfile {
        name: "S1002",
        source: "Wheel of EN 13715 and UIC 510-2, flange of 28 mm height and 32.5 mm width",
        is_wheel: true,
        shape: Shape::S1002,
    },
    NominalProfile {
        name: "cone-1:40",
        source: "Cone of 1:40 with the flange of S1002, joined by an arc of 13 mm; not the 1/40 profile of EN 13715",
        is_wheel: true,
        shape: Shape::Cone(1.0 / 40.0),
    },
    NominalProfile {
        name: "60E1",
        source: "Rail of EN 13674-1 (UIC60)",
        is_wheel: false,
        shape: Shape::RailHead(&[(300.0, 10.228), (80.0, 26.0265), (13.0, f64::NAN)]),
    },
    NominalProfile {
        name: "60E2",
        source: "Rail of EN 13674-1",
        is_wheel: false,
        shape: Shape::RailHead(&[(200.0, 11.889), (70.0, 24.4565), (16.0, 35.387), (8.0, f64::NAN)]),
    },
    NominalProfile {
        name: "54E1",
        source: "Rail of EN 13674-1 (UIC54)",
        is_wheel: false,
        shape: Shape::RailHead(&[(300.0, 10.012), (80.0, 24.8635), (13.0, f64::NAN)]),
    },
    NominalProfile {
        name: "56E1",
        source: "Rail of EN 13674-1 (BS113A)",
        is_wheel: false,
        shape: Shape::RailHead(&[(305.0, 5.8935), (80.0, 25.6175), (12.7, f64::NAN)]),
    },
    NominalProfile {
        name: "BS113A",
        source: "Rail of BS 11, the section 56E1 of EN 13674-1",
        is_wheel: false,
        shape: Shape::RailHead(&[(305.0, 5.8935), (80.0, 25.6175), (12.7, f64::NAN)]),
    },
];

/// Depth below the crown to which the flank of a rail goes \[mm\].
const FLANK_DEPTH: f64 = 36.0;
/// Slope of the flank, lateral over vertical.
const FLANK: f64 = 1.0 / 20.0;
/// Length of the pieces \[mm\]. Cubics of this length leave an arc of 8 mm by 2e-9 mm.
const STEP: f64 = 0.1;

impl NominalProfile {
    /// The profile of a name, in either case of letters.
    pub fn named(name: &str) -> Option<&'static Self> {
        NOMINAL.iter().find(|profile| profile.name.eq_ignore_ascii_case(name))
    }

    /// Its curve.
    pub fn profile(&self) -> Profile {
        match self.shape {
            Shape::RailHead(arcs) => rail_head(arcs),
            Shape::S1002 => s1002(),
            Shape::Cone(slope) => cone(slope),
        }
    }
}

/// A knot from millimetres, its parameter in millimetres.
fn knot(x: f64, height: f64, by_parameter: [f64; 2]) -> Knot {
    Knot { x: 1e-3 * x, height: 1e-3 * height, by_parameter: by_parameter.map(|value| 1e-3 * value) }
}

/// Tangent arcs about the crown, then straight flanks; symmetric.
fn rail_head(arcs: &[(f64, f64)]) -> Profile {
    let steepest = FLANK.recip().atan();
    // Right half, from the crown: pairs of knots.
    let mut half = Vec::new();
    // Point (x, depth) and angle at which an arc begins.
    let (mut x, mut depth, mut angle) = (0.0_f64, 0.0_f64, 0.0_f64);
    for &(radius, end) in arcs {
        let (centre_x, centre_depth) = (x - radius * angle.sin(), depth + radius * angle.cos());
        let to = match end.is_nan() {
            true => steepest,
            false => ((end - centre_x) / radius).asin(),
        };
        let count = (radius * (to - angle) / STEP).ceil() as usize;
        let place = |index: usize| {
            let angle = angle + (to - angle) * index as f64 / count as f64;
            let point = (centre_x + radius * angle.sin(), centre_depth - radius * angle.cos());
            knot(point.0, -point.1, [angle.cos(), -angle.sin()])
        };
        let length = radius * (to - angle) / count as f64;
        half.extend((0..count).map(|index| (place(index), place(index + 1), length)));
        x = centre_x + radius * to.sin();
        depth = centre_depth - radius * to.cos();
        angle = to;
    }
    let down = FLANK_DEPTH - depth;
    let tangent = [angle.cos(), -angle.sin()];
    half.push((knot(x, -depth, tangent), knot(x + FLANK * down, -FLANK_DEPTH, tangent), down / angle.sin()));
    let turned = |knot: &Knot| Knot {
        x: -knot.x,
        height: knot.height,
        by_parameter: [knot.by_parameter[0], -knot.by_parameter[1]],
    };
    let left = half.iter().rev().map(|(begin, end, length)| (turned(end), turned(begin), *length));
    let spans: Vec<(Knot, Knot, f64)> = left.chain(half.iter().copied()).collect();
    Profile::of_knots(&spans)
}

/// Coefficients of the sections B and C of S1002, ascending, in millimetres; the profile goes down with its flange.
const TREAD: [f64; 9] = [
    0.0,
    -0.03358537058,
    0.001565681624,
    -2.810427944e-05,
    5.844240864e-08,
    -1.562379023e-08,
    5.309217349e-15,
    -5.957839843e-12,
    2.646656573e-13,
];
const THROAT: [f64; 8] = [
    -4320.221063,
    -1038.384026,
    -106.5501873,
    -6.051367875,
    -0.2054332446,
    -0.004169739389,
    -4.687195829e-05,
    -2.25275554e-07,
];

/// Value and derivative of a polynomial.
fn polynomial(coefficients: &[f64], at: f64) -> (f64, f64) {
    coefficients
        .iter()
        .rev()
        .fold((0.0, 0.0), |(value, slope), coefficient| (value * at + coefficient, slope * at + value))
}

/// Knots of a wheel, with the length of the parameter between them.
type Spans = Vec<(Knot, Knot, f64)>;

/// An arc from one x to another, about a centre (x, depth); the sign tells a crest of F from a trough.
fn arc(centre: (f64, f64), radius: f64, from: f64, to: f64, crest: f64) -> Spans {
    // Over the angle, from −x to +x.
    let angle = |x: f64| ((x - centre.0) / radius).clamp(-1.0, 1.0).asin();
    let (from, to) = (angle(from), angle(to));
    let count = (radius * (to - from) / STEP).ceil() as usize;
    let place = |index: usize| {
        let angle = from + (to - from) * index as f64 / count as f64;
        let depth = centre.1 + crest * radius * angle.cos();
        knot(centre.0 + radius * angle.sin(), -depth, [angle.cos(), crest * angle.sin()])
    };
    let length = radius * (to - from) / count as f64;
    let pieces = (0..count).map(|index| (place(index), place(index + 1), length));
    pieces.collect()
}

/// A section given by its depth and the slope of it over x.
fn over_x(depth: &dyn Fn(f64) -> (f64, f64), from: f64, to: f64) -> Spans {
    let count = ((to - from) / STEP).ceil() as usize;
    let place = |index: usize| {
        let x = from + (to - from) * index as f64 / count as f64;
        let (value, slope) = depth(x);
        knot(x, -value, [1.0, -slope])
    };
    let length = (to - from) / count as f64;
    let pieces = (0..count).map(|index| (place(index), place(index + 1), length));
    pieces.collect()
}

/// Flank of the flange of S1002: F = A + B x, of 70 degrees.
const FLANGE: (f64, f64) = (-93.576667419, -2.747477419);
/// Where it begins \[mm\].
const FLANK_BEGIN: f64 = -39.764473993;

/// The sections H to F, from the flange back over the tip to the flank.
fn flange() -> Spans {
    let mut spans = arc((-49.5, 9.519259302), 20.5, -69.9, -62.764705882, 1.0);
    spans.extend(arc((-55.0, 16.0), 12.0, -62.764705882, -49.662510381, 1.0));
    spans.extend(arc((-58.558326413, 8.834924130), 20.0, -49.662510381, FLANK_BEGIN, 1.0));
    spans
}

/// Flange of S1002, an arc of 13 mm and a cone to the field side.
fn cone(slope: f64) -> Profile {
    const RADIUS: f64 = 13.0;
    let mut spans = flange();
    // The centre of the arc lies its radius below the tread, F = −slope x, and outside the flank.
    let (tread, flank) = (slope.hypot(1.0), FLANGE.1.hypot(1.0));
    let x = -(FLANGE.0 + RADIUS * (flank - tread)) / (FLANGE.1 + slope);
    let depth = RADIUS * tread - slope * x;
    let from = x + RADIUS * FLANGE.1 / flank;
    let to = x - RADIUS * slope / tread;
    spans.extend(over_x(&|x| (FLANGE.0 + FLANGE.1 * x, FLANGE.1), FLANK_BEGIN, from));
    spans.extend(arc((x, depth), RADIUS, from, to, -1.0));
    spans.extend(over_x(&|x| (-slope * x, -slope), to, 60.0));
    Profile::of_knots(&spans)
}

/// The sections H to A from the flange back to the field side. Angles of arcs are those of their points about the centre.
fn s1002() -> Profile {
    let mut spans = flange();
    let throat_arc = arc((-26.210665, 16.446), 13.0, -38.426669071, -35.0, -1.0);
    spans.extend(over_x(&|x| (FLANGE.0 + FLANGE.1 * x, FLANGE.1), FLANK_BEGIN, -38.426669071));
    spans.extend(throat_arc);
    spans.extend(over_x(&|x| polynomial(&THROAT, x), -35.0, -26.0));
    spans.extend(over_x(&|x| polynomial(&TREAD, x), -26.0, 32.15796));
    spans.extend(over_x(&|x| (1.364323640 - 0.066666667 * x, -0.066666667), 32.15796, 60.0));
    Profile::of_knots(&spans)
}
