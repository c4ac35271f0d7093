//! One motion of the axle with its discs: bending in a plane, torsion or stretch.

use num_complex::Complex64;
use riffel_numerics::square::Square;

use super::disc::CoupledInertia;
use super::span::{LONGEST_PHASE, Section, Transfer};

/// What sits at a place of the axle.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Node<const N: usize> {
    /// Place \[m\] from the middle of the axle.
    pub(super) place: f64,
    /// Mass or inertia of each displacement.
    pub(super) inertia: [f64; N],
    /// Stiffness to the ground.
    pub(super) stiffness: [f64; N],
    /// Viscous damping to the ground.
    pub(super) damping: [f64; N],
    /// Inertias behind springs, on the first displacement.
    pub(super) coupled: Vec<CoupledInertia>,
}

impl<const N: usize> Node<N> {
    pub(super) fn bare(place: f64) -> Self {
        Self { place, inertia: [0.0; N], stiffness: [0.0; N], damping: [0.0; N], coupled: Vec::new() }
    }

    /// Dynamic stiffness.
    #[inline]
    pub(super) fn dynamic_stiffness(&self, w: f64) -> [Complex64; N] {
        let mut stiffness: [Complex64; N] =
            std::array::from_fn(|i| Complex64::new(self.stiffness[i] - w * w * self.inertia[i], w * self.damping[i]));
        for coupled in &self.coupled {
            let spring = Complex64::new(coupled.stiffness, w * coupled.damping);
            let inertia = -w * w * coupled.polar_inertia;
            stiffness[0] += spring * inertia / (spring + inertia);
        }
        stiffness
    }

    /// Number of coupled inertias whose own frequency, the axle being held, lies below ω.
    fn held_frequencies_below(&self, w: f64) -> usize {
        let below = |coupled: &&CoupledInertia| coupled.stiffness < w * w * coupled.polar_inertia;
        self.coupled.iter().filter(below).count()
    }
}

/// A line of spans with a node at each end of every one.
///
/// Method: the dynamic stiffness of all that lies on one side is carried across span by span (a Riccati equation), from
/// either end to the contacts. No wave is followed in the direction of its growth, and at low frequency no large
/// stiffnesses cancel, so that receptances are exact to rounding from rigid motion to any frequency. Without loss they
/// keep ten digits within a relative 1e-6 of a frequency at which a part of the axle resonates on a held end, and one
/// less for each ten times nearer.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Chain<S, const N: usize> {
    pub(super) nodes: Vec<Node<N>>,
    /// Sections and lengths, each once.
    kinds: Vec<(S, f64)>,
    /// The kind of each span, one less than the nodes.
    pub(super) spans: Vec<usize>,
    elasticity: Complex64,
    /// Whether it looks alike from either end, as without a gear.
    symmetric: bool,
}

/// A kind of span at one frequency.
pub(super) struct Cut<const N: usize> {
    pub(super) transfer: Transfer<N>,
    pieces: usize,
}

/// What lies between an end and two nodes, seen from that end.
#[derive(Clone, Copy)]
struct FromEnd<const N: usize> {
    /// Dynamic stiffness of all before the near node, without it.
    before_near: Square<N>,
    /// Dynamic stiffness of all before the far node, without it.
    before_far: Square<N>,
    /// Motion at the near node by that at the far one.
    back: Square<N>,
}

impl<S: Section<N> + PartialEq, const N: usize> Chain<S, N> {
    /// Nodes from left to right and the section of the axle at a place between them.
    pub(super) fn new(nodes: Vec<Node<N>>, section: impl Fn(f64) -> S, loss_factor: f64) -> Self {
        /// Lengths that differ by less differ by the rounding of places \[m\].
        const SAME: f64 = 1e-12;
        let mut kinds: Vec<(S, f64)> = Vec::new();
        let spans = nodes.windows(2).map(|ends| {
            let length = ends[1].place - ends[0].place;
            let section = section(0.5 * (ends[0].place + ends[1].place));
            let known = kinds.iter().position(|(other, known)| *other == section && (known - length).abs() < SAME);
            known.unwrap_or_else(|| {
                kinds.push((section, length));
                kinds.len() - 1
            })
        });
        let spans: Vec<usize> = spans.collect();
        let mut opposite = nodes.iter().zip(nodes.iter().rev());
        let alike = opposite.all(|(one, other)| {
            (one.place + other.place).abs() < SAME && *one == Node { place: one.place, ..other.clone() }
        });
        let symmetric = alike && spans.iter().eq(spans.iter().rev());
        Self { nodes, kinds, spans, elasticity: Complex64::new(1.0, loss_factor), symmetric }
    }

