//! A contact that moves across the profiles, and all that goes with its place.

use super::Conformity;

/// Two profiles whose contact moves as wheel and rail shift and roll against one another, and what that does in a loop.
///
/// On the rail the contact moves to the right by y_r, on the wheel by y_w; s is the lateral displacement of the wheel against the
/// rail along the plane of contact, to the right, θ the roll of the rail and ψ_p that by the cross slope of the ripple, both with
/// the right side down, and R_c and R_t the radii of [`Conformity`]. The wheel is taken not to roll. To first order:
///
/// ```text
/// y_r/R_r = ψ_p − θ − s/R_t     y_w = y_r − s
/// β = θ − ψ_p + y_r/R_c = y_w/R_t            turn of the plane of contact about x, its right side down
/// Δγ = ∓β                                    contact angle, upper sign on the right rail
/// ξ_x = ± (sin γ/R) y_w                      by the rolling radius
/// φ₁ = cos γ β/R                             spin, −Δ(sin γ)/R of the right wheel, which does not roll
/// f_t = Q_t − P₀β,   f_n = P + Q_t0 β        forces on the rail in the axes of the mean state: the plane takes its forces along
/// M = P₀ y_r                                 moment on the rail about where it was touched before
/// ```
///
/// The plane turns as the wheel is curved where it is touched: under a cone it stays. M acts against θ through y_r, as a roll
/// stiffness P₀R_r of the contact. Source: geometry after A. Bhaskar, K. L. Johnson, G. D. Wood, J. Woodhouse, *Proc. IMechE F* 211 (1997);
/// derived here, and held against finite differences of two circles that roll and shift (test `two_circles`). Range of validity:
/// shifts far below the semi-axis b, circles over the width of the patch. Left out: the roll of the wheel, the change of the lateral
/// creepage of a yawed wheel with the angle, ξ_t0 tan γ Δγ, and the way that the contact runs ahead of a yawed wheel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MovingContact {
    /// The profiles.
    pub profiles: Conformity,
    /// R \[m\].
    pub rolling_radius: f64,
    /// Cross slope κ of the ripple \[1/m\]: the share of itself by which its height grows for a metre outward.
    pub cross_slope: f64,
    /// What of it enters the loop.
    pub effects: ShiftEffects,
}

/// What the shift of a contact does in a loop.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ShiftEffects {
    /// Longitudinal creepage by the rolling radius.
    pub rolling_radius: bool,
    /// The forces that turn with the plane of contact.
    pub contact_angle: bool,
    /// Spin by the turn of that plane.
    pub spin: bool,
    /// The roll of the rail that moves the contact, and the moment of the shifted load on the rail: both or none, or energy would
    /// come from nowhere.
    pub rail_roll: bool,
}

impl ShiftEffects {
    /// All of them.
    pub const ALL: Self = Self { rolling_radius: true, contact_angle: true, spin: true, rail_roll: true };
    /// Creepage by the rolling radius alone.
    pub const ROLLING_RADIUS: Self = Self { rolling_radius: true, contact_angle: false, spin: false, rail_roll: false };
}
