//! Wheels that are not round, as their own axle boxes felt them.

use std::collections::BTreeMap;
use std::f64::consts::{SQRT_2, TAU};

use riffel::axlebox::{PatchAverageProfile, WheelPattern};
use riffel_case::Case;
use riffel_keys::{Message, fixed, number, say, significant};
use riffel_rail::rail_of_channel;
use serde::Serialize;

use super::LevelRange;
use super::listening::{PartWithout, lower};

/// Part of the greatest power of an order from which others are told, too: 10 dB less.
const TOLD: f64 = 0.1;

/// A flat of a wheel, or a wave around it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WheelMark {
    /// The channel.
    pub name: String,
    /// Waves around the wheel; None for a flat.
    pub order: Option<usize>,
    /// Level \[dB re 1 µm\].
    pub level_db: f64,
    /// Amplitude of the wave \[m\]; None for a flat.
    pub amplitude_m: Option<f64>,
    /// Depth \[m\]; None for a wave.
    pub flat_depth_m: Option<f64>,
    /// Flat or polygon.
    pub kind: WheelMarkKind,
}

/// What a wheel has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum WheelMarkKind {
    /// Waves around it.
    Polygon,
    /// A flat.
    Flat,
}

/// A channel's piece of line, which pieces of others go with.
pub(super) type Piece = (usize, PatchAverageProfile, Option<WheelPattern>);

/// Take what turns with the wheels off pieces of line, each with the place of its channel among some names: pieces of the same length of one
/// rail are compared, but for one that is a multiple of another, which is no second axle box.
///
/// # Errors
/// Errors of [`WheelPattern::take_off`].
pub(super) fn taken_off(
    case: &Case,
    finished: Vec<(usize, PatchAverageProfile)>,
    name: &dyn Fn(usize) -> String,
) -> Result<Vec<Piece>, riffel::Error> {
    let circumference = TAU * case.hertz.rolling_radius();
    let supports = case.file.track.support_spacing.map(|spacing| spacing.si());
    let mut groups: BTreeMap<_, (Vec<usize>, Vec<PatchAverageProfile>)> = BTreeMap::new();
    let mut copies = Vec::new();
    for (place, patch_average) in finished {
        let name = name(place);
        // Rails of no name known are each another.
        let rail = rail_of_channel(&name).ok_or(name);
        let key = (rail, patch_average.profile.start().to_bits());
        let (places, all) = groups.entry(key).or_default();
        match all.iter().any(|other| patch_average.is_multiple(other)) {
            true => copies.push((vec![place], vec![patch_average])),
            false => {
                places.push(place);
                all.push(patch_average);
            }
        }
    }
    let mut pieces = Vec::new();
    for (places, mut patch_averages) in groups.into_values().chain(copies) {
        let found = WheelPattern::take_off(&mut patch_averages, circumference, supports)?;
        let of_channels = places.into_iter().zip(patch_averages).zip(found);
        pieces.extend(of_channels.map(|((place, patch_average), found)| (place, patch_average, found)));
    }
    Ok(pieces)
}

/// What is to be said of the level that waves that may be the wheel's make the most uncertain, if any by half a decibel.
pub(super) fn bound(name: &str, levels: &[LevelRange], parts: &[PartWithout]) -> Option<Message> {
    let lower = |level: &LevelRange| lower(parts, level.band);
    let most = levels.iter().max_by(|one, other| lower(one).total_cmp(&lower(other)))?;
    (lower(most) > 0.5).then(|| {
        say!(
            level_of_wheel_or_rail,
            channel = name.to_owned(),
            wavelength = number(most.band.nominal_millimetres()),
            lowest = fixed(most.level - lower(most), 1),
            level = fixed(most.level, 1)
        )
    })
}

/// What turns with the wheel of a channel, in its pieces of line with their lengths \[m\], and a sentence on it.
pub(super) fn marks(name: &str, pieces: &[(f64, WheelPattern)]) -> (Vec<WheelMark>, Option<Message>) {
    let is_wheel = pieces.iter().any(|(_, found)| found.is_wheel);
    let pieces: Vec<&(f64, WheelPattern)> = pieces.iter().filter(|(_, found)| found.is_wheel == is_wheel).collect();
    let length: f64 = pieces.iter().map(|(length, _)| length).sum();
    if pieces.is_empty() {
        return (Vec::new(), None);
    }
    let mean = |of: &dyn Fn(&WheelPattern) -> f64| {
        let sum: f64 = pieces.iter().map(|(length, found)| length * of(found)).sum();
        sum / length
    };
    let circumference = mean(&|found| found.circumference);
    let level_db = |rms: f64| 20.0 * (rms / 1e-6).log10();
    let channel = || name.to_owned();
    if mean(&|found| f64::from(u8::from(found.is_flat()))) > 0.5 {
        let depth = mean(&|found| found.depth);
        let said = say!(
            wheel_has_a_flat,
            channel = channel(),
            depth = significant(1e6 * depth, 2),
            circumference = fixed(circumference, 2)
        );
        let flat = WheelMark {
            name: channel(),
            order: None,
            level_db: level_db(mean(&|found| found.rms.powi(2)).sqrt()),
            amplitude_m: None,
            flat_depth_m: Some(depth),
            kind: WheelMarkKind::Flat,
        };
        return (vec![flat], Some(said));
    }
    let mut powers: BTreeMap<usize, f64> = BTreeMap::new();
    for (own, found) in &pieces {
        for (order, amplitude) in &found.orders {
            *powers.entry(*order).or_default() += own / length * amplitude.powi(2);
        }
    }
    let mut orders: Vec<(usize, f64)> = powers.into_iter().collect();
    orders.sort_by(|one, other| other.1.total_cmp(&one.1));
    let Some(&(order, most)) = orders.first() else {
        return (Vec::new(), None);
    };
    let (waves, amplitude) = (order.to_string(), fixed(1e6 * most.sqrt(), 1));
    let wavelength = significant(1e3 * circumference / order as f64, 3);
    if !is_wheel {
        let said = say!(wheel_or_rail, channel = channel(), order = waves, amplitude, wavelength);
        return (Vec::new(), Some(said));
    }
    let said = say!(wheel_is_not_round, channel = channel(), order = waves, amplitude, wavelength);
    let told = orders.iter().filter(|(_, power)| *power >= TOLD * most);
    let marks = told.map(|(order, power)| WheelMark {
        name: channel(),
        order: Some(*order),
        level_db: level_db(power.sqrt() / SQRT_2),
        amplitude_m: Some(power.sqrt()),
        flat_depth_m: None,
        kind: WheelMarkKind::Polygon,
    });
    (marks.collect(), Some(said))
}
