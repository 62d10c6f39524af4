//! The head of a file.

use std::collections::HashMap;

use crate::mesh::attribute::{AttributeType, Value};
use crate::mesh::file::error::{Damage, Failure, FileReason};
use crate::mesh::file::format::Encoding;
use crate::mesh::file::scan::shown;
use crate::mesh::id::ElementKind;

/// The type of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Scalar {
    I8,
    U8,
    I16,
    U16,
    I32,
    U32,
    F32,
    F64,
}

impl Scalar {
    fn of(word: &str) -> Option<Self> {
        Some(match word {
            "char" | "int8" => Self::I8,
            "uchar" | "uint8" => Self::U8,
            "short" | "int16" => Self::I16,
            "ushort" | "uint16" => Self::U16,
            "int" | "int32" => Self::I32,
            "uint" | "uint32" => Self::U32,
            "float" | "float32" => Self::F32,
            "double" | "float64" => Self::F64,
            _ => return None,
        })
    }

    pub(super) fn name(self) -> &'static str {
        match self {
            Self::I8 => "char",
            Self::U8 => "uchar",
            Self::I16 => "short",
            Self::U16 => "ushort",
            Self::I32 => "int",
            Self::U32 => "uint",
            Self::F32 => "float",
            Self::F64 => "double",
        }
    }

    pub(super) fn size(self) -> usize {
        match self {
            Self::I8 | Self::U8 => 1,
            Self::I16 | Self::U16 => 2,
            Self::I32 | Self::U32 | Self::F32 => 4,
            Self::F64 => 8,
        }
    }

    pub(super) fn is_whole(self) -> bool {
        !matches!(self, Self::F32 | Self::F64)
    }

    /// The greatest value of the type, by which colours are divided.
    pub(super) fn greatest(self) -> f64 {
        match self {
            Self::I8 => 127.0,
            Self::U8 => 255.0,
            Self::I16 => 32767.0,
            Self::U16 => 65535.0,
            Self::I32 => 2147483647.0,
            Self::U32 => 4294967295.0,
            Self::F32 | Self::F64 => 1.0,
        }
    }
}

/// A property of an element.
#[derive(Clone, Debug)]
pub(super) struct Property {
    pub(super) name: String,
    pub(super) scalar: Scalar,
    /// For a list, the type of its length.
    pub(super) list: Option<Scalar>,
}

/// An element declaration of the head.
#[derive(Clone, Debug)]
pub(super) struct Element {
    pub(super) name: String,
    pub(super) count: usize,
    pub(super) properties: Vec<Property>,
}

impl Element {
    /// The least number of bytes of one element.
    pub(super) fn least_size(&self, encoding: Encoding) -> usize {
        let size = |property: &Property| match encoding {
            Encoding::Ascii => 2,
            _ => property.list.unwrap_or(property.scalar).size(),
        };
        self.properties.iter().map(size).sum()
    }
}

/// The declaration of an attribute in a comment.
pub(super) struct Declared {
    pub(super) name: String,
    pub(super) default: Value,
}

/// A head.
#[derive(Default)]
pub(super) struct Header {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element>,
    /// The attributes of each kind, by the names of the properties that have their values.
    pub(super) declared: [HashMap<String, Declared>; 4],
    /// The names of objects, groups, materials and smoothing groups, by number.
    pub(super) names: [Vec<Vec<u8>>; 4],
    pub(super) libraries: Vec<Vec<u8>>,
    /// The other comments, and the lines `obj_info`.
    pub(super) comments: Vec<Vec<u8>>,
    /// The length in bytes, and the number of lines.
    pub(super) length: usize,
    pub(super) lines: u32,
    /// Lines that do not belong in a head.
    pub(super) damage: Damage,
}

/// The properties of faces that number the states of OBJ, in the order of their keywords.
pub(super) const STATES: [&str; 4] = ["object", "group", "material", "smoothing"];

