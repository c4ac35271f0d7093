//! The loop on all axes and its structures against what can be written down by hand.

use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use approx::assert_relative_eq;
use proptest::prelude::*;
use riffel::feedback::{Comb, Contact, Loop, LoopState};
use riffel::receptance::{
    Beam, ContinuousTrack, EulerBernoulliBeam, Layer, MassOnRail, Resonance, SpatialTrack, Structure, Support,
};
use riffel::wheelset::{Motion, RigidMass};
use riffel::{Complex64, Direction, ElasticMaterial, Place, Rail, Receptance};

use crate::fixtures;
use crate::general_loop::{AMPLITUDE, close, contact, hertz, rolling, wheel};

const COMPLIANT: [Motion<()>; 2] = [Motion::Compliant(()), Motion::Compliant(())];
/// Contacts that creep along the rail only.
const ALONG: [Motion<()>; 2] = [Motion::Compliant(()), Motion::Held];

fn axis(direction: Direction) -> usize {
    match direction {
        Direction::Longitudinal => 0,
        Direction::Lateral => 1,
        Direction::Vertical => 2,
    }
}

/// Wavenumber √ω (m/EI)^{1/4} of that rail \[1/m\].
fn bending_wavenumber(w: f64) -> f64 {
    (56.0 * w * w / (207e9 * 2.35e-5)).powf(0.25)
}

/// H(l) = −(i e^{−ikl} + e^{−kl})/4EIk³ of a free beam without loss.
fn free_rail(w: f64, distance: f64) -> Complex64 {
    let k = bending_wavenumber(w);
    let wave = Complex64::I * Complex64::cis(-k * distance) + (-k * distance).exp();
    -wave / (4.0 * 207e9 * 2.35e-5 * k.powi(3))
}

/// The rail as it is computed.
fn rail() -> SpatialTrack {
    SpatialTrack::free(Beam::from(fixtures::rail()).into())
}

fn down(along: f64) -> Place {
    Place { along, rail: Rail::Right, direction: Direction::Vertical }
}

/// Receptances between three contacts, of any symmetric matrix.
struct Anything([[Complex64; 9]; 9]);

impl Structure for Anything {
    fn cross_receptance(&self, _: f64, _: f64, at: Place, from: Place) -> Complex64 {
        let index = |place: Place| {
            let contact = match (place.rail, place.along == 0.0) {
                (Rail::Right, true) => 0,
                (Rail::Right, false) => 1,
                (Rail::Left, _) => 2,
            };
            3 * contact + axis(place.direction)
        };
        self.0[index(at)][index(from)]
    }
}

/// A symmetric matrix of some nm/N.
fn anything(numbers: &[f64]) -> Anything {
    let entry = |row: usize, column: usize| {
        let (most, least) = (row.max(column), row.min(column));
        let pair = 2 * (most * (most + 1) / 2 + least);
        1e-9 * Complex64::new(numbers[pair], numbers[pair + 1])
    };
    Anything(std::array::from_fn(|row| std::array::from_fn(|column| entry(row, column))))
}

/// Numbers of a symmetric matrix of nine rows.
const NUMBERS: usize = 2 * 45;

