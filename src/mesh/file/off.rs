//! The Geomview object file format: `OFF`, with the prefixes `ST` (texture coordinates), `C`
//! (colours) and `N` (normals) for what follows the coordinates of each vertex.
//!
//! Numbers are in free form, except for those after the corners of a face: the rest of that line is
//! its colour. Colours have 3 or 4 numbers, up to 1 or up to 255; those of faces are up to 255 if
//! none has a point, and all are written with one. No crate reads them. With the prefix `4`, a last
//! coordinate divides the others: if it is 0, the position is not finite. With `n`, the head gives
//! the number of coordinates, of which the first three are used. Binary files are rejected.

use std::io::{self, Write};

use glam::{DVec2, DVec3};

use super::contents::{Contents, FileColumn};
use super::error::{Failure, FileReason};
use super::format::Encoding;
use super::kept::MISSING;
use super::mesh_file::{MeshFile, WrittenNumbers};
use super::print::Printer;
use super::scan::{Scanner, no_number, shown};
use crate::mesh::attribute::{AttributeType, ColumnId, Value};
use crate::mesh::id::ElementKind;
use crate::mesh::polygons::Polygons;

/// Reads a file.
pub(super) fn read(text: &[u8]) -> Result<Contents, Failure> {
    let scanner = Scanner::with_sticking_comments(text);
    let mut reader = Reader { scanner, contents: Contents::default() };
    reader.contents.encoding = Encoding::Ascii;
    let read = reader.file();
    let line = Some(reader.scanner.line());
    match read {
        // What was read so far can be kept.
        Err(words) if reader.scanner.is_at_end() && !reader.contents.positions.is_empty() => {
            reader.contents.damage.add(line, || words);
        }
        read => read.map_err(|words| (line, FileReason::Malformed(words)))?,
    }
    Ok(reader.contents)
}

struct Reader<'t> {
    scanner: Scanner<'t>,
    contents: Contents,
}

/// The numbers that each vertex has.
#[derive(Clone, Copy)]
struct Head {
    /// True if a last coordinate divides the others.
    is_divided: bool,
    /// The number of the other coordinates; `None` if it follows the first word of the file.
    dimension: Option<usize>,
    texture: bool,
    color: bool,
    normal: bool,
}

impl Head {
    const PLAIN: Self =
        Self { is_divided: false, dimension: Some(3), texture: false, color: false, normal: false };

    /// The head given by the first word of a file; `None` if it is another word.
    fn of(word: &[u8]) -> Option<Self> {
        let mut rest = word.strip_suffix(b"OFF").or_else(|| word.strip_suffix(b"off"))?;
        let mut head = Self::PLAIN;
        let mut is_many = false;
        for (prefix, flag) in [
            (&b"ST"[..], &mut head.texture),
            (b"C", &mut head.color),
            (b"N", &mut head.normal),
            (b"4", &mut head.is_divided),
            (b"n", &mut is_many),
        ] {
            if let Some(behind) = rest.strip_prefix(prefix) {
                (*flag, rest) = (true, behind);
            }
        }
        if is_many {
            head.dimension = None;
        }
        rest.is_empty().then_some(head)
    }
}

/// True if a file may begin with this word.
pub(super) fn is_head(word: &[u8]) -> bool {
    word.starts_with(b"appearance")
        || word.first().is_some_and(u8::is_ascii_digit)
        || Head::of(without_number(word)).is_some()
}

/// A word without the digits at its end: in the files of ModelNet, `OFF` has no blank behind it.
fn without_number(word: &[u8]) -> &[u8] {
    let digits = word.iter().rev().take_while(|byte| byte.is_ascii_digit()).count();
    &word[..word.len() - digits]
}

/// Colours as in the file: four numbers for each element.
#[derive(Default)]
struct Colors {
    reals: Vec<f64>,
    has_alpha: bool,
    /// True if a number has a point.
    has_point: bool,
    bare: usize,
}

