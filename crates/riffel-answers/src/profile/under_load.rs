//! The contacts of a wheelset pressed on its track by their own profiles.

use riffel::{ElasticMaterial, Rail};
use riffel_case::CurvingCase;
use riffel_curving::profile::{ContactSurface, LoadedContact, WheelsetContact};
use riffel_keys::{Message, fixed, say};
use riffel_plot::{LineFigure, LinePanel, LineStyle, Series};
use serde::Serialize;

use super::or_dash;
use crate::side::side;
use crate::{Answer, AnswerError, Result, Rows, Table};

/// Both contacts of a wheelset under a normal force each, at lateral shifts: serialised, what
/// `riffel profile CASE --wheelset --load P --json` prints.
#[derive(Serialize)]
pub struct UnderLoadAnswer {
    normal_force_n: f64,
    /// By lateral shift, left before right.
    contacts: Vec<ContactDocument>,
    /// Contacts under pressure, the left one and the right one.
    #[serde(skip)]
    pressed: Vec<(WheelsetContact, [Pressed; 2])>,
    /// Of the patches and of the case.
    #[serde(skip)]
    remarks: Vec<Message>,
}

/// A contact on the contact plane and on the rail's own surface; the latter has none if the profile ends there.
struct Pressed {
    flat: LoadedContact,
    conformal: Option<LoadedContact>,
}

/// One contact under load.
#[derive(Serialize)]
struct ContactDocument {
    lateral_shift_m: f64,
    yaw_rad: f64,
    rail: &'static str,
    approach_m: f64,
    stiffness_n_per_m: f64,
    peak_pressure_pa: f64,
    area_m2: f64,
    length_m: f64,
    width_m: f64,
    /// Along and across the contact plane, from where it touches the rail.
    centre_of_pressure_m: [f64; 2],
    /// Along and across, of the ellipse with the second moments of the pressure.
    equivalent_semi_axes_m: [f64; 2],
    /// Turn of the rail from one side of the patch to the other.
    turn_of_rail_rad: Option<f64>,
    /// On the rail, which is curved across, in the place of the contact plane; the width is along its arc. `None` if a profile
    /// ends.
    conformal: Option<ConformalDocument>,
    /// Kik and Piotrowski.
    fast: PatchDocument,
    /// `None` if a curvature at the first touch is not positive.
    hertz: Option<PatchDocument>,
}

/// A patch of another theory at the same place.
#[derive(Serialize)]
struct PatchDocument {
    approach_m: f64,
    peak_pressure_pa: f64,
    area_m2: f64,
    length_m: f64,
    width_m: f64,
}

/// The patch on the curved surface of the rail.
#[derive(Serialize)]
struct ConformalDocument {
    #[serde(flatten)]
    patch: PatchDocument,
    stiffness_n_per_m: f64,
}

const RAILS: [Rail; 2] = [Rail::Left, Rail::Right];

impl UnderLoadAnswer {
    /// Elements of the grid across a patch that is as long as wide.
    const ELEMENTS: usize = CurvingCase::ELEMENTS_UNDER_LOAD;

    /// The wheelset of a case at lateral shifts \[m\] and a yaw \[rad\], each wheel under the normal force \[N\].
    ///
    /// # Errors
    /// [`AnswerError`] for profiles that cannot be read or do not fit, where a wheel has left its rail, and where a contact lies at
    /// the end of a profile.
    pub fn new(case: &CurvingCase, shifts: &[f64], yaw: f64, normal_force: f64) -> Result<Self> {
        let wheelset = case.wheelset_on_track()?;
        let steel: ElasticMaterial = case.steel()?;
        let refused = AnswerError::Profile;
        let mut pressed = Vec::with_capacity(shifts.len());
        let mut rows = Vec::with_capacity(2 * shifts.len());
        for shift in shifts {
            let at = wheelset.contact(*shift, yaw).map_err(refused)?;
            let on = |rail, surface| wheelset.under_load(&at, rail, steel, normal_force, surface, Self::ELEMENTS);
            let under = |rail| {
                Ok::<Pressed, AnswerError>(Pressed {
                    flat: on(rail, ContactSurface::Flat).map_err(refused)?,
                    conformal: on(rail, ContactSurface::Curved).ok(),
                })
            };
            let loaded = [under(Rail::Left)?, under(Rail::Right)?];
            for (rail, loaded) in RAILS.iter().zip(&loaded) {
                rows.push(ContactDocument::new(&at, *rail, loaded)?);
            }
            pressed.push((at, loaded));
        }
        let of_case = case.remarks.iter().cloned().chain(case.remarks_of_profiles()?);
        Ok(Self {
            normal_force_n: normal_force,
            remarks: of_turn(&rows).into_iter().chain(of_case).collect(),
            contacts: rows,
            pressed,
        })
    }