proptest! {
    /// The power that the profile puts in is what goes into rail and wheels and what the oscillations of creep forces
    /// dissipate: ½Re Σ P* iωr = ½ω fᴴ(−Im H)f + ½V Re Σ Qᴴ ξ. It holds for any symmetric receptances, passive or not, any contact
    /// law, of complex slopes too, any contact angle, and any number of contacts; with forces turned into the axes
    /// of the track by hand. The tolerance is the residual of the equations, which are ill-conditioned for some of them.
    #[test]
    fn power_of_the_profile_goes_somewhere(
        track in prop::collection::vec(-1.0..1.0f64, NUMBERS), wheels in prop::collection::vec(-1.0..1.0f64, NUMBERS),
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, angles in prop::array::uniform3(0.0..0.6f64),
        creepages in prop::array::uniform6(-2e-3..2e-3f64), free in any::<bool>(), opposite in -1.0..1.0f64,
    ) {
        let (track, wheels) = (anything(&track), anything(&wheels));
        let at = |index: usize, along: f64, rail: Rail, profile: f64| Contact {
            rail,
            angle: angles[index],
            profile,
            ..contact(along, rolling(creepages[2 * index], creepages[2 * index + 1] + 1e-4), COMPLIANT)
        };
        let mut contacts = vec![
            at(0, 0.0, Rail::Right, 1.0), at(1, -2.5, Rail::Right, 1.0), at(2, 0.0, Rail::Left, opposite),
        ];
        if free {
            contacts[1].motion[0] = Motion::Free;
        }
        let both: [[Complex64; 9]; 9] = std::array::from_fn(|row| {
            std::array::from_fn(|column| track.0[row][column] + wheels.0[row][column])
        });
        let general =
            Loop::new(Arc::new(track), Arc::new(wheels), contacts.clone(), AMPLITUDE).unwrap();
        let state = general.at(wavelength, speed);
        let w = state.angular_frequency;

        let mut forces = Vec::new();
        let mut terms = Vec::new();
        for (contact, state) in contacts.iter().zip(&state.contacts) {
            let profile = AMPLITUDE * contact.profile * Complex64::cis(TAU / wavelength * contact.along);
            terms.push(0.5 * (state.force[2].conj() * Complex64::I * w * profile).re);
            for (force, creepage) in state.force.iter().zip(state.creepage) {
                terms.push(-0.5 * speed * (force.conj() * creepage).re);
            }
            let outward = match contact.rail {
                Rail::Right => contact.angle.sin(),
                Rail::Left => -contact.angle.sin(),
            };
            let [along, across, normal] = state.force;
            forces.push(along);
            forces.push(across * contact.angle.cos() + normal * outward);
            forces.push(normal * contact.angle.cos() - across * outward);
        }
        for row in 0..9 {
            for column in 0..9 {
                let share = forces[row].conj() * -both[row][column].im * forces[column];
                terms.push(-0.5 * w * share.re);
            }
        }
        let size: f64 = terms.iter().map(|term| term.abs()).sum();
        let rest: f64 = terms.iter().sum();
        prop_assert!(rest.abs() <= 1e-9 * size, "{rest} {size}");
    }

    /// Two wheels of one rigid body split into one that the body follows up and down and one that it follows in pitch:
    /// P± = r±/(H(0) ± H(l) + H_w± + 1/k_H), r± = Δ(1 ± e^{−ikl})/2.
    #[test]
    fn wheels_of_one_body_split_into_two(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, distance in 1.5..3.0f64,
    ) {
        let body = Body { mass: 1200.0, inertia: 900.0, distance };
        let contacts = vec![
            contact(0.0, rolling(1e-3, 0.0), ALONG), contact(-distance, rolling(1e-3, 0.0), ALONG),
        ];
        let general = Loop::new(Arc::new(rail()), Arc::new(body), contacts, AMPLITUDE).unwrap();
        let state = general.at(wavelength, speed);
        let w = state.angular_frequency;
        let phase = Complex64::cis(-TAU / wavelength * distance);
        let split = |sign: f64, inertance: f64| {
            let sum = free_rail(w, 0.0) + sign * free_rail(w, distance) - inertance / (w * w)
                + hertz().stiffness().recip();
            0.5 * AMPLITUDE * (1.0 + sign * phase) / sum
        };
        let up = split(1.0, 2.0 / 1200.0);
        let pitch = split(-1.0, 2.0 * (0.5 * distance).powi(2) / 900.0);
        near(state.contacts[0].force[2], up + pitch, up.norm() + pitch.norm());
        near(state.contacts[1].force[2], up - pitch, up.norm() + pitch.norm());
    }

    /// The mean over the comb is what the phases of the profile under the second wheel leave in the mean, with the rail
    /// between the wheels as it is: the harmonics e^{±ikl} of the energy vanish over 24 of them.
    #[test]
    fn the_mean_over_the_comb_is_that_over_its_phases(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, across in 0.2..3.0f64,
    ) {
        let loop_at = |distance: f64, comb: Comb| -> LoopState {
            let contacts = vec![
                contact(0.0, rolling(1e-3, 0.0), ALONG), contact(-distance, rolling(1e-3, 0.0), ALONG),
            ];
            let frozen = FrozenRail { across };
            let general = Loop::new(Arc::new(frozen), Arc::new(wheel(400.0, 40.0)), contacts, AMPLITUDE);
            general.unwrap().with_comb(comb).at(wavelength, speed)
        };
        let mean = loop_at(2.5, Comb::Mean);
        let phases: Vec<LoopState> = (0..24)
            .map(|step| loop_at(2.5 + wavelength * f64::from(step) / 24.0, Comb::Resolved))
            .collect();
        for wheel in 0..2 {
            let energies = phases.iter().map(|state| state.contacts[wheel].energy_at_rail);
            let average = energies.clone().sum::<Complex64>() / 24.0;
            let largest = energies.map(Complex64::norm).fold(0.0, f64::max);
            near(mean.contacts[wheel].energy_at_rail, average, largest);
        }
    }

    /// Turned about, braking is traction where the receptance between rolling and lifting changes its sign with it; where
    /// there is none, braking and traction grow alike. In closed form, with D = 1 + ikC H_xx:
    /// Q₁/P₁ = (F_P − ikC H_xz)/D and P₁ = Δ/(1/k_H + H_zz + H_zx Q₁/P₁).
    #[test]
    fn braking_is_traction_turned_about(
        wavelength in 0.02..0.3f64, speed in 5.0..60.0f64, creepage in 1e-4..3e-3f64, pitch in -1.0..1.0f64,
    ) {
        let growth = |creepage: f64, pitch: f64| {
            let structure = Pitching { pitch };
            let contact = contact(0.0, rolling(creepage, 0.0), ALONG);
            let general = Loop::new(Arc::new(rail()), Arc::new(structure), vec![contact], AMPLITUDE);
            let state = general.unwrap().at(wavelength, speed);
            (state.contacts[0], state.angular_frequency)
        };
        let (braking, w) = growth(creepage, pitch);
        let (traction, _) = growth(-creepage, -pitch);
        near(traction.energy_at_rail, braking.energy_at_rail, braking.energy_at_rail.norm());
        let (straight, back) = (growth(creepage, 0.0).0, growth(-creepage, 0.0).0);
        near(back.energy_at_rail, straight.energy_at_rail, straight.energy_at_rail.norm());

        let response = rolling(creepage, 0.0).response(wavelength);
        let (by_load, slope) = (response.by_load.force[0], response.by_longitudinal.force[0]);
        let [xx, xz, zz] = Pitching { pitch }.receptances(w);
        let ik = Complex64::I * TAU / wavelength;
        let ratio = (by_load - ik * slope * xz) / (1.0 + ik * slope * xx);
        let normal = AMPLITUDE
            / (hertz().stiffness().recip() + free_rail(w, 0.0) + zz + xz * ratio);
        near(braking.force[2], normal, normal.norm());
        near(braking.force[0], ratio * normal, ratio.norm() * normal.norm() + by_load.norm() * normal.norm());
    }
}

