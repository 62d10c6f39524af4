//! Reading a file, statement by statement.

use glam::DVec3;

use crate::mesh::attribute::Value;
use crate::mesh::file::contents::{Contents, FileColumn};
use crate::mesh::file::error::Indexed;
use crate::mesh::file::kept::{MISSING, State};
use crate::mesh::file::scan::{Scanner, no_number, shown};
use crate::mesh::id::ElementKind;

/// The reason why a statement cannot be read.
type Fault = String;

/// The contents of a file, or of a part of it.
#[derive(Default)]
pub(super) struct Reader {
    pub(super) contents: Contents,
    /// True if there is a relative index, which may refer to what precedes the part.
    pub(super) counts_back: bool,
    /// The number of lines that have been read.
    pub(super) lines: u32,
    pub(super) corners: Vec<u32>,
    pub(super) ends: Vec<usize>,
    pub(super) weights: Vec<f64>,
    /// Three numbers for each vertex, once any has had a colour.
    pub(super) colors: Vec<f64>,
    pub(super) alphas: Vec<f64>,
    pub(super) colored: usize,
    pub(super) highest: [Highest; 3],
    /// The statements in force from a face on: the face, the index of the keyword, and the operand.
    pub(super) states: Vec<(u32, usize, Vec<u8>)>,
    pub(super) libraries: Vec<Vec<u8>>,
}

/// The highest index of its kind, and its line.
#[derive(Clone, Copy, Default)]
pub(super) struct Highest {
    pub(super) index: u64,
    pub(super) line: u32,
}

const KINDS: [Indexed; 3] = [Indexed::Vertex, Indexed::Texture, Indexed::Normal];

impl Reader {
    /// A reader of a text of at most the given number of bytes.
    pub(super) fn new(bytes: usize) -> Self {
        let mut reader = Self::default();
        // If the allocation fails, the lists grow as they are filled.
        let _ = reader.corners.try_reserve(bytes / 12);
        let _ = reader.ends.try_reserve(bytes / 40);
        let _ = reader.contents.face_lines.try_reserve(bytes / 40);
        let _ = reader.contents.positions.try_reserve(bytes / 100);
        let _ = reader.contents.vertex_lines.try_reserve(bytes / 100);
        reader
    }

    /// Reads some lines, which follow those read before.
    pub(super) fn read(&mut self, text: &[u8]) {
        let mut scanner = Scanner::with_continued_lines(text);
        while !scanner.is_at_end() {
            if scanner.next_word() {
                let line = self.lines + scanner.line();
                self.statement(&mut scanner, line);
            }
            scanner.end_line();
        }
        self.lines += scanner.line() - 1;
    }

    /// The numbers of vertices, texture coordinates and normals so far.
    fn have(&self) -> [usize; 3] {
        let Contents { positions, kept, .. } = &self.contents;
        [positions.len(), kept.texture.rows.len(), kept.normals.rows.len()]
    }

    fn statement(&mut self, scanner: &mut Scanner<'_>, line: u32) {
        let keyword = match scanner.rest() {
            [keyword @ (b'v' | b'f'), b' ', ..] => {
                scanner.skip(1);
                std::slice::from_ref(keyword)
            }
            _ => match scanner.word() {
                Some(keyword) => keyword,
                None => return,
            },
        };
        match keyword {
            b"v" => {
                if let Err(fault) = self.vertex(scanner, line) {
                    self.contents.damage.add(Some(line), || fault);
                    // The other vertices keep their numbers.
                    self.contents.positions.push(DVec3::NAN);
                    self.contents.vertex_lines.push(line);
                }
            }
            b"f" | b"fo" => {
                let corners = self.corners.len();
                if let Err(fault) = self.face(scanner, line) {
                    self.contents.damage.add(Some(line), || fault);
                    self.corners.truncate(corners);
                    self.contents.kept.corner_texture.truncate(corners);
                    self.contents.kept.corner_normals.truncate(corners);
                }
                self.ends.push(self.corners.len());
                self.contents.face_lines.push(line);
            }
            b"vt" => self.row(scanner, line, ("vt", 1, "a number or more")),
            b"vn" => self.row(scanner, line, ("vn", 3, "three numbers")),
            b"mtllib" => self.libraries.push(scanner.text().into_owned()),
            _ => match State::KEYWORDS.iter().position(|k| k.as_bytes() == keyword) {
                Some(place) => {
                    let name = scanner.text().into_owned();
                    self.states.push((self.ends.len() as u32, place, name));
                }
                None => self.contents.kept.skip(&shown(keyword), line),
            },
        }
    }

