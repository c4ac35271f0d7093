//! `riffel contact`

use std::io::{self, Write};

use riffel::{
    Carter3d, Complex64, ContactElement, ContactResponse, CreepLaw, Creepages, HalfSpace,
    HalfSpaceRolling, HertzContact, KalkerCoefficients,
};
use riffel_case::{Case, CreepLaws};
use riffel_plot::{
    Arrangement, DEFAULT_PNG_SCALE, LineFigure, LinePanel, LineStyle, OKABE_ITO, Rgb, Scale,
    Series, png,
};
use serde::Serialize;

use crate::arguments::{Contact, positive};
use crate::error::CliError;
use crate::map_figure::polach;
use crate::output::{Progress, print, print_json, print_remarks, table};
use crate::staging::Staging;

pub(crate) fn run(arguments: &Contact) -> miette::Result<()> {
    let case = arguments.case.read()?;
    let patch = Patch::new(&case)?;
    let creepages = creepages(arguments, &patch)?;
    let ratios = ratios(arguments)?;

    let progress = Progress::new("contact", creepages.len() + ratios.len() + 1);
    // First what is refused soonest.
    let response = FrequencyResponse::new(&patch, ratios, &progress)?;
    let curves = CreepCurves::new(&patch, creepages, &progress)?;
    drop(progress);

    if arguments.json {
        print_json(&document(&patch, &curves, &response));
        print_remarks(&case.remarks);
        if arguments.output.is_none() {
            return Ok(());
        }
    }

    let folder = arguments
        .case
        .folder(arguments.output.as_deref(), "contact");
    let mut staging = Staging::new(&folder)?;
    for (name, figure) in [
        ("contact", figure(&case, &patch, &curves, &response)),
        ("patch", patch_figure(&case, &patch)),
    ] {
        let svg = figure.svg().map_err(CliError::from)?;
        let picture = png(&svg, DEFAULT_PNG_SCALE).map_err(CliError::from)?;
        staging.write(&format!("{name}.png"), picture)?;
        staging.write(&format!("{name}.svg"), svg)?;
        let page = figure.html().map_err(CliError::from)?;
        staging.write(&format!("{name}.html"), page)?;
    }
    staging.write_with("creep-curve.csv", |file| curves.table(file))?;
    staging.write_with("frequency-response.csv", |file| response.table(file))?;
    staging.write_with("patch.csv", |file| patch.table(file))?;
    let files = staging.publish()?;
    if !arguments.json {
        let place = format!("{}: {}\n", folder.display(), files.join(" "));
        print(&(readable(&case, &patch, &curves) + &place));
        print_remarks(&case.remarks);
    }
    Ok(())
}

/// The creepages asked for \[-\], or equally spaced ones to beyond full slip.
fn creepages(arguments: &Contact, patch: &Patch) -> Result<Vec<f64>, CliError> {
    const POINTS: u32 = 40;
    const BEYOND_FULL_SLIP: f64 = 1.2;
    if arguments.creepage.is_empty() {
        let last = BEYOND_FULL_SLIP * patch.full_slip_creepage();
        return Ok((1..=POINTS)
            .map(|index| last * f64::from(index) / f64::from(POINTS))
            .collect());
    }
    let given = arguments.creepage.iter();
    given
        .map(|&creepage| positive("--creepage", creepage))
        .collect()
}

/// The wavelengths asked for \[semi-axes\], or some equally spaced in their logarithm.
fn ratios(arguments: &Contact) -> Result<Vec<f64>, CliError> {
    const POINTS: u32 = 30;
    const SHORTEST: f64 = 2.0;
    const LONGEST: f64 = 100.0;
    if arguments.ratio.is_empty() {
        let last = POINTS - 1;
        return Ok((0..POINTS)
            .map(|index| match index {
                0 => SHORTEST,
                _ if index == last => LONGEST,
                _ => SHORTEST * (LONGEST / SHORTEST).powf(f64::from(index) / f64::from(last)),
            })
            .collect());
    }
    let given = arguments.ratio.iter();
    given.map(|&ratio| positive("--ratio", ratio)).collect()
}

