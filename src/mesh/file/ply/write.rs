//! Writing a file: columns of numbers, the head that names them, and the rows.

use std::collections::HashSet;
use std::io::{self, Write};

use super::header::{STATES, Scalar};
use super::read::usual_default;
use crate::mesh::attribute::{AttributeType, Column, ColumnId, Value};
use crate::mesh::file::corners::{Corners, OfCorner};
use crate::mesh::file::format::Encoding;
use crate::mesh::file::kept::{MISSING, Rows as Table};
use crate::mesh::file::mesh_file::{MeshFile, WrittenNumbers};
use crate::mesh::file::print::{Printer, one_nan};
use crate::mesh::id::{ElementKind, FaceId};

/// A property to be written: its numbers, and how they are divided into rows.
struct Property {
    name: String,
    scalar: Scalar,
    numbers: Vec<f64>,
    rows: Rows,
}

enum Rows {
    /// One number each.
    One,
    /// Lists of this length.
    Alike(usize),
    /// Lists with this many numbers for each corner of a face.
    Corners(usize),
    /// Lists with these ends.
    Lists(Vec<usize>),
}

/// Writes a mesh.
pub(in crate::mesh::file) fn write(
    output: &mut dyn Write,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> io::Result<()> {
    let mesh = &file.mesh;
    // They come before the declarations, which number their names in order.
    let comments = file.kept.comments.iter().flat_map(|comment| [comment, &b"\n"[..]]);
    let mut head = Head { text: comments.collect::<Vec<_>>().concat() };
    let mut vertices = Vec::new();
    let at = numbers.vertex_order.iter().flat_map(|&v| mesh.position(v).to_array()).collect();
    together(&mut vertices, &["x", "y", "z"], at, None);
    let order: Vec<u32> = numbers.vertex_order.iter().map(|v| v.0).collect();
    head.columns(&mut vertices, file, &[(ElementKind::Vertex, &order)]);

    let mut faces = Vec::new();
    let (mut corners, mut halfedges, mut ends) = (Vec::new(), Vec::new(), Vec::new());
    for &f in &numbers.face_order {
        for h in mesh.face_halfedges(f) {
            corners.push(f64::from(numbers.vertex(mesh.vertex(h)).unwrap_or(1) - 1));
            halfedges.push(h.0);
        }
        ends.push(corners.len());
    }
    let name = "vertex_indices".to_owned();
    let (scalar, rows) = (Scalar::I32, Rows::Corners(1));
    faces.push(Property { name, scalar, numbers: corners, rows });
    head.states(&mut faces, file, numbers);
    for what in OfCorner::ALL {
        faces.extend(at_corners(file, what, &numbers.face_order));
    }
    let order: Vec<u32> = numbers.face_order.iter().map(|f| f.0).collect();
    let kinds = [(ElementKind::Face, &order[..]), (ElementKind::Halfedge, &halfedges)];
    head.columns(&mut faces, file, &kinds);

    let mut edges = Vec::new();
    let order: Vec<u32> = mesh.edges().map(|e| e.0).collect();
    if mesh.columns(ElementKind::Edge).any(|(_, column)| column.is_public()) {
        let ends = mesh.edges().flat_map(|e| {
            let h = mesh.edge_halfedge(e);
            let number = |v| f64::from(numbers.vertex(v).unwrap_or(1) - 1);
            [number(mesh.vertex(h)), number(mesh.target(h))]
        });
        together(&mut edges, &["vertex1", "vertex2"], ends.collect(), Some(Scalar::I32));
        head.columns(&mut edges, file, &[(ElementKind::Edge, &order)]);
    }

    let elements = [
        ("vertex", numbers.vertex_order.len(), &vertices),
        ("face", numbers.face_order.len(), &faces),
        ("edge", order.len(), &edges),
    ];
    let longest = faces.iter().map(|property| match property.rows {
        Rows::Corners(each) => each,
        Rows::Lists(_) => 3,
        _ => 0,
    });
    let sides = numbers.face_order.iter().map(|&f| mesh.face_size(f)).max().unwrap_or(0);
    // Most programs expect the length of a list in a byte.
    let length = match sides * longest.max().unwrap_or(0) {
        0..256 => Scalar::U8,
        _ => Scalar::U32,
    };
    let text = head.finish(file.encoding, length, &elements);
    let mut printer = Printer::new(output);
    printer.bytes(&text);
    for (_, count, properties) in elements {
        let rows = if properties.is_empty() { 0 } else { count };
        write_rows(&mut printer, file.encoding, length, properties, rows, &ends)?;
    }
    printer.flush()
}

/// The texture coordinates or normals that are kept beside the mesh, if there are any: a list for
/// each face, empty if it has none.
fn at_corners(file: &MeshFile, what: OfCorner, faces: &[FaceId]) -> Option<Property> {
    let mesh = &file.mesh;
    if mesh.find_column(ElementKind::Halfedge, what.name()).is_some() {
        return None;
    }
    let corners = Corners::kept(file, what, faces);
    let Table { rows, width } = corners.rows();
    let (name, width) = match (what, width) {
        (OfCorner::Texture, 0..3) => ("texcoord", 2),
        (OfCorner::Texture, _) => ("uv", 3),
        (OfCorner::Normal, _) => ("normal", 3),
    };
    let (mut numbers, mut ends) = (Vec::new(), Vec::with_capacity(faces.len()));
    for &f in faces {
        if corners.cover(mesh, f) {
            let row = |h| rows.get(corners.row(h)? as usize);
            numbers.extend(mesh.face_halfedges(f).filter_map(row).flat_map(|row| &row[..width]));
        }
        ends.push(numbers.len());
    }
    let (name, scalar) = (name.to_owned(), smallest(&numbers));
    (!numbers.is_empty()).then_some(Property { name, scalar, numbers, rows: Rows::Lists(ends) })
}

/// Adds properties whose numbers are interleaved, row by row.
fn together(
    properties: &mut Vec<Property>,
    names: &[&str],
    numbers: Vec<f64>,
    scalar: Option<Scalar>,
) {
    let scalar = scalar.unwrap_or_else(|| smallest(&numbers));
    for (at, name) in names.iter().enumerate() {
        let numbers = numbers.iter().skip(at).step_by(names.len()).copied().collect();
        let name = (*name).to_owned();
        properties.push(Property { name, scalar, numbers, rows: Rows::One });
    }
}

/// The smallest type of reals that holds them all exactly.
fn smallest(numbers: &[f64]) -> Scalar {
    let is_short = |&x: &f64| f64::from(x as f32).to_bits() == x.to_bits();
    if numbers.iter().all(is_short) { Scalar::F32 } else { Scalar::F64 }
}

/// The properties that other programs know an attribute by; none if it has its own name.
fn usual(kind: ElementKind, column: &Column) -> &'static [&'static str] {
    match (kind, column.name(), column.attribute_type()) {
        (ElementKind::Halfedge, "uv", AttributeType::Vec2) => &["texcoord"],
        (ElementKind::Halfedge, "uv", AttributeType::Vec3) => &["uv"],
        (ElementKind::Halfedge, "normal", AttributeType::Vec3) => &["normal"],
        (ElementKind::Halfedge | ElementKind::Edge, ..) => &[],
        (_, "normal", AttributeType::Vec3) => &["nx", "ny", "nz"],
        (_, "color", AttributeType::Vec3) => &["red", "green", "blue"],
        // A declared `alpha` is read as it stands.
        (_, "alpha", _) if column.default_value().is_identical(Value::Real(1.0)) => &["alpha"],
        (_, "uv", AttributeType::Vec2) => &["s", "t"],
        _ => &[],
    }
}

