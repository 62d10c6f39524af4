//! Stereolithography: triangles by the positions of their corners, as text or binary.
//!
//! The crate `stl_io` takes every file that begins with `solid ` for text, though many binary ones
//! do; rejects `solid` without a name, capitals, and several solids in a file; rounds numbers of
//! text to 32 bits; and writes no text. So the sixty lines that it would save are here.
//!
//! Triangles share no vertices in such a file: equal points become one vertex. Normals follow from
//! the points and are ignored, as are the two bytes after each binary triangle, which are reported
//! if they are not 0. A binary file holds 32 bits of each coordinate.

use std::io::{self, Write};

use glam::DVec3;

use super::contents::Contents;
use super::error::{Damage, Failure, FileReason};
use super::format::Encoding;
use super::mesh_file::{MeshFile, WrittenNumbers};
use super::print::Printer;
use super::scan::{Scanner, no_number, shown, without_mark};
use crate::mesh::id::VertexId;
use crate::mesh::polygons::Polygons;
use crate::mesh::repair::merge_equal;

const HEADER: usize = 84;
const TRIANGLE: usize = 50;

/// Reads a file.
pub(super) fn read(text: &[u8]) -> Result<Contents, Failure> {
    let claimed = claimed(text);
    let Some(head) = text.get(..HEADER) else {
        return if is_text(text) { Ok(read_text(text)) } else { Err(no_file("it is too short")) };
    };
    // Many binary files begin with `solid`, and some have bytes after the triangles.
    if is_whole(text) || head.contains(&0) {
        Ok(read_binary(text, claimed))
    } else if is_text(text) {
        Ok(read_text(text))
    } else if head[80..].iter().all(|byte| byte.is_ascii_graphic() || byte.is_ascii_whitespace()) {
        // Such letters are no number of triangles.
        Err(no_file("it is a text that does not begin with `solid`"))
    } else {
        Ok(read_binary(text, claimed))
    }
}

/// The number of triangles that the header declares.
fn claimed(text: &[u8]) -> usize {
    let claimed = text.get(80..HEADER).and_then(|count| count.try_into().ok());
    claimed.map_or(0, u32::from_le_bytes) as usize
}

/// True if a file is binary, and as long as its header declares.
pub(super) fn is_whole(text: &[u8]) -> bool {
    text.len().checked_sub(HEADER) == claimed(text).checked_mul(TRIANGLE)
}

/// True if a file is binary, for all that its header tells: letters there would declare too much.
pub(super) fn is_likely(text: &[u8]) -> bool {
    let room = text.len().saturating_sub(HEADER) / TRIANGLE;
    (1..=room).contains(&claimed(text))
}

/// True if a text, after its byte order mark, begins as an STL file does.
pub(super) fn is_text(text: &[u8]) -> bool {
    let start = without_mark(text).trim_ascii_start();
    start.get(..5).is_some_and(|word| word.eq_ignore_ascii_case(b"solid"))
}

fn no_file(why: &str) -> Failure {
    (None, FileReason::Malformed(format!("this is no STL file: {why}")))
}

fn read_binary(text: &[u8], claimed: usize) -> Contents {
    let (all, _) = text[HEADER..].as_chunks::<TRIANGLE>();
    // Programs that do not know the number in advance leave a 0.
    let is_counted = claimed > 0 || all.is_empty();
    let triangles = if is_counted { &all[..claimed.min(all.len())] } else { all };
    let mut points = Vec::with_capacity(triangles.len() * 3);
    let mut tagged = 0;
    for triangle in triangles {
        let (numbers, _) = triangle[12..48].as_chunks::<4>();
        let (corners, _) = numbers.as_chunks::<3>();
        for corner in corners {
            points.push(DVec3::from_array(corner.map(|it| f64::from(f32::from_le_bytes(it)))));
        }
        tagged += usize::from(triangle[48..] != [0, 0]);
    }
    let mut contents = share(points);
    let tags = [
        "triangle with two bytes of a program's own",
        "triangles with two bytes of a program's own",
    ];
    contents.kept.note_count(tags, tagged);
    let rest = &text[HEADER + triangles.len() * TRIANGLE..];
    if claimed <= all.len() && is_counted {
        contents.kept.note_bytes_behind(rest, "triangle that the header declares");
    }
    contents.encoding = Encoding::LittleEndian;
    if claimed > all.len() || !is_counted {
        contents.damage.add(None, || {
            let room = all.len();
            format!("its header declares {claimed} triangles, and there is room for {room}")
        });
    }
    contents
}

