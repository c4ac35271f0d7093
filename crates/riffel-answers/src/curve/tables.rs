//! Shifts of the wheelsets, and creepages and forces of the wheels, for a reader.

use riffel_keys::{Message, number, say};

use super::equilibrium::{Creep, Forces, Wheel, Wheelset};
use crate::number_alone;
use crate::side::side;
use crate::{Column, Rows, Table};

/// Shift and yaw of each wheelset.
pub(super) fn wheelsets(wheelsets: &[Wheelset]) -> Table {
    Table {
        name: "wheelsets",
        columns: vec![
            Column::shown(say!(wheelset_column), (1..=wheelsets.len()).map(number_alone).collect()),
            wheelsets.digits(say!(shift_column), 3, |wheelset| 1e3 * wheelset.lateral_shift_m),
            wheelsets.digits(say!(yaw_column), 3, |wheelset| 1e3 * wheelset.yaw_rad),
            wheelsets.digits(say!(angle_of_attack_column), 3, |wheelset| 1e3 * wheelset.angle_of_attack_rad),
        ],
    }
}

/// Creepages and forces of each wheel, and of its second contact.
pub(super) fn wheels(wheels: &[Wheel]) -> Table {
    let contacts: Vec<(Message, &Creep, &Forces)> = (wheels.iter())
        .flat_map(|wheel| {
            let name = say!(wheel_on_rail, wheelset = number(wheel.wheelset), rail = side(wheel.rail));
            let names = [name.clone(), say!(second_contact_of, wheel = name)];
            names.into_iter().zip(wheel.contacts()).map(|(name, (creep, forces))| (name, creep, forces))
        })
        .collect();
    Table {
        name: "wheels",
        columns: vec![
            contacts.shown(say!(wheel_column), |contact| contact.0.clone()),
            contacts.digits(say!(creepage_along_column), 4, |(_, creep, _)| 100.0 * creep.longitudinal_creepage),
            contacts.digits(say!(creeps_across_column), 4, |(_, creep, _)| 100.0 * creep.lateral_creepage),
            contacts.digits(say!(spin_column), 3, |(_, creep, _)| creep.spin_1_per_m),
            contacts.digits(say!(contact_angle_column), 1, |(_, creep, _)| creep.contact_angle_rad.to_degrees()),
            contacts.digits(Message::verbatim("P kN"), 1, |(_, _, forces)| 1e-3 * forces.normal_force_n),
            contacts.digits(Message::verbatim("Qx kN"), 2, |(_, _, forces)| 1e-3 * forces.longitudinal_force_n),
            contacts.digits(Message::verbatim("Qy kN"), 2, |(_, _, forces)| 1e-3 * forces.lateral_force_n),
            contacts.digits(Message::verbatim("|Q|/μP"), 3, |(_, _, forces)| forces.tractive_ratio),
            contacts.digits(Message::verbatim("Tγ N"), 1, |(_, _, forces)| forces.t_gamma_n),
        ],
    }
}
