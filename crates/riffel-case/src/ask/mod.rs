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

pub use contact_name::contact_names;
pub use damage_of_case::{has_shear_yield, limit_name, shakedown_limit, shakedown_limit_of, shear_yield};
pub use discrete_supports::{growth_on_irregular_supports, growth_with_neighbours};
pub use growth_window::{fastest_under, growth_window, shortest_told, told_of};
pub use passage::contacts::transient_contact;
pub use passage::{in_time, in_time_without_profile, passing_wheel};
pub use resonances::{p2, p2_closed_form, resonances};
pub use rolling_noise::without_decay;
pub use sensitivity::sensitivities;
pub use stability::{remarks_at, remarks_at_point, stability, stability_over_the_map};
pub use wheelset_modes::wheelset_modes;
