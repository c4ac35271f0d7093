//! One-third octaves of wavelength.

use crate::Error;

/// Nominal centres of a decade \[-\], from 1.
pub const NOMINAL_OF_DECADE: [f64; 10] = [1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0];

/// A base-ten one-third octave: centre 10^(n/10) m, edges 10^(±1/20) about it (EN 15610, Annex C, in
/// wavenumber; the bands are the same in wavelength).
///
/// Bands are ordered by wavelength.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct ThirdOctave {
    index: i32,
}

impl ThirdOctave {
    /// Decimal logarithm of the ratio of a band's edge to its centre \[-\].
    pub const HALF_WIDTH_DECADES: f64 = 0.05;

    /// The band whose centre is 10^(`index`/10) m.
    pub const fn new(index: i32) -> Self {
        Self { index }
    }

    /// The band in which a wavelength \[m\] lies; nominal wavelengths lie in their bands.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the wavelength is finite and above zero.
    pub fn containing(wavelength: f64) -> Result<Self, Error> {
        Error::unless_positive("wavelength", wavelength, "m")?;
        Ok(Self::new((10.0 * wavelength.log10()).round() as i32))
    }

    /// The band of which a wavelength \[m\] is the exact or the nominal centre; these are 1.3 % apart at most.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a wavelength more than 5 % from a centre.
    pub fn centred(wavelength: f64) -> Result<Self, Error> {
        let band = Self::containing(wavelength)?;
        if (wavelength / band.wavelength() - 1.0).abs() <= 0.05 {
            return Ok(band);
        }
        Err(Error::OutOfRange {
            quantity: "wavelength of a one-third octave",
            value: wavelength,
            unit: "m",
            rule: "must be the centre of one, such as 0.0315 or 0.04",
        })
    }

    /// The n of the centre 10^(n/10) m.
    pub const fn index(self) -> i32 {
        self.index
    }

    /// Exact centre \[m\].
    pub fn wavelength(self) -> f64 {
        10f64.powf(f64::from(self.index) / 10.0)
    }

    /// Shortest and longest wavelength \[m\].
    pub fn wavelength_range(self) -> (f64, f64) {
        let half = 10f64.powf(Self::HALF_WIDTH_DECADES);
        (self.wavelength() / half, self.wavelength() * half)
    }

    /// Lowest and highest wavenumber \[1/m\], without 2π.
    pub fn wavenumber_range(self) -> (f64, f64) {
        let (shortest, longest) = self.wavelength_range();
        (longest.recip(), shortest.recip())
    }

    /// Nominal centre \[mm\]: 31.5 for 31.623 mm.
    pub fn nominal_millimetres(self) -> f64 {
        let (decade, place) = (self.index.div_euclid(10), self.index.rem_euclid(10));
        let nominal = NOMINAL_OF_DECADE[place as usize];
        // 10⁻¹ and its powers are not exact: divide where the decade is below a millimetre.
        match decade + 3 {
            power @ 0.. => nominal * 10f64.powi(power),
            power => nominal / 10f64.powi(-power),
        }
    }

    /// All bands whose centres are within the two, the shorter first.
    pub fn between(shortest: Self, longest: Self) -> impl Iterator<Item = Self> {
        (shortest.index..=longest.index).map(Self::new)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nominal_wavelengths_lie_in_their_bands() -> Result<(), Error> {
        for index in -30..=5 {
            let band = ThirdOctave::new(index);
            let nominal = band.nominal_millimetres();
            assert_eq!(ThirdOctave::containing(1e-3 * nominal)?, band);
            assert!((1e3 * band.wavelength() / nominal - 1.0).abs() < 0.013);
        }
        assert_eq!(ThirdOctave::new(-17).nominal_millimetres(), 20.0);
        assert_eq!(ThirdOctave::new(-15).nominal_millimetres(), 31.5);
        assert!((ThirdOctave::new(-17).wavelength() - 0.019_952_623).abs() < 1e-9);
        assert!(ThirdOctave::containing(0.0).is_err());
        Ok(())
    }

    #[test]
    fn neighbours_share_an_edge() {
        let (band, next) = (ThirdOctave::new(-17), ThirdOctave::new(-16));
        let (upper, lower) = (band.wavelength_range().1, next.wavelength_range().0);
        assert!((upper / lower - 1.0).abs() < 1e-12);
    }
}
