//! The engine: what calls of one program need besides the mesh, kept between calls.

use super::Program;
use super::binding::Bound;
use crate::mesh::{ColumnId, Mesh, Value};
use crate::rewrite::Machine;
use crate::run::Columns;

/// A machine for a program, and the columns of its attributes on the mesh.
pub(super) struct Engine {
    pub(super) program: Program,
    pub(super) machine: Machine,
    /// The columns of the attributes in the mesh, by attribute number.
    pub(super) columns: Vec<Option<ColumnId>>,
    /// The columns whose defaults on the mesh are others than those of the program, with these.
    pub(super) defaults: Vec<(ColumnId, Value)>,
    /// For what the columns of each operation, script or function are known, by its number.
    pub(super) bound_ops: Vec<Bound>,
    pub(super) bound_scripts: Vec<Bound>,
    pub(super) bound_functions: Vec<Bound>,
}

impl Engine {
    pub(super) fn new(program: &Program) -> Self {
        let analysis = &program.0.analysis;
        Self {
            machine: Machine::new(&analysis.plans),
            columns: vec![None; analysis.program.attributes.len()],
            defaults: Vec::new(),
            bound_ops: vec![Bound::No; analysis.program.ops.len()],
            bound_scripts: vec![Bound::No; analysis.program.scripts.len()],
            bound_functions: vec![Bound::No; analysis.program.functions.len()],
            program: program.clone(),
        }
    }

    /// Forgets the columns, which must be looked up again.
    pub(super) fn unbind(&mut self) {
        self.bound_ops.fill(Bound::No);
        self.bound_scripts.fill(Bound::No);
        self.bound_functions.fill(Bound::No);
        self.columns.fill(None);
        self.defaults.clear();
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
