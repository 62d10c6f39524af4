//! Reading a file, section by section.

use std::collections::HashMap;

use glam::DVec3;

use super::{mujoco, node_count, sides};
use crate::mesh::attribute::{AttributeType, Value};
use crate::mesh::file::contents::{Contents, FileColumn};
use crate::mesh::file::error::{Failure, FileReason};
use crate::mesh::file::format::{Encoding, MshVersion};
use crate::mesh::file::kept::MISSING;
use crate::mesh::file::scan::{Scanner, no_number, shown};
use crate::mesh::id::ElementKind;
use crate::mesh::polygons::Polygons;

/// Reads a file.
pub(in crate::mesh::file) fn read(text: &[u8]) -> Result<Contents, Failure> {
    if let Some(contents) = mujoco::read(text) {
        return Ok(contents);
    }
    let mut reader = Reader::new(text);
    let read = reader.file();
    let line = reader.is_text.then(|| reader.scanner.line());
    match read {
        // What was read so far can be kept.
        Err(words) if reader.scanner.is_at_end() && !reader.contents.positions.is_empty() => {
            reader.contents.damage.add(line, || words);
        }
        read => read.map_err(|words| (line, FileReason::Malformed(words)))?,
    }
    Ok(reader.finish())
}

struct Reader<'t> {
    scanner: Scanner<'t>,
    version: MshVersion,
    is_text: bool,
    is_big: bool,
    contents: Contents,
    /// The vertices by node number.
    nodes: HashMap<u64, u32>,
    /// The faces by element number.
    elements: HashMap<u64, u32>,
    corners: Vec<u32>,
    ends: Vec<usize>,
    /// The names of the groups of surfaces, by group number.
    names: HashMap<i64, Vec<u8>>,
    /// The groups of the surfaces, by surface number.
    surfaces: HashMap<i64, i64>,
    /// The numbers of elements that are not faces, of faces of a higher order, and of values for
    /// elements that are not faces.
    others: usize,
    bent: usize,
    unpaired: usize,
}

type Answer<T> = Result<T, String>;

impl<'t> Reader<'t> {
    fn new(text: &'t [u8]) -> Self {
        Self {
            scanner: Scanner::new(text),
            version: MshVersion::V4,
            is_text: true,
            is_big: false,
            contents: Contents::default(),
            nodes: HashMap::new(),
            elements: HashMap::new(),
            corners: Vec::new(),
            ends: Vec::new(),
            names: HashMap::new(),
            surfaces: HashMap::new(),
            others: 0,
            bent: 0,
            unpaired: 0,
        }
    }

    fn file(&mut self) -> Answer<()> {
        let mut has_format = false;
        while self.scanner.next_line() {
            let line = self.scanner.line();
            let word = self.scanner.word().unwrap_or_default();
            self.scanner.end_line();
            let Some(section) = word.strip_prefix(b"$") else {
                return Err(format!("`{}` begins no section of a Gmsh file", shown(word)));
            };
            match section {
                b"MeshFormat" => {
                    self.format()?;
                    has_format = true;
                }
                _ if !has_format && section != b"Comments" => {
                    return Err("a Gmsh file begins with `$MeshFormat`".into());
                }
                b"PhysicalNames" => self.names()?,
                b"Entities" => self.entities()?,
                b"Nodes" => self.nodes()?,
                b"Elements" => self.elements()?,
                b"NodeData" => self.data(ElementKind::Vertex)?,
                b"ElementData" => self.data(ElementKind::Face)?,
                _ => {
                    let word = shown(word);
                    let what = [format!("section `{word}`"), format!("sections `{word}`")];
                    self.contents.kept.note(what.each_ref().map(String::as_str), line);
                }
            }
            self.end_section(section)?;
        }
        if has_format { Ok(()) } else { Err("a Gmsh file begins with `$MeshFormat`".into()) }
    }

