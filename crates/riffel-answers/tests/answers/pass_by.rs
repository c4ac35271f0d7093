//! Levels beside the track in a calibration are those of rolling noise.

use std::path::PathBuf;

use riffel::roughness::{Spectrum, ThirdOctave};
use riffel_answers::noise::NoiseQuestion;
use riffel_answers::question::Nobody;
use riffel_calibrate::Plan;
use riffel_case::Case;
use riffel_keys::quantity::Quantity;
use riffel_rail::Survey;

/// Trains at both ends of six million passages.
const HEARD: &str = "passages,level_dba,speed_km_per_h\n0,80,100\n6000000,84,100\n";
/// The rail beyond the bands whose growth is known, 0 dB from 2 mm to 1 m.
const SHORTEST: i32 = -27;

/// What a plan expects of both trains less what the answer on the same roughness has: each predicted contrast stands as far from
/// the observed one as the predicted level from the measured one. Both sum the same bands: rounding.
#[test]
fn a_calibration_hears_what_the_answer_on_noise_hears() {
    let set = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../../validation/calibration/c-all-together");
    let folder = tempfile::tempdir().unwrap();
    for file in ["case.toml", "plan.toml", "traffic.toml", "hammer.csv", "decay.csv", "roughness.csv", "axlebox.csv"] {
        std::fs::copy(set.join(file), folder.path().join(file)).unwrap();
    }
    let bands: Vec<ThirdOctave> = (SHORTEST..=0).map(ThirdOctave::new).collect();
    let rest = bands.iter().map(|band| format!("{},0\n", 1e3 * band.wavelength()));
    let rest = format!("wavelength_mm,level_db\n{}", rest.collect::<String>());
    std::fs::write(folder.path().join("rest.csv"), rest).unwrap();
    std::fs::write(folder.path().join("pass-by.csv"), HEARD).unwrap();
    let path = folder.path().join("plan.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let data = "\n[[data]]\nkind = \"pass-by\"\nfile = \"pass-by.csv\"\nwheels = 8\ndistance = \"25 m\"\n\
                 height = \"3.5 m\"\nwheel_roughness = \"cnossos-disc-brakes\"\nroughness = \"rest.csv\"\n\
                 set = { \"track.model\" = \"two-layer\" }\n";
    std::fs::write(&path, text + data).unwrap();
    let plan = Plan::read(&path).unwrap();
    let remarks = &plan.remarks;
    assert!(!remarks.iter().any(|it| it.to_string().contains("silent")), "{remarks:?}");

    let parameters = plan.posterior.parameters();
    let values: Vec<f64> = parameters.iter().map(|it| it.prior.quantile(0.5)).collect();
    let predicted = plan.posterior.predictions(&values).unwrap().pop().unwrap();
    let observed = plan.posterior.observed().pop().unwrap();
    // Levels of the second and of the last date over the first, those of the axle box, and the two trains.
    let table = std::fs::read_to_string(folder.path().join("roughness.csv")).unwrap();
    let rows: Vec<Vec<f64>> =
        table.lines().skip(1).map(|line| line.split(',').map(|it| it.parse().unwrap()).collect()).collect();
    let first: Vec<&Vec<f64>> = rows.iter().filter(|row| row[0] == 0.0).collect();
    let change = |row: usize| predicted[first.len() + row];
    let written = |name: &str| {
        let place = parameters.iter().position(|it| it.name == name).unwrap();
        format!("{name}={:e}", values[place])
    };
    let keys = [
        "track.pad.stiffness",
        "track.pad.loss_factor",
        "track.ballast.stiffness",
        "track.ballast.loss_factor",
        "rail.loss_factor",
        "wheel.mass",
    ];
    let mut overrides: Vec<String> = keys.into_iter().map(written).collect();
    // The rail of a periodic track has shear, and keeps it.
    overrides.extend(["track.model=two-layer", "rail.beam=timoshenko"].map(str::to_owned));
    let case = Case::read(&folder.path().join("case.toml"), &overrides).unwrap();
    for (train, measured) in [80.0, 84.0].into_iter().enumerate() {
        let of_bands = bands.iter().map(|band| {
            let own =
                first.iter().position(|row| ThirdOctave::centred(1e-3 * row[1]).is_ok_and(|other| other == *band));
            let level = own.map_or(0.0, |own| first[own][2] + if train == 1 { change(own) } else { 0.0 });
            (*band, level)
        });
        let question = NoiseQuestion {
            wheels: 8,
            distance: Quantity::new(25.0).into(),
            height: Quantity::new(3.5).into(),
            wheel_roughness: Some("cnossos-disc-brakes".to_owned()),
            ..NoiseQuestion::of_a_coach(
                case.clone(),
                Survey::of_spectrum(Spectrum::new(of_bands).unwrap()),
                100.0 / 3.6,
                "iso-3095-2013",
            )
            .unwrap()
        };
        let answer = question.answer(&Nobody).unwrap();
        let place = predicted.len() - 2 + train;
        let level = measured - observed[place] + predicted[place];
        let told = answer.level.total_dba.unwrap();
        assert!((level - told).abs() < 1e-9, "{train}: {level}, not {told}");
    }
}
