//! A wheel that passes discrete supports: growth with neighbours, and the same in time.

use std::f64::consts::TAU;
use std::sync::{Arc, OnceLock};

use riffel::contact::{MeanState, QuasiStatic};
use riffel::feedback::OneWheel;
use riffel::growth::{Bay, GrowthWithNeighbours};
use riffel::passage::{
    ContactInTime, Evolution, EvolutionStep, ImpulseResponse, PassageModel, PassingWheel, Sinusoid, StructuresInTime,
    WearOfPassages,
};
use riffel::receptance::{Beam, MovingLoadOnSupports, PeriodicTrack};
use riffel::roughness::Profile;
use riffel::wheelset::{RigidInertia, RigidMass};
use riffel::{Carter3d, Complex64, DissipationPhase, HertzContact, Loop, PlaceOfWear, Receptance, RollingContact};

use crate::fixtures::{on_sleepers, one_wheel, steel};

const SPACING: f64 = 0.6;
const SPEED: f64 = 30.0;

fn track() -> PeriodicTrack<Beam> {
    on_sleepers(1e4)
}

fn feedback(amplitude: f64) -> Loop {
    let hertz = HertzContact::new(steel(), 0.46, 0.3, 50e3).unwrap();
    let place_of_wear = PlaceOfWear::new(DissipationPhase::None, 0.0, 0.3);
    OneWheel { place_of_wear, amplitude, ..one_wheel(Arc::new(track()), hertz, 0.35, 0.3) }.close().unwrap()
}

fn moving(speed: f64) -> MovingLoadOnSupports {
    MovingLoadOnSupports::new(&track(), speed).unwrap()
}

/// At 2 m/s over 4 mm everything is quasi-static in position: the wave alone grows like the mean over the bay, and the
/// leading pattern faster, towards the fastest place.
#[test]
fn growth_with_neighbours_of_a_slow_wheel_is_local() {
    let feedback = feedback(1e-6);
    let (speed, wavelength) = (2.0, 0.004);
    let bay = Bay::new(feedback.clone(), Arc::new(track())).unwrap();
    let states = bay.states(wavelength, speed, 61);
    let rates: Vec<f64> = states.iter().map(|(_, state)| state.growth_rate).collect();
    let mean = feedback.growth_rate_per_dissipation() * bay.mean_normalized_dissipation(wavelength, speed).re;
    let highest = rates.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let lowest = rates.iter().copied().fold(f64::INFINITY, f64::min);
    let range = highest - lowest;
    let of = |neighbours| GrowthWithNeighbours::at(&feedback, &moving(speed), wavelength, neighbours).unwrap();
    let [few, many] = [of(2), of(6)];
    assert!((many.alone().re - mean).abs() < 2e-3 * range);
    // e_n changes by 4 % over the neighbours, and with it what leads.
    assert!(few.leading.re > mean + 0.5 * (highest - mean) && few.leading.re < highest + 0.02 * range);
    assert!(many.leading.re < highest + 0.02 * range);
    assert!(many.leading.re > mean + 0.4 * (highest - mean));
}

/// Neighbours need wavelengths.
#[test]
fn too_many_neighbours_are_refused() {
    let refused = GrowthWithNeighbours::at(&feedback(1e-6), &moving(SPEED), 0.1, 6).unwrap_err();
    assert!(refused.to_string().contains("neighbours"), "{refused}");
}

/// Made once: it takes a second.
fn response() -> &'static ImpulseResponse {
    static RESPONSE: OnceLock<ImpulseResponse> = OnceLock::new();
    RESPONSE.get_or_init(|| ImpulseResponse::over_supports(&moving(SPEED)).unwrap())
}

