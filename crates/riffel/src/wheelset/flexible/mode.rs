//! A natural mode of one motion of the axle.

use num_complex::Complex64;
use riffel_numerics::gauss::GAUSS;
use riffel_numerics::square::Square;

use super::chain::Chain;
use super::disc::CoupledInertia;
use super::span::Section;

/// A mode of a [`Chain`], of a generalised mass of 1 kg.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Mode<S, const N: usize> {
    chain: Chain<S, N>,
    /// ω \[rad/s\].
    pub(super) natural: f64,
    /// Displacements of each node and loads right of it.
    states: Vec<([Complex64; N], [Complex64; N])>,
}

impl<S: Section<N> + PartialEq, const N: usize> Mode<S, N> {
    /// The mode of a chain at a natural frequency ω \[rad/s\] of one without loss, to a generalised mass of 1 kg.
    ///
    /// Method: the motion under a load a relative 1e-9 above it, at the node that answers most; nodes must be near each
    /// other against the wave.
    pub(super) fn of(chain: &Chain<S, N>, natural: f64) -> Self {
        const BESIDE: f64 = 1e-9;
        let w = natural * (1.0 + BESIDE);
        let cuts = chain.cuts(w);
        let loads: Vec<[Complex64; N]> = chain.nodes.iter().map(|node| node.dynamic_stiffness(w)).collect();
        let last = chain.spans.len();
        // Dynamic stiffness left and right of each node, without it, and how a motion goes on outward.
        let (mut left, mut outward_left) = (vec![Square::ZERO; last + 1], vec![Square::ZERO; last]);
        for span in 0..last {
            let transfer = &cuts[chain.spans[span]].transfer;
            (left[span + 1], outward_left[span]) = transfer.across(left[span].plus_diagonal(&loads[span]));
        }
        let (mut right, mut outward_right) = (vec![Square::ZERO; last + 1], vec![Square::ZERO; last]);
        for span in (0..last).rev() {
            let transfer = &cuts[chain.spans[span]].transfer;
            let beyond = right[span + 1].plus_diagonal(&loads[span + 1]);
            let (stiffness, back) = transfer.across(beyond.mirrored());
            (right[span], outward_right[span]) = (stiffness.mirrored(), back.mirrored());
        }

        let answers = (0..=last).map(|node| (left[node].plus_diagonal(&loads[node]) + right[node]).inverse());
        let strongest = answers.enumerate().flat_map(|(node, answer)| {
            (0..N).map(move |i| (node, answer.0[i][i].norm(), std::array::from_fn(|j| answer.0[j][i])))
        });
        let (source, _, motion) =
            strongest.max_by(|a, b| a.1.total_cmp(&b.1)).unwrap_or((0, 0.0, [Complex64::ZERO; N]));

        let mut displacements = vec![motion; last + 1];
        for span in (0..source).rev() {
            displacements[span] = outward_left[span].apply(&displacements[span + 1]);
        }
        for span in source..last {
            displacements[span + 1] = outward_right[span].apply(&displacements[span]);
        }
        // Right of each node.
        let internal = |node: usize| {
            let stiffness = if node < source { left[node].plus_diagonal(&loads[node]) } else { right[node] };
            let load = stiffness.apply(&displacements[node]);
            if node < source { load } else { load.map(|value| -value) }
        };
        let states = (0..=last).map(|node| (displacements[node], internal(node))).collect();
        Self::normalised(chain.clone(), natural, states)
    }

    fn normalised(chain: Chain<S, N>, natural: f64, states: Vec<([Complex64; N], [Complex64; N])>) -> Self {
        let mut mode = Self { chain, natural, states };
        let factor = mode.generalised_mass().sqrt().recip();
        for (displacement, load) in &mut mode.states {
            *displacement = displacement.map(|value| value * factor);
            *load = load.map(|value| value * factor);
        }
        mode
    }

    /// Displacements at a place \[m\] from the middle of the axle; those of the end beyond it.
    pub(super) fn at(&self, place: f64) -> [f64; N] {
        let nodes = &self.chain.nodes;
        let after = nodes.partition_point(|node| node.place <= place);
        let node = after.saturating_sub(1).min(nodes.len() - 2);
        let (_, length) = self.chain.span(node);
        self.within(node, ((place - nodes[node].place) / length).clamp(0.0, 1.0))
    }

