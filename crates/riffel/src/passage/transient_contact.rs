//! A settled state whose contact is the half-space, followed element by element.

use std::f64::consts::TAU;

use num_complex::Complex64;

use super::settled::{harmonics, largest_change};
use super::{ContactInstant, Harmonic, PassageModel, Settled, Sinusoid};
use crate::Error;
use crate::contact::{Creepages, HertzContact, PressedOnRail, TransientRolling};

/// The exact contact of a passage: a Hertz patch of elastic half-spaces in stick and slip, which remembers what it has rolled over
/// at any load and creepage.
///
/// It is what [`LateContact`](super::LateContact) and steady laws come near to.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TransientContact {
    /// The patch under the mean load.
    pub hertz: HertzContact,
    /// Coefficient of friction \[-\].
    pub friction: f64,
    /// Elements over a diameter of the patch under the largest load, an even number from 16 to 200.
    pub across: usize,
    /// Whether the pressures are those of the true gap over the wave, in the place of the ellipse of the load.
    pub over_true_gap: bool,
}

/// The settled state of one wheel on the exact contact.
#[derive(Debug, Clone, PartialEq)]
pub struct TransientSettled {
    /// Forces and creepage. The wave has a step for each element that it is long.
    pub settled: Settled,
    /// Harmonics n = 0 … 5 of the energy that a place of the rail receives \[J/m\].
    pub energy_at_rail: [Complex64; 6],
}

impl PassageModel {
    /// The settled state over a sinusoid with the exact contact in the place of the creep law.
    ///
    /// The normal force does not feel the creep force, so that it is that of [`settle`](Self::settle) with `steps` steps to a
    /// wave; under it the contact rolls from element to element and the wheel turns by equation (15).
    ///
    /// Over the true gap the pressures are solved anew at every element of the wave, so that the [geometry](crate::contact::WaveGeometry) of the wave
    /// is in them without a formula; the creepage is the slip per metre that the wheel goes on.
    ///
    /// Method: creepage in the middle of a step, creep force at its end, both explicit and of second order; the elements are made
    /// as long as an even number of them is a wave. A patch shorter than two elements carries nothing. Waves follow one another until
    /// the one of twice as many is the same to 10⁻³ of its first harmonics, which leaves the square of that. Elements leave errors of first
    /// order in their length, so that the same is rolled with half as many and both are extrapolated, place by place. Accuracy: 2 to 3 % of the
    /// first harmonics if the load moves the edge by 1.4 elements or more (test `transient_contact_at_small_amplitude`), tens of per cent below
    /// ([`elements_of_edge`](TransientContact::elements_of_edge)). With loss of contact means are those of the march to 10⁻³.
    /// Cost: 1 ms an element with 32 across, growing with the third power of that; seconds for a wave of some semi-axes.
    ///
    /// # Errors
    /// Errors of `settle`; [`Error::OutOfRange`] on discrete supports, where no wave is like the one before, for a wave of fewer than 40
    /// elements or more than 4000, for loads that do not move the edge by a tenth of an element, and for elements that are no even number; those of [`TransientRolling`]; [`Error::NotSettled`] after 1024 waves.
    pub fn settle_transient(
        &self,
        profile: Sinusoid,
        steps: usize,
        contact: TransientContact,
    ) -> Result<TransientSettled, Error> {
        if self.contacts.len() > 1 || self.structures.are_fitted_together() {
            return Err(Error::OutOfRange {
                quantity: "number of contacts beside a transient one",
                value: self.contacts.len() as f64 - 1.0,
                unit: "",
                rule: "must be none, under a free wheel with longitudinal creepage",
            });
        }
        if let Some(spacing) = self.structures.support_spacing() {
            return Err(Error::OutOfRange {
                quantity: "support spacing under a transient contact",
                value: spacing,
                unit: "m",
                rule: "must be none: on discrete supports no wave is like the one before",
            });
        }
        if contact.across % 2 == 1 {
            return Err(Error::OutOfRange {
                quantity: "number of elements over a diameter of the patch",
                value: contact.across as f64,
                unit: "",
                rule: "must be even, since half as many are rolled too",
            });
        }
        let settled = self.settle(profile, steps)?.swap_remove(0);
        let elements = contact.elements_of_a_wave(&settled, profile)?;
        let rolled = |across: usize, elements: usize| {
            let length = profile.wavelength / elements as f64;
            let rolling = contact.with_elements(across, length, profile)?;
            let mut rolling = RollingOverWave::new(self, &settled, elements, rolling, profile);
            if contact.over_true_gap {
                rolling.press_on(profile)?;
            }
            let waves = rolling.settle(self.speed)?;
            Ok((rolling, waves))
        };
        let (fine, waves) = rolled(contact.across, elements)?;
        let (coarse, _) = rolled(contact.across / 2, elements / 2)?;
        Ok(fine.extrapolated(&coarse, contact.friction, settled, waves))
    }
}

