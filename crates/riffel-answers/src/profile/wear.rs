//! Wear of profiles against a nominal one.

use std::path::{Path, PathBuf};

use riffel_case::file::Inclination;
use riffel_curving::profile::{
    Profile, ProfileAlignment, ProfileError, ProfileWear, RailWear, WheelDimensions, WornPoint,
};
use riffel_keys::{CaseError, Message, Value, fixed, say};
use riffel_plot::{Arrangement, LineFigure, LinePanel, LineStyle, Series};
use riffel_rail::{ProfileKind, ProfileReading, profile_of};
use serde::{Serialize, Serializer};

use super::or_dash;
use crate::{Answer, Rows, Table};

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

/// Profiles beside a nominal one: serialised, what `riffel profile FILE… --against NAME --json` prints.
#[derive(Serialize)]
pub struct WearAnswer {
    #[serde(rename = "nominal")]
    nominal_name: String,
    #[serde(serialize_with = "kind_name")]
    kind: ProfileKind,
    #[serde(serialize_with = "name_of")]
    alignment: ProfileAlignment,
    profiles: Vec<Worn>,
    /// Of files, and of what is laid on what.
    remarks: Vec<Message>,
    #[serde(skip)]
    nominal: Profile,
}

/// One of them.
#[derive(Serialize)]
struct Worn {
    name: String,
    shift_x_m: f64,
    shift_height_m: f64,
    misfit_m: Option<f64>,
    area_m2: f64,
    greatest_depth_m: Option<f64>,
    greatest_depth_x_m: Option<f64>,
    #[serde(flatten)]
    measures: Measures,
    x_m: Vec<f64>,
    height_m: Vec<f64>,
    depth_m: Vec<Option<f64>>,
    #[serde(skip)]
    measured: Profile,
}

/// The numbers by which wheels and rails are judged.
#[derive(Serialize)]
#[serde(untagged)]
enum Measures {
    /// Dimensions of a wheel, those of the nominal one and how much the tread has lost.
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

fn kind_name<S: Serializer>(kind: &ProfileKind, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(kind.name())
}

fn name_of<S: Serializer>(alignment: &ProfileAlignment, serializer: S) -> Result<S::Ok, S::Error> {
    serializer.serialize_str(alignment_name(*alignment))
}

impl Measures {
    fn of_wheel(measured: &WheelDimensions, nominal: &WheelDimensions) -> Self {
        Self::Wheel {
            flange_height_m: measured.flange_height,
            flange_thickness_m: measured.flange_thickness,
            flange_gradient_m: measured.flange_gradient,
            nominal_flange_height_m: nominal.flange_height,
            nominal_flange_thickness_m: nominal.flange_thickness,
            nominal_flange_gradient_m: nominal.flange_gradient,
            tread_wear_m: measured.tread_wear(nominal),
        }
    }

    fn of_rail(rail: &RailWear, gauge_height_m: f64) -> Self {
        Self::Rail { w1_m: rail.vertical, w2_m: rail.lateral, w3_m: rail.diagonal, gauge_height_m }
    }

    /// Which of them are not told, for nothing is measured where they are taken.
    fn not_measured(&self, name: &str) -> Option<Message> {
        let all = match self {
            Self::Wheel { flange_height_m, flange_thickness_m, flange_gradient_m, .. } => {
                [("Sh", flange_height_m), ("Sd", flange_thickness_m), ("qR", flange_gradient_m)]
            }
            Self::Rail { w1_m, w2_m, w3_m, .. } => [("W1", w1_m), ("W2", w2_m), ("W3", w3_m)],
        };
        let silent = all.iter().filter(|(_, value)| value.is_none());
        let silent: Vec<Value> = silent.map(|(measure, _)| (*measure).into()).collect();
        let count = silent.len();
        (count > 0).then(|| {
            let measures = Value::List(silent);
            say!(measures_not_measured, name, measures, count)
        })
    }

