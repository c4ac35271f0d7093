//! Figures as pictures: what is drawn where, and the picture as SVG and PNG.

pub(crate) mod axis;
mod bar;
mod collision;
mod color_bar;
mod contours;
mod font;
mod frame;
mod legend;
pub(crate) mod line;
pub(crate) mod map;
pub(crate) mod map_marks;
mod mark_name;
pub(crate) mod marker;
mod picture;
mod png;
mod point;
mod sheet;
mod sheet_box;
mod strip;
pub(crate) mod subscript;
mod svg;
pub(crate) mod text;

pub use collision::collisions;
pub use picture::Picture;
pub use png::DEFAULT_PNG_SCALE;
