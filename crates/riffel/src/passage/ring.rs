//! A rail as a ring, made of a record or of waves.

use std::f64::consts::{FRAC_PI_2, TAU};

use riffel_numerics::matrix::dot;

use super::{Evolution, Sinusoid};
use crate::Error;
use crate::roughness::{BandPass, Profile, WavelengthBand};

impl Evolution {
    /// A rail before any wheel, of a record whose ends do not meet.
    ///
    /// Waves longer than the given wavelength \[m\] are taken off by [`BandPass`], which a vehicle follows on its suspension and
    /// which would not meet either. Then the last heights, over that length, are laid on the first, with weights
    /// s = sin and c = cos over a quarter of a period, over √(1 + 2ρsc) with the correlation ρ of the two: the power stays as it is,
    /// of noise and of a regular wave. The ring is shorter than the record by that length and by up to half of it more, so much
    /// that ρ is highest and waves go on where they end; waves shorter than 2.6 spacings are gone.
    ///
    /// With a `bay` \[m\], the support spacing, the ring is as many whole bays as the record has, or up to three fewer for the
    /// same end: its spacing is changed for that by less than half of itself over the whole length.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a record shorter than four of the longest wavelengths or than a bay, and those of the filter.
    pub fn of_record(record: &Profile, longest: f64, bay: Option<f64>) -> Result<Self, Error> {
        /// Wavelengths that a record must be long, in the longest.
        const LEAST: f64 = 4.0;
        /// Shortest wavelength of a filter, in spacings.
        const SHORTEST: f64 = 2.6;
        /// Bays that a ring may have fewer than its record.
        const FEWER_BAYS: u8 = 3;
        /// Power of a joint below which it is not raised: waves that cancel there stay weak.
        const LEAST_POWER: f64 = 0.25;
        if record.length() < LEAST * longest {
            return Err(Error::OutOfRange {
                quantity: "length of the record",
                value: record.length(),
                unit: "m",
                rule: "must be four times the longest wavelength that is kept, so that its ends can be joined",
            });
        }
        let spacing = record.spacing();
        let kept = WavelengthBand::new(SHORTEST * spacing, longest)?;
        let filter = BandPass::new(spacing, record.heights().len(), &[kept])?;
        let heights = filter.filter(record).swap_remove(0);
        let overlap = (longest / spacing).round() as usize;
        let longest = heights.len() - overlap;
        let best_of = |counts: &mut dyn Iterator<Item = usize>| {
            let joints = counts.map(|count| (count, correlation(&heights, count, overlap)));
            let best = joints.max_by(|one, other| one.1.total_cmp(&other.1));
            best.unwrap_or((longest, 0.0))
        };
        let (count, alike);
        let mut spacing = spacing;
        if let Some(bay) = bay {
            let bays = ((longest as f64 + 0.5) * spacing / bay).floor();
            if bays < 1.0 {
                return Err(Error::OutOfRange {
                    quantity: "length of the record without what its ends are joined over",
                    value: longest as f64 * spacing,
                    unit: "m",
                    rule: "must be a support spacing or more",
                });
            }
            let of = |bays: f64| longest.min((bays * bay / spacing).round() as usize);
            let fewer = (0..=FEWER_BAYS).map(|fewer| bays - f64::from(fewer));
            let tried = fewer.filter(|tried| *tried >= 0.5 * bays);
            (count, alike) = best_of(&mut tried.map(of));
            let bays = (count as f64 * spacing / bay).round();
            spacing = bays * bay / count as f64;
        } else {
            let shortest = longest - overlap / 2;
            (count, alike) = best_of(&mut (shortest..=longest).rev());
        }
        let ring = (0..count).map(|index| {
            let share = (index as f64 + 0.5) / overlap as f64;
            if share >= 1.0 {
                return heights[index];
            }
            let (first, last) = (FRAC_PI_2 * share).sin_cos();
            let power = (1.0 + 2.0 * alike * first * last).max(LEAST_POWER);
            (first * heights[index] + last * heights[count + index]) / power.sqrt()
        });
        Ok(Self::new(&Profile::new(record.start(), spacing, ring.collect())?))
    }
}

/// How alike the first heights are to as many from another on, from −1 to 1; 0 where either is still.
fn correlation(heights: &[f64], from: usize, count: usize) -> f64 {
    let (first, last) = (&heights[..count], &heights[from..from + count]);
    let scale = (dot(first, first) * dot(last, last)).sqrt();
    match scale > 0.0 {
        true => dot(first, last) / scale,
        false => 0.0,
    }
}

