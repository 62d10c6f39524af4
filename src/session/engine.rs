//! The engine: what calls of one program need besides the mesh, kept between calls.

use super::Program;
use crate::mesh::{ColumnId, Mesh};
use crate::rewrite::Machine;
use crate::run::Columns;

/// A machine for a program, and the columns of its attributes on the mesh.
pub(super) struct Engine {
    pub(super) program: Program,
    pub(super) machine: Machine,
    /// The columns of the attributes in the mesh, by attribute number.
    pub(super) columns: Vec<Option<ColumnId>>,
    /// Whether the columns of each operation, script or function are on the mesh, by its number.
    pub(super) bound_ops: Vec<bool>,
    pub(super) bound_scripts: Vec<bool>,
    pub(super) bound_functions: Vec<bool>,
}

impl Engine {
    pub(super) fn new(program: &Program) -> Self {
        let analysis = &program.0.analysis;
        Self {
            machine: Machine::new(&analysis.plans),
            columns: vec![None; analysis.program.attributes.len()],
            bound_ops: vec![false; analysis.program.ops.len()],
            bound_scripts: vec![false; analysis.program.scripts.len()],
            bound_functions: vec![false; analysis.program.functions.len()],
            program: program.clone(),
        }
    }

    /// Forgets the columns, which must be looked up again.
    pub(super) fn unbind(&mut self) {
        self.bound_ops.fill(false);
        self.bound_scripts.fill(false);
        self.bound_functions.fill(false);
        self.columns.fill(None);
    }

    /// Removes the scratch attributes of the program from a mesh.
    pub(super) fn release(&self, mesh: &mut Mesh) {
        let parts = &self.program.0;
        let ops = parts.applications.iter().filter_map(|op| op.get()?.as_ref().ok());
        let ops = ops.map(|op| op.columns());
        let scripts = parts.scripts.iter().chain(&parts.functions);
        let scripts = scripts.filter_map(|script| script.get()?.as_ref().ok());
        let all = ops.chain(scripts.map(|script| script.columns()));
        all.for_each(|columns: &Columns| columns.release(mesh));
    }
}
