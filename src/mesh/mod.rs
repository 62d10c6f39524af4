//! Halfedge meshes: what the language works on, independent of the language.
//!
//! A mesh is three kinds of orbit of halfedges. Every halfedge lies in one cycle of
//! `next`, its face; in one pair of `twin`s, its edge; and in one cycle of next-spoke,
//! counterclockwise `h -> h.prev.twin`, its vertex. Boundaries are loops too: a hole is
//! a face with a flag, so that on a valid mesh no pointer of a halfedge is missing.
//!
//! The tables store whatever is written. `validate` checks whether they are a mesh, and the levels
//! how regular a mesh. Operations are not here.

// The tables.
mod allocation;
mod attribute;
mod columns;
mod connectivity;
mod id;
mod journal;
mod memory;
mod notes;
mod order;
mod pointers;
mod records;
#[cfg(feature = "native")]
pub(crate) mod tables;

// Queries.
mod adjacency;
mod component;
mod difference;
mod displaced;
mod ears;
mod equality;
mod geometry;
mod history;
mod identical;
mod in_order;
mod invalid;
mod kernel;
mod level;
mod level_near;
mod link;
mod lookahead;
mod orbit_condition;
mod summary;
pub mod validate;
mod walk;

// Construction, conversion and files.
mod arrays;
mod binary;
mod build;
mod build_error;
mod compaction;
mod dump;
mod faults;
mod file;
mod loops;
pub(crate) mod parallel;
mod polygon_sides;
mod polygons;
mod prefetch;
mod repair;
pub mod shape;

/// The crate of the vectors and matrices of positions and attributes.
pub use glam;

pub(crate) use adjacency::Adjacency;
pub use arrays::NotATriangle;
pub use attribute::{
    Attribute, AttributeType, Column, ColumnConflict, ColumnData, ColumnId, Value, is_public_name,
};
pub use binary::{BinaryError, read_bytes, write_bytes};
pub use build_error::BuildError;
pub use connectivity::Mesh;
pub use difference::{Difference, difference};
pub use displaced::{Displaced, Places, Unset};
pub use dump::{Dump, DumpError, DumpReason, read_dump, write_dump};
pub use equality::{equal_up_to_renumbering, same_connectivity, same_up_to_renumbering};
pub use faults::{FaultKind, Faults};
pub use file::{
    BareFaces, Encoding, FileError, FileFaultKind, FileFaults, FileFormat, FileReason, Loss,
    LostValues, Material, MeshFile, MshVersion, WantedAttribute, WrittenNumbers, expect_writable,
    open_file, read_mesh, read_mesh_from, read_mesh_reordered, replace_file, write_mesh,
    write_mesh_to, write_mesh_unless,
};
pub use geometry::direction;
pub(crate) use geometry::is_inside;
pub use history::History;
#[doc(hidden)]
pub use id::Elements;
pub use id::{EdgeId, Element, ElementKind, FaceId, HalfedgeId, OtherKind, VertexId};
pub use identical::{identical, identical_but_for_scratch};
pub use invalid::Invalid;
pub use level::{BelowLevel, Level, highest_level, validate_level};
pub(crate) use level::{level_of_polygons, validate_level_of_valid};
pub(crate) use level_near::Orbits;
pub use level_near::{Footprint, validate_level_near};
pub use notes::{Bookmark, Written};
pub use orbit_condition::OrbitCondition;
#[cfg(feature = "threads")]
pub use parallel::set_threads;
pub use parallel::threads;
pub use polygons::Polygons;
pub(crate) use prefetch::prefetch;
pub use records::HalfedgeRecord;
pub use repair::{Repair, RepairReport, Repaired};
pub use summary::{AttributeSummary, Bin, Lengths, Measures, Summary};
pub use validate::validate;
pub use walk::{LoopWalk, SpokeWalk};