fn read_text(text: &[u8]) -> Contents {
    let mut scanner = Scanner::new(text);
    let mut damage = Damage::default();
    let mut points = Vec::with_capacity(text.len() / 80);
    // The number of points before this loop, and whether all of the loop has been read.
    let (mut before, mut is_whole) = (0, true);
    let (mut solids, mut is_open) = (0, false);
    while scanner.next_line() {
        let line = scanner.line();
        let Some(word) = scanner.word() else { continue };
        let is = |known: &str| word.eq_ignore_ascii_case(known.as_bytes());
        if is("vertex") {
            match [(); 3].map(|()| scanner.number()) {
                [Some(Ok(x)), Some(Ok(y)), Some(Ok(z))] => points.push(DVec3::new(x, y, z)),
                numbers => {
                    let other = numbers.into_iter().flatten().find_map(Result::err);
                    let words = || "`vertex` needs three numbers".to_owned();
                    damage.add(Some(line), || other.map_or_else(words, no_number));
                    is_whole = false;
                }
            }
        } else if is("endloop") {
            let is_of_three = points.len() - before == 3;
            if is_whole && !is_of_three {
                damage.add(Some(line), || "a loop of STL has three vertices".to_owned());
            }
            if !is_whole || !is_of_three {
                points.truncate(before);
            }
            (before, is_whole) = (points.len(), true);
        } else if is("solid") {
            solids += 1;
            is_open = true;
        } else if is("endsolid") {
            is_open = false;
        } else if !["facet", "outer", "endfacet"].into_iter().any(is) {
            damage.add(Some(line), || format!("`{}` is not a word of an STL file", shown(word)));
        }
        scanner.end_line();
    }
    if is_open || points.len() > before {
        let words = "the file ends before `endsolid`: triangles may be missing";
        damage.add(Some(scanner.line()), || words.to_owned());
        points.truncate(before);
    }
    let mut contents = share(points);
    contents.damage = damage;
    let several = ["solid", "solids, which are one mesh now"];
    contents.kept.note_count(several, if solids > 1 { solids } else { 0 });
    contents.encoding = Encoding::Ascii;
    contents
}

/// Merges equal points into one vertex.
fn share(points: Vec<DVec3>) -> Contents {
    let mut corners = merge_equal(&points);
    let mut positions: Vec<DVec3> = Vec::with_capacity(points.len() / 5);
    for i in 0..corners.len() {
        // The first of equal points gets a new number, which the later ones look up.
        corners[i] = if corners[i] as usize == i {
            positions.push(points[i]);
            positions.len() as u32 - 1
        } else {
            corners[corners[i] as usize]
        };
    }
    let ends = (1..=corners.len() / 3).map(|end| end * 3).collect();
    Contents { positions, polygons: Polygons::of_parts(corners, ends), ..Contents::default() }
}

/// The number of vertices with the same position as another one, as written, and of those without a
/// face.
pub(super) fn lost_vertices(file: &MeshFile) -> [usize; 2] {
    let mesh = &file.mesh;
    let is_used =
        |&v: &VertexId| mesh.spokes(v).any(|h| mesh.get_face(h).is_some_and(|f| !mesh.is_hole(f)));
    let (used, unused): (Vec<_>, Vec<_>) = mesh.vertices().partition(is_used);
    let is_text = file.encoding == Encoding::Ascii;
    let place = |&v: &VertexId| match (is_text, mesh.position(v)) {
        (true, at) => at,
        (false, at) => at.as_vec3().as_dvec3(),
    };
    let points: Vec<DVec3> = used.iter().map(place).collect();
    let merged = merge_equal(&points);
    let one_with_others = (0..).zip(&merged).filter(|(point, other)| point != *other);
    [one_with_others.count(), unused.len()]
}

/// Writes a mesh of triangles.
pub(super) fn write(
    output: &mut dyn Write,
    file: &MeshFile,
    numbers: &WrittenNumbers,
) -> Result<(), FileReason> {
    let mesh = &file.mesh;
    let is_text = file.encoding == Encoding::Ascii;
    for (number, &face) in (1..).zip(&numbers.face_order) {
        let sides = mesh.face_size(face);
        if sides != 3 {
            return Err(FileReason::Unheld(format!(
                "an STL file holds triangles alone, and face {number} has {sides} sides; \
                 triangulate the mesh, or write another format"
            )));
        }
    }
    let is_small = |&v: &_| mesh.position(v).as_vec3().is_finite();
    if let (false, Some(stray)) = (is_text, numbers.vertex_order.iter().position(|v| !is_small(v)))
    {
        return Err(FileReason::Unheld(format!(
            "vertex {} has a coordinate that is too large for the 32 bits of an STL file",
            stray + 1
        )));
    }
    let mut printer = Printer::new(output);
    write_triangles(&mut printer, file, numbers, is_text).map_err(FileReason::Io)
}

fn write_triangles(
    printer: &mut Printer,
    file: &MeshFile,
    numbers: &WrittenNumbers,
    is_text: bool,
) -> io::Result<()> {
    if is_text {
        printer.bytes(b"solid hedgerow\n");
    } else {
        let mut head = [b' '; HEADER];
        head[..8].copy_from_slice(b"hedgerow");
        head[80..].copy_from_slice(&(numbers.face_order.len() as u32).to_le_bytes());
        printer.bytes(&head);
    }
    for &face in &numbers.face_order {
        let mut points = [DVec3::ZERO; 3];
        for (point, v) in points.iter_mut().zip(file.mesh.face_vertices(face)) {
            *point = file.mesh.position(v);
            if !is_text {
                *point = point.as_vec3().as_dvec3(); // the normal is that of what is written
            }
        }
        let [a, b, c] = points;
        let normal = (b - a).cross(c - a).normalize_or_zero();
        if is_text {
            printer.word("  facet normal");
            printer.reals(&normal.to_array());
            printer.bytes(b"\n    outer loop\n");
            for point in points {
                printer.word("      vertex");
                printer.reals(&point.to_array());
                printer.bytes(b"\n");
            }
            printer.bytes(b"    endloop\n  endfacet");
            printer.end_line()?;
        } else {
            for number in [normal, a, b, c].into_iter().flat_map(|at| at.as_vec3().to_array()) {
                printer.bytes(&number.to_le_bytes());
            }
            printer.bytes(&[0, 0]);
            printer.flush_if_full()?;
        }
    }
    if is_text {
        printer.bytes(b"endsolid hedgerow\n");
    }
    printer.flush()
}