/// A refusal of the physics, with what was computed.
fn refused(input: impl Into<String>) -> impl FnOnce(riffel::Error) -> CliError {
    let input = input.into();
    move |error| CliError::Physics { input, error }
}

/// The contact of the case by all theories, and its mean state by the exact one.
struct Patch {
    hertz: HertzContact,
    friction: f64,
    carter: Carter3d,
    laws: CreepLaws,
    half_space: HalfSpace,
    state: HalfSpaceRolling,
}

impl Patch {
    fn new(case: &Case) -> miette::Result<Self> {
        let (hertz, friction) = (case.hertz, case.steady.friction);
        let ratio = case.steady.tractive_ratio();
        if ratio > HalfSpace::LARGEST_TRACTIVE_RATIO {
            Err(CliError::Argument {
                argument: "the tractive ratio of the case",
                value: format!("{ratio:.4}"),
                rule: format!(
                    "at most {} for a frequency response: nearer to full slip the creep curve has no \
                     slope",
                    HalfSpace::LARGEST_TRACTIVE_RATIO
                ),
            })?;
        }
        let carter = Carter3d::from_tractive_ratio(hertz, friction, ratio)
            .map_err(refused("the mean state of the case"))?;
        let laws = case.creep_laws()?;
        let across = usize::try_from(case.file.contact.grid).unwrap_or(usize::MAX);
        let half_space =
            HalfSpace::new(hertz, friction, across).map_err(refused("contact.grid"))?;
        let state = half_space
            .roll_at_tractive_ratio(ratio)
            .map_err(refused("the mean state of the case"))?;
        Ok(Self {
            hertz,
            friction,
            carter,
            laws,
            half_space,
            state,
        })
    }

    /// The larger of the creepages at which Johnson & Vermeulen and the paper see full slip.
    fn full_slip_creepage(&self) -> f64 {
        let law = &self.laws.johnson_vermeulen;
        let by_ellipse = law.limit(self.hertz.normal_force()).creepage();
        by_ellipse.max(self.carter.saturation_creepage())
    }

    fn tractive_ratio(&self, force: f64) -> f64 {
        force / (self.friction * self.hertz.normal_force())
    }

    fn elements(&self) -> impl Iterator<Item = ContactElement> + '_ {
        self.half_space.elements(&self.state)
    }

    fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        writer.write_record([
            "x_m",
            "y_m",
            "traction_longitudinal_pa",
            "traction_lateral_pa",
            "bound_pa",
            "slips",
        ])?;
        for element in self.elements() {
            writer.serialize((
                element.centre,
                element.traction,
                element.bound,
                element.slips,
            ))?;
        }
        writer.flush()
    }
}

/// Tractive ratio against creepage by one law.
struct CreepCurve {
    /// Name in the case file, and key in documents and tables.
    key: &'static str,
    /// Name in the figure.
    label: &'static str,
    style: LineStyle,
    color: Rgb,
    tractive_ratios: Vec<f64>,
}

struct CreepCurves {
    creepages: Vec<f64>,
    laws: Vec<CreepCurve>,
}

