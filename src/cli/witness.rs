//! Counterexamples as files.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use super::failure::Failure;
use super::output::eprint_line;
use crate::analysis::Counterexample;
use crate::draw::draw_op;
use crate::mesh::{Dump, MeshFile, write_dump, write_mesh};

/// Writes counterexamples, each under a name of its own.
#[derive(Default)]
pub(super) struct Witnesses {
    /// The number of files that each name has been used for.
    used: BTreeMap<String, usize>,
}

impl Witnesses {
    /// Writes counterexamples to a folder, which is created if necessary.
    pub fn write(&mut self, folder: &Path, examples: &[Counterexample]) -> Result<(), Failure> {
        if examples.is_empty() {
            return Ok(());
        }
        let failed = |error: std::io::Error| {
            Failure::usage(format!("cannot write to `{}`: {error}", folder.display()))
        };
        fs::create_dir_all(folder).map_err(failed)?;
        for example in examples {
            let name = self.name(example);
            let path = folder.join(format!("{name}.halfedges"));
            fs::write(&path, write_dump(&dump(example))).map_err(failed)?;
            eprint_line(&format!("written: {}", path.display()));
            let path = folder.join(format!("{name}.svg"));
            fs::write(&path, draw_op(&example.drawn()).svg()).map_err(failed)?;
            eprint_line(&format!("written: {}", path.display()));
            if example.is_polygons() {
                let path = folder.join(format!("{name}.obj"));
                let obj = MeshFile::from_mesh(example.before.clone());
                write_mesh(&path, &obj).map_err(Failure::usage)?;
                eprint_line(&format!("written: {}", path.display()));
            }
        }
        Ok(())
    }

    /// `collapse-interior-vertex-splits-1`
    fn name(&mut self, example: &Counterexample) -> String {
        let rule: String = example.rule.iter().map(|rule| format!("-{rule}")).collect();
        let name = format!("{}{rule}-{}", example.op, example.code);
        let number = self.used.entry(name.clone()).or_insert(0);
        *number += 1;
        format!("{name}-{number}")
    }
}

fn dump(example: &Counterexample) -> Dump {
    let rule: String = example.rule.iter().map(|rule| format!(", rule {rule}")).collect();
    Dump {
        remarks: vec![
            format!("{}{rule}: {}", example.op, example.code),
            format!("carried out literally: {}", example.verdict),
        ],
        meshes: vec![
            ("before".into(), example.before.clone()),
            ("after".into(), example.after.clone()),
        ],
        names: example.names.clone(),
    }
}