impl TransientContact {
    /// How many elements the edge of the patch moves over a wave.
    ///
    /// Below one the steps by which it does are seen: errors of a first harmonic are some 3 % from 1.4 on, and tens of per cent below.
    pub fn elements_of_edge(&self, settled: &Settled, profile: Sinusoid) -> f64 {
        let [least, largest] = settled.normal_force;
        let half = |load: f64| (load.max(0.0) / self.hertz.normal_force()).cbrt();
        let by_load = 1.0 - half(least) / half(largest);
        let semi_axis = self.hertz.semi_axis_longitudinal() * half(largest);
        let by_wave = 2.0 * self.shift(profile) / semi_axis;
        0.5 * self.across as f64 * by_load.max(by_wave)
    }

    /// R r' \[m\]: how far ahead of its centre the wheel touches; nothing where the ellipse stays under it.
    fn shift(&self, profile: Sinusoid) -> f64 {
        match self.over_true_gap {
            true => self.hertz.longitudinal_radius() * profile.amplitude * TAU / profile.wavelength,
            false => 0.0,
        }
    }

    /// Largest even number of elements that a wave has, if the patch under its largest load has `across`.
    fn elements_of_a_wave(&self, settled: &Settled, profile: Sinusoid) -> Result<usize, Error> {
        const LEAST: f64 = 40.0;
        const MOST: f64 = 4000.0;
        /// Elements that the edge moves, below which nothing follows the load.
        const LEAST_OF_EDGE: f64 = 0.1;
        let moves = self.elements_of_edge(settled, profile);
        if moves < LEAST_OF_EDGE {
            return Err(Error::OutOfRange {
                quantity: "number of elements that the load moves the edge of the contact",
                value: moves,
                unit: "",
                rule: "must be at least 0.1: take a larger amplitude or more elements",
            });
        }
        let [_, largest] = settled.normal_force;
        let largest = self.hertz.under(largest.max(self.hertz.normal_force()));
        let diameters = profile.wavelength / (2.0 * largest.semi_axis_longitudinal());
        // A grid may be a hundredth larger or smaller than the patch, since it has its area.
        let elements = 2.0 * (0.49 * diameters * self.across as f64).floor();
        if elements < LEAST {
            return Err(Error::OutOfRange {
                quantity: "wavelength",
                value: profile.wavelength,
                unit: "m",
                rule: "must be at least 40 elements of the contact: take more of them",
            });
        }
        if elements > MOST {
            return Err(Error::OutOfRange {
                quantity: "wavelength",
                value: profile.wavelength,
                unit: "m",
                rule: "must be at most 4000 elements of the contact: a wave so long has a steady contact",
            });
        }
        Ok(elements as usize)
    }

    /// The contact on elements of a length \[m\], whatever load makes them so long, with room for where the wave takes it.
    fn with_elements(&self, across: usize, length: f64, profile: Sinusoid) -> Result<TransientRolling, Error> {
        /// In a trough the patch is longer, to first order half as much as κ.
        const LONGER: f64 = 1.0;
        let made = TransientRolling::new(self.hertz, self.friction, across)?;
        // a grows with the cube root of the load.
        let load = self.hertz.normal_force() * (length / made.step_length()).powi(3);
        let shift = self.shift(profile);
        let curvature = shift * TAU / profile.wavelength;
        let room = shift / length + LONGER * curvature * 0.5 * across as f64;
        let room = if shift > 0.0 { 1 + room.ceil() as usize } else { 0 };
        TransientRolling::with_room(self.hertz.under(load), self.friction, across, room)
    }
}