impl CreepCurves {
    fn new(patch: &Patch, creepages: Vec<f64>, progress: &Progress) -> Result<Self, CliError> {
        let load = patch.hertz.normal_force();
        let mut exact = Vec::with_capacity(creepages.len());
        for &creepage in &creepages {
            let state = patch.half_space.roll(creepage);
            let state = state.map_err(refused(format!("half-space, creepage {creepage}")))?;
            exact.push(patch.tractive_ratio(state.tangential_force()));
            progress.advance(1);
        }
        let over = |force: &dyn Fn(f64) -> f64| -> Vec<f64> {
            let ratio = |&creepage| patch.tractive_ratio(force(creepage));
            creepages.iter().map(ratio).collect()
        };
        let by = |law: &dyn CreepLaw| {
            over(&|creepage| {
                law.forces(load, Creepages::longitudinal(creepage))
                    .longitudinal
            })
        };
        let curve = |key, label, style, color: usize, tractive_ratios| CreepCurve {
            key,
            label,
            style,
            color: OKABE_ITO[color],
            tractive_ratios,
        };
        use LineStyle::{Dashed, Dotted, Solid};
        let laws = &patch.laws;
        let carter = over(&|creepage| patch.carter.tangential_force(load, creepage));
        let laws = vec![
            curve("carter-3d", "Carter 3D (paper)", Dashed, 1, carter),
            curve("carter-2d", "Carter 2D", Dotted, 6, by(&*laws.carter_2d)),
            curve(
                "johnson-vermeulen",
                "Johnson–Vermeulen",
                Dotted,
                2,
                by(&*laws.johnson_vermeulen),
            ),
            curve(
                "shen-hedrick-elkins",
                "Shen–Hedrick–Elkins",
                Dashed,
                3,
                by(&*laws.shen_hedrick_elkins),
            ),
            curve("polach", "Polach", Solid, 4, by(&*laws.polach)),
            curve("fastsim", "FASTSIM", Solid, 5, by(&*laws.fastsim)),
            curve("half-space", "half-space (exact)", Solid, 0, exact),
        ];
        Ok(Self { creepages, laws })
    }

    fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let mut header = vec!["creepage".to_owned()];
        header.extend(self.laws.iter().map(|law| law.key.replace('-', "_")));
        writer.write_record(&header)?;
        for (index, &creepage) in self.creepages.iter().enumerate() {
            let mut row = vec![creepage];
            row.extend(self.laws.iter().map(|law| law.tractive_ratios[index]));
            writer.serialize(row)?;
        }
        writer.flush()
    }

    fn panel(&self, patch: &Patch) -> LinePanel {
        const TO_PERCENT: f64 = 100.0;
        // Every law begins at the origin.
        let from_origin = |values: &[f64], factor: f64| -> Vec<f64> {
            let values = values.iter().map(|value| factor * value);
            std::iter::once(0.0).chain(values).collect()
        };
        let percent = from_origin(&self.creepages, TO_PERCENT);
        let laws = self.laws.iter().map(|law| Series {
            style: law.style,
            color: Some(law.color),
            ..line(law.label, &percent, &from_origin(&law.tractive_ratios, 1.0))
        });
        let mean_state = Series {
            label: "mean state".to_owned(),
            x: vec![TO_PERCENT * patch.state.creepage()],
            y: vec![patch.tractive_ratio(patch.state.tangential_force())],
            style: LineStyle::Markers,
            color: Some(OKABE_ITO[0]),
        };
        LinePanel {
            subtitle: "steady rolling".to_owned(),
            x_label: "creepage ξ [%]".to_owned(),
            y_label: "tractive ratio Q/μP [-]".to_owned(),
            y_range: Some((0.0, 1.08)),
            series: laws.chain([mean_state]).collect(),
            ..LinePanel::default()
        }
    }
}

/// A curve from left to right, in whichever order its samples were asked for.
fn line(label: &str, x: &[f64], y: &[f64]) -> Series {
    let mut samples: Vec<(f64, f64)> = x.iter().copied().zip(y.iter().copied()).collect();
    samples.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (x, y) = samples.into_iter().unzip();
    Series {
        label: label.to_owned(),
        x,
        y,
        ..Series::default()
    }
}

/// Normalised responses to one input, 1 for long wavelengths.
#[derive(Default)]
struct Outputs {
    force: Vec<Complex64>,
    dissipation: Vec<Complex64>,
    rail_dissipation: Vec<Complex64>,
}

impl Outputs {
    fn push(&mut self, [force, dissipation, rail_dissipation]: [Complex64; 3]) {
        self.force.push(force);
        self.dissipation.push(dissipation);
        self.rail_dissipation.push(rail_dissipation);
    }

