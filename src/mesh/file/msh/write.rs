//! Writing a file.

use std::collections::{HashMap, HashSet};
use std::io::{self, Write};

use crate::mesh::attribute::AttributeType;
use crate::mesh::file::error::FileReason;
use crate::mesh::file::format::MshVersion;
use crate::mesh::file::mesh_file::{MeshFile, WrittenNumbers};
use crate::mesh::file::print::Printer;
use crate::mesh::id::{ElementKind, FaceId};

/// True if a file can hold values of a kind and a type.
pub(in crate::mesh::file) fn is_held(kind: ElementKind, ty: AttributeType) -> bool {
    matches!(kind, ElementKind::Vertex | ElementKind::Face)
        && matches!(ty, AttributeType::Real | AttributeType::Vec3 | AttributeType::Mat3)
}

/// Writes a mesh of triangles and quads.
pub(in crate::mesh::file) fn write(
    output: &mut dyn Write,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> Result<(), FileReason> {
    for (number, &face) in (1..).zip(&numbers.face_order) {
        let sides = file.mesh.face_size(face);
        if !(3..=4).contains(&sides) {
            return Err(FileReason::Unheld(format!(
                "a Gmsh file holds triangles and quads alone, and face {number} has {sides} sides; \
                 triangulate the mesh, or write another format"
            )));
        }
    }
    Writer::new(output, file, numbers).write().map_err(FileReason::Io)
}

/// Gives each group its number in the Gmsh file that was read, or else the one that it has for a
/// name, or else the next that is free.
fn numbered<'n>(names: Vec<&'n [u8]>, known: &HashMap<Vec<u8>, i64>) -> Vec<(&'n [u8], i64)> {
    let own = |name: &[u8]| known.get(name).copied().or_else(|| number_of(name));
    let taken: HashSet<i64> = names.iter().filter_map(|name| own(name)).collect();
    let mut free = (1..).filter(|number| !taken.contains(number));
    let number = |name| own(name).or_else(|| free.next()).unwrap_or(0);
    let numbers: Vec<i64> = names.iter().copied().map(number).collect();
    names.into_iter().zip(numbers).collect()
}

/// The number that the name of a group is.
fn number_of(name: &[u8]) -> Option<i64> {
    let number: i32 = std::str::from_utf8(name).ok()?.parse().ok()?;
    (number != 0 && number.to_string().as_bytes() == name).then_some(number.into())
}

struct Writer<'w> {
    printer: Printer<'w>,
    file: &'w MeshFile,
    numbers: &'w WrittenNumbers,
    /// The physical groups: names and numbers.
    names: Vec<(&'w [u8], i64)>,
    /// The group of each face by its index from 1, 0 for none.
    groups: Vec<usize>,
}

impl<'w> Writer<'w> {
    fn new(output: &'w mut dyn Write, file: &'w MeshFile, numbers: &'w WrittenNumbers) -> Self {
        let mut names: Vec<&[u8]> = Vec::new();
        let mut known = HashMap::new();
        let states = file.states_of(&numbers.face_order);
        let mut group = |at: usize| {
            let state = states.get(at).copied().flatten();
            let name = state.and_then(|state| file.kept.names.get(state.0[1] as usize));
            name.filter(|name| *name != b"default").map_or(0, |name| {
                *known.entry(name).or_insert_with(|| {
                    names.push(name);
                    names.len()
                })
            })
        };
        let groups = (0..numbers.face_order.len()).map(&mut group).collect();
        let names = numbered(names, &file.kept.group_numbers);
        Self { printer: Printer::new(output), file, numbers, names, groups }
    }

    fn write(&mut self) -> io::Result<()> {
        let is_old = self.file.msh_version == MshVersion::V2;
        let version = if is_old { "2.2" } else { "4.1" };
        self.printer.word(&format!("$MeshFormat\n{version} 0 8\n$EndMeshFormat\n"));
        let mut named = self.names.clone();
        named.retain(|&(name, number)| number_of(name) != Some(number));
        if !named.is_empty() {
            self.printer.word(&format!("$PhysicalNames\n{}\n", named.len()));
            for (name, number) in named {
                let text = String::from_utf8_lossy(name);
                let name = text.replace(|c: char| c == '"' || c.is_control(), "_");
                self.printer.word(&format!("2 {number} \"{name}\"\n"));
            }
            self.printer.word("$EndPhysicalNames\n");
        }
        if is_old {
            self.write_old()?;
        } else {
            self.write_new()?;
        }
        self.write_values()?;
        self.printer.flush()
    }

    /// The number of the group with an index from 1; 0 for none.
    fn number(&self, group: usize) -> i64 {
        group.checked_sub(1).map_or(0, |at| self.names[at].1)
    }

    fn position(&mut self, at: usize) {
        let [x, rest @ ..] = self.file.mesh.position(self.numbers.vertex_order[at]).to_array();
        self.printer.real(x);
        self.printer.reals(&rest);
    }

