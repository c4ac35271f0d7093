//! The equations of the general loop and their scratch.

mod axes;
mod moved;

use std::f64::consts::PI;

use num_complex::Complex64;
use pulp::Arch;

use super::answers::Answers;
use super::linear::{Equations, Solve};
use super::solve::{NORMAL, SHIFT, SolveLoop};
use super::{Comb, Contact, ContactState, Derivative, Loop};
use crate::vector::lanes_of;
use crate::wheelset::Motion;
use crate::{Place, Rail};
pub(super) use axes::turn_lanes;
use axes::{turn_axes, turn_numbers};
use moved::Moved;

/// The equations and their scratch, for one loop at one group of points after the other: as many as a vector register has
/// lanes.
#[derive(Clone)]
pub(crate) struct System {
    arch: Arch,
    lanes: usize,
    /// Places of the contacts on the track and on the wheels.
    on_track: Vec<Place>,
    on_wheels: Vec<Place>,
    /// Unknowns of a contact.
    unknowns: usize,
    /// Where the rail may roll under the contacts, where one of them feels it.
    rolling: Vec<(f64, Rail)>,
    /// Roll at each contact by forces along its axes and by a moment at every contact.
    rolls: Vec<Complex64>,
    /// One where an unknown is a force, zero where it is a creepage.
    force_shares: Vec<f64>,
    /// Receptances of the track and of the wheels at the point asked last.
    track: Vec<Complex64>,
    wheels: Vec<Complex64>,
    /// Receptances of both in the axes of the contacts; of each entry the real parts of all lanes, then the imaginary ones.
    receptances: Vec<f64>,
    /// Receptances of the wheels alone in the axes of the track, alike; where no contact moves.
    wheels_by_lanes: Vec<f64>,
    equations: Equations,
    /// What was asked for all lanes at once.
    of_lanes: OfLanes,
    /// Where the hubs stand, and −ik T N of each contact and excitation, where normal forces turn with the wave.
    hubs: Vec<(f64, Rail)>,
    direction: Option<Vec<f64>>,
    /// Which excitation is that of each contact.
    excitation: Vec<usize>,
    /// Creepages of the contacts, and Ŵ₁ of the mean growth.
    creepages: Vec<f64>,
    dissipation: Vec<f64>,
}

/// Angular frequencies \[rad/s\] of the lanes and matrices at each, one behind the other.
#[derive(Clone)]
struct OfLanes {
    frequencies: Vec<f64>,
    track: Vec<Complex64>,
    wheels: Vec<Complex64>,
    hubs: Vec<Complex64>,
}

impl System {
    pub(crate) fn new(of: &Loop) -> Self {
        let arch = Arch::new();
        let lanes = lanes_of(arch);
        let count = of.contacts.len();
        let places_count = 3 * count;
        let moves = of.contacts.iter().any(|contact| contact.moving.is_some());
        let unknowns = match moves {
            true => SHIFT + 1,
            false => SHIFT,
        };
        let size = unknowns * count;
        let rolls = of.contacts.iter().any(Contact::rolls);
        let rolling: Vec<(f64, Rail)> = match rolls {
            true => (of.contacts.iter()).map(|contact| (of.position + contact.along, contact.rail)).collect(),
            false => Vec::new(),
        };
        let places = |from: f64| -> Vec<Place> {
            let places = of.contacts.iter();
            places.flat_map(|contact| contact.places(from + contact.along)).collect()
        };
        let mut wheelsets: Vec<f64> = Vec::new();
        let excitation = of.contacts.iter().map(|contact| match of.comb {
            Comb::Resolved => 0,
            Comb::Mean => {
                let known = wheelsets.iter().position(|&along| along == contact.along);
                known.unwrap_or_else(|| {
                    wheelsets.push(contact.along);
                    wheelsets.len() - 1
                })
            }
        });
        let excitation: Vec<usize> = excitation.collect();
        let columns = 1 + excitation.iter().max().copied().unwrap_or(0);
        let force_shares = of.contacts.iter();
        let force_shares = force_shares.flat_map(|contact| [0, 1, NORMAL].map(|axis| contact.force_share(axis)));
        Self {
            arch,
            lanes,
            on_track: places(of.position),
            on_wheels: places(0.0),
            unknowns,
            rolls: vec![Complex64::ZERO; if moves { 4 * count * count } else { 0 }],
            rolling,
            force_shares: force_shares.collect(),
            track: vec![Complex64::ZERO; places_count * places_count],
            wheels: vec![Complex64::ZERO; places_count * places_count],
            receptances: vec![0.0; 2 * size * size * lanes],
            wheels_by_lanes: vec![0.0; if moves { 0 } else { 2 * size * size * lanes }],
            equations: Equations::new(size, columns, lanes),
            hubs: of.places_of_wheels(),
            of_lanes: OfLanes {
                frequencies: Vec::with_capacity(lanes),
                track: vec![Complex64::ZERO; lanes * places_count * places_count],
                wheels: vec![Complex64::ZERO; lanes * places_count * places_count],
                hubs: vec![Complex64::ZERO; lanes * count * count],
            },
            direction: (of.normal_direction.as_ref()).map(|_| vec![0.0; 2 * count * columns * lanes]),
            excitation,
            creepages: vec![0.0; 2 * 2 * of.contacts.len() * lanes],
            dissipation: vec![0.0; 2 * lanes],
        }
    }

