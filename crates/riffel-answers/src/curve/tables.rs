//! Shifts of the wheelsets, and creepages and forces of the wheels, for a reader.

use riffel_keys::{Message, number, say};

use super::equilibrium::{Creep, Forces, Wheel, Wheelset};
use crate::number_alone;
use crate::side::side;
use crate::{Column, Table};

/// Shift and yaw of each wheelset.
pub(super) fn wheelsets(wheelsets: &[Wheelset]) -> Table {
    let thousandths =
        |head, of: fn(&Wheelset) -> f64| Column::digits(head, 3, wheelsets.iter().map(|wheelset| 1e3 * of(wheelset)));
    Table {
        name: "wheelsets",
        columns: vec![
            Column::shown(say!(wheelset_column), (1..=wheelsets.len()).map(number_alone).collect()),
            thousandths(say!(shift_column), |wheelset| wheelset.lateral_shift_m),
            thousandths(say!(yaw_column), |wheelset| wheelset.yaw_rad),
            thousandths(say!(angle_of_attack_column), |wheelset| wheelset.angle_of_attack_rad),
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
    let column = |head, digits: usize, of: &dyn Fn(&Creep, &Forces) -> f64| {
        Column::digits(head, digits, contacts.iter().map(|(_, creep, forces)| of(creep, forces)))
    };
    Table {
        name: "wheels",
        columns: vec![
            Column::shown(say!(wheel_column), contacts.iter().map(|contact| contact.0.clone()).collect()),
            column(say!(creepage_along_column), 4, &|creep, _| 100.0 * creep.longitudinal_creepage),
            column(say!(creeps_across_column), 4, &|creep, _| 100.0 * creep.lateral_creepage),
            column(say!(spin_column), 3, &|creep, _| creep.spin_1_per_m),
            column(say!(contact_angle_column), 1, &|creep, _| creep.contact_angle_rad.to_degrees()),
            column(Message::verbatim("P kN"), 1, &|_, forces| 1e-3 * forces.normal_force_n),
            column(Message::verbatim("Qx kN"), 2, &|_, forces| 1e-3 * forces.longitudinal_force_n),
            column(Message::verbatim("Qy kN"), 2, &|_, forces| 1e-3 * forces.lateral_force_n),
            column(Message::verbatim("|Q|/μP"), 3, &|_, forces| forces.tractive_ratio),
            column(Message::verbatim("Tγ N"), 1, &|_, forces| forces.t_gamma_n),
        ],
    }
}
