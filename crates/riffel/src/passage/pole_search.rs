//! How many poles the response of a structure takes.

use num_complex::Complex64;

use super::ImpulseResponse;
use super::vector_fitting::worst_frequencies;
use crate::Error;

/// A fit by partial fractions.
pub(super) struct PoleFit<T> {
    pub(super) fit: T,
    /// Mean square of its relative error.
    pub(super) share_cut: f64,
    /// Its poles, one of each pair \[rad/s\].
    pub(super) poles: Vec<Complex64>,
    /// Its error at frequencies \[rad/s\].
    pub(super) errors: Vec<(f64, f64)>,
}

/// The search for a fit of enough poles and no more.
pub(super) struct PoleSearch<T> {
    best: Option<PoleFit<T>>,
    /// A share below needs no more poles.
    fine: f64,
}

impl<T> PoleSearch<T> {
    /// The best of fits, made one after the other until one is fine. With a gain, one that leaves more than that part of the best so far is
    /// the last.
    pub(super) fn among(fits: impl IntoIterator<Item = PoleFit<T>>, fine: f64, gain: Option<f64>) -> Self {
        let mut search = Self { best: None, fine };
        for fit in fits {
            let better = search.betters(&fit, gain.unwrap_or(1.0));
            if better {
                search.best = Some(fit);
            }
            if search.is_fine() || (!better && gain.is_some()) {
                break;
            }
        }
        search
    }

    /// On from the poles of the best fit, with pairs where it is off most, up to five times. What more poles do not halve is not causal.
    pub(super) fn refined(mut self, fit: impl Fn(&[Complex64]) -> PoleFit<T>) -> Self {
        const FITS: usize = 5;
        const MORE: usize = 6;
        for _ in 0..FITS {
            let Some(best) = self.best.as_ref().filter(|_| !self.is_fine()) else {
                break;
            };
            let worst = worst_frequencies(best.errors.clone(), MORE).into_iter();
            let pairs = worst.map(|w| Complex64::new(-0.02, 1.0) * w);
            let starting: Vec<Complex64> = best.poles.iter().copied().chain(pairs).collect();
            let next = fit(&starting);
            if !self.betters(&next, 0.5) {
                break;
            }
            self.best = Some(next);
        }
        self
    }

    /// What was found.
    ///
    /// # Errors
    /// [`Error::NotCausal`] if no causal response comes near enough.
    pub(super) fn found(self) -> Result<T, Error> {
        // Not a number is no share.
        match self.best {
            Some(best) if best.share_cut <= ImpulseResponse::LARGEST_SHARE_CUT => Ok(best.fit),
            best => Err(Error::NotCausal {
                share: best.map_or(f64::NAN, |best| best.share_cut),
                largest: ImpulseResponse::LARGEST_SHARE_CUT,
            }),
        }
    }

    /// Whether a fit leaves less than a part of what the best does.
    fn betters(&self, fit: &PoleFit<T>, part: f64) -> bool {
        let best = self.best.as_ref();
        best.is_none_or(|best| fit.share_cut < part * best.share_cut)
    }

    fn is_fine(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.share_cut <= self.fine)
    }
}
