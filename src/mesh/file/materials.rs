//! The colours of materials, from the libraries (`.mtl`) that an OBJ file names.
//!
//! A library is looked up in the folder of the file. Since its name comes from an untrusted file,
//! only regular files of a moderate size are opened.

use std::collections::HashMap;
use std::path::{Path, PathBuf};

use glam::DVec3;

use super::mesh_file::MeshFile;
use crate::mesh::attribute::Value;
use crate::mesh::id::{ElementKind, FaceId};

/// The maximum size of a library, in bytes.
const LARGEST: u64 = 1 << 26;

/// A material of a library.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    pub name: String,
    /// The diffuse colour (`Kd`).
    pub color: Option<DVec3>,
}

impl MeshFile {
    /// The materials of the libraries that the file names, and the libraries that cannot be read.
    pub fn read_materials(&self) -> (Vec<Material>, Vec<String>) {
        let (mut materials, mut missing) = (Vec::new(), Vec::new());
        for library in &self.kept.libraries {
            let name = String::from_utf8_lossy(library).into_owned();
            // One statement may name several libraries, and a name may contain blanks.
            let words = name.split_ascii_whitespace().collect::<Vec<_>>();
            let read = self.read_library(&name).or_else(|| {
                let parts = words.iter().map(|word| self.read_library(word));
                Some(parts.collect::<Option<Vec<_>>>()?.concat())
            });
            match read {
                Some(read) => materials.extend(read),
                None => missing.push(name),
            }
        }
        (materials, missing)
    }

    fn read_library(&self, name: &str) -> Option<Vec<Material>> {
        let path: PathBuf = self.folder.as_ref()?.join(Path::new(name));
        let facts = std::fs::metadata(&path).ok()?;
        if !facts.is_file() || facts.len() > LARGEST {
            return None;
        }
        let text = std::fs::read(path).ok()?;
        let (materials, _) = tobj::load_mtl_buf(&mut text.as_slice()).ok()?;
        let materials = materials.into_iter().map(|material| Material {
            name: material.name,
            color: material.diffuse.map(DVec3::from_array),
        });
        Some(materials.collect())
    }

    /// Makes a column of face colours from the materials, if the libraries have any.
    pub(super) fn bring_face_colors(&mut self, default: Value) {
        if !matches!(default, Value::Vec3(_)) || self.kept.libraries.is_empty() {
            return;
        }
        let (materials, _) = self.read_materials();
        let colors: HashMap<&[u8], DVec3> = materials
            .iter()
            .filter_map(|material| Some((material.name.as_bytes(), material.color?)))
            .collect();
        let color = |f: FaceId| {
            let place = self.kept.state(self.face_number(f)? - 1).0[2];
            colors.get(self.kept.names.get(place as usize)?.as_slice()).copied()
        };
        let found: Vec<_> = self.mesh.faces().filter_map(|f| Some((f, color(f)?))).collect();
        if found.is_empty() {
            return;
        }
        if let Ok(column) = self.mesh.add_column(ElementKind::Face, "color", default) {
            for (f, color) in found {
                self.mesh.put_value(column, f.0, Value::Vec3(color));
            }
        }
    }
}
