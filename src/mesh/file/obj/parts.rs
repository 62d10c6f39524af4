//! Reading a file in parts, on all cores.
//!
//! A text is cut at ends of lines. Each part is read by itself, as if nothing were before it, and
//! what the parts say is put together in order: numbers of lines and places of faces move by what
//! was before. An index that counts back may lead out of its part; such a part is read again when
//! it is known what was before it.

use std::borrow::Cow;

use super::read::Reader;
use crate::mesh::Polygons;
use crate::mesh::file::contents::Contents;
use crate::mesh::parallel;

/// The bytes that are worth a thread.
const LEAST: usize = 1 << 16;

/// Reads the text of a file.
pub(in crate::mesh::file) fn read(text: &[u8]) -> Contents {
    let text = text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text);
    let parts = cut(text);
    let first = [0; 3];
    let read = parallel::map(parts.clone(), |part| Reader::read(part, first));
    let mut whole: Option<Reader> = None;
    for (text, part) in parts.into_iter().zip(read) {
        whole = Some(match whole {
            None => part,
            Some(mut whole) => {
                let part = match part.counts_back {
                    true => Reader::read(text, whole.have()),
                    false => part,
                };
                whole.append(part);
                whole
            }
        });
    }
    whole.unwrap_or_else(|| Reader::read(b"", first)).finish()
}

/// Cuts a text behind ends of lines that do not go on.
fn cut(text: &[u8]) -> Vec<&[u8]> {
    let mut parts = Vec::new();
    let mut start = 0;
    for part in parallel::parts(text.len(), LEAST) {
        if part.end <= start {
            continue;
        }
        let mut end = part.end;
        while end < text.len() && !is_cut(&text[..end]) {
            let next = text[end..].iter().position(|&byte| byte == b'\n');
            end = next.map_or(text.len(), |next| end + next + 1);
        }
        parts.push(&text[start..end]);
        start = end;
    }
    parts
}

/// True if a text ends with a line that does not go on.
fn is_cut(text: &[u8]) -> bool {
    let Some(line) = text.strip_suffix(b"\n") else { return false };
    let last = line.iter().rposition(|&byte| byte == b'\n' || !byte.is_ascii_whitespace());
    last.is_none_or(|last| line[last] != b'\\')
}

impl<'t> Reader<'t> {
    /// The numbers of vertices, texture coordinates and normals, with those before the part.
    pub(super) fn have(&self) -> [usize; 3] {
        let kept = &self.contents.kept;
        let own = [self.contents.positions.len(), kept.texture.rows.len(), kept.normals.rows.len()];
        std::array::from_fn(|kind| self.before[kind] + own[kind])
    }

    /// Adds what the next part of the file says.
    fn append(&mut self, part: Self) {
        let lines = self.lines;
        self.lines += part.lines;
        let [vertices, faces, corners] =
            [self.contents.positions.len(), self.ends.len(), self.corners.len()];
        let Contents { positions, vertex_lines, face_lines, kept, damage, strays, .. } =
            part.contents;
        let all = &mut self.contents;
        all.positions.extend(positions);
        all.vertex_lines.extend(vertex_lines.into_iter().map(|line| line + lines));
        all.face_lines.extend(face_lines.into_iter().map(|line| line + lines));
        all.damage.append(damage, lines);
        all.strays.append(strays, lines);
        let tables = [
            (&mut all.kept.corner_texture, kept.corner_texture),
            (&mut all.kept.corner_normals, kept.corner_normals),
        ];
        for (table, part) in tables {
            extend(table, part, corners, u32::MAX);
        }
        for (rows, part) in
            [(&mut all.kept.texture, kept.texture), (&mut all.kept.normals, kept.normals)]
        {
            rows.width = rows.width.max(part.width);
            rows.rows.extend(part.rows);
        }
        all.kept.append(kept.passed_over, kept.notes, lines);
        self.corners.extend(part.corners);
        self.ends.extend(part.ends.into_iter().map(|end| end + corners));
        extend(&mut self.weights, part.weights, vertices, 1.0);
        extend(&mut self.alphas, part.alphas, vertices, 1.0);
        extend(&mut self.colors, part.colors, vertices * 3, 1.0);
        self.colored += part.colored;
        for (highest, part) in self.highest.iter_mut().zip(part.highest) {
            if part.index > highest.index {
                (highest.index, highest.line) = (part.index, part.line + lines);
            }
        }
        let states = part.states.into_iter();
        self.states.extend(states.map(|(face, place, name)| (face + faces as u32, place, name)));
        self.libraries.extend(part.libraries);
    }

    /// The contents of the file, of which all is read.
    fn finish(mut self) -> Contents {
        self.look_for_strays();
        for (face, place, name) in std::mem::take(&mut self.states) {
            self.contents.kept.enter_state(face, place, &name);
        }
        for library in self.libraries.drain(..).map(Cow::into_owned) {
            let libraries = &mut self.contents.kept.libraries;
            if !libraries.contains(&library) {
                libraries.push(library);
            }
        }
        self.add_columns();
        let mut contents = self.contents;
        // They become those of the mesh.
        contents.positions.shrink_to_fit();
        contents.polygons = Polygons::of_parts(self.corners, self.ends);
        contents
    }
}

/// Adds the values of a part to those before it, if it has any: what is not said has the usual one.
fn extend<T: Copy>(table: &mut Vec<T>, part: Vec<T>, before: usize, usual: T) {
    if !part.is_empty() {
        table.resize(before, usual);
        table.extend(part);
    }
}
