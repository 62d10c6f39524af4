//! A mesh that a rejected rule breaks, and what else can come of carrying a rule out.

use crate::mesh::{Element, Invalid, Level, Mesh};

/// A mesh that a rejected rule breaks.
#[derive(Clone, Debug)]
pub struct Counterexample {
    /// The op.
    pub op: String,
    /// The rule, where it has a name.
    pub rule: Option<String>,
    /// The diagnostic it goes with, by its code.
    pub code: &'static str,
    /// A valid mesh.
    pub before: Mesh,
    /// The mesh after, as the rewrite, carried out literally, makes of it.
    pub after: Mesh,
    /// The elements of each name: one element, the halfedges of a path, the spokes of a fan.
    pub names: Vec<(String, Vec<Element>)>,
    /// The reason why `after` is no mesh.
    pub invalid: Invalid,
    /// The same with the names of the drawing.
    pub verdict: String,
    /// The level among whose meshes, those that the rule breaks, `before` has the fewest
    /// halfedges; `None` where there are too many to look at. Where names may be one by an `alias`,
    /// the meshes are meant where just the names are one that are here.
    pub smallest_of: Option<Level>,
}

impl Counterexample {
    /// True if the mesh before is what a list of polygons says, so that files of polygons can hold
    /// it.
    pub fn is_polygons(&self) -> bool {
        self.before.is_polygons()
    }
}

/// The outcome of a rejected rule, carried out literally.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It breaks a mesh.
    Breaks(Box<Counterexample>),
    /// It breaks none of so many small meshes.
    Valid(usize),
    /// The drawing contradicts itself, so no mesh matches.
    NoMesh,
    /// It cannot be carried out, or no law about the mesh is broken.
    NotTried,
}