/// The comments of a head, collected so far.
struct Head {
    text: Vec<u8>,
}

impl Head {
    /// Adds the columns of some kinds as properties of one element, each with the ids in the order
    /// in which they are written. A name that another property has gets an underscore.
    fn columns(
        &mut self,
        properties: &mut Vec<Property>,
        file: &MeshFile,
        kinds: &[(ElementKind, &[u32])],
    ) {
        let columns = || {
            kinds.iter().flat_map(|&(kind, order)| {
                let columns = file.mesh.columns(kind).filter(|(_, column)| column.is_public());
                columns.map(move |(id, column)| (id, column, usual(kind, column), order))
            })
        };
        let mut taken: HashSet<String> = properties.iter().map(|it| it.name.clone()).collect();
        taken.extend(columns().flat_map(|(_, _, usual, _)| usual).map(|&name| name.to_owned()));
        for (id, column, usual, order) in columns() {
            let (kind, ty, numbers) = (id.kind, column.attribute_type(), numbers(file, id, order));
            if let (ElementKind::Halfedge, [name]) = (kind, usual) {
                if !column.default_value().is_identical(ty.zero()) {
                    self.declare(kind, column, name);
                }
                let (name, scalar) = ((*name).to_owned(), smallest(&numbers));
                let rows = Rows::Corners(ty.width());
                properties.push(Property { name, scalar, numbers, rows });
            } else if !usual.is_empty() {
                let default = column.default_value();
                if !usual_default(column.name()).is_some_and(|usual| usual.is_identical(default)) {
                    self.declare(kind, column, column.name());
                }
                let is_color = ["red", "alpha"].contains(&usual[0]);
                match is_color.then(|| as_bytes(&numbers)).flatten() {
                    Some(bytes) => together(properties, usual, bytes, Some(Scalar::U8)),
                    None => together(properties, usual, numbers, None),
                }
            } else {
                let mut name = column.name().to_owned();
                while !taken.insert(name.clone()) {
                    name.push('_');
                }
                self.declare(kind, column, &name);
                let scalar = match ty {
                    AttributeType::Bool => Scalar::U8,
                    AttributeType::Int if numbers.iter().all(|x| x.abs() <= 2147483647.0) => {
                        Scalar::I32
                    }
                    AttributeType::Int => Scalar::F64,
                    _ => smallest(&numbers),
                };
                let width = ty.width();
                let rows = match (kind, width) {
                    (ElementKind::Halfedge, _) => Rows::Corners(width),
                    (_, 1) => Rows::One,
                    _ => Rows::Alike(width),
                };
                properties.push(Property { name, scalar, numbers, rows });
            }
        }
    }

