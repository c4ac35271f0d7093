//! A wheel in time over discrete supports, and a profile that wears under many of them.

use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::path::Path;
use std::sync::{Arc, OnceLock};
use std::time::Instant;

use riffel::contact::{MeanState, QuasiStatic};
use riffel::passage::{
    ContactInTime, Evolution, EvolutionStep, ImpulseResponse, PassageModel, PassingWheel, StructuresInTime,
    WearOfPassages,
};
use riffel::receptance::{Beam, Layer, MovingLoadOnSupports, PeriodicTrack, ShearSection, Support};
use riffel::roughness::Profile;
use riffel::wheelset::{RigidInertia, RigidMass};
use riffel::{Carter3d, DissipationPhase, ElasticMaterial, EnergyWear, HertzContact, PlaceOfWear, RollingContact};
use riffel_case::{Case, ask};

use crate::contestant::{Contestant, Failure, Peers, machine};
use crate::section::Section;
use crate::{is_smoke, median, ratio, sizes};

const SPEED: f64 = 30.0;
const SPACING: f64 = 0.6;
const STEP: f64 = 5e-4;
const STEPS_TO_BAY: usize = 1200;
/// Length of the rail that wears \[m\].
const RING: f64 = 19.8;
const STEPS_ON_ALL_AXES: usize = 20_000;

/// Seconds of a task, and a number that says what came of it.
pub(crate) fn task(name: &str, points: usize) -> Result<(f64, f64), Failure> {
    match name {
        "march" => march(points),
        "evolution" => evolution(points as u64),
        "all-axes" => all_axes(points),
        _ => Err("no such task of the passage".into()),
    }
}

/// 60E1 on concrete sleepers with viscous loss everywhere.
fn response() -> Result<ImpulseResponse, Failure> {
    static RESPONSE: OnceLock<ImpulseResponse> = OnceLock::new();
    if let Some(response) = RESPONSE.get() {
        return Ok(response.clone());
    }
    let shear = ShearSection { area: 7.67e-3, shear_coefficient: 0.4, shear_modulus: 79.6e9, density: 7850.0 };
    let rail = Beam::timoshenko(steel()?, 3.04e-5, 60.2, shear)?.with_damping(5e4)?;
    let (pad, ballast) = (Layer::new(300e6, 40e3)?, Layer::new(80e6, 80e3)?);
    let support = Support::two_layer(pad, 150.0, ballast)?;
    let track = PeriodicTrack::new(rail, support, SPACING)?;
    let response = ImpulseResponse::over_supports(&MovingLoadOnSupports::new(&track, SPEED)?)?;
    Ok(RESPONSE.get_or_init(|| response).clone())
}

fn steel() -> Result<ElasticMaterial, Failure> {
    Ok(ElasticMaterial::new(207e9, 0.3)?)
}

fn hertz() -> Result<HertzContact, Failure> {
    Ok(HertzContact::new(steel()?, 0.46, 0.3, 50e3)?)
}

fn model() -> Result<PassageModel, Failure> {
    let hertz = hertz()?;
    let law = Carter3d::new(hertz, 0.35)?;
    let mean = QuasiStatic::new(law, 50e3, MeanState::TractiveRatio(0.3))?.steady();
    let rotation = RigidInertia::new(RigidInertia::reduced_inertia(350.0, 0.46), 0.46)?;
    let contact = ContactInTime::of_one_wheel(mean, hertz.stiffness(), Arc::new(law))?;
    Ok(PassageModel {
        structures: StructuresInTime::of_one_wheel(response()?, &RigidMass::new(350.0)?, Some(&rotation)),
        contacts: vec![contact],
        contact_filter: None,
        speed: SPEED,
    })
}

/// Two waves \[m\], of 47 and 83 mm.
fn height(x: f64) -> f64 {
    5e-6 * (TAU * x / 0.047).cos() + 8e-6 * (TAU * x / 0.083).sin()
}

/// A rough rail in steps of half a millimetre; the root mean square of P − P₀ over the last bays \[N\].
fn march(bays: usize) -> Result<(f64, f64), Failure> {
    let model = model()?;
    let begun = Instant::now();
    let mut march = model.march(STEP)?;
    let mut sum = 0.0;
    let [_, counting, _] = sizes().bays;
    let counted = (bays - counting) * STEPS_TO_BAY;
    for step in 1..=bays * STEPS_TO_BAY {
        let force = march.advance(&[height(step as f64 * STEP)])[0].normal_force;
        if step > counted {
            sum += (force - 50e3).powi(2);
        }
    }
    let seconds = begun.elapsed().as_secs_f64();
    Ok((seconds, (sum / (counting * STEPS_TO_BAY) as f64).sqrt()))
}

/// A flexible wheelset on both rails over a rough right one, all axes; the root mean square of P − P₀ under the right wheel \[N\].
fn all_axes(steps: usize) -> Result<(f64, f64), Failure> {
    const KEYS: [&str; 4] = [
        "track.model=one-layer",
        "contact.creep_law=polach",
        "contact.polach={limit_friction_ratio=1, friction_decay=0, adhesion_reduction=1, slip_reduction=1, speed=30}",
        "track.pad.loss_factor=0",
    ];
    static MODEL: OnceLock<PassageModel> = OnceLock::new();
    let model = match MODEL.get() {
        Some(model) => model,
        None => {
            let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../cases/wheelset-metro-trailer.toml");
            let case = ask::in_time(&Case::read(&path, &KEYS.map(str::to_owned))?, SPEED)?;
            MODEL.get_or_init(|| case)
        }
    };
    let begun = Instant::now();
    let mut march = model.march(STEP)?;
    let mut sum = 0.0;
    for step in 1..=steps {
        let contacts = march.advance(&[height(step as f64 * STEP), 0.0]);
        sum += (contacts[0].normal_force - model.contacts[0].spring.normal_force()).powi(2);
    }
    let seconds = begun.elapsed().as_secs_f64();
    Ok((seconds, (sum / steps as f64).sqrt()))
}

