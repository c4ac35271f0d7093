//! The contact of a wheel and its rail under load.

mod overlap;

use overlap::{Overlap, ends_of, grid_over};
use riffel::contact::{
    ContactBody, ContactGrid, CreepForces, Creepages, EllipticContact, GapStrip, NormalContact, NormalState,
    PatchRolling, PenetrationState, VirtualPenetration,
};
use riffel::{ElasticMaterial, Error, Rail};

use super::contact_surface::PatchSurface;
use super::{ContactGap, ContactSurface, ProfileError, ShapeFault, WheelsetContact, WheelsetOnTrack};

/// The grid reaches to where the gap is this share of the approach of the fast patch \[-\]; the patch itself ends before
/// the gap is the approach. Should it come near the rim, the next one is tried.
const REACHES: [f64; 4] = [0.85, 1.1, 1.6, 2.5];
/// Elements that stay free at the rim: room for the grid of half as many and for the load of [`CHANGE_OF_LOAD`].
const FREE: f64 = 2.5;
/// Elements of the grid that tells the place of the contact plane.
const FIRST_ELEMENTS: usize = 24;
/// Change of the load for the stiffness \[-\]: the truncation of central differences is 1e-4 of it.
const CHANGE_OF_LOAD: f64 = 0.05;

/// Normal contact of a wheel and its rail under load: exact on the undeformed gap of their profiles, and beside it Hertz
/// with the curvatures where they first touch, and the fast patch of Kik & Piotrowski.
///
/// The contact plane touches the rail in the centre of the overlap of the undeformed profiles, weighted by its depth, at
/// the approach of the fast patch: where curvatures are alike it lies millimetres from the place of first touch, and
/// inclined otherwise. x points along the track, y across it in the contact plane, to the right; on a curved surface y is the
/// length across the rail, which begins where the plane touches it.
///
/// Method: [`ContactGap`], on it [`NormalContact`], elements nearly square. Accuracy with 48 elements: approach 0.05 %, peak
/// pressure 0.3 %, stiffness 0.3 %, area 3 % (test `a_wheel_of_circles_is_that_of_hertz`); the places of Manchester's profiles
/// against CONTACT: the book, chapter *Normal contact*. Cost: that of [`NormalContact`] on 24 and on n elements. Range of validity: that of [`NormalContact`]; on
/// the flat surface patches over which the rail turns little, see [`inclination`](Self::inclination), on the curved one what
/// [`NormalContact::curved`] tells.
pub struct LoadedContact {
    material: ElasticMaterial,
    gap: ContactGap,
    surface: PatchSurface,
    /// Middle of the grid on the surface \[m\].
    middle: [f64; 2],
    /// \[m\].
    rolling_radius: f64,
    contact: NormalContact,
    state: NormalState,
    fast: PenetrationState,
    hertz: Option<EllipticContact>,
}

impl WheelsetOnTrack {
    /// The contact on one rail of a wheelset that touches there, under the normal force P \[N\], on a surface; both bodies are of
    /// one material. The grid has n² elements of about one size, n across a patch that is as long as wide, from 16 to 200.
    ///
    /// # Errors
    /// [`ProfileError::Shape`] where the contact lies at the end of a profile, [`ProfileError::Contact`] for a force that is not
    /// positive, a number of elements out of range, and a contact that does not converge.
    pub fn under_load(
        &self,
        contact: &WheelsetContact,
        rail: Rail,
        material: ElasticMaterial,
        normal_force: f64,
        surface: ContactSurface,
        elements: usize,
    ) -> Result<LoadedContact, ProfileError> {
        check_elements(elements)?;
        let on = &contact.contacts[match rail {
            Rail::Left => 0,
            Rail::Right => 1,
        }];
        let touch = [on.on_track[0], rail.sign() * on.on_track[1]];
        let hertz = || {
            let along = on.contact_angle.cos() / on.rolling_radius;
            let wheel = ContactBody { material, longitudinal_curvature: along, lateral_curvature: -on.wheel_curvature };
            let rail = ContactBody { material, longitudinal_curvature: 0.0, lateral_curvature: on.rail_curvature };
            EllipticContact::new([wheel, rail], normal_force).ok()
        };
        // The plane where they first touch tells the approach, and that the place of the plane under load.
        let first = self.gap_at(contact, rail, touch, None)?;
        let about = Guess::new(&first, material, normal_force, on.rolling_radius)?;
        let approach = about.solve(&first, ContactSurface::Flat, FIRST_ELEMENTS)?.state.approach();
        let overlap = Overlap::new(&first, &about.strips, approach);
        let place = first.on_rail(overlap.y).ok_or(ProfileError::Shape(ShapeFault::BeyondEnd(rail)))?;
        let place = [touch[0] + overlap.x, place];
        let gap = self.gap_at(contact, rail, place, Some(overlap.inclination))?;
        let guess = Guess::new(&gap, material, normal_force, on.rolling_radius)?;
        let Solved { surface, middle, contact, state } = guess.solve(&gap, surface, elements)?;
        Ok(LoadedContact {
            material,
            gap,
            surface,
            middle,
            rolling_radius: on.rolling_radius,
            contact,
            state,
            fast: guess.fast,
            hertz: hertz(),
        })
    }
}