    /// The outputs with their keys, names in the figure and colours.
    fn all(&self) -> [(&'static str, &'static str, Rgb, &[Complex64]); 3] {
        [
            ("force", "force", OKABE_ITO[0], &self.force),
            (
                "dissipation",
                "dissipation",
                OKABE_ITO[2],
                &self.dissipation,
            ),
            (
                "rail_dissipation",
                "energy left on rail",
                OKABE_ITO[1],
                &self.rail_dissipation,
            ),
        ]
    }
}

/// Response at each wavelength divided by the quasi-static one.
struct FrequencyResponse {
    ratios: Vec<f64>,
    creepage: Outputs,
    load: Outputs,
}

impl FrequencyResponse {
    fn new(patch: &Patch, ratios: Vec<f64>, progress: &Progress) -> Result<Self, CliError> {
        let at = |wavelength: f64, input: String| -> Result<ContactResponse, CliError> {
            let response = patch.half_space.response(&patch.state, wavelength);
            progress.advance(1);
            response.map_err(refused(input))
        };
        let slow = at(f64::INFINITY, "the mean state of the case".to_owned())?;
        let (mut creepage, mut load) = (Outputs::default(), Outputs::default());
        for &ratio in &ratios {
            let wavelength = ratio * patch.hertz.semi_axis_longitudinal();
            let response = at(wavelength, format!("--ratio {ratio}"))?;
            let rail = response.at_rail(0.0);
            creepage.push([
                response.dq_dxi / slow.dq_dxi,
                response.de_dxi / slow.de_dxi,
                rail.de_dxi / slow.de_dxi,
            ]);
            load.push([
                response.dq_dp / slow.dq_dp,
                response.de_dp / slow.de_dp,
                rail.de_dp / slow.de_dp,
            ]);
        }
        Ok(Self {
            ratios,
            creepage,
            load,
        })
    }