impl Sinusoid {
    /// Waves of the same height as a ring, one from crest to crest or, with a support spacing \[m\], as many as whole bays
    /// have.
    ///
    /// Of 4 to 32 bays those are taken whose length comes nearest to whole waves, the fewest that come as near as a part of
    /// 10⁻³; the wavelength is changed for that by 1/64 of a wave in four bays at most.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] for a wavelength that is not positive.
    pub fn ring(&self, bay: Option<f64>) -> Result<Profile, Error> {
        /// Heights of a wave: its tenth harmonic has twelve.
        const HEIGHTS: usize = 128;
        let (waves, length) = match bay {
            None => (1, self.wavelength),
            Some(bay) => whole_waves(self.wavelength, bay),
        };
        let count = HEIGHTS * waves;
        let height = |index: usize| {
            let share = (index % HEIGHTS) as f64 / HEIGHTS as f64;
            self.amplitude * (TAU * share).cos()
        };
        let spacing = length / count as f64;
        Profile::new(0.0, spacing, (0..count).map(height).collect())
    }
}

/// Number of waves of some wavelength \[m\] that bays have, and the length of these \[m\].
fn whole_waves(wavelength: f64, bay: f64) -> (usize, f64) {
    /// Part of a wavelength that is near enough.
    const NEAR: f64 = 1e-3;
    let tried = (4..=32).map(|bays| {
        let length = f64::from(bays) * bay;
        let waves = (length / wavelength).round().max(1.0);
        (waves as usize, length, (length / waves / wavelength - 1.0).abs())
    });
    let all: Vec<(usize, f64, f64)> = tried.collect();
    let near = all.iter().find(|(_, _, change)| *change <= NEAR);
    let nearest = || all.iter().min_by(|one, other| one.2.total_cmp(&other.2));
    near.or_else(nearest).map_or((1, wavelength), |&(waves, length, _)| (waves, length))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::roughness::{ColouredNoise, Recipe, level};

    /// Levels of noise stay within the scatter of its 100 to 200 lines in a band, 0.7 dB at most, and no step is left where
    /// the ends meet.
    #[test]
    fn a_record_becomes_a_ring() -> Result<(), Error> {
        let noise = ColouredNoise { level: 0.0, wavelength: 0.1, slope: 10.0, longest: 20.0 };
        let recipe = Recipe { length: 50.0, spacing: 1e-3, seed: 3, noise: Some(noise), ..Recipe::default() };
        let heights = recipe.heights()?.into_iter().enumerate();
        let sloping = heights.map(|(index, height)| height + 1e-6 * index as f64);
        let record = Profile::new(7.0, 1e-3, sloping.collect())?;
        let ring = Evolution::of_record(&record, 1.0, None)?;
        assert!((48_500..=49_000).contains(&ring.heights().len()));
        let of_bays = Evolution::of_record(&record, 1.0, Some(0.6501))?;
        let bays = of_bays.heights().len() as f64 * of_bays.spacing() / 0.6501;
        assert!(
            (bays - bays.round()).abs() < 1e-9
                && (72.0..75.5).contains(&bays)
                && (of_bays.spacing() / 1e-3 - 1.0).abs() < 2e-5
        );
        for wavelength in [0.05, 0.1] {
            let half = 10f64.powf(0.05);
            let band = (wavelength / half, wavelength * half);
            let waves = ring.waves().into_iter();
            let power: f64 = waves
                .filter(|(wave, _)| (band.0..band.1).contains(wave))
                .map(|(_, amplitude)| 0.5 * amplitude.norm_sqr())
                .sum();
            let expected = noise.level_at(wavelength);
            assert!((level(power) - expected).abs() < 1.0, "{} {expected}", level(power));
        }
        let heights = ring.heights();
        let steps = heights.windows(2).map(|pair| (pair[1] - pair[0]).abs());
        let largest = steps.fold(0.0, f64::max);
        assert!((heights[0] - heights[heights.len() - 1]).abs() < largest);
        let short = record.between(7.0, 10.9).ok_or(Error::Measurement { index: 0, rule: "" })?;
        assert!(Evolution::of_record(&short, 1.0, None).is_err());
        Ok(())
    }

    /// A regular wave keeps its height all along, whatever part of a wave the record has left over, and on bays of twelve waves and
    /// of thirteen and a third.
    #[test]
    fn a_regular_wave_goes_on_where_it_ends() -> Result<(), Error> {
        for (wavelength, bay) in [(0.05, None), (0.047, None), (0.05, Some(0.6)), (0.045, Some(0.6))] {
            for length in [5.0, 5.013, 5.027] {
                let count = (length / 1e-3) as usize;
                let height = |index: usize| 1e-5 * (TAU * index as f64 * 1e-3 / wavelength).sin();
                let record = Profile::new(0.0, 1e-3, (0..count).map(height).collect())?;
                let ring = Evolution::of_record(&record, 1.0, bay)?;
                let most = ring.heights().iter().fold(0.0, |most: f64, it| most.max(it.abs()));
                assert!((most / 1e-5 - 1.0).abs() < 0.02, "{wavelength} {bay:?} {length}: {most}");
            }
        }
        Ok(())
    }
}