    /// Skips past the end of a section.
    fn end_section(&mut self, section: &[u8]) -> Answer<()> {
        let end = [b"$End", section].concat();
        let found = self.scanner.rest().windows(end.len()).position(|window| window == end);
        let Some(at) = found else {
            self.scanner.skip(self.scanner.rest().len());
            return Err(format!("the section `${}` does not end", shown(section)));
        };
        // Lines are counted only in text; binary data may contain any bytes.
        match self.is_text {
            true => {
                while self.scanner.next_line() {
                    if self.scanner.word() == Some(&end[..]) {
                        break;
                    }
                    self.scanner.end_line();
                }
            }
            false => self.scanner.skip(at + end.len()),
        }
        self.scanner.end_line();
        Ok(())
    }

    fn format(&mut self) -> Answer<()> {
        let version = self.text_number()?;
        self.version = match version {
            2.0..3.0 => MshVersion::V2,
            4.1 => MshVersion::V4,
            _ => {
                return Err(format!(
                    "version {version} of Gmsh files is not read: 2.2 and 4.1 are"
                ));
            }
        };
        self.is_text = self.text_number()? == 0.0;
        if self.text_number()? != 8.0 {
            return Err("numbers of other than 8 bytes are not read".into());
        }
        self.scanner.end_line();
        if !self.is_text {
            self.is_big = match self.bytes::<4>()? {
                [1, 0, 0, 0] => false,
                [0, 0, 0, 1] => true,
                _ => return Err("the bytes of a binary file begin with a 1".into()),
            };
        }
        Ok(())
    }

    fn names(&mut self) -> Answer<()> {
        for _ in 0..self.text_count()? {
            let (dimension, tag) = (self.text_number()?, self.text_number()? as i64);
            let text = self.scanner.text();
            let name = text.strip_prefix(b"\"").and_then(|name| name.strip_suffix(b"\""));
            let name = name.unwrap_or(&text).to_vec();
            let numbers = &mut self.contents.kept.group_numbers;
            if dimension == 2.0 && *numbers.entry(name.clone()).or_insert(tag) == tag {
                self.names.insert(tag, name);
            } else if dimension == 2.0 {
                let what = [
                    "group with the name of another one, which its number is now",
                    "groups with the names of others, which their numbers are now",
                ];
                self.contents.kept.note(what, self.scanner.line());
            }
            self.scanner.end_line();
        }
        Ok(())
    }

    fn entities(&mut self) -> Answer<()> {
        let mut counts = [0; 4];
        for count in &mut counts {
            *count = self.size()?;
        }
        for (dimension, count) in counts.into_iter().enumerate() {
            for _ in 0..count {
                let tag = self.int()?;
                for _ in 0..if dimension == 0 { 3 } else { 6 } {
                    self.real()?;
                }
                for at in 0..self.size()? {
                    let group = self.int()?;
                    if dimension == 2 && at == 0 {
                        self.surfaces.insert(tag, group);
                    }
                }
                if dimension > 0 {
                    for _ in 0..self.size()? {
                        self.int()?;
                    }
                }
            }
        }
        Ok(())
    }

    fn nodes(&mut self) -> Answer<()> {
        if self.version == MshVersion::V2 {
            for _ in 0..self.text_count()? {
                let tag = self.int()?;
                self.node(tag as u64)?;
            }
            return Ok(());
        }
        let blocks = self.size()?;
        for _ in 0..3 {
            self.size()?;
        }
        for _ in 0..blocks {
            let dimension = self.int()?;
            self.int()?;
            let is_parametric = self.int()? != 0;
            let count = self.size()?;
            let tags = (0..count).map(|_| self.size()).collect::<Answer<Vec<_>>>()?;
            for tag in tags {
                self.node(tag)?;
                for _ in 0..if is_parametric { dimension.clamp(0, 3) } else { 0 } {
                    self.real()?;
                }
            }
        }
        Ok(())
    }

    fn node(&mut self, tag: u64) -> Answer<()> {
        let at = DVec3::new(self.real()?, self.real()?, self.real()?);
        if self.nodes.insert(tag, self.contents.positions.len() as u32).is_some() {
            return Err(format!("node {tag} is there twice"));
        }
        self.contents.positions.push(at);
        Ok(())
    }