    /// How many points it solves at once.
    pub(crate) fn lanes(&self) -> usize {
        self.lanes
    }

    /// What the contacts answer at no more wavelengths \[m\] than lanes.
    pub(crate) fn answers(&self, of: &Loop, wavelengths: &[f64]) -> Answers {
        Answers::new(of, wavelengths, self.lanes)
    }

    /// Solve the equations at the wavelengths of the answers and a speed \[m/s\], one wavelength a lane.
    pub(crate) fn solve(&mut self, of: &Loop, answers: &Answers, speed: f64) {
        self.ask(of, answers.wavelengths(), speed);
        let stays = self.unknowns == SHIFT;
        for (lane, &wavelength) in answers.wavelengths().iter().enumerate() {
            self.turn_normals(of, wavelength, lane);
            if stays {
                let size = self.size() * self.size();
                let lanes = self.lanes;
                scatter(&self.of_lanes.track[lane * size..][..size], &mut self.receptances, lane, lanes);
                scatter(&self.of_lanes.wheels[lane * size..][..size], &mut self.wheels_by_lanes, lane, lanes);
            } else {
                self.take(of, lane);
                self.ask_rolls(of, 2.0 * PI * speed / wavelength, speed);
                self.gather(of, lane);
            }
        }
        self.arch.dispatch(SolveLoop {
            contacts: &of.contacts,
            unknowns: self.unknowns,
            excitation: &self.excitation,
            answers,
            receptances: &mut self.receptances,
            to_gather: stays.then_some((&mut self.wheels_by_lanes, &self.force_shares)),
            direction: self.direction.as_deref(),
            equations: &mut self.equations,
            creepages: &mut self.creepages,
            dissipation: &mut self.dissipation,
        });
    }

    /// Take what track and wheels answered for the point solved in the first lane alone, in the axes of the contacts.
    pub(super) fn take_first(&mut self, of: &Loop) {
        // Where a contact moves the equations are made of what is taken.
        if self.unknowns == SHIFT {
            self.take(of, 0);
        }
    }

    fn take(&mut self, of: &Loop, lane: usize) {
        let size = self.size() * self.size();
        self.track.copy_from_slice(&self.of_lanes.track[lane * size..][..size]);
        self.wheels.copy_from_slice(&self.of_lanes.wheels[lane * size..][..size]);
        self.turn_axes(of);
    }

    /// Ŵ₁ of the mean growth at the point solved in a lane.
    pub(crate) fn normalized_dissipation(&self, lane: usize) -> Complex64 {
        self.number(&self.dissipation, 0, lane)
    }

    /// Ŵ₁ of the mean growth with all damage whose rate depends on the amplitude, at the wavelength \[m\] of the lane.
    pub(crate) fn equivalent(&mut self, of: &Loop, wavelength: f64, speed: f64, lane: usize) -> Complex64 {
        let mut sum = self.normalized_dissipation(lane);
        if !of.depends_on_amplitude() {
            return sum;
        }
        self.receptances(of, 2.0 * PI * speed / wavelength, speed);
        self.turn_axes(of);
        for (index, contact) in of.contacts.iter().enumerate() {
            let Some(damage) = contact.clipped_damage() else {
                continue;
            };
            let moved = self.moved(of, index, wavelength, lane);
            let receptance = self.track[(3 * index + NORMAL) * (self.size() + 1)];
            let at = moved.oscillation(&contact.derivatives(wavelength), receptance, wavelength);
            let depth = damage.clipped(contact.mean_of_damage(), &at);
            let energy = depth / contact.wear.depth_per_energy();
            let under = moved.phase * contact.profile_or_one();
            sum += of.share_of_growth(index) * energy / under;
        }
        sum
    }

