//! Stress in the rail under a rolling and sliding contact.

mod contour;

pub(crate) use contour::contour;
mod figure;
mod point_in_rail;
mod tables;

use riffel::damage::stress::{Depth, EllipseStress, StressMaximum, StressMeasure, Traction};
use riffel_case::CaseContact;
use riffel_keys::{CaseError, Message, number, say};
use riffel_plot::LineFigure;
use serde::Serialize;

pub(crate) use point_in_rail::PointInRail;

use crate::{Answer, Table};

/// Stress under the contact of a case: serialised, what `riffel contact --stress --json` prints.
#[derive(Debug, Serialize)]
pub struct StressAnswer {
    #[serde(skip)]
    title: Option<String>,
    /// Semi-axis along the rail.
    pub semi_axis_longitudinal_m: f64,
    /// Semi-axis across it.
    pub semi_axis_lateral_m: f64,
    /// p₀.
    pub peak_pressure_pa: f64,
    /// Coefficient of friction.
    pub friction: f64,
    /// |Q|/μP of the mean state.
    pub tractive_ratio: f64,
    /// Direction of the force on the rail along and across it; forward in braking.
    pub direction: [f64; 2],
    /// Stresses in p₀, x and z in a, y in b.
    pub stress: StressDocument,
    /// What the reader should know.
    pub remarks: Vec<Message>,
    #[serde(skip)]
    ellipse: EllipseStress,
    /// By name.
    #[serde(skip)]
    tractions: Vec<(&'static str, Traction)>,
}

/// Largest stresses, and stress at points.
#[derive(Debug, Serialize)]
pub struct StressDocument {
    /// Of each measure, in full and in partial slip and by the exact theory where the case takes that, at the surface and below.
    pub maxima: Vec<StressMaximumDocument>,
    /// The largest von Mises stress in full slip over the coefficient of friction.
    pub over_friction: Vec<FrictionRow>,
    /// Points that were asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub points: Vec<StressPoint>,
}

/// A largest stress.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct StressMaximumDocument {
    /// full-slip, partial-slip, half-space.
    pub traction: &'static str,
    /// von-mises, tresca.
    pub measure: &'static str,
    /// surface, subsurface.
    #[serde(rename = "where")]
    pub depth: &'static str,
    /// Over p₀; the largest shear stress by Tresca.
    pub value_over_p0: f64,
    /// Stress in Pa.
    pub value_pa: f64,
    /// Place.
    pub x_over_a: f64,
    /// Place.
    pub y_over_b: f64,
    /// Place.
    pub z_over_a: f64,
    /// Whether one below the surface lies where the search begins, and so is the surface's.
    pub at_search_floor: bool,
}

/// Largest von Mises stress over p₀ at one friction.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct FrictionRow {
    /// μ.
    pub friction: f64,
    /// At the surface.
    pub surface_over_p0: f64,
    /// Below it.
    pub subsurface_over_p0: f64,
    /// Whether that lies where the search begins, and so is the surface's.
    pub at_search_floor: bool,
}

/// Stress at a point, xx, yy, zz, xy, yz, zx over p₀.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct StressPoint {
    /// Place.
    pub x_over_a: f64,
    /// Place.
    pub y_over_b: f64,
    /// Place, into the rail.
    pub z_over_a: f64,
    /// By pressure.
    pub normal_over_p0: [f64; 6],
    /// By a traction q_x = p.
    pub tangential_over_p0: [f64; 6],
}

