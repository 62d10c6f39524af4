//! Reading a dump, line by line.

use super::table::Table;
use super::{Dump, DumpError, DumpReason};
use crate::mesh::id::{Element, ElementKind};

/// Reads the text of a dump.
pub fn read_dump(text: &str) -> Result<Dump, DumpError> {
    let ids = Ids::of(text);
    let mut dump = Dump::default();
    let mut table: Option<(String, Table)> = None;
    let finish = |table: Option<(String, Table)>, dump: &mut Dump| {
        dump.meshes.extend(table.map(|(name, table)| (name, table.mesh())));
    };
    for (at, line) in text.lines().enumerate() {
        let failed = |reason| DumpError { line: at + 1, reason };
        if let Some(remark) = line.trim_start().strip_prefix('#') {
            dump.remarks.push(remark.trim().into());
            continue;
        }
        let words: Vec<_> = line.split_whitespace().collect();
        match words.as_slice() {
            [] => {}
            ["mesh", name] => {
                finish(table.take(), &mut dump);
                table = Some(((*name).into(), Table::default()));
            }
            ["mesh", ..] => return Err(failed(DumpReason::NotOfForm("mesh WORD"))),
            ["name", words @ ..] => dump.names.push(read_name(words, ids).map_err(failed)?),
            words => {
                let (_, table) = table.as_mut().ok_or_else(|| failed(DumpReason::NoMesh))?;
                table.read(words, ids).map_err(failed)?;
            }
        }
    }
    finish(table, &mut dump);
    Ok(dump)
}

fn read_name(words: &[&str], ids: Ids) -> Result<(String, Vec<Element>), DumpReason> {
    const FORM: &str = "name WORD KIND ID…";
    let [name, kind, listed @ ..] = words else { return Err(DumpReason::NotOfForm(FORM)) };
    let kind = ElementKind::named(kind).ok_or(DumpReason::NotOfForm(FORM))?;
    let element = |text: &&str| Ok(Element { kind, index: ids.read(text)? });
    let elements = listed.iter().map(element).collect::<Result<_, _>>()?;
    Ok(((*name).into(), elements))
}

pub(super) fn read_number(text: &str) -> Result<f64, DumpReason> {
    text.parse().map_err(|_| DumpReason::NotANumber(text.into()))
}

/// The ids that a text may contain: below its length in bytes, so that a short line cannot request
/// gigabytes.
#[derive(Clone, Copy)]
pub(super) struct Ids {
    below: u32,
}

impl Ids {
    /// The bound for small texts.
    const LEAST: u32 = 1 << 20;

    fn of(text: &str) -> Self {
        let bytes = u32::try_from(text.len()).unwrap_or(u32::MAX - 1);
        Self { below: bytes.clamp(Self::LEAST, u32::MAX - 1) }
    }

    pub(super) fn read(self, text: &str) -> Result<u32, DumpReason> {
        let id = text.parse().ok().filter(|&id: &u32| id < self.below);
        id.ok_or_else(|| DumpReason::NotAnId { text: text.into(), below: self.below })
    }

    /// An id, or `-` for none.
    pub(super) fn read_pointer(self, text: &str) -> Result<u32, DumpReason> {
        match text {
            "-" => Ok(u32::MAX),
            text => self.read(text),
        }
    }
}