    /// The determinant of the equations at an angular frequency \[rad/s\] and a speed \[m/s\], over that of the
    /// normal forces alone on rails and wheels without friction.
    pub(super) fn determinant(&mut self, of: &Loop, angular_frequency: f64, speed: f64) -> Complex64 {
        let answers = self.answers(of, &[2.0 * PI * speed / angular_frequency]);
        self.solve(of, &answers, speed);
        let whole = self.equations.determinant(0);
        let (unknowns, count) = (self.unknowns, of.contacts.len());
        let size = unknowns * count;
        let mut normal = Equations::new(count, 0, self.lanes);
        for (row, contact) in of.contacts.iter().enumerate() {
            for column in 0..count {
                let entry = (unknowns * row + NORMAL) * size + unknowns * column + NORMAL;
                let mut entry = self.number(&self.receptances, entry, 0);
                if row == column {
                    entry += contact.stiffness.recip();
                }
                normal.set(row, column, 0, entry);
            }
        }
        self.arch.dispatch(Solve(&mut normal));
        whole.over(normal.determinant(0))
    }

    /// Receptances of track and wheels in the axes of the track.
    pub(super) fn receptances(&mut self, of: &Loop, angular_frequency: f64, speed: f64) {
        of.track.receptance_matrix(angular_frequency, speed, &self.on_track, &mut self.track);
        of.wheels.receptance_matrix(angular_frequency, speed, &self.on_wheels, &mut self.wheels);
        self.ask_rolls(of, angular_frequency, speed);
    }

    /// Receptances of track, wheels and hubs at wavelengths \[m\], one a lane.
    fn ask(&mut self, of: &Loop, wavelengths: &[f64], speed: f64) {
        let OfLanes { frequencies, track, wheels, hubs } = &mut self.of_lanes;
        frequencies.clear();
        frequencies.extend(wavelengths.iter().map(|wavelength| 2.0 * PI * speed / wavelength));
        of.track.receptance_matrices(frequencies, speed, &self.on_track, track);
        of.wheels.receptance_matrices(frequencies, speed, &self.on_wheels, wheels);
        if let Some(asked) = &of.normal_direction {
            asked.between(frequencies, speed, &self.hubs, hubs);
        }
    }

    fn ask_rolls(&mut self, of: &Loop, angular_frequency: f64, speed: f64) {
        if !self.rolling.is_empty() {
            let track = &of.track;
            track.roll_matrix(angular_frequency, speed, &self.rolling, &mut self.rolls);
        }
    }

    /// What the direction of the normal forces makes of the waves under the contacts, after their receptances.
    fn turn_normals(&mut self, of: &Loop, wavelength: f64, lane: usize) {
        let (size, count, lanes) = (self.size(), of.contacts.len(), self.lanes);
        let Some(direction) = &mut self.direction else {
            return;
        };
        let wavenumber = 2.0 * PI / wavelength;
        let of_hubs = &self.of_lanes.hubs[lane * count * count..];
        let track = &self.of_lanes.track[lane * size * size..];
        let columns = direction.len() / (2 * lanes * count);
        for (to, contact) in of.contacts.iter().enumerate() {
            let slips = &mut direction[2 * to * columns * lanes..][..2 * columns * lanes];
            slips.iter_mut().skip(lane).step_by(lanes).for_each(|part| *part = 0.0);
            // A surface that is held does not slip, and one that is free slips as its force asks for.
            if !matches!(contact.motion[0], Motion::Compliant(())) {
                continue;
            }
            for (from, source) in of.contacts.iter().enumerate() {
                let profile = of.amplitude * source.profile * source.phase(wavenumber);
                let load = source.rolling.steady().normal_force;
                let along = track[3 * to * size + 3 * from] + of_hubs[to * count + from];
                let slip = wavenumber * wavenumber * load * along * profile;
                let parts = &mut slips[2 * self.excitation[from] * lanes..];
                parts[lane] += slip.re;
                parts[lanes + lane] += slip.im;
            }
        }
    }

    /// Gather the receptances of track and wheels in a lane of a loop in which a contact moves.
    fn gather(&mut self, of: &Loop, lane: usize) {
        self.turn_rolls(of);
        let (unknowns, count) = (self.unknowns, of.contacts.len());
        for to in 0..count {
            for from in 0..count {
                let block = self.block(of, to, from);
                for (row, entries) in block.iter().enumerate().take(unknowns) {
                    let line = (unknowns * to + row) * unknowns * count;
                    for (column, entry) in entries.iter().enumerate().take(unknowns) {
                        let place = line + unknowns * from + column;
                        let parts = &mut self.receptances[2 * place * self.lanes..];
                        (parts[lane], parts[self.lanes + lane]) = (entry.re, entry.im);
                    }
                }
            }
        }
    }