    fn inputs(&self) -> [(&'static str, LineStyle, &Outputs); 2] {
        [
            ("creepage", LineStyle::Solid, &self.creepage),
            ("load", LineStyle::Dashed, &self.load),
        ]
    }

    fn table(&self, file: &mut impl Write) -> io::Result<()> {
        let mut writer = csv::Writer::from_writer(file);
        let inputs = self.inputs();
        let columns: Vec<(String, &[Complex64])> = inputs
            .iter()
            .flat_map(|(input, _, outputs)| {
                let column = |output| format!("{input}_{output}");
                outputs
                    .all()
                    .map(|(output, _, _, values)| (column(output), values))
            })
            .collect();
        let mut header = vec!["wavelength_over_semi_axis".to_owned()];
        let parts = |name: &String| ["re", "im"].map(|part| format!("{name}_{part}"));
        header.extend(columns.iter().flat_map(|(name, _)| parts(name)));
        writer.write_record(&header)?;
        for (index, &ratio) in self.ratios.iter().enumerate() {
            let mut row = vec![ratio];
            row.extend(
                columns
                    .iter()
                    .flat_map(|(_, values)| [values[index].re, values[index].im]),
            );
            writer.serialize(row)?;
        }
        writer.flush()
    }

    /// Modulus and phase against wavelength.
    fn panels(&self) -> [LinePanel; 2] {
        // Names stand in the first of the two panels only.
        let panel = |named: bool, value: &dyn Fn(&[Complex64]) -> Vec<f64>| LinePanel {
            x_label: "wavelength λ/a [-]".to_owned(),
            x_scale: Scale::Log,
            series: self
                .inputs()
                .into_iter()
                .flat_map(|(input, style, outputs)| {
                    outputs.all().map(|(_, output, color, values)| {
                        let label = if named {
                            format!("{output} by {input}")
                        } else {
                            String::new()
                        };
                        Series {
                            style,
                            color: Some(color),
                            ..line(&label, &self.ratios, &value(values))
                        }
                    })
                })
                .collect(),
            ..LinePanel::default()
        };
        let moduli = |values: &[Complex64]| values.iter().map(|value| value.norm()).collect();
        let largest = self
            .inputs()
            .iter()
            .flat_map(|(_, _, outputs)| outputs.all())
            .flat_map(|(_, _, _, values)| values)
            .map(|value| value.norm())
            .fold(0.0, f64::max);
        /// Room for the names above the curves, which end at 1.
        const HIGHEST: f64 = 2.4;
        [
            LinePanel {
                subtitle: "response to small oscillations over quasi-static response".to_owned(),
                y_label: "modulus [-]".to_owned(),
                y_range: Some((0.0, HIGHEST.max(1.05 * largest))),
                ..panel(true, &moduli)
            },
            LinePanel {
                y_label: "phase [°]".to_owned(),
                ..panel(false, &|values| self.phases(values))
            },
        ]
    }

    /// Phases \[°\] that pass ±180° without a jump, from zero at long wavelengths.
    fn phases(&self, values: &[Complex64]) -> Vec<f64> {
        let mut order: Vec<usize> = (0..values.len()).collect();
        order.sort_by(|&a, &b| self.ratios[b].total_cmp(&self.ratios[a]));
        let mut phases = vec![0.0; values.len()];
        let mut previous = 0.0;
        for index in order {
            let phase = values[index].arg().to_degrees();
            let turns = ((previous - phase) / 360.0_f64).round();
            previous = phase + 360.0 * turns;
            phases[index] = previous;
        }
        phases
    }
}

/// `contact --json`.
#[derive(Serialize)]
struct Document {
    semi_axis_longitudinal_m: f64,
    semi_axis_lateral_m: f64,
    approach_m: f64,
    peak_pressure_pa: f64,
    stiffness_n_per_m: f64,
    kalker: KalkerDocument,
    creep_curve: CreepCurveDocument,
    frequency_response: FrequencyResponseDocument,
}

#[derive(Serialize)]
struct KalkerDocument {
    c11: f64,
    c22: f64,
    c23: f64,
    c33: f64,
}

#[derive(Serialize)]
struct CreepCurveDocument {
    creepage: Vec<f64>,
    tractive_ratio: serde_json::Map<String, serde_json::Value>,
}

#[derive(Serialize)]
struct FrequencyResponseDocument {
    wavelength_over_semi_axis: Vec<f64>,
    creepage: serde_json::Map<String, serde_json::Value>,
    load: serde_json::Map<String, serde_json::Value>,
}

fn document(patch: &Patch, curves: &CreepCurves, response: &FrequencyResponse) -> Document {
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let laws = curves
        .laws
        .iter()
        .map(|law| (law.key.to_owned(), law.tractive_ratios.clone().into()));
    let outputs = |outputs: &Outputs| {
        let pairs = |values: &[Complex64]| -> serde_json::Value {
            values
                .iter()
                .map(|value| serde_json::Value::from(vec![value.re, value.im]))
                .collect()
        };
        outputs
            .all()
            .map(|(key, _, _, values)| (key.to_owned(), pairs(values)))
            .into_iter()
            .collect()
    };
    Document {
        semi_axis_longitudinal_m: patch.hertz.semi_axis_longitudinal(),
        semi_axis_lateral_m: patch.hertz.semi_axis_lateral(),
        approach_m: patch.hertz.approach(),
        peak_pressure_pa: patch.hertz.peak_pressure(),
        stiffness_n_per_m: patch.hertz.stiffness(),
        kalker: KalkerDocument { c11, c22, c23, c33 },
        creep_curve: CreepCurveDocument {
            creepage: curves.creepages.clone(),
            tractive_ratio: laws.collect(),
        },
        frequency_response: FrequencyResponseDocument {
            wavelength_over_semi_axis: response.ratios.clone(),
            creepage: outputs(&response.creepage),
            load: outputs(&response.load),
        },
    }
}

/// The parameters of the contact in one sentence.
fn parameters(case: &Case, patch: &Patch) -> String {
    let material = patch.hertz.material();
    format!(
        "E = {:.0} GPa, ν = {}; R = {:.2} m, R_r = {:.2} m, P = {:.0} kN, μ = {}; ellipse {:.2} × {:.2} mm; \
         mean state τ = {:.3}, ξ₀ = {:.4} %; {} elements over a diameter{}.",
        1e-9 * case.file.steel.youngs_modulus.si(),
        material.poisson_ratio(),
        patch.hertz.rolling_radius(),
        case.file.contact.transverse_radius.si(),
        1e-3 * patch.hertz.normal_force(),
        patch.friction,
        2e3 * patch.hertz.semi_axis_longitudinal(),
        2e3 * patch.hertz.semi_axis_lateral(),
        patch.tractive_ratio(patch.state.tangential_force()),
        100.0 * patch.state.creepage(),
        case.file.contact.grid,
        match polach(case).as_str() {
            "" => String::new(),
            words => format!("; Polach{words}"),
        },
    )
}

fn figure(
    case: &Case,
    patch: &Patch,
    curves: &CreepCurves,
    response: &FrequencyResponse,
) -> LineFigure {
    let [modulus, phase] = response.panels();
    LineFigure {
        title: "Rolling contact: creep curves and frequency response".to_owned(),
        caption: format!(
            "Responses of the half-space about its mean state, exp(+iωt); the energy left on the rail is that of \
             the whole passage, relative to the instant at which the wheel centre passes. {}",
            parameters(case, patch)
        ),
        panels: vec![curves.panel(patch), modulus, phase],
        arrangement: Arrangement::Stacked,
    }
}

fn patch_figure(case: &Case, patch: &Patch) -> LineFigure {
    const TO_MILLIMETRES: f64 = 1e3;
    const TO_MEGAPASCALS: f64 = 1e-6;
    /// Height of a panel over its width, so that the ellipse keeps its shape.
    const HEIGHT_OVER_WIDTH: f64 = 200.0 / 450.0;
    const AIR: f64 = 1.12;
    /// Elements over a diameter that can be told apart.
    const MOST_MARKS: u64 = 40;
    /// Number of marks from which a zone is wide.
    const WIDE_ZONE: usize = 150;
    let a = TO_MILLIMETRES * patch.hertz.semi_axis_longitudinal();
    let b = TO_MILLIMETRES * patch.hertz.semi_axis_lateral();
    let half_width = AIR * a.max(b / HEIGHT_OVER_WIDTH);
    let x_range = Some((-half_width, half_width));
    let half_height = half_width * HEIGHT_OVER_WIDTH;
    let x_label = "x along the rail, in the direction of rolling [mm]".to_owned();

    // The number of rows is even: the one just beside the centre line.
    let beside = patch
        .elements()
        .map(|element| element.centre.1)
        .filter(|&y| y > 0.0)
        .fold(f64::INFINITY, f64::min);
    let row: Vec<ContactElement> = patch
        .elements()
        .filter(|element| element.centre.1 == beside)
        .collect();
    // On the edge of the patch the pressure vanishes.
    let x: Vec<f64> = row
        .iter()
        .map(|element| TO_MILLIMETRES * element.centre.0)
        .chain([-a, a])
        .collect();
    let stress = |label, style, value: fn(&ContactElement) -> f64| {
        let y: Vec<f64> = row
            .iter()
            .map(|element| TO_MEGAPASCALS * value(element))
            .chain([0.0, 0.0])
            .collect();
        Series {
            style,
            ..line(label, &x, &y)
        }
    };

    let highest = TO_MEGAPASCALS * patch.friction * patch.hertz.peak_pressure();

    let outline: (Vec<f64>, Vec<f64>) = (0..=180)
        .map(|step| std::f64::consts::TAU * f64::from(step) / 180.0)
        .map(|angle| (a * angle.cos(), b * angle.sin()))
        .unzip();
    let rows = distinct(patch.elements().map(|element| element.centre.1));
    let columns = distinct(patch.elements().map(|element| element.centre.0));
    let every = case.file.contact.grid.div_ceil(MOST_MARKS) as usize;
    let marks = |label: &str, slips: bool, color: usize| {
        // A wide zone is legible with fewer marks.
        let zone = patch.elements().filter(|element| element.slips == slips);
        let every = if zone.count() > WIDE_ZONE * every * every {
            2 * every
        } else {
            every
        };
        let shown = |places: &[f64], place: f64| {
            places
                .binary_search_by(|other| other.total_cmp(&place))
                .is_ok_and(|index| index % every == every / 2)
        };
        let (x, y) = patch
            .elements()
            .filter(|element| element.slips == slips)
            .map(|element| element.centre)
            .filter(|&(x, y)| shown(&columns, x) && shown(&rows, y))
            .map(|(x, y)| (TO_MILLIMETRES * x, TO_MILLIMETRES * y))
            .unzip();
        Series {
            label: label.to_owned(),
            x,
            y,
            style: LineStyle::Markers,
            color: Some(OKABE_ITO[color]),
        }
    };
    LineFigure {
        title: "Contact patch in steady rolling".to_owned(),
        caption: format!(
            "Half-space theory; material enters on the right, at x = +a. {}",
            parameters(case, patch)
        ),
        panels: vec![
            LinePanel {
                subtitle: "tractions on the centre line".to_owned(),
                x_label: x_label.clone(),
                y_label: "traction [MPa]".to_owned(),
                x_range,
                y_range: Some((0.0, 1.25 * highest)),
                series: vec![
                    stress("bound μp", LineStyle::Dashed, |element| element.bound),
                    stress("traction", LineStyle::Solid, |element| element.traction.0),
                ],
                ..LinePanel::default()
            },
            LinePanel {
                subtitle: "where the surfaces stick and slip".to_owned(),
                x_label,
                y_label: "y across the rail [mm]".to_owned(),
                x_range,
                y_range: Some((-half_height, half_height)),
                series: vec![
                    marks("stick", false, 1),
                    marks("slip", true, 2),
                    Series {
                        x: outline.0,
                        y: outline.1,
                        color: Some(OKABE_ITO[0]),
                        ..Series::default()
                    },
                ],
                ..LinePanel::default()
            },
        ],
        arrangement: Arrangement::Stacked,
    }
}

/// Values in ascending order, each once.
fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    values
}

