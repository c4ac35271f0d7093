//! A case on discrete supports with the wheel passing them.

use riffel::growth::GrowthWithNeighbours;
use riffel::receptance::MovingLoadOnSupports;
use riffel_keys::CaseError;

use crate::Case;

impl Case {
    /// Growth of a wave \[m\] at a speed \[m/s\] together with so many neighbours on each side, 1/λ ± n/d, which the passing of
    /// supports makes of it.
    ///
    /// # Errors
    /// [`CaseError`] for a case without discrete supports, for a loop on all axes or of several wheels, and for more
    /// neighbours than have a wavelength.
    pub fn growth_with_neighbours(
        &self,
        wavelength: f64,
        speed: f64,
        neighbours: usize,
    ) -> Result<GrowthWithNeighbours, CaseError> {
        let Some(feedback) = self.feedback.longitudinal() else {
            let message = "growth with neighbours takes one wheel of [wheel] with longitudinal creepage, and this is a loop \
                           on all axes or of several wheels";
            return Err(self.refuse("contact.creepage", message));
        };
        if self.track.support_spacing().is_none() {
            let message = format!(
                "`track.model` is \"{}\", but only discrete supports make neighbours of a wave; choose a periodic model",
                self.file.track.model.name()
            );
            return Err(self.refuse("track.model", &message));
        }
        let track = self.moving_load_on_supports(speed)?;
        GrowthWithNeighbours::at(feedback, &track, wavelength, neighbours).map_err(|error| {
            CaseError::Physics {
                input: "--neighbours".to_owned(),
                error,
            }
        })
    }

    /// The vertical track of a case with discrete supports, under a load that passes them.
    pub(crate) fn moving_load_on_supports(
        &self,
        speed: f64,
    ) -> Result<MovingLoadOnSupports, CaseError> {
        let track = self.keys.periodic_track()?;
        let moving = MovingLoadOnSupports::new(&track, speed);
        self.keys.physics("track", moving)
    }
}