    /// Adds a comment that declares an attribute, which a head cannot.
    fn declare(&mut self, kind: ElementKind, column: &Column, property: &str) {
        let default = column.default_value();
        let shown = match default {
            Value::Bool(value) => format!(" {value}"),
            Value::Int(value) => format!(" {value}"),
            _ => default.reals().iter().map(|real| format!(" {real}")).collect(),
        };
        let (name, ty) = (column.name(), column.attribute_type());
        let behind = if name == property { String::new() } else { format!(" as {property}") };
        self.line(&format!("comment attribute {kind} {name} {ty}{shown}{behind}"), b"");
    }

    /// Adds a line that ends with a name, without the control characters of this.
    fn line(&mut self, text: &str, name: &[u8]) {
        self.text.extend_from_slice(text.as_bytes());
        self.text.extend(name.iter().map(|&b| if b.is_ascii_control() { b' ' } else { b }));
        self.text.push(b'\n');
    }

    /// Adds objects, groups, materials and smoothing groups: numbers, and comments that name them.
    fn states(&mut self, faces: &mut Vec<Property>, file: &MeshFile, numbers: &WrittenNumbers) {
        for library in &file.kept.libraries {
            self.line("comment mtllib ", library);
        }
        let states = file.states_of(&numbers.face_order);
        if states.is_empty() {
            return;
        }
        for (keyword, name) in STATES.into_iter().enumerate() {
            let mut known: Vec<&[u8]> = Vec::new();
            let mut places = std::collections::HashMap::new();
            let mut values = Vec::with_capacity(states.len());
            for state in &states {
                let place = state.map_or(MISSING, |state| state.0[keyword]);
                let value = match file.kept.names.get(place as usize) {
                    None => -1.0,
                    Some(name) => *places.entry(name.as_slice()).or_insert_with(|| {
                        known.push(name);
                        known.len() as f64 - 1.0
                    }),
                };
                values.push(value);
            }
            if known.is_empty() {
                continue;
            }
            for (number, value) in known.into_iter().enumerate() {
                self.line(&format!("comment {name} {number} "), value);
            }
            let (scalar, rows) = (Scalar::I32, Rows::One);
            faces.push(Property { name: name.to_owned(), scalar, numbers: values, rows });
        }
    }

