//! `hedgerow convert`

use super::arguments::ConvertArguments;
use super::failure::Failure;
use super::meshes;

/// Writes a mesh to another file.
pub(super) fn convert(arguments: &ConvertArguments) -> Result<(), Failure> {
    meshes::expect_mesh(&arguments.output)?;
    let mut file = meshes::read(&arguments.mesh, &arguments.repair)?;
    meshes::write(&arguments.output, &mut file, &arguments.encoding, || None)
}
