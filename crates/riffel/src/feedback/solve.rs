//! Solution of the loop at the wavelengths of a vector register, in vector instructions.

use pulp::{Simd, WithSimd};

use super::Contact;
use super::answers::{Answer, Answers};
use super::linear::Equations;
use super::system::turn_lanes;
use crate::vector::{Parts, Vector};
use crate::wheelset::Motion;

/// The index of the normal force among the unknowns of a contact, after those along and across the rail.
pub(super) const NORMAL: usize = 2;

/// The index of the shift of the contact on the rail, in a loop in which one moves.
pub(super) const SHIFT: usize = 3;

/// Inputs and results of the equations of the loop.
pub(super) struct SolveLoop<'a> {
    pub(super) contacts: &'a [Contact],
    /// Unknowns of a contact: three, or four where a contact of the loop moves across the profiles.
    pub(super) unknowns: usize,
    /// The column of excitation of each contact.
    pub(super) excitation: &'a [usize],
    pub(super) answers: &'a Answers,
    /// Receptances H of track and wheels together, by rows; zero by unknowns that are no forces. In a loop in which a contact moves the
    /// fourth row of a contact is θ − u_t/R_t, and its fourth column is by the moment of a shift.
    pub(super) receptances: &'a mut [f64],
    /// Receptances of the wheels and shares of the forces, if `receptances` holds those of the track alone: both are in the axes of
    /// the track then. `None` if they are gathered already.
    pub(super) to_gather: Option<(&'a mut [f64], &'a [f64])>,
    /// −ik T N of each contact and excitation, by rows: the slip that the direction of the normal forces makes; `None` if they stay.
    pub(super) direction: Option<&'a [f64]>,
    /// Made here and solved.
    pub(super) equations: &'a mut Equations,
    /// Creepages along and across of each contact.
    pub(super) creepages: &'a mut [f64],
    /// Ŵ₁ of the mean growth.
    pub(super) dissipation: &'a mut [f64],
}

impl WithSimd for SolveLoop<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(mut self, simd: S) {
        self.gather(simd);
        self.assemble(simd);
        self.equations.solve(simd);
        self.close(simd);
    }
}

