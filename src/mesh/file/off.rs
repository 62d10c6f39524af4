//! The object file format of Geomview: `OFF`, with the prefixes `ST` (texture coordinates), `C`
//! (colours) and `N` (normals) of what stands behind the coordinates of each vertex.
//!
//! Numbers stand free, but for those behind a face and its corners: what is left of that line is
//! its colour. Colours are of 3 or 4 numbers, up to 1 or up to 255. There is no crate that reads
//! them. Four coordinates and binary files are refused.

use std::io::{self, Write};

use glam::{DVec2, DVec3};

use super::contents::{Contents, FileColumn};
use super::error::{Failure, FileReason};
use super::format::Encoding;
use super::kept::MISSING;
use super::mesh_file::{MeshFile, WrittenNumbers};
use super::print::Printer;
use super::scan::{Scanner, shown};
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::id::ElementKind;
use crate::mesh::polygons::Polygons;

/// Reads a file.
pub(super) fn read(text: &[u8]) -> Result<Contents, Failure> {
    let mut reader = Reader { scanner: Scanner::new(text), contents: Contents::default() };
    reader.contents.encoding = Encoding::Ascii;
    let read = reader.file();
    let line = Some(reader.scanner.line());
    read.map_err(|words| (line, FileReason::Malformed(words)))?;
    Ok(reader.contents)
}

struct Reader<'t> {
    scanner: Scanner<'t>,
    contents: Contents,
}

/// What stands behind the coordinates of a vertex.
#[derive(Clone, Copy, Default)]
struct Prefixes {
    texture: bool,
    color: bool,
    normal: bool,
}

/// Colours as they stand in the file: four numbers for each element.
#[derive(Default)]
struct Colors {
    reals: Vec<f64>,
    has_alpha: bool,
    bare: usize,
}

impl Colors {
    fn push(&mut self, color: &[f64]) {
        if color.len() < 3 {
            self.bare += 1;
        }
        self.has_alpha |= color.len() > 3;
        let channel = |at: usize| color.get(at).copied().unwrap_or(f64::NAN);
        self.reals.extend([0, 1, 2, 3].map(channel));
    }

    fn columns(self, kind: ElementKind, contents: &mut Contents) {
        let count = self.reals.len() / 4;
        if count == self.bare {
            return;
        }
        let what = format!("{} without a colour, which are white now", kind.plural());
        contents.kept.note_count(&what, self.bare);
        let most = self.reals.iter().copied().fold(0.0, f64::max);
        let scale = if most > 1.0 { 255.0 } else { 1.0 };
        let channel = |value: f64| if value.is_nan() { 1.0 } else { value / scale };
        let (rows, _) = self.reals.as_chunks::<4>();
        let color = rows.iter().flat_map(|row| [row[0], row[1], row[2]].map(channel)).collect();
        let white = Value::Vec3(DVec3::ONE);
        contents.columns.push(FileColumn::new(kind, "color", white, color));
        if self.has_alpha && rows.iter().any(|row| channel(row[3]) != 1.0) {
            let alpha = rows.iter().map(|row| channel(row[3])).collect();
            contents.columns.push(FileColumn::new(kind, "alpha", Value::Real(1.0), alpha));
        }
    }
}

