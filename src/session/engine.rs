//! The engine: what calls of one program need besides the mesh, kept from call to call.

use super::Program;
use crate::mesh::{ColumnId, Mesh};
use crate::rewrite::Machine;
use crate::run::Columns;

/// A machine for a program, and where on the mesh the attributes of that lie.
pub(super) struct Engine {
    pub(super) program: Program,
    pub(super) machine: Machine,
    /// The columns of the attributes in the mesh, by number.
    pub(super) columns: Vec<Option<ColumnId>>,
    /// By number whether the columns of an operation, a script or a function are on the mesh.
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

    /// The columns are to be looked for anew.
    pub(super) fn unbind(&mut self) {
        self.bound_ops.fill(false);
        self.bound_scripts.fill(false);
        self.bound_functions.fill(false);
        self.columns.fill(None);
    }

    /// Takes the scratch attributes of the program off a mesh.
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