    fn title(&self) -> Message {
        say!(wheels_under_load, load = fixed(1e-3 * self.normal_force_n, 1))
    }

    /// In mm and MPa, for a reader.
    fn patches(&self) -> Table {
        let column = |head, digits: usize, of: &dyn Fn(&ContactDocument) -> Option<f64>| {
            self.contacts.shown(head, |row| or_dash(of(row), digits))
        };
        let peak = |patch: &PatchDocument| 1e-6 * patch.peak_pressure_pa;
        Table {
            name: "patches",
            columns: vec![
                column(say!(shift_column), 1, &|row| Some(1e3 * row.lateral_shift_m)),
                self.contacts.shown(say!(rail_column), |row| side(row.rail)),
                column(say!(length_in_millimetres_column), 1, &|row| Some(1e3 * row.length_m)),
                column(say!(width_in_millimetres_column), 1, &|row| Some(1e3 * row.width_m)),
                column(say!(peak_pressure_column), 0, &|row| Some(1e-6 * row.peak_pressure_pa)),
                column(say!(conformal_pressure_column), 0, &|row| Some(peak(&row.conformal.as_ref()?.patch))),
                column(say!(hertz_pressure_column), 0, &|row| row.hertz.as_ref().map(peak)),
                column(say!(approach_column), 1, &|row| Some(1e6 * row.approach_m)),
                column(say!(stiffness_column), 0, &|row| Some(1e-6 * row.stiffness_n_per_m)),
            ],
        }
    }

    /// Elements under pressure, in SI: shift, rail, place in the contact plane, pressure.
    fn elements(&self) -> Table {
        type Element = (f64, Rail, (f64, f64), f64);
        let elements: Vec<Element> = (self.pressed.iter())
            .flat_map(|(at, loaded)| RAILS.iter().zip(loaded).map(|(rail, loaded)| (at.lateral_shift, *rail, loaded)))
            .flat_map(|(shift, rail, loaded)| {
                loaded.flat.under_pressure().map(move |(place, pressure)| (shift, rail, place, pressure))
            })
            .collect();
        Table {
            name: "contact",
            columns: vec![
                elements.exact("lateral_shift_m", |element| element.0),
                elements.names("rail", |element| element.1.name()),
                elements.exact("x_m", |element| element.2.0),
                elements.exact("y_m", |element| element.2.1),
                elements.exact("pressure_pa", |element| element.3),
            ],
        }
    }

    fn over_shifts(&self) -> Vec<LinePanel> {
        let of = |label: &str, style, rail: Rail, value: &dyn Fn(&ContactDocument) -> f64| {
            let rows = self.contacts.iter();
            let (x, y) =
                rows.filter(|row| row.rail == rail.name()).map(|row| (1e3 * row.lateral_shift_m, value(row))).unzip();
            Series::new(format!("{label}{}", rail.name()), x, y).styled(style)
        };
        let panel = |y_label: &str, series: Vec<Series>| {
            LinePanel::new("lateral shift y, to the right positive [mm]", y_label, series)
        };
        let both = |label: &str, style: LineStyle, value: &dyn Fn(&ContactDocument) -> f64| {
            RAILS.map(|rail| of(label, style, rail, value))
        };
        let peaks = [
            both("exact, ", LineStyle::Solid, &|row| 1e-6 * row.peak_pressure_pa),
            both("Hertz, ", LineStyle::Dashed, &|row| {
                let hertz = row.hertz.as_ref();
                hertz.map_or(f64::NAN, |hertz| 1e-6 * hertz.peak_pressure_pa)
            }),
        ];
        let stiffness = both("", LineStyle::Solid, &|row| 1e-6 * row.stiffness_n_per_m);
        vec![
            panel("peak pressure [MPa]", peaks.into_iter().flatten().collect()),
            panel("contact stiffness [MN/m]", stiffness.into()),
        ]
    }
}

