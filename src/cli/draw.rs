//! `hedgerow draw`

use std::path::Path;

use super::arguments::DrawArguments;
use super::failure::Failure;
use super::output::complain_of;
use super::program;
use crate::draw::{Picture, draw_op};

/// How many pixels of an image are a unit of a picture.
const PIXELS: f64 = 2.0;

/// Draws an operation, before and after.
pub(super) fn draw(arguments: &DrawArguments) -> Result<(), Failure> {
    let (path, name) = program::part(&arguments.op);
    let program = program::read(path)?;
    let op = program::find_op(&program, name)?;
    let Some(diagram) = &program.analysis.program.ops[op].diagram else {
        complain_of(&program.analysis.diagnostics, &program.sources);
        return Err(Failure::NotProved);
    };
    write_picture(&draw_op(diagram), &arguments.output)
}

/// Writes a picture as what the end of the file's name says.
pub(super) fn write_picture(picture: &Picture, path: &Path) -> Result<(), Failure> {
    let shown = path.display();
    let extension = path.extension().and_then(|extension| extension.to_str());
    let bytes = match extension {
        Some("svg") => picture.svg().into_bytes(),
        Some("png") => picture.png(PIXELS).map_err(Failure::usage)?,
        _ => {
            return Err(Failure::usage(format!(
                "cannot tell what `{shown}` is to be: its name ends in neither .svg nor .png"
            )));
        }
    };
    std::fs::write(path, bytes)
        .map_err(|error| Failure::usage(format!("cannot write `{shown}`: {error}")))
}