    /// What the unknowns of one contact move at another: displacements along its axes, and θ − u_t/R_t.
    fn block(&self, of: &Loop, to: usize, from: usize) -> [[Complex64; 4]; 4] {
        let (contact, source) = (&of.contacts[to], &of.contacts[from]);
        let size = self.size();
        let mut block = [[Complex64::ZERO; 4]; 4];
        for (row, entries) in block.iter_mut().enumerate().take(SHIFT) {
            for (column, entry) in entries.iter_mut().enumerate().take(SHIFT) {
                let place = (3 * to + row) * size + 3 * from + column;
                let share = self.force_shares[3 * from + column];
                *entry = (self.track[place] + self.wheels[place]) * share;
            }
        }
        let count = of.contacts.len();
        // The moment of a load that has moved.
        if source.rolls() {
            let load = source.rolling.steady().normal_force;
            for (row, entries) in block.iter_mut().enumerate().take(SHIFT) {
                entries[SHIFT] = self.rolls[4 * (from * count + to) + row] * load;
            }
            if contact.rolls() {
                block[SHIFT][SHIFT] = self.rolls[4 * (to * count + from) + SHIFT] * load;
            }
        }
        let Some(moving) = contact.moving else {
            return block;
        };
        if contact.rolls() {
            let rolls = &self.rolls[4 * (to * count + from)..];
            let shares = &self.force_shares[3 * from..];
            let entries = block[SHIFT].iter_mut().take(SHIFT);
            for (entry, (roll, share)) in entries.zip(rolls.iter().zip(shares)) {
                *entry = roll * share;
            }
        }
        if contact.shifts_with_displacement() {
            let curvature = moving.profiles.wheel_curvature();
            let displacements = block[1];
            for (entry, displacement) in block[SHIFT].iter_mut().zip(displacements) {
                *entry -= displacement * curvature;
            }
        }
        block
    }

    /// Turn the rolls asked last from the axes of the track to those of the contacts.
    fn turn_rolls(&mut self, of: &Loop) {
        for row in self.rolls.chunks_exact_mut(4 * of.contacts.len()) {
            for (entries, contact) in row.chunks_exact_mut(4).zip(&of.contacts) {
                turn_numbers(contact, entries);
            }
        }
    }

    /// What moves a contact as the equations solved leave it at the wavelength \[m\] of a lane.
    fn moved(&self, of: &Loop, index: usize, wavelength: f64, lane: usize) -> Moved {
        let contact = &of.contacts[index];
        let of_unknown = |axis: usize| {
            let column = self.excitation[index];
            let unknown = self.unknowns * index + axis;
            self.equations.unknown_of_lane(unknown, column, lane)
        };
        let mut force: [Complex64; 3] = std::array::from_fn(|axis| contact.force_share(axis) * of_unknown(axis));
        let [along, across] = [0, 1].map(|axis| self.number(&self.creepages, 2 * index + axis, lane));
        let wavenumber = 2.0 * PI / wavelength;
        let (mut creepage, mut spin) = ([along, across], Complex64::ZERO);
        let mut shift = Complex64::ZERO;
        if contact.moving.is_some() {
            shift = of_unknown(SHIFT);
            let mut on_wheel = shift;
            if contact.shifts_with_displacement() {
                // ξ_t = −ik u_t.
                on_wheel += across * Complex64::I / wavenumber;
            }
            let by_shift = contact.by_shift();
            creepage[0] += by_shift.creepage * on_wheel;
            spin = by_shift.spin * on_wheel;
            force[1] -= by_shift.lateral_force * on_wheel;
            force[NORMAL] -= by_shift.normal_force * on_wheel;
        }
        let phase = contact.phase(wavenumber);
        Moved { force, creepage, spin, shift, phase, profile: of.amplitude * contact.profile * phase }
    }