impl Answer for UnderLoadAnswer {
    fn name(&self) -> &'static str {
        "contact"
    }

    fn introduction(&self) -> Vec<Message> {
        vec![self.title()]
    }

    fn tables(&self) -> Vec<Table> {
        vec![self.patches(), self.elements()]
    }

    /// Pressure and outline of both patches at one shift, or peak pressure and stiffness over several.
    fn figure(&self) -> LineFigure {
        let panels = match &self.pressed[..] {
            [(_, loaded)] => {
                let rails = RAILS.iter().zip(loaded);
                rails.flat_map(|(rail, loaded)| of_patch(*rail, loaded)).collect()
            }
            _ => self.over_shifts(),
        };
        LineFigure::new(
            self.title().to_string(),
            "Exact contact of the profiles on their contact plane and on the curved rail (conformal, y \
                      along its arc), the fast patch of Kik and Piotrowski, and Hertz with the \
                       curvatures where the profiles first touch; y across, to the right.",
            panels,
        )
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}

impl ContactDocument {
    fn new(at: &WheelsetContact, rail: Rail, pressed: &Pressed) -> Result<Self> {
        let loaded = &pressed.flat;
        let [length, width] = loaded.size();
        let (state, fast) = (loaded.state(), loaded.fast());
        let [first, last] = fast.ends();
        Ok(Self {
            lateral_shift_m: at.lateral_shift,
            yaw_rad: at.yaw,
            rail: rail.name(),
            approach_m: state.approach(),
            stiffness_n_per_m: loaded.stiffness()?,
            peak_pressure_pa: state.peak_pressure(),
            area_m2: state.contact_area(),
            length_m: length,
            width_m: width,
            centre_of_pressure_m: loaded.centre_of_pressure(),
            equivalent_semi_axes_m: loaded.equivalent_semi_axes(),
            turn_of_rail_rad: loaded.inclination(),
            conformal: match &pressed.conformal {
                Some(conformal) => Some(ConformalDocument::new(conformal)?),
                None => None,
            },
            fast: PatchDocument {
                approach_m: fast.approach,
                peak_pressure_pa: fast.peak_pressure(),
                area_m2: fast.contact_area(),
                length_m: 2.0 * fast.half_length(),
                width_m: last - first,
            },
            hertz: loaded.hertz().map(|hertz| {
                let (a, b) = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
                PatchDocument {
                    approach_m: hertz.approach(),
                    peak_pressure_pa: hertz.peak_pressure(),
                    area_m2: std::f64::consts::PI * a * b,
                    length_m: 2.0 * a,
                    width_m: 2.0 * b,
                }
            }),
        })
    }
}

impl ConformalDocument {
    fn new(loaded: &LoadedContact) -> Result<Self> {
        let (state, [length, width]) = (loaded.state(), loaded.size());
        Ok(Self {
            patch: PatchDocument {
                approach_m: state.approach(),
                peak_pressure_pa: state.peak_pressure(),
                area_m2: state.contact_area(),
                length_m: length,
                width_m: width,
            },
            stiffness_n_per_m: loaded.stiffness()?,
        })
    }
}

/// y across \[m\], largest pressure \[Pa\] and ends along \[m\] of each row of elements, by increasing y.
fn rows_of(loaded: &LoadedContact) -> Vec<(f64, f64, [f64; 2])> {
    let grid = loaded.state().grid();
    // Rows of the grid follow each other.
    let mut rows: Vec<(f64, f64, [f64; 2])> = Vec::new();
    for ((x, y), pressure) in loaded.under_pressure() {
        let ends = [x - 0.5 * grid.dx(), x + 0.5 * grid.dx()];
        match rows.last_mut() {
            Some((row, peak, [low, high])) if (*row - y).abs() < 0.5 * grid.dy() => {
                *peak = peak.max(pressure);
                *low = low.min(ends[0]);
                *high = high.max(ends[1]);
            }
            _ => rows.push((y, pressure, ends)),
        }
    }
    rows
}