    fn elements(&mut self) -> Answer<()> {
        if self.version == MshVersion::V2 {
            return self.elements_of_version_2();
        }
        let blocks = self.size()?;
        for _ in 0..3 {
            self.size()?;
        }
        for _ in 0..blocks {
            let dimension = self.int()?;
            let entity = self.int()?;
            let element = self.int()?;
            let count = self.size()?;
            let group = self.surfaces.get(&entity).copied().filter(|_| dimension == 2);
            let nodes = node_count(element)?;
            for _ in 0..count {
                let tag = self.size()?;
                self.element(tag, element as usize, nodes, group)?;
            }
        }
        Ok(())
    }

    fn elements_of_version_2(&mut self) -> Answer<()> {
        let mut left = self.text_count()?;
        while left > 0 {
            // In text, each element has a head of its own; in binary files, each block of elements.
            let first = self.int()?;
            let (tag, element, count) = match self.is_text {
                true => (Some(first as u64), self.int()?, 1),
                false => (None, first, self.int()?),
            };
            let tags = self.int()?;
            let nodes = node_count(element)?;
            if !(1..=left as i64).contains(&count) || !(0..=1 << 20).contains(&tags) {
                return Err("a block of elements is larger than its section".into());
            }
            left -= count as usize;
            for _ in 0..count {
                let tag = tag.map_or_else(|| self.int().map(|tag| tag as u64), Ok)?;
                let mut group = None;
                for at in 0..tags {
                    let value = self.int()?;
                    group = if at == 0 { Some(value).filter(|&value| value != 0) } else { group };
                }
                self.element(tag, element as usize, nodes, group)?;
            }
        }
        Ok(())
    }

    fn element(
        &mut self,
        tag: u64,
        element: usize,
        nodes: usize,
        group: Option<i64>,
    ) -> Answer<()> {
        let sides = sides(element);
        let line = self.scanner.line();
        for at in 0..nodes {
            let node = match self.version {
                MshVersion::V2 => self.int()? as u64,
                MshVersion::V4 => self.size()?,
            };
            if at >= sides {
                continue;
            }
            let vertex = self.nodes.get(&node).copied();
            if vertex.is_none() {
                let line = self.is_text.then_some(line);
                self.contents.bad_indices.add(line, || format!("there is no node {node}"));
            }
            self.corners.push(vertex.unwrap_or(MISSING));
        }
        if sides == 0 {
            self.others += 1;
            return Ok(());
        }
        self.bent += usize::from(nodes > sides);
        let face = self.ends.len() as u32;
        self.elements.insert(tag, face);
        self.ends.push(self.corners.len());
        if self.is_text {
            self.contents.face_lines.push(line);
        }
        let name = match group {
            Some(group) => match self.names.get(&group) {
                Some(name) => name.clone(),
                None => group.to_string().into_bytes(),
            },
            None if self.contents.kept.states.is_empty() => return Ok(()),
            None => b"default".to_vec(),
        };
        self.contents.kept.enter_state(face, 1, &name);
        Ok(())
    }

