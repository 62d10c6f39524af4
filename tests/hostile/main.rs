//! What nobody writes on purpose, or only to do harm: broken programs taken all the way, items
//! beyond all measure, files that are none, streams that carry something else.

mod limits;
#[cfg(unix)]
mod paths;
mod programs;
mod streams;