    fn vertex(&mut self, scanner: &mut Scanner<'_>, line: u32) -> Result<(), Fault> {
        let mut numbers = [0.0; 7];
        let mut count = 0;
        while count < numbers.len() {
            match scanner.number() {
                Some(Ok(number)) => numbers[count] = number,
                None => break,
                Some(Err(word)) if count < 3 => return Err(no_number(word)),
                Some(Err(_)) => {
                    let what = [
                        "vertex with a word behind its numbers",
                        "vertices with a word behind their numbers",
                    ];
                    self.contents.kept.note(what, line);
                    break;
                }
            }
            count += 1;
        }
        if count < 3 {
            let in_plane = if count == 2 { "; in a plane the third is 0" } else { "" };
            return Err(format!("`v` needs three numbers{in_plane}"));
        }
        if count == 5 || (count == 7 && scanner.next_word()) {
            let what = [
                "vertex with 5 numbers, or more than 7",
                "vertices with 5 numbers, or more than 7",
            ];
            self.contents.kept.note(what, line);
        }
        let [x, y, z, rest @ ..] = numbers;
        let before = self.contents.positions.len();
        self.contents.positions.push(DVec3::new(x, y, z));
        self.contents.vertex_lines.push(line);
        match count {
            4 if rest[0] != 1.0 => pad(&mut self.weights, before, 1.0, rest[0]),
            6 | 7 => {
                self.colors.resize(before * 3, 1.0);
                self.colors.extend_from_slice(&rest[..3]);
                self.colored += 1;
                if count == 7 {
                    pad(&mut self.alphas, before, 1.0, rest[3]);
                }
            }
            _ => {}
        }
        Ok(())
    }

    fn row(
        &mut self,
        scanner: &mut Scanner<'_>,
        line: u32,
        (statement, least, needs): (&str, usize, &str),
    ) {
        let mut row = [0.0; 3];
        let mut width = 0;
        let mut other = None;
        while width < 3 && other.is_none() {
            match scanner.number() {
                Some(Ok(number)) => row[width] = number,
                Some(Err(word)) => other = Some(word),
                None => break,
            }
            width += usize::from(other.is_none());
        }
        if width < least || other.is_some() {
            let words = || format!("`{statement}` needs {needs}");
            self.contents.damage.add(Some(line), || other.map_or_else(words, no_number));
            (row, width) = ([0.0; 3], least);
        }
        let kept = &mut self.contents.kept;
        if width == 3 && scanner.next_word() {
            kept.note([&format!("`{statement}` with more than three numbers"); 2], line);
        }
        let rows = if statement == "vt" { &mut kept.texture } else { &mut kept.normals };
        rows.width = rows.width.max(width);
        rows.rows.push(row);
    }

    /// Reads the corners of a face.
    fn face(&mut self, scanner: &mut Scanner<'_>, line: u32) -> Result<(), Fault> {
        while scanner.next_word() {
            // Most corners are digits alone.
            if let Some(index) = scanner.whole_number() {
                let place = self.resolve(i64::from(index), 0, line);
                self.keep_corner([place, MISSING, MISSING]);
                continue;
            }
            let start = scanner.position();
            let before = scanner.rest();
            let mut places = [MISSING; 3];
            for (i, place) in places.iter_mut().enumerate() {
                let negative = scanner.take(b'-');
                let is_signed = negative || scanner.take(b'+');
                let digits = scanner.digits();
                let length = scanner.position() - start;
                let is_left_out = i > 0
                    && digits.is_none()
                    && !is_signed
                    && !before[length..].first().is_some_and(u8::is_ascii_digit);
                if !is_left_out {
                    let index = digits.ok_or_else(|| malformed(before))? as i64;
                    let index = if negative { -index } else { index };
                    *place = self.resolve(index, i, line);
                }
                if i == 2 || !scanner.take(b'/') {
                    break;
                }
            }
            let length = scanner.position() - start;
            let ends = before.get(length).is_none_or(|b| b.is_ascii_whitespace() || *b == b'\\');
            if !ends {
                return Err(malformed(before));
            }
            self.keep_corner(places);
        }
        Ok(())
    }

