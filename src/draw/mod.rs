//! Pictures of operations and small meshes.
//!
//! [`draw_op`] makes a [`Picture`] of an operation as in a textbook: before and after side by side,
//! the same vertex at the same place, halfedges as arrows inside their faces; colour and stroke
//! distinguish what is kept, reassigned, new and erased. A picture is written as SVG or PNG. Texts
//! are built-in outlines of letters, so no fonts are needed. [`text_op`] draws with characters,
//! `page` makes a page of many operations, and [`draw_mesh`] shows a mesh. Any drawing has a
//! picture, proved or not.

// What is drawn.
mod after_layout;
mod assigned;
mod components;
mod example;
mod family_sector;
mod figure;
mod hanging;
mod layout;
mod opened;
mod outer;
mod routing;
mod split_vertices;
mod status;

// How it is drawn.
mod arrows;
mod curve;
mod curve_fit;
mod fan;
mod hatch;
mod label_boxes;
mod label_positions;
mod letters;
mod shape;

mod faces;
mod panel;
mod stars;
mod strands;

mod sheet;

// A mesh.
mod colours;
pub mod raster;
mod view;
pub mod viridis;

// Output formats.
mod compact;
mod page;
mod png;
mod steps;
mod svg;
mod text;
mod words;

#[cfg(feature = "play")]
pub(crate) use colours::{Colours, Key};
pub use page::{Section, page};
pub use png::TooLarge;
pub use shape::{Picture, TextBox};
pub use sheet::{draw_op, draw_sheet};
pub use status::fates;
pub use text::{COLUMNS, text_op};
pub use view::{View, draw_mesh};
