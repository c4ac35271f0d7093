//! Rail that moves along, across and down at once, on any support.

mod remembering;
mod spatial_waves;

use std::ops::Range;

use num_complex::Complex64;

use super::coupled_floquet::CoupledFloquet;
use super::periodic::check_spacing;
use super::twisting_rail::{Foundation, TwistingRail};
use super::{Bar, Beam, FloquetWaves, Structure, Support, Twist, Waveguide};
use crate::{Direction, Error, Place, Rail};
use spatial_waves::{AxisWaves, LateralWaves};

pub use remembering::{RememberingTrack, TrackMemory};

pub(super) use spatial_waves::{Motions, SpatialWaves};

/// A rail by its motions: one that it does not have is held.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialRail {
    /// Bending downward.
    pub vertical: Beam,
    /// Bending across the track.
    pub lateral: Option<Beam>,
    /// Twist, of a rail that bends across the track.
    pub twist: Option<Twist>,
    /// Stretch.
    pub longitudinal: Option<Bar>,
}

impl From<Beam> for SpatialRail {
    /// A rail that bends downward only.
    fn from(vertical: Beam) -> Self {
        Self { vertical, lateral: None, twist: None, longitudinal: None }
    }
}

/// What carries a rail, by directions, per support or per metre; a direction without a support is free.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Supports {
    /// Downward. Its pad resists the twist too.
    pub vertical: Option<Support>,
    /// Across the track, at the foot.
    pub lateral: Option<Support>,
    /// Along the rail.
    pub longitudinal: Option<Support>,
}

/// Where a wheel touches the rail.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct ContactPoint {
    /// Height h above the shear centre \[m\].
    pub height: f64,
    /// Offset e to the right of the shear centre \[m\].
    pub lateral_offset: f64,
}

/// An infinite rail that stretches, bends both ways and twists, free, on supports spread evenly or on discrete ones;
/// receptances along all axes between any two places, counted from a support.
///
/// Bending downward (w) and stretch (u) run on their own, as on [`ContinuousTrack`](super::ContinuousTrack) and
/// [`PeriodicTrack`](super::PeriodicTrack). Bending across the track (v, of the shear centre) and twist (θ, positive: the
/// head moves to the right) are coupled by the foot, d below the shear centre, and by the mass at the centroid, c above it:
///
/// ```text
/// EI_z v'''' − ω²m (v + cθ) + K_y (v − dθ) = f_y                                          (with shear as in Beam)
/// EI_ω θ'''' − GJ θ'' − ω²(ρI_p θ + mc (v + cθ)) + K_θ θ − dK_y (v − dθ) = moment
/// ```
///
/// K_y is the lateral support, K_θ = k_p(ω)B²/12 that of a foot of the width B on its pad, k_p the vertical dynamic
/// stiffness of the pad alone: the sleeper moves across and down on its ballast, and does not turn. Without twist the foot
/// moves with the rail. A contact at the height h above the shear centre and e to the right of it moves by
///
/// ```text
/// u_x = u,   u_y = v + hθ,   u_z = w + eθ
/// H_yy = H_vv + h(H_vθ + H_θv) + h²H_θθ,   H_zz = H_ww + e²H_θθ,   H_yz = e(H_vθ + hH_θθ)
/// ```
///
/// so that a contact off the middle couples lateral and vertical forces. The two rails of a track do not feel each other,
/// and the motion of the load along the rail is left out.
///
/// Method: residues at the waves of the rail on its foundation, or Floquet waves of the free rail on discrete supports,
/// for v and θ of both together (three waves, or four with warping). No truncation. Errors: 1e-12 of the point
/// receptances from 1 Hz to 5 kHz for a rail (test `supports_to_all_digits`), 1e-11 over all kinds of track (test
/// `reciprocal_and_periodic`) and at 0.1 Hz, where the amplitudes of lateral waves on discrete supports cancel; more
/// without any loss next to a band edge or where two waves coincide. Not a number where a wave decays by e¹⁰⁰ and more
/// from one support to the next. Cost: [`receptance_matrix`](Structure::receptance_matrix) finds the waves of a frequency
/// once, in 1 µs on even supports and 3 µs on discrete ones; every other contact takes 0.2 and 0.3 µs, and every pair
/// 0.1 µs.
///
/// Source: after Kostovasilis, Thompson & Hussein (2017), *A semi-analytical beam model for the vibration of railway
/// tracks*, reduced to the motions above, for sections symmetric about their vertical axis; derived anew. Range of
/// validity: the section keeps its shape, up to some 1.3 kHz across the track, above which the web bends and the
/// receptance of the head is larger; downward and along the rail to some 3 kHz. On evenly spread supports below the
/// pinned-pinned frequencies. The motion of the load along the rail is left out.
///
/// ```
/// use riffel::receptance::*;
/// use riffel::{Direction, ElasticMaterial, Place, Rail};
///
/// # fn main() -> Result<(), riffel::Error> {
/// let steel = ElasticMaterial::new(210e9, 0.3)?;
/// let vertical = Beam::from(EulerBernoulliBeam::new(steel, 3.0383e-5, 60.21)?);
/// let rail = SpatialRail {
///     lateral: Some(EulerBernoulliBeam::new(steel, 5.123e-6, 60.21)?.into()),
///     twist: Some(Twist::new(steel, TwistSection {
///         torsion_constant: 2.21e-6,
///         polar_second_moment: 3.55e-5,
///         warping_constant: 2.16e-8,
///         centroid_height: 0.033,
///         foot_depth: 0.048,
///         foot_width: 0.15,
///         shear_modulus: steel.shear_modulus(),
///         density: 7850.0,
///     })?),
///     longitudinal: Some(Bar::new(steel, 7.67e-3, 60.21)?),
///     ..vertical.into()
/// };
/// let on_slab = |stiffness| -> Result<_, riffel::Error> {
///     Ok(Some(Support::one_layer(Layer::new(stiffness, 0.0)?.with_loss_factor(0.2)?)))
/// };
/// let supports = Supports {
///     vertical: on_slab(120e6)?,
///     lateral: on_slab(40e6)?,
///     longitudinal: on_slab(40e6)?,
/// };
/// let contact = ContactPoint { height: 0.124, lateral_offset: 0.010 };
/// let track = SpatialTrack::discrete(rail, supports, 0.6)?.with_contact(Rail::Right, contact);
///
/// let place = |direction| Place { along: 0.3, rail: Rail::Right, direction };
/// let places = Direction::ALL.map(place);
/// let mut matrix = [Default::default(); 9];
/// track.receptance_matrix(2e3, 0.0, &places, &mut matrix);
/// // A vertical force on the right of the rail moves its head to the right.
/// assert_eq!(matrix[3 + 2], matrix[6 + 1]);
/// assert!(matrix[3 + 2].norm() > 0.0);
/// # Ok(())
/// # }
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SpatialTrack {
    rail: SpatialRail,
    supports: Supports,
    /// Distance of discrete supports.
    spacing: Option<f64>,
    /// On the left rail and on the right one.
    contacts: [ContactPoint; 2],
}