impl Reader<'_> {
    fn file(&mut self) -> Result<(), String> {
        let prefixes = self.head()?;
        let [vertices, faces, _] = self.counts()?;
        self.vertices(vertices, prefixes)?;
        self.faces(faces)
    }

    /// The first word, which may be left out.
    fn head(&mut self) -> Result<Prefixes, String> {
        if !self.scanner.next_line() {
            return Err("the file is empty".into());
        }
        if self.scanner.rest()[0].is_ascii_digit() && !self.scanner.rest().starts_with(b"4OFF") {
            return Ok(Prefixes::default());
        }
        let word = self.scanner.word().unwrap_or_default();
        let unknown = || format!("`{}` is not `OFF`, with a prefix or without", shown(word));
        let mut rest = word.strip_suffix(b"OFF").ok_or_else(unknown)?;
        let mut prefixes = Prefixes::default();
        for (prefix, flag) in [
            (&b"ST"[..], &mut prefixes.texture),
            (b"C", &mut prefixes.color),
            (b"N", &mut prefixes.normal),
        ] {
            if let Some(behind) = rest.strip_prefix(prefix) {
                (*flag, rest) = (true, behind);
            }
        }
        match rest {
            b"" => Ok(prefixes),
            b"4" | b"n" | b"4n" => {
                Err(format!("`{}`: only three coordinates are read", shown(word)))
            }
            _ => Err(unknown()),
        }
    }

    fn counts(&mut self) -> Result<[usize; 3], String> {
        let mut counts = [0; 3];
        for (at, count) in counts.iter_mut().enumerate() {
            // The number of edges may be left out.
            if at == 2 && !self.scanner.next_word() {
                break;
            }
            let left = self.scanner.rest().len();
            let number = self.next("the numbers of vertices, faces and edges")?;
            if number.fract() != 0.0 || number < 0.0 || (at < 2 && number > left as f64) {
                return Err(format!(
                    "the head speaks of {number} {}, and the file has {left} bytes more",
                    ["vertices", "faces", "edges"][at]
                ));
            }
            *count = number as usize;
        }
        Ok(counts)
    }

    /// The next number, in this line or a later one.
    fn next(&mut self, wanted: &str) -> Result<f64, String> {
        if !self.scanner.next_line() {
            return Err(format!("the file ends where {wanted} should stand"));
        }
        match self.scanner.number() {
            Some(Ok(number)) => Ok(number),
            Some(Err(b"BINARY")) => Err("binary OFF files are not read".into()),
            Some(Err(word)) => Err(format!("`{}` stands where {wanted} should", shown(word))),
            None => Err(format!("the file ends where {wanted} should stand")),
        }
    }

    fn vertices(&mut self, count: usize, prefixes: Prefixes) -> Result<(), String> {
        let (mut normals, mut textures) = (Vec::new(), Vec::new());
        let mut colors = Colors::default();
        for _ in 0..count {
            let mut numbers = [0.0; 3];
            for number in &mut numbers {
                *number = self.next("a coordinate")?;
            }
            self.contents.positions.push(DVec3::from_array(numbers));
            self.contents.vertex_lines.push(self.scanner.line());
            if prefixes.normal {
                for _ in 0..3 {
                    normals.push(self.next("a normal")?);
                }
            }
            // Some programs write three numbers for a colour, some four.
            let mut rest = Vec::new();
            while (prefixes.color || prefixes.texture) && rest.len() < 6 && self.scanner.next_word()
            {
                rest.push(self.next("a colour")?);
            }
            if prefixes.texture {
                let at = rest.len().checked_sub(2).ok_or("texture coordinates are missing")?;
                textures.extend(rest.drain(at..));
            }
            if prefixes.color {
                colors.push(&rest);
            }
        }
        let mut add = |name, default, reals: Vec<f64>| {
            if !reals.is_empty() {
                let column = FileColumn::new(ElementKind::Vertex, name, default, reals);
                self.contents.columns.push(column);
            }
        };
        add("normal", Value::Vec3(DVec3::ZERO), normals);
        add("uv", Value::Vec2(DVec2::ZERO), textures);
        colors.columns(ElementKind::Vertex, &mut self.contents);
        Ok(())
    }

    fn faces(&mut self, count: usize) -> Result<(), String> {
        let mut corners = Vec::new();
        let mut ends = Vec::with_capacity(count);
        let mut colors = Colors::default();
        let vertices = self.contents.positions.len();
        for _ in 0..count {
            let sides = self.next("the number of corners of a face")?;
            if sides.fract() != 0.0 || !(0.0..=1e9).contains(&sides) {
                return Err(format!("{sides} is no number of corners"));
            }
            let line = self.scanner.line();
            for _ in 0..sides as usize {
                let index = self.next("a vertex of a face")?;
                let is_known = index.fract() == 0.0 && (0.0..vertices as f64).contains(&index);
                if !is_known {
                    self.contents.strays.add(Some(line), || {
                        format!("there is no vertex {index}: there are {vertices}, counted from 0")
                    });
                }
                corners.push(if is_known { index as u32 } else { MISSING });
            }
            ends.push(corners.len());
            self.contents.face_lines.push(line);
            let mut color = Vec::new();
            while color.len() < 4 && self.scanner.next_word() {
                color.push(self.next("a colour")?);
            }
            if color.len() < 3 && !color.is_empty() {
                self.contents.kept.note("faces with a number of a table of colours", line);
            }
            colors.push(&color);
            self.scanner.end_line();
        }
        if self.scanner.next_line() {
            let line = self.scanner.line();
            self.contents.kept.note("lines behind the last face", line);
        }
        colors.columns(ElementKind::Face, &mut self.contents);
        self.contents.polygons = Polygons::of_parts(corners, ends);
        Ok(())
    }
}

/// The columns that a file holds: normals, colours, alphas and texture coordinates of vertices,
/// and colours and alphas of faces.
pub(super) fn columns(file: &MeshFile) -> [Option<ColumnId>; 6] {
    use AttributeType::{Real, Vec2, Vec3};
    use ElementKind::{Face, Vertex};
    let column = |kind, name, ty| file.column_of_type(kind, name, |has| has == ty);
    let (color, face_color) = (column(Vertex, "color", Vec3), column(Face, "color", Vec3));
    [
        column(Vertex, "normal", Vec3),
        color,
        color.and_then(|_| column(Vertex, "alpha", Real)),
        column(Vertex, "uv", Vec2),
        face_color,
        face_color.and_then(|_| column(Face, "alpha", Real)),
    ]
}

/// Writes the text of a mesh.
pub(super) fn write(
    output: &mut dyn Write,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> io::Result<()> {
    let mut printer = Printer::new(output);
    let [normal, color, alpha, uv, face_color, face_alpha] = columns(file);
    let prefixes = [(uv, "ST"), (color, "C"), (normal, "N")];
    for (_, prefix) in prefixes.into_iter().filter(|(column, _)| column.is_some()) {
        printer.word(prefix);
    }
    let [vertices, faces] = [numbers.vertex_order.len(), numbers.face_order.len()];
    printer.word(&format!("OFF\n{vertices} {faces} {}\n", file.mesh.edge_count()));
    let value = |printer: &mut Printer, column: Option<ColumnId>, index: u32| {
        if let Some(value) = column.and_then(|column| file.mesh.value(column, index)) {
            printer.reals(value.reals());
        }
    };
    for &v in &numbers.vertex_order {
        let [x, rest @ ..] = file.mesh.position(v).to_array();
        printer.real(x);
        printer.reals(&rest);
        value(&mut printer, normal, v.0);
        value(&mut printer, color, v.0);
        match alpha {
            Some(_) => value(&mut printer, alpha, v.0),
            None if color.is_some() => printer.word(" 1"),
            None => {}
        }
        value(&mut printer, uv, v.0);
        printer.end_line()?;
    }
    for &f in &numbers.face_order {
        printer.int(file.mesh.face_size(f) as i64);
        for v in file.mesh.face_vertices(f) {
            printer.bytes(b" ");
            printer.int(i64::from(numbers.vertex(v).unwrap_or(1)) - 1);
        }
        value(&mut printer, face_color, f.0);
        value(&mut printer, face_alpha, f.0);
        printer.end_line()?;
    }
    printer.flush()
}
