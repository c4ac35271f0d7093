//! Covariance of what a model misses.

/// Covariance of two values of a process of variance one, by their distance.
///
/// Source: Rasmussen & Williams (2006), *Gaussian Processes for Machine Learning*, section 4.2.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kernel {
    /// Every datum has its own.
    Band,
    /// exp(−r/l), rough.
    Exponential { length: f64 },
    /// (1 + √3 r/l) exp(−√3 r/l), with one derivative.
    Matern32 { length: f64 },
    /// (1 + √5 r/l + 5r²/3l²) exp(−√5 r/l), with two.
    Matern52 { length: f64 },
    /// exp(−r²/2l²), with all.
    SquaredExponential { length: f64 },
}

impl Kernel {
    /// Names in a plan.
    pub(crate) const NAMES: [&'static str; 4] = ["exponential", "matern-3/2", "matern-5/2", "squared-exponential"];

    pub(crate) fn of(name: &str, length: f64) -> Option<Self> {
        let place = Self::NAMES.iter().position(|known| *known == name)?;
        Some(match place {
            0 => Self::Exponential { length },
            1 => Self::Matern32 { length },
            2 => Self::Matern52 { length },
            _ => Self::SquaredExponential { length },
        })
    }

    pub(crate) fn at(self, distance: f64) -> f64 {
        let r = distance.abs();
        match self {
            Self::Band => f64::from(u8::from(r == 0.0)),
            Self::Exponential { length } => (-r / length).exp(),
            Self::Matern32 { length } => {
                let s = 3f64.sqrt() * r / length;
                (1.0 + s) * (-s).exp()
            }
            Self::Matern52 { length } => {
                let s = 5f64.sqrt() * r / length;
                (1.0 + s + s * s / 3.0) * (-s).exp()
            }
            Self::SquaredExponential { length } => (-0.5 * (r / length).powi(2)).exp(),
        }
    }
}