/// Warping that dies away over less than this share of a bay leaves the range of numbers.
const STRONGEST_DECAY_IN_BAY: f64 = 100.0;

impl Supports {
    /// Supports per metre of rail, one every `spacing` \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the spacing is positive.
    pub fn per_metre(&self, spacing: f64) -> Result<Self, Error> {
        let spread = |support: &Option<Support>| support.map(|support| support.per_metre(spacing)).transpose();
        Ok(Self {
            vertical: spread(&self.vertical)?,
            lateral: spread(&self.lateral)?,
            longitudinal: spread(&self.longitudinal)?,
        })
    }

    /// What they take across the track and against rotation of a foot of the width given \[m\].
    pub(super) fn under_foot(&self, w: f64, foot_width: f64) -> Foundation {
        Foundation {
            lateral: self.lateral.map_or(Complex64::ZERO, |support| support.dynamic_stiffness(w)),
            roll: self.vertical.map_or(Complex64::ZERO, |support| {
                let pad = support.pad().dynamic_stiffness(Complex64::new(0.0, w));
                pad * (foot_width * foot_width / 12.0)
            }),
        }
    }
}

impl SpatialTrack {
    /// A rail without supports.
    pub fn free(rail: SpatialRail) -> Self {
        Self::continuous(rail, Supports::default())
    }

    /// A rail on supports whose values are per metre.
    pub fn continuous(rail: SpatialRail, supports: Supports) -> Self {
        Self { rail, supports, spacing: None, contacts: [ContactPoint::default(); 2] }
    }

