//! How C++ reads, writes, allocates and erases: what differs from one mesh class to the next.
//!
//! Everything is a pattern with a name. A pattern may speak of `{of}`, the element; `{pointer}`,
//! the name of the pointer or attribute; and `{value}`.

use std::fmt;

use crate::diagram::{Kind, Pointer};

/// Patterns and names, each with what it is for as long as nobody says otherwise, and with what
/// meshes with accessors have.
const PATTERNS: &[(&str, &str, Option<&str>)] = &[
    ("read", "{of}->{pointer}", Some("{of}->{pointer}()")),
    ("write", "{of}->{pointer} = {value}", Some("{of}->{pointer}() = {value}")),
    ("next", "next", None),
    ("prev", "", None),
    ("twin", "twin", None),
    ("vertex", "vertex", None),
    ("edge", "edge", None),
    ("face", "face", None),
    ("halfedge", "halfedge", None),
    ("boundary", "{of}->boundary", Some("{of}->is_boundary()")),
    ("set_boundary", "{of}->boundary = {value}", None),
    ("position", "{of}->position", Some("{of}->pos")),
    ("attribute", "{of}->{pointer}", None),
    ("mesh", "Mesh", Some("Halfedge_Mesh")),
    ("nested", "yes", None),
    ("member", "no", None),
    ("function", "", None),
    ("Vertex", "VertexRef", None),
    ("Halfedge", "HalfedgeRef", None),
    ("Edge", "EdgeRef", None),
    ("Face", "FaceRef", None),
    ("Vector", "Vec3", None),
    ("Vector2", "", None),
    ("Vector4", "", None),
    ("Matrix3", "", None),
    ("Matrix4", "", None),
    ("real", "double", Some("float")),
    ("new_vertex", "new_vertex()", None),
    ("new_halfedge", "new_halfedge()", None),
    ("new_edge", "new_edge()", None),
    ("new_face", "new_face()", None),
    ("erase_vertex", "erase({of})", None),
    ("erase_halfedge", "erase({of})", None),
    ("erase_edge", "erase({of})", None),
    ("erase_face", "erase({of})", None),
];

/// How C++ spells what a mesh class has its own ways for.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Style {
    patterns: Vec<String>,
}

impl Default for Style {
    /// Fields: `h->next`.
    fn default() -> Self {
        Self { patterns: PATTERNS.iter().map(|(_, fields, _)| fields.to_string()).collect() }
    }
}

/// Why a style is not understood.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StyleError {
    /// Neither a name of a style nor `NAME=PATTERN`.
    NotAStyle(String),
    /// There is no such pattern.
    Unknown(String),
    /// A pattern leaves out what it has to speak of.
    Lacks {
        /// The pattern.
        name: String,
        /// `{of}`
        part: &'static str,
    },
    /// A name would not be one in C++.
    NotAName {
        /// The pattern.
        name: String,
        /// What it was to be.
        value: String,
    },
}

impl fmt::Display for StyleError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAStyle(text) => {
                write!(f, "`{text}` is no style: write fields, accessors, or NAME=PATTERN")
            }
            Self::Unknown(name) => {
                let names: Vec<_> = PATTERNS.iter().map(|(name, _, _)| *name).collect();
                write!(f, "a style has no `{name}`; it has {}", names.join(", "))
            }
            Self::Lacks { name, part } => {
                write!(f, "the pattern of `{name}` has to speak of `{part}`")
            }
            Self::NotAName { name, value } => {
                write!(f, "`{name}` is to be a name in C++, and `{value}` is none")
            }
        }
    }
}

impl Style {
    /// Changes a style: `fields`, `accessors`, or `NAME=PATTERN`.
    ///
    /// # Errors
    /// [`StyleError`] for what is neither, for a pattern that there is not, and for one that
    /// leaves out the element or the value.
    pub fn set(&mut self, text: &str) -> Result<(), StyleError> {
        match text {
            "fields" => *self = Self::default(),
            "accessors" => {
                for (pattern, (_, _, accessors)) in self.patterns.iter_mut().zip(PATTERNS) {
                    if let Some(accessors) = accessors {
                        *pattern = accessors.to_string();
                    }
                }
            }
            _ => {
                let (name, value) =
                    text.split_once('=').ok_or_else(|| StyleError::NotAStyle(text.to_string()))?;
                let at = PATTERNS
                    .iter()
                    .position(|(known, _, _)| *known == name)
                    .ok_or_else(|| StyleError::Unknown(name.to_string()))?;
                understand(name, PATTERNS[at].1, value)?;
                self.patterns[at] = value.to_string();
            }
        }
        Ok(())
    }