    /// A contact as the equations solved leave it at the wavelength \[m\] of the first lane.
    pub(super) fn state(&self, of: &Loop, index: usize, wavelength: f64) -> ContactState {
        let contact = &of.contacts[index];
        let derivatives = contact.derivatives(wavelength);
        let moved = self.moved(of, index, wavelength, 0);
        let sum = |what: fn(&Derivative) -> Complex64| moved.sum(&derivatives, what);
        let (energy, at_rail) = (sum(|by| by.energy), sum(|by| by.at_rail));
        let under = moved.profile_or_one(contact, of.amplitude);
        let receptance = self.track[(3 * index + NORMAL) * (self.size() + 1)];
        let oscillation = moved.oscillation(&derivatives, receptance, wavelength);
        let damage = contact.damage_state(&oscillation, moved.force, under);
        let Moved { force, mut creepage, mut spin, shift, phase, profile } = moved;
        let wave = contact.wave_state(wavelength, profile);
        if let Some(wave) = wave {
            for (creepage, of_wave) in creepage.iter_mut().zip(wave.creepage) {
                *creepage += of_wave;
            }
            spin += wave.spin;
        }
        let energy_at_rail = at_rail / (phase * contact.profile_or_one());
        let depth = contact.wear.depth_per_energy() * energy_at_rail.re;
        ContactState {
            force,
            creepage,
            spin,
            shift,
            energy,
            energy_at_rail,
            growth_rate: (contact.profile != 0.0).then(|| match &damage {
                Some(damage) => damage.growth().re,
                None => -depth / of.amplitude,
            }),
            wave,
            slip_by_direction: self.direction.as_ref().map(|direction| {
                let columns = self.equations.width() - self.equations.size();
                self.number(direction, index * columns + self.excitation[index], 0)
            }),
            damage,
        }
    }

    /// Normal force P₁ \[N\] of a contact as the equations solved leave it at the wavelength of a lane.
    pub(crate) fn normal_force(&self, of: &Loop, index: usize, wavelength: f64, lane: usize) -> Complex64 {
        let contact = &of.contacts[index];
        let column = self.excitation[index];
        let of_unknown = |axis: usize| {
            let unknown = self.unknowns * index + axis;
            self.equations.unknown_of_lane(unknown, column, lane)
        };
        let force = of_unknown(NORMAL) * contact.force_share(NORMAL);
        if contact.moving.is_none() {
            return force;
        }
        let mut on_wheel = of_unknown(SHIFT);
        if contact.shifts_with_displacement() {
            let across = self.number(&self.creepages, 2 * index + 1, lane);
            on_wheel += across * Complex64::I * wavelength / (2.0 * PI);
        }
        force - on_wheel * contact.by_shift().normal_force
    }

    /// Turn the receptances asked last into the axes of the contacts.
    pub(super) fn turn_axes(&mut self, of: &Loop) {
        turn_axes(of, &mut self.track);
        turn_axes(of, &mut self.wheels);
    }

    /// Receptances of track and wheels together at the point asked last, by rows.
    pub(super) fn together(&self) -> Vec<Complex64> {
        let both = self.track.iter().zip(&self.wheels);
        both.map(|(track, wheels)| track + wheels).collect()
    }

    /// Part A \[1/kg\] of the receptances of the wheels, −A/ω² for ω → 0, in the axes of the contacts by rows.
    pub(super) fn free_wheels(&self, of: &Loop) -> Vec<f64> {
        let free = of.wheels.free(&self.on_wheels);
        let mut free: Vec<Complex64> = free.into_iter().map(Complex64::from).collect();
        turn_axes(of, &mut free);
        free.into_iter().map(|entry| entry.re).collect()
    }

    /// Receptances of the wheels at the point asked last, by rows.
    pub(super) fn of_wheels(&self) -> impl Iterator<Item = Complex64> + '_ {
        self.wheels.iter().copied()
    }

    /// Receptance matrices of track and wheel at the first contact and the point asked last.
    pub(super) fn at_first(&self) -> [[[Complex64; 3]; 3]; 2] {
        [&self.track, &self.wheels]
            .map(|matrix| std::array::from_fn(|row| std::array::from_fn(|column| matrix[row * self.size() + column])))
    }

    /// A number of those that lie by lanes.
    fn number(&self, of: &[f64], index: usize, lane: usize) -> Complex64 {
        let parts = &of[2 * index * self.lanes..][..2 * self.lanes];
        Complex64::new(parts[lane], parts[self.lanes + lane])
    }

    fn size(&self) -> usize {
        self.on_track.len()
    }
}

/// Put complex numbers into a lane: of each the real parts of all lanes, then the imaginary ones.
fn scatter(numbers: &[Complex64], into: &mut [f64], lane: usize, lanes: usize) {
    for (parts, number) in into.chunks_exact_mut(2 * lanes).zip(numbers) {
        (parts[lane], parts[lanes + lane]) = (number.re, number.im);
    }
}