fn model() -> PassageModel {
    let hertz = HertzContact::new(steel(), 0.46, 0.3, 50e3).unwrap();
    let law = Carter3d::new(hertz, 0.35).unwrap();
    let contact = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.3)).unwrap();
    let rotation = RigidInertia::new(RigidInertia::reduced_inertia(350.0, 0.46), 0.46).unwrap();
    let wheel = RigidMass::new(350.0).unwrap();
    let in_time = ContactInTime::of_one_wheel(contact.steady(), hertz.stiffness(), Arc::new(law)).unwrap();
    PassageModel {
        structures: StructuresInTime::of_one_wheel(response().clone(), &wheel, Some(&rotation)),
        contacts: vec![in_time],
        contact_filter: None,
        speed: SPEED,
    }
}

/// Poles leave 5·10⁻⁴ rms of all harmonics together, as asked for, no more of the mean over the bay, and 2·10⁻³ at the worst
/// frequency.
#[test]
fn response_comes_back() {
    let response = response();
    assert!(response.share_cut().sqrt() < 5e-4, "{:e}", response.share_cut());
    assert!(response.largest_error() < 2e-3, "{:e}", response.largest_error());
    for hertz in [20.0, 300.0, 1060.0, 2000.0] {
        let exact = moving(SPEED).harmonics(TAU * hertz, 1).unwrap().at(0);
        let error = (response.receptance(TAU * hertz) - exact).norm() / exact.norm();
        assert!(error < 5e-4, "{hertz} Hz: {error:e}");
    }
}

/// What a profile adds to the normal force on a smooth rail has lines at ω + nΩ, and they are those of the harmonic
/// balance, N = A⁻¹r: to 3·10⁻³ of the strongest. The load on the smooth rail varies by 2.6 %, and Hertz's stiffness by a third
/// of that, which the balance leaves out; the fit and the steps take 5·10⁻⁴.
#[test]
fn small_waves_are_the_harmonic_balance() {
    let model = model();
    let memory = model.memory().unwrap();
    let amplitude = 1e-8;
    let steps_to_bay = 1600;
    let step = SPACING / f64::from(steps_to_bay);
    let run_in = ((memory / SPACING).ceil() as usize + 6) * steps_to_bay as usize;
    let counted = 16 * steps_to_bay as usize;
    let mut without = model.march(step).unwrap();
    let start = without.clone();
    let smooth: Vec<f64> = (0..run_in + counted).map(|_| without.advance(&[0.0])[0].normal_force).collect();
    for wavelength in [0.047, 0.0293] {
        let feedback = feedback(amplitude);
        let growth = GrowthWithNeighbours::at(&feedback, &moving(SPEED), wavelength, 6).unwrap();
        let mut with = start.clone();
        let mut lines = [Complex64::ZERO; 5];
        for (index, smooth) in (1..).zip(&smooth) {
            let x = index as f64 * step;
            let height = amplitude * (TAU * x / wavelength).cos();
            let force = with.advance(&[height])[0].normal_force - smooth;
            if index > run_in {
                // A window of Blackman and Harris over 16 bays parts lines that are one per bay apart.
                let share = TAU * (index - run_in) as f64 / counted as f64;
                let window =
                    0.35875 - 0.48829 * share.cos() + 0.14128 * (2.0 * share).cos() - 0.01168 * (3.0 * share).cos();
                for (line, k) in lines.iter_mut().zip(&growth.wavenumbers[4..]) {
                    let scale = 2.0 * window / (0.35875 * counted as f64);
                    *line += force * Complex64::from_polar(scale, -k * x);
                }
            }
        }
        let expected = |n: usize| {
            let wave = feedback.at(TAU / growth.wavenumbers[n], SPEED);
            let energy = wave.dissipation_at_rail / (wave.normal_force() * SPEED);
            -growth.operator[n][6] * amplitude / (feedback.contacts()[0].wear.depth_per_energy() * energy)
        };
        for (n, line) in (4..).zip(lines) {
            let error = (line - expected(n)).norm() / expected(6).norm();
            assert!(error < 3e-3, "{wavelength} m, line {n}: {error:e}");
        }
    }
}