/// Largest pressure and outline of a patch over y.
fn of_patch(rail: Rail, pressed: &Pressed) -> [LinePanel; 2] {
    let (loaded, rows) = (&pressed.flat, rows_of(&pressed.flat));
    let y: Vec<f64> = rows.iter().map(|row| 1e3 * row.0).collect();
    let series = |label: &str, style: LineStyle, x: Vec<f64>, y: Vec<f64>| Series::new(label, x, y).styled(style);
    let fast: Vec<[f64; 2]> = loaded.fast().pressures().collect();
    let mut pressures = vec![
        series("exact", LineStyle::Solid, y.clone(), rows.iter().map(|row| 1e-6 * row.1).collect()),
        series(
            "Kik and Piotrowski",
            LineStyle::Dashed,
            fast.iter().map(|[y, _]| 1e3 * y).collect(),
            fast.iter().map(|[_, pressure]| 1e-6 * pressure).collect(),
        ),
    ];
    let outline = loaded.fast().outline();
    let (fast_y, fast_ends): (Vec<f64>, Vec<[f64; 2]>) =
        outline.map(|[y, back, front]| (1e3 * y, [1e3 * back, 1e3 * front])).unzip();
    let around = |y: &[f64], ends: &[[f64; 2]]| -> (Vec<f64>, Vec<f64>) {
        let there = y.iter().copied().zip(ends.iter().map(|ends| ends[1]));
        let back = y.iter().copied().zip(ends.iter().map(|ends| ends[0])).rev();
        let first = y.iter().copied().zip(ends.iter().map(|ends| ends[1])).take(1);
        there.chain(back).chain(first).unzip()
    };
    let ends: Vec<[f64; 2]> = rows.iter().map(|row| row.2.map(|end| 1e3 * end)).collect();
    let (exact_y, exact_x) = around(&y, &ends);
    let (quick_y, quick_x) = around(&fast_y, &fast_ends);
    let mut outlines = vec![
        series("exact", LineStyle::Solid, exact_y, exact_x),
        series("Kik and Piotrowski", LineStyle::Dashed, quick_y, quick_x),
    ];
    if let Some(hertz) = loaded.hertz() {
        const POINTS: u32 = 120;
        let (a, b) = (hertz.semi_axis_longitudinal(), hertz.semi_axis_lateral());
        // Hertz knows no place in the plane under load: drawn about the centre of pressure.
        let [x0, y0] = loaded.centre_of_pressure();
        let turns = (0..=POINTS).map(|index| (std::f64::consts::TAU * f64::from(index) / f64::from(POINTS)).sin_cos());
        let (ellipse_y, ellipse_x) =
            turns.map(|(sine, cosine)| (1e3 * (y0 + b * sine), 1e3 * (x0 + a * cosine))).unzip();
        outlines.push(series("Hertz", LineStyle::Dotted, ellipse_y, ellipse_x));
        let across = (0..=POINTS).map(|index| -1.0 + 2.0 * f64::from(index) / f64::from(POINTS));
        let (hertz_y, hertz_p) = across
            .map(|share| {
                let pressure = hertz.peak_pressure() * (1.0 - share * share).max(0.0).sqrt();
                (1e3 * (y0 + b * share), 1e-6 * pressure)
            })
            .unzip();
        pressures.push(series("Hertz", LineStyle::Dotted, hertz_y, hertz_p));
    }
    if let Some(conformal) = &pressed.conformal {
        let (y, peaks) = rows_of(conformal).into_iter().map(|row| (1e3 * row.0, 1e-6 * row.1)).unzip();
        pressures.push(series("conformal", LineStyle::Markers, y, peaks));
    }
    let panel = |subtitle: String, label: &str, series: Vec<Series>| {
        LinePanel::new("y across [mm]", label, series).titled(subtitle)
    };
    let name = |what: &str| format!("{} rail: {what}", rail.name());
    [panel(name("largest pressure"), "pressure [MPa]", pressures), panel(name("patch"), "x along [mm]", outlines)]
}

/// That a patch is curved.
fn of_turn(rows: &[ContactDocument]) -> Option<Message> {
    /// \[rad\]: half a width over the radius of 0.2, from which on the half-space is no longer a good neighbour of the bodies.
    const FLAT: f64 = 0.4;
    let turns = rows.iter().filter_map(|row| row.turn_of_rail_rad);
    let most = turns.map(f64::abs).fold(0.0, f64::max);
    (most > FLAT).then(|| {
        let degrees = most.to_degrees();
        say!(flat_patch_beyond_range, degrees = fixed(degrees, 0))
    })
}