    fn finish(
        self,
        encoding: Encoding,
        length: Scalar,
        elements: &[(&str, usize, &Vec<Property>)],
    ) -> Vec<u8> {
        let format = match encoding {
            Encoding::Ascii => "ascii",
            Encoding::LittleEndian => "binary_little_endian",
            Encoding::BigEndian => "binary_big_endian",
        };
        let mut text = String::new();
        for (name, count, properties) in elements.iter().filter(|(_, _, p)| !p.is_empty()) {
            text += &format!("element {name} {count}\n");
            for Property { name, scalar, rows, .. } in *properties {
                let list = match rows {
                    Rows::One => String::new(),
                    Rows::Alike(_) => "list uchar ".to_owned(),
                    Rows::Corners(_) | Rows::Lists(_) => format!("list {} ", length.name()),
                };
                text += &format!("property {list}{} {name}\n", scalar.name());
            }
        }
        let head = format!("ply\nformat {format} 1.0\n");
        [head.as_bytes(), &self.text, text.as_bytes(), b"end_header\n"].concat()
    }
}

/// The numbers of a column, element by element.
fn numbers(file: &MeshFile, column: ColumnId, order: &[u32]) -> Vec<f64> {
    let mut numbers = Vec::with_capacity(order.len());
    for value in order.iter().filter_map(|&index| file.mesh.value(column, index)) {
        match value {
            Value::Bool(value) => numbers.push(f64::from(u8::from(value))),
            Value::Int(value) => numbers.push(value as f64),
            _ => numbers.extend_from_slice(value.reals()),
        }
    }
    numbers
}

/// Colours as bytes, if that is exact.
fn as_bytes(numbers: &[f64]) -> Option<Vec<f64>> {
    let byte = |&x: &f64| {
        let byte = (x * 255.0).round();
        (x.is_sign_positive() && byte <= 255.0 && byte / 255.0 == x).then_some(byte)
    };
    numbers.iter().map(byte).collect()
}

fn write_rows(
    printer: &mut Printer,
    encoding: Encoding,
    length: Scalar,
    properties: &[Property],
    rows: usize,
    ends: &[usize],
) -> io::Result<()> {
    let mut first = 0;
    for row in 0..rows {
        let corners = ends.get(row).map_or(0..0, |&end| first..end);
        for (place, property) in properties.iter().enumerate() {
            let numbers = match &property.rows {
                Rows::One => &property.numbers[row..=row],
                Rows::Alike(length) => &property.numbers[row * length..(row + 1) * length],
                Rows::Corners(each) => &property.numbers[corners.start * each..corners.end * each],
                Rows::Lists(ends) => {
                    let first = row.checked_sub(1).map_or(0, |before| ends[before]);
                    &property.numbers[first..ends[row]]
                }
            };
            if place > 0 && encoding == Encoding::Ascii {
                printer.bytes(b" ");
            }
            if !matches!(property.rows, Rows::One) {
                let is_short = matches!(property.rows, Rows::Alike(_));
                let length = if is_short { Scalar::U8 } else { length };
                put(printer, encoding, length, numbers.len() as f64);
                if encoding == Encoding::Ascii && !numbers.is_empty() {
                    printer.bytes(b" ");
                }
            }
            for (at, &number) in numbers.iter().enumerate() {
                if at > 0 && encoding == Encoding::Ascii {
                    printer.bytes(b" ");
                }
                put(printer, encoding, property.scalar, number);
            }
        }
        first = corners.end.max(first);
        if encoding == Encoding::Ascii { printer.end_line()? } else { printer.flush_if_full()? }
    }
    Ok(())
}

#[inline]
fn put(printer: &mut Printer, encoding: Encoding, scalar: Scalar, number: f64) {
    let number = one_nan(number);
    macro_rules! put {
        ($number:expr) => {
            match encoding {
                Encoding::BigEndian => printer.bytes(&$number.to_be_bytes()),
                _ => printer.bytes(&$number.to_le_bytes()),
            }
        };
    }
    match (encoding, scalar) {
        (Encoding::Ascii, scalar) if scalar.is_whole() => printer.int(number as i64),
        (Encoding::Ascii, _) => printer.real(number),
        (_, Scalar::I8) => put!((number as i8)),
        (_, Scalar::U8) => put!((number as u8)),
        (_, Scalar::I16) => put!((number as i16)),
        (_, Scalar::U16) => put!((number as u16)),
        (_, Scalar::I32) => put!((number as i32)),
        (_, Scalar::U32) => put!((number as u32)),
        (_, Scalar::F32) => put!((number as f32)),
        (_, Scalar::F64) => put!(number),
    }
}