    /// Chain without loss, with nodes no further apart than a phase \[rad\] of the shortest wave at ω.
    pub(super) fn refined(&self, w: f64, phase: f64) -> Self {
        let lossless = |node: &Node<N>| {
            let mut node = node.clone();
            node.damping = [0.0; N];
            for coupled in &mut node.coupled {
                coupled.damping = 0.0;
            }
            node
        };
        let (mut nodes, mut kinds, mut spans) = (vec![lossless(&self.nodes[0])], Vec::new(), Vec::new());
        let counts: Vec<usize> = self
            .kinds
            .iter()
            .map(|(section, length)| {
                let pieces = section.pieces(*length, w * w, phase);
                kinds.push((*section, length / pieces as f64));
                pieces
            })
            .collect();
        for (index, &kind) in self.spans.iter().enumerate() {
            let begin = self.nodes[index].place;
            for piece in 1..counts[kind] {
                nodes.push(Node::bare(begin + piece as f64 * kinds[kind].1));
            }
            nodes.push(lossless(&self.nodes[index + 1]));
            spans.extend(std::iter::repeat_n(kind, counts[kind]));
        }
        Self { nodes, kinds, spans, elasticity: Complex64::ONE, symmetric: self.symmetric }
    }

    /// Section and length of a span.
    pub(super) fn span(&self, index: usize) -> (S, f64) {
        self.kinds[self.spans[index]]
    }

    pub(super) fn cuts(&self, w: f64) -> Vec<Cut<N>> {
        let w2 = w * w;
        let cut = |(section, length): &(S, f64)| {
            let pieces = section.pieces(*length, w2, LONGEST_PHASE);
            let transfer = section.transfer(length / pieces as f64, w2, self.elasticity);
            Cut { transfer, pieces }
        };
        self.kinds.iter().map(cut).collect()
    }

    /// Receptances between two nodes, the first left of the second: `[at][from]`, displacements by loads. Of the cuts at ω, which chains
    /// of the same spans share.
    pub(super) fn between(&self, [left, right]: [usize; 2], w: f64, cuts: &[Cut<N>]) -> [[Square<N>; 2]; 2] {
        let from_left = |span: usize| (span, span);
        let of_left = self.seen_from_end(w, cuts, (0..left).map(from_left), (left..right).map(from_left));
        // As seen in a mirror.
        let of_right = match self.symmetric && left + right == self.spans.len() {
            true => of_left,
            false => {
                let from_right = |span: usize| (span, span + 1);
                let beyond = (right..self.spans.len()).rev().map(from_right);
                self.seen_from_end(w, cuts, beyond, (left..right).rev().map(from_right))
            }
        };
        let at_node = |index: usize, left: Square<N>, right: Square<N>| {
            let whole = left.plus_diagonal(&self.nodes[index].dynamic_stiffness(w)) + right.mirrored();
            whole.inverse().symmetric()
        };
        let at_left = at_node(left, of_left.before_near, of_right.before_far);
        let at_right = at_node(right, of_left.before_far, of_right.before_near);
        // The motion at the right node by that at the left one.
        let across = of_right.back.mirrored() * at_left;
        [[at_left, across.transposed()], [across, at_right]]
    }

    /// From an end over spans to the near one of two nodes and on to the far one; each span with the node at its begin.
    #[inline]
    fn seen_from_end(
        &self,
        w: f64,
        cuts: &[Cut<N>],
        to_near: impl Iterator<Item = (usize, usize)>,
        to_far: impl Iterator<Item = (usize, usize)>,
    ) -> FromEnd<N> {
        let over = |before: Square<N>, mut back: Square<N>, (span, begin): (usize, usize)| {
            let cut = &cuts[self.spans[span]];
            let mut stiffness = before.plus_diagonal(&self.nodes[begin].dynamic_stiffness(w));
            for _ in 0..cut.pieces {
                let (beyond, factor) = cut.transfer.across(stiffness);
                (stiffness, back) = (beyond, back * factor);
            }
            (stiffness, back)
        };
        let identity = Square::identity();
        let before_near = to_near.fold(Square::ZERO, |before, span| over(before, identity, span).0);
        let (before_far, back) = to_far.fold((before_near, identity), |(before, back), span| over(before, back, span));
        FromEnd { before_near, before_far, back }
    }

