//! What can be asked of a case.

pub(crate) mod contact;
pub(crate) mod contact_name;
pub(crate) mod damage_of_case;
pub(crate) mod damage_point;
pub(crate) mod discrete_supports;
pub(crate) mod growth_window;
pub(crate) mod numbers;
pub(crate) mod passage;
pub(crate) mod point;
pub(crate) mod resonances;
pub(crate) mod rolling_noise;
pub(crate) mod sensitivity;
pub(crate) mod stability;
pub(crate) mod wheelset_modes;
