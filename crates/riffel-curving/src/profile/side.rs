//! Sides of a rail that are too steep to be a curve across the track.

/// How far points of an overhanging side may lie beside the end of the curve, and above points before them \[m\]: unevenness of measured
/// ones.
pub(super) const OVERHANG: f64 = 1e-3;

/// Points (x, height) \[m\] from an end of the curve down, each lower than those before, from which the lateral coordinate follows by the
/// height; empty where nothing goes down there.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Side(Vec<[f64; 2]>);

/// A place on a side.
pub(super) struct OnSide {
    /// Lateral coordinate \[m\].
    pub(super) x: f64,
    /// Distance of the points above and below \[m\].
    pub(super) step: f64,
}

impl Side {
    /// The points that go down from the first, the end of the curve, as long as they do not rise again or lie farther outward than down.
    pub(super) fn down(points: &mut dyn Iterator<Item = [f64; 2]>) -> Self {
        let Some(end) = points.next() else {
            return Self::default();
        };
        let (mut side, mut lowest) = (vec![end], end[1]);
        for [x, height] in points {
            if height > lowest + OVERHANG || (x - end[0]).abs() > OVERHANG + end[1] - lowest {
                break;
            }
            if height < lowest {
                side.push([x, height]);
                lowest = height;
            }
        }
        Self(side)
    }

    /// The points.
    pub(super) fn points(&self) -> &[[f64; 2]] {
        &self.0
    }

    /// The side with each point elsewhere.
    pub(super) fn map(&self, change: impl Fn([f64; 2]) -> [f64; 2]) -> Self {
        Self(self.0.iter().copied().map(change).collect())
    }

    /// The place at a height \[m\].
    pub(super) fn at(&self, height: f64) -> Option<OnSide> {
        let below = self.0.partition_point(|point| point[1] > height);
        let ([x, from], [to_x, to]) = (*self.0.get(below.checked_sub(1)?)?, *self.0.get(below)?);
        Some(OnSide { x: x + (height - from) / (to - from) * (to_x - x), step: (to_x - x).hypot(to - from) })
    }
}

#[cfg(test)]
mod tests {
    use crate::profile::{NominalProfile, Profile, ProfileAlignment, ProfilePoint, ProfileWear, RailWear};
    use riffel_numerics::random_numbers::unit;

    /// Below the crown, where W2 is measured \[m\].
    const GAUGE_HEIGHT: f64 = 0.014;

    /// Numbers from 0 to 1, the same ones each time.
    struct Drawn(u64);

    impl Drawn {
        fn next(&mut self) -> f64 {
            self.0 ^= self.0 << 13;
            self.0 ^= self.0 >> 7;
            self.0 ^= self.0 << 17;
            unit(self.0)
        }

        fn between(&mut self, low: f64, high: f64) -> f64 {
            low + (high - low) * self.next()
        }

        fn of<T: Copy>(&mut self, all: &[T]) -> T {
            all[(self.next() * all.len() as f64) as usize]
        }

        /// Of a normal distribution with the deviation 1.
        fn normal(&mut self) -> f64 {
            (0..12).map(|_| self.next()).sum::<f64>() - 6.0
        }
    }

    /// A rail cut at its gauge face by a line, and what is true of it.
    struct Cut {
        nominal: Profile,
        face: f64,
        lean: f64,
        height: f64,
    }

    impl Cut {
        /// Worn by a depth \[m\] at the gauge height; `lean` outward over down.
        fn new(nominal: Profile, worn: f64, lean: f64) -> Self {
            let height = nominal.crown().height - GAUGE_HEIGHT;
            let face = nominal.inner_face(height).unwrap() + worn;
            Self { nominal, face, lean, height }
        }

        fn at(&self, height: f64) -> f64 {
            self.face + self.lean * (height - self.height)
        }