/// Equal to 1e-9 of a size: rounding of a dozen equations, of a rail by its waves and of phases of some hundred turns.
fn near(got: Complex64, expected: Complex64, size: f64) {
    assert!((got - expected).norm() <= 1e-9 * size, "{got} {expected}");
}

/// Two wheels on one rigid body, as far apart as they are before and behind its centre.
struct Body {
    mass: f64,
    inertia: f64,
    distance: f64,
}

impl Structure for Body {
    fn cross_receptance(&self, w: f64, _: f64, at: Place, from: Place) -> Complex64 {
        if axis(at.direction) != 2 || axis(from.direction) != 2 {
            return Complex64::ZERO;
        }
        let lever = |place: Place| place.along + 0.5 * self.distance;
        let inertance = 1.0 / self.mass + lever(at) * lever(from) / self.inertia;
        (-inertance / (w * w)).into()
    }
}

/// A rail whose receptance between two wheels does not change with their distance, nm/N.
struct FrozenRail {
    across: f64,
}

impl Structure for FrozenRail {
    fn cross_receptance(&self, _: f64, _: f64, at: Place, from: Place) -> Complex64 {
        match (axis(at.direction), axis(from.direction)) {
            (2, 2) if at == from => Complex64::new(1e-9, -2e-9),
            (2, 2) => 1e-9 * Complex64::new(0.3, -self.across),
            _ => Complex64::ZERO,
        }
    }
}

/// A wheel that lifts as it rolls, by a mode of 80 Hz that both share.
struct Pitching {
    pitch: f64,
}

impl Pitching {
    /// H_xx, H_xz and H_zz.
    fn receptances(&self, w: f64) -> [Complex64; 3] {
        let of = TAU * 80.0;
        let mode = (200.0 * (of * of * Complex64::new(1.0, 0.02) - w * w)).inv();
        let free = -1.0 / (400.0 * w * w);
        [mode + 2.0 * free, self.pitch * mode, self.pitch * self.pitch * mode + free]
    }
}

impl Structure for Pitching {
    fn cross_receptance(&self, w: f64, _: f64, at: Place, from: Place) -> Complex64 {
        let [xx, xz, zz] = self.receptances(w);
        match (axis(at.direction), axis(from.direction)) {
            (0, 0) => xx,
            (2, 2) => zz,
            (0, 2) | (2, 0) => xz,
            _ => Complex64::ZERO,
        }
    }
}

/// How much the direction matters where rolling lifts the wheel, by a mode of 80 Hz with as much of the one as of the other,
/// at 50 mm and 10 m/s: braking wears the profile off by 1.1e-7 a passage and traction grows it by 1.5e-7, where without it
/// both would grow it by 0.3e-7.
#[test]
fn where_rolling_lifts_the_wheel_the_direction_matters() {
    let growth = |creepage: f64, pitch: f64| {
        let contact = contact(0.0, rolling(creepage, 0.0), ALONG);
        let wheels = Arc::new(Pitching { pitch });
        let general = Loop::new(Arc::new(rail()), wheels, vec![contact], AMPLITUDE).unwrap();
        general.at(0.05, 10.0).contacts[0].growth_rate.unwrap()
    };
    let (braking, traction) = (growth(1e-3, 1.0), growth(-1e-3, 1.0));
    let alike = growth(1e-3, 0.0);
    for (got, expected) in [(braking, -1.05e-7), (traction, 1.54e-7), (alike, 2.9e-8)] {
        // The digits that are written.
        assert_relative_eq!(got, expected, max_relative = 0.01);
    }
}

