//! A mesh that a rejected rule breaks, and the other outcomes of carrying a rule out.

use crate::mesh::{Element, Invalid, Level, Mesh};

/// A mesh that a rejected rule breaks.
#[derive(Clone, Debug)]
pub struct Counterexample {
    pub op: String,
    /// The rule, where it has a name.
    pub rule: Option<String>,
    /// The diagnostic it goes with, by its code.
    pub code: &'static str,
    /// A valid mesh.
    pub before: Mesh,
    /// The mesh after the rewrite, carried out literally.
    pub after: Mesh,
    /// The elements of each name: one element, the halfedges of a path, the spokes of a fan.
    pub names: Vec<(String, Vec<Element>)>,
    /// The reason why `after` is not valid.
    pub invalid: Invalid,
    /// The same in words, with the names of the drawing.
    pub verdict: String,
    /// The level for which `before` has the fewest halfedges of all meshes that the rule breaks;
    /// `None` if there are too many to examine. If an `alias` lets names be one, only meshes where
    /// the same names are one as here are compared.
    pub smallest_of: Option<Level>,
}

impl Counterexample {
    /// True if `before` is determined by a list of polygons, so that files of polygons can hold it.
    pub fn is_polygons(&self) -> bool {
        self.before.is_polygons()
    }
}

/// The outcome of a rejected rule, carried out literally.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It breaks a mesh.
    Breaks(Box<Counterexample>),
    /// It breaks none of this number of small meshes.
    Valid(usize),
    /// The drawing contradicts itself, so no mesh matches.
    NoMesh,
    /// It cannot be carried out, or no law about the mesh is broken.
    NotTried,
}
