//! `hedgerow convert`

use super::arguments::ConvertArguments;
use super::failure::Failure;
use super::meshes;

/// Writes a mesh to another file.
pub(super) fn convert(arguments: &ConvertArguments) -> Result<(), Failure> {
    let output = arguments.output.as_ref().or(arguments.option.as_ref());
    let output = output.ok_or_else(|| Failure::usage("an output file is wanted"))?;
    meshes::expect_mesh(output, &arguments.encoding)?;
    let mut file = meshes::read(&arguments.mesh, &arguments.repair)?;
    meshes::write(output, &mut file, &arguments.encoding, |_| None)
}
