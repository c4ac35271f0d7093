//! Frequencies at which waves of bending across the track and of twist cut on.

use riffel_numerics::matrix::Matrix;

use super::{ResonanceKind, SpatialTrack, Support, Twist, Waveguide};

impl SpatialTrack {
    /// Undamped angular frequencies \[rad/s\] of the lateral motion that have a name, lowest first: those at which the
    /// rail moves on its supports without bending (cut-on: waves run from there on, and the receptance has its peaks
    /// nearby), and on discrete supports the lateral pinned-pinned frequency, if the rail shears (see
    /// [`Beam::pinned_pinned_frequency`](super::Beam::pinned_pinned_frequency)).
    ///
    /// The section moves as a rigid body: across the track, about its centroid, and against the sleeper, if that has
    /// mass. Of these modes the one with most of its kinetic energy in rotation is the roll cut-on, the others are
    /// lateral. Supports are spread evenly here. Source: the equations of [`SpatialTrack`] at an infinite wavelength,
    /// as an eigenvalue problem of two or three degrees of freedom. Exact to rounding.
    pub fn lateral_resonances(&self) -> Vec<(ResonanceKind, f64)> {
        let Some(bending) = self.rail().lateral else {
            return Vec::new();
        };
        let mass = bending.mass_per_length();
        let supports = match self.support_spacing() {
            // The constructor has checked the spacing.
            Some(spacing) => self.supports().per_metre(spacing).unwrap_or_default(),
            None => *self.supports(),
        };
        let mut found = match (supports.lateral, self.rail().twist) {
            (None, _) => Vec::new(),
            (Some(lateral), None) => lateral
                .cut_on_frequencies(mass)
                .into_iter()
                .map(|frequency| (ResonanceKind::LateralCutOn, frequency))
                .collect(),
            (Some(lateral), Some(twist)) => {
                let pad = supports.vertical.map_or(0.0, |support| support.pad().stiffness());
                cut_ons(mass, &twist, &lateral, pad)
            }
        };
        if let Some(spacing) = self.support_spacing().filter(|_| bending.shears()) {
            let frequency = bending.pinned_pinned_frequency(spacing, 1);
            found.push((ResonanceKind::LateralPinnedPinned, frequency));
        }
        found.sort_by(|(_, a), (_, b)| a.total_cmp(b));
        found
    }
}

/// Rigid modes of a rail of the given mass per metre on lateral supports and on pads of the given vertical stiffness.
fn cut_ons(mass: f64, twist: &Twist, lateral: &Support, pad: f64) -> Vec<(ResonanceKind, f64)> {
    let section = twist.section();
    // The foot below the centroid, which carries the mass.
    let lever = section.foot_depth + section.centroid_height;
    let roll = pad * section.foot_width * section.foot_width / 12.0;
    let inertia = twist.polar_inertia();
    match *lateral {
        Support::TwoLayer { pad, sleeper_mass, ballast } if sleeper_mass > 0.0 => named(&modes(
            [mass, inertia, sleeper_mass],
            &[(pad.stiffness(), [1.0, -lever, -1.0]), (roll, [0.0, 1.0, 0.0]), (ballast.stiffness(), [0.0, 0.0, 1.0])],
        )),
        _ => named(&modes([mass, inertia], &[(lateral.static_stiffness(), [1.0, -lever]), (roll, [0.0, 1.0])])),
    }
}

/// Modes by name, from ω² and the share of the rotation in the kinetic energy.
fn named(modes: &[(f64, f64)]) -> Vec<(ResonanceKind, f64)> {
    let roll = modes.iter().map(|&(_, share)| share).fold(0.0, f64::max);
    let name = |&(square, share): &(f64, f64)| {
        let kind = if share == roll { ResonanceKind::RollCutOn } else { ResonanceKind::LateralCutOn };
        (kind, square.max(0.0).sqrt())
    };
    modes.iter().map(name).collect()
}

/// ω² of N masses on springs, each of a stiffness and of what every mass contributes to its length, with the share of
/// the second mass in the kinetic energy.
fn modes<const N: usize>(masses: [f64; N], springs: &[(f64, [f64; N])]) -> Vec<(f64, f64)> {
    let matrix = Matrix::of(N, |row, column| {
        let stiffness = springs.iter().map(|(k, length)| k * length[row] * length[column]);
        stiffness.sum::<f64>() / (masses[row] * masses[column]).sqrt()
    });
    let (squares, vectors) = matrix.eigenvectors();
    squares.into_iter().enumerate().map(|(mode, square)| (square, vectors.at(mode, 1).powi(2))).collect()
}
