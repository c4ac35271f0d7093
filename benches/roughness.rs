//! Reading and processing of a profile, beside NumPy and SciPy.

use std::fmt::Write as _;
use std::hint::black_box;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

use riffel::roughness::{
    BandLevel, BandSettings, BandStatistics, PIT_DEPTH, PowerSpectrum, Profile, Spectrum, SpikeCriterion, WHEEL_RADIUS,
    WavelengthBand,
};
use riffel_rail::{Layout, RoughnessFile};

use crate::contestant::{Contestant, Failure, numpy_version, scipy_version};
use crate::{check_agreement, median};

/// Samples of the profile: 2 km at 1 mm.
const SAMPLES: usize = 2_000_000;
/// SciPy takes seconds a turn.
const ROUNDS: usize = 5;
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
pub(crate) fn contest(task: &str, file: &str, samples: usize) -> Result<(f64, f64), Failure> {
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

/// The profile as text: position in m, height in µm.
fn write_profile(folder: &Path) -> Result<(PathBuf, u64), Failure> {
    let path = folder.join("../target/roughness-benchmark.csv");
    let mut file = std::io::BufWriter::new(std::fs::File::create(&path)?);
    writeln!(file, "position_m,height_um")?;
    for (sample, height) in made(SAMPLES).iter().enumerate() {
        writeln!(file, "{:.3},{:.3}", sample as f64 * SPACING, 1e6 * height)?;
    }
    file.flush()?;
    let size = std::fs::metadata(&path)?.len();
    Ok((path, size))
}

/// The section of the report.
pub(crate) fn report(
    text: &mut String,
    folder: &Path,
    one: &mut Contestant,
    two: &mut Contestant,
) -> Result<(), Failure> {
    let mut scipy = Contestant::numpy(folder, "roughness_scipy.py")?;
    let (path, size) = write_profile(folder)?;
    let path = path.display();
    let mut times = [const { Vec::new() }; 8];
    let mut rms = 0.0;
    for _ in 0..ROUNDS {
        let read = scipy.once(&format!("read {path}"), SAMPLES)?;
        let process = scipy.once("process -", SAMPLES)?;
        let mut row = [read.0, process.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
        for (index, riffel) in [&mut *one, &mut *two].into_iter().enumerate() {
            let own = riffel.time(&format!("roughness-read {path}"), SAMPLES)?;
            // A sum of two million heights that nearly cancel: against their size and not against itself.
            check_agreement("heights read", (own.1 + 1e6, read.1 + 1e6), 1e-9)?;
            row[2 + 3 * index] = own.0;
            let own = riffel.time("roughness-process -", SAMPLES)?;
            check_agreement("roughnesses", (own.1, process.1), 1e-9)?;
            row[3 + 3 * index] = own.0;
            let levels = riffel.time("roughness-levels -", SAMPLES)?;
            row[4 + 3 * index] = levels.0;
            rms = levels.1 / own.1;
        }
        times.iter_mut().zip(row).for_each(|(times, time)| times.push(time));
    }
    let [read, process, read_one, process_one, levels_one, read_two, process_two, levels_two] = times.map(median);
    let megabytes = size as f64 / 1e6;
    let row = |name: &str, reading: f64, processing: f64| {
        format!(
            "| {name} | {reading:.3} | {:.0} | {:.1} × | {processing:.3} | {:.1} × |",
            megabytes / reading,
            read / reading,
            process / processing
        )
    };
    writeln!(text, "\n## Roughness of 2 km at 1 mm, one rail, {megabytes:.0} MB of text\n")?;
    writeln!(text, "| contestant | read s | MB/s | | process s | |\n|---|---|---|---|---|---|")?;
    let peers = format!("NumPy {}, SciPy {}, one thread", numpy_version(folder)?, scipy_version(folder)?);
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
         peak-to-peak value of each, rolling of the wheel (`grey_dilation`), `welch`. The RMS of the spectra must \
         agree to 1e-9. The levels of `riffel roughness` are no `welch`: each band has segments of its own length, so that a \
         pure tone at the edge of two bands counts in their sum with up to 6 % of its power too much or too little. The RMS by \
         the levels of this record, twelve tones, is {:+.2} % from that by `welch`. {ROUNDS} rounds. The roughness functions \
         of the Python package phonometry are in no release up to 4.0.0rc1, the latest on the package index, and could not be \
         run beside.",
        100.0 * (rms - 1.0)
    )?;
    Ok(())
}