    /// A rail on supports, values per support, every `spacing` \[m\].
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless the spacing is positive and at most 10 m, and, for a rail that twists, the supports
    /// hold it downward and across and the warping constant is zero or so large that warping is felt from one support to
    /// the next.
    pub fn discrete(rail: SpatialRail, supports: Supports, spacing: f64) -> Result<Self, Error> {
        check_spacing(spacing)?;
        if rail.lateral.is_some() && rail.twist.is_some() {
            for (quantity, support) in [
                ("vertical stiffness of the supports", supports.vertical),
                ("lateral stiffness of the supports", supports.lateral),
            ] {
                if support.is_none() {
                    return Err(Error::OutOfRange {
                        quantity,
                        value: 0.0,
                        unit: "N/m",
                        rule: "discrete supports must hold a rail that twists both downward and across",
                    });
                }
            }
        }
        if let Some(twist) = rail.twist
            && let Some(decay) = twist.warping_decay()
            && decay * spacing > STRONGEST_DECAY_IN_BAY
        {
            return Err(Error::OutOfRange {
                quantity: "warping constant",
                value: twist.section().warping_constant,
                unit: "m6",
                rule: "must be zero, or large enough for warping to reach from one support to the next: EI_w > GJ d^2/10^4",
            });
        }
        Ok(Self { spacing: Some(spacing), ..Self::continuous(rail, supports) })
    }

    /// Track with wheels touching one of the rails at the given point; by default at the height of the shear centre,
    /// in the middle.
    pub fn with_contact(mut self, rail: Rail, contact: ContactPoint) -> Self {
        self.contacts[side(rail)] = contact;
        self
    }

    /// Track with its supports spread evenly, one to a length \[m\].
    pub(super) fn spread(&self, spacing: f64) -> Result<Self, Error> {
        Ok(Self { supports: self.supports.per_metre(spacing)?, spacing: None, ..*self })
    }

    /// Distance of the supports \[m\], where they are discrete.
    pub fn support_spacing(&self) -> Option<f64> {
        self.spacing
    }

    /// The rail.
    pub fn rail(&self) -> &SpatialRail {
        &self.rail
    }

    /// The supports: per support where they are discrete, otherwise per metre.
    pub fn supports(&self) -> &Supports {
        &self.supports
    }

    pub(super) fn waves(&self, w: f64, alongs: Vec<f64>) -> SpatialWaves {
        let Supports { vertical, lateral, longitudinal } = self.supports;
        SpatialWaves {
            vertical: self.axis(w, &self.rail.vertical, vertical, &alongs),
            longitudinal: self.rail.longitudinal.map(|bar| self.axis(w, &bar, longitudinal, &alongs)),
            lateral: self.rail.lateral.map(|bending| match self.rail.twist {
                None => LateralWaves::Bending(self.axis(w, &bending, lateral, &alongs)),
                Some(twist) => self.twisting(w, &TwistingRail { bending, twist }, &alongs),
            }),
            alongs,
        }
    }

    fn axis(&self, w: f64, rail: &impl Waveguide, support: Option<Support>, alongs: &[f64]) -> AxisWaves {
        let stiffness = support.map_or(Complex64::ZERO, |support| support.dynamic_stiffness(w));
        match self.spacing.filter(|_| support.is_some()) {
            Some(spacing) => {
                let waves = FloquetWaves::new(&rail.waves(w, Complex64::ZERO), stiffness, spacing);
                let stations = alongs.iter().map(|&along| waves.station(along)).collect();
                AxisWaves::Discrete { waves, stations }
            }
            None => AxisWaves::Even { waves: rail.waves(w, stiffness), point: rail.point_receptance(w, stiffness) },
        }
    }

    fn twisting(&self, w: f64, rail: &TwistingRail, alongs: &[f64]) -> LateralWaves {
        let section = rail.twist.section();
        let foundation = self.supports.under_foot(w, section.foot_width);
        match self.spacing {
            Some(spacing) => {
                let free = rail.waves(w, &Foundation::NONE);
                let stiffness = foundation.at_shear_centre(section.foot_depth);
                let waves = Box::new(CoupledFloquet::new(free, &stiffness, spacing));
                let stations = alongs.iter().map(|&along| waves.station(along)).collect();
                LateralWaves::Discrete { waves, stations }
            }
            None => LateralWaves::Even(rail.waves(w, &foundation)),
        }
    }

    /// Fill a [`receptance_matrix`](Structure::receptance_matrix) with what the motions between distinct places along the track,
    /// asked by their numbers, make at the contacts.
    fn fill_receptances(
        &self,
        places: &[Place],
        contacts: &[ContactAxes],
        matrix: &mut [Complex64],
        motions: impl Fn(usize, usize) -> Motions,
    ) {
        let count = places.len();
        matrix.fill(Complex64::ZERO);
        // Contacts of a wheelset on both rails have the same motions.
        let mut last = None;
        for (index, (to, rows)) in contacts.iter().enumerate() {
            for (other, (from, columns)) in contacts[..=index].iter().enumerate() {
                if places[rows.start].rail != places[columns.start].rail {
                    continue;
                }
                let between = match last {
                    Some((known, between)) if known == (*from, *to) => between,
                    _ => motions(*from, *to),
                };
                last = Some(((*from, *to), between));
                for row in rows.clone() {
                    // Within a contact one half says all.
                    let columns = if other == index { columns.start..row + 1 } else { columns.clone() };
                    for column in columns {
                        let entry = self.entry(&between, places[row], places[column]);
                        matrix[row * count + column] = entry;
                        matrix[column * count + row] = entry;
                    }
                }
            }
        }
    }

