//! What Riffel is held against: reference numbers and published statements, as a table.
//!
//! Each check is one function; the program prints them all, the tests run each under its name and hold its row against
//! the book's table.

mod appendix;
mod checked;
mod classes;
mod contact;
mod contact_filter;
mod curving;
pub mod decay_rate;
mod fastsim;
pub mod field;
mod forecast;
mod general_loop;
mod ground;
mod growth;
mod linear_theory;
mod loaded_contact;
mod noise;
pub mod place_of_wear;
mod points;
mod profile;
mod receptance;
mod reference_file;
mod rolling;
mod roughness;
mod time_domain;
mod transient;
mod twisting_rail;
mod wave_geometry;
mod wheelset;

pub use checked::Checked;
use serde::Serialize;

/// The outcome of one check.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Row {
    /// What is claimed.
    pub statement: &'static str,
    /// Who claims it, and where.
    pub source: &'static str,
    /// The claim in numbers.
    pub expected: String,
    /// What Riffel computes.
    pub got: String,
    /// How far the two may be apart, and why.
    pub tolerance: &'static str,
    /// Whether they agree.
    pub holds: bool,
}

impl Row {
    /// The row of [`markdown()`], with the end of its line.
    fn markdown(&self) -> String {
        let verdict = if self.holds { "holds" } else { "**fails**" };
        format!(
            "| {} | {} | {} | {} | {} | {verdict} |\n",
            self.statement, self.source, self.expected, self.got, self.tolerance
        )
        .replace("|P₁", "\\|P₁")
        .replace("P₀|", "P₀\\|")
    }
}

/// A check with its name.
pub struct Check {
    /// Unique name, that of the test.
    pub name: &'static str,
    /// Run it.
    pub run: fn() -> Row,
}

macro_rules! checks {
    ($($module:ident: $($name:ident),+;)+) => {
        /// Every check, in the order of the paper.
        pub const CHECKS: &[Check] = &[
            $($(Check { name: stringify!($name), run: $module::$name },)+)+
        ];

        #[cfg(test)]
        mod tests {
            $($(
                #[test]
                fn $name() {
                    let row = super::$module::$name();
                    assert!(row.holds, "{row:#?}");
                    let printed = row.markdown();
                    assert!(
                        include_str!("../../docs/src/validation.md").contains(&printed),
                        "docs/src/validation.md is not current (cargo xtask generate); now: {printed}"
                    );
                }
            )+)+
        }
    };
}

checks! {
    points: reference_points;
    receptance: two_layer_receptance, timoshenko_receptance, periodic_receptance_over_support,
        periodic_receptance_mid_span, two_layer_peaks, one_layer_peak, pinned_pinned_antiresonance,
        pinned_pinned_overstated_by_euler, bhaskar_resonance, free_beam_is_the_high_frequency_limit;
    twisting_rail: twisting_rail, twisting_rail_farther_on;
    contact: hertz_semi_axis, exact_hertz_ellipse, kalker_coefficients_linear_theory,
        kalker_coefficients_printed, kalker_coefficients_contact, creep_curve, saturation_creepage,
        creepage_of_four_per_mille;
    rolling: half_space_creep_curve, frequency_response_to_creepage, frequency_response_to_load,
        dissipation_at_the_rail, half_space_creep_forces, frequency_response_across_the_rail,
        frequency_response_at_the_default;
    wave_geometry: waves_in_the_loop_of_the_paper, wave_under_the_half_space, curvature_filter;
    transient: carter_in_two_dimensions, slopes_of_the_half_space, shift_of_cattaneo,
        stiffness_of_mindlin, from_cattaneo_to_carter, frequency_response_by_time;
    contact_filter: contact_filter_of_the_solver, contact_filter_scales_with_the_patch,
        contact_filter_rises_with_the_load, contact_filter_of_long_waves,
        contact_filter_between_bounds, contact_filter_of_remington, contact_filter_approximation;
    fastsim: fastsim_against_the_exact_theory, fastsim_on_first_order_cells, fastsim_with_spin;
    place_of_wear: lag_is_nearest_to_the_exact_contact;
    appendix: moving_load_modulus, moving_load_phase, stationary_lag;
    growth: largest_normal_force, phase_near_300_hz, phase_at_high_frequency,
        ridge_low_traction, ridge_high_traction, growth_at_low_speed, growth_highest_at_highest_speed,
        main_line_on_track_low_traction, extra_line_low_traction,
        main_line_on_track_high_traction, extra_line_high_traction, stiff_pads_lose_the_line,
        minimum_nearly_constant_over_speed, inertia_bounds, limits_bound_all_speeds,
        growth_with_tractive_ratio, not_monotonic_near_full_slip, growth_falls_with_inertia,
        reduced_inertia, lead_is_not_constant_frequency, growth_without_resonance;
    classes: class_of_roaring_rails, class_of_rutting, class_of_contact_fatigue, class_of_booted_sleepers,
        class_of_soft_slabs, class_of_heavy_haul, class_of_light_rail, class_of_cracks_at_p2;
    decay_rate: decay_rate_peak_and_dip, decay_rate_residual, decay_rate_within_the_curves;
    roughness: sinusoid_level, sinusoid_leakage, white_noise_spectrum, coloured_noise_spectrum,
        spikes_and_pits, sinusoids_are_left_alone, moving_statistics, band_pass_error,
        grinding_mark_fades, grinding_mark_is_diagnosed, grinding_mark_is_heard;
    noise: pass_by_level_of_the_site, directive_level_of_the_site, pass_by_bands_of_the_rail,
        wheel_between_rigid_and_ringing, dampers_save_no_more_than_computed;
    wheelset: flexible_wheelset_receptance, flexible_wheelset_natural_frequencies;
    general_loop: loop_on_all_axes, several_wheels_on_one_rail, both_rails_and_flexible_wheelsets;
    time_domain: small_amplitudes, settled_harmonics, loss_of_contact;
    curving: closed_forms_of_curving, linear_steering, saturated_curving, curving_on_flanges;
    profile: wheelset_on_nominal_rails, wheelset_on_measured_rails, conicity_of_a_cubic, equivalent_conicity,
        curving_on_profiles;
    loaded_contact: contact_under_load_on_the_tread, contact_under_load_on_the_flange,
        rolling_on_the_patch_of_profiles, first_touch_under_thirty_newtons;
    forecast: growth_of_levels, mean_over_speeds, wear_coefficient_is_found, fading_mark_is_not_fitted;
}

/// All checks as a Markdown table.
pub fn markdown() -> String {
    let mut text = String::from(
        "| statement | source | expected | Riffel | tolerance and its cause | |\n|---|---|---|---|---|---|\n",
    );
    for check in CHECKS {
        text.push_str(&(check.run)().markdown());
    }
    text
}