impl Header {
    pub(super) fn read(text: &[u8]) -> Result<Self, Failure> {
        let mut header = Self { encoding: Encoding::Ascii, ..Self::default() };
        let mut has_format = false;
        loop {
            let rest = &text[header.length..];
            let end = rest.iter().position(|&b| b == b'\n' || b == b'\r');
            let fail = |words: String, line: u32| Err((Some(line), FileReason::Malformed(words)));
            let Some(end) = end else {
                return fail(
                    "the head does not end: `end_header` is missing".into(),
                    header.lines + 1,
                );
            };
            let line = String::from_utf8_lossy(&rest[..end]);
            let is_crlf = rest[end..].starts_with(b"\r\n");
            header.length += end + if is_crlf { 2 } else { 1 };
            header.lines += 1;
            let words: Vec<&str> = line.split_ascii_whitespace().collect();
            let known = match words.as_slice() {
                [word] if header.lines == 1 => word.eq_ignore_ascii_case("ply"),
                _ if header.lines == 1 => false,
                [] => true,
                ["obj_info", ..] => {
                    header.comments.push(rest[..end].trim_ascii().to_vec());
                    true
                }
                ["format", name, _] => {
                    has_format = true;
                    header.set_format(name)
                }
                ["comment", ..] => {
                    header.comment(rest[..end].trim_ascii());
                    true
                }
                ["element", name, _] if header.elements.iter().any(|it| it.name == *name) => {
                    let name = shown(name.as_bytes());
                    return fail(format!("the element `{name}` is there twice"), header.lines);
                }
                ["element", name, count] => match count.parse() {
                    Ok(count) => {
                        let (name, properties) = ((*name).to_owned(), Vec::new());
                        header.elements.push(Element { name, count, properties });
                        true
                    }
                    Err(_) => false,
                },
                ["property", "list", length, scalar, name] => {
                    let list = Scalar::of(length).filter(|length| length.is_whole());
                    list.is_some() && header.add_property(scalar, list, name)
                }
                ["property", scalar, name] => header.add_property(scalar, None, name),
                ["end_header"] if has_format => return Ok(header),
                _ => false,
            };
            if !known && header.lines == 1 {
                return fail("a PLY file begins with a line `ply`".to_owned(), 1);
            }
            if !known {
                let line = shown(line.as_bytes());
                let told = format!("`{line}` is not a line of the header of a PLY file");
                // Nothing can be read without these lines, which describe the body.
                match words.first() {
                    Some(&("format" | "element" | "property" | "end_header")) => {
                        return fail(told, header.lines);
                    }
                    _ => header.damage.add(Some(header.lines), || told),
                }
            }
        }
    }

    fn set_format(&mut self, name: &str) -> bool {
        self.encoding = match name {
            "ascii" => Encoding::Ascii,
            "binary_little_endian" => Encoding::LittleEndian,
            "binary_big_endian" => Encoding::BigEndian,
            _ => return false,
        };
        true
    }

    fn add_property(&mut self, scalar: &str, list: Option<Scalar>, name: &str) -> bool {
        match (self.elements.last_mut(), Scalar::of(scalar)) {
            (Some(element), Some(scalar)) => {
                element.properties.push(Property { name: name.to_owned(), scalar, list });
                true
            }
            _ => false,
        }
    }

    /// Reads a comment: one of the declarations that this module writes, or one to keep.
    fn comment(&mut self, line: &[u8]) {
        let (word, rest) = first_word(line["comment".len()..].trim_ascii());
        let text = String::from_utf8_lossy(rest);
        if word == b"mtllib" {
            self.libraries.push(rest.to_vec());
        } else if word == b"attribute"
            && let Some((kind, property, declared)) = declared(&text)
        {
            self.declared[kind as usize].entry(property).or_insert(declared);
        } else if let Some(place) = STATES.iter().position(|state| state.as_bytes() == word)
            && let (number, name) = first_word(rest)
            && number == self.names[place].len().to_string().as_bytes()
        {
            self.names[place].push(name.to_vec());
        } else {
            self.comments.push(line.to_vec());
        }
    }
}

/// The first word of a text, and what follows the blank behind it.
fn first_word(text: &[u8]) -> (&[u8], &[u8]) {
    let end = text.iter().position(|&byte| byte == b' ').unwrap_or(text.len());
    (&text[..end], text.get(end + 1..).unwrap_or_default())
}

/// `KIND NAME TYPE DEFAULT`, or with ` as PROPERTY`.
fn declared(text: &str) -> Option<(ElementKind, String, Declared)> {
    let words: Vec<&str> = text.split_ascii_whitespace().collect();
    let [kind, name, ty, default @ ..] = words.as_slice() else { return None };
    let (default, property) = match default {
        [default @ .., "as", property] => (default, property),
        default => (default, name),
    };
    let kind = ElementKind::named(kind)?;
    let ty = AttributeType::ALL.iter().copied().find(|known| known.name() == *ty)?;
    let default = match (ty, default) {
        (AttributeType::Bool, [word]) => Value::Bool(word.parse().ok()?),
        (AttributeType::Int, [word]) => Value::Int(word.parse().ok()?),
        _ => {
            let reals = default.iter().map(|word| word.parse().ok()).collect::<Option<Vec<_>>>()?;
            Value::from_reals(ty, &reals)?
        }
    };
    let name = (*name).to_owned();
    Some((kind, (*property).to_owned(), Declared { name, default }))
}
