//! Waves under the contact: pressure, contact filter and finite amplitude.

use std::f64::consts::PI;

use approx::assert_relative_eq;

use super::{grid_over, hertz, quadratic, steel};
use crate::contact::{ContactFilter, ContactGrid, NormalContact};

/// Full contact with a small wave: Δ cos kx takes the pressure πE\*Δ/λ cos kx (Johnson 1985, section
/// 13.2), in the middle of a patch that is eight wavelengths long. Half the difference of two waves of
/// opposite sign frees it from the pressure below. Sampled with m elements to a wavelength it is
/// 1 + 1.3/m²: 1.3 % here.
#[test]
fn wave_in_full_contact() {
    let radii = (0.3, 0.3);
    let exact = hertz(radii, [steel(); 2], 50e3);
    let a = exact.semi_axis_longitudinal();
    let wavelength = 0.25 * a;
    let wavenumber = 2.0 * PI / wavelength;
    let amplitude = 1e-7;
    let grid = grid_over(&exact, 96);
    let [crest, trough] = [1.0, -1.0].map(|sign| {
        let gap = |x: f64, y: f64| quadratic(radii)(x, y) - sign * amplitude * (wavenumber * x).cos();
        let contact = NormalContact::new([steel(); 2], grid, gap).unwrap();
        contact.under_load(50e3).unwrap()
    });
    let (mut sum, mut square) = (0.0, 0.0);
    let pressures = crest.pressures().iter().zip(trough.pressures());
    for ((x, y), (crest, trough)) in grid.centres().zip(pressures) {
        if x.abs() < wavelength && y.abs() < 0.5 * a {
            let wave = (wavenumber * x).cos();
            sum += 0.5 * (crest - trough) * wave;
            square += wave * wave;
        }
    }
    let johnson = PI * exact.contact_modulus() * amplitude / wavelength;
    assert_relative_eq!(sum / square, johnson, max_relative = 0.02);
}

/// The first and second harmonic of the wheel's lift at constant load, over the amplitude, as a wave passes
/// under it; and the mean lift. All are even in the phase, so that half a period will do.
fn harmonics(contact: &mut NormalContact, amplitude: f64, [along, across]: [f64; 2]) -> [f64; 3] {
    const INTERVALS: usize = 8;
    let radii = (0.46, 0.3);
    contact.set_gap(quadratic(radii)).unwrap();
    let smooth = contact.under_load(50e3).unwrap().approach();
    let mut harmonics = [0.0; 3];
    for interval in 0..=INTERVALS {
        let phase = PI * interval as f64 / INTERVALS as f64;
        let wave = |x: f64, y: f64| amplitude * (along * x + across * y + phase).cos();
        contact.set_gap(|x, y| quadratic(radii)(x, y) - wave(x, y)).unwrap();
        let lift = (smooth - contact.under_load(50e3).unwrap().approach()) / amplitude;
        let ends = interval == 0 || interval == INTERVALS;
        let weight = if ends { 0.5 } else { 1.0 } / INTERVALS as f64;
        harmonics[0] += weight * lift;
        harmonics[1] += 2.0 * weight * lift * phase.cos();
        harmonics[2] += 2.0 * weight * lift * (2.0 * phase).cos();
    }
    harmonics
}

fn wheel_on_wave() -> (NormalContact, ContactFilter) {
    let radii = (0.46, 0.3);
    let exact = hertz(radii, [steel(); 2], 50e3);
    let (a, b) = (exact.semi_axis_longitudinal(), exact.semi_axis_lateral());
    let grid = ContactGrid::over(48, 48, 1.5 * a, 1.5 * b).unwrap();
    let contact = NormalContact::new([steel(); 2], grid, quadratic(radii)).unwrap();
    (contact, ContactFilter::new(a, b).unwrap())
}

/// A wave of 1 µm passing under a wheel at constant load lifts it by sin κ/κ of its amplitude, along the rail
/// and askew. Tolerance 0.004 of the amplitude: 48 elements, whose patch grows by whole ones.
#[test]
fn passing_wave_is_filtered_like_a_flat_punch() {
    let (mut contact, filter) = wheel_on_wave();
    let a = 5.712e-3;
    for (ratio, askew) in [(1.4, 0.0), (2.0, 0.0), (4.0, 0.0), (8.0, 0.0), (4.0, 1.0), (6.0, 2.0)] {
        let along = 2.0 * PI / (ratio * a);
        let across = askew * along;
        let [mean, first, _] = harmonics(&mut contact, 1e-6, [along, across]);
        let linear = filter.amplitude(along, across);
        assert!((first - linear).abs() < 0.004, "{ratio} {askew}: {first} {linear}");
        // Second order in the amplitude: the wheel rides on the crests.
        assert!((0.0..0.03).contains(&mean), "{mean}");
    }
}

/// Finite amplitude at λ = 4a, 10 and 30 µm, as 128 × 128 elements have it: mean lift, fundamental and second
/// harmonic over the amplitude. Tolerance 0.001: 48 × 48.
#[test]
fn finite_amplitude_lifts_the_wheel() {
    let (mut contact, _) = wheel_on_wave();
    let along = 2.0 * PI / (4.0 * 5.712e-3);
    for (amplitude, converged) in [(10e-6, [0.0576, 0.6333, -0.0159]), (30e-6, [0.1701, 0.6075, -0.0484])] {
        let got = harmonics(&mut contact, amplitude, [along, 0.0]);
        for (got, converged) in got.into_iter().zip(converged) {
            assert!((got - converged).abs() < 0.001, "{got} {converged}");
        }
    }
}

/// On a long wave the wheel is a rigid circle that rolls on it. Its centre is max(Δ cos kx − (x − X)²/2R) above
/// its mean, to second order Δ cos kX + ½RΔ²k² sin² kX: higher by RΔk²/4 of the amplitude in the mean, and
/// −RΔk²/4 of second harmonic. 10 %: the filter of the patch at λ = 16a.
#[test]
fn long_wave_lifts_the_wheel_as_if_rigid() {
    let (mut contact, _) = wheel_on_wave();
    let (amplitude, along) = (30e-6, 2.0 * PI / (16.0 * 5.712e-3));
    let [mean, _, second] = harmonics(&mut contact, amplitude, [along, 0.0]);
    let rigid = 0.46 * amplitude * along * along / 4.0;
    assert_relative_eq!(mean, rigid, max_relative = 0.1);
    assert_relative_eq!(second, -rigid, max_relative = 0.1);
}