impl StressAnswer {
    /// Stress under the contact of a case, and at points x/a, y/b, z/a.
    ///
    /// # Errors
    /// [`CaseError`] where the mean state is that of the exact theory, and that does not converge.
    pub fn new(contact: &CaseContact, points: &[[f64; 3]]) -> Result<Self, CaseError> {
        let hertz = contact.hertz;
        let steady = contact.steady()?;
        let rolling = steady.rolling;
        let forces = [rolling.forces.longitudinal, rolling.forces.lateral];
        let size = forces[0].hypot(forces[1]);
        let direction = match size > 0.0 {
            true => forces.map(|force| force / size),
            false => [1.0, 0.0],
        };
        let ratio = hertz.semi_axis_longitudinal() / hertz.semi_axis_lateral();
        let ellipse = EllipseStress::of_ratio(ratio, hertz.material().poisson_ratio());
        let (friction, tractive_ratio) = (contact.friction(), rolling.tractive_ratio());
        let mut tractions = vec![
            ("full-slip", Traction::full_slip(friction, direction)),
            ("partial-slip", Traction::partial_slip(friction, direction, tractive_ratio)),
        ];
        // The exact theory where the case takes it, or has creepages of more than one axis.
        let has_law = contact.law.is_some() && !contact.is_non_steady();
        if !has_law || contact.vector_creepage().is_some() {
            let half_space = contact.half_space()?;
            let state = contact.exact(&half_space)?;
            tractions.push(("half-space", Traction::half_space(&half_space, &state)));
        }
        let mut remarks = contact.remarks.clone();
        if !(0.3..=3.0).contains(&ratio) {
            remarks.push(say!(stress_beyond_ratio));
        }
        if friction > 0.6 {
            remarks.push(say!(stress_beyond_friction));
        }
        let maxima = maxima(&ellipse, &tractions, hertz.peak_pressure());
        if maxima.iter().any(|row| row.at_search_floor) {
            let depth = number(StressMaximum::FLOOR);
            remarks.push(say!(stress_has_no_maximum_below, depth));
        }
        Ok(Self {
            title: contact.file.title.clone(),
            semi_axis_longitudinal_m: hertz.semi_axis_longitudinal(),
            semi_axis_lateral_m: hertz.semi_axis_lateral(),
            peak_pressure_pa: hertz.peak_pressure(),
            friction,
            tractive_ratio,
            direction,
            stress: StressDocument {
                maxima,
                over_friction: over_friction(&ellipse, direction),
                points: points
                    .iter()
                    .map(|&[x, y, z]| {
                        let unit = ellipse.at([x, y, z]);
                        StressPoint {
                            x_over_a: x,
                            y_over_b: y,
                            z_over_a: z,
                            normal_over_p0: unit.normal,
                            tangential_over_p0: unit.along,
                        }
                    })
                    .collect(),
            },
            remarks,
            ellipse,
            tractions,
        })
    }
}

fn maxima(
    ellipse: &EllipseStress,
    tractions: &[(&'static str, Traction)],
    pressure: f64,
) -> Vec<StressMaximumDocument> {
    use rayon::prelude::*;
    let mut asked = Vec::new();
    for (name, traction) in tractions {
        for measure in StressMeasure::ALL {
            for depth in Depth::ALL {
                asked.push((*name, traction, measure, depth));
            }
        }
    }
    let found = asked.par_iter().map(|&(name, traction, measure, depth)| {
        let found = StressMaximum::find(ellipse, traction, measure, depth);
        let [x, y, z] = found.place;
        StressMaximumDocument {
            traction: name,
            measure: measure.name(),
            depth: depth.name(),
            value_over_p0: found.value,
            value_pa: found.value * pressure,
            x_over_a: x,
            y_over_b: y,
            z_over_a: z,
            at_search_floor: found.is_at_floor(ellipse),
        }
    });
    found.collect()
}

fn over_friction(ellipse: &EllipseStress, direction: [f64; 2]) -> Vec<FrictionRow> {
    use rayon::prelude::*;
    let rows = (0..=12).into_par_iter().map(|step| {
        let friction = 0.05 * f64::from(step);
        let traction = Traction::full_slip(friction, direction);
        let of = |depth| StressMaximum::find(ellipse, &traction, StressMeasure::VonMises, depth);
        let below = of(Depth::Below);
        FrictionRow {
            friction,
            surface_over_p0: of(Depth::Surface).value,
            subsurface_over_p0: below.value,
            at_search_floor: below.is_at_floor(ellipse),
        }
    });
    rows.collect()
}

impl Answer for StressAnswer {
    fn name(&self) -> &'static str {
        "stress"
    }

    fn introduction(&self) -> Vec<Message> {
        tables::introduction(self)
    }

    fn tables(&self) -> Vec<Table> {
        tables::tables(self)
    }

    fn sentences(&self) -> Vec<Message> {
        Vec::new()
    }

    fn figure(&self) -> LineFigure {
        figure::figure(self)
    }

    fn remarks(&self) -> &[Message] {
        &self.remarks
    }
}
