//! Ranges of wavelengths, speeds and places beside the track.

use super::{BARE_SPEED, row};
use crate::quantity::{Area, Frequency, Kind, Length, Mass, Ratio, Speed};
use crate::range::PhysicalRange;

/// A number of things, which takes no unit and is not written in per cent.
const COUNT: Kind = Kind { name: "a number", unit: "", example: "6000" };

pub(super) const RANGES: &[PhysicalRange] = &[
    row::<Length>(
        &[
            "map.wavelength.min",
            "map.wavelength.max",
            "--wavelength",
            "outputs.point.wavelength",
            "outputs.wave.wavelength",
        ],
        [1e-4, 10.0],
        [2e-3, 3.0],
        "Shorter than a tenth of any contact patch nothing grows; corrugation has 10 mm to 1.5 m.",
    ),
    PhysicalRange {
        bare_up_to: BARE_SPEED,
        ..row::<Speed>(
            &[
                "map.speed.min",
                "map.speed.max",
                "contact.polach.speed",
                "wear.speed",
                "--speed",
                "outputs.point.speed",
                "outputs.wave.speed",
                "vehicle.speed.mean",
                "vehicle.speeds.speed",
                "speed.mean",
            ],
            [0.01, 200.0],
            [1.0, 100.0],
            "Roller rigs begin at centimetres a second; trains in service run at up to 350 km/h, 97 m/s.",
        )
    },
    row::<Speed>(
        &["vehicle.speed.standard_deviation", "speed.standard_deviation"],
        [0.0, 50.0],
        [0.0, 20.0],
        "Less than a quarter of the mean.",
    ),
    row::<Ratio>(
        &["speed.factor"],
        [1e-3, 1e3],
        [0.1, 10.0],
        "Of the speeds of the traffic, which keep their own range.",
    ),
    row::<Mass>(
        &["vehicle.axle_load"],
        [0.2, 4e5],
        [2e3, 5e4],
        "Twice the load of a wheel: 3 t (light rail) to 40 t (ore lines).",
    ),
    PhysicalRange {
        kind: COUNT,
        ..row::<Ratio>(
            &["line.passages_per_day"],
            [1e-6, 1e7],
            [20.0, 5e4],
            "Axles: a branch line with two trains a day has 30, a metro with 40 trains an hour 30 000.",
        )
    },
    PhysicalRange {
        kind: COUNT,
        ..row::<Ratio>(
            &["line.mgt_per_year"],
            [1e-6, 1e4],
            [0.01, 300.0],
            "A tram 1 to 5, main lines 5 to 40, heavy haul up to 250.",
        )
    },
    row::<Frequency>(
        &["--from", "--to", "--frequencies"],
        [1e-3, 2e6],
        [1.0, 5e4],
        "The slowest speed over the longest wavelength to the fastest over the shortest.",
    ),
    row::<Length>(
        &["--distance"],
        [0.76, 1e3],
        [1.0, 100.0],
        "From the middle of the track, beyond the rail; pass-bys are measured at 7.5 and 25 m.",
    ),
    row::<Length>(&["--height"], [0.0, 100.0], [0.0, 20.0], "Above the rail; pass-bys are measured at 1.2 and 3.5 m."),
    row::<Length>(&["--train-length"], [0.1, 1e4], [2.0, 3e3], "A tram has 20 m, an ore train 3 km."),
    row::<Length>(
        &["--rail-foot"],
        [0.01, 0.5],
        [0.08, 0.2],
        "Vignole rails have 110 to 150 mm, grooved rails 180 mm.",
    ),
    row::<Area>(&["--sleeper-area"], [1e-4, 10.0], [0.1, 1.0], "Half of a sleeper of 2.6 m by 0.25 m."),
];
