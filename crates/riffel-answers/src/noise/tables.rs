//! Levels as tables.

use riffel_keys::{Message, number, say, shown_speed};
use riffel_noise::Part;

use super::NoiseAnswer;
use crate::{Column, Rows, Table, Values};

/// The name of a part.
pub(crate) fn name_of(part: Part) -> Message {
    match part {
        Part::Rail => say!(noise_of_rail),
        Part::Sleepers => say!(noise_of_sleepers),
        Part::Wheel => say!(noise_of_wheel),
        Part::Total => say!(noise_of_all),
    }
}

pub(super) fn introduction(answer: &NoiseAnswer) -> Vec<Message> {
    let title = answer.title.clone();
    let title = title.map_or_else(|| say!(rolling_noise), Message::verbatim);
    vec![
        say!(noise_at_speed, title, speed = shown_speed(answer.speed_m_per_s, 1)),
        say!(noise_heard_at, distance = number(answer.distance_m), height = number(answer.height_m)),
    ]
}

pub(super) fn tables(answer: &NoiseAnswer) -> Vec<Table> {
    vec![bands(answer), parts(answer), measures(answer)]
}

fn bands(answer: &NoiseAnswer) -> Table {
    let mut columns = vec![Column {
        head: Some(say!(frequency_in_hertz)),
        ..Column::in_file("frequency_hz", answer.frequency_hz.iter().copied())
    }];
    for part in Part::ALL {
        let (levels, _) = answer.level.of(part);
        let head = say!(in_decibels, what = name_of(part));
        let name = format!("{}_db", name_of(part));
        columns.push(Column::decibels(name, Some(head), levels.clone()));
    }
    for part in Part::ALL {
        let (levels, _) = answer.sound_power_level.of(part);
        let name = format!("{}_power_db", name_of(part));
        columns.push(Column::decibels(name, None, levels.clone()));
    }
    if let Some(transfer) = &answer.by_transfer_functions {
        let total = say!(in_decibels, what = say!(by_transfer_functions));
        for (name, head, levels) in [
            ("track", None, &transfer.track_db),
            ("vehicle", None, &transfer.vehicle_db),
            ("total", Some(total), &transfer.total_db),
        ] {
            let of_band = |band: &f64| {
                let place = transfer.frequency_hz.iter().position(|other| other == band);
                place.and_then(|place| levels[place])
            };
            let levels = answer.frequency_hz.iter().map(of_band).collect();
            let name = format!("transfer_{name}_db");
            columns.push(Column::decibels(name, head, levels));
        }
    }
    if let Some(since) = &answer.since {
        let place = |band: &f64| since.frequency_hz.iter().position(|other| other == band);
        let of_band = |band| place(band).and_then(|place| since.before_db[place]);
        let levels = answer.frequency_hz.iter().map(of_band).collect();
        let head = say!(in_decibels, what = say!(noise_before));
        columns.push(Column::decibels("before_db".to_owned(), Some(head), levels));
    }
    Table { name: "bands", columns }
}

/// The head of A-weighted levels, which may be lower bounds.
fn level_head(answer: &NoiseAnswer) -> Message {
    let level = say!(decibels_a_weighted);
    match answer.lower_bound_up_to_hz {
        Some(hertz) => say!(level_at_least, level, hertz = number(hertz)),
        None => level,
    }
}

/// The A-weighted levels of what radiates anything.
fn parts(answer: &NoiseAnswer) -> Table {
    let levels = Part::ALL.map(|part| {
        let [(_, level), (_, power)] = [&answer.level, &answer.sound_power_level].map(|levels| levels.of(part));
        (name_of(part), level, power)
    });
    let mut rows: Vec<_> = levels.into_iter().filter(|(_, level, power)| level.is_some() || power.is_some()).collect();
    if let Some(since) = &answer.since {
        rows.push((say!(noise_before), Some(since.before_dba), None));
    }
    if let Some(transfer) = &answer.by_transfer_functions {
        rows.push((say!(by_transfer_functions), transfer.total_dba, None));
    }
    let exposure = Some(answer.sound_exposure_level_dba);
    rows.push((say!(sound_exposure, wheels = answer.wheels), exposure, None));
    let column = |name: &str, head, values| Column::decibels(name.to_owned(), Some(head), values);
    Table {
        name: "parts",
        columns: vec![
            rows.words("part", say!(what_radiates), |(part, ..)| part.clone()),
            column("level_dba", level_head(answer), rows.iter().map(|(_, level, _)| *level).collect()),
            column("power_dba", say!(sound_power_of_a_wheel), rows.iter().map(|(.., power)| *power).collect()),
        ],
    }
}

pub(super) fn measures(answer: &NoiseAnswer) -> Table {
    let measures = &answer.measures;
    let saved = measures.iter().map(|measure| Some(measure.saved_db));
    Table {
        name: "measures",
        columns: vec![
            measures.words("title", say!(each_alone), |measure| measure.title.clone()),
            Column::decibels(
                "total_dba".to_owned(),
                Some(level_head(answer)),
                measures.iter().map(|measure| measure.total_dba).collect(),
            ),
            Column {
                name: "saved_db".to_owned(),
                head: Some(match answer.lower_bound_up_to_hz {
                    Some(hertz) => say!(saves_decibels_up_to, hertz = number(hertz)),
                    None => say!(saves_decibels),
                }),
                values: Values::Fixed { values: saved.collect(), file: 3, shown: 1, signed: true },
            },
        ],
    }
}