    /// Fill a [`roll_matrix`](Structure::roll_matrix) with what the motions between its places make, asked by their numbers.
    fn fill_rolls(&self, places: &[(f64, Rail)], matrix: &mut [Complex64], motions: impl Fn(usize, usize) -> Motions) {
        let rows = matrix.chunks_exact_mut(4 * places.len()).enumerate();
        for ((to, row), (_, rail)) in rows.zip(places) {
            for (from, (entries, (_, other))) in row.chunks_exact_mut(4).zip(places).enumerate() {
                entries.fill(Complex64::ZERO);
                if rail == other {
                    let [_, [by_force, by_moment]] = motions(from, to).lateral;
                    let contact = self.contacts[side(*other)];
                    entries[1] = by_force + by_moment * contact.height;
                    entries[2] = by_moment * contact.lateral_offset;
                    entries[3] = by_moment;
                }
            }
        }
    }

    /// Displacement at one place per force at another, from the motions between them.
    pub(super) fn entry(&self, motions: &Motions, at: Place, from: Place) -> Complex64 {
        use Direction::{Lateral, Longitudinal, Vertical};
        if at.rail != from.rail {
            return Complex64::ZERO;
        }
        // Lever of the twist, with the lateral motion itself.
        let contact = self.contacts[side(at.rail)];
        let lever = |direction| match direction {
            Longitudinal => [0.0, 0.0],
            Lateral => [1.0, contact.height],
            Vertical => [0.0, contact.lateral_offset],
        };
        let (at_lever, from_lever) = (lever(at.direction), lever(from.direction));
        let mut sum = match (at.direction, from.direction) {
            (Longitudinal, Longitudinal) => motions.longitudinal,
            (Vertical, Vertical) => motions.vertical,
            _ => Complex64::ZERO,
        };
        for (row, at) in motions.lateral.iter().zip(at_lever) {
            for (entry, from) in row.iter().zip(from_lever) {
                sum += entry * (at * from);
            }
        }
        sum
    }
}

impl Structure for SpatialTrack {
    fn cross_receptance(&self, angular_frequency: f64, _speed: f64, at: Place, from: Place) -> Complex64 {
        let waves = self.waves(angular_frequency, vec![from.along, at.along]);
        self.entry(&waves.motions(0, 1), at, from)
    }

    fn roll_matrix(&self, angular_frequency: f64, _speed: f64, places: &[(f64, Rail)], matrix: &mut [Complex64]) {
        let alongs = places.iter().map(|(along, _)| *along).collect();
        let waves = self.waves(angular_frequency, alongs);
        self.fill_rolls(places, matrix, |from, to| waves.motions(from, to));
    }

    fn receptance_matrix(&self, angular_frequency: f64, _speed: f64, places: &[Place], matrix: &mut [Complex64]) {
        let alongs = alongs_of(places);
        let contacts = contacts_of(places, &alongs);
        let waves = self.waves(angular_frequency, alongs);
        self.fill_receptances(places, &contacts, matrix, |from, to| waves.motions(from, to));
    }
}

/// Distinct places along the track, in their order.
fn alongs_of(places: &[Place]) -> Vec<f64> {
    let mut alongs = Vec::with_capacity(places.len());
    for place in places {
        if !alongs.contains(&place.along) {
            alongs.push(place.along);
        }
    }
    alongs
}

/// One contact: the number of its place among the distinct ones along the track, and which places are its axes.
type ContactAxes = (usize, Range<usize>);

/// Contacts of places, of which the axes of one stand beside each other.
fn contacts_of(places: &[Place], alongs: &[f64]) -> Vec<ContactAxes> {
    let mut contacts: Vec<ContactAxes> = Vec::with_capacity(places.len());
    for places in places.chunk_by(is_beside) {
        let along = alongs.iter().position(|&along| along == places[0].along);
        let first = contacts.last().map_or(0, |contact| contact.1.end);
        contacts.push((along.unwrap_or_default(), first..first + places.len()));
    }
    contacts
}

fn is_beside(one: &Place, other: &Place) -> bool {
    one.along == other.along && one.rail == other.rail
}

fn side(rail: Rail) -> usize {
    match rail {
        Rail::Left => 0,
        Rail::Right => 1,
    }
}