/// What the strips of a gap tell before the exact contact.
struct Guess {
    material: ElasticMaterial,
    normal_force: f64,
    /// Strips of the gap, as far as the grid may reach.
    strips: Vec<GapStrip>,
    fast: PenetrationState,
}

/// How often more of the profiles is taken for a first guess; each time at least a fifth more.
const MOST_LIMITS: usize = 60;

impl Guess {
    /// `radius` is that of the wheel \[m\].
    fn new(gap: &ContactGap, material: ElasticMaterial, normal_force: f64, radius: f64) -> Result<Self, Error> {
        Error::unless_positive("normal load", normal_force, "N")?;
        // The approach of a sphere; sharper edges take more, by the cube root of their radius.
        let modulus = material.youngs_modulus() / (2.0 * (1.0 - material.poisson_ratio().powi(2)));
        let sphere = (9.0 * normal_force.powi(2) / (16.0 * modulus.powi(2) * radius)).cbrt();
        let mut limit = 4.0 * sphere;
        for _ in 0..MOST_LIMITS {
            let strips = gap.strips(limit);
            let fast = VirtualPenetration::new([material; 2], strips.clone())?.under_load(normal_force)?;
            let furthest = REACHES[REACHES.len() - 1] * fast.approach;
            if furthest <= limit {
                return Ok(Self { material, normal_force, strips, fast });
            }
            limit = 1.2 * furthest;
        }
        Err(Error::NotConverged {
            problem: "the approach of wheel and rail",
            residual: limit,
            tolerance: sphere,
            remedy: "the profiles may have no contact at this place",
        })
    }

    fn solve(&self, gap: &ContactGap, surface: ContactSurface, elements: usize) -> Result<Solved, Error> {
        let mut failed = None;
        for reach in REACHES {
            let [along, across] = ends_of(&self.strips, reach * self.fast.approach);
            let surface = PatchSurface::new(surface, gap, across);
            let across = across.map(|y| surface.length_of(y));
            let (grid, middle) = grid_over([along, across], elements)?;
            let contact = normal_contact(gap, &surface, self.material, grid, middle)?;
            let near = VirtualPenetration::PENETRATION * self.fast.approach;
            match contact.under_load_near(self.normal_force, Some(near)) {
                Ok(state) if is_free(&state) => {
                    return Ok(Solved { surface, middle, contact, state });
                }
                Ok(state) => {
                    let grid = state.grid();
                    failed = Some(Error::GridTooSmall {
                        length: grid.columns() as f64 * grid.dx(),
                        width: grid.rows() as f64 * grid.dy(),
                    });
                }
                Err(error @ Error::GridTooSmall { .. }) => failed = Some(error),
                Err(error) => return Err(error),
            }
        }
        Err(failed.unwrap_or(Error::GridTooSmall { length: 0.0, width: 0.0 }))
    }
}

/// The contact on a grid and its solution.
struct Solved {
    surface: PatchSurface,
    /// Of the grid \[m\].
    middle: [f64; 2],
    contact: NormalContact,
    state: NormalState,
}

/// Whether the elements at the rim are free of pressure.
fn is_free(state: &NormalState) -> bool {
    let grid = state.grid();
    let [columns, rows] = [grid.columns(), grid.rows()].map(|count| count as f64);
    let at_rim = |index: usize| {
        let (row, column) = (index / grid.columns(), index % grid.columns());
        let (row, column) = (row as f64 + 0.5, column as f64 + 0.5);
        row.min(rows - row) < FREE || column.min(columns - column) < FREE
    };
    let mut elements = state.pressures().iter().enumerate();
    !elements.any(|(index, pressure)| *pressure > 0.0 && at_rim(index))
}