        /// Points a step apart from the foot of the gauge face to the field side \[m\].
        fn points(&self, step: f64) -> Vec<[f64; 2]> {
            let outline = self.nominal.along(step);
            let lost = outline.iter().rposition(|point| point.x < self.at(point.height));
            let kept = outline[lost.map_or(0, |lost| lost + 1)..].iter();
            let kept: Vec<[f64; 2]> = kept.map(|point| [point.x, point.height]).collect();
            let (top, foot) = (kept[0][1], self.height - 0.012);
            let count = ((top - foot) / step) as usize;
            let heights = (0..count).map(|index| foot + (top - foot) * index as f64 / count as f64);
            heights.map(|height| [self.at(height), height]).chain(kept).collect()
        }

        /// Depth along the normal (across, up) into the metal from a point of the nominal profile \[m\].
        fn depth(&self, [x, height]: [f64; 2], slope: f64) -> f64 {
            let length = slope.hypot(1.0);
            let [across, up] = [slope / length, -1.0 / length];
            (self.at(height) - x).max(0.0) / (across - self.lean * up)
        }
    }

    /// Points off their outline by a normal scatter \[m\].
    fn scattered(points: &[[f64; 2]], scatter: f64, drawn: &mut Drawn) -> Vec<[f64; 2]> {
        let last = points.len() - 1;
        let off = |index: usize| {
            let ([x, height], [to, up]) = (points[index.saturating_sub(1)], points[last.min(index + 1)]);
            let length = (to - x).hypot(up - height);
            let off = scatter * drawn.normal() / length;
            [points[index][0] - off * (up - height), points[index][1] + off * (to - x)]
        };
        (0..=last).map(off).collect()
    }

    /// A made-up measurement: its points, its nominal rail and the truth.
    fn measured(drawn: &mut Drawn) -> (Vec<[f64; 2]>, Cut, f64) {
        let nominal = NominalProfile::named(drawn.of(&["60E1", "60E2", "54E1"])).unwrap();
        let inclination = f64::atan(drawn.of(&[0.0, 1.0 / 40.0, 1.0 / 20.0]));
        let lean = drawn.of(&[1.0, 1.0, -1.0]) / drawn.of(&[20.0, 50.0, 100.0, 200.0, 1000.0]);
        let worn = drawn.between(0.0, 0.01);
        let cut = Cut::new(nominal.profile().turned(inclination), worn, lean);
        let mut points = scattered(&cut.points(drawn.of(&[1e-4, 2.5e-4, 5e-4])), 20e-6, drawn);
        let by = [drawn.between(-3e-3, 3e-3), drawn.between(-3e-3, 3e-3)];
        for point in &mut points {
            *point = [point[0] + by[0], point[1] + by[1]];
        }
        if drawn.next() < 0.5 {
            points.reverse();
        }
        (points, cut, worn)
    }

    /// Of 200 rails, worn by up to 10 mm at a gauge face that leans outward or inward by 1:20 to 1:1000, with points 0.1 to 0.5 mm apart
    /// that scatter by 20 µm, in either order, upright or inclined, displaced by up to 3 mm, all have W2, W3 and the greatest depth
    /// within 0.1 mm, five deviations of a point, and the area within 2 mm², 20 µm along the outline.
    // Long: measures 200 drawn outlines, as many as its counts are of.
    #[test]
    fn a_steep_gauge_face_is_worn() {
        let mut drawn = Drawn(20_261_128);
        let mut right = [0; 4];
        for _ in 0..200 {
            let (points, cut, worn) = measured(&mut drawn);
            let profile = Profile::through(&points).unwrap();
            let wear = ProfileWear::new(&profile, &cut.nominal, false, ProfileAlignment::FieldSide).unwrap();
            let found = RailWear::new(&wear, &cut.nominal, GAUGE_HEIGHT);
            let exact = wear.points.iter().map(|point| match point.depth {
                Some(_) => cut.depth([point.nominal.x, point.nominal.height], point.nominal.slope),
                None => f64::NAN,
            });
            let exact: Vec<f64> = exact.collect();
            let off_corner = |place: &usize| (wear.points[*place].nominal.slope - 1.0).abs();
            let corner = (0..exact.len()).min_by(|one, other| off_corner(one).total_cmp(&off_corner(other))).unwrap();
            let area = |place: usize| {
                let [from, to] = [place, place + 1].map(|place| wear.points[place].nominal);
                let of = |point: ProfilePoint, depth: f64| depth + 0.5 * point.curvature * depth * depth;
                let length = (to.x - from.x).hypot(to.height - from.height);
                0.5 * length * (of(from, exact[place]) + of(to, exact[place + 1]))
            };
            let areas = (0..exact.len() - 1).map(area).filter(|area| area.is_finite());
            let off = [
                found.lateral.unwrap() - worn,
                found.diagonal.unwrap() - exact[corner],
                wear.deepest().unwrap().1 - exact.iter().copied().fold(0.0, f64::max),
                (wear.area - areas.sum::<f64>()) / 20e-3,
            ];
            for (right, off) in right.iter_mut().zip(off) {
                *right += usize::from(off.abs() < 1e-4);
            }
        }
        assert_eq!(right, [200; 4]);
    }