    /// Displacements at a share of a span.
    fn within(&self, span: usize, share: f64) -> [f64; N] {
        let (section, length) = self.chain.span(span);
        let w2 = self.natural * self.natural;
        let transfer = section.transfer(share * length, w2, Complex64::ONE);
        let (displacement, load) = &self.states[span];
        transfer.state(displacement, load).0.map(|value| value.re)
    }

    /// Generalised mass of the axle, the nodes and what is coupled to them \[kg\].
    fn generalised_mass(&self) -> f64 {
        let nodes = (0..self.states.len()).map(|node| self.mass_of_node(node));
        nodes.sum::<f64>() + self.mass_of_axle()
    }

    /// Generalised mass of what sits at a node \[kg\].
    pub(super) fn mass_of_node(&self, index: usize) -> f64 {
        let node = &self.chain.nodes[index];
        let displacement = self.states[index].0.map(|value| value.re);
        let own = node.inertia.iter().zip(displacement).map(|(inertia, d)| inertia * d * d);
        let coupled = node
            .coupled
            .iter()
            .map(|coupled| coupled.polar_inertia * (displacement[0] * self.amplification(coupled)).powi(2));
        own.sum::<f64>() + coupled.sum::<f64>()
    }

    /// Momentum of what sits at a node in its first displacement, over ω.
    pub(super) fn momentum_of_node(&self, index: usize) -> f64 {
        let node = &self.chain.nodes[index];
        let coupled = node.coupled.iter().map(|coupled| coupled.polar_inertia * self.amplification(coupled));
        (node.inertia[0] + coupled.sum::<f64>()) * self.states[index].0[0].re
    }

    /// Motion of a coupled inertia relative to that of its node.
    fn amplification(&self, coupled: &CoupledInertia) -> f64 {
        (1.0 - self.natural * self.natural * coupled.polar_inertia / coupled.stiffness).recip()
    }

    /// Generalised mass of the bare axle \[kg\].
    pub(super) fn mass_of_axle(&self) -> f64 {
        let spans = 0..self.states.len() - 1;
        let of_span = |span: usize| {
            let (section, length) = self.chain.span(span);
            let inertia = section.inertia();
            let at = |(share, weight): (f64, f64)| {
                let displacement = self.within(span, share);
                let squares = inertia.iter().zip(displacement).map(|(inertia, d)| inertia * d * d);
                weight * length * squares.sum::<f64>()
            };
            GAUSS.iter().copied().map(at).sum::<f64>()
        };
        spans.map(of_span).sum()
    }

    /// Share of the springs to the ground in the potential energy.
    pub(super) fn share_of_springs(&self) -> f64 {
        let of_node = |(node, state): (&super::chain::Node<N>, &([Complex64; N], _))| -> f64 {
            let squares = node.stiffness.iter().zip(state.0);
            squares.map(|(stiffness, d)| stiffness * d.re * d.re).sum()
        };
        let springs: f64 = self.chain.nodes.iter().zip(&self.states).map(of_node).sum();
        springs / (self.natural * self.natural)
    }

    /// Places of the nodes \[m\].
    pub(super) fn places(&self) -> impl Iterator<Item = f64> {
        self.chain.nodes.iter().map(|node| node.place)
    }

    /// True where the first displacement is more even than odd about the middle of the axle.
    pub(super) fn is_symmetric(&self) -> bool {
        /// Enough to resolve any mode that a wave of a few nodes makes.
        const PLACES: usize = 200;
        let (Some(first), Some(last)) = (self.chain.nodes.first(), self.chain.nodes.last()) else {
            return true;
        };
        let place = |step: usize| first.place + (last.place - first.place) * step as f64 / PLACES as f64;
        let product = |step: usize| self.at(place(step))[0] * self.at(place(PLACES - step))[0];
        (0..=PLACES).map(product).sum::<f64>() > 0.0
    }
}
