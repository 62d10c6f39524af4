//! Reading a file: tables of numbers become polygons and columns.

use std::collections::HashMap;

use glam::{DVec2, DVec3};

use super::body::{Body, Table};
use super::header::{Declared, Element, Header, Property, STATES, Scalar};
use crate::mesh::attribute::{AttributeType, Value};
use crate::mesh::file::contents::{Contents, FileColumn};
use crate::mesh::file::corners::OfCorner;
use crate::mesh::file::error::{Failure, FileReason};
use crate::mesh::file::kept::MISSING;
use crate::mesh::file::scan::shown;
use crate::mesh::id::ElementKind;
use crate::mesh::polygons::Polygons;

/// Reads a file.
pub(in crate::mesh::file) fn read(text: &[u8]) -> Result<Contents, Failure> {
    let header = Header::read(text)?;
    let mut body = Body::new(&header, &text[header.length..]);
    let mut contents = Contents { encoding: header.encoding, ..Contents::default() };
    contents.kept.libraries.clone_from(&header.libraries);
    contents.kept.comments.clone_from(&header.comments);
    contents.damage = header.damage.clone();
    for element in &header.elements {
        body.expect_numbers(element)?;
        let tables = body.read(element, &mut contents)?;
        let is_cut_off = body.is_cut_off;
        if is_cut_off && tables.iter().all(Table::is_empty) {
            break;
        }
        let mut rows = Rows { header: &header, element, tables, contents: &mut contents };
        match element.name.as_str() {
            "vertex" => rows.vertices()?,
            "face" => rows.faces()?,
            "tristrips" => rows.strips()?,
            "edge" => rows.edges(),
            _ if element.count == 0 => {}
            _ => rows.skip(""),
        }
        if is_cut_off {
            break;
        }
    }
    if !body.is_cut_off {
        body.note_rest(&mut contents.kept);
    }
    check_corners(&mut contents);
    Ok(contents)
}

/// Finds corners with invalid indices, after the whole file: vertices may follow the faces.
fn check_corners(contents: &mut Contents) {
    let vertices = contents.positions.len();
    let (mut corners, ends) = std::mem::take(&mut contents.polygons).into_parts();
    for corner in &mut corners {
        if *corner as usize >= vertices {
            let index = *corner;
            match index {
                MISSING => contents.bad_indices.add(None, || {
                    "there is an index of a vertex that is not a number from 0 on".to_owned()
                }),
                _ => contents.bad_indices.add_vertex(None, index.into(), vertices),
            }
            *corner = MISSING;
        }
    }
    contents.polygons = Polygons::of_parts(corners, ends);
}

/// The rows of an element, to be turned into columns.
struct Rows<'r> {
    header: &'r Header,
    element: &'r Element,
    tables: Vec<Table>,
    contents: &'r mut Contents,
}

/// Groups of properties that form one attribute.
const TOGETHER: [(&str, &[&str]); 8] = [
    ("normal", &["nx", "ny", "nz"]),
    ("color", &["red", "green", "blue"]),
    ("color", &["diffuse_red", "diffuse_green", "diffuse_blue"]),
    ("color", &["r", "g", "b"]),
    ("uv", &["s", "t"]),
    ("uv", &["u", "v"]),
    ("uv", &["texture_u", "texture_v"]),
    ("alpha", &["alpha"]),
];

/// The lists at the corners of faces that are kept beside the mesh, with the numbers that each
/// corner has.
const AT_CORNERS: [(&str, OfCorner, usize); 3] = [
    ("texcoord", OfCorner::Texture, 2),
    ("uv", OfCorner::Texture, 3),
    ("normal", OfCorner::Normal, 3),
];