    /// Those that a reader sees, in the order of the columns.
    fn shown(&self) -> Vec<Option<f64>> {
        match *self {
            Self::Wheel { tread_wear_m, flange_height_m, flange_thickness_m, flange_gradient_m, .. } => {
                vec![tread_wear_m, flange_height_m, flange_thickness_m, flange_gradient_m]
            }
            Self::Rail { w1_m, w2_m, w3_m, .. } => vec![w1_m, w2_m, w3_m],
        }
    }
}

impl Worn {
    fn new(name: String, wear: ProfileWear, measures: Measures) -> Self {
        let of = |value: fn(&WornPoint) -> f64| wear.points.iter().map(value).collect();
        let deepest = wear.deepest();
        Self {
            shift_x_m: wear.shift[0],
            shift_height_m: wear.shift[1],
            misfit_m: wear.misfit,
            area_m2: wear.area,
            greatest_depth_m: deepest.map(|(_, depth)| depth),
            greatest_depth_x_m: deepest.map(|(place, _)| place.x),
            x_m: of(|point| point.nominal.x),
            height_m: of(|point| point.nominal.height),
            depth_m: wear.points.iter().map(|point| point.depth).collect(),
            measured: wear.measured,
            name,
            measures,
        }
    }
}

/// The name of an alignment on the command line and in Python.
pub fn alignment_name(alignment: ProfileAlignment) -> &'static str {
    match alignment {
        ProfileAlignment::AsWritten => "as-written",
        ProfileAlignment::Flange => "flange",
        ProfileAlignment::FieldSide => "field-side",
    }
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
                true => Measures::of_wheel(
                    &WheelDimensions::new(&wear.measured, back).map_err(refuse)?,
                    &WheelDimensions::new(&nominal, back).map_err(refuse)?,
                ),
                false => {
                    let rail = RailWear::new(&wear, &nominal, settings.gauge_height);
                    Measures::of_rail(&rail, settings.gauge_height)
                }
            };
            remarks.extend(of_misfit(&name, &wear));
            remarks.extend(measures.not_measured(&name));
            worn.push(Worn::new(name, wear, measures));
        }
        Ok(Self { nominal_name: nominal_name.to_owned(), nominal, kind, alignment, profiles: worn, remarks })
    }

    /// By what they lie on the nominal profile.
    fn title(&self) -> Message {
        let nominal = &self.nominal_name;
        match self.alignment {
            ProfileAlignment::AsWritten => say!(wear_as_written, nominal),
            ProfileAlignment::Flange => say!(wear_laid_by_flange, nominal),
            ProfileAlignment::FieldSide => say!(wear_laid_by_field_side, nominal),
        }
    }

    /// In mm, for a reader.
    fn measures(&self) -> Table {
        let worn = &self.profiles;
        let name = match self.kind {
            ProfileKind::Wheel => say!(wheel_column),
            ProfileKind::Rail => say!(rail_column),
        };
        let heads = match self.kind {
            ProfileKind::Wheel => vec![
                say!(tread_wear_column),
                say!(flange_height_column),
                say!(flange_thickness_column),
                Message::verbatim("qR mm"),
            ],
            ProfileKind::Rail => vec![say!(w1_column), say!(w2_column), say!(w3_column)],
        };
        let millimetres = |length: Option<f64>| or_dash(length.map(|length| 1e3 * length), 2);
        let measures = heads.into_iter().enumerate();
        let measures = measures.map(|(index, head)| worn.shown(head, |worn| millimetres(worn.measures.shown()[index])));
        let after = [
            worn.shown(say!(deepest_column), |worn| millimetres(worn.greatest_depth_m)),
            worn.shown(say!(area_column), |worn| or_dash(Some(1e6 * worn.area_m2), 1)),
        ];
        let names = worn.shown(name, |worn| Message::verbatim(&worn.name));
        Table { name: "measures", columns: [names].into_iter().chain(measures).chain(after).collect() }
    }

    /// One row for each point of the nominal profile, in mm; depths that are not measured are empty.
    fn depths(&self) -> Table {
        let points = self.profiles.iter().flat_map(|worn| (0..worn.x_m.len()).map(move |place| (worn, place)));
        let points: Vec<(&Worn, usize)> = points.collect();
        Table {
            name: "wear",
            columns: vec![
                points.names("profile", |(worn, _)| &worn.name),
                points.exact("nominal_x_mm", |(worn, place)| 1e3 * worn.x_m[*place]),
                points.exact("nominal_y_mm", |(worn, place)| 1e3 * worn.height_m[*place]),
                points.exact("depth_mm", |(worn, place)| Some(1e3 * worn.depth_m[*place]?)),
            ],
        }
    }
}

impl Answer for WearAnswer {
    fn name(&self) -> &'static str {
        "wear"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![self.title()]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.measures(), self.depths()]
    }

    /// Outlines on the nominal one, and depth over the place across the track.
    fn figure(&self) -> LineFigure {
        /// Distance of the points that are drawn \[m\].
        const STEP: f64 = 2.5e-4;
        let outline = |label: &str, profile: &Profile, style: LineStyle| {
            let (x, y) = profile.along(STEP).iter().map(|point| (1e3 * point.x, 1e3 * point.height)).unzip();
            Series::new(label, x, y).styled(style)
        };
        let mut outlines = vec![outline(&self.nominal_name, &self.nominal, LineStyle::Dashed)];
        let mut depths = Vec::new();
        for worn in &self.profiles {
            outlines.push(outline(&worn.name, &worn.measured, LineStyle::Solid));
            let x = worn.x_m.iter().map(|x| 1e3 * x).collect();
            let y = worn.depth_m.iter().map(|depth| depth.map_or(f64::NAN, |depth| 1e3 * depth)).collect();
            depths.push(Series::new(worn.name.clone(), x, y));
        }
        // The colours of the outlines, of which the nominal one has the first.
        depths.insert(0, Series::default());
        let panel =
            |label: &str, series: Vec<Series>| LinePanel::new("lateral x, field side positive [mm]", label, series);
        LineFigure::new(
            self.title().to_string(),
            "Depth is measured across the nominal profile into the metal; above zero metal is missing.",
            [panel("height [mm]", outlines), panel("depth [mm]", depths)],
        )
        .arranged(Arrangement::Stacked)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

/// That a rail does not lie on its field side.
fn of_misfit(name: &str, wear: &ProfileWear) -> Option<Message> {
    /// \[m\]; devices measure to some hundredths of a millimetre.
    const WORTH_A_REMARK: f64 = 1e-4;
    let misfit = wear.misfit.filter(|misfit| *misfit > WORTH_A_REMARK)?;
    let millimetres = 1e3 * misfit;
    Some(say!(rail_worn_on_field_side, name, millimetres = fixed(millimetres, 2)))
}
