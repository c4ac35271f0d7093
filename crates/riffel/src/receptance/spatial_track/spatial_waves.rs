//! Waves of a rail that moves on all axes, and motions that they make.

use num_complex::Complex64;

use crate::receptance::coupled_floquet::{CoupledFloquet, CoupledStation};
use crate::receptance::periodic::Station;
use crate::receptance::twisting_rail::{CoupledWaves, LateralReceptance};
use crate::receptance::{FloquetWaves, Waves};

/// The waves of a track at one frequency, and what they are at some places.
pub(in crate::receptance) struct SpatialWaves {
    pub(super) alongs: Vec<f64>,
    pub(super) vertical: AxisWaves,
    pub(super) longitudinal: Option<AxisWaves>,
    pub(super) lateral: Option<LateralWaves>,
}

/// Displacements at one place by unit forces at another.
#[derive(Debug, Clone, Copy, Default)]
pub(in crate::receptance) struct Motions {
    pub(in crate::receptance) vertical: Complex64,
    pub(super) longitudinal: Complex64,
    pub(in crate::receptance) lateral: LateralReceptance,
}

/// Waves of one motion of the rail.
pub(super) enum AxisWaves {
    Even { waves: Waves, point: Complex64 },
    Discrete { waves: FloquetWaves, stations: Vec<Station> },
}

/// Waves of bending across the track and twist.
pub(super) enum LateralWaves {
    Bending(AxisWaves),
    Even(CoupledWaves),
    Discrete { waves: Box<CoupledFloquet>, stations: Vec<CoupledStation> },
}

impl SpatialWaves {
    /// Motions at one of the places by forces at another, by their numbers.
    pub(in crate::receptance) fn motions(&self, from: usize, to: usize) -> Motions {
        let alongs = &self.alongs;
        let along_axis = |axis: &AxisWaves| axis.receptance(alongs, from, to);
        Motions {
            vertical: along_axis(&self.vertical),
            longitudinal: self.longitudinal.as_ref().map_or(Complex64::ZERO, along_axis),
            lateral: match &self.lateral {
                None => LateralReceptance::default(),
                Some(LateralWaves::Bending(axis)) => [[along_axis(axis), Complex64::ZERO], [Complex64::ZERO; 2]],
                Some(LateralWaves::Even(waves)) => waves.receptance((alongs[to] - alongs[from]).abs()),
                Some(LateralWaves::Discrete { waves, stations }) => waves.between(&stations[from], &stations[to]),
            },
        }
    }
}

impl AxisWaves {
    pub(super) fn receptance(&self, alongs: &[f64], from: usize, to: usize) -> Complex64 {
        match self {
            Self::Even { waves, point } => {
                let distance = (alongs[to] - alongs[from]).abs();
                if distance == 0.0 {
                    return *point;
                }
                let waves = waves.as_slice().iter();
                waves.map(|wave| wave.amplitude * (-wave.propagation * distance).exp()).sum()
            }
            Self::Discrete { waves, stations } => waves.between(&stations[from], &stations[to]),
        }
    }
}
