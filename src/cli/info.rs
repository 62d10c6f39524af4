//! `hedgerow info`
use super::arguments::InfoArguments;
use super::failure::Failure;

/// Describes a mesh.
pub(super) fn info(_arguments: &InfoArguments) -> Result<(), Failure> {
    Ok(())
}