    fn pattern(&self, name: &str) -> &str {
        let at = PATTERNS.iter().position(|(known, _, _)| *known == name);
        at.map_or("", |at| &self.patterns[at])
    }

    /// A name, as the mesh class has it.
    pub(in crate::emit) fn name(&self, name: &str) -> &str {
        self.pattern(name)
    }

    /// A type of values; arrays, matrices column by column, where the mesh class has none.
    pub(in crate::emit) fn value(&self, ty: &str) -> String {
        let name = self.pattern(ty);
        if !name.is_empty() {
            return name.to_string();
        }
        let array = |of: &str, size: u8| format!("std::array<{of}, {size}>");
        let (real, size) = (self.pattern("real"), if ty.ends_with('3') { 3 } else { 4 });
        match ty {
            "Vector2" => array(real, 2),
            "Vector4" => array(real, 4),
            _ => array(&array(real, size), size),
        }
    }

    /// Whether operations are members of the mesh class.
    pub(in crate::emit) fn is_member(&self) -> bool {
        self.pattern("member") == "yes"
    }

    /// Whether halfedges store `prev`.
    pub(in crate::emit) fn has_prev(&self) -> bool {
        !self.pattern("prev").is_empty()
    }

    /// `of.pointer`; `None` for a pointer that is no field.
    pub(in crate::emit) fn read(&self, of: &str, pointer: Pointer) -> Option<String> {
        let pointer = self.pattern(field(pointer)?);
        (!pointer.is_empty()).then(|| fill(self.pattern("read"), of, pointer, ""))
    }

    /// `of.pointer` for a pointer by its usual name, and also `position` and `boundary`; of a
    /// mesh, `new_vertex` and the like.
    pub(in crate::emit) fn chained(&self, of: &str, pointer: &str) -> String {
        let pointer = match pointer {
            "boundary" => return self.boundary(of),
            "position" => return self.position(of),
            pointer => match pointer.strip_prefix("new_") {
                Some(kind) => return format!("{of}.{}", self.allocation(kind)),
                None => usual(pointer),
            },
        };
        self.read(of, pointer).unwrap_or_default()
    }

    /// `of.pointer = value` for the same; of a mesh, what erases the value.
    pub(in crate::emit) fn put(&self, of: &str, pointer: &str, value: &str) -> String {
        match pointer {
            "boundary" => fill(self.pattern("set_boundary"), of, "", value),
            "position" => format!("{} = {value}", self.position(of)),
            pointer => match pointer.strip_prefix("erase_") {
                Some(kind) => format!("{of}.{}", self.erasure(kind, value)),
                None => self.write(of, usual(pointer), value).unwrap_or_default(),
            },
        }
    }

    /// A type where the names of the mesh class are not in sight: `Mesh::VertexRef`.
    pub(in crate::emit) fn qualified(&self, ty: &str) -> String {
        match self.is_nested(ty) {
            true => format!("{}::{}", self.pattern("mesh"), self.pattern(ty)),
            false => self.value(ty),
        }
    }

    /// Whether a type is one of the mesh class.
    pub(in crate::emit) fn is_nested(&self, ty: &str) -> bool {
        let is_element = ["Vertex", "Halfedge", "Edge", "Face"].contains(&ty);
        is_element && self.pattern("nested") == "yes"
    }

    /// `of.pointer = value`
    pub(in crate::emit) fn write(&self, of: &str, pointer: Pointer, value: &str) -> Option<String> {
        let pointer = self.pattern(field(pointer)?);
        (!pointer.is_empty()).then(|| fill(self.pattern("write"), of, pointer, value))
    }

    pub(in crate::emit) fn boundary(&self, face: &str) -> String {
        fill(self.pattern("boundary"), face, "", "")
    }

    pub(in crate::emit) fn set_boundary(&self, face: &str, value: bool) -> String {
        let value = if value { "true" } else { "false" };
        fill(self.pattern("set_boundary"), face, "", value)
    }

    pub(in crate::emit) fn position(&self, vertex: &str) -> String {
        fill(self.pattern("position"), vertex, "", "")
    }

    /// An attribute of the program, to be read or set.
    pub(in crate::emit) fn attribute(&self, of: &str, name: &str) -> String {
        fill(self.pattern("attribute"), of, name, "")
    }

    /// A call that allocates.
    pub(in crate::emit) fn allocate(&self, kind: Kind) -> String {
        self.call(self.allocation(kind.word()))
    }