    /// Of 200 such rails without the points around the place of W1, W2 or W3, 6 to 9 mm of their outline, none tells one of the 237 measures
    /// of a place there, and 362 of the 363 others are within 0.1 mm of what all points tell, as the scatter bends a curve beside a gap.
    // Long: measures 400 drawn outlines, as many as its counts are of.
    #[test]
    fn nothing_is_measured_over_a_gap() {
        let mut drawn = Drawn(53);
        let (mut lost, mut silent, mut told) = (0, 0, 0);
        for _ in 0..200 {
            let (points, cut, _) = measured(&mut drawn);
            let measures = |points: &[[f64; 2]]| {
                let profile = Profile::through(points).unwrap();
                let way = ProfileAlignment::FieldSide;
                let wear = ProfileWear::new(&profile, &cut.nominal, false, way).unwrap();
                let found = RailWear::new(&wear, &cut.nominal, GAUGE_HEIGHT);
                (wear.shift, [found.vertical, found.lateral, found.diagonal])
            };
            let (shift, whole) = measures(&points);
            // The places of W1, W2 and W3 on the measured outline.
            let crown = cut.nominal.crown();
            let corner = cut.nominal.along(2.5e-4).into_iter().filter(|point| point.x < crown.x);
            let corner = corner.min_by(|one, other| (one.slope - 1.0).abs().total_cmp(&(other.slope - 1.0).abs()));
            let (corner, deep) = (corner.unwrap(), whole[2].unwrap() * 0.5f64.sqrt());
            let face = cut.nominal.inner_face(cut.height).unwrap() + whole[1].unwrap();
            let places = [
                [crown.x, crown.height - whole[0].unwrap()],
                [face, cut.height],
                [corner.x + deep, corner.height - deep],
            ];
            let middle = drawn.of(&[0, 1, 2]);
            let from = |point: &[f64; 2], place: [f64; 2]| {
                (point[0] + shift[0] - place[0]).hypot(point[1] + shift[1] - place[1])
            };
            let half = drawn.between(3e-3, 4.5e-3);
            let kept = points.iter().copied();
            let kept: Vec<[f64; 2]> = kept.filter(|point| from(point, places[middle]) > half).collect();
            let (_, found) = measures(&kept);
            for place in 0..3 {
                let off = [places[place][0] - places[middle][0], places[place][1] - places[middle][1]];
                let is_lost = off[0].hypot(off[1]) < half;
                lost += usize::from(is_lost);
                match found[place] {
                    None => silent += usize::from(is_lost),
                    Some(depth) => {
                        let is_right = (depth - whole[place].unwrap()).abs() < 1e-4;
                        told += usize::from(!is_lost && is_right);
                    }
                }
            }
        }
        assert!(lost > 200);
        assert_eq!(silent, lost);
        assert!(told + 1 >= 600 - lost, "{told} of {}", 600 - lost);
    }
}