    /// Number of natural frequencies below ω, each as often as it occurs; of a chain without loss.
    ///
    /// Source: Wittrick & Williams (1971), A general algorithm for computing natural frequencies of elastic structures:
    /// those of the parts with held ends, of which short pieces have none, and the negative eigenvalues of the dynamic
    /// stiffness, counted as it is eliminated from left to right.
    pub(super) fn frequencies_below(&self, w: f64) -> usize {
        let cuts = self.cuts(w);
        let mut count = 0;
        let mut stiffness = Square::ZERO;
        for (index, node) in self.nodes.iter().enumerate() {
            stiffness = stiffness.plus_diagonal(&node.dynamic_stiffness(w));
            count += node.held_frequencies_below(w);
            let Some(&kind) = self.spans.get(index) else {
                break;
            };
            for _ in 0..cuts[kind].pieces {
                count += cuts[kind].transfer.held(stiffness).negative_eigenvalues();
                (stiffness, _) = cuts[kind].transfer.across(stiffness);
            }
        }
        count + stiffness.negative_eigenvalues()
    }

    /// Natural frequencies ω between two \[rad/s\], in order, each as often as it occurs; of a chain without loss.
    ///
    /// Method: bisection of [`frequencies_below`](Self::frequencies_below), which misses none, to a relative 1e-13.
    pub(super) fn natural_frequencies(&self, [low, high]: [f64; 2]) -> Vec<f64> {
        let mut frequencies = Vec::new();
        let counts = [low, high].map(|w| self.frequencies_below(w));
        self.divide([low, high], counts, &mut frequencies);
        frequencies
    }

    fn divide(&self, [low, high]: [f64; 2], [below, above]: [usize; 2], found: &mut Vec<f64>) {
        const TOLERANCE: f64 = 1e-13;
        if below >= above {
            return;
        }
        let middle = (low * high).sqrt();
        if high - low <= TOLERANCE * high {
            found.extend(std::iter::repeat_n(middle, above - below));
            return;
        }
        // At a natural frequency the count may be off by rounding.
        let count = self.frequencies_below(middle).clamp(below, above);
        self.divide([low, middle], [below, count], found);
        self.divide([middle, high], [count, above], found);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::steel;
    use crate::wheelset::flexible::beam::BeamSection;
    use crate::wheelset::{Axle, Segment};

    /// Of an axle with a wheel and a brake disc on either side, the discs perhaps of different masses.
    fn chain(discs: [f64; 2]) -> Chain<BeamSection, 2> {
        let axle = Axle::new(steel(), 7850.0, vec![Segment { length: 2.2, diameter: 0.16 }]).unwrap();
        let places = [(-1.1, 0.0), (-0.75, 350.0), (-0.3, discs[0]), (0.3, discs[1]), (0.75, 350.0), (1.1, 0.0)];
        let nodes = places.map(|(place, mass)| Node { inertia: [mass, 0.05 * mass], ..Node::bare(place) });
        Chain::new(nodes.to_vec(), |place| BeamSection::new(&axle, axle.segment_at(place)), 0.002)
    }

    #[test]
    fn the_other_half_of_a_symmetric_axle_is_its_mirror_image() {
        let symmetric = chain([110.0; 2]);
        assert!(symmetric.symmetric && !chain([110.0, 111.0]).symmetric);
        let from_both = Chain { symmetric: false, ..symmetric.clone() };
        for step in 1..200 {
            let w = 40.0 * f64::from(step);
            let cuts = symmetric.cuts(w);
            let [one, other] = [&symmetric, &from_both].map(|chain| chain.between([1, 4], w, &cuts));
            for (one, other) in one.as_flattened().iter().zip(other.as_flattened()) {
                for (one, other) in one.0.as_flattened().iter().zip(other.0.as_flattened()) {
                    assert!((one - other).norm() <= 1e-11 * other.norm(), "{w}: {one} {other}");
                }
            }
        }
    }
}
