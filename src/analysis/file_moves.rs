//! Moves of files: the edits after which programs use moved files by their new paths, and qualify
//! what these declare by their new names.

use super::files::name_of;
use super::links::links;
use super::occurrences::shared_item;
use super::snapshot::Snapshot;
use crate::diagnostic::Edit;
use crate::library::FOLDER;
use crate::resolve::qualifier;
use crate::source::Span;
use crate::syntax::is_name;
use crate::syntax::tree::qualified;

/// The edits of a text for moves of files, perhaps of its own. `moved` gives the new name of a
/// file, which is the old one if the file stays.
pub fn edits_for_moves(snapshot: &Snapshot, moved: &dyn Fn(&str) -> String) -> Vec<Edit> {
    let mut edits = paths(snapshot, moved);
    edits.extend(qualifiers(snapshot, moved));
    edits
}

/// The edits of the paths in `use`. A path that means the same file afterwards stays as written.
fn paths(snapshot: &Snapshot, moved: &dyn Fn(&str) -> String) -> Vec<Edit> {
    let old = snapshot.sources().get(snapshot.file()).name();
    let here = moved(old);
    let own = links(snapshot).into_iter().filter(|link| !link.path.starts_with(FOLDER));
    let edits = own.filter_map(|link| {
        let target = moved(&name_of(old, &link.path));
        let path = match link.path.starts_with('/') {
            true => target.clone(),
            false => relative(&here, &target, link.path.starts_with("./")),
        };
        let stays = name_of(&here, &link.path) == target;
        let is_path = name_of(&here, &path) == target && !path.contains(['"', '\\', '\n']);
        (!stays && is_path).then_some(Edit { span: link.span, text: path })
    });
    edits.collect()
}

/// The path by which the file `here` uses the file `target`; `dotted` if it begins with `./` where
/// both are in one folder.
fn relative(here: &str, target: &str, dotted: bool) -> String {
    let (folder, _) = here.rsplit_once('/').unwrap_or_default();
    let from: Vec<&str> = folder.split('/').filter(|step| !step.is_empty()).collect();
    let to: Vec<&str> = target.split('/').filter(|step| !step.is_empty()).collect();
    let common = from.iter().zip(&to).take_while(|(one, other)| one == other).count();
    let path = "../".repeat(from.len() - common) + &to[common..].join("/");
    match path.starts_with(FOLDER) || (dotted && common == from.len()) {
        true => format!("./{path}"),
        false => path,
    }
}

/// The edits of the qualifiers of files whose own names change.
fn qualifiers(snapshot: &Snapshot, moved: &dyn Fn(&str) -> String) -> Vec<Edit> {
    let names = snapshot.names();
    let edits = names.mentions().iter().filter_map(|mention| {
        let file = shared_item(snapshot, names.symbol(mention.symbol))?.file;
        let (old, target) = (qualifier(&file), moved(&file));
        let new = qualifier(&target);
        if new == old {
            return None;
        }
        // A file may have a name that no program can write.
        let text = if is_name(new) { qualified(new, "") } else { String::new() };
        let mark = qualified(old, "");
        let start = mention.span.start.checked_sub(mark.len() as u32)?;
        let whole = Span { start, end: mention.span.start, ..mention.span };
        let is_qualified = snapshot.text().get(whole.range())? == mark;
        is_qualified.then_some(Edit { span: whole, text })
    });
    edits.collect()
}