impl SolveLoop<'_> {
    /// Receptances of track and wheels together in the axes of the contacts.
    #[inline(always)]
    fn gather<S: Simd>(&mut self, simd: S) {
        let Some((wheels, shares)) = &mut self.to_gather else {
            return;
        };
        let (track, wheels) = (Vector::<S>::row_mut(self.receptances), Vector::<S>::row_mut(wheels));
        turn_lanes(simd, self.contacts, track);
        turn_lanes(simd, self.contacts, wheels);
        let size = shares.len();
        for row in 0..size {
            for column in 0..size {
                let place = row * size + column;
                let both = Vector::from(track[place]).plus(simd, wheels[place].into());
                track[place] = both.scaled(simd, simd.splat_f64s(shares[column])).parts();
            }
        }
    }

    /// The equations, with ξ = −ik (H f) in the tangent plane where an axis is compliant:
    ///
    /// ```text
    /// Q − F_P P − F_ξ ξ = F_κ κ    two rows a contact
    /// P/k_H + (H f)_n = Δ p        one row
    /// ```
    ///
    /// In a loop in which contacts move f are the forces in the axes of the mean state, and with the shifts y on the rail and
    /// y + (H f)_t on the wheel, see [`MovingContact`](crate::contact::MovingContact),
    ///
    /// ```text
    /// f − F_P f_n − F_ξ ξ + c (y + (H f)_t) = F_κ κ
    /// f_n/k_H + (H f)_n + d (y + (H f)_t) = Δ p
    /// y/R_r + θ − (H f)_t/R_t = ψ_p                one row more
    /// ```
    #[inline(always)]
    fn assemble<S: Simd>(&mut self, simd: S) {
        let (size, width) = (self.equations.size(), self.equations.width());
        let unknowns = self.unknowns;
        let receptances = Vector::<S>::row(self.receptances).chunks_exact(unknowns * size);
        let rows = self.equations.rows_mut::<S>();
        let rows = rows.chunks_exact_mut(unknowns * width);
        let (wavenumbers, _) = S::as_simd_f64s(self.answers.wavenumbers());
        let zero = Vector::<S>::zero(simd);
        let contacts = self.contacts.iter().zip(self.excitation);
        for (index, ((contact, &excitation), (rows, receptances))) in contacts.zip(rows.zip(receptances)).enumerate() {
            let answer = self.answers.of_contact::<S>(index);
            let own = unknowns * index;
            let (along, rest) = receptances.split_at(size);
            let (across, rest) = rest.split_at(size);
            let (normal, shift) = rest.split_at(size);
            let moves = contact.moving.is_some();
            let shifts = moves && contact.shifts_with_displacement();
            for axis in 0..NORMAL {
                let (row, right) = rows[axis * width..][..width].split_at_mut(size);
                let by_creepage = answer.force_by_creepage[axis];
                // −F_ξ ξ by displacements.
                let by_along = by_displacement(simd, &contact.motion[0], by_creepage[0], wavenumbers[0]);
                let mut by_across = by_displacement(simd, &contact.motion[1], by_creepage[1], wavenumbers[0]);
                if shifts {
                    by_across = by_across.plus(simd, answer.force_by_shift[axis]);
                }
                // By number: iterators over vectors are calls here.
                for column in 0..size {
                    let share = by_along.times(simd, along[column].into());
                    row[column] = by_across.times_plus(simd, across[column].into(), share).parts();
                }
                // −F_ξ ξ by creepages that are unknowns themselves.
                for (other, by) in by_creepage.into_iter().enumerate() {
                    if matches!(contact.motion[other], Motion::Free) {
                        add(simd, &mut row[own + other], by.negative(simd));
                    }
                }
                add(simd, &mut row[own + axis], real(simd, contact.force_share(axis)));
                add(simd, &mut row[own + NORMAL], answer.force_by_load[axis].negative(simd));
                if moves {
                    add(simd, &mut row[own + SHIFT], answer.force_by_shift[axis]);
                }
                right.fill(zero.parts());
                right[excitation] = answer.force_by_profile[axis].parts();
                if let Some(direction) = self.direction {
                    let slips = &Vector::<S>::row(direction)[index * (width - size)..];
                    for column in 0..width - size {
                        let slip = Vector::<S>::from(slips[column]);
                        add(simd, &mut right[column], by_creepage[0].times(simd, slip));
                    }
                }
            }
            let (row, right) = rows[NORMAL * width..][..width].split_at_mut(size);
            row.copy_from_slice(normal);
            add(simd, &mut row[own + NORMAL], real(simd, contact.stiffness.recip()));
            if shifts {
                for (entry, &across) in row.iter_mut().zip(across) {
                    let by_shift = answer.approach_by_shift.times(simd, across.into());
                    add(simd, entry, by_shift);
                }
            }
            if moves {
                add(simd, &mut row[own + SHIFT], answer.approach_by_shift);
            }
            right.fill(zero.parts());
            right[excitation] = answer.profile.parts();
            if unknowns > SHIFT {
                let (row, right) = rows[SHIFT * width..][..width].split_at_mut(size);
                row.copy_from_slice(shift);
                let curvature = contact.moving.map_or(1.0, |moving| moving.profiles.relative_radius().recip());
                add(simd, &mut row[own + SHIFT], real(simd, curvature));
                right.fill(zero.parts());
                right[excitation] = answer.roll.parts();
            }
        }
    }

    /// Creepages and dissipation of the unknowns.
    #[inline(always)]
    fn close<S: Simd>(&mut self, simd: S) {
        let size = self.equations.size();
        let equations = &*self.equations;
        let unknowns = self.unknowns;
        let receptances = Vector::<S>::row(self.receptances).chunks_exact(unknowns * size);
        let (creepages, _) = Vector::<S>::row_mut(self.creepages).as_chunks_mut::<2>();
        let (wavenumbers, _) = S::as_simd_f64s(self.answers.wavenumbers());
        let mut dissipation = Vector::<S>::zero(simd);
        let contacts = self.contacts.iter().zip(self.excitation);
        for (index, ((contact, &column), (creepages, receptances))) in
            contacts.zip(creepages.iter_mut().zip(receptances)).enumerate()
        {
            let answer = self.answers.of_contact::<S>(index);
            let Answer { growth_by_load, growth_by_creepage, growth_by_shift, growth_by_profile, .. } = answer;
            let mut displacements = [Vector::<S>::zero(simd); 2];
            let (along, rest) = receptances.split_at(size);
            for from in 0..size {
                let unknown = equations.unknown(from, column);
                let [by_along, by_across] = displacements;
                displacements = [
                    unknown.times_plus(simd, along[from].into(), by_along),
                    unknown.times_plus(simd, rest[from].into(), by_across),
                ];
            }
            let load = equations.unknown::<S>(unknowns * index + NORMAL, column);
            dissipation = growth_by_load.times_plus(simd, load, dissipation);
            dissipation = growth_by_profile.plus(simd, dissipation);
            if contact.moving.is_some() {
                let mut shift = equations.unknown::<S>(unknowns * index + SHIFT, column);
                if contact.shifts_with_displacement() {
                    shift = shift.plus(simd, displacements[1]);
                }
                dissipation = growth_by_shift.times_plus(simd, shift, dissipation);
            }
            for axis in 0..NORMAL {
                let creepage = match contact.motion[axis] {
                    Motion::Held => Vector::zero(simd),
                    Motion::Free => equations.unknown(unknowns * index + axis, column),
                    Motion::Compliant(()) => times_i(simd, displacements[axis], wavenumbers[0]).negative(simd),
                };
                let creepage = match self.direction {
                    Some(direction) if axis == 0 => {
                        let columns = equations.width() - size;
                        let slips = Vector::<S>::row(direction);
                        let slip = Vector::<S>::from(slips[index * columns + column]);
                        slip.plus(simd, creepage)
                    }
                    _ => creepage,
                };
                creepages[axis] = creepage.parts();
                dissipation = growth_by_creepage[axis].times_plus(simd, creepage, dissipation);
            }
        }
        Vector::<S>::row_mut(self.dissipation)[0] = dissipation.parts();
    }
}

/// Share −F_ξ ξ of the force by a displacement along an axis, ξ = −ik u; nothing where that is held or free.
#[inline(always)]
fn by_displacement<S: Simd>(simd: S, motion: &Motion<()>, by_creepage: Vector<S>, wavenumbers: S::f64s) -> Vector<S> {
    match motion {
        Motion::Compliant(()) => times_i(simd, by_creepage, wavenumbers),
        Motion::Held | Motion::Free => Vector::zero(simd),
    }
}

/// i times a number times a real one.
#[inline(always)]
fn times_i<S: Simd>(simd: S, number: Vector<S>, factor: S::f64s) -> Vector<S> {
    let Vector { re, im } = number.scaled(simd, factor);
    Vector { re: simd.neg_f64s(im), im: re }
}

#[inline(always)]
fn real<S: Simd>(simd: S, value: f64) -> Vector<S> {
    Vector { re: simd.splat_f64s(value), im: simd.splat_f64s(0.0) }
}

#[inline(always)]
fn add<S: Simd>(simd: S, entry: &mut Parts<S>, share: Vector<S>) {
    *entry = share.plus(simd, (*entry).into()).parts();
}
