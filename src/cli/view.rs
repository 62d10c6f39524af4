//! `hedgerow view`

use glam::DVec3;

use super::arguments::ViewArguments;
use super::draw::write_picture;
use super::failure::Failure;
use super::meshes;
use crate::draw::{View, draw_mesh};

/// Makes a picture of a mesh.
pub(super) fn view(arguments: &ViewArguments) -> Result<(), Failure> {
    let obj = meshes::read(&arguments.mesh)?;
    let mut view = View::default();
    if let Some(from) = &arguments.from {
        view.from = direction(from)?;
    }
    if let Some(size) = arguments.size {
        view.size = f64::from(size);
    }
    write_picture(&draw_mesh(&obj.mesh, &view), &arguments.output, 1.0)
}

fn direction(text: &str) -> Result<DVec3, Failure> {
    let parts: Option<Vec<f64>> = text
        .split(',')
        .map(|part| part.trim().parse().ok())
        .collect();
    let direction = match parts.as_deref() {
        Some(&[x, y, z]) => DVec3::new(x, y, z),
        _ => DVec3::ZERO,
    };
    if direction.is_finite() && direction != DVec3::ZERO {
        Ok(direction)
    } else {
        Err(Failure::usage(format!(
            "`{text}` is no direction: write x,y,z"
        )))
    }
}
