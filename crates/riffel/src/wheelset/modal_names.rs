//! What the modes of a file are, by how they move the contacts.

use super::{BendingPlane, ElasticMode, ModeName};

/// Motion of the two contacts along one axis.
type Pair = [f64; 2];

/// The names of elastic modes in their order.
///
/// An axle that bends across moves a wheel down by its deflection and sideward by its slope; the same axle bends along the track at the
/// same frequency, and moves the wheels along it as far as it moved them down. Wheels that move along the rail without such a
/// partner turn: torsion. What moves contacts sideward alone, as an axle that stretches or a web that bends, has no name but its
/// number. Orders count modes of one kind, symmetry and plane.
pub(super) fn names(modes: &[ElasticMode]) -> Vec<ModeName> {
    let mut named = Vec::with_capacity(modes.len());
    for (index, mode) in modes.iter().enumerate() {
        let name = match kind(mode, modes) {
            Some(Kind::Torsion) => {
                let earlier = named.iter();
                let earlier = earlier.filter(|name| matches!(name, ModeName::Torsion { .. }));
                ModeName::Torsion { order: earlier.count() + 1, discs: None }
            }
            Some(Kind::Bending { symmetric, plane }) => {
                let alike = |name: &&ModeName| {
                    matches!(name, ModeName::Bending { symmetric: other, plane: own, .. }
                        if (*other, *own) == (symmetric, plane))
                };
                ModeName::Bending { symmetric, order: named.iter().filter(alike).count() + 1, plane }
            }
            None => ModeName::Elastic { order: index + 1 },
        };
        named.push(name);
    }
    named
}

enum Kind {
    Torsion,
    Bending { symmetric: bool, plane: BendingPlane },
}

fn kind(mode: &ElasticMode, modes: &[ElasticMode]) -> Option<Kind> {
    /// What is less of the largest is none of the motion of a mode.
    const SMALL: f64 = 1e-2;
    /// Frequencies of bending in both planes of an axle that is round.
    const SAME: f64 = 1e-2;
    let [along, across, down] = pairs(mode);
    let largest = size(along).max(size(across)).max(size(down));
    if size(along) < SMALL * largest {
        return (size(down) > SMALL * largest)
            .then(|| Kind::Bending { symmetric: down[0] * down[1] > 0.0, plane: BendingPlane::Vertical });
    }
    if size(across).max(size(down)) > SMALL * largest {
        return None;
    }
    let partner = modes.iter().find(|other| {
        let [_, _, down] = pairs(other);
        let near = (other.angular_frequency / mode.angular_frequency - 1.0).abs() < SAME;
        let unit = (other.generalised_mass / mode.generalised_mass).sqrt();
        let as_far = (size(down) / unit / size(along) - 1.0).abs() < 10.0 * SAME;
        let same_sides = (down[0] * down[1] > 0.0) == (along[0] * along[1] > 0.0);
        near && as_far && same_sides
    });
    Some(match partner {
        Some(_) => Kind::Bending { symmetric: along[0] * along[1] > 0.0, plane: BendingPlane::Horizontal },
        None => Kind::Torsion,
    })
}

/// Left and right along the track, across it and downward.
fn pairs(mode: &ElasticMode) -> [Pair; 3] {
    let shape = mode.shape;
    std::array::from_fn(|axis| [shape[axis], shape[3 + axis]])
}

fn size([left, right]: Pair) -> f64 {
    left.hypot(right)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(frequency: f64, shape: [f64; 6]) -> ElasticMode {
        ElasticMode { angular_frequency: frequency, damping_ratio: 1e-3, generalised_mass: 1.0, shape }
    }

    /// First torsion; first bending, symmetric, in both planes; the antisymmetric one; second torsion with both wheels
    /// alike; a web that moves its wheel sideward.
    #[test]
    fn modes_are_named_by_the_motion_of_the_contacts() {
        let modes = [
            mode(63.0, [-1.4, 0.0, 0.0, 1.4, 0.0, 0.0]),
            mode(67.7, [0.0, -1.3, -0.16, 0.0, 1.3, -0.16]),
            mode(67.7, [-0.16, 0.0, 0.0, -0.16, 0.0, 0.0]),
            mode(149.6, [0.0, -1.5, 0.34, 0.0, -1.5, -0.34]),
            mode(149.6, [0.34, 0.0, 0.0, -0.34, 0.0, 0.0]),
            mode(253.4, [0.5, 0.0, 0.0, 0.5, 0.0, 0.0]),
            mode(502.5, [0.0, 0.94, 0.0, 0.0, -0.94, 0.0]),
        ];
        let bending = |symmetric, plane| ModeName::Bending { symmetric, order: 1, plane };
        let torsion = |order| ModeName::Torsion { order, discs: None };
        let expected = [
            torsion(1),
            bending(true, BendingPlane::Vertical),
            bending(true, BendingPlane::Horizontal),
            bending(false, BendingPlane::Vertical),
            bending(false, BendingPlane::Horizontal),
            torsion(2),
            ModeName::Elastic { order: 7 },
        ];
        assert_eq!(names(&modes), expected);
    }
}