fn check_elements(elements: usize) -> Result<(), Error> {
    if (16..=200).contains(&elements) {
        return Ok(());
    }
    Err(Error::OutOfRange {
        quantity: "number of elements across the contact",
        value: elements as f64,
        unit: "",
        rule: "must be between 16 and 200",
    })
}

/// The exact contact on a grid with its middle at a place of the surface.
fn normal_contact(
    gap: &ContactGap,
    surface: &PatchSurface,
    material: ElasticMaterial,
    grid: ContactGrid,
    [along, across]: [f64; 2],
) -> Result<NormalContact, Error> {
    let materials = [material; 2];
    if let PatchSurface::Flat = surface {
        return NormalContact::new(materials, grid, |x, y| gap.at(x + along, y + across));
    }
    let rows = grid.rows();
    let first = -0.5 * (rows as f64 - 1.0) * grid.dy();
    NormalContact::curved(
        materials,
        grid,
        |x, y| gap.along_normal(x + along, surface.at(y + across).y),
        |row| surface.at(first + row as f64 * grid.dy() + across).inclination,
    )
}

impl LoadedContact {
    /// The gap of the profiles, and the plane of the contact.
    pub fn gap(&self) -> &ContactGap {
        &self.gap
    }

    /// Pressures on the grid, whose middle lies at [`middle`](Self::middle).
    pub fn state(&self) -> &NormalState {
        &self.state
    }

    /// Middle of the grid on the surface, along and across \[m\].
    pub fn middle(&self) -> [f64; 2] {
        self.middle
    }

    /// The patch after Kik & Piotrowski.
    pub fn fast(&self) -> &PenetrationState {
        &self.fast
    }

    /// The ellipse of the curvatures where the profiles first touch; `None` if one of them is not positive.
    pub fn hertz(&self) -> Option<&EllipticContact> {
        self.hertz.as_ref()
    }

    /// Length and width of the patch \[m\]; each to one element.
    pub fn size(&self) -> [f64; 2] {
        self.ends().map(|[low, high]| high - low)
    }

    /// First and last x and y of the elements under pressure \[m\].
    pub fn ends(&self) -> [[f64; 2]; 2] {
        let grid = self.state.grid();
        let mut ends = [[f64::INFINITY, f64::NEG_INFINITY]; 2];
        for ((x, y), _) in self.under_pressure() {
            for (ends, (place, step)) in ends.iter_mut().zip([(x, grid.dx()), (y, grid.dy())]) {
                *ends = [ends[0].min(place - 0.5 * step), ends[1].max(place + 0.5 * step)];
            }
        }
        ends
    }