    /// Values at nodes or elements.
    fn data(&mut self, kind: ElementKind) -> Answer<()> {
        let line = self.scanner.line();
        let mut name = String::new();
        for at in 0..self.text_count()? {
            if !self.scanner.next_line() {
                return Err("the file ends where a text should stand".into());
            }
            let text = self.scanner.text();
            if at == 0 {
                name = String::from_utf8_lossy(&text).trim_matches('"').to_owned();
            }
            self.scanner.end_line();
        }
        for _ in 0..self.text_count()? {
            self.text_number()?;
        }
        let mut ints = [0; 3];
        for at in 0..self.text_count()? {
            let number = self.text_number()?;
            if let Some(int) = ints.get_mut(at) {
                *int = number as usize;
            }
        }
        self.scanner.end_line();
        let [_, width, count] = ints;
        if count == 0 {
            return Ok(()); // a value for each node would take far more room than the file
        }
        let default = match width {
            1 => Value::Real(0.0),
            3 => Value::Vec3(DVec3::ZERO),
            9 => match Value::from_reals(AttributeType::Mat3, &[0.0; 9]) {
                Some(zero) => zero,
                None => return Ok(()), // nine reals are a matrix
            },
            _ => return Err(format!("values of {width} numbers: 1, 3 and 9 are read")),
        };
        let rows = match kind {
            ElementKind::Vertex => self.contents.positions.len(),
            _ => self.ends.len(),
        };
        let mut reals = vec![0.0; rows * width];
        for _ in 0..count {
            let tag = self.int()? as u64;
            let places = if kind == ElementKind::Vertex { &self.nodes } else { &self.elements };
            let place = places.get(&tag).map(|&place| place as usize * width);
            for at in 0..width {
                let real = self.real()?;
                match place {
                    Some(place) => reals[place + at] = real,
                    None => self.unpaired += usize::from(at == 0),
                }
            }
        }
        let said = |c: char| if c.is_alphanumeric() || c == '_' { c } else { '_' };
        let name: String = name.chars().map(said).collect();
        if self.contents.columns.iter().any(|column| column.is(kind, &name)) {
            let what = [
                "value that was there already, at another time",
                "values that were there already, at another time",
            ];
            self.contents.kept.note(what, line);
        } else if !name.is_empty() {
            self.contents.columns.push(FileColumn::new(kind, &name, default, reals));
        }
        Ok(())
    }

    fn finish(self) -> Contents {
        let mut contents = self.contents;
        let kept = &mut contents.kept;
        let mut corners = self.corners;
        corners.truncate(self.ends.last().copied().unwrap_or(0)); // the file may end within one
        let others = [
            "element that is neither a triangle nor a quad",
            "elements that are neither triangles nor quads",
        ];
        kept.note_count(others, self.others);
        let bent = [
            "face of a higher order, which has its corners alone",
            "faces of a higher order, which have their corners alone",
        ];
        kept.note_count(bent, self.bent);
        let unpaired =
            ["value of an element that is not a face", "values of elements that are not faces"];
        kept.note_count(unpaired, self.unpaired);
        contents.msh_version = self.version;
        contents.encoding = Encoding::Ascii;
        contents.polygons = Polygons::of_parts(corners, self.ends);
        contents
    }
}

/// Numbers, as text or as bytes.
impl Reader<'_> {
    fn text_number(&mut self) -> Answer<f64> {
        if !self.scanner.next_line() {
            return Err("the file ends where a number should stand".into());
        }
        match self.scanner.number() {
            Some(Ok(number)) => Ok(number),
            Some(Err(word)) => Err(no_number(word)),
            None => Err("the file ends where a number should stand".into()),
        }
    }

    /// A count, which is text in a binary file, too.
    fn text_count(&mut self) -> Answer<usize> {
        let count = self.text_number()? as usize;
        if !self.is_text {
            self.scanner.end_line();
        }
        Ok(count)
    }

    fn bytes<const N: usize>(&mut self) -> Answer<[u8; N]> {
        let bytes = self.scanner.rest().first_chunk::<N>().copied();
        self.scanner.skip(N);
        bytes.ok_or_else(|| "the file ends where a number should stand".to_owned())
    }

    fn int(&mut self) -> Answer<i64> {
        if self.is_text {
            return self.text_number().map(|number| number as i64);
        }
        let bytes = self.bytes()?;
        Ok(i64::from(if self.is_big {
            i32::from_be_bytes(bytes)
        } else {
            i32::from_le_bytes(bytes)
        }))
    }

    fn size(&mut self) -> Answer<u64> {
        if self.is_text {
            return self.text_number().map(|number| number as u64);
        }
        let bytes = self.bytes()?;
        Ok(if self.is_big { u64::from_be_bytes(bytes) } else { u64::from_le_bytes(bytes) })
    }

    fn real(&mut self) -> Answer<f64> {
        if self.is_text {
            return self.text_number();
        }
        let bytes = self.bytes()?;
        Ok(if self.is_big { f64::from_be_bytes(bytes) } else { f64::from_le_bytes(bytes) })
    }
}
