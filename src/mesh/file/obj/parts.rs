//! Reading a file in blocks of lines, on all cores.
//!
//! A block is parsed while it is in the cache, and then dropped, so that the text of a file is
//! never in memory as a whole. With several threads, each block is parsed on its own, as if nothing
//! preceded it, and the results are appended in order: line numbers and face indices are shifted by
//! what precedes them. A relative index may refer to an earlier block; such a block is parsed again
//! once what precedes it is known.

use std::collections::HashSet;
use std::io::{self, Read};
use std::sync::{Mutex, PoisonError};

use super::read::Reader;
use crate::mesh::file::contents::Contents;
use crate::mesh::{Polygons, parallel};

/// The maximum number of bytes read at a time for a block, which may end within a line: as many as
/// stay in the cache.
const MOST: usize = 1 << 18;

/// The fewest bytes that are worth a thread.
const LEAST: usize = 1 << 16;

/// Reads a file of about the given number of bytes.
pub(in crate::mesh::file) fn read(source: impl Read, bytes: usize) -> io::Result<Contents> {
    let threads = parallel::threads();
    let size = (bytes / (4 * threads)).clamp(LEAST, MOST);
    let blocks = Blocks { source, size, begun: Vec::new(), is_first: true };
    let mut whole = Reader::new(bytes);
    // Parts that were appended: their memory is used for those that follow.
    let spare = Mutex::new(Vec::new());
    let alone = |block: io::Result<Vec<u8>>| {
        let block = block?;
        let part = (threads > 1).then(|| {
            let used = spare.lock().unwrap_or_else(PoisonError::into_inner).pop();
            let mut part: Reader = used.unwrap_or_default();
            part.read(&block);
            part
        });
        Ok((block, part))
    };
    parallel::in_order(blocks, alone, |read: io::Result<_>| {
        match read? {
            (_, Some(part)) if !part.counts_back => {
                let used = whole.append(part);
                spare.lock().unwrap_or_else(PoisonError::into_inner).push(used);
            }
            (block, _) => whole.read(&block),
        }
        Ok::<_, io::Error>(())
    })?;
    Ok(whole.finish())
}

/// The blocks of a file: each ends after a line that is not continued.
struct Blocks<S> {
    source: S,
    size: usize,
    /// The start of the next block.
    begun: Vec<u8>,
    is_first: bool,
}

impl<S: Read> Blocks<S> {
    /// The next block; it is empty at the end of the file.
    fn block(&mut self) -> io::Result<Vec<u8>> {
        let mut block = std::mem::take(&mut self.begun);
        loop {
            let before = block.len();
            block.try_reserve(self.size)?;
            let read = self.source.by_ref().take(self.size as u64).read_to_end(&mut block)?;
            if std::mem::take(&mut self.is_first) && block.starts_with(BYTE_ORDER_MARK) {
                block.drain(..BYTE_ORDER_MARK.len());
            }
            let ends = (before..block.len()).rev().filter(|&at| block[at] == b'\n');
            let end = ends.map(|at| at + 1).find(|&end| is_cut(&block[..end]));
            if let Some(end) = end.or((read == 0).then_some(block.len())) {
                self.begun = block.split_off(end);
                return Ok(block);
            }
        }
    }
}

impl<S: Read> Iterator for Blocks<S> {
    type Item = io::Result<Vec<u8>>;

    fn next(&mut self) -> Option<Self::Item> {
        self.block().map(|block| (!block.is_empty()).then_some(block)).transpose()
    }
}

const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// True if a text ends with a line that is not continued.
fn is_cut(text: &[u8]) -> bool {
    let Some(line) = text.strip_suffix(b"\n") else { return false };
    let last = line.iter().rposition(|&byte| byte == b'\n' || !byte.is_ascii_whitespace());
    last.is_none_or(|last| line[last] != b'\\')
}

impl Reader {
    /// Appends the next part of the file; returns an empty part with its memory.
    fn append(&mut self, mut part: Self) -> Self {
        let lines = self.lines;
        self.lines += part.lines;
        let [vertices, faces, corners] =
            [self.contents.positions.len(), self.ends.len(), self.corners.len()];
        let Contents {
            mut positions,
            mut vertex_lines,
            mut face_lines,
            kept,
            damage,
            bad_indices,
            ..
        } = part.contents;
        let all = &mut self.contents;
        all.positions.append(&mut positions);
        all.vertex_lines.extend(vertex_lines.drain(..).map(|line| line + lines));
        all.face_lines.extend(face_lines.drain(..).map(|line| line + lines));
        all.damage.append(damage, lines);
        all.bad_indices.append(bad_indices, lines);
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
        all.kept.append(kept.skipped, kept.notes, lines);
        self.corners.append(&mut part.corners);
        self.ends.extend(part.ends.drain(..).map(|end| end + corners));
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
        Self {
            contents: Contents { positions, vertex_lines, face_lines, ..Contents::default() },
            corners: part.corners,
            ends: part.ends,
            ..Self::default()
        }
    }

    /// The contents of the file, after all of it has been read.
    fn finish(mut self) -> Contents {
        self.look_for_bad_indices();
        for (face, place, name) in std::mem::take(&mut self.states) {
            self.contents.kept.enter_state(face, place, &name);
        }
        let mut known = HashSet::new();
        self.libraries.retain(|library| known.insert(library.clone()));
        self.contents.kept.libraries = std::mem::take(&mut self.libraries);
        self.add_columns();
        let mut contents = self.contents;
        // They become the positions of the mesh.
        contents.positions.shrink_to_fit();
        contents.polygons = Polygons::of_parts(self.corners, self.ends);
        contents
    }
}

/// Appends the values of a part, if it has any; missing values before it are `usual`.
fn extend<T: Copy>(table: &mut Vec<T>, part: Vec<T>, before: usize, usual: T) {
    if !part.is_empty() {
        table.resize(before, usual);
        table.extend(part);
    }
}
