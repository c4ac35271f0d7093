//! Wear of profiles against a nominal one.

use std::io::{self, Write};
use std::path::{Path, PathBuf};

use riffel::profile::{Profile, ProfileAlignment, ProfileError, ProfileWear, RailWear, WheelDimensions, WornPoint};
use riffel_case::file::{Inclination, ProfileKind};
use riffel_case::{ProfileReading, profile_of};
use riffel_keys::{CaseError, Message, Value, fixed, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Scale, Series};
use serde::Serialize;

/// How wear is found.
#[derive(Debug, Clone, Copy)]
pub struct WearSettings {
    /// How the files are read.
    pub reading: ProfileReading,
    /// By what profiles are laid on the nominal one; none for the flange of wheels and the field side of rails.
    pub alignment: Option<ProfileAlignment>,
    /// By what the nominal rail is inclined before, for coordinates that are.
    pub inclination: Inclination,
    /// Below the nominal crown, where wear of the gauge face is measured \[m\].
    pub gauge_height: f64,
    /// Flange back in the coordinates of a wheel \[m\].
    pub flange_back_position: f64,
}

impl Default for WearSettings {
    fn default() -> Self {
        Self {
            reading: ProfileReading::default(),
            alignment: None,
            inclination: Inclination { slope: 0.0 },
            gauge_height: 0.014,
            flange_back_position: -0.07,
        }
    }
}

/// Profiles beside a nominal one.
pub struct WearAnswer {
    nominal_name: String,
    nominal: Profile,
    kind: ProfileKind,
    alignment: ProfileAlignment,
    gauge_height: f64,
    worn: Vec<Worn>,
    /// Of files, and of what is laid on what.
    pub remarks: Vec<Message>,
}

/// One of them.
pub struct Worn {
    /// File.
    pub name: String,
    /// Depths and area.
    pub wear: ProfileWear,
    /// The numbers by which it is judged.
    pub measures: Measures,
}

/// The numbers by which wheels and rails are judged.
pub enum Measures {
    /// Of a wheel: its dimensions, those of the nominal one and how much the tread has lost \[m\].
    Wheel {
        /// As it is.
        measured: WheelDimensions,
        /// As it was.
        nominal: WheelDimensions,
    },
    /// Of a rail.
    Rail(RailWear),
}

impl Measures {
    /// Which of them are not told, for nothing is measured where they are taken.
    fn not_measured(&self, name: &str) -> Option<Message> {
        let all = match self {
            Self::Wheel { measured, .. } => {
                [("Sh", measured.flange_height), ("Sd", measured.flange_thickness), ("qR", measured.flange_gradient)]
            }
            Self::Rail(rail) => [("W1", rail.vertical), ("W2", rail.lateral), ("W3", rail.diagonal)],
        };
        let silent = all.iter().filter(|(_, value)| value.is_none());
        let silent: Vec<Value> = silent.map(|(measure, _)| (*measure).into()).collect();
        let count = silent.len();
        (count > 0).then(|| {
            let measures = Value::List(silent);
            say!(measures_not_measured, name = name, measures = measures, count = count)
        })
    }
}

/// What `riffel profile FILE… --against NAME --json` prints.
#[derive(Serialize)]
pub struct WearDocument {
    nominal: String,
    kind: &'static str,
    alignment: &'static str,
    profiles: Vec<WornDocument>,
    remarks: Vec<Message>,
}

#[derive(Serialize)]
struct WornDocument {
    name: String,
    shift_x_m: f64,
    shift_height_m: f64,
    misfit_m: Option<f64>,
    area_m2: f64,
    greatest_depth_m: Option<f64>,
    greatest_depth_x_m: Option<f64>,
    #[serde(flatten)]
    measures: MeasuresDocument,
    x_m: Vec<f64>,
    height_m: Vec<f64>,
    depth_m: Vec<Option<f64>>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum MeasuresDocument {
    Wheel {
        flange_height_m: Option<f64>,
        flange_thickness_m: Option<f64>,
        flange_gradient_m: Option<f64>,
        nominal_flange_height_m: Option<f64>,
        nominal_flange_thickness_m: Option<f64>,
        nominal_flange_gradient_m: Option<f64>,
        tread_wear_m: Option<f64>,
    },
    Rail {
        w1_m: Option<f64>,
        w2_m: Option<f64>,
        w3_m: Option<f64>,
        gauge_height_m: f64,
    },
}

/// The name of an alignment on the command line and in Python.
pub fn alignment_name(alignment: ProfileAlignment) -> &'static str {
    match alignment {
        ProfileAlignment::AsWritten => "as-written",
        ProfileAlignment::Flange => "flange",
        ProfileAlignment::FieldSide => "field-side",
    }
}

