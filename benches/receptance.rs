//! The receptance of one track beside the peers.

use std::fmt::Write as _;
use std::hint::black_box;
use std::time::Instant;

use riffel::receptance::{Beam, Layer, PeriodicTrack, ShearSection, Support};
use riffel::{ElasticMaterial, Receptance};

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;
use crate::{is_smoke, median, ratio, sizes};

/// Receptances from 20 Hz to 3000 Hz, spaced evenly in logarithm, and the sum of their moduli.
pub(crate) fn task(points: usize) -> Result<(f64, f64), Failure> {
    /// A single turn is too short for the clock and for the processor to settle.
    const REPEATS: usize = 50;
    let angular_frequencies: Vec<f64> = (0..points)
        .map(|index| index as f64 / (points - 1) as f64)
        .map(|share| std::f64::consts::TAU * 20.0 * (3000.0_f64 / 20.0).powf(share))
        .collect();
    let begun = Instant::now();
    let mut receptances = Vec::new();
    for _ in 0..REPEATS {
        let track = black_box(uic60_on_stiff_pads()?);
        let values = angular_frequencies.iter();
        receptances = black_box(values.map(|&w| track.receptance(w, 0.0)).collect());
    }
    let seconds = begun.elapsed().as_secs_f64() / REPEATS as f64;
    Ok((seconds, receptances.iter().map(|value| value.norm()).sum()))
}

/// At mid-span; values of validation/reference/receptance/uic60_stiff_pad.json.
fn uic60_on_stiff_pads() -> Result<PeriodicTrack, Failure> {
    let spacing = 0.6;
    let section = ShearSection { area: 7.67e-3, shear_coefficient: 0.393, shear_modulus: 80.769e9, density: 7850.0 };
    let steel = ElasticMaterial::new(210e9, 0.3)?;
    let rail = Beam::timoshenko(steel, 3.037e-5, 60.2, section)?.with_loss_factor(0.02)?;
    let support = Support::two_layer(Layer::new(800e6, 30e3)?, 162.0, Layer::new(100e6, 60e3)?)?;
    Ok(PeriodicTrack::new(rail, support, spacing)?.at(spacing / 2.0))
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (rounds, rolland_rounds, frequencies) = (sizes().rounds, sizes().fewest_rounds, sizes().frequencies);
    let mut riffel = peers.riffel(1)?;
    let mut numpy = peers.numpy("receptance_numpy.py", &[])?;
    let mut rolland = peers.rolland();
    if is_smoke()
        && let Err(reason) = &rolland
    {
        println!("rolland is left out: {reason}");
    }
    let mut times = [const { Vec::new() }; 4];
    for round in 0..rounds {
        let single = riffel.time("receptance uic60", frequencies)?;
        let written = numpy.time("as-written", frequencies)?;
        let tuned = numpy.time("tuned", frequencies)?;
        text.compare("NumPy", (written.1, single.1), 1e-9);
        text.compare("NumPy, tuned by hand", (tuned.1, single.1), 1e-9);
        for (times, (seconds, _)) in times.iter_mut().zip([single, written, tuned]) {
            times.push(seconds);
        }
        if let Ok(rolland) = &mut rolland
            && round < rolland_rounds
        {
            let (seconds, sum) = rolland.time("rolland", frequencies)?;
            text.compare("rolland", (sum, single.1), 1e-6);
            times[3].push(seconds);
        }
    }
    let [single, written, tuned, others] = times;
    let [single, written, tuned] = [single, written, tuned].map(|times| 1e6 * median(times));
    let row = |contestant: &str, track: &str, time: f64| {
        let each = time / frequencies as f64;
        let ratio = ratio(time / single);
        format!("| {contestant} | {track} | {time:.0} | {each:.2} | {ratio} × faster |")
    };

    writeln!(text, "{frequencies} frequencies, 20–3000 Hz, one thread. Machine: {}.\n", machine())?;
    writeln!(text, "Timoshenko rail on discrete two-layer supports: UIC 60 on stiff pads, rail loss factor 0.02.\n")?;
    writeln!(text, "| contestant | track | µs | µs a frequency | Riffel is |\n|---|---|---|---|---|")?;
    let each = single / frequencies as f64;
    writeln!(text, "| Riffel | infinite | {single:.0} | {each:.2} | |")?;
    let version = peers.numpy_version()?;
    let contestant = format!("NumPy {version}, matrices of the bay, `eig` and `solve`");
    writeln!(text, "{}", row(&contestant, "infinite", written))?;
    let contestant = format!("NumPy {version}, tuned by hand");
    writeln!(text, "{}", row(&contestant, "infinite", tuned))?;
    let contestant = format!("rolland {}, `TSBDiscr2L`", peers.rolland_version()?);
    match rolland {
        Ok(_) => writeln!(text, "{}", row(&contestant, "122 supports", 1e6 * median(others)))?,
        Err(reason) => writeln!(text, "| {contestant} | 122 supports | not installed: {reason} | | |")?,
    }
    writeln!(
        text,
        "\nThe frequencies are given; all else is timed. Riffel and NumPy solve the infinite track exactly, by its \
         Floquet waves; rolland solves an infinite rail on a finite number of supports, a dense matrix for each \
         frequency. {rounds} rounds, of which rolland takes {rolland_rounds}. Sums of |H| are compared with Riffel's."
    )?;
    Ok(())
}
