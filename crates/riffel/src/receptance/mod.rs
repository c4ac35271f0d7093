//! Receptances of track and wheel: complex displacement per unit force \[m/N\], both positive
//! downward, for the time factor exp(+iωt). A passive structure has Im H ≤ 0.

mod beam;
mod free_beam;
mod moving_beam;
mod rigid_mass;
mod tabulated;
mod two_layer;

pub use beam::EulerBernoulliBeam;
pub use free_beam::FreeBeam;
pub use moving_beam::{MovingBeam, MovingLoadRoots};
pub use rigid_mass::RigidMass;
pub use tabulated::{Tabulated, TabulationError};
pub use two_layer::{Layer, TwoLayerTrack};

use num_complex::Complex64;

use crate::{SplitComplex, Tile};

/// A tile of angular frequencies with their reciprocals, which a map has for nothing and which spare
/// the simplest structures a division.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Frequencies {
    /// ω \[rad/s\].
    pub angular: Tile,
    /// 1/ω \[s/rad\].
    pub reciprocal: Tile,
}

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

    /// True where the receptance depends on frequency alone and one evaluation costs more than an
    /// interpolation: a large map then works from a [`Tabulated`] copy.
    fn worth_tabulating(&self) -> bool {
        false
    }
}
