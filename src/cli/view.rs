//! `hedgerow view`

use glam::DVec3;

use super::arguments::ViewArguments;
use super::draw::write_picture;
use super::failure::Failure;
use super::meshes;
use super::output::eprint_line;
use crate::diagnostic::quoted;
use crate::draw::{Picture, View, draw_mesh};
use crate::mesh::{ColumnId, Mesh};

/// Makes a picture of a mesh.
pub(super) fn view(arguments: &ViewArguments) -> Result<(), Failure> {
    let mut obj = meshes::read(&arguments.mesh, &arguments.repair)?;
    let mut view = View::default();
    if let Some(from) = &arguments.from {
        view.from = direction(from)?;
    }
    if let Some(size) = arguments.size {
        view.size = f64::from(size);
    }
    obj.bring_all();
    if let Some(name) = &arguments.attribute {
        view.attribute = Some(attribute(&obj.mesh, name)?);
    }
    let picture = draw_mesh(&obj.mesh, &view.with_own_colours(&obj.mesh));
    tell_if_blank(&picture, &obj.mesh);
    write_picture(&picture, &arguments.output, 1.0)
}

/// Says so if nothing of a mesh is seen in its picture.
pub(super) fn tell_if_blank(picture: &Picture, mesh: &Mesh) {
    if !picture.is_blank() {
        return;
    }
    eprint_line(match mesh.faces().any(|face| mesh.get_is_hole(face) == Some(false)) {
        false => "warning: nothing is seen: the mesh has no faces",
        true => {
            "warning: nothing is seen: no face has an area from here; `view --from x,y,z` looks \
             from elsewhere"
        }
    });
}

/// The attribute of a name, or of a kind and a name: `height`, `vertex.height`.
pub(super) fn attribute(mesh: &Mesh, wanted: &str) -> Result<ColumnId, Failure> {
    let columns = || mesh.public_columns();
    let full = |id: ColumnId, name: &str| format!("{}.{name}", id.kind.name());
    let found: Vec<_> = columns()
        .filter(|(id, column)| [column.name(), &full(*id, column.name())].contains(&wanted))
        .map(|(id, column)| (id, full(id, column.name())))
        .collect();
    match &found[..] {
        [(id, _)] => Ok(*id),
        [] => {
            let all = columns().map(|(id, column)| full(id, column.name()));
            let all = match all.collect::<Vec<_>>() {
                all if all.is_empty() => "it has none".to_string(),
                all => format!("it has {}", quoted(all)),
            };
            Err(Failure::usage(format!("the mesh has no attribute `{wanted}`: {all}")))
        }
        several => Err(Failure::usage(format!(
            "`{wanted}` may be several attributes: write one of {}",
            quoted(several.iter().map(|(_, name)| name))
        ))),
    }
}

fn direction(text: &str) -> Result<DVec3, Failure> {
    let parts: Option<Vec<f64>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    let direction = match parts.as_deref() {
        Some(&[x, y, z]) => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    };
    if direction.is_finite() && direction != DVec3::ZERO {
        Ok(direction)
    } else {
        Err(Failure::usage(format!("`{text}` is not a direction: write x,y,z")))
    }
}