/// The alignment of a name.
pub fn alignment_named(name: &str) -> Option<ProfileAlignment> {
    let all = [ProfileAlignment::AsWritten, ProfileAlignment::Flange, ProfileAlignment::FieldSide];
    all.into_iter().find(|one| alignment_name(*one) == name)
}

impl WearAnswer {
    /// The wear of files against a nominal profile or another file.
    ///
    /// # Errors
    /// [`CaseError`] with file and line, and for profiles that do not fit each other.
    pub fn new(files: &[PathBuf], nominal_name: &str, settings: WearSettings) -> Result<Self, CaseError> {
        let here = Path::new("");
        let read = profile_of(nominal_name, here, settings.reading)?;
        let (kind, mut remarks) = (read.kind, read.remarks);
        let is_wheel = kind == ProfileKind::Wheel;
        let nominal = match is_wheel {
            true => read.profile,
            false => read.profile.turned(settings.inclination.slope.atan()),
        };
        let alignment = settings.alignment.unwrap_or(match is_wheel {
            true => ProfileAlignment::Flange,
            false => ProfileAlignment::FieldSide,
        });
        let suits = match alignment {
            ProfileAlignment::AsWritten => true,
            ProfileAlignment::Flange => is_wheel,
            ProfileAlignment::FieldSide => !is_wheel,
        };
        if !suits {
            let name = alignment_name(alignment);
            let other = match kind {
                ProfileKind::Wheel => say!(is_wheel_not_laid_so, alignment = name),
                ProfileKind::Rail => say!(is_rail_not_laid_so, alignment = name),
            };
            return Err(CaseError::data(Path::new(nominal_name), other));
        }
        let mut worn = Vec::new();
        for file in files {
            let name = file.display().to_string();
            let reading =
                ProfileReading { kind: Some(kind), flange_back: settings.flange_back_position, ..settings.reading };
            let read = profile_of(&name, here, reading)?;
            if read.kind != kind {
                let other = match kind {
                    ProfileKind::Wheel => say!(is_rail_against_wheel, nominal = nominal_name),
                    ProfileKind::Rail => say!(is_wheel_against_rail, nominal = nominal_name),
                };
                return Err(CaseError::data(file, other));
            }
            remarks.extend(read.remarks);
            let refuse = |error: ProfileError| CaseError::data(file, &error);
            let wear = ProfileWear::new(&read.profile, &nominal, is_wheel, alignment).map_err(refuse)?;
            let back = settings.flange_back_position;
            let measures = match is_wheel {
                true => Measures::Wheel {
                    measured: WheelDimensions::new(&wear.measured, back).map_err(refuse)?,
                    nominal: WheelDimensions::new(&nominal, back).map_err(refuse)?,
                },
                false => Measures::Rail(RailWear::new(&wear, &nominal, settings.gauge_height)),
            };
            remarks.extend(of_misfit(&name, &wear));
            remarks.extend(measures.not_measured(&name));
            worn.push(Worn { name, wear, measures });
        }
        Ok(Self {
            nominal_name: nominal_name.to_owned(),
            nominal,
            kind,
            alignment,
            gauge_height: settings.gauge_height,
            worn,
            remarks,
        })
    }

    /// The profiles.
    pub fn worn(&self) -> &[Worn] {
        &self.worn
    }

    /// Wheels or rails.
    pub fn kind(&self) -> ProfileKind {
        self.kind
    }

    /// By what they lie on the nominal profile, in words.
    pub fn in_words(&self) -> String {
        let nominal = &self.nominal_name;
        match self.alignment {
            ProfileAlignment::AsWritten => format!("against {nominal}, as the coordinates are"),
            ProfileAlignment::Flange => format!(
                "against {nominal}, laid by the flange back across the track and by the tip of the flange upward"
            ),
            ProfileAlignment::FieldSide => {
                format!("against {nominal}, laid by the field side, where it is steeper than 20°")
            }
        }
    }