    /// A call that erases.
    pub(in crate::emit) fn erase(&self, kind: Kind, of: &str) -> String {
        self.call(self.erasure(kind.word(), of))
    }

    /// What allocates an element of a kind, as the mesh class calls it.
    pub(in crate::emit) fn allocation(&self, kind: &str) -> String {
        self.pattern(&format!("new_{kind}")).to_string()
    }

    /// What erases an element of a kind, as the mesh class calls it.
    pub(in crate::emit) fn erasure(&self, kind: &str, of: &str) -> String {
        fill(self.pattern(&format!("erase_{kind}")), of, "", "")
    }

    fn call(&self, call: String) -> String {
        match self.is_member() {
            true => call,
            false => format!("mesh.{call}"),
        }
    }
}

/// A pointer by its usual name.
fn usual(pointer: &str) -> Pointer {
    match pointer {
        "next" => Pointer::Next,
        "prev" => Pointer::Prev,
        "twin" => Pointer::Twin,
        "vertex" => Pointer::Vertex,
        "edge" => Pointer::Edge,
        "face" => Pointer::Face,
        _ => Pointer::VertexHalfedge,
    }
}

fn field(pointer: Pointer) -> Option<&'static str> {
    Some(match pointer {
        Pointer::Next => "next",
        Pointer::Prev => "prev",
        Pointer::Twin => "twin",
        Pointer::Vertex => "vertex",
        Pointer::Edge => "edge",
        Pointer::Face => "face",
        Pointer::VertexHalfedge | Pointer::EdgeHalfedge | Pointer::FaceHalfedge => "halfedge",
        Pointer::Target => return None,
    })
}

/// Fills a pattern in one go: what is filled in is not looked at again.
fn fill(pattern: &str, of: &str, pointer: &str, value: &str) -> String {
    let mut text = String::new();
    let mut rest = pattern;
    while let Some(at) = rest.find('{') {
        text.push_str(&rest[..at]);
        rest = &rest[at..];
        let parts = [("{of}", of), ("{pointer}", pointer), ("{value}", value)];
        match parts.iter().find(|(part, _)| rest.starts_with(part)) {
            Some((part, with)) => {
                text.push_str(with);
                rest = &rest[part.len()..];
            }
            None => {
                text.push('{');
                rest = &rest[1..];
            }
        }
    }
    text + rest
}

/// Whether a value can be what the pattern is for.
fn understand(name: &str, usual: &str, value: &str) -> Result<(), StyleError> {
    for part in ["{of}", "{pointer}", "{value}"] {
        if usual.contains(part) && !value.contains(part) {
            let name = name.to_string();
            return Err(StyleError::Lacks { name, part });
        }
    }
    let is_call = usual.contains('{') || usual.contains('(');
    let may_be_empty = usual.is_empty();
    let is_name = |text: &str| {
        let parts = text.split("::");
        parts.into_iter().all(|part| {
            let word = part.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
            word && part.chars().next().is_some_and(|c| !c.is_ascii_digit())
        })
    };
    let known = match name {
        "member" | "nested" => value == "yes" || value == "no",
        _ => is_call || (may_be_empty && value.is_empty()) || is_name(value),
    };
    if known && !value.contains('\n') {
        return Ok(());
    }
    Err(StyleError::NotAName { name: name.to_string(), value: value.to_string() })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn patterns_are_filled_in_one_go() {
        assert_eq!(
            fill("{of}.{pointer}({value}) {x}", "{value}", "next", "a"),
            "{value}.next(a) {x}"
        );
    }

    #[test]
    fn a_style_is_changed_bit_by_bit() {
        let mut style = Style::default();
        assert_eq!(style.read("h", Pointer::Next).as_deref(), Some("h->next"));
        assert_eq!(style.read("h", Pointer::Prev), None);
        style.set("accessors").unwrap();
        style.set("halfedge=half_edge").unwrap();
        let read = style.read("v", Pointer::VertexHalfedge);
        assert_eq!(read.as_deref(), Some("v->half_edge()"));
        let write = style.write("a", Pointer::Twin, "b");
        assert_eq!(write.as_deref(), Some("a->twin() = b"));
    }

    #[test]
    fn what_no_style_has_is_an_error() {
        let mut style = Style::default();
        for text in
            ["pascal", "nexxt=n", "write={of}->{pointer}", "next=->x", "member=maybe", "mesh="]
        {
            assert!(style.set(text).is_err(), "{text}");
        }
    }
}
