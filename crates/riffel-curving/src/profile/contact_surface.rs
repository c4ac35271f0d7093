//! The surface on which a patch lies.

use super::ContactGap;

/// What a patch is laid on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ContactSurface {
    /// The contact plane.
    #[default]
    Flat,
    /// The rail, which is curved across: conformal contact.
    Curved,
}

/// A place of the surface, by its length across.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct SurfacePlace {
    /// In the contact plane, to the right \[m\].
    pub(super) y: f64,
    /// Below the contact plane \[m\].
    pub(super) depth: f64,
    /// To the plane \[rad\], positive where the normal force pushes the rail outward the more.
    pub(super) inclination: f64,
}

/// The surface of a patch over its length across, from the origin of the contact plane to the right.
#[derive(Debug, Clone)]
pub(super) enum PatchSurface {
    Flat,
    /// Lengths \[m\] and their places, by increasing length.
    Curved(Vec<(f64, SurfacePlace)>),
}

impl PatchSurface {
    /// From one y \[m\] to another and somewhat beyond.
    ///
    /// Method: chords of 0.01 mm; a radius of 10 mm makes them shorter than arcs by 4e-8.
    pub(super) fn new(surface: ContactSurface, gap: &ContactGap, [low, high]: [f64; 2]) -> Self {
        const STEP: f64 = 1e-5;
        /// \[m\]; the grid reaches beyond the strips by an element, and arcs are longer than what they span.
        const BEYOND: f64 = 3e-3;
        if surface == ContactSurface::Flat {
            return Self::Flat;
        }
        let steps = |to: f64| ((to.abs() + BEYOND) / STEP).ceil() as i32;
        let walk = |sign: i32, to: f64| {
            let mut places = Vec::new();
            let (mut length, mut last) = (0.0, [0.0, 0.0]);
            for index in 0..=steps(to) {
                let y = STEP * f64::from(sign * index);
                let Some((depth, inclination)) = gap.below(y) else {
                    break;
                };
                length += f64::from(sign) * (y - last[0]).hypot(depth - last[1]);
                last = [y, depth];
                let place = SurfacePlace { y, depth, inclination };
                places.push((length, place));
            }
            places
        };
        let mut places = walk(-1, low.min(0.0));
        places.reverse();
        places.pop();
        places.extend(walk(1, high.max(0.0)));
        Self::Curved(places)
    }

    /// The place of a length \[m\]; at the ends that of the rail's.
    pub(super) fn at(&self, length: f64) -> SurfacePlace {
        let flat = SurfacePlace { y: length, depth: 0.0, inclination: 0.0 };
        let Self::Curved(places) = self else {
            return flat;
        };
        let next = places.partition_point(|(other, _)| *other < length);
        if next == 0 || next == places.len() {
            // Nothing is there to touch.
            let end = places.get(next.saturating_sub(1)).or(places.first());
            return end.map_or(flat, |(begin, place)| SurfacePlace { y: place.y + length - begin, ..*place });
        }
        let ((begin, one), (end, other)) = (places[next - 1], places[next]);
        let share = (length - begin) / (end - begin);
        let between = |one: f64, other: f64| one + share * (other - one);
        SurfacePlace {
            y: between(one.y, other.y),
            depth: between(one.depth, other.depth),
            inclination: between(one.inclination, other.inclination),
        }
    }

    /// The length of a y \[m\] of the contact plane.
    pub(super) fn length_of(&self, y: f64) -> f64 {
        let Self::Curved(places) = self else {
            return y;
        };
        let next = places.partition_point(|(_, place)| place.y < y);
        let near = next.min(places.len().saturating_sub(1));
        let (length, place) = places[near];
        length + (y - place.y) / place.inclination.cos()
    }
}