    /// Stores the indices, from 0, of the vertex, the texture coordinates and the normal of a
    /// corner.
    #[inline(always)]
    fn keep_corner(&mut self, [vertex, texture, normal]: [u32; 3]) {
        let kept = &mut self.contents.kept;
        if texture != MISSING || !kept.corner_texture.is_empty() {
            keep_row(&mut kept.corner_texture, self.corners.len(), texture);
        }
        if normal != MISSING || !kept.corner_normals.is_empty() {
            keep_row(&mut kept.corner_normals, self.corners.len(), normal);
        }
        self.corners.push(vertex);
    }

    /// The row, from 0, that an index refers to: negative ones count back from the last row.
    #[inline]
    fn resolve(&mut self, index: i64, kind: usize, line: u32) -> u32 {
        if index <= 0 {
            return self.resolve_back(index.unsigned_abs(), kind, line);
        }
        // A face may refer to a vertex that comes later.
        let index = index as u64;
        if index > self.highest[kind].index {
            self.highest[kind] = Highest { index, line };
        }
        u32::try_from(index - 1).unwrap_or(MISSING - 1)
    }

    #[cold]
    fn resolve_back(&mut self, back: u64, kind: usize, line: u32) -> u32 {
        if back == 0 {
            self.contents.bad_indices.add_zero(line);
            return MISSING;
        }
        self.counts_back = true;
        let have = self.have()[kind];
        let place = (have as u64).checked_sub(back);
        if place.is_none() {
            let words = || KINDS[kind].missing(-(back as i64), have);
            self.contents.bad_indices.add(Some(line), words);
        }
        place.map_or(MISSING, |place| place as u32)
    }

    /// Makes columns of the other values of vertices.
    pub(super) fn add_columns(&mut self) {
        let contents = &mut self.contents;
        let vertices = contents.positions.len();
        let kept = &mut contents.kept;
        for table in [&mut kept.corner_texture, &mut kept.corner_normals] {
            if !table.is_empty() {
                table.resize(self.corners.len(), MISSING);
            }
        }
        if self.colored > 0 && self.colored < vertices {
            let bare = vertices - self.colored;
            kept.note_count(
                [
                    "vertex without a colour, which is white now",
                    "vertices without a colour, which are white now",
                ],
                bare,
            );
        }
        let ones = [
            ("color", Value::Vec3(DVec3::ONE), &mut self.colors),
            ("weight", Value::Real(1.0), &mut self.weights),
            ("alpha", Value::Real(1.0), &mut self.alphas),
        ];
        for (name, default, reals) in ones {
            let mut reals = std::mem::take(reals);
            if !reals.is_empty() {
                reals.resize(vertices * default.reals().len(), 1.0);
                contents.columns.push(FileColumn::new(ElementKind::Vertex, name, default, reals));
            }
        }
    }

    /// Finds indices beyond the ends of their tables; all of a kind are reported as the highest
    /// one.
    pub(super) fn look_for_bad_indices(&mut self) {
        let have = self.have();
        let Contents { kept, bad_indices, .. } = &mut self.contents;
        let tables = [&mut self.corners, &mut kept.corner_texture, &mut kept.corner_normals];
        for (kind, table) in tables.into_iter().enumerate() {
            let Highest { index, line } = self.highest[kind];
            if index <= have[kind] as u64 {
                continue;
            }
            for place in table.iter_mut() {
                if *place != MISSING && *place as usize >= have[kind] {
                    *place = MISSING;
                    bad_indices.add(Some(line), || KINDS[kind].missing(index as i64, have[kind]));
                }
            }
        }
    }
}

#[cold]
fn malformed(text: &[u8]) -> Fault {
    let end = text.iter().position(u8::is_ascii_whitespace).unwrap_or(text.len());
    format!("`{}` is not a corner of a face", shown(&text[..end]))
}

/// Appends a value, after `usual` for each vertex before it that had none.
fn pad(table: &mut Vec<f64>, before: usize, usual: f64, value: f64) {
    table.resize(before, usual);
    table.push(value);
}

/// Stores the row of a corner, behind those of the corners before it.
fn keep_row(table: &mut Vec<u32>, corner: usize, place: u32) {
    table.resize(corner, MISSING);
    table.push(place);
}