/// A settled sinusoid of 0.5 µm has the normal force and the dissipation of the wave alone in the operator.
#[test]
fn a_settled_wave_is_the_mean_over_the_bay() {
    let (model, amplitude, wavelength) = (model(), 0.5e-6, 0.047);
    let feedback = feedback(amplitude);
    let growth = GrowthWithNeighbours::at(&feedback, &moving(SPEED), wavelength, 6).unwrap();
    let profile = Sinusoid { amplitude, wavelength };
    let settled = model.settle(profile, 200).unwrap().swap_remove(0);
    let dissipation = -growth.alone() * amplitude / feedback.contacts()[0].wear.depth_per_energy();
    let error = (settled.harmonics[1].dissipation - dissipation).norm() / dissipation.norm();
    // As above, and the load that varies by 2.6 % makes the creep force answer by as much more and less, in the mean its square.
    assert!(error < 5e-3, "{error:e}");
    assert!((settled.harmonics[0].normal_force.re / 50e3 - 1.0).abs() < 1e-4);
}

/// On a smooth rail the force has the period of the supports, and is the harmonic balance of the sag: to the softening
/// of Hertz.
#[test]
fn smooth_rails_shake_with_the_supports() {
    let model = model();
    let memory = model.memory().unwrap();
    let steps = 1200;
    let mut march = model.march(SPACING / f64::from(steps)).unwrap();
    let bays = (memory / SPACING).ceil() as i32 + 6;
    for _ in 0..bays * steps {
        march.advance(&[0.0]);
    }
    let mut bay = || -> Vec<f64> { (0..steps).map(|_| march.advance(&[0.0])[0].normal_force - 50e3).collect() };
    let (one, other) = (bay(), bay());
    let range = one.iter().fold(0f64, |most, force| most.max(force.abs()));
    let changes = one.iter().zip(&other).map(|(one, other)| (one - other).abs());
    assert!(range > 500.0 && range < 5e3, "{range}");
    assert!(changes.fold(0.0, f64::max) < 1e-5 * range);
    // With what the force does put in, the sag of the track and the motion of the wheel are the approach of the contact:
    // Σ_m Ĥ_{n−m}(mΩ) N_m + (H_w(nΩ) + 1/k_H) N_n = −P₀ Ĥ_n(0).
    let track = moving(SPEED);
    let passing = track.passing();
    let line = |n: isize| -> Complex64 {
        let terms = one.iter().zip(1..);
        terms
            .map(|(force, index)| {
                let angle = -TAU * n as f64 * f64::from(index) / f64::from(steps);
                Complex64::from_polar(force / f64::from(steps), angle)
            })
            .sum()
    };
    let at_rest = track.harmonics(0.0, 12).unwrap();
    let wheel = RigidMass::new(350.0).unwrap();
    let stiffness = feedback(1.0).contacts()[0].stiffness;
    for n in 1..=3isize {
        let w = n as f64 * passing;
        let mut sum = line(n) * (wheel.receptance(w, SPEED) + stiffness.recip());
        for m in (-8..=8isize).filter(|&m| m != 0) {
            let harmonics = track.harmonics(m as f64 * passing, 12).unwrap();
            sum += harmonics.at(n - m) * line(m);
        }
        let sag = -50e3 * at_rest.at(n);
        let error = (sum - sag).norm() / at_rest.at(1).norm() / 50e3;
        assert!(error < 1e-2, "{n}: {sum} for {sag}: {error:e}");
    }
}

const STEP: EvolutionStep = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: 1e-3 };

fn wheel(feedback: &Loop, model: PassageModel, memory: f64) -> PassingWheel {
    PassingWheel {
        model,
        wear: WearOfPassages {
            wear: feedback.contacts()[0].wear,
            place: feedback.contacts()[0].place_of_wear,
            shortest: 0.01,
        },
        memory,
        share: 1.0,
        traction_share: 1.0,
    }
}

