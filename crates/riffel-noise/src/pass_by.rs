//! A train that passes: from the sound power of its sources to the level beside the track.

use riffel::Error;

use super::Air;

/// What is around source and receiver.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Surroundings {
    /// Nothing.
    FreeField,
    /// Hard ground under source and receiver; source and image add in energy, as they do in one-third octaves for
    /// receivers some metres away.
    #[default]
    HardGround,
    /// A receiver in the face of a large hard plate, where the pressure is twice that of the free field.
    OnPlate,
}

impl Surroundings {
    /// Mean square pressure over that of the free field \[-\].
    pub fn gain(self) -> f64 {
        match self {
            Self::FreeField => 1.0,
            Self::HardGround => 2.0,
            Self::OnPlate => 4.0,
        }
    }
}

/// A train past a receiver.
///
/// A wheel of the sound power W that passes at the distance d with the speed V leaves ∫p²dt = ρcW/(4πd²) · ∫dt/(1 + (Vt/d)²)
/// = ρcW/(4dV) in the free field. N wheels in a train of the length L, which takes T = L/V to pass, have the mean square
/// pressure over T
///
/// ```text
/// p² = ρc (N/L) W/(4d)
/// ```
///
/// on each rail; sources add in energy. Sources are taken to radiate alike to all sides; the ends of the train and
/// what absorbs sound are left out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PassBy {
    /// Distance of the receiver from the middle of the track \[m\].
    distance: f64,
    /// Height of the receiver over the rail head \[m\].
    height: f64,
    /// Wheelsets per length of train \[1/m\].
    wheelsets_per_metre: f64,
    surroundings: Surroundings,
}

impl PassBy {
    /// Distance of the rails between their contacts \[m\].
    const GAUGE: f64 = 1.5;

    /// Distance of the rails from the middle of the track \[m\], beyond which a receiver is.
    pub const NEAREST: f64 = 0.5 * Self::GAUGE;

    /// Length of train to a wheel on one rail \[m\]: a coach of 26.4 m on four wheelsets (UIC 567).
    pub const LENGTH_PER_WHEEL: f64 = 6.6;

    /// A receiver at a distance from the middle of the track and a height over the rail head \[m\], beside a train of some
    /// wheelsets and some length \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the receiver is beside the track, and there are wheelsets and a length.
    pub fn new(
        distance: f64,
        height: f64,
        wheelsets: f64,
        train_length: f64,
        surroundings: Surroundings,
    ) -> Result<Self, Error> {
        if !(distance > Self::NEAREST && distance.is_finite()) {
            return Err(Error::OutOfRange {
                quantity: "distance of the receiver from the middle of the track",
                value: distance,
                unit: "m",
                rule: "must be beyond the rail, 0.75 m",
            });
        }
        Error::unless_not_negative("height of the receiver", height, "m")?;
        Error::unless_positive("number of wheelsets", wheelsets, "")?;
        Error::unless_positive("length of the train", train_length, "m")?;
        Ok(Self { distance, height, wheelsets_per_metre: wheelsets / train_length, surroundings })
    }

    /// Mean square pressure \[Pa²\] over the time the train takes to pass, where each wheel with the rail under it has a
    /// sound power \[W\].
    pub fn of_wheels(&self, air: &Air, power: f64) -> f64 {
        let rails = [self.distance - Self::NEAREST, self.distance + Self::NEAREST];
        let sum: f64 = rails.iter().map(|across| across.hypot(self.height).recip()).sum();
        self.mean_square(air, power) * sum
    }

    /// Mean square pressure \[Pa²\] if each wheelset, with the track under it, is a source in the middle of the track that radiates to
    /// the sides as 0.01 + 0.99 sin²φ, the horizontal directivity of the European directive: 10 lg 0.505 = −3 dB over
    /// the passage.
    pub fn of_wheelsets(&self, air: &Air, power: f64) -> f64 {
        0.505 * self.mean_square(air, power) / self.distance.hypot(self.height)
    }

    /// p²d \[Pa² m\] of a line of sources.
    fn mean_square(&self, air: &Air, power: f64) -> f64 {
        0.25 * self.surroundings.gain() * air.impedance() * self.wheelsets_per_metre * power
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The closed form is the integral of the passage of one source.
    #[test]
    fn one_source_that_passes() -> Result<(), Error> {
        let air = Air::default();
        let (distance, speed, length) = (7.5, 40.0, 200.0);
        let pass = PassBy::new(distance, 0.0, 1.0, length, Surroundings::FreeField)?;
        let steps = 400_000;
        let (from, to) = (-500.0, 500.0);
        let step: f64 = (to - from) / f64::from(steps);
        let exposure: f64 = (0..steps)
            .map(|index| {
                let along = speed * (from + step * (f64::from(index) + 0.5));
                let squares = [6.75f64, 8.25].map(|across| across * across + along * along);
                let sum: f64 = squares.iter().map(|square| square.recip()).sum();
                air.impedance() / (4.0 * std::f64::consts::PI) * sum * step
            })
            .sum();
        let mean = exposure / (length / speed);
        assert!((pass.of_wheels(&air, 1.0) / mean - 1.0).abs() < 1e-3);
        Ok(())
    }

    #[test]
    fn twice_as_far_is_three_decibels_and_a_plate_six() -> Result<(), Error> {
        let air = Air::default();
        let at = |distance, surroundings| PassBy::new(distance, 0.0, 4.0, 26.4, surroundings);
        let level = |pass: PassBy| 10.0 * pass.of_wheelsets(&air, 1.0).log10();
        let near = level(at(25.0, Surroundings::FreeField)?);
        assert!((near - level(at(50.0, Surroundings::FreeField)?) - 3.01).abs() < 0.01);
        assert!((level(at(25.0, Surroundings::OnPlate)?) - near - 6.02).abs() < 0.01);
        assert!(at(0.5, Surroundings::FreeField).is_err());
        assert!(PassBy::new(7.5, 1.2, 0.0, 26.4, Surroundings::FreeField).is_err());
        Ok(())
    }
}
