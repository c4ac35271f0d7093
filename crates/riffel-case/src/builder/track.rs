//! The track of a case.

use std::sync::Arc;

use riffel::{
    ElasticMaterial, EulerBernoulliBeam, FreeBeam, Layer, MovingBeam, Receptance, TwoLayerTrack,
};

use super::Builder;
use crate::CaseError;
use crate::file::{Support, TrackModel};

impl Builder {
    fn beam(&self, steel: ElasticMaterial) -> Result<EulerBernoulliBeam, CaseError> {
        let rail = &self.file.rail;
        let help = "give it, or name a preset by rail.section";
        let mass_per_length = rail
            .mass_per_length
            .ok_or_else(|| self.source.missing("rail.mass_per_length", help))?;
        let second_moment = rail
            .second_moment
            .ok_or_else(|| self.source.missing("rail.second_moment", help))?;
        let beam = EulerBernoulliBeam::new(
            steel,
            self.positive("rail.second_moment", second_moment)?,
            self.positive("rail.mass_per_length", mass_per_length)?,
        );
        self.physics("rail", beam)
    }

    /// The track under every load of the map, up to the longest wavelength \[m\] and highest speed
    /// \[m/s\].
    pub(super) fn track(
        &self,
        steel: ElasticMaterial,
        wavelength: f64,
        speed: f64,
    ) -> Result<Arc<dyn Receptance>, CaseError> {
        self.check_track()?;
        let beam = self.beam(steel)?;
        let track = &self.file.track;
        Ok(match track.model {
            TrackModel::FreeBeam => Arc::new(FreeBeam::new(beam)),
            TrackModel::MovingBeam => {
                let damping = track.rail_damping.map_or(0.0, |damping| damping.si());
                let model = self.physics("track.rail_damping", MovingBeam::new(beam, damping))?;
                self.physics("map", model.check_speed(wavelength, speed))?;
                Arc::new(model)
            }
            TrackModel::TwoLayer => {
                let spacing = self.required("track.support_spacing", track.support_spacing)?;
                let spacing = spacing.si();
                let pad = self.layer("track.pad", track.pad.as_ref(), spacing)?;
                let ballast = self.layer("track.ballast", track.ballast.as_ref(), spacing)?;
                let sleeper = self.required("track.sleeper.mass", track.sleeper.as_ref())?;
                let model = TwoLayerTrack::new(beam, pad, sleeper.mass.si() / spacing, ballast);
                Arc::new(self.physics("track", model)?)
            }
        })
    }

    fn layer(
        &self,
        key: &str,
        support: Option<&Support>,
        spacing: f64,
    ) -> Result<Layer, CaseError> {
        let support = self.required(key, support)?;
        let stiffness = self.required(&format!("{key}.stiffness"), support.stiffness)?;
        let damping = self.required(&format!("{key}.damping"), support.damping)?;
        let layer = Layer::new(stiffness.si() / spacing, damping.si() / spacing);
        self.physics(key, layer)
    }

    /// Every value of the track that is written, whether its model needs it or not.
    fn check_track(&self) -> Result<(), CaseError> {
        let track = &self.file.track;
        if let Some(spacing) = track.support_spacing {
            self.positive("track.support_spacing", spacing)?;
        }
        for (key, support) in [("track.pad", &track.pad), ("track.ballast", &track.ballast)] {
            let Some(support) = support else { continue };
            if let Some(stiffness) = support.stiffness {
                self.positive(&format!("{key}.stiffness"), stiffness)?;
            }
            if let Some(damping) = support.damping {
                self.not_negative(&format!("{key}.damping"), damping)?;
            }
        }
        if let Some(sleeper) = &track.sleeper {
            self.not_negative("track.sleeper.mass", sleeper.mass)?;
        }
        if let Some(damping) = track.rail_damping {
            self.not_negative("track.rail_damping", damping)?;
        }
        Ok(())
    }
}
