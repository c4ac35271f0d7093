//! Reading and processing of a profile, beside NumPy and SciPy.

use std::fmt::Write as _;
use std::hint::black_box;
use std::io::Write as _;
use std::path::Path;
use std::time::Instant;

use riffel::roughness::{
    BandLevel, BandSettings, BandStatistics, PIT_DEPTH, PowerSpectrum, Profile, Spectrum, SpikeCriterion, WHEEL_RADIUS,
    WavelengthBand,
};
use riffel_rail::{Layout, RoughnessFile};

use crate::contestant::{Failure, Peers, machine};
use crate::section::Section;
use crate::{median, sizes};

/// Step of the profile \[m\].
const SPACING: f64 = 1e-3;
/// Longest wavelength of the spectra \[m\].
const LONGEST: f64 = 1.0;

/// A rough rail: sums of sinusoids, alike in every language.
fn made(samples: usize) -> Vec<f64> {
    let mut heights = vec![0.0; samples];
    for index in 0..12 {
        let wavelength = 0.02 * 1.37f64.powi(index);
        let amplitude = 1e-5 * wavelength.sqrt();
        for (sample, height) in heights.iter_mut().enumerate() {
            let phase = std::f64::consts::TAU * sample as f64 * SPACING / wavelength;
            *height += amplitude * (phase + f64::from(index)).sin();
        }
    }
    heights
}

/// Seconds of a task, and a sum of its result.
pub(crate) fn task(task: &str, file: &str, samples: usize) -> Result<(f64, f64), Failure> {
    if task == "roughness-read" {
        let begun = Instant::now();
        let RoughnessFile::Profile(record) = RoughnessFile::read(Path::new(file), &Layout::default(), &|_| ())? else {
            return Err("the file holds no profile".into());
        };
        let seconds = begun.elapsed().as_secs_f64();
        let heights = record.rails[0].stretches[0].heights();
        return Ok((seconds, 1e6 * heights.iter().sum::<f64>()));
    }
    let mut profile = Profile::new(0.0, SPACING, made(samples))?;
    let begun = Instant::now();
    profile.remove_spikes(SpikeCriterion::EN_15610);
    let settings = WavelengthBand::GRINDING.map(|band| BandSettings {
        band,
        window: (band.default_window() / SPACING).round() as usize,
        limit: Some(7e-6),
        block: 10_000,
        margin: 1000,
    });
    black_box(BandStatistics::of_profile(&profile, &settings)?);
    profile.roll_over(WHEEL_RADIUS, PIT_DEPTH);
    let sum: f64 = if task == "roughness-levels" {
        let levels = Spectrum::of_record(&[profile], LONGEST)?;
        levels.levels().iter().map(BandLevel::mean_square).sum()
    } else {
        let power = PowerSpectrum::of_record(&[profile], LONGEST)?;
        power.lines().map(|(_, power)| power).sum()
    };
    Ok((begun.elapsed().as_secs_f64(), sum.sqrt()))
}

/// Write the profile as text: position in m, height in µm.
fn write_profile(path: &Path, samples: usize) -> Result<(), Failure> {
    let mut file = std::io::BufWriter::new(std::fs::File::create(path)?);
    writeln!(file, "position_m,height_um")?;
    for (sample, height) in made(samples).iter().enumerate() {
        writeln!(file, "{:.3},{:.3}", sample as f64 * SPACING, 1e6 * height)?;
    }
    Ok(file.flush()?)
}

/// The section of the report.
pub(crate) fn report(text: &mut Section, peers: &Peers) -> Result<(), Failure> {
    let (rounds, samples) = (sizes().few_rounds, sizes().samples);
    let mut scipy = peers.numpy("roughness_scipy.py", &[])?;
    let (mut one, mut two) = (peers.riffel(1)?, peers.riffel(2)?);
    let scratch = tempfile::tempdir()?;
    let path = scratch.path().join("profile.csv");
    write_profile(&path, samples)?;
    let megabytes = std::fs::metadata(&path)?.len() as f64 / 1e6;
    let path = path.display();
    let mut times = [const { Vec::new() }; 8];
    let mut rms = 0.0;
    for _ in 0..rounds {
        let read = scipy.once(&format!("read {path}"), samples)?;
        let process = scipy.once("process -", samples)?;
        let mut row = [read.0, process.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for (index, riffel) in [&mut one, &mut two].into_iter().enumerate() {
            let own = riffel.time(&format!("roughness-read {path}"), samples)?;
            // A sum of two million heights that nearly cancel: against their size and not against itself.
            text.compare("NumPy, heights read", (own.1 + 1e6, read.1 + 1e6), 1e-9);
            row[2 + 3 * index] = own.0;
            let own = riffel.time("roughness-process -", samples)?;
            text.compare("SciPy, RMS of the spectrum", (own.1, process.1), 1e-9);
            row[3 + 3 * index] = own.0;
            let levels = riffel.time("roughness-levels -", samples)?;
            row[4 + 3 * index] = levels.0;
            rms = levels.1 / own.1;
        }
        times.iter_mut().zip(row).for_each(|(times, time)| times.push(time));
    }
    let [read, process, read_one, process_one, levels_one, read_two, process_two, levels_two] = times.map(median);
    let row = |name: &str, reading: f64, processing: f64| {
        format!(
            "| {name} | {reading:.3} | {:.0} | {:.1} × | {processing:.3} | {:.1} × |",
            megabytes / reading,
            read / reading,
            process / processing
        )
    };
    writeln!(
        text,
        "{} km at 1 mm, one rail, {megabytes:.0} MB of text; {rounds} rounds. Machine: {}.\n",
        1e-3 * SPACING * samples as f64,
        machine()
    )?;
    writeln!(text, "| contestant | read s | MB/s | | process s | |\n|---|---|---|---|---|---|")?;
    let peers = format!("NumPy {}, SciPy {}, one thread", peers.numpy_version()?, peers.scipy_version()?);
    writeln!(text, "{}", row(&peers, read, process))?;
    writeln!(text, "{}", row("Riffel, one thread", read_one, process_one))?;
    writeln!(text, "{}", row("Riffel, two threads", read_two, process_two))?;
    let with_levels = "with one-third-octave levels for `welch`";
    writeln!(text, "{}", row(&format!("Riffel, one thread, {with_levels}"), read_one, levels_one))?;
    writeln!(text, "{}", row(&format!("Riffel, two threads, {with_levels}"), read_two, levels_two))?;
    writeln!(
        text,
        "\nReading: `numpy.loadtxt` against sniffing, parsing and checking the chainage. Processing: spikes, four \
         zero-phase band-passes (`sosfiltfilt` of Butterworth filters of order 4 in SciPy), moving RMS and \
         peak-to-peak value of each, rolling of the wheel (`grey_dilation`), `welch`. The levels of `riffel roughness` are no `welch`: each band has segments of its own length, so that a \
         pure tone at the edge of two bands counts in their sum with up to 6 % of its power too much or too little. The RMS by \
         the levels of this record, twelve tones, is {:+.2} % from that by `welch`. The roughness functions \
         of the Python package phonometry are in no release up to 4.0.0rc1, the latest on the package index, and could not be \
         run beside.",
        100.0 * (rms - 1.0)
    )?;
    Ok(())
}
