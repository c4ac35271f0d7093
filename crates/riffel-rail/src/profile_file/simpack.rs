//! Files of Simpack, `.prr` of rails and `.prw` of wheels: sections `header`, `spline` and `point`, each from `….begin` to `….end`.
//!
//! `header.type` is 0 for a rail and 1 for a wheel. Points have the columns y, z and perhaps a weight; what the section `spline` says is
//! done to them in this order: near points left out, shifts, rotation, bounds, mirrors, unit (`units.len.f` units make a metre,
//! `units.ang.f` a radian). z then points downward. Source: the files of the Manchester contact benchmark that CONTACT ships, and what
//! CONTACT's open source says of them.

use std::collections::BTreeMap;

use riffel_keys::table::number_in;
use riffel_keys::{clipped, say};

use super::reading::ProfileKind;
use super::table::without_comment;
use super::written::{WIDEST_IN_METRES, WrittenProfile};
use crate::refusal::Refusal;

/// Whether the first line is that of such a file.
pub(super) fn is_first_line(line: &str) -> bool {
    let line = line.to_lowercase();
    line.starts_with("header.begin") || line.starts_with("spline.begin")
}

/// The keys of the sections with their values as text, and the lines they stand in.
#[derive(Default)]
struct Keys(BTreeMap<String, (String, usize)>);

impl Keys {
    fn number(&self, key: &str) -> Result<Option<f64>, Refusal> {
        match self.0.get(key) {
            None => Ok(None),
            Some((text, line)) => match number_in(text) {
                Some(value) => Ok(Some(value)),
                None => Err(Refusal::new(Some(*line), say!(value_must_be_number, name = key, value = clipped(text)))),
            },
        }
    }

    fn number_or(&self, key: &str, default: f64) -> Result<f64, Refusal> {
        Ok(self.number(key)?.unwrap_or(default))
    }

    /// Units of the file in a metre, of a profile of this width.
    fn units_per_metre(&self, width: f64) -> Result<f64, Refusal> {
        let unit = self.0.get("spline.units.len");
        Ok(match (self.number("spline.units.len.f")?, unit) {
            (Some(per_metre), _) if per_metre > 0.0 => per_metre,
            (Some(_), _) => {
                let line = self.0["spline.units.len.f"].1;
                return Err(Refusal::new(Some(line), say!(units_per_metre_above_zero)));
            }
            (None, Some((unit, _))) if unit == "mm" => 1e3,
            (None, Some((unit, _))) if unit == "m" => 1.0,
            (None, _) if width > WIDEST_IN_METRES => 1e3,
            (None, _) => 1.0,
        })
    }
}

pub(super) fn read(text: &str) -> Result<WrittenProfile, Refusal> {
    let (mut written, keys) = sections(text)?;
    written.kind = keys.number("header.type")?.map(|kind| match kind {
        0.0 => ProfileKind::Rail,
        _ => ProfileKind::Wheel,
    });
    let per_metre = keys.units_per_metre(written.width())?;
    transform(&mut written, &keys, per_metre)?;
    let smoothing = keys.number("spline.approx.smooth")?;
    if smoothing.is_some_and(|smooth| smooth > 0.0) {
        written.remarks.push(say!(smoothing_of_file_left_out));
    }
    Ok(written)
}