/// A rail under many wheels; the number of steps of Heun's, two marches each.
fn evolution(passages: u64) -> Result<(f64, f64), Failure> {
    let model = model()?;
    let count = (RING / 1e-3) as usize;
    let heights = (0..count).map(|index| height(index as f64 * 1e-3));
    let profile = Profile::new(0.0, 1e-3, heights.collect())?;
    let wear = WearOfPassages {
        wear: EnergyWear::new(2.5e-9, 7850.0, hertz()?.semi_axis_lateral())?,
        place: PlaceOfWear::new(DissipationPhase::None, 0.0, 0.3),
        shortest: 2.0 * hertz()?.semi_axis_longitudinal(),
    };
    let step = EvolutionStep { largest_change: EvolutionStep::USUAL_CHANGE, largest_step: STEP };
    let begun = Instant::now();
    let wheel = PassingWheel { memory: model.memory()?, model, wear, share: 1.0, traction_share: 1.0 };
    let mut rail = Evolution::new(&profile);
    let mut steps = 0;
    while rail.passages() < passages {
        rail.advance(&[&wheel], &step, passages - rail.passages())?;
        steps += 1;
    }
    Ok((begun.elapsed().as_secs_f64(), f64::from(steps)))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let [run_in, counted, finite_elements] = sizes().bays;
    let (rounds, passages) = (sizes().few_rounds, sizes().passages);
    let mut one = peers.riffel(1)?;
    let mut numpy = peers.numpy("passage_numpy.py", &[finite_elements.to_string()])?;
    let bays = run_in + counted;
    let (mut ours, mut theirs, mut worn) = (Vec::new(), Vec::new(), Vec::new());
    let (mut by_riffel, mut by_numpy, mut marches) = (0.0, 0.0, 0.0);
    for _ in 0..rounds {
        let (seconds, force) = one.time("passage march", bays)?;
        ours.push(seconds);
        by_riffel = force;
        let (seconds, force) = numpy.once("march", bays)?;
        theirs.push(seconds);
        by_numpy = force;
        text.compare("modes in NumPy", (by_numpy, by_riffel), 5e-3);
        let (seconds, steps) = one.once("passage evolution", passages)?;
        worn.push(seconds);
        marches = 2.0 * steps;
    }
    let [ours, theirs, worn] = [ours, theirs, worn].map(median);
    let real = bays as f64 * SPACING / SPEED;
    writeln!(text, "One thread; {rounds} rounds. Machine: {}.\n", machine())?;
    writeln!(
        text,
        "| {bays} sleeper bays at 30 m/s in steps of 0.5 mm | µs a step | times real time | rms of P − P₀ over the last \
         {counted} bays, kN |\n|---|---|---|---|"
    )?;
    for (name, seconds, force) in
        [("Riffel", ours, by_riffel), (&*format!("modes in NumPy {}", peers.numpy_version()?), theirs, by_numpy)]
    {
        writeln!(
            text,
            "| {name} | {:.2} | {} | {:.3} |",
            1e6 * seconds / (bays * STEPS_TO_BAY) as f64,
            ratio(real / seconds),
            1e-3 * force
        )?;
    }
    writeln!(
        text,
        "\nRiffel is {} × faster. 60E1 on two viscous layers, a rigid wheel that turns, Hertz's spring, the creep law of the paper. \
         Beside it {finite_elements} bays of finite elements, their modes up to 6 kHz moved exactly under forces that are linear over a \
         step, as Riffel's track is; making either is not counted (Riffel's response some seconds, their eigenvalues ten).\n\n\
         {passages} wheels over {RING} m of that rail and its run-in: {worn:.2} s for {marches} marches, since a band of the profile may \
         change by 8 % before the next; every wheel by itself would take {:.0} s. The memory is that of the profile and of one \
         passage; nothing grows with the length of the line or the number of wheels.",
        ratio(theirs / ours),
        worn / marches * passages as f64
    )?;
    // Its responses take seconds to make, and no peer is beside it.
    if is_smoke() { Ok(()) } else { report_all_axes(text, &mut one) }
}

/// A wheelset on all axes.
fn report_all_axes(text: &mut Section, one: &mut Contestant) -> Result<(), Failure> {
    let times = (0..sizes().few_rounds).map(|_| Ok(one.time("passage all-axes", STEPS_ON_ALL_AXES)?.0));
    let a_step = median(times.collect::<Result<_, Failure>>()?) / STEPS_ON_ALL_AXES as f64;
    writeln!(
        text,
        "\nOn all axes a flexible wheelset with brake discs, both wheels on 60E1 on an even layer, creep law of Polach, takes {:.2} µs a \
         step, {} times real time.",
        1e6 * a_step,
        ratio(STEP / SPEED / a_step)
    )?;
    Ok(())
}
