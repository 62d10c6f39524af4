//! Writing a file.

use std::io::{self, Write};

use glam::DVec3;

use crate::mesh::attribute::{AttributeType, ColumnId};
use crate::mesh::file::corners::{Corners, OfCorner};
use crate::mesh::file::kept::State;
use crate::mesh::file::mesh_file::{MeshFile, WrittenNumbers};
use crate::mesh::file::print::{PART, Printer};
use crate::mesh::id::{ElementKind, FaceId, VertexId};

/// Writes the text of a mesh.
pub(in crate::mesh::file) fn write(
    output: &mut dyn Write,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> io::Result<()> {
    let mut printer = Printer::new(output);
    for library in &file.kept.libraries {
        statement(&mut printer, "mtllib", library);
    }
    write_vertices(&mut printer, file, numbers)?;
    let corners = [OfCorner::Texture, OfCorner::Normal];
    let corners = corners.map(|what| Corners::of(file, what, &numbers.face_order));
    for (keyword, corners) in ["vt", "vn"].into_iter().zip(&corners) {
        let table = corners.rows();
        printer.in_parts(table.rows.len(), |printer, part| {
            table.rows[part].iter().try_for_each(|row| {
                printer.word(keyword);
                printer.reals(&row[..table.width]);
                printer.end_line()
            })
        })?;
    }
    let states = file.states_of(&numbers.face_order);
    let starts = states_of_parts(file, &states);
    printer.in_parts(numbers.face_order.len(), |printer, part| {
        let mut current = starts.get(part.start / PART).copied().unwrap_or(State::EMPTY);
        part.into_iter().try_for_each(|at| {
            if let Some(state) = states.get(at).copied().flatten() {
                write_state(printer, file, &mut current, state);
            }
            write_face(printer, file, numbers, &corners, numbers.face_order[at]);
            printer.end_line()
        })
    })?;
    printer.flush()
}

/// The statements in force where each part of the faces begins, given those of the faces.
fn states_of_parts(file: &MeshFile, states: &[Option<State>]) -> Vec<State> {
    let mut current = State::EMPTY;
    let mut parts = Vec::new();
    for part in states.chunks(PART) {
        parts.push(current);
        let mut printer = Printer::gathering();
        for &state in part.iter().flatten() {
            write_state(&mut printer, file, &mut current, state);
        }
    }
    parts
}

/// The columns that follow the coordinates: colour, alpha, weight.
pub(in crate::mesh::file) fn vertex_columns(file: &MeshFile) -> [Option<ColumnId>; 3] {
    let real = |name| {
        let of_type = |ty| ty == AttributeType::Real;
        file.column_of_type(ElementKind::Vertex, name, of_type)
    };
    match file.color() {
        Some(color) => [Some(color), real("alpha"), None],
        None => [None, None, real("weight")],
    }
}

fn write_vertices(
    printer: &mut Printer,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> io::Result<()> {
    let [color, alpha, weight] = vertex_columns(file);
    let colors = color.and_then(|column| file.mesh.values::<DVec3>(column));
    let reals = |column: Option<ColumnId>| column.and_then(|id| file.mesh.values::<f64>(id));
    let (alphas, weights) = (reals(alpha), reals(weight));
    let vertex = |printer: &mut Printer, v: VertexId| {
        printer.bytes(b"v");
        printer.reals(&file.mesh.position(v).to_array());
        if let Some(color) = colors.and_then(|colors| colors.get(v.index())) {
            printer.reals(&color.to_array());
        }
        let last = [alphas, weights].map(|values| values.and_then(|values| values.get(v.index())));
        for value in last.into_iter().flatten().filter(|&&value| alphas.is_some() || value != 1.0) {
            printer.reals(&[*value]);
        }
        printer.end_line()
    };
    printer.in_parts(numbers.vertex_order.len(), |printer, part| {
        numbers.vertex_order[part].iter().try_for_each(|&v| vertex(printer, v))
    })
}

fn write_state(printer: &mut Printer, file: &MeshFile, current: &mut State, state: State) {
    for (i, keyword) in State::KEYWORDS.into_iter().enumerate() {
        if state.0[i] == current.0[i] {
            continue;
        }
        if let Some(name) = file.kept.names.get(state.0[i] as usize) {
            statement(printer, keyword, name);
        } else if keyword == "s" {
            statement(printer, keyword, b"off");
        } else if keyword == "g" {
            statement(printer, keyword, b"default");
        } else {
            continue; // nothing takes an object or a material back
        }
        current.0[i] = state.0[i];
    }
}

/// A statement with a name as operand, altered where it would not be read back as one.
fn statement(printer: &mut Printer, keyword: &str, operand: &[u8]) {
    printer.word(keyword);
    let mut before = b' ';
    if !operand.is_empty() {
        printer.bytes(b" ");
    }
    for &byte in operand {
        let byte = if byte.is_ascii_control() { b' ' } else { byte };
        if byte == b'#' && before == b' ' {
            printer.bytes(b"_"); // it would begin a comment
        }
        printer.bytes(&[byte]);
        before = byte;
    }
    if before == b'\\' {
        printer.bytes(b" #"); // or the next line were the rest of this one
    }
    printer.bytes(b"\n");
}

/// A face, with texture coordinates if all its corners have one, and normals likewise.
fn write_face(
    printer: &mut Printer,
    file: &MeshFile,
    numbers: &WrittenNumbers,
    [texture, normals]: &[Corners; 2],
    f: FaceId,
) {
    let (with_texture, with_normals) = (texture.cover(&file.mesh, f), normals.cover(&file.mesh, f));
    let number = |corners: &Corners, h| i64::from(corners.row(h).map_or(0, |row| row + 1));
    printer.bytes(b"f");
    for h in file.mesh.face_halfedges(f) {
        printer.bytes(b" ");
        printer.int(i64::from(numbers.vertex(file.mesh.vertex(h)).unwrap_or(0)));
        if with_texture || with_normals {
            printer.bytes(b"/");
        }
        if with_texture {
            printer.int(number(texture, h));
        }
        if with_normals {
            printer.bytes(b"/");
            printer.int(number(normals, h));
        }
    }
}