/// On a smooth rail the sag between supports is what the wheel rolls over: a passage wears G applied to it, lines n = 1 … 4 of
/// the bay to 2 % of the largest (the force is 1 % off, as above, and the law is not linear at a per cent of the load).
#[test]
fn supports_print_themselves_on_a_smooth_rail() {
    const COUNT: usize = 9;
    let feedback = feedback(1e-6);
    let model = model();
    let memory = model.memory().unwrap();
    let mut rail = Evolution::new(&Profile::new(0.0, 1e-3, vec![0.0; 600]).unwrap());
    rail.advance(&[&wheel(&feedback, model, memory)], &STEP, 1).unwrap();
    assert_eq!(rail.passages(), 1);
    // Lines 1 to 9 of the bay, those of the wave d/5 and its four neighbours on each side.
    let growth = GrowthWithNeighbours::at(&feedback, &moving(SPEED), SPACING / 5.0, COUNT / 2).unwrap();
    let at_rest = moving(SPEED).harmonics(0.0, COUNT).unwrap();
    let printed = |row: &Vec<Complex64>| -> Complex64 {
        let terms = row.iter().zip(1..);
        // Where the rail sags the wheel is lower. The waves of a ring are real, of twice the coefficient.
        terms.map(|(by, n)| -2.0 * 50e3 * at_rest.at(n) * by).sum()
    };
    let expected: Vec<Complex64> = growth.operator.iter().map(printed).collect();
    let largest = expected.iter().map(|wave| wave.norm()).fold(0.0, f64::max);
    for (index, wave) in expected.iter().take(4).enumerate() {
        let error = (rail.waves()[index].1 - wave).norm() / largest;
        assert!(error < 2e-2, "{index}: {} {wave} {error:e}", rail.waves()[index].1);
    }
}

/// Two wheels in equal shares, of which one rolls free half of the time, wear their weighted mean.
#[test]
fn wheels_wear_by_their_shares() {
    let feedback = feedback(1e-6);
    let slow = wheel(&feedback, model(), 3.0);
    let fast = PassingWheel {
        model: PassageModel { speed: 35.0, ..model() },
        share: 0.4,
        traction_share: 0.5,
        ..slow.clone()
    };
    let slow = PassingWheel { share: 0.6, ..slow };
    let heights = (0..1200).map(|index| 1e-6 * (TAU * f64::from(index) / 60.0).cos());
    let ring = Evolution::new(&Profile::new(0.0, 1e-3, heights.collect()).unwrap());
    let worn = |wheels: &[&PassingWheel]| {
        let mut rail = ring.clone();
        let extremes = rail.advance(wheels, &STEP, 1).unwrap();
        (rail.waves()[19].1 - ring.waves()[19].1, rail.mean_depth(), extremes)
    };
    let (both, one, other) = (worn(&[&slow, &fast]), worn(&[&slow]), worn(&[&fast]));
    // Heun's second half is not linear in the change of a passage, which is 10⁻⁶ of the wave.
    assert!((both.0 - one.0 - other.0).norm() < 1e-5 * both.0.norm());
    assert!((both.1 - one.1 - other.1).abs() < 1e-5 * both.1);
    let least = |of: &riffel::passage::PassageExtremes| of.normal_force[0];
    assert_eq!(least(&both.2), least(&one.2).min(least(&other.2)));
}

/// The end of a ring is its beginning, at the same place of a bay.
#[test]
fn rings_of_broken_bays_are_refused() {
    let feedback = feedback(1e-6);
    let wheel = wheel(&feedback, model(), 3.0);
    let ring = Profile::new(0.0, 1e-3, vec![0.0; 900]).unwrap();
    let refused = Evolution::new(&ring).advance(&[&wheel], &STEP, 1).unwrap_err();
    assert!(refused.to_string().contains("support spacing"), "{refused}");
}

/// Sixteen bays of 0.6 m part waves from the lines d/m, m = 1 … 8, that are a quarter of 1/d or more away.
#[test]
fn waves_as_long_as_a_line_of_the_supports_are_known() {
    let line = |waves: f64| {
        let wavelength = SPACING / waves;
        Sinusoid { amplitude: 1e-6, wavelength }.shares_lines_with(SPACING)
    };
    assert_eq!([6.0, 6.24, 5.76].map(line), [Some(6); 3]);
    assert_eq!([0.2, 6.26, 5.74, 9.0].map(line), [None; 4]);
}