    /// Centres \[m\] and pressures \[Pa\] of the elements under pressure.
    pub fn under_pressure(&self) -> impl Iterator<Item = ((f64, f64), f64)> + '_ {
        let [along, across] = self.middle;
        let elements = self.state.grid().centres().zip(self.state.pressures());
        elements
            .filter(|(_, pressure)| **pressure > 0.0)
            .map(move |((x, y), &pressure)| ((x + along, y + across), pressure))
    }

    /// Centre of pressure, along and across \[m\].
    pub fn centre_of_pressure(&self) -> [f64; 2] {
        let mut sums = [0.0; 3];
        for ((x, y), pressure) in self.under_pressure() {
            sums[0] += pressure;
            sums[1] += pressure * x;
            sums[2] += pressure * y;
        }
        [sums[1] / sums[0], sums[2] / sums[0]]
    }

    /// Semi-axes along and across of the ellipse whose Hertz pressure has the second moments of this one \[m\]:
    /// a² = 5 ∬ p x²/P about the centre of pressure.
    pub fn equivalent_semi_axes(&self) -> [f64; 2] {
        let [along, across] = self.centre_of_pressure();
        let mut sums = [0.0; 3];
        for ((x, y), pressure) in self.under_pressure() {
            sums[0] += pressure;
            sums[1] += pressure * (x - along).powi(2);
            sums[2] += pressure * (y - across).powi(2);
        }
        [1, 2].map(|moment| (5.0 * sums[moment] / sums[0]).sqrt())
    }

    /// Turn of the rail from one side of the patch to the other \[rad\], which a flat patch leaves out.
    pub fn inclination(&self) -> Option<f64> {
        let grid = self.state.grid();
        let [_, [low, high]] = self.ends();
        // Within the outermost elements, where the pressure has vanished.
        let ends = [low + 0.5 * grid.dy(), high - 0.5 * grid.dy()];
        self.gap.inclination_over(ends.map(|length| self.surface.at(length).y))
    }

    /// Contact stiffness dP/dδ \[N/m\], the wheelset where it is, by central differences over ±5 % of the load. Cost: twice
    /// that of the contact.
    ///
    /// # Errors
    /// [`Error::NotConverged`], [`Error::GridTooSmall`].
    pub fn stiffness(&self) -> Result<f64, Error> {
        let load = self.state.load();
        let near = Some(VirtualPenetration::PENETRATION * self.state.approach());
        let at = |share: f64| {
            let state = self.contact.under_load_near(share * load, near)?;
            Ok::<f64, Error>(state.approach())
        };
        let change = at(1.0 + CHANGE_OF_LOAD)? - at(1.0 - CHANGE_OF_LOAD)?;
        Ok(2.0 * CHANGE_OF_LOAD * load / change)
    }

    /// Steady rolling on the patch, exact: creep forces in the contact plane \[N\] and their moment about its normal in its origin
    /// \[Nm\]. Creepages are those of the rigid bodies in that origin; `friction` is μ \[-\] at a place of the surface \[m\].
    ///
    /// On a curved surface wheel and rail slip at a place that lies d below the plane and is inclined by α to it with
    /// ξ − φy − d cos γ/r along, since the wheel is larger there, and η cos α + (φ cos α ∓ sin α cos γ/r) x across, upper sign on
    /// the right rail, since it spins by its own inclination. Displacements under tractions are those of the flat patch: α²/2 of
    /// the elastic ones is left out, and the normal displacement by tractions across.
    ///
    /// Method: [`PatchRolling`] on the grid and on one of half as many elements, 2·fine − coarse.
    ///
    /// # Errors
    /// [`Error::OutOfRange`] if a coefficient of friction is not positive, [`Error::NotConverged`].
    pub fn roll(&self, creepages: Creepages, friction: impl Fn(f64, f64) -> f64) -> Result<(CreepForces, f64), Error> {
        let [along, across] = self.middle;
        let on = |state: &NormalState| {
            let friction = |x: f64, y: f64| friction(x + along, y + across);
            let rolling = PatchRolling::new(self.material, state, friction)?;
            let mut sums = [0.0; 3];
            for ((x, y), [longitudinal, lateral]) in
                rolling.roll(|x, y| self.rigid_slip(creepages, x + along, y + across))?.forces()
            {
                let (x, place) = (x + along, self.surface.at(y + across));
                let lateral = lateral * place.inclination.cos();
                let moment = x * lateral - place.y * longitudinal;
                for (sum, part) in sums.iter_mut().zip([longitudinal, lateral, moment]) {
                    *sum += part;
                }
            }
            Ok::<[f64; 3], Error>(sums)
        };
        let grid = self.state.grid();
        let half = ContactGrid::new(grid.columns() / 2, grid.rows() / 2, 2.0 * grid.dx(), 2.0 * grid.dy())?;
        let near = VirtualPenetration::PENETRATION * self.state.approach();
        let coarse = normal_contact(&self.gap, &self.surface, self.material, half, self.middle)?
            .under_load_near(self.state.load(), Some(near))?;
        let (fine, coarse) = (on(&self.state)?, on(&coarse)?);
        let [longitudinal, lateral, moment] = [0, 1, 2].map(|part| 2.0 * fine[part] - coarse[part]);
        Ok((CreepForces { longitudinal, lateral }, moment))
    }

    /// Slip of the rigid bodies along and across the surface per metre rolled at a place of it, see [`roll`](Self::roll).
    fn rigid_slip(&self, creepages: Creepages, x: f64, y: f64) -> [f64; 2] {
        // Rotation of the wheel about the line across the plane.
        let rolling = self.gap.contact_angle().cos() / self.rolling_radius;
        let place = self.surface.at(y);
        let (sine, cosine) = place.inclination.sin_cos();
        let [longitudinal, lateral] = creepages.rigid_slip(x, place.y);
        [longitudinal - rolling * place.depth, lateral * cosine - self.gap.side() * rolling * sine * x]
    }
}

#[cfg(test)]
mod tests;