    /// The corners of a face, each with a blank before it.
    fn corners(&mut self, f: FaceId) {
        for v in self.file.mesh.face_vertices(f) {
            self.printer.bytes(b" ");
            self.printer.int(i64::from(self.numbers.vertex(v).unwrap_or(0)));
        }
    }

    fn write_old(&mut self) -> io::Result<()> {
        let (vertices, faces) = (self.numbers.vertex_order.len(), self.numbers.face_order.len());
        self.printer.word(&format!("$Nodes\n{vertices}\n"));
        for at in 0..vertices {
            self.printer.int(at as i64 + 1);
            self.printer.bytes(b" ");
            self.position(at);
            self.printer.end_line()?;
        }
        self.printer.word(&format!("$EndNodes\n$Elements\n{faces}\n"));
        for at in 0..faces {
            let (face, group) = (self.numbers.face_order[at], self.groups[at]);
            let element = self.file.mesh.face_size(face) - 1;
            let number = self.number(group);
            self.printer.word(&format!("{} {element} 2 {number} {}", at + 1, group + 1));
            self.corners(face);
            self.printer.end_line()?;
        }
        self.printer.word("$EndElements\n");
        Ok(())
    }

    fn write_new(&mut self) -> io::Result<()> {
        let (vertices, faces) = (self.numbers.vertex_order.len(), self.numbers.face_order.len());
        // One surface for the faces without a group, and one for each group.
        let [low, high] = self.bounds();
        self.printer.word(&format!("$Entities\n0 0 {} 0\n", self.names.len() + 1));
        for group in 0..=self.names.len() {
            self.printer.int(group as i64 + 1);
            self.printer.reals(&low);
            self.printer.reals(&high);
            let number = self.number(group);
            let physical = if group == 0 { " 0".to_owned() } else { format!(" 1 {number}") };
            self.printer.word(&format!("{physical} 0\n"));
        }
        let blocks = usize::from(vertices > 0);
        let least = blocks;
        self.printer
            .word(&format!("$EndEntities\n$Nodes\n{blocks} {vertices} {least} {vertices}\n"));
        if blocks > 0 {
            self.printer.word(&format!("2 1 0 {vertices}\n"));
        }
        for at in 0..vertices {
            self.printer.int(at as i64 + 1);
            self.printer.end_line()?;
        }
        for at in 0..vertices {
            self.position(at);
            self.printer.end_line()?;
        }
        // The faces keep their order: a block for each run of one group and one size.
        let sizes: Vec<usize> =
            self.numbers.face_order.iter().map(|&f| self.file.mesh.face_size(f)).collect();
        let places: Vec<usize> = (0..faces).collect();
        let groups = self.groups.clone();
        let is_alike = |&a: &usize, &b: &usize| groups[a] == groups[b] && sizes[a] == sizes[b];
        let blocks = places.chunk_by(is_alike).count();
        let least = usize::from(faces > 0);
        self.printer.word(&format!("$EndNodes\n$Elements\n{blocks} {faces} {least} {faces}\n"));
        for block in places.chunk_by(is_alike) {
            let (first, count) = (block[0], block.len());
            let (group, element) = (groups[first], sizes[first] - 1);
            self.printer.word(&format!("2 {} {element} {count}\n", group + 1));
            for &at in block {
                self.printer.int(at as i64 + 1);
                self.corners(self.numbers.face_order[at]);
                self.printer.end_line()?;
            }
        }
        self.printer.word("$EndElements\n");
        Ok(())
    }

    fn bounds(&self) -> [[f64; 3]; 2] {
        let mut at = self.numbers.vertex_order.iter().map(|&v| self.file.mesh.position(v));
        let first = at.next().unwrap_or_default();
        let bounds = at.fold([first; 2], |[low, high], at| [low.min(at), high.max(at)]);
        bounds.map(|bound| bound.to_array())
    }

    fn write_values(&mut self) -> io::Result<()> {
        let kinds = [(ElementKind::Vertex, "NodeData"), (ElementKind::Face, "ElementData")];
        for (kind, section) in kinds {
            let columns = self.file.mesh.columns(kind);
            let held = columns.filter(|(_, c)| c.is_public() && is_held(kind, c.attribute_type()));
            for (id, column) in held {
                let width = column.default_value().reals().len();
                let order: Vec<u32> = match kind {
                    ElementKind::Vertex => self.numbers.vertex_order.iter().map(|v| v.0).collect(),
                    _ => self.numbers.face_order.iter().map(|f| f.0).collect(),
                };
                self.printer.word(&format!(
                    "${section}\n1\n\"{}\"\n1\n0\n3\n0\n{width}\n{}\n",
                    column.name(),
                    order.len()
                ));
                for (tag, index) in (1..).zip(order) {
                    self.printer.int(tag);
                    if let Some(value) = self.file.mesh.value(id, index) {
                        self.printer.reals(value.reals());
                    }
                    self.printer.end_line()?;
                }
                self.printer.word(&format!("$End{section}\n"));
            }
        }
        Ok(())
    }
}