impl Colors {
    fn push(&mut self, color: &[f64]) {
        if color.len() < 3 {
            self.bare += 1;
        }
        self.has_alpha |= color.len() > 3;
        self.reals.extend([0, 1, 2, 3].map(|at| color.get(at).copied().unwrap_or(f64::NAN)));
    }

    fn columns(self, kind: ElementKind, contents: &mut Contents) {
        let count = self.reals.len() / 4;
        if count == self.bare {
            return;
        }
        let what = [
            format!("{kind} without a colour, which is white now"),
            format!("{} without a colour, which are white now", kind.plural()),
        ];
        contents.kept.note_count(what, self.bare);
        let most = self.reals.iter().copied().fold(0.0, f64::max);
        let is_of_bytes = most > 1.0 || (kind == ElementKind::Face && !self.has_point);
        let scale = if is_of_bytes { 255.0 } else { 1.0 };
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

impl<'t> Reader<'t> {
    fn file(&mut self) -> Result<(), String> {
        let mut head = self.head()?;
        if head.dimension.is_none() {
            let number = self.next("the number of coordinates")?;
            if number.fract() != 0.0 || !(1.0..=1e6).contains(&number) {
                return Err(format!("{number} is not a number of coordinates"));
            }
            head.dimension = Some(number as usize);
        }
        let [vertices, faces, _] = self.counts()?;
        self.vertices(vertices, faces, head)?;
        self.faces(faces)
    }

    /// The first word, which may be missing. A description of the appearance may precede it.
    fn head(&mut self) -> Result<Head, String> {
        if !self.scanner.next_line() {
            return Err("the file is empty".into());
        }
        let rest = self.scanner.rest();
        let is_word = |word: &[u8]| rest.starts_with(word);
        if rest[0].is_ascii_digit() && !is_word(b"4OFF") && !is_word(b"4nOFF") {
            return Ok(Head::PLAIN);
        }
        let line = self.scanner.line();
        let mut word = self.head_word();
        if word.starts_with(b"appearance") {
            self.skip_braces(word)?;
            let what = ["description of the appearance", "descriptions of the appearance"];
            self.contents.kept.note(what, line);
            if self.scanner.next_line() {
                word = self.head_word();
            }
        }
        let unknown = || format!("`{}` is not `OFF`, with a prefix or without", shown(word));
        Head::of(word).ok_or_else(unknown)
    }

    /// The next word, without a number that sticks to its end.
    fn head_word(&mut self) -> &'t [u8] {
        let rest = self.scanner.rest();
        let ends = |byte: &u8| byte.is_ascii_whitespace() || *byte == b'#';
        let word = without_number(rest.split(ends).next().unwrap_or_default());
        self.scanner.skip(word.len());
        word
    }

    /// Skips everything up to the end of the braces that a word or those after it open.
    fn skip_braces(&mut self, mut word: &'t [u8]) -> Result<(), String> {
        let (mut open, mut closed) = (0, 0);
        loop {
            open += word.iter().filter(|&&byte| byte == b'{').count();
            closed += word.iter().filter(|&&byte| byte == b'}').count();
            if open > 0 && closed >= open {
                return Ok(());
            }
            if !self.scanner.next_line() {
                return Err("the braces of `appearance` do not end".into());
            }
            word = self.scanner.word().unwrap_or_default();
        }
    }

    fn counts(&mut self) -> Result<[usize; 3], String> {
        let mut counts = [0; 3];
        for (at, count) in counts.iter_mut().enumerate() {
            // The number of edges may be missing.
            if at == 2 && !self.scanner.next_word() {
                break;
            }
            let left = self.scanner.rest().len();
            let number = self.next("the numbers of vertices, faces and edges")?;
            if number.fract() != 0.0 || number < 0.0 || (at < 2 && number > left as f64) {
                return Err(format!(
                    "the header declares {number} {}, but only {left} bytes follow",
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
            Some(Err(word)) if word.contains(&b',') => Err(no_number(word)),
            Some(Err(word)) => Err(format!("`{}` stands where {wanted} should", shown(word))),
            None => Err(format!("the file ends where {wanted} should stand")),
        }
    }

    /// Reads the vertices, behind which there are some faces.
    fn vertices(&mut self, count: usize, faces: usize, head: Head) -> Result<(), String> {
        let mut rows = VertexRows::default();
        let mut has_lines = None;
        let read = (0..count).try_for_each(|at| {
            self.scanner.next_line();
            let begin = self.scanner.line();
            let read = self.vertex(head, &mut rows);
            let left = (count - at - 1).saturating_add(faces);
            if read.is_ok() && self.scanner.skip_surplus(begin, left, &mut has_lines) {
                let what = [
                    "vertex with more than the first word of the file says",
                    "vertices with more than the first word of the file says",
                ];
                self.contents.kept.note(what, begin);
            }
            if !self.skip(read)? {
                // The other vertices keep their numbers.
                self.contents.positions.push(DVec3::NAN);
                self.contents.vertex_lines.push(self.scanner.line());
                rows.push_none(head);
            }
            Ok(())
        });
        let VertexRows { normals, textures, colors, divided } = rows;
        let mut add = |name, default, reals: Vec<f64>| {
            if !reals.is_empty() {
                let column = FileColumn::new(ElementKind::Vertex, name, default, reals);
                self.contents.columns.push(column);
            }
        };
        add("normal", Value::Vec3(DVec3::ZERO), normals);
        add("uv", Value::Vec2(DVec2::ZERO), textures);
        colors.columns(ElementKind::Vertex, &mut self.contents);
        let kept = &mut self.contents.kept;
        let what = [
            "vertex whose last coordinate divides the others",
            "vertices whose last coordinates divide the others",
        ];
        kept.note_count(what, divided);
        if head.dimension > Some(3) {
            let what = [
                "vertex of more than three coordinates, which has the first three",
                "vertices of more than three coordinates, which have the first three",
            ];
            kept.note_count(what, self.contents.positions.len());
        }
        read
    }

    /// Whether an element was read. If it was not, skips the rest of its line; fails at the end of
    /// the file.
    fn skip(&mut self, read: Result<(), String>) -> Result<bool, String> {
        let Err(words) = read else { return Ok(true) };
        if self.scanner.is_at_end() {
            return Err(words);
        }
        self.contents.damage.add(Some(self.scanner.line()), || words);
        self.scanner.end_line();
        Ok(false)
    }

    fn vertex(&mut self, head: Head, rows: &mut VertexRows) -> Result<(), String> {
        let mut numbers = [0.0; 3];
        for axis in 0..head.dimension.unwrap_or(3) {
            let number = self.next("a coordinate")?;
            if let Some(place) = numbers.get_mut(axis) {
                *place = number;
            }
        }
        let mut place = DVec3::from_array(numbers);
        if head.is_divided {
            let divisor = self.next("a coordinate")?;
            rows.divided += usize::from(divisor != 1.0);
            place /= divisor;
        }
        let mut normal = [0.0; 3];
        for number in normal.iter_mut().filter(|_| head.normal) {
            *number = self.next("a normal")?;
        }
        // Some programs write three numbers for a colour, some four.
        let mut rest = Vec::new();
        while (head.color || head.texture) && rest.len() < 6 && self.scanner.next_word() {
            rest.push(self.next("a colour")?);
        }
        if head.texture {
            let at = rest.len().checked_sub(2).ok_or("texture coordinates are missing")?;
            rows.textures.extend(rest.drain(at..));
        }
        if head.normal {
            rows.normals.extend(normal);
        }
        if head.color {
            rows.colors.push(&rest);
        }
        self.contents.positions.push(place);
        self.contents.vertex_lines.push(self.scanner.line());
        Ok(())
    }

    fn faces(&mut self, count: usize) -> Result<(), String> {
        let (mut corners, mut ends) = (Vec::new(), Vec::with_capacity(count));
        let mut colors = Colors::default();
        let read = (0..count).try_for_each(|_| {
            let (before, line) = (corners.len(), self.scanner.line());
            let read = self.face(&mut corners, &mut colors);
            if read.is_err() {
                corners.truncate(before);
            }
            if !self.skip(read)? {
                self.contents.face_lines.push(line);
                colors.push(&[]);
            }
            ends.push(corners.len());
            Ok(())
        });
        if read.is_ok() {
            self.contents.kept.note_lines_behind(&mut self.scanner, "face", 0);
        }
        colors.columns(ElementKind::Face, &mut self.contents);
        self.contents.polygons = Polygons::of_parts(corners, ends);
        read
    }

    fn face(&mut self, corners: &mut Vec<u32>, colors: &mut Colors) -> Result<(), String> {
        let sides = self.next("the number of corners of a face")?;
        if sides.fract() != 0.0 || !(0.0..=1e9).contains(&sides) {
            return Err(format!("{sides} is not a number of corners"));
        }
        let line = self.scanner.line();
        let vertices = self.contents.positions.len();
        for _ in 0..sides as usize {
            let index = self.next("a vertex of a face")?;
            let is_known = index.fract() == 0.0 && (0.0..vertices as f64).contains(&index);
            if !is_known {
                self.contents.bad_indices.add_vertex(Some(line), index, vertices);
            }
            corners.push(if is_known { index as u32 } else { MISSING });
        }
        let mut color = Vec::new();
        let behind = self.scanner.rest();
        while color.len() < 4
            && let Some(number) = self.scanner.number()
        {
            let Ok(number) = number else {
                let what = ["face with a word behind it", "faces with a word behind them"];
                self.contents.kept.note(what, line);
                break;
            };
            color.push(number);
        }
        let read = behind.len() - self.scanner.rest().len();
        colors.has_point |= behind[..read].contains(&b'.');
        self.contents.face_lines.push(line);
        if color.len() < 3 && !color.is_empty() {
            let what = [
                "face with a number of a table of colours",
                "faces with a number of a table of colours",
            ];
            self.contents.kept.note(what, line);
        }
        colors.push(&color);
        self.scanner.end_line();
        Ok(())
    }
}

/// The values of vertices other than positions.
#[derive(Default)]
struct VertexRows {
    normals: Vec<f64>,
    textures: Vec<f64>,
    colors: Colors,
    /// The number of vertices whose last coordinate is not 1.
    divided: usize,
}

impl VertexRows {
    /// Adds the values of a vertex that has none.
    fn push_none(&mut self, head: Head) {
        self.normals.extend([0.0; 3].iter().filter(|_| head.normal));
        self.textures.extend([0.0; 2].iter().filter(|_| head.texture));
        if head.color {
            self.colors.push(&[]);
        }
    }
}

/// The columns that a file can hold: normals, colours, alphas and texture coordinates of vertices,
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
    let get = |column: Option<ColumnId>, index| file.mesh.value(column?, index);
    let value = |printer: &mut Printer, column, index: u32| {
        if let Some(value) = get(column, index) {
            printer.reals(value.reals());
        }
    };
    // Parts of a colour without a point would be from 0 to 255.
    let part = |printer: &mut Printer, column, index: u32| {
        for &real in get(column, index).iter().flat_map(Value::reals) {
            printer.reals(&[real]);
            printer.word(if real.fract() == 0.0 { ".0" } else { "" });
        }
    };
    for &v in &numbers.vertex_order {
        let [x, rest @ ..] = file.mesh.position(v).to_array();
        printer.real(x);
        printer.reals(&rest);
        value(&mut printer, normal, v.0);
        part(&mut printer, color, v.0);
        match alpha {
            Some(_) => part(&mut printer, alpha, v.0),
            None if color.is_some() => printer.word(" 1.0"),
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
        part(&mut printer, face_color, f.0);
        part(&mut printer, face_alpha, f.0);
        printer.end_line()?;
    }
    printer.flush()
}