/// Wheels at one place are one: P = Δ/(nH + H_w + 1/k_H) each, to the 4 nm that they are apart.
#[test]
fn wheels_at_one_place_share_the_rail() {
    for count in 1..=5_i32 {
        let contacts = (0..count).map(|index| contact(-1e-9 * f64::from(index), rolling(1e-3, 0.0), ALONG)).collect();
        let general = Loop::new(Arc::new(rail()), Arc::new(wheel(400.0, 40.0)), contacts, AMPLITUDE);
        let state = general.unwrap().at(0.05, 30.0);
        let w = state.angular_frequency;
        let sum = f64::from(count) * free_rail(w, 0.0) - 1.0 / (400.0 * w * w) + hertz().stiffness().recip();
        for contact in state.contacts {
            let expected = AMPLITUDE / sum;
            assert!((contact.force[2] - expected).norm() < 1e-5 * expected.norm());
        }
    }
}

/// Between two wheels on a free rail without loss a wave stands where their forces radiate nothing: H(0) − H(l) is real at
/// k l = 2πn, H(0) + H(l) at (2n + 1)π. The rail as it is computed is the closed form at every distance.
#[test]
fn standing_waves_between_two_wheels_radiate_nothing() {
    let rail = rail();
    let w = TAU * 700.0;
    let wavenumber = bending_wavenumber(w);
    let receptance = |distance: f64| rail.cross_receptance(w, 0.0, down(0.0), down(-distance));
    for step in 0..40 {
        let distance = 0.1 * f64::from(step);
        close(receptance(distance), free_rail(w, distance));
    }
    let point = receptance(0.0);
    for half_waves in 1..12 {
        let distance = PI * f64::from(half_waves) / wavenumber;
        let sign = if half_waves % 2 == 0 { -1.0 } else { 1.0 };
        let pattern = point + sign * receptance(distance);
        assert!(pattern.im.abs() < 1e-12 * point.norm(), "{half_waves} {pattern}");
        let other = point - sign * receptance(distance);
        assert!((other.im / point.im - 2.0).abs() < 1e-12, "{half_waves} {other}");
    }
}

/// P2 of a mass on a beam on an elastic foundation: f = √(k_t/(m_u + m_t))/2π with k_t = 2√2 (EI)^{1/4} k^{3/4} and
/// m_t = 3m/2β, β = (k/4EI)^{1/4}, takes the beam's static shape and is at most 0.4 % above the least |H_rail + H_wheel|.
/// The contact spring lowers that by 1 to 3 %.
#[test]
fn p2_is_the_mass_on_the_static_shape() {
    let steel = ElasticMaterial::new(210e9, 0.3).unwrap();
    let stiffness = 210e9 * 2.35e-5;
    for (mass, foundation, closed, least, with_contact) in
        [(350.0, 20e6, 48.25, 48.09, 47.53), (600.0, 40e6, 50.33, 50.28, 49.08), (350.0, 60e6, 74.60, 74.44, 72.30)]
    {
        let support = Support::one_layer(Layer::new(foundation, 0.0).unwrap());
        let of_mass = MassOnRail::new(mass, stiffness, 56.0, support, 1e20).unwrap();
        let frequency = of_mass.angular_frequency() / TAU;
        assert!((frequency - closed).abs() < 0.005, "{frequency}");

        let beam = EulerBernoulliBeam::new(steel, 2.35e-5, 56.0).unwrap();
        let pad = Layer::new(foundation, 0.0).unwrap();
        let track = ContinuousTrack::new(Beam::from(beam), Support::one_layer(pad));
        let wheel = RigidMass::new(mass).unwrap();
        let p2 = |contact: f64| {
            let total = |w: f64| track.receptance(w, 0.0) + wheel.receptance(w, 0.0) + contact;
            let cut_on = f64::sqrt(foundation / 56.0);
            let found = Resonance::p2(total, |_| 1.0, [TAU * 10.0, 0.99 * cut_on]).unwrap();
            found.angular_frequency / TAU
        };
        assert!((p2(0.0) - least).abs() < 0.006, "{}", p2(0.0));
        assert!((p2(1.0 / 1.08e9) - with_contact).abs() < 0.006);
        assert_relative_eq!(p2(0.0), frequency, max_relative = 4e-3);
    }
}