/// The contact under way over waves that are all alike.
struct RollingOverWave {
    contact: TransientRolling,
    /// Normal force and approach at the end of each step.
    loads: Vec<[f64; 2]>,
    /// Pressures at the end of each step; `None` if they are those of the load.
    pressed: Option<Vec<PressedOnRail>>,
    /// Load under which the patch is two elements long \[N\].
    least: f64,
    /// Creepage in the middle of the step to come.
    creepage: f64,
    /// What the direction of the normal force adds to it, −P₀r/(MV²), in the middle of each step.
    climbing: Vec<f64>,
    /// R²h/(I_wV) \[1/N\], zero where the creepage is held.
    creepage_per_force: f64,
    mean_force: f64,
    wave: Vec<ContactInstant>,
    /// Energy that each element of the rail has received from one wave of rolling \[J/m\].
    energy: Vec<f64>,
}

impl RollingOverWave {
    /// A number of elements is a wave.
    fn new(
        model: &PassageModel,
        settled: &Settled,
        count: usize,
        contact: TransientRolling,
        profile: Sinusoid,
    ) -> Self {
        let step = contact.step_length();
        let wheel = &model.contacts[0];
        let creepage_per_force = match wheel.held[0] {
            false => model.structures.free()[0] * step / (model.speed * model.speed),
            true => 0.0,
        };
        let direction = model.structures.direction();
        let per_height = match direction.filter(|_| !wheel.held[0]) {
            Some(direction) => -wheel.mean.normal_force * direction.free[0] / model.speed.powi(2),
            None => 0.0,
        };
        let middles = (0..count).map(|index| (index as f64 + 0.5) / count as f64);
        let largest = contact.hertz();
        let semi_axes = step / largest.semi_axis_longitudinal();
        Self {
            pressed: None,
            loads: (1..=count).map(|index| at_share(&settled.wave, index as f64 / count as f64)).collect(),
            // a grows with the cube root of the load.
            least: largest.normal_force() * semi_axes.powi(3),
            creepage: settled.harmonics[0].creepage.re,
            climbing: middles.map(|share| per_height * profile.amplitude * (TAU * share).cos()).collect(),
            creepage_per_force,
            mean_force: wheel.mean.forces.longitudinal,
            wave: Vec::with_capacity(count),
            energy: vec![0.0; count],
            contact,
        }
    }

    /// Solve the pressures over the gap of the wave at the end of each step.
    fn press_on(&mut self, profile: Sinusoid) -> Result<(), Error> {
        let mut normal = self.contact.normal_contact()?;
        let wavenumber = TAU / profile.wavelength;
        let height = |place: f64| profile.amplitude * (wavenumber * place).cos();
        let steps = self.loads.iter().enumerate();
        let pressed = steps.map(|(index, &[load, _])| {
            let centre = (index + 1) as f64 * self.contact.step_length();
            // What is lifted carries nothing, under any pressures.
            let load = load.max(self.least);
            let over_centre = |x: f64| height(centre + x) - height(centre);
            self.contact.press_on(&mut normal, load, over_centre)
        });
        self.pressed = Some(pressed.collect::<Result<_, _>>()?);
        Ok(())
    }

    /// Rolls until a wave is like that of half as many; their number.
    fn settle(&mut self, speed: f64) -> Result<usize, Error> {
        const MOST_WAVES: usize = 1024;
        const CHANGE: f64 = 1e-3;
        let mut before: Option<[[Harmonic; 6]; 1]> = None;
        let mut change = f64::INFINITY;
        let mut until = 4;
        for number in 1..=MOST_WAVES {
            self.roll_a_wave()?;
            if number < until {
                continue;
            }
            until *= 2;
            let now = [harmonics(&self.wave)];
            if let Some(before) = before {
                change = largest_change(&before, &now);
                if change <= CHANGE {
                    return Ok(number);
                }
            }
            before = Some(now);
        }
        let length = self.loads.len() as f64 * self.contact.step_length();
        Err(Error::NotSettled { seconds: MOST_WAVES as f64 * length / speed, change })
    }

