//! What the shape of a wave itself does to a contact that rolls over it.

use std::sync::Arc;

use super::{ContactFilter, CurvatureFilter, HertzContact};
use crate::Error;

/// The wave's own geometry: how much a contact feels of the curvature of a wave r = Δ e^{ikx}.
///
/// A circle of the radius R touches where the normals agree, x = x_c + R r'. So the contact runs slower over crests than the wheel,
/// dx/dt = V/(1 + κ), and presses as if the wheel had the radius R/(1 + κ), both with
///
/// ```text
/// κ = R k² Φ(ka) Δ
/// ```
///
/// The slip speed s does not feel the wave: every creepage, which is slip per metre rolled, does, c₁ = s₁/V + c₀κ. What both do to
/// creep force and energy under constant load and slip speed is [`by_curvature`](super::ContactResponse::by_curvature). The patch is that of
/// the smaller radius: over a crest it is shorter, its pressure higher ([`HertzContact::pressure_by_curvature`]).
///
/// A contact that slides everywhere weighs load and wear with the same filter F = sin(ka)/(ka), e₁/e₀ = F P₁/P₀ + κ with
/// P₁ = k_H(F Δ − H P₁): there is no angle of the place of wear.
///
/// Source: derived in the book. Range of validity: κ < 1, one patch, waves of three semi-axes and more.
#[derive(Debug, Clone)]
pub struct WaveGeometry {
    radius: f64,
    patch: WavePatch,
    /// What a contact that slides everywhere averages.
    sliding: Option<ContactFilter>,
}

/// What part the size of the patch has in the curvature.
#[derive(Debug, Clone)]
pub enum WavePatch {
    /// None: the contact is a point, Φ = 1.
    Point,
    /// Φ of an ellipse.
    Ellipse(Arc<CurvatureFilter>),
    /// Φ is in the response of the contact, which resolves its patch.
    Resolved(Arc<CurvatureFilter>),
}

impl WaveGeometry {
    /// Of a contact whose wheel has the radius R along the rail \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless it is positive.
    pub fn new(radius: f64, patch: WavePatch) -> Result<Self, Error> {
        Error::unless_positive("radius along the rail", radius, "m")?;
        Ok(Self { radius, patch, sliding: None })
    }

    /// Geometry of a contact that slides everywhere.
    pub fn sliding(mut self, hertz: &HertzContact) -> Self {
        self.sliding = Some(ContactFilter::of(hertz));
        self
    }

    /// Whether the contact slides everywhere.
    pub fn is_sliding(&self) -> bool {
        self.sliding.is_some()
    }

    /// What a contact that slides everywhere presses and wears by; none of a point, and of one that sticks anywhere.
    pub fn filter(&self) -> Option<ContactFilter> {
        match self.patch {
            WavePatch::Point => None,
            _ => self.sliding,
        }
    }

    /// R \[m\].
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// Φ \[-\] of the wavenumber k \[rad/m\].
    pub fn share(&self, wavenumber: f64) -> f64 {
        match &self.patch {
            WavePatch::Point => 1.0,
            WavePatch::Ellipse(filter) | WavePatch::Resolved(filter) => filter.share(wavenumber),
        }
    }

    /// κ/Δ = R k² Φ \[1/m\], Φ one where the response of the contact has it.
    pub fn curvature(&self, wavenumber: f64) -> f64 {
        let share = match &self.patch {
            WavePatch::Resolved(_) => 1.0,
            _ => self.share(wavenumber),
        };
        self.radius * wavenumber * wavenumber * share
    }

    /// Curvature κ/Δ with Φ whatever the response has, by which the patch changes its shape.
    pub fn patch_curvature(&self, wavenumber: f64) -> f64 {
        self.radius * wavenumber * wavenumber * self.share(wavenumber)
    }

    /// F \[-\], the share of a displacement that a contact presses by and wears of; one unless it slides everywhere as a patch.
    pub fn pressed(&self, wavenumber: f64) -> f64 {
        self.filter().map_or(1.0, |filter| filter.amplitude(wavenumber, 0.0))
    }

    /// Derivatives by κ at κ = 0 of what a contact has under constant load and creepages on a wheel of the radius R/(1 + κ).
    ///
    /// Method: central difference of fourth order; a step of 10⁻³ leaves 10⁻¹¹ of a force.
    ///
    /// # Errors
    /// Errors of `of`.
    pub fn derivative<const N: usize, E>(step: f64, of: impl Fn(f64) -> Result<[f64; N], E>) -> Result<[f64; N], E> {
        let [near, far] = [1.0, 2.0].map(|steps| Ok([of(steps * step)?, of(-steps * step)?]));
        let ([up, down], [far_up, far_down]) = (near?, far?);
        Ok(std::array::from_fn(|i| (8.0 * (up[i] - down[i]) - (far_up[i] - far_down[i])) / (12.0 * step)))
    }
}