/// The points as they are written, and the keys.
fn sections(text: &str) -> Result<(WrittenProfile, Keys), Refusal> {
    let mut written = WrittenProfile { of_any_orientation: true, ..WrittenProfile::default() };
    // Sections that are open, with the lines of their beginnings.
    let mut open: Vec<(String, usize)> = Vec::new();
    let mut keys = Keys::default();
    for (index, line) in text.lines().enumerate() {
        let line = without_comment(line);
        let lower = line.to_lowercase();
        if line.is_empty() {
            continue;
        }
        if let Some(section) = lower.strip_suffix(".begin") {
            if !matches!(section, "header" | "spline" | "point") {
                let other = say!(no_section_of_profile, text = clipped(line));
                return Err(Refusal::new(Some(index + 1), other));
            }
            open.push((section.to_owned(), index + 1));
        } else if let Some(section) = lower.strip_suffix(".end") {
            match open.pop() {
                Some((begun, _)) if begun == section => {}
                _ => {
                    let closes_none = say!(section_closes_none, section);
                    return Err(Refusal::new(Some(index + 1), closes_none));
                }
            }
        } else if open.last().is_some_and(|(section, _)| section == "point") {
            let mut cells = line.split_whitespace().map(number_in);
            match (cells.next().flatten(), cells.next().flatten()) {
                (Some(y), Some(z)) => written.push([y, z], index + 1),
                _ => {
                    let no_point = say!(line_is_no_point, text = clipped(line));
                    return Err(Refusal::new(Some(index + 1), no_point));
                }
            }
        } else if let Some((key, value)) = line.split_once('=') {
            let section = open.last().map_or("", |(section, _)| section);
            let key = format!("{section}.{}", key.trim().to_lowercase());
            keys.0.insert(key, (value.trim().trim_matches('\'').to_owned(), index + 1));
        } else {
            let neither = say!(line_is_no_key, text = clipped(line));
            return Err(Refusal::new(Some(index + 1), neither));
        }
    }
    if let Some((section, line)) = open.first() {
        return Err(Refusal::new(Some(*line), say!(section_without_end, section)));
    }
    Ok((written, keys))
}

/// What the section `spline` asks for, and z upward.
fn transform(written: &mut WrittenProfile, keys: &Keys, per_metre: f64) -> Result<(), Refusal> {
    let or = |key: &str, default: f64| keys.number_or(key, default);
    let apart = or("spline.point.dist.min", 0.0)?;
    if apart > 0.0 {
        leave_out_near(written, apart);
    }
    let (shift_y, shift_z) = (or("spline.shift.y", 0.0)?, or("spline.shift.z", 0.0)?);
    let angle = or("spline.rotate", 0.0)? / or("spline.units.ang.f", 1.0)?;
    let (sine, cosine) = angle.sin_cos();
    written.map(|[y, z]| {
        let (y, z) = (y + shift_y, z + shift_z);
        [cosine * y - sine * z, sine * y + cosine * z]
    });
    let bounds = [
        [or("spline.bound.y.min", 0.0)?, or("spline.bound.y.max", 0.0)?],
        [or("spline.bound.z.min", 0.0)?, or("spline.bound.z.max", 0.0)?],
    ];
    let inside = |point: &[f64; 2]| {
        let mut axes = point.iter().zip(&bounds);
        axes.all(|(value, [low, high])| low >= high || (low..=high).contains(&value))
    };
    let kept = written.points.iter().map(inside).collect::<Vec<bool>>();
    keep(written, &kept);
    let mirrored = [keys.number("spline.mirror.y")?, keys.number("spline.mirror.z")?];
    let [across, down] = mirrored.map(|key| if key == Some(1.0) { -1.0 } else { 1.0 });
    // z points downward.
    written.map(|[y, z]| [across * y / per_metre, -down * z / per_metre]);
    Ok(())
}

/// Leave out points nearer than this to the one kept before, across the profile.
fn leave_out_near(written: &mut WrittenProfile, apart: f64) {
    let mut last = f64::NEG_INFINITY;
    let kept: Vec<bool> = written
        .points
        .iter()
        .map(|point| {
            let far = (point[0] - last).abs() > apart;
            if far {
                last = point[0];
            }
            far
        })
        .collect();
    keep(written, &kept);
}

fn keep(written: &mut WrittenProfile, kept: &[bool]) {
    let mut of_points = kept.iter();
    written.points.retain(|_| *of_points.next().unwrap_or(&true));
    let mut of_lines = kept.iter();
    written.lines.retain(|_| *of_lines.next().unwrap_or(&true));
}
