//! Receptances of track and wheel: complex displacement per unit force \[m/N\], both positive
//! downward, for the time factor exp(+iωt). A passive structure has Im H ≤ 0.

mod bar;
mod beam;
mod continuous;
mod coupled_floquet;
mod decay_rate;
mod euler_bernoulli;
mod extremum;
mod free_beam;
mod free_motion;
mod irregular;
mod lateral_resonance;
mod mass_on_rail;
mod measured;
mod moving_beam;
mod moving_load;
mod moving_load_on_supports;
mod periodic;
mod quadrature_over_wavenumbers;
mod resonance;
mod rigid_ground;
mod spatial_moving_load;
mod spatial_track;
mod structure;
mod support;
mod tabulated;
mod twist;
mod twisting_rail;
mod wave_stiffness;
mod waves;

pub use bar::Bar;
pub use beam::{Beam, ShearSection};
pub use continuous::ContinuousTrack;
pub use decay_rate::{DecayRate, one_sided_places};
pub use euler_bernoulli::EulerBernoulliBeam;
pub use extremum::Extremum;
pub use free_beam::FreeBeam;
pub(crate) use free_motion::free_of;
pub use irregular::{IrregularTrack, IrregularWaves};
pub use mass_on_rail::MassOnRail;
pub use measured::MeasuredReceptance;
pub use moving_beam::{MovingBeam, MovingLoadRoots};
pub use moving_load::MovingLoadTrack;
pub use moving_load_on_supports::{Harmonics, MovingLoadOnSupports};
pub use periodic::{FloquetWaves, PeriodicTrack};
pub use resonance::{Resonance, ResonanceKind};
pub use rigid_ground::RigidGround;
pub use spatial_moving_load::{HarmonicMatrices, SpatialMovingLoad};
pub use spatial_track::{ContactPoint, RememberingTrack, SpatialRail, SpatialTrack, Supports, TrackMemory};
pub(crate) use structure::pairs;
pub use structure::{Structure, Uncoupled};
pub use support::{Layer, Support};
pub use tabulated::Tabulated;
pub use twist::{Twist, TwistSection};
pub use waves::{Wave, Waveguide, Waves};

use std::sync::Arc;

use num_complex::Complex64;

use crate::tile::{Frequencies, SplitComplex};

/// Joint of the loop: a structure under an oscillating force at the contact.
///
/// A new track or wheel is one new implementation of [`receptance`](Self::receptance).
pub trait Receptance: Send + Sync {
    /// Receptance \[m/N\] at the angular frequency ω > 0 \[rad/s\], under a load that travels along
    /// the structure at the given speed \[m/s\]; a structure that does not feel the motion of its
    /// load ignores the speed.
    fn receptance(&self, angular_frequency: f64, speed: f64) -> Complex64;

    /// Receptances at a tile of frequencies and one speed.
    ///
    /// Provided, so that a tile of a map costs one dynamic call.
    fn receptances(&self, frequencies: &Frequencies, speed: f64, receptances: &mut SplitComplex) {
        receptances.set(&frequencies.angular, |w| self.receptance(w, speed));
    }

    /// Part A \[1/kg\] of the receptance, H → −A/ω² for ω → 0: the motion that nothing holds.
    ///
    /// Provided, from the receptance at three low frequencies, for a structure that only its receptance describes.
    fn free(&self) -> f64 {
        free_of(&|w| vec![self.receptance(w, 1.0)])[0]
    }

    /// True where the receptance depends on frequency alone and one evaluation costs more than an
    /// interpolation: a large map then works from a [`Tabulated`] copy.
    fn worth_tabulating(&self) -> bool {
        false
    }

    /// Lowest and highest angular frequency \[rad/s\] at which the receptance is known.
    fn frequency_range(&self) -> (f64, f64) {
        (0.0, f64::INFINITY)
    }
}

/// A track that answers at one place to a force at another.
pub trait CrossReceptance: Receptance {
    /// Displacement at `to` per force at `from` \[m/N\], both places in metres along the rail, the
    /// origin over a support; angular frequency ω > 0 \[rad/s\]. Reciprocal: the two may be
    /// exchanged.
    fn cross_receptance(&self, angular_frequency: f64, from: f64, to: f64) -> Complex64;

    /// Displacements per force from one place to several, in their order.
    ///
    /// Provided, so that a track whose waves serve all places finds them once.
    fn cross_receptances(&self, angular_frequency: f64, from: f64, to: &[f64]) -> Vec<Complex64> {
        let to = to.iter();
        to.map(|to| self.cross_receptance(angular_frequency, from, *to)).collect()
    }

    /// Distance of the supports \[m\], where they are discrete.
    fn support_spacing(&self) -> Option<f64>;

    /// The receptance under a load at a place along the rail \[m\].
    fn under_load_at(&self, place: f64) -> Arc<dyn Receptance>;
}