    fn roll_a_wave(&mut self) -> Result<(), Error> {
        let count = self.loads.len();
        let length = self.contact.step_length();
        self.wave.clear();
        self.energy.fill(0.0);
        for (index, &[load, approach]) in self.loads.iter().enumerate() {
            let creepage = self.creepage + self.climbing[index];
            let tangential_force = if load <= self.least {
                self.contact.lift();
                0.0
            } else {
                let creepages = Creepages::longitudinal(creepage);
                let step = match &self.pressed {
                    Some(pressed) => self.contact.roll_pressed(&pressed[index], creepages)?,
                    None => self.contact.roll(load, creepages)?,
                };
                // The middle of this step is that of the element `index`, in whole elements from which a column lies.
                let middle = self.contact.columns() / 2;
                for (column, energy) in step.dissipation_along.iter().enumerate() {
                    let element = (index + column + 2 * count - middle) % count;
                    self.energy[element] += energy / length;
                }
                step.forces.longitudinal
            };
            let change = self.creepage_per_force * (tangential_force - self.mean_force);
            self.wave.push(ContactInstant {
                normal_force: load,
                tangential_force,
                lateral_force: 0.0,
                creepage: creepage - 0.5 * change,
                lateral_creepage: 0.0,
                approach,
                energy_at_rail: 0.0,
            });
            self.creepage -= change;
        }
        Ok(())
    }

    /// To elements of no length, at the places of the coarse ones, which are twice as long.
    fn extrapolated(self, coarse: &Self, friction: f64, settled: Settled, waves: usize) -> TransientSettled {
        let count = coarse.energy.len();
        let energy: Vec<f64> = (0..count)
            .map(|index| self.energy[2 * index] + self.energy[2 * index + 1] - coarse.energy[index])
            .collect();
        let wave: Vec<ContactInstant> = (0..count)
            .map(|index| {
                let (fine, coarse) = (self.wave[2 * index + 1], coarse.wave[index]);
                let bound = friction * fine.normal_force;
                let tangential_force = 2.0 * fine.tangential_force - coarse.tangential_force;
                ContactInstant {
                    tangential_force: tangential_force.clamp(-bound, bound),
                    creepage: 2.0 * fine.creepage - coarse.creepage,
                    // As the wheel centre passes the end of an element.
                    energy_at_rail: 0.5 * (energy[index] + energy[(index + 1) % count]),
                    ..fine
                }
            })
            .collect();
        let harmonic = |n: usize| -> Complex64 {
            let scale = if n == 0 { 1.0 } else { 2.0 } / count as f64;
            let elements = energy.iter().enumerate();
            elements
                .map(|(index, energy)| {
                    let angle = TAU * n as f64 * (index as f64 + 0.5) / count as f64;
                    Complex64::from_polar(scale * energy, -angle)
                })
                .sum()
        };
        TransientSettled {
            energy_at_rail: std::array::from_fn(harmonic),
            settled: Settled {
                harmonics: harmonics(&wave),
                crest: wave[count - 1],
                wave,
                waves: settled.waves + waves,
                ..settled
            },
        }
    }
}

/// Normal force and approach at a share of the wave, linear between its steps, the last of which is its end.
fn at_share(wave: &[ContactInstant], share: f64) -> [f64; 2] {
    let place = share * wave.len() as f64;
    let before = place.floor();
    let at = |index: f64| {
        let index = index as usize;
        // Place zero is the end of the wave before.
        &wave[(index + wave.len() - 1) % wave.len()]
    };
    let (one, other, part) = (at(before), at(before + 1.0), place - before);
    [
        one.normal_force + part * (other.normal_force - one.normal_force),
        one.approach + part * (other.approach - one.approach),
    ]
}