impl Rows<'_> {
    /// Takes the table of the property with the given name, if there is one.
    fn take(&mut self, name: &str, list: bool) -> Option<(Table, Scalar)> {
        let place = self.place(name, list)?;
        Some((std::mem::take(&mut self.tables[place]), self.element.properties[place].scalar))
    }

    fn place(&self, name: &str, list: bool) -> Option<usize> {
        let is_it = |property: &Property| property.name == name && property.list.is_some() == list;
        let place = self.element.properties.iter().position(is_it)?;
        let table = &self.tables[place];
        (!(table.numbers.is_empty() && table.ends.is_empty())).then_some(place)
    }

    fn vertices(&mut self) -> Result<(), Failure> {
        let mut axes = ["x", "y", "z"].map(|name| self.take(name, false).map(|(table, _)| table));
        if axes.iter().any(Option::is_none) && self.element.count > 0 {
            let words = "the vertices have no `x`, `y` and `z`".to_owned();
            return Err((None, FileReason::Malformed(words)));
        }
        if let [Some(x), Some(y), Some(z)] = &mut axes {
            let numbers = x.numbers.iter().zip(&y.numbers).zip(&z.numbers);
            self.contents.positions.extend(numbers.map(|((&x, &y), &z)| DVec3::new(x, y, z)));
        }
        self.columns(ElementKind::Vertex, &[]);
        Ok(())
    }

    /// The lists of corners of faces or strips; `None` if there are no such elements.
    fn corner_lists(&mut self, of: &str) -> Result<Option<Table>, Failure> {
        let mut names = ["vertex_indices", "vertex_index"].into_iter();
        let words = match names.find_map(|name| self.take(name, true)) {
            _ if self.element.count == 0 => return Ok(None),
            Some(_) if !self.contents.polygons.is_empty() => {
                "there are elements `face` and `tristrips`, of which only one is read".to_owned()
            }
            Some((table, _)) => return Ok(Some(table)),
            None => format!("the {of} have no list `vertex_indices`"),
        };
        Err((None, FileReason::Malformed(words)))
    }

    /// Reads triangle strips: each corner after the first two of a strip makes a triangle with the
    /// two before it, every other one reversed. A negative number ends a strip.
    fn strips(&mut self) -> Result<(), Failure> {
        let Some(Table { numbers, ends }) = self.corner_lists("strips")? else { return Ok(()) };
        let mut start = 0;
        for end in ends {
            for strip in numbers[start..end].split(|&number| number < 0.0) {
                for (at, three) in strip.windows(3).enumerate() {
                    let [a, b, c] = [three[0], three[1], three[2]].map(index);
                    // A strip repeats a corner to turn.
                    if a != b && b != c && c != a {
                        let triangle = if at % 2 == 0 { [a, b, c] } else { [b, a, c] };
                        self.contents.polygons.push(&triangle);
                    }
                }
            }
            start = end;
        }
        Ok(())
    }

    fn faces(&mut self) -> Result<(), Failure> {
        let Some(Table { numbers, ends }) = self.corner_lists("faces")? else { return Ok(()) };
        let corners: Vec<u32> = numbers.into_iter().map(index).collect();
        self.states();
        AT_CORNERS.into_iter().for_each(|at_corners| self.at_corners(at_corners, &ends));
        self.columns(ElementKind::Face, &ends);
        self.contents.polygons = Polygons::of_parts(corners, ends);
        Ok(())
    }

    /// Reads texture coordinates or normals at the corners; an empty list stands for none.
    fn at_corners(&mut self, (name, what, width): (&str, OfCorner, usize), ends: &[usize]) {
        let Some(place) = self.place(name, true) else { return };
        let are_declared = |kind| self.find_declared(kind, name).is_some();
        let has_parts = |&(attribute, parts): &(&str, &[&str])| {
            attribute == name && parts.iter().all(|part| self.place(part, false).is_some())
        };
        let are_of_faces = are_declared(ElementKind::Face) && !TOGETHER.iter().any(has_parts);
        if are_declared(ElementKind::Halfedge) || are_of_faces {
            return; // they are an attribute by themselves
        }
        let table = &self.tables[place];
        let mut is_fitting = true;
        let (mut start, mut first) = (0, 0);
        for (&end, &corners) in table.ends.iter().zip(ends) {
            let (numbers, corners) = (end - start, corners - first);
            is_fitting &= numbers == 0 || numbers == width * corners;
            (start, first) = (end, first + corners);
        }
        let (rows, of_corners) = self.contents.kept.at_corners(what);
        if !is_fitting || !of_corners.is_empty() {
            return;
        }
        let Table { numbers, ends: lists } = std::mem::take(&mut self.tables[place]);
        rows.width = width;
        let mut known = HashMap::new();
        let (mut start, mut first) = (0, 0);
        for (&end, &corners) in lists.iter().zip(ends) {
            for corner in 0..corners - first {
                of_corners.push(match end - start {
                    0 => MISSING,
                    _ => {
                        let mut row = [0.0; 3];
                        let first = start + width * corner;
                        row[..width].copy_from_slice(&numbers[first..first + width]);
                        let next = rows.rows.len() as u32;
                        let place = *known.entry(row.map(f64::to_bits)).or_insert(next);
                        if place == next {
                            rows.rows.push(row);
                        }
                        place
                    }
                });
            }
            (start, first) = (end, corners);
        }
    }

    /// Reads objects, groups, materials and smoothing groups, where comments name them.
    fn states(&mut self) {
        for (keyword, name) in STATES.into_iter().enumerate() {
            let names = &self.header.names[keyword];
            if names.is_empty() {
                continue;
            }
            match self.take(name, false) {
                Some((table, _)) => self.contents.kept.add_states(keyword, names, &table.numbers),
                // They are comments of another program.
                None => {
                    self.contents.kept.comments.extend((0..).zip(names).map(|(at, text)| {
                        [format!("comment {name} {at} ").as_bytes(), text].concat()
                    }))
                }
            }
        }
    }

    fn edges(&mut self) {
        let ends = ["vertex1", "vertex2"].map(|name| self.take(name, false));
        let [Some((from, _)), Some((to, _))] = ends else {
            return self.skip(" without `vertex1` and `vertex2`");
        };
        let pairs = from.numbers.iter().zip(&to.numbers);
        self.contents.edges = pairs.map(|(&v, &w)| [index(v), index(w)]).collect();
        self.columns(ElementKind::Edge, &[]);
    }

    /// Notes that the rows are not in the mesh; `which` is said behind the name of the element.
    fn skip(&mut self, which: &str) {
        let name = shown(self.element.name.as_bytes());
        let what = ["element", "elements"].map(|word| format!("{word} `{name}`{which}"));
        self.contents.kept.note_count(what, self.element.count);
    }

    /// Makes columns of the remaining tables. `corners` has the ends of the polygons.
    fn columns(&mut self, kind: ElementKind, corners: &[usize]) {
        let mut known = Vec::new();
        for (name, parts) in TOGETHER {
            let places: Option<Vec<_>> = parts.iter().map(|part| self.place(part, false)).collect();
            let Some(places) = places else { continue };
            if known.contains(&name) {
                continue; // others are this attribute, and these stay single numbers
            }
            if parts.iter().any(|part| self.find_declared(kind, part).is_some()) {
                continue; // they are attributes by themselves
            }
            known.push(name);
            let rows = self.tables[places[0]].numbers.len();
            let scale = match name {
                "color" | "alpha" => self.element.properties[places[0]].scalar.greatest(),
                _ => 1.0,
            };
            let mut reals = Vec::with_capacity(rows * places.len());
            for row in 0..rows {
                reals.extend(places.iter().map(|&place| self.tables[place].numbers[row] / scale));
            }
            places.iter().for_each(|&place| self.tables[place] = Table::default());
            let declared = self.find_declared(kind, name).map(|declared| declared.default);
            if let Some(default) = declared.or(usual_default(name))
                && default.attribute_type().width() == places.len()
            {
                self.contents.columns.push(FileColumn::new(kind, name, default, reals));
            }
        }
        // A name that an attribute cannot have does not take that of another one.
        let mut places: Vec<usize> = (0..self.tables.len()).collect();
        places.sort_by_key(|&place| !self.element.properties[place].name.chars().all(is_of_name));
        for place in places {
            let table = std::mem::take(&mut self.tables[place]);
            if !table.numbers.is_empty() {
                self.column(kind, place, table, corners);
            }
        }
    }

    fn column(&mut self, kind: ElementKind, place: usize, table: Table, corners: &[usize]) {
        let property = &self.element.properties[place];
        let said = |c: char| if is_of_name(c) { c } else { '_' };
        let name: String = property.name.chars().map(said).collect();
        let said_so = |kind| self.find_declared(kind, &property.name);
        let declared = |kind| said_so(kind).map(|declared| declared.default);
        let common = table.common_length();
        // The count of numbers per corner, if it is the same for all lists.
        let of_corners = (!corners.is_empty() && corners.len() == table.ends.len())
            .then(|| {
                let (first, sides) = (*table.ends.first()?, *corners.first()?);
                let each = first.checked_div(sides)?;
                let alike = table.ends.iter().zip(corners).all(|(&end, &c)| end == each * c);
                (alike && each > 0).then_some(each)
            })
            .flatten();
        let found = if property.list.is_none() {
            let usual = if property.scalar.is_whole() { Value::Int(0) } else { Value::Real(0.0) };
            Some((kind, declared(kind).unwrap_or(usual), 1))
        } else if let (Some(each), Some(default)) = (of_corners, declared(ElementKind::Halfedge))
            && default.attribute_type().width() == each
        {
            Some((ElementKind::Halfedge, default, each))
        } else if let (Some(length), Some(default)) = (common, declared(kind)) {
            Some((kind, default, length))
        } else {
            let corner =
                of_corners.and_then(|each| Some((ElementKind::Halfedge, zero(each)?, each)));
            corner.or_else(|| common.and_then(|length| Some((kind, zero(length)?, length))))
        };
        match found {
            Some((kind, default, each)) if default.attribute_type().width() == each => {
                let name = said_so(kind).map_or(name, |declared| declared.name.clone());
                self.contents.columns.push(FileColumn::new(kind, &name, default, table.numbers));
            }
            _ => {
                let what = format!(
                    "property `{name}` of the {}, a list that is not a value",
                    kind.plural()
                );
                self.contents.kept.note_count([&what; 2], 1);
            }
        }
    }

    /// The attribute that is declared for a property.
    fn find_declared(&self, kind: ElementKind, property: &str) -> Option<&Declared> {
        self.header.declared[kind as usize].get(property)
    }
}

/// True if a name of an attribute may have a character.
fn is_of_name(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The default of an attribute that other programs know, where none is declared.
pub(super) fn usual_default(name: &str) -> Option<Value> {
    Some(match name {
        "color" => Value::Vec3(DVec3::ONE),
        "alpha" => Value::Real(1.0),
        "uv" => Value::Vec2(DVec2::ZERO),
        "normal" => Value::Vec3(DVec3::ZERO),
        _ => return None,
    })
}

/// The index given by a number; an invalid one becomes [`MISSING`].
fn index(number: f64) -> u32 {
    if number.fract() == 0.0 && number >= 0.0 { number as u32 } else { MISSING }
}

/// The default of a value of the given number of reals.
fn zero(width: usize) -> Option<Value> {
    let mut all = AttributeType::ALL.iter().map(|ty| ty.zero());
    all.find(|zero| width > 0 && zero.reals().len() == width)
}