/// The contact for the terminal.
fn readable(case: &Case, patch: &Patch, curves: &CreepCurves) -> String {
    const ROWS: usize = 8;
    let hertz = patch.hertz;
    let KalkerCoefficients { c11, c22, c23, c33 } = patch.laws.kalker;
    let mut text = format!("{}\n", case.file.title.as_deref().unwrap_or("Contact"));
    text.push_str(&format!(
        "ellipse {:.2} mm along and {:.2} mm across the rail, approach {:.1} µm\n\
         peak pressure {:.0} MPa, stiffness {:.0} MN/m\n\
         Kalker's coefficients C₁₁ = {c11:.3}, C₂₂ = {c22:.3}, C₂₃ = {c23:.3}, C₃₃ = {c33:.3}\n\
         mean state by half-space: tractive ratio {:.3} at creepage {:.4} %\n",
        2e3 * hertz.semi_axis_longitudinal(),
        2e3 * hertz.semi_axis_lateral(),
        1e6 * hertz.approach(),
        1e-6 * hertz.peak_pressure(),
        1e-6 * hertz.stiffness(),
        patch.tractive_ratio(patch.state.tangential_force()),
        100.0 * patch.state.creepage(),
    ));
    let mut header = vec!["creepage"];
    header.extend(curves.laws.iter().map(|law| law.key));
    let mut rows = table(&header);
    let count = curves.creepages.len();
    let shown = count.min(ROWS);
    for place in 1..=shown {
        let index = place * count / shown - 1;
        let mut row = vec![format!("{:.4} %", 100.0 * curves.creepages[index])];
        let ratios = curves.laws.iter();
        row.extend(ratios.map(|law| format!("{:.4}", law.tractive_ratios[index])));
        rows.add_row(row);
    }
    text.push_str(&format!("tractive ratio Q/μP\n{rows}\n"));
    text
}
