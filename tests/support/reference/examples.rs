//! The programs of the examples, and each rule in isolation.

use std::path::{Path, PathBuf};

use hedgerow::diagram::{Op, Rule, Type};
use hedgerow::mesh::Mesh;

/// The programs of the examples, in the order of their names.
pub fn examples() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let entries = std::fs::read_dir(folder).expect("the examples");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    let mut paths: Vec<_> =
        paths.filter(|path| path.extension().is_some_and(|end| end == "hedge")).collect();
    paths.sort();
    paths
}

/// The op with one rule, without requirements, value parameters and result; unnamed elements get
/// names.
pub fn alone(op: &Op, rule: &Rule) -> Op {
    let mut base = op.clone();
    let mut rule = rule.clone();
    rule.requires.clear();
    rule.result = None;
    base.result = None;
    let kept = (0..op.params.len()).filter(|&at| op.params[at].ty.is_element());
    let kept: Vec<_> = kept.collect();
    base.params = kept.iter().map(|&at| op.params[at].clone()).collect();
    rule.params = kept.iter().map(|&at| rule.params[at]).collect();
    for (at, name) in rule.names.iter_mut().enumerate() {
        if !name.named {
            name.text = format!("W{at}");
            name.named = true;
        }
    }
    base.rules = vec![rule];
    base
}

/// The elements of a kind.
pub fn elements(mesh: &Mesh, ty: Type) -> Vec<u32> {
    match ty {
        Type::Vertex => mesh.vertices().map(|v| v.0).collect(),
        Type::Halfedge => mesh.halfedges().map(|h| h.0).collect(),
        Type::Edge => mesh.edges().map(|e| e.0).collect(),
        Type::Face => mesh.faces().map(|f| f.0).collect(),
        _ => Vec::new(),
    }
}