    /// What `riffel profile FILE… --against NAME --json` prints.
    pub fn document(&self) -> WearDocument {
        let profiles = self.worn.iter().map(|worn| {
            let wear = &worn.wear;
            let of = |value: fn(&WornPoint) -> f64| wear.points.iter().map(value).collect();
            let deepest = wear.deepest();
            WornDocument {
                name: worn.name.clone(),
                shift_x_m: wear.shift[0],
                shift_height_m: wear.shift[1],
                misfit_m: wear.misfit,
                area_m2: wear.area,
                greatest_depth_m: deepest.map(|(_, depth)| depth),
                greatest_depth_x_m: deepest.map(|(place, _)| place.x),
                measures: match &worn.measures {
                    Measures::Wheel { measured, nominal } => MeasuresDocument::Wheel {
                        flange_height_m: measured.flange_height,
                        flange_thickness_m: measured.flange_thickness,
                        flange_gradient_m: measured.flange_gradient,
                        nominal_flange_height_m: nominal.flange_height,
                        nominal_flange_thickness_m: nominal.flange_thickness,
                        nominal_flange_gradient_m: nominal.flange_gradient,
                        tread_wear_m: measured.tread_wear(nominal),
                    },
                    Measures::Rail(rail) => MeasuresDocument::Rail {
                        w1_m: rail.vertical,
                        w2_m: rail.lateral,
                        w3_m: rail.diagonal,
                        gauge_height_m: self.gauge_height,
                    },
                },
                x_m: of(|point| point.nominal.x),
                height_m: of(|point| point.nominal.height),
                depth_m: wear.points.iter().map(|point| point.depth).collect(),
            }
        });
        WearDocument {
            nominal: self.nominal_name.clone(),
            kind: self.kind.name(),
            alignment: alignment_name(self.alignment),
            profiles: profiles.collect(),
            remarks: self.remarks.clone(),
        }
    }

    /// One row for each point of the nominal profile, in mm; depths that are not measured are empty.
    ///
    /// # Errors
    /// Those of the file.
    pub fn csv(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record(["profile", "nominal_x_mm", "nominal_y_mm", "depth_mm"])?;
        for worn in &self.worn {
            for point in &worn.wear.points {
                writer.serialize((
                    &worn.name,
                    1e3 * point.nominal.x,
                    1e3 * point.nominal.height,
                    point.depth.map(|depth| 1e3 * depth),
                ))?;
            }
        }
        writer.flush()
    }

    /// Outlines on the nominal one, and depth over the place across the track.
    pub fn figure(&self) -> LineFigure {
        /// Distance of the points that are drawn \[m\].
        const STEP: f64 = 2.5e-4;
        let outline = |label: &str, profile: &Profile, style: LineStyle| {
            let (x, y) = profile.along(STEP).iter().map(|point| (1e3 * point.x, 1e3 * point.height)).unzip();
            Series { label: label.to_owned(), x, y, style, ..Series::default() }
        };
        let mut outlines = vec![outline(&self.nominal_name, &self.nominal, LineStyle::Dashed)];
        let mut depths = Vec::new();
        for worn in &self.worn {
            outlines.push(outline(&worn.name, &worn.wear.measured, LineStyle::Solid));
            let (x, y) = worn
                .wear
                .points
                .iter()
                .map(|point| (1e3 * point.nominal.x, point.depth.map_or(f64::NAN, |depth| 1e3 * depth)))
                .unzip();
            depths.push(Series { label: worn.name.clone(), x, y, ..Series::default() });
        }
        // The colours of the outlines, of which the nominal one has the first.
        depths.insert(0, Series::default());
        let panel = |label: &str, series: Vec<Series>| LinePanel {
            x_label: "lateral x, field side positive [mm]".to_owned(),
            y_label: label.to_owned(),
            x_scale: Scale::Linear,
            y_scale: Scale::Linear,
            series,
            ..LinePanel::default()
        };
        LineFigure {
            title: format!("Wear {}", self.in_words()),
            caption: "Depth is measured across the nominal profile into the metal; above zero metal is missing."
                .to_owned(),
            panels: vec![panel("height [mm]", outlines), panel("depth [mm]", depths)],
            arrangement: Arrangement::Stacked,
        }
    }
}

/// That a rail does not lie on its field side.
fn of_misfit(name: &str, wear: &ProfileWear) -> Option<Message> {
    /// \[m\]; devices measure to some hundredths of a millimetre.
    const WORTH_A_REMARK: f64 = 1e-4;
    let misfit = wear.misfit.filter(|misfit| *misfit > WORTH_A_REMARK)?;
    let millimetres = 1e3 * misfit;
    Some(say!(rail_worn_on_field_side, name = name, millimetres = fixed(millimetres, 2)))
}
