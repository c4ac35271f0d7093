//! # Files of measured rails
//!
//! Profiles and one-third-octave spectra as instruments write them: told apart by their first lines, read, checked
//! against what rails can be, put right where that is safe. Profiles of wheels and rails across the track, and
//! [frequency responses](response). Limits to hold them to, recipes to synthesise them, and what stands out of the
//! records of a rail over the years.
//!
//! ```
//! use riffel_rail::{Layout, RoughnessFile};
//!
//! # let folder = tempfile::tempdir()?;
//! # let path = folder.path().join("levels.csv");
//! std::fs::write(&path, "wavelength_mm,level_db\n50,2\n40,1\n")?;
//! let RoughnessFile::Spectra(spectra, _) = RoughnessFile::read(&path, &Layout::default(), &|_| ())? else {
//!     panic!("a table of levels");
//! };
//! assert_eq!(spectra[0].spectrum.levels().len(), 2);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod axle_box;
mod built_in;
mod chainage;
mod date;
mod date_column;
mod decay_rate_file;
mod defects;
mod device;
mod format;
mod ground;
pub mod history;
mod input;
mod labelled_spectrum;
mod layout;
mod length_unit;
mod level_unit;
mod limit;
mod line_place;
mod no_rail;
mod part;
mod places;
mod plausibility;
mod profile_columns;
mod profile_file;
mod rail;
mod rail_name;
mod rail_record;
mod rail_spectrum;
mod recipe;
mod record;
mod refusal;
mod resampling;
pub mod response;
mod roughness_file;
mod spectra;
mod survey;
mod transfer_table;
mod unit_remark;
mod wheel_modes_table;
mod wheel_roughness;

pub use axle_box::{AxleBoxFile, AxleBoxLayout, AxleBoxPlace, AxleBoxReading, RunEnd};
pub use date::read_date;
pub use date_column::{ends_of_dates, is_of_time};
pub use decay_rate_file::read_decay_rates;
pub use defects::{DefectsAre, defects_in_words};
pub use device::is_device_column;
pub use format::{Column, ReaderFormat};
pub use ground::GroundRail;
pub use labelled_spectrum::LabelledSpectrum;
pub use layout::Layout;
pub use length_unit::LengthUnit;
pub use limit::{Limit, LimitTable};
pub use line_place::LinePlace;
pub use part::RecordPart;
pub use plausibility::{check_axle_box_levels, levels_unlike_a_rail, unlike_a_rail};
pub use profile_file::{ProfileKind, ProfileOfName, ProfileOrientation, ProfileReading, profile_of, read_profile};
pub use rail::{EarlierRails, Rail};
pub use rail_name::{are_opposite, find_rail, is_rail_column, name_in_words, rail_in_words, rail_of_channel};
pub use rail_record::{RailRecord, RailRoughness};
pub use rail_spectrum::RailSpectrum;
pub use recipe::{DEFAULT_RECIPE, RecipeFile};
pub use record::Record;
pub use riffel_keys::table::{DecimalMark, Delimiter};
pub use roughness_file::RoughnessFile;
pub use survey::{Elapsed, RailDates, Survey};
pub use transfer_table::{TransferPart, TransferTable};
pub use wheel_modes_table::WheelModesTable;
pub use wheel_roughness::WheelRoughness;

#[cfg(test)]
mod written_cells;
